//! Reactions have parts, and laws of loads do not know them.

linkwright::mechanism! {
    planar Arm {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pin: revolute(ground(0, 0) [m], arm.start);
        torque rub: torque(pin) = -0.01 [m]*pin.reaction.size*sign(pin.rate);
        output held [N] = pin.reaction;
        output pressed [N] = pin.reaction.normal;
    }
}

fn main() {}
