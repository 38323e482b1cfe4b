//! A number without a unit beside a quantity: it is never converted silently.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        const OFFSET [deg] = 30;
        start { pivot.angle [deg] = 2*OFFSET + 15; }
    }
}

fn main() {}
