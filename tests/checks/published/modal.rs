//! Bodies with the modes of files against the beam that a file was written from.

use linkwright::{Rk4, Simulation};
use mechanisms::zoo_modal::{Cantilever, CantileverInputs};

linkwright::mechanism! {
    /// The zoo's arm with the modes of a file, as the beam that the file was written from.
    #[allow(slender)]
    spatial SameAsFile {
        param loss = 0.02 in 0..1;
        input push [N];
        gravity [m/s^2] = (0.3, -0.2, -9.81);
        beam arm { length [m] = 1; area [mm^2] = 2400; second_moment_z [mm^4] = 3.2e5; second_moment_y [mm^4] = 7.2e5;
                   torsion_constant [mm^4] = 6e5; young [GPa] = 0.5; shear_modulus [GPa] = 0.2; density [kg/m^3] = 2700;
                   modes = (axial = 1, bending_y = 2, bending_z = 1, torsion = 1); shapes = clamped; damping_ratio = loss;
                   point third [m] = (0.4, 0, 0); }
        body hand { mass [kg] = 0.5; inertia [kg*m^2] = (1e-3, 2e-3, 1.5e-3); center [m] = (0.05, 0.01, 0.02); }
        body side { mass [kg] = 0.3; inertia [kg*m^2] = (1e-3, 2e-3, 1.5e-3); center [m] = (0.1, 0.01, 0.02); }
        joint base:  universal(ground(0, 0, 0) [m], arm.start, axis = (0, 0, 1), second_axis = (0, 1, 0));
        joint wrist: fixed(arm.end, hand.origin);
        joint hinge: revolute(arm.third, side.origin, axis = (0.3, 1, 0));
        spring tie:  spring(arm.third, ground(1, 1, 0) [m], stiffness [N/m] = 100, length [m] = 0.5, damping [N*s/m] = 1);
        force blow:  force(arm.end) = (push, 0.2 [N], -0.1 [N*s/m]*hand.center.velocity.z);
        start { base.angle_1 [rad] = 0.3; base.rate_1 [rad/s] = 2; base.angle_2 [rad] = -0.2; hinge.angle [rad] = 0.4; hinge.rate [rad/s] = 3;
                arm.bending_y[0] [mm] = 10; arm.bending_z[0].rate [m/s] = 0.1; }
        output x [m] = hand.center.x;
        output z [m] = hand.center.z;
        output bent [mm] = arm.bending_y[0] + 0.5 [s]*arm.bending_z[0].rate;
        output frame [m/s] = arm.origin.velocity.x;
        output whole [J] = energy;
    }
}

/// The modes of a beam by a file move as those of the beam: shapes, integrals, what twists, damping and places.
#[test]
fn a_file_moves_as_the_beam_it_was_written_from() {
    let (file, beam) = (Cantilever::<f64>::default(), SameAsFile::<f64>::default());
    let (pushed, push) = (CantileverInputs { push: 0.7 }, SameAsFileInputs { push: 0.7 });
    let mut one = Simulation::new(&file, Cantilever::START).constant(pushed).integrator(Rk4).step(1e-3);
    let mut other = Simulation::new(&beam, SameAsFile::START).constant(push).integrator(Rk4).step(1e-3);
    for _ in 0..10 {
        let until = one.time() + 0.1;
        one.advance_until(until).expect("it moves");
        other.advance_until(until).expect("it moves");
        let (a, b) = (one.sample().outputs, other.sample().outputs);
        let pairs = [
            (a.x, b.x, 1.0),
            (a.z, b.z, 1.0),
            (a.bent, b.bent, 0.1),
            (a.frame, b.frame, 1.0),
            (a.whole, b.whole, 30.0),
        ];
        for (a, b, size) in pairs {
            assert!((a - b).abs() < 1e-11 * size, "{until}: {a} is not {b}");
        }
    }
}
