//! Without a length.

linkwright::mechanism! {
    planar Crane {
        gravity [m/s^2] = (0, -9.81);
        input drawn [m];
        particle load { mass [kg] = 2; }
        rod boom { mass [kg] = 4; length [m] = 1; }
        joint foot: revolute(ground(0, 0) [m], boom.start);
        output angle [rad] = foot.angle;
        joint rope: cord(boom.end, load.center);
        output length [m] = drawn;
    }
}

fn main() {}
