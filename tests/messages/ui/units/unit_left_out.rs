//! A declaration without the unit of its value.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        output reach = arm.end.x;
    }
}

fn main() {}
