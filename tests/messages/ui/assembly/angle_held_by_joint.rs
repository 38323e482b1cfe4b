//! An angle that a joint holds at another value.

linkwright::mechanism! {
    planar Drawer {
        body drawer { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint rail: prismatic(ground(0, 0) [m], drawer.center, axis = (1, 0));
        start { drawer.angle [deg] = 180; }
    }
}

fn main() {}
