//! Gears by their teeth: a planetary set with three planets, a compound train, a rack and pinion, bevel gears, a worm drive and a differential.
//!
//! Sources: lecture "Day 2: Dynamics", worked examples of part II (40/20/80, ring held); the compound train 20/50, 18/72 is of the same part.
//! Modules, masses and places are ours. Ratios and senses follow from numbers of teeth, and each planet is turned at the start to where
//! its teeth meet those of the sun; that they then meet those of the ring, (40 + 80)/3 being whole, is checked while the program is built.
//! Expected: ω_sun = 3 ω_arm and ω_planet = −3 ω_arm against the ground; of the train ω_in = 10 ω_out. The rack travels 40 π mm in a turn of its pinion (m = 2 mm,
//! z = 20), bevel gears 20/40 turn as 2 to 1, a worm with one thread turns its wheel of 40 by 1/40. The differential holds ω_left + ω_right = 2 ω_case; its clutch, regularised
//! Coulomb friction between case and left shaft, moves torque to the slower shaft.

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

linkwright::mechanism! {
    /// A pinion of 20 teeth drives a rack.
    pub planar RackAndPinion {
        const MODULE [mm] = 2;
        /// Torque on the pinion.
        input torque [N*m];
        /// Force on the rack.
        input load [N];
        disk pinion { mass [kg] = 0.25; radius [mm] = 20; toothing rim: external(teeth = 20, module = MODULE, face_width [mm] = 20); }
        body bar { mass [kg] = 1.6; inertia [kg*m^2] = 0.005; point near [mm] = (-95, 0); point far [mm] = (95, 0);
                   line pitch = (bar.near, bar.far); toothing teeth: rack(module = MODULE, line = bar.pitch); }
        joint axle: revolute(ground(0, 20) [mm], pinion.center);
        joint rail: prismatic(ground(0, 0) [mm], bar.center, axis = (1, 0));
        gear drive: gear(pinion.rim, bar.teeth);
        torque motor: torque(pinion) = torque;
        force push: force(rail) = load;
        start { axle.angle [rad] = 0.3; axle.rate [rad/s] = 2; }
        expect { degrees_of_freedom = 1; }
        output travel [mm] = rail.travel;
    }
}

linkwright::mechanism! {
    /// Bevel gears 20/40 about axes at right angles.
    pub spatial BevelPair {
        const SMALL = 20;
        const LARGE = 40;
        const MODULE [mm] = 2;
        const CONE [rad] = atan2(SMALL, LARGE);
        /// Torque on the small wheel.
        input torque [N*m];
        /// Torque on the large wheel.
        input load [N*m];
        gravity [m/s^2] = (0, 0, -9.81);
        body small { mass [kg] = 0.3; inertia [kg*m^2] = (6e-5, 3.5e-5, 3.5e-5);
                     toothing rim: bevel(teeth = SMALL, module = MODULE, cone = CONE, face_width [mm] = 12); }
        body large { mass [kg] = 0.9; inertia [kg*m^2] = (4e-4, 4e-4, 7.2e-4);
                     toothing rim: bevel(teeth = LARGE, module = MODULE, cone = 90 [deg] - CONE, face_width [mm] = 12); }
        joint input_shaft:  revolute(ground(40, 0, 0) [mm], small.center, axis = (1, 0, 0));
        joint output_shaft: revolute(ground(0, 0, 20) [mm], large.center, axis = (0, 0, 1));
        gear pair: gear(small.rim, large.rim);
        torque motor: torque(input_shaft) = torque;
        torque brake: torque(output_shaft) = load;
        start { input_shaft.angle [rad] = 0.3; input_shaft.rate [rad/s] = 20; }
        expect { degrees_of_freedom = 1; }
        output out_rate [rad/s] = output_shaft.rate;
    }
}

linkwright::mechanism! {
    /// A worm with one right-hand thread drives a wheel of 40 teeth.
    pub spatial WormDrive {
        const STARTS = 1;
        const TEETH = 40;
        const MODULE [mm] = 2;
        const DIAMETER [mm] = 20;
        const LEAD [rad] = atan2(STARTS*MODULE, DIAMETER);
        /// Torque on the worm.
        input torque [N*m];
        /// Torque on the wheel.
        input load [N*m];
        gravity [m/s^2] = (0, 0, -9.81);
        body screw { mass [kg] = 0.15; inertia [kg*m^2] = (8e-6, 5e-5, 5e-5);
                     toothing thread: worm(starts = STARTS, module = MODULE, diameter = DIAMETER); }
        body wheel { mass [kg] = 0.8; inertia [kg*m^2] = (3.4e-4, 3.4e-4, 6.4e-4);
                     toothing rim: external(teeth = TEETH, module = MODULE*cos(LEAD), helix = LEAD); }
        joint input_shaft:  revolute(ground(0, 0, 0) [mm], screw.center, axis = (1, 0, 0));
        joint output_shaft: revolute(ground(0, 50, 0) [mm], wheel.center, axis = (0, 0, 1));
        gear drive: gear(screw.thread, wheel.rim);
        torque motor: torque(input_shaft) = torque;
        torque brake: torque(output_shaft) = load;
        start { input_shaft.angle [rad] = 0.3; input_shaft.rate [rad/s] = 100; }
        expect { degrees_of_freedom = 1; }
        output out_rate [rad/s] = output_shaft.rate;
    }
}

linkwright::mechanism! {
    /// A differential with bevel gears in its case, and a clutch between the case and the left shaft.
    pub spatial ClutchedDifferential {
        const SIDE = 24;
        const SPIDER = 15;
        const MODULE [mm] = 3;
        const CONE [rad] = atan2(SIDE, SPIDER);
        /// Distances of the pitch circles from where the axes cross.
        const SIDE_AT [mm] = MODULE*SPIDER/2;
        const SPIDER_AT [mm] = MODULE*SIDE/2;
        /// What the clutch holds.
        param clutch [N*m] = 20;
        /// Slip from which on it holds all of that.
        const SLIP [rad/s] = 0.1;
        /// Torque on the case.
        input torque [N*m];
        /// Torques that the road resists with.
        input left_load [N*m];
        input right_load [N*m];
        body case { mass [kg] = 4; inertia [kg*m^2] = (0.02, 0.015, 0.015);
                    point left [m] = (-SIDE_AT, 0, 0); point right [m] = (SIDE_AT, 0, 0); point cross [m] = (0, SPIDER_AT, 0); }
        body left   { mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.006, 0.006); toothing rim: bevel(teeth = SIDE, module = MODULE, cone = CONE); }
        body right  { mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.006, 0.006); toothing rim: bevel(teeth = SIDE, module = MODULE, cone = CONE); }
        body spider { mass [kg] = 0.6; inertia [kg*m^2] = (4e-4, 6e-4, 4e-4); #[allow(teeth)] toothing rim: bevel(teeth = SPIDER, module = MODULE, cone = 90 [deg] - CONE); }
        joint main:       revolute(ground(0, 0, 0) [m], case.center, axis = (1, 0, 0));
        joint left_axle:  revolute(case.left, left.center, axis = (1, 0, 0));
        joint right_axle: revolute(case.right, right.center, axis = (1, 0, 0));
        joint pin:        revolute(case.cross, spider.center, axis = (0, 1, 0));
        gear to_left:  gear(spider.rim, left.rim);
        gear to_right: gear(spider.rim, right.rim);
        torque engine: torque(main) = torque;
        torque road_left: torque(left) = (left_load, 0, 0);
        torque road_right: torque(right) = (right_load, 0, 0);
        torque plates: torque(left_axle) = -clutch*left_axle.rate/sqrt(left_axle.rate^2 + SLIP^2);
        start { main.angle [rad] = 0; main.rate [rad/s] = 30; left_axle.angle [rad] = 0; left_axle.rate [rad/s] = 1; }
        expect { degrees_of_freedom = 2; }
        output left_rate [rad/s] = main.rate + left_axle.rate;
        output right_rate [rad/s] = main.rate + right_axle.rate;
    }
}
