use linkwright::mechanism;

mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        output load [N] = pivot.force;
    }
}

fn main() {}
