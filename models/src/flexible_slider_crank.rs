//! Slider-crank whose connecting rod bends and stretches, at 150 rad/s.
//!
//! Source: B. Simeon, Modelling a flexible slider crank mechanism by a mixed system of DAEs and PDEs, *Mathematical Modelling of Systems* 2, 1996,
//! 1–18; F. Mazzia, C. Magherini, *Test Set for Initial Value Problem Solvers*, problem crank, for the numbers. Data: crank 0.15 m, rod 0.3 m of
//! steel, 8 mm square, E = 200 GPa, 7870 kg/m³, slider 0.075552 kg, no gravity, linear stiffness, no damping; two sines across and a quadratic
//! element along, close to a smooth motion at the start, where the element's middle is at 0.0103339863 mm and its end at 0.0169327969 mm.
//!
//! The test set prints φ₂ = −0.3311734988256, x₃ = 0.1697373328428 m and modes of 1.893192899614e-4, 2.375751249879e-5, −5.323896770570e-6,
//! −8.363313279112e-6 m at 0.1 s, and these follow from a mistake: the block of the element in its mass matrix is ρAl (8, 1; 1, 2) where the
//! integrals of the two functions are ρAl (8, 1; 1, 2)/15: with the block as printed a run of ours has the printed values, φ₂ to 1e-12 and the
//! modes to 5e-11 m. With the integrals it is at φ₂ = −0.3311734303, x₃ = 0.1697373958 m, and without the rotary inertia of the sections, m h²/12,
//! which the test set has in J₂ and this beam has not, at −0.3311734301, 0.1697373961 m with modes of 1.893081e-4 and 2.376202e-5 m across
//! (extrapolation of midpoint rules with quadrature of |ṙ|², steps of 20 and 40 µs).

linkwright::mechanism! {
    /// Slider-crank at 150 rad/s with an elastic rod, two modes across and a quadratic element along.
    ///
    /// After 0.1 s the rod is at φ = −0.3311734301, the slider at x = 0.1697373961 m.
    pub planar FlexibleSliderCrank {
        const L [m] = 0.15;
        body crank  { mass [kg] = 0.36; inertia [kg*m^2] = 0.002727; point pin [m] = (L, 0); }
        beam rod    { length [m] = 0.3; section = rectangle(height [mm] = 8, width [mm] = 8); young [GPa] = 200;
                      density [kg/m^3] = 7870; modes = (axial = quadratic, bending = 2); shapes = pinned; }
        body slider { mass [kg] = 0.075552; inertia [kg*m^2] = 1e-5; }

        joint axle:  revolute(ground(0, 0) [m], crank.origin);
        joint big:   revolute(crank.pin, rod.start);
        joint wrist: revolute(rod.end, slider.center);
        joint guide: prismatic(ground(0, 0) [m], slider.center, axis = (1, 0));
        drive motor: axle.angle = 150 [rad/s]*time;

        // Middle and end of the element are 1.00560 and 1.42279 of the first mode, −0.99437 and 2.44452 of the second.
        start   { rod.angle [rad] ~ 0; guide.travel [m] ~ 0.45;
                  rod.axial[0] [m] = 1.086993702924985e-5; rod.axial[1] [m] = 6.001678417859092e-7;
                  rod.axial[0].rate [m/s] = -1.817703882001260e-6; rod.axial[1].rate [m/s] = -4.220436261524336e-8;
                  rod.bending[0].rate [m/s] = 0.444896105; rod.bending[1].rate [m/s] = 0.00463434311; }
        options { emit = (tangent); }
        expect  { degrees_of_freedom = 5; }
        output angle [rad] = rod.angle;
        output stroke [m] = slider.center.x;
        output first [m] = rod.bending[0];
        output second [m] = rod.bending[1];
        /// How much longer the rod is.
        output stretch [m] = distance(crank.pin, slider.center) - 2*L;
        output torque [N*m] = motor.effort;
    }
}
