//! Beams that ride, bend and swing: frequencies in closed form, a pendulum against a geometrically exact rod, the quick return of the
//! source with its bending coupler.

use super::{Table, Worst, baumgarte, run};
use linkwright::{Linearisation, Simulation};
use linkwright_models::flexible_pendulum::{FlexiblePendulum, HingedBar, HingedBarOfSines};
use linkwright_models::flexible_quick_return::{FlexibleQuickReturn, FlexibleQuickReturnInputs};
use linkwright_models::quick_return::{ConstantSpeed, QuickReturn, slider_force};
use std::f64::consts::{PI, TAU};

/// Three free shapes in bending, tip and frame after half a second and a second; a geometrically exact rod is at (−0.09016, −0.99593)
/// and (−0.999966, −0.00821) m, to which this theory is near.
#[test]
fn pendulum_of_a_strip() {
    let model = FlexiblePendulum::<f64>::default();
    let (mut tip, mut angle, mut bend, mut energy) =
        (Worst::default(), Worst::default(), Worst::default(), Worst::default());
    let expected = [
        (10_000, [-0.090_433_934_7, -0.995_902_457_0], -1.661_334_233_6, -9.946_242_6e-5),
        (20_000, [-0.999_967_138_0, -0.008_107_268_0], -3.133_555_805_3, -1.501_949_6e-5),
    ];
    run(&model, FlexiblePendulum::START, (0.0, 5e-5), 1.0, 1, |step, sample| {
        let outputs = &sample.outputs;
        energy.see(outputs.stored, 0.0);
        for (at, [x, y], turned, bent) in expected {
            if at == step {
                tip.see(outputs.tip_x, x);
                tip.see(outputs.tip_y, y);
                angle.see((outputs.angle - turned + PI).rem_euclid(TAU), PI);
                bend.see(outputs.bend, bent);
            }
        }
    })
    .expect("it swings");
    tip.below(1e-8, "flexible pendulum, tip");
    angle.below(1e-8, "flexible pendulum, frame");
    bend.below(1e-8, "flexible pendulum, first mode");
    energy.below(1e-8, "flexible pendulum, energy");
}

/// det(K − ω²) of ẍ = −K x, which changes its sign at each frequency.
fn determinant(a: &[f64; 36], hertz: f64) -> f64 {
    let k = |i: usize, j: usize| -a[6 * (3 + i) + j] - if i == j { (TAU * hertz).powi(2) } else { 0.0 };
    k(0, 0) * (k(1, 1) * k(2, 2) - k(1, 2) * k(2, 1)) - k(0, 1) * (k(1, 0) * k(2, 2) - k(1, 2) * k(2, 0))
        + k(0, 2) * (k(1, 0) * k(2, 1) - k(1, 1) * k(2, 0))
}

/// Between two hinges: k²π²/(2π) √(EI/μL⁴) with sines, to the last digits; 115.907738 Hz with three free shapes, whose second is
/// odd: with y = −2 (p₀ + p₂) the symmetric motion has M = m (1 + 4 J), J full of ones.
#[test]
fn frequencies_between_two_hinges() {
    let own = HingedBarOfSines::<f64>::default();
    let linear = Linearisation::at(&own, 0.0, &HingedBarOfSines::START, &()).expect("regular");
    let sines = linear.state_space().expect("three coordinates").a;
    let rigidity = 207e9 * PI * 7e-3_f64.powi(4) / 64.0;
    let exact = PI / 2.0 * (rigidity / (7801.0 * PI * 7e-3_f64.powi(2) / 4.0 * 0.35_f64.powi(4))).sqrt();
    assert!((exact - 115.593_089).abs() < 1e-6, "{exact}");
    for hertz in [1.0, 4.0, 9.0].map(|square| square * exact) {
        let [below, above] = [-1e-10, 1e-10].map(|part| determinant(&sines, hertz * (1.0 + part)));
        assert!(below * above < 0.0, "{hertz}: {below} {above}");
    }
    let free = HingedBar::<f64>::default();
    let linear = Linearisation::at(&free, 0.0, &HingedBar::START, &()).expect("regular");
    let free = linear.state_space().expect("three coordinates").a;
    let [below, above] = [-1e-6, 1e-6].map(|hertz| determinant(&free, 115.907_738 + hertz));
    assert!(below * above < 0.0, "{below} {above}");
}

/// Two strokes at 20 rad/s.
#[test]
fn quick_return_with_a_bending_coupler() {
    const CRANK_SPEED: f64 = 20.0;
    let reference = Table::new(include_str!("../../data/flexible_quick_return_w20.csv"));
    let (rigid, model) = (QuickReturn::<f64>::default(), FlexibleQuickReturn::<f64>::default());
    let mut law = ConstantSpeed::new(&rigid, CRANK_SPEED);
    let inputs = |time: f64, _: &_| FlexibleQuickReturnInputs {
        drive: law.torque(time).expect("the crank turns"),
        cutting: slider_force(time, CRANK_SPEED),
    };
    let rows = reference.rows.len();
    let end = reference.get(rows - 1, "t");
    // A whole number of steps from row to row.
    let every = 320;
    let step = end / ((rows - 1) * every) as f64;
    let mut simulation = Simulation::new(&model, FlexibleQuickReturn::START)
        .formulation(baumgarte(50.0))
        .sampled(inputs)
        .step(step);
    let (mut place, mut modes, mut rate) = (Worst::default(), Worst::default(), Worst::default());
    let mut seen = 0;
    simulation
        .run_until(end, |sample| {
            let outputs = &sample.outputs;
            let bent = [outputs.first, outputs.second, outputs.third];
            let row = (sample.time / end * (rows - 1) as f64).round() as usize;
            if (sample.time - reference.get(row, "t")).abs() < 1e-9 {
                let value = |name: &str| reference.get(row, name);
                place.see(outputs.coupler_x, value("x3"));
                place.see(outputs.coupler_y, value("y3"));
                place.see(outputs.stroke, value("x4"));
                rate.see(outputs.rate, value("crank_rate"));
                for (p, name) in bent.into_iter().zip(["pb1", "pb2", "pb3"]) {
                    modes.see(p, value(name));
                }
                seen += 1;
            }
        })
        .expect("it runs");
    assert_eq!(seen, rows);
    place.below(1e-9, "flexible quick return, places");
    modes.below(1e-9, "flexible quick return, modes");
    rate.below(1e-7, "flexible quick return, crank speed");
}
