//! Stewart platform: six legs, each on a universal joint, with a prismatic joint in it and a ball joint at the platform.
//!
//! Source: The MathWorks, SimMechanics case study of the Stewart platform (mech_stewart_control_setup.m, 2002–2003; Smith
//! & Wendlandt, *Creating a Stewart platform model using SimMechanics*, MATLAB Digest 10(5), 2002). Data: base points at
//! 3 m, ±2.5° about 0°, 120° and 240°; platform points at 1 m, ±10° about 60°, 180° and 300°; platform of 0.05 m × 1 m radius, 2 m
//! above the base; lower legs are tubes of 0.05 and 0.03 m radius, upper legs rods of 0.03 m, each three quarters of the leg's
//! 3.153800683985 m; steel of 76e3/9.81 kg/m³. There the legs are universal–cylindrical–universal; here
//! universal–prismatic–spherical, which leaves the same six degrees of freedom and moves alike but for the spin of the upper
//! legs. Expected: with a thrust of 4078.783656699347 N in each leg the platform stands still,
//! f = \[M g + 6 m₁ g (ℓ/2) c²/L + 6 m₂ g (1 − (ℓ/2) c²/L)\]/(6 s), s and c the sine and cosine of the legs' slope, ℓ = ¾ L;
//! with other thrusts the motion of a separate integration.
//!
//! A thrust pushes the upper leg out of the lower one.

linkwright::mechanism! {
    /// Stewart platform with six universal–prismatic–spherical legs; inputs are the thrusts in them.
    ///
    /// At 4078.783656699347 N in each leg the platform stands still.
    pub spatial StewartPlatform {
        const BASE [m] = 3;
        const TOP [m] = 1;
        const HEIGHT [m] = 2;
        const BASE_ANGLE [deg] = 2.5;
        const TOP_ANGLE [deg] = 50;
        const DENSITY [kg/m^3] = 76e3/9.81;
        const INNER [m] = 0.03;
        const OUTER [m] = 0.05;
        const THICKNESS [m] = 0.05;
        const LEG [m] = sqrt(BASE^2 + TOP^2 - 2*BASE*TOP*cos(TOP_ANGLE - BASE_ANGLE) + HEIGHT^2);
        const PART [m] = 3/4*LEG;
        const TUBE [kg] = DENSITY*pi*(OUTER^2 - INNER^2)*PART;
        const TUBE_ACROSS [kg*m^2] = TUBE*(3*(OUTER^2 + INNER^2) + PART^2)/12;
        const PLATE [kg] = DENSITY*pi*TOP^2*THICKNESS;
        const PLATE_ACROSS [kg*m^2] = PLATE*(3*TOP^2 + THICKNESS^2)/12;

        gravity [m/s^2] = (0, 0, -9.81);
        body platform {
            mass [kg] = PLATE; inertia [kg*m^2] = (PLATE_ACROSS, PLATE_ACROSS, PLATE*TOP^2/2);
            point ball[0] [m] = (TOP*cos(-TOP_ANGLE), TOP*sin(-TOP_ANGLE), 0);
            point ball[1] [m] = (TOP*cos(TOP_ANGLE), TOP*sin(TOP_ANGLE), 0);
            point ball[2] [m] = (TOP*cos(120 [deg] - TOP_ANGLE), TOP*sin(120 [deg] - TOP_ANGLE), 0);
            point ball[3] [m] = (TOP*cos(120 [deg] + TOP_ANGLE), TOP*sin(120 [deg] + TOP_ANGLE), 0);
            point ball[4] [m] = (TOP*cos(240 [deg] - TOP_ANGLE), TOP*sin(240 [deg] - TOP_ANGLE), 0);
            point ball[5] [m] = (TOP*cos(240 [deg] + TOP_ANGLE), TOP*sin(240 [deg] + TOP_ANGLE), 0);
        }

        repeat j in 0..3 {
            // Leg 2j + k, to the right (k = 0) or to the left of the middle of its pair.
            repeat k in 0..2 {
                /// Thrust in the leg, N.
                input thrust[2*j+k] [N];

                // x along the leg at the start, z across it and level.
                marker foot[2*j+k] [m] = (BASE*cos(120 [deg]*j + (2*k - 1)*BASE_ANGLE),
                                          BASE*sin(120 [deg]*j + (2*k - 1)*BASE_ANGLE), 0),
                    axis = (TOP*sin(120 [deg]*j + (2*k - 1)*TOP_ANGLE) - BASE*sin(120 [deg]*j + (2*k - 1)*BASE_ANGLE),
                            BASE*cos(120 [deg]*j + (2*k - 1)*BASE_ANGLE) - TOP*cos(120 [deg]*j + (2*k - 1)*TOP_ANGLE),
                            0),
                    reference =
                           (TOP*cos(120 [deg]*j + (2*k - 1)*TOP_ANGLE) - BASE*cos(120 [deg]*j + (2*k - 1)*BASE_ANGLE),
                            TOP*sin(120 [deg]*j + (2*k - 1)*TOP_ANGLE) - BASE*sin(120 [deg]*j + (2*k - 1)*BASE_ANGLE),
                            HEIGHT);
                body lower[2*j+k] {
                    mass [kg] = TUBE; center [m] = (PART/2, 0, 0);
                    inertia [kg*m^2] = (TUBE*(OUTER^2 + INNER^2)/2, TUBE_ACROSS, TUBE_ACROSS);
                }
                cylinder upper[2*j+k] { density [kg/m^3] = DENSITY; length [m] = PART; radius [m] = INNER; }

                joint cross[2*j+k]: universal(foot[2*j+k], lower[2*j+k].origin,
                                              axis = (0, 0, 1), second_axis = (0, 1, 0));
                joint slide[2*j+k]: prismatic(lower[2*j+k].origin, upper[2*j+k].end, axis = (1, 0, 0));
                joint ball[2*j+k]:  spherical(upper[2*j+k].end, platform.ball[2*j+k]);

                force push[2*j+k]: force(slide[2*j+k]) = thrust[2*j+k];

                start { cross[2*j+k].angle_1 [rad] ~ 0; cross[2*j+k].angle_2 [rad] ~ 0;
                        slide[2*j+k].travel [m] ~ LEG; }
                output leg[2*j+k] [m] = slide[2*j+k].travel;
            }
        }

        start  { platform.center.x [m] = 0; platform.center.y [m] = 0; platform.center.z [m] = 2;
                 platform.orientation = (1, 0, 0, 0);
                 platform.center.velocity.x [m/s] = 0; platform.center.velocity.y [m/s] = 0;
                 platform.center.velocity.z [m/s] = 0;
                 platform.rate.x [rad/s] = 0; platform.rate.y [rad/s] = 0; platform.rate.z [rad/s] = 0; }
        options { emit = (null_space); }
        expect { degrees_of_freedom = 6; }
        output x [m] = platform.center.x;
        output y [m] = platform.center.y;
        output z [m] = platform.center.z;
    }
}
