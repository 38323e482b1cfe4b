//! A load by what presses.

linkwright::mechanism! {
    planar Mount {
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = 1; }
        body cart { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint rail: prismatic(ground(0, 0) [m], cart.center, axis = (1, 0));
        joint pin: revolute(cart.center, arm.start);
        friction rub: on(pin) = coulomb(coefficient = 0.2, radius [m] = 0.01, speed [rad/s] = 0.01);
        force push: force(rail) = -rub.normal;
    }
}

fn main() {}
