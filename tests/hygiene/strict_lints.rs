//! Strict lints on the user's side are quiet about what is emitted.
#![forbid(unsafe_code)]
#![deny(missing_docs, warnings, unused, rust_2018_idioms, unreachable_pub, non_camel_case_types)]
#![deny(clippy::all, clippy::pedantic)]

linkwright::mechanism! {
    /// A pendulum with one of everything that becomes an item.
    pub(crate) planar Pendulum {
        /// How long.
        param length [m] = 1.0 in 0.1..2;
        /// What turns it.
        input drive [N*m];
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = length; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        table law(angle [deg]) [N*m] = [(-90, 1.234567890123), (0, 0), (90, -1.2345)], outside = hold;
        table loss(share) = [(0, 1), (1, 123456.5)];
        torque motor: torque(pivot) = drive + law(pivot.angle)*loss(0.0 + length/1 [m]);
        start { pivot.angle [rad] = 0.5; }
        options { emit = (penalty, projection, null_space, tangent); }
        /// How high.
        output height [m] = arm.end.y;
    }
}

fn main() {
    let model = Pendulum::prepare(PendulumParameters { length: 2.0 }).expect("a length");
    let inputs = PendulumInputs { drive: 1.0 };
    let outputs: PendulumOutputs =
        linkwright::Mechanism::outputs(&model, 0.0, &Pendulum::START, &inputs);
    let state: PendulumState = Pendulum::START;
    assert!((outputs.height - 2.0 * 0.5_f64.sin()).abs() < 1e-12 && state.v.len() == 1);
}
