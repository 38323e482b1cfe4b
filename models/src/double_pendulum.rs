//! Double pendulum, with the data of Project Chrono's unit test.
//!
//! Source: `utest_CH_double_pend` of Project Chrono. Data: two links of 1 kg, 1 m and 1 kg m² about the centre, which is
//! in the middle; g = 10 m/s²; horizontal and at rest. Expected: the energy is constant, and at 1 s the links stand at
//! −2.22720283996553 and −1.48968770110751 rad from the horizontal (recomputed with DOP853 at 3e-14).

linkwright::mechanism! {
    /// Double pendulum with the data of Project Chrono's unit test.
    ///
    /// Two links of 1 kg, 1 m, 1 kg m², g = 10 m/s², released from the horizontal. At 1 s their angles from the
    /// horizontal are −2.22720283996553 and −1.48968770110751 rad.
    pub planar DoublePendulum {
        gravity [m/s^2] = (0, -10);
        body upper { mass [kg] = 1; inertia [kg*m^2] = 1; center [m] = (0.5, 0); point tip [m] = (1, 0); }
        body lower { mass [kg] = 1; inertia [kg*m^2] = 1; center [m] = (0.5, 0); }
        joint shoulder: revolute(ground(0, 0) [m], upper.origin);
        joint elbow:    revolute(upper.tip, lower.origin);
        start  { upper.angle [rad] = 0; lower.angle [rad] = 0; upper.rate [rad/s] = 0; lower.rate [rad/s] = 0; }
        expect { degrees_of_freedom = 2; }
        output first [rad] = upper.angle;
        output second [rad] = lower.angle;
        output first_rate [rad/s] = upper.rate;
        output second_rate [rad/s] = lower.rate;
        output x [m] = lower.center.x;
        output y [m] = lower.center.y;
    }
}
