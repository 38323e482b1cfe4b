//! Double-wishbone suspension: the left front wheel of the HMMWV, with its steering.
//!
//! Source: Project Chrono, src/chrono_models/vehicle/hmmwv/suspension/HMMWV_DoubleWishbone.cpp (projectchrono/chrono
//! @425dfa3e, BSD-3), front axle: hardpoints in inches from the middle between the lower arm's bearings, x forward, y left,
//! z up; masses, moments of inertia (the arms' about axes with z across the arm and x from its rear to its front bearing;
//! those across are more than any body's with so little in the plane, by 5 and 12 %, and are taken as they stand).
//! Its table of spring forces is 167062 x + 3.6085392e7 x³ to all its digits; free length 0.339 m. Its damper has 71.5 and
//! 128.25 lbf s/in in compression and rebound (12521.56 and 22460.01 N s/m). The chassis is the ground here; bump
//! stops, the axle's inertia and the tie rod's mass are left out. Expected: two degrees of freedom, of the wheel's travel and
//! its spin; position, inclination and steering of the wheel over its travel as a separate computation of the loop has them.

linkwright::mechanism! {
    /// Double-wishbone suspension with the hardpoints of the HMMWV's left front wheel.
    ///
    /// Inputs are the vertical force on the wheel and the torque on its spindle. `steering` moves the inner end of the tie rod
    /// to the left. Angles are zero in the design position, where the spring is compressed by 92.5 mm.
    pub spatial DoubleWishbone {
        const IN [m] = 0.0254;
        const STIFFNESS [N/m] = 167062;
        const STIFFENING [N/m^3] = 3.6085392e7;
        const FREE [m] = 0.339;
        const COMPRESSION [N*s/m] = 12521.56;
        const REBOUND [N*s/m] = 22460.01;
        /// Travel of the steering rack to the left.
        param steering [m] = 0 in -0.1..0.1;
        /// Force of the road on the wheel, upwards.
        input road [N];
        /// Torque on the spindle about its axis.
        input brake [N*m];

        gravity [m/s^2] = (0, 0, -9.81);
        // Every body's axes are the chassis' in the design position, and its origin is the chassis'.
        body upper {
            mass [kg] = 5.813; center [m] = (-4.155*IN, 23.176*IN, 8.575*IN);
            marker plane [m] = (-4.155*IN, 23.176*IN, 8.575*IN),
                axis = (-19.0644582, 9.5570152, 91.7921334), reference = (8.6732, -1.251, 1.9316);
            inertia [kg*m^2] = (0.03, 0.03, 0.06276); inertia_axes = plane;
            point front [m] = (-1.8864*IN, 17.5575*IN, 9.6308*IN);
            point ball [m] = (-2.088*IN, 28.17*IN, 8.484*IN);
        }
        body lower {
            mass [kg] = 23.965; center [m] = (0, 21.528*IN, -2.325*IN);
            marker plane [m] = (0, 21.528*IN, -2.325*IN), axis = (0, 81.747, 331.8225), reference = (1, 0, 0);
            inertia [kg*m^2] = (0.4, 0.4, 0.8938); inertia_axes = plane;
            point front [m] = (8.79*IN, 12.09*IN, 0);
            point ball [m] = (-1.4*IN, 30.965*IN, -4.65*IN);
            point strut [m] = (3.827*IN, 21.385*IN, -1.835*IN);
        }
        body upright {
            mass [kg] = 19.45; center [m] = (-1.59*IN, 29.5675*IN, -1.035*IN);
            inertia [kg*m^2] = (0.1656, 0.1934, 0.04367);
            point upper [m] = (-2.088*IN, 28.17*IN, 8.484*IN);
            point lower [m] = (-1.4*IN, 30.965*IN, -4.65*IN);
            point arm [m] = (-6.922*IN, 32.327*IN, -0.643*IN);
            point hub [m] = (-1.59*IN, 35.815*IN, -1.035*IN);
        }
        body spindle {
            mass [kg] = 14.705; center [m] = (-1.59*IN, 35.815*IN, -1.035*IN);
            inertia [kg*m^2] = (0.04117, 0.07352, 0.04117);
        }

        joint upper_bearing: revolute(ground(-1.8864*IN, 17.5575*IN, 9.6308*IN), upper.front,
                                      axis = (8.6732, -1.251, 1.9316));
        joint lower_bearing: revolute(ground(8.79*IN, 12.09*IN, 0), lower.front, axis = (1, 0, 0));
        joint upper_ball:    spherical(upper.ball, upright.upper);
        joint lower_ball:    spherical(lower.ball, upright.lower);
        joint tie_rod:       distance(ground(-9.855*IN, 17.655*IN + steering, 2.135*IN), upright.arm,
                                      length = IN*sqrt((9.855 - 6.922)^2 + (32.327 - 17.655)^2 + (2.135 + 0.643)^2));
        joint hub:           revolute(upright.hub, spindle.center, axis = (0, 1, 0));

        spring coil: spring(ground(4.095*IN, 20.07*IN, 7.775*IN), lower.strut, stiffness = STIFFNESS, length = FREE);
        // The cubic part of the spring, along the line of the linear one.
        force coil_cubic: force(lower.strut) = (
            STIFFENING*(distance(lower.strut, ground(4.095*IN, 20.07*IN, 7.775*IN)) - FREE)^3
                *(4.095*IN - lower.strut.x)/distance(lower.strut, ground(4.095*IN, 20.07*IN, 7.775*IN)),
            STIFFENING*(distance(lower.strut, ground(4.095*IN, 20.07*IN, 7.775*IN)) - FREE)^3
                *(20.07*IN - lower.strut.y)/distance(lower.strut, ground(4.095*IN, 20.07*IN, 7.775*IN)),
            STIFFENING*(distance(lower.strut, ground(4.095*IN, 20.07*IN, 7.775*IN)) - FREE)^3
                *(7.775*IN - lower.strut.z)/distance(lower.strut, ground(4.095*IN, 20.07*IN, 7.775*IN)));
        // The mean of both directions; what each has beyond it is not modelled.
        damper shock: damper(ground(4.095*IN, 19.598*IN, 12.722*IN), lower.strut,
                             damping = (COMPRESSION + REBOUND)/2);
        force road_force: force(spindle.center, direction = (0, 0, 1)) = road;
        torque brake_torque: torque(hub) = brake;

        start  { lower_bearing.angle [rad] = 0; lower_bearing.rate [rad/s] = 0;
                 hub.angle [rad] = 0; hub.rate [rad/s] = 0;
                 upper_bearing.angle [rad] ~ 0; upright.orientation ~ (1, 0, 0, 0); }
        options { inertia = accept; }
        expect  { degrees_of_freedom = 2; }
        output wheel_x [m] = spindle.center.x;
        output wheel_y [m] = spindle.center.y;
        output wheel_z [m] = spindle.center.z;
        output upper_angle [rad] = upper_bearing.angle;
        output lower_angle [rad] = lower_bearing.angle;
    }
}
