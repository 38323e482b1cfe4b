//! A driver of an angle that never changes.

linkwright::mechanism! {
    planar Drawer {
        body drawer { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint rail: prismatic(ground(0, 0) [m], drawer.center, axis = (1, 0));
        drive turn: drawer.angle = 0 [rad];
    }
}

fn main() {}
