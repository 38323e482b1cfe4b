//! A backbone that is a grid.

linkwright::mechanism! {
    planar Mount {
        table bar(way [m], heat) [N] = grid((0, 1), (0, 1), [(0, 1), (0, 2)]);
        body cart { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint rail: prismatic(ground(0, 0) [m], cart.center, axis = (1, 0));
        force bush: masing(rail, backbone = bar);
    }
}

fn main() {}
