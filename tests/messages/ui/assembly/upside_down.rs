//! A direction that agrees with the start only upside down.

linkwright::mechanism! {
    planar Drawer {
        body drawer { mass [kg] = 1; inertia [kg*m^2] = 1; }
        body front  { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint rail:   prismatic(ground(0, 0) [m], drawer.center, axis = (1, 0));
        joint hinge:  revolute(drawer.center, front.center);
        joint closed: fixed(drawer.center, front.center, angle [deg] = 180);
        start { front.angle [deg] = 0; }
        options { cut = closed; }
    }
}

fn main() {}
