//! Change-point (folding) four-bar: all four links can lie in one line.
//!
//! Source: folding four-bars of any textbook of mechanisms; the lengths are ours. Data: ground 4, crank 1, coupler 2,
//! rocker 3 m, the limit l + s = p + q of Grashof's rule (4 + 1 = 2 + 3); uniform rods of 1 kg/m, g = 9.81 m/s². It
//! starts at a crank angle of 90°, away from the change point at 180°, where D loses rank and the motion is undetermined
//! for an instant. Expected: a start at 180° is refused; a motion that passes 180° quickly keeps its energy.

linkwright::mechanism! {
    /// Four-bar at the limit of Grashof's rule: 4 + 1 = 2 + 3 m.
    ///
    /// Uniform rods of 1 kg/m under gravity. With the crank at 180° all links lie in one line and a second branch of
    /// motion meets the first; the start is at 90°.
    pub planar ChangePointFourBar {
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 2; length [m] = 2; }
        rod rocker  { mass [kg] = 3; length [m] = 3; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(4, 0) [m], rocker.start);
        joint left:  revolute(crank.end, coupler.start);
        joint right: revolute(coupler.end, rocker.end);
        start  { crank_pin.angle [deg] = 90; crank_pin.rate [rad/s] = 4;
                 rocker_pin.angle [deg] ~ 145; coupler.angle [deg] ~ 20; }
        options { emit = (penalty, projection, null_space); }
        expect { degrees_of_freedom = 1; rotates = crank_pin; }
        output crank_angle [rad] = crank_pin.angle;
        output rocker_angle [rad] = rocker_pin.angle;
    }
}
