//! Loads, and the pitch circles of gears.

use super::labels::Kind;
use super::{Drawing, JOINTS, LOADS};
use crate::drawing::canvas::{Group, Pen};
use crate::drawing::load::Symbol;
use crate::drawing::shapes::{away, circle, heading};
use crate::drawing::view::{Spot, View};
use crate::equations::loads::LoadKind;
use crate::page::sketch::{Effort, Wheel};

/// What is so near to a line lies on it, px; what lies on one another stands so far apart, units.
const BESIDE: f64 = 12.0;
const ASIDE: f64 = 4.4;

/// A load, so far beside its ends, px.
pub fn effort(drawing: &mut Drawing, kind: &LoadKind, effort: &Effort, aside: f64) {
    let view = drawing.view.clone();
    let mut symbol = Symbol {
        effort,
        view: &view,
        group: Group::new(LOADS, 0.0, effort.name.clone()),
        unit: drawing.unit.max(2.5),
        name: None,
        aside,
    };
    (kind.symbol)(&mut symbol);
    let Symbol { group, name, .. } = symbol;
    drawing.add(group);
    if let Some((anchor, reach)) = name {
        drawing.label(&effort.name, vec![anchor], reach, Kind::Load);
    }
}

/// How far each load is drawn beside its ends, units: those that would lie on one another stand side by side.
pub fn asides(view: &View, efforts: &[(&'static LoadKind, Effort)]) -> Vec<f64> {
    let ends: Vec<Option<[Spot; 2]>> = efforts
        .iter()
        .map(|(_, effort)| match effort.ends[..] {
            [first, second] => Some([first, second].map(|end| view.spot(end.at))),
            _ => None,
        })
        .collect();
    let alike = |one: &Option<[Spot; 2]>, other: &Option<[Spot; 2]>| match (one, other) {
        (Some(one), Some(other)) => runs_along(*one, *other) || runs_along(*other, *one),
        _ => false,
    };
    let side = |index: usize| {
        let own = &ends[index];
        let before = ends[..index].iter().filter(|other| alike(own, other)).count();
        let all = ends.iter().filter(|other| alike(own, other)).count().max(1);
        let forward = |ends: &Option<[Spot; 2]>| ends.is_some_and(|[a, b]| a <= b);
        let sign = if forward(own) { 1.0 } else { -1.0 };
        sign * ASIDE * (before as f64 - (all - 1) as f64 / 2.0)
    };
    (0..efforts.len()).map(side).collect()
}

/// Whether a line lies on another, for a good part of its length.
fn runs_along([a, b]: [Spot; 2], [c, d]: [Spot; 2]) -> bool {
    let Some(e) = heading(c, d) else { return false };
    let along = |spot: Spot| (spot[0] - c[0]) * e[0] + (spot[1] - c[1]) * e[1];
    let aside = |spot: Spot| ((spot[1] - c[1]) * e[0] - (spot[0] - c[0]) * e[1]).abs();
    let (least, most) = (along(a).min(along(b)), along(a).max(along(b)));
    let common = most.min(away(c, d)) - least.max(0.0);
    aside(a) < BESIDE && aside(b) < BESIDE && common > 0.3 * away(a, b)
}

pub fn wheel(drawing: &mut Drawing, wheel: &Wheel) {
    let mut group = Group::new(JOINTS, -1.0, format!("{}, {}", wheel.of, wheel.circle));
    let view = &drawing.view;
    group.path(&circle(view, wheel.center, wheel.about, wheel.radius * view.scale), true, Pen::Broken(1.0));
    drawing.add(group);
}
