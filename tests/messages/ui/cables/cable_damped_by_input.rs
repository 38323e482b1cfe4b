//! A damping needs the rate of the length.

linkwright::mechanism! {
    planar Crane {
        gravity [m/s^2] = (0, -9.81);
        input drawn [m];
        particle load { mass [kg] = 2; }
        rod boom { mass [kg] = 4; length [m] = 1; }
        joint foot: revolute(ground(0, 0) [m], boom.start);
        output angle [rad] = foot.angle;
        cable rope: cable(boom.end, load.center, stiffness [N] = 2e4, length = drawn, damping [N*s/m] = 3);
    }
}

fn main() {}
