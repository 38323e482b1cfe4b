//! Simple pendulum, problem A01 of the IFToMM library of computational benchmark problems.
//!
//! Source: González, Dopico, Lugrís & Cuadrado, *A benchmarking system for MBS simulation software* (2006), and the
//! IFToMM library that grew out of it. Data: 1 kg on a massless arm of 1 m, g = 9.81 m/s², from (−1, 0) at rest.
//! Expected: ẍ of a pendulum, θ̈ = −(g/L) cos θ with θ from the horizontal; period 2.367841947576237449 s; at 10 s the
//! mass stands at (−0.275087462576116860, −0.961419205099125064) m (exact, Jacobi's elliptic functions).

linkwright::mechanism! {
    /// Simple pendulum: a point mass on a massless arm (IFToMM A01).
    ///
    /// 1 kg, 1 m, g = 9.81 m/s², from (−1, 0) at rest. Period 2.367841947576237449 s.
    pub planar SimplePendulum {
        gravity [m/s^2] = (0, -9.81);
        body arm { mass [kg] = 1; inertia [kg*m^2] = 0; center [m] = (1, 0); }
        joint pivot: revolute(ground(0, 0) [m], arm.origin);
        start  { pivot.angle [deg] = 180; pivot.rate [rad/s] = 0; }
        expect { degrees_of_freedom = 1; }
        output x [m] = arm.center.x;
        output y [m] = arm.center.y;
    }
}
