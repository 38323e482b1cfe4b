//! Friction in joints by the reactions that they have: of every kind of bearing, carrying and closing loops, with the ground first and
//! second, and all laws.

linkwright::mechanism! {
    /// A crank, a rod and a slider with friction in every joint; the rail has a length.
    pub planar Rubbed {
        gravity [m/s^2] = (0, -9.81);
        param dry = 0.15 in 0..1;
        input torque [N*m];
        rod crank { mass [kg] = 0.8; length [m] = 0.1; }
        rod rod_ { mass [kg] = 1.2; length [m] = 0.35; }
        body slider { mass [kg] = 0.6; inertia [kg*m^2] = 2e-3; point edge [m] = (0.02, 0.01); }
        joint main: revolute(ground(0, 0) [m], crank.start);
        joint big: revolute(rod_.start, crank.end);
        joint wrist: revolute(rod_.end, slider.origin);
        joint rail: prismatic(slider.edge, ground(0.2, 0.03) [m], axis = (1, 0.1), angle [deg] = 8);
        torque drive: torque(main) = torque;
        friction at_main: on(main) = coulomb(coefficient = dry, radius [mm] = 12, speed [rad/s] = 0.1, torque [N*m] = 0.02);
        friction at_big: on(big) = stribeck(static = 0.2, kinetic = 0.12, transition [rad/s] = 1, speed [rad/s] = 0.1,
            radius [mm] = 9, viscous [N*m*s] = 1e-3, preload [N] = 4);
        friction at_wrist: on(wrist) = coulomb(coefficient = 0.1 + 0.02*abs(wrist.rate)/(1 [rad/s] + abs(wrist.rate)), radius [mm] = 8,
            speed [rad/s] = 0.1);
        friction in_rail: on(rail) = coulomb(coefficient = 0.1, speed [m/s] = 0.02, length [m] = 0.4, force [N] = 1);
        start { main.angle [deg] = 50; main.rate [rad/s] = 5; slider.angle [deg] ~ 0; rod_.angle [deg] ~ -15; }
        options { friction_passes = 4; }
        output pressed [N] = in_rail.normal;
        output resisting [N*m] = at_big.torque;
        output sliding [m/s] = in_rail.sliding;
        output lost [W] = -power(at_main) - power(at_big) - power(at_wrist) - power(in_rail);
    }
}

linkwright::mechanism! {
    /// A slide on a rail, an arm on it, and a point of that on a line, with friction in each.
    pub planar Sliding {
        gravity [m/s^2] = (0, -9.81);
        input push [N];
        body slide { mass [kg] = 1.5; inertia [kg*m^2] = 0.01; }
        rod arm { mass [kg] = 0.7; length [m] = 0.4; }
        particle bead { mass [kg] = 0.2; }
        joint rail: prismatic(ground(0, 0) [m], slide.origin, axis = (1, 0.2));
        joint pin: revolute(slide.origin, arm.start);
        joint wire: point_on_line(line(ground(-1, 0.5) [m], ground(1, 0.8) [m]), bead.center);
        spring tie: spring(arm.end, bead.center, stiffness [N/m] = 300, length [m] = 0.5);
        force pushing: force(slide.origin) = (push, 0 [N]);
        friction f_rail: on(rail) = stribeck(static = 0.3, kinetic = 0.2, transition [m/s] = 0.1, speed [m/s] = 0.02, length [m] = 0.1);
        friction f_pin: on(pin) = coulomb(coefficient = 0.25, radius [mm] = 15, speed [rad/s] = 0.1);
        friction f_wire: on(wire) = coulomb(coefficient = 0.1, speed [m/s] = 0.01);
        start { rail.travel [m] = 0; pin.angle [deg] = -70; rail.speed [m/s] = 0.5; pin.rate [rad/s] = -1; }
        output pressed [N] = f_wire.normal;
        output gone [W] = -power(f_rail) - power(f_pin) - power(f_wire);
    }
}

linkwright::mechanism! {
    /// A closed loop of space with friction in a pin with shoulder and length, a sleeve, a ball and a cross.
    pub spatial RubbedLoop {
        gravity [m/s^2] = (0, 0, -9.81);
        input torque [N*m];
        body crank { mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.01, 0.004); center [m] = (0.05, 0, 0); point tip [m] = (0.12, 0, 0.02); }
        body rod_ { mass [kg] = 1.4; inertia [kg*m^2] = (0.002, 0.03, 0.03); point near [m] = (-0.25, 0, 0); point far [m] = (0.25, 0, 0); }
        body block { mass [kg] = 0.9; inertia [kg*m^2] = (0.004, 0.003, 0.005); point side [m] = (0.01, 0.02, 0.03); }
        joint main: revolute(ground(0, 0, 0) [m], crank.origin, axis = (0, 0, 1));
        joint ball: spherical(crank.tip, rod_.near);
        joint hooke: universal(rod_.far, block.origin, axis = (0, 1, 0), second_axis = (0, 0, 1));
        joint sleeve: cylindrical(ground(0.5, 0.1, 0.05) [m], block.side, axis = (1, 0.1, 0.2));
        torque drive: torque(main) = torque;
        friction f_main: on(main) = coulomb(coefficient = 0.15, radius [mm] = 15, shoulder [mm] = 20, length [mm] = 60, speed [rad/s] = 0.1);
        friction f_ball: on(ball) = coulomb(coefficient = 0.1, radius [mm] = 12, speed [rad/s] = 0.1);
        friction f_hooke: on(hooke) = stribeck(static = 0.2, kinetic = 0.1, transition [rad/s] = 1, radius [mm] = 8, speed [rad/s] = 0.1);
        friction f_sleeve: on(sleeve) = coulomb(coefficient = 0.12, radius [mm] = 18, length [mm] = 80, speed [m/s] = 0.02);
        start { main.angle [deg] = 40; main.rate [rad/s] = 4; sleeve.travel [m] ~ 0; }
        output pressed [N] = f_main.normal;
        output lost [W] = -power(f_main) - power(f_ball) - power(f_hooke) - power(f_sleeve);
    }
}

linkwright::mechanism! {
    /// A rail, a pin on it, a ball at its end.
    pub spatial RubbedArm {
        gravity [m/s^2] = (0, 0, -9.81);
        body slide { mass [kg] = 2; inertia [kg*m^2] = (0.01, 0.01, 0.01); }
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.001, 0.02, 0.02); center [m] = (0.2, 0, 0); point tip [m] = (0.4, 0, 0); }
        body bob { mass [kg] = 0.5; inertia [kg*m^2] = (1e-3, 2e-3, 3e-3); point top [m] = (0, 0, 0.2); }
        joint rail: prismatic(slide.origin, ground(0, 0, 0) [m], axis = (1, 0.3, 0));
        joint pin: revolute(arm.origin, slide.origin, axis = (0, 1, 0));
        joint ball: spherical(arm.tip, bob.top);
        friction f_rail: on(rail) = coulomb(coefficient = 0.1, length [m] = 0.4, speed [m/s] = 0.05);
        friction f_pin: on(pin) = coulomb(coefficient = 0.2, radius [mm] = 15, length [mm] = 300, speed [rad/s] = 0.1);
        friction f_ball: on(ball) = coulomb(coefficient = 0.2, radius [mm] = 10, speed [rad/s] = 0.1, torque [N*m] = 0.01);
        start { rail.travel [m] = 0; rail.speed [m/s] = 0.4; pin.angle [deg] = 10; pin.rate [rad/s] = 1; bob.rate.x [rad/s] = 2; }
        options { friction_passes = 4; }
        output pressed [N] = f_pin.normal;
    }
}
