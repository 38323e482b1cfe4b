//! A four-bar with Coulomb friction in its four pins by their reactions, and three of them in a row.
//!
//! Source: S. Bai, lecture *Dynamics*, equations (2.19) and (2.20), as system of equations of J. García de Jalón, E. Bayo, *Kinematic and Dynamic
//! Simulation of Multibody Systems*, 10.1. Data: links of 0.2, 0.5 and 0.4 m, 1, 2.5 and 2 kg, ground 0.6 m; pins of 15 mm with a coefficient of 0.2,
//! regularised by 0.05 rad/s; 2 N m on the crank. Expected: the energy and the work of the motor and of friction close, and the equations
//! of motion hold with the friction of the reactions that they have.

linkwright::mechanism! {
    /// A four-bar with friction in its four pins by their reactions.
    pub planar RubbingFourBar {
        gravity [m/s^2] = (0, -9.81);
        param coefficient = 0.2 in 0..1;
        param radius [mm] = 15 in 0..50;
        rod crank   { mass [kg] = 1;   length [m] = 0.2; }
        rod coupler { mass [kg] = 2.5; length [m] = 0.5; }
        rod rocker  { mass [kg] = 2;   length [m] = 0.4; }
        joint a: revolute(ground(0, 0) [m], crank.start);
        joint b: revolute(crank.end, coupler.start);
        joint c: revolute(coupler.end, rocker.end);
        joint d: revolute(ground(0.6, 0) [m], rocker.start);
        friction fa: on(a) = coulomb(coefficient = coefficient, radius = radius, speed [rad/s] = 0.05);
        friction fb: on(b) = coulomb(coefficient = coefficient, radius = radius, speed [rad/s] = 0.05);
        friction fc: on(c) = coulomb(coefficient = coefficient, radius = radius, speed [rad/s] = 0.05);
        friction fd: on(d) = coulomb(coefficient = coefficient, radius = radius, speed [rad/s] = 0.05);
        torque motor: torque(a) = 2 [N*m];
        /// The work of the motor and of all friction.
        state given [J] = 0;
        state lost [J] = 0;
        rate given = power(motor);
        rate lost = -power(fa) - power(fb) - power(fc) - power(fd);
        start { a.angle [deg] = 60; a.rate [rad/s] = 6; rocker.angle [deg] ~ 98; }
        expect { degrees_of_freedom = 1; }
        output crank_rate [rad/s] = a.rate;
        output pressed [N] = fa.normal;
        output losses [W] = -power(fa) - power(fb) - power(fc) - power(fd);
        output given [J] = given;
        output lost [J] = lost;
        output energy [J] = energy;
    }
}

linkwright::mechanism! {
    /// Three four-bars in a row, driven by one crank, with friction in all ten pins by their reactions.
    pub planar RubbingFourBars {
        const N = 3;
        gravity [m/s^2] = (0, -9.81);
        repeat i in 0..N+1 {
            rod upright[i] { mass [kg] = 1; length [m] = 1; }
            joint foot[i]: revolute(ground(i, 0) [m], upright[i].start);
            friction f_foot[i]: on(foot[i]) = coulomb(coefficient = 0.2, radius [mm] = 15, speed [rad/s] = 0.05);
        }
        repeat i in 0..N {
            rod top[i] { mass [kg] = 1; length [m] = 1.1; }
            joint left[i]:  revolute(upright[i].end, top[i].start);
            joint right[i]: revolute(top[i].end, upright[i+1].end);
            friction f_left[i]:  on(left[i])  = coulomb(coefficient = 0.2, radius [mm] = 15, speed [rad/s] = 0.05);
            friction f_right[i]: on(right[i]) = coulomb(coefficient = 0.2, radius [mm] = 15, speed [rad/s] = 0.05);
        }
        start { foot[0].angle [deg] = 80; foot[0].rate [rad/s] = 1; }
        repeat i in 1..N+1 { start { upright[i].angle [deg] ~ 70; } }
        expect { degrees_of_freedom = 1; }
        output angle [rad] = foot[0].angle;
        output pressed [N] = f_foot[0].normal;
        output energy [J] = energy;
    }
}
