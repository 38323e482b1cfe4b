//! Equations in independent coordinates: they move the whole, hold it at rest, and say where coordinates lead nothing.

use crate::registry::{At, Model, for_each};
use crate::walking::walk;
use crate::{STATES, assert_close, assert_close_by, solved};
use linkwright::{
    AssembleExt, Fields, LinearisationError, Mechanism, Motion, Reading, Reduced, State, Vector, coordinate,
    coordinate_rates, coordinate_values, measured,
};
use linkwright_models::slider_crank::SliderCrank;

for_each!(reduced_equations_move_the_whole);

/// M_r s̈ + h = 0 at the motion of the whole, which N s̈ + a₀ gives back; N ṡ + v₀ is v.
fn reduced_equations_move_the_whole<M: Model>() {
    let (_, _, model, states) = walk::<M>(70, STATES);
    let (name, f) = (model.name(), model.independent().len());
    let freedoms = model.velocity_count() + model.idle().len() - model.row_count();
    let mut compared = 0;
    for at in &states {
        let state = at.state();
        let reduced = match Reduced::at(&model, at.time, &state, &at.u) {
            Err(LinearisationError::Incomplete { needed, given }) => {
                assert!(needed == freedoms && given == f && f < freedoms, "{name}");
                return;
            }
            Err(LinearisationError::Assembly(_)) => continue,
            Err(
                LinearisationError::Rigid { contact: gate } | LinearisationError::Sticks { friction: gate },
            ) => {
                assert!(model.is_rigid() && model.gate_names().contains(&gate), "{name}");
                return;
            }
            found => found.unwrap_or_else(|error| panic!("{name}: {error}")),
        };
        compared += 1;
        let a = solved(&model, at);
        let (s2, s1) = (second_rates(&model, at, &a), coordinate_rates(&model, at.time, &at.q, &at.v));
        let size = 1.0 + a.max_abs();
        assert_close_by(name, reduced.acceleration(&s2).as_slice(), a.as_slice(), 1e-8 * size);
        let v = reduced.velocity(&independent(&model, &s1));
        assert_close_by(name, v.as_slice(), at.v.as_slice(), 1e-8 * (1.0 + at.v.max_abs()));
        for row in 0..f {
            let terms: Vec<f64> =
                (0..f).map(|k| reduced.mass_matrix().as_slice()[row * f + k] * s2[k]).collect();
            let size = terms.iter().fold(reduced.bias()[row].abs(), |sum, term| sum + term.abs());
            let left = terms.iter().sum::<f64>() + reduced.bias()[row];
            assert!(left.abs() <= 1e-8 * (1e-3 + size), "{name}: {left:e} of {size:e}");
            // B N = 1.
            let unit = coordinate_rates(&model, at.time, &at.q, &reduced.motion(row));
            let rest = coordinate_rates(&model, at.time, &at.q, &model.zero_v());
            let unit = independent(&model, &unit.plus(-1.0, &rest));
            let expected: Vec<f64> = (0..f).map(|k| f64::from(k == row)).collect();
            assert_close(&format!("{name}: B N"), &unit, &expected, 1e-9);
        }
        let mut moved = model.zero_lambda();
        let mut jacobian = model.zero_jacobian();
        model.constraint_jacobian(at.time, &at.q, &mut jacobian);
        for k in 0..f {
            let motion = reduced.motion(k);
            moved.as_mut_slice().fill(0.0);
            for (entry, (row, column)) in jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
                if !model.idle().contains(row) {
                    moved.as_mut_slice()[usize::from(*row)] +=
                        entry * motion.as_slice()[usize::from(*column)];
                }
            }
            assert!(
                moved.max_abs() < 1e-10 * (1.0 + motion.max_abs() * jacobian.max_abs()),
                "{name}: {moved:?}"
            );
        }
        // At rest without inputs the bias is what holds it.
        let still = State { v: model.zero_v(), ..state };
        let none = M::Inputs::from_array(Vector::zeros(model.input_names().len()));
        let rest =
            Reduced::at(&model, at.time, &still, &none).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_close(&format!("{name}: gravity"), reduced.gravity(), rest.gravity(), 1e-12);
        // No driver, no place that moves with time, and no bent bristles, which hold at rest.
        let holds = model.rubs() && model.internal_count() > 0;
        if f > 0 && !holds && rest.velocity(&[]).max_abs() == 0.0 && rest.acceleration(&[]).max_abs() == 0.0 {
            assert_close(&format!("{name}: bias at rest"), rest.bias(), rest.gravity(), 1e-9);
            // ½ ṡᵀ M_r ṡ is the energy of N ṡ.
            let motion = reduced.motion(0);
            let energy = model.kinetic_energy(at.time, &at.q, &motion);
            let mass = reduced.mass_matrix().as_slice()[0];
            assert!((0.5 * mass - energy).abs() <= 1e-10 * energy.max(1e-6), "{name}: {mass} {energy}");
        }
    }
    assert!(compared > 0 || f == 0, "{name}: no regular state");
}

/// B a + b of the independent coordinates.
fn second_rates<M: Model>(model: &M, at: &At<M>, a: &M::V) -> Vec<f64> {
    let (mut bias, mut drift) = (model.zero_conditions(), model.zero_conditions());
    model.condition_bias(at.time, &at.q, &at.v, &mut bias);
    model.condition_drift(at.time, &at.q, &mut drift);
    let all = coordinate_rates(model, at.time, &at.q, a).plus(1.0, &bias).plus(-1.0, &drift);
    independent(model, &all)
}

fn independent<M: Model>(model: &M, all: &M::Conditions) -> Vec<f64> {
    model.independent().iter().map(|index| all.as_slice()[usize::from(*index)]).collect()
}

for_each!(in sample, reduced_equations_in_single_precision);

/// To 1e-4 of the largest entry, where the position itself is one of single precision.
fn reduced_equations_in_single_precision<M: Model>() {
    let (double, single) = (M::standard(), M::single());
    let start = double.start();
    let (q, v): (Vec<f32>, Vec<f32>) = (
        start.q.as_slice().iter().map(|x| *x as f32).collect(),
        start.v.as_slice().iter().map(|x| *x as f32).collect(),
    );
    let mut state = single.start();
    state.q.as_mut_slice().copy_from_slice(&q);
    state.v.as_mut_slice().copy_from_slice(&v);
    let none = M::Inputs::from_array(Vector::zeros(double.input_names().len()));
    let few = <M::Single as Mechanism<f32>>::Inputs::from_array(Vector::zeros(single.input_names().len()));
    let Ok(reduced) = Reduced::at(&double, 0.0, &start, &none) else { return };
    let found = match Reduced::at(&single, 0.0, &state, &few) {
        Ok(found) => found,
        // Half of the digits are fewer there.
        Err(LinearisationError::Assembly(_) | LinearisationError::Breakdown { .. }) => return,
        Err(error) => panic!("{}: {error}", double.name()),
    };
    let wide = |x: &[f32]| x.iter().map(|x| f64::from(*x)).collect::<Vec<_>>();
    let name = double.name();
    // Beside singular starts the condition multiplies what rounding of the position is.
    let near = 1.0 + 1e-3 / linkwright::smallest_pivot(&double, 0.0, &start.q).0;
    let mass = reduced.mass_matrix();
    assert_close(&format!("{name}: M"), &wide(found.mass_matrix().as_slice()), mass.as_slice(), 1e-4 * near);
    // Where a machine starts in balance its loads are what there is.
    let mut forces = double.zero_v();
    // Surfaces that press make forces of what rounding of the position is.
    let mut shaken = start;
    // Not all alike, which would only make the mechanism larger.
    let rounded =
        |k: usize| if k.is_multiple_of(3) { f64::from(f32::EPSILON) } else { -f64::from(f32::EPSILON) };
    shaken.q.as_mut_slice().iter_mut().enumerate().for_each(|(k, q)| *q *= 1.0 + rounded(k));
    let shaken = Reduced::at(&double, 0.0, &shaken, &none).ok();
    let rounding = |k: usize| {
        let shaken = shaken.as_ref().and_then(|shaken| shaken.gravity().get(k).copied());
        shaken.map_or(0.0, |shaken| 2.0 * (shaken - reduced.gravity()[k]).abs())
    };
    double.forces(0.0, &State { v: double.zero_v(), ..start }, &none, &mut forces);
    for (k, (found, expected)) in wide(found.gravity()).iter().zip(reduced.gravity()).enumerate() {
        let motion = reduced.motion(k);
        let terms = motion.as_slice().iter().zip(forces.as_slice()).map(|(n, force)| (n * force).abs());
        // What hydraulics hold up is a weight.
        let bound = 1e-4 * near * terms.sum::<f64>().max(10.0 * mass.max_abs()) + rounding(k);
        assert!((found - expected).abs() <= bound, "{name}: {found} {expected}, bound {bound:e}");
    }
}

#[test]
fn reduced_equations_say_where_coordinates_lead_nothing() {
    let model = SliderCrank::<f64>::default();
    let start = model.start();
    let none = <SliderCrank as Mechanism<f64>>::Inputs::from_array([0.0; 2]);
    let at = |position| {
        let given = [Motion { position, rate: 0.0, acceleration: 0.0 }];
        let found = model.kinematics(0.0, &start.q, &given).expect("the crank turns");
        State::new(found.q, found.v)
    };
    let error = Reduced::along(&model, 0.0, &at(0.7), &none, &[]).expect_err("one freedom");
    assert_eq!(error, LinearisationError::Incomplete { needed: 1, given: 0 });
    assert!(Reduced::along(&model, 0.0, &at(0.7), &none, &[99]).is_err());

    let model = Slide::<f64>::default();
    let [travel, angle] =
        ["bore.travel", "main.angle"].map(|name| coordinate(&model, name).expect("start names it"));
    let at = |position| {
        let near = [Reading { coordinate: angle, position, rate: 0.0 }];
        measured(&model, 0.0, &model.start(), &near).expect("the crank turns")
    };
    let error = Reduced::along(&model, 0.0, &at(0.0), &(), &[travel]).expect_err("stretched");
    assert!(error.to_string().contains("bore.travel"), "{error}");
    let crank = Reduced::along(&model, 0.0, &at(0.7), &(), &[angle]).expect("regular");
    let slide = Reduced::along(&model, 0.0, &at(0.7), &(), &[travel]).expect("regular");
    // M of the travel times (dx/dθ)² is that of the crank.
    let ratio = (crank.motion(0).norm_squared() / slide.motion(0).norm_squared()).sqrt();
    let (m, i) = (slide.mass_matrix()[0], crank.mass_matrix()[0]);
    assert!((m * ratio * ratio - i).abs() < 1e-12 * i, "{m} {i} {ratio}");
    let x = (0.1 * 0.7_f64.cos()) + (0.09 - (0.1 * 0.7_f64.sin()).powi(2)).sqrt();
    assert!((coordinate_values(&model, 0.0, &at(0.7).q)[usize::from(travel)] - x).abs() < 1e-12);
}

linkwright::mechanism! {
    /// A slider-crank that knows two coordinates.
    pub planar Slide {
        rod crank { mass [kg] = 1; length [m] = 0.1; }
        rod bar   { mass [kg] = 1; length [m] = 0.3; }
        body piston { mass [kg] = 0.4; inertia [kg*m^2] = 2e-4; }
        joint main:  revolute(ground(0, 0) [m], crank.start);
        joint big:   revolute(crank.end, bar.start);
        joint wrist: revolute(bar.end, piston.center);
        joint bore:  prismatic(ground(0, 0) [m], piston.center, axis = (1, 0));
        start { main.angle [deg] = 60; bore.speed [m/s] = 0; bore.travel [m] ~ 0.3; }
        options { independent = (bore.travel); }
    }
}
