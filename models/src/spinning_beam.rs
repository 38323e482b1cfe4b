//! A slender beam that is spun up about its start, with and without what bending draws in.
//!
//! Source: T. R. Kane, R. R. Ryan, A. K. Banerjee, Dynamics of a cantilever beam attached to a moving base, *J. Guidance, Control, and
//! Dynamics* 10(2), 1987, 139–151; P. Shi, J. McPhee, G. R. Heppler, A deformation field for Euler–Bernoulli beams with applications to
//! flexible multibody dynamics, *Multibody System Dynamics* 5, 2001, for the numbers of the manoeuvre.
//! Data: 10 m, 1.2 kg/m, EI = 14 000 N m², as an aluminium-like bar of 70 GPa; ω(t) = Ω (t/T − sin(2πt/T)/2π) up to Ω = 6 rad/s at
//! T = 15 s. Expected, with three shapes of the clamped beam: tip across the frame at 2.5, 5, … 15 s −0.1513001056, −0.4693646679,
//! −0.5610289551, −0.3636695300, −0.1125435368, 0.0015953831 m, at most −0.5759178 m at 6.770 s, by extrapolation of midpoint rules in the
//! frame with quadrature of |ṙ|².
//!
//! How far that is from others, in m: from a geometrically exact rod that keeps its length (−0.15127372, −0.46843550, −0.55898487, −0.36267244,
//! −0.11264361, 0.00127477) 2.7e-5, 9.3e-4, 2.04e-3, 1.0e-3, 1.0e-4, 3.2e-4: 0.4 % where the tip lags by 5.6 % of the length. From a T that is cut off at the
//! second order in the modes, K + ω² (∫xΓ − ∫NN) (−0.1512878413, −0.4688063170, −0.5595985739, −0.3627881003, −0.1125859110,
//! 0.0012223064), 1.4e-3 at most. Both are of the order of what the elastic energy leaves out, the square of the slope by the
//! curvature. Without stiffening the beam bends without bound: −1.4645 m at 7.5 s, −72 m at 10 s, because 6 rad/s is beyond its first
//! frequency, 3.80 rad/s.

linkwright::mechanism! {
    /// A beam of 10 m that a hub turns up to 6 rad/s in 15 s, stiffer as it turns faster.
    ///
    /// After 7.5 s its tip lags 0.5610289551 m behind.
    pub planar SpinUp {
        const T [s] = 15;
        const TURN [rad/s] = 360 [deg]/T;
        /// Rate of the hub at the end.
        param top [rad/s] = 6 in 0..10;
        beam blade { length [m] = 10; area [mm^2] = 400; second_moment [m^4] = 2e-7; young [GPa] = 70; mass [kg] = 12;
                     modes = (bending = 3); shapes = clamped; stiffening = on; }
        body hub { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint axle: revolute(ground(0, 0) [m], hub.center);
        joint root: fixed(hub.center, blade.start);
        drive motor: axle.angle = top*(time*time/2 + (cos(TURN*time) - 1)/(TURN*TURN))/T;
        options { emit = (tangent); }
        expect  { degrees_of_freedom = 4; }
        // The shapes have 2, −2, 2 at the end.
        output across [m] = 2*(blade.bending[0] - blade.bending[1] + blade.bending[2]);
        output reach [m] = distance(hub.center, blade.end);
        output torque [N*m] = motor.effort;
    }
}

linkwright::mechanism! {
    /// The same beam where bending draws nothing in: it bends without bound.
    #[allow(stiffening)]
    pub planar SpinUpWithoutStiffening {
        const T [s] = 15;
        const TURN [rad/s] = 360 [deg]/T;
        /// Rate of the hub at the end.
        param top [rad/s] = 6 in 0..10;
        beam blade { length [m] = 10; area [mm^2] = 400; second_moment [m^4] = 2e-7; young [GPa] = 70; mass [kg] = 12;
                     modes = (bending = 3); shapes = clamped; }
        body hub { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint axle: revolute(ground(0, 0) [m], hub.center);
        joint root: fixed(hub.center, blade.start);
        drive motor: axle.angle = top*(time*time/2 + (cos(TURN*time) - 1)/(TURN*TURN))/T;
        expect { degrees_of_freedom = 4; }
        // The shapes have 2, −2, 2 at the end.
        output across [m] = 2*(blade.bending[0] - blade.bending[1] + blade.bending[2]);
    }
}
