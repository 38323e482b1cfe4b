//! Dormand and Prince's method on emitted models: tolerances against published runs, evaluations, projections, states between
//! the steps. Its orders are in `convergence.rs` and `space_convergence.rs`.

use linkwright::{
    AssemblyError, AugmentedLagrangian, DormandPrince, Evaluation, Formulation, LagrangeIndex1, Mechanism,
    NullSpace, Partitioned, Penalty, PivotOf, Projected, Residual, SettingError, Settled, Simulation,
    StateOf,
};
use linkwright_models::andrews::Andrews;
use linkwright_models::four_spherical_joints::FourSphericalJoints;
use linkwright_models::heavy_top::HeavyTop;
use linkwright_models::n_four_bar::NFourBar2;
use linkwright_models::spatial_four_bar::Fourbar1;
use std::cell::Cell;

/// A formulation that counts its evaluations.
struct Counting<'c, F>(F, &'c Cell<u32>);

impl<M: Mechanism<f64>, F: Formulation<f64, M>> Formulation<f64, M> for Counting<'_, F> {
    type Memory = F::Memory;

    fn pivot_of(model: &M) -> PivotOf {
        F::pivot_of(model)
    }
    fn memory(&self, model: &M) -> F::Memory {
        self.0.memory(model)
    }
    fn acceleration(
        &self,
        memory: &mut F::Memory,
        model: &M,
        time: f64,
        state: &mut StateOf<M>,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> Evaluation<f64> {
        self.1.set(self.1.get() + 1);
        self.0.acceleration(memory, model, time, state, u, a, lambda)
    }
    fn settle(
        &self,
        memory: &mut F::Memory,
        model: &M,
        time: f64,
        state: &mut StateOf<M>,
    ) -> Result<Settled<f64>, AssemblyError> {
        self.0.settle(memory, model, time, state)
    }
    fn check(&self) -> Result<(), SettingError> {
        self.0.check()
    }
}

/// The largest difference of two lists.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Quaternions up to their sign and body rates of the table, to 2 s: 20 turns a second for 48 turns.
#[test]
fn the_heavy_top_follows_the_tolerance() {
    let text = include_str!("../data/heavy_top_computed.csv");
    let rows = text.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit()));
    let rows: Vec<Vec<f64>> =
        rows.map(|line| line.split(',').map(|field| field.parse().expect("a number")).collect()).collect();
    let model = HeavyTop::<f64>::default();
    let mut errors = Vec::new();
    for digits in 6..=11 {
        let tolerance = 10.0_f64.powi(-digits);
        let evaluations = Cell::new(0);
        let mut simulation = Simulation::new(&model, HeavyTop::START)
            .formulation(Counting(LagrangeIndex1, &evaluations))
            .integrator(DormandPrince::tolerance(tolerance))
            .step(0.1);
        let mut error = 0.0_f64;
        for row in &rows {
            let state = simulation.advance_until(row[0]).expect("the top spins");
            let place: Vec<f64> =
                model.motions(row[0], &state.q, &state.v, &model.zero_v())[0].position.into();
            error = error.max(apart(&place, &row[8..11]));
        }
        println!("{tolerance:.0e}: place off by {error:.2e} m, {} evaluations", evaluations.get());
        assert!(error < 300.0 * tolerance && evaluations.get() < 80_000, "{tolerance:e}: {error:e}");
        errors.push(error);
    }
    assert!(rows.last().is_some_and(|row| row[0] == 2.0));
    for pair in errors.windows(2) {
        assert!((3.0..30.0).contains(&(pair[0] / pair[1])), "{errors:?}");
    }
}

/// The IVP test set's reference at 0.03 s, which the classical method meets with 120 000 evaluations.
#[test]
fn andrews_of_the_ivp_test_set() {
    let model = Andrews::<f64>::default();
    let reference = [
        15.81077119629904,
        -15.75637105984298,
        0.04082224013073101,
        -0.5347301163226948,
        0.5244099658805304,
        0.5347301163226948,
        1.048080741042263,
    ];
    for (tolerance, bound, most) in [(1e-6, 3e-4, 7_000), (1e-8, 3e-6, 15_000), (1e-10, 3e-8, 40_000)] {
        let evaluations = Cell::new(0);
        let mut simulation = Simulation::new(&model, Andrews::START)
            .formulation(Counting(LagrangeIndex1, &evaluations))
            .integrator(DormandPrince::tolerance(tolerance))
            .step(0.01);
        let mut last = simulation.sample().outputs;
        let mut steps = 0;
        simulation
            .run_until(0.03, |sample| {
                last = sample.outputs;
                steps += 1;
            })
            .expect("the squeezer runs");
        let found = [last.beta, last.theta, last.gamma, last.phi, last.delta, last.omega, last.epsilon];
        let error = apart(&found, &reference);
        println!("{tolerance:.0e}: {error:.2e} rad, {} evaluations, {steps} steps", evaluations.get());
        assert!(error < bound, "{tolerance:e}: {error:e}");
        assert!(evaluations.get() < most, "{tolerance:e}: {}", evaluations.get());
    }
}

/// Six evaluations a step where nothing is changed at its end, seven where a projection changes the state.
#[test]
fn a_projection_asks_for_the_accelerations_again() {
    let model = FourSphericalJoints::<f64>::default();
    let start = FourSphericalJoints::START;
    let steps = 50;
    let count = |projected: bool| {
        let evaluations = Cell::new(0);
        let counting = Counting(LagrangeIndex1, &evaluations);
        let (h, fixed) = (2e-3, DormandPrince::fixed());
        let residual = if projected {
            let formulation = Projected::after(counting);
            let mut simulation =
                Simulation::new(&model, start).formulation(formulation).integrator(fixed).step(h);
            for _ in 0..steps {
                simulation.advance().expect("it swings");
            }
            simulation.constraint_residual()
        } else {
            let mut simulation =
                Simulation::new(&model, start).formulation(counting).integrator(fixed).step(h);
            for _ in 0..steps {
                simulation.advance().expect("it swings");
            }
            simulation.constraint_residual()
        };
        (evaluations.get(), residual)
    };
    let ((plain, drift), (projected, kept)) = (count(false), count(true));
    println!("{plain} and {projected} evaluations; {:.1e} and {:.1e} m", drift.position, kept.position);
    assert_eq!((plain, projected), (1 + 6 * steps, 7 * steps));
    assert!(kept.position < 1e-13 && kept.velocity < 1e-11, "{kept:?}");
}

/// The extension ends where the method ended the step, before the projection.
#[test]
fn between_projected_steps() {
    let model = Fourbar1::<f64>::default();
    let mut simulation = Simulation::new(&model, Fourbar1::START)
        .formulation(Projected::after(LagrangeIndex1))
        .integrator(DormandPrince::tolerance(1e-4))
        .step(0.1);
    simulation.advance_until(0.5).expect("it turns");
    let step = simulation.advance().expect("it turns");
    let just_before = simulation.interpolate(step.time - 1e-12 * step.size).expect("within the step");
    let jump = apart(just_before.q.as_slice(), simulation.state().q.as_slice());
    println!("{jump:.1e} against {:.1e} moved, size {:.3}", step.moved, step.size);
    assert!(step.moved > 0.0 && jump < 2.0 * step.moved + 1e-11, "{jump:e} {:e}", step.moved);
    for part in [1e-6, 0.25, 0.5, 0.75] {
        let time = step.time - (1.0 - part) * step.size;
        let state = simulation.interpolate(time).expect("within the step");
        let residual = Residual::of(&model, time, &state);
        assert!(residual.position < 1e-5 && residual.velocity < 1e-4, "{part}: {residual:?}");
    }
}

/// The augmented Lagrangian begins each iteration with the multipliers before it; a trial given up leaves none behind.
#[test]
fn other_formulations_have_adaptive_steps_too() {
    let model = NFourBar2::<f64>::default();
    let exact = Simulation::new(&model, NFourBar2::START).step(2e-4).advance_until(1.0).expect("it falls");
    let integrator = DormandPrince::tolerance(1e-9);
    let build = || Simulation::new(&model, NFourBar2::START).integrator(integrator).step(0.05);
    let lagrange = build().advance_until(1.0).expect("it falls");
    let augmented = AugmentedLagrangian::new(Penalty { alpha: 1e7, omega: 10.0, mu: 1.0 });
    let augmented = build().formulation(augmented).advance_until(1.0).expect("it falls");
    let null_space = build().formulation(NullSpace).advance_until(1.0).expect("it falls");
    let partitioned = build().formulation(Partitioned::default()).advance_until(1.0).expect("it falls");
    for found in [lagrange, augmented, null_space, partitioned] {
        let error = apart(found.q.as_slice(), exact.q.as_slice());
        println!("off by {error:.1e}");
        assert!(error < 1e-7, "{error:e}");
    }
}

/// The windows fall flat at 0.714 s. The pivot at a step's beginning, which tells what was passed, is that of the end of the
/// step before.
#[test]
fn a_singular_position_is_seen_between_steps() {
    let model = NFourBar2::<f64>::default();
    let build = || Simulation::new(&model, NFourBar2::START).step(2e-3);
    let mut classical = build();
    classical.advance_until(1.0).expect("it falls");
    let known = classical.near_singular().expect("it passes the flat position");
    for integrator in [DormandPrince::fixed(), DormandPrince::tolerance(1e-9)] {
        let mut simulation = build().integrator(integrator);
        simulation.advance_until(1.0).expect("it falls");
        let found = simulation.near_singular().expect("it passes the flat position");
        println!("{} s by Runge and Kutta, {} s, {:.1e}", known.time, found.time, found.reciprocal_condition);
        assert!(
            (found.time - known.time).abs() < 1e-3 && found.row.of == known.row.of,
            "{found:?} {known:?}"
        );
    }
}

/// Samples at even times lie on the motion, and cost no evaluation.
#[test]
fn samples_between_the_steps_cost_nothing() {
    let model = HeavyTop::<f64>::default();
    let run = |interval: f64| {
        let evaluations = Cell::new(0);
        let mut simulation = Simulation::new(&model, HeavyTop::START)
            .formulation(Counting(LagrangeIndex1, &evaluations))
            .integrator(DormandPrince::tolerance(1e-8))
            .step(0.1);
        let energy = simulation.energy();
        let mut worst = 0.0_f64;
        let mut count = 0;
        simulation
            .run_every(interval, 0.1, |sample| {
                worst = worst.max((sample.energy() - energy).abs());
                count += 1;
            })
            .expect("the top spins");
        (evaluations.get(), count, worst)
    };
    let (coarse, fine) = (run(0.05), run(1e-4));
    println!("{fine:?}");
    assert_eq!((coarse.0, coarse.1, fine.1), (fine.0, 3, 1001));
    assert!(fine.2 < 1e-3, "energy of 5436 J between the steps: {}", fine.2);
}
