//! Where `linkwright` has another name. The dependency's name is the only one that this crate knows it by.
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs, warnings, unused, unreachable_pub)]

pub use lw as engine;

lw::mechanism! {
    /// A pendulum with one of everything that becomes an item.
    pub planar Pendulum {
        /// How long.
        param length [m] = 1 in 0.1..2;
        /// What turns it.
        input drive [N*m];
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = length; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        torque motor: torque(pivot) = drive;
        start { pivot.angle [rad] = 0.5; }
        options { emit = (penalty, projection, null_space, tangent); }
        /// How high.
        output height [m] = arm.end.y;
    }
}

// A second one in the same module.
lw::mechanism!(file = "ball.mech");

#[cfg(test)]
mod tests {
    use super::*;
    use engine::{Rk4, Sampled, Simulation};

    #[test]
    fn it_runs() {
        let model = Pendulum::default();
        let inputs = Sampled(|_, _| PendulumInputs { drive: 0.0 });
        let mut simulation =
            Simulation::new(&model, Pendulum::START).inputs(inputs).integrator(Rk4).step(1e-3);
        let energy = simulation.energy();
        simulation.run_until(0.1, |_| ()).unwrap();
        assert!((simulation.energy() - energy).abs() < 1e-9);
        assert_eq!(Ball::DEGREES_OF_FREEDOM, 3);
    }

    #[test]
    fn in_a_function() {
        lw::mechanism! {
            planar Inside { rod arm { mass [kg] = 1; length [m] = 1; } joint pivot: revolute(ground(0, 0) [m], arm.start); }
        }
        assert_eq!(Inside::DEGREES_OF_FREEDOM, 1);
    }

    /// The path that is written comes before the one that is found.
    #[test]
    fn by_a_path() {
        lw::mechanism! {
            planar Named {
                rod arm { mass [kg] = 1; length [m] = 1; }
                joint pivot: revolute(ground(0, 0) [m], arm.start);
                options { crate = crate::engine; }
            }
        }
        assert_eq!(Named::DEGREES_OF_FREEDOM, 1);
    }
}
