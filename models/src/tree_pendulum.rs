//! Pendulum of five links that branches, with a torsion spring: a mechanism without loops.
//!
//! Source: data of our own. Data: a trunk, two arms on it and one link on each arm, uniform rods of distinct lengths and
//! masses; an undamped torsion spring between trunk and left arm. Expected: five
//! degrees of freedom, no constraint rows in tree coordinates, constant energy, the same motion in absolute ones.

linkwright::mechanism! {
    /// Branching pendulum of five links with a torsion spring at one joint.
    ///
    /// No loops: tree coordinates have no constraint rows. The energy is constant.
    pub planar TreePendulum {
        gravity [m/s^2] = (0, -9.81);
        rod trunk      { mass [kg] = 2;   length [m] = 1; }
        rod left_arm   { mass [kg] = 0.8; length [m] = 0.7; }
        rod left_hand  { mass [kg] = 0.3; length [m] = 0.4; }
        rod right_arm  { mass [kg] = 0.9; length [m] = 0.6; }
        rod right_hand { mass [kg] = 0.4; length [m] = 0.5; }
        joint root:       revolute(ground(0, 0) [m], trunk.start);
        joint left:       revolute(trunk.end, left_arm.start);
        joint left_wrist: revolute(left_arm.end, left_hand.start);
        joint right:      revolute(trunk.end, right_arm.start);
        joint right_wrist: revolute(right_arm.end, right_hand.start);
        torsion_spring stiffener: torsion_spring(left, stiffness = 12 [N*m/rad], angle = -35 [deg]);
        start  { root.angle [deg] = -60; left.angle [deg] = -20; left_wrist.angle [deg] = 30;
                 right.angle [deg] = 50; right_wrist.angle [deg] = -40;
                 root.rate [rad/s] = 0.5; left.rate [rad/s] = -1; left_wrist.rate [rad/s] = 2;
                 right.rate [rad/s] = 0; right_wrist.rate [rad/s] = -1.5; }
        expect { degrees_of_freedom = 5; }
        output left_x [m] = left_hand.end.x;
        output left_y [m] = left_hand.end.y;
        output right_x [m] = right_hand.end.x;
        output right_y [m] = right_hand.end.y;
        output bend [rad] = left.angle;
    }
}
