//! What loads with internal states say: the way that they resist, the elements of a backbone, and the states themselves.

use super::lower::Lowering;
use super::names::Part;
use super::tables::Table;
use super::unused::Scope;
use super::{BodyId, Coordinate, DeclaredUnit, Expr, Frame, InternalState, JointId, Load, Name};
use super::{Function2, LoadId, Quantity, Rate, Rotor, Sliding, Space, Subject, fold};
use crate::diagnostics::{Diagnostics, Region};
use crate::forms::{Acts, Bearing, Interpolation, Outside, Owned};
use crate::messages;
use crate::syntax::{self, Entry, TableData, Term, TermKind};
use crate::units::Dimension;

/// Of the largest, what is taken for rounding.
const ROUNDING: f64 = 1e-9;

/// Where a backbone is wrong, by the index of a knot, and what is.
type Wrong = (usize, fn(&str, &str) -> String);

impl<'d> Lowering<'d> {
    /// The coordinate of a joint that has one, or of a body in the plane, by its name; nothing where none is meant.
    pub(super) fn way(&mut self, term: &'d Term) -> Option<Subject> {
        let TermKind::Name(path) = &term.kind else { return None };
        if path.parts.len() != 1 || self.names.value(&path.text).is_some() {
            return None;
        }
        let coordinate = match self.names.part(&path.text)? {
            Part::Body(index) => {
                let turns =
                    self.definition.space == Space::Planar && !self.is_particle(Frame::Body(BodyId(index)));
                turns.then_some(Coordinate::Angle(Rotor::Body(BodyId(index))))
            }
            Part::Joint(index) => match self.coordinates(JointId(index)) {
                ([_], []) => Some(Coordinate::Angle(Rotor::Joint(JointId(index), 0))),
                ([], [_]) => Some(Coordinate::Travel(JointId(index), 0)),
                _ => None,
            },
            Part::Constraint(_)
            | Part::Driver(_)
            | Part::Load(_)
            | Part::Contact(_)
            | Part::Line(_)
            | Part::Marker(_)
            | Part::Use(_) => None,
        }?;
        let dimension = coordinate.dimension();
        Some(Subject::Expression(Expr::Quantity(Quantity::Coordinate(coordinate)), dimension))
    }

    /// A number that is known at expansion and at least one.
    pub(super) fn exponent(&mut self, entry: &'d Entry, what: &str) -> Option<Vec<Expr>> {
        let exponent = self.number(entry, Dimension::ONE, what)?;
        if exponent < 1.0 {
            self.diagnostics.error(entry.value.region, messages::exponent_below_one(what, exponent));
            return None;
        }
        Some(vec![Expr::Number(exponent)])
    }

    /// The elements of a backbone: a stiffness that never yields, then of each element the way at which it yields and its stiffness.
    pub(super) fn backbone(&mut self, entry: &'d Entry, way: Dimension) -> Option<Vec<Expr>> {
        let region = entry.value.region;
        let table = match (&entry.value.kind, &entry.unit) {
            (TermKind::Name(path), None) => self.names.table(&path.text),
            _ => None,
        };
        let Some(index) = table else {
            self.diagnostics.error(region, messages::backbone_is_a_table());
            return None;
        };
        let written = &self.definition.tables[index];
        self.used.insert((Scope::Table, &written.name.text));
        let table = self.tables.get(index)?.clone()?;
        let text = &table.name.text;
        if table.arguments.len() != 1 {
            self.diagnostics.error(region, messages::backbone_of_two(text));
            return None;
        }
        let effort = Dimension::TORQUE.over(way);
        for (what, expected, found) in [
            (messages::knot_of(text), way, table.arguments[0].dimension),
            (messages::value_of(text), effort, table.value.dimension),
        ] {
            if !found.fits(expected) {
                self.diagnostics.error(region, messages::wrong_unit(&what, expected, found));
                return None;
            }
        }
        if table.kind != Interpolation::Linear {
            self.diagnostics.error(region, messages::backbone_of_curves(text, table.kind.word()));
            return None;
        }
        match elements(&table) {
            Ok(elements) => Some(elements.into_iter().map(Expr::Number).collect()),
            Err((knot, message)) => {
                let place = written.read.as_ref().map(|read| {
                    let line = read.lines.get(knot).copied();
                    messages::in_line(&read.shown, line)
                });
                let shown = table.arguments[0].shown(table.knots[0][knot]) + &place.unwrap_or_default();
                let at = match &written.data {
                    TableData::Points(points) if written.read.is_none() => points[knot][0].region,
                    _ => region,
                };
                self.diagnostics.error(at, message(text, &shown));
                None
            }
        }
    }

    /// What a load exerts as one quantity: what makes a power of the rate of its way, a force where it has places.
    pub(super) fn effort(&mut self, load: &'d syntax::Load) -> Dimension {
        if load.form.acts().next() == Some(Acts::Rotor) {
            return Dimension::TORQUE;
        }
        // What is wrong with it is said where it is declared.
        let known = std::mem::replace(&mut self.diagnostics, Diagnostics::new());
        let subject = load.on.first().and_then(|first| self.subject(first, Acts::Way));
        self.diagnostics = known;
        match subject {
            Some(Subject::Expression(_, way)) => Dimension::TORQUE.over(way),
            _ => Dimension::FORCE,
        }
    }

    /// The states of the loads, behind those that are declared; each load is told which are its own.
    pub(super) fn states_of_loads(&mut self, loads: &mut [Load], states: &mut Vec<InternalState>) {
        let mut known: Vec<(String, Region)> =
            states.iter().map(|state| (state.name.identifier(), state.name.span)).collect();
        let components: Vec<usize> = loads.iter().map(|load| self.components(load, loads)).collect();
        for (id, load) in loads.iter_mut().enumerate() {
            let first = states.len();
            let owned = sizes(load, components[id]);
            for (which, (text, size)) in owned.into_iter().enumerate() {
                let name = Name { text, span: load.name.span };
                let identifier = name.identifier();
                if let Some((_, region)) = known.iter().find(|(other, _)| *other == identifier) {
                    let message = messages::state_of_load_taken(&load.name.text, &identifier);
                    self.diagnostics.conflict(
                        load.name.span,
                        message,
                        *region,
                        messages::first_here(&identifier),
                    );
                }
                known.push((identifier, load.name.span));
                states.push(InternalState {
                    name,
                    unit: unit_of(load),
                    docs: String::new(),
                    start: Expr::Number(0.0),
                    scale: fold::evaluate(&size, self.defaults()).filter(|size| *size > 0.0),
                    rate: Rate::OfLoad(LoadId(id), which),
                });
            }
            load.states = first..states.len();
        }
    }
}

impl Lowering<'_> {
    /// How many components the sliding of a friction has, in all that slides.
    fn components(&self, load: &Load, loads: &[Load]) -> usize {
        match load.on.first() {
            Some(Subject::Bearing(joint, _)) => match self.definition.joints[joint.0].form.bearing {
                Some(Bearing::Ball | Bearing::Knuckle | Bearing::Face) => 3,
                Some(Bearing::Cross | Bearing::Sleeve | Bearing::Spot) => 2,
                Some(Bearing::Pin | Bearing::Rail | Bearing::Point | Bearing::Curve | Bearing::Thread)
                | None => 1,
            },
            Some(Subject::Touches(contact)) => {
                let each = |sliding: &Sliding| match sliding {
                    Sliding::Along(_) => 1,
                    Sliding::Surfaces(_) if self.definition.space == Space::Planar => 1,
                    Sliding::Surfaces(_) => 3,
                };
                // Where a load was refused, which is said, the others are not where they belong.
                loads.get(contact.0).map_or(0, |contact| contact.slides.iter().map(each).sum())
            }
            _ => 0,
        }
    }
}

/// The names and sizes of a load's states; of a friction as many as its sliding has components.
fn sizes(load: &Load, components: usize) -> Vec<(String, Expr)> {
    let argument = |name: &str| {
        let at = load.form.call.named.iter().position(|argument| argument.name == name);
        at.map_or(&[][..], |at| &load.values[at][..])
    };
    let owner = &load.name.text;
    match load.form.owns {
        None => Vec::new(),
        Some(Owned::One { name, size }) => {
            argument(size).iter().map(|size| (format!("{owner}.{name}"), size.clone())).collect()
        }
        Some(Owned::Bristles { name, most, stiffness }) => {
            let first = |name| argument(name).first().cloned();
            let size = first(most).zip(first(stiffness));
            let size = size.map(|(most, stiffness)| fold::binary(Function2::Div, most, stiffness));
            let named = |which: usize| match components {
                1 => format!("{owner}.{name}"),
                _ => format!("{owner}.{name}[{which}]"),
            };
            (0..components).filter_map(|which| Some((named(which), size.clone()?))).collect()
        }
        Some(Owned::Elements { name, backbone }) => {
            let elements = argument(backbone).get(1..).unwrap_or_default().chunks(2).enumerate();
            elements
                .map(|(index, element)| (format!("{owner}.{name}[{index}]"), element[0].clone()))
                .collect()
        }
    }
}

/// SI.
fn unit_of(load: &Load) -> DeclaredUnit {
    let text = match load.on.first() {
        Some(Subject::Expression(_, way) | Subject::Bearing(_, way)) => way.to_string(),
        Some(Subject::Touches(_)) => Dimension::LENGTH.to_string(),
        _ => "1".to_string(),
    };
    DeclaredUnit { text: text.clone(), scale: 1.0, si: text }
}

/// Of a backbone F through (xᵢ, Fᵢ) with slopes sᵢ up to xᵢ: element i has the stiffness sᵢ − sᵢ₊₁ and yields at xᵢ, so that those
/// which have not yielded have the slope together (Iwan, J. Appl. Mech. 33 (1966) 893). What is left at the end never yields.
fn elements(table: &Table) -> Result<Vec<f64>, Wrong> {
    let (x, f) = (&table.knots[0], &table.values[0]);
    let largest = f.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let near = |a: f64, b: f64| (a - b).abs() <= ROUNDING * largest;
    if let Some(zero) = x.iter().position(|x| *x == 0.0).filter(|zero| !near(f[*zero], 0.0)) {
        return Err((zero, messages::backbone_beside_origin));
    }
    let below = x.iter().take_while(|x| **x < 0.0).count();
    if below == 0 && x[0] != 0.0 {
        return Err((0, messages::backbone_beside_origin));
    }
    let first = if x.get(below) == Some(&0.0) { below + 1 } else { below };
    for (knot, (at, force)) in x.iter().zip(f).take(below).enumerate() {
        let mirrored = x.len() - 1 - knot;
        if mirrored < first || (x[mirrored] + at).abs() > ROUNDING * at.abs() || !near(f[mirrored], -force) {
            return Err((knot, messages::backbone_not_odd));
        }
    }
    if below > 0 && x.len() - first != below {
        return Err((x.len() - 1, messages::backbone_not_odd));
    }
    let (mut slopes, mut from) = (Vec::new(), (0.0, 0.0));
    for knot in first..x.len() {
        let slope = (f[knot] - from.1) / (x[knot] - from.0);
        let steepest = slopes.first().copied().unwrap_or(slope);
        if slope < -ROUNDING * steepest || steepest <= 0.0 {
            return Err((knot, messages::backbone_falls));
        }
        if slopes.last().is_some_and(|before| slope > before + ROUNDING * steepest) {
            return Err((knot - 1, messages::backbone_convex));
        }
        slopes.push(slope);
        from = (x[knot], f[knot]);
    }
    let steepest = slopes.first().copied().unwrap_or_default();
    let beyond = match table.outside {
        Outside::Linear => slopes.last().copied().unwrap_or_default(),
        Outside::Hold => 0.0,
    };
    let mut elements = vec![beyond];
    let next = slopes[1..].iter().copied().chain([beyond]);
    for ((knot, slope), next) in (first..).zip(&slopes).zip(next) {
        if slope - next > ROUNDING * steepest {
            elements.extend([x[knot], slope - next]);
        }
    }
    if elements.len() == 1 {
        return Err((x.len() - 1, messages::backbone_straight));
    }
    Ok(elements)
}
