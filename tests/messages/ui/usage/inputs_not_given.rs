//! A mechanism with inputs does not run before they are given.

linkwright::mechanism! {
    planar Pendulum {
        input drive [N*m];
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        force motor: torque(pivot) = drive;
    }
}

fn main() {
    let model = Pendulum::<f64>::default();
    let mut simulation = linkwright::Simulation::new(&model, Pendulum::START).step(1e-3);
    let _ = simulation.advance();
}
