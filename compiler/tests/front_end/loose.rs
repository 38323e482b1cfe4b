//! Joints with play: what they are short for, how they start, one message for each mistake.

use crate::bad;
use linkwright_compiler::compile;
use linkwright_compiler::schedule::{Function, Inputs, run};

/// A slider-crank with these statements and this start.
fn wrist(statements: &str, start: &str) -> String {
    format!(
        "#[allow(penetration)] planar Wrist {{ rod crank {{ mass [kg] = 0.3; length [m] = 0.05; }}
         body rod {{ mass [kg] = 0.21; inertia [kg*m^2] = 2.5e-4; point big [m] = (-0.06, 0); point small [m] = (0.06, 0); }}
         body slider {{ mass [kg] = 0.14; inertia [kg*m^2] = 1e-5; }}
         joint main: revolute(ground(0, 0) [m], crank.start); joint crank_pin: revolute(crank.end, rod.big);
         joint rail: prismatic(ground(0, 0) [m], slider.center, axis = (1, 0));
         {statements} start {{ main.angle [rad] = 0.7; main.rate [rad/s] = 9; {start} }} }}"
    )
}

const LAW: &str = "kelvin_voigt(stiffness [N/m] = 1e6, damping [N*s/m] = 30)";

fn compiled(source: &str) -> linkwright_compiler::Compiled {
    compile(source.parse().expect("tokens"), None).unwrap_or_else(|found| panic!("{found}"))
}

/// The same programs as of a circle in a hole.
#[test]
fn a_pin_with_play_is_a_circle_in_a_hole() {
    let short = format!(
        "joint wrist: revolute(rod.small, slider.center, play [mm] = 0.5, radius [mm] = 10) = {LAW};"
    );
    let long = format!(
        "surface hole: hole(rod.small, radius [mm] = 10); surface pin: circle(slider.center, radius = 10 [mm] - 0.5 [mm]);
         contact wrist: between(pin, hole) = {LAW};"
    );
    let rest = "friction rub: on(wrist) = coulomb(coefficient = 0.2, speed [m/s] = 0.1); output pushed [N] = wrist.force; output lost [W] = power(wrist);";
    let start = "crank_pin.angle [rad] ~ -1; rail.travel [m] ~ 0.16;";
    let [short, long] = [short, long].map(|it| compiled(&wrist(&format!("{it} {rest}"), start)));
    for function in [Function::Forces, Function::Outputs, Function::Acceleration] {
        let [short, long] = [&short, &long].map(|it| format!("{:?}", it.programs.get(function)));
        assert_eq!(short, long);
    }
    assert_eq!(short.assembly.mobility.generic, 3);
    assert!(
        short.assembly.mobility.to_string().contains("yield or have play take no freedoms away: \"wrist\"")
    );
}

/// Centres are together, at the rates of the joint, or where `start` says.
#[test]
fn where_a_loose_joint_starts() {
    let loose = format!(
        "joint wrist: revolute(rod.small, slider.center, play [mm] = 0.5, radius [mm] = 10) = {LAW};"
    );
    let firm = "joint wrist: revolute(rod.small, slider.center);";
    let start = "crank_pin.angle [rad] ~ -1; rail.travel [m] ~ 0.16;";
    let outputs = "output travel [m] = rail.travel; output speed [m/s] = rail.speed; output angle [rad] = rod.angle; output rate [rad/s] = rod.rate;";
    let of = |joint: &str, start: &str, more: &str| {
        let compiled = compiled(&wrist(&format!("{joint} {outputs} {more}"), start));
        let inputs = Inputs {
            q: compiled.assembly.q.clone(),
            v: compiled.assembly.v.clone(),
            parameters: Vec::new(),
            ..Inputs::default()
        };
        let prepared = run(compiled.programs.get(Function::Prepare), &inputs);
        run(compiled.programs.get(Function::Outputs), &Inputs { prepared, ..inputs })
    };
    let (firm, held) = (of(firm, start, ""), of(&loose, start, "output off [m] = wrist.eccentricity;"));
    for (firm, loose) in firm.iter().zip(&held) {
        assert!((firm - loose).abs() < 1e-9, "{firm} {loose}");
    }
    assert!(held[4] < 1e-12, "{}", held[4]);
    let off = of(
        &loose,
        &format!("{start} wrist.offset.x [mm] = 0.3; wrist.offset.y [mm] = -0.2;"),
        "output x [mm] = wrist.offset.x; output y [mm] = wrist.offset.y;",
    );
    assert!((off[4] - 3e-4).abs() < 1e-10 && (off[5] + 2e-4).abs() < 1e-10, "{off:?}");
}

#[track_caller]
fn only(source: &str, expected: &str) {
    let found = bad(source).to_string();
    assert!(found.contains(expected), "{source}\n{found}");
}

#[test]
fn one_message_for_each_mistake() {
    let pin = |arguments: &str, law: &str| {
        format!("joint wrist: revolute(rod.small, slider.center, {arguments}){law};")
    };
    let law = format!(" = {LAW}");
    for (statements, expected) in [
        (pin("play [mm] = 0.5", &law), "`revolute` needs its radius: write"),
        (
            pin("play [mm] = 0.5, radius [mm] = 10", ""),
            "expected `=` and the law of the contact, such as `kelvin_voigt(…)`, found `;`",
        ),
        (
            pin(
                "play [mm] = 0.5, radius [mm] = 10",
                " = penalty(stiffness [N/m] = 1e6, damping [N*s/m] = 200)",
            ),
            "by a `penalty` a joint without play yields, and `wrist` is a contact",
        ),
        (pin("play [mm] = -0.5, radius [mm] = 10", &law), "radius"),
        (pin("play [mm] = 20, radius [mm] = 10", &law), "radius"),
        (pin("play [kg] = 1, radius [mm] = 10", &law), "kg"),
        (
            "joint wrist: fixed(rod.small, slider.center, play [mm] = 1, radius [mm] = 10) = 3 [N];"
                .to_string(),
            "there is no short form of a `fixed` with play; a `revolute` has, `joint pin: revolute(place, place, play [mm] = 0.5, radius [mm] = 10) = hertz(…);`. \
             Elsewhere surfaces with a gap between them and a `contact` say it",
        ),
        (
            format!("{} output r [N] = wrist.reaction.size;", pin("play [mm] = 0.5, radius [mm] = 10", &law)),
            "`wrist` has play and holds nothing by itself: its surfaces push with `wrist.force`, at `wrist.point`",
        ),
    ] {
        only(&wrist(&statements, "crank_pin.angle [rad] ~ -1;"), expected);
    }
    let space = "spatial Space { body arm { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); }
        joint pin: revolute(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1), play [mm] = 1, radius [mm] = 10) = 3 [N]; }";
    only(
        space,
        "there is no short form of a `revolute` with play; a `spherical` has, `joint ball: spherical(place, place, play [mm] = 0.5, radius [mm] = 10) = hertz(…);`. \
        Elsewhere surfaces with a gap between them and a `contact` say it",
    );
}

/// Two rods between hinges 1 m apart that are `short` m too short, with play at the first hinge and between both rods, in mm.
fn short_rods(short: f64, plays: [f64; 2]) -> String {
    let [first, second] = plays;
    let length = 0.5 - short;
    format!(
        "planar Rods {{ rod a {{ mass [kg] = 1; length [m] = 0.5; }} rod b {{ mass [kg] = 1; length [m] = {length}; }}
         joint left: revolute(ground(0, 0) [m], a.start, play [mm] = {first}, radius [mm] = 10) = {LAW};
         joint knee: revolute(a.end, b.start, play [mm] = {second}, radius [mm] = 10) = {LAW};
         joint right: revolute(b.end, ground(1, 0) [m]);
         output at_left [mm] = left.eccentricity; output at_knee [mm] = knee.eccentricity;
         start {{ a.angle [rad] ~ 0.01; b.angle [rad] ~ 0; }} }}"
    )
}

/// What is missing is taken up by parts of the clearances: e₁ + e₂ is what is missing, and Σ (e/c)² the least. Beyond them the loop does not close.
#[test]
fn loops_that_close_only_with_play() {
    for (short, plays) in [(0.5e-3, [0.1, 0.5]), (0.3e-3, [0.2, 0.2])] {
        for coordinates in ["absolute", "tree"] {
            let source = short_rods(short, plays)
                .replace("start {", &format!("options {{ coordinates = {coordinates}; }} start {{"));
            let compiled = compiled(&source);
            let inputs = Inputs {
                q: compiled.assembly.q.clone(),
                v: compiled.assembly.v.clone(),
                parameters: Vec::new(),
                ..Inputs::default()
            };
            let prepared = run(compiled.programs.get(Function::Prepare), &inputs);
            let inputs = Inputs { prepared, ..inputs };
            let found = run(compiled.programs.get(Function::Outputs), &inputs);
            let weights = plays.map(|play| play * play);
            for (found, weight) in found.iter().zip(weights) {
                let expected = short * weight / (weights[0] + weights[1]);
                assert!((found - expected).abs() < 1e-9, "{plays:?}: {found} for {expected}");
            }
        }
    }
    let source = short_rods(0.8e-3, [0.2, 0.5]);
    let found = compile(source.parse().expect("tokens"), None).expect_err("it cannot close").to_string();
    assert!(
        found.contains(
            "the loop does not close: where the centres of `left` and `knee` come nearest they stay 0.8 mm apart, of which the play takes up 0.7 mm; \
             change a length, or the play"
        ),
        "{found}"
    );
}
