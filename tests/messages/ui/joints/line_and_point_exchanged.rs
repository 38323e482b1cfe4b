//! The point before the line.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        line rail = (ground(0, 0), ground(1, 0) [m]);
        joint slide: point_on_line(arm.end, rail);
    }
}

fn main() {}
