//! Repetition becomes loops that mean what their instructions mean, and whose text does not grow.

use crate::compiled;
use linkwright_compiler::Compiled;
use linkwright_compiler::functions::Shape;
use linkwright_compiler::schedule::{Function, Inputs, Program, run, run_straight};

/// Arrays that are needed one after the other are one: a window of a ladder keeps 19 numbers, and 31 if each had an array of its own.
#[test]
fn arrays_are_used_again() {
    let programs = rolled(&ladder(100, |_| 1.0));
    let leading = programs.iter().find(|(function, _)| *function == Function::NullSpaceBaumgarte);
    let rolled = leading.and_then(|(_, program)| program.rolled.as_ref()).expect("it has loops");
    let kept: usize = rolled.arrays.iter().sum();
    assert!(kept <= 20 * 100, "{kept} numbers");
}

/// Windows side by side on hinged cranks, each mass by the number of its window.
fn ladder(windows: usize, mass: impl Fn(usize) -> f64) -> String {
    let mut text = format!(
        "planar Ladder {{ const N = {windows}; gravity [m/s^2] = (0, -9.81);
    repeat i in 0..N+1 {{ rod crank[i] {{ mass [kg] = 1; length [m] = 1; }}
        joint pin[i]: revolute(ground(i, 0) [m], crank[i].start); }}\n"
    );
    for window in 0..windows {
        text += &format!("rod coupler[{window}] {{ mass [kg] = {:?}; length [m] = 1; }}\n", mass(window));
    }
    text + "repeat i in 0..N { joint left[i]: revolute(crank[i].end, coupler[i].start);
        joint right[i]: revolute(coupler[i].end, crank[i+1].end);
        start { coupler[i].angle [rad] ~ 0; pin[i+1].angle [deg] ~ 90; } }
    start { pin[0].angle [deg] = 90; pin[0].rate [rad/s] = -1; }
    expect { degrees_of_freedom = 1; } }"
}

/// Discs on a line with springs and dampers between them, driven at one end.
fn masses(count: usize) -> String {
    format!(
        "planar Masses {{ const N = {count}; param k [N/m] = 30; input drive [N];
    repeat i in 0..N {{ particle disc[i] {{ mass [kg] = 1 + 0.1 * i; }}
        joint rail[i]: point_on_line(line(ground(0, 0) [m], ground(1, 0) [m]), disc[i].center);
        start {{ rail[i].travel [m] = i; rail[i].speed [m/s] = 0; }} }}
    repeat i in 0..N-1 {{ force band[i]: spring(disc[i].center, disc[i+1].center, stiffness = k, length [m] = 0.9,
        damping [N*s/m] = 0.1); }}
    force push: force(disc[0].center) = (drive, 0 [N]);
    expect {{ degrees_of_freedom = N; }} }}"
    )
}

/// Rods that hang on one another by ball joints, in absolute coordinates.
fn chain(count: usize) -> String {
    format!(
        "spatial Chain {{ const N = {count}; gravity [m/s^2] = (0, 0, -9.81);
    repeat i in 0..N {{ cylinder link[i] {{ mass [kg] = 1; length [m] = 0.5; radius [m] = 0.05; }} }}
    joint root: spherical(ground(0, 0, 0) [m], link[0].start);
    repeat i in 1..N {{ joint ball[i]: spherical(link[i-1].end, link[i].start); }}
    options {{ coordinates = absolute; }}
    }}"
    )
}

/// Numbers between 0.5 and 1.5 (Knuth, The Art of Computer Programming 2, 3.3.4, line 26 of table 1).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        0.5 + (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn inputs(compiled: &Compiled) -> Inputs {
    let mut numbers = Numbers(1);
    let mut of = |shape: Shape| (0..compiled.entries(shape)).map(|_| numbers.next()).collect::<Vec<f64>>();
    Inputs {
        parameters: of(Shape::Parameters),
        phases: of(Shape::Phases),
        q: of(Shape::Positions),
        v: of(Shape::Velocities),
        inputs: of(Shape::Inputs),
        acceleration: of(Shape::Velocities),
        lambda: of(Shape::Rows),
        given_forces: of(Shape::Velocities),
        given_rows: of(Shape::Rows),
        kept: of(Shape::Store),
        lu: of(Shape::Lu),
        targets: of(Shape::Conditions),
        prepared: of(Shape::Constants),
        time: 0.3,
        two_alpha: 2.0,
        beta_squared: 3.0,
        compliance: 0.1,
        ..Inputs::default()
    }
}

/// The programs with loops, which give to the bit what they give without.
fn rolled(source: &str) -> Vec<(Function, Program)> {
    let compiled = compiled(source).unwrap_or_else(|errors| panic!("{errors}\n{source}"));
    let inputs = inputs(&compiled);
    let mut found = Vec::new();
    for (function, program) in &compiled.programs.functions {
        let Some(rolled) = &program.rolled else { continue };
        let (loops, straight) = (run(program, &inputs), run_straight(program, &inputs));
        for (at, (by_loops, one)) in loops.iter().zip(&straight).enumerate() {
            assert_eq!(by_loops.to_bits(), one.to_bits(), "{function:?}, result {at}: {by_loops} and {one}");
        }
        let long = program.instructions.len() + program.outputs.len();
        assert!(2 * rolled.statements(program) <= long, "{function:?}");
        found.push((*function, program.clone()));
    }
    found
}

fn statements(programs: &[(Function, Program)], function: Function) -> Option<usize> {
    let (_, program) = programs.iter().find(|(known, _)| *known == function)?;
    Some(program.rolled.as_ref()?.statements(program))
}

/// What the text of a function is, at two sizes: the same.
fn assert_constant(name: &str, sources: [String; 2], functions: &[Function]) {
    let [small, large] = sources.map(|source| rolled(&source));
    for function in functions {
        let [small, large] = [&small, &large].map(|programs| statements(programs, *function));
        println!("{name} {function:?}: {small:?} {large:?} statements");
        let (Some(small), Some(large)) = (small, large) else { panic!("{name}: {function:?} has no loops") };
        // In the middle of a short chain in space some terms come before the chain's own that come behind it in a long one; other sums follow.
        let more = if name == "chain" { small / 8 } else { small / 20 };
        assert!(large <= small + more, "{name}, {function:?}: {small} statements, {large} at twice the size");
    }
}

const SOLUTIONS: [Function; 2] = [Function::Acceleration, Function::AccelerationBaumgarte];

#[test]
fn the_text_of_a_ladder_does_not_grow() {
    let leading = [Function::NullSpace, Function::NullSpaceBaumgarte, Function::Motions, Function::Reactions];
    let sizes = [80, 160].map(|windows| ladder(windows, |_| 1.0));
    assert_constant("ladder", sizes, &leading);
}

#[test]
fn masses_may_all_differ() {
    let sizes = [60, 120].map(|windows| ladder(windows, |window| 1.03 + 0.0071 * window as f64));
    assert_constant(
        "ladder of different masses",
        sizes,
        &[Function::NullSpace, Function::NullSpaceBaumgarte],
    );
}

#[test]
fn the_text_of_springs_in_a_row_does_not_grow() {
    assert_constant("masses", [250, 400].map(masses), &[Function::Forces]);
}

#[test]
fn the_text_of_a_chain_in_space_does_not_grow() {
    assert_constant("chain", [120, 240].map(chain), &SOLUTIONS);
}

/// One window differs: what is alike before and behind it still is.
#[test]
fn almost_regular_ladders_are_right() {
    let found = rolled(&ladder(60, |window| if window == 17 { 2.0 } else { 1.0 }));
    println!("{:?}", statements(&found, Function::NullSpace));
    assert!(!found.is_empty());
}

/// Programs of a few hundred instructions stay as they are.
#[test]
fn small_mechanisms_have_none() {
    assert!(rolled(&ladder(5, |_| 1.0)).is_empty());
}
