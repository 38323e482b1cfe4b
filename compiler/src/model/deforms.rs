//! What deforms of a body, by whichever modes: those of a beam, or those of a finite element model.

use super::beams::Beam;
use super::lower::{Lowering, Use};
use super::names::Part;
use super::{
    Axes, Body, BodyId, Coordinate, Expr, Frame, Inertia, Mechanism, Place, StartCondition, Vector, fold,
    value_at,
};
use crate::beams::{Shapes, Way};
use crate::diagnostics::Region;
use crate::messages;
use crate::modal::Reduced;
use crate::syntax::{self, Path};
use crate::units::Dimension;
use std::sync::Arc;

/// A mass that is written beside a file may differ from that of the file by this part.
const MASS_AGREES: f64 = 1e-3;

/// The coordinates of its own by which a body deforms.
#[derive(Clone, Debug)]
pub enum Deforms {
    Beam(Box<Beam>),
    Modal(Modal),
}

/// Modes of a finite element model.
#[derive(Clone, Debug)]
pub struct Modal {
    pub reduced: Arc<Reduced>,
    /// Of each natural mode, 1.
    pub damping_ratio: Expr,
}

impl Deforms {
    /// How many modes it has.
    pub fn modes(&self) -> usize {
        match self {
            Self::Beam(beam) => beam.slender.modes.len(),
            Self::Modal(modal) => modal.reduced.modes(),
        }
    }

    /// `bending[0]`, `mode[7]`.
    pub fn mode_name(&self, mode: usize) -> String {
        match self {
            Self::Beam(beam) => beam.mode_name(mode),
            Self::Modal(modal) => format!("mode[{}]", modal.reduced.numbers[mode]),
        }
    }

    /// Whether the coordinate of a mode is an angle, and no length.
    pub fn is_angle(&self, mode: usize) -> bool {
        match self {
            Self::Beam(beam) => beam.slender.modes[mode].way == Way::Torsion,
            Self::Modal(_) => false,
        }
    }

    /// Rates of the modes by themselves, rad/s; not a number where one is not known.
    pub fn rates(&self, mass: &Expr, parameters: &[f64]) -> Vec<f64> {
        match self {
            Self::Beam(beam) => beam.rates(mass, parameters),
            Self::Modal(modal) => modal.reduced.rates(),
        }
    }

    /// Whether the origin of its frame is the mean of its motion, and no point of it.
    pub fn has_mean_frame(&self) -> bool {
        match self {
            Self::Beam(beam) => beam.slender.shapes == Shapes::Free,
            Self::Modal(_) => true,
        }
    }

    /// Whether a place keeps its direction while the body deforms.
    pub fn keeps_direction(&self, at: &Vector) -> bool {
        match self {
            Self::Beam(beam) => matches!(at[0], Expr::Number(x) if beam.slender.keeps_direction(x)),
            Self::Modal(modal) => modal.node(at).is_some_and(|node| node.turns.iter().all(is_none)),
        }
    }

    /// Whether a place keeps where it is, too.
    pub fn stays(&self, at: &Vector) -> bool {
        match self {
            Self::Beam(beam) => matches!(at[0], Expr::Number(x) if beam.slender.stays(x)),
            Self::Modal(modal) => {
                self.keeps_direction(at) && modal.node(at).is_some_and(|node| node.shifts.iter().all(is_none))
            }
        }
    }
}

fn is_none(vector: &[f64; 3]) -> bool {
    *vector == [0.0; 3]
}

impl Modal {
    /// The node that a place is.
    fn node(&self, at: &Vector) -> Option<&crate::modal::Node> {
        let [x, y, z] = at.each_ref().map(|component| fold::evaluate(component, &[]));
        let index = self.reduced.node_at([x?, y?, z?])?;
        Some(&self.reduced.nodes[index])
    }
}

impl Body {
    /// What it is as a beam.
    pub fn beam(&self) -> Option<&Beam> {
        match &self.deforms {
            Some(Deforms::Beam(beam)) => Some(beam),
            _ => None,
        }
    }
}

impl Mechanism {
    /// What deforms of a frame.
    pub fn deforms(&self, frame: Frame) -> Option<&Deforms> {
        match frame {
            Frame::Ground => None,
            Frame::Body(body) => self.bodies[body.0].deforms.as_ref(),
        }
    }

    /// What bends of a frame, if it is a beam's.
    pub fn beam(&self, frame: Frame) -> Option<&Beam> {
        match frame {
            Frame::Ground => None,
            Frame::Body(body) => self.bodies[body.0].beam(),
        }
    }

    /// The modes of all bodies by themselves, with their natural rates at the default parameters, rad/s.
    pub fn modes(&self) -> Vec<(String, f64)> {
        let defaults = self.defaults();
        let mut modes = Vec::new();
        for body in &self.bodies {
            let Some(deforms) = &body.deforms else { continue };
            let rates = deforms.rates(&body.mass, &defaults).into_iter().enumerate();
            modes.extend(
                rates.map(|(mode, rate)| (format!("{}.{}", body.name.text, deforms.mode_name(mode)), rate)),
            );
        }
        modes
    }

    /// Whether what a place belongs to keeps its direction there while it deforms.
    pub fn keeps_direction(&self, place: &Place) -> bool {
        self.deforms(place.frame).is_none_or(|deforms| deforms.keeps_direction(&place.at))
    }
}

impl<'d> Lowering<'d> {
    /// What a file says of a body; `None` after an error.
    pub(super) fn modal(&mut self, body: &'d syntax::Body) -> Option<Modal> {
        let reduced = body.reduced()?.clone();
        let damping_ratio = self.damping_ratio(body)?;
        Some(Modal { reduced, damping_ratio })
    }

    /// The mass as the file of a body has it; one that is written has to be that.
    pub(super) fn mass_of_modal(&mut self, body: &'d syntax::Body) -> Option<(Expr, Region)> {
        let reduced = body.reduced()?;
        let read = body.modal.as_ref()?.read.as_ref()?;
        let Some((_, entry)) = body.property("mass") else {
            return Some((Expr::Number(reduced.mass), body.name.region));
        };
        let region = entry.value.region;
        let written = self.entry(entry, Dimension::MASS, Use::PROPERTY, "mass")?;
        let value = value_at(&written, self.defaults()).unwrap_or(f64::NAN);
        if !matches!(written, Expr::Number(_)) || (value - reduced.mass).abs() > MASS_AGREES * reduced.mass {
            let message = messages::mass_disagrees(&body.name.text, &read.shown, value, reduced.mass);
            self.diagnostics.error(region, message);
            return None;
        }
        Some((Expr::Number(reduced.mass), region))
    }

    /// The damping ratio of a body that deforms, nothing where it is not written.
    pub(super) fn damping_ratio(&mut self, body: &'d syntax::Body) -> Option<Expr> {
        let Some((_, entry)) = body.property("damping_ratio") else { return Some(Expr::Number(0.0)) };
        let ratio = self.entry(entry, Dimension::ONE, Use::PROPERTY, "damping_ratio");
        if let Some(Expr::Number(ratio)) = &ratio
            && *ratio < 0.0
        {
            let message = messages::damping_ratio_negative(body.form.word, &body.name.text, *ratio);
            self.diagnostics.error(entry.value.region, message);
            return None;
        }
        ratio
    }

    /// `arm.mode[7]`: the mode, and whether its rate is meant; nothing where it is no mode.
    pub(super) fn mode_of_file(
        &mut self,
        body: BodyId,
        path: &Path,
    ) -> Option<Result<(Coordinate, bool), ()>> {
        let reduced = self.definition.bodies[body.0].reduced()?;
        let word = path.parts[1].text.as_str();
        if word.split('[').next() != Some("mode") {
            return None;
        }
        let rest: Vec<&str> = path.parts[2..].iter().map(|part| part.text.as_str()).collect();
        let mode = reduced.numbers.iter().position(|number| format!("mode[{number}]") == word);
        let (Some(mode), [] | ["rate"]) = (mode, rest.as_slice()) else {
            let message = messages::modes_of_flexible(&path.parts[0].text, &path.text, &reduced.numbers);
            self.diagnostics.error(path.region, message);
            return Some(Err(()));
        };
        Some(Ok((Coordinate::Mode(body, mode as u8, false), !rest.is_empty())))
    }

    /// Modes are at rest at zero at the start unless that is said: assembly does not bend a body to close a loop.
    /// The bodies of `start { coupler = static; }`.
    pub(super) fn deflected(&mut self) -> Vec<(BodyId, Region)> {
        let definition = self.definition;
        let mut found: Vec<(BodyId, Region)> = Vec::new();
        for path in &definition.deflected {
            let Some(Part::Body(index)) = self.names.part(&path.text) else {
                let bends = definition.bodies.iter().filter(|body| body.form.bends());
                let message =
                    messages::static_of_nothing(&path.text, bends.map(|body| body.name.text.as_str()));
                self.diagnostics.error(path.region, message);
                continue;
            };
            if !definition.bodies[index].form.bends() {
                self.diagnostics.error(path.region, messages::static_and_rigid(&path.text));
                continue;
            }
            let stated = definition.start.iter().find(|start| {
                let parts = &start.quantity.parts;
                parts.len() == 2 && parts[0].text == path.text && parts[1].text.contains('[')
            });
            if let Some(stated) = stated {
                let message = messages::stated_and_static(&stated.quantity.text, &path.text);
                let note = messages::first_here(&path.text);
                self.diagnostics.conflict(stated.quantity.region, message, path.region, note);
                continue;
            }
            match found.iter().find(|(known, _)| known.0 == index) {
                Some((_, first)) => {
                    let message = messages::property_twice(&path.text, "start");
                    self.diagnostics.conflict(path.region, message, *first, messages::first_here(&path.text));
                }
                None => found.push((BodyId(index), path.region)),
            }
        }
        found
    }

    pub(super) fn modes_at_rest(mechanism: &mut Mechanism) {
        let mut rest = Vec::new();
        for (index, body) in mechanism.bodies.iter().enumerate() {
            let Some(deforms) = &body.deforms else { continue };
            for mode in 0..deforms.modes() {
                let coordinate = Coordinate::Mode(BodyId(index), mode as u8, deforms.is_angle(mode));
                for rate in [false, true] {
                    // What is only guessed is found, and so is its rate.
                    let said = |start: &StartCondition| {
                        start.coordinate == coordinate && (start.rate == rate || !start.exact)
                    };
                    if !mechanism.start.iter().any(said) {
                        rest.push(StartCondition {
                            coordinate: coordinate.clone(),
                            rate,
                            text: format!("{}.{}", body.name.text, deforms.mode_name(mode)),
                            value: Expr::Number(0.0),
                            exact: true,
                            span: body.name.span,
                        });
                    }
                }
            }
        }
        mechanism.start.extend(rest);
    }
}

/// The tensor about the centre of mass.
pub(super) fn inertia(reduced: &Reduced) -> Inertia {
    let (moments, products) = reduced.about_center();
    Inertia { moments: moments.map(Expr::Number), products: products.map(Expr::Number), axes: Axes::Parallel }
}
