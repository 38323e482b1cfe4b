//! Planar joints: their symbols in their layers, and the room that those take.

use super::{BLOCKS, Drawing, GROUND, JOINTS};
use crate::drawing::Hinge;
use crate::drawing::canvas::Group;
use crate::drawing::plane::{DOWN, Symbol};
use crate::drawing::shapes::shifted;
use crate::equations::plane::joints;
use crate::forms::Spans;

pub fn joint(drawing: &mut Drawing, hinge: &Hinge) {
    let unit = drawing.unit;
    let is_slide = hinge.form.is_block();
    let mut symbol = Symbol {
        hinge,
        behind: Group::new(GROUND, 0.0, hinge.name.clone()),
        before: Group::new(if is_slide { BLOCKS } else { JOINTS }, 0.0, hinge.name.clone()),
        first: drawing.view.spot(hinge.first),
        second: drawing.view.spot(hinge.second),
        way: drawing.view.way(hinge.axis),
        unit,
    };
    (joints::of(hinge.form).symbol)(&mut symbol);
    let Symbol { behind, before, first, second, .. } = symbol;
    drawing.add(behind);
    drawing.add(before);
    if hinge.form.spans == Spans::Rod {
        drawing.block_path(&[first, second], false);
    }
    if hinge.is_grounded() {
        let depth = if is_slide { 2.5 } else { 4.5 };
        drawing.block(shifted(second, depth / 2.0 * unit, DOWN), 3.2 * unit, depth / 2.0 * unit);
    }
    drawing.block(second, 1.4 * unit, 1.4 * unit);
}
