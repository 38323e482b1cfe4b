//! Joints on curves: those that are no graphs carry a body, and stand where their curve has a direction.

use super::assemble::{Ancestry, Assembly, Point};
use super::messages;
use crate::diagnostics::Diagnostics;
use crate::equations::{Equations, Laws, SpanningTree, plane};
use crate::model::{JointId, Mechanism};
use crate::symbolic::Node;

/// Of |c′|, which is about 1: what is taken for zero.
const STANDS: f64 = 1e-6;

/// A curve that is no graph is where a body hangs, as its parameter is a coordinate.
pub fn curves(mechanism: &Mechanism, tree: &SpanningTree) -> Result<(), Diagnostics> {
    let mut errors = Diagnostics::new();
    let carrying = tree.carrying(mechanism);
    for (joint, _) in
        mechanism.joints.iter().zip(carrying).filter(|(joint, carries)| joint.must_carry() && !carries)
    {
        errors.error(joint.name.span, messages::curve_closes_a_loop(&joint.name.text));
    }
    errors.finish(())
}

/// Where their parameters start, the functions of curves are numbers, and so are their first two derivatives, by which points on them
/// have velocities and accelerations.
pub(super) fn numbers(
    mechanism: &Mechanism,
    equations: &Equations,
    q: &[f64],
    errors: &mut Diagnostics,
) -> Option<()> {
    const WHAT: [&str; 3] = ["value", "slope", "curvature"];
    let curves: Vec<usize> =
        (0..mechanism.joints.len()).filter(|at| mechanism.joints[*at].functions().is_some()).collect();
    if curves.is_empty() {
        return Some(());
    }
    // What is only asked here shall be on no graph that is written out.
    let equations = equations.clone();
    let (g, symbols) = (equations.graph.sheet(), &equations.symbols);
    let laws = Laws::moving(g, mechanism, symbols, &equations.layout, &equations.kinematics);
    let mut point = Point::at_defaults(mechanism, &equations, &[]);
    point.set_q(q);
    for index in curves {
        let (parameter, axes) = plane::joints::derivatives_of_curve(&laws, JointId(index));
        point.evaluate(&Ancestry::of(&equations, axes.iter().flatten().copied().chain([parameter])));
        let missing = |of: &[Node; 3]| of.iter().position(|node| !point.get(*node).is_finite());
        let name = &mechanism.joints[index].name;
        for (axis, of) in ["x", "y"].into_iter().zip(&axes) {
            if let Some(order) = missing(of) {
                let message = messages::curve_without(&name.text, axis, WHAT[order], point.get(parameter));
                errors.error(name.span, message);
            }
        }
    }
    errors.is_empty().then_some(())
}

/// At the start no curve that is no graph stands still with its parameter.
pub fn standing(mechanism: &Mechanism, equations: &Equations, assembly: &Assembly, errors: &mut Diagnostics) {
    let (g, symbols) = (equations.graph.sheet(), &equations.symbols);
    let laws = Laws::moving(g, mechanism, symbols, &equations.layout, &equations.kinematics);
    for (index, joint) in mechanism.joints.iter().enumerate().filter(|(_, joint)| joint.must_carry()) {
        let (tangent, parameter) = plane::joints::tangent_of_curve(&laws, JointId(index));
        let mut point = Point::at_start(mechanism, equations, assembly);
        point.evaluate(&Ancestry::of(equations, tangent.into_iter().chain([parameter])));
        let [x, y] = tangent.map(|node| point.get(node));
        let moves = x.abs() > STANDS || y.abs() > STANDS;
        if !moves {
            errors.error(joint.name.span, messages::curve_stands(&joint.name.text, point.get(parameter)));
        }
    }
}
