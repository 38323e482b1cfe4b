//! Warnings of a mechanism break no build, however strict: their level is set where they are.
#![deny(warnings, deprecated, unused)]

mod strict {
    linkwright::mechanism! {
        planar Pendulum {
            const LENGTH [m] = 1;
            param payload [kg] = 2;
            rod arm { mass [kg] = 1; length [m] = 1; }
            joint pivot: revolute(ground(0, 0), arm.start);
            torque motor: torque(pivot) = 0;
        }
    }

    pub fn freedoms() -> usize {
        let _ = PendulumParameters { payload: 1.0_f64 };
        Pendulum::DEGREES_OF_FREEDOM
    }
}

fn main() {
    assert_eq!(strict::freedoms(), 1);
}
