//! How near the constraints are to losing rank: the reciprocal condition of D M⁻¹ Dᵀ, rows brought to length one.
//!
//! The pivots of a factorisation are at hand at every stage, and never below the least eigenvalue; where they are small, inverse
//! iteration says how small that is. The rows are measured by what they are along the motion ([`Assemble::row_scales`]), not by what
//! is left of them at the position, so that a row that vanishes as a whole counts.

use crate::mechanism::Assemble;
use crate::real::Real;
use crate::vector::Vector;

/// Substitutions made. The first finds the direction that is lost if it is lost by a hundred times more than any other.
const SUBSTITUTIONS: u32 = 3;

/// A pivot of D M⁻¹ Dᵀ, rows brought to length one, from which on the least eigenvalue is not asked for: 3·10⁻³ for `f64`, 3·10⁻² for
/// `f32`. On every mechanism that ships no position with such a pivot is nearly singular.
pub(crate) fn far<R: Real>() -> R {
    R::from_f64(3e-3).max(R::from_f64(30.0) * R::NEAR_SINGULAR)
}

/// The number that a step looks at: [`reciprocal_condition`], or the smallest pivot where that is far from zero.
pub(crate) fn watched<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> R {
    let mut store = model.store();
    let pivot = model.factor(time, q, R::ZERO, &mut store);
    if R::any(pivot.greater_equal(far())) { pivot } else { least(model, &store, pivot) }
}

/// An estimate of λ_min/λ_max of A = S^−½ D M⁻¹ Dᵀ S^−½ at a position, S the rows' scales; never above the smallest pivot. One for a
/// mechanism without constraints.
///
/// Inverse iteration: xᵢ₊₁ = A⁻¹ xᵢ/|xᵢ|, |xᵢ₊₁| → 1/λ_min from below (Golub, Van Loan, *Matrix Computations*, 8.2.2), by the
/// factors of K(0) = \[M, Dᵀ; D, 0\], whose solution for (0, b) has λ = −(D M⁻¹ Dᵀ)⁻¹ b. S is twice what the rows are where they are largest,
/// so that λ_max lies between ½ and m/2, m the number of rows, and is taken as one.
pub fn reciprocal_condition<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> R {
    if model.row_count() == 0 {
        return R::ONE;
    }
    let mut store = model.store();
    let pivot = model.factor(time, q, R::ZERO, &mut store);
    least(model, &store, pivot)
}

/// The estimate, by factors whose smallest pivot is given.
fn least<R: Real, M: Assemble<R>>(model: &M, store: &M::Store, pivot: R) -> R {
    // Written so that a NaN is returned.
    if !R::any(pivot.greater(R::ZERO)) {
        return pivot;
    }
    let mut scales = model.zero_lambda();
    model.row_scales(&mut scales);
    let roots = |x: &mut M::Lambda| {
        for (entry, scale) in x.as_mut_slice().iter_mut().zip(scales.as_slice()) {
            *entry = *entry * scale.sqrt();
        }
    };
    let mut x = signs::<R, M::Lambda>(model.row_count());
    let mut largest = R::ZERO;
    for _ in 0..SUBSTITUTIONS {
        let length = x.norm_squared().sqrt();
        x = x.scaled(R::ONE / length);
        roots(&mut x);
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.solve(store, &model.zero_v(), &x, &mut a, &mut lambda);
        roots(&mut lambda);
        let size = lambda.norm_squared().sqrt();
        // A vector that overflows, or is zero, says no more.
        if !(size > R::ZERO && size.is_finite()) {
            break;
        }
        largest = size.max(largest);
        x = lambda;
    }
    if largest > R::ZERO { pivot.min(R::ONE / largest) } else { pivot }
}

/// ±1 without a pattern, by the bits of multiples of the golden ratio.
fn signs<R: Real, V: Vector<R>>(len: usize) -> V {
    let mut x = V::zeros(len);
    for (k, entry) in x.as_mut_slice().iter_mut().enumerate() {
        let bit = (k as u32 + 1).wrapping_mul(0x9E37_79B9) >> 31;
        *entry = if bit == 0 { R::ONE } else { -R::ONE };
    }
    x
}
