//! A block on a rail that touches a floor along it.

linkwright::mechanism! {
    planar Press {
        rod crank { mass [kg] = 1; length [m] = 0.1; }
        rod coupler { mass [kg] = 1; length [m] = 0.4; }
        body ram { mass [kg] = 2; inertia [kg*m^2] = 0.01; point low [m] = (0, -0.02); surface sole: point(ram.low); }
        surface floor: half_plane(line(ground(0, -0.02) [m], ground(1, -0.02) [m]));
        joint shaft: revolute(ground(0, 0) [m], crank.start);
        joint knee: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, ram.center);
        joint rail: prismatic(ground(0, 0) [m], ram.center, axis = (1, 0));
        contact lies: between(ram.sole, floor) = rigid(restitution = 0);
        start { shaft.angle [deg] = 30; shaft.rate [rad/s] = 3; rail.travel [m] ~ 0.5; }
        options { coordinates = absolute; }
    }
}

fn main() {}
