//! Mechanisms that touch: every pair of surfaces in the plane and in space, every law of contacts, gaps by expressions, limits. They
//! begin inside of each other, so that what compares them near their start sees forces.

linkwright::mechanism! {
    /// A ball in a frame with a bore, a wall, a bar and a block, beside an arm between stops and a bead.
    #[allow(penetration)]
    pub planar Touching {
        param stiffness [N/m] = 300;
        param bar [mm] = 50;
        param least [rad] = -1;
        gravity [m/s^2] = (0, -9.81);
        table foam(way [m]) [N] = [(0, 0), (0.3, 20), (1, 90)], linear;
        material rubber { modulus [Pa] = 2e3; poisson = 0.45; }
        material wood { modulus [kPa] = 5; poisson = 0.3; }
        signal beak [m] = 0.3 [m] + bead.center.x - 0.2 [m]*arm.angle/1 [rad];
        disk ball { mass [kg] = 1; radius [m] = 0.3; }
        particle bead { mass [kg] = 0.4; }
        rod arm { mass [kg] = 0.5; length [m] = 0.6; surface tip: point(arm.end); }
        body frame {
            mass [kg] = 2; inertia [kg*m^2] = 0.3; center [m] = (0.02, -0.03);
            point a [m] = (-0.5, -0.6); point b [m] = (0.5, -0.6); point c [m] = (-0.8, 0.7); point d [m] = (0.8, 0.75);
            point e [m] = (0.25, -0.1); point f [m] = (1.1, 0); point g [m] = (0.8, 0.3);
            line top = (frame.d, frame.c);
            surface bore: hole(frame.center, radius [m] = 0.31);
            surface wall: half_plane(frame.top, side = right);
            surface bar: segment(frame.a, frame.b, radius = bar);
            surface edge: segment(frame.c, frame.g, radius [m] = 1.6);
            surface block: polygon(frame.e, frame.f, frame.g);
        }
        surface floor: half_plane(line(ground(0, 0.3) [m], ground(1, 0.25) [m]));
        surface drop: circle(bead.center, radius [m] = 1);
        joint pivot: revolute(ground(1.6, 0.1) [m], arm.start);
        contact inside: between(ball.surface, frame.bore) = hertz(first = rubber, second = wood, restitution = 0.7, speed [m/s] = 1);
        contact lands: between(floor, ball.surface) = kelvin_voigt(stiffness = stiffness, damping [N*s/m] = 6, release = 0.4);
        contact tips: between(arm.tip, frame.wall) = hunt_crossley(force [N] = 40, depth [mm] = 200, exponent = 1.7, dissipation [s/m] = 0.3);
        contact hits: between(ball.surface, drop) = hunt_crossley(force [N] = 30, depth [mm] = 100, restitution = 0.4, speed [m/s] = 2, damping = flores);
        contact slides: between(drop, frame.bar) = foam(slides.depth) + 4 [N*s/m]*slides.closing;
        contact grazes: between(arm.tip, frame.edge) = kelvin_voigt(stiffness [N/m] = 70);
        contact lies: between(frame.bar, floor) = 200 [N/m]*lies.depth*(1 + 0.2 [s/m]*lies.closing);
        contact stands: between(frame.block, floor) = kelvin_voigt(stiffness [N/m] = 150, damping [N*s/m] = 5);
        contact corner: between(drop, frame.block) = hunt_crossley(force [N] = 50, depth [mm] = 100, exponent = 2, dissipation [s/m] = 0.5);
        contact sits: between(ball.surface, frame.block) = kelvin_voigt(stiffness [N/m] = 90, damping [N*s/m] = 3);
        contact pecks: gap(beak) = kelvin_voigt(stiffness [N/m] = 100, damping [N*s/m] = 2);
        limit stops: pivot.angle in least..1.2 [rad] = kelvin_voigt(stiffness [N*m/rad] = 40, damping [N*m*s/rad] = 2);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.2; bead.center.x [m] = -0.7; bead.center.y [m] = 0.1;
                frame.center.x [m] = 0; frame.center.y [m] = 0.25; pivot.angle [rad] = 1.3; pivot.rate [rad/s] = 1; ball.center.velocity.x [m/s] = 1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = inside.force + lies.force;
        output gap [m] = stands.gap;
        output depth [m] = slides.depth;
        output closing [m/s] = tips.closing;
        output at_x [m] = inside.point.x;
        output lies_x [m] = lies.point.x;
        output hits_y [m] = hits.point.y;
        output grazes_y [m] = grazes.point.y;
        output stopped [N*m] = stops.force;
        output lost [W] = power(lands) + power(stands) + power(stops);
        output out_y [m] = sits.point.y;
    }
}

linkwright::mechanism! {
    /// Balls about a block with a tilted plane, a socket, a bore, a column and a rail, beside a coin on a table.
    #[allow(penetration)]
    pub spatial Bumping {
        param stiffness [N/m] = 200;
        param hole [m] = 0.3;
        gravity [m/s^2] = (0, 0, -9.81);
        material rubber { modulus [Pa] = 3e3; poisson = 0.4; }
        sphere ball { mass [kg] = 1; radius [m] = 0.2; }
        sphere marble { mass [kg] = 0.3; radius [m] = 0.7; }
        body coin { mass [kg] = 0.5; inertia [kg*m^2] = (0.02, 0.02, 0.04);
                    surface rim: disk_rim(coin.center, axis = (0.2, 0.1, 1), radius [m] = 0.4); }
        #[allow(outside)]
        box block {
            mass [kg] = 3; size [m] = (1, 0.8, 0.6);
            marker top [m] = (0.1, 0.2, 0), axis = (0.3, -0.2, 1);
            point left [m] = (-0.5, 0.1, 0.2); point right [m] = (0.4, 0.9, 0.1);
            surface slope: plane(block.top);
            surface socket: ball_socket(block.center, radius = hole);
            surface rail: capsule(block.left, block.right, radius [m] = 0.3);
            surface column: cylinder(block.left, axis = (0.1, 0.2, 1), radius [m] = 0.5, length [m] = 0.8);
            surface post: cylinder(block.right, axis = (1, 0, 0.5), radius [m] = 0.8);
            surface tube: bore(block.center, axis = (0, 0.3, 1), radius [m] = 0.25, length [m] = 1.4);
        }
        rod arm { mass [kg] = 0.5; length [m] = 0.5; radius [mm] = 20; surface tip: point(arm.end); }
        surface ground_plane: plane(ground(0, 0, 0.5) [m], axis = (0.1, 0, 1));
        joint hinge: revolute(block.right, arm.start, axis = (0, 1, 0));
        contact rolls: between(ball.surface, block.slope) = hertz(first = rubber, second = rubber, dissipation [s/m] = 0.4);
        contact knocks: between(marble.surface, ball.surface) = hertz(first = rubber, second = rubber, restitution = 0.6, speed [m/s] = 1, damping = lankarani_nikravesh);
        contact seated: between(ball.surface, block.socket) = kelvin_voigt(stiffness = stiffness, damping [N*s/m] = 4);
        contact rails: between(marble.surface, block.rail) = hunt_crossley(force [N] = 30, depth [m] = 0.1, restitution = 0.5, speed [m/s] = 1, damping = hunt_crossley);
        contact columns: between(block.column, marble.surface) = kelvin_voigt(stiffness [N/m] = 80, damping [N*s/m] = 1);
        contact posts: between(ball.surface, block.post) = kelvin_voigt(stiffness [N/m] = 60, damping [N*s/m] = 1);
        contact tubed: between(ball.surface, block.tube) = kelvin_voigt(stiffness [N/m] = 50, damping [N*s/m] = 1);
        contact falls: between(block.rail, ground_plane) = hunt_crossley(force [N] = 100, depth [m] = 0.1, exponent = 1, dissipation [s/m] = 0.5);
        contact spins: between(coin.rim, ground_plane) = kelvin_voigt(stiffness [N/m] = 90, damping [N*s/m] = 2);
        contact pokes: between(arm.tip, ground_plane) = hunt_crossley(force [N] = 60, depth [m] = 0.1, restitution = 0.8, speed [m/s] = 1);
        limit swing: hinge.angle [deg] in -50..40 = hunt_crossley(force [N*m] = 5, depth [deg] = 10, dissipation [s/rad] = 0.5);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.1; ball.center.z [m] = 0.1; marble.center.x [m] = 0.5; marble.center.y [m] = 0; marble.center.z [m] = 0.6;
                coin.center.x [m] = 2; coin.center.y [m] = 0; coin.center.z [m] = 0.2; block.center.x [m] = 0; block.center.y [m] = 0; block.center.z [m] = 0.2;
                hinge.angle [rad] = 0.8; hinge.rate [rad/s] = -1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output rolled [N] = rolls.force;
        output rolls_z [m] = rolls.point.z;
        output knocks_x [m] = knocks.point.x;
        output seated_y [m] = seated.point.y;
        output rails_z [m] = rails.point.z;
        output falls_x [m] = falls.point.x;
        output spins_x [m] = spins.point.x;
        output spins_z [m] = spins.point.z;
        output open [m] = columns.gap + tubed.gap;
        output posted [m/s] = posts.closing;
        output posted_x [m] = posts.point.x;
        output columned_y [m] = columns.point.y;
    }
}

linkwright::mechanism! {
    /// Rolls along each other and in a bush, a bar that adheres where it lies, and an arm that adheres to its stops.
    #[allow(penetration)]
    pub planar Rolling {
        param wide [m] = 0.3;
        gravity [m/s^2] = (0, -9.81);
        material rubber { modulus [Pa] = 4e3; poisson = 0.4; }
        material cork { modulus [Pa] = 9e3; poisson = 0.1; }
        disk roll { mass [kg] = 1; radius [m] = 0.3; }
        disk wheel { mass [kg] = 2; radius [m] = 0.5; surface bush: hole(wheel.center, radius [m] = 0.34); }
        rod plate { mass [kg] = 2; length [m] = 0.8; surface sole: segment(plate.start, plate.end, radius [m] = 0.05); }
        rod arm { mass [kg] = 0.5; length [m] = 0.6; surface pin: circle(arm.end, radius [m] = 0.3); }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0.1) [m]));
        joint pivot: revolute(ground(0.2, 0.4) [m], arm.start);
        contact along: between(roll.surface, wheel.surface) = hertz_line(first = rubber, second = cork, length = wide, dissipation [s/m] = 0.3);
        contact bushed: between(wheel.bush, arm.pin) = hertz_line(first = cork, second = cork, length [m] = 0.2, restitution = 0.7, speed [m/s] = 2);
        contact sticks: between(plate.sole, floor) = kelvin_voigt(stiffness [N/m] = 90, damping [N*s/m] = 12, release = 0.8, adhesion = on);
        limit clings: pivot.angle [rad] in -1..0.1 = hunt_crossley(force [N*m] = 5, depth [rad] = 0.2, dissipation [s/rad] = 0.9, adhesion = on);
        friction grip: on(along) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction drag: on(sticks) = coulomb(coefficient = 0.2, speed [m/s] = 0.1);
        start { roll.center.x [m] = 0.3; roll.center.y [m] = 1.2; roll.angle [rad] = 0; wheel.center.x [m] = 0.75; wheel.center.y [m] = 0.6; wheel.angle [rad] = 0;
                plate.center.x [m] = -0.4; plate.center.y [m] = 0.03; plate.angle [rad] = 0.1; pivot.angle [rad] = 0.3; pivot.rate [rad/s] = 1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = along.force + bushed.force;
        output held [N] = sticks.force;
        output lost [W] = power(along) + power(sticks) + power(clings) + power(grip);
    }
}

linkwright::mechanism! {
    /// Bars that fall on each other: one hangs, one is free, one is fixed.
    #[allow(penetration)]
    pub spatial Crossing {
        gravity [m/s^2] = (0, 0, -9.81);
        rod swing { mass [kg] = 0.7; length [m] = 0.9; radius [mm] = 30; surface skin: capsule(swing.start, swing.end, radius [m] = 0.1); }
        rod stick { mass [kg] = 0.5; length [m] = 1.1; radius [mm] = 30; surface skin: capsule(stick.start, stick.end, radius [m] = 0.15); }
        surface rail: capsule(ground(-1, 0.2, 0) [m], ground(1, -0.1, 0.1) [m], radius [m] = 0.2);
        joint hook: spherical(ground(0, 0, 1) [m], swing.start);
        contact knocks: between(swing.skin, stick.skin) = kelvin_voigt(stiffness [N/m] = 80, damping [N*s/m] = 2);
        contact lies: between(rail, stick.skin) = hunt_crossley(force [N] = 30, depth [m] = 0.1, dissipation [s/m] = 0.4);
        friction rubs: on(knocks) = coulomb(coefficient = 0.4, speed [m/s] = 0.2);
        friction grips: on(lies) = coulomb(coefficient = 0.2, speed [m/s] = 0.1);
        start { stick.center.x [m] = 0.1; stick.center.y [m] = 0.1; stick.center.z [m] = 0.3; stick.orientation = (0.9, 0.1, 0.4, 0.2);
                swing.orientation = (0.8, 0.1, 0.5, 0); swing.rate.z [rad/s] = 1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output knocked [N] = knocks.force;
        output at_y [m] = knocks.point.y;
        output slides_x [m/s] = lies.sliding.x;
    }
}
