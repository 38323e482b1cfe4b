//! Mechanisms with beams whose sections shear: every set of shapes that they have, in the plane and in space, with stiffening and torsion. One whose beam
//! starts as its loads bend it.

linkwright::mechanism! {
    /// A free beam on a hinge that carries a clamped one with a knob at its end, and a stiffening one on two hinges.
    #[allow(stiffening, slender)]
    pub planar Sheared {
        param heavy [kg/m^3] = 2700 in 1..1e5;
        input push [N];
        input twist [N*m];
        gravity [m/s^2] = (0.4, -9.81);
        beam swing { length [m] = 1; section = rectangle(height [mm] = 120, width [mm] = 50); young [GPa] = 2; shear_modulus [GPa] = 0.8;
                     density = heavy; theory = timoshenko; modes = (axial = 1, bending = 2); damping_ratio = 0.02;
                     point third [m] = (0.1, 0); }
        beam arm   { length [m] = 0.7; section = tube(outer [mm] = 80, inner [mm] = 60); young [GPa] = 1; shear_modulus [GPa] = 0.4;
                     mass [kg] = 0.9; theory = timoshenko; modes = (bending = 2); shapes = clamped; }
        beam rod   { length [m] = 0.6; area [mm^2] = 500; second_moment [mm^4] = 3e5; young [GPa] = 2; density [kg/m^3] = 1500;
                     shear_modulus [GPa] = 0.1; shear_factor = 0.5; theory = timoshenko; modes = (axial = quadratic, bending = 2);
                     shapes = pinned; stiffening = on; damping_ratio = 0.05; }
        body knob  { mass [kg] = 0.1; inertia [kg*m^2] = 1e-4; center [m] = (0.01, 0.02); }
        disk bob   { mass [kg] = 0.2; radius [m] = 0.05; }
        joint pin:   revolute(swing.end, ground(0, 0) [m]);
        joint elbow: fixed(swing.start, arm.start, angle = 0.4 [rad]);
        joint weld:  fixed(arm.end, knob.origin, angle = 0.3 [rad]);
        joint third: revolute(swing.third, rod.start);
        joint hand:  revolute(bob.center, rod.end);
        torque turn: torque(third) = twist;
        force blow:  force(arm.center) = (push, -0.1 [N*s/m]*swing.center.velocity.y);
        start { pin.angle [rad] = 0.3; pin.rate [rad/s] = 1; third.angle [rad] = 1; third.rate [rad/s] = 0; hand.angle [rad] = 0;
                hand.rate [rad/s] = 1; swing.bending[0] [mm] = 3; swing.bending[0].rate [mm/s] = 20; arm.bending[1] [mm] = 1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output tip [m] = knob.center.x;
        output bent [mm] = swing.bending[0] + 0.5 [s]*arm.bending[1].rate;
        output held [N*m] = weld.reaction.torque;
        output whole [J] = energy;
    }
}

linkwright::mechanism! {
    /// A clamped arm that bends both ways and twists, and a free one on it that carries a body.
    #[allow(slender)]
    pub spatial ShearedInSpace {
        param heavy [kg/m^3] = 2700 in 1..1e5;
        input push [N];
        gravity [m/s^2] = (0.3, -0.2, -9.81);
        beam upper { length [m] = 1; section = rectangle(height [mm] = 100, width [mm] = 60); young [GPa] = 0.5; shear_modulus [GPa] = 0.2;
                     density = heavy; theory = timoshenko; modes = (bending_y = 2, bending_z = 1, torsion = 1); shapes = clamped;
                     damping_ratio = 0.01; }
        beam fore  { length [m] = 0.8; section = circle(diameter [mm] = 70); young [GPa] = 0.7; density [kg/m^3] = 2700;
                     shear_modulus [GPa] = 0.3; theory = timoshenko; modes = (axial = 1, bending_y = 1, bending_z = 1); stiffening = on; }
        body hand  { mass [kg] = 0.5; inertia [kg*m^2] = (1e-3, 2e-3, 1.5e-3); center [m] = (0.05, 0.01, 0.02); }
        joint base:  revolute(ground(0, 0, 0) [m], upper.start, axis = (0, 0, 1));
        joint elbow: revolute(fore.start, upper.end, axis = (0, 1, 0.3));
        joint wrist: fixed(fore.end, hand.origin);
        force blow:  force(fore.end) = (push, -0.1 [N*s/m]*upper.center.velocity.y, 0.2 [N]);
        start { base.angle [rad] = 0.3; base.rate [rad/s] = 1; elbow.angle [rad] = 0.5; elbow.rate [rad/s] = 0.2;
                upper.bending_y[0] [mm] = 20; upper.bending_z[0].rate [m/s] = 0.1; upper.torsion[0] [rad] = 0.02;
                fore.bending_z[0] [mm] = 6; }
        options { emit = (penalty, projection, null_space); }
        output x [m] = hand.origin.x;
        output bent [mm] = upper.bending_y[0] + 0.5 [s]*fore.bending_z[0].rate;
        output folded [rad] = elbow.angle;
        output whole [J] = energy;
    }
}

linkwright::mechanism! {
    /// A slider-crank that turns, whose coupler begins without swinging.
    #[allow(stiffening)]
    pub planar Sagging {
        gravity [m/s^2] = (0, -9.81);
        rod crank    { length [m] = 0.3; radius [m] = 0.02; mass [kg] = 1; }
        beam coupler { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 70; density [kg/m^3] = 2700; modes = (bending = 3); }
        body block   { mass [kg] = 1; inertia [kg*m^2] = 0.01; }
        joint pivot: revolute(ground(0, 0) [m], crank.start);
        joint pin:   revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, block.center);
        joint rail:  prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
        start { pivot.angle [deg] = 60; pivot.rate [rad/s] = 3; coupler = static; rail.travel [m] ~ 1.1; }
        expect { deflection(coupler.center) >= 0.1 [mm]; deflection(coupler.center) <= 1 [mm]; }
        options { emit = (penalty, projection, null_space, tangent); }
        output sag [mm] = coupler.bending[0];
        output whole [J] = energy;
    }
}
