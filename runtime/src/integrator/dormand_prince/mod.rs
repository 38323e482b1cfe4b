//! Dormand and Prince's method of order 5(4), on the group of positions, with steps of its own choice.

mod control;
mod dense;
mod tableau;

use self::control::{AFTER_BREAKDOWN, LEAST_ERROR, MOST_STEPS, MOST_TRIALS, Scale};
use self::dense::{Segment, Slopes};
use self::tableau::{A, C, ESTIMATE};
use super::{Dynamics, Integrator, Interpolate, Method, Rejections, StepFailure, Stepped};
use crate::error::SettingError;
use crate::formulation::positive;
use crate::layout::{Layout, inverse_differential, retract_counting};
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// The method of order 5 with an embedded one of order 4 (Dormand, Prince, J. Comput. Appl. Math. 6 (1980) 19–26; Hairer,
/// Nørsett, Wanner, *Solving Ordinary Differential Equations I*, II.4–6), six evaluations a step.
///
/// ```text
/// u_i = h Σ a_ij k_j,   q_i = q₀ ⊕ u_i,   v_i = v₀ + h Σ a_ij v̇_j,   k_i = dexp⁻¹(u_i) v_i,   i = 1 … 7
/// ```
/// as in [`Rk4`](crate::Rk4) every stage starts from the step's own beginning (Munthe-Kaas 1999; Hairer, Lubich, Wanner,
/// *Geometric Numerical Integration*, IV.8). The seventh stage is the end of the step and the first of the next one; it is
/// evaluated again only where the state was changed in between, as by a projection, or where inputs are held, because they
/// then change with the step: seven evaluations then. The terms of dexp⁻¹ that [`inverse_differential`] leaves out are
/// (1/720) |u|³ |u × ω|, of which u × ω is O(h²): O(h⁶) in a step, as the method's own error.
///
/// # Choice of the step
/// The difference of the two methods is an error of increments of positions, δu = h Σ (b_i − b̂_i) k_i (m, rad), and of
/// velocities, δv = h Σ (b_i − b̂_i) v̇_i (m/s, rad/s). A step is taken if
///
/// ```text
/// err = √( 1/2n_v Σ (δu_i/sc_i)² + (δv_i/sc_i)² ) ≤ 1,   sc = absolute + relative · size
/// ```
/// where the size of a linear coordinate and of a velocity is the larger of its magnitudes at the ends, and that of an
/// orientation is 1: it has no origin to be counted from. Counted angles follow the orientations and are not counted again.
/// The next size is h · 0.9 err⁻⁰·¹⁷ err₋₁⁰·⁰⁴ (Gustafsson's PI controller), by a factor between 1/5 and 10, never more than
/// [`Simulation::step`](crate::Simulation::step) says; the first is found from the accelerations at the start and after a
/// small step of Euler's method (II.4). A step that was shortened to end where a run ends is not taken as a measure of those
/// that follow.
///
/// A trial with a stage at a singular position, or not finite, is repeated with a quarter of the size.
///
/// # Bounds
/// The least step is four roundings of the time t,
///
/// ```text
/// h_least = 4 ε max(|t|, 1 µs), at most 1 µs, at least 2⁻²⁰ ε |t|
/// ```
/// (ε = 2.2·10⁻¹⁶, in single precision 1.2·10⁻⁷) unless [`least_step`](DormandPrince::least_step) says otherwise; it does not depend on
/// the largest. A step is tried at most 100 times, which takes at most 602 evaluations: 6 a trial, one at the start, one for the
/// size of the first step. A run (`advance_until` and its like) takes at most 10⁶ steps, unless
/// [`most_steps`](DormandPrince::most_steps) says otherwise; it can be gone on with from there.
///
/// # Between the steps
/// [`Interpolate`]: the continuous extension of order 4, of u and v (II.6), at no further evaluation.
///
/// # Errors
/// [`StepFailure::Underflow`] where the size falls below the least one, or after 100 trials, [`StepFailure::Breakdown`] where the
/// start itself breaks down or is not finite; [`SimulationError::TooManySteps`](crate::SimulationError::TooManySteps) of a run. A
/// [`SettingError`] is a tolerance that is not positive and finite, two that are both below ε², where only rounding would
/// be measured, a least step that is not positive and finite, and a bound of no steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DormandPrince<R = f64> {
    /// The error of a step that is allowed whatever the size of a coordinate: m, rad, m/s and rad/s.
    pub absolute: R,
    /// The error of a step that is allowed relative to the size of a coordinate.
    pub relative: R,
    /// Whether the method chooses its steps; otherwise every step is as long as asked for, and the tolerances mean nothing.
    pub adaptive: bool,
    /// The least step of its own choice, s; none for four roundings of the time.
    pub least: Option<R>,
    /// The most steps of its own choice in a run.
    pub steps: u64,
}

impl<R: Real> DormandPrince<R> {
    /// Steps of its own choice with these tolerances.
    pub fn tolerances(absolute: R, relative: R) -> Self {
        DormandPrince { absolute, relative, adaptive: true, least: None, steps: MOST_STEPS }
    }

    /// Steps of its own choice with one number as absolute and relative tolerance.
    pub fn tolerance(both: R) -> Self {
        Self::tolerances(both, both)
    }

    /// Steps as long as asked for, without control of the error.
    pub fn fixed() -> Self {
        DormandPrince { adaptive: false, ..Self::tolerances(R::ONE, R::ONE) }
    }

    /// With this least step, s, in place of four roundings of the time.
    pub fn least_step(self, seconds: R) -> Self {
        DormandPrince { least: Some(seconds), ..self }
    }

    /// With at most so many steps in a run, in place of 10⁶.
    pub fn most_steps(self, steps: u64) -> Self {
        DormandPrince { steps, ..self }
    }

    /// The size of the first step, s: Hairer, Nørsett, Wanner, II.4.
    #[cold]
    fn first_size<D: Dynamics<R>>(
        &self,
        dynamics: &mut D,
        time: R,
        state: &State<D::Q, D::V>,
        first: &First<D::V>,
        largest: R,
    ) -> R {
        let scale = Scale::new((self.absolute, self.relative), &D::LAYOUT, state, state);
        let d0 = scale.norm(&control::sizes(&D::LAYOUT, &state.q), &state.v);
        let d1 = scale.norm(&first.v, &first.a);
        let h0 = control::euler_size(d0, d1).min(largest);
        let u = first.v.scaled(h0);
        let mut q = D::Q::zero();
        retract_counting(&D::LAYOUT, &state.q, &u, &u, &mut q);
        let mut euler = State { q, v: state.v.plus(h0, &first.a) };
        dynamics.begin_trial(h0);
        let a = dynamics.acceleration(time + h0, &mut euler);
        let k = inverse_differential(&D::LAYOUT, &u, &euler.v);
        let d2 = scale.norm(&k.plus(-R::ONE, &first.v), &a.plus(-R::ONE, &first.a)) / h0;
        if dynamics.broke_down() || !d2.is_finite() { h0 } else { control::first_size(h0, d1, d2) }
    }
}

/// The values that [`DormandPrince`] carries from step to step: the size it proposes, the accelerations at the end, and
/// the continuous extension of the last step.
#[derive(Clone, Copy, Debug)]
pub struct DormandPrinceMemory<R, Q, V> {
    /// The size proposed for the next step, s.
    size: Option<R>,
    /// The error of the last step that was not shortened from outside.
    error: R,
    end: Option<End<R, Q, V>>,
    segment: Option<Segment<R, Q, V>>,
}

/// Where the last step ended, and the slopes there.
#[derive(Clone, Copy, Debug)]
struct End<R, Q, V> {
    /// When it began and ended, s, rounded.
    times: [R; 2],
    state: State<Q, V>,
    first: First<V>,
}

/// The slopes of the first stage: velocities, and accelerations.
#[derive(Clone, Copy, Debug)]
struct First<V> {
    v: V,
    a: V,
}

impl<R: Real, Q: Vector<R>, V: Vector<R>> DormandPrinceMemory<R, Q, V> {
    /// The slopes at this time and state, if the last step ended there and nothing was changed since.
    fn known(&self, time: R, state: &State<Q, V>) -> Option<First<V>> {
        let end = self.end.as_ref()?;
        // Near zero the time has the rounding that it began with.
        let [from, to] = end.times;
        let rounding = R::from_f64(8.0) * R::EPSILON * (from.abs() + to.abs());
        ((time - to).abs() <= rounding && end.state == *state).then_some(end.first)
    }

    /// Remembers a step that was taken.
    fn keep(&mut self, time: R, h: R, begin: &State<Q, V>, trial: &Trial<Q, V>) {
        let Trial { end, last, increments, rates, velocities, accelerations } = trial;
        let velocities = velocities.as_ref().unwrap_or(rates);
        let slopes = [rates, velocities, accelerations];
        self.segment = Some(Segment::new(h, begin, *increments, slopes));
        self.end = Some(End { times: [time, time + h], state: *end, first: *last });
    }
}

impl<R: Real> Method<R> for DormandPrince<R> {
    type Memory<Q: Vector<R>, V: Vector<R>, Lambda: Vector<R>> = DormandPrinceMemory<R, Q, V>;

    fn memory<Q: Vector<R>, V: Vector<R>, Lambda: Vector<R>>(&self) -> DormandPrinceMemory<R, Q, V> {
        DormandPrinceMemory { size: None, error: R::from_f64(LEAST_ERROR), end: None, segment: None }
    }

    fn check(&self) -> Result<(), SettingError> {
        let must_be = "positive and finite, such as 1e-8";
        positive("Dormand and Prince's absolute tolerance", self.absolute, must_be)?;
        positive("Dormand and Prince's relative tolerance", self.relative, must_be)?;
        let larger = self.absolute.max(self.relative);
        if larger < R::EPSILON * R::EPSILON {
            let (what, value) = ("the larger of Dormand and Prince's tolerances", larger.to_f64());
            let must_be = "at least a rounding of a rounding, ε² = 4.9e-32 or in single precision 1.4e-14, such as 1e-8";
            return Err(SettingError { what, value, must_be });
        }
        if let Some(least) = self.least {
            positive("Dormand and Prince's least step", least, "positive and finite (s), such as 1e-9")?;
        }
        if self.steps == 0 {
            let (what, must_be) = ("the most steps of Dormand and Prince's method", "at least 1");
            return Err(SettingError { what, value: 0.0, must_be });
        }
        Ok(())
    }

    fn most_steps(&self) -> u64 {
        if self.adaptive { self.steps } else { u64::MAX }
    }
}

impl<R: Real> Interpolate<R> for DormandPrince<R> {
    fn size<Q: Vector<R>, V: Vector<R>, Lambda: Vector<R>>(
        memory: &DormandPrinceMemory<R, Q, V>,
    ) -> Option<R> {
        memory.segment.as_ref().map(Segment::size)
    }

    fn at<Q: Vector<R>, V: Vector<R>, Lambda: Vector<R>>(
        memory: &DormandPrinceMemory<R, Q, V>,
        layout: &Layout,
        elapsed: R,
    ) -> Option<State<Q, V>> {
        memory.segment.as_ref().map(|segment| segment.at(layout, elapsed))
    }
}

impl<R: Real, D: Dynamics<R>> Integrator<R, D> for DormandPrince<R> {
    fn step(
        &self,
        memory: &mut DormandPrinceMemory<R, D::Q, D::V>,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &State<D::Q, D::V>,
    ) -> Result<Stepped<R, D::Q, D::V>, StepFailure<R>> {
        let known = memory.known(time, state);
        let first = match known {
            Some(first) if dynamics.resume() => first,
            _ => {
                let mut begin = *state;
                let a = dynamics.acceleration(time, &mut begin);
                First { v: begin.v, a }
            }
        };
        let finite = first.v.first_not_finite().or(first.a.first_not_finite()).is_none();
        if dynamics.broke_down() || !finite {
            return Err(StepFailure::Breakdown);
        }
        if !self.adaptive {
            let trial = Trial::new(dynamics, time, h, state, &first).ok_or(StepFailure::Breakdown)?;
            memory.keep(time, h, state, &trial);
            return Ok(Stepped::explicit(h, trial.end));
        }

        let proposed = match memory.size {
            Some(size) => size,
            None => self.first_size(dynamics, time, state, &first, h),
        };
        // A hundredth longer rather than leave a sliver.
        let shortened = proposed * R::from_f64(1.01) >= h;
        let least = self.least.unwrap_or_else(|| control::least_size(time));
        // Slopes so large that their norm overflows propose nothing.
        let mut size = if shortened { h } else { proposed.max(least).min(h) };
        let mut rejections = Rejections::default();
        for _ in 0..MOST_TRIALS {
            dynamics.begin_trial(size);
            let trial = Trial::new(dynamics, time, size, state, &first);
            let error = trial.as_ref().map(|trial| trial.error(self, &D::LAYOUT, size, state));
            match (trial, error) {
                (Some(trial), Some(error)) if error <= R::ONE => {
                    memory.keep(time, size, state, &trial);
                    let rejected = rejections.total() > 0;
                    let next = size * control::after_acceptance(error, memory.error, rejected);
                    if shortened && !rejected {
                        memory.size = Some(next.max(proposed));
                    } else {
                        memory.size = Some(next);
                        memory.error = error.max(R::from_f64(LEAST_ERROR));
                    }
                    return Ok(Stepped { rejections, ..Stepped::explicit(size, trial.end) });
                }
                (_, Some(error)) if error.is_finite() => {
                    rejections.error += 1;
                    size = size * control::after_rejection(error);
                }
                _ => {
                    rejections.breakdown += 1;
                    size = size * R::from_f64(AFTER_BREAKDOWN);
                }
            }
            // Written so that a NaN ends it.
            if !R::any(size.greater_equal(least)) {
                break;
            }
        }
        Err(StepFailure::Underflow { size, rejections })
    }
}

/// The stages of a step that was tried.
struct Trial<Q, V> {
    /// The state at its end.
    end: State<Q, V>,
    /// The slopes there.
    last: First<V>,
    /// u, ∫v dt and v₁ − v₀ over the step.
    increments: [V; 3],
    /// k_i.
    rates: Slopes<V>,
    /// v_i, where they differ from k_i in a part that is needed.
    velocities: Option<Slopes<V>>,
    /// v̇_i.
    accelerations: Slopes<V>,
}

impl<Q, V> Trial<Q, V> {
    /// The stages 2 to 7; none if one of them broke down.
    #[inline]
    fn new<R: Real, D: Dynamics<R, Q = Q, V = V>>(
        dynamics: &mut D,
        time: R,
        h: R,
        begin: &State<Q, V>,
        first: &First<V>,
    ) -> Option<Self>
    where
        Q: Vector<R>,
        V: Vector<R>,
    {
        let counting = D::LAYOUT.quaternions > 0 && !D::LAYOUT.angles.is_empty();
        let (mut k, mut v, mut a) = ([V::zero(); 6], [V::zero(); 6], [V::zero(); 6]);
        let mut end = *begin;
        let mut last = *first;
        let mut increments = [V::zero(); 3];
        for (i, (row, &c)) in A.iter().zip(&C).enumerate() {
            let (c, row) = (R::from_f64(c), &row[1..]);
            let u = increment(h, c, &first.v, &k[..i], row);
            let integral = if counting { increment(h, c, &first.v, &v[..i], row) } else { u };
            let dv = increment(h, c, &first.a, &a[..i], row);
            increments = [u, integral, dv];
            let mut q = Q::zero();
            retract_counting(&D::LAYOUT, &begin.q, &u, &integral, &mut q);
            end = State { q, v: begin.v.plus(R::ONE, &dv) };
            let mut stage = end;
            let acceleration = dynamics.acceleration(time + c * h, &mut stage);
            if dynamics.broke_down() {
                return None;
            }
            last = First { v: stage.v, a: acceleration };
            k[i] = inverse_differential(&D::LAYOUT, &u, &stage.v).plus(-R::ONE, &first.v);
            v[i] = stage.v.plus(-R::ONE, &first.v);
            a[i] = acceleration.plus(-R::ONE, &first.a);
        }
        let velocities = counting.then_some(Slopes { first: first.v, others: v });
        let rates = Slopes { first: first.v, others: k };
        let accelerations = Slopes { first: first.a, others: a };
        Some(Trial { end, last, increments, rates, velocities, accelerations })
    }

    /// The estimated error, relative to the tolerances.
    fn error<R: Real>(&self, method: &DormandPrince<R>, layout: &Layout, h: R, begin: &State<Q, V>) -> R
    where
        Q: Vector<R>,
        V: Vector<R>,
    {
        let estimate =
            |slopes: &Slopes<V>| increment(h, R::ZERO, &slopes.first, &slopes.others, &ESTIMATE[1..]);
        let scale = Scale::new((method.absolute, method.relative), layout, begin, &self.end);
        scale.norm(&estimate(&self.rates), &estimate(&self.accelerations))
    }
}

/// h (c k₁ + Σ a_j (k_j − k₁)): written about k₁, so that equal slopes give a uniform motion to the bit.
#[inline]
fn increment<R: Real, V: Vector<R>>(h: R, c: R, first: &V, others: &[V], row: &[f64]) -> V {
    let mut sum = first.scaled(c);
    for (other, &a) in others.iter().zip(row) {
        if a != 0.0 {
            sum.axpy(R::from_f64(a), other);
        }
    }
    sum.scaled(h)
}
