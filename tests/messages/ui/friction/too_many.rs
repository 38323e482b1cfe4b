//! A chain of thirteen pins with friction.

linkwright::mechanism! {
    planar Mount {
        gravity [m/s^2] = (0, -9.81);
        const N = 13;
        rod link[0] { mass [kg] = 1; length [m] = 1; }
        repeat i in 0..N {
            rod link[i+1] { mass [kg] = 1; length [m] = 1; }
            joint pin[i]: revolute(link[i].end, link[i+1].start);
            friction rub[i]: on(pin[i]) = coulomb(coefficient = 0.2, radius [m] = 0.01, speed [rad/s] = 0.01);
        }
        joint foot: revolute(ground(0, 0) [m], link[0].start);
    }
}

fn main() {}
