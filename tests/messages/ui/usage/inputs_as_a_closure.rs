//! A closure alone does not say when it is asked; the name of the type that is expected does.

use linkwright::{AssembleExt, mechanism};

mechanism! {
    planar Driven {
        input torque [N*m];
        body bob { mass [kg] = 1; inertia [kg*m^2] = 0.1; center [m] = (1, 0); }
        joint pin: revolute(ground(0, 0) [m], bob.origin);
        force motor: torque(pin) = torque;
    }
}

fn main() {
    let model = Driven::<f64>::default();
    let _ = model.simulation(model.start()).inputs(|time, _| DrivenInputs { torque: time });
}
