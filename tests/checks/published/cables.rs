//! The cable robot: closed forms of its tensions, the frequencies at which all cables pull, and elastic cables against a separate
//! integration.

use super::Worst;
use linkwright::{DormandPrince, Event, Mechanism, Rk4, Simulation, SimulationError};
use linkwright_models::cable_robot::{
    CableRobot, CableRobotFromRest, CableRobotParameters, ElasticCableRobot, ElasticCableRobotInputs,
};
use std::f64::consts::TAU;

const EXITS: [[f64; 3]; 3] = [[1.2, 0.0, 0.0], [-0.5, 1.0, 0.0], [-0.6, -0.9, 0.0]];
const CENTRE: [f64; 3] = [0.05, 0.02, -1.5];
/// m (g/h) of 2 kg at 9.81 m/s² and 1.5 m.
const PER_LENGTH: f64 = 2.0 * 9.81 / 1.5;

#[track_caller]
fn close(found: f64, expected: f64, bound: f64) {
    assert!((found - expected).abs() <= bound, "{found} is not {expected} within {bound:.0e}");
}

/// √(g/h).
fn omega() -> f64 {
    (9.81_f64 / 1.5).sqrt()
}

/// The coordinates of the point above the centre in the triangle of the exits.
fn mu() -> [f64; 3] {
    let [a, b, c] = EXITS;
    let area =
        |p: [f64; 3], q: [f64; 3], r: [f64; 3]| (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
    let whole = area(a, b, c);
    [area(CENTRE, b, c), area(a, CENTRE, c), area(a, b, CENTRE)].map(|part| part / whole)
}

fn length(exit: [f64; 3], at: [f64; 3]) -> f64 {
    (0..3).map(|k| (at[k] - exit[k]).powi(2)).sum::<f64>().sqrt()
}

/// Position and velocity on centre + a cos ωt + b sin ωt.
fn on_ellipse(parameters: &CableRobotParameters, time: f64) -> [[f64; 3]; 2] {
    let CableRobotParameters { omega, a_x, a_y, a_z, b_x, b_y, b_z } = *parameters;
    let (a, b, (s, c)) = ([a_x, a_y, a_z], [b_x, b_y, b_z], (omega * time).sin_cos());
    [[0, 1, 2].map(|k| CENTRE[k] + a[k] * c + b[k] * s), [0, 1, 2].map(|k| omega * (b[k] * c - a[k] * s))]
}

/// The tensions where the point is on its ellipse.
fn tensions(parameters: &CableRobotParameters, time: f64) -> [f64; 3] {
    let model = CableRobot::prepare(*parameters).expect("within bounds");
    let mut state = CableRobot::START;
    [state.q, state.v] = on_ellipse(parameters, time);
    let outputs = model.outputs(time, &state, &());
    [outputs.first_tension, outputs.second_tension, outputs.third_tension]
}

/// The least and the largest tension of a period.
fn range(parameters: &CableRobotParameters) -> [f64; 2] {
    let period = TAU / parameters.omega;
    let all = |time: f64| tensions(parameters, time);
    let (mut least, mut most) = ((f64::INFINITY, 0.0), (f64::NEG_INFINITY, 0.0));
    let count = 400;
    for k in 0..count {
        let time = period * f64::from(k) / f64::from(count);
        for tension in all(time) {
            least = if tension < least.0 { (tension, time) } else { least };
            most = if tension > most.0 { (tension, time) } else { most };
        }
    }
    // Golden section beside the best of the grid.
    let refined = |time: f64, sign: f64| {
        let value =
            |time: f64| all(time).map(|tension| sign * tension).into_iter().fold(f64::INFINITY, f64::min);
        let (mut low, mut high) = (time - period / f64::from(count), time + period / f64::from(count));
        let part = (5.0_f64.sqrt() - 1.0) / 2.0;
        while high - low > 1e-9 * period {
            let (x, y) = (high - part * (high - low), low + part * (high - low));
            if value(x) < value(y) { high = y } else { low = x }
        }
        sign * value((low + high) / 2.0)
    };
    [refined(least.1, 1.0), refined(most.1, -1.0)]
}

#[test]
fn tensions_are_proportional_to_lengths_at_one_frequency() {
    let expected = [0.34324324, 0.32162162, 0.33513514];
    mu().into_iter().zip(expected).for_each(|(found, expected)| close(found, expected, 5e-9));
    let model = CableRobot::default();
    close(CableRobotParameters::default().omega, omega(), 1e-14);
    let mut worst = Worst::default();
    let mut simulation = Simulation::new(&model, CableRobot::START).integrator(Rk4).step(1e-3);
    let mut seen = 0;
    simulation
        .run_until(TAU / omega(), |sample| {
            let out = &sample.outputs;
            let found = [out.first_tension, out.second_tension, out.third_tension];
            for ((found, mu), exit) in found.into_iter().zip(mu()).zip(EXITS) {
                worst.see(found, PER_LENGTH * mu * length(exit, [out.x, out.y, out.z]));
            }
            seen += 1;
        })
        .expect("it goes round");
    assert!(seen > 2000);
    // At the positions found, which RK4 leaves by 1e-9 m.
    worst.below(2e-6, "tensions on the ellipse");
    let start = tensions(&CableRobotParameters::default(), 0.0);
    for (found, expected) in start.into_iter().zip([6.8279159897, 9.6965848507, 10.2793491125]) {
        close(found, expected, 1e-10);
    }
}

#[test]
fn all_cables_pull_between_two_frequencies() {
    let least = |omega: f64| range(&CableRobotParameters { omega, ..CableRobotParameters::default() })[0];
    let bound = |mut pulls: f64, mut pushes: f64| {
        assert!(least(pulls) > 0.0 && least(pushes) < 0.0);
        while (pulls - pushes).abs() > 1e-11 {
            let middle = (pulls + pushes) / 2.0;
            if least(middle) > 0.0 { pulls = middle } else { pushes = middle }
        }
        pulls
    };
    close(bound(2.5, 1.0), 1.473_225_659_7, 1e-9);
    close(bound(2.5, 5.0), 3.302_969_293_8, 1e-9);
    let rising =
        CableRobotParameters { a_x: 0.5, a_y: 0.1, a_z: 0.3, b_x: 0.0, b_y: 0.5, b_z: -0.2, omega: omega() };
    let [least, most] = range(&rising);
    close(least, 5.9991, 5e-5);
    close(most, 11.0534, 5e-5);
}

/// Below the least frequency a cord would have to push, and an event tells when.
#[test]
fn an_event_tells_where_a_cord_would_push() {
    let watched =
        ["first.tension", "second.tension", "third.tension"].map(|output| Event::of(output).falling());
    let first = |omega: f64| -> Result<Option<(&'static str, f64)>, SimulationError> {
        let parameters = CableRobotParameters { omega, ..CableRobotParameters::default() };
        let model = CableRobot::prepare(parameters).expect("within bounds");
        let mut start = CableRobot::START;
        [start.q, start.v] = on_ellipse(&parameters, 0.0);
        let mut simulation = Simulation::new(&model, start).integrator(Rk4).step(1e-3);
        let found = simulation.run_until_event(TAU / omega, &watched, |_| ())?;
        Ok(found.map(|found| (found.output, found.time)))
    };
    assert_eq!(first(1.5).expect("it goes round"), None);
    let (output, time) = first(1.4).expect("it goes on").expect("a cord pushes");
    let which = ["first.tension", "second.tension", "third.tension"].iter().position(|name| *name == output);
    let which = which.expect("one of them");
    let parameters = CableRobotParameters { omega: 1.4, ..CableRobotParameters::default() };
    let at = |time: f64| tensions(&parameters, time)[which];
    assert!(at(time - 1e-6) > 0.0 && at(time + 1e-6) < 0.0, "{output} at {time} s: {}", at(time));
}

#[test]
fn from_rest_onto_the_ellipse_and_back() {
    let model = CableRobotFromRest::default();
    let mut simulation = Simulation::new(&model, CableRobotFromRest::START).integrator(Rk4).step(1e-3);
    let rest = [8.486334996, 7.884712728, 8.223016614];
    let (mut least, mut round) = (f64::INFINITY, Worst::default());
    let mut ends = [[0.0; 3]; 2];
    simulation
        .run_until(18.0, |sample| {
            let out = &sample.outputs;
            let found = [out.first_tension, out.second_tension, out.third_tension];
            least = found.into_iter().fold(least, f64::min);
            if sample.time == 0.0 {
                ends[0] = found;
            }
            ends[1] = found;
            if (6.0..=11.0).contains(&sample.time) {
                for ((found, mu), exit) in found.into_iter().zip(mu()).zip(EXITS) {
                    round.see(found, PER_LENGTH * mu * length(exit, [out.x, out.y, out.z]));
                }
            }
        })
        .expect("it comes back");
    for (found, expected) in ends.into_iter().flatten().zip([rest, rest].concat()) {
        close(found, expected, 2e-6);
    }
    round.below(2e-6, "tensions while it goes round");
    println!("least tension {least:.4} N");
    assert!(least > 4.0, "the cords pull all the time: {least}");
}

/// The lengths of the elastic cables before anything is let out, m.
const TAUT: [f64; 3] = [1.520822146078, 2.304972884873, 2.344973347397];
/// EA of the elastic cables, N.
const STIFFNESS: f64 = 2e4;

/// Runs the elastic robot over a period, with the lengths that `own` makes of length and tension on the ellipse; the largest
/// deviation, and position and velocity after 1 s.
fn elastic(own: impl Fn(f64, f64) -> f64) -> (f64, [f64; 6]) {
    let model = ElasticCableRobot::default();
    let ellipse = CableRobotParameters { omega: omega(), ..CableRobotParameters::default() };
    let mut start = ElasticCableRobot::START;
    [start.q, start.v] = on_ellipse(&ellipse, 0.0);
    let inputs = |time: f64, _: &_| {
        let [at, _] = on_ellipse(&ellipse, time);
        let lengths = [0, 1, 2].map(|k| {
            let length = length(EXITS[k], at);
            own(length, PER_LENGTH * mu()[k] * length)
        });
        let [let_out_0, let_out_1, let_out_2] = [0, 1, 2].map(|k| lengths[k] - TAUT[k]);
        ElasticCableRobotInputs { let_out_0, let_out_1, let_out_2 }
    };
    let integrator = DormandPrince::tolerance(1e-13);
    let mut simulation = Simulation::new(&model, start).sampled(inputs).integrator(integrator).step(1e-3);
    let mut worst = 0.0_f64;
    let mut after = [0.0; 6];
    for end in [1.0, TAU / omega()] {
        let mut last = start;
        simulation
            .run_until(end, |sample| {
                let [at, _] = on_ellipse(&ellipse, sample.time);
                worst = worst.max(length(at, sample.state.q));
                last = sample.state;
            })
            .expect("it goes round");
        if end == 1.0 {
            let [x, y, z] = last.q;
            let [u, v, w] = last.v;
            after = [x, y, z, u, v, w];
        }
    }
    (worst, after)
}

#[test]
fn elastic_cables() {
    // Shorter by what they stretch: the motion of the ideal robot is a solution.
    let (worst, _) = elastic(|length, tension| length / (1.0 + tension / STIFFNESS));
    println!("off the ellipse by {worst:.1e} m");
    assert!(worst < 5e-11, "{worst}");
    let (worst, after) = elastic(|length, _| length);
    close(worst, 3.631292e-3, 5e-8);
    let expected = [-0.7000049894, 0.2966655023, -1.5016248313, -1.3016944042, -1.0570882042, -0.0510793912];
    for (found, expected) in after.into_iter().zip(expected) {
        close(found, expected, 1e-9);
    }
}
