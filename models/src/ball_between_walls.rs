//! A ball that flies between two rigid walls.
//!
//! Data: 1 kg, 1 m/s, walls 1 m apart, no gravity, restitution 0.9999. Expected: the energy is e²ⁿ of that at the start after n touches, of which
//! none is lost.

linkwright::mechanism! {
    /// A ball between two walls, with nothing else.
    pub planar BallBetweenWalls {
        param restitution [1] = 0.9999;
        particle ball { mass [kg] = 1; }
        surface spot: point(ball.center);
        surface left: half_plane(line(ground(0, 1) [m], ground(0, 0) [m]));
        surface right: half_plane(line(ground(1, 0) [m], ground(1, 1) [m]));
        contact on_left: between(spot, left) = rigid(restitution = restitution);
        contact on_right: between(spot, right) = rigid(restitution = restitution);
        start { ball.center.x [m] = 0.3; ball.center.y [m] = 0; ball.center.velocity.x [m/s] = 1; }
        output place [m] = ball.center.x;
        output speed [m/s] = ball.center.velocity.x;
    }
}
