//! Joints with play, which have a contact in place of their rows: in a loop of the plane and between bodies in space, with friction in them.

linkwright::mechanism! {
    /// A four-bar whose two upper pins have play, one of them dry; one stands off its middle at the start.
    #[allow(penetration)]
    pub planar LooseLoop {
        param play [mm] = 60 in 1..100;
        gravity [m/s^2] = (0.5, -9.81);
        rod crank   { mass [kg] = 1; length [m] = 0.4; }
        rod coupler { mass [kg] = 2; length [m] = 1; }
        body rocker { mass [kg] = 1.5; inertia [kg*m^2] = 0.1; center [m] = (0.3, 0.02); point tip [m] = (0.7, 0); }
        joint left:  revolute(ground(0, 0) [m], crank.start);
        joint right: revolute(ground(0.9, 0) [m], rocker.origin);
        joint knee:  revolute(crank.end, coupler.start, play = play, radius [mm] = 150) = kelvin_voigt(stiffness [N/m] = 900, damping [N*s/m] = 8);
        joint wrist: revolute(rocker.tip, coupler.end, play [mm] = 40, radius [mm] = 120)
            = hunt_crossley(force [N] = 40, depth [mm] = 100, exponent = 1.7, dissipation [s/m] = 0.3);
        friction rub: on(wrist) = coulomb(coefficient = 0.3, speed [m/s] = 0.1);
        torque motor: torque(knee) = 0.4 [N*m] - 0.1 [N*m*s/rad]*wrist.rate;
        start { left.angle [deg] = 70; left.rate [rad/s] = 3; right.angle [deg] ~ 60; coupler.angle [deg] ~ 5; wrist.offset.x [mm] = 50;
                wrist.offset.y [mm] = -5; }
        options { emit = (tangent); }
        expect { degrees_of_freedom = 5; }
        output turned [rad] = knee.angle + wrist.angle;
        output off [mm] = wrist.offset.x - 2*knee.offset.y;
        output far [mm] = wrist.eccentricity;
        output pushed [N] = knee.force + wrist.force;
        output resisted [N] = rub.force;
        output lost [W] = power(knee) + power(rub);
        output slides [m/s] = wrist.sliding;
    }
}

linkwright::mechanism! {
    /// A ball with play at the end of an arm, and a body that hangs in it.
    #[allow(penetration)]
    pub spatial LooseBall {
        gravity [m/s^2] = (0.3, 0, -9.81);
        body arm  { mass [kg] = 1; inertia [kg*m^2] = (0.02, 0.03, 0.04); point tip [m] = (0.4, 0.1, 0); }
        body bob  { mass [kg] = 0.8; inertia [kg*m^2] = (0.01, 0.02, 0.015); point eye [m] = (0, 0.05, 0.3); }
        joint pin:  revolute(ground(0, 0, 0) [m], arm.origin, axis = (0.1, 0, 1));
        joint ball: spherical(arm.tip, bob.eye, play [mm] = 30, radius [mm] = 90) = kelvin_voigt(stiffness [N/m] = 700, damping [N*s/m] = 6);
        friction rub: on(ball) = coulomb(coefficient = 0.2, speed [m/s] = 0.1);
        start { pin.angle [rad] = 0.3; pin.rate [rad/s] = 2; bob.rate.x [rad/s] = 1; ball.offset.x [mm] = 35; ball.offset.y [mm] = 4; ball.offset.z [mm] = -10; }
        options { emit = (tangent); }
        output off [mm] = ball.offset.x + 3*ball.offset.z;
        output far [mm] = ball.eccentricity;
        output pushed [N] = ball.force;
        output pressed [N] = rub.normal;
        output slides [m/s] = ball.sliding.y;
    }
}
