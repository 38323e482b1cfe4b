//! Pins so large that friction makes more reaction than it takes.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar FourBar {
        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 1; length [m] = 0.2; }
        rod coupler { mass [kg] = 2.5; length [m] = 0.5; }
        rod rocker { mass [kg] = 2; length [m] = 0.4; }
        joint a: revolute(ground(0, 0) [m], crank.start);
        joint b: revolute(crank.end, coupler.start);
        joint c: revolute(coupler.end, rocker.end);
        joint d: revolute(ground(0.6, 0) [m], rocker.start);
        friction big: on(b) = coulomb(coefficient = 0.5, radius [m] = 0.5, speed [rad/s] = 0.05);
        friction wide: on(c) = coulomb(coefficient = 0.5, radius [m] = 0.5, speed [rad/s] = 0.05);
        start { a.angle [deg] = 60; rocker.angle [deg] ~ 98; }
    }
}

fn main() {
    let the_only_error = ();
}
