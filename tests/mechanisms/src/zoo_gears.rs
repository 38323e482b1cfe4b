//! Mechanisms with teeth: pairs in both orders, on the ground and on carriers, shifted and helical, in the plane and in space.

linkwright::mechanism! {
    /// A lever that carries an idler between a ring, which turns, and a wheel; a shifted pair; a ring that comes first.
    pub planar Toothed {
        param heavy [kg] = 2 in 0.1..10;
        input twist [N*m];
        input brake [N*m];
        gravity [m/s^2] = (0, -9.81);
        body lever { mass = heavy; inertia [kg*m^2] = 0.02; center [mm] = (10, 5);
                     point hub [mm] = (0, 0); point pin [mm] = (21.65063509461097, 12.5); }
        body ring  { mass [kg] = 3; inertia [kg*m^2] = 0.04; toothing inside: internal(teeth = 75, module [mm] = 2, first [deg] = 3);
                     #[allow(teeth)] toothing outside: external(teeth = 90, module [mm] = 2, first [deg] = -1); point seat [mm] = (0, 0); }
        disk idler { mass [kg] = 0.6; radius [mm] = 48; toothing rim: external(teeth = 50, module [mm] = 2, first [deg] = 7); }
        body side  { mass [kg] = 0.4; inertia [kg*m^2] = 3e-4; center [mm] = (1, -2); point eye [mm] = (0, 3);
                     toothing rim: external(teeth = 21, module [mm] = 2, at = side.eye); toothing spur: external(teeth = 17, module [mm] = 3, shift = 0.4, at = side.eye); }
        disk last  { mass [kg] = 0.9; radius [mm] = 40; toothing rim: external(teeth = 29, module [mm] = 3, shift = 0.25, first [rad] = 0.1); }
        joint main:  revolute(ground(0, 0) [mm], lever.hub);
        joint outer: revolute(lever.hub, ring.seat);
        joint bolt:  revolute(idler.center, lever.pin);
        joint axle:  revolute(ground(111, 0) [mm], side.eye);
        joint end:   revolute(last.center, ground(111, 70.788869) [mm]);
        gear inner:  gear(ring.inside, idler.rim);
        gear train:  gear(side.rim, ring.outside);
        gear shifted: gear(side.spur, last.rim);
        torque drive: torque(main) = twist;
        torque hold:  torque(last) = -brake;
        start { main.angle [rad] = 0.3; main.rate [rad/s] = 0.7; outer.rate [rad/s] = -0.4; }
        options { emit = (penalty, projection, null_space, tangent); }
        output idler_rate [rad/s] = idler.rate;
    }
}

linkwright::mechanism! {
    /// A planetary set in space about a slanted axis, one of its wheels helical with another on the ground.
    pub spatial Epicycle {
        input twist [N*m];
        gravity [m/s^2] = (0, 0, -9.81);
        body arm { mass [kg] = 0.7; inertia [kg*m^2] = (2e-3, 2e-3, 3e-3); point pin [mm] = (60, 0, 0); }
        cylinder sun  { mass [kg] = 1; radius [mm] = 40; length [mm] = 20; toothing rim: external(teeth = 40, module [mm] = 2);
                        toothing slant: external(teeth = 30, module [mm] = 2, helix [deg] = 20, face_width [mm] = 25); }
        cylinder planet { mass [kg] = 0.3; radius [mm] = 20; length [mm] = 20; toothing rim: external(teeth = 20, module [mm] = 2, first [deg] = 5); }
        body ring { mass [kg] = 2; inertia [kg*m^2] = (0.02, 0.02, 0.03); toothing rim: internal(teeth = 80, module [mm] = 2); }
        cylinder pinion { mass [kg] = 0.5; radius [mm] = 20; length [mm] = 25; toothing rim: external(teeth = 20, module [mm] = 2, helix [deg] = -20); }
        joint main:   revolute(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1));
        joint axle:   revolute(arm.origin, sun.center, axis = (0, 0, -1));
        joint bolt:   revolute(planet.center, arm.pin, axis = (0, 0, 1));
        joint rim:    revolute(arm.origin, ring.center, axis = (0, 0, 2));
        joint side:   revolute(ground(0 [mm], 50*2/(2*cos(20 [deg]))*1 [mm], 0 [mm]), pinion.center, axis = (0, 0, 1));
        gear inner: gear(planet.rim, sun.rim);
        gear outer: gear(ring.rim, planet.rim);
        gear third: gear(pinion.rim, sun.slant);
        torque drive: torque(main) = twist;
        start { main.angle [rad] = 0.4; main.rate [rad/s] = 0.6; axle.rate [rad/s] = -0.8; }
        options { emit = (penalty, projection, null_space, tangent); }
        output ring_rate [rad/s] = rim.rate;
    }
}

linkwright::mechanism! {
    /// Teeth that give: a lever with an idler between a ring, which turns, and a wheel; gaps, errors, damping in contact and always, laws
    /// and series of stiffness, a ring that comes first, wheels on bodies whose centres are elsewhere.
    pub planar Meshed {
        param stiffness [N/um] = 40 in 1..100;
        param gap [um] = 60 in 0..500;
        input twist [N*m];
        input fault [um];
        gravity [m/s^2] = (0, -9.81);
        body lever { mass [kg] = 2; inertia [kg*m^2] = 0.02; center [mm] = (10, 5);
                     point hub [mm] = (0, 0); point pin [mm] = (21.65063509461097, 12.5); }
        body ring  { mass [kg] = 3; inertia [kg*m^2] = 0.04; toothing inside: internal(teeth = 75, module [mm] = 2, first [deg] = 3, face_width [mm] = 10);
                     #[allow(teeth)] toothing outside: external(teeth = 90, module [mm] = 2, first [deg] = -1, face_width [mm] = 20, bore [mm] = 155); point seat [mm] = (0, 0); }
        disk idler { mass [kg] = 0.6; radius [mm] = 48; toothing rim: external(teeth = 50, module [mm] = 2, first [deg] = 7); }
        body side  { mass [kg] = 0.4; inertia [kg*m^2] = 3e-4; center [mm] = (1, -2); point eye [mm] = (0, 3);
                     toothing rim: external(teeth = 21, module [mm] = 2, at = side.eye, bore [mm] = 12); toothing spur: external(teeth = 17, module [mm] = 3, shift = 0.4, at = side.eye); }
        disk last  { mass [kg] = 0.9; radius [mm] = 40; toothing rim: external(teeth = 29, module [mm] = 3, shift = 0.25, first [rad] = 0.1); }
        body post  { mass [kg] = 0.5; inertia [kg*m^2] = 2e-4; toothing rim: external(teeth = 40, module [mm] = 3); }
        joint main:  revolute(ground(0, 0) [mm], lever.hub);
        joint outer: revolute(lever.hub, ring.seat);
        joint bolt:  revolute(idler.center, lever.pin);
        joint axle:  revolute(ground(111, 0) [mm], side.eye);
        joint end:   revolute(last.center, ground(111, 70.788869) [mm]);
        joint foot:  fixed(ground(111 [mm], 70.788869 [mm] + 104.230979 [mm]), post.center, angle [deg] = 4);
        mesh inner:   mesh(ring.inside, idler.rim, stiffness = involute(young [GPa] = 210, harmonics = 3, entry = 0.1), damping = 300 [N*s/m],
                           error = 4e-6 [m]*cos(3*ring.angle) + fault, error_rate = 0.1 [mm/s], backlash = gap);
        mesh train:   mesh(side.rim, ring.outside, stiffness = involute(young [GPa] = 206, poisson = 0.29, tooth = profile, harmonics = 5),
                           damping_ratio = 0.05, backlash [mm] = 0.04, error = 5 [um]*sin(side.angle)*cos(40 [rad/s]*time));
        mesh shifted: mesh(last.rim, side.spur, stiffness = stiffness, damping = always(200 [N*s/m]), backlash = 0.3*gap);
        mesh still:   mesh(post.rim, last.rim, stiffness = 2e7 [N/m]*(1 + 0.2*cos(29*last.angle)), damping [N*s/m] = 100);
        shaft wound: shaft(axle, main, ratio = -0.5, stiffness [N*m] = 30, damping [N*m*s] = 0.2, backlash [rad] = 0.05);
        torque drive: torque(main) = twist;
        start { main.angle [rad] = 0.3; main.rate [rad/s] = 0.7; outer.rate [rad/s] = -0.4; }
        options { emit = (penalty, projection, null_space, tangent); }
        output twisted [N*m] = wound.torque;
        output pressed [N] = inner.force;
        output turned [um] = train.deflection;
        output phase [1] = train.phase;
        output pairs [1] = inner.pairs;
        output stiff [N/um] = inner.stiffness;
        output lost [W] = power(train) + power(shifted);
    }
}

linkwright::mechanism! {
    /// A lever with a pinion on a rack that slides on it, turned and fixed to a slide, and a carriage whose pinion rolls below a rack at rest.
    pub planar Racked {
        input twist [N*m];
        input push [N];
        gravity [m/s^2] = (0, -9.81);
        body lever { mass [kg] = 2; inertia [kg*m^2] = 0.02; center [mm] = (10, 5); point hub [mm] = (0, 0); point pin [mm] = (60, 23); point seat [mm] = (0, 2); }
        body pinion { mass [kg] = 0.3; inertia [kg*m^2] = 1e-4; center [mm] = (1, 0); point eye [mm] = (0, 2);
                      toothing rim: external(teeth = 20, module [mm] = 2, shift = 0.5, first [deg] = 4, at = pinion.eye); }
        body slide { mass [kg] = 0.2; inertia [kg*m^2] = 1e-4; center [mm] = (3, 1); point pad [mm] = (0, 1); }
        body bar { mass [kg] = 0.8; inertia [kg*m^2] = 1e-3; point near [mm] = (0, 0); point far = (0.1 [m]*cos(0.2 [rad]), -0.1 [m]*sin(0.2 [rad]));
                   line pitch = (bar.near, bar.far); toothing teeth: rack(module [mm] = 2, line = bar.pitch); }
        body carriage { mass [kg] = 1.5; inertia [kg*m^2] = 0.01; point pin [mm] = (5, -8); }
        disk roller { mass [kg] = 0.4; radius [mm] = 27; toothing rim: external(teeth = 18, module [mm] = 3, first [rad] = -0.2); }
        body rail { mass [kg] = 9; inertia [kg*m^2] = 1; point from [m] = (1, 0); point to [m] = (0, 0); line pitch = (rail.from, rail.to);
                    toothing teeth: rack(module [mm] = 3, line = rail.pitch); }
        joint main:  revolute(ground(0, 0) [mm], lever.hub);
        joint bolt:  revolute(pinion.eye, lever.pin);
        joint guide: prismatic(lever.seat, slide.pad, axis = (2, 0), angle [rad] = 0.3);
        joint held:  fixed(slide.pad, bar.near, angle [rad] = -0.1);
        joint floor: fixed(ground(-0.5, 0.4) [m], rail.to);
        joint way:   prismatic(carriage.origin, ground(0 [m], 0.4 [m] + 8 [mm] - 27 [mm]), axis = (-1, 0));
        joint axle:  revolute(carriage.pin, roller.center);
        gear drive: gear(bar.teeth, pinion.rim);
        gear roll:  gear(roller.rim, rail.teeth);
        torque turn: torque(main) = twist;
        force pull: force(way) = push;
        start { main.angle [rad] = 0.4; main.rate [rad/s] = 0.3; guide.speed [m/s] = 0.05; axle.angle [rad] = 0.7; axle.rate [rad/s] = -2; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pinion_rate [rad/s] = bolt.rate;
    }
}

linkwright::mechanism! {
    /// An arm that carries two cones whose axes cross at 70 degrees, one turned round, a left-hand worm that its wheel drives, and a pinion on a rack.
    pub spatial Coned {
        const AXES [deg] = 70;
        const FIRST [rad] = atan2(sin(AXES), 31/18 + cos(AXES));
        const SECOND [rad] = AXES - FIRST;
        const NEAR [cm] = 18 [cm]/tan(FIRST);
        const FAR [cm] = 31 [cm]/tan(SECOND);
        const LEAD [rad] = atan2(4, 30);
        input twist [N*m];
        gravity [m/s^2] = (0, 0, -9.81);
        body arm { mass [kg] = 1.2; inertia [kg*m^2] = (4e-3, 5e-3, 3e-3); point hub [cm] = (5, 0, 0); point near [m] = (NEAR, 0, 0); point far [m] = (FAR*cos(AXES), 0, FAR*sin(AXES));
                   point wheel [cm] = (100, 10, 0); point screw [cm] = (155, 10, 7); point seat [cm] = (30, 17, -10); }
        body one { mass [kg] = 0.4; inertia [kg*m^2] = (1e-4, 2e-4, 1.5e-4); toothing rim: bevel(teeth = 18, module [cm] = 2, cone = FIRST, first [deg] = 5);
                   toothing spur: external(teeth = 20, module [cm] = 2, first [deg] = -2); }
        body two { mass [kg] = 0.7; inertia [kg*m^2] = (4e-4, 3e-4, 5e-4); toothing rim: bevel(teeth = 31, module [cm] = 2, cone = SECOND); }
        body wheel { mass [kg] = 0.6; inertia [kg*m^2] = (3e-4, 5e-4, 3e-4);
                     toothing rim: external(teeth = 40, module = 2 [cm]*cos(LEAD), helix = -LEAD, first [deg] = 3); }
        body screw { mass [kg] = 0.3; inertia [kg*m^2] = (5e-5, 5e-5, 2e-5); toothing thread: worm(starts = 2, module [cm] = 2, diameter [cm] = 30, first [rad] = 0.4); }
        body bar { mass [kg] = 0.5; inertia [kg*m^2] = (1e-3, 1e-3, 1e-4); point low [cm] = (0, 3, -90); point high [cm] = (0, 3, 90); line pitch = (bar.low, bar.high);
                   toothing teeth: rack(module [cm] = 2, line = bar.pitch); }
        joint main:  revolute(ground(0, 0, 0) [m], arm.hub, axis = (0.3, -0.2, 1));
        joint small: revolute(one.center, arm.near, axis = (-1, 0, 0));
        joint large: revolute(arm.far, two.center, axis = (cos(AXES), 0, sin(AXES)));
        joint hub:   revolute(arm.wheel, wheel.center, axis = (0, 1, 0));
        joint bed:   revolute(arm.screw, screw.center, axis = (0, 0, -1));
        joint guide: prismatic(bar.center, arm.seat, axis = (0, 0, 1));
        gear cones: gear(one.rim, two.rim);
        gear worm:  gear(wheel.rim, screw.thread);
        gear drive: gear(bar.teeth, one.spur);
        torque turn: torque(small) = twist;
        start { main.angle [rad] = 0.4; main.rate [rad/s] = 0.6; small.rate [rad/s] = -0.8; hub.rate [rad/s] = 0.2; }
        options { emit = (penalty, projection, null_space, tangent); }
        output turned [rad/s] = large.rate;
    }
}

linkwright::mechanism! {
    /// Teeth on axes that move, as large as the places that a state may have: a pinion on a slide and a ring that floats beside a wheel, in both orders; gaps,
    /// errors, damping, shifts, stiffness that is stored, by a law and by shape, and a wheel that does not turn.
    pub planar Floated {
        param gap [mm] = 6 in 0..20;
        input fault [mm];
        gravity [m/s^2] = (0, -9.81);
        body lever { mass [kg] = 2; inertia [kg*m^2] = 0.5; center [m] = (0.1, 0.05); point hub [m] = (0, 0); point pin [m] = (2.6, 0.25); point tie [m] = (1.55, 2.27); }
        body block { mass [kg] = 1; inertia [kg*m^2] = 0.2; point seat [m] = (0, 0.1); }
        body pinion { mass [kg] = 3; inertia [kg*m^2] = 0.6; center [m] = (0.1, 0.2); point eye [m] = (0, 0.3);
                      toothing rim: external(teeth = 20, module [cm] = 10, shift = 0.3, first [deg] = 4, face_width [cm] = 50, at = pinion.eye); }
        body wheel { mass [kg] = 4; inertia [kg*m^2] = 1.4; toothing rim: external(teeth = 30, module [cm] = 10, first [rad] = 0.2, face_width [cm] = 60); }
        body ring  { mass [kg] = 5; inertia [kg*m^2] = 9; toothing inside: internal(teeth = 75, module [cm] = 10, shift = 0.2, first [deg] = 3); }
        body post  { mass [kg] = 1; inertia [kg*m^2] = 1; toothing rim: external(teeth = 25, module [cm] = 10); }
        joint main:  revolute(ground(0, 0) [m], lever.hub);
        joint guide: prismatic(lever.hub, block.seat, axis = (1, 0.5));
        joint bolt:  revolute(block.center, pinion.eye);
        joint hinge: revolute(lever.pin, wheel.center);
        joint held:  fixed(ground(0.09, -2.33) [m], post.center, angle [deg] = 7);
        bushing hung: bushing(lever.tie, ring.center, stiffness [N/m] = 800, damping [N*s/m] = 5, torsional_stiffness [N*m] = 40, torsional_damping [N*m*s] = 1);
        spring back: spring(lever.hub, block.center, stiffness [N/m] = 900, length [m] = 0.2);
        mesh shaped: mesh(pinion.rim, wheel.rim, stiffness = involute(young [kPa] = 210, harmonics = 3, entry = 0.1), damping = 3 [N*s/m], backlash = gap,
                          error = 4e-3 [m]*cos(3*pinion.angle) + fault, error_rate = 0.1 [m/s], axes = moving);
        mesh stored: mesh(ring.inside, wheel.rim, stiffness [N/m] = 700, backlash [mm] = 10, axes = moving);
        mesh second: mesh(pinion.rim, ring.inside, stiffness = 300 [N/m]*(1 + 0.2*cos(20*pinion.angle)), damping = 2 [N*s/m], sense = -1, axes = moving);
        mesh still:  mesh(post.rim, pinion.rim, stiffness = involute(young [kPa] = 150, tooth = section, harmonics = 2), damping_ratio = 0.1, axes = moving);
        mesh first:  mesh(ring.inside, pinion.rim, stiffness = involute(young [kPa] = 90, harmonics = 2), sense = -1, axes = moving);
        start { main.angle [rad] = 0.1; main.rate [rad/s] = 0.7; hinge.rate [rad/s] = -0.4; ring.center.x [m] = 1.32; ring.center.y [m] = 2.41; guide.travel [m] = 0.1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = shaped.force;
        output turned [mm] = stored.deflection;
        output phase [1] = shaped.phase;
        output other_phase [1] = first.phase;
        output pairs [1] = shaped.pairs;
        output stiff [N/m] = first.stiffness;
        output lost [W] = power(shaped) + power(second);
        output all [J] = energy;
    }
}

linkwright::mechanism! {
    /// Teeth that give in space, on an arm with a slanted axle: a sun on an axle turned round, a planet, a ring that comes first and one that comes second, slanted teeth of both
    /// hands.
    pub spatial Helical {
        const TURN [rad] = 0.4;
        const HELIX [rad] = 0.3;
        param stiffness [N/m] = 5e3 in 1e3..1e5;
        input twist [N*m];
        gravity [m/s^2] = (0, 0, -9.81);
        body arm { mass [kg] = 3; inertia [kg*m^2] = (0.3, 0.2, 0.4); center [m] = (0.1, 0, 0.05); point hub [m] = (0, 0, 0);
                   point pin = (90 [cm]*cos(TURN), 72 [cm]*sin(TURN), -54 [cm]*sin(TURN));
                   point side = (-60 [cm]/cos(HELIX), 3 [cm], 4 [cm]); }
        #[allow(teeth)]
        body sun { mass [kg] = 2; inertia [kg*m^2] = (0.2, 0.25, 0.3); products [kg*m^2] = (0.02, -0.01, 0.03);
                   toothing rim: external(teeth = 24, module [cm] = 5, face_width [cm] = 30);
                   toothing slant: external(teeth = 14, module [cm] = 5, helix = HELIX, face_width [cm] = 40, first [deg] = 6); }
        #[allow(teeth)]
        body planet { mass [kg] = 0.5; inertia [kg*m^2] = (0.02, 0.03, 0.02); center [m] = (0.01, 0.02, 0); point eye [m] = (0, 0, 0);
                      toothing rim: external(teeth = 12, module [cm] = 5, face_width [cm] = 30, first [deg] = 5, at = planet.eye); }
        body ring { mass [kg] = 4; inertia [kg*m^2] = (0.8, 0.9, 1); toothing inside: internal(teeth = 48, module [cm] = 5, face_width [cm] = 25, first [rad] = 0.1); }
        #[allow(teeth)]
        body last { mass [kg] = 1; inertia [kg*m^2] = (0.05, 0.04, 0.05); toothing rim: external(teeth = 10, module [cm] = 5, helix = -HELIX, face_width [cm] = 45); }
        joint main: revolute(ground(0, 0, 0) [m], arm.hub, axis = (0.3, -0.2, 1));
        joint axle: revolute(sun.center, arm.hub, axis = (0, -3, -4));
        joint bolt: revolute(arm.pin, planet.eye, axis = (0, 3, 4));
        joint rim:  revolute(arm.hub, ring.center, axis = (0, 3, 4));
        joint end:  revolute(arm.side, last.center, axis = (0, 6, 8));
        #[allow(teeth)]
        mesh inner: mesh(sun.rim, planet.rim, stiffness = involute(young [MPa] = 2, tooth = section, harmonics = 3), damping_ratio = 0.1, backlash [mm] = 4);
        #[allow(teeth)]
        mesh outer: mesh(ring.inside, planet.rim, stiffness = involute(young [MPa] = 1, tooth = section, harmonics = 2), damping = always(20 [N*s/m]), backlash [mm] = 3, sense = -1);
        #[allow(teeth)]
        mesh again: mesh(planet.rim, ring.inside, stiffness = stiffness, error = 3 [mm]*cos(bolt.angle));
        #[allow(teeth)]
        mesh slant: mesh(last.rim, sun.slant, stiffness = involute(young [MPa] = 1, harmonics = 3), damping = 9 [N*s/m], backlash [mm] = 2);
        torque drive: torque(main) = twist;
        start { main.angle [rad] = 0.4; main.rate [rad/s] = 0.6; axle.rate [rad/s] = -0.8; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = inner.force;
        output along [N] = end.reaction.z;
        output phase [1] = inner.phase;
        output other_phase [1] = outer.phase;
        output pairs [1] = outer.pairs;
        output stiff [N/m] = slant.stiffness;
        output lost [W] = power(outer) + power(slant);
    }
}
