//! Delta robot with three arms and three parallelograms of bars.
//!
//! Source: RL5-1450-6kg of Autonox24; Alikoc, Sustr, Zitek, Rehorik, Burget & Lomakin, *Motion modelling and simulation
//! of a 5-axis industrial delta robot*, with testbedCIIRC/delta-robot-public @11046d53 (RL5_6kg_Inertia_Mass.m,
//! Basic_3DoF_Delta_Dynamic_Param.m). Data: axes of the motors 0.33 m, joints of the platform 0.125 m from the middle; arms of
//! 0.42 m, 3.47 kg with the centre at 0.17224 m and 0.226 kg at the elbow, together 0.208218 kg m² about the axis; six bars of
//! 1.055 m, 0.525 kg and (5.22934e-5, 0.043009, 0.0430094) kg m² about the middle; platform 2.916 kg. The width of the
//! parallelograms, 0.1 m, and the platform's moments of inertia are ours and have no influence: the platform does not
//! turn. Each bar is on a universal joint at the elbow and a ball joint at the platform, so that it cannot spin. g = 9.81 m/s²
//! along −z. Expected: three degrees of freedom; with the arms 30° below the horizontal the platform is 1.0985777543177184 m
//! below the axes, held there by −15.072845703509 N m on each arm; the motion of a separate integration.

linkwright::mechanism! {
    /// Delta robot RL5-1450: the platform translates in three directions; inputs are the torques on the arms.
    ///
    /// Arms turn downwards. At the start they are 30° below the horizontal, the platform 1.0986 m below the axes.
    pub spatial DeltaRobot {
        const BASE [m] = 0.33;
        const PLATFORM [m] = 0.125;
        const ARM [m] = 0.42;
        const BAR [m] = 1.055;
        const HALF [m] = 0.05;
        const PIPE [kg] = 3.47;
        const ELBOW [kg] = 0.226;
        const ARM_MASS [kg] = PIPE + ELBOW;
        const ARM_CENTER [m] = (PIPE*0.17224 [m] + ELBOW*ARM)/ARM_MASS;
        const ARM_ACROSS [kg*m^2] = 0.208218 [kg*m^2] - ARM_MASS*ARM_CENTER^2;

        gravity [m/s^2] = (0, 0, -9.81);
        body platform {
            mass [kg] = 2.916; inertia [kg*m^2] = (0.01, 0.01, 0.02);
            // Two of each parallelogram: `HALF` to the left and to the right of a ray at 0°, 120° and 240°.
            point ball[0] [m] = (PLATFORM, HALF, 0);
            point ball[1] [m] = (PLATFORM, -HALF, 0);
            point ball[2] [m] = (PLATFORM*cos(120 [deg]) - HALF*sin(120 [deg]),
                                 PLATFORM*sin(120 [deg]) + HALF*cos(120 [deg]), 0);
            point ball[3] [m] = (PLATFORM*cos(120 [deg]) + HALF*sin(120 [deg]),
                                 PLATFORM*sin(120 [deg]) - HALF*cos(120 [deg]), 0);
            point ball[4] [m] = (PLATFORM*cos(240 [deg]) - HALF*sin(240 [deg]),
                                 PLATFORM*sin(240 [deg]) + HALF*cos(240 [deg]), 0);
            point ball[5] [m] = (PLATFORM*cos(240 [deg]) + HALF*sin(240 [deg]),
                                 PLATFORM*sin(240 [deg]) - HALF*cos(240 [deg]), 0);
        }

        repeat i in 0..3 {
            /// Torque on the arm, downwards, N m.
            input torque[i] [N*m];

            // x away from the middle, y along the axis of the motor.
            marker motor[i] [m] = (BASE*cos(120 [deg]*i), BASE*sin(120 [deg]*i), 0), about_z [deg] = 120*i;
            body arm[i] {
                mass [kg] = ARM_MASS; center [m] = (ARM_CENTER, 0, 0);
                inertia [kg*m^2] = (1e-3, ARM_ACROSS, ARM_ACROSS);
                point elbow[0] [m] = (ARM, HALF, 0); point elbow[1] [m] = (ARM, -HALF, 0);
            }
            joint shoulder[i]: revolute(motor[i], arm[i].origin, axis = (0, 1, 0));
            torque drive[i]: torque(shoulder[i]) = torque[i];

            repeat j in 0..2 {
                body bar[2*i+j] {
                    mass [kg] = 0.525; center [m] = (BAR/2, 0, 0);
                    inertia [kg*m^2] = (5.22934e-5, 0.043009, 0.0430094);
                    point tip [m] = (BAR, 0, 0);
                }
                joint cross[2*i+j]: universal(arm[i].elbow[j], bar[2*i+j].origin,
                                              axis = (0, 1, 0), second_axis = (0, 0, 1));
                joint ball[2*i+j]:  spherical(bar[2*i+j].tip, platform.ball[2*i+j]);
                start { cross[2*i+j].angle_1 [deg] ~ 92.6; cross[2*i+j].angle_2 [deg] ~ 0; }
            }
        }

        start  { shoulder[0].angle [deg] = 30; shoulder[1].angle [deg] = 30; shoulder[2].angle [deg] = 30;
                 shoulder[0].rate [rad/s] = 1; shoulder[1].rate [rad/s] = -0.5; shoulder[2].rate [rad/s] = 0.8;
                 platform.center.x [m] ~ 0; platform.center.y [m] ~ 0; platform.center.z [m] ~ -1.1;
                 platform.orientation ~ (1, 0, 0, 0); }
        options { emit = (null_space); }
        expect { degrees_of_freedom = 3; }
        output x [m] = platform.center.x;
        output y [m] = platform.center.y;
        output z [m] = platform.center.z;
        output velocity_x [m/s] = platform.center.velocity.x;
        output velocity_y [m/s] = platform.center.velocity.y;
        output velocity_z [m/s] = platform.center.velocity.z;
    }
}
