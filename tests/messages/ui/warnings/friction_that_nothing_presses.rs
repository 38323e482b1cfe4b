//! A block on a rail that nothing pulls aside.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Rail {
        body block { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
        friction rub: on(rail) = coulomb(coefficient = 0.3, speed [m/s] = 0.01);
        start { rail.travel [m] = 0; rail.speed [m/s] = 1; }
    }
}

fn main() {
    let the_only_error = ();
}
