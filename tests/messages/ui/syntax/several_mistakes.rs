//! Mistakes of one stage are reported together.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        output a [m] = nothing;
        output b [kg] = arm.end.x;
        force f: torque(pivt) = 1 [N*m];
    }
}

fn main() {}
