//! A word where a number stands.

linkwright::mechanism! {
    planar Cam {
        table lift(angle [deg]) [mm] = file("text.csv"), periodic;
        disk cam { mass [kg] = 1; radius [mm] = 40; }
        body follower { mass [kg] = 0.3; inertia [kg*m^2] = 1e-4; }
        joint shaft: revolute(ground(0, 0), cam.center);
        joint rail: prismatic(ground(0, 60) [mm], follower.center, axis = (0, 1));
        constraint follow: rail.travel = lift(shaft.angle);
    }
}

fn main() {}
