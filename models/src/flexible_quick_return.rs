//! Quick-return mechanism with a slender coupler that bends.
//!
//! Source: the conference paper on the flexible quick return, Tables 1 to 4 and equations (1)–(26); rigid parts, forces and torques as in
//! `quick_return.rs`. Data: the coupler is a round bar of steel of 7 mm, E = 207 GPa, in free–free modes at its centroid (2)–(7), straight
//! and at rest in itself at the start; 7801 kg/m³ gives every printed digit of Table 3 (262.037, 722.314, 1416.024 Hz in bending, 7358.885,
//! 14717.769, 22076.654 Hz along). At 20 rad/s the source takes three bending modes and no axial one, under torque (26) of the rigid
//! mechanism. Expected there, by minimal coordinates and DOP853, confirmed in absolute coordinates with quadrature to 6e-11 m: after
//! 0.2π s the coupler's frame at (0.138626186, 0.132276633) m with modes of (5.72007, −3.20750, 0.208851) µm.

linkwright::mechanism! {
    /// Quick-return mechanism whose coupler bends, three modes.
    ///
    /// Inputs are the torque on the crank and the cutting force on the slider along +x, as of the rigid
    /// [`QuickReturn`](crate::quick_return::QuickReturn).
    pub planar FlexibleQuickReturn {
        const GUIDE [m] = 0.4;
        /// Moment of inertia of crank and flywheel about the crank's centre.
        param flywheel [kg*m^2] = 1.26069 in 1e-3..100;
        /// Torque on the crank, counter-clockwise.
        input drive [N*m];
        /// Force on the slider, along +x: against the forward stroke.
        input cutting [N];

        body crank   { mass [kg] = 0.368; inertia [kg*m^2] = flywheel;
                       point pivot [m] = (-0.075, 0); point tip [m] = (0.075, 0); }
        body guide   { mass [kg] = 0.551; inertia [kg*m^2] = 0.00735;
                       point pivot [m] = (-GUIDE/2, 0); point tip [m] = (GUIDE/2, 0);
                       line slot = (guide.pivot, guide.tip); }
        beam coupler { length [m] = 0.35; section = circle(diameter [mm] = 7); young [GPa] = 207; density [kg/m^3] = 7801;
                       modes = (bending = 3); }
        body slider  { mass [kg] = 2.206; inertia [kg*m^2] = 0.00184; }

        joint crank_pin: revolute(ground(0, 0) [m], crank.pivot);
        joint guide_pin: revolute(ground(0, -0.2) [m], guide.pivot);
        joint block:     point_on_line(guide.slot, crank.tip);
        joint knee:      revolute(guide.tip, coupler.end);
        joint wrist:     revolute(coupler.start, slider.center);
        joint rail:      prismatic(ground(0, 0.2) [m], slider.center, axis = (1, 0));

        force motor: torque(crank_pin) = drive;
        force cut:   force(slider.center, direction = (1, 0)) = cutting;

        start   { crank_pin.angle [rad] = 360 [deg] - asin(3/4); crank_pin.rate [rad/s] = 20;
                  guide_pin.angle [rad] ~ 0.7; coupler.angle [rad] ~ -0.4; rail.travel [m] ~ -0.02; }
        expect  { degrees_of_freedom = 4; }
        output rate [rad/s] = crank_pin.rate;
        output stroke [m] = slider.center.x;
        output coupler_x [m] = coupler.origin.x;
        output coupler_y [m] = coupler.origin.y;
        output coupler_angle [rad] = coupler.angle;
        output first [m] = coupler.bending[0];
        output second [m] = coupler.bending[1];
        output third [m] = coupler.bending[2];
    }
}
