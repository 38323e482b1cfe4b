//! Free rigid body that spins near its middle principal axis and turns over again and again.
//!
//! Source: Poinsot's motion in closed form, Landau & Lifshitz, *Mechanics*, § 37; shown in orbit by Dzhanibekov (1985). The
//! data are ours: moments of inertia 1, 2 and 3 g m², 0.2 kg, 10 rad/s about the middle axis with small rates about the
//! others, drifting without forces. Expected: rates by Jacobi's elliptic functions, of period 4.66008834689 s; constant
//! energy, momentum and moment of momentum (in world axes).

linkwright::mechanism! {
    /// Free rigid body spinning near its middle axis (Dzhanibekov's effect).
    ///
    /// The rate about y changes sign every 2.33 s.
    pub spatial FreeRigidBody {
        body nut { mass [kg] = 0.2; inertia [kg*m^2] = (1e-3, 2e-3, 3e-3); }
        start  { nut.center.x [m] = 0; nut.center.y [m] = 0; nut.center.z [m] = 0;
                 nut.center.velocity.x [m/s] = 0.1; nut.center.velocity.y [m/s] = -0.2; nut.center.velocity.z [m/s] = 0.3;
                 nut.orientation = (1, 0, 0, 0);
                 nut.rate.x [rad/s] = 0.02; nut.rate.y [rad/s] = 10; nut.rate.z [rad/s] = 0.03; }
        expect { degrees_of_freedom = 6; }
        output rate_x [rad/s] = nut.rate.x;
        output rate_y [rad/s] = nut.rate.y;
        output rate_z [rad/s] = nut.rate.z;
    }
}
