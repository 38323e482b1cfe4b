//! Dormand and Prince's method of order 5(4), on the group of positions, with steps of its own choice.

mod control;
mod dense;
mod tableau;

use self::control::{AFTER_BREAKDOWN, LARGEST_STEP, LEAST_ERROR, MOST_STEPS, MOST_TRIALS, Scale};
use self::dense::Segment;
pub(super) use self::tableau::DORMAND_PRINCE;
use self::tableau::{ESTIMATE, EULER};
use super::runge_kutta::{Increment, Slopes};
use super::{Dynamics, Integrator, Interpolate, Method, Rejections, StepFailure, Stepped, SteppedOf};
use crate::error::SettingError;
use crate::formulation::positive;
use crate::layout::Layout;
use crate::real::Real;
use crate::state::{Derivative, DerivativeOf, StateOf, Variables};
use crate::vector::Vector;

/// The method of order 5 with an embedded one of order 4 (Dormand, Prince, J. Comput. Appl. Math. 6 (1980) 19–26; Hairer,
/// Nørsett, Wanner, *Solving Ordinary Differential Equations I*, II.4–6), six evaluations a step.
///
/// ```text
/// u_i = h Σ a_ij k_j,   q_i = q₀ ⊕ u_i,   v_i = v₀ + h Σ a_ij v̇_j,   k_i = dexp⁻¹(u_i) v_i,   i = 1 … 7
/// ```
/// as in [`Rk4`](crate::Rk4) every stage starts from the step's own beginning (Munthe-Kaas 1999; Hairer, Lubich, Wanner,
/// *Geometric Numerical Integration*, IV.8), and internal states take Σ a_ij ż_j. The seventh stage is the end of the step and the first of the next one; it is
/// evaluated again only where the state was changed in between, as by a projection, or where inputs are held, because they
/// then change with the step: seven evaluations then. The terms of dexp⁻¹ that [`inverse_differential`](crate::inverse_differential) leaves out are
/// (1/720) |u|³ |u × ω|, of which u × ω is O(h²): O(h⁶) in a step, as the method's own error.
///
/// # Choice of the step
/// The difference of the two methods is an error of increments of positions, δu = h Σ (b_i − b̂_i) k_i (m, rad), of
/// velocities, δv = h Σ (b_i − b̂_i) v̇_i (m/s, rad/s), and of internal states, δz. A step is taken if
///
/// ```text
/// err = √( 1/(2n_v + n_z) Σ (δu_i/sc_i)² + (δv_i/sc_i)² + (δz_i/sc_i)² ) ≤ 1,   sc = absolute + relative · size
/// ```
/// where the size of a linear coordinate, of a velocity and of an internal state is the larger of its magnitudes at the ends, and
/// that of an orientation is 1: it has no origin to be counted from. Counted angles follow the orientations and are not counted again.
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
/// The step size of a simulation is the largest step; where it is not given a step may be as long as the run.
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
    fn first_size<X: Variables<R>, D: Dynamics<R, Variables = X>>(
        &self,
        dynamics: &mut D,
        time: R,
        state: &StateOf<X, R>,
        first: &DerivativeOf<X, R>,
        largest: R,
    ) -> R {
        let (layout, scales) = (dynamics.variables().layout(), dynamics.variables().internal_scales());
        let scale = Scale::new((self.absolute, self.relative), layout, scales, state, state);
        let d0 = scale.norm(&control::sizes(layout, &state.q), &state.v, &state.z);
        let d1 = scale.norm(&first.v, &first.a, &first.z);
        let h0 = control::euler_size(d0, d1).min(largest);
        dynamics.begin_trial(h0);
        let mut slopes = Slopes::new(first.clone());
        let Some(_) = slopes.stage(&EULER, 1, dynamics, (time, h0), state) else { return h0 };
        let Increment { u, v, z, .. } =
            slopes.increment(dynamics.variables().layout(), R::ONE, 0.0, &[0.0, 1.0]);
        let d2 = scale.norm(&u, &v, &z) / h0;
        if !d2.is_finite() { h0 } else { control::first_size(h0, d1, d2) }
    }
}

/// The values that [`DormandPrince`] carries from step to step: the size it proposes, the derivative at the end, and
/// the continuous extension of the last step.
#[derive(Clone, Copy, Debug)]
pub struct DormandPrinceMemory<R, S, V, Z> {
    /// The size proposed for the next step, s.
    size: Option<R>,
    /// The error of the last step that was not shortened from outside.
    error: R,
    end: Option<End<R, S, V, Z>>,
    segment: Option<Segment<R, S, V, Z>>,
}

/// Where the last step ended, and the derivative there.
#[derive(Clone, Copy, Debug)]
struct End<R, S, V, Z> {
    /// When it began and ended, s, rounded.
    times: [R; 2],
    state: S,
    derivative: Derivative<V, Z>,
}

/// [`DormandPrinceMemory`] of what has the variables `X`.
type MemoryOf<X, R> = DormandPrinceMemory<R, StateOf<X, R>, <X as Variables<R>>::V, <X as Variables<R>>::Z>;

impl<R: Real, S: PartialEq + Clone, V: Vector<R>, Z: Vector<R>> DormandPrinceMemory<R, S, V, Z> {
    /// The derivative at this time and state, if the last step ended there and nothing was changed since.
    fn known(&self, time: R, state: &S) -> Option<Derivative<V, Z>> {
        let end = self.end.as_ref()?;
        // Near zero the time has the rounding that it began with.
        let [from, to] = end.times;
        let rounding = R::from_f64(8.0) * R::EPSILON * (from.abs() + to.abs());
        ((time - to).abs() <= rounding && end.state == *state).then(|| end.derivative.clone())
    }
}

/// A step that was tried.
struct Trial<X: Variables<R>, R: Real> {
    slopes: Slopes<X::V, X::Z, 7>,
    /// The increment to its end, the seventh stage.
    increment: Increment<X::V, X::Z>,
    /// The state there, before the equations corrected it.
    end: StateOf<X, R>,
}

impl<X: Variables<R>, R: Real> Trial<X, R> {
    /// The step of size `h` from `begin`, whose derivative is `first`; none if a stage broke down.
    #[inline]
    fn new<D: Dynamics<R, Variables = X>>(
        dynamics: &mut D,
        time: R,
        h: R,
        begin: &StateOf<X, R>,
        first: &DerivativeOf<X, R>,
    ) -> Option<Self> {
        let (method, over) = (&DORMAND_PRINCE, (time, h));
        let mut slopes = Slopes::new(first.clone());
        slopes.stage(method, 1, dynamics, over, begin)?;
        slopes.stage(method, 2, dynamics, over, begin)?;
        slopes.stage(method, 3, dynamics, over, begin)?;
        slopes.stage(method, 4, dynamics, over, begin)?;
        slopes.stage(method, 5, dynamics, over, begin)?;
        let mut end = None;
        let see = |state: &StateOf<X, R>| end = Some(state.clone());
        let increment = slopes.stage_seen(method, 6, dynamics, over, begin, see)?;
        Some(Trial { slopes, increment, end: end? })
    }

    /// The estimated error, relative to the tolerances.
    fn error(&self, method: &DormandPrince<R>, of: &X, h: R, begin: &StateOf<X, R>) -> R {
        let (layout, scales) = (of.layout(), of.internal_scales());
        let Increment { u, v, z, .. } = self.slopes.increment(layout, h, 0.0, &ESTIMATE);
        let scale = Scale::new((method.absolute, method.relative), layout, scales, begin, &self.end);
        scale.norm(&u, &v, &z)
    }

    /// Remembers the step, which was taken; gives its end.
    fn keep(
        self,
        memory: &mut MemoryOf<X, R>,
        layout: &Layout<'_>,
        (time, h): (R, R),
        begin: &StateOf<X, R>,
    ) -> StateOf<X, R> {
        let Trial { slopes, increment, end } = self;
        memory.segment = Some(Segment::new(layout, h, begin.clone(), increment, &slopes));
        let derivative = slopes.last().clone();
        memory.end = Some(End { times: [time, time + h], state: end.clone(), derivative });
        end
    }
}

impl<R: Real> Method<R> for DormandPrince<R> {
    type Memory<X: Variables<R>> = MemoryOf<X, R>;

    fn memory<X: Variables<R>>(&self) -> MemoryOf<X, R> {
        DormandPrinceMemory { size: None, error: R::from_f64(LEAST_ERROR), end: None, segment: None }
    }

    fn largest_step(&self) -> Option<R> {
        self.adaptive.then(|| R::from_f64(LARGEST_STEP))
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
    fn size<X: Variables<R>>(memory: &MemoryOf<X, R>) -> Option<R> {
        memory.segment.as_ref().map(Segment::size)
    }

    fn at<X: Variables<R>>(memory: &MemoryOf<X, R>, of: &X, elapsed: R) -> Option<StateOf<X, R>> {
        memory.segment.as_ref().map(|segment| segment.at(of.layout(), elapsed))
    }
}

impl<R: Real, X: Variables<R>, D: Dynamics<R, Variables = X>> Integrator<R, D> for DormandPrince<R> {
    fn step(
        &self,
        memory: &mut MemoryOf<X, R>,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<X, R>,
    ) -> Result<SteppedOf<X, R>, StepFailure<R>> {
        let first = match memory.known(time, state) {
            Some(first) if dynamics.resume() => first,
            _ => dynamics.derivative(time, &mut state.clone()),
        };
        if dynamics.broke_down() || !first.is_finite() {
            return Err(StepFailure::Breakdown);
        }
        if !self.adaptive {
            let trial = Trial::new(dynamics, time, h, state, &first).ok_or(StepFailure::Breakdown)?;
            let end = trial.keep(memory, dynamics.variables().layout(), (time, h), state);
            return Ok(Stepped::explicit(h, end));
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
            let of = dynamics.variables();
            let error = trial.as_ref().map(|trial| trial.error(self, of, size, state));
            match (trial, error) {
                (Some(trial), Some(error)) if error <= R::ONE => {
                    let end = trial.keep(memory, dynamics.variables().layout(), (time, size), state);
                    let rejected = rejections.total() > 0;
                    let next = size * control::after_acceptance(error, memory.error, rejected);
                    if shortened && !rejected {
                        memory.size = Some(next.max(proposed));
                    } else {
                        memory.size = Some(next);
                        memory.error = error.max(R::from_f64(LEAST_ERROR));
                    }
                    return Ok(Stepped { rejections, ..Stepped::explicit(size, end) });
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
