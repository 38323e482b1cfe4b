linkwright::mechanism! {
    spatial Wrong {
        body crank   { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point tip [m] = (0.3, 0, 0); }
        rod  coupler { mass [kg] = 1; length [m] = 1; radius [m] = 0.01; }
        body rocker  { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point tip [m] = (0, 0.8, 0); }
        joint drive_pin:  revolute(ground(0, 0, 0) [m], crank.origin, axis = (0, 0, 1));
        joint near:       spherical(crank.tip, coupler.start);
        joint far:        spherical(coupler.end, rocker.tip);
        joint rocker_pin: revolute(ground(1, 0, 0.2) [m], rocker.origin, axis = (1, 0, 0));
        start { drive_pin.angle [deg] = 60; rocker_pin.angle [deg] ~ 0; }
        expect { degrees_of_freedom = 1; }
    }
}

fn main() {}
