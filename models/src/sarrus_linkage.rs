//! Sarrus' linkage: a platform that two folding legs at a right angle guide straight up and down.
//!
//! Source: Sarrus (1853), the first linkage with an exact straight line; the data are ours. Data: two legs, each of two
//! uniform rods of 0.5 m and 0.4 kg on three parallel hinges, one leg's hinges along y and the other's along x, 0.3 m from the
//! line; platform of 1 kg; g = 9.81 m/s². Six revolutes and five bodies: Grübler's count is 0, the mechanism has one degree
//! of freedom and one redundant row. With φ the angle of the rods from the horizontal and L their length the platform is
//! at h = 2 L sin φ. Expected: released at φ = 60°, the motion of Lagrange's equation in φ; no turning of the platform.

linkwright::mechanism! {
    /// Sarrus' linkage: overconstrained, one degree of freedom, a platform in exact straight-line motion.
    ///
    /// The rods start 60° from the horizontal, at rest; the platform is at 2 L sin φ.
    pub spatial SarrusLinkage {
        const LENGTH [m] = 0.5;
        const REACH [m] = 0.3;
        gravity [m/s^2] = (0, 0, -9.81);
        rod lower_a { mass [kg] = 0.4; length [m] = LENGTH; }
        rod upper_a { mass [kg] = 0.4; length [m] = LENGTH; }
        rod lower_b { mass [kg] = 0.4; length [m] = LENGTH; }
        rod upper_b { mass [kg] = 0.4; length [m] = LENGTH; }
        box platform { mass [kg] = 1; size [m] = (0.6, 0.6, 0.02);
                       point a [m] = (REACH, 0, 0); marker b [m] = (0, REACH, 0), about_z [deg] = 90; }
        // The second leg is the first, turned by a right angle about z.
        marker base_b [m] = (0, REACH, 0), about_z [deg] = 90;

        // Angles grow upwards: about −y for the rods of the first leg.
        joint foot_a: revolute(ground(REACH, 0, 0), lower_a.start, axis = (0, -1, 0));
        joint knee_a: revolute(lower_a.end, upper_a.start, axis = (0, -1, 0));
        joint head_a: revolute(upper_a.end, platform.a, axis = (0, -1, 0));
        joint foot_b: revolute(base_b, lower_b.start, axis = (0, -1, 0));
        joint knee_b: revolute(lower_b.end, upper_b.start, axis = (0, -1, 0));
        joint head_b: revolute(upper_b.end, platform.b, axis = (0, -1, 0));

        start   { foot_a.angle [deg] = 60; foot_a.rate [rad/s] = 0; knee_a.angle [deg] ~ 60; head_a.angle [deg] ~ -120;
                  foot_b.angle [deg] ~ 60; knee_b.angle [deg] ~ 60; head_b.angle [deg] ~ -120; }
        options { redundant = drop; }
        expect  { degrees_of_freedom = 1; }
        output height [m] = platform.center.z;
        output sideways_x [m] = platform.center.x;
        output sideways_y [m] = platform.center.y;
        output angle [rad] = foot_a.angle;
    }
}
