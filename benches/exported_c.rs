//! A step of RK4 in exported C and by the Rust's stepper, f64, in one process and interleaved.
//!
//! ```text
//! cargo bench --bench exported_c [-- PART OF A MODEL'S NAME]
//! RUSTFLAGS="-C target-cpu=native" cargo bench --bench exported_c
//! CC=clang CFLAGS=-fno-slp-vectorize cargo bench --bench exported_c
//! ```
//! The C is built with `-O3` and what `CFLAGS` says, and bound as if it were linked statically; for the processor and with contraction
//! where this bench is (`target-cpu=native`), otherwise without either.

mod harness;

use harness::{least, library::Library, median};
use linkwright::{Assemble, AssembleExt, Fields, Rk4, Vector};
use linkwright_compiler::export::{self, Scalar};
use linkwright_compiler::{Compiled, compile_with, parse};
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

const SAMPLES: usize = 300;
const H: f64 = 1e-7;
/// Of a sample, in s.
const SHORT: f64 = 20e-6;

/// Takes so many steps of that size and says how many were good.
type Steps = unsafe extern "C" fn(i32, f64) -> i32;

fn main() {
    let part = std::env::args().skip(1).find(|argument| !argument.starts_with('-')).unwrap_or_default();
    println!("{}", harness::machine());
    println!("{} {}", compiler(), options().join(" "));
    println!("ns a step of RK4, least of {SAMPLES} samples; ratio of neighbours, median\n");
    println!("{:<28}{:>10}{:>10}{:>10}", "", "Rust", "C", "C / Rust");
    macro_rules! each {
        ($($name:ident: $model:path),* $(,)?) => {
            $(if stringify!($name).contains(&part) {
                let model = <$model>::default();
                beside(stringify!($name), &model, <$model>::SOURCE);
            })*
        };
    }
    linkwright_models::for_each_model!(each);
}

fn beside<M: Assemble<f64, Inputs: Fields<f64>> + Clone>(name: &str, model: &M, source: &str) {
    let definition =
        parse(source.parse().expect("the source was tokens")).expect("a definition that was compiled");
    let compiled = compile_with(&definition, None, &["projection"]).expect("it was compiled before");
    if export::refused(&compiled).is_some() {
        return;
    }
    let library = Library::open(&built(&compiled, name)).expect("a library that was just built");
    // SAFETY: `driver` defines it so.
    let c: Steps = unsafe { library.function("steps") }.expect("the driver's function");
    let mut plant = model.stepper(model.start(), Rk4);
    let inputs = M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let mut rust =
        |count: usize| (0..count).filter(|_| plant.step(black_box(&inputs), black_box(H)).is_ok()).count();
    // SAFETY: it has its own plant and steps it.
    let mut c = |count: usize| unsafe { c(count as i32, black_box(H)) as usize };
    let once = time(&mut rust, 100).max(1e-9);
    let count = ((SHORT / once) as usize).clamp(4, 2000);
    let (mut by_rust, mut by_c) = (Vec::new(), Vec::new());
    for _ in 0..SAMPLES {
        by_rust.push(time(&mut rust, count));
        by_c.push(time(&mut c, count));
    }
    let ratio = median(by_c.iter().zip(&by_rust).map(|(c, rust)| c / rust).collect());
    println!("{name:<28}{:>10.1}{:>10.1}{ratio:>10.2}", 1e9 * least(&by_rust), 1e9 * least(&by_c));
}

/// Seconds a step.
fn time(steps: &mut impl FnMut(usize) -> usize, count: usize) -> f64 {
    let begin = Instant::now();
    let good = steps(count);
    let passed = begin.elapsed().as_secs_f64();
    assert_eq!(good, count, "a step failed");
    passed / count as f64
}

/// A shared library of the exported mechanism and a loop around its step.
fn built(compiled: &Compiled, name: &str) -> PathBuf {
    let files = export::c(compiled, Scalar::F64);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("bench_{name}"));
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = |end: &str| folder.join(format!("{}{end}", files.name));
    std::fs::write(path(".h"), &files.header).expect("a file");
    std::fs::write(path(".c"), &files.source).expect("a file");
    std::fs::write(folder.join("driver.c"), driver(compiled, &files.name)).expect("a file");
    let mut cc = Command::new(compiler());
    cc.args(options()).arg("-o").args([path(".so"), path(".c"), folder.join("driver.c")]).arg("-lm");
    let cc = cc.output().expect("a C compiler");
    assert!(cc.status.success(), "{name}: {}", String::from_utf8_lossy(&cc.stderr));
    path(".so")
}

fn driver(compiled: &Compiled, name: &str) -> String {
    let initial = if compiled.mechanism.parameters.is_empty() { "" } else { ", 0" };
    let (declared, given) = if compiled.mechanism.inputs.is_empty() {
        (String::new(), "")
    } else {
        (format!("static {name}_inputs_t inputs;"), "&inputs, ")
    };
    let ok = format!("{}_OK", name.to_uppercase());
    format!(
        "#include \"{name}.h\"\nstatic {name}_t plant;\nstatic int begun;\n{declared}\n\
         int steps(int count, double h) {{\nint good = 0;\n\
         if (!begun) {{ begun = 1; if ({name}_init(&plant{initial}) != {ok}) return -1; }}\n\
         for (int i = 0; i < count; i++) good += {name}_step_rk4(&plant, {given}h, 0) == {ok};\nreturn good;\n}}\n"
    )
}

fn compiler() -> String {
    std::env::var("CC").unwrap_or("cc".to_string())
}

fn options() -> Vec<String> {
    let shared = ["-std=c99", "-O3", "-shared", "-fPIC", "-fno-semantic-interposition"];
    let target: &[_] = if cfg!(target_feature = "fma") {
        &["-march=native", "-ffp-contract=fast"]
    } else {
        &["-ffp-contract=off"]
    };
    let given = std::env::var("CFLAGS").unwrap_or_default();
    shared.iter().chain(target).copied().chain(given.split_whitespace()).map(str::to_string).collect()
}
