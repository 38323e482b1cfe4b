//! Planar joints: their symbols in their layers.

use super::{BLOCKS, Drawing, GROUND, JOINTS};
use crate::drawing::Hinge;
use crate::drawing::canvas::Group;
use crate::drawing::plane::Symbol;
use crate::equations::plane::joints;

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
    let Symbol { behind, before, .. } = symbol;
    drawing.add(behind);
    drawing.add(before);
}
