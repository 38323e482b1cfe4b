//! Beams: their modes, what follows from these and from their sections, and the places on their axis.

mod section;
mod thick;

use super::fold;
use super::lower::{Lowering, Use};
use super::{
    Body, BodyId, Coordinate, Deflection, Deforms, Expr, Frame, Frequency, Function2, Joint, Place, Space,
    Vector,
};
use crate::beams::{Shapes, Slender, Theory, Way};
use crate::messages;
use crate::syntax::{self, Path, Side};
use crate::units::Dimension;
use section::Section;
use std::sync::Arc;

/// What bends of a body.
#[derive(Clone, Debug)]
pub struct Beam {
    pub slender: Arc<Slender>,
    pub space: Space,
    /// EA, N, EI, N m², of bending along y and along z, and G J_t, N m², of parameters; in the plane the last two are nothing, and G J_t is where
    /// nothing twists.
    pub rigidities: [Expr; 4],
    /// In space: the square of the radius of gyration of the section about the axis, m².
    pub spin: Expr,
    /// Of each mode, 1.
    pub damping_ratio: Expr,
}

impl Beam {
    /// EA, EI or G J_t.
    pub fn rigidity(&self, way: Way) -> &Expr {
        &self.rigidities[way as usize]
    }

    /// Whether there are modes of a way.
    pub fn has(&self, way: Way) -> bool {
        self.slender.modes.iter().any(|mode| mode.way == way)
    }

    /// Name of a mode, `bending[0]`.
    pub fn mode_name(&self, mode: usize) -> String {
        let mode = &self.slender.modes[mode];
        format!("{}[{}]", mode.way.word(self.space), mode.number)
    }

    /// Natural frequencies of the modes at given parameters, rad/s; not a number where one is not known.
    pub fn rates(&self, mass: &Expr, parameters: &[f64]) -> Vec<f64> {
        let value = |expr: &Expr| fold::evaluate(expr, parameters).unwrap_or(f64::NAN);
        let rate = |mode: usize| {
            let way = self.slender.modes[mode].way;
            let moved = if way == Way::Torsion { value(mass) * value(&self.spin) } else { value(mass) };
            self.slender.square_of_rate(mode, value(self.rigidity(way)), moved).sqrt()
        };
        (0..self.slender.modes.len()).map(rate).collect()
    }
}

impl Body {
    /// Of a beam in space: its inertia about its axis, kg m², by its mass and its section.
    pub(super) fn spin_of_beam(&mut self) {
        if let Some(Deforms::Beam(beam)) = &self.deforms
            && beam.space == Space::Spatial
        {
            self.inertia.moments[0] = times(self.mass.clone(), beam.spin.clone());
        }
    }
}

impl<'d> Lowering<'d> {
    /// The shapes of a beam, as soon as its length is known; said where it is not when the body is lowered.
    pub(super) fn slender(&mut self, body: &'d syntax::Body) -> Option<Arc<Slender>> {
        if !body.form.is_beam() {
            return None;
        }
        let Some(Expr::Number(length)) = self.shape_length(body, "length", false) else { return None };
        let counts = body.beam.counts(self.definition.space);
        if length <= 0.0 {
            return None;
        }
        if let Some(modes) = body.beam.modes.as_ref().filter(|modes| modes.counts.quadratic)
            && body.beam.shapes() == Shapes::Free
        {
            self.diagnostics.error(modes.region, messages::quadratic_and_free(&body.name.text));
            return None;
        }
        let slender = match body.beam.theory() {
            Theory::EulerBernoulli => Slender::new(body.beam.shapes(), length, counts),
            Theory::Timoshenko => self.thick(body, length, counts)?,
        };
        Some(Arc::new(if body.beam.stiffens() { slender.stiffened() } else { slender }))
    }

    /// Points of a beam: its own, and what is written, which has to be on the axis.
    pub(super) fn points_of_beam(
        &mut self,
        body: &'d syntax::Body,
        slender: Option<&Slender>,
        points: &mut std::collections::HashMap<&'d str, Option<Vector>>,
    ) {
        let name = &body.name.text;
        for (label, tuple) in &body.points {
            let (Some(slender), Some(Some(at))) = (slender, points.get(label.text.as_str()).cloned()) else {
                continue;
            };
            let message = match &at {
                [Expr::Number(x), Expr::Number(0.0), Expr::Number(0.0)] if slender.reaches(*x) => continue,
                [Expr::Number(x), Expr::Number(0.0), Expr::Number(0.0)] => {
                    let to = slender.from + slender.length;
                    messages::point_beyond(name, &label.text, *x, slender.from, to)
                }
                [Expr::Number(_), Expr::Number(y), _] => messages::point_off_axis(name, &label.text, *y),
                _ => messages::point_not_known(name, &label.text),
            };
            self.diagnostics.error(tuple.region, message);
            points.insert(&label.text, None);
        }
        for (own, share) in [("start", 0.0), ("center", 0.5), ("end", 1.0)] {
            let at = slender.map(|slender| {
                [Expr::Number(slender.from + share * slender.length), Expr::Number(0.0), Expr::Number(0.0)]
            });
            if points.insert(own, at).is_some() {
                self.shape_point_again(body, own);
            }
        }
    }

    /// What bends of a body; `None` after an error.
    pub(super) fn beam(&mut self, body: &'d syntax::Body, slender: Option<Arc<Slender>>) -> Option<Beam> {
        if slender.is_none()
            && let Some((label, entry)) = body.property("length")
            && !matches!(self.shape_length(body, "length", false), None | Some(Expr::Number(_)))
        {
            self.diagnostics
                .error(label.region.to(entry.value.region), messages::length_not_known(&body.name.text));
        }
        if let Some((label, true)) = &body.beam.stiffening
            && !body.beam.counts(self.definition.space).bends()
        {
            self.diagnostics
                .error(label.region, messages::nothing_to_stiffen(&body.name.text, self.definition.space));
        }
        let young = self.positive_of_beam(body, "young", Dimension::PRESSURE, "GPa");
        let section = self.section(body);
        let damping_ratio = self.damping_ratio(body);
        let shear = self.shear_modulus(body)?;
        let (young, Section { area, about_z, about_y, torsion }) = (young?, section?);
        let [stretched, bent, bent_z] =
            [&area, &about_z, &about_y].map(|of| times(young.clone(), of.clone()));
        let rigidities = [stretched, bent, bent_z, times(shear, torsion)];
        let polar = fold::binary(Function2::Add, about_y, about_z);
        let spin = fold::binary(Function2::Div, polar, area);
        let space = self.definition.space;
        Some(Beam { slender: slender?, space, rigidities, spin, damping_ratio: damping_ratio? })
    }

    /// G, of a beam that twists or shears; nothing of others, which cannot have it.
    fn shear_modulus(&mut self, body: &'d syntax::Body) -> Option<Expr> {
        let name = &body.name.text;
        let twists = body.beam.counts(self.definition.space).torsion > 0;
        let shears = body.beam.theory() == Theory::Timoshenko;
        let idle = |property: &str, is_idle: bool| body.property(property).filter(|_| is_idle);
        if let Some((label, _)) = idle("shear_factor", !shears) {
            self.diagnostics.error(label.region, messages::nothing_to_shear(name, &label.text));
            return None;
        }
        let spatial = self.definition.space == Space::Spatial;
        let idle = idle("torsion_constant", !twists).or(idle("shear_modulus", !twists && !shears));
        if let Some((label, _)) = idle {
            let message = if spatial { messages::nothing_to_twist } else { messages::nothing_to_shear };
            self.diagnostics.error(label.region, message(name, &label.text));
            return None;
        }
        if twists || shears {
            return self.positive_of_beam(body, "shear_modulus", Dimension::PRESSURE, "GPa");
        }
        Some(Expr::Number(0.0))
    }

    /// A property that a beam must have, and that is positive.
    fn positive_of_beam(
        &mut self,
        body: &'d syntax::Body,
        property: &str,
        dimension: Dimension,
        unit: &str,
    ) -> Option<Expr> {
        let Some((_, entry)) = body.property(property) else {
            let message = messages::beam_property_missing(&body.name.text, property, unit);
            self.diagnostics.error(body.name.region, message);
            return None;
        };
        let value = self.entry(entry, dimension, Use::PROPERTY, property)?;
        if let Some(found) = fold::evaluate(&value, self.defaults())
            && found <= 0.0
        {
            let message = messages::not_positive_of_beam(property, &body.name.text, found);
            self.diagnostics.error(entry.value.region, message);
            return None;
        }
        Some(value)
    }

    /// `coupler.bending[0]`: the mode, and whether its rate is meant; nothing where it is no mode.
    pub(super) fn mode(&mut self, body: BodyId, path: &Path) -> Option<Result<(Coordinate, bool), ()>> {
        let word = path.parts[1].text.as_str();
        let base = word.split('[').next().unwrap_or(word);
        let space = self.definition.space;
        let is_way_of = |space: Space| Way::of(space).iter().any(|way| way.word(space) == base);
        // With a number it is meant as a mode, if of a beam elsewhere.
        let is_way =
            is_way_of(space) || word.contains('[') && (is_way_of(Space::Planar) || is_way_of(Space::Spatial));
        if !self.definition.bodies[body.0].form.is_beam() || !is_way {
            return None;
        }
        let counts = self.definition.bodies[body.0].beam.counts(space);
        let names = Way::of(space).iter().flat_map(|way| {
            let word = way.word(space);
            (0..counts.of(*way)).map(move |k| (*way, format!("{word}[{k}]")))
        });
        let named = names.enumerate().find(|(_, (_, name))| name == word);
        let rest: Vec<&str> = path.parts[2..].iter().map(|part| part.text.as_str()).collect();
        let (Some((mode, (way, _))), [] | ["rate"]) = (named, rest.as_slice()) else {
            let message = messages::modes_of_beam(&path.parts[0].text, &path.text, counts, space);
            self.diagnostics.error(path.region, message);
            return Some(Err(()));
        };
        Some(Ok((Coordinate::Mode(body, mode as u8, way == Way::Torsion), !rest.is_empty())))
    }

    /// `frequency(coupler.bending[0]) >= 200 [Hz]`
    pub(super) fn frequency(
        &mut self,
        path: &'d Path,
        side: Side,
        bound: &syntax::Term,
    ) -> Option<Frequency> {
        let Coordinate::Mode(body, mode, _) = self.coordinate(path, "have a frequency")? else {
            self.diagnostics.error(path.region, messages::no_mode(&path.text));
            return None;
        };
        let entry = syntax::Entry::bare(bound.clone());
        let hertz = self.number(&entry, Dimension::ONE.over(Dimension::TIME), "frequency")?;
        Some(Frequency {
            body,
            mode: usize::from(mode),
            side,
            bound: hertz,
            span: path.region.to(bound.region),
        })
    }

    /// `deflection(arm.end) <= 3 [mm]`
    pub(super) fn deflection(
        &mut self,
        path: &'d Path,
        side: Side,
        bound: &syntax::Term,
    ) -> Option<Deflection> {
        let place = self.place(&syntax::PlaceTerm::Named(path.clone()))?;
        let (Frame::Body(body), Expr::Number(x)) = (place.frame, &place.at[0]) else {
            self.diagnostics.error(path.region, messages::no_place_of_beam(&path.text));
            return None;
        };
        if !self.definition.bodies[body.0].form.is_beam() {
            self.diagnostics.error(path.region, messages::no_place_of_beam(&path.text));
            return None;
        }
        self.of_axis(&place)?;
        let length = self.number(&syntax::Entry::bare(bound.clone()), Dimension::LENGTH, "deflection")?;
        let (text, span) = (path.text.clone(), path.region.to(bound.region));
        Some(Deflection { body, x: *x, text, side, bound: length, span })
    }

    /// Whether a place there moves as a beam deforms.
    pub(super) fn bends(&self, frame: Frame) -> bool {
        match frame {
            Frame::Ground => false,
            Frame::Body(body) => self.definition.bodies[body.0].form.bends(),
        }
    }

    /// Whether the origin of a body is no point of it.
    pub(super) fn has_mean_frame(&self, body: BodyId) -> bool {
        let body = &self.definition.bodies[body.0];
        body.form.is_modal() || body.form.is_beam() && body.beam.shapes() == Shapes::Free
    }

    /// Whether the direction of a body is no section's.
    pub(super) fn has_mean_direction(&self, body: BodyId) -> bool {
        let body = &self.definition.bodies[body.0];
        let held = || matches!(body.beam.shapes(), Shapes::Clamped | Shapes::Static);
        body.form.is_modal() || body.form.is_beam() && !held()
    }

    /// Nothing is attached to the origin of a frame in the mean.
    pub(super) fn of_axis(&mut self, place: &Place) -> Option<()> {
        if place.of_mean {
            let message = self.origin_of_mean(place);
            self.diagnostics.error(place.span, message);
            return None;
        }
        Some(())
    }

    /// Why nothing is attached to a place of the mean.
    pub(super) fn origin_of_mean(&self, place: &Place) -> String {
        match place.frame {
            Frame::Body(body) if self.definition.bodies[body.0].form.is_modal() => {
                messages::origin_of_flexible(&place.text)
            }
            _ => messages::origin_of_beam(&place.text),
        }
    }

    /// Why no torque acts on a body whose direction is none of its places'.
    pub(super) fn torque_on_mean(&self, body: BodyId) -> String {
        let body = &self.definition.bodies[body.0];
        match body.form.is_modal() {
            true => messages::torque_on_flexible(&body.name.text),
            false => messages::torque_on_beam(&body.name.text),
        }
    }

    /// What joints with beams cannot do.
    pub(super) fn joint_of_beam(&mut self, joint: &'d syntax::Joint, lowered: &Joint) -> Option<()> {
        let form = lowered.form;
        let takes_axes =
            self.definition.space == Space::Planar && (!form.travels.is_empty() || lowered.curve.is_some());
        if self.bends(lowered.first.frame) && takes_axes {
            let (name, kind) = (&joint.name.text, form.call.word);
            let message = messages::beam_first(name, kind, &lowered.first.text);
            self.diagnostics.error(lowered.first.span, message);
            return None;
        }
        for place in [&lowered.first, &lowered.second] {
            self.of_axis(place)?;
            let Frame::Body(body) = place.frame else { continue };
            let body = &self.definition.bodies[body.0];
            let is_end = |slender: Arc<Slender>| match place.at[0] {
                Expr::Number(x) => x == slender.from || x == slender.from + slender.length,
                _ => false,
            };
            let pinned = body.form.is_beam() && body.beam.shapes() == Shapes::Pinned;
            if pinned && form.keeps_orientation && self.slender(body).is_some_and(is_end) {
                let message = messages::pinned_held(&joint.name.text, form.call.word, &body.name.text);
                self.diagnostics.error(place.span, message);
                return None;
            }
        }
        Some(())
    }
}

fn times(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Mul, a, b)
}
