//! Beams that ride, bend and swing: frequencies in closed form, a pendulum against a geometrically exact rod, the quick return of the
//! source with its bending coupler.

use super::{Table, Worst, baumgarte, run};
use linkwright::{GeneralisedAlpha, Linearisation, Simulation};
use linkwright_models::flexible_pendulum::{
    FlexiblePendulum, HingedBar, HingedBarOfFive, HingedBarOfOne, HingedBarOfSines,
};
use linkwright_models::flexible_quick_return::{FlexibleQuickReturn, FlexibleQuickReturnInputs};
use linkwright_models::flexible_slider_crank::FlexibleSliderCrank;
use linkwright_models::quick_return::{ConstantSpeed, QuickReturn, slider_force};
use linkwright_models::spinning_beam::{SpinUp, SpinUpParameters, SpinUpWithoutStiffening};
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

/// det(K − ω²) of ẍ = −K x, which changes its sign at each frequency, by elimination.
pub fn determinant(a: &[f64], hertz: f64) -> f64 {
    let count = a.len().isqrt() / 2;
    let entry = |i: usize, j: usize| {
        -a[2 * count * (count + i) + j] - if i == j { (TAU * hertz).powi(2) } else { 0.0 }
    };
    let mut rows: Vec<Vec<f64>> = (0..count).map(|i| (0..count).map(|j| entry(i, j)).collect()).collect();
    let mut product = 1.0;
    while let Some(top) = rows.pop() {
        let Some(pivot) = top.last() else { break };
        product *= pivot;
        for row in &mut rows {
            let factor = row[top.len() - 1] / pivot;
            row.iter_mut().zip(&top).for_each(|(entry, below)| *entry -= factor * below);
            row.pop();
        }
    }
    product
}

/// Between two hinges: k²π²/(2π) √(EI/μL⁴) with sines, to the last digits; with 1, 3 and 5 free shapes, of which every
/// other is even, the frame is at y = −2 (p₀ + p₂ + …), M of the symmetric motion is m (1 + 4 J) with J full of ones, and the frequency a root of
/// 1 = 4 Σ ω²/(ω_k² − ω²).
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
    macro_rules! near {
        ($model:ty, $expected:expr) => {{
            let model = <$model>::default();
            let linear = Linearisation::at(&model, 0.0, &<$model>::START, &()).expect("regular");
            let a = linear.state_space().expect("coordinates").a;
            let [below, above] = [-1e-6, 1e-6].map(|hertz| determinant(&a, $expected + hertz));
            assert!(below * above < 0.0, "{}: {below} {above}", $expected);
        }};
    }
    near!(HingedBarOfOne<f64>, 117.186_312);
    near!(HingedBar<f64>, 115.907_738);
    near!(HingedBarOfFive<f64>, 115.701_954);
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

/// Simeon's slider-crank of the test set: rod, slider and modes at every quarter of the run against one by extrapolation with quadrature of
/// |ṙ|², of the same beam; with the rotary inertia of sections the end is at −0.3311734303, 0.1697373958 m.
#[test]
fn slider_crank_with_an_elastic_rod() {
    let expected = [
        [0.2898289550336, 0.1643962237495, -1.947827878244e-04, -2.005527649083e-05, -8.039614795379e-06],
        [-0.4881578630956, 0.3169549489618, 1.273891711869e-03, 4.212983059651e-05, 1.763825561378e-07],
        [0.5051142022085, 0.3002873759416, -1.154340572256e-03, -4.467375596027e-05, -2.098710027282e-06],
        [-0.3311734300959, 0.1697373960512, 1.893081137792e-04, 2.376202186466e-05, -8.303347700119e-06],
    ];
    let model = FlexibleSliderCrank::<f64>::default();
    let (mut place, mut modes, mut rotary) = (Worst::default(), Worst::default(), Worst::default());
    run(&model, FlexibleSliderCrank::START, (1e3, 1e-6), 0.1, 25_000, |step, sample| {
        let outputs = &sample.outputs;
        if step == 0 {
            return;
        }
        let [angle, stroke, first, second, stretch] = expected[step - 1];
        place.see(outputs.angle, angle);
        place.see(outputs.stroke, stroke);
        modes.see(outputs.first, first);
        modes.see(outputs.second, second);
        modes.see(outputs.stretch, stretch);
        if step == expected.len() {
            rotary.see(outputs.angle, -0.331_173_430_3);
            rotary.see(outputs.stroke, 0.169_737_395_8);
        }
    })
    .expect("it turns");
    place.below(2e-11, "elastic slider-crank, rod and slider");
    modes.below(2e-11, "elastic slider-crank, modes");
    rotary.below(4e-10, "elastic slider-crank, the test set with the integrals");
}

/// The hub's manoeuvre after Kane, Ryan and Banerjee: the tip in the frame, to the digits of a run by extrapolation with quadrature of |ṙ|²; with
/// stiffening a geometrically exact rod is within 2.1e-3 m of it, and without it nothing holds the beam.
#[test]
fn spin_up_with_and_without_stiffening() {
    const STEP: f64 = 1.25e-3;
    let expected = [
        -0.151_300_105_6,
        -0.469_364_667_9,
        -0.561_028_955_1,
        -0.363_669_530_0,
        -0.112_543_536_8,
        0.001_595_383_1,
    ];
    let exact = [-0.151_273_72, -0.468_435_50, -0.558_984_87, -0.362_672_44, -0.112_643_61, 0.001_274_77];
    let (mut tip, mut rod, mut reach) = (Worst::default(), Worst::default(), Worst::default());
    let mut lowest = (0.0, 0.0);
    let model = SpinUp::<f64>::default();
    run(&model, SpinUp::START, (0.0, STEP), 15.0, 1, |step, sample| {
        let outputs = &sample.outputs;
        if outputs.across < lowest.1 {
            lowest = (sample.time, outputs.across);
        }
        if step % 2000 == 0 && step > 0 {
            tip.see(outputs.across, expected[step / 2000 - 1]);
            rod.see(outputs.across, exact[step / 2000 - 1]);
        }
        if step == 6000 {
            // What bending draws in is part of the place of the tip; the exact rod's is at x = 9.98213491 m.
            reach.see((outputs.reach.powi(2) - outputs.across.powi(2)).sqrt(), 9.982_134_91);
        }
    })
    .expect("it holds");
    tip.below(1e-9, "spin-up, tip");
    rod.below(2.1e-3, "spin-up, exact rod");
    reach.below(1.3e-4, "spin-up, shortening");
    assert!((lowest.0 - 6.769_5).abs() < 2e-3 && (lowest.1 + 0.575_917_9).abs() < 1e-7, "{lowest:?}");

    let model = SpinUpWithoutStiffening::<f64>::default();
    let mut grows = Worst::default();
    run(&model, SpinUpWithoutStiffening::START, (0.0, STEP), 10.0, 2000, |step, sample| {
        for (at, expected) in [(2, -0.521_837_675), (3, -1.464_543_38), (4, -72.006_963_6)] {
            if step == at {
                grows.see(sample.outputs.across / expected, 1.0);
            }
        }
    })
    .expect("in numbers");
    grows.below(1e-7, "spin-up without stiffening");
}

/// At the end of the manoeuvre the rate is steady and the motion linear in the modes. Three shapes against the beam as it is, out of the plane
/// (Wright, Smith, Thresher, Wang, J. Appl. Mech. 49, 1982), where the squares are more by Ω²: from above, as by Ritz's method.
#[test]
fn frequencies_of_a_turning_beam() {
    // √(EI/ρA)/L².
    let unit = (14_000.0_f64 / 1.2).sqrt() / 100.0;
    let published = [
        (0.0, 3.516_015_00, 1e-6),
        (1.0, 3.681_646_31, 1e-5),
        (3.0, 4.797_278_34, 1e-4),
        (5.0, 6.449_544_40, 3e-4),
    ];
    for (turned, expected, above) in published {
        let parameters = SpinUpParameters { top: turned * unit };
        let model = SpinUp::<f64>::prepare(parameters).expect("within its bounds");
        let state = run(&model, SpinUp::START, (0.0, 2.5e-3), 15.0, 1, |_, _| {}).expect("it holds");
        let linear = Linearisation::at(&model, 15.0, &state, &()).expect("regular");
        let a = linear.state_space().expect("three coordinates").a;
        let in_plane = |flap: f64| unit * (flap * flap - turned * turned).sqrt() / TAU;
        let [low, high] = [1.0 - 1e-9, 1.0 + above].map(|part| determinant(&a, in_plane(expected * part)));
        assert!(low * high < 0.0, "{turned}: {low} {high}");
    }
}

macro_rules! pendulum {
    ($name:ident, $($part:tt)*) => {
        linkwright::mechanism! {
            planar $name {
                gravity [m/s^2] = (0, -9.81);
                $($part)*
                particle bob { mass [kg] = 0.2; }
                joint hinge: revolute(ground(0, 0) [m], arm.start);
                joint hook:  revolute(arm.end, bob.center);
                start   { hinge.angle [rad] = 0; hinge.rate [rad/s] = 1; }
                options { emit = (tangent); }
                output x [m] = bob.center.x;
                output y [m] = bob.center.y;
            }
        }
    };
}

pendulum!(Rigid, rod arm { mass [kg] = 0.6; length [m] = 1.2; });
pendulum!(StiffAndFree, beam arm { mass [kg] = 0.6; length [m] = 1.2; section = circle(diameter [mm] = 20); young [GPa] = 2e9;
    modes = (axial = 1, bending = 3); });
pendulum!(StiffAndPinned, beam arm { mass [kg] = 0.6; length [m] = 1.2; section = circle(diameter [mm] = 20); young [GPa] = 2e9;
    modes = (axial = 1, bending = 2); shapes = pinned; stiffening = on; });
pendulum!(StiffAndClamped, #[allow(slender)] beam arm { mass [kg] = 0.6; length [m] = 1.2; section = circle(diameter [mm] = 20);
    young [GPa] = 2e9; modes = (bending = 2); shapes = clamped; });

/// A beam that is ten million times as stiff as steel moves as the rod of its mass and length: mass, moment of inertia and centre are those of the rod
/// whatever the frame is. Its frame moves in other coordinates, so that steps of second order are extrapolated.
#[test]
fn a_stiff_beam_is_a_rigid_body() {
    macro_rules! moved {
        ($model:ident) => {{
            let model = $model::<f64>::default();
            let end = |step: f64| {
                let mut simulation =
                    Simulation::new(&model, $model::START).integrator(GeneralisedAlpha::new(0.0)).step(step);
                simulation.advance_until(1.5).expect("it swings");
                let outputs = simulation.sample().outputs;
                [outputs.x, outputs.y]
            };
            let (whole, half) = (end(5e-4), end(2.5e-4));
            [0, 1].map(|axis| (4.0 * half[axis] - whole[axis]) / 3.0)
        }};
    }
    let rigid = moved!(Rigid);
    for (name, stiff) in [
        ("free", moved!(StiffAndFree)),
        ("pinned", moved!(StiffAndPinned)),
        ("clamped", moved!(StiffAndClamped)),
    ] {
        let off = [0, 1].map(|axis: usize| (rigid[axis] - stiff[axis]).abs());
        assert!(off[0].max(off[1]) < 1e-9, "{name}: {rigid:?} {stiff:?}");
    }
}
