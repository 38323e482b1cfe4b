//! A body of no particular shape without an inertia.

linkwright::mechanism! {
    planar Pendulum {
        body arm { mass [kg] = 1; point start [m] = (-0.5, 0); }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {}
