//! Joints: places, axes, lines.

use super::fold;
use super::lower::{Lowering, Use, name};
use super::names::Part;
use super::quantities::kind_text;
use super::{BodyId, Expr, Frame, Function2, Joint, JointKind, Place};
use crate::messages;
use crate::syntax::{self, Entry, JointTerm, LineTerm, Path};
use crate::units::Dimension;

/// A line that a point may lie on.
struct LowerLine {
    frame: Frame,
    ends: [[Expr; 2]; 2],
    text: String,
}

impl<'d> Lowering<'d> {
    pub fn joint(&mut self, joint: &'d syntax::Joint) -> Option<Joint> {
        let (first, kind) = match &joint.kind {
            JointTerm::Fixed { first, angle } => {
                let angle = self.joint_angle(angle.as_ref());
                (self.place(first), angle.map(|angle| JointKind::Fixed { angle }))
            }
            JointTerm::Revolute { first } => (self.place(first), Some(JointKind::Revolute)),
            JointTerm::Prismatic { first, axis, angle } => {
                let angle = self.joint_angle(angle.as_ref());
                let axis = self.direction(axis, "axis");
                let kind = axis.zip(angle).map(|(axis, angle)| JointKind::Prismatic { axis, angle });
                (self.place(first), kind)
            }
            JointTerm::PointOnLine { line } => self.on_line(line),
            JointTerm::Distance { first, length } => {
                let length = self.entry(length, Dimension::LENGTH, Use::LENGTH, "length");
                (self.place(first), length.map(|length| JointKind::Distance { length }))
            }
        };
        let second = self.place(&joint.second);
        let (first, second, kind) = (first?, second?, kind?);
        self.two_bodies(joint, &first, &second)?;
        Some(Joint { name: name(&joint.name), kind, first, second })
    }

    fn joint_angle(&mut self, angle: Option<&'d Entry>) -> Option<Expr> {
        match angle {
            Some(entry) => self.entry(entry, Dimension::ANGLE, Use::COEFFICIENT, "angle"),
            None => Some(Expr::Number(0.0)),
        }
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
        let holds_orientation = matches!(joint.kind, JointTerm::Fixed { .. } | JointTerm::Prismatic { .. });
        let particle = [first, second].into_iter().find(|place| self.is_particle(place.frame));
        if let (true, Some(place)) = (holds_orientation, particle) {
            let message = messages::orientation_of_particle(kind_text(&joint.kind), &place.text);
            self.diagnostics.error(region, message);
            return None;
        }
        Some(())
    }

    fn body_name(&self, body: BodyId) -> &'d str {
        &self.definition.bodies[body.0].name.text
    }

    /// The line's first point as the first place, and the way along it.
    fn on_line(&mut self, line: &'d LineTerm) -> (Option<Place>, Option<JointKind>) {
        let Some(LowerLine { frame, ends: [from, to], text }) = self.line(line) else { return (None, None) };
        let [from_x, from_y] = from.clone();
        let [to_x, to_y] = to;
        let direction =
            [fold::binary(Function2::Sub, to_x, from_x), fold::binary(Function2::Sub, to_y, from_y)];
        let first = Place { frame, at: from, text, span: line.region().span() };
        (Some(first), Some(JointKind::PointOnLine { direction }))
    }

    fn line(&mut self, line: &'d LineTerm) -> Option<LowerLine> {
        match line {
            LineTerm::Inline { from, to, .. } => {
                let (frame, ends) = self.line_ends(from, to)?;
                Some(LowerLine { frame, ends, text: "line(…)".to_string() })
            }
            LineTerm::Named(path) if path.parts.len() == 1 => self.line_of_ground(path),
            LineTerm::Named(path) => self.line_of_body(path),
        }
    }

    fn line_of_ground(&mut self, path: &'d Path) -> Option<LowerLine> {
        match self.names.part(&path.text) {
            Some(Part::Line(index)) => {
                let ends = self.lines[index].clone()?;
                Some(LowerLine { frame: Frame::Ground, ends, text: path.text.clone() })
            }
            Some(part) => {
                self.diagnostics.error(path.region, messages::not_a_line(&path.text, part.kind()));
                None
            }
            None => {
                let similar = self.names.similar_part(&path.text, |part| matches!(part, Part::Line(_)));
                self.diagnostics.error(path.region, messages::unknown("line", &path.text, similar));
                None
            }
        }
    }

    fn line_of_body(&mut self, path: &'d Path) -> Option<LowerLine> {
        let head = &path.parts[0];
        let Some(Part::Body(index)) = self.names.part(&head.text) else {
            let similar = self.names.similar_part(&head.text, |part| matches!(part, Part::Body(_)));
            self.diagnostics.error(head.region, messages::unknown("body", &head.text, similar));
            return None;
        };
        let slot = &path.parts[1];
        let Some(ends) = self.bodies[index].lines.get(slot.text.as_str()) else {
            let is_point = self.bodies[index].points.contains_key(slot.text.as_str());
            let mut known: Vec<&str> = self.bodies[index].lines.keys().copied().collect();
            known.sort_unstable();
            let message = messages::unknown_line(&head.text, &slot.text, is_point, &known);
            self.diagnostics.error(slot.region, message);
            return None;
        };
        let ends = ends.clone()?;
        Some(LowerLine { frame: Frame::Body(BodyId(index)), ends, text: path.text.clone() })
    }
}
