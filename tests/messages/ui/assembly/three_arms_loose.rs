linkwright::mechanism! {
    planar Chain {
        rod one   { mass [kg] = 1; length [m] = 1; }
        rod two   { mass [kg] = 1; length [m] = 1; }
        rod three { mass [kg] = 1; length [m] = 1; }
        body tool { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint a: revolute(ground(0, 0) [m], one.start);
        joint b: revolute(one.end, two.start);
        joint c: revolute(two.end, three.start);
        joint d: fixed(three.end, tool.origin);
        expect { degrees_of_freedom = 1; }
    }
}

fn main() {}
