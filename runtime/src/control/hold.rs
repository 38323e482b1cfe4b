//! A linear plant between two ticks, its inputs held: the exponential of its matrix.

use crate::error::LinearisationError;
use crate::real::Real;
use crate::vector::{Vector, at, put};

/// The 1-norm of A h up to which the approximant below is exact to rounding in double precision.
const LARGEST: f64 = 0.5;
/// c₀ … c₆ of the numerator of Padé's approximant (6, 6) of eˣ, (12 − k)! 6! / (12! k! (6 − k)!); the denominator has them with the signs
/// of (−1)ᵏ.
const PADE: [f64; 7] = [1.0, 1.0 / 2.0, 5.0 / 44.0, 1.0 / 66.0, 1.0 / 792.0, 1.0 / 15_840.0, 1.0 / 665_280.0];

/// A_d and B_d of x(t + h) = A_d x(t) + B_d u for ẋ = A x + B u with u held over h (s):
///
/// ```text
/// ⎡ A_d  B_d ⎤       ⎛ ⎡ A  B ⎤   ⎞
/// ⎣  0    1  ⎦ = exp ⎝ ⎣ 0  0 ⎦ h ⎠      A_d = e^{A h},   B_d = ∫₀ʰ e^{A τ} dτ B
/// ```
/// `a` is `[R; n·n]` and `b` `[R; n·n_u]`, row by row, such as those of a [`StateSpace`](crate::StateSpace); h may be negative. A h is halved s times
/// until its 1-norm is at most ½, the exponential of that taken by Padé's approximant (6, 6), whose error is then below 4·10⁻¹⁶ of it, and
/// squared s times. The blocks are computed apart, so that no matrix is larger than A; the denominator is diagonally dominant there and is
/// eliminated without pivoting. Allocates nothing.
///
/// Source: Van Loan, *Computing integrals involving the matrix exponential*, IEEE Trans. Automat. Contr. 23 (1978) 395–404; Moler, Van Loan,
/// *Nineteen dubious ways to compute the exponential of a matrix*, SIAM Review 45 (2003), method 3 and table 1; Higham, *The scaling and squaring
/// method for the matrix exponential revisited*, SIAM J. Matrix Anal. Appl. 26 (2005).
///
/// # Errors
/// [`NonFinite`](LinearisationError::NonFinite) where an entry is infinite or NaN, or the exponential overflows;
/// [`WrongShape`](LinearisationError::WrongShape) where A is not square or B has not as many rows.
pub fn zero_order_hold<R: Real, A: Vector<R>, B: Vector<R>>(
    a: &A,
    b: &B,
    h: R,
) -> Result<(A, B), LinearisationError> {
    let (n, inputs) = shape(a.as_slice().len(), b.as_slice().len())?;
    let what = |what| LinearisationError::NonFinite { time: 0.0, what };
    let mut size = norm(a, n) * h.abs();
    if !(size.is_finite() && h.is_finite() && a.first_not_finite().is_none()) {
        return Err(what("A h"));
    }
    let (mut h, half, mut squarings) = (h, R::from_f64(0.5), 0_u32);
    while size > R::from_f64(LARGEST) {
        (size, h, squarings) = (half * size, half * h, squarings + 1);
    }
    let (mut state, mut input) = pade(&a.scaled(h), &b.scaled(h), n, inputs);
    for _ in 0..squarings {
        // The square of [F, G; 0, 1] is [F F, F G + G; 0, 1].
        input = product(&state, &input, n, inputs).plus(R::ONE, &input);
        state = product(&state, &state, n, n);
    }
    if state.first_not_finite().is_some() {
        return Err(what("A_d"));
    }
    if input.first_not_finite().is_some() {
        return Err(what("B_d"));
    }
    Ok((state, input))
}

/// n and n_u of so many entries.
fn shape(a: usize, b: usize) -> Result<(usize, usize), LinearisationError> {
    let n = (0..=a).find(|n| n * n >= a).unwrap_or(0);
    let inputs = b.checked_div(n).unwrap_or(0);
    if n * n == a && n * inputs == b { Ok((n, inputs)) } else { Err(LinearisationError::WrongShape { a, b }) }
}

/// The largest sum of magnitudes of a column.
fn norm<R: Real, A: Vector<R>>(a: &A, n: usize) -> R {
    let column = |k: usize| a.as_slice().iter().skip(k).step_by(n.max(1));
    (0..n).map(|k| column(k).fold(R::ZERO, |sum, entry| sum + entry.abs())).fold(R::ZERO, |most, sum| {
        // A NaN stays.
        if sum <= most { most } else { sum }
    })
}

/// The blocks of Padé's approximant p(Z)/p(−Z) for Z = \[X, Y; 0, 0\]: with Zᵏ = \[Xᵏ, Xᵏ⁻¹ Y; 0, 0\] and p(±X) = U ± X V, V = Σ c_k Xᵏ⁻¹ over odd
/// k, they are (U − X V)⁻¹ (U + X V) and (U − X V)⁻¹ 2 V Y.
fn pade<R: Real, A: Vector<R>, B: Vector<R>>(x: &A, y: &B, n: usize, inputs: usize) -> (A, B) {
    let square = product(x, x, n, n);
    // Horner's scheme in X²: U = c₀ + c₂ X² + c₄ X⁴ + c₆ X⁶, V = c₁ + c₃ X² + c₅ X⁴.
    let even = horner(&square, n, [PADE[6], PADE[4], PADE[2], PADE[0]]);
    let odd = horner(&square, n, [0.0, PADE[5], PADE[3], PADE[1]]);
    let shifted = product(x, &odd, n, n);
    let mut below = even.plus(-R::ONE, &shifted);
    let mut state = even.plus(R::ONE, &shifted);
    let mut input = product(&odd, &y.scaled(R::ONE + R::ONE), n, inputs);
    eliminate(below.as_mut_slice(), (state.as_mut_slice(), n), (input.as_mut_slice(), inputs), n);
    (state, input)
}

fn horner<R: Real, A: Vector<R>>(square: &A, n: usize, coefficients: [f64; 4]) -> A {
    let mut sum = A::zeros(n * n);
    for c in coefficients {
        sum = product(square, &sum, n, n);
        for entry in sum.as_mut_slice().iter_mut().step_by((n + 1).max(1)) {
            *entry = *entry + R::from_f64(c);
        }
    }
    sum
}

/// F G for F n × n and G n × `width`.
fn product<R: Real, A: Vector<R>, B: Vector<R>>(f: &A, g: &B, n: usize, width: usize) -> B {
    let mut product = B::zeros(n * width);
    let rows = product.as_mut_slice().chunks_exact_mut(width.max(1)).zip(f.as_slice().chunks_exact(n.max(1)));
    for (to, row) in rows {
        for (&factor, from) in row.iter().zip(g.as_slice().chunks_exact(width.max(1))) {
            to.iter_mut().zip(from).for_each(|(to, &from)| *to = factor.mul_add(from, *to));
        }
    }
    product
}

/// X ← M⁻¹ X and Y ← M⁻¹ Y by Gauss–Jordan, M diagonally dominant by columns.
fn eliminate<R: Real>(m: &mut [R], (x, wide): (&mut [R], usize), (y, narrow): (&mut [R], usize), n: usize) {
    for k in 0..n {
        let pivot = at(m, k * n + k);
        for row in (0..n).filter(|row| *row != k) {
            let factor = at(m, row * n + k) / pivot;
            subtract(m, n, row, k, factor);
            subtract(x, wide, row, k, factor);
            subtract(y, narrow, row, k, factor);
        }
    }
    for row in 0..n {
        let pivot = at(m, row * n + row);
        for entry in
            x.iter_mut().skip(row * wide).take(wide).chain(y.iter_mut().skip(row * narrow).take(narrow))
        {
            *entry = *entry / pivot;
        }
    }
}

/// Row `row` less `factor` times row `k`.
fn subtract<R: Real>(matrix: &mut [R], width: usize, row: usize, k: usize, factor: R) {
    for column in 0..width {
        let rest = at(matrix, row * width + column) - factor * at(matrix, k * width + column);
        put(matrix, row * width + column, rest);
    }
}
