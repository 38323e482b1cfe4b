//! M, forces and energies against one another; accelerations and multipliers put back into the equations they solve.

use super::machine::Machine;
use super::quantity::{Along, Quantity, dot};
use super::{Check, Report, beams, friction, rows};
use crate::forms::Law;
use crate::functions::Function;
use crate::model::Load;
use crate::schedule::Inputs;
use crate::symbolic::Node;

/// Step of differences along velocities of order one, s.
const STEP: f64 = 1e-3;

pub fn check(machine: &Machine, report: &mut Report) {
    mass_matrix(machine, report);
    friction::check(machine, report);
    inverse_dynamics(machine, report);
    if stands_still(machine) {
        energy(machine, report);
    }
    solution(machine, report, Function::Acceleration, Check::Solution);
    solution(machine, report, Function::AccelerationBaumgarte, Check::Baumgarte);
}

/// vᵀ M v = T(v) + T(−v) − 2 T(0).
fn mass_matrix(machine: &Machine, report: &mut Report) {
    let inputs = report.inputs;
    let energy = |factor: f64| {
        let v = inputs.v.iter().map(|v| factor * v).collect();
        machine.run(Function::KineticEnergy, &Inputs { v, ..inputs.clone() })[0]
    };
    let square = dot(&machine.mass_times(inputs, &exact(&inputs.v)), &inputs.v);
    let expected = energy(1.0) + energy(-1.0) - energy(0.0) * 2.0;
    report.compare(Check::MassMatrix, || "all velocities together".to_string(), square, expected);
}

/// Its result is M v̇ − Q.
fn inverse_dynamics(machine: &Machine, report: &mut Report) {
    let inputs = report.inputs;
    let product = machine.mass_times(inputs, &exact(&inputs.acceleration));
    let (inverse, mut forces) =
        (machine.run(Function::InverseDynamics, inputs), machine.run(Function::Forces, inputs));
    if machine.compiled.complete.equations.rows.is_empty() {
        friction::add(machine, inputs, &mut forces);
    }
    for (k, (product, force)) in product.into_iter().zip(forces).enumerate() {
        report.compare(Check::InverseDynamics, || velocity(machine, k), inverse[k], product - force);
    }
}

/// dT/dt = vᵀ (M v̇ − Q) + Σ P − dV_gravity/dt along any v and v̇, whatever the constraints.
///
/// V is that of gravity and springs; what springs take is the part of their powers that is odd in v, the rest being
/// that of their dampers.
fn energy(machine: &Machine, report: &mut Report) {
    let inputs = report.inputs;
    let energies = Along::of(STEP, |h| {
        let moved = machine.moved(inputs, h, &inputs.acceleration);
        let of = |function| machine.run(function, &moved)[0];
        vec![of(Function::KineticEnergy), of(Function::PotentialEnergy)]
    });
    let rates = energies.derivatives();
    let inverse = machine.run(Function::InverseDynamics, inputs);
    let powers = machine.run(Function::Powers, inputs);
    let back = Inputs { v: inputs.v.iter().map(|v| -v).collect(), ..inputs.clone() };
    let backwards = machine.run(Function::Powers, &back);
    let mut expected = dot(&inverse, &inputs.v) - rates[1] - beams::dissipated(machine, inputs);
    for (index, load) in machine.compiled.mechanism.loads.iter().enumerate() {
        expected = expected + powers[index];
        if load.stores() {
            expected = expected - (powers[index] - backwards[index]) * 0.5;
        }
    }
    expected = expected + friction::power_beside(machine, inputs);
    report.compare(Check::Energy, || "the rate of the kinetic energy".to_string(), rates[0], expected);
}

/// Whether no support moves by itself: it would work on what it carries. Nor may teeth store energy whose centres are held by rows that
/// random states do not meet, and whose forces would work on what these let go.
pub fn stands_still(machine: &Machine) -> bool {
    let equations = &machine.compiled.complete.equations;
    let loads = &machine.compiled.mechanism.loads;
    let of_teeth = |load: &Load| load.teeth.as_ref().is_some_and(|teeth| !teeth.axes_move) && load.stores();
    if loads.iter().any(|load| load.moves_by_itself() || of_teeth(load)) {
        return false;
    }
    // What has no law of its own changes with time only where its places do.
    let all = machine.compiled.mechanism.loads.iter().enumerate();
    let springs = all.filter(|(_, load)| load.form.law == Law::None);
    let of_springs = springs.flat_map(|(index, _)| {
        equations.contributions.loads[index].iter().chain([&equations.powers[index]]).copied()
    });
    let places =
        equations.motions.iter().flat_map(|motion| motion.position.iter().chain(&motion.orientation));
    let nodes: Vec<Node> = of_springs.chain(places.copied()).collect();
    !equations.graph.read().reachable(nodes).contains(&equations.symbols.time)
}

/// M v̇ + Dᵀ λ = Q, D v̇ = γ, or D v̇ = γ − 2α (D v − ν) − β² Φ.
pub fn solution(machine: &Machine, report: &mut Report, function: Function, check: Check) {
    let inputs = report.inputs;
    let mut right = [Function::Forces, Function::Gamma].map(|function| machine.run(function, inputs));
    if function.is_stabilised() {
        let phi = machine.run(Function::Constraints, inputs);
        let terms = rows::rates(machine, inputs).into_iter().zip(phi);
        for (right, (rate, phi)) in right[1].iter_mut().zip(terms) {
            *right = *right - rate * inputs.two_alpha - phi * inputs.beta_squared;
        }
    }
    let solution = machine.run(function, inputs);
    let [acceleration, lambda, _pivot] = machine.groups(function, &solution);
    friction::rub(machine, inputs, function, [acceleration, lambda], &mut right[0]);
    residuals(machine, report, check, inputs, [acceleration, lambda], &right, 0.0);
}

/// M v̇ + Dᵀ λ and D v̇ − c λ of a solution, v̇ and λ, against right-hand sides.
pub fn residuals(
    machine: &Machine,
    report: &mut Report,
    check: Check,
    inputs: &Inputs,
    [acceleration, lambda]: [&[Quantity]; 2],
    [forces, rates]: &[Vec<Quantity>; 2],
    compliance: f64,
) {
    let jacobian = machine.jacobian(inputs);
    let mut sums = machine.mass_times(inputs, acceleration);
    for (row, lambda) in jacobian.iter().zip(lambda) {
        for (column, entry) in row {
            sums[*column] = sums[*column] + *entry * *lambda;
        }
    }
    for (k, (sum, force)) in sums.into_iter().zip(forces).enumerate() {
        report.compare(check, || velocity(machine, k), sum, *force);
    }
    for (row, (columns, right)) in jacobian.iter().zip(rates).enumerate() {
        // A row that others replace holds at consistent states only.
        if !machine.compiled.complete.equations.idle.contains(&row) {
            let softened = lambda[row] * -compliance;
            let sum =
                columns.iter().fold(softened, |sum, (column, entry)| sum + *entry * acceleration[*column]);
            report.compare(check, || rows::name(machine, row), sum, *right);
        }
    }
}

fn exact(values: &[f64]) -> Vec<Quantity> {
    values.iter().map(|value| Quantity::exact(*value)).collect()
}

/// The equation of a velocity, by its name.
pub fn velocity(machine: &Machine, index: usize) -> String {
    let compiled = machine.compiled;
    format!(
        "the equation of {}",
        compiled.complete.equations.layout.velocity_names(&compiled.mechanism)[index]
    )
}
