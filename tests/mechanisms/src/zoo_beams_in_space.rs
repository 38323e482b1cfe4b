//! Mechanisms with beams in space: every set of shapes, both ways of bending, torsion, sections that carry and are carried, in trees and loops.

linkwright::mechanism! {
    /// An arm of a clamped and a free beam with a body at the end, and a pinned one on a cross at the middle of the first.
    pub spatial BentInSpace {
        param young [GPa] = 0.5 in 0.1..300;
        param thick [mm] = 40 in 10..60;
        param loss = 0.01 in 0..1;
        input push [N];
        input twist [N*m];
        gravity [m/s^2] = (0.3, -0.2, -9.81);
        beam upper { length [m] = 1; section = rectangle(height = thick, width [mm] = 60); young = young; density [kg/m^3] = 2700;
                     modes = (axial = 1, bending_y = 1, bending_z = 1); shapes = clamped; damping_ratio = loss;
                     point third [m] = (0.4, 0, 0); }
        beam fore  { length [m] = 0.8; section = tube(outer [mm] = 60, inner [mm] = 56); young [GPa] = 0.7; density [kg/m^3] = 2700;
                     modes = (bending_y = 1, bending_z = 1); damping_ratio = 0.01;
                     stiffening = on; }
        beam rod   { length [m] = 0.6; area [mm^2] = 500; second_moment_z [mm^4] = 9e4; second_moment_y [mm^4] = 12e4;
                     young [GPa] = 0.2; density [kg/m^3] = 1500; modes = (axial = 1, bending_y = 1); shapes = pinned; }
        body hand  { mass [kg] = 0.5; inertia [kg*m^2] = (1e-3, 2e-3, 1.5e-3); center [m] = (0.05, 0.01, 0.02); }
        joint base:  revolute(ground(0, 0, 0) [m], upper.start, axis = (0, 0, 1));
        joint elbow: revolute(fore.start, upper.end, axis = (0, 1, 0.3));
        joint wrist: fixed(fore.end, hand.origin);
        joint cross: universal(upper.third, rod.start, axis = (0, 1, 0), second_axis = (0, 0, 1));
        spring tie:  spring(rod.end, ground(1, 1, 0) [m], stiffness [N/m] = 100, length [m] = 0.5, damping [N*s/m] = 1);
        torque turn: torque(base) = twist;
        force blow:  force(fore.end) = (push, -0.1 [N*s/m]*upper.center.velocity.y, 0.2 [N]);
        start { base.angle [rad] = 0.3; base.rate [rad/s] = 1; elbow.angle [rad] = 0.5; elbow.rate [rad/s] = 0.2;
                cross.angle_1 [rad] = 0.3; cross.angle_2 [rad] = 0.1; cross.rate_1 [rad/s] = 0; cross.rate_2 [rad/s] = 0.4;
                upper.bending_y[0] [mm] = 20; upper.bending_z[0].rate [m/s] = 0.1;
                fore.bending_z[0] [mm] = 12; rod.axial[0] [um] = 4; }
        options { emit = (penalty, projection, null_space); }
        output x [m] = hand.origin.x;
        output z [m] = hand.origin.z;
        output bent [mm] = upper.bending_y[0] + 0.5 [s]*fore.bending_z[0].rate;
        output middle [m/s] = upper.center.velocity.x;
        output folded [rad] = elbow.angle;
        output mean [m/s] = fore.origin.velocity.x;
        output sagging [mm] = fore.center.z - fore.origin.z;
        output whole [J] = energy;
    }
}

linkwright::mechanism! {
    /// A slider-crank in space whose coupler bends, and a mast on the same ground whose shapes are polynomials, with a ball at its top.
    pub spatial BentLoop {
        param young [GPa] = 0.7 in 0.1..300;
        gravity [m/s^2] = (0, 0, -9.81);
        beam mast    { length [m] = 1.5; section = circle(diameter [mm] = 60); young = young; density [kg/m^3] = 2700;
                       modes = (bending_y = 2, bending_z = 2); shapes = static; }
        particle top { mass [kg] = 0.3; }
        rod crank    { length [m] = 0.5; radius [m] = 0.02; mass [kg] = 1; }
        beam coupler { length [m] = 1.5; section = rectangle(height [mm] = 60, width [mm] = 80); young = young; mass [kg] = 0.8;
                       modes = (bending_y = 1, bending_z = 1); stiffening = on; }
        body block   { mass [kg] = 2; inertia [kg*m^2] = (1e-2, 1e-2, 1e-2); }
        joint foot:  fixed(ground(1.2, 1.5, 0) [m], mast.start);
        joint cap:   spherical(mast.end, top.center);
        joint pivot: revolute(ground(0, 0.5, 0.6) [m], crank.start, axis = (1, 0, 0));
        joint pin:   spherical(crank.end, coupler.start);
        joint hook:  universal(coupler.end, block.origin, axis = (0, 1, 0), second_axis = (0, 0, 1));
        joint rail:  prismatic(ground(0, 0, 0) [m], block.origin, axis = (1, 0, 0));
        spring tie:  spring(top.center, coupler.center, stiffness [N/m] = 20, length [m] = 1.2);
        start { pivot.angle [rad] = 0.3; pivot.rate [rad/s] = 2; mast.bending_y[0] [mm] = 4; mast.bending_z[1].rate [mm/s] = 30;
                rail.travel [m] ~ 1.2; hook.angle_2 [rad] ~ 0.372; }
        options { emit = (penalty, projection, tangent); }
        output reach [m] = rail.travel;
        output sway [mm] = mast.bending_y[0];
        output whole [J] = energy;
    }
}

linkwright::mechanism! {
    /// Two shafts that twist and bend in a chain, one of them in its middle with an arm, between a motor and a hand.
    #[allow(slender)]
    pub spatial TwistedInSpace {
        param shear [GPa] = 0.08 in 0.01..100;
        param wide [mm] = 20 in 10..40;
        param loss = 0.01 in 0..1;
        input twist [N*m];
        gravity [m/s^2] = (0.3, -0.2, -9.81);
        beam drive { length [m] = 1; section = circle(diameter [mm] = 30); young [GPa] = 1; shear_modulus = shear; density [kg/m^3] = 7800;
                     modes = (bending_y = 1, torsion = 2); shapes = clamped; damping_ratio = loss;
                     point third [m] = (0.4, 0, 0); }
        beam blade { length [m] = 0.8; section = rectangle(height [mm] = 30, width = wide); young [GPa] = 1; shear_modulus [GPa] = 0.3;
                     density [kg/m^3] = 2700; modes = (bending_z = 1, torsion = 2); stiffening = on; }
        body hand  { mass [kg] = 0.5; inertia [kg*m^2] = (1e-3, 2e-3, 1.5e-3); center [m] = (0.05, 0.01, 0.02); }
        body arm   { mass [kg] = 0.3; inertia [kg*m^2] = (1e-3, 2e-3, 1.5e-3); center [m] = (0.1, 0.01, 0.02); }
        joint base:  revolute(ground(0, 0, 0) [m], drive.start, axis = (1, 0.2, 0.1));
        joint elbow: revolute(drive.end, blade.start, axis = (0, 1, 0.3));
        joint wrist: fixed(blade.end, hand.origin);
        joint side:  revolute(drive.third, arm.origin, axis = (0.3, 1, 0));
        torque turn: torque(base) = twist;
        force blow:  force(hand.origin) = (0.3 [N], -0.1 [N*s/m]*drive.center.velocity.y, 0.2 [N]);
        start { base.angle [rad] = 0.3; base.rate [rad/s] = 3; elbow.angle [rad] = 0.5; elbow.rate [rad/s] = -2; side.angle [rad] = 0.2;
                side.rate [rad/s] = 1; drive.torsion[0] [deg] = 4; drive.torsion[1].rate [rad/s] = 3;
                blade.torsion[1] [rad] = 0.03; blade.torsion[0].rate [rad/s] = 2; blade.bending_z[0] [mm] = 3; }
        options { emit = (penalty, projection, null_space); }
        output turned [deg] = drive.torsion[0] + 0.1 [s]*blade.torsion[0].rate;
        output x [m] = hand.origin.x;
        output z [m] = arm.center.z;
        output folded [rad] = elbow.angle;
        output whole [J] = energy;
    }
}

linkwright::mechanism! {
    /// A loop through a shaft with polynomial shapes, and a stated section between two hinges that twists.
    #[allow(slender)]
    pub spatial TwistedLoop {
        param shear [GPa] = 0.05 in 0.01..100;
        gravity [m/s^2] = (0, 0, -9.81);
        beam mast  { length [m] = 1; section = tube(outer [mm] = 60, inner [mm] = 50); young [GPa] = 0.7; shear_modulus = shear; density [kg/m^3] = 2700;
                     modes = (bending_z = 1, torsion = 2); shapes = static; }
        beam rod   { length [m] = 0.8; area [mm^2] = 700; second_moment_z [mm^4] = 3e4; second_moment_y [mm^4] = 4e4; torsion_constant [mm^4] = 2e4;
                     young [GPa] = 0.7; shear_modulus [GPa] = 0.04; density [kg/m^3] = 1500; modes = (bending_y = 1, torsion = 1); shapes = pinned;
                     damping_ratio = 0.02; }
        body lever { mass [kg] = 0.4; inertia [kg*m^2] = (2e-3, 3e-3, 4e-3); center [m] = (0.1, 0.05, 0); point tip [m] = (0.2, 0.3, 0); }
        body block { mass [kg] = 1; inertia [kg*m^2] = (1e-2, 1e-2, 1e-2); }
        joint foot:  fixed(ground(0, 0, 0) [m], mast.start);
        joint crown: fixed(mast.end, lever.origin);
        joint pin:   universal(lever.tip, rod.start, axis = (0, 1, 0), second_axis = (0, 0, 1));
        joint hook:  spherical(rod.end, block.center);
        joint rail:  prismatic(ground(0, 0.3, 0) [m], block.center, axis = (1, 0, 0));
        spring tie:  spring(block.center, ground(3, 0.3, 0) [m], stiffness [N/m] = 40, length [m] = 0.8);
        start { mast.torsion[0] [rad] = 0.04; mast.torsion[1].rate [rad/s] = 0.4; rod.torsion[0] [deg] = 2; rod.torsion[0].rate [rad/s] = 1;
                rail.travel [m] ~ 2; pin.angle_1 [rad] ~ 0; pin.angle_2 [rad] ~ 0; }
        options { emit = (penalty, projection, tangent); }
        output reach [m] = rail.travel;
        output turned [deg] = mast.torsion[0];
        output whole [J] = energy;
    }
}
