//! Implicit methods need the tangent, and say so.

linkwright::mechanism! {
    planar Pendulum {
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {
    let model = Pendulum::<f64>::default();
    let simulation = linkwright::Simulation::new(&model, Pendulum::START);
    let mut simulation = simulation.integrator(linkwright::GeneralisedAlpha::new(0.8)).step(1e-3);
    let _ = simulation.advance();
}
