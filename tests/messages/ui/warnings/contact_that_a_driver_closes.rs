//! A stop before a crank that a driver turns, whatever it meets.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Press {
        rod crank { mass [kg] = 1; length [m] = 0.1; }
        rod coupler { mass [kg] = 1; length [m] = 0.4; }
        body ram { mass [kg] = 2; inertia [kg*m^2] = 0.01; surface nose: point(ram.center); }
        surface wall: half_plane(line(ground(0.49, 0) [m], ground(0.49, 1) [m]));
        joint shaft: revolute(ground(0, 0) [m], crank.start);
        joint knee: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, ram.center);
        joint rail: prismatic(ground(0, 0) [m], ram.center, axis = (1, 0));
        contact stop: between(ram.nose, wall) = rigid(restitution = 0.2);
        drive run: shaft.angle = 0.5 [rad] + 3 [rad/s]*time;
        start { rail.travel [m] ~ 0.45; }
    }
}

fn main() {
    let the_only_error = ();
}
