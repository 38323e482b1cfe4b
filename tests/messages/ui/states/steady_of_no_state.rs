//! Steady for what is no state.

linkwright::mechanism! {
    planar Motor {
        param resistance [ohm] = 0.5;
        state current [A] = 0;
        rate  current = (3 [V] - resistance*current - 0.08 [V*s]*axle.rate)/2e-3 [H];
        state heat [1] = 20;
        rate  heat = 1 [1/s] + heat^2*1 [1/s];
        state away [rad] = 0;
        rate  away = axle.rate;
        body arm { mass [kg] = 0.1; inertia [kg*m^2] = 0.02; }
        joint axle: revolute(ground(0, 0) [m], arm.center);
        torque motor: torque(axle) = 0.08 [N*m/A]*current;
        start { axle.rate [rad/s] = 10; steady = (current, hat); }
        output heat [1] = heat;
        output away [rad] = away;
    }
}

fn main() {}
