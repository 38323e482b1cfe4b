//! Static rules: what can be said of a mechanism before it is put together. One function a rule; the comment above
//! it is the rule as the user could read it.
//!
//! Values of parameters are judged at their defaults. Rank, mobility and whether loops close are left to `assemble`.

use super::friction::loops_of_friction_are_small;
use crate::diagnostics::Diagnostics;
use crate::forms::Sign;
use crate::messages;
use crate::model::{
    BodyId, ConstraintKind, Coordinate, Expr, Frame, Mechanism, Name, NamedLine, Quantity, Rotor, Space,
    Subject, Vector, fold,
};
use std::collections::HashMap;

/// The rules in the order they are reported.
const RULES: [fn(&Mechanism, &mut Diagnostics); 24] = [
    has_bodies,
    is_of_a_size_to_write_out,
    bounds_hold_the_default,
    mass_is_not_negative,
    dimensions_are_positive,
    inertia_is_not_negative,
    inertia_belongs_to_a_body,
    lines_have_two_ends,
    axes_point_somewhere,
    lengths_are_not_negative,
    sizes_of_loads_are_positive,
    couplings_couple,
    super::gears::pairs_mesh,
    super::gears::planets_pass,
    equations_move,
    drivers_differ,
    start_is_said_once,
    orientations_are_said_once,
    cuts_differ,
    loads_act_on_bodies,
    super::penalty::what_yields_is_not_cut,
    loops_of_friction_are_small,
    super::beams::frequencies,
    super::beams::starts,
];

/// Applies all rules.
pub fn check(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for rule in RULES {
        rule(mechanism, diagnostics);
    }
}

/// The value of an expression of parameters at their defaults.
pub(super) fn at_defaults(mechanism: &Mechanism, expr: &Expr) -> Option<f64> {
    if let Expr::Number(value) = expr {
        return Some(*value);
    }
    fold::evaluate(expr, &mechanism.defaults())
}

// A mechanism has at least one body.
fn has_bodies(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    if mechanism.bodies.is_empty() {
        diagnostics.error(mechanism.name.span, messages::no_bodies(&mechanism.name.text, mechanism.space));
    }
}

// A definition has a bounded size, or the build would not end; what its equations take is judged by `check::size`.
fn is_of_a_size_to_write_out(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    const MOST_BODIES: usize = 2048;
    const MOST_CONSTRAINTS: usize = 4096;
    const MOST_LOADS: usize = 2048;
    const MOST_VALUES: usize = 1024;
    const MOST_HELD: usize = 256;
    const MOST_TABLES: usize = 256;
    fn names<'a>(names: impl Iterator<Item = &'a Name> + 'a) -> Vec<&'a Name> {
        names.collect()
    }
    // Many more than three of them for each body can only repeat one another, and finding out which takes their cube.
    let most_constraints = MOST_CONSTRAINTS.min(3 * mechanism.bodies.len() + 32);
    let joints = mechanism.joints.iter().map(|joint| &joint.name);
    let constraints = mechanism.constraints.iter().map(|constraint| &constraint.name);
    let drivers = mechanism.drivers.iter().map(|driver| &driver.name);
    let parameters = mechanism.parameters.iter().map(|parameter| &parameter.name);
    let inputs = mechanism.inputs.iter().map(|input| &input.name);
    let states = mechanism.states.iter().map(|state| &state.name);
    let outputs = mechanism.outputs.iter().map(|output| &output.name);
    let memories = mechanism.memories.iter().map(|memory| &memory.name);
    let events = mechanism.events.iter().map(|event| &event.name);
    for (what, names, most) in [
        ("memories and events", names(memories.chain(events)), MOST_HELD),
        ("bodies", names(mechanism.bodies.iter().map(|body| &body.name)), MOST_BODIES),
        (
            "joints, constraints and drivers",
            names(joints.chain(constraints).chain(drivers)),
            most_constraints,
        ),
        ("loads", names(mechanism.loads.iter().map(|load| &load.name)), MOST_LOADS),
        ("tables", names(mechanism.tables.iter().map(|table| &table.name)), MOST_TABLES),
        (
            "parameters, inputs, states and outputs",
            names(parameters.chain(inputs).chain(states).chain(outputs)),
            MOST_VALUES,
        ),
    ] {
        if let Some(first) = names.get(most) {
            diagnostics.error(first.span, messages::too_many(what, names.len(), most, &first.text));
        }
    }
}

// The default of a parameter lies between its bounds.
fn bounds_hold_the_default(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for parameter in &mechanism.parameters {
        let Some((minimum, maximum)) = parameter.bounds else { continue };
        let name = &parameter.name.text;
        if minimum > maximum {
            diagnostics.error(parameter.name.span, messages::empty_bounds(name));
        } else if !(minimum..=maximum).contains(&parameter.default) {
            let message = messages::default_out_of_bounds(name, parameter.default, minimum, maximum);
            diagnostics.error(parameter.name.span, message);
        }
    }
}

// A mass is not negative.
fn mass_is_not_negative(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for body in &mechanism.bodies {
        if let Some(mass) = at_defaults(mechanism, &body.mass).filter(|mass| *mass < 0.0) {
            diagnostics.error(body.mass_span, messages::negative("mass", &body.name.text, mass, "kg"));
        }
    }
}

// The lengths of a shape are positive at the defaults of parameters; numbers have been judged where they are written.
fn dimensions_are_positive(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for body in &mechanism.bodies {
        for (what, length) in &body.dimensions {
            if let Some(length) = at_defaults(mechanism, length).filter(|length| *length <= 0.0) {
                let message = messages::not_positive(what, &body.name.text, length);
                diagnostics.error(body.name.span, message);
            }
        }
    }
}

// A moment of inertia is not negative.
fn inertia_is_not_negative(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for body in &mechanism.bodies {
        // A shape's inertia takes its sign from the mass, which has been judged.
        let follows = at_defaults(mechanism, &body.mass).is_some_and(|mass| mass < 0.0);
        let moments = body.inertia.moments.iter().filter_map(|moment| at_defaults(mechanism, moment));
        if let Some(inertia) = moments.into_iter().find(|inertia| *inertia < 0.0 && !follows) {
            let message = messages::negative("moment of inertia", &body.name.text, inertia, "kg*m^2");
            diagnostics.error(body.inertia_span, message);
        }
    }
}

// In space the inertia tensor is positive, and any two of its principal moments together are at least the third.
fn inertia_belongs_to_a_body(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    if mechanism.space == Space::Planar {
        return;
    }
    for body in &mechanism.bodies {
        let value = |expr: &Expr| at_defaults(mechanism, expr);
        let moments: Vec<f64> = body.inertia.moments.iter().filter_map(value).collect();
        let products: Vec<f64> = body.inertia.products.iter().filter_map(value).collect();
        let ([xx, yy, zz], [xy, xz, yz]) = (moments.as_slice(), products.as_slice()) else { continue };
        if [xx, yy, zz].iter().any(|moment| **moment < 0.0) {
            // Said already.
            continue;
        }
        let [a, b, c] = principal_moments([[*xx, *xy, *xz], [*xy, *yy, *yz], [*xz, *yz, *zz]]);
        // Rounding, and the digits to which data are printed.
        let slack = 1e-6 * c;
        let name = &body.name.text;
        if a < -slack {
            diagnostics.error(body.inertia_span, messages::inertia_not_positive(name, a));
        } else if a + b < c - slack && !mechanism.options.accept_inertia {
            diagnostics.error(body.inertia_span, messages::inertia_of_no_body(name, [a, b, c]));
        }
    }
}

/// Eigenvalues of a symmetric matrix, ascending, by Jacobi's rotations.
fn principal_moments(mut m: [[f64; 3]; 3]) -> [f64; 3] {
    for _ in 0..30 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if m[p][q] == 0.0 {
                continue;
            }
            let theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
            let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
            let c = 1.0 / (t * t + 1.0).sqrt();
            let s = t * c;
            for row in &mut m {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            let (one, other) = (m[p], m[q]);
            m[p] = [0, 1, 2].map(|k| c * one[k] - s * other[k]);
            m[q] = [0, 1, 2].map(|k| s * one[k] + c * other[k]);
        }
    }
    let mut moments = [m[0][0], m[1][1], m[2][2]];
    moments.sort_by(f64::total_cmp);
    moments
}

// A line goes through two different points.
fn lines_have_two_ends(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for body in &mechanism.bodies {
        for line in &body.lines {
            if is_zero(mechanism, &fold::between(&line.from, &line.to)) {
                diagnostics.error(line.name.span, messages::line_without_length(&line.name.text));
            }
        }
    }
    for joint in mechanism.joints.iter().filter(|joint| joint.form.has_line()) {
        // A line with a name has been judged where it is declared.
        let is_it = |line: &NamedLine| {
            line.from == joint.first.at && fold::between(&line.from, &line.to) == *joint.direction(0)
        };
        let named = matches!(joint.first.frame, Frame::Body(body)
            if mechanism.bodies[body.0].lines.iter().any(is_it));
        if !named && is_zero(mechanism, joint.direction(0)) {
            diagnostics.error(joint.first.span, messages::line_without_length(&joint.first.text));
        }
    }
}

fn is_zero(mechanism: &Mechanism, direction: &Vector) -> bool {
    direction.iter().all(|component| at_defaults(mechanism, component) == Some(0.0))
}

// The axis of a joint is not zero.
fn axes_point_somewhere(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for joint in mechanism.joints.iter().filter(|joint| !joint.form.has_line()) {
        if joint.directions.iter().any(|axis| is_zero(mechanism, axis)) {
            diagnostics.error(joint.name.span, messages::zero_direction("axis", mechanism.space));
        }
    }
}

// The length of a spring is not negative.
fn lengths_are_not_negative(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for load in &mechanism.loads {
        // What is not written may be as another.
        let mut said: Option<&Expr> = None;
        let lengths = load.arguments().filter(|(argument, _)| argument.sign == Sign::NotNegative);
        for (argument, value) in lengths.flat_map(|(it, values)| values.iter().map(move |value| (it, value)))
        {
            if let Some(length) = at_defaults(mechanism, value).filter(|length| *length < 0.0)
                && said.replace(value) != Some(value)
            {
                let unit = argument.dimension().map(|dimension| dimension.to_string()).unwrap_or_default();
                let message = messages::negative(argument.name, &load.name.text, length, &unit);
                diagnostics.error(load.name.span, message);
            }
        }
    }
}

// What must be positive of a load is it at the defaults of parameters.
fn sizes_of_loads_are_positive(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for load in &mechanism.loads {
        let sizes = load.arguments().filter(|(argument, _)| argument.sign == Sign::Positive);
        for (argument, value) in sizes.flat_map(|(it, values)| values.iter().map(move |value| (it, value))) {
            if let Some(size) = at_defaults(mechanism, value).filter(|size| *size <= 0.0) {
                let message = messages::size_of_load(argument.name, &load.name.text, size);
                diagnostics.error(load.name.span, message);
            }
        }
    }
}

// A gear couples two different things, and its ratio and a rack's radius are not zero.
fn couplings_couple(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for constraint in &mechanism.constraints {
        let ConstraintKind::Coupling(coupling) = &constraint.kind else { continue };
        let (what, _) = coupling.kind.factor;
        let name = &constraint.name;
        if coupling.driven() == coupling.other() {
            diagnostics.error(name.span, messages::coupled_with_itself(&name.text));
        } else if at_defaults(mechanism, &coupling.factor) == Some(0.0) {
            diagnostics.error(name.span, messages::zero_factor(&name.text, what));
        }
    }
}

// A constraint names at least one quantity that can move.
fn equations_move(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for constraint in &mechanism.constraints {
        let ConstraintKind::Equation { residual } = &constraint.kind else { continue };
        let mut moves = false;
        residual.quantities(&mut |_| moves = true);
        if !moves {
            diagnostics.error(constraint.name.span, messages::nothing_moves(&constraint.name.text));
        }
    }
}

// A quantity is driven once.
fn drivers_differ(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for (before, driver) in mechanism.drivers.iter().enumerate() {
        let mut before = mechanism.drivers[..before].iter();
        if let Some(first) = before.rfind(|first| first.coordinate == driver.coordinate) {
            let (name, first) = (&driver.name, &first.name);
            let message = messages::driven_twice(&name.text, &first.text);
            diagnostics.conflict(name.span, message, first.span, messages::first_here(&first.text));
        }
    }
}

// A start value is given once, as a condition or as a guess.
fn start_is_said_once(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for (before, start) in mechanism.start.iter().enumerate() {
        let mut before = mechanism.start[..before].iter();
        if let Some(first) = before.rfind(|it| (&it.coordinate, it.rate) == (&start.coordinate, start.rate)) {
            let message = messages::start_twice(&start.text);
            diagnostics.conflict(start.span, message, first.span, messages::first_here(&start.text));
        }
    }
}

// One start of an orientation is given.
fn orientations_are_said_once(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    let mut seen = HashMap::new();
    for start in &mechanism.orientations {
        if let Some(first) = seen.insert(start.body, start.span) {
            let text = format!("{}.orientation", mechanism.bodies[start.body.0].name.text);
            diagnostics.conflict(
                start.span,
                messages::start_twice(&text),
                first,
                messages::first_here(&text),
            );
        }
    }
}

// A joint is cut once.
fn cuts_differ(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    let mut seen = HashMap::new();
    for (joint, span) in &mechanism.options.cut {
        if let Some(first) = seen.insert(*joint, *span) {
            let name = &mechanism.joints[joint.0].name.text;
            diagnostics.conflict(*span, messages::cut_twice(name), first, messages::first_here(name));
        }
    }
}

// A force acts on a body.
fn loads_act_on_bodies(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for load in &mechanism.loads {
        match &load.on[..] {
            [Subject::Place(place)] if place.frame == Frame::Ground => {
                diagnostics.error(place.span, messages::force_on_ground(&load.name.text, &place.text));
            }
            [Subject::Rotor(first), Subject::Rotor(second)] if first == second => {
                diagnostics.error(load.name.span, messages::coupled_with_itself(&load.name.text));
            }
            _ => {}
        }
    }
}

/// Which bodies anything acts on.
pub(super) fn touched(mechanism: &Mechanism) -> Vec<bool> {
    let mut touched = vec![false; mechanism.bodies.len()];
    for joint in &mechanism.joints {
        touch(&mut touched, joint.first.frame);
        touch(&mut touched, joint.second.frame);
    }
    let mut coordinates: Vec<&Coordinate> =
        mechanism.drivers.iter().map(|driver| &driver.coordinate).collect();
    for constraint in &mechanism.constraints {
        match &constraint.kind {
            // The bodies of a joint have been touched by it.
            ConstraintKind::Coupling(coupling) => {
                coupling.rotors().for_each(|rotor| touch_rotor(&mut touched, rotor));
            }
            ConstraintKind::Equation { residual } => residual.quantities(&mut |quantity| {
                if let Quantity::Coordinate(coordinate) = quantity {
                    coordinates.push(coordinate);
                }
            }),
            ConstraintKind::Teeth { on, .. } => {
                on.iter().for_each(|id| touch(&mut touched, Frame::Body(id.body)));
            }
        }
    }
    for slip in mechanism.loads.iter().flat_map(|load| load.slips()) {
        slip.quantities(&mut |quantity| {
            if let Quantity::Coordinate(coordinate) = quantity {
                coordinates.push(coordinate);
            }
        });
    }
    for subject in mechanism.loads.iter().flat_map(|load| &load.on) {
        match subject {
            Subject::Place(place) => touch(&mut touched, place.frame),
            Subject::Rotor(rotor) => touch_rotor(&mut touched, *rotor),
            // The bodies of a joint have been touched by it.
            Subject::Travel(_) | Subject::Bearing(..) | Subject::Joint(_) => {}
            // Its contact touches them.
            Subject::Touches(_) => {}
            Subject::Body(body) => touch(&mut touched, Frame::Body(*body)),
            Subject::Toothing(id) => touch(&mut touched, Frame::Body(id.body)),
            Subject::Expression(expr, _) => expr.quantities(&mut |quantity| {
                if let Quantity::Coordinate(coordinate) = quantity {
                    coordinates.push(coordinate);
                }
            }),
        }
    }
    for coordinate in coordinates {
        match coordinate {
            Coordinate::Angle(rotor) => touch_rotor(&mut touched, *rotor),
            // The bodies of a joint have been touched by it; what a beam does in itself holds it nowhere.
            Coordinate::Travel(..) | Coordinate::Mode(..) | Coordinate::Closing(..) => {}
            Coordinate::Turn(body, _) | Coordinate::Deviation(body, _) => {
                touch(&mut touched, Frame::Body(*body))
            }
            Coordinate::Position(..)
            | Coordinate::Distance(..)
            | Coordinate::Way(..)
            | Coordinate::Square(..)
            | Coordinate::Direction(..) => {
                coordinate.places().for_each(|place| touch(&mut touched, place.frame));
            }
        }
    }
    touched
}

fn touch(touched: &mut [bool], frame: Frame) {
    if let Frame::Body(BodyId(index)) = frame {
        touched[index] = true;
    }
}

/// The bodies of a joint have been touched by it.
fn touch_rotor(touched: &mut [bool], rotor: Rotor) {
    if let Rotor::Body(body) = rotor {
        touch(touched, Frame::Body(body));
    }
}
