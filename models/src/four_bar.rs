//! Four-bar of unit rods.

linkwright::mechanism! {
    pub planar FourBar {
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 1; length [m] = 1; }
        rod rocker  { mass [kg] = 1; length [m] = 1; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(1, 0) [m], rocker.start);
        joint left:  revolute(crank.end, coupler.start);
        joint right: revolute(coupler.end, rocker.end);
        start { crank_pin.angle [deg] = 90; crank_pin.rate [rad/s] = -1; rocker_pin.angle [deg] ~ 90; coupler.angle [rad] ~ 0; }
        expect { degrees_of_freedom = 1; operations <= 100; }
        output x [m] = crank.end.x;
        output angle [rad] = rocker_pin.angle;
    }
}
