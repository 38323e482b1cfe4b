//! The yaw drive of a wind turbine: four pinions turn a toothed ring, each by a motor on a soft shaft.
//!
//! Source: the lecture's yaw drive with its question how the pinions share the load; numbers are ours: pinions of 14 teeth inside a ring of 140 (14 mm), 12 kN m each, shafts of
//! 4e6 N m/rad, teeth of 2e9 N/m that swing by a quarter once a pitch, a gap of 0.3 mm, a ring that turns at 0.02 rad/s. Expected: 12 000/r_b = 130 307.482344 N in each mesh; of a motor
//! that pulls by 1 % more the share 1.01/1.0025, of the others 1/1.0025: load follows the torques and not the teeth.

linkwright::mechanism! {
    /// Four motors on shafts, four pinions, a ring that is driven at a constant rate.
    pub planar YawDrive {
        const PINION = 14;
        const RING = 140;
        const MODULE [mm] = 14;
        const AXES [m] = MODULE*(RING - PINION)/2;
        const RATE [rad/s] = 0.02;
        repeat p in 0..4 {
            /// Torque of this motor.
            input torque[p] [N*m];
        }

        body ring { mass [kg] = 1500; inertia [kg*m^2] = 1500; toothing rim: internal(teeth = RING, module = MODULE, face_width [mm] = 120); }
        joint tower: revolute(ground(0, 0) [m], ring.center);
        drive turning: tower.angle = RATE*time;
        repeat p in 0..4 {
            // A pinion whose tooth faces a space of the ring at the angle zero, and what its motor has behind the gearbox.
            #[allow(teeth)]
            body pinion[p] { mass [kg] = 40; inertia [kg*m^2] = 0.25; toothing rim: external(teeth = PINION, module = MODULE, face_width [mm] = 120,
                                                                                             first = pi*(1 + 7*p)/PINION*1 [rad]); }
            body motor[p]  { mass [kg] = 300; inertia [kg*m^2] = 60; }
            joint bearing[p]: revolute(ground(AXES*cos(p*pi/2), AXES*sin(p*pi/2)) [m], pinion[p].center);
            joint axle[p]: revolute(ground(AXES*cos(p*pi/2), AXES*sin(p*pi/2)) [m], motor[p].center);
            shaft drive_shaft[p]: shaft(motor[p], pinion[p], ratio = 1, stiffness [N*m/rad] = 4e6, damping [N*m*s/rad] = 400);
            #[allow(teeth)]
            mesh teeth[p]: mesh(pinion[p].rim, ring.rim, stiffness = 2e9 [N/m]*(1 + 0.25*cos(PINION*pinion[p].angle)), damping [N*s/m] = 4e4,
                                backlash [mm] = 0.3);
            torque drive[p]: torque(motor[p]) = torque[p];
            output force[p] [N] = teeth[p].force;
        }
        repeat p in 0..4 { start { axle[p].rate [rad/s] = RATE*RING/PINION; bearing[p].rate [rad/s] = RATE*RING/PINION; } }
        expect { degrees_of_freedom = 9; }
    }
}
