//! What is run: problems A02 and A03 of the IFToMM library of computational benchmark problems.

use crate::methods::{implicit, table};
use crate::trial::Setting;
use linkwright::{LagrangeIndex1, Projected, Simulation, mechanism};
use linkwright_models::andrews::{Andrews, AndrewsIftomm};
use linkwright_models::change_point_four_bar::ChangePointFourBar;

/// A table and what it is about.
pub struct Benchmark {
    pub name: &'static str,
    pub run: fn() -> String,
}

pub const ALL: [Benchmark; 9] = [
    Benchmark { name: "A02, two windows, tree coordinates, 10 s", run: a02_tree },
    Benchmark { name: "A02, two windows, absolute coordinates, 10 s", run: a02_absolute },
    Benchmark { name: "A02, two windows, implicit methods, tree coordinates, 10 s", run: implicit_tree },
    Benchmark {
        name: "A02, two windows, implicit methods, absolute coordinates, 10 s",
        run: implicit_absolute,
    },
    Benchmark { name: "the lecture's example 4, 100 s", run: closed_loop },
    Benchmark { name: "Andrews' squeezer of the IVP test set, 0.03 s", run: andrews },
    Benchmark { name: "A03, Andrews' squeezer, 0.05 s", run: a03 },
    Benchmark { name: "A02, forty windows, tree coordinates, 10 s", run: ladder },
    Benchmark { name: "change point, 2 s", run: change_point },
];

mechanism! {
    /// The closed loop of the example `quick_return`, in absolute coordinates so that all eight rows can drift.
    planar ClosedLoop {
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = 1.0; length [m] = 0.4; }
        rod coupler { mass [kg] = 1.5; length [m] = 1.1; }
        rod rocker  { mass [kg] = 1.2; length [m] = 0.8; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(1, 0) [m], rocker.start);
        joint left:       revolute(crank.end, coupler.start);
        joint right:      revolute(coupler.end, rocker.end);
        start { crank_pin.angle [deg] = 60; crank_pin.rate [rad/s] = 15;
                rocker_pin.angle [deg] ~ 80; coupler.angle [deg] ~ 20; }
        options { coordinates = absolute; emit = (penalty, projection, null_space); }
    }
}

/// Root mean square of all residuals at the end.
fn closed_loop() -> String {
    let model = ClosedLoop::<f64>::default();
    let setting = Setting {
        model: &model,
        start: ClosedLoop::START,
        end: 100.0,
        steps: &[2e-3],
        energy: |sample| sample.energy(),
        error: &|sample| sample.constraint_residual().position_rms,
    };
    table(&setting, 10.0)
}

/// B0 at 10 s, exact.
const B0: [f64; 2] = [0.328_458_111_540_815_4, 0.944_518_538_178_601];

macro_rules! windows {
    ($name:ident, $windows:literal, $coordinates:ident $(, $tangent:ident)?) => {
        mechanism! {
            /// Windows of unit rods (IFToMM A02).
            planar $name {
                const N = $windows;
                gravity [m/s^2] = (0, -9.81);
                repeat i in 0..N+1 {
                    rod crank[i] { mass [kg] = 1; length [m] = 1; }
                    joint pin[i]: revolute(ground(i, 0) [m], crank[i].start);
                }
                repeat i in 0..N {
                    rod coupler[i] { mass [kg] = 1; length [m] = 1; }
                    joint left[i]:  revolute(crank[i].end, coupler[i].start);
                    joint right[i]: revolute(coupler[i].end, crank[i+1].end);
                    start { coupler[i].angle [rad] ~ 0; pin[i+1].angle [deg] ~ 90; }
                }
                start   { pin[0].angle [deg] = 90; pin[0].rate [rad/s] = -1; }
                options { coordinates = $coordinates; emit = (penalty, projection, null_space $(, $tangent)?); }
                output x [m] = crank[0].end.x;
                output y [m] = crank[0].end.y;
            }
        }
    };
}

windows!(TwoWindows, 2, tree, tangent);
windows!(TwoWindowsAbsolute, 2, absolute, tangent);
windows!(FortyWindows, 40, tree);

macro_rules! a02 {
    ($function:ident, $model:ident, $exact:expr, $steps:expr, $table:expr) => {
        fn $function() -> String {
            let model = $model::<f64>::default();
            let setting = Setting {
                model: &model,
                start: $model::START,
                end: 10.0,
                steps: &$steps,
                energy: |sample| sample.energy(),
                error: &|sample| (sample.outputs.x - $exact[0]).hypot(sample.outputs.y - $exact[1]),
            };
            $table(&setting)
        }
    };
}

const STEPS: [f64; 4] = [0.01, 0.005, 0.002, 0.001];
a02!(a02_tree, TwoWindows, B0, STEPS, |setting| table(setting, 10.0));
a02!(a02_absolute, TwoWindowsAbsolute, B0, STEPS, |setting| table(setting, 10.0));
a02!(implicit_tree, TwoWindows, B0, STEPS, implicit);
a02!(implicit_absolute, TwoWindowsAbsolute, B0, STEPS, implicit);
a02!(ladder, FortyWindows, ladder_end(), [0.005, 0.001], |setting| table(setting, 10.0));

/// B0 at 10 s: the windows move alike, so one crank moves as a pendulum,
/// ((N+1)/3 + N) θ̈ = −((N+1)/2 + N) g cos θ.
fn ladder_end() -> [f64; 2] {
    let windows = 40.0;
    let rate = ((windows + 1.0) / 2.0 + windows) * 9.81 / ((windows + 1.0) / 3.0 + windows);
    let (mut angle, mut speed) = (std::f64::consts::FRAC_PI_2, -1.0);
    let (h, count) = (1e-5, 1_000_000);
    let slope = |angle: f64| -rate * angle.cos();
    for _ in 0..count {
        // Runge and Kutta's classical method.
        let (k1, l1) = (speed, slope(angle));
        let (k2, l2) = (speed + 0.5 * h * l1, slope(angle + 0.5 * h * k1));
        let (k3, l3) = (speed + 0.5 * h * l2, slope(angle + 0.5 * h * k2));
        let (k4, l4) = (speed + h * l3, slope(angle + h * k3));
        angle += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        speed += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    }
    [angle.cos(), angle.sin()]
}

fn andrews() -> String {
    let model = Andrews::<f64>::default();
    let setting = Setting {
        model: &model,
        start: Andrews::START,
        end: 0.03,
        steps: &[2e-5, 1e-5, 5e-6],
        energy: |sample| sample.energy() - 0.033 * sample.outputs.beta,
        error: &|sample| (sample.outputs.beta - 15.81077119629904).abs(),
    };
    table(&setting, 100.0)
}

/// The error is that of the crank's angle against a run by projection with a fifth of the smallest step.
fn a03() -> String {
    let model = AndrewsIftomm::<f64>::default();
    let simulation = Simulation::new(&model, AndrewsIftomm::START);
    let mut finest = simulation.formulation(Projected::after(LagrangeIndex1)).step(1e-6);
    let mut end = f64::NAN;
    let outcome = finest.run_until(0.05, |sample| end = sample.outputs.beta);
    if let Err(error) = outcome {
        return format!("no reference: {error}\n");
    }
    let setting = Setting {
        model: &model,
        start: AndrewsIftomm::START,
        end: 0.05,
        steps: &[2e-5, 1e-5, 5e-6],
        energy: |sample| sample.energy() - 0.033 * sample.outputs.beta,
        error: &|sample| (sample.outputs.beta - end).abs(),
    };
    table(&setting, 100.0)
}

/// The error is that of the rocker's angle against a run by projection with a fifth of the smallest step.
fn change_point() -> String {
    let model = ChangePointFourBar::<f64>::default();
    let simulation = Simulation::new(&model, ChangePointFourBar::START);
    let mut finest = simulation.formulation(Projected::after(LagrangeIndex1)).step(2e-5);
    let mut end = f64::NAN;
    let outcome = finest.run_until(2.0, |sample| end = sample.outputs.rocker_angle);
    if let Err(error) = outcome {
        return format!("no reference: {error}\n");
    }
    let setting = Setting {
        model: &model,
        start: ChangePointFourBar::START,
        end: 2.0,
        steps: &[2e-3, 1e-3, 1e-4],
        energy: |sample| sample.energy(),
        error: &|sample| (sample.outputs.rocker_angle - end).abs(),
    };
    table(&setting, 10.0)
}
