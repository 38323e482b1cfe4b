//! Cords pull where the mechanism starts.

use super::assemble::{Ancestry, Assembly, Point};
use super::messages;
use crate::diagnostics::Diagnostics;
use crate::equations::{Equations, Laws};
use crate::model::Mechanism;
use crate::solve::Solved;
use crate::symbolic::Node;

/// Of the largest force, what is taken for rounding.
const ROUNDING: f64 = 1e-9;

/// An error for each cord whose tension is below zero at the start, as far as no input decides that.
pub fn cords(
    mechanism: &Mechanism,
    equations: &Equations,
    solved: &Solved,
    assembly: &Assembly,
    errors: &mut Diagnostics,
) {
    let rows = equations.rows.iter().zip(&solved.index1.lambda).filter_map(|(row, lambda)| {
        let joint = &mechanism.joints[row.joint()?.0];
        joint.form.only_pulls.then_some((joint, *lambda))
    });
    let cords: Vec<_> = rows.collect();
    if cords.is_empty() {
        return;
    }
    let mut point = Point::at_start(mechanism, equations, assembly);
    let (g, symbols) = (equations.graph.sheet(), &equations.symbols);
    let laws = Laws::moving(g, mechanism, symbols, &equations.layout, &equations.kinematics);
    let lengths: Vec<Node> = cords.iter().map(|(joint, _)| laws.value(joint.scalar(0)).bare).collect();
    let forces = cords.iter().map(|(_, lambda)| *lambda).chain(lengths.iter().copied());
    point.evaluate(&Ancestry::of(equations, forces.chain(equations.forces.iter().copied())));
    let applied = equations.forces.iter().fold(0.0, |most: f64, force| most.max(point.get(*force).abs()));
    for ((joint, lambda), length) in cords.iter().zip(&lengths) {
        // The row is (Δ·Δ − L²)/2, so that λ is force over length.
        let tension = point.get(*lambda) * point.get(*length);
        if tension < -ROUNDING * applied && !equations.takes_inputs(*lambda) {
            errors.error(joint.name.span, messages::cord_that_pushes(&joint.name.text, tension));
        }
    }
}
