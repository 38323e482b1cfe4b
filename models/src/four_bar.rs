//! Four-bar of unit rods, problem A02 of the IFToMM library with one window.
//!
//! Source: González, Dopico, Lugrís & Cuadrado, *A benchmarking system for MBS simulation software* (2006). Data: three
//! uniform rods of 1 m and 1 kg, ground pins 1 m apart, g = 9.81 m/s², cranks vertical, their upper pins moving at
//! +1 m/s. Expected: a parallelogram, so the coupler only translates and both cranks swing as one pendulum with
//! θ̈ = −(6/5)(g/L) cos θ; it passes the change point, all rods in one line, at every turn.

linkwright::mechanism! {
    /// Four-bar of unit rods (IFToMM A02 with one window).
    ///
    /// Three uniform rods of 1 m and 1 kg, g = 9.81 m/s², cranks upright and turning at −1 rad/s. The cranks move as a
    /// pendulum with θ̈ = −(6/5)(g/L) cos θ.
    pub planar FourBar {
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 1; length [m] = 1; }
        rod rocker  { mass [kg] = 1; length [m] = 1; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(1, 0) [m], rocker.start);
        joint left:  revolute(crank.end, coupler.start);
        joint right: revolute(coupler.end, rocker.end);
        start { crank_pin.angle [deg] = 90; crank_pin.rate [rad/s] = -1; rocker_pin.angle [deg] ~ 90; coupler.angle [rad] ~ 0; }
        expect { degrees_of_freedom = 1; operations <= 100; }
        output x [m] = crank.end.x;
        output angle [rad] = rocker_pin.angle;
    }
}
