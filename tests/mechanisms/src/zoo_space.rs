//! Mechanisms in space that ship with nobody: together they have every kind of joint in both orders of its places, with the
//! ground and between bodies, carrying and cut, with axes and markers that lie along no coordinate axis.
//!
//! They belong to the zoo (`zoo.rs`): every generic check runs on them, and the reference has them in both sets of
//! coordinates, so that what carries in one is cut in the other. That they have every joint in both orders is tested by
//! `tests/checks/both_orders.rs`.

linkwright::mechanism! {
    /// An arm on a tilted hinge, whose forearm carries the slide's first place; everything about its inertia is a parameter.
    pub spatial Arm {
        param weight [kg] = 1.3 in 0.5..3;
        param product [kg*m^2] = 0.004;
        param reach [m] = 0.4;
        param stiffness [N*m/rad] = 2;
        input drive [N*m];
        input push [N];
        gravity [m/s^2] = (0.3, -0.4, -9.81);
        marker foot [m] = (0.1, -0.2, 0.05), axis = (1, 2, 2), reference = (0, 0, 1);
        body upper { mass [kg] = weight; inertia [kg*m^2] = (0.02, 0.03, 0.035); products [kg*m^2] = (product, -0.002, 0.003);
                     center [m] = (reach/2, 0.01, -0.02);
                     marker hip [m] = (0.02, 0, 0.01), about_x [deg] = 30, about_z = -0.7 [rad];
                     marker elbow [m] = (reach, 0.02, 0), axis = (1, 0.2, -0.3); }
        box plate   { density [kg/m^3] = 800; size [m] = (0.2, 0.1, 0.05);
                      marker corner [m] = (0.1, 0.05, 0.025), about_y [deg] = 40; }
        body slide  { mass [kg] = 0.6; inertia [kg*m^2] = (0.004, weight*0.005 [m^2], 0.007); center [m] = (0.05, 0, 0.03);
                      marker root [m] = (-0.1, 0.02, 0), axis = (0.4, 1, 0), reference = (1, 0, 1);
                      point tip [m] = (0.2, -0.05, 0.04); }
        rod hand    { mass [kg] = 0.3; length [m] = 0.25; radius [m] = 0.02; }

        joint shoulder: revolute(foot, upper.hip);
        joint weld:     fixed(upper.elbow, plate.corner);
        joint extend:   prismatic(slide.root, upper.elbow);
        joint wrist:    universal(slide.tip, hand.start, axis = (1, 2, 0), second_axis = (-2, 1, 3));

        torsion_spring coil: torsion_spring(shoulder, stiffness = stiffness, angle = 20 [deg], damping = 0.05 [N*m*s/rad]);
        spring rope:    spring(ground(0.5, 0.4, 0.9) [m], slide.root, stiffness = 30 [N/m], length = 0.2 [m], damping = 0.4 [N*s/m]);
        torque motor:   torque(shoulder) = drive - 0.1 [N*m*s/rad] * shoulder.rate;
        torque twist:   torque(hand) = (0.1 * drive, -0.02 [N*m*s/rad] * hand.rate.y, 0.03 [N*m] * cos(shoulder.angle));
        force wind:     force(hand.end, direction = (1, -1, 2)) = push - 0.3 [N/m] * extend.travel;

        start { shoulder.angle [rad] = 0.4; shoulder.rate [rad/s] = 1; extend.travel [m] = 0.1; extend.speed [m/s] = -0.2;
                wrist.angle_1 [rad] = 0.5; wrist.rate_1 [rad/s] = 0.6; wrist.angle_2 [deg] = -50; wrist.rate_2 [rad/s] = -1; }
        options { coordinates = tree; }
        expect { degrees_of_freedom = 4; }
        output tip [m] = hand.end.z;
        output turned [rad] = wrist.angle_2;
        output loss [W] = power(coil) + power(twist);
    }
}

linkwright::mechanism! {
    /// A jack, from the hook up: the joints' second places are nearer to the ground.
    pub spatial Jack {
        param pitch [m] = 0.3;
        param tilt [kg*m^2] = 0.002;
        gravity [m/s^2] = (0, 0, -9.81);
        marker column [m] = (0.2, 0.1, 0), about_z [deg] = 25, about_x [deg] = -15;
        body nut      { mass [kg] = 0.9; inertia [kg*m^2] = (0.0016, 0.0018, 0.0023); products [kg*m^2] = (0.0002, 0.0001, -0.0003);
                        point start [m] = (-0.05, 0, 0); marker bore [m] = (0.01, 0, 0.02), axis = (1, 0, 1); }
        body spindle  { mass [kg] = 0.7; center [m] = (0.02, 0.01, 0.1);
                        marker thread [m] = (0, 0.02, 0), axis = (0.2, 0, 1), reference = (0, 1, 0);
                        marker principal [m] = (0, 0, 0), about_y [deg] = 35;
                        inertia [kg*m^2] = (0.006, 0.007, 0.006); products [kg*m^2] = (tilt, 0, -0.001);
                        inertia_axes = principal; point eye [m] = (0.03, -0.02, 0.25); }
        body hook     { mass [kg] = 0.8; inertia [kg*m^2] = (0.001, 0.0012, 0.0015); products [kg*m^2] = (0.0001, 0, -0.0002);
                        marker pin [m] = (0.02, 0.03, 0.04), about_z [rad] = 0.8;
                        point end [m] = (0, 0.05, -0.05); }
        particle bob  { mass [kg] = 0.4; }

        joint sleeve: cylindrical(nut.bore, column, axis = (0, 2, 1));
        joint lead:   screw(spindle.thread, nut.start, axis = (1, -1, 0), pitch = pitch);
        joint cross:  universal(hook.pin, spindle.eye, axis = (0, 1, 1), second_axis = (2, 1, -1));
        joint hang:   distance(bob.center, hook.end, length = 0.3 [m]);

        damper shock: damper(hook.end, ground(0.1, 0.1, 1) [m], damping = 2 [N*s/m]);
        force weight: force(bob.center) = (0, 0.2 [N], -0.1 [N*s/m] * bob.center.velocity.z);
        torque brake: torque(lead) = -0.02 [N*m*s/rad] * lead.rate;

        start { sleeve.travel [m] = 0.1; sleeve.speed [m/s] = 0.3; sleeve.angle [rad] = 0.3; sleeve.rate [rad/s] = -0.4;
                lead.angle [rad] = 7; lead.rate [rad/s] = 2; cross.angle_1 [rad] = 0.2; cross.angle_2 [rad] = 0.6;
                cross.rate_1 [rad/s] = 0.1; cross.rate_2 [rad/s] = 1.5;
                bob.center.x [m] ~ 0.3; bob.center.y [m] ~ 0; bob.center.z [m] ~ -1; }
        options { coordinates = absolute; }
        expect { degrees_of_freedom = 7; }
        output travel [m] = lead.travel;
        output angle [rad] = lead.angle;
        output speed [m/s] = sleeve.speed;
    }
}

linkwright::mechanism! {
    /// A slab on a plane whose place moves, a ball joint on it, a bead on a wire of it.
    pub spatial Table {
        param stroke [m] = 0.1;
        param slope [1] = 0.3;
        gravity [m/s^2] = (0, 0, -9.81);
        box slab  { mass [kg] = 2; size [m] = (0.6, 0.4, 0.05); marker below [m] = (0.05, 0.02, -0.025), axis = (0.1, 0, 1);
                    #[allow(outside)] point hole [m] = (0.1, 0.1, 0.1); line wire = (slab.hole, slab.below); }
        body top  { mass [kg] = 0.5; inertia [kg*m^2] = (0.002, 0.003, 0.004); center [m] = (0.01, 0, 0.15);
                    marker tip [m] = (0, 0.01, 0), about_x [deg] = 20, about_y [deg] = -30; }
        particle bead { mass [kg] = 0.2; }
        joint feet: planar(ground(stroke * sin(3 [rad/s] * time), 0.1 [m], 0.05 [m] * cos(2 [rad/s] * time)), slab.below,
                           axis = (slope, 0.2, 1));
        joint ball: spherical(slab.hole, top.tip);
        joint ride: point_on_line(slab.wire, bead.center);
        spring tie: spring(ground(0.1 [m/s] * time, 0.3 [m], 0.8 [m]), bead.center, stiffness = 15 [N/m], length = 0.3 [m], damping = 0.2 [N*s/m]);
        damper rub: damper(top.center, bead.center, damping = 0.5 [N*s/m]);
        torque swirl: torque(top) = (0.01 [N*m], -0.01 [N*m*s/rad] * top.rate.x, 0.02 [N*m]);
        start { feet.travel_1 [m] = 0.1; feet.speed_1 [m/s] = 0.2; feet.travel_2 [m] = -0.05; feet.speed_2 [m/s] = 0.1;
                feet.angle [rad] = 0.4; feet.rate [rad/s] = -1; top.orientation = (0.8, 0.36, -0.48, 0);
                top.rate.x [rad/s] = 0.5; top.rate.y [rad/s] = -1; top.rate.z [rad/s] = 6;
                ride.travel [m] = 0.05; ride.speed [m/s] = 0.1; }
        expect { degrees_of_freedom = 7; }
        output height [m] = top.center.z;
        output gap [m] = distance(top.center, bead.center);
    }
}

linkwright::mechanism! {
    /// The same joints with the ground in the second place, a disk on a plane of the slab, a lid that carries its weld.
    pub spatial Ceiling {
        input pull [N];
        gravity [m/s^2] = (1, 0, -9);
        marker roof [m] = (0, 0.1, 1), axis = (1, -2, 4), reference = (1, 1, 0);
        body slab { mass [kg] = 1.5; inertia [kg*m^2] = (0.04, 0.05, 0.07); products [kg*m^2] = (0.01, 0, 0.005);
                    marker above [m] = (0.1, 0, 0.05), about_y [deg] = 60; marker side [m] = (0, 0.2, 0), axis = (0.3, 1, 0.2); }
        body top  { mass [kg] = 0.5; inertia [kg*m^2] = (0.002, 0.003, 0.004); center [m] = (0.01, 0, 0.15);
                    marker tip [m] = (0, 0.01, 0), about_z [deg] = 20, about_y [deg] = -30; }
        disk wheel { mass [kg] = 0.4; radius [m] = 0.1; marker rim [m] = (0.1, 0, 0), about_x [rad] = 0.6; }
        sphere lid { mass [kg] = 0.1; radius [m] = 0.03; marker below [m] = (0, 0, -0.03), about_z [deg] = 70; }
        joint feet:  planar(slab.above, roof);
        joint ball:  spherical(top.tip, slab.side);
        joint slip:  point_on_plane(slab.side, wheel.rim);
        joint weld:  fixed(lid.below, wheel.rim);
        force draw:  force(lid.center) = (pull, -0.1 [N*s/m] * lid.center.velocity.y, 2 [N]);
        torsion_spring hold: torsion_spring(feet, stiffness = 0.5 [N*m/rad]);
        start { feet.travel_1 [m] = 0.1; feet.speed_1 [m/s] = 0.2; feet.travel_2 [m] = -0.05; feet.speed_2 [m/s] = 0.1;
                feet.angle [rad] = 0.4; feet.rate [rad/s] = -1; top.orientation = (0.6, 0, 0.8, 0);
                top.rate.x [rad/s] = 0.5; top.rate.y [rad/s] = -1; top.rate.z [rad/s] = 3;
                lid.orientation = (0.5, 0.5, -0.5, 0.5); lid.center.x [m] = 0.1; lid.center.z [m] = 0.9;
                lid.rate.x [rad/s] = 0.5; lid.rate.y [rad/s] = -1; lid.rate.z [rad/s] = 1;
                wheel.rim.velocity.x [m/s] = 0.1; wheel.rim.velocity.y [m/s] = 0.3; }
        options { coordinates = tree; }
        expect { degrees_of_freedom = 11; }
        output angle [rad] = feet.angle;
        output slid [m] = feet.travel_2;
    }
}

linkwright::mechanism! {
    /// Two bodies on a wire and on a plane of their own, that hold each other by a wire and a strut, and a stray particle.
    pub spatial Wires {
        param length [m] = 0.8;
        gravity [m/s^2] = (0, 0.2, -9.81);
        line span = (ground(-0.2, 0, 0.1) [m], ground(1, 0.4, 0.3) [m]);
        body runner { mass [kg] = 0.8; inertia [kg*m^2] = (0.01, 0.012, 0.008); center [m] = (0, 0.02, -0.1);
                      point hook [m] = (0.01, 0, 0.02); point end [m] = (0.1, 0.1, -0.3); line edge = (runner.end, runner.center); }
        body float  { mass [kg] = 0.5; inertia [kg*m^2] = (0.006, 0.004, 0.005); products [kg*m^2] = (0.001, 0.0005, -0.001);
                      marker face [m] = (0, 0.03, 0), axis = (1, 3, 1); point eye [m] = (0.1, 0, 0.15); point side [m] = (-0.1, 0.1, 0); }
        particle stray { mass [kg] = 0.1; }
        joint trolley: point_on_line(span, runner.hook);
        joint touch:   point_on_plane(float.face, ground(0.4, 0.7, 0.2) [m]);
        joint slot:    point_on_line(runner.edge, float.eye);
        joint strut:   distance(float.side, runner.hook, length = length);
        joint net:     point_on_plane(ground(0, 0, -0.6) [m], stray.center, axis = (0.2, 0.1, -1));
        spring band:   spring(stray.center, float.side, stiffness = 8 [N/m], length = 0.2 [m]);
        start { trolley.travel [m] = 0.4; trolley.speed [m/s] = 0.5; runner.orientation ~ (0.9, 0.3, 0.3, -0.1); slot.travel [m] ~ 0.1;
                float.orientation ~ (1, 0, 0.2, 0); stray.center.x [m] = 0.2; stray.center.y [m] = -0.1;
                stray.center.velocity.x [m/s] = 0.3; stray.center.velocity.y [m/s] = 0.1; runner.rate.z [rad/s] = 1; }
        expect { degrees_of_freedom = 8; }
        output travel [m] = slot.travel;
    }
}

linkwright::mechanism! {
    /// A driven shaft through two constant-velocity joints, the second with its places the other way round.
    pub spatial Shafts {
        param speed [rad/s] = 3;
        gravity [m/s^2] = (0, 0, -9.81);
        marker entry [m] = (0, 0, 0), axis = (1, 0.2, 0.1);
        marker leave [m] = (1, 0.25, 0), axis = (3, 1, 0), reference = (0, 0, 1);
        cylinder first { mass [kg] = 0.5; length [m] = 0.3; radius [m] = 0.08; marker journal [m] = (-0.15, 0, 0), axis = (1, 0.01, 0); }
        cylinder middle { mass [kg] = 0.7; length [m] = 0.5; radius [m] = 0.1; }
        body last { mass [kg] = 0.9; inertia [kg*m^2] = (0.01, 0.02, 0.021); products [kg*m^2] = (0, 0.001, 0); center [m] = (0.1, 0, 0.01);
                    marker bore [m] = (0.3, 0, 0), axis = (1, 0, 0.02), reference = (0, 0, 1); }
        joint bearing: revolute(entry, first.journal);
        joint front:   constant_velocity(first.end, middle.start, axis = (1, 0, 0));
        joint rear:    constant_velocity(last.origin, middle.end, axis = (1, 0.05, 0));
        joint sleeve:  cylindrical(leave, last.bore);
        drive motor:   bearing.angle = speed * time + 0.1 [rad] * sin(2 [rad/s] * time);
        torsion_spring load: torsion_spring(sleeve, stiffness = 1 [N*m/rad], damping = 0.2 [N*m*s/rad]);
        start { sleeve.travel [m] ~ -0.1; sleeve.angle [rad] ~ 0; middle.orientation ~ (1, 0, 0, 0); middle.center.x [m] ~ 0.5; }
        expect { degrees_of_freedom = 1; }
        output effort [N*m] = motor.effort;
    }
}

linkwright::mechanism! {
    /// A pinion drives a rack and a wheel, a screw follows by an equation; the second joint is the other way round.
    pub spatial Mesh {
        param radius [m] = 0.05;
        input drive [N*m];
        gravity [m/s^2] = (0, 0.5, -9.81);
        marker bench [m] = (0, 0, 0.1), about_x [deg] = 20, about_y [deg] = -35;
        disk pinion { mass [kg] = 1; radius [m] = 0.05; }
        disk wheel  { mass [kg] = 0.6; radius [m] = 0.07; point rim [m] = (0.07, 0, 0.01); }
        body rail   { mass [kg] = 0.8; inertia [kg*m^2] = (0.001, 0.01, 0.011); marker side [m] = (0, 0.02, 0), about_z [deg] = 15; }
        body nut    { mass [kg] = 0.3; inertia [kg*m^2] = (0.002, 0.002, 0.003); center [m] = (0.01, 0.02, 0); }
        joint axle:  revolute(bench, pinion.center);
        joint stub:  revolute(wheel.center, ground(0.1, 0.05, 0.1) [m], axis = (1, 0, 2));
        joint slide: prismatic(rail.side, bench, axis = (2, 1, 0));
        joint lead:  screw(ground(-0.3, 0, 0) [m], nut.origin, axis = (-1, 0.5, 1), pitch = -0.2 [m]);
        rack mesh:   rack(axle, slide, radius = radius);
        gear teeth:  gear(stub, axle, ratio = -5/7);
        constraint follow: lead.travel - 0.5 * slide.travel - 0.4 [m] * sin(axle.angle)^2 - 0.05 [m] * sin(2 [rad/s] * time) = 0;
        torsion_spring coil: torsion_spring(stub, stiffness = 0.3 [N*m/rad], angle = 1 [rad], damping = 0.01 [N*m*s/rad]);
        torque motor: torque(axle) = drive;
        spring pull:  spring(ground(1, 0, 0.3) [m], wheel.rim, stiffness = 4 [N/m], length = 0.4 [m]);
        start { axle.angle [rad] = 0.1; axle.rate [rad/s] = 20; }
        expect { degrees_of_freedom = 1; }
        output turned [rad] = axle.angle;
        output lifted [m] = lead.travel;
        output stub_rate [rad/s] = stub.rate;
    }
}

linkwright::mechanism! {
    /// A slider-crank whose rod is carried by neither of its ends as declared: the universal joint is cut, the slider counts.
    pub spatial Crank {
        param length [m] = 0.9;
        param offset [kg*m^2] = 0.001;
        input load [N];
        gravity [m/s^2] = (0.2, 0, -9.81);
        marker guide [m] = (0.3, 0.1, -0.1), axis = (1, 0.1, 0.2), reference = (0, 1, 0);
        body crank  { mass [kg] = 0.5; inertia [kg*m^2] = (0.004, 0.005, 0.006); center [m] = (0, 0.1, 0.01);
                      marker main [m] = (0, -0.02, 0), axis = (1, 0.3, 0.2); point pin [m] = (0.05, 0.3, 0); }
        body rod    { mass [kg] = 0.4; inertia [kg*m^2] = (0.004, 0.03, 0.031); products [kg*m^2] = (offset, 0, 0.0005);
                      point ball [m] = (-length/2, 0, 0); marker yoke [m] = (length/2, 0, 0), about_x [deg] = 30; }
        box slider  { mass [kg] = 1; size [m] = (0.1, 0.06, 0.05); point ear [m] = (0.05, 0, 0.01); }
        joint bearing: revolute(crank.main, ground(0, 0, 0.4) [m], axis = (0, 0, 1));
        joint knuckle: spherical(rod.ball, crank.pin);
        joint rail:    prismatic(guide, slider.center);
        joint yoke:    universal(slider.ear, rod.yoke, axis = (0.1, 1, 0), second_axis = (1, -0.1, 2));
        force cut:     force(slider.center, direction = (1, 0, 0.3)) = load - 2 [N*s/m] * rail.speed;
        start  { bearing.angle [rad] = 0.4; bearing.rate [rad/s] = 3; rail.travel [m] ~ 0.9; }
        options { cut = yoke; independent = rail.travel; emit = projection; }
        expect { degrees_of_freedom = 1; }
        output stroke [m] = rail.travel;
        output swing [rad] = yoke.angle_1;
    }
}

linkwright::mechanism! {
    /// A four-bar in a slanting plane, three rows too many; its crank is driven.
    pub spatial Slanted {
        param rate [rad/s] = 4;
        gravity [m/s^2] = (0, 0, -9.81);
        marker left [m] = (0.1, 0.2, 0.3), axis = (1, 2, 2), reference = (2, -2, 1);
        marker right [m] = (0.5, -0.2, 0.5), axis = (1, 2, 2), reference = (2, -2, 1);
        body crank   { mass [kg] = 0.5; inertia [kg*m^2] = (0.001, 0.01, 0.011); point end [m] = (0.2, 0, 0); }
        body coupler { mass [kg] = 0.8; inertia [kg*m^2] = (0.002, 0.03, 0.031); products [kg*m^2] = (0, 0.001, 0);
                       marker start [m] = (-0.35, 0, 0); marker end [m] = (0.35, 0, 0); }
        body rocker  { mass [kg] = 0.6; inertia [kg*m^2] = (0.002, 0.02, 0.021); center [m] = (0.2, 0, 0.02);
                       marker end [m] = (0.4, 0, 0); }
        joint crank_pin:  revolute(left, crank.origin);
        joint knee:       revolute(coupler.start, crank.end, axis = (0, 0, 1));
        joint wrist:      revolute(coupler.end, rocker.end, axis = (0, 0, 1));
        joint rocker_pin: revolute(rocker.origin, right, axis = (0, 0, 1));
        drive motor: crank_pin.angle = rate * time + 0.3 [rad];
        spring brace: spring(coupler.center, ground(0.3, 0.3, 0.3) [m], stiffness = 10 [N/m], length = 0.1 [m]);
        start  { rocker_pin.angle [deg] ~ -70; }
        options { redundant = drop; }
        expect { degrees_of_freedom = 1; }
        output effort [N*m] = motor.effort;
        output rocking [rad] = rocker_pin.angle;
    }
}

linkwright::mechanism! {
    /// A floating body that everything is held by, so that the joints with the ground are cut: a revolute and a prismatic.
    pub spatial Hub {
        gravity [m/s^2] = (0, 0, -9.81);
        marker tilted [m] = (0.25, 0, 0.1), about_z [deg] = 50, about_x [deg] = -20;
        body hub  { mass [kg] = 1; inertia [kg*m^2] = (0.02, 0.03, 0.025); products [kg*m^2] = (0.002, 0.001, -0.003);
                    point one [m] = (-0.1, 0.05, 0); marker two [m] = (0.1, 0, 0.05), about_y [deg] = 30; }
        body arm  { mass [kg] = 0.4; inertia [kg*m^2] = (0.002, 0.004, 0.003); marker axle [m] = (-0.2, 0, 0.03), axis = (0.2, 1, 0.1);
                    point far [m] = (0.2, 0, 0); }
        body shoe { mass [kg] = 0.5; inertia [kg*m^2] = (0.002, 0.001, 0.003); marker sole [m] = (0, 0.02, -0.05), about_z [rad] = 0.4; }
        joint ball:  spherical(hub.one, arm.far);
        joint cross: universal(shoe.sole, hub.two, axis = (0, 0, 1), second_axis = (1, 2, 0));
        joint hinge: revolute(arm.axle, ground(-0.3, 0.1, 0) [m]);
        joint rail:  prismatic(tilted, shoe.center, axis = (1, 1, 0));
        spring hold: spring(hub.center, ground(0, 0.1, 0.6) [m], stiffness = 20 [N/m], length = 0.4 [m]);
        start { rail.travel [m] = 0.05;
                hub.center.velocity.x [m/s] = 0.3; }
        options { cut = (hinge, rail); coordinates = tree; }
        expect { degrees_of_freedom = 1; }
        output height [m] = hub.center.z;
    }
}

linkwright::mechanism! {
    /// A bed on a screw and a sled on a wire, tied by a cut planar joint; a weight on a cut weld.
    pub spatial Bench {
        param pitch [m] = 0.4;
        gravity [m/s^2] = (0, 0.3, -9.81);
        marker post [m] = (0, 0.2, 0), axis = (0.1, 0.2, 1), reference = (1, 1, 0);
        body bed   { mass [kg] = 1; inertia [kg*m^2] = (0.02, 0.03, 0.025); point thread [m] = (0.02, 0, 0.01);
                     marker top [m] = (0.05, 0, 0.06), about_x [deg] = 70; }
        body sled  { mass [kg] = 0.5; inertia [kg*m^2] = (0.002, 0.004, 0.003); marker below [m] = (0, 0.01, -0.04), about_y [deg] = -20;
                     point end [m] = (0.2, 0.1, 0); line edge = (sled.end, sled.center); }
        joint lead:  screw(post, bed.thread, axis = (0, 0.1, 1), pitch = pitch);
        joint glide: planar(bed.top, sled.below, axis = (0, 1, 1));
        joint wire:  point_on_line(sled.edge, ground(0.25, 0.08, -0.05) [m]);
        joint stay:  distance(sled.center, ground(0.1, -0.3, 0.2) [m], length = 0.6 [m]);
        joint weld:  fixed(weight.center, sled.end);
        sphere weight { density [kg/m^3] = 3000; radius [m] = 0.03; }
        damper rub:  damper(sled.center, bed.center, damping = 0.5 [N*s/m]);
        start { lead.rate [rad/s] = 1; lead.angle [rad] ~ 0.2; sled.orientation ~ (1, 0, 0, 0); }
        options { cut = (glide, weld); }
        expect { degrees_of_freedom = 1; }
        output raised [m] = lead.travel;
    }
}

linkwright::mechanism! {
    /// A long tree without loops, which articulated bodies solve: turns and slides along no axis, balls both ways, two branches.
    pub spatial Snake {
        param weight [kg] = 0.8 in 0.3..2;
        input drive [N*m];
        gravity [m/s^2] = (0.2, 0.5, -9.81);
        marker foot [m] = (0.1, 0.2, -0.1), axis = (1, 0, 2), reference = (0, 1, 0);
        body first  { mass [kg] = weight; inertia [kg*m^2] = (0.02, 0.03, 0.035); products [kg*m^2] = (0.004, -0.002, 0.003);
                      center [m] = (0.1, 0.02, -0.03); marker root [m] = (0, 0.02, 0.01), about_x [deg] = 20;
                      marker end [m] = (0.3, 0, 0.05), about_y [deg] = 35, about_z [deg] = -10; }
        body second { mass [kg] = 0.7; inertia [kg*m^2] = (0.01, 0.012, 0.009); products [kg*m^2] = (-0.001, 0.002, 0.001);
                      center [m] = (0.12, -0.01, 0.02); marker root [m] = (0.01, 0, 0), about_z [deg] = 50;
                      marker end [m] = (0.25, 0.03, -0.02), axis = (0.3, 1, 0.2), reference = (1, 0, 0);
                      marker side [m] = (0.1, 0.1, 0), axis = (0, 1, 1), reference = (1, 0, 0); }
        body third  { mass [kg] = 0.5; inertia [kg*m^2] = (0.006, 0.005, 0.008); products [kg*m^2] = (0.0005, 0.001, -0.0007);
                      center [m] = (0.05, 0.02, 0.1); point root [m] = (0, -0.01, 0.02); point end [m] = (0.02, 0.04, 0.2); }
        body fourth { mass [kg] = 0.6; inertia [kg*m^2] = (0.007, 0.006, 0.004); products [kg*m^2] = (0.001, 0, 0.0005);
                      center [m] = (0, 0.1, 0.03); marker root [m] = (0.02, 0, -0.01), axis = (1, 1, 3), reference = (0, 1, 0);
                      point end [m] = (0.03, 0.2, 0); }
        body fifth  { mass [kg] = 0.4; inertia [kg*m^2] = (0.003, 0.004, 0.005); products [kg*m^2] = (0.0002, -0.0004, 0.0006);
                      center [m] = (0.06, 0.01, 0); point root [m] = (-0.02, 0, 0.01); point tip [m] = (0.1, 0.02, 0.04); }
        body twig   { mass [kg] = 0.3; inertia [kg*m^2] = (0.002, 0.0015, 0.0018); products [kg*m^2] = (0.0001, 0.0003, -0.0002);
                      center [m] = (0.02, 0.05, 0.04); marker root [m] = (0, 0.01, 0), about_x [deg] = -40; point tip [m] = (0, 0.15, 0.1); }
        particle leaf { mass [kg] = 0.1; }

        joint hip:    revolute(foot, first.root);
        joint reach:  prismatic(second.root, first.end, axis = (1, 2, 0));
        joint socket: spherical(second.end, third.root);
        joint sleeve: cylindrical(fourth.root, third.end, axis = (2, 0, 1));
        joint neck:   spherical(fifth.root, fourth.end);
        joint bud:    revolute(twig.root, second.side, axis = (1, 0, 3));
        joint stem:   point_on_line(line(twig.tip, twig.root), leaf.center);

        torque motor: torque(hip) = drive;
        torsion_spring coil: torsion_spring(bud, stiffness = 2 [N*m/rad], angle = 0.3 [rad], damping = 0.05 [N*m*s/rad]);
        spring rope:  spring(fifth.tip, ground(0.4, 0.3, 0.5) [m], stiffness = 20 [N/m], length = 0.3 [m], damping = 0.3 [N*s/m]);
        force wind:   force(third.end) = (0.4 [N], -0.1 * drive / 1 [m], 0.2 [N]);

        start { hip.angle [rad] = 0.3; hip.rate [rad/s] = 1; reach.travel [m] = 0.1; reach.speed [m/s] = 0.2;
                third.orientation = (0.8, 0.36, -0.48, 0); third.rate.x [rad/s] = 0.5; third.rate.y [rad/s] = -1; third.rate.z [rad/s] = 2;
                sleeve.angle [rad] = 0.5; sleeve.rate [rad/s] = -0.7; sleeve.travel [m] = 0.05; sleeve.speed [m/s] = 0.3;
                fifth.orientation = (0.6, 0, 0.64, 0.48); fifth.rate.x [rad/s] = 0.4; fifth.rate.y [rad/s] = 1; fifth.rate.z [rad/s] = -0.3;
                bud.angle [rad] = 0.2; bud.rate [rad/s] = -0.4; stem.travel [m] = 0.06; stem.speed [m/s] = 0.1; }
        options { coordinates = tree; }
        expect { degrees_of_freedom = 12; }
        output height [m] = fifth.tip.z;
        output speed [m/s] = leaf.center.velocity.x;
    }
}

linkwright::mechanism! {
    /// A tray on a stage on an arm, by parallels in both orders of their places, and a buoy that keeps upright.
    pub spatial Stage {
        input push [N];
        gravity [m/s^2] = (0.2, -0.3, -9.81);
        marker foot [m] = (0.1, 0, 0.05), axis = (1, 2, 2), reference = (0, 0, 1);
        body arm   { mass [kg] = 0.9; inertia [kg*m^2] = (0.012, 0.015, 0.01); products [kg*m^2] = (0.001, -0.002, 0.0005);
                     center [m] = (0.1, 0.02, -0.01); marker root [m] = (0.02, 0, 0.01), about_x [deg] = 25;
                     marker end [m] = (0.3, 0, 0.05), about_y [deg] = 35, about_z [deg] = -10; }
        body stage { mass [kg] = 0.7; inertia [kg*m^2] = (0.01, 0.012, 0.009); products [kg*m^2] = (-0.001, 0.002, 0.001);
                     center [m] = (0.02, -0.01, 0.02); marker seat [m] = (0.01, 0, 0), about_z [deg] = 50;
                     point edge [m] = (0.1, 0.1, 0.02); }
        body tray  { mass [kg] = 0.4; inertia [kg*m^2] = (0.003, 0.004, 0.005); products [kg*m^2] = (0.0002, -0.0004, 0.0006);
                     center [m] = (0.06, 0.01, 0); marker back [m] = (-0.02, 0, 0.01), axis = (1, 1, 3), reference = (0, 1, 0);
                     point tip [m] = (0.1, 0.02, 0.04); }
        body buoy  { mass [kg] = 0.5; inertia [kg*m^2] = (0.004, 0.005, 0.003); center [m] = (0.01, 0, 0.05);
                     marker top [m] = (0, 0.02, 0.1), about_x [deg] = 20; }

        joint shoulder: revolute(foot, arm.root);
        joint ride:     parallel(arm.end, stage.seat);
        joint lift:     parallel(tray.back, stage.edge);
        joint float:    parallel(buoy.top, ground(0, 0.4, 0) [m]);

        spring one:  spring(ground(0.5, 0.3, 0.4) [m], stage.edge, stiffness = 50 [N/m], length = 0.3 [m], damping = 0.4 [N*s/m]);
        spring two:  spring(buoy.top, tray.tip, stiffness = 30 [N/m], length = 0.2 [m], damping = 0.2 [N*s/m]);
        force wind:  force(tray.tip) = (push, -0.2 [N*s/m] * ride.speed_2, 1.5 [N/m] * lift.travel_3);

        start { shoulder.angle [rad] = 0.3; shoulder.rate [rad/s] = 0.8; ride.travel_1 [m] = 0.1; ride.speed_1 [m/s] = 0.2;
                ride.travel_2 [m] = -0.05; ride.speed_2 [m/s] = -0.1; ride.travel_3 [m] = 0.15; ride.speed_3 [m/s] = 0.3;
                lift.travel_1 [m] = 0.05; lift.speed_1 [m/s] = 0.1; lift.travel_2 [m] = 0.02; lift.speed_2 [m/s] = -0.2;
                lift.travel_3 [m] = 0.2; lift.speed_3 [m/s] = 0; float.travel_1 [m] = 0.1; float.speed_1 [m/s] = 0.1;
                float.travel_2 [m] = -0.3; float.speed_2 [m/s] = 0; float.travel_3 [m] = 0.2; float.speed_3 [m/s] = -0.2; }
        expect { degrees_of_freedom = 10; }
        output height [m] = tray.tip.z;
        output reach [m] = float.travel_3;
    }
}

linkwright::mechanism! {
    /// A cabin on rubber and a lever on the cabin, with bushings in either order of their places, on markers with axes of their own and on a
    /// support that moves.
    pub spatial Cabin {
        param rubber [N/m] = 800 in 100..2000;
        param twist [N*m/rad] = 5;
        gravity [m/s^2] = (0.1, 0.2, -9.81);
        marker base [m] = (0.1, 0, 0.2), axis = (1, 2, 2), reference = (0, 0, 1);
        body cabin { mass [kg] = 2; inertia [kg*m^2] = (0.1, 0.12, 0.15); products [kg*m^2] = (0.01, -0.005, 0.004); center [m] = (0.02, 0, 0.01);
                     marker foot [m] = (-0.1, 0.05, -0.2), about_x [deg] = 60, about_z = 0.4 [rad]; point seat [m] = (0.1, 0.1, 0); }
        rod lever  { mass [kg] = 0.3; length [m] = 0.3; radius [m] = 0.02; marker hand [m] = (0.1, 0, 0), about_y [deg] = 20; }
        joint hinge: revolute(cabin.seat, lever.start, axis = (0, 1, 1));
        bushing stand: bushing(base, cabin.foot, stiffness = (rubber, rubber/2, 300 [N/m]), damping = 5 [N*s/m],
                               torsional_stiffness = (twist, 3 [N*m/rad], 4 [N*m/rad]), torsional_damping = (0.1, 0.2, 0.05) [N*m*s/rad]);
        bushing grip:  bushing(lever.hand, cabin.foot, stiffness [N/m] = 40, torsional_stiffness = 2 [N*m/rad], torsional_damping = 0.01 [N*m*s/rad]);
        bushing stay:  bushing(lever.end, ground(0.1 [m], 0.02 [m] * sin(2 [rad/s] * time), 0), stiffness = (0, 30, 20) [N/m], damping = (1, 2, 3) [N*s/m],
                               torsional_stiffness = 0);
        start { cabin.orientation = (0.98, 0.1, -0.1, 0.05); cabin.rate.x [rad/s] = 0.5; hinge.angle [rad] = 0.3; hinge.rate [rad/s] = 1; }
        expect { degrees_of_freedom = 7; }
        output loss [W] = power(stand) + power(grip);
    }
}
