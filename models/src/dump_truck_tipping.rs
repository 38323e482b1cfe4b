//! The hopper of an articulated dump truck and the two hydraulic cylinders that tip it.
//!
//! Source: the machine is of the kind of the Hydrema 912D, which a lecture on the modelling of multibody systems names; the data are
//! ours, of the order of a laden truck of 20 t. Its cylinders push the hopper without a linkage of levers between. Data, with the hinge
//! at the rear as the origin, x ahead and y up: hopper of 1.8 t and 3500 kg m², centre of mass at (1.5, 0.25) m; load of 10 t, a block of
//! 3.4 × 0.9 m about (1.7, 0.5) m, which stays in the hopper; two cylinders side by side from the frame at (0.35, −0.65) m to the hopper
//! at (1.30, −0.10) m, 110 mm bore, 60 mm rod, closed 1040 mm, stroke 830 mm, 100 kN s/m; 210 bar, 5 bar in the return, valves of 40 l/min at
//! 35 bar; g = 9.81 m/s². Equations, with the tip angle θ, the ways a and b from the hinge to the pins and the angle β between them, and
//! S_x, S_y = Σ m x, Σ m y at θ = 0:
//!
//! ```text
//! l² = a² + b² − 2 a b cos(β + θ),   F = g (S_x cos θ − S_y sin θ)/(2 r) at rest,   r = dl/dθ = a b sin(β + θ)/l
//! J θ̈ = 2 F r − g (S_x cos θ − S_y sin θ)
//! ```
//! and the pressures of the library's `HydraulicCylinder`. Expected: lengths and thrusts up to 70°, of these closed forms; angle, its
//! rate and the pressures in a tip by the valves, of a separate integration by two methods that agree to 1e-10 (degrees, bar).

linkwright::mechanism! {
    /// The hopper of an articulated dump truck on its two tipping cylinders.
    ///
    /// `valve` from 0 to 1 tips, to −1 lowers; `angle` is 0 where the hopper would lie on the frame, which carries nothing here. It starts
    /// at rest, with pressures that hold its load. Beyond 74.5° hopper and load of 10 t would hang behind the hinge.
    pub planar DumpTruckTipping {
        param load [t] = 10 in 0.1..12;
        input valve [1];
        gravity [m/s^2] = (0, -9.81);

        const BORE [mm] = 110;
        const ROD [mm] = 60;
        const RING [bar] = 10;
        // From the pins on the frame to those on the hopper, at the start, and how far from the hinge the cylinders pass.
        const ACROSS [m] = 1.3 - 0.35;
        const UP [m] = -0.1 + 0.65;
        const LEVER [m] = (1.3 [m]*UP + 0.1 [m]*ACROSS)/sqrt(ACROSS^2 + UP^2);
        signal holds [N] = 9.81 [m/s^2]*(1.8 [t]*1.5 [m] + load*1.7 [m])/(2*LEVER);

        body hopper { mass [t] = 1.8; inertia [kg*m^2] = 3500; center [m] = (1.5, 0.25);
                      point eye [m] = (1.3, -0.1); point floor [m] = (1.7, 0.05); }
        box  heap   { mass = load; width [m] = 3.4; height [m] = 0.9; point foot [m] = (0, -0.45); }
        joint hinge: revolute(ground(0, 0) [m], hopper.origin);
        joint bed:   fixed(hopper.floor, heap.foot);
        repeat i in 0..2 {
            part ram[i]: HydraulicCylinder(
                base = ground(0.35, -0.65) [m], eye = hopper.eye, opening = valve,
                bore = BORE, rod = ROD, closed [mm] = 1040, stroke [mm] = 830, damping [kN*s/m] = 100,
                supply [bar] = 210, tank [bar] = 5, flow [dm^3/min] = 40, start_ring = RING,
                start = (holds + RING*pi/4*(BORE^2 - ROD^2))/(pi/4*BORE^2)
            );
        }

        start   { hinge.angle [deg] = 0; hinge.rate [rad/s] = 0; }
        options { emit = (tangent); }
        expect  { degrees_of_freedom = 1; }
        output angle [deg] = hinge.angle;
        output length [mm] = ram[0].length;
        output thrust [kN] = ram[0].thrust + ram[1].thrust;
        output piston [bar] = ram[0].pressure;
        output ring [bar] = ram[0].pressure_ring;
        output hinge_load [kN] = hinge.reaction.size;
    }
}
