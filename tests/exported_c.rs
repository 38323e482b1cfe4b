//! The exported C of every model, built without contraction and run beside the Rust: the same states, to the bit, by every method, in
//! double and in single precision.

use linkwright::{
    Assemble, AssembleExt, Corrected, Fields, LagrangeIndex1, Real, Rk4, SemiImplicitEuler, State, StepError,
    StepMethod, Stepper, Vector,
};
use linkwright_compiler::export::{self, Scalar};
use linkwright_compiler::{Compiled, compile_with, model, parse};
use mechanisms::registry::{Model, for_each};
use std::fmt::Write;
use std::path::Path;
use std::process::{Command, Stdio};

const STEPS: usize = 40;
const H: f64 = 1e-3;

/// How near corrected steps are of mechanisms whose Rust factors by tables, by their size.
const TABLES: f64 = 1e-9;

for_each!(steps_have_the_same_bits);

fn steps_have_the_same_bits<M: Model>() {
    if !has_cc() {
        return;
    }
    let definition = parse(M::source().parse().expect("the source was tokens")).expect("it was a definition");
    let projected = model::lower(&definition).expect("it is a mechanism").options.emit.projection;
    let compiled = compile_with(&definition, None, &["projection"]).expect("it compiles");
    let refused = export::refused(&compiled);
    assert_eq!(refused.is_none(), M::standard().takes_whole_steps(), "{refused:?}");
    if refused.is_some() {
        return;
    }
    compare::<f64, M>(&compiled, Scalar::F64, M::standard, projected);
    compare::<f32, M::Single>(&compiled, Scalar::F32, M::single, projected);
}

/// The status of each step and the state behind it.
type Run = Vec<(u8, Vec<f64>)>;
/// By one method after another.
type Runs = Vec<Run>;

fn compare<R: Digits, M: Assemble<R, Inputs: Fields<R>>>(
    compiled: &Compiled,
    scalar: Scalar,
    model: impl Fn() -> M,
    projected: bool,
) {
    let (found, expected) = (exported(compiled, scalar), expected(model));
    let name = &compiled.mechanism.name.text;
    assert_eq!(found.len(), expected.len(), "{name}");
    for (method, (found, expected)) in found.iter().zip(&expected).enumerate() {
        assert_eq!(found.len(), expected.len(), "{name}, method {method}");
        // What Rust factors by tables is rounded in another way.
        let exact = method < 2 || projected;
        let size = |state: &[f64]| state.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
        let begin = expected.first().map_or(1.0, |(_, state)| size(state));
        for (step, ((status, state), (code, other))) in found.iter().zip(expected).enumerate() {
            let at = format!("{name} in {}, method {method}, step {step}", scalar.c());
            let size = size(other);
            // What is unstable in steps of this length multiplies what is rounded with itself.
            if !exact && size > R::GROWTH * begin {
                break;
            }
            assert_eq!((status, state.len()), (code, other.len()), "{at}");
            let mut pairs = state.iter().zip(other);
            let fits =
                pairs.all(
                    |(a, b)| if exact { a.to_bits() == b.to_bits() } else { (a - b).abs() <= R::SIZE * size },
                );
            assert!(fits, "{at}: {state:?}, {other:?}");
        }
    }
}

/// A scalar of the two.
trait Digits: Real {
    const SIZE: f64;
    const GROWTH: f64;
    fn of(value: f64) -> Self;
}

impl Digits for f64 {
    const SIZE: f64 = TABLES;
    const GROWTH: f64 = 1e6;
    fn of(value: f64) -> Self {
        value
    }
}

impl Digits for f32 {
    const SIZE: f64 = 1e-3;
    const GROWTH: f64 = 3.0;
    fn of(value: f64) -> Self {
        value as f32
    }
}

/// What the Rust does.
fn expected<R: Digits, M: Assemble<R, Inputs: Fields<R>>>(model: impl Fn() -> M) -> Runs {
    let mut runs = vec![run(&model, Rk4), run(&model, SemiImplicitEuler)];
    if model().row_count() > 0 {
        let corrected = Corrected::after(LagrangeIndex1);
        runs.push(run(&model, (Rk4, corrected)));
        runs.push(run(&model, (SemiImplicitEuler, corrected)));
    }
    runs
}

fn run<R: Digits, M: Assemble<R, Inputs: Fields<R>>, S: StepMethod<R, M>>(
    model: impl Fn() -> M,
    method: S,
) -> Run {
    let mut inputs = <M::Inputs as Fields<R>>::Array::zeros(model().input_names().len());
    for (index, input) in inputs.as_mut_slice().iter_mut().enumerate() {
        *input = R::of(0.05 * (index + 1) as f64);
    }
    let inputs = M::Inputs::from_array(inputs);
    let start = model().start();
    let mut plant = Stepper::new(model(), start, method);
    let step = |_| {
        let code = plant.step(&inputs, R::of(H)).map_or_else(StepError::code, |_| 0);
        (code, numbers(plant.state()))
    };
    (0..STEPS).map(step).collect()
}

fn numbers<R: Real, Q: Vector<R>, V: Vector<R>, Z: Vector<R>, G>(state: &State<Q, V, Z, G>) -> Vec<f64> {
    let parts = [state.q.as_slice(), state.v.as_slice(), state.z.as_slice()];
    parts.into_iter().flatten().map(|value| value.to_f64()).collect()
}

/// What the C does: built in a folder of its own, and run.
fn exported(compiled: &Compiled, scalar: Scalar) -> Runs {
    let files = export::c(compiled, scalar);
    let name = &files.name;
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("exported_{name}_{}", scalar.c()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("a file");
    write(&format!("{name}.h"), &files.header);
    write(&format!("{name}.c"), &files.source);
    write("main.c", &main(compiled, name, scalar));
    let program = folder.join("program");
    let built = Command::new("cc")
        .args([
            "-std=c99",
            "-O0",
            "-ffp-contract=off",
            "-Wall",
            "-Wextra",
            "-pedantic",
            "-Wconversion",
            "-Werror",
            "-o",
        ])
        .arg(&program)
        .args([folder.join(format!("{name}.c")), folder.join("main.c")])
        .arg("-lm")
        .output()
        .expect("cc runs");
    assert!(built.status.success(), "{name}: {}", String::from_utf8_lossy(&built.stderr));
    let output = Command::new(&program).output().expect("it runs");
    assert!(output.status.success(), "{name}: {:?}", output.status);
    let text = String::from_utf8(output.stdout).expect("digits");
    let line = |line: &str| {
        let mut words = line.split(' ');
        let status = words.next().expect("a status").parse().expect("a status");
        (status, words.map(|word| value(word, scalar)).collect())
    };
    text.split("==\n").filter(|run| !run.is_empty()).map(|run| run.lines().map(line).collect()).collect()
}

fn value(digits: &str, scalar: Scalar) -> f64 {
    let bits = u64::from_str_radix(digits, 16).expect("digits");
    match scalar {
        Scalar::F64 => f64::from_bits(bits),
        Scalar::F32 => f64::from(f32::from_bits(bits as u32)),
    }
}

/// A program that takes the steps and writes the bits of each state.
fn main(compiled: &Compiled, name: &str, scalar: Scalar) -> String {
    let (upper, real) = (name.to_uppercase(), scalar.c());
    let (bits, format) = if scalar == Scalar::F64 { ("uint64_t", "PRIx64") } else { ("uint32_t", "PRIx32") };
    let inputs = compiled.mechanism.inputs.len();
    let has_rows = !compiled.complete.equations.rows.is_empty();
    let internal = !compiled.mechanism.states.is_empty();
    let mut text = format!(
        "#include \"{name}.h\"\n#include <inttypes.h>\n#include <stdio.h>\n#include <string.h>\n\
         static {name}_t plant;\n\
         static void numbers(const {real} *x, int count) {{\n\
         for (int i = 0; i < count; i++) {{ {bits} bits; memcpy(&bits, &x[i], sizeof bits); printf(\" %\" {format}, bits); }}\n}}\n\
         static void tell({name}_status_t status) {{\n\
         printf(\"%d\", (int)status);\nnumbers(plant.state.q, {upper}_POSITIONS);\nnumbers(plant.state.v, {upper}_VELOCITIES);\n"
    );
    if internal {
        let _ = writeln!(text, "numbers(plant.state.z, {upper}_INTERNAL);");
    }
    text.push_str("printf(\"\\n\");\n}\nint main(void) {\n");
    let initial = if compiled.mechanism.parameters.is_empty() { "" } else { ", NULL" };
    let mut given = "";
    if inputs > 0 {
        let values: Vec<String> =
            (0..inputs).map(|index| scalar.literal(0.05 * (index + 1) as f64)).collect();
        let _ = writeln!(text, "const {name}_inputs_t u = {{{}}};", values.join(", "));
        given = " &u,";
    }
    let methods = ["rk4", "semi_implicit_euler", "rk4_corrected", "semi_implicit_euler_corrected"];
    for method in methods.into_iter().take(if has_rows { 4 } else { 2 }) {
        let _ = writeln!(
            text,
            "if ({name}_init(&plant{initial}) != {upper}_OK) return 1;\n\
             for (int i = 0; i < {STEPS}; i++) tell({name}_step_{method}(&plant,{given} {}, NULL));\nprintf(\"==\\n\");",
            scalar.literal(H)
        );
    }
    text.push_str("return 0;\n}\n");
    text
}

fn has_cc() -> bool {
    let found = Command::new("cc").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if found.is_err() {
        assert!(std::env::var_os("REQUIRE_ALL").is_none(), "there is no `cc`");
        println!("skipped, because there is no `cc`");
    }
    found.is_ok()
}
