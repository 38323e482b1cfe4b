//! An event where the gap of a rigid contact would be less than none.

linkwright::mechanism! {
    planar Slider {
        body slider { mass [kg] = 1; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], slider.origin, axis = (1, 0));
        memory touches = 0;
        start { rail.travel [m] = 0; rail.speed [m/s] = 1; }
        limit stop: rail.travel [m] in -1..0.5 = rigid(restitution = 0.5);
        event touch: stop.gap falls 0 [m] { touches = touches + 1; }
        output count = touches;
    }
}

fn main() {}
