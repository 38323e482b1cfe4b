//! A cam with a knife-edge follower that nothing but a spring holds on it: a fast cam loses it and catches it again.
//!
//! Source: data of [`CamFollower`](crate::cam_follower::CamFollower), a 3-4-5 lift of 8 mm by a periodic spline, base circle 40 mm, follower
//! 0.3 kg, spring 4000 N/m with a preload of 60 N; there the follower is tied to the cam, here it touches the cam's profile and does not bounce
//! (restitution 0). It begins 0.02 mm above the cam. Equations: on the cam N cos α = m (ω² s″ + g) + F₀ + k s with tan α = s′/(R + s); in
//! flight m s̈ = −m g − F₀ − k s. Expected: N cos α is the tied follower's force; it stays on the cam below 170.83543238 rad/s, at which it is
//! first lost at 210°; at 190 rad/s it leaves where the tied follower's force would be negative, and flies as that oscillation says.

linkwright::mechanism! {
    /// A cam lifts a knife-edge follower that it may lose.
    pub planar CamLiftOff {
        param mass [kg] = 0.3 in 0.01..10;
        param preload [N] = 60 in 0..10000;
        param stiffness [N/m] = 4000 in 0..1000000;
        param speed [rad/s] = 190 in 0..1000;
        gravity [m/s^2] = (0, -9.81);

        table lift(angle [deg]) [mm] = [
            (0, 0.000), (10, 0.041), (20, 0.284), (30, 0.828), (40, 1.679), (50, 2.773), (60, 4.000), (70, 5.227), (80, 6.321),
            (90, 7.172), (100, 7.716), (110, 7.959), (120, 8.000), (130, 8.000), (140, 8.000), (150, 8.000), (160, 8.000), (170, 8.000),
            (180, 8.000), (190, 7.959), (200, 7.716), (210, 7.172), (220, 6.321), (230, 5.227), (240, 4.000), (250, 2.773), (260, 1.679),
            (270, 0.828), (280, 0.284), (290, 0.041), (300, 0.000), (310, 0.000), (320, 0.000), (330, 0.000), (340, 0.000), (350, 0.000), (360, 0.000)
        ], periodic;

        body cam { mass [kg] = 1; inertia [kg*m^2] = 8e-4; surface lobe: profile(cam.center, radius = lift, base [mm] = 40); }
        body follower { mass [kg] = mass; inertia [kg*m^2] = 0; surface edge: point(follower.center); }
        joint shaft: revolute(ground(0, 0) [m], cam.center);
        joint rail:  prismatic(ground(0, 40) [mm], follower.center, axis = (0, 1));
        contact seat: between(follower.edge, cam.lobe) = rigid(restitution = 0);
        drive motor: shaft.angle = 90 [deg] - speed*time;
        force spring: force(rail) = -preload - stiffness*rail.travel;

        start { rail.travel [mm] = 0.02; rail.speed [m/s] = 0; }
        output travel [m] = rail.travel;
        output gap [m] = seat.gap;
        output contact [N] = seat.force;
        output torque [N*m] = motor.effort;
    }
}
