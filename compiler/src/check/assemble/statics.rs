//! Bodies that start bent as they are loaded: coordinates of modes at which these are not accelerated while their rates are what `start` says, by Newton's
//! method around the assembly. Where the mechanism rests, that is its static equilibrium; where it moves, modes begin without swinging.

use super::{Ancestry, Point, attempts, messages, problem, rates};
use crate::beams::Shapes;
use crate::check::elimination::eliminated;
use crate::diagnostics::{Diagnostics, Region};
use crate::equations::{Equations, Linear};
use crate::model::{Coordinate, Deforms, Expr, Mechanism};
use crate::solve::table::{Numeric, Table};

/// Steps of Newton's method.
const MOST: usize = 30;
/// Differences are taken across so much, and a step of so much is the last: m of a deflection, rad of a twist.
const ACROSS: f64 = 1e-7;
const SETTLED: f64 = 1e-13;
/// Trace of mass for velocities that carry none, of the largest.
const TRACE: f64 = 1e-12;

/// One mode that is looked for.
struct Bent {
    /// Its velocity.
    index: usize,
    coordinate: Coordinate,
}

/// The mechanism and its equations with what `start { coupler = static; }` asks for found; `None` after an error.
pub fn deflected(
    mut mechanism: Mechanism,
    mut equations: Equations,
    errors: &mut Diagnostics,
) -> Option<(Mechanism, Equations)> {
    let bent = modes(&mechanism, &equations);
    let mut p = vec![0.0; bent.len()];
    for _ in 0..MOST {
        if bent.is_empty() {
            return Some((mechanism, equations));
        }
        let residual = accelerations(&mechanism, &mut equations, &bent, &p, errors)?;
        let mut columns = Vec::new();
        for at in 0..p.len() {
            let mut moved = |sign: f64| {
                let mut p = p.clone();
                p[at] += sign * ACROSS;
                accelerations(&mechanism, &mut equations, &bent, &p, &mut Diagnostics::new())
            };
            let (Some(ahead), Some(behind)) = (moved(1.0), moved(-1.0)) else {
                let (name, mode, region) = named(&mechanism, &bent[at])?;
                let message = match held_by_start(&mechanism, &bent[at]) {
                    Some(stated) => messages::static_and_stated(name, &mode, &stated),
                    None => messages::static_and_held(name, &mode),
                };
                errors.error(region, message);
                return None;
            };
            let slope = ahead.iter().zip(behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * ACROSS));
            columns.push(slope.collect::<Vec<f64>>());
        }
        let row = |of: usize| columns.iter().map(|column| column[of]).chain([-residual[of]]).collect();
        let Ok(steps) = eliminated((0..p.len()).map(row).collect()) else { break };
        p.iter_mut().zip(&steps).for_each(|(p, step)| *p += step);
        if steps.iter().zip(&p).all(|(step, p)| step.abs() <= SETTLED + 1e-10 * p.abs()) {
            state(&mut mechanism, &mut equations, &bent, &p);
            return Some((mechanism, equations));
        }
    }
    let (at, largest) = p.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    let (name, mode, region) = named(&mechanism, &bent[at])?;
    errors.error(region, messages::no_static(name, &mode, MOST, *largest));
    None
}

/// What `start` states of places and directions, where the shapes of a body keep what joints hold of it.
fn held_by_start(mechanism: &Mechanism, mode: &Bent) -> Option<Vec<String>> {
    let Coordinate::Mode(body, ..) = &mode.coordinate else { return None };
    let Some(Deforms::Beam(beam)) = &mechanism.bodies[body.0].deforms else { return None };
    let is_mode = |coordinate: &Coordinate| matches!(coordinate, Coordinate::Mode(..));
    let stated =
        mechanism.start.iter().filter(|start| start.exact && !start.rate && !is_mode(&start.coordinate));
    let stated: Vec<String> = stated.map(|start| start.text.clone()).collect();
    (beam.slender.shapes != Shapes::Free && !stated.is_empty()).then_some(stated)
}

/// A body, its mode, and where the body is said to be static.
fn named<'m>(mechanism: &'m Mechanism, mode: &Bent) -> Option<(&'m str, String, Region)> {
    let Coordinate::Mode(body, mode, _) = &mode.coordinate else { return None };
    let of = &mechanism.bodies[body.0];
    let name = of.deforms.as_ref()?.mode_name(usize::from(*mode));
    let (_, region) = mechanism.deflected.iter().find(|(own, _)| own == body)?;
    Some((&of.name.text, name, *region))
}

/// Of the bodies that `start` wants static.
fn modes(mechanism: &Mechanism, equations: &Equations) -> Vec<Bent> {
    let linear = equations.layout.linear.iter().enumerate();
    linear
        .filter_map(|(index, linear)| {
            let Linear::Mode(body, mode) = linear else { return None };
            mechanism.deflected.iter().find(|(own, _)| own == body)?;
            let deforms = mechanism.bodies[body.0].deforms.as_ref()?;
            let coordinate = Coordinate::Mode(*body, *mode as u8, deforms.is_angle(*mode));
            Some(Bent { index, coordinate })
        })
        .collect()
}

/// Writes the coordinates into the conditions of `start`.
fn state(mechanism: &mut Mechanism, equations: &mut Equations, bent: &[Bent], p: &[f64]) {
    for (mode, value) in bent.iter().zip(p) {
        let own = mechanism.start.iter_mut().find(|start| start.coordinate == mode.coordinate && !start.rate);
        if let Some(start) = own {
            start.value = Expr::Number(*value);
        }
        equations.begin_at(&mode.coordinate, *value);
    }
}

/// p̈ of these modes where they start at p: [M Dᵀ; D 0] [v̇; λ] = [Q; γ].
fn accelerations(
    mechanism: &Mechanism,
    equations: &mut Equations,
    bent: &[Bent],
    p: &[f64],
    errors: &mut Diagnostics,
) -> Option<Vec<f64>> {
    bent.iter().zip(p).for_each(|(mode, value)| equations.begin_at(&mode.coordinate, *value));
    let equations = &*equations;
    let mut point = Point::at_defaults(mechanism, equations, &[]);
    let problem = problem(mechanism, equations, &mut point);
    let assembled = attempts::closed(mechanism, &problem, &mut point, errors)?;
    let q = attempts::settle_turns(&problem, &mut point, assembled).q;
    let phases = super::phases(mechanism, equations, &mut point, &q);
    point.set(&equations.symbols.phases, &phases);
    let v = rates::rates(mechanism, equations, &mut point, &q, errors)?;
    point.set_q(&q);
    point.set_v(&v);
    point.set(&equations.symbols.internal, &mechanism.internal_starts());
    point.hold();
    point.evaluate(&Ancestry::of_jets(equations, equations.rows.iter().map(|row| &row.jet)));
    let known = equations.mass.values().chain(&equations.forces).chain(&equations.gamma);
    point.evaluate(&Ancestry::of(equations, known.copied()));
    let (n, rows) = (v.len(), &equations.rows);
    let mut entries: Vec<(usize, usize, f64)> =
        equations.mass.iter().map(|((i, j), node)| (*i, *j, point.get(*node))).collect();
    let largest = entries.iter().filter(|(i, j, _)| i == j).fold(0.0_f64, |most, entry| most.max(entry.2));
    for (at, row) in rows.iter().enumerate() {
        entries.extend(row.jet.columns.iter().map(|(column, node)| (n + at, *column, point.get(*node))));
    }
    let table = Table::new(n, rows.len(), entries.iter().map(|(i, j, _)| (*i, *j)));
    let trace = (0..n).map(|k| (k, k, TRACE * largest));
    let right = equations.forces.iter().chain(&equations.gamma).map(|node| point.get(*node));
    let solution =
        Numeric::factor(&table, entries.iter().copied().chain(trace)).solve(&right.collect::<Vec<f64>>());
    Some(bent.iter().map(|mode| solution[mode.index]).collect())
}
