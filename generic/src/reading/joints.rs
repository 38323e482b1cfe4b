//! Joints: their rows, and the quantities that laws name. The rows are those of NOTATION.md, but for the places' gap, which is
//! along the world's axes also in space.

use super::laws::May;
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::expression::{Expression, Operator};
use crate::json::{field, list, name, optional, text};
use crate::kinematics::{Place, Section};
use crate::quantity::{Quantity, Universal};
use crate::row::{Equation, Phase, Row};
use crate::vector::*;
use serde_json::Value;
use std::f64::consts::TAU;

/// A joint as far as quantities need it.
#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(super) kind: String,
    pub(super) first: Place,
    pub(super) second: Place,
    /// In the plane: the unit vector of its axis is x. In space: J, whose z is the axis, in the axes of both places alike.
    pub(super) frame: M3,
    /// Of a universal joint, in the axes of the second place.
    second_axis: V3,
    /// Numbers of its counted angles.
    counted: Vec<usize>,
}

const PLANE: [&str; 8] =
    ["fixed", "revolute", "prismatic", "parallel", "point_on_line", "point_on_curve", "distance", "cord"];
const SPACE: [&str; 14] = [
    "fixed",
    "revolute",
    "prismatic",
    "cylindrical",
    "screw",
    "universal",
    "spherical",
    "planar",
    "parallel",
    "constant_velocity",
    "point_on_line",
    "point_on_plane",
    "distance",
    "cord",
];

impl<'t> Reader<'t> {
    pub(super) fn read_joints(&mut self) -> Read<Vec<Row>> {
        let mut rows = Vec::new();
        for node in list(self.tree, "joints", "joints")? {
            let own = name(node, "joints")?;
            let mut joint = self.joint(node, own)?;
            self.count_angles(&mut joint);
            let equations = if self.spatial {
                self.space_rows(&joint, node, own)?
            } else {
                self.plane_rows(&joint, node, own)?
            };
            if let Some(written) = optional(node, "penalty") {
                let load = self.penalty(&joint, written, own, equations)?;
                self.penalties.push(load);
                self.joint_by_name.insert(own, self.joints.len());
                self.joints.push(joint);
                continue;
            }
            if optional(node, "play").is_none() {
                rows.extend(equations.into_iter().map(|(what, equation)| Row {
                    of: own.to_string(),
                    what,
                    equation,
                }));
            }
            self.joint_by_name.insert(own, self.joints.len());
            self.joints.push(joint);
            if let Some(equation) = self.curve_row(node, own)? {
                rows.push(Row { of: own.to_string(), what: "beside", equation });
            }
        }
        Ok(rows)
    }

    fn joint(&self, node: &Value, own: &str) -> Read<Joint> {
        let kind = text(node, "kind", own)?;
        let known = if self.spatial { SPACE.contains(&kind) } else { PLANE.contains(&kind) };
        if !known {
            return Err(match kind {
                "cam" => DefinitionError::not_there_yet(own, "joints on cams"),
                _ => DefinitionError::kind(own, kind),
            });
        }
        let mut axis = match optional(node, "axis") {
            Some(axis) => self.tuple(axis, "value", own)?,
            None if kind == "point_on_curve" => unit_axis(graph(node, own)?),
            None => unit_axis(2),
        };
        let first = if kind == "point_on_line" {
            let (origin, along) = self.line(field(node, "first", own)?, own)?;
            axis = along;
            origin
        } else {
            self.place(field(node, "first", own)?, own)?
        };
        let second = self.place(field(node, "second", own)?, own)?;
        let directionless = || DefinitionError::value(own, "an axis has no direction");
        let frame = if matches!(kind, "fixed" | "parallel") {
            IDENTITY
        } else if self.spatial {
            canonical_frame(axis).ok_or_else(directionless)?
        } else {
            let x = if axis == unit_axis(2) { unit_axis(0) } else { axis };
            let x = unit(x).ok_or_else(directionless)?;
            from_columns(x, cross(unit_axis(2), x), unit_axis(2))
        };
        let second_axis = match optional(node, "second_axis") {
            Some(axis) => unit(self.tuple(axis, "value", own)?).ok_or_else(directionless)?,
            None => ZERO,
        };
        let turns = !matches!(
            kind,
            "spherical" | "point_on_line" | "point_on_plane" | "distance" | "cord" | "revolute" | "prismatic"
        ) || self.spatial && matches!(kind, "revolute" | "prismatic");
        if self.spatial && turns && [&first, &second].iter().any(|place| self.is_particle(place)) {
            return Err(DefinitionError::value(own, "a particle has no orientation to hold"));
        }
        Ok(Joint { kind: kind.to_string(), first, second, frame, second_axis, counted: Vec::new() })
    }

    fn is_particle(&self, place: &Place) -> bool {
        place.body.is_some_and(|body| self.bodies[body].particle)
    }

    fn bends(&self, place: &Place) -> bool {
        place.body.is_some_and(|body| self.bodies[body].beam.is_some())
    }

    /// In space angles are counted beside the orientations.
    fn count_angles(&mut self, joint: &mut Joint) {
        let angles: &[&str] = match (self.spatial, joint.kind.as_str()) {
            (true, "revolute" | "cylindrical" | "screw" | "planar") => &["angle"],
            (true, "universal") => &["angle_1", "angle_2"],
            _ => &[],
        };
        for which in angles {
            joint.counted.push(self.counted.len());
            self.counted.extend(joint.quantity(which, true));
        }
    }

    /// A quantity of positions of a joint by its word.
    pub(super) fn of_joint(&self, joint: usize, which: &str) -> Option<Quantity> {
        let joint = &self.joints[joint];
        let particle = self.is_particle(&joint.first) || self.is_particle(&joint.second);
        if particle && which.starts_with("angle") {
            return None;
        }
        joint.quantity(which, self.spatial)
    }

    /// The name of the one angle or travel of a joint or body, where a name is of one.
    pub(super) fn coordinate_of(&self, name: &str) -> Option<String> {
        if self.signals.contains_key(name) {
            return None;
        }
        let kind = self.joint_by_name.get(name).map(|joint| self.joints[*joint].kind.as_str());
        let what = match kind {
            Some("prismatic" | "point_on_line") => "travel",
            Some("point_on_curve") => "parameter",
            Some(_) => "angle",
            None if self.body_by_name.contains_key(name) => "angle",
            None => return None,
        };
        Some(format!("{name}.{what}"))
    }

    fn plane_rows(&self, joint: &Joint, node: &Value, own: &str) -> Read<Vec<(&'static str, Equation)>> {
        let kind = joint.kind.as_str();
        let mut rows = Vec::new();
        // p₁ − p₂.
        if matches!(kind, "revolute" | "fixed") {
            rows.extend([("x", joint.gap(0)), ("y", joint.gap(1))]);
        }
        // n̂·Δ.
        if matches!(kind, "prismatic" | "point_on_line") {
            rows.push(("normal", joint.along(1)));
        }
        // sin(θ₂ − θ₁ − angle) = a·x₂ with a the y axis of the first body, turned by the angle.
        let particle = self.is_particle(&joint.first) || self.is_particle(&joint.second);
        if matches!(kind, "prismatic" | "fixed" | "parallel") && !particle {
            let angle = self.entry_of(node, "angle", own)?.unwrap_or(0.0);
            let (first, second) = (Section::whole(joint.first.body), Section::whole(joint.second.body));
            let a = [-angle.sin(), angle.cos(), 0.0];
            if self.bends(&joint.first) || self.bends(&joint.second) {
                let [first, second] = [section(&joint.first), section(&joint.second)];
                rows.push(("angle", Equation::Zero(Quantity::Sections { first, second, angle })));
                return Ok(rows);
            }
            rows.push(("angle", Equation::Zero(Quantity::Dot { first, a, second, b: unit_axis(0) })));
        }
        if matches!(kind, "distance" | "cord") {
            rows.push(("distance", self.distance_row(joint, node, own)?));
        }
        Ok(rows)
    }

    fn space_rows(&self, joint: &Joint, node: &Value, own: &str) -> Read<Vec<(&'static str, Equation)>> {
        let kind = joint.kind.as_str();
        let mut rows = Vec::new();
        match kind {
            // p₁ − p₂.
            "spherical" | "revolute" | "fixed" | "universal" | "constant_velocity" => {
                rows.extend([("x", joint.gap(0)), ("y", joint.gap(1)), ("z", joint.gap(2))]);
            }
            // x₁·Δ, y₁·Δ.
            "prismatic" | "cylindrical" | "screw" | "point_on_line" => {
                rows.extend([("normal_1", joint.along(0)), ("normal_2", joint.along(1))]);
            }
            // z₁·Δ.
            "planar" | "point_on_plane" => rows.push(("normal", joint.along(2))),
            "distance" | "cord" => rows.push(("distance", self.distance_row(joint, node, own)?)),
            _ => {}
        }
        // x₁·z₂, y₁·z₂: the axes stay parallel.
        if matches!(
            kind,
            "revolute" | "fixed" | "prismatic" | "cylindrical" | "screw" | "planar" | "parallel"
        ) {
            rows.push(("axis_1", Equation::Zero(joint.dot(0, 2))));
            rows.push(("axis_2", Equation::Zero(joint.dot(1, 2))));
        }
        // x₁·y₂: nothing turns about them.
        if matches!(kind, "fixed" | "prismatic" | "parallel") {
            rows.push(("angle", Equation::Zero(joint.dot(0, 1))));
        }
        // travel − pitch/(2π)·angle.
        if kind == "screw" {
            let pitch = self.needed(node, "pitch", own)?;
            let travel = Quantity::Along {
                axis: joint.first_axis(2),
                first: joint.first.clone(),
                second: joint.second.clone(),
            };
            let angle = joint.quantity("angle", true).into_iter().map(|angle| (-pitch / TAU, angle));
            let terms = std::iter::once((1.0, travel)).chain(angle).collect();
            rows.push(("screw", Equation::Sum { terms, phase: Phase::Given(0.0) }));
        }
        // a₁·b₂ of the axis and the second axis.
        if kind == "universal" {
            if joint.second_axis == ZERO {
                return Err(DefinitionError::malformed(own, "second_axis"));
            }
            let b = turned(&joint.second.axes, joint.second_axis);
            let (first, second) = (section(&joint.first), section(&joint.second));
            rows.push(("cross", Equation::Zero(Quantity::Dot { first, a: joint.first_axis(2), second, b })));
        }
        // x₁·y₂ − y₁·x₂.
        if kind == "constant_velocity" {
            let terms = vec![(1.0, joint.dot(0, 1)), (-1.0, joint.dot(1, 0))];
            rows.push(("twist", Equation::Sum { terms, phase: Phase::Given(0.0) }));
        }
        Ok(rows)
    }

    /// Δᵧ − y(Δₓ), or x(Δᵧ) − Δₓ, of the last joint, whose parameter has a meaning by now.
    fn curve_row(&self, node: &Value, own: &str) -> Read<Option<Equation>> {
        let Some(joint) = self.joints.last().filter(|joint| joint.kind == "point_on_curve") else {
            return Ok(None);
        };
        let axis = graph(node, own)?;
        let law = self.reading(own, May::Positions, |law| {
            let left = law.leaf(joint.along_quantity(1));
            let curve = law.entry(field(node, ["y", "x"][axis], own)?)?;
            // The axis across that of y is −x.
            Ok(Expression::binary([Operator::Minus, Operator::Plus][axis], left, curve))
        })?;
        Ok(Some(Equation::Law(law)))
    }

    /// (Δ·Δ − L²)/2.
    fn distance_row(&self, joint: &Joint, node: &Value, own: &str) -> Read<Equation> {
        let length = self.entry_law(field(node, "length", own)?, own, May::Time)?;
        Ok(Equation::Distance { first: joint.first.clone(), second: joint.second.clone(), length })
    }
}

impl Joint {
    pub(super) fn kind(&self) -> &str {
        &self.kind
    }

    fn gap(&self, axis: usize) -> Equation {
        Equation::Zero(Quantity::Gap { first: self.first.clone(), second: self.second.clone(), axis })
    }

    /// Axis k of the joint's frame in the axes of the first body.
    fn first_axis(&self, k: usize) -> V3 {
        turned(&self.first.axes, column(&self.frame, k))
    }

    fn second_axis(&self, k: usize) -> V3 {
        turned(&self.second.axes, column(&self.frame, k))
    }

    pub(super) fn along_quantity(&self, k: usize) -> Quantity {
        Quantity::Along { axis: self.first_axis(k), first: self.first.clone(), second: self.second.clone() }
    }

    fn along(&self, k: usize) -> Equation {
        Equation::Zero(self.along_quantity(k))
    }

    /// Axis i of the first times axis j of the second.
    fn dot(&self, i: usize, j: usize) -> Quantity {
        let (first, second) = (section(&self.first), section(&self.second));
        Quantity::Dot { first, a: self.first_axis(i), second, b: self.second_axis(j) }
    }

    fn quantity(&self, which: &str, spatial: bool) -> Option<Quantity> {
        let kind = self.kind.as_str();
        let (first, second) = (section(&self.first), section(&self.second));
        if !spatial {
            return match (which, kind) {
                ("angle", "revolute" | "point_on_line" | "point_on_curve") => {
                    let [first, second] = [section(&self.first), section(&self.second)];
                    Some(Quantity::PlaneAngle { first, second })
                }
                ("travel", "prismatic" | "point_on_line") => Some(self.along_quantity(0)),
                // For loads along it, too.
                ("parameter" | "travel", "point_on_curve") => Some(self.along_quantity(0)),
                ("travel_1", "parallel") => Some(self.along_quantity(0)),
                ("travel_2", "parallel") => Some(self.along_quantity(1)),
                _ => None,
            };
        }
        match (which, kind) {
            ("angle", "revolute" | "cylindrical" | "screw" | "planar") => Some(Quantity::Angle {
                first,
                axes_1: product(&self.first.axes, &self.frame),
                second,
                axes_2: product(&self.second.axes, &self.frame),
                counted: *self.counted.first()?,
            }),
            ("angle_1" | "angle_2", "universal") => {
                let which = usize::from(which == "angle_2");
                let joint = Box::new(Universal {
                    first,
                    axes_1: self.first.axes,
                    second,
                    axes_2: self.second.axes,
                    a: column(&self.frame, 2),
                    s: self.second_axis,
                });
                Some(Quantity::Universal { joint, which, counted: *self.counted.get(which)? })
            }
            ("travel", "prismatic" | "cylindrical" | "screw" | "point_on_line") => {
                Some(self.along_quantity(2))
            }
            ("travel_1", "planar" | "parallel") => Some(self.along_quantity(0)),
            ("travel_2", "planar" | "parallel") => Some(self.along_quantity(1)),
            ("travel_3", "parallel") => Some(self.along_quantity(2)),
            _ => None,
        }
    }
}

/// Along which axis the parameter of a curve is measured.
fn graph(node: &Value, own: &str) -> Read<usize> {
    let parameter = format!("{own}.parameter");
    let is_parameter = |axis: &&str| {
        let written = optional(node, axis).and_then(|entry| entry.get("value"));
        written.is_none_or(|value| value.get("name").and_then(Value::as_str) == Some(&parameter))
    };
    let found = ["x", "y"].iter().position(is_parameter);
    found.ok_or_else(|| DefinitionError::not_there_yet(own, "joints on curves that are no graphs"))
}

/// What turns at a place.
fn section(place: &Place) -> Section {
    Section { body: place.body, x: (!place.of_mean).then_some(place.local[0]) }
}

/// How far the places of a joint with play are apart: along an axis of the first's, or at all.
pub(super) fn of_play(joint: &Joint, part: Option<&str>, what: &str) -> Option<Quantity> {
    let (first, second) = (joint.first.clone(), joint.second.clone());
    let axis = ["x", "y", "z"].iter().position(|axis| *axis == what);
    match (part, axis, what) {
        (Some("offset"), Some(axis), _) => Some(Quantity::Along { axis: unit_axis(axis), first, second }),
        (None, None, "eccentricity") => Some(Quantity::Length { first, second }),
        _ => None,
    }
}
