//! A row that is too short.

linkwright::mechanism! {
    planar Cam {
        table grip(slip, load [N]) [N] = grid((0, 1, 2), (0, 100), [(0, 5, 6), (0, 50)]);
        disk cam { mass [kg] = 1; radius [mm] = 40; }
        body follower { mass [kg] = 0.3; inertia [kg*m^2] = 1e-4; }
        joint shaft: revolute(ground(0, 0), cam.center);
        joint rail: prismatic(ground(0, 60) [mm], follower.center, axis = (0, 1));
        force rub: force(rail) = -grip(0.3, 5 [N]);
    }
}

fn main() {}
