//! A tracked vehicle on six posts a side: one half of its hull in the plane, on trailing arms with torsion bars.
//!
//! Source: the arrangement of a tracked vehicle on an N-post motion simulator (hull, road arms, torsion bars, dampers, dry friction, dishpans
//! that actuators shake in phase, or front against rear). The curves of that source cannot be read: tables and masses are ours. Data: half of
//! the hull 10 t, 22 500 kg m²; six arms of 0.4 m and 50 kg (slender rods) with wheels of 150 kg and radius 0.32 m at their ends; pivots 0.45 m
//! below the hull's centre, every 0.8 m from 2.34 m before it; torsion bars and dampers as in the tables; dry friction 50 N m tanh(rate/(0.05 rad/s));
//! g = 9.81 m/s². The wheels' centres stay at their radius above pans that the posts move; the pans are smooth, so that no wheel turns, and
//! a wheel is a point. The hull is held in x, so that it heaves and pitches. Expected, without shaking: height 0.9836953511 m, pitch
//! 8.24987564e-4 rad, arms at 0.56850155 … 0.55873703 rad under the hull's horizontal, 19149.0349 … 19393.9782 N on the wheels; undamped modes at
//! 0.858814168 and 1.035839790 Hz; and after 9 s of 40 mm at 1 Hz the state (0.9607033656 m, 0.0013322589 rad, 0.2565040188 m/s,
//! −0.0080423473 rad/s), of a separate integration in (heave, pitch).

linkwright::mechanism! {
    /// Half of a tracked vehicle on six posts that shake it.
    ///
    /// Angles of the arms grow downwards from the hull's horizontal; the loads are what the pans bear. At the start it stands at rest on
    /// posts that begin to move.
    pub planar TrackedVehicle {
        param hull_mass [kg] = 10000 in 1000..100000;
        param hull_inertia [kg*m^2] = 22500 in 1000..1000000;
        param friction [N*m] = 50 in 0..1000;
        /// Amplitude of all posts in phase.
        param shake [mm] = 40 in -100..100;
        /// Amplitude of the first post, with the last against it and the others on the line between them.
        param pitch [mm] = 0 in -100..100;
        param frequency [Hz] = 1 in 0..10;
        gravity [m/s^2] = (0, -9.81);

        table outer(angle [rad]) [N*m] =
            [(-0.05, 15000), (0, 14000), (0.2, 10800), (0.4, 8000), (0.55, 6100), (0.75, 3700), (1.05, 0)], pchip;
        table front(angle [rad]) [N*m] =
            [(-0.05, 13900), (0, 13000), (0.2, 10000), (0.4, 7500), (0.55, 5700), (0.75, 3500), (1.05, 0)], pchip;
        table rear(angle [rad]) [N*m] =
            [(-0.05, 13350), (0, 12500), (0.2, 9600), (0.4, 7200), (0.55, 5500), (0.75, 3300), (1.05, 0)], pchip;
        table loss(rate [rad/s]) [N*m] = [(-8, -14000), (-6, -9000), (-3, -3000), (-1, -1200), (-0.2, -500), (0, 0),
                                          (0.2, 500), (1, 1200), (3, 3000), (6, 9000), (8, 14000)], pchip;

        // Of full size after a second.
        signal wave [1] = 0.5*(1 - cos(pi*clamp(time/1 [s], 0, 1)))*sin(2*pi*frequency*time);

        part Station(pivot: place, lift [m], bar: table, loss: table, friction [N*m]) {
            rod arm { mass [kg] = 50; length [m] = 0.4; }
            particle wheel { mass [kg] = 150; }
            joint swing: revolute(pivot, arm.end);
            joint hub: revolute(arm.start, wheel.center);
            drive post: wheel.center.y = 0.32 [m] + lift;
            torque bar: torque(swing) = bar(swing.angle);
            torque damper: torque(swing) = -loss(swing.rate) - friction*tanh(swing.rate/0.05 [rad/s]);
            start { swing.angle [rad] ~ 0.56; }
            output angle [rad] = swing.angle;
            output load [N] = post.effort;
        }

        body hull {
            mass [kg] = hull_mass; inertia [kg*m^2] = hull_inertia;
            point pivot[0] [m] = (2.34, -0.45);
            point pivot[1] [m] = (1.54, -0.45);
            point pivot[2] [m] = (0.74, -0.45);
            point pivot[3] [m] = (-0.06, -0.45);
            point pivot[4] [m] = (-0.86, -0.45);
            point pivot[5] [m] = (-1.66, -0.45);
        }
        line plumb = (ground(0, 0) [m], ground(0, 1) [m]);
        joint mast: point_on_line(plumb, hull.center);
        repeat i in 0..6 { signal lift[i] [m] = (shake + pitch*(1 - 0.4*i))*wave; }
        part station[0]: Station(pivot = hull.pivot[0], lift = lift[0], bar = outer, loss = loss, friction = friction);
        repeat i in 1..3 { part station[i]: Station(pivot = hull.pivot[i], lift = lift[i], bar = front, loss = loss, friction = friction); }
        repeat i in 3..5 { part station[i]: Station(pivot = hull.pivot[i], lift = lift[i], bar = rear, loss = loss, friction = friction); }
        part station[5]: Station(pivot = hull.pivot[5], lift = lift[5], bar = outer, loss = loss, friction = friction);

        start { mast.travel [m] = 0.9836953511; mast.speed [m/s] = 0; hull.angle [rad] = 8.24987564e-4; hull.rate [rad/s] = 0; }
        options { emit = (tangent); independent = (mast.travel, hull.angle); }
        // Six of them the posts hold.
        expect { degrees_of_freedom = 8; }
        output heave [m] = mast.travel;
        output pitch [rad] = hull.angle;
    }
}
