//! Surfaces that may touch: their lines, behind what they belong to.

use super::{Drawing, GROUND};
use crate::drawing::canvas::{Group, Pen};
use crate::drawing::view::Spot;
use crate::page::surfaces::Skin;

pub fn skin(drawing: &mut Drawing, skin: &Skin) {
    let mut group = Group::new(GROUND, f64::NEG_INFINITY, skin.name.clone());
    for line in &skin.lines {
        let spots: Vec<Spot> = line.iter().map(|at| drawing.view.spot(*at)).collect();
        group.path(&spots, false, Pen::Line(1.1));
    }
    drawing.add(group);
}
