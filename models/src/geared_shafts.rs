//! Two shafts that drive each other with backlash: teeth that are apart touch, rebound and chatter.
//!
//! Source: lecture notes on multibody dynamics, torsional systems with backlash, (2.21), (3.1): a spring and a damper that act where the angle between both
//! shafts is beyond half of the gap, and never pull. Data are this project's own: inertias 0.01 and 0.05 kg m², 1000 N m/rad, 0.5 N m s/rad, half gap 0.01
//! rad, at rest in the middle of it; 2 N m to 0.1 s, −2 N m to 0.2 s, 0.5 N m from then on. Equations, u = θ₁ − θ₂:
//!
//! ```text
//! T = max(0, k (u − b) + c u̇) where u > b,  min(0, k (u + b) + c u̇) where u < −b,  else 0;   J₁ ω̇₁ = M − T,  J₂ ω̇₂ = T
//! ```
//! Expected, of a separate integration that stops at each change (two tolerances agree to 3e-10): first touch at 0.01 s; at 0.1 s angles
//! 0.176616418677195 and 0.164676716264561 rad, rates 3.158584548046504 and 3.368283090390699 rad/s; at 0.4 s 0.50920337776, 0.49815932445,
//! 1.39806863796, 1.72038627241, after 34 changes: 12 touches, and of 11 of them the end of the force and the end of the touch.

linkwright::mechanism! {
    /// A motor drives a machine through teeth with backlash.
    ///
    /// Gates are held, so that touches and partings are found to rounding.
    pub planar GearedShafts {
        param half_gap [rad] = 0.01 in 0.0001..0.1;
        param stiffness [N*m] = 1000 in 0..1000000;
        param damping [N*m*s] = 0.5 in 0..1000;
        input drive [N*m];
        body motor   { mass [kg] = 1; inertia [kg*m^2] = 0.01; }
        body machine { mass [kg] = 1; inertia [kg*m^2] = 0.05; }
        joint fast: revolute(ground(0, 0) [m], motor.center);
        joint slow: revolute(ground(0.2, 0) [m], machine.center);
        contact ahead:  gap(half_gap - (fast.angle - slow.angle)) = kelvin_voigt(stiffness = stiffness, damping = damping);
        contact behind: gap(half_gap + (fast.angle - slow.angle)) = kelvin_voigt(stiffness = stiffness, damping = damping);
        torque driving: torque(fast) = drive;
        start { fast.angle [rad] = 0; fast.rate [rad/s] = 0; slow.angle [rad] = 0; slow.rate [rad/s] = 0; }
        options { contact = held; }
        output motor_angle [rad] = fast.angle;
        output machine_angle [rad] = slow.angle;
        output motor_rate [rad/s] = fast.rate;
        output machine_rate [rad/s] = slow.rate;
        output torque [N*m] = ahead.force - behind.force;
    }
}
