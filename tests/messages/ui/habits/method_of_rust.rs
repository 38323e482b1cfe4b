//! A function behind its argument.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        output height [m] = 1 [m]*pivot.angle.sin();
    }
}

fn main() {}
