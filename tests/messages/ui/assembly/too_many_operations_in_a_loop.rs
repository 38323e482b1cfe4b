//! A budget that a closed loop exceeds: where its operations go.

linkwright::mechanism! {
    planar FourBar {
        param payload [kg] = 2 in 0.5..10;
        input drive [N*m];
        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 0.5; length [m] = 0.2; }
        rod coupler { mass [kg] = 1; length [m] = 0.6; }
        body rocker { mass [kg] = payload; inertia [kg*m^2] = 0.05; center [m] = (0.3, 0); point tip [m] = (0.4, 0); }
        joint crank_pin: revolute(ground(0, 0) [m], crank.start);
        joint knee: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, rocker.tip);
        joint rocker_pin: revolute(ground(0.5, 0) [m], rocker.origin);
        force motor: torque(crank_pin) = drive;
        force band: spring(ground(0, 0.7) [m], coupler.center, stiffness [N/m] = 30, length [m] = 0.3);
        start { crank_pin.angle [deg] = 90; rocker_pin.angle [deg] ~ 70; }
        expect { operations <= 80; }
    }
}

fn main() {}
