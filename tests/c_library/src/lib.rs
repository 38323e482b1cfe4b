//! The press of `examples/c`, and a wrist in space whose motor has a current, with the functions of their C headers.

linkwright::mechanism!(file = "../../../examples/c/press.mech");

linkwright::mechanism! {
    /// A body on a ball joint that a motor with a current turns, and a bob on a rod behind it that counts its turns; in single precision.
    pub spatial Wrist {
        options { emit = (projection, tangent); export_c = f32; }
        param resistance [ohm] = 2 in 0.1..10;
        param inertia [kg*m^2] = 0.02;
        gravity [m/s^2] = (0, 0, -9.81);
        input voltage [V];
        state current [A] = 0.1;
        rate current = (voltage - resistance*current)/0.01 [H];
        body hand { mass [kg] = 1.5; inertia [kg*m^2] = (inertia, inertia, 0.01); center [m] = (0, 0, -0.1); point tip [m] = (0, 0, -0.2); }
        rod arm { mass [kg] = 0.5; length [m] = 0.3; radius [mm] = 10; }
        joint ball: spherical(ground(0, 0, 0) [m], hand.origin);
        joint pin: revolute(hand.tip, arm.start, axis = (0, 1, 0));
        force motor: torque(pin) = 0.2 [N*m/A]*current;
        start { pin.rate [rad/s] = 3; }
        output current [mA] = current;
        output angle [deg] = pin.angle;
    }
}
