//! Contacts whose gates are held within a step, and such that are rigid, in the plane and in space: laws that jump and such that do not, loops,
//! limits, several gaps of one contact, surfaces that move by themselves.

linkwright::mechanism! {
    /// A ball, a rod between stops and a plate on two places, in a loop, with friction where the ball lies.
    #[allow(penetration)]
    pub planar Landing {
        param stiffness [N/m] = 300;
        gravity [m/s^2] = (0, -9.81);
        disk ball { mass [kg] = 1; radius [m] = 0.3; }
        rod arm { mass [kg] = 0.5; length [m] = 0.6; surface tip: point(arm.end); }
        rod plate { mass [kg] = 2; length [m] = 0.8; surface sole: segment(plate.start, plate.end, radius [m] = 0.05); }
        surface floor: half_plane(line(ground(0, 0.3) [m], ground(1, 0.25) [m]));
        joint pivot: revolute(ground(1.6, 0.1) [m], arm.start);
        joint link: distance(ball.center, arm.end, length [m] = 1.3);
        contact lands: between(floor, ball.surface) = kelvin_voigt(stiffness = stiffness, damping [N*s/m] = 6, release = 0.4);
        contact tips: between(arm.tip, floor) = hunt_crossley(force [N] = 40, depth [mm] = 200, exponent = 1.7, dissipation [s/m] = 0.3);
        contact lies: between(plate.sole, floor) = 200 [N/m]*lies.depth*(1 + 0.2 [s/m]*lies.closing);
        limit stops: pivot.angle [rad] in -1..1.2 = kelvin_voigt(stiffness [N*m/rad] = 40, damping [N*m*s/rad] = 2);
        friction grip: on(lands) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        start { plate.center.x [m] = -0.4; plate.center.y [m] = 0.3; plate.angle [rad] = 0.1; pivot.angle [rad] = 1.3; pivot.rate [rad/s] = 1;
                ball.center.x [m] = 0.6; ball.center.y [m] ~ 0.5; ball.angle [rad] = 0; }
        options { contact = held; emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = lands.force + lies.force;
        output gap [m] = lies.gap;
        output lost [W] = power(lands) + power(stops) + power(grip);
    }
}

linkwright::mechanism! {
    /// A ball between a deck that is tilted and an arm between stops.
    #[allow(penetration)]
    pub spatial Docking {
        gravity [m/s^2] = (0, 0, -9.81);
        material rubber { modulus [Pa] = 3e3; poisson = 0.4; }
        sphere ball { mass [kg] = 1; radius [m] = 0.2; }
        rod arm { mass [kg] = 0.5; length [m] = 0.5; radius [mm] = 20; surface tip: point(arm.end); surface side: capsule(arm.start, arm.end, radius [m] = 0.02); }
        surface deck: plane(ground(0, 0, 0.5) [m], axis = (0.1, 0, 1));
        joint hinge: revolute(ground(1, 0, 0.6) [m], arm.start, axis = (0, 1, 0));
        contact knocks: between(ball.surface, arm.side) = kelvin_voigt(stiffness [N/m] = 200, damping [N*s/m] = 4);
        contact rolls: between(ball.surface, deck) = hertz(first = rubber, second = rubber, dissipation [s/m] = 0.4);
        contact pokes: between(arm.tip, deck) = hunt_crossley(force [N] = 60, depth [m] = 0.1, exponent = 1, restitution = 0.8, speed [m/s] = 1);
        limit swing: hinge.angle [deg] in -50..40 = hunt_crossley(force [N*m] = 5, depth [deg] = 10, dissipation [s/rad] = 0.5);
        start { ball.center.x [m] = 0.8; ball.center.y [m] = 0.1; ball.center.z [m] = 0.55; hinge.angle [rad] = 0.8; hinge.rate [rad/s] = -1; }
        options { contact = held; emit = (penalty, projection, null_space, tangent); }
        output rolled [N] = rolls.force;
        output poked_z [m] = pokes.point.z;
        output open [m] = knocks.gap;
    }
}

linkwright::mechanism! {
    /// A slider-crank whose slider has a stop, beside a bar that falls on two of its places.
    pub planar Striking {
        param share [1] = 0.6;
        param end [mm] = 640;
        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 1; length [m] = 0.2; }
        rod coupler { mass [kg] = 2; length [m] = 0.5; }
        body slider { mass [kg] = 1.5; inertia [kg*m^2] = 0.01; }
        rod bar { mass [kg] = 3; length [m] = 1; surface sole: segment(bar.start, bar.end, radius [m] = 0.05); }
        surface floor: half_plane(line(ground(0, -0.5) [m], ground(1, -0.45) [m]));
        joint hinge: revolute(ground(0, 0) [m], crank.start);
        joint pin: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, slider.center);
        joint rail: prismatic(ground(0, 0) [m], slider.center, axis = (1, 0));
        contact falls: between(bar.sole, floor) = rigid(restitution = 0.5);
        limit stop: rail.travel in 0..end = rigid(restitution = share);
        start { hinge.angle [deg] = 120; coupler.angle [deg] ~ -20; bar.center.x [m] = 0; bar.center.y [m] = -0.3; bar.angle [rad] = 0.1; }
        options { emit = (penalty, projection, null_space); }
        output travel [m] = rail.travel;
        output force [N] = falls.force;
        output gap [m] = falls.gap;
        output taken [W] = power(stop);
    }
}

linkwright::mechanism! {
    /// A ball on a slope that sinks and rises, under an arm that lies on its stop.
    pub spatial Dropping {
        gravity [m/s^2] = (0, 0, -9.81);
        sphere ball { mass [kg] = 1; radius [m] = 0.2; }
        rod arm { mass [kg] = 0.5; length [m] = 0.5; radius [mm] = 60; surface tip: point(arm.end); }
        surface slope: plane(ground(0 [m], 0 [m], -0.1 [m]*sin(2 [rad/s]*time)), axis = (0.1, 0, 1));
        joint hinge: revolute(ground(1, 0, 0.6) [m], arm.start, axis = (0, 1, 0));
        contact bounces: between(ball.surface, slope) = rigid(restitution = 0.7);
        contact meets: between(arm.tip, ball.surface) = rigid(restitution = 0.4);
        limit swing: hinge.angle [deg] in -60..30 = rigid(restitution = 0);
        start { ball.center.x [m] = 0.6; ball.center.y [m] = 0.1; ball.center.z [m] = 0.3; hinge.angle [deg] = 30; ball.center.velocity.x [m/s] = 0.2; }
        options { emit = (penalty, projection, null_space); }
        output force [N] = bounces.force + meets.force;
        output at_x [m] = meets.point.x;
        output closing [m/s] = meets.closing;
    }
}

linkwright::mechanism! {
    /// A ball on a table that turns askew, a wheel on its rim on a floor that heaves, an arm on the ball, and a bead along a gap, all with dry friction
    /// where they touch.
    pub spatial GrippingInSpace {
        param hold [1] = 0.6;
        param slide [1] = 0.4;
        gravity [m/s^2] = (0.5, 0, -9.81);
        body table { mass [kg] = 5; inertia [kg*m^2] = (0.7, 0.8, 1.2); surface top: plane(table.center, axis = (0.05, 0, 1)); }
        sphere ball { mass [kg] = 1; radius [m] = 0.1; }
        body wheel { mass [kg] = 0.8; inertia [kg*m^2] = (0.005, 0.005, 0.009); surface rim: disk_rim(wheel.center, axis = (0, 0, 1), radius [m] = 0.15); }
        rod arm { mass [kg] = 0.5; length [m] = 0.5; radius [mm] = 30; surface tip: sphere(arm.end, radius [m] = 0.05); }
        particle bead { mass [kg] = 0.3; }
        surface floor: plane(ground(0 [m], 0 [m], -0.5 [m] - 0.05 [m]*sin(3 [rad/s]*time)), axis = (0.1, 0, 1));
        joint axle: revolute(ground(0, 0, 0) [m], table.center, axis = (0.1, 0, 1));
        joint shoulder: revolute(ground(0.3, 0, 0.6) [m], arm.start, axis = (0, 1, 0));
        contact rides: between(ball.surface, table.top) = rigid(restitution = 0.3);
        contact meets: between(arm.tip, ball.surface) = rigid(restitution = 0.4);
        contact rolls: between(wheel.rim, floor) = rigid(restitution = 0.2);
        contact drops: gap(bead.center.z + 0.4 [m], slip = bead.center.x + 0.3 [m]*sin(bead.center.y/1 [m] + 2 [rad/s]*time)) = rigid(restitution = 0);
        friction drags: on(rides) = dry(static = hold, kinetic = slide);
        friction turns: on(meets) = dry(static = 0.5, kinetic = 0.2);
        friction grips: on(rolls) = dry(static = 0.5);
        friction slips: on(drops) = dry(static = 0.3, kinetic = 0);
        start { ball.center.x [m] = 0.3; ball.center.y [m] = 0.1; ball.center.z [m] = 0.3; ball.center.velocity.y [m/s] = 0.5; axle.angle [rad] = 0; axle.rate [rad/s] = 4;
                shoulder.angle [deg] = -10; wheel.center.x [m] = 2; wheel.center.y [m] = 0; wheel.center.z [m] = 0; wheel.rate.x [rad/s] = 2;
                bead.center.x [m] = 0; bead.center.y [m] = 0; bead.center.z [m] = 0.1; bead.center.velocity.y [m/s] = 1; }
        options { emit = (penalty, projection, null_space); }
        output pressed [N] = drags.normal + grips.normal;
        output sliding [m/s] = rides.sliding.y;
        output taken [W] = power(drags) + power(grips) + power(slips);
        output turning [W] = power(turns);
    }
}

linkwright::mechanism! {
    /// A disk between a plank that swings and a rocker, and a bar on a slope and on something that shakes, all with dry friction where they touch.
    pub planar Gripping {
        param hold [1] = 0.6;
        param slide [1] = 0.4;
        gravity [m/s^2] = (0, -9.81);
        disk wheel { mass [kg] = 1; radius [m] = 0.2; }
        body plank { mass [kg] = 2; inertia [kg*m^2] = 0.3; point left [m] = (-0.6, 0.05); point right [m] = (0.6, 0.02);
                     line top = (plank.left, plank.right); surface deck: half_plane(plank.top); }
        disk rocker { mass [kg] = 3; radius [m] = 0.3; }
        rod bar { mass [kg] = 1.5; length [m] = 0.8; surface sole: segment(bar.start, bar.end, radius [m] = 0.05); }
        surface floor: half_plane(line(ground(0, -0.5) [m], ground(1, -0.45) [m]));
        joint pivot: revolute(ground(0, 0) [m], plank.center);
        joint axle: revolute(ground(1.05, 0.45) [m], rocker.center);
        torsion_spring level: torsion_spring(pivot, stiffness [N*m/rad] = 60, angle [rad] = 0);
        contact rides: between(wheel.surface, plank.deck) = rigid(restitution = 0.3);
        contact meets: between(rocker.surface, wheel.surface) = rigid(restitution = 0.5);
        contact falls: between(floor, bar.sole) = rigid(restitution = 0.2);
        contact drops: gap(bar.center.y + 0.3 [m], slip = bar.center.x + 0.1 [m]*sin(bar.angle + 3 [rad/s]*time)) = rigid(restitution = 0);
        friction rolls: on(rides) = dry(static = hold, kinetic = slide);
        friction turns: on(meets) = dry(static = 0.5);
        friction lies: on(falls) = dry(static = 0.3, kinetic = 0.2);
        friction drags: on(drops) = dry(static = 0.3, kinetic = 0);
        start { wheel.center.x [m] = 0.2; wheel.center.y [m] = 0.5; wheel.angle [rad] = 0; wheel.rate [rad/s] = -8; wheel.center.velocity.x [m/s] = 1;
                pivot.angle [rad] = 0; axle.angle [rad] = 0; axle.rate [rad/s] = 3;
                bar.center.x [m] = 0; bar.center.y [m] = -0.2; bar.angle [rad] = 0.1; bar.center.velocity.x [m/s] = 0.5; }
        options { emit = (penalty, projection, null_space); }
        output pressed [N] = rolls.normal;
        output force [N] = rolls.force + turns.force;
        output sliding [m/s] = meets.sliding;
        output taken [W] = power(lies) + power(drags);
    }
}

linkwright::mechanism! {
    /// A slider-crank that rubs in its joints and pushes a wedge under a rider between rigid stops, dry where they touch.
    pub planar Rasping {
        input torque [N*m];
        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 1; length [m] = 0.2; }
        rod coupler { mass [kg] = 2; length [m] = 0.5; }
        body wedge { mass [kg] = 1.5; inertia [kg*m^2] = 0.01; point low [m] = (0, 0); point high [m] = (0.6, 0.25); line slope = (wedge.low, wedge.high); surface top: half_plane(wedge.slope); }
        body rider { mass [kg] = 0.8; inertia [kg*m^2] = 0.01; surface foot: point(rider.center); }
        joint pivot: revolute(ground(0, 0) [m], crank.start);
        joint elbow: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, wedge.center);
        joint rail: prismatic(ground(0, 0) [m], wedge.center, axis = (1, 0));
        joint wall: prismatic(ground(0.8, 0) [m], rider.center, axis = (0.1, 1));
        contact lies: between(rider.foot, wedge.top) = rigid(restitution = 0.4);
        limit end: rail.travel [mm] in 300..900 = rigid(restitution = 0.6);
        torque motor: torque(pivot) = torque;
        friction f_pivot: on(pivot) = coulomb(coefficient = 0.1, radius [mm] = 15, speed [rad/s] = 0.1);
        friction f_elbow: on(elbow) = stribeck(static = 0.12, kinetic = 0.08, transition [rad/s] = 1, radius [mm] = 12, speed [rad/s] = 0.1);
        friction f_rail: on(rail) = coulomb(coefficient = 0.06, length [m] = 0.5, speed [m/s] = 0.02);
        friction f_wall: on(wall) = coulomb(coefficient = 0.1, speed [m/s] = 0.02);
        friction scrape: on(lies) = dry(static = 0.2, kinetic = 0.15);
        start { pivot.angle [deg] = 60; pivot.rate [rad/s] = -2; wall.travel [m] = 0.2; elbow.angle [deg] ~ -80; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = f_pivot.normal + f_rail.normal + f_wall.normal;
        output held [N] = lies.force + end.force;
        output lost [W] = -power(f_pivot) - power(f_elbow) - power(f_rail) - power(f_wall);
    }
}
