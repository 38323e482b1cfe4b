//! A rate in volts, a state in a constraint, and a second rate.

linkwright::mechanism! {
    planar Motor {
        input voltage [V];
        state current [A] = 0;
        state wound [mm] = 1;
        rate current = voltage - 0.5 [ohm]*current;
        rate wound = 0.1 [m/s]*cos(time*1 [rad/s]);
        rate wound = 0.1 [m/s];
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pin: revolute(ground(0, 0) [m], arm.start);
        torque drive: torque(pin) = 0.1 [N*m/A]*current;
        constraint reel: arm.end.x = wound;
    }
}

fn main() {}
