//! A strip of aluminium that falls on a hinge and bends, and the same strip on two hinges.
//!
//! Source: the floating frame of reference with free–free modes as in Shabana, *Dynamics of Multibody Systems*, 5; a geometrically exact
//! rod in comparison (inextensible, converged): tip at (−0.09016, −0.99593) m after 0.5 s and at (−0.999966, −0.00821) m after 1 s.
//! Data: 1 m, 20 mm × 4 mm, E = 70 GPa, 2700 kg/m³, g = 9.81 m/s²; from the horizontal, straight and at rest. Expected, with one, three
//! and five bending modes at 1 s: tip at (−0.9999737552, −0.0072449298), (−0.9999671380, −0.0081072680) and (−0.9999676327,
//! −0.0080469813) m: most of what three modes leave is the moment that a free shape cannot carry at a hinge.
//!
//! Between two hinges a beam has the frequencies k²π² √(EI/μL⁴). Free shapes do not know of the hinges; with 1, 3 and 5 of them the first
//! frequency of a round bar of steel of 350 mm and 7 mm is 117.19, 115.91 and 115.70 Hz, in place of 115.59 Hz.

linkwright::mechanism! {
    /// Pendulum of a flexible strip, three bending modes.
    ///
    /// 1 m, 20 mm × 4 mm of aluminium, from the horizontal at rest. After 1 s its tip is at (−0.9999671380, −0.0081072680) m.
    pub planar FlexiblePendulum {
        gravity [m/s^2] = (0, -9.81);
        beam strip { length [m] = 1; section = rectangle(height [mm] = 4, width [mm] = 20); young [GPa] = 70;
                     density [kg/m^3] = 2700; modes = (bending = 3); }
        joint hinge: revolute(ground(0, 0) [m], strip.start);
        start   { strip.angle [rad] = 0; strip.rate [rad/s] = 0; }
        options { emit = (tangent); }
        expect  { degrees_of_freedom = 4; }
        output tip_x [m] = strip.end.x;
        output tip_y [m] = strip.end.y;
        output angle [rad] = strip.angle;
        output bend [m] = strip.bending[0];
        output stored [J] = energy;
    }
}

linkwright::mechanism! {
    /// A round bar of steel between two hinges, the second of which slides, with three bending modes of the free bar.
    pub planar HingedBar {
        beam bar { length [mm] = 350; section = circle(diameter [mm] = 7); young [GPa] = 207; density [kg/m^3] = 7801;
                   modes = (bending = 3); }
        joint left:  revolute(ground(0, 0) [m], bar.start);
        joint right: point_on_line(line(ground(0, 0) [m], ground(1, 0) [m]), bar.end);
        start   { bar.angle [rad] ~ 0; }
        options { emit = (tangent); }
        expect  { degrees_of_freedom = 3; }
        output middle [mm] = bar.center.y;
    }
}

linkwright::mechanism! {
    /// The same bar with one mode, whose first frequency is 1.4 % too high.
    pub planar HingedBarOfOne {
        beam bar { length [mm] = 350; section = circle(diameter [mm] = 7); young [GPa] = 207; density [kg/m^3] = 7801;
                   modes = (bending = 1); }
        joint left:  revolute(ground(0, 0) [m], bar.start);
        joint right: point_on_line(line(ground(0, 0) [m], ground(1, 0) [m]), bar.end);
        start   { bar.angle [rad] ~ 0; }
        options { emit = (tangent); }
        expect  { degrees_of_freedom = 1; }
        output middle [mm] = bar.center.y;
    }
}

linkwright::mechanism! {
    /// The same bar with five modes, whose first frequency is 0.1 % too high.
    pub planar HingedBarOfFive {
        beam bar { length [mm] = 350; section = circle(diameter [mm] = 7); young [GPa] = 207; density [kg/m^3] = 7801;
                   modes = (bending = 5); }
        joint left:  revolute(ground(0, 0) [m], bar.start);
        joint right: point_on_line(line(ground(0, 0) [m], ground(1, 0) [m]), bar.end);
        start   { bar.angle [rad] ~ 0; }
        options { emit = (tangent); }
        expect  { degrees_of_freedom = 5; }
        output middle [mm] = bar.center.y;
    }
}

linkwright::mechanism! {
    /// The same bar in its own shapes, which are sines.
    pub planar HingedBarOfSines {
        beam bar { length [mm] = 350; section = circle(diameter [mm] = 7); young [GPa] = 207; density [kg/m^3] = 7801;
                   modes = (bending = 3); shapes = pinned; }
        joint left:  revolute(ground(0, 0) [m], bar.start);
        joint right: point_on_line(line(ground(0, 0) [m], ground(1, 0) [m]), bar.end);
        start   { bar.angle [rad] ~ 0; }
        options { emit = (tangent); }
        expect  { degrees_of_freedom = 3; }
        output middle [mm] = bar.center.y;
    }
}
