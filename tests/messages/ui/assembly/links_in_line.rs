//! A start with all links in line, where the motion is undetermined.

linkwright::mechanism! {
    planar Parallelogram {
        rod crank   { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 1; length [m] = 2; }
        rod rocker  { mass [kg] = 1; length [m] = 1; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(2, 0) [m], rocker.start);
        joint left:       revolute(crank.end, coupler.start);
        joint right:      revolute(coupler.end, rocker.end);
        start { crank_pin.angle [deg] = 0; rocker_pin.angle [deg] ~ 0; left.angle [deg] ~ 0; }
    }
}

fn main() {}
