//! A block on a rail above a floor along it.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Press {
        rod crank { mass [kg] = 1; length [m] = 0.1; }
        rod coupler { mass [kg] = 1; length [m] = 0.4; }
        body ram { mass [kg] = 2; inertia [kg*m^2] = 0.01; point low [m] = (0, -0.02); surface sole: point(ram.low); }
        surface floor: half_plane(line(ground(0, -0.1) [m], ground(1, -0.1) [m]));
        joint shaft: revolute(ground(0, 0) [m], crank.start);
        joint knee: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, ram.center);
        joint rail: prismatic(ground(0, 0) [m], ram.center, axis = (1, 0));
        contact idle: between(ram.sole, floor) = kelvin_voigt(stiffness [N/m] = 1e5);
        start { shaft.angle [deg] = 30; shaft.rate [rad/s] = 3; rail.travel [m] ~ 0.5; }
        options { coordinates = absolute; }
    }
}

fn main() {
    let the_only_error = ();
}
