//! Stiff flyball governor, problem A05 of the IFToMM library.
//!
//! Source: IFToMM library of computational benchmark problems, A05. Data: shaft and two rods of 1 × 0.01 × 0.01 m, slider
//! of 0.1 × 0.1 × 0.1 m, 3000 kg/m³; 5 kg at the end of each rod; rods hinged about y at (±0.05, 0, 1) m of the shaft, 30° below
//! the horizontal; spring-dampers of 8e5 N/m, 4e4 N s/m and 0.5 m free length, which push and pull, from (±0.05, 0, s) of
//! the slider to the middles of the rods; s = 0.5 m, unstretched; all turning with the free shaft at 2π rad/s; g = 9.81 m/s²
//! along −z; 10 s. A rod and the point at its end are one body here. Expected: s(t) of a separate integration of the
//! symmetric motion, by way of Lagrange's equations.

linkwright::mechanism! {
    /// Stiff flyball governor (IFToMM A05): a slider on a free shaft, held by spring-dampers from two swinging rods.
    ///
    /// `height` is the slider's, s: 0.5 m at the start.
    pub spatial FlyballGovernor {
        const DENSITY [kg/m^3] = 3000;
        const LENGTH [m] = 1;
        const SIDE [m] = 0.01;
        const OFFSET [m] = 0.05;
        const BALL [kg] = 5;
        const ROD [kg] = DENSITY*LENGTH*SIDE^2;
        const MASS [kg] = ROD + BALL;
        // From the hinge to the centre of mass of rod and ball.
        const CENTER [m] = (ROD*LENGTH/2 + BALL*LENGTH)/MASS;
        const ALONG [kg*m^2] = ROD*2*SIDE^2/12;
        const ACROSS [kg*m^2] = ROD*(LENGTH^2 + SIDE^2)/12 + ROD*(CENTER - LENGTH/2)^2 + BALL*(LENGTH - CENTER)^2;

        gravity [m/s^2] = (0, 0, -9.81);
        box shaft  { density [kg/m^3] = DENSITY; size [m] = (SIDE, SIDE, LENGTH);
                     point foot [m] = (0, 0, -LENGTH/2);
                     // The arms hang on lugs that are not counted to its mass.
                     #[allow(outside)] point right [m] = (OFFSET, 0, LENGTH/2);
                     #[allow(outside)] point left [m] = (-OFFSET, 0, LENGTH/2); }
        body right { mass [kg] = MASS; inertia [kg*m^2] = (ALONG, ACROSS, ACROSS); center [m] = (CENTER, 0, 0);
                     point middle [m] = (LENGTH/2, 0, 0); }
        body left  { mass [kg] = MASS; inertia [kg*m^2] = (ALONG, ACROSS, ACROSS); center [m] = (-CENTER, 0, 0);
                     point middle [m] = (-LENGTH/2, 0, 0); }
        box slider { density [kg/m^3] = DENSITY; size [m] = (0.1, 0.1, 0.1);
                     point right [m] = (OFFSET, 0, 0); point left [m] = (-OFFSET, 0, 0); }

        joint bearing:     revolute(ground(0, 0, 0) [m], shaft.foot, axis = (0, 0, 1));
        // Both angles grow downwards.
        joint right_hinge: revolute(shaft.right, right.origin, axis = (0, 1, 0));
        joint left_hinge:  revolute(shaft.left, left.origin, axis = (0, -1, 0));
        joint rail:        prismatic(shaft.foot, slider.center, axis = (0, 0, 1));

        spring right_spring: spring(slider.right, right.middle,
                                    stiffness = 8e5 [N/m], length = 0.5 [m], damping = 4e4 [N*s/m]);
        spring left_spring:  spring(slider.left, left.middle,
                                    stiffness = 8e5 [N/m], length = 0.5 [m], damping = 4e4 [N*s/m]);

        start  { bearing.angle [rad] = 0; bearing.rate [rad/s] = 2*pi;
                 right_hinge.angle [deg] = 30; right_hinge.rate [rad/s] = 0;
                 left_hinge.angle [deg] = 30; left_hinge.rate [rad/s] = 0;
                 rail.travel [m] = 0.5; rail.speed [m/s] = 0; }
        expect { degrees_of_freedom = 4; }
        output height [m] = rail.travel;
        output swing [rad] = right_hinge.angle;
        output speed [rad/s] = bearing.rate;
    }
}
