//! Cams as joints: curves on bodies and on the ground, with rollers and a knife edge, in both orders of what the tree carries.

linkwright::mechanism! {
    /// A cam that turns against a roller on an arm, a particle on the edge of a plate, and a bar that rides on an uneven ground.
    pub planar Cammed {
        param base [mm] = 600 in 400..800;
        param roller [mm] = 150 in 50..200;
        gravity [m/s^2] = (0, -9.81);
        table lobe(angle [deg]) [mm] = [(0, 0), (40, 40), (80, 140), (120, 200), (160, 150), (200, 30), (240, -40), (280, -60), (320, -30), (360, 0)], periodic;
        table island(angle [rad]) [m] = [(-3.141592653589793, 0), (-2, 0.1), (-1, 0.05), (0, -0.1), (1, 0.15), (2, 0.1), (3.141592653589793, 0)], periodic;
        particle bead { mass [kg] = 0.2; }
        rod arm { mass [kg] = 0.5; length [m] = 2; }
        body cam { mass [kg] = 1.2; inertia [kg*m^2] = 3e-3; center [mm] = (30, -20); point hub [mm] = (10, 20); }
        body plate { mass [kg] = 0.9; inertia [kg*m^2] = 0.05; point middle [mm] = (20, 30); }
        rod bar { mass [kg] = 0.7; length [m] = 0.8; }
        joint shaft: revolute(ground(0, 0) [m], cam.hub);
        joint pivot: revolute(ground(-2, 1) [m], arm.start);
        joint slide: prismatic(plate.center, arm.end, axis = (0.3, 1));
        joint rolls: cam(cam.hub, arm.end, lift = lobe, base = base, radius = roller);
        joint edge: cam(plate.middle, bead.center, lift = island, base [m] = 1.5);
        joint rides: cam(ground(6, -5) [m], bar.start, lift = island, base [m] = 2, radius [m] = 0.2);
        start { shaft.angle [rad] = 0.4; shaft.rate [rad/s] = 3; pivot.angle [rad] ~ -0.2; slide.travel [m] = 0.3; slide.speed [m/s] = 0.2;
                bead.center.x [m] = 1; bead.center.y [m] ~ 2.5; bead.center.velocity.x [m/s] = 0.4; bar.start.x [m] = 5.5; bar.start.y [m] ~ -2.9;
                bar.angle [rad] = 0.3; bar.rate [rad/s] = -1; bar.start.velocity.x [m/s] = 0.6; }
        expect { degrees_of_freedom = 5; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pressed [N] = rolls.force;
        output held [N] = edge.force;
        output along [N] = rides.reaction.x;
        output turned [rad] = rides.angle;
    }
}
