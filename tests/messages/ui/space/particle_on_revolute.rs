//! A joint that needs an orientation, at a particle.

linkwright::mechanism! {
    spatial Wrong {
        particle bob { mass [kg] = 1; }
        joint hinge: revolute(ground(0, 0, 0) [m], bob.center, axis = (0, 0, 1));
    }
}

fn main() {}
