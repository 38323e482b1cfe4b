//! Loads, and the pitch circles of gears.

use super::labels::Kind;
use super::{Drawing, JOINTS, LOADS};
use crate::drawing::canvas::{Group, Pen};
use crate::drawing::load::Symbol;
use crate::drawing::shapes::circle;
use crate::equations::loads::LoadKind;
use crate::page::sketch::{Effort, Wheel};

pub fn effort(drawing: &mut Drawing, kind: &LoadKind, effort: &Effort) {
    let view = drawing.view.clone();
    let mut symbol = Symbol {
        effort,
        view: &view,
        group: Group::new(LOADS, 0.0, effort.name.clone()),
        unit: drawing.unit.max(2.5),
        name: None,
        squares: Vec::new(),
        lines: Vec::new(),
    };
    (kind.symbol)(&mut symbol);
    let Symbol { group, name, squares, lines, .. } = symbol;
    for (center, half) in squares {
        drawing.block(center, half, half);
    }
    for line in lines {
        drawing.block_path(&line, false);
    }
    drawing.add(group);
    if let Some((anchor, reach)) = name {
        drawing.label(&effort.name, anchor, reach, Kind::Load);
    }
}

pub fn wheel(drawing: &mut Drawing, wheel: &Wheel) {
    let mut group = Group::new(JOINTS, -1.0, format!("{}, {}", wheel.of, wheel.circle));
    let view = &drawing.view;
    group.path(&circle(view, wheel.center, wheel.about, wheel.radius * view.scale), true, Pen::Broken(1.0));
    drawing.add(group);
}
