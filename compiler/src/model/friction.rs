//! Friction: the joint or contact it acts in, the arguments that these take, and which forces that press are found with the reactions.

use super::lower::Lowering;
use super::names::Part;
use super::quantities::Found;
use super::{Coordinate, Expr, JointId, Load, LoadId, Quantity, Rotor, Space, Subject};
use crate::forms::Bearing;
use crate::messages;
use crate::syntax::{self, Label, Path, SubjectTerm};
use crate::units::Dimension;

impl<'d> Lowering<'d> {
    /// A joint or contact whose surfaces slide on each other.
    pub(super) fn bearing(&mut self, label: &'d Label) -> Option<Subject> {
        if let Some(index) = self.contact_named(&label.text) {
            return self.touching(index, label);
        }
        let index = match self.names.part(&label.text) {
            Some(Part::Joint(index)) => index,
            _ => {
                let rubs = |part| matches!(part, Part::Joint(_) | Part::Contact(_));
                let message = self.names.not_found("joint or contact", &label.text, rubs);
                self.diagnostics.error(label.region, message);
                return None;
            }
        };
        let form = self.definition.joints[index].form;
        let kind = form.call.word;
        let Some(bearing) = form.bearing else {
            self.diagnostics.error(label.region, messages::no_bearing(&label.text, kind));
            return None;
        };
        let (angles, _) = self.coordinates(JointId(index));
        if angles.is_empty() && matches!(bearing, Bearing::Pin | Bearing::Cross | Bearing::Sleeve) {
            self.diagnostics.error(label.region, messages::bearing_of_particle(&label.text));
            return None;
        }
        let way = if bearing.turns() { Dimension::ANGLE } else { Dimension::LENGTH };
        Some(Subject::Bearing(JointId(index), way))
    }

    /// What a friction has: what presses and, where its surfaces slide along one coordinate, how fast and what resists.
    pub(super) fn of_friction(&mut self, load: LoadId, path: &Path) -> Option<Found> {
        let written = &self.definition.loads[load.0];
        let joint = written.on.first().and_then(|on| match on {
            SubjectTerm::Name(label) => {
                self.contact_named(&label.text).map(Part::Contact).or_else(|| self.names.part(&label.text))
            }
            SubjectTerm::Place(_) | SubjectTerm::Expression(_) => None,
        });
        let (joint, names): (_, &[&str]) = match joint {
            Some(Part::Joint(index)) => {
                let names: &[&str] = match self.definition.joints[index].form.bearing? {
                    Bearing::Pin => &["normal", "torque", "rate"],
                    Bearing::Rail | Bearing::Point => &["normal", "force", "sliding"],
                    Bearing::Cross | Bearing::Ball | Bearing::Sleeve => &["normal"],
                };
                (JointId(index), names)
            }
            // The sliding is a quantity of the contact.
            Some(Part::Contact(index)) if self.slides_in_space(index) => (JointId(0), &["normal"]),
            Some(Part::Contact(_)) => (JointId(0), &["normal", "force"]),
            // What is wrong with its joint is said where it is declared.
            _ => return None,
        };
        let asked = path.parts[1].text.as_str();
        if path.parts.len() != 2 || !names.contains(&asked) {
            self.diagnostics.error(path.region, messages::quantity_of_friction(&path.parts[0].text, names));
            return None;
        }
        match asked {
            "normal" => Found::result(Quantity::Pressing(load), Dimension::FORCE),
            "torque" => Found::result(Quantity::LoadEffort(load), Dimension::TORQUE),
            "force" => Found::result(Quantity::LoadEffort(load), Dimension::FORCE),
            "rate" => Found::velocity(Coordinate::Angle(Rotor::Joint(joint, 0))),
            _ => Found::velocity(Coordinate::Travel(joint, 0)),
        }
    }

    /// Whether a friction says what its joint needs, and nothing that the joint has no use for.
    pub(super) fn rubs(
        &mut self,
        load: &'d syntax::Load,
        on: &[Subject],
        values: &mut [Vec<Expr>],
    ) -> Option<()> {
        let joint = match on {
            [Subject::Bearing(joint, _)] => joint,
            [Subject::Touches(_)] => return self.rubs_in_contact(load, values),
            _ => return Some(()),
        };
        let form = self.definition.joints[joint.0].form;
        let Some(bearing) = form.bearing else { return Some(()) };
        let (name, joint) = (&load.name.text, &self.definition.joints[joint.0].name.text);
        let arguments = load.form.call.named.iter();
        let value = |name: &str| {
            let at = arguments.clone().position(|argument| argument.name == name)?;
            values[at].first().filter(|value| !matches!(value, Expr::Number(0.0)))
        };
        let errors = self.diagnostics.iter().count();
        let mut refuse = |argument: &str, message: String| {
            if let Some(label) = load.named.labels().find(|label| label.text == argument) {
                self.diagnostics.error(label.region, message);
            }
        };
        let spatial = self.definition.space == Space::Spatial;
        let ends = match bearing {
            Bearing::Pin => spatial,
            Bearing::Rail | Bearing::Sleeve => true,
            Bearing::Cross | Bearing::Ball | Bearing::Point => false,
        };
        let kind = form.call.word;
        if !ends {
            refuse("length", messages::no_use_in_bearing("length", joint, kind));
        }
        if !(spatial && bearing == Bearing::Pin) {
            refuse("shoulder", messages::no_use_in_bearing("shoulder", joint, kind));
        }
        if !bearing.turns() && bearing != Bearing::Sleeve {
            refuse("radius", messages::no_use_in_bearing("radius", joint, kind));
        }
        if bearing.turns() {
            refuse("force", messages::friction_by_torque(name, joint));
        } else {
            refuse("torque", messages::friction_by_force(name, joint));
        }
        let presses = ["coefficient", "static", "kinetic"].iter().any(|it| value(it).is_some());
        let takes_radius = bearing.turns() || bearing == Bearing::Sleeve;
        if takes_radius && presses && value("radius").is_none() {
            self.diagnostics.error(load.name.region, messages::friction_without_radius(name, joint, kind));
        } else if !presses && ["force", "torque"].iter().all(|it| value(it).is_none()) {
            self.diagnostics.error(load.name.region, messages::friction_of_nothing(name, bearing.turns()));
        }
        let known = |name: &str| match value(name) {
            Some(Expr::Number(value)) => Some(*value),
            _ => None,
        };
        if let (Some(most), Some(least)) = (known("static"), known("kinetic"))
            && most < least
            && let Some(label) = load.named.labels().find(|label| label.text == "static")
        {
            self.diagnostics.error(label.region, messages::static_below_kinetic(most, least));
        }
        (self.diagnostics.iter().count() == errors).then_some(())
    }
}

impl<'d> Lowering<'d> {
    /// A contact presses by its law, and its friction needs nothing but coefficients and a speed.
    fn rubs_in_contact(&mut self, load: &'d syntax::Load, values: &mut [Vec<Expr>]) -> Option<()> {
        if load.form.holds && load.named.labels().all(|label| label.text != "kinetic") {
            // What slides is as much as what holds.
            let at = |name: &str| load.form.call.named.iter().position(|argument| argument.name == name);
            if let (Some(most), Some(least)) = (at("static"), at("kinetic")) {
                values[least] = values[most].clone();
            }
        }
        let (name, errors) = (&load.name.text, self.diagnostics.iter().count());
        for argument in ["radius", "length", "shoulder", "preload", "force", "torque"] {
            if let Some(label) = load.named.labels().find(|label| label.text == argument) {
                self.diagnostics.error(label.region, messages::no_use_in_contact(argument, name));
            }
        }
        let arguments = load.form.call.named.iter().zip(&*values);
        let given = |name: &str| {
            let (_, value) = arguments.clone().find(|(argument, _)| argument.name == name)?;
            value.first().filter(|value| !matches!(value, Expr::Number(0.0)))
        };
        if self.diagnostics.iter().count() == errors
            && ["coefficient", "static", "kinetic"].iter().all(|it| given(it).is_none())
        {
            self.diagnostics.error(load.name.region, messages::contact_rubs_by_nothing(name));
        }
        if let (Some(Expr::Number(most)), Some(Expr::Number(least))) = (given("static"), given("kinetic"))
            && most < least
            && let Some(label) = load.named.labels().find(|label| label.text == "static")
        {
            self.diagnostics.error(label.region, messages::static_below_kinetic(*most, *least));
        }
        (self.diagnostics.iter().count() == errors).then_some(())
    }
}

impl<'d> Lowering<'d> {
    /// Of dry friction a zero for each gate that it has; it acts in rigid contacts of the plane.
    pub(super) fn held_by(&mut self, load: &'d syntax::Load, on: &[Subject]) -> Option<Vec<Expr>> {
        if !load.form.holds {
            return Some(Vec::new());
        }
        let (name, at) = (&load.name, load.on.first()?.region());
        let index = match on {
            [Subject::Touches(contact)] => contact.0 - self.definition.loads.len(),
            _ => {
                let joint = match load.on.first()? {
                    SubjectTerm::Name(label) => label.text.as_str(),
                    SubjectTerm::Place(_) | SubjectTerm::Expression(_) => "",
                };
                self.diagnostics.error(at, messages::dry_in_joint(joint));
                return None;
            }
        };
        let contact = &self.definition.contacts[index].name.text;
        if !self.is_rigid_contact(index) {
            self.diagnostics.error(at, messages::dry_on_what_yields(contact));
            return None;
        }
        if self.definition.space == Space::Spatial {
            self.diagnostics.error(name.region, messages::dry_in_space(contact));
            return None;
        }
        let others = self.definition.loads.iter().take_while(|other| !std::ptr::eq(*other, load));
        let twice = others.filter(|other| other.form.holds).find(
            |other| matches!(other.on.first(), Some(SubjectTerm::Name(label)) if label.text == *contact),
        );
        if let Some(other) = twice {
            self.diagnostics.error(name.region, messages::dry_twice(contact, &other.name.text));
            return None;
        }
        self.gaps_of_contact(index).map(|gaps| vec![Expr::Number(0.0); gaps])
    }
}

/// Numbers the frictions whose forces follow from reactions.
pub(super) fn number(loads: &mut [Load]) {
    let mut count = 0;
    for load in loads.iter_mut().filter(|load| load.form.rubs) {
        let zero = |name: &str| matches!(load.named(name), Expr::Number(0.0));
        let by_contact = load.contact().is_some();
        if by_contact || load.form.holds || ["coefficient", "static", "kinetic"].iter().all(|name| zero(name))
        {
            continue;
        }
        load.normal = Some(count);
        count += 1;
    }
}
