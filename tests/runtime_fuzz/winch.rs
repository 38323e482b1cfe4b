//! A mechanism of drivers, couplings and laws that several tests take: random calls, and everything that has derivatives.

linkwright::mechanism! {
    /// A driven drum that lifts a load by gear and rack; an arm hangs from the load. The driver's effort is an output.
    pub planar Winch {
        param radius [m] = 0.05;
        param speed [rad/s] = 2;
        param inertia [kg*m^2] = 0.002;
        input brake [N*m];
        gravity [m/s^2] = (0, -9.81);
        body drum  { mass [kg] = 1; inertia [kg*m^2] = inertia; }
        disk wheel { mass [kg] = 0.5; radius [m] = 0.08; }
        body load  { mass [kg] = 3; inertia [kg*m^2] = 0.01; point eye [m] = (0.02, -0.05); }
        rod arm    { mass [kg] = 0.5; length [m] = 0.3; }
        joint axle: revolute(ground(0, 0) [m], drum.center);
        joint wheel_pin: revolute(ground(0.13, 0) [m], wheel.center);
        joint slide: prismatic(ground(-0.3, 0) [m], load.center, axis = (0.1, 1));
        joint hang: revolute(load.eye, arm.start);
        gear teeth: gear(wheel_pin, axle, ratio = -5/8);
        rack mesh: rack(axle, slide, radius = radius);
        drive motor: wheel_pin.angle = speed * time + 0.2 [rad] * sin(3 [rad/s] * time);
        torque hold: torque(hang) = brake - 0.05 [N*m*s/rad] * hang.rate - 0.3 [N*m] * min(hang.angle / 1 [rad], 0.5);
        spring rope: spring(ground(-0.5, -0.4) [m], arm.end, stiffness = 20 [N/m], length = 0.2 [m], damping = 0.1 [N*s/m]);
        start { hang.angle [deg] = -60; hang.rate [rad/s] = 0.5; }
        options { emit = (tangent); }
        expect { degrees_of_freedom = 2; }
        output effort [N*m] = motor.effort;
        output power [W] = motor.power + power(rope);
        output height [m] = arm.end.y;
    }
}
