//! A hammer of two rods that swings against a wall that yields.
//!
//! Data: rods of 1 kg and 1 m, hinged to each other and to the ground, released at rest 60 and 90 degrees from the vertical; a wall half a metre
//! behind the hinge, after Hunt and Crossley (J. Appl. Mech. 42 (1975) 440) with 5000 N at 5 mm and the restitution of 0.5 at 3 m/s, b v = 1.43275053327138 by
//! 1 − e b v = −W₀(−(1 + b v) exp(−(1 + b v))). Expected after 1 s, of a separate integration of the double pendulum with that force (SciPy's DOP853 at
//! 3e-14, which agrees with 1e-12 to 1e-13): the rods at −0.687388757419 and −2.326143940730 rad from the horizontal.

linkwright::mechanism! {
    /// A double pendulum in front of a wall.
    pub planar HammerAtWall {
        gravity [m/s^2] = (0, -9.81);
        rod upper { mass [kg] = 1; length [m] = 1; }
        rod lower { mass [kg] = 1; length [m] = 1; surface tip: point(lower.end); }
        joint shoulder: revolute(ground(0, 0) [m], upper.start);
        joint elbow: revolute(upper.end, lower.start);
        // Free on the left of the line's direction, which is upwards.
        surface wall: half_plane(line(ground(0.5, -3) [m], ground(0.5, 3) [m]));
        contact strike: between(lower.tip, wall) = hunt_crossley(force [N] = 5000, depth [mm] = 5, restitution = 0.5, speed [m/s] = 3);
        start { upper.angle [deg] = -150; lower.angle [deg] = -180; shoulder.rate [rad/s] = 0; elbow.rate [rad/s] = 0; }
        expect { degrees_of_freedom = 2; contact_time(strike) >= 1e-3 [s]; }
        output upper [rad] = upper.angle;
        output lower [rad] = lower.angle;
        output tip [m] = lower.end.x;
        output force [N] = strike.force;
        output lost [W] = power(strike);
    }
}
