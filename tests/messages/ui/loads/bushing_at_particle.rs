//! A bushing at a particle, which has nothing to hold against turning.

linkwright::mechanism! {
    planar Mount {
        particle ball { mass [kg] = 1; }
        bushing b: bushing(ground(0, 0), ball.center, stiffness [N/m] = 100, torsional_stiffness = 0);
    }
}

fn main() {}
