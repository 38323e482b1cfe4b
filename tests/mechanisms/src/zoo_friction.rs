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

linkwright::mechanism! {
    /// A puck on a slanted table, a plate that slides on it, and a knob on a slope that a spring ties to the plate.
    pub spatial RubbedFaces {
        gravity [m/s^2] = (0, 1, -9.81);
        param grip = 0.2 in 0..1;
        input push [N];
        body puck { mass [kg] = 1.2; inertia [kg*m^2] = (0.003, 0.004, 0.006); point sole [m] = (0.01, 0.02, -0.03); point lid [m] = (0, 0.01, 0.04); }
        body plate { mass [kg] = 0.7; inertia [kg*m^2] = (0.004, 0.002, 0.005); point under [m] = (0.02, 0, -0.01); point tip [m] = (0.1, 0.03, 0.02); }
        body knob { mass [kg] = 0.4; inertia [kg*m^2] = (0.001, 0.002, 0.001); point foot [m] = (0.01, 0, -0.02); }
        joint table: planar(ground(0, 0, 0) [m], puck.sole, axis = (0.1, 0, 1));
        joint above: planar(plate.under, puck.lid, axis = (0, 0.2, 1));
        joint slope: point_on_plane(knob.foot, ground(0.5, 0, 0) [m], axis = (0.3, 0.1, 1));
        spring tie: spring(plate.tip, knob.center, stiffness [N/m] = 60, length [m] = 0.3);
        force pushing: force(plate.tip) = (push, 0.3*push, 0 [N]);
        friction f_table: on(table) = coulomb(coefficient = grip, radius [mm] = 40, speed [m/s] = 0.05);
        friction f_above: on(above) = stribeck(static = 0.3, kinetic = 0.2, transition [m/s] = 0.2, radius [mm] = 25, speed [m/s] = 0.05, viscous [N*s/m] = 0.1);
        friction f_slope: on(slope) = coulomb(coefficient = 0.15, speed [m/s] = 0.05, preload [N] = 1);
        start { table.travel_1 [m] = 0; table.travel_2 [m] = 0; table.angle [deg] = 10; table.speed_1 [m/s] = 0.4; table.rate [rad/s] = 1;
                above.travel_1 [m] = 0.02; above.travel_2 [m] = 0; above.angle [deg] = 5; knob.center.x [m] ~ 0.5; knob.center.y [m] ~ 0; knob.center.z [m] ~ 0.02; }
        options { friction_passes = 4; }
        output pressed [N] = f_table.normal + f_above.normal + f_slope.normal;
        output lost [W] = -power(f_table) - power(f_above) - power(f_slope);
    }
}

linkwright::mechanism! {
    /// A nut that runs down its screw, and an arm that winds itself into the nut.
    pub spatial RubbedThreads {
        gravity [m/s^2] = (0, 0, -9.81);
        input torque [N*m];
        body nut { mass [kg] = 2; inertia [kg*m^2] = (0.002, 0.003, 0.004); center [m] = (0.01, 0, 0); point side [m] = (0.05, 0.01, 0); }
        body arm { mass [kg] = 0.6; inertia [kg*m^2] = (0.001, 0.004, 0.004); center [m] = (0.1, 0, 0.02); }
        joint thread: screw(ground(0, 0, 0) [m], nut.origin, axis = (0, 0.1, 1), pitch [mm] = 60);
        joint bolt: screw(arm.origin, nut.side, axis = (1, 0, 0.2), pitch [mm] = -40);
        torque turn: torque(bolt) = torque;
        friction f_thread: on(thread) = coulomb(coefficient = 0.12, radius [mm] = 20, speed [m/s] = 0.05, force [N] = 0.3);
        friction f_bolt: on(bolt) = lugre(static = 0.2, kinetic = 0.15, transition [m/s] = 0.2, stiffness [1/m] = 20, damping [s/m] = 0.01, radius [mm] = 15);
        start { thread.angle [rad] = 0; thread.rate [rad/s] = -3; bolt.angle [deg] = 30; bolt.rate [rad/s] = 4; }
        options { friction_passes = 4; }
        output pressed [N] = f_thread.normal + f_bolt.normal;
        output along [N] = f_thread.force;
        output lost [W] = -power(f_thread) - power(f_bolt);
    }
}

linkwright::mechanism! {
    /// A bead on a bent wire, and a slide with a slot in which the bead runs as well.
    pub planar RubbedWire {
        gravity [m/s^2] = (0, -9.81);
        input push [N];
        particle bead { mass [kg] = 0.3; }
        body slide { mass [kg] = 0.8; inertia [kg*m^2] = 0.01; }
        joint rail: revolute(ground(0.1, -0.4) [m], slide.center);
        joint wire: point_on_curve(ground(0, 0) [m], bead.center, y = 0.8 [1/m]*wire.parameter*wire.parameter - 0.2 [m]);
        joint slot: point_on_curve(slide.center, bead.center, y = 2*slot.parameter + 0.03 [m]*sin(slot.parameter/(0.1 [m])));
        force pushing: force(bead.center) = (push, 0 [N]);
        friction f_wire: on(wire) = coulomb(coefficient = 0.06, speed [m/s] = 0.05);
        friction f_slot: on(slot) = stribeck(static = 0.06, kinetic = 0.04, transition [m/s] = 0.2, speed [m/s] = 0.05, preload [N] = 1);
        start { wire.parameter [m] = 0.2; wire.parameter_rate [m/s] = 0.7; slide.angle [deg] ~ 0; slot.parameter [m] ~ 0.1; }
        options { friction_passes = 6; }
        output pressed [N] = f_wire.normal + f_slot.normal;
        output lost [W] = -power(f_wire) - power(f_slot);
    }
}

linkwright::mechanism! {
    /// A shaft, one that swings at its end and keeps its speed, and a nose on that by a joint of the same kind.
    pub spatial RubbedShafts {
        gravity [m/s^2] = (0, 1, -9.81);
        input torque [N*m];
        body shaft { mass [kg] = 2; inertia [kg*m^2] = (0.004, 0.004, 0.002); center [m] = (0, 0, 0.05); point far [m] = (0, 0.01, 0.1); }
        body swing { mass [kg] = 0.8; inertia [kg*m^2] = (0.003, 0.004, 0.001); center [m] = (0.01, 0, 0.1); point far [m] = (0.01, 0, 0.2); }
        body nose { mass [kg] = 0.3; inertia [kg*m^2] = (0.001, 0.0012, 0.0005); center [m] = (0, 0.01, 0.03); }
        joint main: revolute(ground(0, 0, 0) [m], shaft.origin, axis = (0, 0, 1));
        joint knuckle: constant_velocity(shaft.far, swing.origin, axis = (0, 0, 1));
        joint second: constant_velocity(nose.origin, swing.far, axis = (0.1, 0, 1));
        torque drive: torque(main) = torque;
        friction f_main: on(main) = coulomb(coefficient = 0.1, radius [mm] = 10, speed [rad/s] = 0.1);
        friction f_knuckle: on(knuckle) = stribeck(static = 0.15, kinetic = 0.1, transition [rad/s] = 2, radius [mm] = 25, speed [rad/s] = 0.2);
        friction f_second: on(second) = lugre(static = 0.2, kinetic = 0.15, transition [rad/s] = 1, stiffness [1/rad] = 20, damping [s/rad] = 0.01, radius [mm] = 20);
        start { main.angle [rad] = 0.2; main.rate [rad/s] = 3; swing.orientation ~ (0.95, 0.3, 0, 0); nose.orientation ~ (0.9, 0.3, 0.3, 0); }
        options { friction_passes = 4; }
        output pressed [N] = f_knuckle.normal + f_second.normal;
        output lost [W] = -power(f_main) - power(f_knuckle) - power(f_second);
    }
}
