//! Every mechanism against the reference, by CasADi itself. These tests take longest, and begin first by the name of this file: what is shorter
//! fills the processors beside and behind them.

use crate::reference::{compare, mutation, others, python, recorded, recorded_models, write_requests};

#[test]
fn models_agree_with_casadi() {
    let Some(python) = python() else {
        recorded::compare_all();
        return;
    };
    let record = recorded::folder();
    let mutated = mutation::MODELS.join(",");
    let mut arguments = vec!["--minimum", "100"];
    if std::env::var_os("RECORD_CASADI").is_some() {
        arguments.extend(["--record", record.to_str().unwrap(), "--mutated", &mutated]);
    }
    compare(&python, &write_requests("requests", &recorded_models()), &arguments);
}

/// The rest is not recorded: without CasADi the other checks are all there is of it.
#[test]
fn the_zoo_agrees_with_casadi() {
    let Some(python) = python() else { return };
    let [zoo, _] = others();
    compare(&python, &write_requests("zoo-requests", &zoo), &["--minimum", "100"]);
}

#[test]
fn models_that_are_not_recorded_agree_with_casadi() {
    let Some(python) = python() else { return };
    let [_, models] = others();
    compare(&python, &write_requests("other-requests", &models), &["--minimum", "100"]);
}
