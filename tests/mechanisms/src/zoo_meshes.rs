//! Teeth that give on racks, cones and worms, in both orders, on the ground and on what moves.

linkwright::mechanism! {
    /// A lever with a pinion on a rack that slides on it, turned and fixed to a slide, and a carriage whose pinion rolls below a rack at rest; stiffness by shape, as profiles and
    /// as cantilevers, gaps, an error, damping in contact and always.
    pub planar YieldingRacks {
        param gap [um] = 60 in 0..500;
        input twist [N*m];
        gravity [m/s^2] = (0, -9.81);
        body lever { mass [kg] = 2; inertia [kg*m^2] = 0.02; center [mm] = (10, 5); point hub [mm] = (0, 0); point pin [mm] = (60, 23); point seat [mm] = (0, 2); }
        body pinion { mass [kg] = 0.3; inertia [kg*m^2] = 1e-4; center [mm] = (1, 0); point eye [mm] = (0, 2);
                      toothing rim: external(teeth = 20, module [mm] = 2, shift = 0.5, first [deg] = 4, face_width [mm] = 20, bore [mm] = 14, at = pinion.eye); }
        body slide { mass [kg] = 1.2; inertia [kg*m^2] = 0.5; center [mm] = (3, 1); point pad [mm] = (0, 1); }
        body bar { mass [kg] = 1.8; inertia [kg*m^2] = 0.7; center [mm] = (7, -3); point near [mm] = (0, 0); point far = (0.1 [m]*cos(0.2 [rad]), -0.1 [m]*sin(0.2 [rad]));
                   line pitch = (bar.near, bar.far); toothing teeth: rack(module [mm] = 2, line = bar.pitch, face_width [mm] = 22); }
        body carriage { mass [kg] = 1.5; inertia [kg*m^2] = 0.01; point pin [mm] = (5, -8); }
        disk roller { mass [kg] = 0.4; radius [mm] = 27; toothing rim: external(teeth = 18, module [mm] = 3, first [rad] = -0.2, face_width [mm] = 30); }
        body rail { mass [kg] = 9; inertia [kg*m^2] = 1; point from [m] = (1, 0); point to [m] = (0, 0); line pitch = (rail.from, rail.to);
                    toothing teeth: rack(module [mm] = 3, line = rail.pitch, face_width [mm] = 40); }
        joint main:  revolute(ground(0, 0) [mm], lever.hub);
        joint bolt:  revolute(pinion.eye, lever.pin);
        joint guide: prismatic(lever.seat, slide.pad, axis = (2, 0), angle [rad] = 0.3);
        joint held:  fixed(slide.pad, bar.near, angle [rad] = -0.1);
        joint floor: fixed(ground(-0.5, 0.4) [m], rail.to);
        joint way:   prismatic(carriage.origin, ground(0 [m], 0.4 [m] + 8 [mm] - 27 [mm]), axis = (-1, 0));
        joint axle:  revolute(carriage.pin, roller.center);
        mesh drive: mesh(bar.teeth, pinion.rim, stiffness = involute(young [MPa] = 20, harmonics = 3, entry = 0.1), damping_ratio = 0.1, backlash = gap,
                         error = 4e-6 [m]*cos(3*pinion.angle));
        #[allow(teeth)]
        mesh roll:  mesh(roller.rim, rail.teeth, stiffness = involute(young [MPa] = 10, tooth = section, harmonics = 2), damping = always(300 [N*s/m]), backlash = 0.5*gap, sense = -1);
        torque turn: torque(main) = twist;
        start { main.angle [rad] = 0.4; main.rate [rad/s] = 0.3; guide.speed [m/s] = 0.05; axle.angle [rad] = 0.7; axle.rate [rad/s] = -2; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = drive.force;
        output turned [um] = roll.deflection;
        output phase [1] = drive.phase;
        output other_phase [1] = roll.phase;
        output pairs [1] = roll.pairs;
        output stiff [N/um] = drive.stiffness;
        output lost [W] = power(drive) + power(roll);
    }
}

linkwright::mechanism! {
    /// An arm that carries two cones, one on an axle turned round, a left-hand screw between two wheels of which one is shifted, and a pinion on a rack.
    pub spatial YieldingCones {
        const AXES [deg] = 70;
        const FIRST [rad] = atan2(sin(AXES), 31/18 + cos(AXES));
        const SECOND [rad] = AXES - FIRST;
        const NEAR [cm] = 18 [cm]/tan(FIRST);
        const FAR [cm] = 31 [cm]/tan(SECOND);
        const LEAD [rad] = atan2(4, 30);
        param stiffness [N/m] = 5e3 in 1e3..1e5;
        input twist [N*m];
        gravity [m/s^2] = (0, 0, -9.81);
        body arm { mass [kg] = 4; inertia [kg*m^2] = (0.5, 0.6, 0.7); center [cm] = (3, 2, 1); point hub [cm] = (5, 0, 0); point near [m] = (NEAR, 0, 0);
                   point far [m] = (FAR*cos(AXES), 0, FAR*sin(AXES)); point wheel [cm] = (100, 10, 0); point screw [cm] = (155, 10, 7); point seat [cm] = (30, 17, -10);
                   point last = (210 [cm] + 0.6 [cm]*cos(LEAD), 10 [cm], -4 [cm]); }
        body one { mass [kg] = 1.4; inertia [kg*m^2] = (0.02, 0.03, 0.025); toothing rim: bevel(teeth = 18, module [cm] = 2, cone = FIRST, first [deg] = 5, face_width [cm] = 9);
                   toothing spur: external(teeth = 20, module [cm] = 2, first [deg] = -2, face_width [cm] = 10); }
        body two { mass [kg] = 1.7; inertia [kg*m^2] = (0.04, 0.03, 0.05); center [cm] = (1, 0, 2); point eye [m] = (0, 0, 0);
                   toothing rim: bevel(teeth = 31, module [cm] = 2, cone = SECOND, face_width [cm] = 8, at = two.eye); }
        body wheel { mass [kg] = 1.6; inertia [kg*m^2] = (0.03, 0.05, 0.03); toothing rim: external(teeth = 40, module = 2 [cm]*cos(LEAD), helix = -LEAD, first [deg] = 3); }
        body screw { mass [kg] = 1.3; inertia [kg*m^2] = (0.05, 0.05, 0.02); toothing thread: worm(starts = 2, module [cm] = 2, diameter [cm] = 30, first [rad] = 0.4); }
        body last { mass [kg] = 0.9; inertia [kg*m^2] = (0.03, 0.04, 0.03); toothing rim: external(teeth = 40, module = 2 [cm]*cos(LEAD), helix = -LEAD, shift = 0.3); }
        body bar { mass [kg] = 0.5; inertia [kg*m^2] = (0.1, 0.1, 0.01); center [cm] = (2, 0, 5); point mid [cm] = (0, 0, 0); point low [cm] = (0, 3, -90); point high [cm] = (0, 3, 90);
                   line pitch = (bar.low, bar.high); toothing teeth: rack(module [cm] = 2, line = bar.pitch, face_width [cm] = 12); }
        joint main:  revolute(ground(0, 0, 0) [m], arm.hub, axis = (0.3, -0.2, 1));
        joint small: revolute(one.center, arm.near, axis = (-1, 0, 0));
        joint large: revolute(arm.far, two.eye, axis = (cos(AXES), 0, sin(AXES)));
        joint hub:   revolute(arm.wheel, wheel.center, axis = (0, 1, 0));
        joint bed:   revolute(arm.screw, screw.center, axis = (0, 0, -1));
        joint end:   revolute(last.center, arm.last, axis = (0, -1, 0));
        joint guide: prismatic(bar.mid, arm.seat, axis = (0, 0, 1));
        mesh cones: mesh(one.rim, two.rim, stiffness = involute(young [MPa] = 2, harmonics = 2), damping = 9 [N*s/m], backlash [mm] = 2, error = 1 [mm]*cos(large.angle));
        mesh worm:  mesh(wheel.rim, screw.thread, stiffness = stiffness, damping = always(20 [N*s/m]), backlash [mm] = 3);
        mesh again: mesh(screw.thread, last.rim, stiffness = 2*stiffness, sense = -1);
        mesh drive: mesh(bar.teeth, one.spur, stiffness = involute(young [MPa] = 1, tooth = section, harmonics = 3), damping_ratio = 0.1, backlash [mm] = 1);
        torque turn: torque(small) = twist;
        start { main.angle [rad] = 0.4; main.rate [rad/s] = 0.6; small.rate [rad/s] = -0.8; hub.rate [rad/s] = 0.2; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = cones.force;
        output along [N] = bed.reaction.z;
        output phase [1] = cones.phase;
        output phase_of_worm [1] = worm.phase;
        output phase_again [1] = again.phase;
        output phase_of_rack [1] = drive.phase;
        output pairs [1] = cones.pairs;
        output stiff [N/m] = drive.stiffness;
        output lost [W] = power(cones) + power(worm) + power(drive);
    }
}
