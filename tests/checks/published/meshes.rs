//! Teeth that give: frequencies of a planetary stage, the gear pair with backlash on its branches, turns without number, forces on bearings.

use super::Worst;
use linkwright::{Mechanism, Simulation, Variables, retract};
use linkwright_compiler::compile;
use linkwright_compiler::model::gears::meshes;
use linkwright_compiler::schedule::{Function, count};
use linkwright_models::gear_pair::{
    GearPair, GearPairInputs, GearPairOscillator, GearPairOscillatorParameters,
};
use linkwright_models::planetary_stage::{PlanetaryStage, PlanetaryStageHeld, PlanetaryStageHeldParameters};
use std::f64::consts::{PI, TAU};

/// x of A x = b.
fn solved(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for pivot in 0..n {
        let best = (pivot..n).max_by(|i, j| a[*i][pivot].abs().total_cmp(&a[*j][pivot].abs())).expect("rows");
        a.swap(pivot, best);
        b.swap(pivot, best);
        for row in pivot + 1..n {
            let factor = a[row][pivot] / a[pivot][pivot];
            let [above, below] = a.get_disjoint_mut([pivot, row]).expect("two rows");
            below.iter_mut().zip(above).skip(pivot).for_each(|(entry, known)| *entry -= factor * *known);
            b[row] -= factor * b[pivot];
        }
    }
    for row in (0..n).rev() {
        let known: f64 = (row + 1..n).map(|column| a[row][column] * b[column]).sum();
        b[row] = (b[row] - known) / a[row][row];
    }
    b
}

/// The natural frequency nearest to one that is expected, Hz, by inverse iteration on −∂v̇/∂q.
fn frequency(slopes: &[Vec<f64>], near: f64) -> f64 {
    let n = slopes.len();
    let shift = (TAU * near).powi(2) * (1.0 + 1e-4);
    let shifted = |x: &[f64]| -> Vec<f64> {
        let a = (0..n).map(|i| (0..n).map(|j| -slopes[i][j] - if i == j { shift } else { 0.0 }).collect());
        solved(a.collect(), x.to_vec())
    };
    let mut x = vec![1.0, 0.7, -0.4, 0.3, 0.9];
    let mut value = 0.0;
    for _ in 0..40 {
        let next = shifted(&x);
        let size = next.iter().fold(0.0_f64, |most, x| if x.abs() > most.abs() { *x } else { most });
        let at = next.iter().position(|x| *x == size).expect("the largest");
        value = shift + x[at] / size;
        x = next.iter().map(|x| x / size).collect();
    }
    value.abs().sqrt() / TAU
}

/// Of the stage with stiffnesses held, the natural frequencies nearest to expected ones.
fn frequencies(inner_stiffness: f64, outer_stiffness: f64, expected: &[f64]) -> Vec<f64> {
    let model =
        PlanetaryStageHeld::<f64>::prepare(PlanetaryStageHeldParameters { inner_stiffness, outer_stiffness });
    let model = model.expect("positive stiffnesses");
    let start = PlanetaryStageHeld::START;
    let n = start.v.len();
    let accelerations = |k: usize, h: f64| {
        let (mut state, mut delta) = (start, start.v);
        delta.iter_mut().enumerate().for_each(|(index, delta)| *delta = if index == k { h } else { 0.0 });
        retract(model.layout(), &start.q, &delta, &mut state.q);
        let (mut a, mut lambda) = (start.v, Default::default());
        model.acceleration(0.0, &state, &(), &mut a, &mut lambda);
        a
    };
    // Without gaps all is linear, so that a step may be long enough to round little.
    let columns: Vec<_> = (0..n).map(|k| (accelerations(k, 1e-3), accelerations(k, -1e-3))).collect();
    let slopes: Vec<Vec<f64>> =
        (0..n).map(|i| columns.iter().map(|(plus, minus)| (plus[i] - minus[i]) / 2e-3).collect()).collect();
    expected.iter().map(|near| frequency(&slopes, *near)).collect()
}

/// The stiffness that the compiler finds by the shape of the teeth, at twenty positions of a pitch, and with it the four elastic frequencies.
#[test]
fn planetary_stage_by_its_teeth() {
    let compiled = compile(PlanetaryStage::SOURCE.parse().expect("tokens"), None).expect("a stage");
    let mechanism = &compiled.mechanism;
    let exact: Vec<_> =
        mechanism.loads.iter().filter_map(|load| Some(meshes::by_shape(mechanism, load)?.0)).collect();
    let (mut stiffness, mut found) = (Worst::default(), Worst::default());
    for line in include_str!("../../data/planetary_stage_computed.csv").lines().skip(1) {
        let row: Vec<f64> = line.split(',').map(|cell| cell.parse().expect("a number")).collect();
        // At τ = 0 the tooth of the sun is on the line of centres, and the planet, whose teeth are even in number, has one there for the ring.
        let at = |phase: f64| (phase + row[0]).rem_euclid(1.0);
        let [inner, outer] = [exact[0].at(at(0.945_131_94)), exact[1].at(at(0.879_623_36))];
        stiffness.see(inner / row[1], 1.0);
        stiffness.see(outer / row[2], 1.0);
        for (frequency, expected) in frequencies(inner, outer, &row[4..]).iter().zip(&row[4..]) {
            found.see(frequency / expected, 1.0);
        }
        let all_turn = frequencies(inner, outer, &[0.5])[0];
        assert!(all_turn < 1e-2, "the rigid mode has {all_turn} Hz");
    }
    stiffness.below(2e-6, "stiffnesses of teeth");
    found.below(1e-6, "frequencies by the shape of teeth");
}

/// Stiffnesses of the teeth at τ = 0, 0.25, 0.5, 0.75 of a pitch, and at two round numbers: frequencies from an assembly of its own.
#[test]
fn planetary_stage_swings() {
    let mut worst = Worst::default();
    for (inner, outer, expected) in [
        (1.789_757_27e8, 1.951_172_76e8, [2130.16946, 8844.51974, 20479.8852, 52321.1713]),
        (1.102_717_89e8, 2.871_051_00e8, [2110.91325, 8497.33035, 24452.8365, 43824.7035]),
        (1.765_450_17e8, 2.256_653_27e8, [2136.71280, 8857.54824, 21881.0205, 52069.2539]),
        (2.827_684_43e8, 1.564_785_87e8, [2138.34875, 9054.99029, 18585.1835, 63147.7675]),
        (2e8, 2.5e8, [2148.43215, 8954.85834, 22936.58329, 54742.46747]),
    ] {
        for (found, expected) in frequencies(inner, outer, &expected).iter().zip(expected) {
            worst.see(found / expected, 1.0);
        }
    }
    worst.below(1e-6, "natural frequencies");
}

/// Swing of the stiffness, shake, and such a point each.
const BRANCHES: [(f64, f64, [f64; 6]); 10] = [
    (0.0, 0.05, [0.755060339, 0.83046368, 0.159068688, 1.35100617, 1.00026489, 0.222488101]),
    (0.0, 0.05, [0.99527462, 0.904114132, 0.0566628962, 1.27045185, 1.07232661, 0.134301052]),
    (0.0, 0.05, [1.30218323, 0.985877898, 0.0248483014, 1.21348161, 1.09818022, 0.0812337962]),
    (0.0, 0.05, [0.599355733, 1.12778767, 0.00155782084, 1.12790895, 1.1, 0.0197346196]),
    (0.0, 0.05, [0.778488376, 0.823687372, 0.139267553, 1.3415392, 1.01021877, 0.211899478]),
    (0.3, 0.0, [0.747227011, 1.03141648, -0.00933643353, 1.17390363, 1.11052433, 0.0506710062]),
    (0.3, 0.0, [1.00325824, 1.19107107, -0.0998058317, 1.22222946, 1.07296359, 0.099169557]),
    (0.3, 0.0, [1.30077442, 1.1346808, -0.0103856853, 1.13540226, 1.09406157, 0.0285007655]),
    (0.3, 0.0, [0.608387335, 1.04461738, -6.71423718e-05, 1.14536531, 1.10705989, 0.0350327821]),
    (0.3, 0.0, [0.779426035, 1.04580375, -0.241797383, 1.32090199, 1.01935776, 0.190180279]),
];

/// Points of the branches of period one, computed apart by shooting: Ω, x and ẋ at t = 0, largest x, mean and rms.
#[test]
fn gear_pair_with_backlash() {
    let mut worst = Worst::default();
    for (swing, shake, [omega, x, rate, most, mean, rms]) in BRANCHES {
        let parameters = GearPairOscillatorParameters { omega, shake, swing };
        let model = GearPairOscillator::<f64>::prepare(parameters).expect("parameters within their bounds");
        let base = 3e-3 * 25.0 * (PI / 9.0).cos();
        let mut start = GearPairOscillator::START;
        let middle = model.outputs(0.0, &start, &()).x;
        let from = start.q;
        retract(model.layout(), &from, &[(x * 1e-6 - middle) / base], &mut start.q);
        start.v[0] = rate * 1e-6 / base;
        let steps = 4000;
        let step = TAU / omega / f64::from(steps);
        let mut simulation = Simulation::new(&model, start).step(step);
        let (mut sum, mut squares, mut largest) = (0.0, 0.0, f64::MIN);
        for _ in 0..steps {
            let x = 1e6 * model.outputs(simulation.time(), simulation.state(), &()).x;
            (sum, squares, largest) = (sum + x, squares + x * x, largest.max(x));
            simulation.advance().expect("teeth turn");
        }
        let end = 1e6 * model.outputs(simulation.time(), simulation.state(), &()).x;
        let (found_mean, count) = (sum / f64::from(steps), f64::from(steps));
        worst.see(end, x);
        worst.see(largest, most);
        worst.see(found_mean, mean);
        worst.see((squares / count - found_mean * found_mean).sqrt(), rms);
    }
    worst.below(1e-5, "one period on a branch");
}

/// A million turns later the same teeth are as deep in each other.
#[test]
fn turns_without_number() {
    let model = GearPair::<f64>::default();
    let inputs = GearPairInputs { drive: 0.0, brake: 0.0 };
    let mut state = GearPair::START;
    let first = model.outputs(0.0, &state, &inputs);
    // Behind two pairs (cos, sin) stand turns and remainder of each wheel.
    state.q[4] += 1e6;
    state.q[6] -= 1e6;
    let later = model.outputs(0.0, &state, &inputs);
    assert!((later.deflection - first.deflection).abs() < 1e-14, "{} {}", later.deflection, first.deflection);
    assert_eq!(later.stiffness, first.stiffness);
}

/// A mesh with three harmonics, a gap and an error, of so many teeth.
fn force_of(teeth: u32) -> String {
    let axes = 1.5 * f64::from(teeth + 50);
    format!(
        "planar Pair {{ body one {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; #[allow(teeth)] toothing rim: external(teeth = {teeth}, module [mm] = 3, face_width [mm] = 20); }}
         body two {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; toothing rim: external(teeth = 50, module [mm] = 3, face_width [mm] = 20); }}
         joint front: revolute(ground(0, 0), one.center); joint back: revolute(ground({axes}, 0) [mm], two.center);
         #[allow(teeth)]
         mesh teeth: mesh(one.rim, two.rim, stiffness = involute(young [GPa] = 210, harmonics = 3), damping [N*s/m] = 60, backlash [um] = 40, error = 2e-6 [m]*cos(one.angle));
         options {{ coordinates = tree; }} output force [N] = teeth.force; }}"
    )
}

/// Within a hundred operations, whole turns and all.
#[test]
fn operations_of_a_mesh() {
    for teeth in [17, 50, 136, 137] {
        let compiled = compile(force_of(teeth).parse().expect("tokens"), None).expect("a pair");
        let counts = count(compiled.programs.get(Function::Outputs));
        println!("{teeth} teeth: {} operations", counts.total());
        assert!((30..=100).contains(&counts.total()), "{teeth} teeth take {} operations", counts.total());
    }
}

linkwright::mechanism! {
    /// The stiffness over a pitch by a table, and by the wave whose values the table has.
    planar PairByTable {
        table k(turn [rad]) [N/m] = [(0, 2e8), (0.7853981633974483, 1.7071067811865475e8), (1.5707963267948966, 1e8), (2.356194490192345, 0.29289321881345254e8), (3.141592653589793, 0),
            (3.9269908169872414, 0.29289321881345254e8), (4.71238898038469, 1e8), (5.497787143782138, 1.7071067811865475e8), (6.283185307179586, 2e8)], periodic;
        body one { mass [kg] = 1; inertia [kg*m^2] = 0.01; toothing rim: external(teeth = 50, module [mm] = 3); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 0.01; toothing rim: external(teeth = 50, module [mm] = 3); }
        joint front: revolute(ground(0, 0), one.center);
        joint back:  revolute(ground(150, 0) [mm], two.center);
        mesh teeth: mesh(one.rim, two.rim, stiffness = k(50*one.angle), backlash [um] = 10);
        start { front.rate [rad/s] = 3; }
        output stiffness [N/m] = teeth.stiffness;
        output angle [rad] = one.angle;
    }
}

/// A table over the phase repeats itself from tooth to tooth, and lies by its spline beside 1e8 (1 + cos zθ).
#[test]
fn stiffness_by_a_table() {
    let model = PairByTable::<f64>::default();
    let mut simulation = Simulation::new(&model, PairByTable::START).step(1e-4);
    let (mut worst, mut least, mut most) = (Worst::default(), f64::INFINITY, 0.0_f64);
    for _ in 0..1500 {
        simulation.advance().expect("wheels turn");
        let outputs = model.outputs(simulation.time(), simulation.state(), &());
        worst.see(outputs.stiffness / 1e8, 1.0 + (50.0 * outputs.angle).cos());
        (least, most) = (least.min(outputs.stiffness), most.max(outputs.stiffness));
    }
    assert!(least < 1e6 && most > 1.99e8, "{least} to {most}");
    // The cubic spline with eight knots over a period: (π/4)⁴ 5/384 at most.
    worst.below(5e-3, "stiffness by a table, 1e8 N/m");
}
