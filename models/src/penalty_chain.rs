//! A chain whose pins yield, for the explicit solver of the tracked-vehicle model validated on an N-post motion simulator.
//!
//! Its joints are those of equations (28)–(32) there: a spring of stiffness k_p and a damper of c_p along the line between the two connection
//! points, in place of the constraint; its integrator is `ExplicitTrapezoidal`. No numbers are printed for such a chain. Data: five rods of 0.1 kg and
//! 0.2 m, released at rest 30 degrees from the vertical, in one line, k_p = 1e4 N/m and c_p = 10 N s/m by default.
//! Expected: as k_p grows the motion is that of the same chain with constraints, whose tip is after 1 s, of a separate integration, where
//! `tests/checks/published/penalties.rs` says; the difference falls with 1/k_p.

linkwright::mechanism! {
    /// Five rods on pins that yield.
    pub planar PenaltyChain {
        param stiffness [N/m] = 1e4 in 1e3..1e9;
        param damping [N*s/m] = 10 in 0..1e4;
        /// Below it damping fades.
        param smallest [m] = 1e-5 in 1e-12..1;
        gravity [m/s^2] = (0, -9.81);
        repeat i in 0..5 {
            rod link[i] { mass [kg] = 0.1; length [m] = 0.2; }
        }
        joint pin[0]: revolute(ground(0, 0) [m], link[0].start)
            = penalty(stiffness = stiffness, damping = damping, damping_along = line, smallest = smallest);
        repeat i in 1..5 {
            joint pin[i]: revolute(link[i - 1].end, link[i].start)
                = penalty(stiffness = stiffness, damping = damping, damping_along = line, smallest = smallest);
        }
        repeat i in 0..5 {
            start { link[i].angle [deg] = -60; link[i].rate [rad/s] = 0; }
        }
        expect { degrees_of_freedom = 15; }
        output tip_x [m] = link[4].end.x;
        output tip_y [m] = link[4].end.y;
        output energy [J] = energy;
        output pulled [N] = pin[0].reaction.size;
    }
}
