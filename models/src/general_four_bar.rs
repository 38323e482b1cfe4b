//! Four-bar with nothing special about it: distinct lengths and masses, offset centres, a tilted ground link.
//!
//! Source: data of our own, a crank-rocker by Grashof's rule (0.4 + 1.1 < 1.0 + 0.9 m). Every number differs from every
//! other and none is 0 or 1, so that no simplification can hide a wrong term. Once with literals, which the compiler
//! folds, and once with every number a parameter: both describe the same motion, and the price of the parameters is
//! the difference of their operation counts. Expected: equal accelerations for the default parameters; constant energy.

linkwright::mechanism! {
    /// Four-bar with distinct lengths, masses and offset centres, all literals.
    ///
    /// A crank-rocker (0.4 + 1.1 < 1.0 + 0.9 m) under gravity, crank at 40° turning at 3 rad/s. The same motion as
    /// [`ParametricFourBar`] at its default parameters.
    pub planar GeneralFourBar {
        gravity [m/s^2] = (0.31, -9.73);
        body crank   { mass [kg] = 0.71; inertia [kg*m^2] = 0.013; center [m] = (0.17, 0.033);
                       point tip [m] = (0.4, 0); }
        body coupler { mass [kg] = 1.93; inertia [kg*m^2] = 0.187; center [m] = (0.43, -0.12);
                       point tip [m] = (1.0, 0); point tracer [m] = (0.62, 0.29); }
        body rocker  { mass [kg] = 1.37; inertia [kg*m^2] = 0.091; center [m] = (0.52, 0.071);
                       point tip [m] = (0.9, 0); }
        joint crank_pin:  revolute(ground(-0.15, 0.24) [m], crank.origin);
        joint rocker_pin: revolute(ground(0.93, 0.45) [m], rocker.origin);
        joint left:  revolute(crank.tip, coupler.origin);
        joint right: revolute(coupler.tip, rocker.tip);
        start  { crank_pin.angle [deg] = 40; crank_pin.rate [rad/s] = 3;
                 rocker_pin.angle [deg] ~ 100; coupler.angle [deg] ~ 40; }
        expect { degrees_of_freedom = 1; rotates = crank_pin; no_singularity; }
        output tracer_x [m] = coupler.tracer.x;
        output tracer_y [m] = coupler.tracer.y;
        output rocking [rad] = rocker_pin.angle;
    }
}

linkwright::mechanism! {
    /// Four-bar of which every number is a parameter; its defaults are the literals of [`GeneralFourBar`].
    pub planar ParametricFourBar {
        param gravity_x [m/s^2] = 0.31;
        param gravity_y [m/s^2] = -9.73;
        param crank_x [m] = -0.15;
        param crank_y [m] = 0.24;
        param rocker_x [m] = 0.93;
        param rocker_y [m] = 0.45;
        param crank_length [m] = 0.4 in 0.01..10;
        param crank_mass [kg] = 0.71;
        param crank_inertia [kg*m^2] = 0.013;
        param crank_center_x [m] = 0.17;
        param crank_center_y [m] = 0.033;
        param coupler_length [m] = 1.0 in 0.01..10;
        param coupler_mass [kg] = 1.93;
        param coupler_inertia [kg*m^2] = 0.187;
        param coupler_center_x [m] = 0.43;
        param coupler_center_y [m] = -0.12;
        param tracer_x [m] = 0.62;
        param tracer_y [m] = 0.29;
        param rocker_length [m] = 0.9 in 0.01..10;
        param rocker_mass [kg] = 1.37;
        param rocker_inertia [kg*m^2] = 0.091;
        param rocker_center_x [m] = 0.52;
        param rocker_center_y [m] = 0.071;
        param start_angle [deg] = 40;
        param start_rate [rad/s] = 3;

        gravity [m/s^2] = (gravity_x, gravity_y);
        body crank   { mass [kg] = crank_mass; inertia [kg*m^2] = crank_inertia;
                       center [m] = (crank_center_x, crank_center_y); point tip [m] = (crank_length, 0); }
        body coupler { mass [kg] = coupler_mass; inertia [kg*m^2] = coupler_inertia;
                       center [m] = (coupler_center_x, coupler_center_y);
                       point tip [m] = (coupler_length, 0); point tracer [m] = (tracer_x, tracer_y); }
        body rocker  { mass [kg] = rocker_mass; inertia [kg*m^2] = rocker_inertia;
                       center [m] = (rocker_center_x, rocker_center_y); point tip [m] = (rocker_length, 0); }
        joint crank_pin:  revolute(ground(crank_x, crank_y) [m], crank.origin);
        joint rocker_pin: revolute(ground(rocker_x, rocker_y) [m], rocker.origin);
        joint left:  revolute(crank.tip, coupler.origin);
        joint right: revolute(coupler.tip, rocker.tip);
        start  { crank_pin.angle [rad] = start_angle; crank_pin.rate [rad/s] = start_rate;
                 rocker_pin.angle [deg] ~ 100; coupler.angle [deg] ~ 40; }
        expect { degrees_of_freedom = 1; }
        output trace_x [m] = coupler.tracer.x;
        output trace_y [m] = coupler.tracer.y;
        output rocking [rad] = rocker_pin.angle;
    }
}
