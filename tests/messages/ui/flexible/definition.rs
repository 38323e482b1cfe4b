//! What a definition asks of a file of modes that is well.

linkwright::mechanism! {
    spatial Beyond {
        flexible arm(file = "arm.flex") { point start = node(1); modes = 1..9; }
        joint base: fixed(ground(0, 0, 0) [m], arm.start);
    }
}

linkwright::mechanism! {
    spatial Nowhere {
        flexible arm(file = "arm.flex") { point start = node(2); }
        joint base: fixed(ground(0, 0, 0) [m], arm.start);
    }
}

linkwright::mechanism! {
    spatial Heavier {
        flexible arm(file = "arm.flex") { mass [kg] = 7; point start = node(1); }
        joint base: fixed(ground(0, 0, 0) [m], arm.start);
    }
}

linkwright::mechanism! {
    spatial Placed {
        flexible arm(file = "arm.flex") { point start [m] = (0, 0, 0); }
        joint base: fixed(ground(0, 0, 0) [m], arm.start);
    }
}

linkwright::mechanism! {
    spatial Without {
        flexible arm { point start = node(1); }
        joint base: fixed(ground(0, 0, 0) [m], arm.start);
    }
}

linkwright::mechanism! {
    spatial Framed {
        flexible arm(file = "arm.flex") { point start = node(1); }
        joint base: fixed(ground(0, 0, 0) [m], arm.origin);
    }
}

linkwright::mechanism! {
    spatial Unknown {
        flexible arm(file = "arm.flex") { point start = node(1); modes = 2..3; }
        joint base: fixed(ground(0, 0, 0) [m], arm.start);
        output bent [mm] = arm.mode[1];
    }
}

fn main() {}
