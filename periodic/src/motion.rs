//! One periodic motion: closed by Newton's method from a guess, with its multipliers.
//!
//! ```text
//! r(x) = φ(x) − x − advance = 0,   (1 − ∂φ/∂x) δ = r        shooting; the derivative is exact, so convergence is quadratic
//! ```
//! Source: Nayfeh, Balachandran, *Applied Nonlinear Dynamics* (1995), 5.4 (shooting), 3.2 (Floquet multipliers).

use crate::coordinates::{difference, numbers, state};
use crate::cycle::Cycle;
use crate::error::PeriodicError;
use crate::flow::{Flow, Switching, flow, second};
use linkwright::{StateOf, Tangent};
use nalgebra::{Complex, DMatrix, DVector};

/// Iterations before a motion is given up.
const ITERATIONS: u32 = 25;
/// The cycle is closed when a coordinate returns to this of its swing.
const CLOSED: f64 = 1e-10;
/// Or to this many roundings: of a turn by a radian or a travel by a metre, or of itself if it is larger.
const ROUNDINGS: f64 = 64.0;
/// Where no step closes the cycle better, this is enough: a swing that is small beside the positions themselves has no more digits.
pub(crate) const STALLED: f64 = 1e-6;
/// A second period may differ from the first by this, of the swing: what is not closed has grown by then.
const AGAIN: f64 = 1e-5;
/// Halvings of a step that closes the cycle no better.
const HALVINGS: u32 = 6;

/// A motion that repeats.
pub struct PeriodicMotion<M: Tangent<f64>> {
    /// p.
    pub value: f64,
    /// T, s.
    pub period: f64,
    /// At time zero.
    pub state: StateOf<M>,
    /// x at time zero: the coordinates of [`Tangent::states`], their rates, the internal states.
    pub start: DVector<f64>,
    /// ∂x(T)/∂x(0), the monodromy matrix, n_x × n_x.
    pub monodromy: DMatrix<f64>,
    /// How far each number of x goes from its value at time zero, but for what it goes on by evenly.
    pub swing: DVector<f64>,
    /// Where the law switches, in order.
    pub switchings: Vec<Switching>,
}

impl<M: Tangent<f64>> Clone for PeriodicMotion<M> {
    fn clone(&self) -> Self {
        PeriodicMotion {
            value: self.value,
            period: self.period,
            state: self.state.clone(),
            start: self.start.clone(),
            monodromy: self.monodromy.clone(),
            swing: self.swing.clone(),
            switchings: self.switchings.clone(),
        }
    }
}

impl<M: Tangent<f64>> PeriodicMotion<M> {
    /// The Floquet multipliers, n_x eigenvalues of the monodromy matrix: what a small disturbance is multiplied by in a period.
    pub fn multipliers(&self) -> Vec<Complex<f64>> {
        self.monodromy.complex_eigenvalues().iter().copied().collect()
    }

    /// The largest of them by size. Below one the motion is stable.
    pub fn largest_multiplier(&self) -> f64 {
        self.multipliers().iter().map(|multiplier| multiplier.norm()).fold(0.0, f64::max)
    }

    /// Whether small disturbances die out.
    pub fn is_stable(&self) -> bool {
        self.largest_multiplier() < 1.0
    }
}

impl<M: Tangent<f64>> Cycle<'_, M> {
    /// The periodic motion at a value of p, from a state near it.
    ///
    /// # Errors
    /// [`NotClosed`](PeriodicError::NotClosed) where Newton's method does not come to one; [`NotPeriodic`](PeriodicError::NotPeriodic) where
    /// the motion that it comes to goes on in another way; whatever the motion meets on its way.
    pub fn close(&self, value: f64, near: &StateOf<M>) -> Result<PeriodicMotion<M>, PeriodicError> {
        let model = self.model(value)?;
        let mut at = self.begin(&model, value, near.clone())?;
        let mut iterations = 0;
        while !at.closed() {
            if iterations == ITERATIONS {
                return Err(at.not_closed(value, iterations));
            }
            iterations += 1;
            let step = at.newton().ok_or_else(|| at.not_closed(value, iterations))?;
            match self.shorten(&model, value, &at, &step) {
                Some(next) => at = next,
                None if at.off() < STALLED => break,
                None => return Err(at.not_closed(value, iterations)),
            }
        }
        self.repeats(&model, value, &at)?;
        Ok(at.into_motion(value))
    }

    /// Whether the second period is as the first one: laws may have another period than was said.
    fn repeats(&self, model: &M, value: f64, first: &Trial<M>) -> Result<(), PeriodicError> {
        let again = second(self, model, value, &first.flow.end)?;
        let apart = difference(self, model, [&again.x, &first.flow.x], 1.0);
        let off = apart.iter().zip(&first.flow.swing).map(|(apart, swing)| apart.abs() / swing);
        match off.filter(|off| off.is_finite()).fold(0.0, f64::max) {
            off if off > AGAIN => Err(PeriodicError::NotPeriodic { value, period: first.period, off }),
            _ => Ok(()),
        }
    }

    /// The same after `periods` of the motion from a state: what is left of its beginning has died out then, if the motion is stable.
    ///
    /// # Errors
    /// As [`close`](Cycle::close).
    pub fn settle(
        &self,
        value: f64,
        from: &StateOf<M>,
        periods: usize,
    ) -> Result<PeriodicMotion<M>, PeriodicError> {
        self.close(value, &self.after(value, from, periods)?)
    }

    /// The step of Newton's method, halved until it closes the cycle better.
    fn shorten(&self, model: &M, value: f64, at: &Trial<M>, step: &DVector<f64>) -> Option<Trial<M>> {
        let mut share = 1.0;
        for _ in 0..HALVINGS {
            let next = state(model, 0.0, &at.state, &(&at.x + step * share))
                .and_then(|state| self.begin(model, value, state));
            match next {
                Ok(next) if next.off() < at.off() => return Some(next),
                _ => share *= 0.5,
            }
        }
        None
    }

    pub(crate) fn begin(&self, model: &M, value: f64, state: StateOf<M>) -> Result<Trial<M>, PeriodicError> {
        let x = numbers(model, 0.0, &state);
        let flow = flow(self, model, value, &state, true)?;
        let residual = difference(self, model, [&flow.x, &x], 1.0);
        Ok(Trial { state, x, flow, residual, freedoms: model.states().len(), period: self.period(value)? })
    }
}

/// A beginning of the cycle, and what became of it.
pub(crate) struct Trial<M: Tangent<f64>> {
    pub state: StateOf<M>,
    pub x: DVector<f64>,
    pub flow: Flow<M>,
    pub residual: DVector<f64>,
    /// f.
    freedoms: usize,
    period: f64,
}

impl<M: Tangent<f64>> Trial<M> {
    pub fn into_motion(self, value: f64) -> PeriodicMotion<M> {
        let Trial { state, x: start, flow, period, .. } = self;
        let Flow { derivative, swing, switchings, .. } = flow;
        let monodromy = derivative.expect("it was asked for");
        PeriodicMotion { value, period, state, start, monodromy, swing, switchings }
    }

    /// The largest difference in swings of its coordinate.
    pub fn off(&self) -> f64 {
        let swings = self.residual.iter().zip(&self.flow.swing);
        swings.map(|(off, swing)| off.abs() / swing.max(f64::MIN_POSITIVE)).fold(0.0, f64::max)
    }

    /// A coordinate is known to the roundings of the positions, which are turns and lengths, and its rate to those by time.
    pub fn closed(&self) -> bool {
        let all = self.residual.iter().zip(&self.flow.swing).zip(&self.flow.x).enumerate();
        all.into_iter().all(|(at, ((off, swing), x))| {
            let size = if at < self.freedoms { 1.0 } else { core::f64::consts::TAU / self.period };
            off.abs() <= (CLOSED * swing).max(ROUNDINGS * f64::EPSILON * x.abs().max(size))
        })
    }

    /// ∂φ/∂x.
    pub fn derivative(&self) -> &DMatrix<f64> {
        self.flow.derivative.as_ref().expect("it was asked for")
    }

    fn newton(&self) -> Option<DVector<f64>> {
        let size = self.x.len();
        (DMatrix::identity(size, size) - self.derivative()).lu().solve(&self.residual)
    }

    pub fn not_closed(&self, value: f64, iterations: u32) -> PeriodicError {
        PeriodicError::NotClosed { value, residual: self.off(), iterations }
    }
}
