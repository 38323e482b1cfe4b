//! The joint is none.

linkwright::mechanism! {
    planar Bench {
        gravity [m/s^2] = (0, -9.81);
        body block { mass [kg] = 2; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0.3));
        friction rub: on(rail) = coulomb(coefficient = 0.5, speed [m/s] = 1e-3);
        start { rail.travel [m] = 0; rail.speed [m/s] = 1; }
        expect { friction_time(rail) >= 1e-3 [s]; }
    }
}

fn main() {}
