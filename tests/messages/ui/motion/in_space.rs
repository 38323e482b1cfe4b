linkwright::mechanism! {
    spatial Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; radius [m] = 0.1; }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.start, axis = (0, 1, 0));
        expect { rotates = hinge; no_singularity; }
    }
}

fn main() {}
