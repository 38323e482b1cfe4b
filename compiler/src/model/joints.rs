//! Joints: places, axes, lines.

use super::fold;
use super::lower::{Lowering, Use, name};
use super::names::Part;
use super::{Axes, BodyId, Expr, Frame, Function2, Joint, JointKind, Place, Vector};
use crate::messages;
use crate::syntax::{self, Entry, FirstTerm, JointWord, LineTerm, Path, Space};
use crate::units::Dimension;

/// A line that a point may lie on.
struct LowerLine {
    frame: Frame,
    ends: [Vector; 2],
    text: String,
}

impl<'d> Lowering<'d> {
    pub fn joint(&mut self, joint: &'d syntax::Joint) -> Option<Joint> {
        let (first, on_line) = match &joint.first {
            FirstTerm::Place(place) => (self.place(place), None),
            FirstTerm::Line(line) => self.on_line(line),
        };
        let second = self.place(&joint.second);
        let kind = match (joint.kind, on_line) {
            (JointWord::PointOnLine, on_line) => on_line,
            (JointWord::Distance, _) => {
                let length = joint.length.as_ref()?;
                let length = self.entry(length, Dimension::LENGTH, Use::LENGTH, "length");
                length.map(|length| JointKind::Distance { length })
            }
            (JointWord::Fixed, _) => {
                let angle = self.joint_angle(joint.angle.as_ref());
                angle.map(|angle| JointKind::Fixed { angle })
            }
            (JointWord::Spherical, _) => Some(JointKind::Spherical),
            (JointWord::Universal, _) => {
                let axis = self.direction(joint.axis.as_ref()?, "axis");
                let second = self.direction(joint.second_axis.as_ref()?, "second axis");
                let (axis, second_axis) = axis.zip(second)?;
                if let Some(degrees) = self.degrees_between(&axis, &second_axis)
                    && (degrees - 90.0).abs() > 1e-6
                {
                    let region = joint.second_axis.as_ref()?.region;
                    self.diagnostics.error(region, messages::not_perpendicular(degrees));
                    return None;
                }
                Some(JointKind::Universal { axis, second_axis })
            }
            _ => self.with_axis(joint, first.as_ref(), second.as_ref()),
        };
        let (first, second, kind) = (first?, second?, kind?);
        self.two_bodies(joint, &first, &second)?;
        Some(Joint { name: name(&joint.name), kind, first, second })
    }

    /// The kinds of joints that have one axis.
    fn with_axis(
        &mut self,
        joint: &'d syntax::Joint,
        first: Option<&Place>,
        second: Option<&Place>,
    ) -> Option<JointKind> {
        let angle = self.joint_angle(joint.angle.as_ref());
        let pitch = match &joint.pitch {
            Some(entry) => {
                let pitch = self.entry(entry, Dimension::LENGTH, Use::COEFFICIENT, "pitch");
                if matches!(pitch, Some(Expr::Number(0.0))) {
                    self.diagnostics.error(entry.value.region, messages::zero_pitch());
                    return None;
                }
                pitch
            }
            None => None,
        };
        let axis = match &joint.axis {
            Some(axis) => self.direction(axis, "axis")?,
            None => {
                let marked = [first?, second?].iter().any(|place| !matches!(place.axes, Axes::Parallel));
                if self.definition.space == Space::Spatial && !marked {
                    let message = messages::missing_axis(joint.kind.text());
                    self.diagnostics.error(joint.name.region, message);
                    return None;
                }
                [Expr::Number(0.0), Expr::Number(0.0), Expr::Number(1.0)]
            }
        };
        Some(match joint.kind {
            JointWord::Revolute => JointKind::Revolute { axis },
            JointWord::Prismatic => JointKind::Prismatic { axis, angle: angle? },
            JointWord::Cylindrical => JointKind::Cylindrical { axis },
            JointWord::Screw => JointKind::Screw { axis, pitch: pitch? },
            JointWord::Planar => JointKind::Planar { axis },
            JointWord::ConstantVelocity => JointKind::ConstantVelocity { axis },
            _ => JointKind::PointOnPlane { axis },
        })
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
        let Some(place) = [first, second].into_iter().find(|place| self.is_particle(place.frame)) else {
            return Some(());
        };
        use JointWord::{Distance, Fixed, PointOnLine, PointOnPlane, Prismatic, Spherical};
        if first.frame == place.frame && joint.kind == PointOnPlane {
            self.diagnostics.error(region, messages::particle_carries(joint.kind.text(), &place.text));
            return None;
        }
        let message = match (self.definition.space, joint.kind) {
            (Space::Planar, Fixed | Prismatic) => {
                messages::orientation_of_particle(joint.kind.text(), &place.text)
            }
            (Space::Spatial, kind) if !matches!(kind, Spherical | PointOnLine | PointOnPlane | Distance) => {
                messages::joint_of_particle_kind(kind.text(), &place.text)
            }
            _ => return Some(()),
        };
        self.diagnostics.error(region, message);
        None
    }

    /// The angle between two directions at the defaults of parameters.
    pub(super) fn degrees_between(&self, a: &Vector, b: &Vector) -> Option<f64> {
        let defaults = self.defaults();
        let value = |vector: &Vector| -> Option<[f64; 3]> {
            let values: Vec<f64> = vector.iter().filter_map(|x| fold::evaluate(x, defaults)).collect();
            values.try_into().ok()
        };
        let (a, b) = (value(a)?, value(b)?);
        let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
        let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let across = libm::sqrt(cross.iter().map(|x| x * x).sum());
        Some(libm::atan2(across, dot).to_degrees())
    }

    fn body_name(&self, body: BodyId) -> &'d str {
        &self.definition.bodies[body.0].name.text
    }

    /// The line's first point as the first place, and the way along it.
    fn on_line(&mut self, line: &'d LineTerm) -> (Option<Place>, Option<JointKind>) {
        let Some(LowerLine { frame, ends: [from, to], text }) = self.line(line) else { return (None, None) };
        let [x, y, z] = from.clone();
        let [to_x, to_y, to_z] = to;
        let less = |a, b| fold::binary(Function2::Sub, a, b);
        let direction = [less(to_x, x), less(to_y, y), less(to_z, z)];
        let first = Place { frame, at: from, axes: Axes::Parallel, text, span: line.region() };
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
