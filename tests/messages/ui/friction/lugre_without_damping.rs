//! Bristles have a stiffness and a damping.

linkwright::mechanism! {
    planar Bench {
        body block { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
        friction rub: on(rail) = lugre(static = 0.5, kinetic = 0.4, transition [m/s] = 0.01, stiffness [1/m] = 1e5);
    }
}

fn main() {}
