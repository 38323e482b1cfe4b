//! A budget of a function that this definition does not emit.

linkwright::mechanism! {
    planar FourBar {
        rod crank   { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 1; length [m] = 2; }
        rod rocker  { mass [kg] = 1; length [m] = 1.5; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(2, 0) [m], rocker.start);
        joint left:       revolute(crank.end, coupler.start);
        joint right:      revolute(coupler.end, rocker.end);
        start { crank_pin.angle [deg] = 90; rocker_pin.angle [deg] ~ 90; }
        expect { operations(factor) <= 200; }
    }
}

fn main() {}
