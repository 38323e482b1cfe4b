//! The exported C of all shipped models, and of the small mechanisms with every element and every word of `emit`: built without a warning,
//! and every function of the equations compared with the interpretation of its program, to the bit.

use linkwright_compiler::export::{self, Scalar};
use linkwright_compiler::functions::{ARGUMENTS, Argument, Function, Shape};
use linkwright_compiler::schedule::{self, Inputs, Instruction, Operand, Program, run};
use linkwright_compiler::source::{Source, invocations};
use linkwright_compiler::symbolic::Compare;
use linkwright_compiler::syntax::EMITTED;
use linkwright_compiler::{Compiled, compile_model, emit, model, parse, syntax};
use std::fmt::Write as _;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;

/// States at which a mechanism is evaluated.
const POINTS: usize = 3;

#[test]
fn every_function_in_c_is_its_program() {
    if !has_cc("every_function_in_c_is_its_program") {
        return;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let entries = std::fs::read_dir(root.join("models/src")).expect("the models");
    let mut models: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    models.sort();
    let zoo =
        ["zoo.rs", "zoo_space.rs", "zoo_laws.rs"].map(|name| root.join("tests/mechanisms/src").join(name));
    let of = |file: &PathBuf, words: &'static [&'static str]| {
        definitions(file).into_iter().map(move |definition| (definition, words))
    };
    let small = zoo.iter().flat_map(|file| of(file, &EMITTED));
    let definitions: Vec<_> = models.iter().flat_map(|file| of(file, &["projection"])).chain(small).collect();
    assert!(definitions.len() >= 60, "{} definitions", definitions.len());
    let next = Mutex::new(definitions.iter().enumerate());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let Some((number, (definition, words))) =
                        next.lock().expect("no thread panics with it").next()
                    else {
                        break;
                    };
                    let compiled = compiled(definition, words);
                    if export::refused(&compiled).is_none() {
                        compare(&compiled, &folder.join(format!("exported_{number}")));
                    }
                }
            });
        }
    });
}

/// A long program with a condition at its beginning that is asked for at its end, in both languages.
#[test]
fn conditions_go_from_part_to_part() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut compiled = compiled(&definitions(&root.join("models/src/four_bar.rs"))[0], &[]);
    let of = |argument: Argument, index: u32| Operand::Source(schedule::Source { argument, index });
    let (x, y) = (of(Argument::Q, 0), of(Argument::V, 0));
    let mut instructions = vec![Instruction::Compare(Compare::Less, x, y), Instruction::Mul(x, y)];
    instructions.extend(
        (1..2000).map(|value| Instruction::Sub(Operand::Value(value), if value % 2 == 0 { x } else { y })),
    );
    let last = instructions.len() as u32;
    instructions.push(Instruction::Select(Operand::Value(0), Operand::Value(last - 1), x));
    let long = Program { instructions, outputs: vec![Operand::Value(last)], ..Program::default() };
    let programs = &mut compiled.programs.functions;
    let energy = programs.iter_mut().find(|(function, _)| *function == Function::KineticEnergy);
    energy.expect("every function has a program").1 = long;

    let (_, text) = emit::emit(&compiled, "", &emit::Home::default());
    assert!(text.contains("R::select(a0, R::ONE, R::ZERO)") && text.contains(".equal(R::ONE)"));
    if has_cc("conditions_go_from_part_to_part") {
        compare(&compiled, &Path::new(env!("CARGO_TARGET_TMPDIR")).join("exported_conditions"));
    }
}

fn has_cc(test: &str) -> bool {
    let found = Command::new("cc").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if found.is_err() {
        assert!(std::env::var_os("REQUIRE_ALL").is_none(), "there is no `cc`");
        println!("{test}: skipped, because there is no `cc`");
    }
    found.is_ok()
}

/// The definitions in a file of Rust.
fn definitions(file: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(file).expect("sources are text");
    let source = Source::new(file.display().to_string(), text);
    let found = invocations(&source).expect("it is read").into_iter();
    let texts = found.map(|invocation| invocation.tokens.stream.to_string());
    // One that names a file is defined there, or has a table there.
    texts.filter(|text| !text.contains("file =") && !text.contains("file (")).collect()
}

/// The mechanism as it is written, and with these words of `emit`.
fn compiled(definition: &str, words: &[&str]) -> Compiled {
    let tokens = emit::Home::split(definition.parse().expect("it consists of tokens")).1;
    let definition = parse(tokens).expect("it is a definition");
    let mut mechanism = model::lower(&definition).expect("it is a mechanism");
    words.iter().for_each(|word| mechanism.options.emit.set(word));
    compile_model(mechanism, syntax::definition_json(&definition), None).expect("it compiles")
}

fn compare(compiled: &Compiled, program: &Path) {
    let name = &compiled.mechanism.name.text;
    build(compiled, program);
    let mut random = Random(7);
    let points: Vec<Inputs> = (0..POINTS).map(|_| point(compiled, &mut random)).collect();
    let mut written = points.iter().map(|point| evaluate(compiled, program, point));
    let calls = export::calls(compiled, Scalar::F64);
    assert!(calls.len() > 5, "{name}: {} functions", calls.len());
    for inputs in &points {
        let mut values = written.next().expect("one for each").into_iter();
        for call in &calls {
            let program = compiled.programs.get(call.function);
            for (index, expected) in run(program, inputs).into_iter().enumerate() {
                let found = values.next().expect("as many as the program gives");
                let same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
                assert!(same, "{}[{index}]: {found:e} in C, {expected:e} by its program", call.name);
            }
        }
        assert_eq!(values.next(), None, "{name}");
    }
}

/// The exported files and a `main` that reads all arguments and writes all results, as the digits of their bits.
fn build(compiled: &Compiled, program: &Path) {
    let files = export::c(compiled, Scalar::F64);
    let name = &files.name;
    std::fs::create_dir_all(program).expect("a folder");
    let write = |file: &str, text: &str| std::fs::write(program.join(file), text).expect("a file");
    write(&format!("{name}.h"), &files.header);
    write(&format!("{name}.c"), &files.source);
    // Functions of its own are called, too.
    let mut text = format!("#include \"{name}.c\"\n#include <inttypes.h>\n#include <stdio.h>\n");
    text.push_str(
        "static double read(void) { uint64_t bits; double x; if (scanf(\"%\" SCNx64, &bits) != 1) return 0.0; memcpy(&x, &bits, 8); return x; }\n\
         static void write(double x) { uint64_t bits; memcpy(&bits, &x, 8); printf(\"%\" PRIx64 \"\\n\", bits); }\n\
         int main(void) {\n",
    );
    let _ = writeln!(text, "static {name}_model_t model; static {name}_state_t state;");
    for given in ARGUMENTS.iter().filter(|given| given.argument.parts().is_empty()) {
        let (name, length) = (given.name, compiled.entries(given.shape));
        let _ = match given.shape {
            Shape::Scalar => writeln!(text, "double {name} = read(); (void){name};"),
            _ => writeln!(
                text,
                "static double {name}[{0}]; for (int i = 0; i < {length}; i++) {name}[i] = read();",
                length.max(1)
            ),
        };
    }
    let parts = [
        (Shape::Parameters, "model.parameters", "parameters"),
        (Shape::Phases, "model.phases", "phases"),
        (Shape::Constants, "model.constants", "constants"),
        (Shape::Positions, "state.q", "q"),
        (Shape::Velocities, "state.v", "v"),
        (Shape::Internal, "state.z", "z"),
    ];
    for (shape, part, list) in parts {
        if compiled.entries(shape) > 0 {
            let _ = writeln!(text, "memcpy(&{part}, {list}, sizeof {part});");
        }
    }
    for call in export::calls(compiled, Scalar::F64) {
        text.push_str("{\n");
        let mut arguments: Vec<String> = call.given.iter().map(|argument| given(*argument, name)).collect();
        for (index, result) in call.written.iter().enumerate() {
            let count = result.extent.unwrap_or(1);
            let _ = writeln!(text, "static {} r{index}[{count}];", result.kind);
            arguments.push(format!("r{index}"));
        }
        let called = format!("{}({})", call.name, arguments.join(", "));
        let _ =
            if call.value { writeln!(text, "double value = {called};") } else { writeln!(text, "{called};") };
        for index in 0..call.written.len() {
            let _ = writeln!(
                text,
                "for (size_t i = 0; i < sizeof r{index} / 8; i++) write(((const double *)r{index})[i]);"
            );
        }
        text.push_str(if call.value { "write(value);\n}\n" } else { "}\n" });
    }
    text.push_str("return 0;\n}\n");
    write("main.c", &text);
    let cc = |options: &[&str], output: PathBuf, file: &str| {
        let built = Command::new("cc")
            .args(["-O0", "-std=c99", "-ffp-contract=off", "-fno-asynchronous-unwind-tables"])
            .args(options)
            .arg("-o")
            .arg(output)
            .arg(program.join(file))
            .arg("-lm")
            .output()
            .expect("cc runs");
        assert!(built.status.success(), "{name}: {}", String::from_utf8_lossy(&built.stderr));
    };
    let strict =
        ["-Wall", "-Wextra", "-pedantic", "-Wconversion", "-Wshadow", "-Wstrict-prototypes", "-Werror"];
    cc(&[&strict[..], &["-fsyntax-only"]].concat(), program.join("syntax"), &format!("{name}.c"));
    cc(&["-w"], program.join("program"), "main.c");
}

/// An argument of a call.
fn given(argument: Argument, name: &str) -> String {
    match argument {
        Argument::Constants => "&model".to_string(),
        Argument::State => "&state".to_string(),
        // Structs of the inputs or the parameters, whose fields are numbers in this order.
        Argument::Inputs => format!("(const {name}_inputs_t *)u"),
        Argument::Parameters => "&model.parameters".to_string(),
        argument => argument.name().to_string(),
    }
}

/// All results at a state.
fn evaluate(compiled: &Compiled, program: &Path, inputs: &Inputs) -> Vec<f64> {
    let mut digits = String::new();
    for given in ARGUMENTS.iter().filter(|given| given.argument.parts().is_empty()) {
        let values = inputs.of(given.argument);
        assert_eq!(values.len(), compiled.entries(given.shape), "{}", given.name);
        values.iter().for_each(|value| digits += &format!("{:x}\n", value.to_bits()));
    }
    let mut child = Command::new(program.join("program"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("it runs");
    child.stdin.take().expect("it reads").write_all(digits.as_bytes()).expect("it reads all");
    let output = child.wait_with_output().expect("it ends");
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).expect("digits");
    text.lines().map(|line| f64::from_bits(u64::from_str_radix(line, 16).expect("digits"))).collect()
}

/// Numbers near the start; no function asks for more than that.
fn point(compiled: &Compiled, random: &mut Random) -> Inputs {
    let assembly = &compiled.assembly;
    let near = |values: &[f64], random: &mut Random| {
        values.iter().map(|value| value + 0.1 * random.next()).collect()
    };
    let any =
        |shape: Shape, random: &mut Random| (0..compiled.entries(shape)).map(|_| random.next()).collect();
    let defaults: Vec<f64> = compiled.mechanism.parameters.iter().map(|known| known.default).collect();
    let mut inputs = Inputs {
        parameters: defaults.iter().map(|value| value * (1.0 + 0.01 * random.next())).collect(),
        phases: assembly.phases.clone(),
        time: random.next(),
        q: near(&assembly.q, random),
        v: any(Shape::Velocities, random),
        inputs: any(Shape::Inputs, random),
        internal: any(Shape::Internal, random),
        gates: any(Shape::Gates, random),
        two_alpha: 10.0 + random.next(),
        beta_squared: 25.0 + random.next(),
        acceleration: any(Shape::Velocities, random),
        lambda: any(Shape::Rows, random),
        targets: any(Shape::Conditions, random),
        compliance: 0.01 * (2.0 + random.next()),
        given_forces: any(Shape::Velocities, random),
        given_rows: any(Shape::Rows, random),
        kept: any(Shape::Store, random),
        lu: any(Shape::Lu, random),
        prepared: Vec::new(),
    };
    inputs.prepared = run(compiled.programs.get(Function::Prepare), &inputs);
    inputs
}

/// Uniform in [−1, 1), the same in every run (xorshift64*: Vigna, ACM TOMS 42, 2016).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}
