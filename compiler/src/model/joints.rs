//! Joints: places, axes, lines.

use super::fold;
use super::kinks::{self, Kink};
use super::lower::{Lowering, Use, name};
use super::names::Part;
use super::unused::Scope;
use super::{Axes, BodyId, Coordinate, Expr, Frame, Joint, JointId, Place, Quantity, Space, Vector};
use crate::forms::{Argument, Given, Need, OfParticle, Value, degrees_between};
use crate::messages;
use crate::syntax::{self, FirstTerm, LineTerm, Path};
use crate::units::Dimension;

/// Passes for the foot on the curve of a joint, after which nothing is left but rounding.
const PASSES: usize = 5;

/// A line that a point may lie on.
pub(super) struct LowerLine {
    pub frame: Frame,
    pub ends: [Vector; 2],
    pub text: String,
}

impl<'d> Lowering<'d> {
    pub fn joint(&mut self, joint: &'d syntax::Joint) -> Option<Joint> {
        if let (FirstTerm::Line(LineTerm::Named(first)), syntax::PlaceTerm::Named(second)) =
            (&joint.first, &joint.second)
            && self.is_line(second)
            && !self.is_line(first)
        {
            let region = first.region.to(second.region);
            self.diagnostics.error(region, messages::line_comes_first(&second.text, &first.text));
            return None;
        }
        let (first, on_line) = match &joint.first {
            FirstTerm::Place(place) => (self.place(place), None),
            FirstTerm::Line(line) => self.on_line(line),
        };
        let second = self.place(&joint.second);
        let mut directions = Vec::new();
        let mut scalars = Vec::new();
        let mut curve = None;
        match &joint.first {
            FirstTerm::Place(_) => {}
            FirstTerm::Line(_) => directions.push(on_line?),
        }
        for argument in joint.form.call.named {
            match argument.value {
                Value::Direction => {
                    directions.push(self.joint_direction(
                        joint,
                        argument,
                        first.as_ref(),
                        second.as_ref(),
                    )?);
                }
                Value::Scalar(dimension) => {
                    scalars.push(self.joint_scalar(joint, argument, dimension, Use::COEFFICIENT)?);
                }
                Value::Moving(dimension) => {
                    scalars.push(self.joint_scalar(joint, argument, dimension, Use::LENGTH)?);
                }
                Value::Diagonal(dimension) => {
                    scalars.extend(self.diagonal(&joint.named, argument.name, dimension)?);
                }
                Value::Outline => {
                    curve = Some(self.outline(argument.name, joint.named.entry(argument.name)?, PASSES)?)
                }
                Value::OfParameter(dimension) => scalars.push(self.of_parameter(joint, argument, dimension)?),
                // Joints resist no way.
                Value::Varying(_)
                | Value::RateOf { .. }
                | Value::Way
                | Value::Law(_)
                | Value::Along { .. }
                | Value::Stiffness
                | Value::Exponent
                | Value::Backbone
                | Value::OfGap
                | Value::Word
                | Value::TeethStiffness
                | Value::TeethDamping => {}
            }
        }
        let (first, second) = (first?, second?);
        let (name, penalty) = (name(&joint.name), self.load_of_joint(joint));
        let loose = self.contact_named(&joint.name.text).map(|contact| self.load_of_contact(contact));
        let form = joint.form;
        let eased = false;
        let lowered = Joint { name, form, first, second, directions, scalars, curve, penalty, loose, eased };
        self.refused(joint, &lowered)?;
        self.rolls(joint, &lowered)?;
        self.runs(joint, &lowered)?;
        self.two_bodies(joint, &lowered.first, &lowered.second)?;
        self.joint_of_beam(joint, &lowered)?;
        if let Some(place) = [&lowered.first, &lowered.second].into_iter().find(|it| self.bends(it.frame))
            && lowered.penalty.is_some()
        {
            self.diagnostics
                .error(joint.name.region, messages::penalty_on_beam(&joint.name.text, &place.text));
            return None;
        }
        Some(lowered)
    }

    fn joint_direction(
        &mut self,
        joint: &'d syntax::Joint,
        argument: &Argument,
        first: Option<&Place>,
        second: Option<&Place>,
    ) -> Option<Vector> {
        if let Some(tuple) = joint.named.tuple(argument.name) {
            return self.direction(tuple, &argument.name.replace('_', " "));
        }
        let marked = [first?, second?].iter().any(|place| !matches!(place.axes, Axes::Parallel));
        if argument.need == Need::UnlessMarked && !marked {
            self.diagnostics.error(joint.name.region, messages::missing_axis(joint.form.call.word));
            return None;
        }
        Some([Expr::Number(0.0), Expr::Number(0.0), Expr::Number(1.0)])
    }

    fn joint_scalar(
        &mut self,
        joint: &'d syntax::Joint,
        argument: &Argument,
        dimension: Dimension,
        usage: Use,
    ) -> Option<Expr> {
        match joint.named.entry(argument.name) {
            Some(entry) => self.entry(entry, dimension, usage, argument.name),
            None => Some(Expr::Number(0.0)),
        }
    }

    /// A function of the parameter of a joint's own curve, or that itself.
    fn of_parameter(
        &mut self,
        joint: &'d syntax::Joint,
        argument: &Argument,
        dimension: Dimension,
    ) -> Option<Expr> {
        let index = self.definition.joints.iter().position(|other| std::ptr::eq(other, joint))?;
        let parameter = Quantity::Coordinate(Coordinate::Travel(JointId(index), 0));
        let Some(entry) = joint.named.entry(argument.name) else { return Some(Expr::Quantity(parameter)) };
        let value = self.entry(entry, dimension, Use::CURVE, argument.name)?;
        let mut foreign = false;
        value.visit(&mut |part| match part {
            Expr::Quantity(quantity) => foreign |= *quantity != parameter,
            Expr::Rate(_) => foreign = true,
            _ => {}
        });
        let (name, region) = (&joint.name.text, entry.value.region);
        if foreign {
            self.diagnostics.error(region, messages::curve_of_others(name, argument.name));
            return None;
        }
        let message = match kinks::first(&value) {
            None => return Some(value),
            Some(Kink::Corner(word)) => messages::curve_with_corner(name, argument.name, word),
            Some(Kink::Choice(word)) => messages::curve_by_choice(name, argument.name, word),
        };
        self.diagnostics.error(region, message);
        None
    }

    /// A curve changes with its parameter.
    fn runs(&mut self, joint: &'d syntax::Joint, lowered: &Joint) -> Option<()> {
        let Some(functions) = lowered.functions() else { return Some(()) };
        if functions.iter().any(|function| function.moves()) {
            return Some(());
        }
        let region = joint.named.entry("y").map_or(joint.name.region, |entry| entry.value.region);
        self.diagnostics.error(region, messages::curve_is_a_point(&joint.name.text));
        None
    }

    /// What the form refuses of the arguments, at the defaults of parameters.
    fn refused(&mut self, joint: &'d syntax::Joint, lowered: &Joint) -> Option<()> {
        let Some(refuses) = joint.form.refuses else { return Some(()) };
        let scalar = |value: &Expr| fold::evaluate(value, self.defaults());
        let direction = |vector: &Vector| {
            let values: Option<Vec<f64>> = vector.iter().map(scalar).collect();
            values?.try_into().ok()
        };
        let given = Given {
            name: &joint.name.text,
            directions: lowered.directions.iter().map(direction).collect(),
            scalars: lowered.scalars.iter().map(scalar).collect(),
        };
        let Some((argument, message)) = refuses(&given) else { return Some(()) };
        let tuple = joint.named.tuple(argument).map(|tuple| tuple.region);
        let region = tuple.or_else(|| joint.named.entry(argument).map(|entry| entry.value.region));
        self.diagnostics.error(region.unwrap_or(joint.name.region), message);
        None
    }

    /// A curve goes around its place, and a roller reaches into all its hollows.
    fn rolls(&mut self, joint: &'d syntax::Joint, lowered: &Joint) -> Option<()> {
        let (Some(curve), Some(base), Some(radius)) =
            (&lowered.curve, lowered.scalars.first(), lowered.scalars.get(1))
        else {
            return Some(());
        };
        let at = |value| fold::evaluate(value, self.defaults());
        let (Some(base), Some(radius)) = (at(base), at(radius)) else { return Some(()) };
        let name = &joint.name.text;
        let (argument, message) = if let Some((angle, least)) = curve.not_around(base) {
            ("lift", messages::profile_about_nothing(name, angle, least))
        } else if radius < 0.0 {
            ("radius", messages::roller_of_no_radius(name, radius))
        } else if let Some((angle, hollow)) = curve.hollow(base).filter(|(_, hollow)| *hollow <= radius) {
            ("radius", messages::undercut_by_roller(name, radius, curve.name(), angle, hollow))
        } else {
            return Some(());
        };
        let region = joint.named.entry(argument).map(|entry| entry.value.region);
        self.diagnostics.error(region.unwrap_or(joint.name.region), message);
        None
    }

    /// A joint connects two things that move apart, and holds the orientation only of what has one.
    fn two_bodies(&mut self, joint: &'d syntax::Joint, first: &Place, second: &Place) -> Option<()> {
        let region = joint.name.region;
        if first.frame == second.frame {
            let message = match first.frame {
                Frame::Ground => messages::joint_of_ground(&joint.name.text),
                Frame::Body(body) => messages::joint_with_itself(&joint.name.text, self.body_name(body)),
            };
            self.diagnostics.error(region, message);
            return None;
        }
        let Some(place) = [first, second].into_iter().find(|place| self.is_particle(place.frame)) else {
            return Some(());
        };
        let word = joint.form.call.word;
        let message = match (joint.form.of_particle, self.definition.space) {
            (OfParticle::Any, _) => return Some(()),
            (OfParticle::Second, _) if first.frame != place.frame => return Some(()),
            (OfParticle::Second, _) => messages::particle_carries(word, &place.text),
            (OfParticle::Neither, Space::Planar) => messages::orientation_of_particle(word, &place.text),
            (OfParticle::Neither, Space::Spatial) => messages::joint_of_particle_kind(word, &place.text),
        };
        self.diagnostics.error(region, message);
        None
    }

    /// The angle between two directions at the defaults of parameters.
    pub(super) fn degrees_between(&self, a: &Vector, b: &Vector) -> Option<f64> {
        let value = |vector: &Vector| -> Option<[f64; 3]> {
            let values: Option<Vec<f64>> =
                vector.iter().map(|x| fold::evaluate(x, self.defaults())).collect();
            values?.try_into().ok()
        };
        Some(degrees_between(value(a)?, value(b)?))
    }

    fn body_name(&self, body: BodyId) -> &'d str {
        &self.definition.bodies[body.0].name.text
    }

    /// The line's first point as the first place, and the way along it.
    fn on_line(&mut self, line: &'d LineTerm) -> (Option<Place>, Option<Vector>) {
        let Some(LowerLine { frame, ends: [from, to], text }) = self.line(line) else { return (None, None) };
        let direction = fold::between(&from, &to);
        let first =
            Place { frame, at: from, axes: Axes::Parallel, of_mean: false, text, span: line.region() };
        (Some(first), Some(direction))
    }

    pub(super) fn line(&mut self, line: &'d LineTerm) -> Option<LowerLine> {
        match line {
            LineTerm::Inline { from, to, .. } => {
                let (frame, ends) = self.line_ends(from, to)?;
                Some(LowerLine { frame, ends, text: "line(…)".to_string() })
            }
            LineTerm::Named(path) if path.parts.len() == 1 => self.line_of_ground(path),
            LineTerm::Named(path) => self.line_of_body(path),
        }
    }

    /// Whether a name is that of a line.
    fn is_line(&self, path: &Path) -> bool {
        match (path.parts.as_slice(), self.names.part(&path.parts[0].text)) {
            ([_], part) => matches!(part, Some(Part::Line(_))),
            ([_, line], Some(Part::Body(index))) => self.bodies[index].lines.contains_key(line.text.as_str()),
            _ => false,
        }
    }

    fn line_of_ground(&mut self, path: &'d Path) -> Option<LowerLine> {
        match self.names.part(&path.text) {
            Some(Part::Line(index)) => {
                self.used.insert((Scope::Ground, &self.definition.lines[index].name.text));
                let ends = self.lines[index].clone()?;
                Some(LowerLine { frame: Frame::Ground, ends, text: path.text.clone() })
            }
            Some(part) => {
                self.diagnostics.error(path.region, messages::not_a_line(&path.text, part.kind()));
                None
            }
            None => {
                let similar = self.names.similar_part(&path.text, |part| matches!(part, Part::Line(_)));
                let message = self.names.unknown("line", &path.text, similar);
                self.diagnostics.error(path.region, message);
                None
            }
        }
    }

    fn line_of_body(&mut self, path: &'d Path) -> Option<LowerLine> {
        let head = &path.parts[0];
        let Some(Part::Body(index)) = self.names.part(&head.text) else {
            let similar = self.names.similar_part(&head.text, |part| matches!(part, Part::Body(_)));
            let message = self.names.unknown("body", &head.text, similar);
            self.diagnostics.error(head.region, message);
            return None;
        };
        let slot = &path.parts[1];
        let Some(ends) = self.body_line_named(index, &slot.text) else {
            let is_point = self.bodies[index].points.contains_key(slot.text.as_str());
            let mut known: Vec<&str> = self.bodies[index].lines.keys().copied().collect();
            known.sort_unstable();
            let message = messages::unknown_line(&head.text, &slot.text, is_point, &known);
            self.diagnostics.error(slot.region, message);
            return None;
        };
        let ends = ends?;
        Some(LowerLine { frame: Frame::Body(BodyId(index)), ends, text: path.text.clone() })
    }
}
