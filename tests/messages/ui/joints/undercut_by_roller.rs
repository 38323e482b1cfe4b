//! A roller that is too large for the hollows of its cam.

linkwright::mechanism! {
    planar Cam {
        gravity [m/s^2] = (0, -9.81);
        table lobe(angle [deg]) [mm] = [(0, 0), (60, 8), (120, 0), (180, 8), (240, 0), (300, 8), (360, 0)], periodic;
        disk cam { mass [kg] = 1; radius [mm] = 20; }
        body follower { mass [kg] = 0.3; inertia [kg*m^2] = 0; }
        joint shaft: revolute(ground(0, 0) [m], cam.center);
        joint rail: prismatic(ground(0, 0) [m], follower.center, axis = (0, 1));
        joint follow: cam(cam.center, follower.center, lift = lobe, base [mm] = 10, radius [mm] = 25);
    }
}

fn main() {}
