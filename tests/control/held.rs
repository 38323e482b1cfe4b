//! Linear plants with their inputs held: against a series, there and back, and in closed form.

use crate::registry::{Random, vector};
use crate::{assert_close, assert_close_by};
use linkwright::{LinearisationError, Vector, zero_order_hold};

/// Σ (A h)ᵏ/k! in steps so short that few terms suffice, and many of them.
fn by_series<const N: usize, const C: usize>(a: &[f64], b: &[f64], h: f64) -> (Vec<f64>, Vec<f64>) {
    let count = 4096;
    let (mut state, mut input) = (vec![0.0; N * N], vec![0.0; N * C]);
    (0..N).for_each(|k| state[k * N + k] = 1.0);
    let step = h / f64::from(count);
    let times = |x: &[f64], width: usize| -> Vec<f64> {
        let entry = |at: usize| (0..N).map(|k| a[at / width * N + k] * x[k * width + at % width]).sum();
        (0..N * width).map(entry).collect()
    };
    for _ in 0..count {
        // x ← x + step (A x + B u) + …, column by column.
        let mut term = state.clone();
        for k in 1..6 {
            term = times(&term, N).iter().map(|x| x * step / f64::from(k)).collect();
            state.iter_mut().zip(&term).for_each(|(x, term)| *x += term);
        }
        let mut term: Vec<f64> = times(&input, C).iter().zip(b).map(|(x, b)| step * (x + b)).collect();
        input.iter_mut().zip(&term).for_each(|(x, term)| *x += term);
        for k in 2..6 {
            term = times(&term, C).iter().map(|x| x * step / f64::from(k)).collect();
            input.iter_mut().zip(&term).for_each(|(x, term)| *x += term);
        }
    }
    (state, input)
}

#[test]
fn held_inputs_act_as_a_series_says() {
    let mut random = Random::new(77);
    for size in [1e-3, 0.3, 1.0, 5.0, 20.0] {
        let a: [f64; 16] = vector(&random.vector(16).iter().map(|x| size * x).collect::<Vec<_>>());
        let b: [f64; 8] = vector(&random.vector(8));
        let (state, input) = zero_order_hold(&a, &b, 0.7).expect("finite");
        let expected = by_series::<4, 2>(&a, &b, 0.7);
        assert_close("A_d", &state, &expected.0, 1e-11);
        assert_close("B_d", &input, &expected.1, 1e-11);
        // Twice h is the same twice, and there and back is nothing.
        let (twice, _) = zero_order_hold(&a, &b, 1.4).expect("finite");
        let (back, _) = zero_order_hold(&a, &b, -0.7).expect("finite");
        let product = |x: &[f64], y: &[f64]| -> Vec<f64> {
            (0..16).map(|at| (0..4).map(|k| x[at / 4 * 4 + k] * y[4 * k + at % 4]).sum()).collect()
        };
        assert_close("squared", &product(&state, &state), &twice, 1e-11);
        let one: Vec<f64> = (0..16).map(|at| f64::from(at % 5 == 0)).collect();
        assert_close_by("inverse", &product(&state, &back), &one, 1e-12 * state.max_abs() * back.max_abs());
    }
}

#[test]
fn held_inputs_in_closed_form() {
    // A mass that is pushed: [1 h; 0 1] and [h²/2; h]; a pendulum: cosine and sine.
    let (a, b) = zero_order_hold(&[0.0, 1.0, 0.0, 0.0], &[0.0, 1.0], 3.0).expect("finite");
    assert_close("A_d", &a, &[1.0, 3.0, 0.0, 1.0], 1e-15);
    assert_close("B_d", &b, &[4.5, 3.0], 1e-15);
    let (w, h) = (7.0_f64, 0.9);
    let (a, b) = zero_order_hold(&[0.0, 1.0, -w * w, 0.0], &[0.0, 1.0], h).expect("finite");
    let (s, c) = (w * h).sin_cos();
    assert_close("A_d", &a, &[c, s / w, -w * s, c], 1e-14);
    assert_close("B_d", &b, &[(1.0 - c) / (w * w), s / w], 1e-13);
    // Nothing to do, and nothing that can be done.
    assert_eq!(zero_order_hold::<f64, _, _>(&(), &(), 1.0), Ok(((), ())));
    assert_eq!(zero_order_hold(&[2.0; 4], &[1.0; 2], 0.0).expect("finite").0, [1.0, 0.0, 0.0, 1.0]);
    let error = zero_order_hold(&[1.0; 3], &[1.0], 1.0).expect_err("not square");
    assert_eq!(error, LinearisationError::WrongShape { a: 3, b: 1 });
    assert!(zero_order_hold(&[1.0; 4], &[1.0; 3], 1.0).is_err());
    for (a, h) in [(f64::NAN, 1.0), (1.0, f64::INFINITY), (1e200, 1e200), (800.0, 1.0)] {
        let error = zero_order_hold(&[a], &[1.0], h).expect_err("too large");
        assert!(matches!(error, LinearisationError::NonFinite { .. }), "{error}");
    }
    assert_eq!(zero_order_hold(&[-1e300], &[1.0], 1.0).expect("it decays").0, [0.0]);
}
