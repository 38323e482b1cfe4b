//! A hammer of two rods that strikes a rigid wall.
//!
//! Data: rods of 1 kg and 1 m, hinged to each other and to the ground, released at rest 60 and 90 degrees from the vertical; a wall half a metre
//! behind the hinge, without friction, with Newton's restitution of 0.5 (Pfeiffer and Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996).
//! Expected, of separate integrations at two tolerances with P = −(1 + e) ġ/(J M⁻¹ Jᵀ) between them: the first touch after 0.7075810264493 s with
//! 3.0488890361 N s, which take 4.0788729150 J, the second after 3.3079758364 s with 1.0121147620 N s, the third after 4.6598047399 s with
//! 2.9268948530 N s. With a restitution of one the first has 4.0651853815 N s, and the second comes after 2.4231220370 s.

linkwright::mechanism! {
    /// A double pendulum in front of a wall that does not yield.
    pub planar HammerAtRigidWall {
        param restitution [1] = 0.5;
        gravity [m/s^2] = (0, -9.81);
        rod upper { mass [kg] = 1; length [m] = 1; }
        rod lower { mass [kg] = 1; length [m] = 1; surface tip: point(lower.end); }
        joint shoulder: revolute(ground(0, 0) [m], upper.start);
        joint elbow: revolute(upper.end, lower.start);
        // Free on the left of the line's direction, which is upwards.
        surface wall: half_plane(line(ground(0.5, -3) [m], ground(0.5, 3) [m]));
        contact strike: between(lower.tip, wall) = rigid(restitution = restitution);
        start { upper.angle [deg] = -150; lower.angle [deg] = -180; shoulder.rate [rad/s] = 0; elbow.rate [rad/s] = 0; }
        expect { degrees_of_freedom = 2; }
        output upper [rad] = upper.angle;
        output lower [rad] = lower.angle;
        output upper_rate [rad/s] = upper.rate;
        output lower_rate [rad/s] = lower.rate;
        output gap [m] = strike.gap;
        output closing [m/s] = strike.closing;
    }
}
