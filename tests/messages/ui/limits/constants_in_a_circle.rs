//! Three constants defined by each other.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        const A [m] = B;
        const B [m] = 2 * C;
        const C [m] = 1 [m] - A;
    }
}

fn main() {}
