//! The residuals that vanish at a consistent position: constraint rows and conditions, angles by the whole angle.
//!
//! Rows that are sines have a second root half a turn away. Here they count as the angles themselves, so that Newton's
//! iteration (`position.rs`) turns back what is on the wrong side. In space sines are products of two unit vectors and angles
//! only where other rows hold: axes are therefore brought together first, by the angle between them, and the turn about
//! them is let go until then.

use super::system::name_unknown;
use crate::error::AssemblyError;
use crate::mechanism::{Assemble, ConditionKind, Flips, name_row};
use crate::real::Real;
use crate::state::Variables;
use crate::vector::{Vector, at, put};

/// Axes further apart than this, rad, are brought together before bodies are turned about them.
const ALIGNED: f64 = 0.1;

/// The least divisor that stands for a cosine.
const NEARLY_RIGHT: f64 = 1e-3;

/// The residual of the mechanism `M`.
pub(super) type ResidualOf<R, M> = Residual<R, <M as Variables<R>>::Lambda, <M as Assemble<R>>::Conditions>;

/// The residual of all rows at one position.
pub(super) struct Residual<R, L, C> {
    pub(super) rows: L,
    pub(super) conditions: C,
    /// The divisors of the rows of D: cos Δθ where the residual is Δθ in place of sin Δθ; zero for a row that is
    /// let go for the time being.
    pub(super) divisors: L,
    pub(super) norm: R,
}

impl<R: Real, L: Vector<R>, C: Vector<R>> Residual<R, L, C> {
    pub(super) fn at<M>(model: &M, time: R, q: &M::Q, targets: &C, active: &C) -> Self
    where
        M: Assemble<R, Lambda = L, Conditions = C>,
    {
        let (mut rows, mut cosines, mut divisors) =
            (model.zero_lambda(), model.zero_lambda(), model.zero_lambda());
        model.constraints(time, q, &mut rows);
        model.row_cosines(time, q, &mut cosines);
        divisors.as_mut_slice().fill(R::ONE);
        let mut let_go = R::ZERO;
        for &Flips { axes, turns } in model.flips() {
            let (rows, divisors) = (rows.as_mut_slice(), divisors.as_mut_slice());
            match axes {
                Some(axes) => {
                    let axes = axes.map(usize::from);
                    let_go = let_go + axes_then_turns(axes, turns, cosines.as_slice(), rows, divisors);
                }
                None => whole_angles(turns, cosines.as_slice(), rows, divisors),
            }
        }

        let (mut conditions, mut flipped) = (model.zero_conditions(), model.zero_conditions());
        model.condition_residual(time, q, targets, &mut conditions);
        model.condition_cosines(time, q, targets, &mut flipped);
        for (i, entry) in conditions.as_mut_slice().iter_mut().enumerate() {
            let held = at(active.as_slice(), i) != R::ZERO;
            *entry = match model.conditions().get(i).map(|condition| condition.kind) {
                Some(ConditionKind::Angle) if held => entry.atan2(at(flipped.as_slice(), i)),
                Some(ConditionKind::Linear) if held => *entry,
                _ => R::ZERO,
            };
        }
        let norm = (rows.norm_squared() + conditions.norm_squared() + let_go).sqrt();
        Residual { rows, conditions, divisors, norm }
    }

    pub(super) fn check_finite<M: Assemble<R>>(&self, model: &M) -> Result<(), AssemblyError> {
        let in_rows = self.rows.first_not_finite();
        let unknown =
            in_rows.or_else(|| self.conditions.first_not_finite().map(|i| self.rows.as_slice().len() + i));
        match unknown {
            Some(row) => {
                Err(AssemblyError::NonFinite { row: name_unknown(model, model.velocity_count() + row) })
            }
            // Squares overflow before numbers do.
            None if !self.norm.is_finite() => Err(AssemblyError::NonFinite {
                row: name_unknown(model, model.velocity_count() + self.worst().0),
            }),
            None => Ok(()),
        }
    }

    pub(super) fn check_flips<M: Assemble<R>>(&self, model: &M) -> Result<(), AssemblyError> {
        let mut flips = model.flips().iter().flat_map(Flips::rows);
        match flips.find(|&row| at(self.divisors.as_slice(), row.into()) < R::ZERO) {
            Some(row) => Err(AssemblyError::Flipped { row: name_row(model, Some(row.into())) }),
            None => Ok(()),
        }
    }

    /// Whether a row is at the place between its two roots where its derivative vanishes.
    pub(super) fn at_right_angle<M: Assemble<R>>(&self, model: &M) -> bool {
        let divisor = |row: u16| at(self.divisors.as_slice(), row.into());
        model.flips().iter().flat_map(Flips::rows).any(|row| divisor(row).abs() == R::from_f64(NEARLY_RIGHT))
    }

    /// The error that names the worst row; a joint stuck on its flipped root is said to be that.
    pub(super) fn no_convergence<M: Assemble<R>>(&self, model: &M, iterations: u32) -> AssemblyError {
        let (worst, residual) = self.worst();
        let row = name_unknown(model, model.velocity_count() + worst);
        let flipped = self.divisors.as_slice().get(worst).is_some_and(|&divisor| divisor < R::ZERO);
        if flipped && model.flips().iter().flat_map(Flips::rows).any(|row| usize::from(row) == worst) {
            return AssemblyError::Flipped { row };
        }
        AssemblyError::NoConvergence { row, residual: residual.to_f64(), iterations }
    }

    /// Index and magnitude of the largest residual; conditions are counted after rows.
    fn worst(&self) -> (usize, R) {
        let all = self.rows.as_slice().iter().chain(self.conditions.as_slice());
        all.enumerate().fold((0, R::ZERO), |(at, largest), (i, entry)| {
            if entry.abs() > largest { (i, entry.abs()) } else { (at, largest) }
        })
    }
}

/// Rows sin Δθ with their cosines: the residual is Δθ, whose derivative is that of the sine over the cosine.
fn whole_angles<R: Real>(flips: &[u16], cosines: &[R], rows: &mut [R], divisors: &mut [R]) {
    for &row in flips {
        let (row, cosine) = (row as usize, at(cosines, row.into()));
        put(rows, row, at(rows, row).atan2(cosine));
        put(divisors, row, away_from_zero(cosine));
    }
}

/// Rows that make two axes parallel, and those of the turn about them; returns what the latter add to the squared norm
/// while they are let go.
fn axes_then_turns<R: Real>(
    axes: [usize; 2],
    turns: &[u16],
    cosines: &[R],
    rows: &mut [R],
    divisors: &mut [R],
) -> R {
    let cosine = at(cosines, axes[0]);
    let (angle, turn) = between_axes(axes.map(|row| at(rows, row)), cosine);
    for (row, turn) in axes.into_iter().zip(turn) {
        put(rows, row, turn);
        put(divisors, row, away_from_zero(cosine));
    }
    if angle <= R::from_f64(ALIGNED) {
        whole_angles(turns, cosines, rows, divisors);
        return R::ZERO;
    }
    for &row in turns {
        put(rows, row.into(), R::ZERO);
        put(divisors, row.into(), R::ZERO);
    }
    // More than any angle, so that the norm falls when a row is taken up.
    R::from_f64(core::f64::consts::PI * core::f64::consts::PI * turns.len() as f64)
}

/// The angle θ between two axes z₁ and z₂, and θ along the direction of s = (x₁·z₂, y₁·z₂), |s| = sin θ.
///
/// With the derivatives of s over cos θ, Newton's step is then the turn by θ that brings z₂ to z₁ on the shortest way.
/// Taken one by one, a row whose sine is zero while the axes are opposite would ask for half a turn of its own.
fn between_axes<R: Real>([x, y]: [R; 2], cosine: R) -> (R, [R; 2]) {
    let sine = (x * x + y * y).sqrt();
    let angle = sine.atan2(cosine);
    if sine > R::ZERO {
        let scale = angle / sine;
        return (angle, [x * scale, y * scale]);
    }
    // Together, or opposite to rounding, where any direction will do.
    (angle, if cosine < R::ZERO { [angle, R::ZERO] } else { [x, y] })
}

/// A cosine as a divisor, with its sign. At a right angle the derivative of the sine vanishes; a small divisor lets the
/// other rows move on.
fn away_from_zero<R: Real>(cosine: R) -> R {
    let nonzero = R::from_f64(NEARLY_RIGHT);
    match cosine {
        _ if cosine.abs() >= nonzero => cosine,
        _ if cosine < R::ZERO => -nonzero,
        _ => nonzero,
    }
}
