//! A linear–quadratic regulator of the light cart-pole: a bob of 1 kg on a massless pole, balanced on a cart a million times lighter.
//!
//! ```text
//! cargo run --release -p linkwright-models --example lqr               writes lqr.svg in the target directory
//! cargo run --release -p linkwright-models --example lqr -- FILE.svg
//! ```
//! Upright it falls with a rate of 3 132 1/s: within a tick of 0.2 ms what is off nearly doubles, so that the plant as it is between two ticks must be
//! known, and A_d and B_d are those of the step itself (`step_map`), which the linear plant with its input held (`zero_order_hold`) is compared with. The
//! gain is the fixed point of Riccati's recursion P ← Q + A_dᵀ P (A_d − B_d K), K = B_dᵀ P A_d/(R + B_dᵀ P B_d). The cart is led
//! smoothly: from 3 rad/s on the bob's centrifugal force is more than its weight, and nothing is linear any more. Source: Åström, Wittenmark,
//! *Computer-Controlled Systems*, 11.4.

use linkwright::{
    AssembleExt, Linearisation, Rk4, Stepper, coordinate_rates, coordinate_values, mechanism, step_map,
    zero_order_hold,
};
use linkwright_examples::plots::{Curve, Panel, draw};
use std::error::Error;

mechanism! {
    /// The light cart-pole upright, with a force on its cart.
    pub planar CartPole {
        input push [N];
        gravity [m/s^2] = (0, -9.81);
        particle cart { mass [kg] = 1e-6; }
        body pole { mass [kg] = 1; inertia [kg*m^2] = 0; center [m] = (0, 1); }
        joint rail: point_on_line(line(ground(0, 0) [m], ground(1, 0) [m]), cart.center);
        joint pin:  revolute(cart.center, pole.origin);
        force motor: force(cart.center, direction = (1, 0)) = push;
        start  { rail.travel [m] = 0; rail.speed [m/s] = 0; pole.angle [rad] = 0; pole.rate [rad/s] = 0; }
        options { emit = (tangent); }
        expect { degrees_of_freedom = 2; }
        output cart [m] = cart.center.x;
        output angle [rad] = pole.angle;
    }
}

/// The tick, s, and how many there are.
const TICK: f64 = 2e-4;
const TICKS: usize = 40_000;
/// What errors of (travel, angle, speed, rate) and the force cost.
const COST: [f64; 4] = [10.0, 0.0, 0.0, 0.0];
const FORCE: f64 = 1.0;

type Matrix = [[f64; 4]; 4];

fn main() -> Result<(), Box<dyn Error>> {
    let model = CartPole::<f64>::default();
    let (upright, none) = (model.start(), CartPoleInputs { push: 0.0 });
    let step = step_map(&model, &Rk4, (0.0, &upright), &none, TICK)?;
    let space = Linearisation::at(&model, 0.0, &upright, &none)?.state_space()?;
    let (held, _) = zero_order_hold(&space.a, &space.b, TICK)?;
    let apart = held.iter().zip(&step.a).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        / held.iter().fold(0.0, |m, a| f64::max(m, a.abs()));
    // Of cosh λh.
    let growth = held[5] + (held[5] * held[5] - 1.0).sqrt();
    println!(
        "in a tick it falls {growth:.2} times further; A_d of the step is {apart:.1e} off that of the linear plant"
    );
    let a: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| step.a[4 * i + j]));
    let gain = regulator(&a, &step.b);
    println!("gain: {gain:.3?}");

    let near = [0.0, 1e-4, 0.0, 0.0];
    let given = [(near[0], near[2]), (near[1], near[3])].map(|(position, rate)| linkwright::Motion {
        position,
        rate,
        acceleration: 0.0,
    });
    let start = model.kinematics(0.0, &upright.q, &given)?.state();
    let mut plant: Stepper<_> = model.stepper(start, Rk4);
    let (mut travels, mut angles, mut forces, mut places) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut last = near;
    for tick in 0..TICKS {
        let (time, state) = (plant.time(), plant.state());
        let (s, rates) =
            (coordinate_values(&model, time, &state.q), coordinate_rates(&model, time, &state.q, &state.v));
        let [travel, angle] = [0, 1].map(|k| usize::from(linkwright::Tangent::<f64>::states(&model)[k]));
        last = [s[travel], s[angle], rates[travel], rates[angle]];
        let (place, speed) = path(time);
        let off = [last[0] - place, last[1], last[2] - speed, last[3]];
        let push = -gain.iter().zip(off).map(|(k, x)| k * x).sum::<f64>();
        plant.step(&CartPoleInputs { push }, TICK)?;
        if tick % 20 == 0 {
            travels.push((time, last[0]));
            places.push((time, place));
            angles.push((time, last[1]));
            forces.push((time, push));
        }
    }
    let off = [last[0] - path(plant.time()).0, last[1]];
    println!("after {:.1} s the cart is {:.1e} m and the pole {:.1e} rad off", plant.time(), off[0], off[1]);
    assert!(off[0].abs() < 2e-3 && off[1].abs() < 1e-3, "it is not balanced");
    let curve = |label, points| vec![Curve { label, points }];
    let panels = [
        Panel {
            label: "travel of the cart, m",
            curves: vec![
                Curve { label: "travel", points: travels },
                Curve { label: "asked for", points: places },
            ],
        },
        Panel { label: "angle of the pole, rad", curves: curve("angle", angles) },
        Panel { label: "force on the cart, N", curves: curve("force", forces) },
    ];
    let file = draw("lqr", "Light cart-pole, balanced and carried along", "time, s", &panels)?;
    println!("{} shows it", file.display());
    Ok(())
}

/// Where the cart should be, m, and how fast, m/s: 0.3 m in three seconds, and then there.
fn path(time: f64) -> (f64, f64) {
    let x = (time / 3.0).min(1.0);
    (0.3 * x * x * x * (10.0 - 15.0 * x + 6.0 * x * x), 0.1 * 30.0 * x * x * (1.0 - x) * (1.0 - x))
}

/// K of u = −K x.
fn regulator(a: &Matrix, b: &[f64]) -> [f64; 4] {
    let mut p: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { COST[i] } else { 0.0 }));
    let mut gain = [0.0; 4];
    for _ in 0..200_000 {
        let pb: [f64; 4] = std::array::from_fn(|i| (0..4).map(|k| p[i][k] * b[k]).sum());
        let across = FORCE + (0..4).map(|k| b[k] * pb[k]).sum::<f64>();
        let next: [f64; 4] = std::array::from_fn(|j| (0..4).map(|k| pb[k] * a[k][j]).sum::<f64>() / across);
        // Joseph's form stays symmetric and positive: (A − B K)ᵀ P (A − B K) + Kᵀ R K + Q.
        let closed: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] - b[i] * next[j]));
        let pc: Matrix =
            std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| p[i][k] * closed[k][j]).sum()));
        p = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let cost = if i == j { COST[i] } else { 0.0 };
                cost + next[i] * FORCE * next[j] + (0..4).map(|k| closed[k][i] * pc[k][j]).sum::<f64>()
            })
        });
        // Of each by itself: what moves the cart converges last.
        let change = gain.iter().zip(next).map(|(old, new): (&f64, f64)| ((old - new) / new).abs());
        let change = change.fold(0.0, f64::max);
        gain = next;
        if change < 1e-9 {
            break;
        }
    }
    gain
}
