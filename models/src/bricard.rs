//! Bricard's mechanism, problem A04 of the IFToMM library: six revolutes, one degree of freedom, one redundant row.
//!
//! Source: González, Dopico, Lugrís & Cuadrado, *A benchmarking system for MBS simulation software* (2006); IFToMM
//! library of computational benchmark problems, A04. Data: five rods of 1 m, 1 kg and square section of 0.1 m, along the
//! edges of a cube; revolutes y, z, x, y, z, x at (0,0,0), (1,0,0), (1,−1,0), (1,−1,1), (0,−1,1), (0,0,1) m; g = 9.81 m/s²
//! along −y; at rest; 10 s. Grübler's count is 0, yet the mechanism moves: rank 29 of 30 rows all along. Every body's axes
//! are the world's at the start, so that all six angles are zero there. Expected: P3 = (1, −1, 0) at the start and as a
//! separate integration has it; constant energy.

linkwright::mechanism! {
    /// Bricard's mechanism (IFToMM A04): overconstrained, one degree of freedom.
    ///
    /// Outputs are P3, the joint between the second and the third rod, which starts at (1, −1, 0) m.
    pub spatial Bricard {
        gravity [m/s^2] = (0, -9.81, 0);
        box rod_1 { mass [kg] = 1; size [m] = (1, 0.1, 0.1); point from [m] = (-0.5, 0, 0); point to [m] = (0.5, 0, 0); }
        box rod_2 { mass [kg] = 1; size [m] = (0.1, 1, 0.1); point from [m] = (0, 0.5, 0);  point to [m] = (0, -0.5, 0); }
        box rod_3 { mass [kg] = 1; size [m] = (0.1, 0.1, 1); point from [m] = (0, 0, -0.5); point to [m] = (0, 0, 0.5); }
        box rod_4 { mass [kg] = 1; size [m] = (1, 0.1, 0.1); point from [m] = (0.5, 0, 0);  point to [m] = (-0.5, 0, 0); }
        box rod_5 { mass [kg] = 1; size [m] = (0.1, 1, 0.1); point from [m] = (0, -0.5, 0); point to [m] = (0, 0.5, 0); }

        joint hinge_1: revolute(ground(0, 0, 0) [m], rod_1.from, axis = (0, 1, 0));
        joint hinge_2: revolute(rod_1.to, rod_2.from, axis = (0, 0, 1));
        joint hinge_3: revolute(rod_2.to, rod_3.from, axis = (1, 0, 0));
        joint hinge_4: revolute(rod_3.to, rod_4.from, axis = (0, 1, 0));
        joint hinge_5: revolute(rod_4.to, rod_5.from, axis = (0, 0, 1));
        joint hinge_6: revolute(rod_5.to, ground(0, 0, 1) [m], axis = (1, 0, 0));

        start   { hinge_1.angle [rad] = 0; hinge_1.rate [rad/s] = 0;
                  hinge_2.angle [rad] ~ 0; hinge_3.angle [rad] ~ 0; hinge_4.angle [rad] ~ 0;
                  hinge_5.angle [rad] ~ 0; hinge_6.angle [rad] ~ 0; }
        options { redundant = drop; emit = (penalty, projection, null_space); }
        expect  { degrees_of_freedom = 1; }
        output x [m] = rod_2.to.x;
        output y [m] = rod_2.to.y;
        output z [m] = rod_2.to.z;
    }
}
