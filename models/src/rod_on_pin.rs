//! A rod that swings on a pin with Coulomb friction by the pin's own reaction, which the friction changes in turn.
//!
//! Source: S. Bai, lecture *Dynamics*, equations (2.19) and (2.20). Data: 1 kg, 1 m, uniform; radius of the pin 20 mm, coefficient 0.3,
//! regularised by 0.05 rad/s; released from the horizontal at rest, g = 9.81 m/s². With R the size of the force in the pin
//!
//! ```text
//! J θ̈ = m g l sin θ/2 − μ r R ω/√(ω² + ω_s²),   R = |m (a − g)|
//! ```
//! Expected, of a separate integration with R as the root of its own equation: at 0.5 s −0.07538258597272893 rad from the hanging position,
//! −5.328482822176402 rad/s and R = 23.978525122752 N; at 2 s 1.394840518942144 rad, −1.326132556068865 rad/s and a work of friction
//! of −0.565512063293147 J; at 5 s −0.67153652690997, 3.87609307103845 and −1.33594432228301 J.

linkwright::mechanism! {
    /// A rod on a pin with friction by the pin's reaction, released from the horizontal.
    pub planar RodOnPin {
        gravity [m/s^2] = (0, -9.81);
        param coefficient = 0.3 in 0..1;
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pin: revolute(ground(0, 0) [m], arm.start);
        friction rub: on(pin) = coulomb(coefficient = coefficient, radius [mm] = 20, speed [rad/s] = 0.05);
        /// The work of friction.
        state work [J] = 0;
        rate work = power(rub);
        start { pin.angle [deg] = 0; pin.rate [rad/s] = 0; }
        options { emit = (tangent); }
        output angle [rad] = pin.angle;
        output rate [rad/s] = pin.rate;
        output pressed [N] = rub.normal;
        output resisting [N*m] = rub.torque;
        output work [J] = work;
        output energy [J] = energy;
    }
}
