//! Joints that yield: none is cut, and how fast they let the mechanism vibrate.

use super::assemble::{Ancestry, Assembly, Point};
use crate::diagnostics::Diagnostics;
use crate::equations::{Equations, Jet, Laws, penalties};
use crate::messages;
use crate::model::Mechanism;
use crate::numbers::significant;
use crate::solve::table::{Numeric, Table};
use std::fmt;

// A joint that yields is not cut.
pub fn what_yields_is_not_cut(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for (joint, span) in &mechanism.options.cut {
        let joint = &mechanism.joints[joint.0];
        if !joint.holds() {
            diagnostics.error(*span, messages::cut_of_what_yields(&joint.name.text));
        }
    }
}

/// The fastest vibration that joints which yield make at the start, with nothing but their penalties acting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vibration {
    /// ω, rad/s.
    pub rate: f64,
    /// ζ, of critical damping.
    pub damping: f64,
}

impl Vibration {
    /// The largest step of the explicit trapezoidal rule, s: 2 (√(1 + ζ²) − ζ)/ω (`ExplicitTrapezoidal` of the runtime).
    pub fn longest_step(&self) -> f64 {
        2.0 * (libm::sqrt(1.0 + self.damping * self.damping) - self.damping) / self.rate
    }
}

impl fmt::Display for Vibration {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (rate, damping) = (significant(self.rate, 3), significant(self.damping, 2));
        let step = significant(self.longest_step(), 2);
        write!(
            f,
            "the fastest vibration has {rate} rad/s and {damping} of critical damping, so steps of explicit methods below {step} s"
        )
    }
}

/// Iterations; ω is then too small by parts in a thousand at most where several vibrations are about as fast.
const PASSES: usize = 200;

/// The largest ω² of K x = ω² M x on the velocities that constraints admit, K = Σ k J_Φᵀ J_Φ, by vector iteration with
/// [M Dᵀ; D 0]⁻¹ K; ζ by C = Σ c J_Φᵀ J_Φ.
pub fn vibration(mechanism: &Mechanism, equations: &Equations, assembly: &Assembly) -> Option<Vibration> {
    let g = equations.graph.sheet();
    let laws = Laws::moving(g, mechanism, &equations.symbols, &equations.layout, &equations.kinematics);
    let yielding = penalties(&laws);
    if yielding.is_empty() {
        return None;
    }
    let rows = equations.rows.iter().map(|row| &row.jet);
    let jets: Vec<&Jet> = rows.chain(yielding.iter().map(|it| &it.row.jet)).collect();
    let mut point = Point::at_start(mechanism, equations, assembly);
    point.evaluate(&Ancestry::of_jets(equations, jets.iter().copied()));
    point.evaluate(&Ancestry::of(equations, equations.mass.values().copied()));
    let coefficients = yielding.iter().flat_map(|it| [it.stiffness.bare, it.damping.bare]);
    point.evaluate(&Ancestry::of(equations, coefficients));
    let columns = |jet: &Jet| -> Vec<(usize, f64)> {
        jet.columns.iter().map(|(index, column)| (*index, point.get(*column))).collect()
    };
    let columns: Vec<_> = jets.iter().map(|jet| columns(jet)).collect();
    let (rows, ways) = columns.split_at(equations.rows.len());

    let n = equations.layout.velocities();
    let mut structure: Vec<(usize, usize)> = equations.mass.keys().copied().collect();
    let mut entries: Vec<_> =
        equations.mass.iter().map(|((i, j), node)| (*i, *j, point.get(*node))).collect();
    for (at, row) in rows.iter().enumerate() {
        structure.extend(row.iter().map(|(column, _)| (n + at, *column)));
        entries.extend(row.iter().map(|(column, value)| (n + at, *column, *value)));
    }
    let table = Table::new(n, rows.len(), structure);
    let factor = Numeric::factor(&table, entries);

    // Σ s J (J·x), and x·Σ s J (J·x).
    let scale = |damping: bool| -> Vec<f64> {
        let node = yielding.iter().map(|it| if damping { it.damping.bare } else { it.stiffness.bare });
        node.map(|node| point.get(node)).collect()
    };
    let (stiffness, damping) = (scale(false), scale(true));
    let along =
        |way: &[(usize, f64)], x: &[f64]| way.iter().map(|(index, value)| value * x[*index]).sum::<f64>();
    let square =
        |s: &[f64], x: &[f64]| -> f64 { ways.iter().zip(s).map(|(way, s)| s * along(way, x).powi(2)).sum() };
    let mut x: Vec<f64> = (0..n).map(|k| libm::sin((3 * k + 2) as f64)).collect();
    let mut faster = 0.0;
    for _ in 0..PASSES {
        let mut force = vec![0.0; n + rows.len()];
        for (way, k) in ways.iter().zip(&stiffness) {
            let effort = k * along(way, &x);
            way.iter().for_each(|(index, value)| force[*index] += value * effort);
        }
        let energy = square(&stiffness, &x);
        let next = factor.solve(&force)[..n].to_vec();
        let work: f64 = next.iter().zip(&force).map(|(x, force)| x * force).sum();
        let size = next.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        // Nothing of it moves, or M is singular.
        if !(energy > 0.0 && size > 0.0 && size.is_finite()) {
            return None;
        }
        faster = work / energy;
        x = next.into_iter().map(|x| x / size).collect();
    }
    let rate = libm::sqrt(faster);
    // ζ = xᵀ C x/(2 ω xᵀ M x) with xᵀ M x = xᵀ K x/ω².
    let damping = rate * square(&damping, &x) / (2.0 * square(&stiffness, &x));
    (rate > 0.0).then_some(Vibration { rate, damping })
}
