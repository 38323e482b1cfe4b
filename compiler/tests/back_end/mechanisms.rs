//! The mechanisms of these tests: general enough that no term vanishes.

/// A closed loop of general bodies with springs, a motor and a payload, under Baumgarte's terms.
pub const FOUR_BAR: &str = "planar FourBar {
    param payload [kg] = 2 in 0.5..10;
    param stiffness [N/m] = 30;
    input drive [N*m];
    gravity [m/s^2] = (0.3, -9.81);
    rod crank { mass [kg] = 0.5; length [m] = 0.2; }
    body coupler { mass [kg] = 1; inertia [kg*m^2] = 0.04; center [m] = (0.3, 0.05);
                   point tip [m] = (0.6, 0.02); point eye [m] = (0.2, 0.1); }
    body rocker { mass [kg] = payload; inertia [kg*m^2] = 0.05; center [m] = (0.3, 0.01); point tip [m] = (0.4, 0); }
    joint crank_pin: revolute(ground(0, 0) [m], crank.start);
    joint knee: revolute(crank.end, coupler.origin);
    joint wrist: revolute(coupler.tip, rocker.tip);
    joint rocker_pin: revolute(ground(0.5, 0) [m], rocker.origin);
    force motor: torque(crank_pin) = drive;
    force band: spring(ground(0, 0.7) [m], coupler.eye, stiffness = stiffness, length [m] = 0.3, damping [N*s/m] = 2);
    force coil: torsion_spring(rocker_pin, stiffness [N*m] = 3, angle [rad] = 0.2);
    start { crank_pin.angle [deg] = 90; crank_pin.rate [rpm] = 60; rocker_pin.angle [deg] ~ 70; }
    output swing [rad] = rocker_pin.angle;
    output height [m] = coupler.tip.y;
MORE
}";

/// Two beams that carry one another, the second welded to a section of the first that turns, with damping and a spring on an angle between
/// sections.
pub const BEAMS: &str = "planar Beams {
    param young [MPa] = 2;
    param loss = 0.05;
    gravity [m/s^2] = (0.3, -9.81);
    beam swing { length [m] = 1.1; section = circle(diameter [mm] = 9); young = young; density [kg/m^3] = 2700;
                 modes = (axial = 1, bending = 2); damping_ratio = loss; point third [m] = (0.15, 0); }
    beam arm { length [m] = 0.7; section = tube(outer [mm] = 8, inner [mm] = 6); young [kPa] = 900; mass [kg] = 0.2;
               modes = (axial = 1, bending = 2); shapes = clamped; }
    body knob { mass [kg] = 0.3; inertia [kg*m^2] = 0.002; center [m] = (0.02, 0.03); }
    joint pin: revolute(swing.end, ground(0, 0) [m]);
    joint elbow: revolute(arm.end, swing.third);
    joint weld: fixed(swing.start, knob.origin, angle [rad] = 0.3);
    force coil: torsion_spring(elbow, stiffness [N*m] = 3, angle [rad] = 0.2, damping [N*m*s/rad] = 0.1);
    force band: spring(ground(0.3, 0.7) [m], arm.start, stiffness [N/m] = 30, length [m] = 0.3, damping [N*s/m] = 2);
    start { pin.angle [rad] = 0.4; pin.rate [rad/s] = 1; elbow.angle [rad] = 0.7; elbow.rate [rad/s] = 1; knob.angle [rad] ~ -0.1; }
MORE
}";

/// An open chain in space with a ball, a slide and a hinge.
pub const CHAIN: &str = "spatial Chain {
    param load [kg] = 1.5;
    gravity [m/s^2] = (0.1, 0.2, -9.81);
    body base { mass [kg] = 2; inertia [kg*m^2] = (0.03, 0.04, 0.05); products [kg*m^2] = (0.001, 0.002, 0.003);
                center [m] = (0.05, 0.1, 0.2); point top [m] = (0.1, 0, 0.4); }
    body slide { mass [kg] = load; inertia [kg*m^2] = (0.02, 0.03, 0.02); center [m] = (0, 0.03, 0.1);
                 point end [m] = (0.02, 0, 0.3); }
    cylinder arm { mass [kg] = 1; length [m] = 0.5; radius [m] = 0.05; }
    joint ball: spherical(ground(0, 0, 1) [m], base.origin);
    joint rail: prismatic(base.top, slide.origin, axis = (1, 2, 2));
    joint hinge: revolute(slide.end, arm.start, axis = (0, 1, 1));
    force band: spring(ground(1, 0, 0) [m], arm.end, stiffness [N/m] = 40, length [m] = 0.5);
    start { rail.travel [m] = 0.1; hinge.angle [rad] = 0.5; hinge.rate [rad/s] = 1; }
MORE
}";

/// A closed loop in space that a law drives.
pub const SHAFTS: &str = "spatial Shafts {
    gravity [m/s^2] = (0, 0, -9.81);
    rod crank { mass [kg] = 1; length [m] = 0.3; radius [m] = 0.02; }
    body coupler { mass [kg] = 2; inertia [kg*m^2] = (0.02, 0.2, 0.2); center [m] = (0.4, 0.02, 0); point end [m] = (0.8, 0, 0); }
    body rocker { mass [kg] = 1.5; inertia [kg*m^2] = (0.03, 0.03, 0.01); center [m] = (0.01, 0, 0.2); point end [m] = (0, 0, 0.6); }
    joint crank_pin: revolute(ground(0, 0, 0) [m], crank.start, axis = (0, 0, 1));
    joint cross: universal(crank.end, coupler.origin, axis = (0, 0, 1), second_axis = (0, 1, 0));
    joint ball: spherical(coupler.end, rocker.end);
    joint rocker_pin: revolute(ground(0.9, 0.2, -0.4) [m], rocker.origin, axis = (0.1, 1, 0));
    drive motor: crank_pin.angle = 0.3 [rad] + 2 [rad/s] * time + 0.1 [rad] * sin(3 [rad/s] * time);
    start { rocker_pin.angle [rad] ~ 0.1; cross.angle_1 [rad] ~ -0.1776; }
MORE
}";

/// The definition with these lines at its end.
pub fn with(source: &str, more: &str) -> String {
    source.replace("MORE", more)
}
