//! Exact derivatives against differences of the mechanism assembled anew, of every definition that ships with parameters; and against
//! closed forms.

use super::differences::{Varied, slopes};
use super::exact::Exact;
use super::held::Assembled;
use super::{Parameter, parameters};
use crate::input;
use crate::study::options::{Command, Study, parse};
use crate::study::{Loaded, laws, load, start};
use crate::with_engine;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

fn folder(of: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(of)
}

fn study(file: &Path, options: &[&str]) -> Study {
    let arguments = options.iter().map(|it| it.into()).chain([file.into()]);
    parse(Command::Influence, arguments).expect("options").expect("no help")
}

/// A definition that is written here.
fn loaded(text: &str, options: &[&str]) -> (Loaded, Study) {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    let file = std::env::temp_dir().join(format!("influence_{}_{number}.mech", std::process::id()));
    std::fs::write(&file, text).expect("it can be written");
    let found = input::definitions(file.as_os_str()).expect("it can be read");
    let study = study(&file, options);
    let loaded = load(&found[0], &study).unwrap_or_else(|error| panic!("{}", error.text()));
    std::fs::remove_file(&file).expect("it is there");
    (loaded, study)
}

/// Derivative of a closed form by its number of parameter, with an error of h⁴.
fn derivative<const N: usize>(of: impl Fn([f64; N]) -> f64, at: [f64; N], k: usize) -> f64 {
    let slope = |h: f64| {
        let (mut ahead, mut behind) = (at, at);
        ahead[k] += h;
        behind[k] -= h;
        (of(ahead) - of(behind)) / (2.0 * h)
    };
    let h = 2e-4 * at[k].abs().max(0.1);
    (4.0 * slope(0.5 * h) - slope(h)) / 3.0
}

/// Of each parameter the derivatives of the outputs at the start, exact and by differences, with how far these can be off.
type Both = Vec<(String, Result<Vec<f64>, String>, Result<Vec<[f64; 2]>, String>)>;

fn both(loaded: &Loaded, study: &Study) -> Both {
    let by: Vec<Parameter> = parameters(study, loaded).expect("parameters");
    let inputs = laws(loaded, study).unwrap_or_else(|error| panic!("{}", error.text())).at(0.0);
    let state = with_engine!(&loaded.engine, |engine| start(engine))
        .unwrap_or_else(|error| panic!("{}", error.text()));
    let mut exact = Exact::of(loaded).unwrap_or_else(|error| panic!("{}", error.text()));
    let found = exact.at(0.0, &state, &inputs, &by);
    let assembled = Assembled::of(loaded, &state, &inputs);
    let base = assembled.base(&loaded.engine);
    let varied: Vec<Varied> = by.iter().map(Varied::of).collect();
    let differences =
        slopes(&loaded.engine, &varied, &base, &|engine, parameters| assembled.with(engine, parameters));
    let outputs = &loaded.compiled.mechanism.outputs;
    let compared = by.into_iter().zip(found).zip(differences).map(|((parameter, exact), differences)| {
        let differences = differences.map(|slopes| {
            let of = |(slope, output): (&super::Slope, &linkwright_compiler::model::Output)| {
                [slope.value * output.unit.scale, slope.error * output.unit.scale]
            };
            slopes.iter().zip(outputs).map(of).collect()
        });
        (parameter.name, exact, differences)
    });
    compared.collect()
}

#[test]
fn all_that_ships_by_differences() {
    let mut files: Vec<PathBuf> = ["models/src", "docs/mechanisms"]
        .iter()
        .flat_map(|of| std::fs::read_dir(folder(of)).expect("a folder"))
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| std::fs::read_to_string(path).is_ok_and(|text| text.contains(" param ")))
        .collect();
    files.sort();
    let mut compared = 0;
    for file in &files {
        let found = input::definitions(file.as_os_str()).expect("it can be read");
        let study = study(file, &[]);
        for one in &found {
            let loaded = load(one, &study);
            let loaded = loaded.unwrap_or_else(|error| panic!("{}: {}", file.display(), error.text()));
            if loaded.compiled.mechanism.outputs.is_empty() || loaded.compiled.mechanism.parameters.is_empty()
            {
                continue;
            }
            for (parameter, exact, differences) in both(&loaded, &study) {
                let (exact, differences) = match (&exact, &differences) {
                    (Ok(exact), Ok(differences)) => (exact, differences),
                    (Ok(_), Err(message)) if message.contains("on a ball") => continue,
                    (Err(message), _) if message.contains("is rigid") => continue,
                    // The size of a force has no derivative where it is zero.
                    (Err(message), _)
                        if loaded.name == "PenaltyChain" && message.contains("is no finite number") =>
                    {
                        continue;
                    }
                    (exact, differences) => {
                        panic!(
                            "{} by {parameter}: {:?} {:?}",
                            loaded.name,
                            exact.as_ref().err(),
                            differences.as_ref().err()
                        )
                    }
                };
                let outputs = &loaded.compiled.mechanism.outputs;
                let largest = exact.iter().fold(0.0, |largest: f64, it| largest.max(it.abs()));
                for ((found, [expected, error]), output) in exact.iter().zip(differences).zip(outputs) {
                    let tolerance = 1e-6 * found.abs() + 1e-9 * largest + error + 1e-11;
                    assert!(
                        (found - expected).abs() <= tolerance,
                        "{}: {} by {parameter} is {found}, by differences {expected} ± {error:.0e}",
                        loaded.name,
                        output.name.text
                    );
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 500, "{compared}");
}

/// A four-bar whose crank is driven: two angles follow from the loop r e^{iθ} + l e^{iα} = d + s e^{iβ}, which is differentiated by hand.
#[test]
fn positions_of_a_four_bar_by_hand() {
    let file = folder("docs/mechanisms/four_bar_of_lengths.mech");
    let study = study(&file, &[]);
    let found = input::definitions(file.as_os_str()).expect("it can be read");
    let loaded = load(&found[0], &study).unwrap_or_else(|error| panic!("{}", error.text()));
    let [r, l, s, d, along, beside] = [0.2, 0.6, 0.4, 0.5, 0.3, 0.35];
    let theta = 40_f64.to_radians();
    // The wrist: the intersection of two circles above the line of their centres.
    let [kx, ky] = [r * theta.cos(), r * theta.sin()];
    let [dx, dy] = [d - kx, -ky];
    let square = dx * dx + dy * dy;
    let share = 0.5 + (l * l - s * s) / (2.0 * square);
    let height = (l * l / square - share * share).sqrt();
    let [wx, wy] = [kx + share * dx - height * dy, ky + share * dy + height * dx];
    let (alpha, beta) = ((wy - ky).atan2(wx - kx), wy.atan2(wx - d));
    // l (−sin α, cos α) α′ − s (−sin β, cos β) β′ = right.
    let solve = |right: [f64; 2]| {
        let [a, b] = [[-l * alpha.sin(), l * alpha.cos()], [s * beta.sin(), -s * beta.cos()]];
        let determinant = a[0] * b[1] - a[1] * b[0];
        [(right[0] * b[1] - right[1] * b[0]) / determinant, (a[0] * right[1] - a[1] * right[0]) / determinant]
    };
    let (cos, sin) = (alpha.cos(), alpha.sin());
    let corner = |own: [f64; 2], turn: f64| {
        let [x, y] = [along * cos - beside * sin, along * sin + beside * cos];
        [own[0] - y * turn, own[1] + x * turn]
    };
    let expected: [(&str, [f64; 2], [f64; 2]); 6] = [
        ("crank_length", [-theta.cos(), -theta.sin()], [theta.cos(), theta.sin()]),
        ("coupler_length", [-cos, -sin], [0.0, 0.0]),
        ("rocker_length", [beta.cos(), beta.sin()], [0.0, 0.0]),
        ("base", [1.0, 0.0], [0.0, 0.0]),
        ("corner_along", [0.0, 0.0], [cos, sin]),
        ("corner_beside", [0.0, 0.0], [-sin, cos]),
    ];
    let both = both(&loaded, &study);
    for (name, right, own) in expected {
        let found =
            both.iter().find(|(parameter, ..)| parameter == name).expect(name).1.as_ref().expect(name);
        let [turn, swing] = solve(right);
        let [x, y] = corner(own, turn);
        for (found, expected) in found[1..4].iter().zip([x, y, swing]) {
            assert!((found - expected).abs() < 1e-11, "{name}: {found} {expected}");
        }
        assert!(found[0].abs() < 1e-15, "{name}: the crank is driven");
    }
}

const SLIDER: &str = "planar Slider {
    param r [mm] = 100; param l [mm] = 300; param e [mm] = 20; param x [mm] = 40;
    body crank  { mass [kg] = 1; inertia [kg*m^2] = 0.01; point pin = (r, 0); }
    body link   { mass [kg] = 1; inertia [kg*m^2] = 0.01; point eye = (l, 0); }
    body slider { mass [kg] = 1; inertia [kg*m^2] = 0.01; }
    joint main:  revolute(ground(0, 0) [m], crank.origin);
    joint knee:  revolute(crank.pin, link.origin);
    joint wrist: revolute(link.eye, slider.center);
    joint rail:  prismatic(ground(x, e), slider.center, axis = (1, 0));
    start { rail.travel [mm] = 250; rail.speed [m/s] = 0.5; main.angle [deg] ~ 80; }
    options { coordinates = absolute; independent = (rail.travel); }
    output angle [rad] = main.angle;
    output rate [rad/s] = main.rate;
}";

/// What is held is a travel from a place that a parameter moves: the crank's angle is θ = atan2(e, X) + acos((X² + e² + r² − l²)/(2 r √(X² + e²)))
/// with X = x + 250 mm, its rate ∂θ/∂X times the speed.
#[test]
fn a_travel_is_held_from_where_it_begins() {
    let (loaded, study) = loaded(SLIDER, &[]);
    assert_eq!(Exact::of(&loaded).unwrap_or_else(|error| panic!("{}", error.text())).held(), ["rail.travel"]);
    let angle = |[r, l, e, x]: [f64; 4]| {
        let x = x + 0.25;
        let reach = (x * x + e * e).sqrt();
        e.atan2(x) + ((reach * reach + r * r - l * l) / (2.0 * r * reach)).acos()
    };
    let rate = |at: [f64; 4]| 0.5 * derivative(angle, at, 3);
    for (k, (name, exact, _)) in both(&loaded, &study).into_iter().enumerate() {
        let found = exact.expect("a derivative");
        let at = [0.1, 0.3, 0.02, 0.04];
        for (found, expected, tolerance) in
            [(found[0], derivative(angle, at, k), 1e-9), (found[1], derivative(rate, at, k), 1e-5)]
        {
            assert!(
                (found - expected).abs() < tolerance * (1.0 + expected.abs()),
                "{name}: {found} {expected}"
            );
        }
    }
}

/// A rod that swings little has the frequency ω = √(3 g/2 l): its angle after a time T is φ cos ωT, which changes with l by
/// φ T (ω/2 l) sin ωT.
#[test]
fn a_pendulum_after_a_time() {
    let text = "planar Pendulum {
        param length [m] = 0.5; param mass [kg] = 1;
        gravity [m/s^2] = (0, -9.81);
        rod bob { mass = mass; length = length; }
        joint pivot: revolute(ground(0, 0) [m], bob.start);
        start { pivot.angle [rad] = -1.5706963267948966; }
        output angle [rad] = pivot.angle + 1.5707963267948966 [rad];
    }";
    let (loaded, study) = loaded(text, &["--measure", "last(angle)", "--for", "0.7s"]);
    let by = parameters(&study, &loaded).expect("parameters");
    let tables = super::of_runs(&study, &loaded, &by).unwrap_or_else(|error| panic!("{}", error.text()));
    let slope = |k: usize| *tables[0].lines[k].slope.as_ref().expect("a derivative");
    let (length, time, swing) = (0.5, 0.7, 1e-4);
    let omega = (1.5 * 9.81_f64 / length).sqrt();
    let expected = swing * time * (omega / (2.0 * length)) * (omega * time).sin();
    // What is left out of the closed form is a part of 10⁻⁹ of the swing.
    let found = slope(0);
    assert!((found.value - expected).abs() < 1e-6 * expected.abs(), "{found:?} {expected}");
    assert!(found.error < 1e-5 * expected.abs(), "{found:?}");
    assert!(slope(1).value.abs() <= slope(1).error.max(1e-15), "{:?}", slope(1));
    assert_eq!(tables[0].unit.as_deref(), Some("rad"));
}
