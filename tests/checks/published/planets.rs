//! A planetary stage with three planets that do not stand equally apart, so that no two meshes are in phase: inertia and stiffness assembled by hand.
//!
//! Planets at 0, 29 and 55 of the 84 places where their teeth meet. Phases: τ_sp,i = τ_sp,1 − z_s ψ_i/2π and τ_pr,i = τ_pr,1 + z_r ψ_i/2π (Parker & Lin,
//! Mesh phasing relationships in planetary and epicyclic gears, J. Mech. Des. 126, 2004, (8) and (14)). Teeth, inertias and shafts are those of `PlanetaryStage`; the carrier
//! has 1e-5 kg m² and the masses of three planets on its pins.

use super::Worst;
use linkwright::{Mechanism, StateOf, Variables, retract};
use linkwright_compiler::compile;
use linkwright_compiler::model::gears::meshes;
use std::f64::consts::{PI, TAU};
use std::time::Instant;

linkwright::mechanism! {
    planar StageOfThree {
        const AXES [mm] = 21;
        const SECOND [rad] = 2*pi*29/84;
        const THIRD [rad] = 2*pi*55/84;
        #[allow(teeth)]
        body sun { mass [kg] = 1; inertia [kg*m^2] = 7.990326761e-8; toothing rim: external(teeth = 12, module [mm] = 1, face_width [mm] = 5); }
        body first { mass [kg] = 0.02774419011; inertia [kg*m^2] = 3.121221387e-6; toothing rim: external(teeth = 30, module [mm] = 1, face_width [mm] = 5); }
        body second { mass [kg] = 0.02774419011; inertia [kg*m^2] = 3.121221387e-6; toothing rim: external(teeth = 30, module [mm] = 1, face_width [mm] = 5); }
        body third { mass [kg] = 0.02774419011; inertia [kg*m^2] = 3.121221387e-6; toothing rim: external(teeth = 30, module [mm] = 1, face_width [mm] = 5); }
        body ring { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: internal(teeth = 72, module [mm] = 1, face_width [mm] = 5); }
        body carrier { mass [kg] = 1; inertia [kg*m^2] = 1e-5; point near [mm] = (AXES, 0);
                       point far = (AXES*cos(SECOND), AXES*sin(SECOND)); point last = (AXES*cos(THIRD), AXES*sin(THIRD)); }
        body driver { mass [kg] = 1; inertia [kg*m^2] = 1e-5; }
        body driven { mass [kg] = 1; inertia [kg*m^2] = 1e-4; }
        joint held:  fixed(ground(0, 0), ring.center);
        joint main:  revolute(ground(0, 0), carrier.center);
        joint axle:  revolute(ground(0, 0), sun.center);
        joint bolt1: revolute(carrier.near, first.center);
        joint bolt2: revolute(carrier.far, second.center);
        joint bolt3: revolute(carrier.last, third.center);
        joint front: revolute(ground(0, 0), driver.center);
        joint back:  revolute(ground(0, 0), driven.center);
        #[allow(teeth)]
        mesh inner1: mesh(sun.rim, first.rim, stiffness = involute(young [GPa] = 210, tooth = section, harmonics = 8));
        #[allow(teeth)]
        mesh inner2: mesh(sun.rim, second.rim, stiffness = involute(young [GPa] = 210, tooth = section, harmonics = 8));
        #[allow(teeth)]
        mesh inner3: mesh(sun.rim, third.rim, stiffness = involute(young [GPa] = 210, tooth = section, harmonics = 8));
        mesh outer1: mesh(first.rim, ring.rim, stiffness = involute(young [GPa] = 210, tooth = section, harmonics = 8), sense = -1);
        mesh outer2: mesh(second.rim, ring.rim, stiffness = involute(young [GPa] = 210, tooth = section, harmonics = 8), sense = -1);
        mesh outer3: mesh(third.rim, ring.rim, stiffness = involute(young [GPa] = 210, tooth = section, harmonics = 8), sense = -1);
        shaft input_shaft: shaft(front, axle, ratio = 1, stiffness [N*m/rad] = 2000);
        shaft output_shaft: shaft(main, back, ratio = 1, stiffness [N*m/rad] = 20000);
        start { main.angle [rad] = 0; sun.angle [rad] = 0; front.angle [rad] = 0; back.angle [rad] = 0; }
        expect { degrees_of_freedom = 7; }
        output inner2_phase [1] = inner2.phase;
    }
}

const COUNT: usize = 7;
type Matrix = [[f64; COUNT]; COUNT];
/// Coordinates: absolute angles of the planets, carrier, sun, input, output.
const NAMES: [&str; COUNT] = ["first", "second", "third", "carrier", "sun", "driver", "driven"];
/// Where the planets stand, of 84 places.
const PLACES: [f64; 3] = [0.0, 29.0, 55.0];
/// τ of the first planet where a tooth of the sun and one of the ring are on the line of centres.
const PHASES: [f64; 2] = [0.945_131_94, 0.879_623_36];

/// J and K, with the stiffnesses of the inner and the outer meshes.
fn assembled([inner, outer]: [[f64; 3]; 2]) -> ([f64; COUNT], Matrix) {
    let (mass, arm, cosine) = (0.02774419011, 0.021, (PI / 9.0).cos());
    let planet = 3.121221387e-6;
    let inertia = [planet, planet, planet, 1e-5 + 3.0 * mass * arm * arm, 7.990326761e-8, 1e-5, 1e-4];
    let mut stiffness = [[0.0; COUNT]; COUNT];
    let mut spring = |k: f64, row: [f64; COUNT]| {
        for (i, of) in stiffness.iter_mut().enumerate() {
            for (j, entry) in of.iter_mut().enumerate() {
                *entry += k * row[i] * row[j];
            }
        }
    };
    for at in 0..3 {
        // cos α (a θ_c − r_p θ_p − r_s θ_s) and cos α (a θ_c + r_p θ_p).
        let mut sun = [0.0; COUNT];
        (sun[at], sun[3], sun[4]) = (-0.015 * cosine, arm * cosine, -0.006 * cosine);
        spring(inner[at], sun);
        let mut ring = [0.0; COUNT];
        (ring[at], ring[3]) = (0.015 * cosine, arm * cosine);
        spring(outer[at], ring);
    }
    spring(2000.0, [0.0, 0.0, 0.0, 0.0, -1.0, 1.0, 0.0]);
    spring(20_000.0, [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0]);
    (inertia, stiffness)
}

/// Frequencies, Hz, of J θ̈ + K θ = 0: eigenvalues of J^(−½) K J^(−½) by Jacobi's rotations.
fn frequencies(inertia: &[f64; COUNT], stiffness: &Matrix) -> [f64; COUNT] {
    let mut a = *stiffness;
    for (i, row) in a.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry /= (inertia[i] * inertia[j]).sqrt();
        }
    }
    for _ in 0..20 {
        for p in 0..COUNT {
            for q in p + 1..COUNT {
                if a[p][q] == 0.0 {
                    continue;
                }
                let half = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
                let t = half.signum() / (half.abs() + half.hypot(1.0));
                let c = t.hypot(1.0).recip();
                let s = t * c;
                for row in &mut a {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
                let (one, other) = (a[p], a[q]);
                for k in 0..COUNT {
                    (a[p][k], a[q][k]) = (c * one[k] - s * other[k], s * one[k] + c * other[k]);
                }
            }
        }
    }
    let mut found: [f64; COUNT] = core::array::from_fn(|k| a[k][k].abs().sqrt() / TAU);
    found.sort_by(f64::total_cmp);
    found
}

/// J (−∂v̇/∂θ) by central differences, in the absolute angles: K if the equations are those of `assembled`.
fn stiffness_of(
    model: &StageOfThree<f64>,
    at: &StateOf<StageOfThree<f64>>,
    inertia: &[f64; COUNT],
) -> Matrix {
    let names = model.velocity_names();
    let index = NAMES.map(|name| {
        let own = |known: &&str| known.strip_suffix(".rate") == Some(name);
        names.iter().position(own).unwrap_or_else(|| panic!("{name} of {names:?}"))
    });
    let accelerations = |theta: [f64; COUNT]| {
        let (mut state, mut delta) = (*at, at.v);
        for (k, value) in theta.into_iter().enumerate() {
            delta[index[k]] = value;
        }
        retract(model.layout(), &at.q, &delta, &mut state.q);
        let (mut a, mut lambda) = (at.v, Default::default());
        model.acceleration(0.0, &state, &(), &mut a, &mut lambda);
        index.map(|k| a[k])
    };
    let h = 1e-6;
    let columns: Matrix = core::array::from_fn(|column| {
        let of = |h: f64| accelerations(core::array::from_fn(|k| if k == column { h } else { 0.0 }));
        let (plus, minus) = (of(h), of(-h));
        core::array::from_fn(|row| -inertia[row] * (plus[row] - minus[row]) / (2.0 * h))
    });
    core::array::from_fn(|row| core::array::from_fn(|column| columns[column][row]))
}

/// At eight positions of a pitch: K entry by entry, and the six elastic frequencies and the rigid mode.
#[test]
fn three_planets_by_hand() {
    let began = Instant::now();
    let compiled = compile(StageOfThree::<f64>::SOURCE.parse().expect("tokens"), None).expect("a stage");
    let took = began.elapsed();
    println!("expanded in {took:?}");
    // Without optimisation, 0.04 s on a machine that is busy.
    assert!(took.as_secs_f64() < 0.3, "expanded in {took:?}");
    let mechanism = &compiled.mechanism;
    let shapes: Vec<_> =
        mechanism.loads.iter().filter_map(|load| meshes::by_shape(mechanism, load)).collect();
    let by_default = StageOfThree::<f64>::SOURCE.replace(", harmonics = 8", "");
    let by_default = compile(by_default.parse().expect("tokens"), None).expect("a stage").mechanism;
    let five: Vec<_> =
        by_default.loads.iter().filter_map(|load| meshes::by_shape(&by_default, load)).collect();
    let model = StageOfThree::<f64>::default();
    let (mut entries, mut hertz, mut phase) = (Worst::default(), Worst::default(), Worst::default());
    let mut left = [0.0_f64; 2];
    for position in 0..8 {
        let pitch = f64::from(position) / 8.0;
        // By the rigid mode, the sun by a pitch against the carrier: six turns of that for one of the carrier, twelve teeth.
        let carrier = TAU * pitch / 72.0;
        let mut state = StageOfThree::START;
        let mut delta = state.v;
        for (name, turn) in NAMES.into_iter().zip([-1.4, -1.4, -1.4, 1.0, 7.0, 7.0, 1.0]) {
            let at =
                model.velocity_names().iter().position(|known| known.strip_suffix(".rate") == Some(name));
            delta[at.expect("a body")] = turn * carrier;
        }
        retract(model.layout(), &StageOfThree::START.q, &delta, &mut state.q);
        let phases: [[f64; 3]; 2] = [
            PLACES.map(|place| (PHASES[0] + pitch - 12.0 * place / 84.0).rem_euclid(1.0)),
            PLACES.map(|place| (PHASES[1] + pitch + 72.0 * place / 84.0).rem_euclid(1.0)),
        ];
        phase.see(model.outputs(0.0, &state, &()).inner2_phase, phases[0][1]);
        let by_series = [0, 1].map(|ring| phases[ring].map(|phase| shapes[3 * ring].1.at(phase)));
        let by_shape = [0, 1].map(|ring| phases[ring].map(|phase| shapes[3 * ring].0.at(phase)));
        let (inertia, wanted) = assembled(by_series);
        let found = stiffness_of(&model, &state, &inertia);
        let size = wanted.iter().flatten().fold(0.0_f64, |most, entry| most.max(entry.abs()));
        for (found, wanted) in found.iter().flatten().zip(wanted.iter().flatten()) {
            entries.see(found / size, wanted / size);
        }
        // Of the symmetric part: what is not symmetric is an entry apart from that of the other side.
        let half: Matrix =
            core::array::from_fn(|i| core::array::from_fn(|j| 0.5 * (found[i][j] + found[j][i])));
        let (found, wanted) = (frequencies(&inertia, &half), frequencies(&inertia, &wanted));
        assert!(found[0] < 1.0 && wanted[0] < 1e-2, "{found:?} {wanted:?}");
        for (found, wanted) in found.iter().zip(&wanted).skip(1) {
            hertz.see(found / wanted, 1.0);
        }
        let exact = frequencies(&inertia, &assembled(by_shape).1);
        let of_five = [0, 1].map(|ring| phases[ring].map(|phase| five[3 * ring].1.at(phase)));
        let of_five = frequencies(&inertia, &assembled(of_five).1);
        for (left, series) in left.iter_mut().zip([&wanted, &of_five]) {
            for (series, exact) in series.iter().zip(&exact).skip(1) {
                *left = left.max((series / exact - 1.0).abs());
            }
        }
    }
    phase.below(1e-7, "phase of the second planet");
    entries.below(1e-6, "stiffness of three planets");
    hertz.below(1e-6, "frequencies of three planets");
    // What eight harmonics, and the five of the default, leave out where pairs enter and leave.
    println!("series beside the shape of teeth: {left:?} of the frequencies");
    assert!(left[0] < left[1], "{left:?}");
    assert!(left.iter().all(|left| (1e-4..2e-2).contains(left)), "{left:?}");
}
