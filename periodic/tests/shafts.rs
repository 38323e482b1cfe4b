//! The turning gear pair with backlash on elastic shafts: the jump weakens as the shafts soften.
//!
//! A driven motor, a shaft, a pinion, teeth with k = 1 − 0.3 cos 50 θ, a wheel, a shaft and a load. On hard shafts this is case B of the gear pair
//! of one coordinate (`gear_pair.rs`). Source of the conclusion: Bai, Haastrup and Rigal's yaw drive, whose nonlinearity weakens with the
//! torsional stiffness of its shafts; the numbers are ours. Why: the gap is then small beside what the load twists shafts and teeth together.

use core::f64::consts::TAU;
use linkwright::{AssembleExt, mechanism};
use linkwright_periodic::{Along, Cycle, End, PeriodicMotion};

mechanism! {
    /// Lengths in micrometres, masses in kilograms and times in seconds, as in `GearPairOscillator`; `stiffness` is that of each shaft, in N/m at the base circle.
    pub planar Shafted {
        const BASE [m] = 3e-3 [m]*50/2*cos(20 [deg]);
        param omega [rad/s] = 1 in 0.01..10;
        param stiffness [N/m] = 20 in 0.01..1000;
        body motor  { mass [kg] = 1; inertia [kg*m^2] = 1; }
        body pinion { mass [kg] = 1; inertia [kg*m^2] = BASE*BASE*0.1 [kg]; toothing rim: external(teeth = 50, module [mm] = 3); }
        body wheel  { mass [kg] = 1; inertia [kg*m^2] = BASE*BASE*0.1 [kg]; toothing rim: external(teeth = 50, module [mm] = 3); }
        body load   { mass [kg] = 1; inertia [kg*m^2] = BASE*BASE*0.9 [kg]; }
        joint front: revolute(ground(0, 0), motor.center);
        joint near:  revolute(ground(0, 0), pinion.center);
        joint far:   revolute(ground(150, 0) [mm], wheel.center);
        joint back:  revolute(ground(150, 0) [mm], load.center);
        drive turning: front.angle = omega*time/50;
        shaft first:  shaft(front, near, ratio = 1, stiffness = BASE*BASE*stiffness, damping = BASE*BASE*stiffness*0.1 [s]);
        shaft second: shaft(far, back, ratio = 1, stiffness = BASE*BASE*stiffness, damping = BASE*BASE*stiffness*0.1 [s]);
        mesh teeth: mesh(pinion.rim, wheel.rim, stiffness = 1 [N/m]*(1 - 0.3*cos(50*far.angle)), damping = always(0.1 [N*s/m]),
                         backlash [um] = 2);
        torque brake: torque(back) = BASE*1e-7 [N];
        start { near.rate [rad/s] = 0.02; far.rate [rad/s] = -0.02; back.rate [rad/s] = -0.02; back.angle [rad] = 0; }
        options { emit = (tangent); }
        output x [um] = teeth.deflection;
    }
}

fn cycle<'c>(stiffness: f64) -> Cycle<'c, Shafted<f64>> {
    let model = move |omega| Shafted::prepare(ShaftedParameters { omega, stiffness });
    Cycle::new(model, |omega| TAU / omega)
        .advancing("near.angle", TAU / 50.0)
        .advancing("far.angle", -TAU / 50.0)
        .advancing("back.angle", -TAU / 50.0)
        .switch("x", 1e-6)
        .switch("x", -1e-6)
        .steps(100)
}

/// √(k/m) of teeth and both shafts in series, 1/k = 1 + 2/stiffness.
fn in_series(stiffness: f64) -> f64 {
    (1.0 + 2.0 / stiffness).recip().sqrt()
}

/// The same by hand, in micrometres beyond the motor's turn at the base circle: pinion, wheel and load, and their rates.
#[derive(Clone, Copy)]
struct ByHand {
    stiffness: f64,
    y: [f64; 6],
}

impl ByHand {
    fn rates(&self, omega: f64, t: f64, y: [f64; 6]) -> [f64; 6] {
        let [pinion, wheel, load, pinion_rate, wheel_rate, load_rate] = y;
        let base = 1e6 * 3e-3 * 25.0 * 20f64.to_radians().cos();
        let u = pinion - wheel;
        let beyond = u - u.clamp(-1.0, 1.0);
        let k = 1.0 - 0.3 * (omega * t + 50.0 * wheel / base).cos();
        let teeth = k * beyond + 0.1 * (pinion_rate - wheel_rate);
        let first = self.stiffness * (pinion + 0.1 * pinion_rate);
        let second = self.stiffness * (wheel - load + 0.1 * (wheel_rate - load_rate));
        [
            pinion_rate,
            wheel_rate,
            load_rate,
            (-first - teeth) / 0.1,
            (teeth - second) / 0.1,
            (second - 0.1) / 0.9,
        ]
    }

    /// Runge and Kutta's classical steps over some periods; the rms of u about its mean in the last.
    fn after(&mut self, omega: f64, periods: usize) -> f64 {
        let steps = 400;
        let h = TAU / omega / steps as f64;
        let (mut sum, mut squares) = (0.0, 0.0);
        for step in 0..periods * steps {
            if step == (periods - 1) * steps {
                (sum, squares) = (0.0, 0.0);
            }
            let (t, y) = (h * (step % steps) as f64, self.y);
            let u = y[0] - y[1];
            (sum, squares) = (sum + u, squares + u * u);
            let on = |k: [f64; 6], by: f64| core::array::from_fn(|at| y[at] + by * k[at]);
            let a = self.rates(omega, t, y);
            let b = self.rates(omega, t + 0.5 * h, on(a, 0.5 * h));
            let c = self.rates(omega, t + 0.5 * h, on(b, 0.5 * h));
            let d = self.rates(omega, t + h, on(c, h));
            self.y = core::array::from_fn(|at| y[at] + h / 6.0 * (a[at] + 2.0 * (b[at] + c[at]) + d[at]));
        }
        let mean = sum / steps as f64;
        (squares / steps as f64 - mean * mean).sqrt()
    }

    /// Ω of a sweep in steps of 1 % at which the rms goes from one side of a level to the other.
    fn jump(&mut self, from: f64, by: f64, level: f64) -> f64 {
        let above = self.after(from, 200) > level;
        let sweep = core::iter::successors(Some(from * by), |omega| Some(omega * by)).take(60);
        sweep.into_iter().find(|omega| (self.after(*omega, 120) > level) != above).unwrap()
    }
}

/// Folds, with the rms of both motions at the upper one.
struct Jump {
    folds: [f64; 2],
    rms: [f64; 2],
}

fn jump(stiffness: f64) -> Jump {
    let cycle = cycle(stiffness);
    let linear = in_series(stiffness);
    let start = Shafted::<f64>::default().start();
    let first = cycle.settle(0.65 * linear, &start, 60).unwrap();
    let along = Along { step: 0.04, ..Along::new(0.6 * linear..=1.1 * linear) };
    let branch = cycle.branch(&first, &along).unwrap();
    assert_eq!(branch.end, End::Left);
    assert_eq!(branch.folds.len(), 2, "at {stiffness}");
    let rms = |motion| cycle.measure(motion, "x").unwrap().rms;
    let last = branch.motions.last().unwrap();
    // By hand at the same frequency.
    let mut by_hand = ByHand { stiffness, y: [0.0, -1.1, -1.2, 0.0, 0.0, 0.0] };
    let found = by_hand.after(last.value, 300);
    assert!((found / (1e6 * rms(last)) - 1.0).abs() < 1e-4, "{found} for {}", rms(last));
    for motion in &branch.motions {
        // The product of the multipliers is e^(T tr A) (Liouville), the trace that of all dampings over their masses.
        let trace = (0.1 + 0.1 * stiffness) / 0.1 * 2.0 + 0.1 * stiffness / 0.9;
        let (product, wanted) = (motion.monodromy.determinant(), (-trace * motion.period).exp());
        assert!((product - wanted).abs() < 1e-6, "{product} for {wanted} at {}", motion.value);
    }
    let fold = &branch.folds[0];
    let below = rms(fold);
    let apart = |motion: &PeriodicMotion<_>| (motion.value - fold.value).abs();
    // Behind the folds, where it jumps to.
    let behind = branch.motions.iter().skip_while(|motion| motion.is_stable());
    let above =
        behind.filter(|motion| motion.is_stable()).min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap();
    Jump { folds: [fold.value, branch.folds[1].value], rms: [below, rms(above)] }
}

/// From 20 to 4 to 1 times the mean stiffness of the teeth: the frequencies between which there are two motions go from 15 to 11 to 3 % of the upper
/// one, and the rms jumps up by less.
#[test]
fn softer_shafts_weaken_the_jump() {
    let stiffnesses = [20.0, 4.0, 1.0];
    let jumps = stiffnesses.map(jump);
    let widths = jumps.each_ref().map(|jump| 1.0 - jump.folds[1] / jump.folds[0]);
    let heights = jumps.each_ref().map(|jump| jump.rms[1] / jump.rms[0]);
    for (found, wanted) in widths.iter().zip([0.1524, 0.1097, 0.0307]) {
        assert!((found - wanted).abs() < 1e-3, "{widths:?}");
    }
    assert!(heights[0] > heights[1] && heights[1] > heights[2] && heights[2] > 1.0, "{heights:?}");
    // Sweeps by hand jump where the folds are.
    for (stiffness, jump) in stiffnesses.into_iter().zip(&jumps) {
        let level = 0.5e6 * (jump.rms[0] + jump.rms[1]);
        let mut by_hand = ByHand { stiffness, y: [0.0, -1.1, -1.2, 0.0, 0.0, 0.0] };
        let up = by_hand.jump(0.85 * jump.folds[1], 1.01, level);
        assert!((0.99..=1.011).contains(&(up / jump.folds[0])), "{up} for {}", jump.folds[0]);
        let down = by_hand.jump(up, 0.99, level);
        assert!((0.989..=1.01).contains(&(down / jump.folds[1])), "{down} for {}", jump.folds[1]);
    }
}
