//! A budget of live values that is exceeded.

linkwright::mechanism! {
    planar Pendulum {
        gravity [m/s^2] = (0, -9.81);
        rod upper { mass [kg] = 1; length [m] = 1; }
        rod lower { mass [kg] = 1; length [m] = 1; }
        joint shoulder: revolute(ground(0, 0) [m], upper.start);
        joint elbow: revolute(upper.end, lower.start);
        expect { live_values <= 2; }
    }
}

fn main() {}
