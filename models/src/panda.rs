//! Franka Emika Panda, seven joints, without the hand.
//!
//! Source: inertias as identified by Gaz, Cognetti, Oliva, Robuffo Giordano & De Luca, *Dynamic identification of the Franka
//! Emika Panda robot with retrieval of feasible parameters using penalty-based optimization*, IEEE Robotics and Automation
//! Letters 4(4), 2019, in frankaemika/franka_ros, franka_description/robots/common/inertial.yaml @b2a62ff6; joints of
//! franka_arm.xacro there. Data: seven links, centres and tensors about them in the axes of the joint before, which the
//! markers on the links in front place (URDF's rpy of (±π/2, 0, 0), written as exact directions); g = 9.81 m/s² along −z.
//! Expected: M, bias and accelerations of Pinocchio 4.1.0, built from the same numbers, at the state that is the start
//! here, to 1e-11.

linkwright::mechanism!(file = "panda.mech");
