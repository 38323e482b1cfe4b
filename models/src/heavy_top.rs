//! Heavy top: a spinning body on a fixed point.
//!
//! Source: Géradin & Cardona, *Flexible Multibody Dynamics* (2001); Brüls & Cardona, *On the use of Lie group time
//! integrators in multibody dynamics* (2010). Data: 15 kg, moments of inertia 0.234375, 0.46875, 0.234375 kg m² about the
//! centre, which is 1 m along y from the fixed point; g = 9.81 m/s² along −z; axes along the world's at the start, body
//! rates (0, 150, −4.61538) rad/s. Expected: quaternion (w, x, y, z) at 2 s
//! (0.12294713504155, −0.49107989255038, 0.35043003034356, −0.78798688755028), computed at 3e-14; constant energy,
//! constant moment of momentum about z and about the body's y.

linkwright::mechanism! {
    /// Heavy top of Géradin & Cardona: 15 kg, centre 1 m from the fixed point, spinning at 150 rad/s.
    ///
    /// Outputs are the place of the centre and the body's rates.
    pub spatial HeavyTop {
        gravity [m/s^2] = (0, 0, -9.81);
        body top { mass [kg] = 15; inertia [kg*m^2] = (0.234375, 0.46875, 0.234375); center [m] = (0, 1, 0); }
        joint tip: spherical(ground(0, 0, 0) [m], top.origin);
        start  { top.orientation = (1, 0, 0, 0);
                 top.rate.x [rad/s] = 0; top.rate.y [rad/s] = 150; top.rate.z [rad/s] = -4.61538; }
        expect { degrees_of_freedom = 3; }
        output x [m] = top.center.x;
        output y [m] = top.center.y;
        output z [m] = top.center.z;
        output rate_x [rad/s] = top.rate.x;
        output rate_y [rad/s] = top.rate.y;
        output rate_z [rad/s] = top.rate.z;
    }
}
