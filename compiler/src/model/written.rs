//! In which units lengths are written, for drawings that say them.

use super::DeclaredUnit;
use super::lower::declared_unit;
use crate::syntax::{Body, Definition, FirstTerm, LineTerm, PlaceTerm, WrittenUnit};

/// Units of the first length of each body, and of the first place of the ground; nothing where none is written.
#[derive(Clone, Debug, Default)]
pub struct WrittenLengths {
    pub bodies: Vec<Option<DeclaredUnit>>,
    pub ground: Option<DeclaredUnit>,
}

pub(super) fn lengths(definition: &Definition) -> WrittenLengths {
    let bodies = definition.bodies.iter().map(|body| of_body(body).map(|unit| declared_unit(Some(unit))));
    let mut places = definition.joints.iter().flat_map(|joint| {
        let first = match &joint.first {
            FirstTerm::Place(place) | FirstTerm::Line(LineTerm::Inline { from: place, .. }) => Some(place),
            FirstTerm::Line(LineTerm::Named(_)) => None,
        };
        first.into_iter().chain([&joint.second])
    });
    let ground = places.find_map(|place| match place {
        PlaceTerm::Ground(ground) => ground.unit.as_ref(),
        PlaceTerm::Named(_) => None,
    });
    WrittenLengths { bodies: bodies.collect(), ground: ground.map(|unit| declared_unit(Some(unit))) }
}

/// Of its shape, or else of its points.
fn of_body(body: &Body) -> Option<&WrittenUnit> {
    let is_length = |name: &str| !matches!(name, "mass" | "density" | "inertia" | "young");
    let of_shape = body.properties.iter().filter(|(label, _)| is_length(&label.text));
    let of_shape = of_shape.filter_map(|(_, entry)| entry.unit.as_ref());
    let size = body.vectors.iter().filter(|(label, _)| label.text == "size");
    let points = size.chain(&body.center).chain(&body.points);
    of_shape.chain(points.filter_map(|(_, tuple)| tuple.unit.as_ref())).next()
}
