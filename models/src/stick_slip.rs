//! A block that a spring pulls over a table, with LuGre friction by the force that presses them together: it sticks and slips.
//!
//! Source: Canudas de Wit, Olsson, Åström, Lischinsky, *A new model for control of systems with friction*, IEEE Transactions on Automatic
//! Control 40 (1995) 419–425, figure 5: 1 kg, σ₀ = 10⁵ N/m, σ₁ = √10⁵ N s/m, σ₂ = 0.4 N s/m, F_C = 1 N, F_S = 1.5 N, v_S = 1 mm/s, a spring
//! of 2 N/m whose end moves with 0.1 m/s. Gravity is 1 m/s² here, so that the table presses with 1 N and coefficients are the paper's forces.
//! Equations, N = m g:
//!
//! ```text
//! m ẍ = k (v t − x) − N (σ₀ z + σ₁ ż) − σ₂ ẋ,   ż = ẋ − σ₀ |ẋ| z/g(ẋ),   g(ẋ) = μ_k + (μ_s − μ_k) e^{−(ẋ/v_S)²}
//! ```
//! Expected: the times at which it passes 0.05 m/s, of separate integrations whose three tolerances agree to 1e-11: upwards at
//! 7.5403974630155, 13.9031172840815 and 20.2658371051474 s, downwards at 10.0644592529518 s, so that a period takes 6.36271982106 s.

linkwright::mechanism! {
    /// A block that a spring pulls over a table, and that sticks and slips.
    #[allow(penetration)]
    pub planar StickSlip {
        param stiffness [N/m] = 2;
        param pulling [m/s] = 0.1;
        gravity [m/s^2] = (0, -1);
        particle block { mass [kg] = 1; surface sole: point(block.center); }
        surface table_top: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact stand: between(block.sole, table_top) = kelvin_voigt(stiffness [N/m] = 1000);
        friction grip: on(stand) = lugre(static = 1.5, kinetic = 1, transition [m/s] = 0.001, stiffness [1/m] = 1e5,
            damping [s/m] = 316.22776601683796, viscous [N*s/m] = 0.4);
        force spring: force(block.center) = (stiffness*(pulling*time - block.center.x), 0 [N]);
        start { block.center.x [m] = 0; block.center.y [m] = -0.001; }
        options { emit = (tangent); }
        output place [m] = block.center.x;
        output speed [m/s] = block.center.velocity.x;
        output friction [N] = grip.force;
    }
}
