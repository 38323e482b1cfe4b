//! A cord below the load.

linkwright::mechanism! {
    planar Crane {
        gravity [m/s^2] = (0, -9.81);
        input drawn [m];
        particle load { mass [kg] = 2; }
        rod boom { mass [kg] = 4; length [m] = 1; }
        joint foot: revolute(ground(0, 0) [m], boom.start);
        output angle [rad] = foot.angle;
        joint rope: cord(ground(0, -1) [m], load.center, length [m] = 0.5);
        start { load.center.x [m] = 0; load.center.y [m] ~ -0.5; }
        output pull [N] = rope.tension;
        output length [m] = drawn;
    }
}

fn main() {}
