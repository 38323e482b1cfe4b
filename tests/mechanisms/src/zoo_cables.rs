//! Mechanisms on cables and cords: winches, eyes, pendulums that hang on what can only pull.

linkwright::mechanism! {
    /// A load that a drum winds up over an eye on a swinging boom, with stays and a plumb on a cord that is let down.
    pub planar Winch {
        param stiffness [kN] = 2;
        param give [mm] = 20 in 1..100;
        input torque [N*m];
        input slack [m];
        input veer [m/s];
        gravity [m/s^2] = (0, -9.81);
        state taken [m] = 0.02;
        rate  taken = 0.1 [m/s]*sin(2 [rad/s]*time) - taken/1 [s];
        disk drum { mass [kg] = 3; radius [m] = 0.2; }
        rod  boom { mass [kg] = 4; length [m] = 1.2; }
        disk load { mass [kg] = 2; radius [m] = 0.1; point hook [m] = (0, 0.1); }
        particle plumb { mass [kg] = 0.5; }
        joint shaft: revolute(ground(-0.3, 0.2) [m], drum.center);
        joint foot:  revolute(ground(0, 0) [m], boom.start);
        joint line:  cord(boom.end, plumb.center, length = 0.6 [m] + 0.05 [m]*time/1 [s]);
        torque motor: torque(shaft) = torque;
        cable hoist: cable(drum.center, boom.end, load.hook, stiffness = stiffness, damping [N*s/m] = 3,
                           length = 2.4 [m] - 0.2 [m/rad]*shaft.angle + 0.03 [m]*sin(4 [rad/s]*time));
        cable stay:  cable(ground(-0.9, 0.1) [m], boom.end, stiffness [N] = 900, length = 1.32 [m], smooth = give);
        cable guy:   cable(boom.end, ground(1.6, 0) [m], stiffness [N] = 700, length = 1.4 [m] + slack + taken, damping [N*s/m] = 5,
                           pay_out = veer, smooth [mm] = 40);
        force check: cable(load.center, ground(1.5, -0.6) [m], stiffness [N] = 300, length [mm] = 250);
        start { foot.angle [deg] = 60; foot.rate [rad/s] = 0.2; shaft.angle [rad] = 0.1; shaft.rate [rad/s] = -0.3;
                plumb.center.x [m] = 0.8; load.center.x [m] = 0.9; load.center.y [m] = -0.2; load.angle [rad] = 0.3; load.rate [rad/s] = 0.5; }
        options { emit = (penalty, projection, null_space, tangent); }
        output hoisted [N] = hoist.tension;
        output stayed [kN] = stay.tension;
        output held [N] = guy.tension;
        output hung [N] = line.tension;
        output wound [W] = power(hoist) + power(guy);
    }
}

linkwright::mechanism! {
    /// A plate in space that three cables hold above a weight on a cord.
    pub spatial Hoisted {
        param stiffness [N] = 500;
        gravity [m/s^2] = (0, 0, -9.81);
        box plate { mass [kg] = 2; size [m] = (0.6, 0.4, 0.1);
                    point left [m] = (-0.3, 0, 0.05); point front [m] = (0.2, 0.2, 0.05); point back [m] = (0.2, -0.2, 0.05); }
        particle weight { mass [kg] = 0.7; }
        rod arm { mass [kg] = 0.5; length [m] = 0.4; radius [mm] = 10; }
        joint pin: revolute(ground(1, 0, 0.8) [m], arm.start, axis = (0, 1, 0));
        joint tied: cord(plate.center, weight.center, length [m] = 0.5);
        rod beam { mass [kg] = 0.2; length [m] = 0.5; radius [mm] = 8; }
        joint knuckle: spherical(arm.end, beam.start);
        cable left: cable(ground(-0.5 [m], 0 [m], 1 [m] + 0.02 [m]*sin(5 [rad/s]*time)), plate.left, stiffness = stiffness, length [m] = 0.9, damping [N*s/m] = 2);
        cable front: cable(plate.front, ground(0.5, 0.4, 1) [m], stiffness = stiffness, length = 0.9 [m] - 0.1 [m/rad]*pin.angle);
        cable back: cable(beam.end, arm.start, plate.back, stiffness = stiffness, smooth [mm] = 15,
                          length [m] = 1.2, damping [N*s/m] = 1);
        start { plate.center.x [m] = 0.1; plate.center.y [m] = 0.02; plate.center.z [m] = 0.02; plate.orientation = (0.99, 0.05, -0.04, 0.1);
                weight.center.x [m] = 0.15; weight.center.y [m] = 0.05; weight.center.z [m] ~ -0.5; pin.angle [rad] = 0.4; pin.rate [rad/s] = -0.6; }
        options { emit = (penalty, projection, null_space, tangent); }
        output tied [N] = tied.tension;
        output left [N] = left.tension;
        output sum [N] = front.tension + back.tension;
    }
}
