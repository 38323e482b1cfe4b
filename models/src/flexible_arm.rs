//! A long arm in orbit: two booms that bend both ways, with a payload.
//!
//! Data: own, in the sizes of the long manipulators that serve space stations: booms of 6.4 m and 7 m, tubes of carbon fibre of 150 mm with
//! walls of 3 mm, a payload of 500 kg whose centre is 0.8 m before and 0.3 m beside the grip. Shapes `static`, two each way. Expected, from
//! rest with all angles at 0 but the elbow's at 1.2 rad, under torques of 300 sin(2πt/8 s) N m about the yaw axis, −150 sin(2πt/8 s) N m at the
//! shoulder and 60 sin(2πt/8 s) N m at the elbow: after 10 s the payload is at (8.77702243, 0.41573871, −5.96068448) m, where steps of RK4 of 1 ms
//! and of 0.5 ms agree to 2e-9 m, and four shapes each way are at (8.77702225, 0.41573897, −5.96068426) m: own converged values.

linkwright::mechanism! {
    /// Arm of two flexible booms in space that turns a payload.
    ///
    /// It slews in eight seconds, and its booms swing behind.
    pub spatial FlexibleArm {
        /// Mass of what is gripped.
        param payload [kg] = 500 in 10..2000;
        /// Young's modulus of the booms.
        param young [GPa] = 70 in 10..300;
        input yaw_torque [N*m];
        input shoulder_torque [N*m];
        input elbow_torque [N*m];
        body column { mass [kg] = 50; inertia [kg*m^2] = (4, 4, 3); point top [m] = (0, 0, 0.6); }
        beam upper  { length [m] = 6.4; section = tube(outer [mm] = 150, inner [mm] = 144); young = young; density [kg/m^3] = 1600;
                      modes = (bending_y = 2, bending_z = 2); shapes = static; }
        beam fore   { length [m] = 7; section = tube(outer [mm] = 150, inner [mm] = 144); young = young; density [kg/m^3] = 1600;
                      modes = (bending_y = 2, bending_z = 2); shapes = static; }
        box load    { mass = payload; size [m] = (1.6, 1, 1.2); point grip [m] = (-0.8, 0.3, 0); }
        joint yaw:      revolute(ground(0, 0, 0) [m], column.origin, axis = (0, 0, 1));
        joint shoulder: revolute(column.top, upper.start, axis = (0, 1, 0));
        joint elbow:    revolute(upper.end, fore.start, axis = (0, 1, 0));
        joint hold:     fixed(fore.end, load.grip);
        torque turn:  torque(yaw) = yaw_torque;
        torque lift:  torque(shoulder) = shoulder_torque;
        torque fold:  torque(elbow) = elbow_torque;
        start  { yaw.angle [rad] = 0; shoulder.angle [rad] = 0; elbow.angle [rad] = 1.2; }
        expect { degrees_of_freedom = 11; }
        output x [m] = load.center.x;
        output y [m] = load.center.y;
        output z [m] = load.center.z;
        output upper_bend [mm] = upper.bending_y[0];
        output fore_bend [mm] = fore.bending_z[0];
        output stored [J] = energy;
    }
}
