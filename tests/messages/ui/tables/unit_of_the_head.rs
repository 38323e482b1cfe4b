//! A unit that is none, in the head.

linkwright::mechanism! {
    planar Cam {
        table law(speed [mps]) [N] = [(-1, -5), (1, 5)];
        disk cam { mass [kg] = 1; radius [mm] = 40; }
        body follower { mass [kg] = 0.3; inertia [kg*m^2] = 1e-4; }
        joint shaft: revolute(ground(0, 0), cam.center);
        joint rail: prismatic(ground(0, 60) [mm], follower.center, axis = (0, 1));
        force rub: force(rail) = -law(rail.speed);
    }
}

fn main() {}
