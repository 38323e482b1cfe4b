//! An index that no round declares.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        repeat i in 0..3 {
            rod link[i] { mass [kg] = 1; length [m] = 1; }
            joint knee[i]: revolute(link[i].end, link[i + 1].start);
        }
    }
}

fn main() {}
