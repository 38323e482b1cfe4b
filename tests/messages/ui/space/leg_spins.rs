linkwright::mechanism! {
    spatial Wrong {
        body foot  { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point hip [m] = (0, 0, 1); }
        body lower { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); }
        body upper { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); }
        joint lift:  prismatic(ground(0, 0, 0) [m], foot.origin, axis = (0, 0, 1));
        joint below: spherical(ground(0.5, 0, 0) [m], lower.origin);
        joint slide: prismatic(lower.origin, upper.origin, axis = (0, 0, 1));
        joint above: spherical(foot.hip, upper.origin);
        start { lift.travel [m] = 0.1; slide.travel [m] ~ 1.2; }
        expect { degrees_of_freedom = 1; }
    }
}

fn main() {}
