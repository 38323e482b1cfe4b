//! A memory that is called otherwise.

linkwright::mechanism! {
    planar Slider {
        body slider { mass [kg] = 1; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], slider.origin, axis = (1, 0));
        memory engaged = 0;
        force pull: along(rail.travel) = 1 [N]*engaged;
        start { rail.travel [m] = 0; rail.speed [m/s] = 1; }
        event out: rail.travel rises 0.2 [m] { engagd = 1; }
    }
}

fn main() {}
