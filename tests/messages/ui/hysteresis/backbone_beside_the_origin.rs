//! A backbone without its first point.

linkwright::mechanism! {
    planar Mount {
        table bar(way [mm]) [N] = [(1, 100), (2, 150)], linear, outside = hold;
        body cart { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint rail: prismatic(ground(0, 0) [m], cart.center, axis = (1, 0));
        force bush: masing(rail, backbone = bar);
    }
}

fn main() {}
