//! The steering of an articulated dump truck, seen from above: a front frame on a vertical pivot, turned by two hydraulic cylinders.
//!
//! Source: the machine is of the kind of the Hydrema 912D, which a lecture on the modelling of multibody systems names; the data are
//! ours, of the order of a laden truck of 20 t. Data: the rear frame stands, its pivot is the origin, x points ahead; front frame of
//! 6 t, centre of mass 0.9 m before the pivot, 8000 kg m² about it; cylinders from the rear frame at (−1.0, ±0.55) m to the front frame
//! at (0.30, ±0.42) m, 80 mm bore, 45 mm rod, closed 930 mm, stroke 650 mm, 20 kN s/m; 210 bar, 5 bar in the return, a valve of 20 l/min
//! at 35 bar; 20 kN m by which the tyres resist the turn, smooth below 0.02 rad/s. A steering angle φ to the left closes the left
//! cylinder and opens the right. Equations, with the ways a and b from the pivot to the pins and the angle β between them:
//!
//! ```text
//! l² = a² + b² − 2 a b cos(β ± φ),   dl/dφ = ± a b sin(β ± φ)/l,   + on the right, − on the left
//! 12860 kg m² φ̈ = F_left dl_left/dφ + F_right dl_right/dφ − 20 kN m φ̇/√(φ̇² + ε²)
//! ```
//! and the pressures of the library's `HydraulicCylinder`. Expected: lengths, lever arms and the torque of equal pressures up to 40° to
//! both sides, of these closed forms; angle and pressures in a turn by the valve, of a separate integration by two methods that agree to
//! 1e-10 (degrees, bar).

linkwright::mechanism! {
    /// The steering of an articulated dump truck that stands, seen from above.
    ///
    /// `valve` from 0 to 1 steers to the left, to −1 to the right; `angle` is positive to the left, −40° to 40° in the machine, which has
    /// stops there and the model none. A lever is the torque of a cylinder about the pivot for each newton that it pushes.
    pub planar DumpTruckSteering {
        param scrub [kN*m] = 20 in 0..100;
        input valve [1];

        /// One of the cylinders.
        part Ram(base: place, eye: place, opening [1]) {
            part oil: HydraulicCylinder(
                base = base, eye = eye, opening = opening,
                bore [mm] = 80, rod [mm] = 45, closed [mm] = 930, stroke [mm] = 650, damping [kN*s/m] = 20,
                supply [bar] = 210, tank [bar] = 5, flow [dm^3/min] = 20, start [bar] = 30, start_ring [bar] = 30
            );
            signal lever [m] = cross(eye - ground(0, 0) [m], eye - base)/oil.length;
        }

        body front { mass [t] = 6; inertia [kg*m^2] = 8000; center [m] = (0.9, 0);
                     point left [m] = (0.3, 0.42); point right [m] = (0.3, -0.42); }
        joint pivot: revolute(ground(0, 0) [m], front.origin);
        part left:  Ram(base = ground(-1, 0.55) [m], eye = front.left, opening = -valve);
        part right: Ram(base = ground(-1, -0.55) [m], eye = front.right, opening = valve);
        torque tyres: torque(pivot) = -scrub*pivot.rate/hypot(pivot.rate, 0.02 [rad/s]);

        start   { pivot.angle [deg] = 0; pivot.rate [rad/s] = 0; }
        options { emit = (tangent); }
        expect  { degrees_of_freedom = 1; }
        output angle [deg] = pivot.angle;
        output left_length [mm] = left.oil.length;
        output right_length [mm] = right.oil.length;
        output left_lever [mm] = left.lever;
        output right_lever [mm] = right.lever;
        output left_thrust [kN] = left.oil.thrust;
        output right_thrust [kN] = right.oil.thrust;
        output left_piston [bar] = left.oil.pressure;
        output left_ring [bar] = left.oil.pressure_ring;
        output right_piston [bar] = right.oil.pressure;
        output right_ring [bar] = right.oil.pressure_ring;
    }
}
