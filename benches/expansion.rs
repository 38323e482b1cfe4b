//! What a definition costs at build time.
//!
//! ```text
//! cargo bench --bench expansion [-- PART OF A MODEL'S NAME]
//! ```
//! *Expansion*: seconds from tokens to tokens, measured inside rustc, in a default debug build, where the compiler of
//! definitions is unoptimised as any procedural macro is. The bench generates a macro crate under `target/` that is
//! the shipped one with a clock around it, and a crate that uses it; `cargo check` of that crate prints the times.
//!
//! *Half typed*: the same of a definition that is cut behind each of its tokens in turn, as an editor has it, median over the
//! places of the cut.
//!
//! *Release build*: wall time of `cargo build --release` for a crate that simulates a model in f64, all dependencies
//! being built: expansion, type checking, code generation and linking.
//!
//! Both are medians of [`ROUNDS`] runs after one that is thrown away; beside them the least, which is what a machine does
//! that has nothing else to do.

mod harness;

use harness::{least, median, seconds};
use linkwright_models::{
    four_bar::FourBar, n_four_bar::NFourBar40, panda::Panda, stewart_platform::StewartPlatform,
    tracked_vehicle::TrackedVehicle,
};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const ROUNDS: usize = 9;

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or(root.join("target"), PathBuf::from);
    let bench = Bench { root, folder: target.join("bench-expansion") };
    println!("{}\n", harness::machine());
    let part = std::env::args().skip(1).find(|argument| !argument.starts_with('-')).unwrap_or_default();
    println!("expansion inside rustc, debug build:");
    let definitions = [
        ("four_bar", FourBar::SOURCE),
        ("n_four_bar_40", NFourBar40::SOURCE),
        ("panda", Panda::SOURCE),
        ("stewart_platform", StewartPlatform::SOURCE),
        ("tracked_vehicle", TrackedVehicle::SOURCE),
    ];
    for (name, definition) in definitions.into_iter().filter(|(name, _)| name.contains(&part)) {
        print_times(name, &bench.expansion("mechanism", definition));
    }
    if "half_typed".contains(&part) {
        print_times("half_typed", &bench.expansion("half_typed", FourBar::SOURCE));
        print_times("half_typed, most", &bench.expansion("half_typed_longest", FourBar::SOURCE));
    }
    println!("release build of a crate that simulates, dependencies built:");
    let programs = [
        ("n_four_bar_40", "NFourBar40", NFourBar40::SOURCE, ""),
        ("panda", "Panda", Panda::SOURCE, ".held(|_, _| linkwright::Fields::from_array([0.0; 7]))"),
        (
            "stewart_platform",
            "StewartPlatform",
            StewartPlatform::SOURCE,
            ".held(|_, _| linkwright::Fields::from_array([4e3; 6]))",
        ),
    ];
    for (name, model, definition, inputs) in programs.into_iter().filter(|(name, ..)| name.contains(&part)) {
        let times = bench.release_build(model, definition, inputs);
        println!("  {name:<18}{:>9.2} s,  least {:>7.2} s", median(times.clone()), least(&times));
    }
}

fn print_times(name: &str, times: &[f64]) {
    println!("  {name:<18}{:>9.1} ms, least {:>7.1} ms", 1e3 * median(times.to_vec()), 1e3 * least(times));
}

/// The macros with a clock.
const CLOCK: &str = r#"
use linkwright_compiler::{Expansion, expand};
use proc_macro::{Group, TokenStream, TokenTree};
use std::time::Instant;

#[proc_macro]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    let start = Instant::now();
    let Expansion::Items { text, .. } = expand(tokens.into(), |_| None) else { panic!("the definition is wrong") };
    let items: TokenStream = text.parse().unwrap();
    eprintln!("expansion took {} s", start.elapsed().as_secs_f64());
    items
}

#[proc_macro]
pub fn half_typed(tokens: TokenStream) -> TokenStream {
    let times = of_all_cuts(tokens);
    eprintln!("expansion took {} s", times[times.len() / 2]);
    TokenStream::new()
}

#[proc_macro]
pub fn half_typed_longest(tokens: TokenStream) -> TokenStream {
    let times = of_all_cuts(tokens);
    eprintln!("expansion took {} s", times[times.len() - 1]);
    TokenStream::new()
}

fn of_all_cuts(tokens: TokenStream) -> Vec<f64> {
    let mut all = usize::MAX;
    first(tokens.clone(), &mut all);
    let mut times: Vec<f64> = (1..usize::MAX - all).map(|mut kept| time(first(tokens.clone(), &mut kept))).collect();
    times.sort_by(f64::total_cmp);
    times
}

fn time(tokens: TokenStream) -> f64 {
    let start = Instant::now();
    let expansion: TokenStream = match expand(tokens.into(), |_| None) {
        Expansion::Items { text, .. } => text.parse().unwrap(),
        Expansion::Errors(errors) => errors.into(),
    };
    let time = start.elapsed().as_secs_f64();
    assert!(!expansion.is_empty());
    time
}

/// The first tokens, groups that are begun closed.
fn first(tokens: TokenStream, left: &mut usize) -> TokenStream {
    let mut kept = Vec::new();
    for token in tokens {
        if *left == 0 {
            break;
        }
        *left -= 1;
        kept.push(match token {
            TokenTree::Group(group) => {
                let mut cut = Group::new(group.delimiter(), first(group.stream(), left));
                cut.set_span(group.span());
                TokenTree::Group(cut)
            }
            token => token,
        });
    }
    kept.into_iter().collect()
}
"#;

struct Bench<'a> {
    root: &'a Path,
    /// Where the generated crates live.
    folder: PathBuf,
}

impl Bench<'_> {
    /// Times that a clocked macro prints for one definition, s.
    fn expansion(&self, name: &str, definition: &str) -> Vec<f64> {
        let root = self.root.display();
        self.write(
            "clock/Cargo.toml",
            &format!(
                "[package]\nname = \"clock\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[lib]\nproc-macro = true\n\
                 [dependencies]\nlinkwright-compiler = {{ path = \"{root}/compiler\" }}\n[workspace]\n"
            ),
        );
        self.write("clock/src/lib.rs", CLOCK);
        self.write(
            "user/Cargo.toml",
            &format!(
                "[package]\nname = \"user\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[dependencies]\n\
                 linkwright = {{ path = \"{root}\" }}\nclock = {{ path = \"../clock\" }}\n[workspace]\n"
            ),
        );
        self.write("user/src/lib.rs", &format!("clock::{name}! {{ {definition} }}\n"));
        self.lock("user");
        let run = || {
            self.touch("user/src/lib.rs");
            let output = self.cargo("user", &["check"]);
            let line = output.lines().find_map(|line| line.strip_prefix("expansion took "));
            let time = line.and_then(|line| line.strip_suffix(" s"));
            time.and_then(|time| time.parse().ok())
                .unwrap_or_else(|| panic!("no time was printed:\n{output}"))
        };
        run();
        (0..ROUNDS).map(|_| run()).collect()
    }

    /// Wall times, s. `inputs` is the call that gives a simulation its inputs, if the model has any.
    fn release_build(&self, model: &str, definition: &str, inputs: &str) -> Vec<f64> {
        let root = self.root.display();
        self.write(
            "simulates/Cargo.toml",
            &format!(
                "[package]\nname = \"simulates\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[dependencies]\n\
                 linkwright = {{ path = \"{root}\" }}\n[workspace]\n"
            ),
        );
        self.write(
            "simulates/src/main.rs",
            &format!(
                "use linkwright::{{AssembleExt, Baumgarte, Simulation}};\n\
                 linkwright::mechanism! {{ {definition} }}\n\
                 fn main() -> Result<(), Box<dyn std::error::Error>> {{\n\
                 \x20   let model = {model}::<f64>::default();\n\
                 \x20   let start = model.assemble(&{model}::START)?;\n\
                 \x20   let mut simulation = Simulation::new(&model, start)\n\
                 \x20       .formulation(Baumgarte {{ alpha: 10.0, beta: 10.0 }}).step(1e-3){inputs};\n\
                 \x20   simulation.run_until(0.1, |sample| println!(\"{{}} {{}}\", sample.time, sample.energy()))?;\n\
                 \x20   Ok(())\n\
                 }}\n"
            ),
        );
        self.lock("simulates");
        self.cargo("simulates", &["build", "--release"]);
        let run = || {
            self.touch("simulates/src/main.rs");
            seconds(|| self.cargo("simulates", &["build", "--release"])).1
        };
        (0..ROUNDS).map(|_| run()).collect()
    }

    fn write(&self, file: &str, text: &str) {
        let path = self.folder.join(file);
        fs::create_dir_all(path.parent().expect("a folder")).expect("the target folder can be written to");
        fs::write(path, text).expect("the target folder can be written to");
    }

    /// The versions of dependencies that this workspace has.
    fn lock(&self, package: &str) {
        fs::copy(self.root.join("Cargo.lock"), self.folder.join(package).join("Cargo.lock"))
            .expect("a lock file");
    }

    /// Makes the crate out of date.
    fn touch(&self, file: &str) {
        let path = self.folder.join(file);
        let text = fs::read_to_string(&path).expect("written before");
        fs::write(&path, text).expect("the target folder can be written to");
    }

    /// Runs cargo in a generated crate; gives what it said.
    fn cargo(&self, package: &str, arguments: &[&str]) -> String {
        let cargo = std::env::var_os("CARGO").unwrap_or("cargo".into());
        let output = Command::new(cargo)
            .args(arguments)
            .current_dir(self.folder.join(package))
            .env("CARGO_TARGET_DIR", self.folder.join("target"))
            .env_remove("RUSTFLAGS")
            .output()
            .expect("cargo runs");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "cargo failed in {package}:\n{said}");
        said
    }
}
