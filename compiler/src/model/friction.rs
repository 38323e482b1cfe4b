//! Friction: the joint or contact it acts in, the arguments that these take, and which forces that press are found with the reactions.

use super::lower::Lowering;
use super::names::Part;
use super::quantities::Found;
use super::{Coordinate, Expr, JointId, Load, LoadId, LoadTime, Quantity, Rotor, Space, Subject};
use crate::diagnostics::Region;
use crate::forms::Bearing;
use crate::messages;
use crate::syntax::{self, Entry, Label, OptionEntry, Path, SubjectTerm};
use crate::units::Dimension;

/// How many joints may have dry friction: which of them hold is found among all ways in which they may hold and slide.
const STICKING: usize = 8;

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

    /// `friction_time(rub) >= 1e-4 [s]`
    pub(super) fn friction_time(&mut self, path: &Path, time: &syntax::Term) -> Option<LoadTime> {
        let load = match self.names.part(&path.text) {
            Some(Part::Load(index)) if self.definition.loads[index].form.rubs => LoadId(index),
            _ => {
                let definition = self.definition;
                let rubs = |part| matches!(part, Part::Load(index) if definition.loads[index].form.rubs);
                let message = self.names.not_found("friction", &path.text, rubs);
                self.diagnostics.error(path.region, message);
                return None;
            }
        };
        let least = self.number(&Entry::bare(time.clone()), Dimension::TIME, "friction_time")?;
        Some(LoadTime { load, least, span: path.region.to(time.region) })
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
                    Bearing::Thread => &["normal", "force"],
                    Bearing::Cross | Bearing::Ball | Bearing::Knuckle | Bearing::Sleeve => &["normal"],
                    Bearing::Face | Bearing::Spot | Bearing::Curve => &["normal"],
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
        if load.form.holds {
            slides_as_it_holds(load, values);
        }
        let (name, joint) = (&load.name.text, &self.definition.joints[joint.0].name.text);
        if load.form.holds && bearing == Bearing::Knuckle {
            self.diagnostics.error(load.name.region, messages::knuckle_that_holds(name, joint));
            return None;
        }
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
            Bearing::Cross | Bearing::Ball | Bearing::Knuckle | Bearing::Point | Bearing::Face => false,
            Bearing::Spot | Bearing::Curve | Bearing::Thread => false,
        };
        let kind = form.call.word;
        if !ends {
            refuse("length", messages::no_use_in_bearing("length", joint, kind));
        }
        if !(spatial && bearing == Bearing::Pin) {
            refuse("shoulder", messages::no_use_in_bearing("shoulder", joint, kind));
        }
        if !bearing.turns() && !bearing.turns_too() {
            refuse("radius", messages::no_use_in_bearing("radius", joint, kind));
        }
        if bearing.turns() {
            refuse("force", messages::friction_by_torque(name, joint));
        } else {
            refuse("torque", messages::friction_by_force(name, joint));
        }
        let dry = load.form.holds;
        let presses = ["coefficient", "static", "kinetic"].iter().any(|it| value(it).is_some());
        let takes_radius = bearing.turns() || bearing.turns_too();
        if takes_radius && presses && value("radius").is_none() {
            let message = match bearing {
                Bearing::Sleeve => messages::sleeve_without_radius(name, joint),
                Bearing::Face => messages::face_without_radius(name, joint),
                Bearing::Thread => messages::thread_without_radius(name, joint),
                _ => messages::friction_without_radius(name, joint, kind),
            };
            self.diagnostics.error(load.name.region, message);
        } else if !presses && ["force", "torque", "breakaway"].iter().all(|it| value(it).is_none()) {
            self.diagnostics
                .error(load.name.region, messages::friction_of_nothing(name, bearing.turns(), dry));
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
        let sliding = if bearing.turns() { "torque" } else { "force" };
        if let (Some(most), Some(least)) = (known("breakaway"), known(sliding))
            && most < least
            && let Some(label) = load.named.labels().find(|label| label.text == "breakaway")
        {
            self.diagnostics.error(label.region, messages::breakaway_below(most, least, sliding));
        }
        (self.diagnostics.iter().count() == errors).then_some(())
    }
}

/// What is not written of dry friction: it slides by the share that it holds by, or the other way round, and holds by the force that it slides
/// with.
fn slides_as_it_holds(load: &syntax::Load, values: &mut [Vec<Expr>]) {
    let written = |name: &str| load.named.labels().any(|label| label.text == name);
    let at = |name: &str| load.form.call.named.iter().position(|argument| argument.name == name);
    let sliding = if written("torque") { "torque" } else { "force" };
    for (own, other) in [("kinetic", "static"), ("static", "kinetic"), ("breakaway", sliding)] {
        if written(own) || !written(other) {
            continue;
        }
        if let (Some(own), Some(other)) = (at(own), at(other)) {
            values[own] = values[other].clone();
        }
    }
}

impl<'d> Lowering<'d> {
    /// A contact presses by its law, and its friction needs nothing but coefficients and a speed.
    fn rubs_in_contact(&mut self, load: &'d syntax::Load, values: &mut [Vec<Expr>]) -> Option<()> {
        if load.form.holds {
            slides_as_it_holds(load, values);
        }
        let (name, errors) = (&load.name.text, self.diagnostics.iter().count());
        for argument in ["radius", "length", "shoulder", "preload", "force", "torque", "breakaway"] {
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
            let share = if load.form.holds { "static" } else { "coefficient" };
            self.diagnostics.error(load.name.region, messages::contact_rubs_by_nothing(name, share));
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
    /// Of dry friction a zero for each gate that it has: of a rigid contact one for each gap, in space one along each axis of the world; of a
    /// joint one along each coordinate that slides.
    pub(super) fn held_by(&mut self, load: &'d syntax::Load, on: &[Subject]) -> Option<Vec<Expr>> {
        if !load.form.holds {
            return Some(Vec::new());
        }
        let at = load.on.first()?.region();
        match on {
            [Subject::Touches(contact)] => {
                self.held_by_contact(load, contact.0 - self.definition.loads.len(), at)
            }
            [Subject::Bearing(joint, _)] => self.held_by_joint(load, *joint),
            _ => None,
        }
    }

    fn held_by_contact(&mut self, load: &'d syntax::Load, index: usize, at: Region) -> Option<Vec<Expr>> {
        let contact = &self.definition.contacts[index].name.text;
        if !self.is_rigid_contact(index) {
            self.diagnostics.error(at, messages::dry_on_what_yields(contact));
            return None;
        }
        self.is_dry_alone(load, contact)?;
        let axes = if self.slides_in_space(index) { 3 } else { 1 };
        self.gaps_of_contact(index).map(|gaps| vec![Expr::Number(0.0); axes * gaps])
    }

    /// Surfaces that slide along as many coordinates, and nothing else that is held within a step.
    fn held_by_joint(&mut self, load: &'d syntax::Load, joint: JointId) -> Option<Vec<Expr>> {
        let definition = self.definition;
        self.is_dry_alone(load, &definition.joints[joint.0].name.text)?;
        let others = definition.loads.iter().take_while(|other| !std::ptr::eq(*other, load));
        let before: usize = others.filter_map(|other| self.sticking_along(other)).sum();
        let own = self.sticking_along(load)?;
        if before <= STICKING && before + own > STICKING {
            self.diagnostics.error(load.name.region, messages::too_many_stick(STICKING));
        }
        (before + own <= STICKING).then(|| vec![Expr::Number(0.0); own])
    }

    /// Along how many coordinates a dry friction of a joint holds; nothing of others.
    fn sticking_along(&self, load: &syntax::Load) -> Option<usize> {
        let SubjectTerm::Name(label) = load.on.first().filter(|_| self.sticks(load))? else { return None };
        let Some(Part::Joint(joint)) = self.names.part(&label.text) else { return None };
        let bearing = self.definition.joints[joint].form.bearing?;
        Some(bearing.slides(load.named.entry("radius").is_some()))
    }

    /// Whether no other holds there.
    fn is_dry_alone(&mut self, load: &'d syntax::Load, place: &str) -> Option<()> {
        let others = self.definition.loads.iter().take_while(|other| !std::ptr::eq(*other, load));
        let twice = others
            .filter(|other| other.form.holds)
            .find(|other| matches!(other.on.first(), Some(SubjectTerm::Name(label)) if label.text == place));
        match twice {
            Some(other) => {
                self.diagnostics.error(load.name.region, messages::dry_twice(place, &other.name.text));
                None
            }
            None => Some(()),
        }
    }

    /// Whether it is the dry friction of a joint.
    pub(super) fn sticks(&self, load: &syntax::Load) -> bool {
        let joint = |on: &SubjectTerm| match on {
            SubjectTerm::Name(label) => {
                self.contact_named(&label.text).is_none()
                    && matches!(self.names.part(&label.text), Some(Part::Joint(_)))
            }
            SubjectTerm::Place(_) | SubjectTerm::Expression(_) => false,
        };
        load.form.holds && load.on.first().is_some_and(joint)
    }

    /// What dry friction in joints cannot be together with yet.
    pub(super) fn beside_sticking(&mut self) {
        let definition = self.definition;
        let Some(dry) = definition.loads.iter().find(|load| self.sticks(load)) else { return };
        let name = &dry.name.text;
        for entry in &definition.options {
            match entry {
                OptionEntry::Contact(word) if word.text == "held" => {
                    self.diagnostics.error(word.region, messages::dry_beside_held(name));
                }
                OptionEntry::ExportC(scalar) => {
                    self.diagnostics.error(scalar.region, messages::dry_in_c(name));
                }
                _ => {}
            }
        }
        let rigid = (0..definition.contacts.len()).find(|index| self.is_rigid_contact(*index));
        if let Some(rigid) = rigid.map(|index| &definition.contacts[index].name) {
            let (message, note) =
                (messages::dry_beside_rigid(name, &rigid.text), messages::rigid_here(&rigid.text));
            self.diagnostics.conflict(dry.name.region, message, rigid.region, note);
        }
    }
}

/// Numbers the frictions whose forces follow from reactions.
pub(super) fn number(loads: &mut [Load]) {
    let mut count = 0;
    for load in loads.iter_mut().filter(|load| load.form.rubs) {
        let zero = |name: &str| matches!(load.named(name), Expr::Number(0.0));
        let by_contact = load.contact().is_some();
        if by_contact || ["coefficient", "static", "kinetic"].iter().all(|name| zero(name)) {
            continue;
        }
        load.normal = Some(count);
        count += 1;
    }
}
