//! A length that is zero at the default of its parameter.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        param reach [m] = 0;
        rod link { mass [kg] = 1; length [m] = reach; }
        joint knee: revolute(arm.end, link.start);
    }
}

fn main() {}
