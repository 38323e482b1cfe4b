//! A slender rod that can spin about its own axis.

linkwright::mechanism! {
    spatial Wrong {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint ball: spherical(ground(0, 0, 0) [m], arm.start);
    }
}

fn main() {}
