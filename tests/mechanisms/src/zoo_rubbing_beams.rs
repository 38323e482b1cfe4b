//! What bends and rubs: surfaces at places of beams, whose sections turn, on the ground, on bodies and on each other, and at the node of a
//! body from a file. They begin inside of each other and move, so that what compares them near their start sees friction.

linkwright::mechanism! {
    /// A whisker on a floor with a ball on its tip, and an arm with a socket on a peg.
    #[allow(penetration, slender, stiffening)]
    pub planar RubbingBeams {
        param grip = 0.3 in 0..1;
        gravity [m/s^2] = (0, -9.81);
        beam whisker { length [m] = 0.6; section = rectangle(width [mm] = 12, height [mm] = 3); young [GPa] = 7; density [kg/m^3] = 2700;
                       modes = (axial = 1, bending = 3); shapes = clamped; stiffening = on;
                       surface tip: circle(whisker.end, radius [mm] = 150); }
        beam arm     { length [m] = 0.4; section = circle(diameter [mm] = 8); young [GPa] = 0.7; density [kg/m^3] = 2700; modes = (bending = 2);
                       point third [m] = (0.07, 0); surface socket: hole(arm.third, radius [mm] = 120); surface end: circle(arm.end, radius [mm] = 80); }
        disk ball    { mass [kg] = 0.2; radius [m] = 0.1; }
        surface floor: half_plane(line(ground(1, -0.08) [m], ground(-1, -0.05) [m]), side = right);
        surface peg: circle(ground(0.35, 0.68) [m], radius [mm] = 100);
        joint root:  revolute(ground(0, 0) [m], whisker.start);
        joint pivot: revolute(ground(0.1, 0.6) [m], arm.start);
        contact scrapes: between(whisker.tip, floor) = kelvin_voigt(stiffness [N/m] = 300, damping [N*s/m] = 3);
        contact carries: between(ball.surface, whisker.tip) = hunt_crossley(force [N] = 30, depth [mm] = 100, dissipation [s/m] = 0.1);
        contact hangs:   between(peg, arm.socket) = kelvin_voigt(stiffness [N/m] = 200);
        contact taps:    between(arm.end, ball.surface) = kelvin_voigt(stiffness [N/m] = 100);
        friction f_scrapes: on(scrapes) = coulomb(coefficient = grip, speed [m/s] = 0.1);
        friction f_carries: on(carries) = lugre(static = 0.5, kinetic = 0.3, transition [m/s] = 0.1, stiffness [1/m] = 100, damping [s/m] = 0.1);
        friction f_hangs: on(hangs) = stribeck(static = 0.5, kinetic = 0.3, transition [m/s] = 0.4, speed [m/s] = 0.1, viscous [N*s/m] = 1);
        friction f_taps: on(taps) = coulomb(coefficient = 0.2, speed [m/s] = 0.1);
        start { root.angle [deg] = -2; root.rate [rad/s] = 1; pivot.angle [deg] = 20; pivot.rate [rad/s] = -2; ball.center.x [m] = 0.55;
                ball.center.y [m] = 0.2; ball.angle [rad] = 0; ball.rate [rad/s] = 5; whisker.bending[0] [mm] = 20; whisker.bending[1].rate [m/s] = 0.4;
                arm.bending[0] [mm] = -10; arm.bending[1].rate [m/s] = 0.3; }
        options { emit = (tangent); }
        output sliding [m/s] = scrapes.sliding + carries.sliding;
        output resisting [N] = f_scrapes.force;
        output gone [W] = power(f_scrapes) + power(f_carries) + power(f_hangs) + power(f_taps);
    }
}

linkwright::mechanism! {
    /// A wand that twists and bends both ways, with a ball on its tip, on a slope.
    #[allow(penetration, slender, stiffening)]
    pub spatial RubbingWand {
        param grip = 0.3 in 0..1;
        gravity [m/s^2] = (0, 0, -9.81);
        beam wand { length [m] = 0.6; section = rectangle(height [mm] = 12, width [mm] = 3); young [GPa] = 0.7; shear_modulus [GPa] = 0.26;
                    density [kg/m^3] = 2700; modes = (bending_y = 1, bending_z = 2, torsion = 1);
                    surface tip: sphere(wand.end, radius [mm] = 150); }
        sphere ball { mass [kg] = 0.2; radius [m] = 0.1; }
        surface slope: plane(ground(0, 0, -0.08) [m], axis = (0.1, 0.2, 1));
        joint root: revolute(ground(0, 0, 0) [m], wand.start, axis = (0.1, 1, 0));
        contact scrapes: between(wand.tip, slope) = kelvin_voigt(stiffness [N/m] = 300, damping [N*s/m] = 3);
        contact carries: between(ball.surface, wand.tip) = hunt_crossley(force [N] = 30, depth [mm] = 100, dissipation [s/m] = 0.1);
        friction f_scrapes: on(scrapes) = coulomb(coefficient = grip, speed [m/s] = 0.1);
        friction f_carries: on(carries) = lugre(static = 0.5, kinetic = 0.3, transition [m/s] = 0.1, stiffness [1/m] = 100, damping [s/m] = 0.1);
        start { root.angle [deg] = 3; root.rate [rad/s] = -1; wand.bending_z[0] [mm] = 10; wand.bending_y[0].rate [m/s] = 0.3;
                wand.torsion[0] [rad] = 0.1; wand.torsion[0].rate [rad/s] = 2;
                ball.center.x [m] = 0.5; ball.center.y [m] = 0.02; ball.center.z [m] = 0.15; ball.rate.z [rad/s] = 4; }
        options { emit = (tangent); }
        output x [m/s] = scrapes.sliding.x;
        output y [m/s] = carries.sliding.y;
        output gone [W] = power(f_scrapes) + power(f_carries);
    }
}

linkwright::mechanism! {
    /// A block of a file that lies on one of its nodes.
    #[allow(penetration)]
    pub spatial RubbingBlock {
        gravity [m/s^2] = (0.3, -0.2, -9.81);
        flexible plate(file = "data/block.flex") { point a = node(100); point b = node(103); damping_ratio = 0.05;
                                                   surface foot: sphere(plate.b, radius [mm] = 100); }
        surface floor: plane(ground(0, 0, -0.02) [m], axis = (0, 0.1, 1));
        joint base: spherical(ground(0, 0, 0) [m], plate.a);
        contact scrapes: between(plate.foot, floor) = kelvin_voigt(stiffness [N/m] = 300, damping [N*s/m] = 3);
        friction f_scrapes: on(scrapes) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        start { plate.rate.z [rad/s] = 1; plate.mode[2] [mm] = 10; plate.mode[1].rate [mm/s] = 50; }
        options { emit = (tangent); }
        output y [m/s] = scrapes.sliding.y;
        output gone [W] = power(f_scrapes);
    }
}
