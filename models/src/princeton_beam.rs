//! The Princeton beam: a strip that a weight at its end bends across both of its axes at once, far enough for the one way to count in the other.
//!
//! E. H. Dowell, J. J. Traybar, *An experimental study of the nonlinear stiffness of a rotor blade undergoing flap, lag and twist deformations*, AMS reports
//! 1194 and 1257, Princeton University, 1975; data as in O. A. Bauchau, P. Betsch, A. Cardona, J. Gerstmayr, B. Jonker, P. Masarati, V. Sonneville, *Validation of
//! flexible multibody dynamics beam formulations using benchmark problems*, Multibody System Dynamics 37 (2016): aluminium, 71.7 GPa, ν = 0.31, 508 mm of
//! 12.7 mm × 3.175 mm, weights of 4.448 and 8.896 N at angles from y, the stiff way, to z, the soft one. Deformations within a beam are small, those of the strip
//! are not: it is four beams, one fixed to the next. At rest the end is at (stiff, soft) mm by a geometrically exact rod: 4.448 N, 30°: (4.444571, 39.95256);
//! 60°: (2.686855, 68.13157); 8.896 N, 30°: (9.543962, 79.47694); 60°: (6.317586, 129.93505). Four beams are within 1 % the stiff way and 0.1 % the soft one at
//! the smaller load, within 3 % and 0.3 % at the larger; as many and two are in `docs/flexible-bodies.md`.

linkwright::mechanism! {
    /// A strip of four beams, held at one end and pulled across at the other.
    pub spatial PrincetonBeam {
        /// The weight at the end, N.
        param load [N] = 4.448 in 0..10;
        /// From the stiff way to the soft one.
        param way [deg] = 30 in 0..90;
        repeat i in 0..4 {
            beam strip[i] { length [mm] = 127; section = rectangle(height [mm] = 12.7, width [mm] = 3.175); young [GPa] = 71.7;
                            shear_modulus [GPa] = 27.366; density [kg/m^3] = 2700; modes = (bending_y = 2, bending_z = 2, torsion = 1);
                            shapes = static; damping_ratio = 0.01; }
        }
        joint root: fixed(ground(0, 0, 0) [m], strip[0].start);
        repeat i in 0..3 { joint seam[i]: fixed(strip[i].end, strip[i+1].start); }
        force pull: force(strip[3].end) = (0 [N], load*cos(way), load*sin(way));
        options { coordinates = tree; emit = (tangent); }
        expect { degrees_of_freedom = 20; }
        output stiff [mm] = strip[3].end.y;
        output soft [mm] = strip[3].end.z;
    }
}
