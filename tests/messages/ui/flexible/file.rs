//! Files of modes that are of another version, not what they say, or not there.

linkwright::mechanism! {
    spatial Newer {
        flexible arm(file = "newer.flex") { point start = node(1); }
        joint base: fixed(ground(0, 0, 0) [m], arm.start);
    }
}

linkwright::mechanism! {
    spatial Asymmetric {
        flexible arm(file = "asymmetric.flex") { point start = node(1); }
        joint base: fixed(ground(0, 0, 0) [m], arm.start);
    }
}

linkwright::mechanism! {
    spatial Missing {
        flexible arm(file = "amr.flex") { point start = node(1); }
        joint base: fixed(ground(0, 0, 0) [m], arm.start);
    }
}

fn main() {}
