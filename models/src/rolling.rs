//! A disk and a ball that are pushed along a floor without turning, and roll in the end.
//!
//! Closed forms with exact Coulomb friction, μ = 0.2 and g = 9.81 m/s², from 3 m/s: with the gyration J = k m r² the speed of the centre when
//! rolling begins is v₀/(1 + k), 2/3 of v₀ for a disk and 5/7 for a ball, whatever friction is, after v₀ k/((1 + k) μ g). The disk rolls at
//! 0.509683995922528 s, with 2 m/s and at 1.27420998990632 m, the ball at 0.436871996505024 s, with 2.142857142857143 m/s and at
//! 1.12338513387006 m. Friction that is made smooth by v_s is off by the order of v_s. Law: García de Jalón & Bayo, *Kinematic and Dynamic
//! Simulation of Multibody Systems*, 10.1.

linkwright::mechanism! {
    /// A disk that slides at 3 m/s and comes to roll.
    pub planar SlidingDisk {
        param smooth [m/s] = 1e-3;
        gravity [m/s^2] = (0, -9.81);
        disk wheel { mass [kg] = 2; radius [m] = 0.1; }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        #[allow(penetration)]
        contact touch: between(wheel.surface, floor) = kelvin_voigt(stiffness [N/m] = 1.962e7, damping [N*s/m] = 4000);
        friction grip: on(touch) = coulomb(coefficient = 0.2, speed = smooth);
        // As deep as its weight presses it, 1 µm.
        start { wheel.center.x [m] = 0; wheel.center.y [m] = 0.099999; wheel.angle [rad] = 0; wheel.center.velocity.x [m/s] = 3; }
        output place [m] = wheel.center.x;
        output speed [m/s] = wheel.center.velocity.x;
        output rate [rad/s] = wheel.rate;
        output sliding [m/s] = touch.sliding;
        output pressed [N] = grip.normal;
        output gripping [N] = grip.force;
        output lost [W] = -power(grip);
    }
}

linkwright::mechanism! {
    /// A ball that slides at 3 m/s and comes to roll.
    pub spatial SlidingBall {
        param smooth [m/s] = 1e-3;
        gravity [m/s^2] = (0, 0, -9.81);
        sphere ball { mass [kg] = 2; radius [m] = 0.1; }
        surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));
        #[allow(penetration)]
        contact touch: between(ball.surface, floor) = kelvin_voigt(stiffness [N/m] = 1.962e7, damping [N*s/m] = 4000);
        friction grip: on(touch) = coulomb(coefficient = 0.2, speed = smooth);
        // As deep as its weight presses it, 1 µm.
        start { ball.center.x [m] = 0; ball.center.y [m] = 0; ball.center.z [m] = 0.099999; ball.center.velocity.x [m/s] = 1.8;
                ball.center.velocity.y [m/s] = 2.4; }
        output speed_x [m/s] = ball.center.velocity.x;
        output speed_y [m/s] = ball.center.velocity.y;
        output place_x [m] = ball.center.x;
        output place_y [m] = ball.center.y;
        output sliding_x [m/s] = touch.sliding.x;
        output sliding_y [m/s] = touch.sliding.y;
        output sliding_z [m/s] = touch.sliding.z;
        output pressed [N] = grip.normal;
        output lost [W] = -power(grip);
    }
}
