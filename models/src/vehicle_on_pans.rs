//! A tracked vehicle on six posts a side whose wheels leave their pans and climb the cylindrical stops of these.
//!
//! Source: the arrangement of a tracked vehicle on an N-post motion simulator, as of [`TrackedVehicle`](crate::tracked_vehicle::TrackedVehicle),
//! whose masses, lengths, tables and friction these are, but with free wheels and a free hull: wheels 2 and 5 stand on flat pans, the others between
//! cylindrical stops, which they climb once their arms turn by some 16 degrees. Data, ours: stops of radius 60 mm, half sunk, 250 mm before and behind
//! the wheel at rest, so that it touches after 45 mm; wheels press by F = 18 kN (d/10 mm)^1.5 (1 + 1 s/m ḋ) (Hunt and Crossley); the arms
//! end at 0 and 60 degrees under the horizontal by M = 10 kN m (φ/2°)^1.5 (1 + 1 s/rad φ̇). Pans are smooth, so that no wheel turns.
//! No numbers are published. Expected, of our own, which RK4 in steps of 0.25 ms and an adaptive method agree on: the state behind 8 s of 70 mm at 1.2 Hz
//! (hull at 0.0792308 m and 1.0321225 m, pitch 1.34904e-3 rad); the first arm swings by 25 degrees up and 13 down, some 20 in the source.

linkwright::mechanism! {
    /// Half of a tracked vehicle whose wheels may leave six shaken pans and climb their stops.
    pub planar VehicleOnPans {
        param hull_mass [kg] = 10000 in 1000..100000;
        param hull_inertia [kg*m^2] = 22500 in 1000..1000000;
        param friction [N*m] = 50 in 0..1000;
        /// Amplitude of all posts in phase.
        param shake [mm] = 70 in -100..100;
        /// Amplitude of the first post, with the last against it and the others on the line between them.
        param pitch [mm] = 0 in -100..100;
        param frequency [Hz] = 1.2 in 0..10;
        gravity [m/s^2] = (0, -9.81);

        table outer(angle [rad]) [N*m] =
            [(-0.05, 15000), (0, 14000), (0.2, 10800), (0.4, 8000), (0.55, 6100), (0.75, 3700), (1.05, 0)], pchip;
        table front(angle [rad]) [N*m] =
            [(-0.05, 13900), (0, 13000), (0.2, 10000), (0.4, 7500), (0.55, 5700), (0.75, 3500), (1.05, 0)], pchip;
        table rear(angle [rad]) [N*m] =
            [(-0.05, 13350), (0, 12500), (0.2, 9600), (0.4, 7200), (0.55, 5500), (0.75, 3300), (1.05, 0)], pchip;
        table loss(rate [rad/s]) [N*m] = [(-8, -14000), (-6, -9000), (-3, -3000), (-1, -1200), (-0.2, -500), (0, 0),
                                          (0.2, 500), (1, 1200), (3, 3000), (6, 9000), (8, 14000)], pchip;

        signal wave [1] = 0.5*(1 - cos(pi*clamp(time/1 [s], 0, 1)))*sin(2*pi*frequency*time);

        part Station(pivot: place, lift [m], bar: table, loss: table, friction [N*m]) {
            rod arm { mass [kg] = 50; length [m] = 0.4; }
            particle wheel { mass [kg] = 150; }
            surface rim: circle(wheel.center, radius [m] = 0.32);
            joint swing: revolute(pivot, arm.end);
            joint hub: revolute(arm.start, wheel.center);
            surface pan: half_plane(line(ground(0 [m], lift), ground(1 [m], lift)));
            #[allow(penetration)]
            contact stand: between(rim, pan) = hunt_crossley(force [N] = 18000, depth [mm] = 10, exponent = 1.5, dissipation [s/m] = 1);
            torque bar: torque(swing) = bar(swing.angle);
            torque damper: torque(swing) = -loss(swing.rate);
            friction dry: on(swing) = coulomb(torque = friction, speed [rad/s] = 0.05);
            limit stops: swing.angle in 0..60 [deg] = hunt_crossley(force [N*m] = 10000, depth [deg] = 2, exponent = 1.5, dissipation [s/rad] = 1);
            start { swing.angle [rad] ~ 0.56; }
            output angle [rad] = swing.angle;
            output load [N] = stand.force;
        }
        part Stops(wheel: place, from [m], lift [m]) {
            surface rim: circle(wheel, radius [m] = 0.32);
            surface before: circle(ground(from + 0.25 [m], lift), radius [m] = 0.06);
            surface behind: circle(ground(from - 0.25 [m], lift), radius [m] = 0.06);
            contact ahead: between(rim, before) = hunt_crossley(force [N] = 18000, depth [mm] = 10, exponent = 1.5, dissipation [s/m] = 1);
            contact back: between(rim, behind) = hunt_crossley(force [N] = 18000, depth [mm] = 10, exponent = 1.5, dissipation [s/m] = 1);
            output load [N] = ahead.force + back.force;
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
        repeat i in 0..6 { signal lift[i] [m] = (shake + pitch*(1 - 0.4*i))*wave; }
        part station[0]: Station(pivot = hull.pivot[0], lift = lift[0], bar = outer, loss = loss, friction = friction);
        repeat i in 1..3 { part station[i]: Station(pivot = hull.pivot[i], lift = lift[i], bar = front, loss = loss, friction = friction); }
        repeat i in 3..5 { part station[i]: Station(pivot = hull.pivot[i], lift = lift[i], bar = rear, loss = loss, friction = friction); }
        part station[5]: Station(pivot = hull.pivot[5], lift = lift[5], bar = outer, loss = loss, friction = friction);
        part stops[0]: Stops(wheel = station[0].wheel.center, from [m] = 2.001, lift = lift[0]);
        part stops[2]: Stops(wheel = station[2].wheel.center, from [m] = 0.401, lift = lift[2]);
        part stops[3]: Stops(wheel = station[3].wheel.center, from [m] = -0.399, lift = lift[3]);
        part stops[5]: Stops(wheel = station[5].wheel.center, from [m] = -1.999, lift = lift[5]);
        start { hull.center.x [m] = 0; hull.center.y [m] = 0.9736; hull.angle [rad] = 8.3e-4; }
        output heave [m] = hull.center.y;
        output pitch [rad] = hull.angle;
    }
}
