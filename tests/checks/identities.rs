//! What must hold of any model at any state, by differences along its own motion: D is the derivative of Φ, γ that of
//! D v − ν, conditions have their rates, M belongs to the kinetic energy.
//!
//! Nothing here knows the mechanisms; positions and velocities are random and fulfil no constraint. What needs
//! consistent states is `balances.rs`.

use crate::registry::{At, Model, Random, compiled, for_each, vector};
use linkwright::{ConditionKind, Vector, retract};

const POINTS: usize = 10;

for_each!(jacobian_is_the_derivative);
for_each!(gamma_is_the_derivative);
for_each!(conditions_have_their_rates);
for_each!(mass_belongs_to_the_energy);
for_each!(bodies_move_as_reported);

/// Random states, and a model with random parameters for each.
fn points<M: Model>(seed: u64) -> impl Iterator<Item = (M, At<M>)> {
    let compiled = compiled::<M>(None);
    let mut random = Random::new(seed);
    (0..POINTS).map(move |_| {
        let mut point = random.point(&compiled);
        point.q = random.position(&M::LAYOUT);
        (M::prepared(&point.parameters).expect("parameters near their defaults"), At::of(&point))
    })
}

/// (t + h, q ⊕ h v).
fn along<M: Model>(at: &At<M>, h: f64) -> (f64, M::Q) {
    let mut q = at.q;
    retract(&M::LAYOUT, &at.q, &at.v.scaled(h), &mut q);
    (at.time + h, q)
}

/// The derivative at zero, as by [`derivative_over`] a thousandth.
fn derivative(f: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    derivative_over(1e-3, f)
}

/// The derivative at zero by central differences over `h`, extrapolated (Richardson) to the fourth order.
pub fn derivative_over(h: f64, f: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let slope = |h: f64| -> Vec<f64> {
        f(h).iter().zip(f(-h)).map(|(ahead, behind)| (ahead - behind) / (2.0 * h)).collect()
    };
    slope(h).iter().zip(slope(h / 2.0)).map(|(coarse, fine)| (4.0 * fine - coarse) / 3.0).collect()
}

/// D v from the stored entries; magnitudes Σ |d v| with `absolute`.
pub fn product<M: Model>(jacobian: &M::Jacobian, v: &M::V, absolute: bool) -> Vec<f64> {
    let mut product = vec![0.0; M::ROWS.len()];
    for (&(row, column), d) in M::JACOBIAN_PATTERN.iter().zip(jacobian.as_slice()) {
        let term = d * v.as_slice()[column as usize];
        product[row as usize] += if absolute { term.abs() } else { term };
    }
    product
}

/// D v − ν, and the magnitude of its terms.
pub fn row_rates<M: Model>(model: &M, time: f64, q: &M::Q, v: &M::V) -> (Vec<f64>, Vec<f64>) {
    let (mut jacobian, mut nu) = (M::Jacobian::zero(), M::Lambda::zero());
    model.constraint_jacobian(time, q, &mut jacobian);
    model.nu(time, q, &mut nu);
    let rates = product::<M>(&jacobian, v, false);
    let magnitudes = product::<M>(&jacobian, v, true);
    let nu = nu.as_slice();
    (
        rates.iter().zip(nu).map(|(rate, nu)| rate - nu).collect(),
        magnitudes.iter().zip(nu).map(|(magnitude, nu)| magnitude + nu.abs()).collect(),
    )
}

/// dΦ(t + h, q ⊕ h v)/dh = D v − ν.
fn jacobian_is_the_derivative<M: Model>() {
    for (model, at) in points::<M>(10) {
        let phi = |h: f64| {
            let (time, q) = along(&at, h);
            let mut phi = M::Lambda::zero();
            model.constraints(time, &q, &mut phi);
            phi.as_slice().to_vec()
        };
        let (rates, magnitudes) = row_rates(&model, at.time, &at.q, &at.v);
        let differences = derivative(phi);
        for (row, name) in M::ROWS.iter().enumerate() {
            let (rate, difference) = (rates[row], differences[row]);
            let tolerance = 2e-8 * (1.0 + magnitudes[row]);
            assert!(
                (rate - difference).abs() <= tolerance,
                "{} {name}: D v − ν {rate}, dΦ {difference}",
                M::NAME
            );
        }
    }
}

/// d(D v − ν)/dh = −γ at v̇ = 0.
fn gamma_is_the_derivative<M: Model>() {
    for (model, at) in points::<M>(11) {
        let rates = |h: f64| {
            let (time, q) = along(&at, h);
            row_rates(&model, time, &q, &at.v).0
        };
        let mut gamma = M::Lambda::zero();
        model.gamma(at.time, &at.q, &at.v, &mut gamma);
        let (_, magnitudes) = row_rates(&model, at.time, &at.q, &at.v);
        let differences = derivative(rates);
        for (row, name) in M::ROWS.iter().enumerate() {
            let (gamma, difference) = (gamma.as_slice()[row], -differences[row]);
            let tolerance = 1e-7 * (1.0 + magnitudes[row] + gamma.abs());
            assert!((gamma - difference).abs() <= tolerance, "{} {name}: γ {gamma}, {difference}", M::NAME);
        }
    }
}

/// dc/dh = J v + drift and d(dc/dh)/dh = bias for every condition's coordinate c.
fn conditions_have_their_rates<M: Model>() {
    for (model, at) in points::<M>(12) {
        // The angle from its value at h = 0 on, so that no whole turn comes between.
        let value = |h: f64, target: &M::Conditions| -> Vec<f64> {
            let (time, q) = along(&at, h);
            let (mut residual, mut upright) = (M::Conditions::zero(), M::Conditions::zero());
            model.condition_residual(time, &q, target, &mut residual);
            model.condition_cosines(time, &q, target, &mut upright);
            let both = residual.as_slice().iter().zip(upright.as_slice()).zip(M::CONDITIONS);
            both.map(|((residual, upright), condition)| match condition.kind {
                ConditionKind::Angle => residual.atan2(*upright),
                ConditionKind::Linear => *residual,
            })
            .collect()
        };
        let rate = |h: f64| -> Vec<f64> {
            let (time, q) = along(&at, h);
            let (mut jacobian, mut drift) = (M::ConditionJacobian::zero(), M::Conditions::zero());
            model.condition_jacobian(time, &q, &mut jacobian);
            model.condition_drift(time, &q, &mut drift);
            let mut rates = drift.as_slice().to_vec();
            for (&(row, column), j) in M::CONDITION_PATTERN.iter().zip(jacobian.as_slice()) {
                rates[row as usize] += j * at.v.as_slice()[column as usize];
            }
            rates
        };
        let here: M::Conditions = vector(&value(0.0, &M::Conditions::zero()));
        let (rates, slopes) = (rate(0.0), derivative(|h| value(h, &here)));
        let (mut bias, second) = (M::Conditions::zero(), derivative(rate));
        model.condition_bias(at.time, &at.q, &at.v, &mut bias);
        for (index, condition) in M::CONDITIONS.iter().enumerate() {
            let (rate, slope) = (rates[index], slopes[index]);
            let of = condition.of;
            assert!(
                (rate - slope).abs() <= 2e-7 * (1.0 + rate.abs()),
                "{} {of}: rate {rate} {slope}",
                M::NAME
            );
            let (bias, second) = (bias.as_slice()[index], second[index]);
            assert!(
                (bias - second).abs() <= 2e-6 * (1.0 + bias.abs()),
                "{} {of}: bias {bias} {second}",
                M::NAME
            );
        }
    }
}

/// vᵀ M v is the part of 2 T that is quadratic in v, T is never negative, and M has no negative pivot.
fn mass_belongs_to_the_energy<M: Model>() {
    for (model, at) in points::<M>(13) {
        let n = M::VELOCITY_NAMES.len();
        let mut stored = M::Mass::zero();
        model.mass_matrix(at.time, &at.q, &mut stored);
        let mut mass = vec![vec![0.0; n]; n];
        for (&(row, column), entry) in M::MASS_PATTERN.iter().zip(stored.as_slice()) {
            assert!(row >= column, "{}: the lower triangle is stored", M::NAME);
            mass[row as usize][column as usize] = *entry;
            mass[column as usize][row as usize] = *entry;
        }
        let v = at.v.as_slice();
        let quadratic: f64 =
            (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).map(|(i, j)| v[i] * mass[i][j] * v[j]).sum();
        let energy = |factor: f64| model.kinetic_energy(at.time, &at.q, &at.v.scaled(factor));
        // The supports' own motion adds terms that are linear and constant in v.
        let (ahead, behind, still) = (energy(1.0), energy(-1.0), energy(0.0));
        let expected = ahead + behind - 2.0 * still;
        let scale = ahead.abs() + behind.abs() + still.abs();
        assert!((quadratic - expected).abs() <= 1e-12 * scale, "{}: {quadratic} {expected}", M::NAME);
        assert!(ahead >= 0.0 && still >= 0.0, "{}: T = {ahead}, {still}", M::NAME);

        for k in 0..n {
            let pivot = mass[k].clone();
            assert!(pivot[k] >= -1e-14, "{}: pivot {} at {}", M::NAME, pivot[k], M::VELOCITY_NAMES[k]);
            if pivot[k] <= 1e-14 {
                continue;
            }
            for row in &mut mass[k + 1..] {
                let factor = row[k] / pivot[k];
                row.iter_mut().zip(&pivot).for_each(|(entry, above)| *entry -= factor * above);
            }
        }
    }
}

/// The reported velocities and accelerations of bodies are the derivatives of their positions, for any v̇.
fn bodies_move_as_reported<M: Model>() {
    let mut random = Random::new(14);
    for (model, at) in points::<M>(14) {
        let a: M::V = vector(&random.vector(M::VELOCITY_NAMES.len()));
        // Per body x, y, c, s, ẋ, ẏ, ω, ẍ, ÿ, ω̇, along v(h) = v + h v̇.
        let reported = |h: f64| {
            let (mut q, v) = (at.q, at.v.plus(h, &a));
            retract(&M::LAYOUT, &at.q, &at.v.scaled(h).plus(h * h / 2.0, &a), &mut q);
            model.flat_motions(at.time + h, &q, &v, &a)
        };
        let (here, slopes) = (reported(0.0), derivative(reported));
        for (body, slope) in here.chunks(10).zip(slopes.chunks(10)) {
            let [c, s, rate] = [body[2], body[3], body[6]];
            assert!((c * c + s * s - 1.0).abs() < 1e-14, "{}: orientation ({c}, {s})", M::NAME);
            let pairs = [
                (slope[0], body[4]),
                (slope[1], body[5]),
                (slope[2], -s * rate),
                (slope[3], c * rate),
                (slope[4], body[7]),
                (slope[5], body[8]),
                (slope[6], body[9]),
            ];
            for (index, (slope, value)) in pairs.into_iter().enumerate() {
                let tolerance = 1e-7 * (1.0 + value.abs());
                assert!((slope - value).abs() <= tolerance, "{} [{index}]: {slope} {value}", M::NAME);
            }
        }
    }
}
