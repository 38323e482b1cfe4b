//! A ball that falls on a floor that yields: with a linear spring and damper, and after Hunt and Crossley.
//!
//! Data: 1 kg from 0.5 m, 9.81 m/s². Linear: 1e4 N/m and 20 N s/m, cut where it would pull (Goldsmith, *Impact*, 1960). Hunt and Crossley (J.
//! Appl. Mech. 42 (1975) 440): F = K d^1.5 (1 + b ḋ) with K = 1e6 N/m^1.5, given as 1000 N at 1 cm, and b = 0.2 s/m. Expected heights after one second:
//! 0.1400263525336718 m, of the closed forms of flight and contact one after the other, and 0.1319567478264415 m, after two seconds
//! 0.0295957460118444 m, of a separate integration that stops at each touch (order 8, 3e-14).

linkwright::mechanism! {
    /// A ball on a spring and a damper that push alone.
    pub planar BouncingBall {
        param stiffness [N/m] = 1e4;
        param damping [N*s/m] = 20;
        gravity [m/s^2] = (0, -9.81);
        particle ball { mass [kg] = 1; }
        surface below: point(ball.center);
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact touch: between(below, floor) = kelvin_voigt(stiffness = stiffness, damping = damping);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.5; }
        expect { contact_time(touch) >= 30e-3 [s]; }
        output height [m] = ball.center.y;
        output force [N] = touch.force;
        output lost [W] = power(touch);
    }
}

linkwright::mechanism! {
    /// A ball on a floor whose force grows with the power 1.5 of the depth and with the speed.
    pub planar BouncingBallOfHuntAndCrossley {
        gravity [m/s^2] = (0, -9.81);
        disk ball { mass [kg] = 1; radius [m] = 0.05; }
        surface floor: half_plane(line(ground(0, -0.05) [m], ground(1, -0.05) [m]));
        contact touch: between(ball.surface, floor) = hunt_crossley(force [N] = 1000, depth [mm] = 10, dissipation [s/m] = 0.2);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.5; ball.angle [rad] = 0; }
        output height [m] = ball.center.y;
        output depth [m] = touch.depth;
        output force [N] = touch.force;
    }
}
