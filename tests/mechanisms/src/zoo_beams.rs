//! Mechanisms with beams: every set of shapes, joints at places that move and turn with the deformation, in both orders, carrying and
//! cut, loads at them, parameters in what they are made of.

linkwright::mechanism! {
    /// A free beam on a hinge that carries a clamped one by its end and a pinned one by its middle, with springs at their tips.
    pub planar Bent {
        param young [GPa] = 2 in 0.1..300;
        param thick [mm] = 8 in 1..20;
        param loss = 0.02 in 0..1;
        input push [N];
        input twist [N*m];
        gravity [m/s^2] = (0.4, -9.81);
        beam swing { length [m] = 1; section = circle(diameter = thick); young = young; density [kg/m^3] = 2700;
                     modes = (axial = 2, bending = 3); damping_ratio = loss; point third [m] = (0.1, 0); }
        beam arm   { length [m] = 0.7; section = tube(outer [mm] = 8, inner [mm] = 6); young [GPa] = 70; mass [kg] = 0.05;
                     modes = (axial = 1, bending = 2); shapes = clamped; }
        beam rod   { length [m] = 0.6; area [mm^2] = 50; second_moment [mm^4] = 300; young [GPa] = 20; density [kg/m^3] = 1500;
                     modes = (axial = 1, bending = 2); shapes = pinned; damping_ratio = 0.05; }
        disk bob   { mass [kg] = 0.2; radius [m] = 0.05; }
        joint pin:   revolute(swing.end, ground(0, 0) [m]);
        joint elbow: revolute(arm.end, swing.start);
        joint third: revolute(swing.third, rod.start);
        joint hand:  revolute(bob.center, rod.end);
        spring tie:  spring(bob.center, ground(1, 1) [m], stiffness [N/m] = 100, length [m] = 0.5, damping [N*s/m] = 1);
        torsion_spring knee: torsion_spring(elbow, stiffness [N*m/rad] = 3, damping [N*m*s/rad] = 0.1);
        torque turn: torque(third) = twist;
        force blow:  force(arm.start) = (push, -0.1 [N*s/m]*swing.center.velocity.y);
        start { pin.angle [rad] = 0.3; pin.rate [rad/s] = 1; elbow.angle [rad] = 0.5; elbow.rate [rad/s] = 0.2;
                third.angle [rad] = 1; third.rate [rad/s] = 0; hand.angle [rad] = 0; hand.rate [rad/s] = 1;
                swing.bending[0] [mm] = 3; swing.bending[0].rate [mm/s] = 20; rod.axial[0] [um] = 4; }
        options { emit = (penalty, projection, null_space, tangent); }
        output bent [rad] = elbow.angle;
        output first [mm] = swing.bending[0] + 0.5 [s]*arm.bending[1].rate;
        output tip [m] = arm.start.x;
        output mean [m/s] = swing.origin.velocity.x;
        output middle [m/s] = swing.center.velocity.x;
        output whole [J] = energy;
    }
}

linkwright::mechanism! {
    /// Beams welded to the ground, to one another at sections that turn, and to a sled; a loop through them.
    #[allow(stiffening)]
    pub planar Frame {
        param offset [rad] = 0.1;
        gravity [m/s^2] = (0, -9.81);
        beam post { length [m] = 0.8; section = rectangle(height [mm] = 4, width [mm] = 20); young [GPa] = 70; density [kg/m^3] = 2700;
                    shapes = clamped; damping_ratio = 0.01; }
        beam bar  { length [m] = 0.5; section = rectangle(height [mm] = 3, width [mm] = 20); young [GPa] = 7; density [kg/m^3] = 2700;
                    modes = (axial = 1, bending = 2); }
        body knob { mass [kg] = 0.1; inertia [kg*m^2] = 1e-4; center [m] = (0.01, 0.02); }
        body sled { mass [kg] = 0.4; inertia [kg*m^2] = 0.01; }
        joint foot: fixed(ground(0, 0) [m], post.start, angle = 1.2 [rad]);
        joint weld: fixed(post.end, knob.origin, angle = offset);
        joint joint_1: revolute(bar.start, post.center);
        joint rail: prismatic(ground(0, 0.1473) [m], sled.center, axis = (1, 0.2));
        joint clasp: fixed(sled.center, bar.end, angle = -0.2 [rad]);
        start { post.bending[0] [mm] = 2; post.bending[1].rate [mm/s] = 3; bar.angle [rad] ~ -0.2; rail.travel [m] ~ 0.646;
                bar.bending[0] [mm] ~ 0; bar.axial[0] [mm] ~ 0; bar.axial[0].rate [mm/s] = 0; }
        options { emit = (penalty, projection, null_space, tangent); }
        output across [m] = knob.center.x;
        output held [N*m] = weld.reaction.torque;
        output foot_force [N] = foot.reaction.x;
    }
}

linkwright::mechanism! {
    /// Beams that stiffen: a free one on a hinge, a pinned one that it carries by a place within, a clamped one that hangs by its end, and
    /// one that slides and does not turn.
    pub planar Stiffened {
        input push [N];
        gravity [m/s^2] = (0.4, -9.81);
        beam swing { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 200; density [kg/m^3] = 2700;
                     modes = (bending = 2); stiffening = on; point third [m] = (0.1, 0); }
        beam rod   { length [m] = 0.6; section = circle(diameter [mm] = 6); young [GPa] = 200; density [kg/m^3] = 1500;
                     modes = (axial = quadratic, bending = 1); shapes = pinned; stiffening = on; damping_ratio = 0.05; }
        beam arm   { length [m] = 0.7; section = tube(outer [mm] = 8, inner [mm] = 6); young [GPa] = 200; mass [kg] = 0.05;
                     modes = (axial = 1, bending = 2); shapes = clamped; stiffening = on; }
        beam sled  { length [m] = 0.5; section = circle(diameter [mm] = 5); young [GPa] = 200; mass [kg] = 0.1;
                     modes = (bending = 1); shapes = static; stiffening = on; }
        disk bob   { mass [kg] = 0.2; radius [m] = 0.05; }
        joint pin:   revolute(swing.start, ground(0, 0) [m]);
        joint third: revolute(swing.third, rod.start);
        joint hand:  revolute(bob.center, rod.end);
        joint elbow: revolute(arm.end, swing.end);
        joint rail:  prismatic(ground(0, 0.1) [m], sled.start, axis = (1, 0.2));
        joint tie:   distance(sled.end, bob.center, length [m] = 1.5);
        force blow:  force(arm.start) = (push, -0.1 [N*s/m]*swing.center.velocity.y);
        spring cord: spring(swing.center, sled.center, stiffness [N/m] = 20, length [m] = 0.5, damping [N*s/m] = 1);
        start { pin.angle [rad] = 0.3; pin.rate [rad/s] = 1; elbow.angle [rad] = 0.5; elbow.rate [rad/s] = 0.2;
                third.angle [rad] = 1; third.rate [rad/s] = 0; hand.angle [rad] = 0; hand.rate [rad/s] = 1; rail.travel [m] ~ -0.7;
                swing.bending[0] [mm] = 3; swing.bending[0].rate [mm/s] = 20; rod.bending[0] [mm] = 2;
                arm.bending[0] [mm] = 2; arm.bending[1].rate [mm/s] = 10; sled.bending[0] [mm] = 1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output tip [m] = arm.start.x;
        output middle [m/s] = swing.center.velocity.x;
        output whole [J] = energy;
        output pull [N] = tie.tension;
    }
}
