//! A unit behind a name: brackets there are an index.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        output seconds [s] = time [s];
    }
}

fn main() {}
