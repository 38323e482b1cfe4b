//! Mechanisms with bodies that deform by the modes of files: nodes that carry, are carried and are cut, a full stiffness and what turns at nodes.

linkwright::mechanism! {
    /// A clamped arm on a cross, with a body at its end and one on a hinge at a place between.
    pub spatial Cantilever {
        param loss = 0.02 in 0..1;
        input push [N];
        gravity [m/s^2] = (0.3, -0.2, -9.81);
        flexible arm(file = "data/clamped.flex") {
            point start = node(1); point third = node(5); point end = node(11); modes = 1..5; damping_ratio = loss;
        }
        body hand { mass [kg] = 0.5; inertia [kg*m^2] = (1e-3, 2e-3, 1.5e-3); center [m] = (0.05, 0.01, 0.02); }
        body side { mass [kg] = 0.3; inertia [kg*m^2] = (1e-3, 2e-3, 1.5e-3); center [m] = (0.1, 0.01, 0.02); }
        joint base:  universal(ground(0, 0, 0) [m], arm.start, axis = (0, 0, 1), second_axis = (0, 1, 0));
        joint wrist: fixed(arm.end, hand.origin);
        joint hinge: revolute(arm.third, side.origin, axis = (0.3, 1, 0));
        spring tie:  spring(arm.third, ground(1, 1, 0) [m], stiffness [N/m] = 100, length [m] = 0.5, damping [N*s/m] = 1);
        force blow:  force(arm.end) = (push, 0.2 [N], -0.1 [N*s/m]*hand.center.velocity.z);
        start { base.angle_1 [rad] = 0.3; base.rate_1 [rad/s] = 2; base.angle_2 [rad] = -0.2; hinge.angle [rad] = 0.4; hinge.rate [rad/s] = 3;
                arm.mode[2] [mm] = 10; arm.mode[4].rate [m/s] = 0.1; }
        options { emit = (penalty, projection, null_space); }
        output x [m] = hand.center.x;
        output z [m] = hand.center.z;
        output bent [mm] = arm.mode[2] + 0.5 [s]*arm.mode[4].rate;
        output frame [m/s] = arm.origin.velocity.x;
        output whole [J] = energy;
    }
}

linkwright::mechanism! {
    /// A block on a ball, which hangs on a rod at its other end, and a body that is fixed to it: a loop through three of its nodes.
    pub spatial Block {
        param loss = 0.05 in 0..1;
        input twist [N*m];
        gravity [m/s^2] = (0.3, -0.2, -9.81);
        flexible plate(file = "data/block.flex") { point a = node(100); point b = node(103); point c = node(106); damping_ratio = loss; }
        rod link  { mass [kg] = 0.4; length [m] = 0.8; radius [m] = 0.01; }
        body hand { mass [kg] = 0.5; inertia [kg*m^2] = (1e-3, 2e-3, 1.5e-3); center [m] = (0.05, 0.01, 0.02); }
        joint base:  spherical(ground(0, 0, 0) [m], plate.a);
        joint hang:  universal(ground(0.6, 0.9, 0.1) [m], link.start, axis = (1, 0, 0), second_axis = (0, 0, 1));
        joint hold:  spherical(link.end, plate.c);
        joint wrist: revolute(plate.b, hand.origin, axis = (0.2, 0, 1));
        torque turn: torque(wrist) = twist;
        spring tie:  spring(plate.b, ground(1, 1, 0) [m], stiffness [N/m] = 100, length [m] = 0.5, damping [N*s/m] = 1);
        start { hang.angle_1 [rad] ~ 3.1; hang.angle_2 [rad] ~ 0; plate.mode[2] [mm] = 10; plate.mode[1].rate [mm/s] = 50; wrist.angle [rad] = 0.4;
                wrist.rate [rad/s] = 2; }
        options { emit = (penalty, projection, tangent); }
        output x [m] = hand.center.x;
        output sway [mm] = plate.mode[2];
        output whole [J] = energy;
    }
}
