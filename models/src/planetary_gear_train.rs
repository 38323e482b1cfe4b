//! Planetary gear train 40/20/80: the arm drives, the ring is held, the sun is driven.
//!
//! Source: lecture "Day 2: Dynamics", worked example of part II. Data: sun 40, planet 20, ring 80 teeth; the module of
//! 2 mm and the disks' masses are ours. Every gear is mounted on the arm, so that its joint angle is the one relative to
//! the arm, which is what Willis' formula speaks of: (−40/20)(20/80) = −½ = (ω_ring − ω_arm)/(ω_sun − ω_arm). Expected:
//! ω_sun = 3 ω_arm; at constant speed the torque on the arm is three times that on the sun (T_in ω_in = T_out ω_out).

linkwright::mechanism! {
    /// Planetary gear train with 40/20/80 teeth: arm in, sun out, ring held.
    ///
    /// ω_sun = 3 ω_arm, and the two torques balance when T_arm = −3 T_sun.
    pub planar PlanetaryGearTrain {
        const SUN = 40;
        const PLANET = 20;
        const RING = 80;
        const MODULE [mm] = 2;
        const AXES [m] = MODULE*(SUN + PLANET)/2;
        /// Torque on the arm.
        input arm_torque [N*m];
        /// Torque on the sun.
        input sun_torque [N*m];

        body arm    { mass [kg] = 0.6; inertia [kg*m^2] = 4e-4; center [m] = (AXES/2, 0); point pin [m] = (AXES, 0); }
        disk sun    { mass [kg] = 1;   radius [m] = MODULE*SUN/2; }
        disk planet { mass [kg] = 0.3; radius [m] = MODULE*PLANET/2; }
        body ring   { mass [kg] = 2;   inertia [kg*m^2] = 0.015; }

        joint bearing:     revolute(ground(0, 0) [m], arm.origin);
        joint sun_axle:    revolute(arm.origin, sun.center);
        joint planet_axle: revolute(arm.pin, planet.center);
        joint ring_axle:   revolute(arm.origin, ring.center);

        gear outer: gear(planet_axle, sun_axle, ratio = -SUN/PLANET);
        gear inner: gear(planet_axle, ring_axle, ratio = RING/PLANET);
        constraint held: ring.angle = 0;

        torque input: torque(arm) = arm_torque;
        torque output: torque(sun) = sun_torque;

        start  { bearing.angle [rad] = 0; bearing.rate [rad/s] = 10; sun.angle [rad] ~ 0; planet.angle [rad] ~ 0; }
        expect { degrees_of_freedom = 1; }
        output arm_rate [rad/s] = arm.rate;
        output sun_rate [rad/s] = sun.rate;
        output planet_rate [rad/s] = planet.rate;
    }
}
