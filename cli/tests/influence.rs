//! `linkwright influence` as its users run it: mistakes, what has no derivative, what is written for machines.

use serde_json::Value;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// Exit code, standard output and error of a definition on standard input.
fn ran(text: &str, options: &[&str]) -> (i32, String, String) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_linkwright"))
        .args([&["influence", "-"], options].concat())
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program is built");
    let _ = child.stdin.take().expect("it is piped").write_all(text.as_bytes());
    let output = child.wait_with_output().expect("it ends");
    let text = |bytes| String::from_utf8(bytes).expect("it writes text");
    (output.status.code().expect("it was not killed"), text(output.stdout), text(output.stderr))
}

const PENDULUM: &str = "planar Pendulum {
    param length [m] = 0.5 in 0.5..2; param mass [kg] = 1; param pull [N*m] = 0;
    gravity [m/s^2] = (0, -9.81);
    rod bob { mass = mass; length = length; }
    joint pivot: revolute(ground(0, 0) [m], bob.start);
    torque motor: torque(pivot) = pull;
    start { pivot.angle [deg] = 0; }
    output angle [deg] = pivot.angle;
    output height [m] = bob.end.y;
    output reach [m] = bob.end.x;
}";

#[test]
fn mistakes_are_said() {
    let bare = PENDULUM.replace("    output", "    // output");
    let constant = "planar A { rod bob { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], bob.start); output angle [rad] = pivot.angle; }";
    for (text, options, code, message) in [
        (
            PENDULUM,
            &["--of", "heigth"] as &[&str],
            2,
            "--of: there is no quantity \"heigth\"; did you mean `height`?",
        ),
        (PENDULUM, &["--by", "lenght"], 2, "--by: no parameter is called \"lenght\"; did you mean `length`?"),
        (PENDULUM, &["--measure", "max(angel)"], 2, "did you mean `angle`?"),
        (PENDULUM, &["--measure", "angle"], 2, "write max(angle)"),
        (PENDULUM, &["--set", "mas=2"], 2, "did you mean `mass`?"),
        (PENDULUM, &["--ovr"], 2, "influence has no option"),
        (PENDULUM, &["--svg"], 2, "--svg is of --along"),
        (PENDULUM, &["--along", "--against", "reach"], 2, "--against is of the plot of --along --svg"),
        (PENDULUM, &["--along", "--svg", "--against", "raech"], 2, "did you mean `reach`?"),
        (PENDULUM, &["--along", "--measure", "max(angle)"], 2, "a measure is one number of a whole run"),
        (PENDULUM, &["--along", "--of", "energy"], 2, "`energy` is none: declare an output for it"),
        (&bare, &[], 2, "Pendulum has no outputs: say what the influence is on"),
        (
            constant,
            &[],
            2,
            "A has no parameters: declare what may change, such as `param crank_length [mm] = 200;`",
        ),
        (PENDULUM, &["--set", "length=3"], 1, "length is 3"),
        (PENDULUM, &["--out", "nowhere/at/all.txt"], 2, "cannot be written"),
    ] {
        let (found, out, err) = ran(text, options);
        assert_eq!((found, out.as_str()), (code, ""), "{options:?}: {err}");
        assert!(err.contains(message), "{options:?}: {err}");
    }
}

#[test]
fn zeros_and_parameters_without_influence() {
    let (code, out, err) = ran(PENDULUM, &[]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(out.starts_with("Pendulum at the start, pivot.angle and its rate held\n"), "{out}");
    // The angle itself is held.
    assert!(out.contains("\nangle = 0 deg\n  no influence: length, mass, pull\n"), "{out}");
    assert!(out.contains("\nheight = 0 m\n  no influence: length, mass, pull\n"), "{out}");
    assert!(out.contains("length     0.5 m  1 m/m       0.005 m   1         exact"), "{out}");
    // What depends on a parameter that is zero; and a zero quantity that changes.
    let (_, out, _) = ran(PENDULUM, &["--measure", "last(motor.power)", "--by", "pull", "--for", "0.1s"]);
    assert!(
        out.contains("-         -         differences\n  -: a parameter that is zero has no percent\n"),
        "{out}"
    );
    let moved = PENDULUM.replace("bob.end.y", "bob.end.y - length + 0.5 [m]");
    let (_, out, _) = ran(&moved, &["--of", "height", "--by", "length"]);
    assert!(out.contains("-1 m/m"), "{out}");
    assert!(out.contains("  -: the quantity is zero, and nothing is a part of it\n"), "{out}");
}

#[test]
fn bounds_leave_one_side_or_none() {
    let options = ["--measure", "max(height)", "--by", "length", "--for", "0.2s"];
    let (code, out, _) = ran(PENDULUM, &options);
    assert!(code == 0 && out.contains("no influence: length"), "{out}");
    let options = ["--measure", "min(height)", "--by", "length", "--for", "0.2s"];
    let (code, out, _) = ran(PENDULUM, &options);
    assert!(code == 0 && out.contains("one-sided differences"), "{out}");
    let tight = PENDULUM.replace("in 0.5..2", "in 0.5..0.5");
    let (code, out, _) = ran(&tight, &options);
    assert_eq!(code, 1, "{out}");
    assert!(out.contains("length = 0.5 m: length is 0.5005; it must be from 0.5 to 0.5"), "{out}");
    // What is exact needs no step.
    let (code, out, _) = ran(&tight, &["--of", "reach", "--by", "length"]);
    assert!(code == 0 && out.contains("1 m/m"), "{out}");
}

/// The travel that is held is the longest there is: a shorter link does not reach it.
#[test]
fn a_step_that_does_not_assemble_is_made_smaller() {
    let text = |travel: &str| {
        format!(
            "planar Reach {{
            param l [mm] = 300;
            body crank {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; point pin [m] = (0.1, 0); }}
            body link {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; point eye = (l, 0); }}
            body slider {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; }}
            joint main: revolute(ground(0, 0) [m], crank.origin);
            joint knee: revolute(crank.pin, link.origin);
            joint wrist: revolute(link.eye, slider.center);
            joint rail: prismatic(ground(0, 0) [m], slider.center, axis = (1, 0));
            start {{ rail.travel [mm] = {travel}; main.angle [deg] ~ 5; }}
            options {{ independent = (rail.travel); }}
            output knee_height [mm] = crank.pin.y;
        }}"
        )
    };
    let options = ["--of", "potential_energy", "--of", "knee.force.y", "--of", "knee_height"];
    let (code, out, err) = ran(&text("399.9"), &options);
    assert_eq!(code, 0, "{out}{err}");
    let exact = out.lines().find(|line| line.ends_with(" exact")).expect(&out);
    // y² = r² − x²: with c = (r² + d² − l²)/2d the height √(r² − c²) changes with l by c l/(d y).
    let (r, d, l) = (100.0, 399.9, 300.0);
    let c: f64 = (r * r + d * d - l * l) / (2.0 * d);
    let expected = c * l / (d * (r * r - c * c).sqrt());
    let found: f64 = exact.split_whitespace().nth(3).expect(exact).parse().expect(exact);
    assert!((found - expected).abs() < 1e-5 * expected, "{exact} {expected}");
}

#[test]
fn machines_are_told_the_same() {
    let options = ["--json", "--of", "reach", "--measure", "min(height)", "--for", "0.2s"];
    let (code, out, err) = ran(PENDULUM, &options);
    assert_eq!((code, err.as_str()), (0, ""));
    let answer: Value = serde_json::from_str(&out).expect("it is JSON");
    let found = &answer["mechanisms"][0]["influence"];
    assert_eq!(found["held"][0], "pivot.angle");
    let quantities = found["quantities"].as_array().expect("a list");
    let [reach, height] = quantities.as_slice() else { panic!("{quantities:?}") };
    assert_eq!((&reach["at"], &height["at"]), (&Value::from("start"), &Value::from("run")));
    let first = &reach["parameters"][0];
    assert_eq!(
        (&first["name"], &first["how"], &first["derivative_unit"]),
        (&"length".into(), &"exact".into(), &"m/m".into())
    );
    assert!((first["derivative"].as_f64().expect("a number") - 1.0).abs() < 1e-12);
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/influence.md"))
        .expect("the page");
    for key in found
        .as_object()
        .expect("an object")
        .keys()
        .chain(reach.as_object().expect("one").keys())
        .chain(first.as_object().expect("one").keys())
    {
        assert!(page.contains(&format!("`{key}`")), "docs/influence.md does not describe `{key}`");
    }
}

#[test]
fn along_a_run() {
    let (code, out, err) = ran(
        PENDULUM,
        &["--along", "--of", "reach", "--by", "length", "--by", "mass", "--for", "0.5s", "--every", "0.1s"],
    );
    assert_eq!((code, err.as_str()), (0, ""));
    let mut lines = out.lines();
    assert_eq!(lines.next(), Some("time [s],reach [m],reach by length [m/m],reach by mass [m/kg]"));
    for line in lines.clone() {
        let numbers: Vec<f64> = line.split(',').map(|cell| cell.parse().expect(line)).collect();
        // x = l cos φ with φ held.
        assert!((numbers[2] - numbers[1] / 0.5).abs() < 1e-12 && numbers[3] == 0.0, "{line}");
    }
    assert_eq!(lines.count(), 6);
    let options = ["--along", "--svg", "--of", "reach", "--for", "0.5s", "--against", "angle"];
    let (code, out, _) = ran(PENDULUM, &options);
    assert_eq!(code, 0);
    let whole = out.starts_with("<svg") && out.contains("reach for +1 % of length, m");
    assert!(whole && !out.contains("pull") && !out.contains("mass"), "what does nothing has no panel: {out}");
    let (code, out, err) = ran(PENDULUM, &["--along", "--svg", "--of", "angle", "--for", "0.1s"]);
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(err.contains("no parameter does anything to angle along the run"), "{err}");
}

/// Three numbers do not say how a ball is turned: exact derivatives hold it by turns about axes, differences cannot.
#[test]
fn a_body_that_turns_freely() {
    let text = "spatial Ball {
        param length [m] = 0.5; param mass [kg] = 1;
        gravity [m/s^2] = (0, 0, -9.81);
        cylinder bob { mass = mass; length = length; radius [m] = 0.02; }
        joint pivot: spherical(ground(0, 0, 0) [m], bob.start);
        output speed [m/s] = norm(bob.end.velocity);
        start { bob.rate.z [rad/s] = 3; }
    }";
    let (code, out, err) = ran(text, &[]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(
        out.starts_with("Ball at the start, the turn of bob about its x, the turn of bob about its y, "),
        "{out}"
    );
    // v = 3 rad/s · l.
    assert!(out.contains("length     0.5 m  3 (m/s)/m   0.015 m/s  1         exact"), "{out}");
    let (code, out, _) = ran(text, &["--of", "kinetic_energy"]);
    assert_eq!(code, 1);
    assert!(out.contains("declare an output, whose derivative is exact"), "{out}");
}

/// A rigid contact is not linearised: places are differentiated by differences, and so is a run with an impact. From the height h the ball
/// falls for t = √(2 (h − r)/g) and comes back to e² (h − r) at the most.
#[test]
fn a_rigid_contact() {
    let text = "planar Drop {
        param height [m] = 0.5; param bounce = 0.5; param mass [kg] = 1;
        gravity [m/s^2] = (0, -9.81);
        body ball { mass = mass; inertia [kg*m^2] = 0.01; }
        surface skin: circle(ball.center, radius [m] = 0.1);
        surface floor: half_plane(line(ground(-1, 0) [m], ground(1, 0) [m]));
        joint guide: prismatic(ground(0 [m], height), ball.center, axis = (0, 1));
        contact touch: between(skin, floor) = rigid(restitution = bounce);
        output y [m] = ball.center.y;
        start { guide.travel [m] = 0; }
    }";
    let (code, out, err) = ran(text, &["--of", "y"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(out.contains(" 1 ± ") && out.contains("differences\n  no influence: bounce, mass\n"), "{out}");
    let (code, out, err) = ran(
        text,
        &["--csv", "--measure", "last(y)", "--for", "0.4s", "--integrator", "dormand_prince:1e-12"],
    );
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let derivative = |name: &str| -> f64 {
        let line = out.lines().find(|line| line.contains(&format!(",{name},"))).expect(&out);
        line.rsplit(',').nth(5).expect(line).parse().expect(line)
    };
    let (fall, g, e): (f64, f64, f64) = (0.4, 9.81, 0.5);
    let time = (2.0 * fall / g).sqrt();
    let rest = 0.4 - time;
    // y = r + e g t τ − g τ²/2 with τ = 0.4 s − t, and ∂t/∂h = 1/(g t).
    let by_height = (e * g * (rest - time) + g * rest) / (g * time);
    for (name, expected) in [("height", by_height), ("bounce", g * time * rest)] {
        assert!((derivative(name) - expected).abs() < 1e-5, "{name}: {} {expected}\n{out}", derivative(name));
    }
}
