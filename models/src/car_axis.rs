//! Car axis on a bumpy road, problem of the IVP test set (Bari/Geneva).
//!
//! Source: Test Set for Initial Value Problem Solvers, *Car axis problem* (index 3). Data: ε = 10⁻², M = 10, L = 1,
//! L₀ = ½, r = 0.1, ω = 10, g = 1; two particles of mass M ε²/2 a distance L apart, each on a spring of stiffness 1 and
//! free length L₀: the left one from the origin, the right one from the road, (x_b, y_b) = (√(L² − y_b²), r sin ω t); the
//! left spring is perpendicular to the line to the road, x_l x_b + y_l y_b = 0. Expected at 3 s: left particle
//! (0.0493455784275402809, 0.496989460230171154), right (1.04174252488542151681, 0.373911027265361257). The set's
//! multipliers follow f + Dᵀ λ with the length constraint not halved: its λ₁ is minus that of `upright`, twice its λ₂
//! minus that of `axle`.

linkwright::mechanism! {
    /// Car axis of the IVP test set: two particles, springs that push and pull, a moving road.
    ///
    /// At 3 s the left particle is at (0.0493455784275402809, 0.496989460230171154) m, the right one at
    /// (1.04174252488542151681, 0.373911027265361257) m.
    pub planar CarAxis {
        const LENGTH [m] = 1;
        const HEIGHT [m] = 0.5;
        const BUMP [m] = 0.1;
        const OMEGA [rad/s] = 10;
        const STIFFNESS [N/m] = 1;
        const EPSILON = 1e-2;

        gravity [m/s^2] = (0, -1);
        particle left  { mass [kg] = 10 [kg]*EPSILON^2/2; }
        particle right { mass [kg] = 10 [kg]*EPSILON^2/2; }

        joint axle: distance(left.center, right.center, length = LENGTH);
        constraint upright: left.center.x * sqrt(LENGTH^2 - (BUMP*sin(OMEGA*time))^2)
                            + left.center.y * BUMP*sin(OMEGA*time) = 0;

        spring left_spring: spring(ground(0, 0) [m], left.center, stiffness = STIFFNESS, length = HEIGHT);
        spring right_spring: spring(
            ground(sqrt(LENGTH^2 - (BUMP*sin(OMEGA*time))^2), BUMP*sin(OMEGA*time)),
            right.center, stiffness = STIFFNESS, length = HEIGHT);

        start  { left.center.y [m] = 0.5; right.center.y [m] = 0.5;
                 left.center.velocity.y [m/s] = 0; right.center.velocity.y [m/s] = 0;
                 left.center.x [m] ~ 0; right.center.x [m] ~ 1; }
        expect { degrees_of_freedom = 2; }
        output left_x [m] = left.center.x;
        output left_y [m] = left.center.y;
        output right_x [m] = right.center.x;
        output right_y [m] = right.center.y;
    }
}
