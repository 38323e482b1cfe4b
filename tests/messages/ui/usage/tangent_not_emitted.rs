//! Derivatives that were not asked for are missed where they are used.

linkwright::mechanism! {
    planar Pendulum {
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {
    let model = Pendulum::<f64>::default();
    let _ = linkwright::equilibrium(&model, 0.0, &Pendulum::START.q, &());
}
