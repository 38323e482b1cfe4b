//! What formulations refuse, and what a step says.

use super::runs::AbsoluteWindows;
use linkwright::{
    AugmentedLagrangian, Formulation, LagrangeIndex1, Partitioned, Penalty, Projected, Simulation,
    SimulationError, State,
};
use linkwright_models::n_four_bar::NFourBar2;

type Model = NFourBar2<f64>;

fn refused<F: Formulation<f64, Model>>(formulation: F) -> String {
    let model = Model::default();
    let mut simulation = Simulation::new(&model, NFourBar2::START).formulation(formulation).step(1e-3);
    match simulation.advance() {
        Err(error @ SimulationError::Setting(_)) => error.to_string(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn settings_that_make_no_sense() {
    let penalty = Penalty::new(1e7);
    let iterated = AugmentedLagrangian::new(penalty);
    let projected = Projected::after(LagrangeIndex1);
    for (message, expected) in [
        (refused(Penalty { alpha: 0.0, ..penalty }), "the penalty's alpha is 0; it must be positive"),
        (refused(Penalty { alpha: -1e7, ..penalty }), "the penalty's alpha is -10000000"),
        (refused(Penalty { alpha: f64::NAN, ..penalty }), "the penalty's alpha is NaN"),
        (
            refused(Penalty { omega: -1.0, ..penalty }),
            "the penalty's omega is -1; it must be zero or positive",
        ),
        (refused(Penalty { mu: f64::INFINITY, ..penalty }), "the penalty's mu is inf"),
        (refused(AugmentedLagrangian { tolerance: 0.0, ..iterated }), "tolerance is 0; it must be positive"),
        (
            refused(AugmentedLagrangian { iterations: 0, ..iterated }),
            "iterations is 0; it must be at least 1",
        ),
        (
            refused(AugmentedLagrangian { penalty: Penalty { alpha: 0.0, ..penalty }, ..iterated }),
            "the penalty's alpha is 0",
        ),
        (refused(Projected { weight: 0.0, ..projected }), "the projection's weight is 0"),
        (
            refused(Projected { tolerance: -1e-14, ..projected }),
            "the projection's tolerance is -0.00000000000001",
        ),
        (refused(Projected { iterations: 0, ..projected }), "the projection's iterations is 0"),
        (
            refused(Partitioned { tolerance: 0.0, ..Partitioned::default() }),
            "the partitioning's tolerance is 0",
        ),
        (
            refused(Partitioned { iterations: 0, ..Partitioned::default() }),
            "the partitioning's iterations is 0",
        ),
    ] {
        assert!(message.contains(expected), "{message}");
    }
}

/// A projection that cannot reach its tolerance says by how much, and the state before stays.
#[test]
fn a_projection_out_of_reach_is_an_error() {
    let model = Model::default();
    let far = Projected { iterations: 1, ..Projected::after(LagrangeIndex1) };
    let mut off = NFourBar2::START;
    off.q[1] += 1e-3;
    off.q[0] = (1.0 - off.q[1] * off.q[1]).max(0.0).sqrt();
    let length = off.q[0].hypot(off.q[1]);
    (off.q[0], off.q[1]) = (off.q[0] / length, off.q[1] / length);
    off.q[2] = 0.05_f64.sin();
    off.q[3] = 0.05_f64.cos();
    let mut simulation = Simulation::new(&model, off).formulation(far).step(1e-3).accept_inconsistent_start();
    let error = simulation.advance().unwrap_err();
    assert!(matches!(error, SimulationError::Projection { .. }), "{error}");
    assert!(error.to_string().contains("off the constraints"), "{error}");
    assert_eq!((simulation.time(), simulation.state()), (0.0, &off));
}

#[test]
fn a_step_says_what_happened() {
    let model = Model::default();
    let penalty = Penalty::for_model(&model, 0.0, &NFourBar2::START.q, 1e-3);
    let iterated = AugmentedLagrangian::new(penalty);
    let mut simulation = Simulation::new(&model, NFourBar2::START).formulation(iterated).step(1e-3);
    let step = simulation.advance().expect("it runs");
    assert_eq!((step.time, step.size, step.stepped_over), (1e-3, 1e-3, 0));
    assert!((4..=40).contains(&step.iterations), "{step:?}");
    assert!(step.residual <= 1e-12 && step.reciprocal_condition > 1e-3, "{step:?}");
    assert!(step.near_singular.is_none() && step.rejections.total() == 0);

    let model = AbsoluteWindows::<f64>::default();
    let projected = Projected::after(LagrangeIndex1);
    let mut simulation = Simulation::new(&model, AbsoluteWindows::START).formulation(projected).step(0.02);
    let moved = (0..20).map(|_| simulation.advance().expect("it runs").moved).fold(0.0, f64::max);
    assert!(moved > 0.0 && moved < 1e-4, "{moved:e}");
}

/// An inconsistent start is refused with the amount and the remedy, which works.
#[test]
fn an_inconsistent_start_is_projected() {
    let model = Model::default();
    let mut off = NFourBar2::START;
    off.v[0] += 0.3;
    let error = Simulation::new(&model, off).step(1e-3).advance().unwrap_err().to_string();
    assert!(error.contains("3.0") && error.contains("model.project"), "{error}");
    let project: State<_, _> = linkwright::AssembleExt::project(&model, 0.0, &off).expect("it is near");
    assert!(Simulation::new(&model, project).step(1e-3).advance().is_ok());
}
