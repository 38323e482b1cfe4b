//! Beams beyond what their theory and their shapes are for: thick, clamped where they turn, fast and pressed together without stiffening.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar OutOfReach {
        beam thick { length [mm] = 100; section = rectangle(height [mm] = 20, width [mm] = 20); young [GPa] = 70; density [kg/m^3] = 2700; }
        beam loose { length [m] = 1; section = circle(diameter [mm] = 20); young [GPa] = 70; density [kg/m^3] = 2700; shapes = clamped; }
        beam blade { length [m] = 10; area [mm^2] = 400; second_moment [m^4] = 2e-7; young [GPa] = 70; mass [kg] = 12; }
        beam strut { length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800; shapes = pinned; }
        #[allow(slender)]
        beam short { length [mm] = 100; section = rectangle(height [mm] = 20, width [mm] = 20); young [GPa] = 70; density [kg/m^3] = 2700; }
        body press { mass [kg] = 200; inertia [kg*m^2] = 1; }
        joint a: revolute(ground(0, 0) [m], thick.start);
        joint b: revolute(ground(1, 0) [m], loose.start);
        joint c: revolute(ground(2, 0) [m], blade.center);
        joint d: revolute(ground(3, 0) [m], strut.start);
        joint e: revolute(strut.end, press.center);
        joint rail: prismatic(ground(3, 0) [m], press.center, axis = (0, 1));
        joint f: revolute(ground(5, 0) [m], short.start);
        gravity [m/s^2] = (0, -9.81);
        start { a.angle [rad] = 0; b.angle [rad] = 0; c.angle [rad] = 0; c.rate [rad/s] = 9; strut.angle [deg] ~ 90; f.angle [rad] = 0; rail.travel [m] ~ 1; }
    }
}

fn main() {
    let the_only_error = ();
}
