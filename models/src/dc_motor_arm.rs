//! A direct-current motor on an arm that hangs: a mechanism with a state beside its motion.
//!
//! Data: inductance 2 mH, resistance 0.5 Ω, torque constant 0.08 N m/A (and 0.08 V s), moment of inertia of arm and rotor about the
//! axle 0.02 kg m², m g l = 0.0981 N m; 3 V from rest, hanging. Equations: J θ̈ = K i − m g l sin θ, L i̇ = V − R i − K θ̇ (Fitzgerald,
//! Kingsley, Umans, *Electric Machinery*, ch. 7). Expected: angle, rate and current after 0.01 s and 1 s, of a separate integration of
//! these two equations (Dormand and Prince of order 8, 3e-14).

linkwright::mechanism! {
    /// A direct-current motor turns an arm.
    ///
    /// `angle` grows from the hanging position, 0 at the start.
    pub planar DcMotorArm {
        param resistance [ohm] = 0.5;
        param inductance [mH] = 2;
        param constant [N*m/A] = 0.08;
        input voltage [V];
        gravity [m/s^2] = (0, -9.81);

        /// Through the motor.
        state current [A] = 0;
        rate  current = (voltage - resistance*current - constant*axle.rate)/inductance;

        // Of 0.02 kg m² about the axle.
        body arm { mass [kg] = 0.1; inertia [kg*m^2] = 0.019; point axle [m] = (0, 0.1); }

        joint  axle:  revolute(ground(0, 0) [m], arm.axle);
        torque motor: torque(axle) = constant*current;

        start { axle.angle [rad] = 0; axle.rate [rad/s] = 0; }
        options { emit = (tangent); }
        output angle [rad] = axle.angle;
        output rate [rad/s] = axle.rate;
        output current [A] = current;
    }
}
