//! A mechanism that a program builds is the one that a definition describes, and what is wrong with it names its part.

use linkwright_compiler::builder::{Builder, Call, Fault, Value, ground};
use linkwright_compiler::forms::{Interpolation, Outside};
use linkwright_compiler::{Compiled, compile};

const WRITTEN: &str = "pub planar FourBar {
    param payload [kg] = 1.5 in 0.5..10;
    input drive [N*m];
    gravity [m/s^2] = (0, -9.81);
    rod crank { mass [kg] = 1; length [m] = 0.5; }
    rod coupler { mass [kg] = 1; length [m] = 1; }
    body rocker { mass = payload; inertia [kg*m^2] = 0.05; center [m] = (0.3, 0); point tip [m] = (0.8, 0); }
    joint crank_pin: revolute(ground(0, 0) [m], crank.start);
    joint rocker_pin: revolute(ground(1, 0) [m], rocker.origin);
    joint left: revolute(crank.end, coupler.start);
    joint right: revolute(coupler.end, rocker.tip);
    force motor: torque(crank_pin) = drive;
    force strut: spring(crank.end, ground(0.5, -0.5) [m], stiffness = 200 [N/m], length = 0.3 [m]);
    start { crank_pin.angle [deg] = 60; crank_pin.rate [rad/s] = 2; rocker_pin.angle [deg] ~ 70; }
    expect { degrees_of_freedom = 1; }
    output swing [rad] = rocker_pin.angle - 2*crank_pin.angle;
}";

fn four_bar() -> Builder {
    let mut built = Builder::planar("FourBar");
    built.bounded("payload", 1.5, 0.5..10.0, "kg").input("drive", "N*m").gravity(&[0.0, -9.81]);
    built.body("rod", "crank").value("mass", 1.0, "kg").value("length", 0.5, "m");
    built.body("rod", "coupler").value("mass", 1.0, "kg").value("length", 1.0, "m");
    let rocker = built.body("body", "rocker").expression("mass", "payload".into());
    rocker.value("inertia", 0.05, "kg*m^2").vector("center", &[0.3, 0.0], "m").point("tip", &[0.8, 0.0]);
    let pin = || Call::new("revolute");
    built.joint("crank_pin", pin().on(ground(&[0.0, 0.0])).on("crank.start"));
    built.joint("rocker_pin", pin().on(ground(&[1.0, 0.0])).on("rocker.origin"));
    built.joint("left", pin().on("crank.end").on("coupler.start"));
    built.joint("right", pin().on("coupler.end").on("rocker.tip"));
    built.law("motor", Call::new("torque").on("crank_pin"), "drive");
    let strut = Call::new("spring").on("crank.end").on(ground(&[0.5, -0.5]));
    let strut =
        strut.with("stiffness", Value::quantity(200.0, "N/m")).with("length", Value::quantity(0.3, "m"));
    built.load("strut", strut);
    built.start("crank_pin.angle", Value::quantity(60.0, "deg"));
    built.start("crank_pin.rate", Value::quantity(2.0, "rad/s"));
    built.guess("rocker_pin.angle", Value::quantity(70.0, "deg"));
    built.expect_degrees_of_freedom(1);
    built.output("swing", "rad", Value::name("rocker_pin.angle") - Value::from(2.0) * "crank_pin.angle");
    built
}

fn programs(compiled: &Compiled) -> String {
    format!("{:?}", compiled.programs)
}

#[test]
fn a_built_mechanism_has_the_programs_of_the_written_one() {
    let built = four_bar().compile(None).expect("it compiles");
    let written = compile(WRITTEN.parse().expect("tokens"), None).expect("it compiles");
    assert_eq!(programs(&built), programs(&written));
    assert_eq!((built.assembly.q, built.assembly.v), (written.assembly.q, written.assembly.v));
}

#[test]
fn its_text_is_a_definition() {
    let text = four_bar().text();
    let read = compile(text.parse().expect("tokens"), None).expect("it compiles");
    assert_eq!(programs(&read), programs(&four_bar().compile(None).expect("it compiles")));
}

fn faults(built: &Builder) -> Vec<Fault> {
    built.compile(None).map(|_| ()).expect_err("it is wrong")
}

fn assert_fault(built: &Builder, part: &str, message: &str) {
    let found = faults(built);
    let named = found.iter().any(|fault| fault.part == part && fault.message.contains(message));
    assert!(named, "{part}: {message} is not among {found:#?}");
}

#[test]
fn what_is_wrong_names_its_part() {
    let mut built = four_bar();
    built.joint("knee", Call::new("hinge").on("crank.end").on("rocker.tip"));
    assert_fault(&built, "joint \"knee\"", "did you mean `revolute`");
    let mut built = four_bar();
    built.body("rod", "crank").value("mass", 1.0, "kg").value("length", 1.0, "m");
    let found = faults(&built);
    let fault = found.iter().find(|fault| fault.part == "rod \"crank\"").expect("the second crank");
    assert_eq!(fault.notes[0].0, "rod \"crank\"");
    let mut built = four_bar();
    built.body("rod", "arm").value("mass", -1.0, "kg").value("length", 1.0, "m");
    assert_fault(&built, "rod \"arm\"", "mass");
    let mut built = four_bar();
    built.start("coupler.angle", Value::quantity(1.0, "m"));
    assert_fault(&built, "start of \"coupler.angle\"", "m");
}

#[test]
fn what_cannot_be_written_down_is_refused() {
    let mut built = four_bar();
    built.body("rod", "arm").value("mass", f64::NAN, "kg").value("length", 1.0, "m");
    assert_fault(&built, "rod \"arm\"", "NaN");
    let mut built = four_bar();
    built.joint("knee; joint other", Call::new("revolute").on("crank.end").on("rocker.tip"));
    assert_fault(&built, "joint \"knee; joint other\"", "is no name");
    let mut built = four_bar();
    built.parameter("load", 1.0, "kg];\nparam x [m");
    assert_fault(&built, "parameter \"load\"", "is no unit");
    assert_fault(&Builder::planar("four bar"), "mechanism \"four bar\"", "is no name");
    // Nothing to move.
    assert_fault(&Builder::planar("Empty"), "mechanism \"Empty\"", "");
}

/// Every kind of statement, in space.
#[test]
fn statements_of_space() {
    let mut built = Builder::spatial("Shafts");
    built.gravity(&[0.0, 0.0, -9.81]);
    for name in ["input", "output"] {
        let wheel = built.body("disk", name).value("mass", 2.0, "kg").value("radius", 0.1, "m");
        wheel.value("thickness", 0.02, "m");
    }
    let bearing = |at: f64, wheel: &str| {
        let hinge = Call::new("revolute").on(ground(&[at, 0.0, 0.0])).on(wheel);
        hinge.direction("axis", &[0.0, 0.0, 1.0])
    };
    built.joint("first", bearing(0.0, "input.origin"));
    built.joint("second", bearing(0.3, "output.origin"));
    built.coupling("mesh", Call::new("gear").on("first").on("second").with("ratio", 2.0));
    let swing = Value::call("sin", &[Value::name("time") * Value::quantity(3.0, "1/s")]);
    built.drive("motor", "first.angle", swing * Value::quantity(1.0, "rad"));
    built.start("second.angle", Value::quantity(0.0, "rad")).option("coordinates", "tree");
    built.expect_degrees_of_freedom(1);
    built.signal("lag", "rad", Value::name("second.angle") - "first.angle");
    let lag = Value::quantity(-2.0, "N*m/rad") * "lag" + Value::quantity(-0.1, "N*m*s/rad") * "lag.rate";
    built.law("slack", Call::new("along").along("lag"), lag);
    let points = [[0.0, 0.0], [90.0, 1.5], [180.0, 0.5], [360.0, 0.0]];
    built.table("cam", ["angle", "deg"], "N*m", &points, Interpolation::Periodic, Outside::Linear);
    let (axes, rows): (_, [&[f64]; 2]) = ([&[-5.0, 5.0][..], &[0.0, 2.0]], [&[0.0, 1.0], &[2.0, 5.0]]);
    built.grid(
        "drag",
        [["rate", "rad/s"], ["share", ""]],
        "N*m",
        axes,
        &rows,
        (Interpolation::Bilinear, Outside::Hold),
    );
    let drag = Value::call("drag", &[Value::name("first.rate"), Value::from(0.5)]);
    built.law(
        "resistance",
        Call::new("torque").on("first"),
        Value::call("cam", &[Value::name("first.angle")]) - drag,
    );
    built.output("steep", "N*m/rad", Value::call("cam.slope", &[Value::name("first.angle")]));
    built.output("effort", "N*m", Value::name("motor.effort"));
    let compiled = built.compile(None).unwrap_or_else(|faults| panic!("{faults:#?}\n{}", built.text()));
    assert_eq!(compiled.mechanism.constraints.len(), 1);
    assert_eq!(built.warnings(&compiled), []);
}

#[test]
fn warnings_name_their_part() {
    let mut built = four_bar();
    built.parameter("spare", 1.0, "kg");
    let compiled = built.compile(None).expect("it compiles");
    let parts: Vec<String> = built.warnings(&compiled).into_iter().map(|fault| fault.part).collect();
    assert_eq!(parts, ["parameter \"spare\""]);
}
