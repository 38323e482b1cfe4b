//! Singular positions: how near they are, who gets over them, on which branch.

use linkwright::{
    Assemble, AssembleExt, AugmentedLagrangian, Baumgarte, Formulation, LagrangeIndex1, NullSpace, Penalty,
    Projected, SemiImplicitEuler, Simulation, SimulationError, State,
};
use linkwright_models::bricard::Bricard;
use linkwright_models::change_point_four_bar::ChangePointFourBar;
use linkwright_models::n_four_bar::NFourBar2;
use std::f64::consts::PI;

/// Pivots vanish with the square of the distance from a flat position, whatever the rows are measured by.
#[test]
fn pivots_tell_the_distance_from_a_flat_position() {
    // Up to a flat position, and at it.
    let model = NFourBar2::<f64>::default();
    for angle in [1e-1, 1e-2, 1e-3, 1e-4, 0.0_f64] {
        let (c, s) = (angle.cos(), angle.sin());
        let q = [c, s, c, s, c, s, 1.0, 0.0, 1.0, 0.0];
        let found = model.factor(0.0, &q, 0.0, &mut <NFourBar2>::default().store());
        assert!(found <= s * s && found >= 0.02 * s * s, "{found:e} at {angle}");
    }
}

/// A flat position of the two windows: all rods along x, turning as parallelograms do.
fn flat() -> State<[f64; 10], [f64; 5]> {
    State::new([1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0], [-3.0, -3.0, -3.0, 0.0, 0.0])
}

#[test]
fn a_breakdown_stops_or_is_stepped_over() {
    let model = NFourBar2::<f64>::default();
    let baumgarte = Baumgarte { alpha: 10.0, beta: 10.0 };
    let mut simulation = Simulation::new(&model, flat()).formulation(baumgarte).step(1e-3);
    let error = simulation.advance().unwrap_err();
    let SimulationError::Breakdown { time, pivot, row } = error else { panic!("{error}") };
    assert!(time == 0.0 && pivot < 1e-14 && row.of.starts_with("right["), "{error}");
    assert_eq!((simulation.time(), simulation.state()), (0.0, &flat()));

    // Stepped over, it goes on along the branch it came.
    let mut simulation =
        Simulation::new(&model, flat()).formulation(baumgarte).step(1e-3).step_over_breakdowns();
    let begin = simulation.energy();
    let first = simulation.advance().expect("stepped over");
    assert!(first.stepped_over == 1, "{first:?}");
    let near = first.near_singular.expect("it is singular");
    assert!(
        near.time == 0.0 && near.reciprocal_condition < 1e-14 && near.row.of.starts_with("right["),
        "{near:?}"
    );
    simulation.advance_until(0.5).expect("it runs");
    assert!((simulation.energy() - begin).abs() < 1e-5, "{:e}", simulation.energy() - begin);
    let q = simulation.state().q;
    assert!((q[6] - 1.0).abs() < 1e-6 && (q[8] - 1.0).abs() < 1e-6, "the couplers stay level: {q:?}");
}

/// Penalty, augmented Lagrangian and their projections have accelerations at the singular position itself, and keep to the branch.
#[test]
fn softened_constraints_pass_the_singular_position_itself() {
    fn passes<F: Formulation<f64, NFourBar2<f64>>>(name: &str, formulation: F) {
        let model = NFourBar2::<f64>::default();
        let mut simulation = Simulation::new(&model, flat()).formulation(formulation).step(1e-3);
        let begin = simulation.energy();
        let first = simulation.advance().unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(first.stepped_over == 0, "{name}: {first:?}");
        simulation.advance_until(0.5).unwrap_or_else(|error| panic!("{name}: {error}"));
        let drift = (simulation.energy() - begin).abs();
        let q = simulation.state().q;
        println!("{name}: energy {drift:.1e} J, coupler {:.1e} rad", q[7]);
        assert!(drift < 1e-4, "{name}: {drift:e}");
        assert!(q[7].abs() < 1e-4 && q[9].abs() < 1e-4, "{name}: the couplers stay level: {q:?}");
    }
    let model = NFourBar2::<f64>::default();
    let penalty = Penalty::for_model(&model, 0.0, &flat().q, 1e-3);
    passes("penalty", penalty);
    passes("augmented Lagrangian", AugmentedLagrangian::new(penalty));
    passes("penalty, projected", Projected::after(penalty));
    passes("augmented Lagrangian, projected", Projected::after(AugmentedLagrangian::new(penalty)));
}

/// Where the four links of the change-point four-bar lie in one line, at 0.366 s, the rocker could turn either way.
#[test]
fn a_change_point_is_passed_and_reported() {
    fn passes<F: Formulation<f64, ChangePointFourBar<f64>>>(name: &str, formulation: F, h: f64, energy: f64) {
        let model = ChangePointFourBar::<f64>::default();
        let mut simulation =
            Simulation::new(&model, ChangePointFourBar::START).formulation(formulation).step(h);
        let begin = simulation.energy();
        let mut near = None;
        while simulation.time() < 0.6 {
            let step = simulation.advance().unwrap_or_else(|error| panic!("{name}: {error}"));
            near = near.or(step.near_singular);
            simulation.sample();
        }
        let near = near.unwrap_or_else(|| panic!("{name}: nothing reported"));
        let drift = (simulation.energy() - begin).abs();
        let outputs = simulation.sample().outputs;
        println!("{name}: {near:?}, energy {drift:.1e} J, rocker at {:.3} rad", outputs.rocker_angle);
        assert!((near.time - 0.3664).abs() < 1e-3 && near.row.of == "right", "{name}: {near:?}");
        assert!(drift < energy, "{name}: {drift:e} J");
        // The crank went on, and the rocker with it, to the other side of the line.
        assert!(outputs.crank_angle > PI && outputs.rocker_angle > PI, "{name}: {outputs:?}");
    }
    let model = ChangePointFourBar::<f64>::default();
    let penalty = Penalty::for_model(&model, 0.0, &ChangePointFourBar::START.q, 1e-3);
    passes("Baumgarte", Baumgarte { alpha: 20.0, beta: 20.0 }, 1e-4, 1e-5);
    passes("penalty", penalty, 1e-4, 1e-4);
    passes("augmented Lagrangian", AugmentedLagrangian::new(penalty), 1e-4, 1e-4);
    passes("index 1, projected", Projected::after(LagrangeIndex1), 1e-3, 1e-4);
    passes("penalty, projected", Projected::after(penalty), 1e-3, 1e-3);
    passes("null space", NullSpace, 1e-4, 1e-4);
    passes("null space, projected", Projected::after(NullSpace), 1e-3, 1e-4);
}

/// What is passed between two steps is told by the lengths of the steps: a week on, times in `f32` are 62 ms apart.
#[test]
fn what_is_passed_between_steps_is_seen_after_a_week() {
    fn passed(since: f32) -> f32 {
        let model = NFourBar2::<f32>::default();
        let (h, rate) = (0.03_f32, 10.0);
        // Flat in the middle of a step, by a method that looks at its beginning only.
        let (s, c) = (4.5 * h * rate).sin_cos();
        let start = State::new([c, s, c, s, c, s, 1.0, 0.0, 1.0, 0.0], [-rate, -rate, -rate, 0.0, 0.0]);
        let simulation = Simulation::new(&model, start).start_time(since).step(h);
        let mut simulation =
            simulation.formulation(Projected::after(LagrangeIndex1)).integrator(SemiImplicitEuler);
        (0..10)
            .find_map(|_| simulation.advance().expect("it runs").near_singular)
            .unwrap_or_else(|| panic!("nothing was seen after {since} s"))
            .time
    }
    let first = passed(0.0);
    assert!((first - 4.5 * 0.03).abs() < 0.01, "{first}");
    // To the distance of neighbouring times.
    assert!((passed(86_400.0) - 86_400.0 - first).abs() <= 0.016);
    assert!((passed(604_800.0) - 604_800.0 - first).abs() <= 0.125);
}

/// A row that repeats others is no singular position: it is left out of the estimate.
#[test]
fn redundant_rows_are_not_singular() {
    let model = Bricard::<f64>::default();
    let mut simulation = Simulation::new(&model, Bricard::START).step(1e-3);
    let step = simulation.advance().expect("it runs");
    assert!(step.near_singular.is_none() && step.reciprocal_condition > 1e-3, "{step:?}");
}

/// From the shipped start at 1 ms index 1 used to gain energy where the change point fell between two steps, and ran on.
#[test]
fn a_run_stops_where_energy_comes_from_nowhere() {
    let model = ChangePointFourBar::<f64>::default();
    let penalty = Penalty::for_model(&model, 0.0, &ChangePointFourBar::START.q, 1e-3);
    let mut simulation = Simulation::new(&model, ChangePointFourBar::START).formulation(penalty).step(1e-3);
    let begin = simulation.energy();
    let error = simulation.advance_until(2.0).unwrap_err();
    assert!(matches!(error, SimulationError::Unresolved { row, .. } if row.of == "right"), "{error}");
    assert!((simulation.energy() - begin).abs() < 0.1, "{}", simulation.energy() - begin);
    // The last good state can be gone on from.
    let start = model.project(0.0, simulation.state()).expect("it is nearly consistent");
    let mut onward = Simulation::new(&model, start).formulation(Projected::after(NullSpace)).step(1e-4);
    onward.advance_until(0.5).expect("it runs");
    assert!((onward.energy() - begin).abs() < 0.2, "{}", onward.energy() - begin);
}

/// Without sensible settings nothing is solved; a mechanism without rows used to panic.
#[test]
fn settings_are_checked_wherever_they_are_used() {
    let model = linkwright_models::double_pendulum::DoublePendulum::<f64>::default();
    let partitioned = linkwright::Partitioned { tolerance: f64::NAN, iterations: 10 };
    let mut simulation = Simulation::new(&model, model.start()).formulation(partitioned);
    assert!(matches!(simulation.multipliers(), Err(SimulationError::Setting(_))));
    assert!(matches!(simulation.acceleration(), Err(SimulationError::Setting(_))));
}
