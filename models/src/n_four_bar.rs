//! Ladders of four-bars, problem A02 of the IFToMM library: N windows of unit rods.
//!
//! Source: González, Dopico, Lugrís & Cuadrado, *A benchmarking system for MBS simulation software* (2006); the library
//! asks for N = 2 and 10 s, the original for N = 40 and 20 s. Data: 2N + 1 uniform rods of 1 m and 1 kg, ground pins
//! 1 m apart, g = 9.81 m/s², cranks vertical, their upper pins moving at +1 m/s. B0 is the upper pin of the first crank.
//! Expected: one degree of freedom, N + 1 of them at each passage where all rods are horizontal; N = 2 at 10 s has B0 at
//! (0.328458111540815379, 0.944518538178600962) m, velocity (1.423051470206944, −0.494868845487043) m/s (exact).

macro_rules! n_four_bar {
    ($(#[$documentation:meta])* $name:ident, $windows:literal $(, emit = $emit:tt)?) => {
        linkwright::mechanism! {
            $(#[$documentation])*
            pub planar $name {
                const N = $windows;
                gravity [m/s^2] = (0, -9.81);
                repeat i in 0..N+1 {
                    rod crank[i] { mass [kg] = 1; length [m] = 1; }
                    joint pin[i]: revolute(ground(i, 0) [m], crank[i].start);
                }
                repeat i in 0..N {
                    rod coupler[i] { mass [kg] = 1; length [m] = 1; }
                    joint left[i]:  revolute(crank[i].end, coupler[i].start);
                    joint right[i]: revolute(coupler[i].end, crank[i+1].end);
                    start { coupler[i].angle [rad] ~ 0; pin[i+1].angle [deg] ~ 90; }
                }
                start  { pin[0].angle [deg] = 90; pin[0].rate [rad/s] = -1; }
                $(options { emit = $emit; })?
                expect { degrees_of_freedom = 1; }
                output x [m] = crank[0].end.x;
                output y [m] = crank[0].end.y;
                output velocity_x [m/s] = crank[0].end.velocity.x;
                output velocity_y [m/s] = crank[0].end.velocity.y;
            }
        }
    };
}

n_four_bar! {
    /// Two windows of unit rods (IFToMM A02).
    NFourBar2, 2, emit = (penalty, projection, null_space)
}

n_four_bar! {
    /// Ten windows of unit rods (IFToMM A02).
    NFourBar10, 10, emit = (penalty, projection, null_space)
}

n_four_bar! {
    /// Forty windows of unit rods (IFToMM A02).
    NFourBar40, 40, emit = (null_space)
}
