//! Dry friction in joints: which of them stick, which slide and which way, and the forces with which they do.
//!
//! ```text
//! sticks    ẇ_i = J_i v̇ + J̇_i v = 0,   |y_i| ≤ b_i          w_i the rate of the joint, rad/s or m/s, y_i the force along it, N m or N
//! slides    y_i = −σ_i f_i,   σ_i w_i ≥ 0, σ_i = ±1          and from rest σ_i ẇ_i ≥ 0                                       (Coulomb)
//! as one    |y| ≤ b where ẇ = 0,   else y = −f w/|w|          and from rest −f ẇ/|ẇ|; w, y of a ball or a sleeve, along its directions
//! ```
//! v̇ and λ are what the formulation finds with the forces y; b and f may depend on them, by the reactions that press the surfaces, so that these
//! equations are solved by Newton's method, all of them together. Its slopes are differences: they say how fast it ends, and not where. Which
//! way each goes stays the same within a piece of a step. What sticks is watched until it is asked for more than b, what slides until it
//! has no speed (`held.rs` parts the step there); then all ways are tried in which what has no speed may stick or slide, and the first that
//! is consistent is taken: what sticks before what slides (Pfeiffer and Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996, 5.3).

use super::along_several::{alone, along_rates, begun, is_first, size, together};
use super::complementarity::{Few, ROWS, solved};
use super::rigid::{Held, LEAST, near, sharp, still, strikes};
use super::strike::{Blow, SLOW};
use super::ties::{Ties, share};
use super::{MechanismDynamics, Simulation};
use crate::clock::Clock;
use crate::error::SimulationError;
use crate::formulation::{Formulation, velocities_onto_constraints};
use crate::input::InputSource;
use crate::integrator::Method;
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::{State, StateOf, Variables};
use crate::trigger::{contacts, with_memories};
use crate::vector::{Vector, at, dot, put};

/// The most passes of Newton's method.
const PASSES: u32 = 24;

/// A last change of the forces as a part of them: what is left is less by the error of the slopes, a ten-thousandth.
const CHANGE: f64 = 1e-12;

/// A change after which slopes are found anew.
const RENEWED: f64 = 1e-3;

/// What is taken where rounding lets a change shrink no more.
const ROUNDED: f64 = 1e-9;

/// How far something may slide on that is taken to stand, as a part of what counts as no gap.
const FURTHER: f64 = 1e-3;

/// Into how many pieces a step is parted at most so that methods follow what slides along several directions.
pub(super) const TURNING: u32 = 512;

/// A part of its speed at which what slides along several directions looks again where it goes.
pub(super) const SLOWER: f64 = 0.5;

/// The most passes in which ways of what begins to slide along several directions are turned, and a last change of them.
const TURNS: u32 = 60;
const TURNED: f64 = 1e-11;

/// What of the derivative of a rate is rounding, as a part of the largest; and what methods leave of it where others hold a joint.
const NOTHING: f64 = 1e-11;
const NEARLY_NOTHING: f64 = 1e-6;

/// Forces of all that rubs in joints, and what follows from them.
struct Moved<R: Real, M: Mechanism<R>> {
    forces: M::Gates,
    a: M::V,
    lambda: M::Lambda,
    /// ẇ of each.
    bends: M::Gates,
    /// b and f of each.
    holding: M::Gates,
    sliding: M::Gates,
}

/// Which stick and which slide where, and what follows from it.
type Way<R, M> = (Held<<M as Variables<R>>::Gates>, Moved<R, M>);

/// How what is left of the equations changes with each force, and the accelerations do.
struct Slopes<R, V> {
    matrix: [Few<R>; ROWS],
    ways: [V; ROWS],
    ties: Ties<R>,
}

/// All joints that stick, as bits.
fn sticking<R: Real, G: Vector<R>>(held: &Held<G>, count: usize) -> usize {
    (0..count).filter(|i| sticks::<R, _>(held, *i)).fold(0, |set, i| set | 1 << i)
}

/// Where forces are sought.
struct Place<'s, R: Real, M: Mechanism<R>> {
    time: R,
    state: &'s StateOf<M, R>,
    inputs: &'s M::Inputs,
}

fn count<R: Real, M: Mechanism<R>>(model: &M) -> usize {
    contacts(model).min(ROWS)
}

pub(super) fn sticks<R: Real, G: Vector<R>>(held: &Held<G>, i: usize) -> bool {
    R::any(at(held.stuck.as_slice(), i).greater(R::ZERO))
}

/// Whether it is said of each whether it sticks or slides.
fn is_known<R: Real, M: Mechanism<R>>(model: &M, held: &Held<M::Gates>) -> bool {
    (0..count(model)).all(|i| sticks::<R, _>(held, i) || goes(model, held, i))
}

/// Whether a joint slides, as far as is known.
fn goes<R: Real, M: Mechanism<R>>(model: &M, held: &Held<M::Gates>, i: usize) -> bool {
    together(model, i).any(|j| !R::any(at(held.ways.as_slice(), j).equal(R::ZERO)))
}

/// What is left of the equation of each: ẇ of what sticks, or how it shares that with others; y + σ f of what slides.
fn left<R: Real, M: Mechanism<R>>(
    held: &Held<M::Gates>,
    ties: Option<&Ties<R>>,
    moved: &Moved<R, M>,
) -> Few<R> {
    core::array::from_fn(|i| {
        if let Some(Some(tie)) = ties.and_then(|ties| ties.rows.get(i)) {
            dot(tie, moved.forces.as_slice())
        } else if sticks::<R, _>(held, i) {
            at(moved.bends.as_slice(), i)
        } else {
            let way = at(held.ways.as_slice(), i);
            way.mul_add(at(moved.sliding.as_slice(), i), at(moved.forces.as_slice(), i))
        }
    })
}

/// The largest in size; no number where one of them is none.
fn largest<R: Real>(of: &[R]) -> R {
    let (largest, none) =
        of.iter().fold((R::ZERO, R::ZERO), |(largest, none), x| (largest.max(x.abs()), none + R::ZERO * *x));
    largest + none
}

impl<'m, M: Mechanism<R>, R: Real, F: Formulation<R, M>, S> MechanismDynamics<'m, M, R, F, S> {
    /// The forces of what rubs in joints, and the accelerations with them; no numbers where there are none.
    pub(super) fn rubbed(
        &self,
        time: R,
        state: &StateOf<M, R>,
        inputs: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> M::Gates {
        let place = Place { time, state, inputs };
        let found = if is_known(self.model, &self.held) {
            self.balanced(&place, &self.held)
        } else {
            self.sought(&place, 0).map(|(_, moved)| moved)
        };
        match found {
            Some(moved) => {
                (*a, *lambda) = (moved.a, moved.lambda);
                with_memories(self.model, moved.forces, &state.gates)
            }
            None => {
                let none = R::from_f64(f64::NAN);
                *a = a.scaled(none);
                // Where bounds are no numbers nothing is locked.
                if self.unbounded(&place).is_some() { state.gates.clone() } else { state.gates.scaled(none) }
            }
        }
    }

    fn zeros(&self) -> M::Gates {
        M::Gates::zeros(self.model.gate_names().len())
    }

    /// The first whose bounds are no numbers.
    #[cold]
    fn unbounded(&self, place: &Place<'_, R, M>) -> Option<usize> {
        let moved = self.moved(place, self.zeros());
        moved.holding.first_not_finite().or(moved.sliding.first_not_finite())
    }

    fn moved(&self, place: &Place<'_, R, M>, forces: M::Gates) -> Moved<R, M> {
        let model = self.model;
        let Place { time, inputs, .. } = *place;
        let gates = with_memories(model, forces.clone(), &place.state.gates);
        let state = State { gates, ..place.state.clone() };
        let (a, lambda, _) = self.free(time, &state, inputs);
        let along = |v: &M::V| strikes(model, time, &state.q, v);
        let (drifts, biases) = (along(&model.zero_v()).rates, along(&state.v).biases);
        let bends = along(&a).rates.plus(-R::ONE, &drifts).plus(R::ONE, &biases);
        let (mut holding, mut sliding) = (self.zeros(), self.zeros());
        model.bounds(time, &state, inputs, &a, &lambda, &mut holding, &mut sliding);
        Moved { forces, a, lambda, bends, holding, sliding }
    }

    /// The forces with which what sticks does, and what slides is braked; nothing where there are none.
    fn balanced(&self, place: &Place<'_, R, M>, held: &Held<M::Gates>) -> Option<Moved<R, M>> {
        let count = count(self.model);
        let held = &self.directed(place, held);
        let mut begin = with_memories(self.model, place.state.gates.clone(), &self.zeros());
        // What several hold alike is shared by how they hold, and not by what they held before.
        let stuck = sticking::<R, _>(held, count);
        for i in (0..count).filter(|i| stuck >> i & 1 == 1) {
            put(begin.as_mut_slice(), i, R::ZERO);
        }
        let mut moved = self.moved(place, begin);
        let most = |forces: &M::Gates| forces.max_abs().max(R::from_f64(LEAST));
        let open = left(held, None, &moved);
        let nothing = R::from_f64(64.0) * R::EPSILON * most(&moved.forces);
        if stuck == 0 && R::any(largest(&open).less_equal(nothing)) {
            return Some(moved);
        }
        let enough = R::from_f64(CHANGE).max(R::from_f64(64.0) * R::EPSILON);
        let (mut slopes, mut before) = (self.slopes(place, held, &moved), R::ZERO);
        for pass in 0..PASSES {
            let open = left(held, Some(&slopes.ties), &moved);
            let change = solved(&slopes.matrix, &open, 0, count, (1 << count) - 1)?;
            let mut forces = moved.forces.clone();
            for (force, change) in forces.as_mut_slice().iter_mut().zip(change) {
                *force = *force + change;
            }
            let (changed, whole) = (largest(&change), most(&forces));
            moved = self.moved(place, forces);
            // Written so that a NaN ends it.
            if !R::any(changed.greater(enough * whole)) {
                return Some(moved);
            }
            if pass > 1 && R::any((changed + changed).greater(before)) {
                let rounded = R::from_f64(ROUNDED).max(R::EPSILON.sqrt());
                return R::any(changed.less(rounded * whole)).then_some(moved);
            }
            if R::any(changed.greater(R::from_f64(RENEWED) * whole)) {
                slopes = self.slopes(place, held, &moved);
            }
            before = changed;
        }
        None
    }

    /// The same ways, of what slides along several directions as it does at this state: against w, and where w turns back beyond rest as before.
    fn directed(&self, place: &Place<'_, R, M>, held: &Held<M::Gates>) -> Held<M::Gates> {
        let (model, State { q, v, .. }) = (self.model, place.state);
        let mut held = held.clone();
        if !model.slide_as_one().is_empty() {
            let rates = strikes(model, place.time, q, v).rates;
            along_rates(model, &rates, R::from_f64(SLOW) * still(v.as_slice()), &mut held.ways);
        }
        held
    }

    fn slopes(&self, place: &Place<'_, R, M>, held: &Held<M::Gates>, moved: &Moved<R, M>) -> Slopes<R, M::V> {
        let model = self.model;
        let mut matrix = [[R::ZERO; ROWS]; ROWS];
        let base = left(held, None, moved);
        let part = R::EPSILON.sqrt().sqrt();
        let ways = core::array::from_fn(|column| {
            if column >= count(model) {
                return model.zero_v();
            }
            let own = at(moved.forces.as_slice(), column);
            let size = own.abs().max(at(moved.holding.as_slice(), column)).max(R::from_f64(LEAST));
            let mut forces = moved.forces.clone();
            put(forces.as_mut_slice(), column, own + part * size);
            let more = self.moved(place, forces);
            // As it is rounded.
            let by = R::ONE / (at(more.forces.as_slice(), column) - own);
            for ((row, after), before) in matrix.iter_mut().zip(left(held, None, &more)).zip(base) {
                put(row, column, (after - before) * by);
            }
            more.a.plus(-R::ONE, &moved.a).scaled(by)
        });
        let ties = Ties::of(&matrix, sticking::<R, _>(held, count(model)));
        for (row, tie) in matrix.iter_mut().zip(&ties.rows) {
            *row = tie.unwrap_or(*row);
        }
        Slopes { matrix, ways, ties }
    }

    /// G of all joints.
    fn yielding(&self, place: &Place<'_, R, M>, ways: &[M::V; ROWS]) -> [Few<R>; ROWS] {
        let model = self.model;
        let along = |v: &M::V| strikes(model, place.time, &place.state.q, v).rates;
        let (drifts, mut matrix) = (along(&model.zero_v()), [[R::ZERO; ROWS]; ROWS]);
        for (column, way) in ways.iter().enumerate().take(count(model)) {
            let moved = along(way).plus(-R::ONE, &drifts);
            for (row, moved) in matrix.iter_mut().zip(moved.as_slice()) {
                put(row, column, *moved);
            }
        }
        matrix
    }

    /// Which stick and which slide, and their forces: of what has a speed and does not rest that is known; all else may do either.
    fn sought(&self, place: &Place<'_, R, M>, resting: usize) -> Option<Way<R, M>> {
        let (model, State { q, v, .. }) = (self.model, place.state);
        let (count, zeros) = (count(model), || self.zeros());
        let rates = strikes(model, place.time, q, v).rates;
        let slow = R::from_f64(SLOW) * still(v.as_slice());
        let rests = |i: usize| resting >> i & 1 == 1;
        let stops = self.stops(place);
        let way_of = |i: usize| {
            let speed = size(model, &rates, i);
            let slides = !rests(i)
                && !sticks::<R, _>(&self.held, i)
                && R::any(speed.greater(slow.max(at(stops.as_slice(), i))));
            if slides { at(rates.as_slice(), i) / speed } else { R::ZERO }
        };
        let is_open = |i: usize| together(model, i).all(|j| R::any(way_of(j).equal(R::ZERO)));
        let choices = |i: usize| match is_first(model, i) && is_open(i) {
            true if alone(model, i) => 3,
            true => 2,
            false => 1,
        };
        let released = self.moved(place, zeros()).bends;
        let whole = released.max_abs();
        let nothing = R::from_f64(NOTHING).max(R::from_f64(1000.0) * R::EPSILON) * whole;
        let nearly = R::from_f64(NEARLY_NOTHING).max(R::EPSILON.sqrt()) * whole;
        let many: usize = (0..count).map(choices).product();
        // What would stick and cannot slides where it is pushed, rather than back.
        let mut pushed = zeros();
        (0..many).find_map(|mut which| {
            let (mut held, all, mut begins) = (Held::none(model), which == 0, 0_usize);
            for i in 0..count {
                put(held.ways.as_mut_slice(), i, way_of(i));
                put(held.speeds.as_mut_slice(), i, size(model, &rates, i));
            }
            for i in (0..count).filter(|i| choices(*i) > 1) {
                let digit = which % choices(i);
                which /= choices(i);
                let on = if R::any(at(pushed.as_slice(), i).greater(R::ZERO)) { -R::ONE } else { R::ONE };
                for j in together(model, i) {
                    let way = match digit {
                        0 => R::ZERO,
                        // Where it would go with no friction at all, to begin with.
                        1 if !alone(model, i) => at(released.as_slice(), j) / size(model, &released, i),
                        1 => on,
                        _ => -on,
                    };
                    put(held.ways.as_mut_slice(), j, way);
                    put(held.stuck.as_mut_slice(), j, if digit == 0 { R::ONE } else { R::ZERO });
                }
                if digit == 1 && !alone(model, i) {
                    begins |= 1 << i;
                }
            }
            let mut moved = self.balanced(place, &held)?;
            if begins != 0 {
                moved = self.turned(place, &mut held, moved, begins)?;
            }
            if all {
                pushed = moved.forces.clone();
            }
            let is_consistent = |i: usize| {
                if sticks::<R, _>(&held, i) {
                    let most = (R::ONE + sharp()) * at(moved.holding.as_slice(), i);
                    return R::any(size(model, &moved.forces, i).less_equal(most));
                }
                let product = |j| at(held.ways.as_slice(), j) * at(moved.bends.as_slice(), j);
                let along = together(model, i).fold(R::ZERO, |sum, j| sum + product(j));
                !is_open(i) || R::any(along.greater_equal(-if rests(i) { nearly } else { nothing }))
            };
            (0..count).filter(|i| is_first(model, *i)).all(is_consistent).then_some((held, moved))
        })
    }

    /// Says in what times the ways of what slides along several directions may change as much as the speeds do: |w|/(f tr G).
    fn pace(&self, place: &Place<'_, R, M>, held: &mut Held<M::Gates>, moved: &Moved<R, M>) {
        let (model, stops) = (self.model, self.stops(place));
        let slides = |i: &usize| is_first(model, *i) && !alone(model, *i) && !sticks::<R, _>(held, *i);
        let sliding = (0..count(model)).filter(slides).fold(0_usize, |set, i| set | 1 << i);
        if sliding == 0 {
            return;
        }
        let yielding = self.yielding(place, &self.slopes(place, held, moved).ways);
        for i in (0..count(model)).filter(|i| sliding >> i & 1 == 1) {
            let own = |j: usize| yielding.get(j).map_or(R::ZERO, |row| at(row, j));
            let trace = together(model, i).fold(R::ZERO, |sum, j| sum + own(j));
            let speed = at(held.speeds.as_slice(), i).max(at(stops.as_slice(), i));
            put(held.times.as_mut_slice(), i, speed / (at(moved.sliding.as_slice(), i) * trace));
        }
    }

    /// Of what slides along several directions the speed √(a d), m/s or rad/s, with which it gets no further than d (`FURTHER`, m or rad) before it
    /// stands, if friction stops it with a = |ẇ|:
    /// there is no way of its own in that, which methods could follow.
    fn stops(&self, place: &Place<'_, R, M>) -> M::Gates {
        let model = self.model;
        let mut speeds = M::Gates::zeros(model.gate_names().len());
        if model.slide_as_one().is_empty() {
            return speeds;
        }
        let held = with_memories(model, place.state.gates.clone(), &self.zeros());
        let bends = self.moved(place, held).bends;
        let further = R::from_f64(FURTHER) * near::<R>();
        for i in (0..count(model)).filter(|i| !alone(model, *i)) {
            put(speeds.as_mut_slice(), i, (further * size(model, &bends, i)).sqrt());
        }
        speeds
    }

    /// Turns the ways of what begins to slide along several directions until each is against its own force; nothing where one is held.
    fn turned(
        &self,
        place: &Place<'_, R, M>,
        held: &mut Held<M::Gates>,
        mut moved: Moved<R, M>,
        begins: usize,
    ) -> Option<Moved<R, M>> {
        let (model, slopes) = (self.model, self.slopes(place, held, &moved));
        let yielding = self.yielding(place, &slopes.ways);
        let enough = R::from_f64(TURNED).max(R::from_f64(64.0) * R::EPSILON);
        for _ in 0..TURNS {
            let mut most = R::ZERO;
            for i in (0..count(model)).filter(|i| begins >> i & 1 == 1) {
                let force = at(moved.sliding.as_slice(), i);
                if !R::any(force.greater(R::from_f64(LEAST))) {
                    continue;
                }
                let set = together(model, i).fold(0_usize, |set, j| set | 1 << j);
                let own: Few<R> = core::array::from_fn(|j| match set >> j & 1 {
                    1 => at(moved.forces.as_slice(), j),
                    _ => R::ZERO,
                });
                let open = core::array::from_fn(|j| {
                    at(moved.bends.as_slice(), j) - yielding.get(j).map_or(R::ZERO, |row| dot(row, &own))
                });
                let forces = begun(&yielding, &open, set, force)?;
                for j in together(model, i) {
                    let way = -at(&forces, j) / force;
                    most = most.max((way - at(held.ways.as_slice(), j)).abs());
                    put(held.ways.as_mut_slice(), j, way);
                }
                moved = self.balanced(place, held)?;
            }
            if R::any(most.less_equal(enough)) {
                return Some(moved);
            }
        }
        None
    }
}

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    I: Method<R>,
{
    /// The state, with velocities on the constraints. Methods that hold these by positions leave them off by what they err, and joints of a loop would
    /// not stop at one time by them; their own velocities stay, because taking that back in every step would cost multipliers an order.
    fn on_constraints(&self) -> StateOf<M, R> {
        let mut state = self.run.state.clone();
        if self.dynamics.watch.by_positions {
            velocities_onto_constraints(self.model(), self.time(), &mut state);
        }
        state
    }

    /// What sticks and what slides from here on.
    pub(super) fn stick(&mut self) -> Result<Blow<R>, SimulationError>
    where
        S: InputSource<R, M>,
    {
        let (model, time, mut state) = (self.model(), self.time(), self.on_constraints());
        let inputs = self.dynamics.present_inputs(time, &self.run.state);
        let count = count(model);
        // What others hold rests, whatever a method leaves of its rate.
        let tied = |i: &usize| R::any(at(self.dynamics.held.groups.as_slice(), *i).greater(R::ZERO));
        let mut resting = (0..count).filter(tied).fold(0_usize, |set, i| set | 1 << i);
        let nothing = [R::ZERO; ROWS];
        let (mut held, moved, back, ways) = loop {
            let place = Place { time, state: &state, inputs: &inputs };
            let Some((mut held, moved)) = self.dynamics.sought(&place, resting) else {
                let time = time.to_f64();
                return Err(match self.dynamics.unbounded(&place) {
                    Some(which) => SimulationError::NonFinite { time, what: self.contact(which) },
                    None => SimulationError::Locked { friction: self.contact(0), time },
                });
            };
            let stuck = sticking::<R, _>(&held, count);
            if stuck == 0 {
                break (held, moved, nothing, core::array::from_fn(|_| model.zero_v()));
            }
            let slopes = self.dynamics.slopes(&place, &held, &moved);
            let (yielding, firm) = (self.dynamics.yielding(&place, &slopes.ways), slopes.ties.firm);
            let mut found = 0_usize;
            for i in (0..count).filter(|i| stuck >> i & 1 == 0) {
                if share(&yielding, firm, i).is_some() {
                    put(held.groups.as_mut_slice(), i, R::ONE);
                    found |= 1 << i;
                }
            }
            if found & !resting != 0 {
                resting |= found;
                continue;
            }
            // What a method leaves of the rates of what sticks is taken back, along the way of an impulse.
            let rates = strikes(model, time, &state.q, &state.v).rates;
            let off = core::array::from_fn(|i| at(rates.as_slice(), i));
            let back = solved(&yielding, &off, 0, count, firm).unwrap_or(nothing);
            break (held, moved, back, slopes.ways);
        };
        let before = &self.dynamics.held;
        self.dynamics.pace(&Place { time, state: &state, inputs: &inputs }, &mut held, &moved);
        let differs = |i: usize| {
            sticks::<R, _>(before, i) != sticks::<R, _>(&held, i)
                || alone(model, i) && at(before.ways.as_slice(), i) != at(held.ways.as_slice(), i)
        };
        let mut blow = Blow::none();
        if is_known(model, before) {
            blow.changed = (0..count).filter(|i| is_first(model, *i) && differs(*i)).count() as u32;
        }
        if (0..count).any(differs) {
            // What a method carries from step to step is of the motion before.
            self.memory = self.integrator.memory();
        } else {
            state.v.clone_from(&self.run.state.v);
        }
        for (along, way) in back.iter().zip(&ways) {
            state.v.axpy(*along, way);
        }
        state.gates = with_memories(model, moved.forces, &state.gates);
        self.run.state = state;
        self.dynamics.held = held;
        Ok(blow)
    }

    /// Where a piece of a step is to stop for what slides along several directions: as it comes to rest and leaves it, what resists turns as fast as
    /// it does, and explicit methods cannot follow in longer ones.
    pub(super) fn until_turned(&self, h: R, end: Clock<R>, pieces: u32) -> (R, Clock<R>) {
        let times = self.dynamics.held.times.as_slice();
        let limits = times.iter().filter(|time| R::any(time.greater(R::ZERO)));
        let least = limits.fold(h, |least, time| time.min(least));
        if pieces < TURNING && R::any(least.less(h)) {
            (least, self.run.clock.after(least))
        } else {
            (h, end)
        }
    }

    /// Of each joint, and zero: where it sticks how much more it could hold, where it slides how fast it does; along
    /// several directions how much faster than half as fast as when it began, that way.
    pub(super) fn sticking_guards(&mut self) -> [M::Gates; 2]
    where
        S: InputSource<R, M>,
    {
        let inputs = self.dynamics.inputs_within(self.time(), &self.run.state);
        let (model, time, state) = (self.model(), self.time(), self.on_constraints());
        let zeros = || M::Gates::zeros(model.gate_names().len());
        let (mut guards, rates) = (zeros(), strikes(model, time, &state.q, &state.v).rates);
        let held = &self.dynamics.held;
        let all = 0..count(model);
        let moved = all.clone().any(|i| sticks::<R, _>(held, i)).then(|| {
            let place = Place { time, state: &state, inputs: &inputs };
            self.dynamics.balanced(&place, held)
        });
        for i in all {
            let tied = |j: usize| R::any(at(held.groups.as_slice(), j).greater(R::ZERO));
            let along = |j: usize| at(held.ways.as_slice(), j) * at(rates.as_slice(), j);
            let guard = match &moved {
                _ if !is_first(model, i) => R::ONE,
                Some(Some(moved)) if sticks::<R, _>(held, i) => {
                    let most = (R::ONE + sharp()) * at(moved.holding.as_slice(), i);
                    most - size(model, &moved.forces, i)
                }
                // It ends where nothing balances it any more.
                Some(None) if sticks::<R, _>(held, i) => -R::ONE,
                // What others hold does so as long as they do.
                _ if together(model, i).all(tied) => R::ONE,
                _ if alone(model, i) => along(i),
                _ => {
                    let slower = R::from_f64(SLOWER) * at(held.speeds.as_slice(), i);
                    together(model, i).fold(-slower, |sum, j| sum + along(j))
                }
            };
            put(guards.as_mut_slice(), i, guard);
        }
        [guards, zeros()]
    }
}
