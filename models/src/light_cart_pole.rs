//! Pole on a cart a million times lighter, proposed as a benchmark of stiff mechanical systems.
//!
//! Source: the *light cart-pole*, proposed for the IFToMM library of computational benchmark problems. Data: cart 10⁻⁶ kg on a
//! horizontal rail without friction, bob of 1 kg on a massless pole of 1 m, g = 9.81 m/s², from the horizontal at rest, 10 s.
//! Expected: nothing pushes sideways, so the common centre of mass stays where it is and the bob falls almost freely; at the bottom the
//! cart changes sides within microseconds. With ε = m_c/(m_c + m) and θ from below,
//! θ̇² = 2 (g/l) cos θ / (sin²θ + ε cos²θ): 4 429.4 rad/s at the bottom, and a period that is an integral.

linkwright::mechanism! {
    /// Pole on a cart of a millionth of its mass (light cart-pole).
    ///
    /// 10⁻⁶ kg, 1 kg, 1 m, g = 9.81 m/s², from the horizontal at rest. At the bottom the pole turns with 4 429 rad/s.
    pub planar LightCartPole {
        gravity [m/s^2] = (0, -9.81);
        particle cart { mass [kg] = 1e-6; }
        body pole { mass [kg] = 1; inertia [kg*m^2] = 0; center [m] = (0, -1); }
        joint rail: point_on_line(line(ground(0, 0) [m], ground(1, 0) [m]), cart.center);
        joint pin:  revolute(cart.center, pole.origin);
        start  { rail.travel [m] = 0; rail.speed [m/s] = 0; pole.angle [deg] = 90; pole.rate [rad/s] = 0; }
        expect { degrees_of_freedom = 2; }
        output cart_x [m] = cart.center.x;
        output x [m] = pole.center.x;
        output y [m] = pole.center.y;
        output angle [rad] = pole.angle;
    }
}
