//! Samples at even times, by a method that knows states only at the ends of its steps.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {
    let model = Pendulum::<f64>::default();
    let mut simulation = linkwright::Simulation::new(&model, Pendulum::START).step(1e-3);
    let _ = simulation.run_every(0.1, 1.0, |_| ());
}
