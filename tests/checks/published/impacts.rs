//! Rigid contacts of shipped models against closed forms and separate integrations: a hammer and a slider-crank at a stop, in both sets of
//! coordinates, a ball between walls, and a wheel that walks on spokes.

use crate::registry::{Model, compiled};
use linkwright::{AssembleExt, Simulation};
use linkwright_compiler::model::Coordinates;
use linkwright_engine::Engine;
use linkwright_models::ball_between_walls::BallBetweenWalls;
use linkwright_models::hammer_at_rigid_wall::HammerAtRigidWall;
use linkwright_models::rimless_wheel::RimlessWheel;
use linkwright_models::slider_crank_on_stop::SliderCrankOnStop;

const SETS: [Coordinates; 2] = [Coordinates::Tree, Coordinates::Absolute];
const H: f64 = 2e-4;

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

/// A mechanism in a set of coordinates, with these parameters.
fn engine<M: Model>(coordinates: Coordinates, parameters: &[f64]) -> Engine {
    let engine: Engine = Engine::of(&compiled::<M>(Some(coordinates))).expect("it fits");
    engine.prepared(parameters).expect("parameters within their bounds")
}

/// A run of it from its start.
macro_rules! begun {
    ($model:expr) => {
        Simulation::new(&$model, $model.start()).constant($model.no_inputs()).step(H)
    };
}

/// What a touch took, J, and the outputs before and after it.
struct Touch {
    lost: f64,
    before: Vec<f64>,
    after: Vec<f64>,
}

/// Goes on through a touch that comes within `$near` of the time expected, and no other before.
macro_rules! touch {
    ($simulation:ident, $time:expr, $near:expr) => {{
        let begin = $time - $near;
        while $simulation.time() < begin {
            let left = begin - $simulation.time();
            $simulation = $simulation.step(left.min(H));
            let step = $simulation.advance().expect("it moves");
            assert_eq!(step.impacts, 0, "a touch until {} s, expected at {} s", step.time, $time);
        }
        let before = $simulation.sample().outputs.as_slice().to_vec();
        $simulation = $simulation.step(2.0 * $near);
        let step = $simulation.advance().expect("it touches");
        assert_eq!(step.impacts, 1, "no touch until {} s, expected at {} s", step.time, $time);
        let after = $simulation.sample().outputs.as_slice().to_vec();
        $simulation = $simulation.step(H);
        Touch { lost: step.lost, before, after }
    }};
}

/// Two rods: times, rates, energies and impulses, from two tolerances of another program. P = 2 ΔT/((1 − e) ġ).
#[test]
fn a_hammer_strikes_a_wall() {
    let first = 0.7075810264493055;
    for coordinates in SETS {
        for (restitution, rates, lost) in [
            (1.0, [5.17710102491304, -11.5146065184155], 0.0),
            (0.5, [4.7185486690284, -8.08191058550152], 4.0788729150076),
            (0.0, [4.25999631314376, -4.64921465258749], 5.43849722001014),
        ] {
            let model = engine::<HammerAtRigidWall>(coordinates, &[restitution]);
            let mut simulation = begun!(model);
            let found = touch!(simulation, first, 1e-9);
            close(found.lost, lost, 1e-8, "lost");
            close(found.before[2], 3.3428916013745, 1e-7, "rate of the upper rod before");
            close(found.after[2], rates[0], 1e-7, "rate of the upper rod");
            close(found.after[3], rates[1], 1e-7, "rate of the lower rod");
            assert!(simulation.time() > first);
        }
        let model = engine::<HammerAtRigidWall>(coordinates, &[0.5]);
        let mut simulation = begun!(model);
        for (time, expected) in [
            (first, 3.0488890360989),
            (3.307975836391666, 1.01211476199326),
            (4.659804739923455, 2.92689485300646),
        ] {
            let found = touch!(simulation, time, 1e-8);
            close(2.0 * found.lost / (0.5 * found.before[5]), expected, 1e-6, "impulse");
        }
        simulation.advance_until(6.0).expect("it moves");
        let end = simulation.sample().outputs;
        close(end.as_slice()[2], 1.7824491413, 1e-6, "rate of the upper rod after 6 s");
        close(end.as_slice()[3], 1.5091349218, 1e-6, "rate of the lower rod after 6 s");

        let model = engine::<HammerAtRigidWall>(coordinates, &[1.0]);
        let mut simulation = begun!(model);
        let energy = simulation.energy();
        for time in [first, 2.423122037027867] {
            assert_eq!(touch!(simulation, time, 1e-8).before.len(), 6);
        }
        close(simulation.energy(), energy, 1e-9, "energy without a loss");
    }
}

/// Times and rates by an integration in the angle of the crank. Each touch takes 0.64 of the kinetic energy, which is the same before the next,
/// because the linkage comes back to where it was.
#[test]
fn a_slider_crank_runs_against_a_stop() {
    for coordinates in SETS {
        let model = engine::<SliderCrankOnStop>(coordinates, &[0.64, 0.6]);
        let mut simulation = begun!(model);
        let mut taken = 2.810577681243;
        for time in [0.53916275257686, 1.40756310193287, 2.4107520460388] {
            let found = touch!(simulation, time, 2e-9);
            close(found.lost / taken, 1.0, 1e-8, "lost, as a part of what is expected");
            close(found.after[1] / found.before[1], -0.6, 1e-6, "rates after and before");
            taken *= 0.36;
        }
        simulation.advance_until(3.0).expect("it moves");
        let end = simulation.sample().outputs;
        close(end.as_slice()[0].rem_euclid(std::f64::consts::TAU), 3.7513225377323, 1e-8, "angle after 3 s");
        close(end.as_slice()[1], 1.27486387683, 1e-7, "rate after 3 s");
    }
}

/// Ten thousand touches, none lost: the speed is eⁿ of that at the start.
#[test]
fn a_ball_between_walls_loses_no_touch() {
    let model = BallBetweenWalls::default();
    let mut simulation = Simulation::new(&model, BallBetweenWalls::START).step(0.2);
    let mut impacts = 0;
    while impacts < 10_000 {
        impacts += simulation.advance().expect("it moves").impacts;
        let place = simulation.sample().outputs.place;
        assert!((-1e-12..=1.0 + 1e-12).contains(&place), "{place} m");
    }
    let expected = 0.5 * 0.9999_f64.powi(2 * impacts as i32);
    close(simulation.energy() / expected, 1.0, 1e-9, "energy, as a part of what is expected");
}

/// ω²(n + 1) = η² (ω²(n) + 4 g l sin α sin γ/(k² + l²)) behind each landing, with the rate there by the energy, which is kept from one to the next.
#[test]
fn a_rimless_wheel_walks() {
    let model = RimlessWheel::default();
    let mut simulation = Simulation::new(&model, RimlessWheel::START).step(1e-3);
    let (half, slope) = (std::f64::consts::PI / 8.0, 6_f64.to_radians());
    let pace = 2.0 * half.sin();
    let share = (0.2 + (2.0 * half).cos()) / 1.2;
    let gained = 4.0 * 9.81 * half.sin() * slope.sin() / 1.2;
    let mut rates: Vec<f64> = Vec::new();
    while rates.len() < 12 {
        let step = simulation.advance().expect("it walks");
        if step.impacts == 0 {
            continue;
        }
        assert_eq!(step.impacts, 2, "both sides of a notch push");
        let (x, y) = ((rates.len() as f64 + 0.5) * pace, half.cos());
        let height = y * slope.cos() - x * slope.sin();
        let square = 2.0 * (simulation.energy() - 9.81 * height) / 1.2;
        if let Some(before) = rates.last() {
            let expected = share * (before * before + gained).sqrt();
            close(square.sqrt() / expected, 1.0, 1e-9, "rate behind a landing, as a part of that of the map");
        }
        rates.push(square.sqrt());
    }
    let last = share * (gained / (1.0 - share * share)).sqrt();
    close(last, 1.320600545, 1e-9, "the rate that the map keeps");
    close(rates[11], last, 1e-2, "rate after twelve landings");
}
