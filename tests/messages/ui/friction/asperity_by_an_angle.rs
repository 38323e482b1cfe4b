//! A rail gives along a way, so that what resists is per m.

linkwright::mechanism! {
    planar Bench {
        body block { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
        friction rub: on(rail) = asperity(coefficient = 0.5, stiffness [1/rad] = 200, speed [m/s] = 0.01);
    }
}

fn main() {}
