//! KUKA LBR iiwa 14, seven joints, with the inertias of Drake's model.
//!
//! Source: RobotLocomotion/models, iiwa_description/urdf/iiwa14_no_collision.urdf @4723170e; the links that are fixed to one
//! another are one body here, as Pinocchio merges them. Data: seven links, their centres and their tensors about them in
//! the axes of the joint before, which the markers on the links in front place (URDF's rpy of (π/2, 0, π), (π/2, 0, 0) and
//! (−π/2, π, 0), written as exact directions); g = 9.81 m/s² along −z. Other files of the same robot carry other inertias.
//! Once with literals, once with every mass, centre and tensor a parameter. Expected: M, bias and accelerations of Pinocchio
//! 4.1.0 at the state that is the start here, to 1e-11.

macro_rules! iiwa14 {
    (
        $(#[$documentation:meta])*
        $name:ident { $($parameters:tt)* }
        1: $mass_1:tt, $center_1:tt, $inertia_1:tt, $products_1:tt;
        2: $mass_2:tt, $center_2:tt, $inertia_2:tt, $products_2:tt;
        3: $mass_3:tt, $center_3:tt, $inertia_3:tt, $products_3:tt;
        4: $mass_4:tt, $center_4:tt, $inertia_4:tt, $products_4:tt;
        5: $mass_5:tt, $center_5:tt, $inertia_5:tt, $products_5:tt;
        6: $mass_6:tt, $center_6:tt, $inertia_6:tt, $products_6:tt;
        7: $mass_7:tt, $center_7:tt, $inertia_7:tt, $products_7:tt;
    ) => {
        linkwright::mechanism! {
            $(#[$documentation])*
            pub spatial $name {
                $($parameters)*
                input torque_1 [N*m];
                input torque_2 [N*m];
                input torque_3 [N*m];
                input torque_4 [N*m];
                input torque_5 [N*m];
                input torque_6 [N*m];
                input torque_7 [N*m];

                gravity [m/s^2] = (0, 0, -9.81);
                body link_1 { mass [kg] = $mass_1; center [m] = $center_1;
                              inertia [kg*m^2] = $inertia_1; products [kg*m^2] = $products_1;
                              marker next [m] = (0, 0, 0.2025), axis = (0, 1, 0), reference = (-1, 0, 0); }
                body link_2 { mass [kg] = $mass_2; center [m] = $center_2;
                              inertia [kg*m^2] = $inertia_2; products [kg*m^2] = $products_2;
                              marker next [m] = (0, 0.2045, 0), axis = (0, 1, 0), reference = (-1, 0, 0); }
                body link_3 { mass [kg] = $mass_3; center [m] = $center_3;
                              inertia [kg*m^2] = $inertia_3; products [kg*m^2] = $products_3;
                              marker next [m] = (0, 0, 0.2155), axis = (0, -1, 0), reference = (1, 0, 0); }
                body link_4 { mass [kg] = $mass_4; center [m] = $center_4;
                              inertia [kg*m^2] = $inertia_4; products [kg*m^2] = $products_4;
                              marker next [m] = (0, 0.1845, 0), axis = (0, 1, 0), reference = (-1, 0, 0); }
                body link_5 { mass [kg] = $mass_5; center [m] = $center_5;
                              inertia [kg*m^2] = $inertia_5; products [kg*m^2] = $products_5;
                              marker next [m] = (0, 0, 0.2155), axis = (0, -1, 0), reference = (1, 0, 0); }
                body link_6 { mass [kg] = $mass_6; center [m] = $center_6;
                              inertia [kg*m^2] = $inertia_6; products [kg*m^2] = $products_6;
                              marker next [m] = (0, 0.081, 0), axis = (0, 1, 0), reference = (-1, 0, 0); }
                body link_7 { mass [kg] = $mass_7; center [m] = $center_7;
                              inertia [kg*m^2] = $inertia_7; products [kg*m^2] = $products_7; }

                joint axis_1: revolute(ground(0, 0, 0.1575) [m], link_1.origin, axis = (0, 0, 1));
                joint axis_2: revolute(link_1.next, link_2.origin);
                joint axis_3: revolute(link_2.next, link_3.origin);
                joint axis_4: revolute(link_3.next, link_4.origin);
                joint axis_5: revolute(link_4.next, link_5.origin);
                joint axis_6: revolute(link_5.next, link_6.origin);
                joint axis_7: revolute(link_6.next, link_7.origin);

                torque motor_1: torque(axis_1) = torque_1;
                torque motor_2: torque(axis_2) = torque_2;
                torque motor_3: torque(axis_3) = torque_3;
                torque motor_4: torque(axis_4) = torque_4;
                torque motor_5: torque(axis_5) = torque_5;
                torque motor_6: torque(axis_6) = torque_6;
                torque motor_7: torque(axis_7) = torque_7;

                start   { axis_1.angle [rad] = 0.1;  axis_1.rate [rad/s] = 0.3;
                          axis_2.angle [rad] = -0.2; axis_2.rate [rad/s] = 0.2;
                          axis_3.angle [rad] = 0.3;  axis_3.rate [rad/s] = 0.1;
                          axis_4.angle [rad] = -0.4; axis_4.rate [rad/s] = 0;
                          axis_5.angle [rad] = 0.5;  axis_5.rate [rad/s] = -0.1;
                          axis_6.angle [rad] = -0.6; axis_6.rate [rad/s] = -0.2;
                          axis_7.angle [rad] = 0.7;  axis_7.rate [rad/s] = -0.3; }
                options { coordinates = tree; }
                expect  { degrees_of_freedom = 7; }
                output x [m] = link_7.origin.x;
                output y [m] = link_7.origin.y;
                output z [m] = link_7.origin.z;
            }
        }
    };
}

iiwa14! {
    /// KUKA LBR iiwa 14 with the inertias of Drake's model; inputs are the torques of its seven joints.
    ///
    /// Outputs are the place of the last joint.
    Iiwa14 {}
    1: 5.76, (0, -0.03, 0.12),      (0.033, 0.0333, 0.0123),   (0, 0, 0);
    2: 6.35, (0.0003, 0.059, 0.042), (0.0305, 0.011, 0.0304),  (0, 0, 0);
    3: 3.5,  (0, 0.03, 0.13),       (0.025, 0.0238, 0.0076),   (0, 0, 0);
    4: 3.5,  (0, 0.067, 0.034),     (0.017, 0.006, 0.0164),    (0, 0, 0);
    5: 3.5,  (0.0001, 0.021, 0.076), (0.01, 0.0087, 0.00449),  (0, 0, 0);
    6: 1.8,  (0, 0.0006, 0.0004),   (0.0049, 0.0047, 0.0036),  (0, 0, 0);
    7: 1.2,  (0, 0, 0.02),          (0.001, 0.001, 0.001),     (0, 0, 0);
}

iiwa14! {
    /// KUKA LBR iiwa 14 with every mass, centre and tensor a parameter; its defaults are the literals of [`Iiwa14`].
    Iiwa14Parametric {
        param mass_1 [kg] = 5.76 in 0.01..100;
        param center_x_1 [m] = 0;
        param center_y_1 [m] = -0.03;
        param center_z_1 [m] = 0.12;
        param inertia_xx_1 [kg*m^2] = 0.033;
        param inertia_yy_1 [kg*m^2] = 0.0333;
        param inertia_zz_1 [kg*m^2] = 0.0123;
        param product_xy_1 [kg*m^2] = 0;
        param product_xz_1 [kg*m^2] = 0;
        param product_yz_1 [kg*m^2] = 0;
        param mass_2 [kg] = 6.35 in 0.01..100;
        param center_x_2 [m] = 0.0003;
        param center_y_2 [m] = 0.059;
        param center_z_2 [m] = 0.042;
        param inertia_xx_2 [kg*m^2] = 0.0305;
        param inertia_yy_2 [kg*m^2] = 0.011;
        param inertia_zz_2 [kg*m^2] = 0.0304;
        param product_xy_2 [kg*m^2] = 0;
        param product_xz_2 [kg*m^2] = 0;
        param product_yz_2 [kg*m^2] = 0;
        param mass_3 [kg] = 3.5 in 0.01..100;
        param center_x_3 [m] = 0;
        param center_y_3 [m] = 0.03;
        param center_z_3 [m] = 0.13;
        param inertia_xx_3 [kg*m^2] = 0.025;
        param inertia_yy_3 [kg*m^2] = 0.0238;
        param inertia_zz_3 [kg*m^2] = 0.0076;
        param product_xy_3 [kg*m^2] = 0;
        param product_xz_3 [kg*m^2] = 0;
        param product_yz_3 [kg*m^2] = 0;
        param mass_4 [kg] = 3.5 in 0.01..100;
        param center_x_4 [m] = 0;
        param center_y_4 [m] = 0.067;
        param center_z_4 [m] = 0.034;
        param inertia_xx_4 [kg*m^2] = 0.017;
        param inertia_yy_4 [kg*m^2] = 0.006;
        param inertia_zz_4 [kg*m^2] = 0.0164;
        param product_xy_4 [kg*m^2] = 0;
        param product_xz_4 [kg*m^2] = 0;
        param product_yz_4 [kg*m^2] = 0;
        param mass_5 [kg] = 3.5 in 0.01..100;
        param center_x_5 [m] = 0.0001;
        param center_y_5 [m] = 0.021;
        param center_z_5 [m] = 0.076;
        param inertia_xx_5 [kg*m^2] = 0.01;
        param inertia_yy_5 [kg*m^2] = 0.0087;
        param inertia_zz_5 [kg*m^2] = 0.00449;
        param product_xy_5 [kg*m^2] = 0;
        param product_xz_5 [kg*m^2] = 0;
        param product_yz_5 [kg*m^2] = 0;
        param mass_6 [kg] = 1.8 in 0.01..100;
        param center_x_6 [m] = 0;
        param center_y_6 [m] = 0.0006;
        param center_z_6 [m] = 0.0004;
        param inertia_xx_6 [kg*m^2] = 0.0049;
        param inertia_yy_6 [kg*m^2] = 0.0047;
        param inertia_zz_6 [kg*m^2] = 0.0036;
        param product_xy_6 [kg*m^2] = 0;
        param product_xz_6 [kg*m^2] = 0;
        param product_yz_6 [kg*m^2] = 0;
        param mass_7 [kg] = 1.2 in 0.01..100;
        param center_x_7 [m] = 0;
        param center_y_7 [m] = 0;
        param center_z_7 [m] = 0.02;
        param inertia_xx_7 [kg*m^2] = 0.001;
        param inertia_yy_7 [kg*m^2] = 0.001;
        param inertia_zz_7 [kg*m^2] = 0.001;
        param product_xy_7 [kg*m^2] = 0;
        param product_xz_7 [kg*m^2] = 0;
        param product_yz_7 [kg*m^2] = 0;
    }
    1: mass_1, (center_x_1, center_y_1, center_z_1),
       (inertia_xx_1, inertia_yy_1, inertia_zz_1), (product_xy_1, product_xz_1, product_yz_1);
    2: mass_2, (center_x_2, center_y_2, center_z_2),
       (inertia_xx_2, inertia_yy_2, inertia_zz_2), (product_xy_2, product_xz_2, product_yz_2);
    3: mass_3, (center_x_3, center_y_3, center_z_3),
       (inertia_xx_3, inertia_yy_3, inertia_zz_3), (product_xy_3, product_xz_3, product_yz_3);
    4: mass_4, (center_x_4, center_y_4, center_z_4),
       (inertia_xx_4, inertia_yy_4, inertia_zz_4), (product_xy_4, product_xz_4, product_yz_4);
    5: mass_5, (center_x_5, center_y_5, center_z_5),
       (inertia_xx_5, inertia_yy_5, inertia_zz_5), (product_xy_5, product_xz_5, product_yz_5);
    6: mass_6, (center_x_6, center_y_6, center_z_6),
       (inertia_xx_6, inertia_yy_6, inertia_zz_6), (product_xy_6, product_xz_6, product_yz_6);
    7: mass_7, (center_x_7, center_y_7, center_z_7),
       (inertia_xx_7, inertia_yy_7, inertia_zz_7), (product_xy_7, product_xz_7, product_yz_7);
}
