//! Profiles: cams on bodies and on the ground, with points, rollers and wheels, in both orders, with friction. They begin inside of each other
//! and move, so that what compares them near their start sees forces.

linkwright::mechanism! {
    /// A cam that turns against a roller on an arm and a point on a rail, and a wheel on an uneven ground.
    #[allow(penetration)]
    pub planar Profiled {
        param base [mm] = 600 in 400..800;
        gravity [m/s^2] = (0, -9.81);
        table lobe(angle [deg]) [mm] = [(0, 0), (40, 40), (80, 140), (120, 200), (160, 150), (200, 30), (240, -40), (280, -60), (320, -30), (360, 0)], periodic;
        table island(angle [rad]) [m] = [(-3.141592653589793, 0), (-2, 0.1), (-1, 0.05), (0, -0.1), (1, 0.15), (2, 0.1), (3.141592653589793, 0)], periodic;
        body cam { mass [kg] = 1.2; inertia [kg*m^2] = 3e-3; center [mm] = (30, -20); point hub [mm] = (10, 20);
                   surface flank: profile(cam.hub, radius = lobe, base = base, refine = 5); }
        rod arm { mass [kg] = 0.5; length [m] = 2; surface roller: circle(arm.end, radius [mm] = 150); }
        body tappet { mass [kg] = 0.4; inertia [kg*m^2] = 1e-3; surface edge: point(tappet.center); }
        disk wheel { mass [kg] = 0.8; radius [m] = 0.2; }
        surface bump: profile(ground(6, -5) [m], radius = island, base [m] = 2, refine = 5);
        joint shaft: revolute(ground(0, 0) [m], cam.hub);
        joint pivot: revolute(ground(-2, 1) [m], arm.start);
        joint rail: prismatic(ground(0.4, -0.8) [m], tappet.center, axis = (0.1, -1));
        contact rolls: between(arm.roller, cam.flank) = kelvin_voigt(stiffness [N/m] = 900, damping [N*s/m] = 4);
        contact lifts: between(cam.flank, tappet.edge) = hunt_crossley(force [N] = 30, depth [mm] = 100, dissipation [s/m] = 0.3);
        contact rides: between(wheel.surface, bump) = kelvin_voigt(stiffness [N/m] = 700, damping [N*s/m] = 3);
        friction f_rolls: on(rolls) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_lifts: on(lifts) = stribeck(static = 0.3, kinetic = 0.2, transition [m/s] = 0.2, speed [m/s] = 0.1);
        friction f_rides: on(rides) = coulomb(coefficient = 0.4, speed [m/s] = 0.1);
        start { shaft.angle [rad] = 0.4; shaft.rate [rad/s] = 3; pivot.angle [rad] = -0.2; pivot.rate [rad/s] = 1; rail.travel [mm] = -420;
                rail.speed [m/s] = 0.2; wheel.center.x [m] = 5.5; wheel.center.y [m] = -2.95; wheel.rate [rad/s] = -4;
                wheel.center.velocity.x [m/s] = 0.6; }
        options { emit = (penalty, projection, null_space, tangent); }
        output above [m] = rolls.gap;
        output at_x [m] = rides.point.x;
        output sliding [m/s] = lifts.sliding;
        output pressed [N] = lifts.force;
        output lost [W] = -power(f_rolls) - power(f_lifts) - power(f_rides);
    }
}
