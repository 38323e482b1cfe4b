//! Slopes at the knots of a table, from which cubic pieces follow: those that look at a few neighbours only.

/// Widths of the intervals and the slopes of the straight lines over them.
pub(super) fn secants(x: &[f64], y: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let widths: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let rises = y.windows(2).map(|pair| pair[1] - pair[0]);
    let slopes = rises.zip(&widths).map(|(rise, width)| rise / width).collect();
    (widths, slopes)
}

/// Akima (1970): the mean of the secants beside a knot, each weighted by how much those on the other side differ. `modified`: with
/// half the magnitude of their sum in addition, which keeps what is level so.
pub(super) fn akima(secants: &[f64], modified: bool) -> Vec<f64> {
    let n = secants.len() + 1;
    if n == 2 {
        return vec![secants[0]; 2];
    }
    // Two secants more on each side, on the parabola through the outer three knots.
    let mut m = vec![0.0; n + 3];
    m[2..n + 1].copy_from_slice(secants);
    m[1] = 2.0 * m[2] - m[3];
    m[0] = 2.0 * m[1] - m[2];
    m[n + 1] = 2.0 * m[n] - m[n - 1];
    m[n + 2] = 2.0 * m[n + 1] - m[n];
    let weight = |k: usize| {
        let change = (m[k + 1] - m[k]).abs();
        if modified { change + 0.5 * (m[k + 1] + m[k]).abs() } else { change }
    };
    let weights: Vec<[f64; 2]> = (0..n).map(|i| [weight(i + 2), weight(i)]).collect();
    let largest = weights.iter().map(|[a, b]| a + b).fold(0.0, f64::max);
    // Where all four lie on two lines, the corner has no slope of its own.
    let least = if modified { 0.0 } else { 1e-9 * largest };
    let slope = |(i, [left, right]): (usize, &[f64; 2])| {
        let both = left + right;
        if both > least {
            m[i + 1] + right / both * (m[i + 2] - m[i + 1])
        } else if modified {
            0.0
        } else {
            0.5 * (m[i + 3] + m[i])
        }
    };
    weights.iter().enumerate().map(slope).collect()
}

/// Steffen (1990): the slope of the parabola through three knots, as far as no value overshoots; ends by his equations (24) to (29).
pub(super) fn monotone(widths: &[f64], secants: &[f64]) -> Vec<f64> {
    let n = secants.len() + 1;
    if n == 2 {
        return vec![secants[0]; 2];
    }
    let sign = |x: f64| if x == 0.0 { 0.0 } else { x.signum() };
    let end = |h: [f64; 2], s: [f64; 2]| {
        let share = h[0] / (h[0] + h[1]);
        let p = s[0] * (1.0 + share) - s[1] * share;
        match p {
            p if p * s[0] <= 0.0 => 0.0,
            p if p.abs() > 2.0 * s[0].abs() => 2.0 * s[0],
            p => p,
        }
    };
    let inner = widths.windows(2).zip(secants.windows(2)).map(|(h, s)| {
        let p = (s[0] * h[1] + s[1] * h[0]) / (h[0] + h[1]);
        (sign(s[0]) + sign(s[1])) * s[0].abs().min(s[1].abs()).min(0.5 * p.abs())
    });
    let first = end([widths[0], widths[1]], [secants[0], secants[1]]);
    let last = end([widths[n - 2], widths[n - 3]], [secants[n - 2], secants[n - 3]]);
    std::iter::once(first).chain(inner).chain([last]).collect()
}

/// Fritsch and Butland (1984), the weighted harmonic mean of the secants, zero where their signs differ; at the ends the three-point
/// formula as far as it keeps the shape (Moler, Numerical Computing with MATLAB, section 3.6).
pub(super) fn pchip(widths: &[f64], secants: &[f64]) -> Vec<f64> {
    let n = secants.len() + 1;
    if n == 2 {
        return vec![secants[0]; 2];
    }
    let end = |h: [f64; 2], s: [f64; 2]| {
        let d = ((2.0 * h[0] + h[1]) * s[0] - h[0] * s[1]) / (h[0] + h[1]);
        match d {
            d if d * s[0] <= 0.0 => 0.0,
            d if s[0] * s[1] <= 0.0 && d.abs() > 3.0 * s[0].abs() => 3.0 * s[0],
            d => d,
        }
    };
    let inner = widths.windows(2).zip(secants.windows(2)).map(|(h, s)| {
        if s[0] * s[1] <= 0.0 {
            return 0.0;
        }
        let (first, second) = (2.0 * h[1] + h[0], h[1] + 2.0 * h[0]);
        (first + second) / (first / s[0] + second / s[1])
    });
    let first = end([widths[0], widths[1]], [secants[0], secants[1]]);
    let last = end([widths[n - 2], widths[n - 3]], [secants[n - 2], secants[n - 3]]);
    std::iter::once(first).chain(inner).chain([last]).collect()
}
