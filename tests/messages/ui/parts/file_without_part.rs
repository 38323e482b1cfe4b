//! A file that declares other parts, and one that declares none.

linkwright::mechanism! {
    planar Walker {
        part Arm = file("leg.mech");
        part Hand = file("empty.mech");
        gravity [m/s^2] = (0, -9.81);
        body hull { mass [kg] = 10; inertia [kg*m^2] = 1; point left [m] = (-0.2, 0); }
        joint rail: prismatic(ground(0, 1) [m], hull.center, axis = (1, 0));
        part left: Arm(hip = hull.left);
    }
}

fn main() {}
