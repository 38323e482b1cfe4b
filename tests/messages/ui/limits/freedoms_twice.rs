//! Two expectations of one number.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        expect { degrees_of_freedom = 2; degrees_of_freedom = 1; }
    }
}

fn main() {}
