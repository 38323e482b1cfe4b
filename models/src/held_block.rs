//! A block on a slope that asperities hold until a force tears it off: the friction of the surfaces of a tracked vehicle.
//!
//! Source of the law: Wasfy, Wasfy and Mahfouz's tracked vehicle (equations 24 and 25 of the paper): an approximate Coulomb element beside a
//! spring to an anchor, together at most μ N. Data are this project's own: 2 kg, 20°, μ = 0.7, k = 2000/m, v_s = 0.02 m/s. The axes are those
//! of the slope, x down along it.
//! Equations, N = m g cos α:
//!
//! ```text
//! held:  N k z = m g sin α + P,   sliding:  m ẍ = m g sin α + P − μ N
//! ```
//! Expected, closed forms: it comes to rest at x = tan α/k, 181.987 µm, is held there without creeping, and is torn off by P > μ N − m g sin α
//! (6.19543 N), after which it slides with ẍ = g (sin α − μ cos α) + P/m, and is held again where it has come to rest.

linkwright::mechanism! {
    /// A block on a slope that asperities hold, pulled by a force.
    ///
    /// `place` is 0 at the start, where the anchor is.
    pub planar HeldBlock {
        const G [m/s^2] = 9.81;
        param slope [deg] = 20 in 0..45;
        input pull [N];
        gravity = (G*sin(slope), -G*cos(slope));
        particle block { mass [kg] = 2; surface sole: point(block.center); }
        surface hill: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        #[allow(penetration)]
        contact stand: between(block.sole, hill) = kelvin_voigt(stiffness [N/m] = 2e5, damping [N*s/m] = 500);
        friction grip: on(stand) = asperity(coefficient = 0.7, stiffness [1/m] = 2000, speed [m/s] = 0.02);
        force pulling: force(block.center) = (pull, 0 [N]);
        start { block.center.x [m] = 0; block.center.y = -2 [kg]*G*cos(slope)/2e5 [N/m]; }
        options { emit = (tangent); }
        output place [m] = block.center.x;
        output speed [m/s] = block.center.velocity.x;
        output friction [N] = grip.force;
    }
}
