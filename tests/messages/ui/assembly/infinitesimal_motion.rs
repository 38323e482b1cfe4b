linkwright::mechanism! {
    planar Shaky {
        rod crank   { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 1; length [m] = 1; }
        joint crank_pin: revolute(ground(0, 0) [m], crank.start);
        joint left:      revolute(crank.end, coupler.start);
        joint right:     revolute(coupler.end, ground(2, 0) [m]);
        start { crank_pin.angle [deg] ~ 0; left.angle [deg] ~ 0; }
    }
}

fn main() {}
