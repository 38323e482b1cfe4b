//! A spur gear pair with backlash as one oscillator, and as two turning wheels.
//!
//! Source: A. Kahraman, R. Singh, Non-linear dynamics of a spur gear pair, J. Sound Vib. 142 (1990): x″ + 2ζ x′ + k(t) f(x) = F_m + F_a Ω² cos Ωt
//! with f the gap function of half width 1. Data are ours: ζ = 0.05, F_m = 0.1, case A k = 1, F_a = 0.05, case B k = 1 + 0.3 cos Ωt, F_a = 0.
//! One wheel turns against one that is held, lengths are in micrometres, masses in kilograms and times in seconds, so that the equation is that
//! one. Expected: below the jump x swings about 1.1 with an rms of F_a Ω²/√((1 − Ω²)² + (2ζΩ)²)/√2; A at Ω = 1 on the upper branch: rms 0.133083,
//! largest 1.2693.

linkwright::mechanism! {
    /// One coordinate, stiffness by time, damping at all times.
    pub planar GearPairOscillator {
        const BASE [m] = 3e-3 [m]*50/2*cos(20 [deg]);
        param omega [rad/s] = 1 in 0.01..10;
        param shake [1] = 0.05 in 0..1;
        param swing [1] = 0 in 0..0.9;
        body wheel { mass [kg] = 1; inertia [kg*m^2] = BASE*BASE*1 [kg]; toothing rim: external(teeth = 50, module [mm] = 3); }
        body partner { mass [kg] = 1; inertia [kg*m^2] = 1; toothing rim: external(teeth = 50, module [mm] = 3); }
        joint axle: revolute(ground(0, 0), wheel.center);
        joint held: fixed(ground(150, 0) [mm], partner.center);
        mesh teeth: mesh(wheel.rim, partner.rim, stiffness = 1 [N/m]*(1 + swing*cos(omega*time)), damping = always(0.1 [N*s/m]), backlash [um] = 2);
        torque load: torque(axle) = BASE*1e-6 [N]*(0.1 + shake*(omega*1 [s/rad])^2*cos(omega*time));
        options { emit = (tangent); }
        output x [um] = teeth.deflection;
        output force [N] = teeth.force;
    }
}

linkwright::mechanism! {
    /// The same teeth between two wheels that turn, with the stiffness of their shape.
    pub planar GearPair {
        input drive [N*m];
        input brake [N*m];
        body pinion { mass [kg] = 3; inertia [kg*m^2] = 0.0075; toothing rim: external(teeth = 50, module [mm] = 3, face_width [mm] = 20, bore [mm] = 40); }
        body wheel  { mass [kg] = 3; inertia [kg*m^2] = 0.0075; toothing rim: external(teeth = 50, module [mm] = 3, face_width [mm] = 20, bore [mm] = 40); }
        joint front: revolute(ground(0, 0), pinion.center);
        joint back:  revolute(ground(150, 0) [mm], wheel.center);
        mesh teeth: mesh(pinion.rim, wheel.rim, stiffness = involute(young [GPa] = 210, entry = 0.05, harmonics = 3), damping_ratio = 0.05,
                         backlash [um] = 60, error = 2e-6 [m]*cos(pinion.angle));
        torque motor: torque(front) = drive;
        torque load:  torque(back) = brake;
        start { front.rate [rad/s] = 100; back.rate [rad/s] = -100; }
        output force [N] = teeth.force;
        output stiffness [N/m] = teeth.stiffness;
        output deflection [m] = teeth.deflection;
    }
}
