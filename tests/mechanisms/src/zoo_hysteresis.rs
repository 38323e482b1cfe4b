//! Mechanisms whose loads remember where the motion has turned: backbones after Masing, and the law of Bouc and Wen.

linkwright::mechanism! {
    /// A cart on a worn rail with two links behind it, a torsion bar, a band, a bushing and a damper of rubber.
    pub planar Worn {
        param stiffness [N/m] = 300;
        param depth [mm] = 400;
        param share [1] = 0.2;
        input push [N];
        gravity [m/s^2] = (0, -9.81);
        table bar(turn [deg]) [N*m] = [(0, 0), (10, 10), (30, 19), (60, 25)], linear, outside = hold;
        table band(way [m]) [N] = [(-0.6, -40), (-0.2, -30), (0.2, 30), (0.6, 40)], linear;
        signal stretch [m] = norm(bob.end - ground(0.6, 0.2) [m]) - 0.5 [m];
        signal swept [m^2] = cross(bob.end - arm.start, (arm.end + cart.center)/2);
        body cart { mass [kg] = 2; inertia [kg*m^2] = 0.1; }
        rod arm { mass [kg] = 0.7; length [m] = 0.5; }
        rod bob { mass [kg] = 0.5; length [m] = 0.4; }
        joint rail: prismatic(ground(0, 0) [m], cart.center, axis = (1, 0));
        joint shoulder: revolute(cart.center, arm.start);
        joint elbow: revolute(arm.end, bob.start);
        torque twist: masing(shoulder, backbone = bar);
        force tie: masing(stretch, backbone = band);
        force bush: bouc_wen(rail, stiffness = stiffness, share = share, depth = depth, beta = 0.5, gamma = 0.4, exponent = 2);
        bouc_wen rubber: bouc_wen(elbow.angle + 0.2 [rad]*sin(3 [rad/s]*time), stiffness [N*m/rad] = 5, depth [deg] = 40, beta = 0.7,
                                  gamma = -0.2, exponent = 1.7);
        force pull: force(rail) = push;
        force fan: along(swept) = -2 [N/m]*dot(bob.end - arm.start, bob.end.velocity)/1 [m^2/s];
        start { rail.travel [m] = 0.1; rail.speed [m/s] = 0.4; shoulder.angle [rad] = -1.2; elbow.angle [rad] = 0.5; elbow.rate [rad/s] = 1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output held [N*m] = twist.resistance;
        output bushed [N] = bush.resistance;
        output sweeps [m^2/s] = swept.rate + cross(cart.center.velocity, bob.end);
        output lost [W] = power(twist) + power(tie) + power(bush) + power(rubber);
    }
}

linkwright::mechanism! {
    /// A plate in space on a wire rope, beside an arm whose hinge rubs; a filter follows what the rope holds with.
    pub spatial Roped {
        param rubs [N*m/rad] = 8;
        gravity [m/s^2] = (0, 0, -9.81);
        table rope(way [mm]) [N] = [(0, 0), (200, 30), (700, 60)], linear, outside = hold;
        state felt [N] = 0;
        rate felt = (tether.resistance - felt)/0.1 [s];
        box plate { mass [kg] = 2; size [m] = (0.6, 0.4, 0.1); point left [m] = (-0.3, 0, 0); }
        rod arm { mass [kg] = 0.5; length [m] = 0.4; radius [mm] = 10; }
        joint hinge: revolute(plate.center, arm.start, axis = (0, 1, 0));
        force tether: masing(distance(plate.left, ground(-1, 0.2, 1) [m]) - 1.2 [m], backbone = rope);
        bouc_wen rub: bouc_wen(hinge, stiffness = rubs, share = 0.3, depth [rad] = 0.6, beta = 1, gamma = 0, exponent = 1);
        bouc_wen strap: bouc_wen(plate.left.z, stiffness [N/m] = 40, depth [m] = 0.5, beta = 0.6, gamma = 0.1, exponent = 2.5);
        start { plate.center.x [m] = 0.1; plate.center.y [m] = 0; plate.center.z [m] = 0.1; hinge.angle [rad] = 0.3; hinge.rate [rad/s] = 1; }
        output felt [N] = felt;
        output spanned [m^2] = norm(cross(plate.left - arm.end, 2*arm.end - ground(0.1, 0.2, 0.3) [m]));
        output volume [m^3/s] = dot(cross(plate.left, -arm.end), 0.5*arm.end.velocity);
        output rubbed [N*m] = rub.resistance;
    }
}
