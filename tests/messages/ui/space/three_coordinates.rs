//! A place of space in the plane.

linkwright::mechanism! {
    planar Wrong {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.start);
    }
}

fn main() {}
