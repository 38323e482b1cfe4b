//! Contacts that rub: every pair of surfaces in the plane and in space, both laws of friction, gaps with a slip of their own, bodies that do not
//! turn. They begin inside of each other and move, so that what compares them near their start sees friction.

linkwright::mechanism! {
    /// A ball in a frame with a bore, a wall, a bar and a block, beside an arm at a stop and a bead.
    #[allow(penetration)]
    pub planar RubbingPairs {
        param grip = 0.3 in 0..1;
        param smooth [m/s] = 0.2;
        gravity [m/s^2] = (0, -9.81);
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
            surface bar: segment(frame.a, frame.b, radius [mm] = 50);
            surface block: polygon(frame.e, frame.f, frame.g);
        }
        surface floor: half_plane(line(ground(0, 0.3) [m], ground(1, 0.25) [m]));
        surface belt: circle(ground(0.2 [m/s]*time, -0.5 [m]), radius [m] = 0.6);
        surface drop: circle(bead.center, radius [m] = 1);
        joint pivot: revolute(ground(1.6, 0.1) [m], arm.start);
        contact inside: between(ball.surface, frame.bore) = kelvin_voigt(stiffness [N/m] = 200, damping [N*s/m] = 2);
        contact lands: between(floor, ball.surface) = kelvin_voigt(stiffness [N/m] = 300, damping [N*s/m] = 6);
        contact tips: between(arm.tip, frame.wall) = hunt_crossley(force [N] = 40, depth [mm] = 200, exponent = 1.7, dissipation [s/m] = 0.3);
        contact hits: between(ball.surface, drop) = hunt_crossley(force [N] = 30, depth [mm] = 100, dissipation [s/m] = 0.1);
        contact slides: between(drop, frame.bar) = 60 [N/m]*slides.depth;
        contact lies: between(frame.bar, floor) = 200 [N/m]*lies.depth*(1 + 0.1 [s/m]*abs(lies.sliding));
        contact stands: between(frame.block, floor) = kelvin_voigt(stiffness [N/m] = 150, damping [N*s/m] = 5);
        contact corner: between(drop, frame.block) = hunt_crossley(force [N] = 50, depth [mm] = 100, exponent = 2, dissipation [s/m] = 0.5);
        contact sits: between(ball.surface, frame.block) = kelvin_voigt(stiffness [N/m] = 90, damping [N*s/m] = 3);
        contact runs: between(ball.surface, belt) = kelvin_voigt(stiffness [N/m] = 80);
        contact pecks: gap(bead.center.x + 0.3 [m], slip = bead.center.y + 0.2 [m]*sin(arm.angle)) = kelvin_voigt(stiffness [N/m] = 100);
        friction f_inside: on(inside) = coulomb(coefficient = grip, speed = smooth);
        friction f_lands: on(lands) = stribeck(static = 0.5, kinetic = 0.3, transition [m/s] = 0.4, speed [m/s] = 0.1, viscous [N*s/m] = 1);
        friction f_tips: on(tips) = coulomb(coefficient = 0.4, speed [m/s] = 0.1);
        friction f_hits: on(hits) = coulomb(coefficient = 0.2 + 0.1*hits.depth/1 [m], speed [m/s] = 0.1);
        friction f_slides: on(slides) = coulomb(coefficient = 0.5, speed [m/s] = 0.1);
        friction f_lies: on(lies) = stribeck(static = 0.6, kinetic = 0.4, transition [m/s] = 1, speed [m/s] = 0.2);
        friction f_stands: on(stands) = coulomb(coefficient = 0.7, speed [m/s] = 0.1);
        friction f_corner: on(corner) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_sits: on(sits) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_runs: on(runs) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_pecks: on(pecks) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_pivot: on(pivot) = coulomb(coefficient = 0.2, radius [mm] = 20, speed [rad/s] = 0.1);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.2; bead.center.x [m] = -0.7; bead.center.y [m] = 0.1;
                frame.center.x [m] = 0; frame.center.y [m] = 0.25; pivot.angle [rad] = 1.3; pivot.rate [rad/s] = 1; ball.center.velocity.x [m/s] = 1;
                frame.rate [rad/s] = 0.7; ball.rate [rad/s] = -2; bead.center.velocity.y [m/s] = -0.5; }
        options { emit = (penalty, projection, null_space, tangent); }
        output sliding [m/s] = lands.sliding;
        output pressed [N] = f_lands.normal;
        output held [N] = f_lands.force + f_stands.force;
        output deepest [m/s] = stands.sliding;
        output along [m/s] = pecks.sliding;
        output lost [W] = -power(f_inside) - power(f_lands) - power(f_lies) - power(f_stands) - power(f_pecks);
    }
}

linkwright::mechanism! {
    /// Balls about a block with a tilted plane, a socket, a bore, a column and a rail, beside a coin on a table.
    #[allow(penetration)]
    pub spatial RubbingBodies {
        param grip = 0.4;
        gravity [m/s^2] = (0, 0, -9.81);
        sphere ball { mass [kg] = 1; radius [m] = 0.2; }
        sphere marble { mass [kg] = 0.3; radius [m] = 0.7; }
        particle grain { mass [kg] = 0.1; surface spot: point(grain.center); }
        body coin { mass [kg] = 0.5; inertia [kg*m^2] = (0.02, 0.02, 0.04);
                    surface rim: disk_rim(coin.center, axis = (0.2, 0.1, 1), radius [m] = 0.4); }
        #[allow(outside)]
        box block {
            mass [kg] = 3; size [m] = (1, 0.8, 0.6);
            marker top [m] = (0.1, 0.2, 0), axis = (0.3, -0.2, 1);
            point left [m] = (-0.5, 0.1, 0.2); point right [m] = (0.4, 0.9, 0.1);
            surface slope: plane(block.top);
            surface socket: ball_socket(block.center, radius [m] = 0.3);
            surface rail: capsule(block.left, block.right, radius [m] = 0.3);
            surface column: cylinder(block.left, axis = (0.1, 0.2, 1), radius [m] = 0.5, length [m] = 0.8);
            surface post: cylinder(block.right, axis = (1, 0, 0.5), radius [m] = 0.8);
            surface tube: bore(block.center, axis = (0, 0.3, 1), radius [m] = 0.25, length [m] = 1.4);
        }
        rod arm { mass [kg] = 0.5; length [m] = 0.5; radius [mm] = 20; surface tip: point(arm.end); }
        surface ground_plane: plane(ground(0, 0, 0.5) [m], axis = (0.1, 0, 1));
        joint hinge: revolute(block.right, arm.start, axis = (0, 1, 0));
        contact rolls: between(ball.surface, block.slope) = hunt_crossley(force [N] = 60, depth [m] = 0.1, dissipation [s/m] = 0.2);
        contact knocks: between(marble.surface, ball.surface) = kelvin_voigt(stiffness [N/m] = 100, damping [N*s/m] = 1);
        contact seated: between(ball.surface, block.socket) = kelvin_voigt(stiffness [N/m] = 200, damping [N*s/m] = 4);
        contact rails: between(marble.surface, block.rail) = hunt_crossley(force [N] = 30, depth [m] = 0.1, dissipation [s/m] = 0.2);
        contact columns: between(block.column, marble.surface) = kelvin_voigt(stiffness [N/m] = 80, damping [N*s/m] = 1);
        contact posts: between(ball.surface, block.post) = kelvin_voigt(stiffness [N/m] = 60, damping [N*s/m] = 1);
        contact tubed: between(ball.surface, block.tube) = kelvin_voigt(stiffness [N/m] = 50, damping [N*s/m] = 1);
        contact falls: between(block.rail, ground_plane) = hunt_crossley(force [N] = 100, depth [m] = 0.1, exponent = 1, dissipation [s/m] = 0.5);
        contact spins: between(coin.rim, ground_plane) = kelvin_voigt(stiffness [N/m] = 90, damping [N*s/m] = 2);
        contact pokes: between(ground_plane, arm.tip) = hunt_crossley(force [N] = 60, depth [m] = 0.1, dissipation [s/m] = 0.4);
        contact drops: between(grain.spot, ground_plane) = kelvin_voigt(stiffness [N/m] = 60);
        friction f_rolls: on(rolls) = coulomb(coefficient = grip, speed [m/s] = 0.1);
        friction f_knocks: on(knocks) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_seated: on(seated) = stribeck(static = 0.5, kinetic = 0.3, transition [m/s] = 0.3, speed [m/s] = 0.1, viscous [N*s/m] = 0.5);
        friction f_rails: on(rails) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_columns: on(columns) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_posts: on(posts) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_tubed: on(tubed) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_falls: on(falls) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_spins: on(spins) = stribeck(static = 0.4, kinetic = 0.2, transition [m/s] = 0.3, speed [m/s] = 0.1);
        friction f_pokes: on(pokes) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        friction f_drops: on(drops) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.1; ball.center.z [m] = 0.1; marble.center.x [m] = 0.5; marble.center.y [m] = 0; marble.center.z [m] = 0.6;
                coin.center.x [m] = 2; coin.center.y [m] = 0; coin.center.z [m] = 0.2; block.center.x [m] = 0; block.center.y [m] = 0; block.center.z [m] = 0.2;
                grain.center.x [m] = 3; grain.center.y [m] = 0.1; grain.center.z [m] = 0.1;
                hinge.angle [rad] = 0.8; hinge.rate [rad/s] = -1; ball.rate.x [rad/s] = 2; marble.rate.z [rad/s] = -1; coin.rate.z [rad/s] = 3;
                coin.center.velocity.x [m/s] = 0.5; block.rate.y [rad/s] = 0.4; grain.center.velocity.y [m/s] = 1; }
        options { emit = (penalty, projection, null_space); }
        output slid_x [m/s] = rolls.sliding.x;
        output poked_z [m/s] = pokes.sliding.z;
        output fell_y [m/s] = falls.sliding.y;
        output pressed [N] = f_falls.normal;
        output lost [W] = -power(f_rolls) - power(f_falls) - power(f_spins) - power(f_pokes);
    }
}
