//! Velocities of the start, and the mass matrix at the assembled position.

use super::loose::{self, Loose, Way};
use super::point::{Ancestry, Point};
use super::{Assembly, messages};
use crate::diagnostics::Diagnostics;
use crate::equations::{Equations, Jet, Owner};
use crate::model::{BodyId, Mechanism};
use crate::solve::table::{DEPENDENT, Numeric, Table};
use crate::solve::{Massless, groups};
use std::collections::{BTreeMap, BTreeSet};

/// A trace of mass everywhere, in parts of the largest, decides between rates that cost no kinetic energy. More of it where masses
/// are so far apart that rounding takes the rows of the light parts for dependent: what holds comes before what is least.
const TRACES: [f64; 3] = [1e-12, 1e-8, 1e-4];

/// Rates that meet ν and what `start` asks, with the least kinetic energy ½ vᵀ M v + bᵀ v + c: [M D̂ᵀ; D̂ 0] [v; μ] = [−b; ν̂].
pub fn rates(
    mechanism: &Mechanism,
    equations: &Equations,
    point: &mut Point,
    q: &[f64],
    errors: &mut Diagnostics,
) -> Option<Vec<f64>> {
    let n = equations.symbols.v.len();
    point.set_q(q);
    let asked = equations.conditions.with_start();
    let asked: Vec<_> = asked.filter_map(|(condition, start)| Some((condition, start.rate?))).collect();
    let jets: Vec<&Jet> = equations
        .rows
        .iter()
        .map(|row| &row.jet)
        .chain(asked.iter().map(|(condition, _)| &condition.jet))
        .collect();
    point.evaluate(&Ancestry::of_jets(equations, jets.iter().copied()));
    point.evaluate(&Ancestry::of(equations, equations.mass.values().copied()));
    point.evaluate(&Ancestry::of(equations, asked.iter().map(|(_, rate)| *rate)));

    let mut structure: Vec<(usize, usize)> = equations.mass.keys().copied().collect();
    let mut entries: Vec<(usize, usize, f64)> =
        equations.mass.iter().map(|((i, j), node)| (*i, *j, point.get(*node))).collect();
    let largest = entries.iter().filter(|(i, j, _)| i == j).fold(0.0_f64, |m, (_, _, x)| m.max(*x));
    let mut rhs = vec![0.0; n + jets.len()];
    for (at, jet) in jets.iter().enumerate() {
        structure.extend(jet.columns.keys().map(|column| (n + at, *column)));
        entries.extend(jet.columns.iter().map(|(column, node)| (n + at, *column, point.get(*node))));
        rhs[n + at] = -point.get(jet.drift);
    }
    for (at, (_, rate)) in asked.iter().enumerate() {
        rhs[n + equations.rows.len() + at] += point.get(*rate);
    }
    for (force, momentum) in rhs.iter_mut().zip(carried_momentum(equations, point)) {
        *force -= momentum;
    }
    let table = Table::new(n, jets.len(), structure);
    let missing = |v: &[f64]| -> Vec<f64> {
        let product = |jet: &Jet| -> f64 {
            jet.columns.iter().map(|(column, node)| point.get(*node) * v[*column]).sum()
        };
        jets.iter().zip(&rhs[n..]).map(|(jet, right)| right - product(jet)).collect()
    };
    let with_trace = |trace: f64| -> Vec<f64> {
        let trace = (0..n).map(|k| (k, k, trace * largest.max(f64::MIN_POSITIVE)));
        let factor = Numeric::factor(&table, entries.iter().copied().chain(trace));
        let mut v = factor.solve(&rhs)[..n].to_vec();
        // Two refinements: the trace of mass and the spread of masses cost digits.
        for _ in 0..2 {
            let residual: Vec<f64> = vec![0.0; n].into_iter().chain(missing(&v)).collect();
            v.iter_mut().zip(factor.solve(&residual)).for_each(|(own, step)| *own += step);
        }
        v
    };
    let mut missed = None;
    for trace in TRACES {
        let v = with_trace(trace);
        let misses = missing(&v).into_iter().zip(&rhs[n..]).map(|(miss, right)| (miss.abs(), right.abs()));
        let Some((at, (miss, _))) =
            misses.enumerate().find(|(_, (miss, right))| *miss > 1e-9 * (1.0 + right))
        else {
            return Some(v);
        };
        missed.get_or_insert((at, miss));
    }
    let (at, miss) = missed?;
    let asked_for = at.checked_sub(equations.rows.len()).map(|at| asked[at].0.of.clone());
    let span = mechanism.start.iter().find(|start| start.exact).map(|start| start.span);
    errors.error(span.unwrap_or(mechanism.name.span), messages::rates_conflict(asked_for, miss));
    None
}

/// b of the kinetic energy ½ vᵀ M v + bᵀ v + c: places that move with time carry bodies along. From T itself, which is
/// quadratic: b_k = T(e_k) − T(0) − ½ M_kk. The position must be set.
fn carried_momentum(equations: &Equations, point: &mut Point) -> Vec<f64> {
    let n = equations.symbols.v.len();
    let ancestry = Ancestry::of(equations, [equations.kinetic_energy]);
    let mut energy = |v: &[f64]| {
        point.set_v(v);
        point.evaluate(&ancestry);
        point.get(equations.kinetic_energy)
    };
    let mut v = vec![0.0; n];
    let at_rest = energy(&v);
    if at_rest == 0.0 {
        return v;
    }
    let mut momentum = Vec::new();
    for k in 0..n {
        v[k] = 1.0;
        momentum.push(energy(&v) - at_rest);
        v[k] = 0.0;
    }
    point.set_v(&v);
    point.evaluate(&Ancestry::of(equations, equations.mass.values().copied()));
    for (k, own) in momentum.iter_mut().enumerate() {
        *own -= equations.mass.get(&(k, k)).map_or(0.0, |node| 0.5 * point.get(*node));
    }
    momentum
}

/// How much lighter than the heaviest part of the mechanism a row's own mass may be before its ρ follows it: so many times less
/// costs three digits, and one ρ for all rows saves operations.
const LIGHTER: f64 = 1024.0;

/// Velocities without mass of their own, the rows that hold them, and the weights of those rows.
///
/// Beside a ρ much larger than the mass that the row holds, that mass is lost in rounding; with a much smaller one the row's
/// pivot is. So where the row's own mass 1/Σ d²/m over the velocities that have mass, least among the components of its vector,
/// is far less than the mechanism's, it is the row's ρ.
pub fn massless(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    errors: &mut Diagnostics,
) -> Massless {
    let n = equations.symbols.v.len();
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    point.set_q(&assembly.q);
    point.evaluate(&Ancestry::of(equations, equations.mass.values().copied()));
    let mass: Vec<(usize, usize, f64)> =
        equations.mass.iter().map(|((i, j), node)| (*i, *j, point.get(*node))).collect();
    let table = Table::new(n, 0, mass.iter().map(|(i, j, _)| (*i, *j)));
    let pivots = Numeric::factor(&table, mass.iter().copied()).relative_pivots;
    let zero: BTreeSet<usize> = (0..n).filter(|k| !pivots[*k].is_finite() || pivots[*k] < 1e-12).collect();
    if zero.is_empty() {
        return Massless::default();
    }

    // A singular direction may involve every velocity coupled to one without a pivot.
    let mut velocities = zero.clone();
    loop {
        let coupled = mass.iter().filter(|(i, j, _)| velocities.contains(i) != velocities.contains(j));
        let more: Vec<usize> = coupled.flat_map(|(i, j, _)| [*i, *j]).collect();
        if more.is_empty() {
            break;
        }
        velocities.extend(more);
    }
    let touches = |jet: &Jet| jet.columns.keys().any(|column| velocities.contains(column));
    let active = (0..equations.rows.len()).filter(|row| !equations.idle.contains(row));
    let rows: BTreeSet<usize> = active.filter(|row| touches(&equations.rows[*row].jet)).collect();
    let largest = mass.iter().filter(|(i, j, _)| i == j).fold(0.0_f64, |m, (_, _, x)| m.max(*x));
    let largest = if largest > 0.0 { largest } else { 1.0 };
    point.evaluate(&Ancestry::of_jets(equations, rows.iter().map(|row| &equations.rows[*row].jet)));
    let own: BTreeMap<usize, f64> =
        mass.iter().filter(|(i, j, _)| i == j && !zero.contains(i)).map(|(k, _, m)| (*k, *m)).collect();
    let mobility = |row: usize| -> f64 {
        let columns = equations.rows[row].jet.columns.iter();
        columns.filter_map(|(k, d)| own.get(k).map(|m| point.get(*d).powi(2) / m)).sum()
    };
    let groups = groups(&equations.rows);
    let weight = |row: usize| {
        let together =
            |other: &usize| *other == row || groups[row].is_some() && groups[*other] == groups[row];
        let most = rows.iter().copied().filter(together).map(mobility).fold(0.0, f64::max);
        let mass = if largest * most > LIGHTER { 1.0 / most } else { largest };
        // A power of two, so that scaling by it rounds nothing.
        2.0_f64.powi(mass.log2().round() as i32)
    };
    let rows: BTreeMap<usize, f64> = rows.iter().map(|row| (*row, weight(*row))).collect();

    let loose = loose_velocities(&mut point, &mass, &rows, n);
    report_loose(mechanism, equations, assembly, &loose, errors);
    Massless { velocities, rows }
}

/// Names the bodies, and those that spin alone as what they are.
fn report_loose(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    velocities: &[usize],
    errors: &mut Diagnostics,
) {
    if velocities.is_empty() {
        return;
    }
    let alone = loose::find(mechanism, equations, &assembly.q, &assembly.phases);
    let (names, owners) = (equations.layout.velocity_names(mechanism), equations.layout.owners(mechanism));
    for velocity in velocities {
        let id = body_of(equations, owners[*velocity]);
        let spins = |loose: &&Loose| matches!(loose.way, Way::Spinning { .. }) && loose.members.contains(&id);
        let body = &mechanism.bodies[id.0];
        let message = match alone.iter().find(spins) {
            Some(loose) => messages::massless_spin(loose),
            None => messages::massless(&body.name.text, &names[*velocity]),
        };
        errors.error(body.mass_span, message);
    }
}

/// Entries of D below this, in parts of the largest of their row, are rounding.
const ROUNDING: f64 = 1e-13;

/// Velocities that neither mass nor constraints hold: zero pivots of M + Dᵀ ρ D.
fn loose_velocities(
    point: &mut Point,
    mass: &[(usize, usize, f64)],
    rows: &BTreeMap<usize, f64>,
    n: usize,
) -> Vec<usize> {
    let equations = point.equations;
    let mut entries = mass.to_vec();
    for (row, weight) in rows {
        let jet = &equations.rows[*row].jet;
        let columns: Vec<(usize, f64)> =
            jet.columns.iter().map(|(column, node)| (*column, point.get(*node))).collect();
        let largest = columns.iter().fold(0.0_f64, |largest, (_, x)| largest.max(x.abs()));
        // An entry that is rounding beside the rest of its row holds nothing: alone its square would look like a sound pivot.
        let hold = |x: f64| if x.abs() < ROUNDING * largest { 0.0 } else { x };
        for (at, (a, x)) in columns.iter().enumerate() {
            entries.extend(columns[..=at].iter().map(|(b, y)| (*a, *b, weight * hold(*x) * hold(*y))));
        }
    }
    let table = Table::new(n, 0, entries.iter().map(|(i, j, _)| (*i, *j)));
    let pivots = Numeric::factor(&table, entries).relative_pivots;
    (0..n).filter(|k| pivots[*k] < DEPENDENT).collect()
}

/// The body itself, or the one that the joint carries.
fn body_of(equations: &Equations, owner: Owner) -> BodyId {
    let body = match owner {
        Owner::Body(body) => Some(body),
        Owner::Joint(joint) => {
            let mut attachments = equations.tree.attachments.iter();
            let own = attachments.find(|own| own.joint.is_some_and(|(carrying, _)| carrying == joint));
            own.map(|attachment| attachment.body)
        }
    };
    body.unwrap_or(BodyId(0))
}
