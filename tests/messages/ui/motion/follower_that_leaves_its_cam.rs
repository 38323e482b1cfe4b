//! A force that is to press all along the motion.

linkwright::mechanism! {
    planar Cam {
        gravity [m/s^2] = (0, -9.81);
        table lobe(angle [deg]) [mm] = [(0, 0), (60, 4), (120, 8), (180, 8), (240, 8), (300, 4), (360, 0)], periodic;
        disk cam { mass [kg] = 1; radius [mm] = 20; }
        body follower { mass [kg] = 0.3; inertia [kg*m^2] = 0; }
        joint shaft: revolute(ground(0, 0) [m], cam.center);
        joint rail: prismatic(ground(0, 0) [m], follower.center, axis = (0, 1));
        joint follow: cam(cam.center, follower.center, lift = lobe, base [mm] = 30, radius [mm] = 5);
        force spring: force(rail) = -30 [N];
        drive motor: shaft.angle = 300 [rad/s]*time;
        start { rail.travel [mm] ~ 40; }
        expect { follow.force > 0; }
    }
}

fn main() {}
