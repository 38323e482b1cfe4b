//! Laval's rotor: a disc in the middle of a thin shaft, off its centre, between two bearings that align themselves.
//!
//! After Föppl (Civilingenieur 41, 1895) and Jeffcott (Phil. Mag. 37, 1919), with own data: a steel shaft of 10 mm and 0.5 m, a disc of 2 kg whose
//! centre of mass is 0.2 mm off the axis, a resistance of the air of 40 N s/m on it, no weight. Expected with Ω the speed, α the deflection of the
//! middle under a unit force that turns with it, d the damping: the middle whirls on a circle of e α m Ω²/|1 − α (m Ω² − i d Ω)|, for a uniform
//! shaft α = L³ (tan λ/2 − tanh λ/2)/(4 λ³ EI), λ⁴ = μ L⁴ Ω²/EI (Blevins, *Formulas for Natural Frequency and Mode Shape*, 8); at rest this is
//! L³/(48 EI). Far above the critical speed of 135.7 rad/s that circle is e, with the centre of mass in its middle: the rotor centres itself.

linkwright::mechanism! {
    /// Disc off its centre on an elastic shaft, driven at a constant speed.
    ///
    /// Below its critical speed the heavy side flies out, above it turns in.
    pub spatial LavalRotor {
        /// Speed of the motor.
        param speed [rad/s] = 100 in 1..1000;
        /// How far the centre of mass is from the middle of the disc.
        param eccentricity [mm] = 0.2 in 0..1;
        /// Resistance of the air to the disc.
        param drag [N*s/m] = 40 in 0..1000;
        body motor { mass [kg] = 1; inertia [kg*m^2] = (1e-3, 1e-3, 1e-3); }
        beam shaft { length [m] = 0.5; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7850;
                     modes = (bending_y = 3, bending_z = 3); shapes = pinned; }
        body wheel { mass [kg] = 2; inertia [kg*m^2] = (0.01, 0.005, 0.005); center = (0 [m], eccentricity, 0 [m]); }
        joint bearing: revolute(ground(0, 0, 0) [m], motor.origin, axis = (1, 0, 0));
        joint cross:   universal(motor.origin, shaft.start, axis = (0, 1, 0), second_axis = (0, 0, 1));
        joint far:     point_on_line(line(ground(0, 0, 0) [m], ground(1, 0, 0) [m]), shaft.end);
        joint seat:    fixed(shaft.center, wheel.origin);
        drive spin: bearing.angle = speed*time;
        force air: force(wheel.origin) = (0 [N], -drag*wheel.origin.velocity.y, -drag*wheel.origin.velocity.z);
        start  { cross.angle_1 [rad] ~ 0; cross.angle_2 [rad] ~ 0; }
        expect { degrees_of_freedom = 7; }
        output y [mm] = wheel.origin.y;
        output z [mm] = wheel.origin.z;
        output heavy_y [mm] = wheel.center.y;
        output heavy_z [mm] = wheel.center.z;
    }
}
