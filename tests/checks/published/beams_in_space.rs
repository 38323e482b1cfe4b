//! Beams in space against what is known of them: the same beam in the plane, closed forms of bars that stand, spin and are loaded, and
//! what a beam keeps that nothing holds.

use linkwright::{Mechanism, Rk4, Simulation, State, equilibrium};
use linkwright_models::flexible_arm::{FlexibleArm, FlexibleArmInputs};
use linkwright_models::princeton_beam::{PrincetonBeam, PrincetonBeamParameters};
use std::f64::consts::PI;

linkwright::mechanism! {
    /// A blade that is spun, with a particle at its tip, in the plane.
    #[allow(slender)]
    planar InThePlane {
        gravity [m/s^2] = (0.3, -9.81);
        beam arm     { length [m] = 1; section = rectangle(height [mm] = 6, width [mm] = 20); young [GPa] = 70; density [kg/m^3] = 2700;
                       modes = (axial = 1, bending = 3); shapes = clamped; stiffening = on; damping_ratio = 0.01; }
        particle tip { mass [kg] = 0.3; }
        joint pin:  revolute(ground(0, 0) [m], arm.start);
        joint hold: revolute(arm.end, tip.center);
        start { pin.angle [rad] = 0.3; pin.rate [rad/s] = 25; arm.bending[0] [mm] = 15; arm.bending[1].rate [mm/s] = 300; }
        output x [m] = tip.center.x;
        output y [m] = tip.center.y;
        output whole [J] = energy;
    }
}

linkwright::mechanism! {
    /// The same, bending along y.
    #[allow(slender)]
    spatial AlongY {
        gravity [m/s^2] = (0.3, -9.81, 0);
        beam arm     { length [m] = 1; section = rectangle(height [mm] = 6, width [mm] = 20); young [GPa] = 70; density [kg/m^3] = 2700;
                       modes = (axial = 1, bending_y = 3); shapes = clamped; stiffening = on; damping_ratio = 0.01; }
        particle tip { mass [kg] = 0.3; }
        joint pin:  revolute(ground(0, 0, 0) [m], arm.start, axis = (0, 0, 1));
        joint hold: spherical(arm.end, tip.center);
        start { pin.angle [rad] = 0.3; pin.rate [rad/s] = 25; arm.bending_y[0] [mm] = 15; arm.bending_y[1].rate [mm/s] = 300; }
        output x [m] = tip.center.x;
        output y [m] = tip.center.y;
        output whole [J] = energy;
    }
}

linkwright::mechanism! {
    /// The same, bending along z.
    #[allow(slender)]
    spatial AlongZ {
        gravity [m/s^2] = (0.3, 0, -9.81);
        beam arm     { length [m] = 1; section = rectangle(height [mm] = 20, width [mm] = 6); young [GPa] = 70; density [kg/m^3] = 2700;
                       modes = (axial = 1, bending_z = 3); shapes = clamped; stiffening = on; damping_ratio = 0.01; }
        particle tip { mass [kg] = 0.3; }
        joint pin:  revolute(ground(0, 0, 0) [m], arm.start, axis = (0, -1, 0));
        joint hold: spherical(arm.end, tip.center);
        start { pin.angle [rad] = 0.3; pin.rate [rad/s] = 25; arm.bending_z[0] [mm] = 15; arm.bending_z[1].rate [mm/s] = 300; }
        output x [m] = tip.center.x;
        output y [m] = tip.center.z;
        output whole [J] = energy;
    }
}

/// A spatial beam that moves in a plane is the one of the plane, whichever way it bends.
#[test]
fn a_plane_in_space() {
    macro_rules! end {
        ($model:ident) => {{
            let model = $model::<f64>::default();
            let mut simulation = Simulation::new(&model, $model::START).integrator(Rk4).step(2e-5);
            let sample = simulation.run_until(0.1, |_| {}).map(|_| simulation.sample()).expect("it turns");
            [sample.outputs.x, sample.outputs.y, sample.outputs.whole]
        }};
    }
    let plane = end!(InThePlane);
    assert!((plane[1] - 0.3).abs() < 0.1, "{plane:?}");
    for space in [end!(AlongY), end!(AlongZ)] {
        for (found, expected) in space.into_iter().zip(plane) {
            assert!((found - expected).abs() < 1e-11 * (1.0 + expected.abs()), "{space:?} {plane:?}");
        }
    }
}

linkwright::mechanism! {
    /// A round shaft that is held at one end in a bearing along it.
    spatial Shaft {
        beam shaft { length [m] = 0.8; section = circle(diameter [mm] = 8); young [GPa] = 200; density [kg/m^3] = 7850;
                     modes = (bending_y = 2, bending_z = 2); shapes = clamped; }
        joint bearing: revolute(ground(0, 0, 0) [m], shaft.start, axis = (1, 0, 0));
        start { bearing.angle [rad] = 0; bearing.rate [rad/s] = 90; shaft.bending_y[0] [um] = 1;
                shaft.bending_z[0].rate [um/s] = -90; }
        output y [m] = shaft.end.y;
        output z [m] = shaft.end.z;
    }
}

/// However fast a round shaft spins, one that is bent and let go swings in a plane that stands still, with the clamped bar's frequency
/// (λ/L)² √(EI/μ), λ = 1.8751…: what gyroscopic and centrifugal forces do in the turning frame has to cancel. Shape 2 at the end.
#[test]
fn a_spinning_shaft_swings_in_a_standing_plane() {
    let model = Shaft::<f64>::default();
    let radius = 0.004_f64;
    let rate = (1.875_104_068_711_961 / 0.8_f64).powi(2) * (200e9 * radius * radius / 4.0 / 7850.0).sqrt();
    assert!(90.0 > 1.5 * rate / 2.0 && rate > 50.0, "{rate}");
    let mut largest = 0.0_f64;
    let mut simulation = Simulation::new(&model, Shaft::START).integrator(Rk4).step(2e-5);
    simulation
        .run_until(0.3, |sample| {
            let expected = 2e-6 * (rate * sample.time).cos();
            assert!((sample.outputs.y - expected).abs() < 2e-13, "{} {expected}", sample.outputs.y);
            assert!(sample.outputs.z.abs() < 2e-13, "{}", sample.outputs.z);
            largest = largest.max(-expected);
        })
        .expect("it spins");
    assert!(largest > 1.99e-6, "it swung once");
}

linkwright::mechanism! {
    /// A console under its weight, across both of its axes.
    spatial Console {
        gravity [m/s^2] = (0, -3, -9.81);
        beam bar { length [m] = 1.2; section = rectangle(height [mm] = 20, width [mm] = 30); young [GPa] = 70; density [kg/m^3] = 2700;
                   modes = (bending_y = 3, bending_z = 3); shapes = static; damping_ratio = 0.7; }
        joint foot: fixed(ground(0, 0, 0) [m], bar.start);
        output y [m] = bar.end.y;
        output z [m] = bar.end.z;
    }
}

/// w L⁴/(8 E I) in both directions at once, each with its own second moment: three static shapes have it exactly.
#[test]
fn a_console_under_its_weight() {
    let model = Console::<f64>::default();
    let mut simulation = Simulation::new(&model, Console::START).integrator(Rk4).step(2e-5);
    simulation.advance_until(0.6).expect("it comes to rest");
    let sample = simulation.sample();
    let load = 2700.0 * 0.02 * 0.03;
    let deflection = |pull: f64, across: f64, along: f64| {
        load * pull * 1.2_f64.powi(4) / (8.0 * 70e9 * along * across.powi(3) / 12.0)
    };
    let [y, z] = [deflection(3.0, 0.02, 0.03), deflection(9.81, 0.03, 0.02)];
    assert!((sample.outputs.y + y).abs() < 1e-10 * y, "{} {y}", sample.outputs.y);
    assert!((sample.outputs.z + z).abs() < 1e-10 * z, "{} {z}", sample.outputs.z);
}

linkwright::mechanism! {
    /// A beam and a body at its end, thrown.
    spatial Thrown {
        beam stick { length [m] = 1; section = tube(outer [mm] = 30, inner [mm] = 28); young [GPa] = 2; shear_modulus [GPa] = 0.05;
                     density [kg/m^3] = 1500; modes = (axial = 1, bending_y = 2, bending_z = 2, torsion = 2); }
        body head  { mass [kg] = 0.4; inertia [kg*m^2] = (2e-3, 3e-3, 4e-3); center [m] = (0.05, 0.02, -0.01); }
        joint weld: fixed(stick.end, head.origin);
        start { stick.rate.x [rad/s] = 2; stick.rate.y [rad/s] = -3; stick.rate.z [rad/s] = 4; stick.bending_y[0] [mm] = 20;
                stick.bending_z[1].rate [m/s] = 0.3; stick.torsion[0] [deg] = 3; stick.torsion[1].rate [rad/s] = 5; stick.origin.velocity.x [m/s] = 1; }
        output mean [m/s] = stick.origin.velocity.x;
        output head [m/s] = head.center.velocity.x;
        output whole [J] = energy;
        options { self_check = on; }
    }
}

/// Nothing acts, and so the energy and the momentum stay; RK4's fourth order is seen in what energy it loses. The origin of a free beam's
/// frame is its centre of mass.
#[test]
fn a_thrown_stick_keeps_energy_and_momentum() {
    let model = Thrown::<f64>::default();
    let lost = |step: f64| {
        let mut simulation = Simulation::new(&model, Thrown::START).integrator(Rk4).step(step);
        let start = simulation.sample().outputs;
        let stick = 1500.0 * PI / 4.0 * (0.03_f64.powi(2) - 0.028_f64.powi(2));
        let (mut momentum, mut fastest) = (0.0_f64, 0.0_f64);
        simulation
            .run_until(0.2, |sample| {
                let [mean, head] = [(sample.outputs.mean, start.mean), (sample.outputs.head, start.head)]
                    .map(|(now, then)| now - then);
                momentum = momentum.max((stick * mean + 0.4 * head).abs());
                fastest = fastest.max(mean.abs());
            })
            .expect("it flies");
        assert!(momentum < 1e-9 && fastest > 0.1, "{momentum} {fastest}");
        (simulation.sample().outputs.whole - start.whole).abs() / start.whole
    };
    let [coarse, fine] = [1e-4, 5e-5].map(lost);
    assert!(fine < 1e-8 && coarse > 8.0 * fine, "{coarse} {fine}");
}

// The strip of `models/src/princeton_beam.rs` as two beams.
linkwright::mechanism! {
    spatial PrincetonBeamOfTwo {
        param load [N] = 4.448 in 0..10;
        param way [deg] = 30 in 0..90;
        repeat i in 0..2 {
            beam strip[i] { length [mm] = 254; section = rectangle(height [mm] = 12.7, width [mm] = 3.175); young [GPa] = 71.7;
                            shear_modulus [GPa] = 27.366; density [kg/m^3] = 2700; modes = (bending_y = 2, bending_z = 2, torsion = 1);
                            shapes = static; }
        }
        joint root: fixed(ground(0, 0, 0) [m], strip[0].start);
        joint seam: fixed(strip[0].end, strip[1].start);
        force pull: force(strip[1].end) = (0 [N], load*cos(way), load*sin(way));
        options { coordinates = tree; emit = (tangent); }
        output stiff [mm] = strip[1].end.y;
        output soft [mm] = strip[1].end.z;
    }
}

/// The end at rest (stiff, soft), mm, against a geometrically exact rod: how far off two beams and four are, which is less by
/// four as they are half as long, and how far at twice the load.
#[test]
fn the_princeton_beam() {
    let pulls = [
        (4.448, 0.0, [5.003_937, 0.0]),
        (4.448, 30.0, [4.444_571, 39.952_56]),
        (4.448, 60.0, [2.686_855, 68.131_57]),
        (4.448, 90.0, [0.0, 78.083_06]),
        (8.896, 30.0, [9.543_962, 79.476_94]),
        (8.896, 60.0, [6.317_586, 129.935_05]),
    ];
    // Relative, at each load: the stiff way and the soft way.
    let off = |expected: [f64; 2], found: [f64; 2]| {
        [0, 1].map(|k| if expected[k] == 0.0 { found[k].abs() } else { (found[k] / expected[k] - 1.0).abs() })
    };
    macro_rules! errors {
        ($model:ident, $parameters:ident) => {
            pulls.map(|(load, way, expected)| {
                let parameters = $parameters { load, way: way / 180.0 * PI };
                let model = $model::<f64>::prepare(parameters).expect("within bounds");
                let rest = equilibrium(&model, 0.0, &$model::START.q, &()).expect("there is one");
                let state = State { q: rest.q, ..$model::START };
                let outputs = model.outputs(0.0, &state, &());
                off(expected, [1e3 * outputs.stiff, 1e3 * outputs.soft])
            })
        };
    }
    let two = errors!(PrincetonBeamOfTwo, PrincetonBeamOfTwoParameters);
    let four = errors!(PrincetonBeam, PrincetonBeamParameters);
    let largest = |of: &[[f64; 2]], way: usize| of.iter().map(|it| it[way]).fold(0.0, f64::max);
    for (errors, [stiff, soft], [stiff_of_all, soft_of_all]) in
        [(two, [0.034, 0.003], [0.103, 0.009]), (four, [0.01, 0.001], [0.03, 0.003])]
    {
        assert!(largest(&errors[..4], 0) < stiff && largest(&errors[..4], 1) < soft, "{errors:?}");
        assert!(largest(&errors, 0) < stiff_of_all && largest(&errors, 1) < soft_of_all, "{errors:?}");
    }
    // What the two ways do to one another is of second order: a quarter with half the length.
    for (at, quarter) in [(1, 3.3), (2, 3.5), (4, 3.4), (5, 3.5)] {
        assert!(two[at][0] > quarter * four[at][0], "{} {}", two[at][0], four[at][0]);
    }
}

/// A slew of eight seconds and two more: as converged in steps, and within a micrometre of what four shapes each way give.
#[test]
fn an_arm_with_two_flexible_booms() {
    let model = FlexibleArm::<f64>::default();
    let torques = |time: f64, _: &_| {
        let wave = (PI * time / 4.0).sin();
        FlexibleArmInputs {
            yaw_torque: 300.0 * wave,
            shoulder_torque: -150.0 * wave,
            elbow_torque: 60.0 * wave,
        }
    };
    let mut simulation =
        Simulation::new(&model, FlexibleArm::START).sampled(torques).integrator(Rk4).step(1e-3);
    simulation.advance_until(10.0).expect("it slews");
    let outputs = simulation.sample().outputs;
    let found = [outputs.x, outputs.y, outputs.z];
    let converged = [8.777_022_427, 0.415_738_710, -5.960_684_482];
    let more_shapes = [8.777_022_245, 0.415_738_971, -5.960_684_263];
    for k in 0..3 {
        assert!((found[k] - converged[k]).abs() < 3e-9, "{found:?}");
        assert!((found[k] - more_shapes[k]).abs() < 1e-6, "{found:?}");
    }
}
