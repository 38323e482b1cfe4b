//! A slider-crank whose wrist pin has play: the pin is a disk in a hole, and nothing but contact holds them together.
//!
//! Data of the links and of the contact after Flores and Ambrósio (*Revolute joints with clearance in multibody systems*, Computers & Structures
//! 82 (2004) 1359): crank 0.05 m, rod 0.12 m, 0.21 kg, 2.5e-4 kg m², slider 0.14 kg; hole of 10 mm and pin of 9.5 mm in steel (207 GPa, 0.3), so K =
//! 6.6101983978968e10 N/m^1.5 (printed there as 6.61e10); 600 rpm and a dissipation of 20 s/m chosen here, from the stretched position with both
//! centres together and the rates of the ideal mechanism. Expected, of a separate integration at tolerances that agree to 2.3e-9: after 25 ms the rod
//! at −0.428311642606 rad, the slider at 0.108685954481 m, the pin off the hole's middle by (−0.474239204595, −0.159734004988) mm.

linkwright::mechanism! {
    /// A driven crank, a rod with a hole, a slider with a pin.
    pub planar LooseWrist {
        param play [mm] = 0.5 in 0.01..5;
        const SPEED [rad/s] = 20*pi;
        gravity [m/s^2] = (0, -9.81);
        material steel { modulus [Pa] = 207e9; poisson = 0.3; }

        rod crank { mass [kg] = 0.3; length [m] = 0.05; }
        body rod { mass [kg] = 0.21; inertia [kg*m^2] = 2.5e-4; point big [m] = (-0.06, 0); point small [m] = (0.06, 0); }
        body slider { mass [kg] = 0.14; inertia [kg*m^2] = 1e-5; }

        joint main: revolute(ground(0, 0) [m], crank.start);
        joint crank_pin: revolute(crank.end, rod.big);
        joint rail: prismatic(ground(0, 0) [m], slider.center, axis = (1, 0));
        drive motor: main.angle = SPEED*time;
        joint wrist: revolute(rod.small, slider.center, play = play, radius [mm] = 10) = hertz(first = steel, second = steel, dissipation [s/m] = 20);

        start { crank_pin.angle [rad] ~ 0; rail.travel [m] ~ 0.17; }
        expect { degrees_of_freedom = 3; }
        output angle [rad] = rod.angle;
        output travel [m] = rail.travel;
        output off_x [m] = slider.center.x - rod.small.x;
        output off_y [m] = slider.center.y - rod.small.y;
        output force [N] = wrist.force;
        output torque [N*m] = motor.effort;
    }
}
