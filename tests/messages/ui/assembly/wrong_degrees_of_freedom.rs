//! More freedom than expected.

linkwright::mechanism! {
    planar DoublePendulum {
        rod upper { mass [kg] = 1; length [m] = 1; }
        rod lower { mass [kg] = 1; length [m] = 1; }
        joint shoulder: revolute(ground(0, 0) [m], upper.start);
        joint elbow:    revolute(upper.end, lower.start);
        expect { degrees_of_freedom = 1; }
    }
}

fn main() {}
