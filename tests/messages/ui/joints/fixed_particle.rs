//! A joint that holds the orientation of a particle.

linkwright::mechanism! {
    planar Bead {
        particle bead { mass [kg] = 1; }
        joint hold: fixed(ground(0, 0) [m], bead.center);
    }
}

fn main() {}
