//! Joints in space: their symbols in their layers, and what holds them to the ground.

use super::{BLOCKS, Drawing, JOINTS};
use crate::drawing::Hinge;
use crate::drawing::canvas::{Group, Pen};
use crate::drawing::shapes::{ground_line, shifted};
use crate::drawing::space::{Symbol, rail_foot};
use crate::drawing::view::Spot;
use crate::equations::space::joints;
use crate::forms::Spans;
use crate::model::Frame;

pub fn joint(drawing: &mut Drawing, hinge: &Hinge) {
    let unit = drawing.unit;
    let view = drawing.view.clone();
    let at = view.spot(hinge.at);
    let nearness = view.nearness(hinge.at);
    let mut before = Group::new(JOINTS, nearness, hinge.name.clone());
    for (place, on) in [(hinge.first, hinge.first_on), (hinge.second, hinge.second_on)] {
        if on == Frame::Ground {
            let on_rail = on == hinge.first_on && hinge.form.spans == Spans::Rail;
            let foot = if on_rail { rail_foot(&view, hinge, unit) } else { place };
            support(&mut before, view.spot(foot), unit);
        }
    }
    let behind = Group::new(BLOCKS, nearness, hinge.name.clone());
    let mut symbol = Symbol { hinge, view: &view, behind, before, at, unit };
    (joints::of(hinge.form).symbol)(&mut symbol);
    let Symbol { behind, before, .. } = symbol;
    drawing.add(behind);
    drawing.add(before);
}

/// A foot on the ground.
fn support(group: &mut Group, at: Spot, unit: f64) {
    let down = [0.0, 1.0];
    let foot = shifted(at, 3.6 * unit, down);
    group.line(at, foot, Pen::Line(1.6));
    let wide = 2.8 * unit;
    ground_line(group, [foot[0] - wide, foot[1]], [foot[0] + wide, foot[1]], down, unit);
}
