//! Two wheels without the gear between them.

linkwright::mechanism! {
    planar Wheels {
        disk small { mass [kg] = 1; radius [m] = 0.1; }
        disk large { mass [kg] = 9; radius [m] = 0.3; }
        joint small_pin: revolute(ground(0, 0) [m], small.center);
        joint large_pin: revolute(ground(0.4, 0) [m], large.center);
        expect { degrees_of_freedom = 1; }
    }
}

fn main() {}
