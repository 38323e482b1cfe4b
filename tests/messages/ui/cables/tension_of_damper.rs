//! A tension of what has none.

linkwright::mechanism! {
    planar Crane {
        gravity [m/s^2] = (0, -9.81);
        input drawn [m];
        particle load { mass [kg] = 2; }
        rod boom { mass [kg] = 4; length [m] = 1; }
        joint foot: revolute(ground(0, 0) [m], boom.start);
        output angle [rad] = foot.angle;
        force rope: damper(boom.end, load.center, damping [N*s/m] = 3);
        output pull [N] = rope.tension;
        output length [m] = drawn;
    }
}

fn main() {}
