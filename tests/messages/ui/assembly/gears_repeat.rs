linkwright::mechanism! {
    planar Train {
        disk one { mass [kg] = 1; radius [m] = 1; }
        disk two { mass [kg] = 1; radius [m] = 2; }
        joint first:  revolute(ground(0, 0) [m], one.center);
        joint second: revolute(ground(3, 0) [m], two.center);
        gear mesh:  gear(first, second, ratio = -2);
        gear again: gear(first, second, ratio = -2);
    }
}

fn main() {}
