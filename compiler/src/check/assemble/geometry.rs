//! Why joints in space repeat each other: what is special about the axes of a loop.

use super::messages::list;
use super::point::Point;
use super::world::{Vec3, World, cross, dot, length, sub};
use crate::equations::space::constant_axis;
use crate::model::{JointId, Mechanism, Space};
use std::collections::BTreeSet;

/// A joint that turns about one axis, or slides along it, in the world.
struct Axis {
    name: String,
    slides: bool,
    through: Vec3,
    along: Vec3,
}

/// Sines, and distances by the largest of them, below this are zero.
const NONE: f64 = 1e-7;

/// The reasons why the loops that redundant rows close are special: a property that their axes share, or nothing so
/// simple.
pub fn reasons(mechanism: &Mechanism, point: &mut Point, q: &[f64], rows: &[usize]) -> Vec<String> {
    if mechanism.space != Space::Spatial || rows.is_empty() {
        return Vec::new();
    }
    let equations = point.equations;
    let world = World::at(mechanism, point, q);
    let cut: BTreeSet<JointId> = rows.iter().filter_map(|row| equations.rows[*row].joint()).collect();
    let of_loop = |joint: JointId| {
        let mut around = equations.tree.around(mechanism, joint);
        around.sort_unstable();
        let names = around.iter().map(|joint| mechanism.joints[joint.0].name.text.clone());
        let axes: Option<Vec<Axis>> = around.iter().map(|joint| axis(mechanism, &world, *joint)).collect();
        special(&list(&names.collect::<Vec<_>>()), axes.as_deref().unwrap_or_default())
    };
    cut.into_iter().map(of_loop).collect()
}

fn special(joints: &str, axes: &[Axis]) -> String {
    let (slides, turns): (Vec<&Axis>, Vec<&Axis>) = axes.iter().partition(|axis| axis.slides);
    if let (true, Some([one, other])) = (slides.is_empty(), directions(&turns)) {
        return format!("the axes of {one} are parallel, and so are those of {other}");
    }
    match turns.first() {
        Some(first) if turns.iter().all(|axis| parallel(first, axis)) => {
            if slides.is_empty() {
                return format!("the axes of {joints} are parallel, so that the loop moves in a plane");
            }
            if slides.iter().all(|slide| dot(first.along, slide.along).abs() < NONE) {
                return format!(
                    "{joints} turn about parallel axes and slide across them, so that the loop moves in a plane"
                );
            }
        }
        Some(_) if slides.is_empty() && meet(axes) => {
            return format!("the axes of {joints} meet in one point, so that the loop moves on a sphere");
        }
        _ => {}
    }
    format!("the loop of {joints} moves only where its joints have just these places and directions")
}

/// The joints of two directions, where there are no others and no joint is the only one of its direction.
fn directions(turns: &[&Axis]) -> Option<[String; 2]> {
    let first = turns.first()?;
    let (one, others): (Vec<&Axis>, Vec<&Axis>) = turns.iter().partition(|axis| parallel(first, axis));
    let second = others.first()?;
    let names = |axes: &[&Axis]| list(&axes.iter().map(|axis| axis.name.clone()).collect::<Vec<_>>());
    let two = one.len() > 1 && others.len() > 1 && others.iter().all(|axis| parallel(second, axis));
    two.then(|| [names(&one), names(&others)])
}

fn parallel(a: &Axis, b: &Axis) -> bool {
    length(cross(a.along, b.along)) < NONE
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
    let form = definition.form;
    let slides = form.keeps_orientation;
    if form.freedoms != 1 || !(slides || form.keeps_place) {
        return None;
    }
    let along = constant_axis(mechanism, definition, &definition.first)?;
    let along = world.turned(definition.first.frame, along);
    Some(Axis { name: definition.name.text.clone(), slides, through: world.place(&definition.first)?, along })
}
