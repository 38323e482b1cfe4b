//! A hollow is narrower than the roller.

linkwright::mechanism! {
    planar Bench {
        table flank(turn [deg]) [mm] = [(0, 0), (60, 0), (90, -15), (120, 0), (360, 0)], periodic;
        body cam { mass [kg] = 1; inertia [kg*m^2] = 1; surface lobe: profile(cam.center, radius = flank, base [mm] = 40); }
        body follower { mass [kg] = 1; inertia [kg*m^2] = 1; surface roller: circle(follower.center, radius [mm] = 30); }
        joint shaft: revolute(ground(0, 0) [m], cam.center);
        joint rail: prismatic(ground(0, 0) [m], follower.center, axis = (0, 1));
        contact seat: between(follower.roller, cam.lobe) = kelvin_voigt(stiffness [N/m] = 1e5);
        start { shaft.angle [rad] = 0; rail.travel [m] = 0.1; }
    }
}

fn main() {}
