//! Spatial four-bars of the Modelica standard library: with a massive rod (`Fourbar1`) and with a massless one (`Fourbar2`).
//!
//! Source: Modelica.Mechanics.MultiBody.Examples.Loops.Fourbar1 and Fourbar2 (modelica/ModelicaStandardLibrary @033f87e8
//! and @1dd53117). Data: crank on a revolute about x at the origin, r = (0, 0.5, 0.1) m; slider along x, its pin 0.2 m above
//! in y, at x = 1 m; rod from the pin, r = (−1, 0.3, 0.1) m, with a universal joint (y, then z) at the slider and a spherical
//! joint at the crank; all solid cylinders of 0.05 m diameter and 7700 kg/m³ about r: 7.709164, 3.023783 and, in Fourbar1,
//! 15.856851 kg; g = 9.80665 m/s² along −y; crank at 300°/s; 5 s. The massless rod holds a distance and nothing else.
//! Expected at 5 s: crank at 40.24202506499 rad with the massless rod, at 40.329165462177 rad with the massive one.

macro_rules! spatial_four_bar {
    ($(#[$documentation:meta])* $name:ident { $($rod:tt)* } { $($guess:tt)* }) => {
        linkwright::mechanism! {
            $(#[$documentation])*
            pub spatial $name {
                const DENSITY [kg/m^3] = 7700;
                const RADIUS [m] = 0.025;
                const CRANK [m] = sqrt(0.26);
                const CRANK_MASS [kg] = DENSITY*pi*RADIUS^2*CRANK;
                const CRANK_ACROSS [kg*m^2] = CRANK_MASS*(3*RADIUS^2 + CRANK^2)/12;

                gravity [m/s^2] = (0, -9.80665, 0);
                // The tensor's third axis is the cylinder's.
                body crank { mass [kg] = CRANK_MASS; center [m] = (0, 0.25, 0.05); point tip [m] = (0, 0.5, 0.1);
                             marker along [m] = (0, 0.25, 0.05), axis = (0, 0.5, 0.1);
                             inertia [kg*m^2] = (CRANK_ACROSS, CRANK_ACROSS, CRANK_MASS*RADIUS^2/2);
                             inertia_axes = along; }
                // Its x, the cylinder's axis, stands along the world's y: `foot` and `pin` have the world's axes.
                cylinder slider { density [kg/m^3] = DENSITY; length [m] = 0.2; radius [m] = RADIUS;
                                  marker foot [m] = (-0.1, 0, 0), about_z [deg] = -90;
                                  marker pin [m] = (0.1, 0, 0), about_z [deg] = -90; }

                joint bearing: revolute(ground(0, 0, 0) [m], crank.origin, axis = (1, 0, 0));
                joint rail:    prismatic(ground(1.2, 0, 0) [m], slider.foot, axis = (1, 0, 0));
                $($rod)*

                start  { bearing.angle [rad] = 0; bearing.rate [rad/s] = 5.235987755982989;
                         rail.travel [m] ~ -0.2; $($guess)* }
                expect { degrees_of_freedom = 1; }
                output crank_angle [rad] = bearing.angle;
                output crank_rate [rad/s] = bearing.rate;
                output stroke [m] = rail.travel;
                output speed [m/s] = rail.speed;
            }
        }
    };
}

spatial_four_bar! {
    /// Modelica's `Loops.Fourbar1`: spatial four-bar with a massive rod.
    ///
    /// The crank stands at 40.329165462177 rad after 5 s.
    Fourbar1
    {
        const ROD [m] = sqrt(1.1);
        const ROD_MASS [kg] = DENSITY*pi*RADIUS^2*ROD;
        const ROD_ACROSS [kg*m^2] = ROD_MASS*(3*RADIUS^2 + ROD^2)/12;
        body rod { mass [kg] = ROD_MASS; center [m] = (-0.5, 0.15, 0.05); point tip [m] = (-1, 0.3, 0.1);
                   marker along [m] = (-0.5, 0.15, 0.05), axis = (-1, 0.3, 0.1);
                   inertia [kg*m^2] = (ROD_ACROSS, ROD_ACROSS, ROD_MASS*RADIUS^2/2); inertia_axes = along; }
        joint cross: universal(slider.pin, rod.origin, axis = (0, 1, 0), second_axis = (0, 0, 1));
        joint ball:  spherical(crank.tip, rod.tip);
    }
    { cross.angle_1 [rad] ~ 0; cross.angle_2 [rad] ~ 0; }
}

spatial_four_bar! {
    /// Modelica's `Loops.Fourbar2`: spatial four-bar with a massless rod.
    ///
    /// The crank stands at 40.24202506499 rad after 5 s.
    Fourbar2
    {
        joint rod: distance(slider.pin, crank.tip, length = sqrt(1.1) [m]);
    }
    {}
}
