//! A knuckle-boom loader in the plane: two booms, a load at the tip and two hydraulic cylinders.
//!
//! Source: the machine is of the kind of the HMF 4-K5 loader, which a lecture on the modelling of multibody systems names; the data
//! are ours, of the order of that machine. Data: main boom of 3.2 m and 320 kg on a foot at the origin, knuckle boom of 3.0 m and
//! 210 kg, both with the centre of mass in the middle and the moment of inertia of a thin rod, 800 kg at the tip, g = 9.81 m/s²; one
//! cylinder from the ground at (0.25, −0.9) m to the main boom at (1.1, −0.12) m, one from the main boom at (1.9, 0.25) m to the
//! knuckle boom at (−0.35, 0.10) m, along each boom from its foot. The masses of the cylinders are counted to the booms. Hydraulics:
//! cylinders of 110 mm bore with rods of 70 and 60 mm, 240 bar, 5 bar in the return, valves of 30 l/min at 35 bar, 50 kN s/m.
//! Equations: with the angles a and b of the booms against the horizontal, the lengths l(a) and k(b − a) of the cylinders and
//! their thrusts F and G, which push,
//!
//! ```text
//! M₁₁ ä + K cos(a − b) b̈ + K sin(a − b) ḃ² + g m₁ cos a = F l′ − G k′
//! M₂₂ b̈ + K cos(a − b) ä − K sin(a − b) ȧ² + g m₂ cos b = G k′
//! M₁₁ = 320·3.2²/3 + 1010·3.2²,  M₂₂ = 210·3²/3 + 800·3²,  K = 3.2 m₂,  m₁ = 320·1.6 + 1010·3.2,  m₂ = 210·1.5 + 800·3
//! ```
//! and for each cylinder the pressures of the library's `HydraulicCylinder`. Expected, of a computation by these equations:
//!
//! | a, b, degrees | lengths, m | tip, m | thrusts at rest, N |
//! |---|---|---|---|
//! | 30, −20 | 1.5471019814, 1.1545725063 | 5.5903591545, 0.5739395700 | 85963.6303, −73152.1336 |
//! | 60, −40 | 1.8375714341, 1.4613045232 | 3.8981333294, 0.8429184631 | 87764.8038, −64072.9404 |
//! | 10, −10 | 1.2945816940, 1.0059656039 | 6.1058080687, 0.0347296355 | 79830.3211, −129275.5435 |
//!
//! angles, thrusts and power on the way from the first pose to the second in 5 s; and angles, pressures and the pump's work in a lift by
//! the valves, of a separate integration by two methods that agree to 1e-10 (degrees, bar, kJ).

/// What both loaders have: booms, joints and load.
macro_rules! loader {
    ($(#[$documentation:meta])* $name:ident { $($cylinders:tt)* }) => {
        linkwright::mechanism! {
            $(#[$documentation])*
            pub planar $name {
                param payload [kg] = 800 in 1..1000;
                gravity [m/s^2] = (0, -9.81);

                body main    { mass [kg] = 320; center [m] = (1.6, 0); inertia [kg*m^2] = 320*3.2^2/12;
                               point lift [m] = (1.1, -0.12); point fold [m] = (1.9, 0.25); point end [m] = (3.2, 0); }
                body knuckle { mass [kg] = 210; center [m] = (1.5, 0); inertia [kg*m^2] = 210*3^2/12;
                               point fold [m] = (-0.35, 0.1); point tip [m] = (3, 0); }
                particle load { mass [kg] = payload; }

                joint foot:  revolute(ground(0, 0) [m], main.origin);
                joint elbow: revolute(main.end, knuckle.origin);
                joint hook:  revolute(knuckle.tip, load.center);

                $($cylinders)*

                expect { degrees_of_freedom = 2; }
                output main_angle [deg] = main.angle;
                output knuckle_angle [deg] = knuckle.angle;
                output tip_x [m] = knuckle.tip.x;
                output tip_y [m] = knuckle.tip.y;
            }
        }
    };
}

loader! {
    /// A knuckle-boom loader whose cylinders are given their lengths: what they have to push, and the power they take.
    ///
    /// Both cylinders go from their first to their last length within `duration` and stay there; with the same length twice they hold a
    /// pose. A thrust is positive where the cylinder pushes. Angles are those of the booms against the horizontal.
    KnuckleBoomLoader {
        param lift_from [mm] = 1547.1019814 in 1250..1950;
        param lift_to [mm] = 1837.5714341 in 1250..1950;
        param fold_from [mm] = 1154.5725063 in 980..1600;
        param fold_to [mm] = 1461.3045232 in 980..1600;
        param duration [s] = 5 in 0.1..100;

        /// A cylinder without mass: its length, from the pin of the barrel to that of the rod, follows a law.
        part Ram(base: place, eye: place, length [m]) {
            body barrel { mass [kg] = 0; inertia [kg*m^2] = 0; }
            body rod    { mass [kg] = 0; inertia [kg*m^2] = 0; }
            joint base_pin: revolute(base, barrel.origin);
            joint slide:    prismatic(barrel.origin, rod.origin, axis = (1, 0));
            joint eye_pin:  revolute(rod.origin, eye);
            drive push: slide.travel = length;
        }

        // From 0 to 1, at rest and without acceleration at both ends.
        signal passed [1] = clamp(time/duration, 0, 1);
        signal way [1] = passed - sin(passed*2*pi*1 [rad])/(2*pi);
        part lift: Ram(base = ground(0.25, -0.9) [m], eye = main.lift, length = lift_from + (lift_to - lift_from)*way);
        part fold: Ram(base = main.fold, eye = knuckle.fold, length = fold_from + (fold_to - fold_from)*way);

        start { foot.angle [deg] ~ 30; knuckle.angle [deg] ~ -20; }
        output lift_thrust [kN] = lift.push.effort;
        output fold_thrust [kN] = fold.push.effort;
        output power [kW] = lift.push.power + fold.push.power;
    }
}

loader! {
    /// A knuckle-boom loader with its hydraulics: pressures are states, the openings of the valves are the inputs.
    ///
    /// An opening above 0 extends the cylinder, up to 1: `lift_valve` lifts the main boom, `fold_valve` folds the knuckle boom
    /// downwards. It starts at rest, with pressures that hold 800 kg. The cylinders have no stops at the ends of their strokes.
    HydraulicLoader {
        input lift_valve [1];
        input fold_valve [1];
        const SUPPLY [bar] = 240;
        const TANK [bar] = 5;
        const FLOW [dm^3/min] = 30;
        const DAMPING [kN*s/m] = 50;
        const BORE [mm] = 110;
        const LIFT_ROD [mm] = 70;
        const FOLD_ROD [mm] = 60;
        // Thrusts at rest, and what the other side of the piston has at the start.
        const LIFT_HOLDS [N] = 85963.63033788549;
        const FOLD_HOLDS [N] = -73152.13363360992;
        const LIFT_RING [bar] = 20;
        const FOLD_PISTON [bar] = 10;

        part lift: HydraulicCylinder(
            base = ground(0.25, -0.9) [m], eye = main.lift, opening = lift_valve,
            bore = BORE, rod = LIFT_ROD, closed [mm] = 1150, stroke [mm] = 800,
            supply = SUPPLY, flow = FLOW, tank = TANK, damping = DAMPING, start_ring = LIFT_RING,
            start = (LIFT_HOLDS + LIFT_RING*pi/4*(BORE^2 - LIFT_ROD^2))/(pi/4*BORE^2)
        );
        part fold: HydraulicCylinder(
            base = main.fold, eye = knuckle.fold, opening = fold_valve,
            bore = BORE, rod = FOLD_ROD, closed [mm] = 950, stroke [mm] = 650,
            supply = SUPPLY, flow = FLOW, tank = TANK, damping = DAMPING, start = FOLD_PISTON,
            start_ring = (FOLD_PISTON*pi/4*BORE^2 - FOLD_HOLDS)/(pi/4*(BORE^2 - FOLD_ROD^2))
        );

        /// What the pump has delivered.
        state pumped [kJ] = 0;
        rate  pumped = SUPPLY*(max(0, lift.into) + max(0, lift.into_ring) + max(0, fold.into) + max(0, fold.into_ring));
        /// What the cylinders have given to the booms.
        state work [kJ] = 0;
        rate  work = power(lift.push) + power(fold.push);

        start { foot.angle [deg] = 30; knuckle.angle [deg] = -20; foot.rate [rad/s] = 0; knuckle.rate [rad/s] = 0; }
        options { emit = (tangent); }
        output lift_thrust [kN] = lift.thrust;
        output fold_thrust [kN] = fold.thrust;
        output lift_piston [bar] = lift.pressure;
        output lift_ring [bar] = lift.pressure_ring;
        output fold_piston [bar] = fold.pressure;
        output fold_ring [bar] = fold.pressure_ring;
        output pumped [kJ] = pumped;
        output work [kJ] = work;
    }
}
