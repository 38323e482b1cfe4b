//! Joints, couplings and loads of a mechanism: each by its form and what it was given, whatever its kind.

use super::gears::{Meshing, ToothingId};
use super::{BodyId, Curve, Expr, Frame, JointId, LoadId, Mechanism, Name, Place, Quantity, Vector};
use crate::forms::{Argument, CouplingForm, JointAxes, JointForm, LoadForm, Proportion, Spans};
use crate::units::Dimension;
use std::ops::Range;
use std::sync::Arc;

/// A joint between two places. Its coordinate, rate, travel and torque are those of the second place's body
/// relative to the first's, axes in the first's frame.
#[derive(Clone, Debug)]
pub struct Joint {
    pub name: Name,
    pub form: &'static JointForm,
    pub first: Place,
    pub second: Place,
    /// Its directions, of any length but zero, in the order of its arguments; of a line, the way along it.
    pub directions: Vec<Vector>,
    /// Its other arguments, in their order.
    pub scalars: Vec<Expr>,
    /// The closed curve about its first place, as a table of what its first other argument is the base of.
    pub curve: Option<Arc<Curve>>,
    /// The load that acts in place of its rows.
    pub penalty: Option<LoadId>,
    /// The contact between its surfaces, where it has play.
    pub loose: Option<LoadId>,
    /// Whether a loop closes only with its play, so that its centres start apart.
    pub eased: bool,
}

impl Joint {
    /// Whether it has rows or carries a body, and no load yields in their place.
    pub fn holds(&self) -> bool {
        self.penalty.is_none() && self.loose.is_none()
    }

    /// As written.
    pub fn word(&self) -> &'static str {
        self.form.call.word
    }

    /// One of its directions, as many as its form has.
    pub fn direction(&self, which: usize) -> &Vector {
        &self.directions[which]
    }

    /// One of its other arguments, as many as its form has.
    pub fn scalar(&self, which: usize) -> &Expr {
        &self.scalars[which]
    }

    /// What it joins to one of its ends.
    pub fn other(&self, frame: Frame) -> Frame {
        if self.first.frame == frame { self.second.frame } else { self.first.frame }
    }

    /// The axis that is the same in the axes of both places.
    pub fn common_axis(&self) -> Option<&Vector> {
        self.directions.first().filter(|_| self.form.axes == JointAxes::Common)
    }

    /// The length of the rod between its places, if it is one: its first argument.
    pub fn rod(&self) -> Option<&Expr> {
        (self.form.spans == Spans::Rod).then(|| self.scalar(0))
    }

    /// Of a joint on a curve, along which of its axes the parameter is measured, if along one of them.
    pub fn graph(&self) -> Option<usize> {
        let is_parameter = |value: &Expr| matches!(value, Expr::Quantity(_));
        let on_curve = self.form.spans == Spans::Curve;
        self.scalars.iter().position(is_parameter).filter(|_| on_curve)
    }

    /// Whether it has no rows without a coordinate of its own, so that it has to carry a body.
    pub fn must_carry(&self) -> bool {
        self.form.spans == Spans::Curve && self.graph().is_none()
    }

    /// The functions of the parameter that make a curve, if it is a joint on one.
    pub fn functions(&self) -> Option<[&Expr; 2]> {
        (self.form.spans == Spans::Curve).then(|| [self.scalar(0), self.scalar(1)])
    }

    /// Whether one of its places is a body without orientation: the joint then has no angle.
    pub fn has_particle(&self, mechanism: &Mechanism) -> bool {
        let is_particle = |frame: Frame| match frame {
            Frame::Ground => false,
            Frame::Body(body) => !mechanism.bodies[body.0].form.turns,
        };
        is_particle(self.first.frame) || is_particle(self.second.frame)
    }
}

/// What turns: a joint (second relative to first) or a body (relative to the ground).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rotor {
    /// Which of its angles.
    Joint(JointId, usize),
    Body(BodyId),
}

#[derive(Clone, Debug)]
pub struct Constraint {
    pub name: Name,
    pub kind: ConstraintKind,
}

#[derive(Clone, Debug)]
pub enum ConstraintKind {
    Coupling(Coupling),
    /// `residual` = 0 (left minus right side as written, SI).
    Equation {
        residual: Expr,
    },
    /// Two toothings mesh: index of the pair in [`Mechanism::pairs`].
    Teeth {
        form: &'static CouplingForm,
        on: [ToothingId; 2],
        pair: usize,
    },
}

/// driven = factor · other + phase, over any number of turns.
#[derive(Clone, Debug)]
pub struct Coupling {
    pub form: &'static CouplingForm,
    pub kind: &'static Proportion,
    /// What it couples, in the order of its arguments.
    pub on: [Coupled; 2],
    /// Of parameters only.
    pub factor: Expr,
    /// rad or m; from the assembled start if it was not given.
    pub phase: Option<Expr>,
}

/// A coordinate that a coupling couples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coupled {
    Angle(Rotor),
    /// The one travel of a joint.
    Travel(JointId),
}

impl Coupling {
    /// The coordinate that is the factor times the other.
    pub fn driven(&self) -> Coupled {
        self.on[self.kind.driven]
    }

    pub fn other(&self) -> Coupled {
        self.on[1 - self.kind.driven]
    }

    /// The rotors among what it couples.
    pub fn rotors(&self) -> impl Iterator<Item = Rotor> {
        self.on.into_iter().filter_map(|coupled| match coupled {
            Coupled::Angle(rotor) => Some(rotor),
            Coupled::Travel(_) => None,
        })
    }
}

#[derive(Clone, Debug)]
pub struct Load {
    pub name: Name,
    pub form: &'static LoadForm,
    /// What it acts on, in the order of its arguments.
    pub on: Vec<Subject>,
    /// Its named arguments in the order of its form, each with its components; zero, or of a direction nothing, where it
    /// was not written.
    pub values: Vec<Vec<Expr>>,
    /// The law behind it: nothing, one value, or components along the axes of the world.
    pub law: Vec<Expr>,
    /// Of a contact what slides at each of its gaps, where friction or an expression asks for it.
    pub slides: Vec<Sliding>,
    /// Of a contact whose gates are held: what its law says along each of its gaps, pulls included.
    pub ungated: Vec<Expr>,
    /// Of a rigid contact: at each of its gaps the share of the speed of approach with which it parts.
    pub restitutions: Vec<Expr>,
    /// Whether a contact may pull, which presses nothing.
    pub adheres: bool,
    /// Its internal states, among those of the mechanism.
    pub states: Range<usize>,
    /// Of a load between teeth: the pair, and what its stiffness is made of.
    pub teeth: Option<Meshing>,
    /// Of a friction by the force that presses surfaces together: which of these forces.
    pub normal: Option<usize>,
}

/// What a load acts on.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "there are few of them, and most are places")]
pub enum Subject {
    Place(Place),
    Rotor(Rotor),
    /// The one travel of a joint.
    Travel(JointId),
    /// A joint whose surfaces slide on each other, and what the way measures that they slide.
    Bearing(JointId, Dimension),
    /// A joint, in place of its rows.
    Joint(JointId),
    /// A contact whose surfaces slide on each other.
    Touches(LoadId),
    /// A body in space, about the axes of the world.
    Body(BodyId),
    /// An expression of positions, and what it measures.
    Expression(Expr, Dimension),
    Toothing(ToothingId),
}

/// What slides where a gap of a contact closes.
#[derive(Clone, Debug)]
pub enum Sliding {
    /// An expression of positions, m.
    Along(Expr),
    Surfaces(Box<Spot>),
}

/// Where surfaces touch: the material of both slides on each other there.
#[derive(Clone, Debug)]
pub struct Spot {
    /// Of the first surface and of the second.
    pub places: [Place; 2],
    /// In the world, halfway between the two surfaces, m.
    pub point: Vec<Expr>,
    /// In the world, of unit length: from the one surface to the other, whichever way.
    pub normal: Vec<Expr>,
}

impl Load {
    /// Whether surfaces, a gap or a range make it.
    pub fn is_contact(&self) -> bool {
        self.form.exported == "contact"
    }

    /// The places it acts at.
    pub fn places(&self) -> impl Iterator<Item = &Place> {
        self.on.iter().filter_map(|subject| match subject {
            Subject::Place(place) => Some(place),
            Subject::Rotor(_)
            | Subject::Travel(_)
            | Subject::Bearing(..)
            | Subject::Joint(_)
            | Subject::Touches(_)
            | Subject::Body(_)
            | Subject::Expression(..)
            | Subject::Toothing(_) => None,
        })
    }

    /// One of its places, as many as its form has.
    pub fn place(&self, which: usize) -> &Place {
        self.places().nth(which).expect("places are as many as the form has")
    }

    /// The joint along whose travel it acts, if its form says that it acts on one.
    pub fn travel(&self) -> JointId {
        let travel = self.on.iter().find_map(|subject| match subject {
            Subject::Travel(joint) => Some(*joint),
            Subject::Place(_)
            | Subject::Rotor(_)
            | Subject::Bearing(..)
            | Subject::Joint(_)
            | Subject::Touches(_)
            | Subject::Body(_)
            | Subject::Expression(..)
            | Subject::Toothing(_) => None,
        });
        travel.expect("the form says so")
    }

    /// The joint in place of whose rows it acts.
    pub fn in_place_of(&self) -> Option<JointId> {
        match self.on[..] {
            [Subject::Joint(joint)] => Some(joint),
            _ => None,
        }
    }

    /// The joint that it acts in, if it is a friction.
    pub fn bearing(&self) -> Option<JointId> {
        self.on.iter().find_map(|subject| match subject {
            Subject::Bearing(joint, _) => Some(*joint),
            Subject::Place(_)
            | Subject::Joint(_)
            | Subject::Touches(_)
            | Subject::Rotor(_)
            | Subject::Travel(_)
            | Subject::Body(_)
            | Subject::Toothing(_)
            | Subject::Expression(..) => None,
        })
    }

    /// The contact whose surfaces slide on each other, if it is the friction of one.
    pub fn contact(&self) -> Option<LoadId> {
        self.on.iter().find_map(|subject| match subject {
            Subject::Touches(contact) => Some(*contact),
            Subject::Place(_)
            | Subject::Rotor(_)
            | Subject::Travel(_)
            | Subject::Bearing(..)
            | Subject::Joint(_)
            | Subject::Body(_)
            | Subject::Toothing(_)
            | Subject::Expression(..) => None,
        })
    }

    /// Whether it is the dry friction of a joint.
    pub fn sticks(&self) -> bool {
        self.form.holds && self.bearing().is_some()
    }

    /// A named argument by its name; zero where its form has none of that name.
    pub fn named(&self, name: &str) -> &Expr {
        const NONE: &Expr = &Expr::Number(0.0);
        let which = self.form.call.named.iter().position(|argument| argument.name == name);
        which.and_then(|which| self.values.get(which)?.first()).unwrap_or(NONE)
    }

    /// The rotors it acts on.
    pub fn rotors(&self) -> impl Iterator<Item = Rotor> {
        self.on.iter().filter_map(|subject| match subject {
            Subject::Rotor(rotor) => Some(*rotor),
            Subject::Place(_)
            | Subject::Travel(_)
            | Subject::Bearing(..)
            | Subject::Joint(_)
            | Subject::Touches(_)
            | Subject::Body(_)
            | Subject::Expression(..)
            | Subject::Toothing(_) => None,
        })
    }

    /// The expression it acts along, if its form says that it acts along one.
    pub fn expression(&self) -> &Expr {
        self.along().next().expect("the form says so")
    }

    /// The expressions it acts along.
    pub fn along(&self) -> impl Iterator<Item = &Expr> {
        self.on.iter().filter_map(|subject| match subject {
            Subject::Expression(expr, _) => Some(expr),
            Subject::Place(_)
            | Subject::Rotor(_)
            | Subject::Travel(_)
            | Subject::Bearing(..)
            | Subject::Joint(_)
            | Subject::Touches(_)
            | Subject::Body(_)
            | Subject::Toothing(_) => None,
        })
    }

    /// Whether what it acts along changes with time where nothing moves.
    pub fn moves_by_itself(&self) -> bool {
        let mut found = false;
        let timed = |at: &Vector| {
            let mut timed = false;
            at.iter().for_each(|part| part.visit(&mut |part| timed |= *part == Expr::Time));
            timed
        };
        self.along().chain(self.slips()).for_each(|expr| {
            expr.visit(&mut |part| match part {
                Expr::Time => found = true,
                // Places of the ground may move by themselves.
                Expr::Quantity(Quantity::Coordinate(coordinate)) => {
                    found |= coordinate.places().any(|place| timed(&place.at));
                }
                _ => {}
            });
        });
        found
    }

    /// A named argument that is one number, by its index in the form.
    pub fn value(&self, which: usize) -> &Expr {
        &self.values[which][0]
    }

    /// A named argument with one number for each axis, by its index in the form.
    pub fn components(&self, which: usize) -> &[Expr] {
        &self.values[which]
    }

    /// All that it says in expressions.
    pub fn expressions(&self) -> impl Iterator<Item = &Expr> {
        self.along().chain(self.values.iter().flatten()).chain(&self.law).chain(self.slips())
    }

    /// What slides in a contact that says so.
    pub fn slips(&self) -> impl Iterator<Item = &Expr> {
        self.slides.iter().filter_map(|sliding| match sliding {
            Sliding::Along(slip) => Some(slip),
            Sliding::Surfaces(_) => None,
        })
    }

    /// Whether it stores energy: between teeth only where their stiffness is a number, they have no error, and nothing keeps them from pulling.
    pub fn stores(&self) -> bool {
        self.form.stores && self.teeth.as_ref().is_none_or(|teeth| teeth.stores)
    }

    /// Its named arguments that are no directions, with their components.
    pub fn arguments(&self) -> impl Iterator<Item = (&'static Argument, &[Expr])> {
        let arguments = self.form.call.named.iter().zip(self.values.iter().map(Vec::as_slice));
        arguments.filter(|(argument, _)| !argument.is_direction())
    }
}
