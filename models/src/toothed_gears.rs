//! Gears by their teeth: a planetary set with three planets, and a compound train.
//!
//! Sources: lecture "Day 2: Dynamics", worked examples of part II (40/20/80, ring held); the compound train 20/50, 18/72 is of the same part.
//! Modules, masses and places are ours. Ratios and senses follow from numbers of teeth, and each planet is turned at the start to where
//! its teeth meet those of the sun; that they then meet those of the ring, (40 + 80)/3 being whole, is checked while the program is built.
//! Expected: ω_sun = 3 ω_arm and ω_planet = −3 ω_arm against the ground; of the train ω_in = 10 ω_out.

linkwright::mechanism! {
    /// Planetary set 40/20/80 with three planets: arm in, sun out, ring held.
    pub planar ToothedPlanetarySet {
        const SUN = 40;
        const PLANET = 20;
        const RING = 80;
        const MODULE [mm] = 2;
        const AXES [m] = MODULE*(SUN + PLANET)/2;
        const THIRD [deg] = 120;
        /// Torque on the arm.
        input arm_torque [N*m];
        /// Torque on the sun.
        input sun_torque [N*m];

        body arm {
            mass [kg] = 0.6; inertia [kg*m^2] = 4e-4;
            point pin[0] [m] = (AXES, 0);
            point pin[1] [m] = (AXES*cos(THIRD), AXES*sin(THIRD));
            point pin[2] [m] = (AXES*cos(THIRD), -AXES*sin(THIRD));
        }
        disk sun  { mass [kg] = 1; radius [m] = MODULE*SUN/2; toothing rim: external(teeth = SUN, module = MODULE, face_width [mm] = 20); }
        body ring { mass [kg] = 2; inertia [kg*m^2] = 0.015; toothing rim: internal(teeth = RING, module = MODULE, face_width [mm] = 20); }
        joint held:    fixed(ground(0, 0) [m], ring.center);
        joint bearing: revolute(ground(0, 0) [m], arm.origin);
        joint axle:    revolute(ground(0, 0) [m], sun.center);
        repeat p in 0..3 {
            disk planet[p] { mass [kg] = 0.3; radius [m] = MODULE*PLANET/2;
                             toothing rim: external(teeth = PLANET, module = MODULE, face_width [mm] = 20); }
            joint bolt[p]: revolute(arm.pin[p], planet[p].center);
            gear inner[p]: gear(sun.rim, planet[p].rim);
            gear outer[p]: gear(planet[p].rim, ring.rim);
        }

        torque input: torque(arm) = arm_torque;
        torque output: torque(sun) = sun_torque;
        start  { bearing.angle [rad] = 0; bearing.rate [rad/s] = 10; }
        expect { degrees_of_freedom = 1; }
        output sun_rate [rad/s] = sun.rate;
        output planet_rate [rad/s] = planet[0].rate;
    }
}

linkwright::mechanism! {
    /// A compound train: 20 teeth drive 50, and on the same shaft 18 drive 72.
    pub planar CompoundTrain {
        const FIRST [mm] = 3;
        const SECOND [mm] = 4;
        input torque [N*m];
        disk driver { mass [kg] = 0.9; radius [mm] = 30; toothing rim: external(teeth = 20, module = FIRST); }
        body layshaft { mass [kg] = 6; inertia [kg*m^2] = 0.012;
                        toothing wheel: external(teeth = 50, module = FIRST); toothing pinion: external(teeth = 18, module = SECOND); }
        disk driven { mass [kg] = 14; radius [mm] = 144; toothing rim: external(teeth = 72, module = SECOND); }
        joint input_shaft:  revolute(ground(0, 0) [mm], driver.center);
        joint middle_shaft: revolute(ground(105, 0) [mm], layshaft.center);
        joint output_shaft: revolute(ground(285, 0) [mm], driven.center);
        gear front: gear(driver.rim, layshaft.wheel);
        gear back:  gear(layshaft.pinion, driven.rim);
        torque motor: torque(input_shaft) = torque;
        start { input_shaft.angle [rad] = 0; input_shaft.rate [rad/s] = 50; }
        expect { degrees_of_freedom = 1; }
        output out_rate [rad/s] = driven.rate;
    }
}
