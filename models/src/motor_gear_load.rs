//! A motor drives a load through a gearbox: rigid, and with an elastic output shaft.
//!
//! Data: motor 0.0012 kg m² and 12 N m; gearbox of 18 : 90 teeth with 0.0004 kg m² of its own at the motor's shaft; load 0.45 kg m²
//! with 20 N m of work and 4 N m of friction; output shaft 4000 N m/rad. Equations: behind a gear of ratio n a load counts with J/n² and T/n,
//! ω̇ = (T_m − T_l/n)/(J_m + J_g + J_l/n²). Expected: 7.2 N m accelerate 0.0196 kg m², 367.3469387755102 rad/s² at the motor and a fifth of it
//! at the load; 14.6 N m are needed for 500 rad/s²; on the elastic shaft both swing against each other at
//! √(4000 (1/0.04 + 1/0.45)) = 329.98316455372 rad/s.

linkwright::mechanism! {
    /// A motor and a load on a rigid gear of ratio 5.
    pub planar MotorGearLoad {
        const RATIO = 90/18;
        input drive [N*m];
        // With what of the gearbox turns as the motor does.
        body motor { mass [kg] = 1; inertia [kg*m^2] = 0.0012 + 0.0004; }
        body load  { mass [kg] = 10; inertia [kg*m^2] = 0.45; }
        joint motor_shaft: revolute(ground(0, 0) [m], motor.center);
        joint load_shaft:  revolute(ground(0.3, 0) [m], load.center);
        gear gearbox: gear(motor_shaft, load_shaft, ratio = RATIO);
        torque driving: torque(motor_shaft) = drive;
        torque working: torque(load_shaft) = -(20 [N*m] + 4 [N*m]);
        start { motor_shaft.angle [rad] = 0; motor_shaft.rate [rad/s] = 0; load_shaft.angle [rad] ~ 0; }
        output motor_rate [rad/s] = motor_shaft.rate;
        output load_rate [rad/s] = load_shaft.rate;
    }
}

linkwright::mechanism! {
    /// The same with an elastic shaft behind the gear.
    pub planar ElasticMotorGearLoad {
        const RATIO = 90/18;
        param stiffness [N*m/rad] = 4000;
        input drive [N*m];
        body motor { mass [kg] = 1; inertia [kg*m^2] = 0.0012 + 0.0004; }
        body load  { mass [kg] = 10; inertia [kg*m^2] = 0.45; }
        joint motor_shaft: revolute(ground(0, 0) [m], motor.center);
        joint load_shaft:  revolute(ground(0.3, 0) [m], load.center);
        signal twist [rad] = load_shaft.angle - motor_shaft.angle/RATIO;
        shaft output: shaft(load_shaft, motor_shaft, ratio = 1/RATIO, stiffness = stiffness);
        torque driving: torque(motor_shaft) = drive;
        torque working: torque(load_shaft) = -(20 [N*m] + 4 [N*m]);
        start { motor_shaft.angle [rad] = 0; motor_shaft.rate [rad/s] = 0; load_shaft.angle [rad] = 0; load_shaft.rate [rad/s] = 0; }
        options { emit = (tangent); }
        output twist [rad] = twist;
        output load_rate [rad/s] = load_shaft.rate;
    }
}
