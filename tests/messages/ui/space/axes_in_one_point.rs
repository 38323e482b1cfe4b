linkwright::mechanism! {
    spatial Wrong {
        body one   { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); }
        body two   { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); }
        body three { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); }
        marker base [m] = (0, 0, 0), axis = (0, 0, 1);
        joint a: revolute(ground(0, 0, 0) [m], one.origin, axis = (0, 0, 1));
        joint b: revolute(one.origin, two.origin, axis = (0, 0.6, 0.8));
        joint c: revolute(two.origin, three.origin, axis = (1, 0, 0.1));
        joint d: revolute(ground(0, 0, 0) [m], three.origin, axis = (0.7, 0, 0.7));
        start { a.angle [deg] ~ 0; }
    }
}

fn main() {}
