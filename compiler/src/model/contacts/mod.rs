//! Contacts and limits: what touches, by how much, and what that exerts, as expressions of positions and their rates.
//!
//! A contact is a load along its gap g: Q += Jᵀ F with J the gradient of g, so that both bodies feel the same force in opposite
//! directions. F = law where g < 0, else 0: a choice, not a branch, by a depth d = max(−g, 0) that no root or power spoils. Where gates are
//! held, the choice is by a number that stays what it is within a step, and the law goes on beyond where it would end.
//! Gaps by pairs of surfaces stand in `pairs`, laws in `laws`.

mod laws;
mod pairs;
mod restitution;
mod rigid;
mod rubbing;
mod spots;
mod surfaces;

use super::lower::{Lowering, Use, name};
use super::names::Part;
use super::unused::Scope;
use super::values::Typed;
use super::{
    Comparison, Condition, Expr, Function1, Function2, Load, LoadTime, MemoryId, Quantity, Sliding, Subject,
    fold,
};
use crate::diagnostics::Region;
use crate::messages;
use crate::syntax::{self, ContactLawTerm, ContactTerm, Entry, OptionEntry, Path, RangeTerm};
use crate::units::Dimension;
use pairs::Meeting;
use rubbing::Slides;
pub use surfaces::{Shape, Surface};

/// The contacts of a definition as far as they are known.
pub(super) struct Contacts {
    found: Vec<Found<Geometry>>,
    forces: Vec<Found<Forces>>,
    surfaces: Vec<Found<Surface>>,
    /// What slides at each of its gaps, of one that was asked for it.
    slides: Vec<Option<Vec<Sliding>>>,
    /// The one whose law is being read, and of which of its gaps.
    law_of: Option<(usize, usize)>,
}

#[derive(Clone)]
enum Found<T> {
    Unread,
    Open,
    Wrong,
    Known(T),
}

/// What a contact exerts along each of its gaps.
#[derive(Clone)]
struct Forces {
    along: Vec<Expr>,
    /// The same without the gates, where these are held.
    ungated: Vec<Expr>,
    /// Of a named law: K and n of its elastic part K dⁿ, and the impact speed that it is meant for.
    elastic: Option<[Expr; 3]>,
    /// Of a rigid one.
    restitutions: Vec<Expr>,
    adheres: bool,
}

/// What touches.
#[derive(Clone)]
struct Geometry {
    /// Where two things may touch at several places, one for each.
    meetings: Vec<Meeting>,
    dimension: Dimension,
    slides: Slides,
}

/// What an expression names of a contact.
const QUANTITIES: [&str; 7] = ["gap", "depth", "closing", "force", "point", "sliding", "speed"];

impl Contacts {
    pub fn of(definition: &syntax::Definition) -> Self {
        let count = definition.contacts.len();
        let (found, forces) = (vec![Found::Unread; count], vec![Found::Unread; count]);
        let surfaces = vec![Found::Unread; definition.surfaces.len()];
        Contacts { found, forces, surfaces, slides: vec![None; count], law_of: None }
    }

    /// The surfaces with names that contacts have asked for.
    pub fn named(&self) -> Vec<Surface> {
        let known = |found: &Found<Surface>| match found {
            Found::Known(surface) => Some(surface.clone()),
            _ => None,
        };
        self.surfaces.iter().filter_map(known).collect()
    }
}

impl<'d> Lowering<'d> {
    /// All contacts, as loads along their gaps.
    pub fn contact(&mut self, contact: &'d syntax::Contact) -> Option<Load> {
        let definition = self.definition;
        let index = definition.contacts.iter().position(|it| std::ptr::eq(it, contact))?;
        let geometry = self.geometry(index)?;
        let Forces { along: law, ungated, elastic, restitutions, adheres } = self.forces(index)?;
        let on = geometry.meetings.into_iter().map(|it| Subject::Expression(it.gap, geometry.dimension));
        let values = elastic.into_iter().flatten().map(|value| vec![value]).collect();
        let (name, form) = (name(&contact.name), contact.form);
        let (on, slides) = (on.collect(), Vec::new());
        Some(Load {
            name,
            form,
            on,
            values,
            law,
            states: 0..0,
            teeth: None,
            normal: None,
            slides,
            ungated,
            restitutions,
            adheres,
        })
    }

    /// Whether what yields has its gates held: `options { contact = held; }` without rigid contacts, beside which they are live.
    pub(super) fn holds_gates(&self) -> bool {
        let options = &self.definition.options;
        options.iter().any(|it| matches!(it, OptionEntry::Contact(word) if word.text == "held"))
            && !self.has_rigid_contacts()
    }

    pub(super) fn has_rigid_contacts(&self) -> bool {
        self.definition.contacts.iter().any(rigid::is_rigid)
    }

    /// Which contact a quantity is of; one of a joint with play has those that joints do not have.
    pub(super) fn contact_of(&self, path: &Path) -> Option<usize> {
        let [head, quantity, ..] = &path.parts[..] else { return None };
        match self.names.part(&head.text) {
            Some(Part::Joint(_)) if !QUANTITIES.contains(&quantity.text.as_str()) => None,
            _ => self.contact_named(&head.text),
        }
    }

    /// A contact, or that of a joint with play.
    pub(super) fn contact_named(&self, name: &str) -> Option<usize> {
        match self.names.part(name)? {
            Part::Contact(index) => Some(index),
            Part::Joint(index) if self.definition.joints[index].loose => {
                let own = |contact: &syntax::Contact| contact.of_joint && contact.name.text == name;
                self.definition.contacts.iter().position(own)
            }
            _ => None,
        }
    }

    /// `touch.gap`, `touch.depth`, `touch.closing`, `touch.force`, `touch.point.x`, `touch.sliding`, in space `touch.sliding.x`.
    pub(super) fn quantity_of_contact(&mut self, index: usize, path: &Path, usage: Use) -> Option<Typed> {
        let parts: Vec<&str> = path.parts[1..].iter().map(|part| part.text.as_str()).collect();
        let (permitted, kind) = match parts[0] {
            "closing" | "force" | "sliding" => (usage.velocities, "a velocity"),
            _ => (usage.positions, "a position"),
        };
        let own = self.contacts.law_of.filter(|(of, _)| *of == index).map(|(_, which)| which);
        let typed = |expr, dimension| Some(Typed { expr, dimension, zero: false, region: path.region });
        let axis = match parts[..] {
            ["point" | "sliding", component] => ["x", "y", "z"].iter().position(|axis| *axis == component),
            _ => None,
        };
        let parted = |what: &str| what == "point" || what == "sliding" && self.slides_in_space(index);
        let known = QUANTITIES.contains(&parts[0]) && (parts.len() == 2) == parted(parts[0]);
        if !known || parts.len() == 2 && axis.is_none_or(|axis| axis >= self.definition.space.dimensions()) {
            let message = messages::quantities_of_contact(&path.parts[0].text, self.definition.space);
            self.diagnostics.error(path.region, message);
            return None;
        }
        self.permit(permitted, path, kind, usage)?;
        if parts[0] == "speed" {
            return self.speed_of_touch(index, path, usage);
        }
        let geometry = self.geometry(index)?;
        let meetings = match own {
            Some(which) => vec![geometry.meetings[which].clone()],
            None => geometry.meetings,
        };
        let gaps = meetings.iter().map(|meeting| meeting.gap.clone());
        let nearest = gaps.reduce(least)?;
        let way = geometry.dimension;
        match (parts[0], axis) {
            ("gap", _) => typed(nearest, way),
            ("depth", _) => typed(depth(&nearest), way),
            ("closing", _) => typed(closing(&nearest), way.over(Dimension::TIME)),
            ("force", _) => {
                let forces = self.forces(index)?;
                typed(forces.along.into_iter().reduce(sum)?, Dimension::TORQUE.over(way))
            }
            ("sliding", axis) => {
                if self.sliding(index).is_none() {
                    self.diagnostics.error(path.region, messages::slides_nowhere(&path.parts[0].text));
                    return None;
                }
                let (contact, axis) = (self.load_of_contact(index), axis.unwrap_or(0));
                typed(Expr::Quantity(Quantity::Sliding { contact, which: own, axis }), Dimension::SPEED)
            }
            (_, Some(axis)) => {
                let point = |sliding: &Sliding| match sliding {
                    Sliding::Surfaces(spot) => Some(spot.point[axis].clone()),
                    Sliding::Along(_) => None,
                };
                let points =
                    self.sliding(index).and_then(|all| all.iter().map(point).collect::<Option<Vec<_>>>());
                let Some(points) = points else {
                    self.diagnostics.error(path.region, messages::gap_at_no_place(&path.parts[0].text));
                    return None;
                };
                let points = match own {
                    Some(which) => vec![points[which].clone()],
                    None => points,
                };
                typed(of_deepest(&meetings, points)?, Dimension::LENGTH)
            }
            _ => None,
        }
    }

    /// How fast a contact came together when it touched last, if its law asks for that.
    fn speed_of_touch(&mut self, index: usize, path: &Path, usage: Use) -> Option<Typed> {
        let Some(memory) = self.memory_of_touches(index) else {
            let message = messages::keeps_no_speed(&path.parts[0].text);
            self.diagnostics.error(path.region, message);
            return None;
        };
        self.permit(usage.states, path, "a memory", usage)?;
        let dimension = self.speed_of_contact(index)?;
        self.used.insert((Scope::Value, &self.definition.memories[memory.0].name.text));
        Some(Typed { expr: Expr::Memory(memory), dimension, zero: false, region: path.region })
    }

    fn memory_of_touches(&self, index: usize) -> Option<MemoryId> {
        let name = &self.definition.contacts[index].name.text;
        let own = |memory: &syntax::Memory| memory.touch_of.as_ref().is_some_and(|it| it.text == *name);
        self.definition.memories.iter().position(own).map(MemoryId)
    }

    /// What the rate of its gap measures.
    pub(super) fn speed_of_contact(&mut self, index: usize) -> Option<Dimension> {
        Some(self.geometry(index)?.dimension.over(Dimension::TIME))
    }

    /// At how many places a contact may touch.
    pub(super) fn gaps_of_contact(&mut self, index: usize) -> Option<usize> {
        self.geometry(index).map(|geometry| geometry.meetings.len())
    }

    fn geometry(&mut self, index: usize) -> Option<Geometry> {
        let definition = self.definition;
        let contact = &definition.contacts[index];
        match &self.contacts.found[index] {
            Found::Known(geometry) => return Some(geometry.clone()),
            Found::Wrong => return None,
            Found::Open => {
                self.diagnostics.error(contact.name.region, messages::contact_of_itself(&contact.name.text));
                return None;
            }
            Found::Unread => {}
        }
        self.contacts.found[index] = Found::Open;
        let geometry = match &contact.on {
            ContactTerm::Between(first, second) => self.between(first, second),
            ContactTerm::Gap(gap, slip) => self.value(gap, Use::ALONG).and_then(|typed| {
                let dimension = typed.dimension;
                self.moving(&typed.expr, gap.region)?;
                let slides = self.slip(slip.as_ref(), dimension)?;
                Some(Geometry { meetings: vec![Meeting::of(typed.expr)], dimension, slides })
            }),
            ContactTerm::Limit(quantity, range) => self.limited(quantity, range),
        };
        self.contacts.found[index] = geometry.clone().map_or(Found::Wrong, Found::Known);
        geometry
    }

    /// min(x − a, b − x): the nearer end.
    fn limited(&mut self, quantity: &Path, range: &RangeTerm) -> Option<Geometry> {
        let coordinate = self.coordinate(quantity, "be limited")?;
        let dimension = coordinate.dimension();
        let end = |this: &mut Self, value: &syntax::Term| {
            let entry = Entry { unit: range.unit.clone(), value: value.clone() };
            this.entry(&entry, dimension, Use::COEFFICIENT, &messages::quoted(&quantity.text))
        };
        let (from, to) = (end(self, &range.from), end(self, &range.to));
        let (from, to) = (from?, to?);
        let defaults = self.defaults();
        if let (Some(from), Some(to)) = (fold::evaluate(&from, defaults), fold::evaluate(&to, defaults))
            && from >= to
        {
            self.diagnostics
                .error(range.from.region.to(range.to.region), messages::limit_without_room(from, to));
            return None;
        }
        let x = Expr::Quantity(Quantity::Coordinate(coordinate));
        let gap = least(difference(x.clone(), from), difference(to, x));
        Some(Geometry { meetings: vec![Meeting::of(gap)], dimension, slides: Slides::Nowhere })
    }

    /// `contact_time(touch) >= 1e-3 [s]`
    pub(super) fn contact_time(&mut self, path: &Path, time: &syntax::Term) -> Option<LoadTime> {
        let Some(index) = self.contact_named(&path.text) else {
            let message =
                self.names.not_found("contact", &path.text, |part| matches!(part, Part::Contact(_)));
            self.diagnostics.error(path.region, message);
            return None;
        };
        let least = self.number(&Entry::bare(time.clone()), Dimension::TIME, "contact_time")?;
        let load = self.load_of_contact(index);
        Some(LoadTime { load, least, span: path.region.to(time.region) })
    }

    fn moving(&mut self, gap: &Expr, region: Region) -> Option<()> {
        let mut moves = false;
        gap.quantities(&mut |_| moves = true);
        if !moves {
            self.diagnostics.error(region, messages::gap_that_stands());
        }
        moves.then_some(())
    }

    /// What a contact exerts along each of its gaps.
    fn forces(&mut self, index: usize) -> Option<Forces> {
        let definition = self.definition;
        let contact = &definition.contacts[index];
        match &self.contacts.forces[index] {
            Found::Known(forces) => return Some(forces.clone()),
            Found::Wrong => return None,
            Found::Open => {
                self.diagnostics.error(contact.name.region, messages::contact_of_itself(&contact.name.text));
                return None;
            }
            Found::Unread => {}
        }
        self.contacts.forces[index] = Found::Open;
        let outer = self.contacts.law_of;
        let forces = self.geometry(index).and_then(|geometry| {
            let held = self.holds_gates();
            let usage = if held { Use::HELD_LAW } else { Use::LOAD };
            if rigid::is_rigid(contact) {
                return self.rigid(index, &geometry);
            }
            let mut forces = Forces {
                along: Vec::new(),
                ungated: Vec::new(),
                elastic: None,
                restitutions: Vec::new(),
                adheres: false,
            };
            for (which, meeting) in geometry.meetings.iter().enumerate() {
                self.contacts.law_of = Some((index, which));
                let law = match &contact.law {
                    ContactLawTerm::Named(form, named, region) => {
                        let law = self.named_law(index, form, named, *region, meeting, geometry.dimension)?;
                        forces.elastic = Some(law.elastic);
                        forces.adheres = law.adheres;
                        law.force
                    }
                    ContactLawTerm::Expression(term) => {
                        let typed = self.value(term, usage)?;
                        let what = messages::quoted(&contact.name.text);
                        let dimension = Dimension::TORQUE.over(geometry.dimension);
                        let law = self.expect_dimension(typed, dimension, &what)?;
                        if held { law } else { pushing(law) }
                    }
                };
                if held {
                    let gate = Expr::Gate(self.load_of_contact(index), which);
                    let closed = Condition::Compare(Comparison::Less, Expr::Number(0.5), gate);
                    forces.along.push(where_closed(closed, law.clone()));
                    // Of what adheres the gap alone says when it parts.
                    forces.ungated.push(if forces.adheres { Expr::Number(1.0) } else { law });
                } else {
                    forces.along.push(gated(&meeting.gap, law));
                }
            }
            Some(forces)
        });
        self.contacts.law_of = outer;
        self.contacts.forces[index] = forces.clone().map_or(Found::Wrong, Found::Known);
        forces
    }
}

/// Where several touch, the deepest says.
fn of_deepest(meetings: &[Meeting], values: Vec<Expr>) -> Option<Expr> {
    let mut all = meetings.iter().map(|meeting| meeting.gap.clone()).zip(values);
    let (mut gap, mut value) = all.next()?;
    for (other, own) in all {
        let deeper = Condition::Compare(Comparison::Less, other.clone(), gap.clone());
        value = Expr::If(Box::new(deeper), Box::new(own), Box::new(value));
        gap = least(gap, other);
    }
    Some(value)
}

/// A force where there is contact.
fn gated(gap: &Expr, law: Expr) -> Expr {
    where_closed(Condition::Compare(Comparison::Less, gap.clone(), Expr::Number(0.0)), law)
}

fn where_closed(closed: Condition, law: Expr) -> Expr {
    Expr::If(Box::new(closed), Box::new(law), Box::new(Expr::Number(0.0)))
}

/// max(F, 0).
fn pushing(force: Expr) -> Expr {
    fold::binary(Function2::Max, force, Expr::Number(0.0))
}

/// d = max(−g, 0).
fn depth(gap: &Expr) -> Expr {
    fold::binary(Function2::Max, fold::unary(Function1::Neg, gap.clone()), Expr::Number(0.0))
}

/// −ġ.
fn closing(gap: &Expr) -> Expr {
    fold::unary(Function1::Neg, Expr::Rate(Box::new(gap.clone())))
}

fn sum(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Add, a, b)
}

fn difference(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Sub, a, b)
}

fn product(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Mul, a, b)
}

fn quotient(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Div, a, b)
}

fn least(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Min, a, b)
}

fn most(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Max, a, b)
}
