//! Memories and the events that set them: beside gates of contacts that are held, rigid contacts, and dry friction in joints.

linkwright::mechanism! {
    /// A sampled controller holds the force on one slider; a latch catches another, which has a stop and remembers how it was caught; a pendulum
    /// counts its swings. The bolt is thrown back once.
    pub planar Remembering {
        param target [m] = 0.2;
        param stiffness [N/m] = 200;
        input pull [N];
        gravity [m/s^2] = (0, -9.81);
        body slider { mass [kg] = 2; inertia [kg*m^2] = 0.01; }
        body bolt { mass [kg] = 2; inertia [kg*m^2] = 0.02; }
        rod pendulum { mass [kg] = 0.5; length [m] = 0.6; }
        joint rail: prismatic(ground(0, 1) [m], slider.origin, axis = (1, 0));
        joint bore: prismatic(ground(0, 2) [m], bolt.origin, axis = (1, 0));
        joint pivot: revolute(ground(1, 0) [m], pendulum.start);
        memory held [N] = 0;
        memory sum [m*s] = 0.01;
        memory before [mm] = 50;
        memory engaged = 0;
        memory touched [m/s] = 0;
        memory swings = 0;
        memory most [N] = 0;
        signal error [m] = target - rail.travel;
        event tick: every 10 [ms] {
            held = 50 [N/m]*error + 20 [N/(m*s)]*sum - 15 [N*s/m]*(rail.travel - before)/0.01 [s];
            sum = sum + error*0.01 [s];
            before = rail.travel;
        }
        event latch: bore.travel rises 0.1 [m] { engaged = 1; touched = bore.speed; }
        event off: bore.travel falls 0.1 [m] { engaged = 0; }
        event swing: pivot.angle crosses -90 [deg] { swings = swings + 1; most = max(most, 2 [N*s/rad]*abs(pivot.rate)); }
        event kicked: time rises 1.3 [s] { jump(bore.speed) = 0.1 [m/s] - 0.5*bore.speed; }
        event pushed: time rises 0.6 [s] { most = 2*pull; }
        force motor: along(rail.travel) = held;
        force spring: along(bore.travel) = -stiffness*engaged*(bore.travel - 0.1 [m]);
        limit stop: bore.travel [m] in -0.5..0.4 = kelvin_voigt(stiffness [N/m] = 5000, damping [N*s/m] = 30);
        start { rail.travel [m] = 0.05; rail.speed [m/s] = 0.3; bore.travel [m] = 0; bore.speed [m/s] = 0.5;
                pivot.angle [deg] = -60; pivot.rate [rad/s] = 0; }
        options { contact = held; emit = (penalty, projection, null_space, tangent); }
        output place [m] = rail.travel;
        output speed [m/s] = rail.speed;
        output force [N] = held;
        output caught [m] = bore.travel;
        output back [m/s] = bore.speed;
        output impact [m/s] = touched;
        output passes = swings;
        output load [N] = most;
        output summed [m*s] = sum;
    }
}

linkwright::mechanism! {
    /// A puck falls on a floor that rubs, counts its bounces and is blown as it did last; a slider between two rigid stops is driven at ticks, thrown
    /// once and braked by a buffer that yields.
    pub planar RememberingImpacts {
        param share = 0.6 in 0..1;
        input wind [N];
        gravity [m/s^2] = (0, -9.81);
        disk puck { mass [kg] = 0.5; radius [m] = 0.1; }
        body slider { mass [kg] = 2; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 1) [m], slider.origin, axis = (1, 0.2));
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact touch: between(puck.surface, floor) = rigid(restitution = share);
        friction rub: on(touch) = dry(static = 0.5, kinetic = 0.4);
        limit stop: rail.travel [m] in -0.4..0.5 = rigid(restitution = 0.3);
        limit buffer: rail.travel [m] in -0.2..0.6 = kelvin_voigt(stiffness [N/m] = 300, damping [N*s/m] = 4);
        memory bounces = 0;
        memory fast [m/s] = 0;
        memory held [N] = 0;
        event bounce: puck.center.velocity.y rises 0 { bounces = bounces + 1; fast = puck.center.velocity.y; }
        event tick: every 20 [ms] { held = 4 [N] - 9 [N/m]*rail.travel; }
        event thrown: time rises 0.7 [s] { jump(rail.speed) = 0.9 [m/s]; }
        event blown: time rises 0.5 [s] { jump(puck.center.velocity.x) = puck.center.velocity.x + 0.5 [m/s]; }
        force blows: force(puck.center, direction = (1, 0)) = 0.2 [N*s/m]*fast + wind;
        force motor: along(rail.travel) = held;
        start { puck.center.x [m] = 0; puck.center.y [m] = 0.4; puck.center.velocity.x [m/s] = 0.3; puck.center.velocity.y [m/s] = 0;
                puck.angle [rad] = 0; puck.rate [rad/s] = 2; rail.travel [m] = 0; rail.speed [m/s] = -0.5; }
        options { emit = (penalty, projection, null_space); }
        output height [m] = puck.center.y;
        output place [m] = rail.travel;
        output count = bounces;
        output speed [m/s] = fast;
        output forces [N] = touch.force + stop.force + buffer.force + rub.force;
    }
}

linkwright::mechanism! {
    /// Two arms on pins that stick, driven by what ticks set, and a slider that is thrown once and let go as it stands.
    pub planar RememberingBrakes {
        param grip = 0.5 in 0..2;
        input push [N];
        gravity [m/s^2] = (0, -9.81);
        rod upper { mass [kg] = 1; length [m] = 0.5; }
        rod lower { mass [kg] = 0.6; length [m] = 0.4; }
        body slider { mass [kg] = 2; inertia [kg*m^2] = 0.01; }
        joint shoulder: revolute(ground(0, 0) [m], upper.start);
        joint elbow: revolute(upper.end, lower.start);
        joint rail: prismatic(ground(0, 1) [m], slider.origin, axis = (1, 0));
        friction drum: on(shoulder) = dry(static = grip, kinetic = 0.4, radius [m] = 0.05, torque [N*m] = 1);
        friction band: on(elbow) = dry(static = 0.6, kinetic = 0.5, radius [m] = 0.04);
        friction shoe: on(rail) = dry(static = 0.5, kinetic = 0.4);
        memory held [N*m] = 0;
        memory stops = 0;
        event tick: every 15 [ms] { held = -6 [N*m/rad]*shoulder.angle; }
        event stands: rail.speed falls 0.01 [m/s] { stops = stops + 1; }
        event thrown: time rises 0.4 [s] { jump(rail.speed) = 0.8 [m/s]; }
        event struck: time rises 0.6 [s] { jump(shoulder.rate) = 3 [rad/s]; }
        torque motor: along(shoulder.angle) = held;
        force pull: along(rail.travel) = push + 2 [N]*stops;
        start { shoulder.angle [deg] = -40; shoulder.rate [rad/s] = 0; elbow.angle [deg] = -20; elbow.rate [rad/s] = 0; rail.travel [m] = 0; rail.speed [m/s] = 0; }
        options { emit = (penalty, projection, null_space); }
        output torque [N*m] = drum.torque + band.torque;
        output force [N] = shoe.force;
        output place [m] = rail.travel;
        output count = stops;
        output turned [rad] = shoulder.angle;
    }
}

linkwright::mechanism! {
    /// A ball on a floor, an arm that strikes it and its own stop, all with the speed of each touch, and one that adheres.
    #[allow(penetration)]
    pub planar RememberingTouches {
        gravity [m/s^2] = (0, -9.81);
        material rubber { modulus [Pa] = 3e3; poisson = 0.4; }
        disk ball { mass [kg] = 1; radius [m] = 0.2; }
        rod arm { mass [kg] = 0.5; length [m] = 0.6; surface tip: circle(arm.end, radius [m] = 0.1); }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0.05) [m]));
        joint pivot: revolute(ground(0, 0.8) [m], arm.start);
        contact lands: between(ball.surface, floor) = hunt_crossley(force [N] = 60, depth [m] = 0.1, restitution = 0.7, speed = touch, slowest [m/s] = 0.2);
        contact knocks: between(ball.surface, arm.tip) = hertz(first = rubber, second = rubber, restitution = 0.5, speed = touch);
        contact lies: between(arm.tip, floor) = kelvin_voigt(stiffness [N/m] = 80, damping [N*s/m] = 3, adhesion = on);
        limit stops: pivot.angle [rad] in -1.2..0.2 = hunt_crossley(force [N*m] = 9, depth [rad] = 0.3, restitution = 0.8, speed = touch);
        start { ball.center.x [m] = 0.75; ball.center.y [m] = 0.5; ball.angle [rad] = 0; ball.center.velocity.y [m/s] = 1; pivot.angle [rad] = 0; pivot.rate [rad/s] = 1; }
        options { contact = held; emit = (penalty, projection, null_space, tangent); }
        output struck [m/s] = knocks.speed + lands.speed;
        output turned [rad/s] = stops.speed;
        output lost [W] = power(lands) + power(knocks) + power(stops);
    }
}
