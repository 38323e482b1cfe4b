//! A motorcycle's rear wheel under braking: swing arm, chain and the slip of the tyre.
//!
//! Source: the minimal model of studies of rear-wheel stability under braking (swing arm, wheel, chain, longitudinal slip); the numbers are
//! ours. Data: arm 0.57 m and 0.35 kg m², hub 0.08 m below the pivot, 18 kg at the hub, wheel 0.55 kg m² and R = 0.315 m, load N₀ = 900 N, tyre
//! 1.8e5 N/m and 80 N s/m, spring 6500 N m/rad, damper 60 N m s, sprockets r_f = 35 and r_r = 100 mm, the front one on the pivot's axis, chain
//! 5.5e5 N/m and 10 N s/m, μ(κ) = 1.2 sin(1.5 atan 12κ); chassis and front sprocket run at constant speed. Equations, in the frame of the
//! chassis, e = e₀ + d the angle of the arm, e₀ = −asin(0.08/0.57), Δz = l (sin e − sin e₀), s the stretch of the chain:
//!
//! ```text
//! v = V + l sin e ḋ,   N = N₀ − k_t Δz − c_t Δż,   z_h = R − N₀/k_t + Δz,   κ = (Ω R − v)/v,   F = N μ(κ)
//! I_w Ω̇ = −F z_h − r_r T,   T = T₀ + k_c s + c_c ṡ,   ṡ = r_r (Ω − ḋ) − r_f (Ω_f − ḋ)
//! (m l² + I_a) d̈ = N l cos e + F l sin e + (r_r − r_f) T − m g l cos e − k_s d − c_s ḋ − (their value at rest)
//! ```
//! Expected: eigenvalues about steady running at V = 20 m/s, −7.8286281 ± 104.7001958i and −85.9501536 ± 44.1153891i 1/s for κ₀ = 0, +7.3466465 ±
//! 106.2464313i and −48.5002463 ± 103.3137043i 1/s for κ₀ = −0.06; flutter begins at κ₀ = −0.05312694 (−812.331 N) for 10 m/s, −0.04282616 (−705.679 N)
//! for 15, −0.03609785 (−621.492 N) for 20, −0.02291122 (−423.016 N) for 40 and −0.01750154 (−329.993 N) for 60 m/s. Its cause: the force of
//! the tyre falls as the hub rises, ∂F/∂z = −μ k_t, and acts on spin and arm with unlike arms, so that the stiffness is not symmetric.

linkwright::mechanism! {
    /// A motorcycle's rear wheel on its swing arm, driving towards −x, in the frame of the chassis.
    ///
    /// At the start it runs steadily with the slip `braking`; `force` is that on the wheel, forward.
    pub planar RearWheel {
        const ARM [m] = 0.57;
        const DROP [m] = 0.08;
        const RADIUS [m] = 0.315;
        const LOAD [N] = 900;
        const FRONT [mm] = 35;
        const REAR [mm] = 100;
        const G [m/s^2] = 9.81;
        param speed [m/s] = 20 in 1..100;
        /// Slip at rest, negative while braking.
        param braking [1] = 0 in -0.5..0.5;
        param tyre [N/m] = 1.8e5 in 1e3..1e7;
        param tyre_damping [N*s/m] = 80 in 0..1e5;
        param spring [N*m/rad] = 6500 in 0..1e6;
        param damper [N*m*s] = 60 in 0..1e4;
        param chain [N/m] = 5.5e5 in 1e3..1e8;
        param chain_damping [N*s/m] = 10 in 0..1e4;
        param mass [kg] = 18 in 1..100;
        gravity [m/s^2] = (0, -G);

        body arm   { mass [kg] = 0; inertia [kg*m^2] = 0.35; point hub [m] = (ARM, 0); }
        body wheel { mass [kg] = mass; inertia [kg*m^2] = 0.55; }
        joint swing: revolute(ground(0, 0) [m], arm.center);
        joint hub:   revolute(arm.hub, wheel.center);

        // Running steadily, e₀, Ω, F₀, T₀ and the moment of the spring.
        signal rest [rad] = -asin(DROP/ARM);
        signal spin [rad/s] = speed*(1 + braking)/RADIUS;
        signal pull [N] = LOAD*1.2*sin(1.5*atan(12*braking));
        signal taut [N] = -pull*(RADIUS - LOAD/tyre)/REAR;
        signal held [N*m] = (LOAD - mass*G)*ARM*cos(rest) + pull*ARM*sin(rest) + (REAR - FRONT)*taut;

        // Tyre.
        signal rise [m] = wheel.center.y + DROP;
        signal load [N] = LOAD - tyre*rise - tyre_damping*wheel.center.velocity.y;
        signal forward [m/s] = speed - wheel.center.velocity.x;
        signal slip [1] = (wheel.rate*RADIUS - forward)/forward;
        signal grip [N] = load*1.2*sin(1.5*atan(12*slip));
        force  road:    force(wheel.center) = (-grip, load);
        torque contact: torque(wheel) = -grip*(RADIUS - LOAD/tyre + rise);

        // Chain.
        signal stretch [m] = REAR*hub.angle - FRONT*(REAR/FRONT*spin*time - (swing.angle - rest));
        signal tension [N] = taut + chain*stretch + chain_damping*stretch.rate;
        force  run: along(stretch) = -tension;

        // Spring and damper.
        torque strut: torque(swing) = -spring*(swing.angle - rest) - damper*swing.rate - held;

        start   { swing.angle [rad] = rest; swing.rate [rad/s] = 0; hub.angle [rad] = 0; hub.rate [rad/s] = spin; }
        options { emit = (tangent); independent = (swing.angle, hub.angle); }
        expect  { degrees_of_freedom = 2; }
        output swing [rad] = swing.angle - rest;
        output stretch [m] = stretch;
        output slip [1] = slip;
        output load [N] = load;
        output force [N] = grip;
        output tension [N] = tension;
    }
}
