//! The programs of all shipped models, and of the small mechanisms with every element and every word of `emit`, written in C, built and compared with
//! their interpretation: to the bit where no function of `libm` is called. It shows that a dialect is all that a second language takes.

mod dialect;

use dialect::{C, PRELUDE, apart, function, name_of, tables};
use linkwright_compiler::emit::Printer;
use linkwright_compiler::functions::{ARGUMENTS, Argument, FUNCTIONS, Function, Shape, Signature};
use linkwright_compiler::schedule::{self, Inputs, Instruction, Operand, Program, run};
use linkwright_compiler::source::{Source, invocations};
use linkwright_compiler::symbolic::{Compare, Unary};
use linkwright_compiler::syntax::EMITTED;
use linkwright_compiler::{Compiled, compile_model, emit, model, parse, syntax};
use std::fmt::Write as _;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;

/// States at which a mechanism is evaluated.
const POINTS: usize = 3;
/// Mechanisms of more instructions are built without optimisation.
const LARGE: usize = 2_000;
/// Where `libm` is called; that of C is another.
const TOLERANCE: f64 = 1e-14;

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
    let definitions: Vec<_> = models.iter().flat_map(|file| of(file, &[])).chain(small).collect();
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
                    compare(&compiled(definition, words), &folder.join(format!("model_{number}")));
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
        compare(&compiled, &Path::new(env!("CARGO_TARGET_TMPDIR")).join("conditions"));
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
    for inputs in &points {
        let mut values = written.next().expect("one for each").into_iter();
        for signature in written_out(compiled) {
            let program = compiled.programs.get(signature.function);
            for (index, expected) in run(program, inputs).into_iter().enumerate() {
                let found = values.next().expect("as many as the program gives");
                let tolerance = if calls_libm(program) { TOLERANCE * scale(program, inputs) } else { 0.0 };
                let same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
                assert!(
                    same || (found - expected).abs() <= tolerance,
                    "{name}: {} [{index}]: {found:e} in C, {expected:e} by its program",
                    signature.name
                );
            }
        }
        assert_eq!(values.next(), None, "{name}");
    }
}

/// The functions that the mechanism has.
fn written_out(compiled: &Compiled) -> impl Iterator<Item = &'static Signature> {
    FUNCTIONS.iter().filter(|signature| !compiled.programs.get(signature.function).outputs.is_empty())
}

/// The largest of the results, beside which a difference of the last digit counts.
fn scale(program: &Program, inputs: &Inputs) -> f64 {
    run(program, inputs)
        .into_iter()
        .filter(|value| value.is_finite())
        .fold(0.0, |most, value| most.max(value.abs()))
}

fn calls_libm(program: &Program) -> bool {
    let exact = [Unary::Reciprocal, Unary::Sqrt, Unary::Abs, Unary::Sign];
    program.instructions.iter().any(|instruction| match instruction {
        Instruction::Unary(function, _) => !exact.contains(function),
        Instruction::Atan2(..) => true,
        _ => false,
    })
}

/// The functions and a `main` that reads all arguments and writes all results, as the digits of their bits.
fn build(compiled: &Compiled, program: &Path) {
    let printer = Printer::new(compiled, C::new());
    let mut text = format!("{PRELUDE}#include <inttypes.h>\n#include <stdio.h>\n#include <string.h>\n");
    text.push_str(&tables(&printer));
    written_out(compiled).for_each(|signature| text.push_str(&function(&printer, signature)));
    text.push_str(
        "static double read(void) { uint64_t bits; double x; if (scanf(\"%\" SCNx64, &bits) != 1) return 0.0; memcpy(&x, &bits, 8); return x; }\n\
         static void write(double x) { uint64_t bits; memcpy(&bits, &x, 8); printf(\"%\" PRIx64 \"\\n\", bits); }\n\
         int main(void) {\n",
    );
    for given in ARGUMENTS.iter().filter(|given| given.argument.parts().is_empty()) {
        let (name, length) = (given.name, compiled.entries(given.shape));
        let _ = match given.shape {
            Shape::Scalar => writeln!(text, "double {name} = read();"),
            _ => writeln!(
                text,
                "double {name}[{0}]; for (int i = 0; i < {length}; i++) {name}[i] = read();",
                length.max(1)
            ),
        };
    }
    for signature in written_out(compiled) {
        let outputs = &compiled.programs.get(signature.function).outputs;
        let groups = signature.groups(&compiled.complete, outputs);
        let given = apart(signature.arguments).map(|argument| argument.name().to_string());
        let mut at = 0;
        let results = groups.iter().map(|group| {
            at += group.len();
            format!("results + {}", at - group.len())
        });
        let arguments: Vec<String> = given.chain(results).collect();
        let _ = writeln!(
            text,
            "{{ double results[{0}]; {1}({2}); for (int i = 0; i < {0}; i++) write(results[i]); }}",
            outputs.len(),
            name_of(compiled, signature),
            arguments.join(", ")
        );
    }
    text.push_str("return 0;\n}\n");
    let file = program.with_extension("c");
    std::fs::write(&file, text).expect("it can be written");
    let size: usize = compiled.programs.functions.iter().map(|(_, program)| program.instructions.len()).sum();
    let optimised = if size > LARGE { "-O0" } else { "-O1" };
    let built = Command::new("cc")
        .args([optimised, "-std=c11", "-w", "-fno-asynchronous-unwind-tables", "-ffp-contract=off", "-o"])
        .arg(program)
        .arg(&file)
        .arg("-lm")
        .output()
        .expect("cc runs");
    let name = &compiled.mechanism.name.text;
    assert!(built.status.success(), "{name}: {}", String::from_utf8_lossy(&built.stderr));
}

/// All results at a state.
fn evaluate(compiled: &Compiled, program: &Path, inputs: &Inputs) -> Vec<f64> {
    let mut digits = String::new();
    for given in ARGUMENTS.iter().filter(|given| given.argument.parts().is_empty()) {
        let values = inputs.of(given.argument);
        assert_eq!(values.len(), compiled.entries(given.shape), "{}", given.name);
        values.iter().for_each(|value| digits += &format!("{:x}\n", value.to_bits()));
    }
    let mut child =
        Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("it runs");
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
