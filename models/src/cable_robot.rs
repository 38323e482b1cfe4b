//! A point that hangs on three cables from exits at one height: ideal cords whose winches follow an ellipse, the same from rest and
//! back, and elastic cables with winches as inputs.
//!
//! Source: trajectory planning of cable-suspended robots (Gosselin, *Global planning of dynamically feasible trajectories for
//! three-DOF spatial cable-suspended parallel robots*, CableCon 2012; Jiang, Gosselin, *Dynamic point-to-point trajectory planning of a
//! three-DOF cable-suspended parallel robot*, IEEE Trans. Robotics 32, 2016). Data, completed here: exits (1.2, 0, 0), (−0.5, 1, 0),
//! (−0.6, −0.9, 0) m, 2 kg, 9.81 m/s², a centre (0.05, 0.02, −1.5) m, a horizontal ellipse with the half axes 0.9 m and 0.5 m, EA 20 kN.
//!
//! Expected: at ω = √(g/h) with h = 1.5 m, the depth of the centre below the exits, the tensions are T = m (g/h) μ l, where μ are the
//! coordinates (0.34324324, 0.32162162, 0.33513514) of the centre in the triangle of the exits and l the lengths, for whatever ellipse:
//! 6.8279159897, 9.6965848507, 10.2793491125 N at the start; at rest in the centre 8.486334996, 7.884712728, 8.223016614 N. All three pull
//! for ω between 1.4732256597 and 3.3029692938 rad/s. With half axes (0.5, 0.1, 0.3) m and (0, 0.5, −0.2) m the tensions lie
//! between 5.9991 N and 11.0534 N. Elastic cables of the lengths l/(1 + T/EA) stay on the ellipse; of the lengths l they leave it by at
//! most 3.63129e-3 m in one period, and the point is after 1 s at (−0.7000049894, 0.2966655023, −1.5016248313) m with the velocity
//! (−1.3016944042, −1.0570882042, −0.0510793912) m/s (a separate integration of order 8, 1e-13).

linkwright::mechanism! {
    /// A point on three cords whose lengths follow an ellipse, centre + a cos ωt + b sin ωt.
    pub spatial CableRobot {
        param omega [rad/s] = 2.557342370508884 in 0..20;
        param a_x [m] = 0.9;
        param a_y [m] = 0;
        param a_z [m] = 0;
        param b_x [m] = 0;
        param b_y [m] = 0.5;
        param b_z [m] = 0;
        gravity [m/s^2] = (0, 0, -9.81);

        /// A cord from an exit, as long as it is from there to a point that moves.
        part Winch(x [m], y [m], load: place, at_x [m], at_y [m], at_z [m]) {
            joint cord: cord(ground(x, y, 0 [m]), load, length = sqrt((at_x - x)^2 + (at_y - y)^2 + at_z^2));
            output tension [N] = cord.tension;
        }

        signal x [m] = 0.05 [m] + a_x*cos(omega*time) + b_x*sin(omega*time);
        signal y [m] = 0.02 [m] + a_y*cos(omega*time) + b_y*sin(omega*time);
        signal z [m] = -1.5 [m] + a_z*cos(omega*time) + b_z*sin(omega*time);
        particle load { mass [kg] = 2; }
        part first:  Winch(x [m] = 1.2,  y [m] = 0,    load = load.center, at_x = x, at_y = y, at_z = z);
        part second: Winch(x [m] = -0.5, y [m] = 1,    load = load.center, at_x = x, at_y = y, at_z = z);
        part third:  Winch(x [m] = -0.6, y [m] = -0.9, load = load.center, at_x = x, at_y = y, at_z = z);

        start {
            load.center.x ~ 0.05 [m] + a_x;
            load.center.y ~ 0.02 [m] + a_y;
            load.center.z ~ -1.5 [m] + a_z;
        }
        expect { degrees_of_freedom = 0; }
        output x [m] = load.center.x;
        output y [m] = load.center.y;
        output z [m] = load.center.z;
    }
}

linkwright::mechanism! {
    /// The same from rest in the centre onto the ellipse and back: its size goes from zero to one within `rise`, stays for `hold`
    /// and goes back within `rise`, each time as 10 s³ − 15 s⁴ + 6 s⁵.
    pub spatial CableRobotFromRest {
        param omega [rad/s] = 2.557342370508884;
        param rise [s] = 6 in 0.1..100;
        param hold [s] = 5 in 0..100;
        gravity [m/s^2] = (0, 0, -9.81);

        part Winch(x [m], y [m], load: place, at_x [m], at_y [m]) {
            joint cord: cord(ground(x, y, 0 [m]), load, length = sqrt((at_x - x)^2 + (at_y - y)^2 + (1.5 [m])^2));
            output tension [N] = cord.tension;
        }

        signal up [1] = clamp(time/rise, 0, 1);
        signal down [1] = clamp((time - rise - hold)/rise, 0, 1);
        signal size [1] = up^3*(10 - 15*up + 6*up^2) - down^3*(10 - 15*down + 6*down^2);
        signal x [m] = 0.05 [m] + 0.9 [m]*size*cos(omega*time);
        signal y [m] = 0.02 [m] + 0.5 [m]*size*sin(omega*time);
        particle load { mass [kg] = 2; }
        part first:  Winch(x [m] = 1.2,  y [m] = 0,    load = load.center, at_x = x, at_y = y);
        part second: Winch(x [m] = -0.5, y [m] = 1,    load = load.center, at_x = x, at_y = y);
        part third:  Winch(x [m] = -0.6, y [m] = -0.9, load = load.center, at_x = x, at_y = y);

        start { load.center.x [m] ~ 0.05; load.center.y [m] ~ 0.02; load.center.z [m] ~ -1.5; }
        expect { degrees_of_freedom = 0; }
        output x [m] = load.center.x;
        output y [m] = load.center.y;
        output z [m] = load.center.z;
    }
}

linkwright::mechanism! {
    /// A point on three elastic cables. Winches let them out by what is given from outside, beyond lengths at which they are just taut
    /// at the start.
    pub spatial ElasticCableRobot {
        param stiffness [kN] = 20 in 0.01..1000;
        gravity [m/s^2] = (0, 0, -9.81);
        particle load { mass [kg] = 2; }
        repeat i in 0..3 { input let_out[i] [m]; }
        cable first:  cable(ground(1.2, 0, 0) [m],     load.center, stiffness = stiffness, length = 1.520822146078 [m] + let_out[0]);
        cable second: cable(ground(-0.5, 1, 0) [m],    load.center, stiffness = stiffness, length = 2.304972884873 [m] + let_out[1]);
        cable third:  cable(ground(-0.6, -0.9, 0) [m], load.center, stiffness = stiffness, length = 2.344973347397 [m] + let_out[2]);
        // On the ellipse, at its velocity.
        start {
            load.center.x [m] = 0.95;
            load.center.y [m] = 0.02;
            load.center.z [m] = -1.5;
            load.center.velocity.x [m/s] = 0;
            load.center.velocity.y [m/s] = 1.278671185254442;
            load.center.velocity.z [m/s] = 0;
        }
        options { emit = (tangent); }
        output first_tension [N] = first.tension;
        output second_tension [N] = second.tension;
        output third_tension [N] = third.tension;
    }
}
