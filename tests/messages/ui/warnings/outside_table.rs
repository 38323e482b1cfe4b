//! A table that ends before the motion does, and one that ends before the start.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Rocker {
        table bar(angle [deg]) [N*m] = [(-60, -9), (0, 0), (60, 9)];
        table drag(rate [rad/s]) [N*m] = [(-1, -1), (0, 0), (1, 1)], outside = hold;
        rod crank { mass [kg] = 1; length [m] = 0.2; }
        rod coupler { mass [kg] = 1; length [m] = 1; }
        rod rocker { mass [kg] = 1; length [m] = 0.6; }
        joint shaft: revolute(ground(0, 0) [m], crank.start);
        joint knee: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, rocker.end);
        joint foot: revolute(ground(1, 0) [m], rocker.start);
        torque rest: torque(foot) = -bar(foot.angle);
        torque slow: torque(shaft) = -drag(shaft.rate);
        #[allow(outside_table)]
        torque slower: torque(shaft) = -2*drag(shaft.rate);
        start { shaft.angle [deg] = 30; shaft.rate [rad/s] = 3; foot.angle [deg] ~ 80; }
        expect { rotates = shaft; }
    }
}

fn main() {
    let the_only_error = ();
}
