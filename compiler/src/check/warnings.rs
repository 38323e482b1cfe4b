//! Warnings, of things that are possible and probably not meant: declarations that nothing names, loads that change
//! nothing, places outside of the shape they belong to, inertia without proportion. One function a warning; the comment
//! above it is the rule as the user could read it.
//!
//! Warnings never stop the compilation, and `#[allow(…)]` before a declaration takes them back.

use super::proportion::{attached, disproportion};
use super::rules::{at_defaults, touched};
use crate::diagnostics::{Allowed, Diagnostics, Lint, Region};
use crate::forms::Outline;
use crate::forms::{JointForm, Law, Sign};
use crate::messages;
use crate::model::{
    Body, BodyId, Declared, Expr, Frame, InternalState, Joint, JointId, Load, Mechanism, NamedPoint, Place,
    Quantity, ReactionPart, Rotor, Subject, Vector,
};

/// The warnings in the order they are reported.
const WARNINGS: [fn(&Mechanism, &mut Wanted); 16] = [
    declarations_are_used,
    memories_are_set,
    bodies_are_connected,
    gravity_pulls,
    loads_have_an_effect,
    springs_pull_back,
    places_are_on_their_bodies,
    inertia_fits_mass_and_size,
    tables_bend_smoothly,
    reactions_are_unique,
    cords_are_watched,
    super::gears::teeth_are_sound,
    super::gears::bodies_are_known,
    super::beams::beams_are_slender,
    super::beams::clamps_hold,
    super::beams::clamps_are_known,
];

/// All warnings of a mechanism without errors, and with these joints whose reactions are one of many.
pub fn warnings(mechanism: &Mechanism, shared: &[JointId]) -> Diagnostics {
    let mut wanted = Wanted { allowed: &mechanism.allowed, shared, found: Diagnostics::new() };
    for warning in WARNINGS {
        warning(mechanism, &mut wanted);
    }
    wanted.found
}

/// Warnings of states that grow by themselves, with the time in which they do, s.
pub fn unstable_states(mechanism: &Mechanism, growing: &[(&InternalState, f64)], found: &mut Diagnostics) {
    for (state, time) in growing {
        let (name, at) = (&state.name.text, state.name.span);
        if !mechanism.allowed.covers(Lint::UnstableState, at) {
            found.warning(Lint::UnstableState, at, super::messages::unstable_state(name, *time));
        }
    }
}

/// Warnings, but those that `#[allow(…)]` takes back.
pub(super) struct Wanted<'a> {
    allowed: &'a Allowed,
    shared: &'a [JointId],
    found: Diagnostics,
}

impl Wanted<'_> {
    pub(super) fn push(&mut self, lint: Lint, at: Region, message: String) {
        if !self.allowed.covers(lint, at) {
            self.found.warning(lint, at, message);
        }
    }
}

// A constant, parameter, input, point, marker or line is named by something.
fn declarations_are_used(mechanism: &Mechanism, wanted: &mut Wanted) {
    for unused in &mechanism.unused {
        let kind = match unused.kind {
            Declared::Constant => "constant",
            Declared::Parameter => "parameter",
            Declared::Input => "input",
            Declared::State => "state",
            Declared::Memory => "memory",
            Declared::Signal => "signal",
            Declared::Table => "table",
            Declared::Point => "point",
            Declared::Marker => "marker",
            Declared::Line => "line",
            Declared::Toothing => "toothing",
            Declared::Part => "part",
            Declared::Surface => "surface",
            Declared::Material => "material",
        };
        let message = messages::unused(kind, &unused.name.text, unused.body.as_deref());
        wanted.push(Lint::Unused, unused.name.span, message);
    }
}

// A memory is set by an event.
fn memories_are_set(mechanism: &Mechanism, wanted: &mut Wanted) {
    for (index, memory) in mechanism.memories.iter().enumerate() {
        let is_set = mechanism.events.iter().any(|event| event.sets.iter().any(|(set, _)| set.0 == index));
        if !is_set && !memory.name.text.starts_with('_') {
            wanted.push(Lint::Unused, memory.name.span, messages::memory_never_set(&memory.name.text));
        }
    }
}

// A table in a constraint or driver has no kinks in its slope.
fn tables_bend_smoothly(mechanism: &Mechanism, wanted: &mut Wanted) {
    for kink in &mechanism.kinks {
        wanted.push(Lint::Kinks, kink.region, messages::accelerations_jump(&kink.table));
    }
}

// A reaction that is named is the only one that holds its joint.
fn reactions_are_unique(mechanism: &Mechanism, wanted: &mut Wanted) {
    let outputs = mechanism.outputs.iter().map(|output| (&output.name, &output.value));
    let rates = mechanism.states.iter().filter_map(|state| Some((&state.name, state.rate.written()?)));
    for (name, expr) in outputs.chain(rates) {
        let mut named = Vec::new();
        expr.quantities(&mut |quantity| match quantity {
            Quantity::Reaction(joint, _) if wanted.shared.contains(joint) && !named.contains(joint) => {
                named.push(*joint);
            }
            _ => {}
        });
        for joint in named {
            let message = messages::shared_reaction(&name.text, &mechanism.joints[joint.0].name.text);
            wanted.push(Lint::Shared, name.span, message);
        }
    }
}

// The tension of a cord is seen by an output or a state.
fn cords_are_watched(mechanism: &Mechanism, wanted: &mut Wanted) {
    let outputs = mechanism.outputs.iter().map(|output| &output.value);
    let rates = mechanism.states.iter().filter_map(|state| state.rate.written());
    let mut watched = Vec::new();
    for expr in outputs.chain(rates) {
        expr.quantities(&mut |quantity| {
            if let Quantity::Reaction(joint, ReactionPart::Tension) = quantity {
                watched.push(*joint);
            }
        });
    }
    for (index, joint) in mechanism.joints.iter().enumerate() {
        if joint.form.only_pulls && !watched.contains(&JointId(index)) {
            let message = messages::unwatched(&joint.name.text, &joint.name.identifier());
            wanted.push(Lint::Unwatched, joint.name.span, message);
        }
    }
}

// In a mechanism that connects anything every body has a joint, a constraint or a load on it.
fn bodies_are_connected(mechanism: &Mechanism, wanted: &mut Wanted) {
    let touched = touched(mechanism);
    if mechanism.joints.is_empty() && !touched.contains(&true) {
        return;
    }
    for (body, touched) in mechanism.bodies.iter().zip(touched) {
        if !touched && !body.name.text.starts_with('_') {
            wanted.push(Lint::Unused, body.name.span, messages::not_connected(&body.name.text));
        }
    }
}

// Gravity that is written is not zero.
fn gravity_pulls(mechanism: &Mechanism, wanted: &mut Wanted) {
    let Some((components, region)) = mechanism.gravity.as_ref().zip(mechanism.gravity_span) else { return };
    if is_zero(components) {
        wanted.push(Lint::NoEffect, region, messages::zero_gravity());
    }
}

// A load has a force, and something that it can move.
fn loads_have_an_effect(mechanism: &Mechanism, wanted: &mut Wanted) {
    let rigid = Groups::of(mechanism, |form| form.freedoms == 0);
    let parallel = Groups::of(mechanism, |form| form.keeps_orientation);
    for load in &mechanism.loads {
        if let Some(message) =
            nothing_from(load).or_else(|| nothing_moved(mechanism, load, &rigid, &parallel))
        {
            wanted.push(Lint::NoEffect, load.name.span, message);
        }
    }
}

/// Warns of a load that is zero whatever parameters, inputs and positions are.
fn nothing_from(load: &Load) -> Option<String> {
    let name = &load.name.text;
    let zero = |expr: &Expr| matches!(expr, Expr::Number(0.0));
    if load.form.law != Law::None {
        return load.law.iter().all(zero).then(|| messages::zero_load(name));
    }
    let mut pulling = load.arguments().filter(|(argument, _)| argument.sign == Sign::Restoring).peekable();
    if pulling.peek().is_some() && pulling.all(|(_, values)| values.iter().all(zero)) {
        return Some(messages::spring_of_nothing(name));
    }
    let number = |expr: &Expr| if let Expr::Number(value) = expr { Some(*value) } else { None };
    let numbers: Vec<Option<f64>> = load.arguments().flat_map(|(_, values)| values).map(number).collect();
    load.form.doubt.and_then(|doubt| doubt(name, &numbers))
}

/// Warns of a load on bodies that joints hold, in `rigid` groups altogether and in `parallel` ones against turning.
fn nothing_moved(mechanism: &Mechanism, load: &Load, rigid: &Groups, parallel: &Groups) -> Option<String> {
    // What is held at one place of a body that deforms moves at another.
    if load.places().any(|place| mechanism.deforms(place.frame).is_some()) {
        return None;
    }
    let name = &load.name.text;
    let body = |id: BodyId| &mechanism.bodies[id.0].name.text;
    if let [Subject::Place(first), Subject::Place(second)] = &load.on[..] {
        let still = rigid.same(first.frame, second.frame);
        return still.then(|| messages::spring_between_held(name, &first.text, &second.text));
    }
    load.on.iter().find_map(|subject| match subject {
        Subject::Place(place) => match place.frame {
            Frame::Body(id) => {
                let still = rigid.same(place.frame, Frame::Ground);
                still.then(|| messages::load_on_held(name, body(id)))
            }
            Frame::Ground => None,
        },
        Subject::Body(id) | Subject::Rotor(Rotor::Body(id)) => {
            let still = parallel.same(Frame::Body(*id), Frame::Ground);
            still.then(|| messages::torque_on_held(name, body(*id)))
        }
        Subject::Rotor(Rotor::Joint(id, _)) => locked(mechanism, name, *id, parallel),
        Subject::Travel(id) | Subject::Bearing(id, _) | Subject::Joint(id) => {
            locked(mechanism, name, *id, rigid)
        }
        // Its derivative says so, and the compiler leaves out what is zero.
        Subject::Expression(..) | Subject::Touches(_) => None,
        Subject::Toothing(id) => {
            let still = parallel.same(Frame::Body(id.body), Frame::Ground);
            (load.on.len() < 2 && still).then(|| messages::torque_on_held(name, body(id.body)))
        }
    })
}

/// Of a load along or about a joint whose bodies are in one group.
fn locked(mechanism: &Mechanism, load: &str, id: JointId, groups: &Groups) -> Option<String> {
    let joint = &mechanism.joints[id.0];
    let still = groups.same(joint.first.frame, joint.second.frame) && holds_bodies(mechanism, joint);
    still.then(|| messages::load_on_locked(load, &joint.name.text))
}

// Stiffness and damping are not negative.
fn springs_pull_back(mechanism: &Mechanism, wanted: &mut Wanted) {
    for load in &mechanism.loads {
        for (argument, values) in load.arguments().filter(|(it, _)| it.sign == Sign::Restoring) {
            // Behind the mean of a series stand its waves.
            let most = if load.teeth.is_some() { 1 } else { values.len() };
            let values = values.iter().take(most).filter_map(|value| at_defaults(mechanism, value));
            if let Some(value) = values.into_iter().find(|value| *value < 0.0) {
                let message = messages::negative_coefficient(argument.name, &load.name.text, value);
                wanted.push(Lint::Negative, load.name.span, message);
            }
        }
    }
}

/// Whether what a joint holds of its places it holds of their bodies: a place that moves or turns as its body deforms is held alone.
fn holds_bodies(mechanism: &Mechanism, joint: &Joint) -> bool {
    let stays = |place: &Place| mechanism.deforms(place.frame).is_none_or(|deforms| deforms.stays(&place.at));
    stays(&joint.first) && stays(&joint.second)
}

/// Bodies, and the ground, that joints of some kinds hold together.
struct Groups(Vec<usize>);

impl Groups {
    fn of(mechanism: &Mechanism, holds: impl Fn(&JointForm) -> bool) -> Self {
        // The ground is the last member; each group is called by one of its members.
        let mut group: Vec<usize> = (0..=mechanism.bodies.len()).collect();
        let own = |groups: &[usize], mut member: usize| {
            while groups[member] != member {
                member = groups[member];
            }
            member
        };
        let holds = |joint: &&Joint| joint.holds() && holds(joint.form) && holds_bodies(mechanism, joint);
        for joint in mechanism.joints.iter().filter(holds) {
            let ends = [joint.first.frame, joint.second.frame];
            let [one, other] = ends.map(|frame| own(&group, member(frame, mechanism.bodies.len())));
            group[one.min(other)] = one.max(other);
        }
        Groups((0..group.len()).map(|member| own(&group, member)).collect())
    }

    fn same(&self, one: Frame, other: Frame) -> bool {
        let ground = self.0.len() - 1;
        self.0[member(one, ground)] == self.0[member(other, ground)]
    }
}

fn member(frame: Frame, ground: usize) -> usize {
    match frame {
        Frame::Ground => ground,
        Frame::Body(body) => body.0,
    }
}

// A point or marker of a shape lies in it, as far as its dimensions are given.
fn places_are_on_their_bodies(mechanism: &Mechanism, wanted: &mut Wanted) {
    for body in &mechanism.bodies {
        for place in body.points.iter().chain(&body.markers) {
            // A shape's own points stand where its name does.
            if place.name.span.serials() == body.name.span.serials() {
                continue;
            }
            if let Some((along, least)) = beyond(mechanism, body, place) {
                let message = messages::outside(&place.name.text, body.form, &body.name.text, along, least);
                wanted.push(Lint::Outside, place.name.span, message);
            }
        }
    }
}

/// How far out a place is, and how far the shape goes there: (direction, distance), limit.
fn beyond(mechanism: &Mechanism, body: &Body, place: &NamedPoint) -> Option<((&'static str, f64), f64)> {
    let value = |expr: &Expr| at_defaults(mechanism, expr);
    let length = |name: &str| {
        let (_, length) = body.dimensions.iter().find(|(known, _)| *known == name)?;
        value(length)
    };
    let half = |name: &str| length(name).map(|length| length / 2.0);
    let [x, y, z] = [value(&place.at[0])?, value(&place.at[1])?, value(&place.at[2])?];
    let limits = match body.form.outline {
        Outline::None => return None,
        // What is not on the axis of a beam was refused, and its frame may be at an end.
        _ if body.form.bends() => return None,
        Outline::Bar => {
            vec![("along x", x.abs(), half("length")), ("off its axis", libm::hypot(y, z), length("radius"))]
        }
        Outline::Disk => {
            vec![
                ("off its axis", libm::hypot(x, y), length("radius")),
                ("along z", z.abs(), half("thickness")),
            ]
        }
        Outline::Ball => {
            vec![("from its centre", libm::hypot(libm::hypot(x, y), z), length("radius"))]
        }
        Outline::Box => vec![
            ("along x", x.abs(), half("width").or(half("size along x"))),
            ("along y", y.abs(), half("height").or(half("size along y"))),
            ("along z", z.abs(), half("thickness").or(half("size along z"))),
        ],
    };
    let mut outside = limits.into_iter().filter_map(|(along, out, limit)| Some(((along, out), limit?)));
    outside.find(|((_, out), limit)| *out > limit * (1.0 + 1e-6))
}

// A moment of inertia belongs to a body of about the mass and size that are given.
fn inertia_fits_mass_and_size(mechanism: &Mechanism, wanted: &mut Wanted) {
    // Published moments that no real body has are the definition's own business.
    if mechanism.options.accept_inertia {
        return;
    }
    for (body, attached) in mechanism.bodies.iter().zip(attached(mechanism)) {
        if let Some(found) = disproportion(mechanism, body, &attached) {
            let message = messages::out_of_proportion(&body.name.text, &found);
            wanted.push(Lint::Proportion, body.inertia_span, message);
        }
    }
}

fn is_zero(vector: &Vector) -> bool {
    vector.iter().all(|component| matches!(component, Expr::Number(0.0)))
}
