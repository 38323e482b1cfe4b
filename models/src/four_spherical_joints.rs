//! Closed loop of three bodies and four spherical joints: ground – 2 – 3 – 4 – ground.
//!
//! Source: lecture "Day 2: Dynamics", example 1. It gives the rows of D, [I, −ã_i | −I, ã_j] per joint, and no data; the
//! data are ours, three bodies with full inertia tensors, so that no spin is without inertia. In absolute coordinates D is
//! 12 × 18 with full rank: six degrees of freedom, among them the spins of the bodies about the lines through their two
//! joints. Expected: those counts; constant energy; the places of B and C of a separate integration.

linkwright::mechanism! {
    /// Loop of three bodies on four spherical joints A, B, C, D: six degrees of freedom.
    ///
    /// Every body stands with its axes along the world's at the start. In absolute coordinates D is 12 × 18.
    pub spatial FourSphericalJoints {
        gravity [m/s^2] = (0, 0, -9.81);
        body crank   { mass [kg] = 2;
                       inertia [kg*m^2] = (0.062, 0.055, 0.013); products [kg*m^2] = (-0.004, -0.009, -0.016);
                       center [m] = (0.06, 0.09, 0.26); point tip [m] = (0.1, 0.2, 0.5); }
        body coupler { mass [kg] = 3;
                       inertia [kg*m^2] = (0.02, 0.17, 0.165); products [kg*m^2] = (-0.024, -0.016, -0.004);
                       center [m] = (0.42, 0.06, 0.07); point tip [m] = (0.8, 0.15, 0.1); }
        body rocker  { mass [kg] = 2.5;
                       inertia [kg*m^2] = (0.11, 0.085, 0.05); products [kg*m^2] = (-0.009, -0.012, -0.05);
                       center [m] = (0.04, 0.24, 0.29); point tip [m] = (0.1, 0.45, 0.6); }

        joint a: spherical(ground(0, 0, 0) [m], crank.origin);
        joint b: spherical(crank.tip, coupler.origin);
        joint c: spherical(coupler.tip, rocker.tip);
        joint d: spherical(ground(0.8, -0.1, 0) [m], rocker.origin);

        start   { crank.orientation = (1, 0, 0, 0);
                  coupler.orientation ~ (1, 0, 0, 0);
                  rocker.orientation ~ (1, 0, 0, 0);
                  crank.rate.x [rad/s] = 1.5; crank.rate.y [rad/s] = -0.4; crank.rate.z [rad/s] = 2;
                  coupler.rate.x [rad/s] = 0.7; rocker.rate.x [rad/s] = -1.2; rocker.rate.z [rad/s] = 0.9; }
        options { coordinates = absolute; }
        expect  { degrees_of_freedom = 6; }
        output b_x [m] = crank.tip.x;
        output b_y [m] = crank.tip.y;
        output b_z [m] = crank.tip.z;
        output c_x [m] = rocker.tip.x;
        output c_y [m] = rocker.tip.y;
        output c_z [m] = rocker.tip.z;
    }
}
