//! Joints that yield, every kind that may, in the plane and in space, between bodies, with the ground, and with particles.

linkwright::mechanism! {
    /// A weld to the ground, a slide, a pin damped along its line, a slot, an Oldham coupling, a bead, and a strut that stands on what shakes.
    pub planar Yielding {
        param stiffness [N/m] = 2000 in 1..1e6;
        param damping [N*s/m] = 10;
        param turning [N*m/rad] = 100;
        gravity [m/s^2] = (0, -9.81);
        body base  { mass [kg] = 1.2; inertia [kg*m^2] = 0.02; center [m] = (0.1, 0.02); point p [m] = (0.3, 0.1); point q [m] = (-0.1, 0.05); }
        body slide { mass [kg] = 0.8; inertia [kg*m^2] = 0.015; center [m] = (0.05, -0.02); point p [m] = (0.2, 0.1); point q [m] = (-0.1, 0.05); }
        body link  { mass [kg] = 0.7; inertia [kg*m^2] = 0.01; point p [m] = (0.2, 0.1); point q [m] = (-0.1, 0.05); line slot = (link.q, link.p); }
        body block { mass [kg] = 0.7; inertia [kg*m^2] = 0.01; point p [m] = (0.2, 0.1); }
        body plate { mass [kg] = 0.9; inertia [kg*m^2] = 0.02; point p [m] = (0.2, 0.1); }
        particle bead { mass [kg] = 0.3; }
        rod strut { mass [kg] = 0.5; length [m] = 0.4; }
        joint weld:  fixed(ground(0.1, 0) [m], base.q, angle [deg] = 20)
            = penalty(stiffness = stiffness, damping = damping, torsional_stiffness = turning, torsional_damping [N*m*s/rad] = 1);
        joint rail:  prismatic(base.p, slide.q, axis = (1, 0.3), angle [deg] = 10)
            = penalty(stiffness = 2*stiffness, damping [N*s/m] = 7, torsional_stiffness = turning);
        joint pin:   revolute(link.q, slide.p) = penalty(stiffness [N/m] = 1500, damping = damping, damping_along = line, smallest [m] = 0.01);
        joint ride:  point_on_line(link.slot, block.p) = penalty(stiffness [N/m] = 900, damping [N*s/m] = 5);
        joint cross: parallel(block.p, plate.p) = penalty(torsional_stiffness [N*m/rad] = 200, torsional_damping [N*m*s/rad] = 0.5);
        joint hang:  revolute(plate.origin, bead.center) = penalty(stiffness [N/m] = 500, damping [N*s/m] = 2);
        joint foot:  revolute(strut.end, ground(0.2 [m]*sin(3 [rad/s]*time), -0.5 [m])) = penalty(stiffness [N/m] = 500, damping [N*s/m] = 4);
        joint head:  revolute(strut.start, plate.p);
        friction rub: on(foot) = coulomb(coefficient = 0.3, radius [m] = 0.02, speed [rad/s] = 0.5);
        torsion_spring coil: torsion_spring(pin, stiffness [N*m/rad] = 2);
        start { plate.angle [deg] ~ 20; rail.travel [m] = 0.1; pin.angle [deg] = 30; ride.angle [deg] = 20; ride.travel [m] = 0.1; strut.angle [deg] = 70; strut.rate [rad/s] = 1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = rail.reaction.normal;
        output turned [N*m] = weld.reaction.torque;
        output taken [W] = pin.power + power(rub);
    }
}

linkwright::mechanism! {
    /// Bodies in space on every joint that may yield, one after the other.
    pub spatial YieldingInSpace {
        param stiffness [N/m] = 2000 in 1..1e6;
        param turning [N*m/rad] = 100;
        gravity [m/s^2] = (0.3, 0, -9.81);
        body a { mass [kg] = 1.2; inertia [kg*m^2] = (0.02, 0.03, 0.04); center [m] = (0.1, 0.02, 0.03); point p [m] = (0.3, 0.1, 0.05); point q [m] = (-0.1, 0.05, 0); }
        body b { mass [kg] = 0.8; inertia [kg*m^2] = (0.015, 0.01, 0.02); point p [m] = (0.2, 0.1, 0); point q [m] = (-0.1, 0.05, 0.02); line bar = (b.p, b.q); }
        body c { mass [kg] = 0.8; inertia [kg*m^2] = (0.015, 0.01, 0.02); center [m] = (0.05, -0.02, 0.01); point p [m] = (0.2, 0.1, 0); point q [m] = (-0.1, 0.05, 0.02); }
        body d { mass [kg] = 0.9; inertia [kg*m^2] = (0.01, 0.014, 0.02); point p [m] = (0.2, 0.1, 0); }
        particle bead { mass [kg] = 0.3; }
        joint weld:  fixed(ground(0.1, 0, 0) [m], a.q)
            = penalty(stiffness = stiffness, damping [N*s/m] = 10, torsional_stiffness = turning, torsional_damping [N*m*s/rad] = 0.2);
        joint rail:  prismatic(a.p, b.q, axis = (1, 0.3, 0)) = penalty(stiffness = stiffness, torsional_stiffness = turning, torsional_damping [N*m*s/rad] = 0.2);
        joint ball:  spherical(c.q, b.p) = penalty(stiffness [N/m] = 1500, damping [N*s/m] = 10, damping_along = line, smallest [m] = 0.01);
        joint ride:  point_on_line(b.bar, d.p) = penalty(stiffness [N/m] = 900, damping [N*s/m] = 5);
        joint table: planar(d.p, c.p, axis = (0, 1, 1)) = penalty(stiffness [N/m] = 700, damping [N*s/m] = 5, torsional_stiffness [N*m/rad] = 90);
        joint plane: point_on_plane(d.origin, bead.center, axis = (1, 0, 0)) = penalty(stiffness [N/m] = 600, damping [N*s/m] = 3);
        start { rail.travel [m] = 0.1; ride.travel [m] = 0.1; bead.center.y [m] = 0.1; bead.center.z [m] = 0.2; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = rail.reaction.z;
        output turned [N*m] = table.reaction.torque.x;
        output taken [W] = ball.power;
    }
}

linkwright::mechanism! {
    /// Shafts on joints that yield: a hinge to the ground, a Cardan joint, a homokinetic one, a sleeve and an Oldham coupling.
    pub spatial YieldingShafts {
        param stiffness [N/m] = 1000 in 1..1e6;
        param turning [N*m/rad] = 10;
        gravity [m/s^2] = (0, 0, -9.81);
        cylinder first  { mass [kg] = 1; radius [m] = 0.08; length [m] = 0.3; }
        cylinder second { mass [kg] = 0.8; radius [m] = 0.08; length [m] = 0.25; }
        cylinder third  { mass [kg] = 0.7; radius [m] = 0.06; length [m] = 0.25; }
        cylinder fourth { mass [kg] = 0.6; radius [m] = 0.06; length [m] = 0.2; }
        cylinder fifth  { mass [kg] = 0.6; radius [m] = 0.06; length [m] = 0.2; }
        joint hinge: revolute(ground(0.1, 0, 0) [m], first.origin, axis = (0, 0.2, 1))
            = penalty(stiffness = stiffness, damping [N*s/m] = 10, torsional_stiffness = turning, torsional_damping [N*m*s/rad] = 0.01);
        joint cross: universal(second.origin, first.center, axis = (1, 0, 0), second_axis = (0, 1, 0))
            = penalty(stiffness = stiffness, damping [N*s/m] = 10, torsional_stiffness = turning, torsional_damping [N*m*s/rad] = 0.01);
        joint ball:  constant_velocity(second.center, third.origin, axis = (0, 0, 1))
            = penalty(stiffness [N/m] = 1500, damping [N*s/m] = 6, torsional_stiffness = turning);
        joint sleeve: cylindrical(third.center, fourth.center, axis = (0, 1, 1)) = penalty(stiffness = stiffness, torsional_stiffness = turning);
        joint slider: parallel(fourth.center, fifth.center) = penalty(torsional_stiffness = turning, torsional_damping [N*m*s/rad] = 0.01);
        spring tie: spring(fourth.center, fifth.center, stiffness [N/m] = 300, length [m] = 0.1);
        start { hinge.angle [deg] ~ 30; first.rate.z [rad/s] = 2; cross.angle_1 [deg] ~ 20; cross.angle_2 [deg] ~ 10; sleeve.angle [deg] ~ 15; sleeve.travel [m] = 0.1;
                slider.travel_1 [m] = 0.1; slider.travel_2 [m] = 0.2; slider.travel_3 [m] = -0.1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = cross.reaction.size;
        output turned [N*m] = ball.reaction.torque.z;
        output taken [W] = hinge.power;
    }
}
