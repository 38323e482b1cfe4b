//! Profiles: cams on bodies and on the ground, with points, rollers and wheels, in both orders, with friction. They begin inside of each other
//! and move, so that what compares them near their start sees forces.

linkwright::mechanism! {
    /// A cam that turns against a roller on an arm and a point on a rail, and a wheel on an uneven ground.
    #[allow(penetration)]
    pub planar Profiled {
        param base [mm] = 60 in 40..80;
        gravity [m/s^2] = (0, -9.81);
        table lobe(angle [deg]) [mm] = [(0, 0), (40, 4), (80, 14), (120, 20), (160, 15), (200, 3), (240, -4), (280, -6), (320, -3), (360, 0)], periodic;
        table island(angle [rad]) [m] = [(-3.141592653589793, 0), (-2, 0.03), (-1, 0.01), (0, -0.02), (1, 0.04), (2, 0.02), (3.141592653589793, 0)], periodic;
        body cam { mass [kg] = 1.2; inertia [kg*m^2] = 3e-3; center [mm] = (3, -2); point hub [mm] = (1, 2);
                   surface flank: profile(cam.hub, radius = lobe, base = base, refine = 5); }
        rod arm { mass [kg] = 0.5; length [m] = 0.2; surface roller: circle(arm.end, radius [mm] = 15); }
        body tappet { mass [kg] = 0.4; inertia [kg*m^2] = 1e-3; surface edge: point(tappet.center); }
        disk wheel { mass [kg] = 0.8; radius [m] = 0.05; }
        surface bump: profile(ground(0.6, -0.5) [m], radius = island, base [m] = 0.4, refine = 5);
        joint shaft: revolute(ground(0, 0) [m], cam.hub);
        joint pivot: revolute(ground(-0.2, 0.1) [m], arm.start);
        joint rail: prismatic(ground(0.04, -0.08) [m], tappet.center, axis = (0.1, -1));
        contact rolls: between(arm.roller, cam.flank) = kelvin_voigt(stiffness [N/m] = 900, damping [N*s/m] = 4);
        contact lifts: between(cam.flank, tappet.edge) = hunt_crossley(force [N] = 30, depth [mm] = 20, dissipation [s/m] = 0.3);
        contact rides: between(wheel.surface, bump) = kelvin_voigt(stiffness [N/m] = 700, damping [N*s/m] = 3);
        friction f_rolls: on(rolls) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_lifts: on(lifts) = stribeck(static = 0.3, kinetic = 0.2, transition [m/s] = 0.2, speed [m/s] = 0.1);
        friction f_rides: on(rides) = coulomb(coefficient = 0.4, speed [m/s] = 0.1);
        start { shaft.angle [rad] = 0.4; shaft.rate [rad/s] = 3; pivot.angle [rad] = -0.2; pivot.rate [rad/s] = 1; rail.travel [mm] = -42;
                rail.speed [m/s] = 0.2; wheel.center.x [m] = 0.55; wheel.center.y [m] = -0.08; wheel.rate [rad/s] = -4;
                wheel.center.velocity.x [m/s] = 0.6; }
        options { emit = (penalty, projection, null_space, tangent); }
        output above [m] = rolls.gap;
        output at_x [m] = rides.point.x;
        output sliding [m/s] = lifts.sliding;
        output pressed [N] = lifts.force;
        output lost [W] = -power(f_rolls) - power(f_lifts) - power(f_rides);
    }
}
