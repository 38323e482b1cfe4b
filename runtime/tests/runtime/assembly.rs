//! Consistent states: the four-bar against its closed form and its own differences, weld and errors.

use crate::four_bar::{FourBar, Q};
use crate::support::Support;
use linkwright_runtime::{
    AssembleExt, AssemblyError, Mechanism, Motion, Residual, State, assemble_position, project_velocity,
    smallest_pivot,
};

/// The angle of the rocker from that of the crank: the triangle over the diagonal from crank pin to bearing.
fn rocker_angle(model: &FourBar, crank: f64) -> f64 {
    let [a, b, c] = model.lengths;
    let (x, y) = (a * crank.cos() - model.ground, a * crank.sin());
    let diagonal = x.hypot(y);
    y.atan2(x) - ((diagonal * diagonal + c * c - b * b) / (2.0 * diagonal * c)).acos()
}

fn kinematics(model: &FourBar, near: &Q, position: f64) -> linkwright_runtime::Kinematics<Q, [f64; 9]> {
    model.kinematics(0.0, near, &[Motion { position, rate: 7.0, acceleration: -20.0 }]).unwrap()
}

#[test]
fn start_is_assembled_to_rounding() {
    let model = FourBar::new();
    let start = model.assemble(&model.rough_start()).unwrap();
    let residual = Residual::of(&model, 0.0, &start);
    assert!(residual.position < 1e-14 && residual.velocity < 1e-14, "{residual:?}");
    assert!((start.q[7].atan2(start.q[6]) - 1.0).abs() < 1e-14);
    assert!((start.v[6] - 12.0).abs() < 1e-13);
    assert!((start.q[13] - 1.0).abs() < 1e-13, "the multi-turn angle moves with the pair");
}

#[test]
fn positions_follow_the_closed_form() {
    let model = FourBar::new();
    let mut near = model.assemble(&model.rough_start()).unwrap().q;
    for i in 0..400 {
        let crank = 1.0 + 0.05 * f64::from(i);
        near = kinematics(&model, &near, crank).q;
        let (expected, found) = (rocker_angle(&model, crank), (near[10], near[11]));
        assert!(
            (found.0 - expected.cos()).abs() < 1e-13 && (found.1 - expected.sin()).abs() < 1e-13,
            "{crank}"
        );
    }
    let angle = core::f64::consts::TAU * near[12] + near[13];
    assert!((angle - (1.0 + 0.05 * 399.0)).abs() < 1e-11, "{angle}");
}

#[test]
fn a_far_target_is_reached() {
    let model = FourBar::new();
    let near = model.assemble(&model.rough_start()).unwrap().q;
    let far = kinematics(&model, &near, -2.0).q;
    assert!((far[7].atan2(far[6]) + 2.0).abs() < 1e-13);
}

#[test]
fn rates_and_accelerations_are_derivatives() {
    let model = FourBar::new();
    let near = model.assemble(&model.rough_start()).unwrap().q;
    let h = 1e-4;
    let at = |t: f64| kinematics(&model, &near, 1.3 + 7.0 * t - 10.0 * t * t);
    let (before, now, after) = (at(-h), at(0.0), at(h));
    for body in 0..3 {
        for axis in 0..2 {
            let i = 2 * body + axis;
            let rate = (after.q[i] - before.q[i]) / (2.0 * h);
            let acceleration = (after.q[i] - 2.0 * now.q[i] + before.q[i]) / (h * h);
            assert!((rate - now.v[i]).abs() < 1e-5, "{i}: {rate} {}", now.v[i]);
            assert!((acceleration - now.a[i]).abs() < 1e-4 * now.a[i].abs().max(1.0), "{i}");
        }
    }
}

#[test]
fn projection_is_idempotent_and_orthogonal() {
    let model = FourBar::new();
    let start = model.assemble(&model.rough_start()).unwrap();
    let mut off = start;
    off.q[2] += 1e-3;
    off.v[4] += 0.3;
    let projected = model.project(0.0, &off).unwrap();
    let residual = Residual::of(&model, 0.0, &projected);
    assert!(residual.position < 1e-14 && residual.velocity < 1e-13, "{residual:?}");
    let again = model.project(0.0, &projected).unwrap();
    assert!(again.q.iter().zip(projected.q).all(|(a, b)| (a - b).abs() < 1e-14));

    // The correction is orthogonal, in the norm of M, to what the constraints allow.
    let corrected = project_velocity(&model, 0.0, &start.q, &off.v).unwrap();
    let mut mass = [0.0; 9];
    model.mass_matrix(0.0, &start.q, &mut mass);
    let product: f64 = (0..9).map(|i| (corrected[i] - off.v[i]) * mass[i] * start.v[i]).sum();
    assert!(product.abs() < 1e-13, "{product}");
}

#[test]
fn a_weld_is_turned_back_and_follows_time() {
    let model = Support { mass: 2.0, angle: 0.4 };
    let upside_down = [0.3, -0.2, (2.9_f64 + 0.4).cos(), (2.9_f64 + 0.4).sin()];
    let q = assemble_position(&model, 3.0, &upside_down, &[], &[]).unwrap();
    for (found, expected) in q.iter().zip([0.9, 0.0, 0.4_f64.cos(), 0.4_f64.sin()]) {
        assert!((found - expected).abs() < 1e-14, "{q:?}");
    }
    // No inertia: the mass matrix is singular, the constraint holds the rate.
    let v = project_velocity(&model, 3.0, &q, &[1.0, 1.0, 1.0]).unwrap();
    assert!((v[0] - 0.6).abs() < 1e-15 && v[1].abs() < 1e-15 && v[2].abs() < 1e-15, "{v:?}");
}

#[test]
fn what_cannot_be_reached_is_named() {
    let model = FourBar { ground: 5.0, ..FourBar::new() };
    let error = model.assemble(&model.rough_start()).unwrap_err();
    let text = error.to_string();
    assert!(
        matches!(error, AssemblyError::NoConvergence { .. } | AssemblyError::RankDeficient { .. }),
        "{error:?}"
    );
    assert!(text.contains("_pin") || text.contains("bearing"), "{text}");
}

#[test]
fn wrong_arguments_are_errors() {
    let model = FourBar::new();
    let near = model.rough_start().q;
    let error = model.kinematics(0.0, &near, &[]).unwrap_err();
    assert_eq!(error, AssemblyError::WrongLength { needed: 1, given: 0 });
    let error = assemble_position(&model, 0.0, &near, &[0.0; 2], &[2]).unwrap_err();
    assert_eq!(error, AssemblyError::NoSuchCondition { index: 2, count: 2 });
    let broken = FourBar { ground: f64::NAN, ..model };
    let error = broken.assemble(&State::new(near, [0.0; 9])).unwrap_err();
    assert!(matches!(error, AssemblyError::NonFinite { row } if row.of == "bearing"), "{error:?}");
}

#[test]
fn the_smallest_pivot_names_the_row() {
    let model = FourBar::new();
    let start = model.assemble(&model.rough_start()).unwrap();
    assert!(smallest_pivot(&model, 0.0, &start.q).0 > 1e-3);
    let flat = FourBar { lengths: [0.2, 0.4, 0.2], ground: 0.4, ..model };
    let (pivot, row) = smallest_pivot(&flat, 0.0, &flat.rough([0.0; 3]));
    assert!(pivot < 1e-14 && row.is_some(), "{pivot} {row:?}");
}
