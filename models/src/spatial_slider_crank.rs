//! Spatial slider-crank of Haug, in the four readings under which it has been solved.
//!
//! Source: Haug, *Computer-Aided Kinematics and Dynamics of Mechanical Systems* (1989); IFToMM library of computational
//! benchmark problems, spatial rigid slider-crank mechanism. Data: crank 0.08 m about x through (0, 0.1, 0.12), rod 0.3 m,
//! masses 0.12, 0.5 and 2 kg, crank 1e-4 kg m² about its axis, rod 0.004, 0.004 and 0.0004 kg m², slider 1e-4 kg m²;
//! spherical joint between crank and rod, universal joint between rod and slider, one arm of its cross along x in the
//! slider, the other perpendicular to x and to the rod; g = 9.81 m/s²; crank upright at 6 rad/s; 5 s. The problem leaves
//! open which axis of the rod carries the small moment and, in some solutions, where the crank's centre is: they are
//! different motions. Expected: the start of the library (slider at 0.2 m with 0.24 m/s, rod at (1.92, −0.96, 0.48) rad/s in
//! world axes) for all; the submitted run of González for `axial`, that of Masoudi for `third`.

macro_rules! spatial_slider_crank {
    ($(#[$documentation:meta])* $name:ident, center = $center:literal, inertia = $inertia:tt) => {
        linkwright::mechanism! {
            $(#[$documentation])*
            pub spatial $name {
                gravity [m/s^2] = (0, 0, -9.81);
                body crank  { mass [kg] = 0.12; inertia [kg*m^2] = (1e-4, 1e-4, 1e-5); center [m] = (0, 0, $center);
                              point pin [m] = (0, 0, 0.08); }
                // x along the rod from the slider to the crank, y along the arm of the cross.
                body rod    { mass [kg] = 0.5; inertia [kg*m^2] = $inertia; center [m] = (0.15, 0, 0);
                              point ball [m] = (0.3, 0, 0);
                              // The slider's axes as the rod sees them at the start.
                              marker cross [m] = (0, 0, 0), axis = (2/3, 1/sqrt(5), 4/(3*sqrt(5))),
                                                 reference = (-2/3, 0, sqrt(5)/3); }
                body slider { mass [kg] = 2; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); }

                joint bearing: revolute(ground(0, 0.1, 0.12) [m], crank.origin, axis = (1, 0, 0));
                joint ball:    spherical(crank.pin, rod.ball);
                joint cross:   universal(slider.center, rod.cross, axis = (1, 0, 0), second_axis = (0, -2, 1));
                joint rail:    prismatic(ground(0, 0, 0) [m], slider.center, axis = (1, 0, 0));

                start  { bearing.angle [rad] = 0; bearing.rate [rad/s] = 6;
                         rail.travel [m] ~ 0.2; cross.angle_1 [rad] ~ 0; cross.angle_2 [rad] ~ 0; }
                expect { degrees_of_freedom = 1; }
                output crank_angle [rad] = bearing.angle;
                output crank_rate [rad/s] = bearing.rate;
                output stroke [m] = rail.travel;
                output speed [m/s] = rail.speed;
            }
        }
    };
}

spatial_slider_crank! {
    /// Haug's spatial slider-crank, the rod's small moment of inertia about its own axis: the library's own statement.
    ///
    /// The run of González: slider at 0.211755 m after 1 s and at 0.240762 m after 5 s.
    SpatialSliderCrankAxial, center = 0.04, inertia = (4e-4, 4e-3, 4e-3)
}

spatial_slider_crank! {
    /// Haug's spatial slider-crank, the rod's small moment of inertia about the arm of the cross.
    SpatialSliderCrankArm, center = 0.04, inertia = (4e-3, 4e-4, 4e-3)
}

spatial_slider_crank! {
    /// Haug's spatial slider-crank, the rod's small moment of inertia across its axis and the arm of the cross.
    ///
    /// The run of Masoudi: slider at 0.261013 m and crank at 51.5068 rad after 5 s.
    SpatialSliderCrankThird, center = 0.04, inertia = (4e-3, 4e-3, 4e-4)
}

spatial_slider_crank! {
    /// Haug's spatial slider-crank with a balanced crank: its centre of mass is in its pivot.
    SpatialSliderCrankBalanced, center = 0, inertia = (4e-4, 4e-3, 4e-3)
}
