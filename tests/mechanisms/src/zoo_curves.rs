//! Joints on curves that are graphs: where a body hangs on one, in both orders, and where one closes a loop.

linkwright::mechanism! {
    /// A bead on a parabola, a crank's pin in a wavy slot of a rocker, and a plate whose slot runs over a pin of the ground.
    pub planar Wired {
        param k [1/m] = 2 in 1..3;
        gravity [m/s^2] = (0, -9.81);
        table slot(along [mm]) [mm] = [(0, 0), (100, 20), (200, -10), (300, 15), (400, 0)], periodic;
        particle bead { mass [kg] = 0.2; }
        rod crank { mass [kg] = 0.5; length [m] = 0.2; }
        rod rocker { mass [kg] = 1; length [m] = 0.8; }
        body plate { mass [kg] = 0.9; inertia [kg*m^2] = 0.05; center [mm] = (30, -20); point corner [mm] = (-200, 100); }
        joint wire: point_on_curve(ground(1, 0) [m], bead.center, y = k / 2 * wire.parameter * wire.parameter);
        joint a: revolute(ground(0, 0) [m], crank.start);
        joint b: revolute(ground(-0.3, -0.1) [m], rocker.start);
        joint pin: point_on_curve(rocker.start, crank.end, y = slot(pin.parameter));
        joint hangs: point_on_curve(plate.corner, ground(2, 1) [m], x = 30 [mm] * sin(hangs.parameter / 0.2 [m]), y = hangs.parameter);
        spring link: spring(bead.center, plate.center, stiffness [N/m] = 40, length [m] = 0.5);
        force drag: force(hangs) = -0.3 [N*s/m]*hangs.parameter_rate;
        start { wire.parameter [m] = 0.3; wire.parameter_rate [m/s] = 0.4; a.angle [deg] = 60; b.angle [deg] ~ 20; a.rate [rad/s] = 2;
                hangs.parameter [m] = 0.1; hangs.parameter_rate [m/s] = 0.2; plate.angle [rad] = 0.3; plate.rate [rad/s] = -1; }
        expect { degrees_of_freedom = 4; }
        options { emit = (penalty, projection, null_space, tangent); }
        output held [N] = wire.force;
        output pressed [N] = pin.force;
        output carried [N] = hangs.reaction.y;
        output along [m] = hangs.parameter;
        output turned [rad] = pin.angle;
    }
}
