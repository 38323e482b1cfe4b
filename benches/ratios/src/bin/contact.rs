//! Time of the four-bar whose coupler's middle may touch a floor, with live gates, beside that of the one without.
//!
//! ```text
//! cd benches/ratios && RUSTFLAGS="-C target-cpu=native" cargo run --release --bin contact
//! ```

use ratios::{Timed, least};

macro_rules! four_bar {
    ($name:ident: $($more:tt)*) => {
        linkwright::mechanism! {
            /// Of unit rods.
            planar $name {
                gravity [m/s^2] = (0, -9.81);
                rod crank { mass [kg] = 1; length [m] = 1; }
                rod coupler { mass [kg] = 1; length [m] = 1; }
                rod rocker { mass [kg] = 1; length [m] = 1; }
                joint crank_pin: revolute(ground(0, 0) [m], crank.start);
                joint rocker_pin: revolute(ground(1, 0) [m], rocker.start);
                joint left: revolute(crank.end, coupler.start);
                joint right: revolute(coupler.end, rocker.end);
                start { crank_pin.angle [deg] = 90; crank_pin.rate [rad/s] = -1; rocker_pin.angle [deg] ~ 90; coupler.angle [rad] ~ 0; }
                $($more)*
            }
        }
    };
}

four_bar! { Free: }
four_bar! { Touching:
    surface floor: half_plane(line(ground(0, 0.9) [m], ground(1, 0.9) [m]));
    surface middle: point(coupler.center);
    contact lands: between(floor, middle) = kelvin_voigt(stiffness [N/m] = 1e4, damping [N*s/m] = 5);
}
four_bar! { Rubbing:
    surface floor: half_plane(line(ground(0, 0.9) [m], ground(1, 0.9) [m]));
    surface middle: point(coupler.center);
    contact lands: between(floor, middle) = kelvin_voigt(stiffness [N/m] = 1e4, damping [N*s/m] = 5);
    friction rub: on(lands) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
}

const APART: f64 = 1e-3;
const STEP: f64 = 1e-4;

fn main() {
    let mut all = [
        Timed::new(Free::<f64>::default(), (), APART, STEP),
        Timed::new(Touching::<f64>::default(), (), APART, STEP),
        Timed::new(Rubbing::<f64>::default(), (), APART, STEP),
    ];
    let least = least(&mut all);
    println!("| four-bar | evaluation, ns | ratio | step, ns | ratio |");
    println!("|---|---|---|---|---|");
    for (name, [evaluation, step]) in ["free", "with a contact", "with friction on it"].iter().zip(&least) {
        let [by, steps] = [evaluation / least[0][0], step / least[0][1]];
        println!("| {name} | {evaluation:.1} | {by:.2} | {step:.1} | {steps:.2} |");
    }
}
