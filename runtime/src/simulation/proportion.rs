//! Steps whose result is out of all proportion: they are errors, not motion.
//!
//! Near singular positions accelerations divide by what is hardly known, and a step may end finite, Ok and absurd. Two
//! things tell that apart from a coarse but healthy step, whatever the formulation:
//!
//! - **Energy from nowhere**, or gone. Constraints at rest do no work: kinetic energy comes from potential energy, or from loads without
//!   one, whose work over the step is h (P₀ + P₁)/2 with the powers at its ends, to half their difference. Where places move or drivers
//!   prescribe, a bound remains: in the norm |v|² = vᵀ M v a step can add to the velocities what the loads add without constraints,
//!   what is prescribed, and what taking back Φ within the step needs, or take as much: ||v₁| − |v₀|| ≤ h |M⁻¹ Q| + |v_ν| + |v_Φ|/h.
//!   What does not add up to [`RESOLVED`] of the kinetic energy is an error. Velocities of an accepted start that are off the
//!   constraints may take or bring the energy that they have in that.
//! - **Constraints left behind.** A row is off by more than a tenth of a radian of the turns that it holds, or D v − ν is more than
//!   the largest velocity that the run has had so far would make of any position.
//!
//! Every step pays for max |v| alone. Energy is looked at where D is not far from losing rank; the constraints where the velocities have
//! doubled, where D nearly lost rank, and every [`EVERY`] steps.

use super::step::name_singularity;
use super::{NearSingular, Simulation};
use crate::assembly::determinacy::turned;
use crate::assembly::system::subtract_product;
use crate::error::SimulationError;
use crate::formulation::friction::applied;
use crate::formulation::{Formulation, Penalty, largest_mass};
use crate::input::InputSource;
use crate::integrator::Method;
use crate::mechanism::{Assemble, Row};
use crate::real::Real;
use crate::state::{State, StateOf};
use crate::vector::{Vector, dot};

/// Steps after which the constraints are looked at, whatever the velocities.
const EVERY: u32 = 64;

/// The turn by which a row may be off, rad.
const TURN: f64 = 0.1;

/// The part of the kinetic energy that may come from nowhere, or go, in a step: a method of order one that turns by ωh is off by some
/// (ωh)², one of order four by (ωh)⁵/120.
const RESOLVED: f64 = 1e-3;

/// By what part the bound on what loads bring may be more: it takes M at the step's beginning, and Q at its ends.
const MORE: f64 = 1.1;

/// The reciprocal condition below which energy may come from nowhere between two steps whose ends are not nearly singular.
const CLOSE: f64 = 1e-3;

/// What a run has been like so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Proportion<R> {
    /// The largest velocity, m/s or rad/s.
    fastest: R,
    /// Steps since the constraints were looked at.
    unseen: u32,
    /// How far rows are allowed to be off, rad; more than [`TURN`] from a start that was off by more and accepted.
    allowed: R,
    /// The kinetic energy of velocities off the constraints that an accepted start had and that has not come or gone yet, J.
    off: R,
}

impl<R: Real> Proportion<R> {
    pub fn new() -> Self {
        Proportion { fastest: R::ZERO, unseen: 0, allowed: R::from_f64(TURN), off: R::ZERO }
    }
}

/// A state at a time.
type At<'s, R, M> = (R, &'s StateOf<M, R>);

impl<'m, R: Real, M: Assemble<R>, F: Formulation<R, M>, S, I: Method<R>> Simulation<'m, M, R, F, S, I> {
    /// Takes the start as it is: velocities as they are, and rows off as far as was accepted.
    #[cold]
    pub(super) fn begin_proportion(&mut self) {
        let Self { dynamics, run, .. } = self;
        let begin = (run.clock.time(), &run.state);
        let (off, _) = furthest(dynamics.model, begin, R::ZERO);
        let energy = if run.start_accepted { energy_off(dynamics.model, begin) } else { R::ZERO };
        let proportion = &mut run.proportion;
        proportion.off = energy;
        proportion.fastest = run.state.v.max_abs();
        proportion.allowed = proportion.allowed.max(off.map_or(R::ZERO, |off| off.turn + off.turn));
    }

    /// An error where the step of this size from `begin`, which ended in `next`, is out of proportion.
    #[inline]
    pub(super) fn check_proportion(
        &mut self,
        (begin, h): (R, R),
        next: At<'_, R, M>,
        inputs: &M::Inputs,
        (condition, near): (R, Option<NearSingular<R>>),
    ) -> Result<(), SimulationError>
    where
        S: InputSource<R, M>,
    {
        let model = self.model();
        if model.row_count() == 0 {
            return Ok(());
        }
        let Proportion { fastest, unseen, .. } = self.run.proportion;
        let speed = next.1.v.max_abs();
        // Written so that a NaN is looked at.
        let close = near.is_some() || !R::any(condition.greater_equal(R::from_f64(CLOSE)));
        let taken =
            if close { self.check_energy((begin, h), next, inputs, (condition, near))? } else { R::ZERO };
        let look = speed > fastest + fastest || near.is_some() || unseen >= EVERY;
        if look {
            self.check_constraints(next, near)?;
        }
        let proportion = &mut self.run.proportion;
        proportion.fastest = speed.max(fastest);
        proportion.unseen = if look { 0 } else { unseen + 1 };
        proportion.off = (proportion.off - taken).max(R::ZERO);
        Ok(())
    }

    /// What came from nowhere, or went, J: to be taken off what the start had off the constraints.
    #[cold]
    #[inline(never)]
    fn check_energy(
        &mut self,
        (begin, h): (R, R),
        (end, next): At<'_, R, M>,
        inputs: &M::Inputs,
        (condition, near): (R, Option<NearSingular<R>>),
    ) -> Result<R, SimulationError>
    where
        S: InputSource<R, M>,
    {
        let (model, state) = (self.dynamics.model, &self.run.state);
        let before = model.kinetic_energy(begin, &state.q, &state.v);
        let after = model.kinetic_energy(end, &next.q, &next.v);
        let (stored, left) = (model.potential_energy(begin, state), model.potential_energy(end, next));
        let released = stored - left;
        let rounding = R::from_f64(64.0) * R::EPSILON * (stored.abs() + left.abs() + before);
        let allowed = R::from_f64(RESOLVED) * (before + released.abs()) + rounding + self.run.proportion.off;
        // Written so that a NaN fails.
        let unaccounted = (after - before - released).abs();
        if R::any(unaccounted.less_equal(allowed)) {
            return Ok(unaccounted);
        }
        let exchange = Exchange { begin, h, end, next, before, after, allowed };
        if self.is_exchanged(&exchange, inputs, inputs)
            // Inputs may have come in the step.
            || !S::HELD && {
                let last = self.dynamics.source.sample(end, next);
                self.is_exchanged(&exchange, inputs, &last)
            }
        {
            return Ok(R::ZERO);
        }
        let near = near.unwrap_or_else(|| name_singularity(model, begin, condition, &state.q));
        Err(SimulationError::Unresolved {
            time: begin.to_f64(),
            row: near.row,
            reciprocal_condition: near.reciprocal_condition.to_f64(),
            before: before.to_f64(),
            after: after.to_f64(),
        })
    }

    /// Whether loads without potential energy, drivers and Φ account for the kinetic energy, with the inputs at the step's ends.
    fn is_exchanged(&self, exchange: &Exchange<'_, R, M>, first: &M::Inputs, last: &M::Inputs) -> bool {
        let Exchange { begin, h, end, next, before, after, allowed } = *exchange;
        let Given { pushed, prescribed, taken_back } = self.given_in((begin, h), (end, next), first, last);
        let given = R::from_f64(MORE) * pushed + prescribed + taken_back;
        let own = before.max(R::ZERO).sqrt();
        let (least, most) = ((own - given).max(R::ZERO), own + given);
        // Written so that a NaN fails.
        if !R::any((after + allowed).greater_equal(least * least) & after.less_equal(most * most + allowed)) {
            return false;
        }
        // Forces of constraints that prescribe nothing do no work.
        if prescribed > R::ZERO {
            return true;
        }
        let (model, state) = (self.dynamics.model, &self.run.state);
        let power = |time, state: &StateOf<M, R>, inputs: &M::Inputs| {
            let mut forces = model.zero_v();
            applied(model, time, state, inputs, &mut forces);
            dot(forces.as_slice(), state.v.as_slice())
        };
        // ½ vᵀ Ṁ v, which Q has among the forces of inertia.
        let turned =
            |v: &M::V| model.kinetic_energy(end, &next.q, v) - model.kinetic_energy(begin, &state.q, v);
        let works =
            [h * power(begin, state, first) + turned(&state.v), h * power(end, next, last) + turned(&next.v)];
        let half = R::from_f64(0.5);
        let (mean, spread) = (half * (works[0] + works[1]), half * (works[1] - works[0]).abs());
        let spread = spread + (own + own + taken_back) * taken_back;
        R::any((after - before - mean).abs().less_equal(allowed + spread))
    }

    #[cold]
    #[inline(never)]
    fn check_constraints(
        &self,
        next: At<'_, R, M>,
        near: Option<NearSingular<R>>,
    ) -> Result<(), SimulationError> {
        let model = self.dynamics.model;
        let Proportion { fastest, allowed, .. } = self.run.proportion;
        let speed = if fastest > R::ZERO { fastest } else { next.1.v.max_abs() };
        let (position, velocity) = furthest(model, next, speed);
        let position = position.filter(|off| !R::any(off.turn.less_equal(allowed)));
        let Some((row, residual)) = position.map(|off| (off.row, off.residual)).or(velocity) else {
            return Ok(());
        };
        let near = near.or(self.run.near_singular);
        Err(SimulationError::LeftConstraints {
            time: next.0.to_f64(),
            row,
            residual: residual.to_f64(),
            singular: near.map(|near| (near.time.to_f64(), near.row)),
        })
    }

    /// What can be given in a step of `h`.
    fn given_in(
        &self,
        (begin, h): (R, R),
        (end, next): At<'_, R, M>,
        first: &M::Inputs,
        last: &M::Inputs,
    ) -> Given<R> {
        let (model, state) = (self.dynamics.model, &self.run.state);
        let q = &state.q;
        // Constraints as soft as the masses are heavy: what they take off the loads is at most what rigid ones do, and nothing is
        // divided by what vanishes at singular positions.
        let (compliance, mut store) = (R::ONE / largest_mass(model, begin, q), model.store());
        model.factor(begin, q, compliance, &mut store);
        let solved = |forces: &M::V, rows: &M::Lambda| {
            let mut x = model.zero_v();
            model.solve(&store, forces, rows, &mut x, &mut model.zero_lambda());
            x
        };
        let half = R::from_f64(0.5);
        let there = State { v: state.v.clone(), ..next.clone() };
        let pushed = [(begin, state, first), (end, &there, last)].map(|(time, state, inputs)| {
            let mut forces = model.zero_v();
            applied(model, time, state, inputs, &mut forces);
            let work = dot(forces.as_slice(), solved(&forces, &model.zero_lambda()).as_slice());
            h * (half * work.max(R::ZERO)).sqrt()
        });
        let (mut nu, mut phi) = (model.zero_lambda(), model.zero_lambda());
        model.nu(end, q, &mut nu);
        model.constraints(end, q, &mut phi);
        // Twice, because soft constraints are followed by half.
        let prescribed = [nu, phi.scaled(R::ONE / h)].map(|rows| {
            let velocity = solved(&model.zero_v(), &rows);
            model.kinetic_energy(begin, q, &velocity.scaled(R::from_f64(2.0))).max(R::ZERO).sqrt()
        });
        let [prescribed, taken_back] = prescribed;
        Given { pushed: pushed[0].max(pushed[1]), prescribed, taken_back }
    }
}

/// Velocities that a step can give, as the roots of their kinetic energies, √J.
struct Given<R> {
    /// By loads.
    pushed: R,
    /// By moving places and drivers.
    prescribed: R,
    /// By taking back Φ.
    taken_back: R,
}

/// A step whose kinetic energy potential energy does not account for.
struct Exchange<'s, R: Real, M: Assemble<R>> {
    begin: R,
    h: R,
    end: R,
    next: &'s StateOf<M, R>,
    /// The kinetic energy at its beginning and at its end, J.
    before: R,
    after: R,
    /// What of it need not be accounted for, J.
    allowed: R,
}

/// The kinetic energy of what velocities have off the constraints, J: ½ rᵀ (D M⁻¹ Dᵀ)⁻¹ r, r = D v − ν, at most all of it. Rows
/// as soft as a penalty makes them keep it finite at singular positions, and too small there rather than too large.
fn energy_off<R: Real, M: Assemble<R>>(model: &M, (time, State { q, v, .. }): At<'_, R, M>) -> R {
    let Penalty { alpha, .. } = Penalty::for_model(model, time, q, R::ONE);
    let mut store = model.store();
    model.factor(time, q, R::ONE / alpha, &mut store);
    let (mut rates, mut jacobian) = (model.zero_lambda(), model.zero_jacobian());
    model.nu(time, q, &mut rates);
    model.constraint_jacobian(time, q, &mut jacobian);
    subtract_product(model.jacobian_pattern(), jacobian.as_slice(), v.as_slice(), rates.as_mut_slice());
    let (mut x, mut lambda) = (model.zero_v(), model.zero_lambda());
    model.solve(&store, &model.zero_v(), &rates, &mut x, &mut lambda);
    let off = R::from_f64(-0.5) * dot(rates.as_slice(), lambda.as_slice());
    let whole = model.kinetic_energy(time, q, v).max(R::ZERO);
    off.max(R::ZERO).min(whole)
}

/// A row, and how far it is off.
struct Off<R> {
    row: Row,
    residual: R,
    /// The turn of one body that would make as much of it, rad.
    turn: R,
}

/// The row that is off furthest by position, and the first of velocities that `speed` (m/s and rad/s) does not account for.
fn furthest<R: Real, M: Assemble<R>>(
    model: &M,
    (time, State { q, v, .. }): At<'_, R, M>,
    speed: R,
) -> (Option<Off<R>>, Option<(Row, R)>) {
    let (mut phi, mut rates) = (model.zero_lambda(), model.zero_lambda());
    let (mut jacobian, mut levers) = (model.zero_jacobian(), model.zero_lambda());
    model.constraints(time, q, &mut phi);
    model.nu(time, q, &mut rates);
    let nu = rates.clone();
    model.constraint_jacobian(time, q, &mut jacobian);
    let mut sizes = model.zero_lambda();
    for (&entry, &(row, column)) in jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
        let (row, velocity) = (usize::from(row), v.as_slice().get(usize::from(column)));
        if let (Some(rate), Some(size), Some(&velocity)) =
            (rates.as_mut_slice().get_mut(row), sizes.as_mut_slice().get_mut(row), velocity)
        {
            *rate = *rate - entry * velocity;
            *size = *size + entry.abs();
        }
    }
    add_levers(model, time, q, &mut levers);
    let mut position: Option<Off<R>> = None;
    for ((&row, &residual), &lever) in model.rows().iter().zip(phi.as_slice()).zip(levers.as_slice()) {
        let turn = residual.abs() / lever;
        if lever > R::ZERO && position.as_ref().is_none_or(|off| !R::any(turn.less_equal(off.turn))) {
            position = Some(Off { row, residual, turn });
        }
    }
    let terms = rates.as_slice().iter().zip(nu.as_slice()).zip(sizes.as_slice());
    let velocity = model.rows().iter().zip(terms).find_map(|(&row, ((&rate, &nu), &size))| {
        let accounted = size * speed + nu.abs();
        (!R::any(rate.abs().less_equal(accounted))).then_some((row, rate))
    });
    (position, velocity)
}

/// The largest entry of each row of D in the column of a turn, at this position and a few that are turned from it: the lever arms
/// of the row, which do not vanish with it.
fn add_levers<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q, levers: &mut M::Lambda) {
    let turns = model.layout().linear;
    for part in 0..3 {
        let mut jacobian = model.zero_jacobian();
        model.constraint_jacobian(time, &turned(model, q, part), &mut jacobian);
        for (&entry, &(row, column)) in jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
            if usize::from(column) >= turns
                && let Some(lever) = levers.as_mut_slice().get_mut(usize::from(row))
            {
                *lever = lever.max(entry.abs());
            }
        }
    }
}
