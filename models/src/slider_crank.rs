//! Slider-crank with a gas force on the piston.
//!
//! Source: any textbook; the data are those of a small engine, ours. Data: crank 40 mm with its centre at the pivot
//! (balanced), rod 140 mm with its centre 40 mm from the crank pin, piston 0.4 kg on the x axis, no gravity. Expected:
//! x = r cos θ + √(l² − r² sin² θ) and its derivatives; the power of the two inputs equals the change of kinetic energy.

linkwright::mechanism! {
    /// Slider-crank: crank 40 mm, rod 140 mm, piston on the x axis.
    ///
    /// The piston stands at x = r cos θ + √(l² − r² sin² θ). Inputs are the torque on the crank and the force on the
    /// piston, against x.
    pub planar SliderCrank {
        const R [mm] = 40;
        const L [mm] = 140;
        /// Torque on the crank, counter-clockwise.
        input torque [N*m];
        /// Force on the piston, towards the crank.
        input gas [N];

        body crank  { mass [kg] = 1.2; inertia [kg*m^2] = 2.5e-3; point pin [m] = (R, 0); }
        body rod    { mass [kg] = 0.55; inertia [kg*m^2] = 1.6e-3; center [mm] = (40, 0); point eye [m] = (L, 0); }
        body piston { mass [kg] = 0.4; inertia [kg*m^2] = 2e-4; }

        joint main:   revolute(ground(0, 0) [m], crank.origin);
        joint big:    revolute(crank.pin, rod.origin);
        joint wrist:  revolute(rod.eye, piston.center);
        joint bore:   prismatic(ground(0, 0) [m], piston.center, axis = (1, 0));

        force drive: torque(main) = torque;
        force load:  force(piston.center, direction = (-1, 0)) = gas;

        start  { main.angle [deg] = 30; main.rate [rpm] = 1200; bore.travel [mm] ~ 170; }
        expect { degrees_of_freedom = 1; rotates = main; no_singularity; bore.travel in 100..180 [mm]; }
        output angle [rad] = main.angle;
        output stroke [m] = bore.travel;
        output speed [m/s] = bore.speed;
    }
}
