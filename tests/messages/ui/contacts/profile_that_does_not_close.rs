//! A table of a part of a turn.

linkwright::mechanism! {
    planar Bench {
        table flank(turn [deg]) [mm] = [(0, 40), (60, 48), (120, 40)], monotone;
        body cam { mass [kg] = 1; inertia [kg*m^2] = 1; surface lobe: profile(cam.center, radius = flank); }
        body follower { mass [kg] = 1; inertia [kg*m^2] = 1; surface edge: point(follower.center); }
        joint shaft: revolute(ground(0, 0) [m], cam.center);
        joint rail: prismatic(ground(0, 0) [m], follower.center, axis = (0, 1));
        contact seat: between(follower.edge, cam.lobe) = kelvin_voigt(stiffness [N/m] = 1e5);
        start { shaft.angle [rad] = 0; rail.travel [m] = 0.1; }
    }
}

fn main() {}
