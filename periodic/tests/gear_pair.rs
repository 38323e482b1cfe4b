//! The spur gear pair with backlash against values computed by others: branches, folds, multipliers.
//!
//! `data/gear_pair_*.csv` were computed for this equation by a program of their own (shooting in one coordinate, arclength continuation, Python): two
//! arclength steps agree in the folds to 1e-8.

use core::f64::consts::TAU;
use linkwright::AssembleExt;
use linkwright_models::gear_pair::{GearPairOscillator, GearPairOscillatorParameters};
use linkwright_periodic::nalgebra::DVector;
use linkwright_periodic::{Along, Cycle, End, PeriodicMotion};

type Pair = GearPairOscillator<f64>;

/// 1 µm, the unit of the equation, and the base radius, m.
const UNIT: f64 = 1e-6;
fn base() -> f64 {
    3e-3 * 25.0 * 20f64.to_radians().cos()
}

/// With k = 1 + swing cos Ωt and F_a = shake.
fn pair<'c>(shake: f64, swing: f64) -> Cycle<'c, Pair> {
    let model = move |omega| Pair::prepare(GearPairOscillatorParameters { omega, shake, swing });
    Cycle::new(model, |omega| TAU / omega).switch("x", UNIT).switch("x", -UNIT)
}

fn case_a<'c>() -> Cycle<'c, Pair> {
    pair(0.05, 0.0)
}

fn case_b<'c>() -> Cycle<'c, Pair> {
    pair(0.0, 0.3)
}

/// The motion whose x and x′ at the beginning are near these.
fn near(cycle: &Cycle<'_, Pair>, omega: f64, x: f64, rate: f64) -> PeriodicMotion<Pair> {
    let start = Pair::default().start();
    let model = Pair::default();
    let there = linkwright::Mechanism::outputs(&model, 0.0, &start, &()).x;
    let mut numbers = cycle.numbers(omega, &start).unwrap();
    numbers[0] += (x * UNIT - there) / base();
    numbers[1] = rate * UNIT / base();
    cycle.close(omega, &cycle.state(omega, &start, &numbers).unwrap()).unwrap()
}

fn compare(cycle: &Cycle<'_, Pair>, file: &str, every: usize) {
    let text = std::fs::read_to_string(format!("{}/tests/data/{file}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let rows = text.lines().filter(|line| !line.starts_with('#')).step_by(every);
    let mut compared = 0;
    for row in rows {
        let row: Vec<f64> = row.split(',').map(|number| number.parse().unwrap()).collect();
        let [omega, x, rate, largest, least, mean, rms, contact, multiplier] = row[..] else { panic!() };
        let motion = near(cycle, omega, x, rate);
        let found = cycle.measure(&motion, "x").unwrap();
        let what = format!("{file} at {omega}");
        // Beside a fold the last digit of Ω moves x by its root.
        let close = |found: f64, wanted: f64, by: f64| {
            assert!((found - wanted).abs() <= by, "{what}: {found} for {wanted}");
        };
        close(found.largest / UNIT, largest, 1e-5);
        close(found.least / UNIT, least, 1e-5);
        close(found.mean / UNIT, mean, 1e-5);
        close(found.rms / UNIT, rms, 1e-5);
        // Counted there at 2000 times.
        let touching = 1.0 - cycle.share_within(&motion, "x", -UNIT..=UNIT).unwrap();
        close(touching, contact, 1e-3);
        close(motion.largest_multiplier(), multiplier, 2e-4);
        compared += 1;
    }
    assert!(compared > 10, "{file}");
}

#[test]
fn motions_of_case_a_below() {
    compare(&case_a(), "gear_pair_A_low.csv", 5);
}

#[test]
fn motions_of_case_a_above() {
    compare(&case_a(), "gear_pair_A_high.csv", 5);
}

#[test]
fn motions_of_case_b_below() {
    compare(&case_b(), "gear_pair_B_low.csv", 5);
}

#[test]
fn motions_of_case_b_above() {
    compare(&case_b(), "gear_pair_B_high.csv", 5);
}

/// Between the folds the motion is unstable, at them a multiplier is one.
fn folds(cycle: &Cycle<'_, Pair>, from: f64, wanted: [f64; 2]) {
    let start = Pair::default().start();
    let first = cycle.settle(from, &start, 40).unwrap();
    let branch = cycle.branch(&first, &Along { step: 0.02, ..Along::new(from..=1.0) }).unwrap();
    assert_eq!(branch.end, End::Left);
    let found: Vec<f64> = branch.folds.iter().map(|fold| fold.value).collect();
    assert_eq!(found.len(), 2, "{found:?}");
    for (fold, wanted) in branch.folds.iter().zip(wanted) {
        assert!((fold.value - wanted).abs() < 1e-6, "{} for {wanted}", fold.value);
        let nearest = fold.multipliers().iter().map(|it| (it - 1.0).norm()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-4, "{nearest}");
    }
    for motion in &branch.motions {
        // Damping at all times: the product of the multipliers is e^(−2ζT) (Liouville), whatever the switches do.
        let product = motion.monodromy.determinant();
        let wanted = (-0.1 * motion.period).exp();
        assert!((product - wanted).abs() < 1e-7, "{product} for {wanted} at {}", motion.value);
    }
    let unstable = branch.motions.iter().filter(|motion| !motion.is_stable()).count();
    assert!(unstable > 5);
}

#[test]
fn folds_of_case_a() {
    folds(&case_a(), 0.6, [0.8284640, 0.7080316]);
}

#[test]
fn folds_of_case_b() {
    folds(&case_b(), 0.6, [0.8445641, 0.7056975]);
}

/// Below the jump teeth never part, and the equation is linear: rms = F_a Ω²/√((1 − Ω²)² + (2ζΩ)²)/√2.
#[test]
fn linear_below_the_jump() {
    let cycle = case_a();
    for omega in [0.5, 0.62, 0.8] {
        let motion = near(&cycle, omega, 1.1, 0.0);
        let square = (1.0 - omega * omega).powi(2) + (0.1 * omega).powi(2);
        let wanted = 0.05 * omega * omega / square.sqrt() / 2f64.sqrt();
        let found = cycle.measure(&motion, "x").unwrap();
        assert!((found.rms / UNIT - wanted).abs() < 1e-8, "{} for {wanted}", found.rms);
        assert!((found.mean / UNIT - 1.1).abs() < 1e-8);
        assert!(motion.switchings.is_empty());
        let size = (-0.05 * motion.period).exp();
        assert!(motion.multipliers().iter().all(|multiplier| (multiplier.norm() - size).abs() < 1e-6));
    }
}

/// A sweep by frequency, as an experiment does it: it jumps within a step of where the folds say.
#[test]
fn sweeps_jump_at_folds() {
    let cycle = case_a();
    let step = 0.01;
    let sweep = |from: PeriodicMotion<Pair>, step: f64, count: usize| {
        let (from, mut state) = (from.value, from.state);
        let mut before: Option<f64> = None;
        for index in 0..count {
            let omega = from + step * index as f64;
            state = cycle.after(omega, &state, 60).unwrap();
            let motion = cycle.close(omega, &state).unwrap();
            let rms = cycle.measure(&motion, "x").unwrap().rms / UNIT;
            if let Some(before) = before
                && (rms - before).abs() > 0.05
            {
                return omega;
            }
            before = Some(rms);
        }
        panic!("no jump");
    };
    let up = sweep(near(&cycle, 0.8, 1.1, 0.0), step, 5);
    assert!((0.8284640..0.8284640 + step).contains(&up), "{up}");
    let down = sweep(near(&cycle, 0.73, 0.86, 0.188), -step, 5);
    assert!((0.7080316 - step..0.7080316).contains(&down), "{down}");
}

/// The state that x stands for has these x.
#[test]
fn numbers_give_the_state_back() {
    let cycle = case_a();
    let start = Pair::default().start();
    let x = DVector::from_vec(vec![0.3, -2.0]);
    let there = cycle.state(0.9, &start, &x).unwrap();
    assert!((cycle.numbers(0.9, &there).unwrap() - x).amax() < 1e-15);
}
