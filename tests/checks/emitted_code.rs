//! Three evaluations of every function of every model agree: the emitted Rust, the interpreter of the scheduled
//! program it was written from, and the interpreter of the graph the program was selected from.
//!
//! Emitted code and program round alike wherever fused multiply-add is off, so they are compared bit for bit; program
//! and graph differ in the order of signs at most, and are compared with the rounding that the graph's own operations
//! allow. That the equations are the right ones is the business of `identities.rs` and of the reference.

use crate::registry::{At, Model, Random, compiled, for_each, vector};
use crate::zoo_tangent::for_each_with_tangent;
use linkwright::{Tangent, Vector};
use linkwright_compiler::Compiled;
use linkwright_compiler::model::Coordinates;
use linkwright_compiler::schedule::{self, Function, Inputs};
use linkwright_compiler::symbolic::{Graph, Node, Op, Unary, evaluate, of_patch, of_piece};

/// Whether the runtime's `mul_add` rounds once.
const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));
const POINTS: usize = 20;

for_each!(emitted_code_is_the_program);
for_each!(programs_are_the_graph);
for_each_with_tangent!(emitted_tangents_are_the_programs);

fn emitted_code_is_the_program<M: Model>() {
    let compiled = compiled::<M>(None);
    let mut random = Random::new(1);
    for point in 0..POINTS {
        let mut inputs = random.point(&compiled);
        if point == 0 {
            inputs.parameters = compiled.mechanism.parameters.iter().map(|known| known.default).collect();
        }
        let model = M::prepared(&inputs.parameters).expect("parameters near their defaults");
        inputs.prepared = schedule::run(compiled.programs.get(Function::Prepare), &inputs);
        fix_phases(&compiled, &mut inputs);
        let is_emitted = |function: &Function| (function.signature().emitted)(&compiled.complete);
        for function in Function::ALL.into_iter().filter(is_emitted) {
            let Some(emitted) = emitted(&model, &inputs, function) else { continue };
            let program = schedule::run(compiled.programs.get(function), &inputs);
            compare(model.name(), function, &emitted, &program);
        }
        factors_are_the_program(&compiled, &model, inputs.clone());
        factorisation_is_the_program(&compiled, &model, inputs);
    }
}

/// Phases that the start gives are taken from it with the parameters at hand, as `prepare` does.
fn fix_phases(compiled: &Compiled, inputs: &mut Inputs) {
    let start = Inputs { time: 0.0, q: compiled.assembly.q.clone(), ..inputs.clone() };
    let phi = schedule::run(compiled.programs.get(Function::Constraints), &start);
    for (phase, row) in compiled.complete.equations.open_rows(&compiled.mechanism).into_iter().enumerate() {
        inputs.phases[phase] += phi[row];
    }
    inputs.prepared = schedule::run(compiled.programs.get(Function::Prepare), inputs);
}

fn compare(name: &str, function: Function, emitted: &[f64], program: &[f64]) {
    assert_eq!(emitted.len(), program.len(), "{name}::{}", function.name());
    let same = |a: f64, b: f64| match FUSED {
        true => (a - b).abs() <= 1e-9 * (1.0 + b.abs()) || a.is_nan() && b.is_nan(),
        false => a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan(),
    };
    for (index, (a, b)) in emitted.iter().zip(program).enumerate() {
        assert!(same(*a, *b), "{name}::{}[{index}]: emitted {a:e}, program {b:e}", function.name());
    }
}

/// What the emitted function gives, flattened as the program's outputs; `None` where none is emitted.
fn emitted<M: Model>(model: &M, inputs: &Inputs, function: Function) -> Option<Vec<f64>> {
    let at = At::<M>::of(inputs);
    let (t, q, v, u) = (at.time, &at.q, &at.v, &at.u);
    let state = &at.state();
    let target = vector(&inputs.targets);
    let (a, lambda) = (vector(&inputs.acceleration), vector(&inputs.lambda));
    let solution = |solve: &dyn Fn(&mut M::V, &mut M::Lambda) -> f64| {
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let pivot = solve(&mut a, &mut lambda);
        a.as_slice().iter().chain(lambda.as_slice()).copied().chain([pivot]).collect()
    };
    Some(match function {
        Function::MassMatrix => written(model.zero_mass(), |out| model.mass_matrix(t, q, out)),
        Function::Constraints => written(model.zero_lambda(), |out| model.constraints(t, q, out)),
        Function::ConstraintJacobian => {
            written(model.zero_jacobian(), |out| model.constraint_jacobian(t, q, out))
        }
        Function::Nu => written(model.zero_lambda(), |out| model.nu(t, q, out)),
        Function::Gamma => written(model.zero_lambda(), |out| model.gamma(t, q, v, out)),
        Function::Forces => written(model.zero_v(), |out| model.forces(t, state, u, out)),
        Function::FrictionForces => {
            written(model.zero_v(), |out| model.friction_forces(t, state, u, &a, &lambda, out))
        }
        Function::KineticEnergy => vec![model.kinetic_energy(t, q, v)],
        Function::PotentialEnergy => vec![model.potential_energy(t, state)],
        Function::Acceleration => solution(&|a, lambda| model.acceleration(t, state, u, a, lambda)),
        Function::AccelerationBaumgarte => solution(&|a, lambda| {
            model.acceleration_baumgarte(t, state, u, inputs.two_alpha, inputs.beta_squared, a, lambda)
        }),
        Function::NullSpace => solution(&|a, lambda| model.null_space(t, state, u, a, lambda)),
        Function::NullSpaceBaumgarte => solution(&|a, lambda| {
            model.null_space_baumgarte(t, state, u, inputs.two_alpha, inputs.beta_squared, a, lambda)
        }),
        Function::Outputs => linkwright::Fields::to_array(&model.outputs(t, state, u)).as_slice().to_vec(),
        Function::InternalRates => {
            let mut rates = at.z;
            model.internal_rates(t, state, u, &a, &lambda, &mut rates);
            rates.as_slice().to_vec()
        }
        Function::Guards => {
            let [mut gaps, mut forces] = [at.gates; 2];
            model.guards(t, state, &mut gaps, &mut forces);
            [gaps.as_slice(), forces.as_slice()].concat()
        }
        Function::Assignments => written(at.gates, |after| model.assignments(t, state, u, after)),
        Function::Strikes => {
            let [mut rates, mut biases, mut restitutions] = [at.gates; 3];
            model.strikes(t, q, v, &mut rates, &mut biases, &mut restitutions);
            [rates.as_slice(), biases.as_slice(), restitutions.as_slice()].concat()
        }
        Function::Grips => {
            let [mut holding, mut sliding] = [at.gates; 2];
            model.grips(&mut holding, &mut sliding);
            [holding.as_slice(), sliding.as_slice()].concat()
        }
        Function::Bounds => {
            let [mut holding, mut sliding] = [at.gates; 2];
            model.bounds(t, state, u, &a, &lambda, &mut holding, &mut sliding);
            [holding.as_slice(), sliding.as_slice()].concat()
        }
        Function::InverseDynamics => model.flat_inverse_dynamics(&at, &a),
        Function::Powers => model.flat_powers(&at),
        Function::DriverEfforts => model.flat_driver_efforts(&at, &lambda),
        Function::Motions => model.flat_motions(t, q, v, &a),
        Function::Reactions => model.flat_reactions(&at, &a, &lambda),
        Function::RowCosines => written(model.zero_lambda(), |out| model.row_cosines(t, q, out)),
        Function::ConditionResidual => {
            written(model.zero_conditions(), |out| model.condition_residual(t, q, &target, out))
        }
        Function::ConditionCosines => {
            written(model.zero_conditions(), |out| model.condition_cosines(t, q, &target, out))
        }
        Function::ConditionJacobian => {
            written(model.zero_condition_jacobian(), |out| model.condition_jacobian(t, q, out))
        }
        Function::ConditionBias => written(model.zero_conditions(), |out| model.condition_bias(t, q, v, out)),
        Function::ConditionDrift => written(model.zero_conditions(), |out| model.condition_drift(t, q, out)),
        Function::StartTargets => {
            let (mut positions, mut rates) = (model.zero_conditions(), model.zero_conditions());
            model.start_targets(&mut positions, &mut rates);
            positions.as_slice().iter().chain(rates.as_slice()).copied().collect()
        }
        Function::StartInternal => model.start_internal().as_slice().to_vec(),
        Function::RowScales => written(model.zero_lambda(), |out| model.row_scales(out)),
        Function::Prepare | Function::Masses => return None,
        // Compared together below.
        Function::Factor | Function::System | Function::Solve => return None,
        Function::FactorJacobian | Function::DependentVelocities => return None,
        // Of mechanisms that emit them, below.
        Function::Residual
        | Function::Tangent
        | Function::RowTangent
        | Function::RateTangent
        | Function::InputTangent
        | Function::InternalTangent
        | Function::FrictionTangent
        | Function::InternalRateTangent
        | Function::ParameterTangent
        | Function::OutputTangent
        | Function::CoordinateTangent => return None,
    })
}

/// The factorisation of K(c) where it is emitted: factored, and set up, then solved.
fn factorisation_is_the_program<M: Model>(compiled: &Compiled, model: &M, mut inputs: Inputs) {
    let Some(stored) = &compiled.complete.further.stored else { return };
    let kept = stored.kept.len();
    let at = At::<M>::of(&inputs);
    let (mut store, compliance) = (model.store(), inputs.compliance);
    let solved = |store: &M::Store, forces: &M::V, rows: &M::Lambda, pivot: f64| {
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.solve(store, forces, rows, &mut a, &mut lambda);
        a.as_slice().iter().chain(lambda.as_slice()).copied().chain([pivot]).collect::<Vec<f64>>()
    };
    let pivot = model.factor(at.time, &at.q, compliance, &mut store);
    let emitted = solved(&store, &vector(&inputs.given_forces), &vector(&inputs.given_rows), pivot);
    let factored = schedule::run(compiled.programs.get(Function::Factor), &inputs);
    inputs.kept = factored[..kept].to_vec();
    let mut program = schedule::run(compiled.programs.get(Function::Solve), &inputs);
    program.push(factored[kept]);
    compare(model.name(), Function::Factor, &emitted, &program);
    if !compiled.complete.further.emits_system {
        return;
    }
    let (mut forces, mut rows) = (model.zero_v(), model.zero_lambda());
    let (two_alpha, beta_squared) = (inputs.two_alpha, inputs.beta_squared);
    let (At { time, u, .. }, state) = (&at, &at.state());
    let pivot = model.system(
        *time,
        state,
        u,
        two_alpha,
        beta_squared,
        compliance,
        &mut store,
        &mut forces,
        &mut rows,
    );
    let emitted = solved(&store, &forces, &rows, pivot);
    let set_up = schedule::run(compiled.programs.get(Function::System), &inputs);
    let (stored, rest) = set_up.split_at(kept);
    inputs.kept = stored.to_vec();
    inputs.given_forces = rest[..model.velocity_count()].to_vec();
    inputs.given_rows = rest[model.velocity_count()..rest.len() - 1].to_vec();
    let mut program = schedule::run(compiled.programs.get(Function::Solve), &inputs);
    program.extend(rest.last());
    compare(model.name(), Function::System, &emitted, &program);
}

/// D factored where that is emitted, then solved.
fn factors_are_the_program<M: Model>(compiled: &Compiled, model: &M, mut inputs: Inputs) {
    let further = &compiled.complete.further;
    let Some(written) = further.null_space.as_ref().filter(|_| further.emits_factors) else { return };
    let at = At::<M>::of(&inputs);
    let At { time, q, v, .. } = &at;
    let (mut lu, mut velocity) = (model.lu(), model.zero_v());
    let pivot = model.factor_jacobian(*time, q, &mut lu);
    model.dependent_velocities(&lu, &vector(&inputs.given_rows), v, &mut velocity);
    let emitted: Vec<f64> = velocity.as_slice().iter().copied().chain([pivot]).collect();
    let factored = schedule::run(compiled.programs.get(Function::FactorJacobian), &inputs);
    inputs.lu = factored[..written.kept.len()].to_vec();
    let mut program = schedule::run(compiled.programs.get(Function::DependentVelocities), &inputs);
    program.extend(factored.last());
    compare(model.name(), Function::DependentVelocities, &emitted, &program);
}

/// All functions of a mechanism that emits its derivatives.
fn emitted_tangents_are_the_programs<M: Model + Tangent<f64>>() {
    let model = M::standard();
    emitted_code_is_the_program::<M>();
    let compiled = compiled::<M>(None);
    assert!(compiled.complete.tangents.is_some(), "{}: nothing would be compared", model.name());
    let mut random = Random::new(3);
    for _ in 0..POINTS {
        let mut inputs = random.point(&compiled);
        let model = M::prepared(&inputs.parameters).expect("parameters near their defaults");
        inputs.prepared = schedule::run(compiled.programs.get(Function::Prepare), &inputs);
        fix_phases(&compiled, &mut inputs);
        let at = At::<M>::of(&inputs);
        let (At { time: t, q, v, u, .. }, state) = (&at, &at.state());
        let (t, a, lambda) = (*t, vector::<M::V>(&inputs.acceleration), vector::<M::Lambda>(&inputs.lambda));
        let (a, lambda) = (&a, &lambda);
        let check = |function: Function, emitted: Vec<f64>| {
            let program = schedule::run(compiled.programs.get(function), &inputs);
            compare(model.name(), function, &emitted, &program);
        };
        check(Function::Residual, written(model.zero_v(), |out| model.residual(t, state, u, a, lambda, out)));
        check(
            Function::RateTangent,
            written(model.zero_rate_tangent(), |out| model.rate_tangent(t, q, v, out)),
        );
        check(
            Function::InputTangent,
            written(model.zero_input_tangent(), |out| model.input_tangent(t, state, u, out)),
        );
        check(
            Function::ParameterTangent,
            written(model.zero_parameter_tangent(), |out| {
                model.parameter_tangent(t, state, u, a, lambda, out)
            }),
        );
        check(
            Function::OutputTangent,
            written(model.zero_output_tangent(), |out| model.output_tangent(t, state, u, a, lambda, out)),
        );
        check(
            Function::InternalTangent,
            written(model.zero_internal_tangent(), |out| model.internal_tangent(t, state, u, out)),
        );
        check(
            Function::FrictionTangent,
            written(model.zero_friction_tangent(), |out| model.friction_tangent(t, state, u, a, lambda, out)),
        );
        check(
            Function::InternalRateTangent,
            written(model.zero_internal_rate_tangent(), |out| {
                model.internal_rate_tangent(t, state, u, a, lambda, out)
            }),
        );
        check(
            Function::CoordinateTangent,
            written(model.zero_coordinate_tangent(), |out| model.coordinate_tangent(t, q, v, a, out)),
        );
        let mut second = model.zero_damping();
        let mut first =
            written(model.zero_stiffness(), |out| model.tangent(t, state, u, a, lambda, out, &mut second));
        first.extend(second.as_slice());
        check(Function::Tangent, first);
        let mut second = model.zero_row_damping();
        let mut first =
            written(model.zero_row_stiffness(), |out| model.row_tangent(t, q, v, a, out, &mut second));
        first.extend(second.as_slice());
        check(Function::RowTangent, first);
    }
}

fn written<V: Vector<f64>>(zeros: V, write: impl FnOnce(&mut V)) -> Vec<f64> {
    let mut out = zeros;
    // An entry that is not written is seen.
    out.as_mut_slice().fill(f64::INFINITY);
    write(&mut out);
    out.as_slice().to_vec()
}

fn programs_are_the_graph<M: Model>() {
    for coordinates in [Coordinates::Absolute, Coordinates::Tree] {
        let compiled = compiled::<M>(Some(coordinates));
        let mut random = Random::new(2);
        let points = if compiled.complete.equations.graph.read().len() > 20_000 { 3 } else { POINTS };
        for _ in 0..points {
            programs_are_the_graph_at(&compiled, random.point(&compiled));
        }
    }
}

fn programs_are_the_graph_at(compiled: &Compiled, mut inputs: Inputs) {
    let Compiled { complete, programs, .. } = compiled;
    let equations = &complete.equations;
    inputs.prepared = schedule::run(programs.get(Function::Prepare), &inputs);
    let symbols: Vec<f64> =
        schedule::sources(complete).into_iter().map(|source| inputs.get(source)).collect();
    let values = evaluate(&equations.graph.read(), &symbols);
    let errors = errors(&equations.graph.read(), &values);
    for function in Function::ALL {
        let nodes = schedule::outputs(complete, function);
        if function == Function::Prepare {
            continue;
        }
        let program = schedule::run(programs.get(function), &inputs);
        assert_eq!(program.len(), nodes.len(), "{}", function.name());
        for (index, (value, node)) in program.iter().zip(&nodes).enumerate() {
            let (graph, error) = (values[node.index()], errors[node.index()]);
            assert!(
                (value - graph).abs() <= 4.0 * error || value.is_nan() && graph.is_nan() || *value == graph,
                "{} of {} {:?}[{index}]: program {value:e}, graph {graph:e}, rounding {error:e}",
                function.name(),
                compiled.mechanism.name.text,
                compiled.choice.coordinates
            );
        }
    }
}

/// What rounding may make of each node, to first order: ε|x| of its own and |∂x/∂y| times that of each operand y.
fn errors(graph: &Graph, values: &[f64]) -> Vec<f64> {
    let mut errors: Vec<f64> = Vec::with_capacity(values.len());
    for (node, op) in graph.nodes() {
        let (value, error) = (|node: Node| values[node.index()], |node: Node| errors[node.index()]);
        let own = f64::EPSILON * value(node).abs();
        let propagated = match op {
            Op::Constant(_) | Op::Symbol(_) => 0.0,
            Op::Compare(..) | Op::And(..) | Op::Or(..) | Op::Not(_) => 0.0,
            Op::Neg(a) => error(a),
            Op::Add(a, b) | Op::Sub(a, b) => error(a) + error(b),
            Op::Mul(a, b) => error(a) * value(b).abs() + value(a).abs() * error(b),
            Op::Div(a, b) => (error(a) + value(node).abs() * error(b)) / value(b).abs(),
            Op::Unary(function, a) => slope(function, value(a)).abs() * error(a),
            Op::Min(a, b) | Op::Max(a, b) => error(a).max(error(b)),
            Op::Atan2(a, b) => {
                let (y, x) = (value(a), value(b));
                (error(a) * x.abs() + error(b) * y.abs()) / (x * x + y * y)
            }
            Op::Select(mask, a, b) => {
                if value(mask) != 0.0 {
                    error(a)
                } else {
                    error(b)
                }
            }
            Op::Cell(..) => 0.0,
            Op::Piece(table, orders, cell, x) => {
                let (slope, of_terms) = of_piece(graph.table(table), orders, value(cell), value(x));
                slope * error(x) + of_terms
            }
            Op::Patch(table, orders, cell, x, y) => {
                let (slopes, of_terms) =
                    of_patch(graph.table(table), orders, value(cell), [value(x), value(y)]);
                slopes[0] * error(x) + slopes[1] * error(y) + of_terms
            }
        };
        errors.push(own + propagated);
    }
    errors
}

fn slope(function: Unary, x: f64) -> f64 {
    match function {
        Unary::Reciprocal => 1.0 / (x * x),
        Unary::Sqrt => 0.5 / x.sqrt(),
        Unary::Abs => 1.0,
        Unary::Sign => 0.0,
        Unary::Sin => x.cos(),
        Unary::Cos => x.sin(),
        Unary::Tan => 1.0 / (x.cos() * x.cos()),
        Unary::Asin | Unary::Acos => 1.0 / (1.0 - x * x).sqrt(),
        Unary::Exp => x.exp(),
        Unary::Ln => 1.0 / x,
        Unary::Log10 => std::f64::consts::LOG10_E / x,
        Unary::Sinh => x.cosh(),
        Unary::Cosh => x.sinh(),
        Unary::Tanh => 1.0 / (x.cosh() * x.cosh()),
        Unary::Floor => 0.0,
    }
}
