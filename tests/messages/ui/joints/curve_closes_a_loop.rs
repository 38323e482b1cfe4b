//! A curve that is no graph, left out of the tree.

linkwright::mechanism! {
    planar Wire {
        gravity [m/s^2] = (0, -9.81);
        particle bead { mass [kg] = 0.2; }
        joint wire: point_on_curve(ground(0, 0) [m], bead.center, x = 2*wire.parameter, y = 3*wire.parameter);
        options { cut = (wire); }
    }
}

fn main() {}
