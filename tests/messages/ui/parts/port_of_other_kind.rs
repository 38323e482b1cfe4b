//! A body where a place is asked for, and a time where a length is.

linkwright::mechanism! {
    planar Walker {
        part Leg(hip: place, length [m] = 0.4) {
            rod thigh { mass [kg] = 1; length = length; }
            joint pin: revolute(hip, thigh.start);
        }
        gravity [m/s^2] = (0, -9.81);
        body hull { mass [kg] = 10; inertia [kg*m^2] = 1; point left [m] = (-0.2, 0); }
        joint rail: prismatic(ground(0, 1) [m], hull.center, axis = (1, 0));
        part left: Leg(hip = hull, length [s] = 0.3);
    }
}

fn main() {}
