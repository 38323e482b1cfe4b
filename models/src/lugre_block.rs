//! A block with LuGre friction: before it slides it gives way like a spring with hysteresis, and pulled slowly it sticks and slips.
//!
//! Source: Canudas de Wit, Olsson, Åström, Lischinsky, *A new model for control of systems with friction*, IEEE Transactions on Automatic
//! Control 40 (1995) 419–425. Data: 1 kg, σ₀ = 10⁵ N/m, σ₁ = √10⁵ N s/m, σ₂ = 0.4 N s/m, F_C = 1 N, F_S = 1.5 N, v_S = 1 mm/s.
//! Equations:
//!
//! ```text
//! ż = v − σ₀ |v| z/g(v),   g(v) = F_C + (F_S − F_C) exp(−(v/v_S)²),   F = σ₀ z + σ₁ ż + σ₂ v
//! ```
//! Expected: the place while a force grows to 1.425 N, reverses and goes (the paper's figure 2), and the stick–slip of a block that a spring
//! of 2 N/m pulls at 0.1 m/s (figure 5), of separate integrations whose three tolerances agree to 1e-11.

linkwright::mechanism! {
    /// A block with LuGre friction, pushed by a force.
    ///
    /// `place` is 0 at the start, where no bristle is bent.
    pub planar LugreBlock {
        param stiffness [N/m] = 1e5;
        param damping [N*s/m] = 316.22776601683796;
        param viscous [N*s/m] = 0.4;
        param sliding [N] = 1;
        param sticking [N] = 1.5;
        param stribeck [m/s] = 0.001;
        input push [N];

        /// Deflection of the bristles.
        state bristle [m] = 0, scale = 1e-6;
        rate  bristle = bending;

        signal speed [m/s] = rail.speed;
        signal steady [N] = sliding + (sticking - sliding)*exp(-(speed/stribeck)^2);
        signal bending [m/s] = speed - stiffness*abs(speed)*bristle/steady;

        body  block { mass [kg] = 1; inertia [kg*m^2] = 0; }
        joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
        force friction: force(rail) = -(stiffness*bristle + damping*bending + viscous*speed);
        force pushing: force(rail) = push;

        start { rail.travel [m] = 0; rail.speed [m/s] = 0; }
        options { emit = (tangent); }
        output place [m] = rail.travel;
        output speed [m/s] = speed;
        output friction [N] = stiffness*bristle + damping*bending + viscous*speed;
    }
}
