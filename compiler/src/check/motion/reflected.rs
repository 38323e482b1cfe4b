//! Inertia and loads as they are felt at one joint: of a mechanism with one degree of freedom.
//!
//! With the velocities t of the motion, J = tᵀ M t/ẋ² is the inertia that a drive at the coordinate x turns or moves, and F = tᵀ Q/ẋ what
//! gravity and loads at rest exert along it: J = Σ J_k (∂θ_k/∂θ)² of a gear train (Norton, Design of Machinery, 10.11).

use super::path::Path;
use super::{of_joints, start, watched};
use crate::check::assemble::{Ancestry, Assembly, Point, pins};
use crate::equations::Equations;
use crate::model::{Mechanism, Space};

/// Below this part of the fastest a coordinate stands still at the start, and nothing is felt there.
const STILL: f64 = 1e-9;

/// What is felt along a coordinate at the start.
#[derive(Clone, Debug)]
pub struct Reflected {
    /// `crank_pin.angle`.
    pub of: String,
    pub angular: bool,
    /// kg m² or kg.
    pub inertia: f64,
    /// Of gravity and loads at rest, inputs zero; N m or N.
    pub load: f64,
}

/// Of all angles and travels of joints that move; none where the motion has not one freedom.
pub fn reflected(mechanism: &Mechanism, equations: &Equations, assembly: &Assembly) -> Vec<Reflected> {
    if assembly.mobility.generic != 1 {
        return Vec::new();
    }
    let (watched, reference) = watched(mechanism, equations, assembly, &of_joints(mechanism));
    let q = assembly.q.as_slice();
    let mut point = Point::at_start(mechanism, equations, assembly);
    let length = match mechanism.space {
        Space::Planar => pins::longest_link(&pins::pins(mechanism, &mut point, q)),
        Space::Spatial => 1.0,
    };
    let mut path = Path::new(mechanism, equations, &assembly.phases, watched.clone(), length, q);
    let Some(place) = start(&mut path, equations, q, reference) else { return Vec::new() };
    point.set_q(&place.q);
    point.set_v(&vec![0.0; place.tangent.len()]);
    let nodes = equations.mass.values().chain(&equations.forces).copied();
    point.evaluate(&Ancestry::of(equations, nodes));
    let t = &place.tangent;
    let inertia: f64 = equations
        .mass
        .iter()
        .map(|((row, column), node)| {
            let twice = if row == column { 1.0 } else { 2.0 };
            twice * point.get(*node) * t[*row] * t[*column]
        })
        .sum();
    let load: f64 = equations.forces.iter().zip(t).map(|(node, t)| point.get(*node) * t).sum();
    let fastest = place.rates.iter().fold(0.0_f64, |most, rate| most.max(rate.abs()));
    let felt = watched.iter().zip(&place.rates).filter(|(_, rate)| rate.abs() > STILL * fastest);
    felt.map(|(condition, rate)| Reflected {
        of: condition.of.clone(),
        angular: condition.angular,
        inertia: inertia / (rate * rate),
        load: load / rate,
    })
    .filter(|reflected| reflected.inertia.is_finite() && reflected.load.is_finite())
    .collect()
}
