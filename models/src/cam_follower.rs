//! A cam with a knife-edge follower on its axis, by a table of its lift.
//!
//! Source: the 3-4-5 polynomial of any textbook of cams (Norton, *Design of Machinery*, ch. 8); the numbers are ours. Data: lift 8 mm, rise
//! from 0 to 120°, dwell to 180°, fall to 300°, dwell to 360°, h (10 x³ − 15 x⁴ + 6 x⁵) every 10°, rounded to 1 µm, joined by the periodic cubic
//! spline; follower 0.3 kg above the cam, spring 4000 N/m with a preload of 60 N, g = 9.81 m/s²; the cam turns at 100 rad/s. Equations: contact
//! force N = m (ω² s″ + g) + F₀ + k s, torque N s′. Expected: s, s′, s″ at 25° 5.163118787913e-4 m, 3.116271481205e-3 and 1.042307330591e-2 m
//! (a radian), at 200° 7.716e-3, −2.2085435173e-3, −1.03805192052e-2; N at 0, 25, 95, 200° 63.56693982519, 96.27746743289, 61.60853256711,
//! 62.66544238441 N, least 60.2341177801 N, at 210°; 0.571793472471 N m at 45°; the follower first leaves the cam at 170.83543238 rad/s, at 210°.
//! Of SciPy's periodic spline.

linkwright::mechanism! {
    /// A cam lifts a knife-edge follower against a spring.
    ///
    /// `contact` is positive while the cam pushes. Where it is negative, a real follower would leave the cam.
    pub planar CamFollower {
        param mass [kg] = 0.3 in 0.01..10;
        param preload [N] = 60 in 0..10000;
        param stiffness [N/m] = 4000 in 0..1000000;
        param speed [rad/s] = 100 in -1000..1000;
        gravity [m/s^2] = (0, -9.81);

        table lift(angle [deg]) [mm] = [
            (0, 0.000), (10, 0.041), (20, 0.284), (30, 0.828), (40, 1.679), (50, 2.773), (60, 4.000), (70, 5.227), (80, 6.321),
            (90, 7.172), (100, 7.716), (110, 7.959), (120, 8.000), (130, 8.000), (140, 8.000), (150, 8.000), (160, 8.000), (170, 8.000),
            (180, 8.000), (190, 7.959), (200, 7.716), (210, 7.172), (220, 6.321), (230, 5.227), (240, 4.000), (250, 2.773), (260, 1.679),
            (270, 0.828), (280, 0.284), (290, 0.041), (300, 0.000), (310, 0.000), (320, 0.000), (330, 0.000), (340, 0.000), (350, 0.000), (360, 0.000)
        ], periodic;

        disk cam      { mass [kg] = 1; radius [mm] = 40; }
        body follower { mass [kg] = mass; inertia [kg*m^2] = 0; }
        joint shaft: revolute(ground(0, 0) [m], cam.center);
        joint rail:  prismatic(ground(0, 40) [mm], follower.center, axis = (0, 1));
        constraint follow: rail.travel = lift(shaft.angle);
        drive motor: shaft.angle = speed*time;
        force spring: force(rail) = -preload - stiffness*rail.travel;

        expect { degrees_of_freedom = 1; follow.effort > 0; }
        output travel [m] = rail.travel;
        output steep [m/rad] = lift.slope(shaft.angle);
        output contact [N] = follow.effort;
        output torque [N*m] = motor.effort;
    }
}
