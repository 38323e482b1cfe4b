//! The dimensions of a mechanism: how far the joints of each body, and of the ground, are apart. How they are drawn is left to `figure`.

use super::stand::{Pose, Stand};
use crate::compiled::Compiled;
use crate::drawing::vector::{Point, difference, length};
use crate::forms::Spans;
use crate::model::{Axes, DeclaredUnit, Expr, Frame, Function1, Mechanism, Place, Vector};
use crate::numbers::significant;

/// Places are the same, or on one line, up to this much of their distance.
const NEAR: f64 = 1e-9;

/// A length between two places of one body.
#[derive(Clone, Debug)]
pub struct Dimension {
    /// The body, or `ground`.
    pub of: String,
    /// `crank_length = 200 mm`, or the value alone.
    pub text: String,
    /// In the world.
    pub ends: [Point; 2],
}

/// A place where a joint holds on, or an end of the shape.
#[derive(Clone)]
struct Mark {
    at: Vector,
    /// In the axes of its body, and in the world.
    own: Point,
    shown: Point,
}

pub fn dimensions(compiled: &Compiled, pose: &Pose) -> Vec<Dimension> {
    let mechanism = &compiled.mechanism;
    let mut stand = Stand::of(compiled, pose);
    let frames = (0..mechanism.bodies.len()).map(|index| Frame::Body(crate::model::BodyId(index)));
    let mut found = Vec::new();
    for frame in frames.chain([Frame::Ground]) {
        let marks = marks(mechanism, &mut stand, frame);
        for [a, b] in pairs(&marks) {
            let value = length(difference(marks[b].own, marks[a].own));
            let name = parameter(mechanism, frame, [&marks[a].at, &marks[b].at]);
            found.push(Dimension {
                of: match frame {
                    Frame::Body(body) => mechanism.bodies[body.0].name.text.clone(),
                    Frame::Ground => "ground".to_string(),
                },
                text: match name {
                    Some(id) => {
                        let parameter = &mechanism.parameters[id];
                        format!("{} = {}", parameter.name.text, in_unit(value, Some(&parameter.unit)))
                    }
                    None => in_unit(value, unit(mechanism, frame)),
                },
                ends: [marks[a].shown, marks[b].shown],
            });
        }
    }
    found
}

/// Where joints that turn hold on to a body, and the ends of its shape; no two the same.
fn marks(mechanism: &Mechanism, stand: &mut Stand, frame: Frame) -> Vec<Mark> {
    let at_joints =
        mechanism.joints.iter().filter(|joint| matches!(joint.form.spans, Spans::Nothing | Spans::Rod));
    let at_joints = at_joints.flat_map(|joint| [&joint.first, &joint.second]);
    let mut places: Vec<Place> =
        at_joints.filter(|place| place.frame == frame && is_fixed(&place.at)).cloned().collect();
    if let Frame::Body(body) = frame {
        let body = &mechanism.bodies[body.0];
        let is_end = |name: &str| body.form.has_ends && matches!(name, "start" | "end");
        let ends = body.points.iter().filter(|point| is_end(&point.name.text));
        places.extend(ends.map(|point| Place {
            frame,
            at: point.at.clone(),
            axes: Axes::Parallel,
            of_mean: false,
            text: String::new(),
            span: point.name.span,
        }));
    }
    let mut marks: Vec<Mark> = Vec::new();
    for place in places {
        let mark = Mark { own: stand.vector(&place.at), shown: stand.place(&place), at: place.at };
        let size = length(mark.own);
        if marks.iter().all(|other| length(difference(other.own, mark.own)) > NEAR * (1.0 + size)) {
            marks.push(mark);
        }
    }
    marks
}

/// Whether it stays where it is while the mechanism moves.
fn is_fixed(at: &Vector) -> bool {
    at.iter().all(|component| {
        let mut fixed = true;
        component.visit(&mut |part| {
            fixed &= matches!(
                part,
                Expr::Number(_) | Expr::Parameter(_) | Expr::Unary(..) | Expr::Binary(..) | Expr::Power(..)
            );
        });
        fixed
    })
}

/// Each place with the nearest of the others, until all are connected; of three that are not on one line, all pairs.
fn pairs(marks: &[Mark]) -> Vec<[usize; 2]> {
    let apart = |[a, b]: [usize; 2]| length(difference(marks[a].own, marks[b].own));
    let mut all: Vec<[usize; 2]> =
        (0..marks.len()).flat_map(|a| (a + 1..marks.len()).map(move |b| [a, b])).collect();
    all.sort_by(|one, other| apart(*one).total_cmp(&apart(*other)));
    if let [one, two, three] = all[..]
        && apart(three) < (apart(one) + apart(two)) * (1.0 - NEAR)
    {
        return all;
    }
    let mut tree: Vec<usize> = (0..marks.len()).collect();
    all.retain(|[a, b]| {
        let (kept, gone) = (tree[*a], tree[*b]);
        tree.iter_mut().filter(|root| **root == gone).for_each(|root| *root = kept);
        kept != gone
    });
    all
}

/// The parameter that is the distance.
fn parameter(mechanism: &Mechanism, frame: Frame, places: [&Vector; 2]) -> Option<usize> {
    if let Frame::Body(body) = frame {
        let body = &mechanism.bodies[body.0];
        let end =
            |name: &str| body.points.iter().find(|point| point.name.text == name).map(|point| &point.at);
        let ends = [end("start"), end("end")];
        let is_whole = places.iter().all(|place| ends.contains(&Some(place)));
        if is_whole && body.form.has_ends {
            let length = body.dimensions.iter().find(|(name, _)| *name == "length");
            return length.and_then(|(_, length)| as_parameter(length));
        }
    }
    let [a, b] = places;
    let mut differ = (0..3).filter(|k| a[*k] != b[*k]);
    let (k, None) = (differ.next()?, differ.next()) else { return None };
    match (&a[k], &b[k]) {
        (Expr::Number(0.0), other) | (other, Expr::Number(0.0)) => as_parameter(other),
        _ => None,
    }
}

fn as_parameter(value: &Expr) -> Option<usize> {
    match value {
        Expr::Parameter(id) => Some(id.0),
        Expr::Unary(Function1::Neg, inner) => as_parameter(inner),
        _ => None,
    }
}

/// In which lengths of a body are written, or else those of the ground.
fn unit(mechanism: &Mechanism, frame: Frame) -> Option<&DeclaredUnit> {
    let written = &mechanism.lengths;
    let own = match frame {
        Frame::Body(body) => written.bodies.get(body.0).and_then(Option::as_ref),
        Frame::Ground => None,
    };
    own.or(written.ground.as_ref())
}

fn in_unit(value: f64, unit: Option<&DeclaredUnit>) -> String {
    let (scale, text) = unit.map_or((1.0, "m"), |unit| (unit.scale, unit.text.as_str()));
    format!("{} {text}", significant(value / scale, 6))
}
