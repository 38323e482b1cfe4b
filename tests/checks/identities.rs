//! What must hold of any model at any state, by differences along its own motion: D is the derivative of Φ, γ that of
//! D v − ν, conditions have their rates, M belongs to the kinetic energy.
//!
//! Nothing here knows the mechanisms; positions and velocities are random and fulfil no constraint, unless something has no
//! meaning without. What needs consistent states is `balances.rs`.

use crate::registry::{At, Model, Random, compiled, for_each, vector};
use crate::walking::walk;
use linkwright::{Condition, ConditionKind, Vector, retract};
use linkwright_compiler::model::Space;

const POINTS: usize = 10;

for_each!(jacobian_is_the_derivative);
for_each!(gamma_is_the_derivative);
for_each!(conditions_have_their_rates);
for_each!(mass_belongs_to_the_energy);
for_each!(inverse_dynamics_is_what_motion_asks);
for_each!(bodies_move_as_reported);

/// Random states, and a model with random parameters for each.
fn points<M: Model>(seed: u64) -> impl Iterator<Item = (M, At<M>)> {
    let model = M::standard();
    let compiled = compiled::<M>(None);
    let mut random = Random::new(seed);
    (0..POINTS).map(move |_| {
        let mut point = random.point(&compiled);
        point.q = random.position(model.layout());
        (M::prepared(&point.parameters).expect("parameters near their defaults"), At::of(&point))
    })
}

/// (t + h, q ⊕ h v).
fn along<M: Model>(at: &At<M>, h: f64) -> (f64, M::Q) {
    let model = M::standard();
    let mut q = at.q;
    retract(model.layout(), &at.q, &at.v.scaled(h), &mut q);
    (at.time + h, q)
}

/// The derivative at zero, as by [`derivative_over`] a thousandth.
fn derivative(f: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    derivative_over(1e-3, f)
}

/// The derivative at zero by central differences over `h`, extrapolated (Richardson) to the fourth order.
pub fn derivative_over(h: f64, f: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    // Once for all functions: there are thousands, each of one mechanism.
    by_differences(h, &f)
}

fn by_differences(h: f64, f: &dyn Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let slope = |h: f64| -> Vec<f64> {
        f(h).iter().zip(f(-h)).map(|(ahead, behind)| (ahead - behind) / (2.0 * h)).collect()
    };
    slope(h).iter().zip(slope(h / 2.0)).map(|(coarse, fine)| (4.0 * fine - coarse) / 3.0).collect()
}

/// D v from the stored entries; magnitudes Σ |d v| with `absolute`.
pub fn product<M: Model>(jacobian: &M::Jacobian, v: &M::V, absolute: bool) -> Vec<f64> {
    let model = M::standard();
    let mut product = vec![0.0; model.rows().len()];
    for (&(row, column), d) in model.jacobian_pattern().iter().zip(jacobian.as_slice()) {
        let term = d * v.as_slice()[column as usize];
        product[row as usize] += if absolute { term.abs() } else { term };
    }
    product
}

/// D v − ν, and the magnitude of its terms.
pub fn row_rates<M: Model>(model: &M, time: f64, q: &M::Q, v: &M::V) -> (Vec<f64>, Vec<f64>) {
    let (mut jacobian, mut nu) = (model.zero_jacobian(), model.zero_lambda());
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
            let mut phi = model.zero_lambda();
            model.constraints(time, &q, &mut phi);
            phi.as_slice().to_vec()
        };
        let (rates, magnitudes) = row_rates(&model, at.time, &at.q, &at.v);
        let differences = derivative(phi);
        for (row, name) in model.rows().iter().enumerate() {
            let (rate, difference) = (rates[row], differences[row]);
            let tolerance = 2e-8 * (1.0 + magnitudes[row]);
            assert!(
                (rate - difference).abs() <= tolerance,
                "{} {name}: D v − ν {rate}, dΦ {difference}",
                model.name()
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
        let mut gamma = model.zero_lambda();
        model.gamma(at.time, &at.q, &at.v, &mut gamma);
        let (_, magnitudes) = row_rates(&model, at.time, &at.q, &at.v);
        let differences = derivative(rates);
        for (row, name) in model.rows().iter().enumerate() {
            let (gamma, difference) = (gamma.as_slice()[row], -differences[row]);
            let tolerance = 1e-7 * (1.0 + magnitudes[row] + gamma.abs());
            assert!(
                (gamma - difference).abs() <= tolerance,
                "{} {name}: γ {gamma}, {difference}",
                model.name()
            );
        }
    }
}

/// dc/dh = J v + drift and d(dc/dh)/dh = bias for every condition's coordinate c; of a rate without a coordinate J v is ω
/// of its body, as reported, in place of the first.
///
/// A joint in space that carries no body has an angle only where its axes are parallel: elsewhere its rate is z₂·ω₂ − z₁·ω₁,
/// and the derivative of nothing. There the first is compared at consistent states.
fn conditions_have_their_rates<M: Model>() {
    let (compiled, _, model, states) = walk::<M>(12, POINTS);
    let mechanism = &compiled.mechanism;
    let carrying = compiled.complete.equations.tree.carrying(mechanism);
    let cut = mechanism.joints.iter().zip(carrying).filter(|(_, carrying)| !carrying);
    let cut: Vec<&str> = match mechanism.space {
        Space::Planar => Vec::new(),
        Space::Spatial => cut.map(|(joint, _)| joint.name.text.as_str()).collect(),
    };
    let is_open = |of: &str| of.split_once('.').is_some_and(|(joint, _)| cut.contains(&joint));
    for at in &states {
        conditions_have_their_rates_at(&model, at, &|_| true);
    }
    for (model, at) in points::<M>(12) {
        conditions_have_their_rates_at(&model, &at, &|condition| {
            condition.kind != ConditionKind::Angle || !is_open(condition.of)
        });
    }
}

fn conditions_have_their_rates_at<M: Model>(model: &M, at: &At<M>, has_value: &dyn Fn(&Condition) -> bool) {
    // The angle from its value at h = 0 on, so that no whole turn comes between.
    let value = |h: f64, target: &M::Conditions| -> Vec<f64> {
        let (time, q) = along(at, h);
        let (mut residual, mut upright) = (model.zero_conditions(), model.zero_conditions());
        model.condition_residual(time, &q, target, &mut residual);
        model.condition_cosines(time, &q, target, &mut upright);
        let both = residual.as_slice().iter().zip(upright.as_slice()).zip(model.conditions());
        both.map(|((residual, upright), condition)| match condition.kind {
            ConditionKind::Angle => residual.atan2(*upright),
            ConditionKind::Linear => *residual,
            // A rate without a coordinate has no value.
            ConditionKind::Rate => 0.0,
        })
        .collect()
    };
    let rate = |h: f64| -> Vec<f64> {
        let (time, q) = along(at, h);
        let (mut jacobian, mut drift) = (model.zero_condition_jacobian(), model.zero_conditions());
        model.condition_jacobian(time, &q, &mut jacobian);
        model.condition_drift(time, &q, &mut drift);
        let mut rates = drift.as_slice().to_vec();
        for (&(row, column), j) in model.condition_pattern().iter().zip(jacobian.as_slice()) {
            rates[row as usize] += j * at.v.as_slice()[column as usize];
        }
        rates
    };
    let here: M::Conditions = vector(&value(0.0, &model.zero_conditions()));
    let (rates, slopes) = (rate(0.0), derivative(|h| value(h, &here)));
    let (mut bias, second) = (model.zero_conditions(), derivative(rate));
    model.condition_bias(at.time, &at.q, &at.v, &mut bias);
    let motions = model.flat_motions(at.time, &at.q, &at.v, &model.zero_v());
    for (index, condition) in model.conditions().iter().enumerate() {
        let (of, rate) = (condition.of, rates[index]);
        let slope = match condition.kind {
            ConditionKind::Rate => reported_rate::<M>(of, &motions),
            ConditionKind::Angle | ConditionKind::Linear => slopes[index],
        };
        let off = if has_value(condition) { (rate - slope).abs() } else { 0.0 };
        assert!(off <= 1e-6 * (1.0 + rate.abs()), "{} {of}: rate {rate} {slope}", model.name());
        let (bias, second) = (bias.as_slice()[index], second[index]);
        assert!(
            (bias - second).abs() <= 2e-6 * (1.0 + bias.abs()),
            "{} {of}: bias {bias} {second}",
            model.name()
        );
    }
}

/// The component of ω that `of` names, `nut.rate.x`, in what the bodies do.
fn reported_rate<M: Model>(of: &str, motions: &[f64]) -> f64 {
    let model = M::standard();
    let (body, axis) = of.split_once(".rate.").expect("only ω has no coordinate");
    let body = model.bodies().iter().position(|known| *known == body).expect("a body's");
    let axis = ["x", "y", "z"].iter().position(|known| *known == axis).expect("an axis");
    motions[motions.len() / model.bodies().len() * body + 15 + axis]
}

/// vᵀ M v is the part of 2 T that is quadratic in v, T is never negative, and M has no negative pivot.
fn mass_belongs_to_the_energy<M: Model>() {
    for (model, at) in points::<M>(13) {
        let n = model.velocity_names().len();
        let mut stored = model.zero_mass();
        model.mass_matrix(at.time, &at.q, &mut stored);
        let mut mass = vec![vec![0.0; n]; n];
        for (&(row, column), entry) in model.mass_pattern().iter().zip(stored.as_slice()) {
            assert!(row >= column, "{}: the lower triangle is stored", model.name());
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
        assert!((quadratic - expected).abs() <= 1e-12 * scale, "{}: {quadratic} {expected}", model.name());
        assert!(ahead >= 0.0 && still >= 0.0, "{}: T = {ahead}, {still}", model.name());

        for k in 0..n {
            let pivot = mass[k].clone();
            assert!(
                pivot[k] >= -1e-14,
                "{}: pivot {} at {}",
                model.name(),
                pivot[k],
                model.velocity_names()[k]
            );
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

/// `inverse_dynamics` is M v̇ − Q, for any v̇.
fn inverse_dynamics_is_what_motion_asks<M: Model>() {
    let mut random = Random::new(15);
    for (model, at) in points::<M>(15) {
        let a: M::V = vector(&random.vector(model.velocity_names().len()));
        let (mut stored, mut forces) = (model.zero_mass(), model.zero_v());
        model.mass_matrix(at.time, &at.q, &mut stored);
        model.forces(at.time, &at.state(), &at.u, &mut forces);
        // Where there are rows, what rubs depends on their multipliers.
        if model.rubs() && model.rows().is_empty() {
            let mut friction = model.zero_v();
            model.friction_forces(at.time, &at.state(), &at.u, &a, &model.zero_lambda(), &mut friction);
            forces = forces.plus(1.0, &friction);
        }
        let mut asked: Vec<f64> = forces.as_slice().iter().map(|force| -force).collect();
        let mut largest = forces.max_abs();
        for (&(row, column), entry) in model.mass_pattern().iter().zip(stored.as_slice()) {
            let (row, column) = (row as usize, column as usize);
            asked[row] += entry * a.as_slice()[column];
            if row != column {
                asked[column] += entry * a.as_slice()[row];
            }
            largest = largest.max(entry.abs());
        }
        let found = model.flat_inverse_dynamics(&at, &a);
        assert_eq!(found.len(), asked.len());
        for ((found, asked), name) in found.iter().zip(&asked).zip(model.velocity_names()) {
            assert!((found - asked).abs() <= 1e-12 * largest, "{} {name}: {found} {asked}", model.name());
        }
    }
}

/// The reported velocities and accelerations of bodies are the derivatives of their positions, for any v̇.
fn bodies_move_as_reported<M: Model>() {
    let mut random = Random::new(14);
    for (model, at) in points::<M>(14) {
        let a: M::V = vector(&random.vector(model.velocity_names().len()));
        // Along v(h) = v + h v̇.
        let reported = |h: f64| {
            let (mut q, v) = (at.q, at.v.plus(h, &a));
            retract(model.layout(), &at.q, &at.v.scaled(h).plus(h * h / 2.0, &a), &mut q);
            model.flat_motions(at.time + h, &q, &v, &a)
        };
        let (here, slopes) = (reported(0.0), derivative(reported));
        let size = here.len() / model.bodies().len();
        for (body, slope) in here.chunks(size).zip(slopes.chunks(size)) {
            let off = off_the_group(body);
            assert!(off < 1e-14, "{}: an orientation is off by {off:e}", model.name());
            for (index, value) in slopes_of(body) {
                let (slope, tolerance) = (slope[index], 1e-7 * (1.0 + value.abs()));
                assert!((slope - value).abs() <= tolerance, "{} [{index}]: {slope} {value}", model.name());
            }
        }
    }
}

/// How far the orientation of a body is from a rotation: of c² + s² from 1, of A Aᵀ from 1, of the third row of A from the
/// cross product of the others.
fn off_the_group(body: &[f64]) -> f64 {
    if let [_, _, c, s, _, _, _, _, _, _] = body {
        return (c * c + s * s - 1.0).abs();
    }
    let [x, y, z] = rows_of(body);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
    let lengths = [dot(x, x) - 1.0, dot(y, y) - 1.0, dot(z, z) - 1.0, dot(x, y), dot(y, z), dot(z, x)];
    let handed = [cross[0] - z[0], cross[1] - z[1], cross[2] - z[2]];
    lengths.iter().chain(&handed).fold(0.0, |worst, off| f64::max(worst, off.abs()))
}

/// The rows of A of a body in space.
fn rows_of(body: &[f64]) -> [[f64; 3]; 3] {
    [3, 6, 9].map(|at| [body[at], body[at + 1], body[at + 2]])
}

/// What the time derivatives of a body's position, orientation, velocity and ω are, by its other entries, each with its index.
///
/// In the plane a body has x, y, c, s, ẋ, ẏ, ω, ẍ, ÿ, ω̇; in space r, A row by row, ṙ, ω, r̈, ω̇, with Ȧ = A ω̃.
pub fn slopes_of(body: &[f64]) -> Vec<(usize, f64)> {
    if let [_, _, c, s, vx, vy, rate, ax, ay, angular] = *body {
        let (dc, ds) = (-s * rate, c * rate);
        return vec![(0, vx), (1, vy), (2, dc), (3, ds), (4, ax), (5, ay), (6, angular)];
    }
    assert_eq!(body.len(), 24);
    let [wx, wy, wz] = [body[15], body[16], body[17]];
    let same = |from: usize, to: usize| (0..3).map(move |k| (from + k, body[to + k]));
    let turned = rows_of(body).into_iter().enumerate().flat_map(|(row, [x, y, z])| {
        // A row of A times ω̃ = [0 −ω_z ω_y; ω_z 0 −ω_x; −ω_y ω_x 0].
        let slopes = [y * wz - z * wy, z * wx - x * wz, x * wy - y * wx];
        slopes.into_iter().enumerate().map(move |(column, slope)| (3 + 3 * row + column, slope))
    });
    same(0, 12).chain(turned).chain(same(12, 18)).chain(same(15, 21)).collect()
}
