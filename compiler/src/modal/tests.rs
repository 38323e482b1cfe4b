//! Factors and points against what they stand for.

use super::linear::reduced as reduced_by;
use super::*;

fn near(found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() <= within, "{found:?} is not {expected:?}");
}

/// Mass, place, and where each mode moves it.
type Mass = (f64, [f64; 3], [[f64; 3]; 2]);

/// Four points of different mass, moved by two modes, of which the second turns them, too.
fn some() -> Reduced {
    let points = [
        (0.3, [0.0, 0.1, 0.0], [[0.1, 0.0, 0.2], [0.0, 0.5, 0.0]]),
        (0.5, [0.4, 0.0, 0.1], [[0.0, 0.6, 0.1], [0.2, 0.0, -0.3]]),
        (0.1, [0.9, -0.2, 0.0], [[-0.3, 1.1, 0.0], [0.0, 0.4, 1.0]]),
        (0.7, [0.2, 0.3, -0.4], [[0.5, 0.1, 0.4], [0.3, -0.2, 0.1]]),
    ];
    let f = |point: &Mass| -> Vec<f64> { point.1.iter().chain(point.2.iter().flatten()).copied().collect() };
    let sum = |of: &dyn Fn(&Mass) -> f64| -> f64 { points.iter().map(|point| point.0 * of(point)).sum() };
    let moments: Square = (0..9).map(|i| (0..9).map(|k| sum(&|p| f(p)[i] * f(p)[k])).collect()).collect();
    let first: Vec<f64> = (0..9).map(|i| sum(&|p| f(p)[i])).collect();
    let trace = moments[0][0] + moments[1][1] + moments[2][2];
    let own = |i: usize, k: usize| if i == k { trace - moments[i][i] } else { -moments[i][k] };
    let mass: f64 = points.iter().map(|point| point.0).sum();
    let placed = |j: usize, k: usize| -> f64 { (0..3).map(|a| moments[3 + 3 * j + a][3 + 3 * k + a]).sum() };
    let swept = |mode: usize, a: usize| {
        let (b, c) = ((a + 1) % 3, (a + 2) % 3);
        moments[b][3 + 3 * mode + c] - moments[c][3 + 3 * mode + b]
    };
    let turned = 0.02;
    Reduced {
        mass,
        inertia: [0, 1, 2].map(|i| [0, 1, 2].map(|k| own(i, k) + if i == k { turned } else { 0.0 })),
        momentum: (0..2).map(|j| [0, 1, 2].map(|a| first[3 + 3 * j + a])).collect(),
        angular_momentum: (0..2)
            .map(|j| [0, 1, 2].map(|a| swept(j, a) + if (j, a) == (1, 2) { turned } else { 0.0 }))
            .collect(),
        center: [0, 1, 2].map(|axis| first[axis] / mass),
        generalised_mass: vec![vec![placed(0, 0), placed(0, 1)], vec![placed(1, 0), placed(1, 1) + turned]],
        stiffness: vec![vec![300.0, -40.0], vec![-40.0, 500.0]],
        moments,
        nodes: Vec::new(),
        numbers: vec![1, 2],
    }
}

/// What points of equal weight have in common with the body: all integrals of two functions.
#[test]
fn points_have_the_integrals_of_the_body() {
    let of = some();
    let points = of.points();
    assert_eq!(points.len(), 10);
    let f = |point: &MassPoint| -> Vec<f64> {
        [1.0].iter().chain(&point.at).chain(point.shifts.iter().flatten()).copied().collect()
    };
    let whole = of.whole();
    for (i, row) in whole.iter().enumerate() {
        for (k, expected) in row.iter().enumerate() {
            let found: f64 = points.iter().map(|point| point.share * f(point)[i] * f(point)[k]).sum();
            near(found, *expected, 1e-14);
        }
    }
}

/// What is not of places is found, and nothing else.
#[test]
fn what_turns_is_told_apart() {
    let Rotary { inertia, momentum, modal } = some().rotary();
    for (i, row) in inertia.iter().enumerate() {
        row.iter().enumerate().for_each(|(k, entry)| near(*entry, if i == k { 0.02 } else { 0.0 }, 1e-15));
    }
    assert_eq!(momentum[0], [0.0; 3]);
    near(momentum[1][2], 0.02, 1e-15);
    assert_eq!([modal[0][0], modal[0][1], modal[1][0]], [0.0; 3]);
    near(modal[1][1], 0.02, 1e-15);
}

/// C of the ratio 1 is 2 √(K M) of each natural mode: with Ψᵀ M Ψ = 1 and Ψᵀ K Ψ = Ω², Ψᵀ C Ψ = 2 Ω.
#[test]
fn damping_is_that_of_natural_modes() {
    let of = some();
    let l = cholesky(&of.generalised_mass).expect("it is positive definite");
    let (squares, q) = eigen(&reduced_by(&l, &of.stiffness));
    // Ψ = L⁻ᵀ Q.
    let shape = |k: usize| {
        let second = q[1][k] / l[1][1];
        [(q[0][k] - l[1][0] * second) / l[0][0], second]
    };
    let damping = of.critical_damping();
    for j in 0..2 {
        for (k, square) in squares.iter().enumerate() {
            let product = |matrix: &Square| -> f64 {
                let pairs = (0..2).flat_map(|a| (0..2).map(move |b| (a, b)));
                pairs.map(|(a, b)| shape(j)[a] * matrix[a][b] * shape(k)[b]).sum()
            };
            let same = f64::from(u8::from(j == k));
            near(product(&of.generalised_mass), same, 1e-14);
            near(product(&of.stiffness), same * square, 1e-11);
            near(product(&damping), same * 2.0 * square.sqrt(), 1e-12);
        }
    }
}

/// Of a chain of equal springs and masses the eigenvalues are 2 − 2 cos kπ/(n + 1).
#[test]
fn eigenvalues_of_a_chain() {
    const COUNT: usize = 30;
    let entry = |i: usize, k: usize| match i.abs_diff(k) {
        0 => 2.0,
        1 => -1.0,
        _ => 0.0,
    };
    let matrix: Square = (0..COUNT).map(|i| (0..COUNT).map(|k| entry(i, k)).collect()).collect();
    let (mut values, _) = eigen(&matrix);
    values.sort_by(f64::total_cmp);
    for (k, value) in values.into_iter().enumerate() {
        let angle = (k as f64 + 1.0) * std::f64::consts::PI / (COUNT as f64 + 1.0);
        near(value, 2.0 - 2.0 * angle.cos(), 1e-14);
    }
    let root = root(&matrix);
    for i in 0..COUNT {
        for k in 0..COUNT {
            let square: f64 = (0..COUNT).map(|m| root[i][m] * root[m][k]).sum();
            near(square, entry(i, k), 1e-13);
        }
    }
}

/// Fewer modes leave nothing of the others.
#[test]
fn some_of_the_modes() {
    let (all, second) = (some(), some().only(2..=2));
    assert_eq!((second.modes(), second.numbers.clone()), (1, vec![2]));
    assert_eq!(second.generalised_mass, vec![vec![all.generalised_mass[1][1]]]);
    assert_eq!(second.moments[3][4], all.moments[6][7]);
    assert_eq!(second.momentum, vec![all.momentum[1]]);
}
