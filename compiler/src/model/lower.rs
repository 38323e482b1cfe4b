//! [`syntax::Definition`] → [`Mechanism`]: names become ids, units SI, expressions are checked for dimension and
//! for what they may depend on. The order of the steps is the order of what they need from each other.
//!
//! A step that meets an error pushes it and leaves its element out; a later element that refers to it stays silent.
//! The mechanism is returned only if there was no error at all, so ids are always the positions in the definition.

use super::contacts::Contacts;
use super::fold;
use super::friction;
use super::names::Names;
use super::signals::Signals;
use super::unused::{self, Scope};
use super::written;
use super::{
    Axes, Constraint, ConstraintKind, Coupled, Coupling, DeclaredUnit, Driver, Expr, Function2, Input,
    Mechanism, Name, Output, Parameter, Rotor, StartCondition, StartOrientation, Subject, Vector,
};
use crate::beams::Slender;
use crate::diagnostics::Diagnostics;
use crate::forms::Acts;
use crate::messages;
use crate::syntax::{self, ConstraintTerm, Definition, Entry, Label, SubjectTerm};
use crate::units::Dimension;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// Lowers a definition. All errors are reported.
pub fn lower(definition: &Definition) -> Result<Mechanism, Diagnostics> {
    let mut diagnostics = Diagnostics::new();
    let names = Names::new(definition, &mut diagnostics);
    let mut lowering = Lowering {
        definition,
        diagnostics,
        names,
        constants: Vec::new(),
        bodies: Vec::new(),
        equations: Vec::new(),
        lines: Vec::new(),
        markers: HashMap::new(),
        defaults: Vec::new(),
        signals: Signals::of(definition),
        contacts: Contacts::of(definition),
        tables: Vec::new(),
        kinks: Vec::new(),
        used: HashSet::new(),
    };

    lowering.constants();
    lowering.all_tables();
    let parameters = lowering.each(&definition.parameters, Lowering::parameter);
    lowering.defaults = parameters.iter().map(|parameter| parameter.default).collect();
    lowering.body_frames();
    lowering.ground_markers();
    lowering.ground_lines();
    // AFTER THIS POINT every place can be resolved.
    lowering.given();
    if !lowering.diagnostics.is_empty() && !definition.uses.is_empty() {
        // Inside of parts the same would be said again.
        return Err(lowering.diagnostics);
    }
    let mut mechanism = Mechanism {
        space: definition.space,
        name: name(&definition.name),
        visibility: definition.visibility.to_string(),
        attributes: definition.attributes.to_string(),
        parameters,
        inputs: lowering.each(&definition.inputs, Lowering::input),
        states: Vec::new(),
        memories: Vec::new(),
        events: Vec::new(),
        signals: lowering.each(&definition.signals, Lowering::named_signal),
        gravity: lowering.gravity(),
        gravity_span: definition.gravity.as_ref().map(|tuple| tuple.region),
        bodies: lowering.each(&definition.bodies, Lowering::body),
        joints: lowering.each(&definition.joints, Lowering::joint),
        constraints: lowering.each(&definition.constraints, Lowering::constraint),
        drivers: lowering.each(&definition.drivers, Lowering::driver),
        loads: {
            let loads = lowering.each(&definition.loads, Lowering::load);
            let contacts = lowering.each(&definition.contacts, Lowering::contact);
            let penalties = definition.joints.iter().filter_map(|joint| joint.penalty.as_ref());
            let penalties: Vec<_> = penalties.filter_map(|load| lowering.load(load)).collect();
            loads.into_iter().chain(contacts).chain(penalties).collect()
        },
        surfaces: lowering.contacts.named(),
        start: lowering.each(&definition.start, Lowering::start_condition),
        steady: lowering.steady(),
        deflected: lowering.deflected(),
        orientations: lowering.each(&definition.orientations, Lowering::start_orientation),
        options: lowering.options(),
        expect: lowering.expect(),
        outputs: lowering.each(&definition.outputs, Lowering::output),
        tables: Vec::new(),
        pairs: Vec::new(),
        parts: lowering.used_parts(),
        kinks: Vec::new(),
        unused: Vec::new(),
        allowed: definition.allowed.clone(),
        lengths: written::lengths(definition),
    };
    Lowering::modes_at_rest(&mut mechanism);
    mechanism.states = lowering.states();
    mechanism.memories = lowering.each(&definition.memories, Lowering::memory);
    mechanism.events = lowering.events(&mechanism.drivers);
    friction::number(&mut mechanism.loads);
    lowering.all_signals();
    lowering.slides(&mut mechanism.loads);
    lowering.states_of_loads(&mut mechanism.loads, &mut mechanism.states);
    mechanism.tables = std::mem::take(&mut lowering.tables).into_iter().flatten().collect();
    mechanism.kinks = std::mem::take(&mut lowering.kinks);
    mechanism.unused = unused::unused(definition, &lowering.used);
    if lowering.diagnostics.is_empty() {
        super::gears::settle(&mut mechanism, &mut lowering.diagnostics);
    }
    lowering.diagnostics.finish(mechanism)
}

/// What is known while lowering.
pub(super) struct Lowering<'d> {
    pub definition: &'d Definition,
    pub diagnostics: Diagnostics,
    pub names: Names<'d>,
    /// SI values; `None` after an error.
    pub constants: Vec<Option<f64>>,
    pub bodies: Vec<BodyFrame<'d>>,
    /// Of the sides of equations, constraint by constraint; `None` of couplings and after an error.
    pub equations: Vec<Option<Dimension>>,
    /// Lines of the ground, both ends; `None` after an error.
    pub lines: Vec<Option<[Vector; 2]>>,
    /// Markers of the ground; `None` after an error.
    pub markers: HashMap<&'d str, Option<(Vector, Axes)>>,
    /// Of the parameters.
    pub defaults: Vec<f64>,
    pub signals: Signals,
    pub contacts: Contacts,
    /// `None` after an error; as long as the definition's once they are known.
    pub tables: Vec<Option<super::tables::Table>>,
    pub kinks: Vec<super::Kink>,
    /// What has been named so far.
    pub used: HashSet<(Scope, &'d str)>,
}

/// The named places of a body.
#[derive(Default)]
pub(super) struct BodyFrame<'d> {
    pub center: Option<Vector>,
    /// `None` after an error.
    pub points: HashMap<&'d str, Option<Vector>>,
    pub markers: HashMap<&'d str, Option<(Vector, Axes)>>,
    pub lines: HashMap<&'d str, Option<[Vector; 2]>>,
    /// Of a beam whose length is known.
    pub slender: Option<Arc<Slender>>,
}

/// What an expression may depend on, and how its message calls it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Use {
    pub what: &'static str,
    pub parameters: bool,
    pub time: bool,
    pub inputs: bool,
    /// With rates of their own.
    pub states: bool,
    pub positions: bool,
    pub velocities: bool,
    /// Efforts, powers and energies.
    pub results: bool,
    /// Whether accelerations follow what it is of.
    pub accelerates: bool,
}

impl Use {
    pub const CONSTANT: Self = Self {
        what: "a constant or default value",
        parameters: false,
        time: false,
        inputs: false,
        states: false,
        positions: false,
        velocities: false,
        results: false,
        accelerates: false,
    };
    pub const TABLE: Self = Self { what: "a table", ..Self::CONSTANT };
    pub const PROPERTY: Self = Self { what: "a property of a body", parameters: true, ..Self::CONSTANT };
    pub const COEFFICIENT: Self = Self { what: "this argument", ..Self::PROPERTY };
    pub const DIRECTION: Self = Self { what: "a direction", ..Self::PROPERTY };
    pub const GRAVITY: Self = Self { what: "gravity", ..Self::PROPERTY };
    pub const RANGE: Self = Self { what: "an expected range", ..Self::CONSTANT };
    pub const START: Self = Self { what: "a start value", ..Self::PROPERTY };
    pub const GROUND: Self =
        Self { what: "a place of the ground", time: true, accelerates: true, ..Self::PROPERTY };
    pub const LENGTH: Self = Self { what: "the length of a distance joint", ..Self::GROUND };
    pub const LAW: Self = Self { what: "the law of a driver", ..Self::GROUND };
    pub const EQUATION: Self = Self { what: "a constraint", positions: true, ..Self::GROUND };
    pub const CURVE: Self = Self { what: "a curve", time: false, ..Self::EQUATION };
    pub const LOAD: Self = Self {
        what: "the law of a load",
        inputs: true,
        states: true,
        velocities: true,
        accelerates: false,
        ..Self::EQUATION
    };
    pub const HELD_LAW: Self =
        Self { what: "the law of a contact whose gates are held", inputs: false, ..Self::LOAD };
    pub const EVENT: Self = Self { what: "the condition of an event", inputs: false, ..Self::LOAD };
    pub const PERIOD: Self = Self { what: "the period of an event", ..Self::CONSTANT };
    pub const ASSIGNED: Self = Self { what: "what an event sets a memory to", ..Self::OUTPUT };
    pub const VARYING: Self = Self { what: "this argument", velocities: false, ..Self::LOAD };
    pub const OUTPUT: Self = Self { what: "an output", results: true, ..Self::LOAD };
    pub const STATE_RATE: Self = Self { what: "the rate of a state", ..Self::OUTPUT };
    pub const SIGNAL: Self = Self { what: "a signal", ..Self::OUTPUT };
    pub const RATE: Self = Self { what: "a rate", accelerates: false, ..Self::EQUATION };
    pub const ALONG: Self = Self { what: "what a force acts along", accelerates: false, ..Self::EQUATION };

    /// What it may depend on beside constants, in words.
    pub fn permitted(&self) -> Vec<&'static str> {
        let kinds = [
            (self.parameters, "parameters"),
            (self.time, "time"),
            (self.inputs, "inputs"),
            (self.states, "states"),
            (self.positions, "positions"),
            (self.velocities, "velocities"),
        ];
        kinds.into_iter().filter(|(permitted, _)| *permitted).map(|(_, name)| name).collect()
    }
}

/// The name of a label.
pub(super) fn name(label: &Label) -> Name {
    Name { text: label.text.clone(), span: label.region }
}

/// The unit as written, `1` if none.
pub(super) fn declared_unit(unit: Option<&syntax::WrittenUnit>) -> DeclaredUnit {
    let Some(written) = unit else {
        return DeclaredUnit { text: "1".to_string(), scale: 1.0, si: "1".to_string() };
    };
    let (text, scale) = (written.unit.text.clone(), written.unit.scale);
    let si = if scale == 1.0 { text.clone() } else { written.unit.dimension.to_string() };
    DeclaredUnit { text, scale, si }
}

/// What an entry measures by the unit beside its name.
pub(super) fn declared(unit: Option<&syntax::WrittenUnit>) -> Dimension {
    unit.map_or(Dimension::ONE, |written| written.unit.dimension)
}

impl<'d> Lowering<'d> {
    /// All elements that lower without an error.
    pub fn each<S, T>(&mut self, elements: &'d [S], lower: impl Fn(&mut Self, &'d S) -> Option<T>) -> Vec<T> {
        elements.iter().filter_map(|element| lower(self, element)).collect()
    }

    /// Defaults of all parameters, as far as they are numbers; errors are said where parameters are lowered.
    pub(super) fn defaults(&self) -> &[f64] {
        &self.defaults
    }

    fn parameter(&mut self, parameter: &'d syntax::Parameter) -> Option<Parameter> {
        let dimension = declared(parameter.entry.unit.as_ref());
        let what = &messages::quoted(&parameter.name.text);
        let default = self.declared_number("param", &parameter.name.text, &parameter.entry);
        let bound = |this: &mut Self, value: &syntax::Term| {
            let entry = Entry { unit: parameter.entry.unit.clone(), value: value.clone() };
            this.number(&entry, dimension, what)
        };
        let bounds = match &parameter.bounds {
            Some((minimum, maximum)) => Some(bound(self, minimum).zip(bound(self, maximum))?),
            None => None,
        };
        Some(Parameter {
            name: name(&parameter.name),
            unit: declared_unit(parameter.entry.unit.as_ref()),
            default: default?,
            bounds,
            docs: parameter.docs.to_string(),
        })
    }

    fn input(&mut self, input: &'d syntax::Input) -> Option<Input> {
        Some(Input {
            name: name(&input.name),
            unit: declared_unit(input.unit.as_ref()),
            docs: input.docs.to_string(),
        })
    }

    fn gravity(&mut self) -> Option<Vector> {
        let tuple = self.definition.gravity.as_ref()?;
        self.vector(tuple, Dimension::ACCELERATION, Use::GRAVITY, "gravity")
    }

    fn constraint(&mut self, constraint: &'d syntax::Constraint) -> Option<Constraint> {
        let mut sides = None;
        let found = self.constrained(constraint, &mut sides);
        self.equations.push(sides);
        found
    }

    /// Also the dimension of the sides of an equation.
    fn constrained(
        &mut self,
        constraint: &'d syntax::Constraint,
        sides: &mut Option<Dimension>,
    ) -> Option<Constraint> {
        let kind = match &constraint.kind {
            ConstraintTerm::Coupling { form, kind, on, factor, phase } => {
                let coupled: Vec<_> =
                    on.iter().zip(kind.on).map(|(written, (_, acts))| self.coupled(written, acts)).collect();
                let (name, dimension) = kind.factor;
                let factor = self.entry(factor, dimension, Use::COEFFICIENT, name);
                let phase = self.phase(phase.as_ref(), kind.phase)?;
                let coupled: Vec<Coupled> = coupled.into_iter().collect::<Option<_>>()?;
                let on = coupled.try_into().ok()?;
                ConstraintKind::Coupling(Coupling { form, kind, on, factor: factor?, phase })
            }
            ConstraintTerm::Teeth { form, on } => {
                let ids: Vec<_> = on.iter().map(|written| self.subject(written, Acts::Toothing)).collect();
                let ids: Vec<_> = ids.into_iter().collect::<Option<_>>()?;
                match ids[..] {
                    [Subject::Toothing(first), Subject::Toothing(second)] => {
                        ConstraintKind::Teeth { form, on: [first, second], pair: 0 }
                    }
                    _ => return None,
                }
            }
            ConstraintTerm::Equation { left, right } => {
                let (left, right) = (self.value(left, Use::EQUATION), self.value(right, Use::EQUATION));
                let (left, right) = (left?, right?);
                self.same(&left, &right, "the two sides of the constraint")?;
                *sides = Some(if left.zero { right.dimension } else { left.dimension });
                ConstraintKind::Equation { residual: fold::binary(Function2::Sub, left.expr, right.expr) }
            }
        };
        Some(Constraint { name: name(&constraint.name), kind })
    }

    fn coupled(&mut self, written: &'d SubjectTerm, acts: Acts) -> Option<Coupled> {
        match self.subject(written, acts)? {
            Subject::Rotor(Rotor::Body(body)) if self.has_mean_direction(body) => {
                let message = self.torque_on_mean(body);
                self.diagnostics.error(written.region(), message);
                None
            }
            Subject::Rotor(rotor) => Some(Coupled::Angle(rotor)),
            Subject::Travel(joint) => Some(Coupled::Travel(joint)),
            // Forms of couplings name coordinates only.
            Subject::Place(_)
            | Subject::Bearing(..)
            | Subject::Joint(_)
            | Subject::Touches(_)
            | Subject::Body(_)
            | Subject::Expression(..)
            | Subject::Toothing(_) => None,
        }
    }

    /// `Some(None)` if it was not given, `None` after an error.
    fn phase(&mut self, phase: Option<&'d Entry>, dimension: Dimension) -> Option<Option<Expr>> {
        match phase {
            Some(entry) => self.entry(entry, dimension, Use::COEFFICIENT, "phase").map(Some),
            None => Some(None),
        }
    }

    fn driver(&mut self, driver: &'d syntax::Driver) -> Option<Driver> {
        let coordinate = self.coordinate(&driver.quantity, "be driven");
        let law = self.value(&driver.law, Use::LAW);
        let coordinate = coordinate?;
        let what = messages::quoted(&driver.quantity.text);
        let law = self.expect_dimension(law?, coordinate.dimension(), &what)?;
        Some(Driver { name: name(&driver.name), coordinate, law })
    }

    fn start_condition(&mut self, start: &'d syntax::StartEntry) -> Option<StartCondition> {
        let (coordinate, rate, dimension) = self.coordinate_or_rate(&start.quantity)?;
        if !start.exact && rate {
            self.diagnostics.error(start.quantity.region, messages::guessed_rate(&start.quantity.text));
            return None;
        }
        let what = messages::quoted(&start.quantity.text);
        let value = self.entry(&start.entry, dimension, Use::START, &what)?;
        let region = start.quantity.region;
        Some(StartCondition {
            coordinate,
            rate,
            text: start.quantity.text.clone(),
            value,
            exact: start.exact,
            span: region,
        })
    }

    fn start_orientation(&mut self, start: &'d syntax::OrientationEntry) -> Option<StartOrientation> {
        let body = self.oriented_body(&start.quantity)?;
        let what = messages::quoted(&start.quantity.text);
        let values = self.tuple(&start.value, Dimension::ONE, Use::START, &what)?;
        let quaternion: [Expr; 4] = values.try_into().ok()?;
        if quaternion.iter().all(|value| matches!(value, Expr::Number(0.0))) {
            self.diagnostics.error(start.value.region, messages::zero_quaternion());
            return None;
        }
        Some(StartOrientation { body, quaternion, exact: start.exact, span: start.quantity.region })
    }

    fn output(&mut self, output: &'d syntax::Output) -> Option<Output> {
        let value = self.declaration("output", &output.name.text, &output.entry, Use::OUTPUT)?;
        Some(Output {
            name: name(&output.name),
            unit: declared_unit(output.entry.unit.as_ref()),
            docs: output.docs.to_string(),
            value,
        })
    }
}
