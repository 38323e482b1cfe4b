//! A cam whose curvature jumps, and one that is allowed to.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Cam {
        table lift(angle [deg]) [mm] = [(-360, 0), (0, 0), (60, 4), (180, 8), (300, 2), (360, 0)];
        disk cam { mass [kg] = 1; radius [mm] = 40; }
        body follower { mass [kg] = 0.3; inertia [kg*m^2] = 1e-4; }
        joint shaft: revolute(ground(0, 0), cam.center);
        joint rail: prismatic(ground(0, 60) [mm], follower.center, axis = (0, 1));
        constraint follow: rail.travel = lift(shaft.angle);
        #[allow(kinks)]
        drive motor: shaft.angle = 0.1 [rad/mm]*lift(1 [rad/s]*time);
    }
}

fn main() {
    let the_only_error = ();
}
