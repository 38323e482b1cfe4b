//! Frictions that remember: bristles and dragged anchors in joints of every kind, where surfaces touch at one place and at several, and where
//! a gap has a slip of its own. Contacts begin inside of each other, so that what compares them near their start sees friction.

linkwright::mechanism! {
    /// A slide on a rail, an arm on it, and a point of that on a line.
    pub planar Bristly {
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
        friction f_rail: on(rail) = lugre(static = 0.3, kinetic = 0.2, transition [m/s] = 0.1, stiffness [1/m] = 200, damping [s/m] = 0.001,
            viscous [N*s/m] = 0.5, length [m] = 0.1);
        friction f_pin: on(pin) = asperity(coefficient = 0.25, stiffness [1/rad] = 2, radius [mm] = 15, speed [rad/s] = 0.1, preload [N] = 2);
        friction f_wire: on(wire) = lugre(static = 0.1, kinetic = 0.1, transition [m/s] = 0.1, stiffness [1/m] = 50, damping [s/m] = 0);
        start { rail.travel [m] = 0; pin.angle [deg] = -70; rail.speed [m/s] = 0.5; pin.rate [rad/s] = -1; }
        options { friction_passes = 5; emit = (tangent); }
        output pressed [N] = f_wire.normal;
        output resisting [N] = f_rail.force;
        output gone [W] = -power(f_rail) - power(f_pin) - power(f_wire);
    }
}

linkwright::mechanism! {
    /// A closed loop of space with pins, a sleeve, a ball and a cross.
    pub spatial BristlyLoop {
        gravity [m/s^2] = (0, 0, -9.81);
        input torque [N*m];
        body crank { mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.01, 0.004); center [m] = (0.05, 0, 0); point tip [m] = (0.12, 0, 0.02); }
        body rod_ { mass [kg] = 0.5; inertia [kg*m^2] = (0.002, 0.006, 0.006); point a [m] = (-0.2, 0, 0); point b [m] = (0.2, 0, 0); }
        body slider { mass [kg] = 0.8; inertia [kg*m^2] = (0.002, 0.002, 0.003); }
        joint main: revolute(ground(0, 0, 0) [m], crank.origin, axis = (0, 0.1, 1));
        joint ball: spherical(crank.tip, rod_.a);
        joint cross: universal(rod_.b, slider.origin, axis = (0, 1, 0), second_axis = (0, 0, 1));
        joint sleeve: cylindrical(ground(0.5, 0.05, 0) [m], slider.origin, axis = (1, 0.1, 0));
        torque drive: torque(main) = torque;
        friction f_main: on(main) = lugre(static = 0.2, kinetic = 0.15, transition [rad/s] = 1, stiffness [1/rad] = 3, damping [s/rad] = 0.001,
            radius [mm] = 10, shoulder [mm] = 14, length [mm] = 40);
        friction f_ball: on(ball) = asperity(coefficient = 0.1, stiffness [1/rad] = 1, speed [rad/s] = 0.3, radius [mm] = 8);
        friction f_cross: on(cross) = lugre(static = 0.15, kinetic = 0.1, transition [rad/s] = 1, stiffness [1/rad] = 2, damping [s/rad] = 0.001,
            radius [mm] = 6);
        friction f_sleeve: on(sleeve) = lugre(static = 0.2, kinetic = 0.15, transition [m/s] = 0.2, stiffness [1/m] = 20, damping [s/m] = 0.001,
            radius [mm] = 12, length [mm] = 60, viscous [N*s/m] = 0.2);
        start { main.angle [deg] = 40; main.rate [rad/s] = 3; sleeve.travel [m] ~ 0; sleeve.angle [rad] ~ 0; rod_.orientation ~ (1, 0, 0, 0); }
        options { friction_passes = 5; }
        output pressed [N] = f_sleeve.normal;
        output lost [W] = -power(f_main) - power(f_ball) - power(f_cross) - power(f_sleeve);
    }
}

linkwright::mechanism! {
    /// A ball and a bar on a floor, and a bead with a slip of its own.
    #[allow(penetration)]
    pub planar BristlyPairs {
        param grip = 0.5 in 0..1;
        gravity [m/s^2] = (0, -9.81);
        disk ball { mass [kg] = 1; radius [m] = 0.3; }
        particle bead { mass [kg] = 0.4; }
        body board { mass [kg] = 2; inertia [kg*m^2] = 0.3; point a [m] = (-0.5, -0.1); point b [m] = (0.5, -0.1); point c [m] = (0.2, 0.4);
            surface bar: segment(board.a, board.b, radius [mm] = 50); surface block: polygon(board.a, board.b, board.c); }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0.1) [m]));
        contact lands: between(floor, ball.surface) = kelvin_voigt(stiffness [N/m] = 300, damping [N*s/m] = 6);
        contact lies: between(board.bar, floor) = kelvin_voigt(stiffness [N/m] = 200, damping [N*s/m] = 6);
        contact leans: between(ball.surface, board.block) = kelvin_voigt(stiffness [N/m] = 90, damping [N*s/m] = 3);
        contact pecks: gap(bead.center.x + 0.3 [m], slip = bead.center.y + 0.2 [m]*sin(board.angle)) = kelvin_voigt(stiffness [N/m] = 100);
        friction f_lands: on(lands) = lugre(static = 0.5, kinetic = 0.3, transition [m/s] = 0.4, stiffness [1/m] = 50, damping [s/m] = 0.5,
            viscous [N*s/m] = 1);
        friction f_lies: on(lies) = asperity(coefficient = grip, stiffness [1/m] = 20, speed [m/s] = 0.3);
        friction f_leans: on(leans) = asperity(coefficient = 0.4, stiffness [1/m] = 30, speed [m/s] = 0.2);
        friction f_pecks: on(pecks) = lugre(static = 0.4, kinetic = 0.3, transition [m/s] = 0.2, stiffness [1/m] = 30, damping [s/m] = 0.1);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.25; bead.center.x [m] = -0.4; bead.center.y [m] = 0.1;
                board.center.x [m] = 0.5; board.center.y [m] = 0.2; board.angle [rad] = 0.15; ball.center.velocity.x [m/s] = 1;
                board.rate [rad/s] = 0.4; ball.rate [rad/s] = -2; bead.center.velocity.y [m/s] = -0.5; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = f_lands.normal;
        output held [N] = f_lands.force + f_lies.force;
        output lost [W] = -power(f_lands) - power(f_lies) - power(f_leans) - power(f_pecks);
    }
}

linkwright::mechanism! {
    /// A ball, a bar and a coin on a tilted plane.
    #[allow(penetration)]
    pub spatial BristlyBodies {
        gravity [m/s^2] = (0, 0, -9.81);
        sphere ball { mass [kg] = 1; radius [m] = 0.2; }
        body coin { mass [kg] = 0.5; inertia [kg*m^2] = (0.02, 0.02, 0.04);
                    surface rim: disk_rim(coin.center, axis = (0.2, 0.1, 1), radius [m] = 0.4); }
        body log { mass [kg] = 2; inertia [kg*m^2] = (0.1, 0.3, 0.3); point a [m] = (-0.4, 0, 0); point b [m] = (0.4, 0.1, 0);
                   surface bark: capsule(log.a, log.b, radius [m] = 0.2); }
        surface table: plane(ground(0, 0, 0) [m], axis = (0.1, 0, 1));
        contact rolls: between(table, ball.surface) = hunt_crossley(force [N] = 60, depth [m] = 0.1, dissipation [s/m] = 0.2);
        contact falls: between(log.bark, table) = hunt_crossley(force [N] = 100, depth [m] = 0.1, exponent = 1, dissipation [s/m] = 0.5);
        contact spins: between(coin.rim, table) = kelvin_voigt(stiffness [N/m] = 90, damping [N*s/m] = 2);
        friction f_rolls: on(rolls) = lugre(static = 0.5, kinetic = 0.3, transition [m/s] = 0.4, stiffness [1/m] = 50, damping [s/m] = 0.5);
        friction f_falls: on(falls) = asperity(coefficient = 0.4, stiffness [1/m] = 20, speed [m/s] = 0.3);
        friction f_spins: on(spins) = lugre(static = 0.4, kinetic = 0.2, transition [m/s] = 0.3, stiffness [1/m] = 20, damping [s/m] = 0.2,
            viscous [N*s/m] = 0.3);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.1; ball.center.z [m] = 0.15; coin.center.x [m] = 2; coin.center.y [m] = 0;
                coin.center.z [m] = -0.1; log.center.x [m] = -1; log.center.y [m] = 0; log.center.z [m] = 0.25; ball.rate.x [rad/s] = 2;
                coin.rate.z [rad/s] = 3; coin.center.velocity.x [m/s] = 0.5; log.center.velocity.y [m/s] = 0.3; }
        options { emit = (penalty, null_space); }
        output pressed [N] = f_falls.normal;
        output lost [W] = -power(f_rolls) - power(f_falls) - power(f_spins);
    }
}
