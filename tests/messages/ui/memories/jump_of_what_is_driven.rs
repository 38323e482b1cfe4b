//! What a driver moves cannot jump.

linkwright::mechanism! {
    planar Slider {
        body slider { mass [kg] = 1; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], slider.origin, axis = (1, 0));
        drive along: rail.travel = 0.1 [m/s]*time;
        event out: rail.travel rises 0.2 [m] { jump(rail.speed) = 0 [m/s]; }
    }
}

fn main() {}
