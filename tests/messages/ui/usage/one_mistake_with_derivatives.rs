//! Code that uses the derivatives of a mechanism with a mistake adds no messages of its own.

linkwright::mechanism! {
    pub planar Pendulum {
        input drive [N*m];
        rod arm { mass [m] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        torque motor: torque(pivot) = drive;
        options { emit = (tangent); }
    }
}

fn main() {
    let model = Pendulum::<f64>::default();
    let inputs = PendulumInputs { drive: 1.0 };
    if let Ok(found) = linkwright::equilibrium(&model, 0.0, &Pendulum::START.q, &inputs) {
        let state = PendulumState { q: found.q, ..Pendulum::START };
        let here = linkwright::Linearisation::at(&model, 0.0, &state, &inputs);
        let _ = here.and_then(|here| here.state_space());
        let _ = linkwright::actuation(&model, 0.0, &state, &state.v, &inputs, &["drive"]);
    }
}
