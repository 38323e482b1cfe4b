//! ∂(v̇, λ) by positions, velocities, inputs and parameters of mechanisms that emit their derivatives, as the runtime finds it
//! from the emitted functions, against the reference's.

use super::{casadi, compare, hash, python, recorded, request};
use crate::registry::{At, Model, compiled};
use crate::zoo_tangent::{Buoy, Flail, Gripper, Rocker, Spring, Winch};
use linkwright::{Fields, Linearisation, Response, Tangent, Vector};
use linkwright_compiler::schedule::Inputs;

/// Relative to the largest entry of a column's v̇ or λ.
const TOLERANCE: f64 = 1e-10;

/// A row for each velocity and each multiplier, a column for each position, velocity, input and parameter.
fn sensitivity<M: Model + Tangent<f64>>(inputs: &Inputs) -> Vec<Vec<f64>> {
    let model = M::prepared(&inputs.parameters).expect("parameters near their defaults");
    let at = At::<M>::of(inputs);
    let state = at.state();
    let here = Linearisation::at(&model, at.time, &state, &at.u).expect("a regular state");
    let by_parameters = here.by_parameters();
    let flat = |column: Response<M::V, M::Lambda>| {
        [column.acceleration.as_slice(), column.multipliers.as_slice()].concat()
    };
    let mut columns: Vec<Vec<f64>> = (0..model.velocity_count()).map(|k| flat(here.by_position(k))).collect();
    columns.extend((0..model.velocity_count()).map(|k| flat(here.by_velocity(k))));
    columns.extend((0..M::Inputs::NAMES.len()).map(|k| flat(here.by_input(k))));
    columns.extend((0..M::Parameters::NAMES.len()).map(|k| flat(by_parameters.column(k))));
    let row = |row: usize| columns.iter().map(|column| column[row]).collect();
    (0..model.velocity_count() + model.row_count()).map(row).collect()
}

fn write<M: Model + Tangent<f64>>(folder: &std::path::Path, name: &str) {
    let compiled = compiled::<M>(None);
    let hash = hash(&compiled.definition);
    let text = request::request_with(&compiled, &hash, &|_| None, &|inputs| {
        vec![("sensitivity", sensitivity::<M>(inputs))]
    });
    std::fs::write(folder.join(format!("{name}.tangent.json")), text).unwrap();
}

fn compare_recorded<M: Model + Tangent<f64>>(name: &str) {
    let model = M::standard();
    let record = recorded::record(name, "tangent");
    assert_eq!(
        record.hash,
        hash(&compiled::<M>(None).definition),
        "{name}: record it anew with RECORD_CASADI=1"
    );
    let states = record.sensitivities();
    assert!(!states.is_empty(), "{name}");
    for (inputs, expected) in states {
        let found = sensitivity::<M>(&inputs);
        for rows in [0..model.velocity_count(), model.velocity_count()..expected.len()] {
            let largest = |k: usize| rows.clone().fold(0.0_f64, |m, row| m.max(expected[row][k].abs()));
            let all = (0..found[0].len()).map(largest).fold(0.0, f64::max);
            for row in rows.clone() {
                for (k, (found, expected)) in found[row].iter().zip(&expected[row]).enumerate() {
                    let scale = largest(k).max(1e-3 * all);
                    let off = (found - expected).abs();
                    assert!(off <= TOLERANCE * scale, "{name}: [{row}][{k}] is {found:?}, not {expected:?}");
                }
            }
        }
    }
}

#[test]
fn derivatives_agree_with_casadi() {
    let Some(python) = python() else { return };
    let folder = casadi::target().join("tangent-requests");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    write::<Gripper>(&folder, "gripper");
    write::<Winch>(&folder, "winch");
    write::<Buoy>(&folder, "buoy");
    write::<Flail>(&folder, "flail");
    write::<Rocker>(&folder, "rocker");
    write::<Spring>(&folder, "spring");
    let record = recorded::folder();
    let mut arguments = vec!["--minimum", "100"];
    if std::env::var_os("RECORD_CASADI").is_some() {
        arguments.extend(["--record", record.to_str().unwrap(), "--states", "1"]);
    }
    compare(&python, &folder, &arguments);
}

/// The committed values hold on every machine, with CasADi or without.
#[test]
fn derivatives_agree_with_the_recorded_values() {
    if std::env::var_os("RECORD_CASADI").is_none() {
        compare_recorded::<Gripper>("gripper");
        compare_recorded::<Winch>("winch");
        compare_recorded::<Buoy>("buoy");
        compare_recorded::<Flail>("flail");
        compare_recorded::<Rocker>("rocker");
        compare_recorded::<Spring>("spring");
    }
}
