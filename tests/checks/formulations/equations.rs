//! Every formulation on every model at random states, against the equations it stands for.

use crate::identities::product;
use crate::registry::{At, Model, Random, for_each, vector};
use crate::walking::walk;
use linkwright::{
    AugmentedLagrangian, Formulation, LagrangeIndex1, NullSpace, Partitioned, Penalty, Projected, State,
    Vector, retract,
};
use linkwright_compiler::compile;
use linkwright_compiler::model::Coordinates;
use linkwright_compiler::schedule::{Function, Inputs, run};

const STATES: usize = 6;

for_each!(softened_constraints_are_solved);
for_each!(written_out_factorisations_solve);
for_each!(written_out_null_spaces_solve);
for_each!(null_space_and_iteration_agree_with_lagrange);
for_each!(projection_reaches_the_constraints_along_the_mass);

/// M a + Dᵀ λ − f and D a − c λ − r, each divided by the magnitude of its terms, or a thousandth of the largest of all of them;
/// the largest of all.
fn backward_error(
    mass: &[((usize, usize), f64)],
    jacobian: &[((usize, usize), f64)],
    compliance: &[f64],
    (a, lambda): (&[f64], &[f64]),
    (forces, rows): (&[f64], &[f64]),
) -> f64 {
    let mut rest = vec![(0.0, 0.0); a.len() + lambda.len()];
    let mut add = |at: usize, term: f64| {
        rest[at].0 += term;
        rest[at].1 += term.abs();
    };
    for &((i, j), entry) in mass {
        add(i, entry * a[j]);
        if i != j {
            add(j, entry * a[i]);
        }
    }
    for &((row, column), entry) in jacobian {
        add(column, entry * lambda[row]);
        add(a.len() + row, entry * a[column]);
    }
    for (row, (c, lambda)) in compliance.iter().zip(lambda).enumerate() {
        add(a.len() + row, -c * lambda);
    }
    for (at, given) in forces.iter().chain(rows).enumerate() {
        add(at, -given);
    }
    let least = 1e-3 * rest.iter().fold(0.0_f64, |most, (_, size)| most.max(*size));
    let relative =
        rest.iter().map(|(value, size)| if *size > 0.0 { value.abs() / size.max(least) } else { 0.0 });
    relative.fold(0.0, |worst: f64, value| if value.is_nan() { f64::INFINITY } else { worst.max(value) })
}

fn pairs(pattern: &[(u16, u16)], values: &[f64]) -> Vec<((usize, usize), f64)> {
    let at = |&(i, j): &(u16, u16)| (usize::from(i), usize::from(j));
    pattern.iter().map(at).zip(values.iter().copied()).collect()
}

/// K(c) of the emitted model, by whatever factorisation it has.
fn softened_constraints_are_solved<M: Model>() {
    let (_, _, model, states) = walk::<M>(7, STATES);
    let mut random = Random::new(8);
    for at in &states {
        let At { time, q, .. } = at;
        let (mut mass, mut jacobian) = (model.zero_mass(), model.zero_jacobian());
        model.mass_matrix(*time, q, &mut mass);
        model.constraint_jacobian(*time, q, &mut jacobian);
        let idle = |row: u16| model.idle().contains(&row);
        let jacobian: Vec<_> = pairs(model.jacobian_pattern(), jacobian.as_slice())
            .into_iter()
            .filter(|((row, _), _)| !idle(*row as u16))
            .collect();
        for compliance in [0.0, 1e-9, 1e-3, 10.0] {
            let mut store = model.store();
            let pivot = model.factor(*time, q, compliance, &mut store);
            assert!(pivot > 1e-9, "{}: pivot {pivot:e} at c = {compliance:e}", model.name());
            let forces: M::V = vector(&random.vector(model.velocity_count()));
            let mut rows: M::Lambda = vector(&random.vector(model.row_count()));
            model.idle().iter().for_each(|row| rows.as_mut_slice()[usize::from(*row)] = 0.0);
            let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
            model.solve(&store, &forces, &rows, &mut a, &mut lambda);
            let softness = vec![compliance; model.row_count()];
            let error = backward_error(
                &pairs(model.mass_pattern(), mass.as_slice()),
                &jacobian,
                &softness,
                (a.as_slice(), lambda.as_slice()),
                (forces.as_slice(), rows.as_slice()),
            );
            assert!(error < 1e-9, "{}: {error:e} at c = {compliance:e}", model.name());
            assert!(model.idle().iter().all(|row| lambda.as_slice()[usize::from(*row)] == 0.0));
        }
    }
}

/// K(c) as it is written out where a definition asks for it, in both sets of coordinates: the programs by the interpreter.
fn written_out_factorisations_solve<M: Model>() {
    factorisations_solve(M::standard().name(), M::source());
}

fn factorisations_solve(name: &str, source: &str) {
    let source = source.trim_end().strip_suffix('}').expect("a definition ends in a brace");
    let source = format!("{source} options {{ emit = (penalty, projection); }} }}");
    for coordinates in [Coordinates::Tree, Coordinates::Absolute] {
        let tokens = source.parse().expect("tokens");
        let Ok(compiled) = compile(tokens, Some(coordinates)) else {
            // Some angles cannot be counted in absolute coordinates.
            assert_eq!(coordinates, Coordinates::Absolute, "{}", name);
            continue;
        };
        let stored = compiled.complete.further.stored.as_ref().expect("it was asked for");
        let (n, kept) = (compiled.complete.equations.layout.velocities(), stored.kept.len());
        let mut random = Random::new(9);
        for _ in 0..STATES {
            let mut inputs = random.point(&compiled);
            // Where M is singular by itself, the rows in a random position need not make up for it.
            if !compiled.complete.solved.massless.rows.is_empty() {
                inputs.q = compiled.assembly.q.clone();
            }
            let program = |function: Function, inputs: &Inputs| run(compiled.programs.get(function), inputs);
            inputs.prepared = program(Function::Prepare, &inputs);
            let entries = |keys: Vec<(usize, usize)>, values: Vec<f64>| -> Vec<_> {
                keys.into_iter().zip(values).collect()
            };
            let mass = entries(
                compiled.complete.equations.mass.keys().copied().collect(),
                program(Function::MassMatrix, &inputs),
            );
            let rows = compiled.complete.equations.rows.iter().enumerate();
            let keys = rows.flat_map(|(row, r)| r.jet.columns.keys().map(move |column| (row, *column)));
            let mut jacobian = entries(keys.collect(), program(Function::ConstraintJacobian, &inputs));
            let idle = &compiled.complete.equations.idle;
            jacobian.retain(|((row, _), _)| !idle.contains(row));
            idle.iter().for_each(|row| inputs.given_rows[*row] = 0.0);

            let system = program(Function::System, &inputs);
            let factored = program(Function::Factor, &inputs);
            // What one function uses once another may use twice, so that their sums are in different orders.
            let alike = |one: &[f64], other: &[f64], of: &str| {
                let largest = one.iter().fold(1.0, |largest: f64, it| largest.max(it.abs()));
                for (one, other) in one.iter().zip(other) {
                    assert!((one - other).abs() <= 1e-9 * largest, "{}: {of}: {one} {other}", name);
                }
            };
            alike(&system[..kept], &factored[..kept], "one factorisation");
            alike(&system[kept..kept + n], &program(Function::Forces, &inputs), "forces");
            let count = compiled.complete.equations.rows.len();
            assert_eq!(system.len(), kept + n + count + 1);
            inputs.kept = factored[..kept].to_vec();
            let solution = program(Function::Solve, &inputs);
            let error = backward_error(
                &mass,
                &jacobian,
                &vec![inputs.compliance; count],
                solution.split_at(n),
                (&inputs.given_forces, &inputs.given_rows),
            );
            // Four light beams in a row, whose sections turn with 1e-5 of the inertia that their ends move with, lose two digits more.
            let most = if name == "PrincetonBeam" { 1e-7 } else { 1e-9 };
            assert!(error < most, "{} in {coordinates:?}: {error:e}", name);

            // The rows are γ − 2α (D v − ν) − β² Φ.
            let (gamma, phi) = (program(Function::Gamma, &inputs), program(Function::Constraints, &inputs));
            let mut rest = program(Function::Nu, &inputs);
            let all = program(Function::ConstraintJacobian, &inputs);
            let rows = compiled.complete.equations.rows.iter().enumerate();
            let keys = rows.flat_map(|(row, r)| r.jet.columns.keys().map(move |column| (row, *column)));
            for ((row, column), entry) in keys.zip(all) {
                rest[row] -= entry * inputs.v[column];
            }
            for (row, found) in system[kept + n..kept + n + count].iter().enumerate() {
                let terms = [gamma[row], inputs.two_alpha * rest[row], -inputs.beta_squared * phi[row]];
                let (sum, size): (f64, f64) = (terms.iter().sum(), terms.iter().map(|term| term.abs()).sum());
                assert!((found - sum).abs() <= 1e-11 * (1.0 + size), "{}: row {row}: {found} {sum}", name);
            }
        }
    }
}

/// The equations in independent velocities as they are written out where a definition asks for it, in both sets of coordinates:
/// D v = ν, D v̇ = γ and M v̇ + Dᵀ λ = Q hold where the programs say so, by the interpreter.
fn written_out_null_spaces_solve<M: Model>() {
    null_spaces_solve(M::standard().name(), M::source());
}

fn null_spaces_solve(name: &str, source: &str) {
    let source = source.trim_end().strip_suffix('}').expect("a definition ends in a brace");
    let source = format!("{source} options {{ emit = (null_space); }} }}");
    for coordinates in [Coordinates::Tree, Coordinates::Absolute] {
        let Ok(compiled) = compile(source.parse().expect("tokens"), Some(coordinates)) else {
            // Some angles cannot be counted in absolute coordinates.
            assert_eq!(coordinates, Coordinates::Absolute, "{}", name);
            continue;
        };
        let equations = &compiled.complete.equations;
        let (n, count) = (equations.layout.velocities(), equations.rows.len());
        let idle = &equations.idle;
        let written = compiled.complete.further.null_space.as_ref().expect("it was asked for");
        let mut random = Random::new(10);
        let mut solved = 0;
        for _ in 0..STATES {
            let mut inputs = random.point(&compiled);
            // Where M is singular by itself, the rows in a random position need not make up for it.
            // Nor need what rubs have one solution there.
            if !compiled.complete.solved.massless.rows.is_empty() || !equations.friction.is_none() {
                inputs.q = compiled.assembly.q.clone();
            }
            let program = |function: Function, inputs: &Inputs| run(compiled.programs.get(function), inputs);
            inputs.prepared = program(Function::Prepare, &inputs);
            let mass: Vec<_> =
                equations.mass.keys().copied().zip(program(Function::MassMatrix, &inputs)).collect();
            let rows = equations.rows.iter().enumerate();
            let keys = rows.flat_map(|(row, r)| r.jet.columns.keys().map(move |column| (row, *column)));
            let mut jacobian: Vec<_> = keys.zip(program(Function::ConstraintJacobian, &inputs)).collect();
            jacobian.retain(|((row, _), _)| !idle.contains(row));
            let of = |values: Vec<f64>| -> Vec<f64> {
                let live = |(row, value)| if idle.contains(&row) { 0.0 } else { value };
                values.into_iter().enumerate().map(live).collect()
            };
            let factored = program(Function::FactorJacobian, &inputs);
            let (kept, pivot) = factored.split_at(written.kept.len());
            inputs.given_rows = of(inputs.given_rows.clone());
            inputs.lu = kept.to_vec();
            // A random position may be one in which other velocities had better be dependent.
            if pivot[0] < 1e-6 {
                continue;
            }
            solved += 1;
            let bound = 1e-12 / pivot[0].min(1.0).sqrt();
            let v = program(Function::DependentVelocities, &inputs);
            let dependent: Vec<usize> =
                compiled.complete.further.partition.pivots().map(|pivot| pivot.velocity).collect();
            assert!((0..n).all(|i| dependent.contains(&i) || v[i] == inputs.v[i]), "{}", name);
            // With M and λ zero only D v = rows is left.
            let (none, rows) = (vec![0.0; n.max(count)], &inputs.given_rows);
            let error =
                backward_error(&[], &jacobian, &none[..count], (&v, &none[..count]), (&none[..n], rows));
            assert!(error < bound, "{} in {coordinates:?}: dependent velocities {error:e}", name);

            let all = program(Function::NullSpace, &inputs);
            let (solution, smallest) = all.split_at(n + count);
            // Equal but for the order of sums.
            let largest = pivot[0] * (1.0 + 1e-12);
            assert!(smallest[0] <= largest, "{}: {smallest:?} {pivot:?}", name);
            let (mut forces, gamma) =
                (program(Function::Forces, &inputs), of(program(Function::Gamma, &inputs)));
            if !equations.friction.is_none() {
                inputs.acceleration = solution[..n].to_vec();
                inputs.lambda = solution[n..].to_vec();
                let friction = program(Function::FrictionForces, &inputs);
                forces.iter_mut().zip(friction).for_each(|(force, friction)| *force += friction);
            }
            let error =
                backward_error(&mass, &jacobian, &none[..count], solution.split_at(n), (&forces, &gamma));
            assert!(error < 1e3 * bound, "{} in {coordinates:?}: {error:e}, pivot {pivot:?}", name);
        }
        assert!(2 * solved >= STATES, "{} in {coordinates:?}: only {solved} states", name);
    }
}

/// v̇ and λ of a formulation at a state.
fn accelerations<M: Model, F: Formulation<f64, M>>(
    model: &M,
    formulation: F,
    at: &At<M>,
) -> (M::V, M::Lambda) {
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    let mut state = at.state();
    let mut memory = formulation.memory(model);
    formulation.acceleration(&mut memory, model, at.time, &mut state, &at.u, &mut a, &mut lambda);
    (a, lambda)
}

/// At consistent states all accelerations are those of Lagrange's equations, whatever the formulation; so are the multipliers,
/// except of rows that are kept though redundant.
fn null_space_and_iteration_agree_with_lagrange<M: Model>() {
    let (_, _, model, states) = walk::<M>(11, STATES);
    for at in &states {
        let (a, lambda) = accelerations(&model, LagrangeIndex1, at);
        let size = 1.0 + a.max_abs();
        let compare = |name: &str, found: (M::V, M::Lambda), bound: f64| {
            let error = found.0.plus(-1.0, &a).max_abs() / size;
            assert!(error < bound, "{}, {name}: accelerations off by {error:e}", model.name());
            let reaction = |lambda: &M::Lambda| {
                let mut jacobian = model.zero_jacobian();
                model.constraint_jacobian(at.time, &at.q, &mut jacobian);
                let mut force = vec![0.0; model.velocity_count()];
                for (&(row, column), d) in model.jacobian_pattern().iter().zip(jacobian.as_slice()) {
                    force[usize::from(column)] += d * lambda.as_slice()[usize::from(row)];
                }
                force
            };
            let (found, known) = (reaction(&found.1), reaction(&lambda));
            let most = 1.0 + known.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
            let error = found.iter().zip(&known).map(|(a, b)| (a - b).abs() / most).fold(0.0, f64::max);
            assert!(error < bound, "{}, {name}: reactions off by {error:e}", model.name());
        };
        compare("null space", accelerations(&model, NullSpace, at), 1e-8);
        compare("partitioned", accelerations(&model, Partitioned::default(), at), 1e-8);
        let penalty = Penalty::for_model(&model, at.time, &at.q, 1e-3);
        compare("augmented Lagrangian", accelerations(&model, AugmentedLagrangian::new(penalty), at), 1e-8);
        compare("penalty", accelerations(&model, penalty, at), 1e-4);
    }
}

/// A position and velocity off the constraints are brought back; the way is orthogonal, in the norm of M, to what the constraints
/// allow.
fn projection_reaches_the_constraints_along_the_mass<M: Model>() {
    let (_, _, model, states) = walk::<M>(13, STATES);
    let mut random = Random::new(14);
    for at in &states {
        let off = vector::<M::V>(&random.vector(model.velocity_count())).scaled(1e-6);
        let mut q = at.q;
        retract(model.layout(), &at.q, &off, &mut q);
        let kick = vector::<M::V>(&random.vector(model.velocity_count())).scaled(1e-3);
        let mut state = at.at(q, at.v.plus(1.0, &kick));
        let before = state;
        let projected = Projected::after(LagrangeIndex1);
        let settled = Formulation::<f64, M>::settle(&projected, &mut (), &model, at.time, &mut state);
        settled.unwrap_or_else(|error| panic!("{}: {error}", model.name()));
        let mut phi = model.zero_lambda();
        model.constraints(at.time, &state.q, &mut phi);
        let size = 1.0 + state.q.max_abs();
        assert!(phi.max_abs() < 1e-13 * size * size, "{}: positions {:e}", model.name(), phi.max_abs());
        let mut jacobian = model.zero_jacobian();
        model.constraint_jacobian(at.time, &state.q, &mut jacobian);
        let mut nu = model.zero_lambda();
        model.nu(at.time, &state.q, &mut nu);
        let rate = product::<M>(&jacobian, &state.v, false);
        let terms = product::<M>(&jacobian, &state.v, true);
        for (row, ((rate, nu), size)) in rate.iter().zip(nu.as_slice()).zip(terms).enumerate() {
            assert!((rate - nu).abs() < 1e-11 * (1.0 + size), "{}: velocity of row {row}", model.name());
        }
        // wᵀ M Δv = 0 for every w with D w = 0.
        let change = state.v.plus(-1.0, &before.v);
        let free = State { v: vector(&random.vector(model.velocity_count())), ..state };
        let mut mass = model.zero_mass();
        model.mass_matrix(at.time, &state.q, &mut mass);
        let mut store = model.store();
        model.factor(at.time, &state.q, 0.0, &mut store);
        let allowed = {
            let mut rows = model.zero_lambda();
            let d = product::<M>(&jacobian, &free.v, false);
            for (row, d) in rows.as_mut_slice().iter_mut().zip(d) {
                *row = -d;
            }
            model.idle().iter().for_each(|row| rows.as_mut_slice()[usize::from(*row)] = 0.0);
            let (mut w, mut lambda) = (model.zero_v(), model.zero_lambda());
            model.solve(&store, &model.zero_v(), &rows, &mut w, &mut lambda);
            w.plus(1.0, &free.v)
        };
        // Where drivers leave no freedom, w is the rounding of what it came from: `whole` is the size of that.
        let (mut work, mut size, mut whole) = (0.0, 0.0_f64, 0.0_f64);
        for (&(i, j), entry) in model.mass_pattern().iter().zip(mass.as_slice()) {
            let (i, j) = (usize::from(i), usize::from(j));
            let twice = if i == j { 0.0 } else { allowed.as_slice()[j] * entry * change.as_slice()[i] };
            let term = allowed.as_slice()[i] * entry * change.as_slice()[j] + twice;
            work += term;
            size += term.abs();
            whole += (free.v.as_slice()[i] * entry * change.as_slice()[j]).abs();
        }
        // The factor belongs to the position before the correction of 1e-6.
        assert!(work.abs() < 1e-4 * (size + 1e-12 + 1e-9 * whole), "{}: {work:e} of {size:e}", model.name());
    }
}
