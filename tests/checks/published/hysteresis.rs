//! Loads that remember where the motion has turned, moved along a given way: forces, and what they take in a cycle.

use crate::reference::random::Random;
use linkwright::{DormandPrince, Simulation};

mod inner {
    linkwright::mechanism! {
        /// A block that is moved to and fro against an element of Jenkins, a backbone after Masing, and a bushing after Bouc and Wen.
        pub planar Shaken {
            const FIRST [mm] = 5;
            param second [mm] = 0;
            param third [mm] = 0;
            const TURNS [rad/s] = 2*pi;
            table jenkins(way [mm]) [N] = [(0, 0), (1, 100)], linear, outside = hold;
            table bar(way [mm]) [N] = [(0, 0), (1, 100), (2, 150), (4, 200)], linear, outside = hold;
            state slid [J] = 0;
            state yielded [J] = 0;
            state rubbed [J] = 0;
            rate slid = slider.resistance*rail.speed;
            rate yielded = worn.resistance*rail.speed;
            rate rubbed = bush.resistance*rail.speed;
            body block { mass [kg] = 1; inertia [kg*m^2] = 0.01; }
            joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
            drive shake: rail.travel = FIRST*sin(TURNS*time) + second*(1 - cos(2*TURNS*time)) + third*(1 - cos(5*TURNS*time));
            force slider: masing(rail, backbone = jenkins);
            force worn: masing(rail, backbone = bar);
            force bush: bouc_wen(rail, stiffness [N/m] = 1e5, share = 0.1, depth [mm] = 2, beta = 0.5, gamma = 0.5, exponent = 2);
            output slides [N] = slider.resistance;
            output bears [N] = worn.resistance;
            output slid [J] = slid;
            output yielded [J] = yielded;
            output rubbed [J] = rubbed;
        }
    }
}

use inner::{Shaken, ShakenOutputs, ShakenParameters};

/// Outputs and the deflection of the bushing, at these times.
fn moved<const N: usize>(model: &Shaken, times: [f64; N]) -> [(ShakenOutputs, f64); N] {
    let simulation = Simulation::new(model, Shaken::START);
    let mut simulation = simulation.integrator(DormandPrince::tolerance(1e-12)).step(1e-3);
    times.map(|time| {
        simulation.advance_until(time).expect("it is moved");
        (simulation.sample().outputs, Shaken::internal(&simulation.state().z).bush_deflection)
    })
}

/// x = 5 mm sin 2πt. Jenkins' and Masing's are closed forms; the others by DOP853 of SciPy at 3e-14.
#[test]
fn to_and_fro() {
    let model = Shaken::default();
    let [(most, deep), (back, _), (one, _), (two, _), (three, late)] =
        moved(&model, [0.25, 0.5, 1.0, 2.0, 3.0]);
    let close = |found: f64, expected: f64, within: f64, what: &str| {
        println!("{what}: {found:.15}, {:.1e} off", (found - expected).abs());
        assert!(
            (found - expected).abs() <= within * expected.abs(),
            "{what}: {found} in place of {expected}"
        );
    };
    close(most.bears, 200.0, 1e-9, "Masing at 5 mm");
    close(back.bears, -125.0, 1e-7, "Masing on the way back");
    close(most.slides, 100.0, 1e-9, "Jenkins at 5 mm");
    close(two.slid - one.slid, 1.6, 1e-7, "Jenkins in a cycle");
    close(two.yielded - one.yielded, 1.8, 1e-7, "Masing in a cycle");
    close(deep, 1.973_228_596_302_8e-3, 1e-10, "Bouc and Wen at a quarter of a second");
    close(late, 1.810_538_436_164_6e-3, 1e-10, "Bouc and Wen after three cycles");
    close(three.rubbed - two.rubbed, 2.022_139_553_714_19, 1e-10, "Bouc and Wen in the third cycle");
}

/// No closed way, from rest without deflections, gives energy, whatever turns it has.
#[test]
fn no_closed_way_gives_energy() {
    let mut random = Random::named("closed ways");
    for _ in 0..40 {
        let [second, third] = [6e-3, 2e-3].map(|size| random.between(-size, size));
        // The way begins with the speed of the start.
        let model = Shaken::prepare(ShakenParameters { second, third });
        for (outputs, _) in moved(&model.expect("any way"), [1.0, 2.0]) {
            for taken in [outputs.slid, outputs.yielded, outputs.rubbed] {
                assert!(taken >= -1e-9, "{second} {third}: {taken} J");
            }
        }
    }
}
