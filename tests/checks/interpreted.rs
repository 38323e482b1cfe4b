//! Every mechanism that ships, and those of the zoo, interpreted: tables, functions and runs are those of the emitted code, to the bit. Rounding is the same
//! where multiply and add are not fused in look-ups of tables: on targets without that instruction.

use crate::registry::{At, Model, Random, compiled, fields, for_each, vector};
use linkwright::{
    Assemble, AssembleExt, Baumgarte, Fields, Formulation, LagrangeIndex1, Mechanism, NullSpace, Partitioned,
    Projected, Simulation, State, StateOf, Variables, Vector,
};
use linkwright_compiler::Compiled;
use linkwright_engine::{Engine, List, Numbers};

/// Bits of lists that have to be the same.
fn same(what: &str, emitted: &[f64], interpreted: &[f64]) {
    let bits = |list: &[f64]| list.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(emitted), bits(interpreted), "{what}: {emitted:?} and {interpreted:?}");
}

fn list<V: Vector<f64>>(vector: &V) -> List {
    List::of(vector.as_slice())
}

fn state_of<M: Model>(state: &StateOf<M>) -> StateOf<Engine> {
    State { q: list(&state.q), v: list(&state.v), z: list(&state.z), gates: list(&state.gates) }
}

for_each!(the_interpreter_is_the_emitted_code);

fn the_interpreter_is_the_emitted_code<M: Model>() {
    let compiled = compiled::<M>(None);
    let engine = Engine::of(&compiled).expect("it fits");
    tables(&M::standard(), &engine);
    functions::<M>(&compiled, &engine);
    runs(&M::standard(), &engine);
}

fn tables<M: Model>(model: &M, engine: &Engine) {
    assert_eq!(model.name(), engine.name());
    assert_eq!(model.fingerprint(), engine.fingerprint());
    assert_eq!(model.layout(), engine.layout());
    assert_eq!(model.rows(), engine.rows());
    assert_eq!(model.position_names(), engine.position_names());
    assert_eq!(model.velocity_names(), engine.velocity_names());
    assert_eq!(model.internal_names(), engine.internal_names());
    assert_eq!(model.input_names(), engine.input_names());
    assert_eq!((model.gate_names(), model.is_rigid()), (engine.gate_names(), engine.is_rigid()));
    assert_eq!(model.output_names(), engine.output_names());
    assert_eq!(model.internal_scales(), engine.internal_scales());
    assert_eq!(model.mass_pattern(), engine.mass_pattern());
    assert_eq!(model.jacobian_pattern(), engine.jacobian_pattern());
    assert_eq!(model.null_space_first(), engine.null_space_first());
    assert_eq!(model.conditions(), engine.conditions());
    assert_eq!(model.start_conditions(), engine.start_conditions());
    assert_eq!(model.start_rates(), engine.start_rates());
    assert_eq!(model.independent(), engine.independent());
    assert_eq!(model.condition_pattern(), engine.condition_pattern());
    assert_eq!(model.flips(), engine.flips());
    assert_eq!(model.idle(), engine.idle());
    assert_eq!(model.dependent(), engine.dependent());
    assert_eq!(model.scales(), engine.scales());
    assert_eq!(model.massless_rows(), engine.massless_rows());
    assert_eq!(model.massless_weights(), engine.massless_weights());
    assert_eq!(model.elimination(), engine.elimination());
    same("row_sizes", model.row_sizes().as_slice(), engine.row_sizes().as_slice());
    let (start, other) = (model.start(), engine.start());
    same("start_q", start.q.as_slice(), other.q.as_slice());
    same("start_v", start.v.as_slice(), other.v.as_slice());
    same("start_internal", start.z.as_slice(), other.z.as_slice());
    same("start_gates", start.gates.as_slice(), other.gates.as_slice());
}

fn functions<M: Model>(compiled: &Compiled, engine: &Engine) {
    let mut random = Random::new(7);
    for _ in 0..3 {
        let mut point = random.point(compiled);
        let prepared = M::prepared(&point.parameters);
        let interpreted = engine.prepared(&point.parameters);
        let (model, engine) = match (prepared, interpreted) {
            (Ok(model), Ok(engine)) => (model, engine),
            (Err(error), Err(other)) => {
                assert_eq!(error, other);
                continue;
            }
            (one, other) => panic!("{:?} and {:?}", one.err(), other.err()),
        };
        point.phases.clear();
        let at = At::<M>::of(&point);
        let (state, u) = (at.state(), Numbers::of(&point.inputs));
        let (own, q, v) = (state_of::<M>(&state), List::of(&point.q), List::of(&point.v));
        /// Writes by both and compares.
        macro_rules! both {
            ($($function:ident($zero:ident, $($model:expr => $engine:expr),*)),* $(,)?) => { $(
                let (mut one, mut other) = (model.$zero(), engine.$zero());
                model.$function($($model,)* &mut one);
                engine.$function($($engine,)* &mut other);
                same(stringify!($function), one.as_slice(), other.as_slice());
            )* };
        }
        let time = point.time;
        both!(
            mass_matrix(zero_mass, time => time, &at.q => &q),
            constraints(zero_lambda, time => time, &at.q => &q),
            constraint_jacobian(zero_jacobian, time => time, &at.q => &q),
            nu(zero_lambda, time => time, &at.q => &q),
            gamma(zero_lambda, time => time, &at.q => &q, &at.v => &v),
            forces(zero_v, time => time, &state => &own, &at.u => &u),
            row_scales(zero_lambda,),
            row_cosines(zero_lambda, time => time, &at.q => &q),
            condition_jacobian(zero_condition_jacobian, time => time, &at.q => &q),
            condition_drift(zero_conditions, time => time, &at.q => &q),
            condition_bias(zero_conditions, time => time, &at.q => &q, &at.v => &v),
        );
        let targets: M::Conditions = vector(&point.targets);
        let own_targets = List::of(&point.targets);
        both!(
            condition_residual(zero_conditions, time => time, &at.q => &q, &targets => &own_targets),
            condition_cosines(zero_conditions, time => time, &at.q => &q, &targets => &own_targets),
        );
        same(
            "kinetic_energy",
            &[model.kinetic_energy(time, &at.q, &at.v)],
            &[engine.kinetic_energy(time, &q, &v)],
        );
        same(
            "potential_energy",
            &[model.potential_energy(time, &state)],
            &[engine.potential_energy(time, &own)],
        );
        /// Accelerations, multipliers and pivot.
        macro_rules! solutions {
            ($($function:ident($($scalar:expr),*)),*) => { $(
                let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
                let (mut other_a, mut other_lambda) = (engine.zero_v(), engine.zero_lambda());
                let pivot = model.$function(time, &state, &at.u, $($scalar,)* &mut a, &mut lambda);
                let other = engine.$function(time, &own, &u, $($scalar,)* &mut other_a, &mut other_lambda);
                same(concat!(stringify!($function), ": a"), a.as_slice(), other_a.as_slice());
                same(concat!(stringify!($function), ": lambda"), lambda.as_slice(), other_lambda.as_slice());
                same(concat!(stringify!($function), ": pivot"), &[pivot], &[other]);
            )* };
        }
        let (two_alpha, beta_squared) = (point.two_alpha, point.beta_squared);
        solutions!(
            acceleration(),
            acceleration_baumgarte(two_alpha, beta_squared),
            null_space(),
            null_space_baumgarte(two_alpha, beta_squared)
        );
        let ([mut gaps, mut forces], own_zeros) = ([at.gates; 2], own.gates.clone());
        let [mut own_gaps, mut own_forces] = [own_zeros.clone(), own_zeros.clone()];
        model.guards(time, &state, &mut gaps, &mut forces);
        engine.guards(time, &own, &mut own_gaps, &mut own_forces);
        same("guards: gaps", gaps.as_slice(), own_gaps.as_slice());
        same("guards: forces", forces.as_slice(), own_forces.as_slice());
        let [mut rates, mut biases, mut shares] = [at.gates; 3];
        let [mut own_rates, mut own_biases, mut own_shares] =
            [own_zeros.clone(), own_zeros.clone(), own_zeros.clone()];
        model.strikes(time, &at.q, &at.v, &mut rates, &mut biases, &mut shares);
        engine.strikes(time, &q, &v, &mut own_rates, &mut own_biases, &mut own_shares);
        same("strikes: rates", rates.as_slice(), own_rates.as_slice());
        same("strikes: biases", biases.as_slice(), own_biases.as_slice());
        same("strikes: restitutions", shares.as_slice(), own_shares.as_slice());
        assert_eq!(model.pressed_by(), engine.pressed_by());
        assert_eq!(model.slide_as_one(), engine.slide_as_one());
        // Where nothing is dry they write nothing.
        let [mut holding, mut sliding] = [at.gates.scaled(0.0), at.gates.scaled(0.0)];
        let [mut own_holding, mut own_sliding] = [own_zeros.scaled(0.0), own_zeros.scaled(0.0)];
        model.grips(&mut holding, &mut sliding);
        engine.grips(&mut own_holding, &mut own_sliding);
        same("grips: holding", holding.as_slice(), own_holding.as_slice());
        same("grips: sliding", sliding.as_slice(), own_sliding.as_slice());
        assert_eq!(model.sticks(), engine.sticks());
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.acceleration(time, &state, &at.u, &mut a, &mut lambda);
        model.bounds(time, &state, &at.u, &a, &lambda, &mut holding, &mut sliding);
        engine.bounds(time, &own, &u, &list(&a), &list(&lambda), &mut own_holding, &mut own_sliding);
        same("bounds: holding", holding.as_slice(), own_holding.as_slice());
        same("bounds: sliding", sliding.as_slice(), own_sliding.as_slice());
        let outputs = model.outputs(time, &state, &at.u);
        let mut own_outputs = engine.outputs(time, &own, &u);
        same("outputs", outputs.to_array().as_slice(), own_outputs.as_slice());
        let mut turned = outputs;
        model.unwrap_start(&mut turned);
        engine.unwrap_start(&mut own_outputs);
        same("unwrap_start", turned.to_array().as_slice(), own_outputs.as_slice());

        let mut solved = (model.zero_v(), model.zero_lambda());
        model.acceleration(time, &state, &at.u, &mut solved.0, &mut solved.1);
        let (a, lambda) = &solved;
        let (own_a, own_lambda) = (list(a), list(lambda));
        let mut rates = (model.zero_z(), engine.zero_z());
        model.internal_rates(time, &state, &at.u, a, lambda, &mut rates.0);
        engine.internal_rates(time, &own, &u, &own_a, &own_lambda, &mut rates.1);
        same("internal_rates", rates.0.as_slice(), rates.1.as_slice());
        same(
            "motions",
            &model.flat_motions(time, &at.q, &at.v, a),
            engine.motions(time, &q, &v, &own_a).as_slice(),
        );
        let reactions = engine.reactions(time, &own, &u, &own_a, &own_lambda);
        same("reactions", &model.flat_reactions(&at, a, lambda), reactions.as_slice());
        same("powers", &model.flat_powers(&at), engine.powers(time, &own, &u).as_slice());
        let inverse = engine.inverse_dynamics(time, &own, &u, &own_a);
        same("inverse_dynamics", &model.flat_inverse_dynamics(&at, a), inverse.as_slice());
        let efforts = engine.driver_efforts(time, &q, &v, &own_lambda);
        same("driver_efforts", &model.flat_driver_efforts(&at, lambda), efforts.as_slice());
        factorisations(&model, &engine, &at, &own);
    }
}

/// K(c) and D by what the mechanism has for them.
fn factorisations<M: Model>(model: &M, engine: &Engine, at: &At<M>, own: &StateOf<Engine>) {
    let (state, u) = (at.state(), Numbers::of(at.u.to_array().as_slice()));
    let (mut store, mut other) = (model.store(), engine.store());
    let mut one = (model.zero_v(), model.zero_lambda());
    let mut two = (engine.zero_v(), engine.zero_lambda());
    let pivot = model.system(at.time, &state, &at.u, 10.0, 25.0, 0.01, &mut store, &mut one.0, &mut one.1);
    let same_pivot = engine.system(at.time, own, &u, 10.0, 25.0, 0.01, &mut other, &mut two.0, &mut two.1);
    same("system: pivot", &[pivot], &[same_pivot]);
    same("system: forces", one.0.as_slice(), two.0.as_slice());
    same("system: rows", one.1.as_slice(), two.1.as_slice());
    let mut solved = (model.zero_v(), model.zero_lambda());
    let mut other_solved = (engine.zero_v(), engine.zero_lambda());
    model.solve(&store, &one.0, &one.1, &mut solved.0, &mut solved.1);
    engine.solve(&other, &two.0, &two.1, &mut other_solved.0, &mut other_solved.1);
    same("solve: a", solved.0.as_slice(), other_solved.0.as_slice());
    same("solve: lambda", solved.1.as_slice(), other_solved.1.as_slice());
    let (mut lu, mut other_lu) = (model.lu(), engine.lu());
    let pivot = model.factor_jacobian(at.time, &at.q, &mut lu);
    same("factor_jacobian", &[pivot], &[engine.factor_jacobian(at.time, &own.q, &mut other_lu)]);
    if pivot != 0.0 {
        let mut velocities = (model.zero_v(), engine.zero_v());
        model.dependent_velocities(&lu, &one.1, &at.v, &mut velocities.0);
        engine.dependent_velocities(&other_lu, &two.1, &own.v, &mut velocities.1);
        same("dependent_velocities", velocities.0.as_slice(), velocities.1.as_slice());
    }
}

/// Fifty steps from the start: the same states, or the same error.
fn runs<M: Model>(model: &M, engine: &Engine) {
    run(model, engine, Baumgarte { alpha: 10.0, beta: 10.0 });
}

for_each!(in sample, it_moves_alike_under_each_formulation);

fn it_moves_alike_under_each_formulation<M: Model>() {
    let (model, engine) = (M::standard(), Engine::of(&compiled::<M>(None)).expect("it fits"));
    run(&model, &engine, LagrangeIndex1);
    run(&model, &engine, Projected::after(LagrangeIndex1));
    run(&model, &engine, NullSpace);
    run(&model, &engine, Partitioned::default());
}

fn run<M: Model, F: Formulation<f64, M> + Formulation<f64, Engine> + Copy>(
    model: &M,
    engine: &Engine,
    formulation: F,
) {
    let zero: M::Inputs = fields(&vec![0.0; engine.input_names().len()]);
    let mut one = Simulation::new(model, model.start()).formulation(formulation).constant(zero).step(1e-3);
    let mut other = Simulation::new(engine, engine.start())
        .formulation(formulation)
        .constant(engine.no_inputs())
        .step(1e-3);
    let ends = (one.advance_steps(50).err(), other.advance_steps(50).err());
    assert_eq!(ends.0, ends.1);
    same("q", one.state().q.as_slice(), other.state().q.as_slice());
    same("v", one.state().v.as_slice(), other.state().v.as_slice());
    same("z", one.state().z.as_slice(), other.state().z.as_slice());
    same("gates", one.state().gates.as_slice(), other.state().gates.as_slice());
    same("energy", &[one.energy()], &[other.energy()]);
}
