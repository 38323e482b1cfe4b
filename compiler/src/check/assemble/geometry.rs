//! Why joints in space repeat each other: what is special about the axes of a loop.

use super::point::Point;
use super::world::{Vec3, World, cross, dot, length, sub};
use crate::equations::space::constant_axis;
use crate::model::{JointId, JointKind, Mechanism, Space};
use std::collections::BTreeSet;

/// A joint that turns about one axis, in the world.
struct Axis {
    joint: JointId,
    through: Vec3,
    along: Vec3,
}

/// Sines, and distances by the largest of them, below this are zero.
const NONE: f64 = 1e-7;

/// One sentence for each loop that redundant rows close, where its axes have something in common.
pub fn reasons(mechanism: &Mechanism, point: &mut Point, q: &[f64], rows: &[usize]) -> Vec<String> {
    if mechanism.space != Space::Spatial || rows.is_empty() {
        return Vec::new();
    }
    let equations = point.equations;
    let world = World::at(mechanism, point, q);
    let cut: BTreeSet<JointId> = rows.iter().filter_map(|row| equations.rows[*row].joint).collect();
    cut.into_iter()
        .filter_map(|joint| {
            let mut around = equations.tree.around(mechanism, joint);
            around.sort_unstable();
            of_loop(mechanism, &world, &around)
        })
        .collect()
}

fn of_loop(mechanism: &Mechanism, world: &World, around: &[JointId]) -> Option<String> {
    let axes: Option<Vec<Axis>> = around.iter().map(|joint| axis(mechanism, world, *joint)).collect();
    let axes = axes?;
    let names: Vec<&str> =
        axes.iter().map(|axis| mechanism.joints[axis.joint.0].name.text.as_str()).collect();
    let (last, others) = names.split_last()?;
    let names = format!("{} and {last}", others.join(", "));
    let first = axes.first()?;
    if axes.iter().all(|axis| length(cross(first.along, axis.along)) < NONE) {
        return Some(format!("the axes of {names} are parallel, so that the loop moves in a plane"));
    }
    meet(&axes).then(|| format!("the axes of {names} meet in one point, so that the loop moves on a sphere"))
}

/// Whether all lines go through one point.
fn meet(axes: &[Axis]) -> bool {
    let Some(other) = axes.iter().find(|axis| length(cross(axes[0].along, axis.along)) > NONE) else {
        return false;
    };
    // The point of the first line that is nearest to the other.
    let (a, b) = (&axes[0], other);
    let normal = cross(a.along, b.along);
    let between = sub(b.through, a.through);
    let along = dot(cross(between, b.along), normal) / dot(normal, normal);
    let point = [0, 1, 2].map(|k| a.through[k] + along * a.along[k]);
    let size = axes.iter().map(|axis| length(sub(axis.through, point))).fold(f64::MIN_POSITIVE, f64::max);
    axes.iter().all(|axis| length(cross(sub(axis.through, point), axis.along)) < NONE * size)
}

fn axis(mechanism: &Mechanism, world: &World, joint: JointId) -> Option<Axis> {
    let definition = &mechanism.joints[joint.0];
    if !matches!(definition.kind, JointKind::Revolute { .. }) {
        return None;
    }
    let along = constant_axis(mechanism, definition, &definition.first)?;
    let along = world.turned(definition.first.frame, along);
    Some(Axis { joint, through: world.place(&definition.first)?, along })
}
