//! What is run: problems A02 and A03 of the IFToMM library of computational benchmark problems.

use crate::methods::table;
use crate::trial::Setting;
use linkwright::mechanism;

/// A table and what it is about.
pub struct Benchmark {
    pub name: &'static str,
    pub run: fn() -> String,
}

pub const ALL: [Benchmark; 2] = [
    Benchmark { name: "A02, two windows, tree coordinates, 10 s", run: a02_tree },
    Benchmark { name: "A02, two windows, absolute coordinates, 10 s", run: a02_absolute },
];

/// B0 at 10 s, exact.
const B0: [f64; 2] = [0.328_458_111_540_815_4, 0.944_518_538_178_601];

macro_rules! two_windows {
    ($name:ident, $coordinates:ident) => {
        mechanism! {
            /// Two windows of unit rods (IFToMM A02).
            planar $name {
                gravity [m/s^2] = (0, -9.81);
                repeat i in 0..3 {
                    rod crank[i] { mass [kg] = 1; length [m] = 1; }
                    joint pin[i]: revolute(ground(i, 0) [m], crank[i].start);
                }
                repeat i in 0..2 {
                    rod coupler[i] { mass [kg] = 1; length [m] = 1; }
                    joint left[i]:  revolute(crank[i].end, coupler[i].start);
                    joint right[i]: revolute(coupler[i].end, crank[i+1].end);
                    start { coupler[i].angle [rad] ~ 0; pin[i+1].angle [deg] ~ 90; }
                }
                start   { pin[0].angle [deg] = 90; pin[0].rate [rad/s] = -1; }
                options { coordinates = $coordinates; emit = (penalty, projection); }
                output x [m] = crank[0].end.x;
                output y [m] = crank[0].end.y;
            }
        }
    };
}

two_windows!(TwoWindows, tree);
two_windows!(TwoWindowsAbsolute, absolute);

macro_rules! a02 {
    ($function:ident, $model:ident) => {
        fn $function() -> String {
            let model = $model::<f64>::default();
            let setting = Setting {
                model: &model,
                start: $model::START,
                end: 10.0,
                steps: &[0.01, 0.005, 0.002, 0.001],
                energy: |sample| sample.energy(),
                error: |sample| (sample.outputs.x - B0[0]).hypot(sample.outputs.y - B0[1]),
            };
            table(&setting, 10.0)
        }
    };
}

a02!(a02_tree, TwoWindows);
a02!(a02_absolute, TwoWindowsAbsolute);
