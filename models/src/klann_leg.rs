//! Klann leg, a walking linkage with five moving links.
//!
//! Source: J. Klann, US patent 6,260,862 (2001); its numbers are pure ratios, taken here in metres, the pins named as in
//! the patent. The patent has no masses: all rods are uniform, 2 kg/m; the coupler (pins 29, 27, 35) and the leg (35, 37,
//! 33) are slightly bent, rigid frames of the two rods that the patent draws. Expected: foot 33 and pin 37 at a crank
//! angle of 0° at (1.000325858229, 0.000381077697) and (1.000242980439, 1.732381075715) m.

linkwright::mechanism! {
    /// Klann leg: crank, bent coupler, two rockers, bent leg.
    ///
    /// The input is the torque on the crank. At a crank angle of 0° the foot stands at
    /// (1.000325858229, 0.000381077697) m.
    pub planar KlannLeg {
        const CRANK [m] = 0.268;
        const LOWER_ROCKER [m] = 0.3206;
        const UPPER_ROCKER [m] = 0.5177;
        // Coupler: crank pin 29, rocker pin 27, knee 35.
        const A [m] = 0.590;
        const B [m] = 0.5221;
        const AB [m] = 1.1051;
        const CX [m] = (A^2 + AB^2 - B^2)/(2*AB);
        const CY [m] = sqrt(A^2 - CX^2);
        const CCX [m] = (A*CX + B*(CX + AB))/(2*(A + B));
        // Leg: rocker pin 37, knee 35, foot 33.
        const C [m] = 0.8966;
        const CC [m] = 1.732;
        const LY [m] = -sqrt(C^2 - (CC/2)^2);
        const DENSITY [kg/m] = 2;
        /// Torque on the crank, counter-clockwise.
        input torque [N*m];

        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = DENSITY*CRANK; length [m] = CRANK; }
        rod lower_rocker { mass [kg] = DENSITY*LOWER_ROCKER; length [m] = LOWER_ROCKER; }
        rod upper_rocker { mass [kg] = DENSITY*UPPER_ROCKER; length [m] = UPPER_ROCKER; }
        body coupler {
            mass [kg] = DENSITY*(A + B);
            center [m] = (CCX, CY/2);
            inertia [kg*m^2] = DENSITY*(A*(A^2/12 + (CX/2 - CCX)^2) + B*(B^2/12 + ((CX + AB)/2 - CCX)^2));
            point pin_27 [m] = (CX, CY);
            point pin_35 [m] = (AB, 0);
        }
        body leg {
            mass [kg] = 2*DENSITY*C;
            center [m] = (CC/2, LY/2);
            inertia [kg*m^2] = 2*DENSITY*C*(C^2/12 + (CC/4)^2);
            point pin_35 [m] = (CC/2, LY);
            point pin_33 [m] = (CC, 0);
        }

        joint pin_15: revolute(ground(1.599, 0.750) [m], crank.start);
        joint pin_11: revolute(ground(1.009, 0.574) [m], lower_rocker.start);
        joint pin_9:  revolute(ground(1.366, 1.366) [m], upper_rocker.start);
        joint pin_29: revolute(crank.end, coupler.origin);
        joint pin_27: revolute(coupler.pin_27, lower_rocker.end);
        joint pin_35: revolute(coupler.pin_35, leg.pin_35);
        joint pin_37: revolute(leg.origin, upper_rocker.end);

        force drive: torque(pin_15) = torque;

        start  { pin_15.angle [deg] = 0; pin_15.rate [rad/s] = 2; pin_11.angle [deg] ~ 33; pin_9.angle [deg] ~ 135;
                 coupler.angle [deg] ~ 174; leg.angle [deg] ~ -90; }
        expect { degrees_of_freedom = 1; rotates = pin_15; no_singularity; }
        output foot_x [m] = leg.pin_33.x;
        output foot_y [m] = leg.pin_33.y;
        output hip_x [m] = leg.origin.x;
        output hip_y [m] = leg.origin.y;
    }
}
