//! A density of a rod without a radius.

linkwright::mechanism! {
    spatial Wrong {
        rod arm { density [kg/m^3] = 7800; length [m] = 1; }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.start, axis = (0, 0, 1));
    }
}

fn main() {}
