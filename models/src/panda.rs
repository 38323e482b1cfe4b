//! Franka Emika Panda, seven joints, without the hand.
//!
//! Source: inertias as identified by Gaz, Cognetti, Oliva, Robuffo Giordano & De Luca, *Dynamic identification of the Franka
//! Emika Panda robot with retrieval of feasible parameters using penalty-based optimization*, IEEE Robotics and Automation
//! Letters 4(4), 2019, in frankaemika/franka_ros, franka_description/robots/common/inertial.yaml @b2a62ff6; joints of
//! franka_arm.xacro there. Data: seven links, centres and tensors about them in the axes of the joint before, which the
//! markers on the links in front place (URDF's rpy of (±π/2, 0, 0), written as exact directions); g = 9.81 m/s² along −z.
//! Expected: M, bias and accelerations of Pinocchio 4.1.0, built from the same numbers, at the state that is the start
//! here, to 1e-11.

linkwright::mechanism! {
    /// Franka Emika Panda without its hand; inputs are the torques of its seven joints.
    ///
    /// Outputs are the place of the flange.
    pub spatial Panda {
        input torque_1 [N*m];
        input torque_2 [N*m];
        input torque_3 [N*m];
        input torque_4 [N*m];
        input torque_5 [N*m];
        input torque_6 [N*m];
        input torque_7 [N*m];

        gravity [m/s^2] = (0, 0, -9.81);
        body link_1 { mass [kg] = 4.970684; center [m] = (0.003875, 0.002081, -0.04762);
                      inertia [kg*m^2] = (0.70337, 0.70661, 0.009117); products [kg*m^2] = (-0.000139, 0.006772, 0.019169);
                      marker next [m] = (0, 0, 0), axis = (0, 1, 0), reference = (1, 0, 0); }
        body link_2 { mass [kg] = 0.646926; center [m] = (-0.003141, -0.02872, 0.003495);
                      inertia [kg*m^2] = (0.007962, 0.02811, 0.025995); products [kg*m^2] = (-0.003925, 0.010254, 0.000704);
                      marker next [m] = (0, -0.316, 0), axis = (0, -1, 0), reference = (1, 0, 0); }
        body link_3 { mass [kg] = 3.228604; center [m] = (0.027518, 0.039252, -0.066502);
                      inertia [kg*m^2] = (0.037242, 0.036155, 0.01083); products [kg*m^2] = (-0.004761, -0.011396, -0.012805);
                      marker next [m] = (0.0825, 0, 0), axis = (0, -1, 0), reference = (1, 0, 0); }
        body link_4 { mass [kg] = 3.587895; center [m] = (-0.05317, 0.104419, 0.027454);
                      inertia [kg*m^2] = (0.025853, 0.019552, 0.028323); products [kg*m^2] = (0.007796, -0.001332, 0.008641);
                      marker next [m] = (-0.0825, 0.384, 0), axis = (0, 1, 0), reference = (1, 0, 0); }
        body link_5 { mass [kg] = 1.225946; center [m] = (-0.011953, 0.041065, -0.038437);
                      inertia [kg*m^2] = (0.035549, 0.029474, 0.008627); products [kg*m^2] = (-0.002117, -0.004037, 0.000229);
                      marker next [m] = (0, 0, 0), axis = (0, -1, 0), reference = (1, 0, 0); }
        body link_6 { mass [kg] = 1.666555; center [m] = (0.060149, -0.014117, -0.010517);
                      inertia [kg*m^2] = (0.001964, 0.004354, 0.005433); products [kg*m^2] = (0.000109, -0.001158, 0.000341);
                      marker next [m] = (0.088, 0, 0), axis = (0, -1, 0), reference = (1, 0, 0); }
        body link_7 { mass [kg] = 0.735522; center [m] = (0.010517, -0.004252, 0.061597);
                      inertia [kg*m^2] = (0.012516, 0.010027, 0.004815); products [kg*m^2] = (-0.000428, -0.001196, -0.000741);
                      point flange [m] = (0, 0, 0.107); }

        joint joint_1: revolute(ground(0, 0, 0.333) [m], link_1.origin, axis = (0, 0, 1));
        joint joint_2: revolute(link_1.next, link_2.origin);
        joint joint_3: revolute(link_2.next, link_3.origin);
        joint joint_4: revolute(link_3.next, link_4.origin);
        joint joint_5: revolute(link_4.next, link_5.origin);
        joint joint_6: revolute(link_5.next, link_6.origin);
        joint joint_7: revolute(link_6.next, link_7.origin);

        torque motor_1: torque(joint_1) = torque_1;
        torque motor_2: torque(joint_2) = torque_2;
        torque motor_3: torque(joint_3) = torque_3;
        torque motor_4: torque(joint_4) = torque_4;
        torque motor_5: torque(joint_5) = torque_5;
        torque motor_6: torque(joint_6) = torque_6;
        torque motor_7: torque(joint_7) = torque_7;

        start   { joint_1.angle [rad] = 0.1; joint_1.rate [rad/s] = 0.3;
                  joint_2.angle [rad] = -0.2; joint_2.rate [rad/s] = 0.2;
                  joint_3.angle [rad] = 0.3; joint_3.rate [rad/s] = 0.1;
                  joint_4.angle [rad] = -1.4; joint_4.rate [rad/s] = -0.15;
                  joint_5.angle [rad] = 0.5; joint_5.rate [rad/s] = -0.1;
                  joint_6.angle [rad] = 1.6; joint_6.rate [rad/s] = -0.2;
                  joint_7.angle [rad] = 0.7; joint_7.rate [rad/s] = -0.3; }
        options { coordinates = tree; }
        expect  { degrees_of_freedom = 7; }
        output x [m] = link_7.flange.x;
        output y [m] = link_7.flange.y;
        output z [m] = link_7.flange.z;
    }
}
