//! Mechanisms from programs: importers, generators, tools that have no source to point into.
//!
//! A [`Builder`] writes the definition statement by statement, in the words of the language, and hands it to the same stages as the
//! macro: whatever these check is checked, and what they say names the part (`joint "knee"`) in place of a line. The text is at
//! hand, to be shown or kept as a file for `mechanism!(file = "…")`.
//!
//! ```
//! use linkwright_compiler::builder::{Builder, Call, Value, ground};
//!
//! let mut pendulum = Builder::planar("Pendulum");
//! pendulum.gravity(&[0.0, -9.81]);
//! pendulum.body("rod", "arm").value("mass", 1.0, "kg").value("length", 0.5, "m");
//! pendulum.joint("hinge", Call::new("revolute").on(ground(&[0.0, 0.0])).on("arm.start"));
//! pendulum.start("hinge.angle", Value::quantity(30.0, "deg"));
//! let compiled = pendulum.compile(None).expect("a pendulum");
//! assert_eq!(compiled.mechanism.joints.len(), 1);
//! ```

mod messages;
mod value;

pub use value::{Call, Place, Value, ground};

use crate::compiled::Compiled;
use crate::diagnostics::Severity;
use crate::driver;
use crate::forms::{Interpolation, Outside};
use crate::model::Coordinates;
use crate::source::{self, Located, Source};
use std::fmt;
use std::ops::Range;
use value::{bracketed, checked_name, checked_path, number, tuple};

/// A definition in the making.
#[derive(Clone, Debug)]
pub struct Builder {
    head: String,
    name: String,
    statements: Vec<Statement>,
}

/// A part and how it is written, or why it cannot be.
#[derive(Clone, Debug)]
struct Statement {
    /// `joint "knee"`.
    part: String,
    text: Result<String, String>,
}

/// What is wrong with a part, or probably not meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    pub severity: Severity,
    /// `joint "knee"`; the mechanism where no part is to blame.
    pub part: String,
    /// What is wrong, why, and what to write instead.
    pub message: String,
    /// Other parts that it speaks of.
    pub notes: Vec<(String, String)>,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.part, self.message)?;
        self.notes.iter().try_for_each(|(part, note)| write!(f, "; {part}: {note}"))
    }
}

impl Builder {
    /// A mechanism of the plane.
    pub fn planar(name: &str) -> Self {
        Self::new("planar", name)
    }

    /// A mechanism of space.
    pub fn spatial(name: &str) -> Self {
        Self::new("spatial", name)
    }

    fn new(space: &str, name: &str) -> Self {
        let mut builder = Builder { head: String::new(), name: name.to_string(), statements: Vec::new() };
        match checked_name(name) {
            Ok(name) => builder.head = format!("pub {space} {name} {{"),
            Err(message) => {
                builder.head = format!("pub {space} Unnamed {{");
                builder.push(builder.whole(), Err(message));
            }
        }
        builder
    }

    fn whole(&self) -> String {
        format!("mechanism \"{}\"", self.name)
    }

    fn push(&mut self, part: String, text: Result<String, String>) {
        self.statements.push(Statement { part, text });
    }

    fn declared(&mut self, what: &str, name: &str, text: impl FnOnce(&str) -> Result<String, String>) {
        let text = checked_name(name).and_then(|name| text(&name));
        self.push(format!("{what} \"{name}\""), text);
    }

    /// A value that may be set at run time, with its default.
    pub fn parameter(&mut self, name: &str, default: f64, unit: &str) -> &mut Self {
        self.declared("parameter", name, |name| {
            Ok(format!("param {name} {} = {};", bracketed(unit)?, number(default)?))
        });
        self
    }

    /// The same within bounds.
    pub fn bounded(&mut self, name: &str, default: f64, bounds: Range<f64>, unit: &str) -> &mut Self {
        self.declared("parameter", name, |name| {
            let (least, most) = (number(bounds.start)?, number(bounds.end)?);
            Ok(format!("param {name} {} = {} in {least}..{most};", bracketed(unit)?, number(default)?))
        });
        self
    }

    /// A value that is given with every call.
    pub fn input(&mut self, name: &str, unit: &str) -> &mut Self {
        self.declared("input", name, |name| Ok(format!("input {name} {};", bracketed(unit)?)));
        self
    }

    /// The acceleration of gravity, m/s².
    pub fn gravity(&mut self, acceleration: &[f64]) -> &mut Self {
        self.push("gravity".to_string(), tuple(acceleration).map(|it| format!("gravity [m/s^2] = {it};")));
        self
    }

    /// A body of a kind such as `rod`, whose properties follow.
    pub fn body(&mut self, kind: &str, name: &str) -> Body<'_> {
        self.declared(kind, name, |name| Ok(format!("{} {name} {{ }}", checked_name(kind)?)));
        Body { statement: self.statements.last_mut() }
    }

    pub fn joint(&mut self, name: &str, kind: Call) -> &mut Self {
        self.declared("joint", name, |name| Ok(format!("joint {name}: {};", kind.text()?)));
        self
    }

    /// A coupling such as `gear`.
    pub fn coupling(&mut self, name: &str, kind: Call) -> &mut Self {
        self.declared("coupling", name, |name| Ok(format!("constraint {name}: {};", kind.text()?)));
        self
    }

    /// left = right, of positions.
    pub fn equation(&mut self, name: &str, left: impl Into<Value>, right: impl Into<Value>) -> &mut Self {
        let (left, right) = (left.into().0, right.into().0);
        self.declared("constraint", name, |name| Ok(format!("constraint {name}: {} = {};", left?, right?)));
        self
    }

    /// A load without a law of its own, such as `spring`.
    pub fn load(&mut self, name: &str, kind: Call) -> &mut Self {
        self.declared("load", name, |name| Ok(format!("force {name}: {};", kind.text()?)));
        self
    }

    /// A load with a law, such as `torque`.
    pub fn law(&mut self, name: &str, kind: Call, law: impl Into<Value>) -> &mut Self {
        let law = law.into().0;
        self.declared("load", name, |name| Ok(format!("force {name}: {} = {};", kind.text()?, law?)));
        self
    }

    /// A quantity that follows a law of time.
    pub fn drive(&mut self, name: &str, quantity: &str, law: impl Into<Value>) -> &mut Self {
        let law = law.into().0;
        self.declared("driver", name, |name| {
            Ok(format!("drive {name}: {} = {};", checked_path(quantity)?, law?))
        });
        self
    }

    /// What a coordinate or its rate is at the start.
    pub fn start(&mut self, quantity: &str, value: impl Into<Value>) -> &mut Self {
        self.stated(quantity, '=', value.into())
    }

    /// What a coordinate is near at the start.
    pub fn guess(&mut self, quantity: &str, value: impl Into<Value>) -> &mut Self {
        self.stated(quantity, '~', value.into())
    }

    fn stated(&mut self, quantity: &str, sign: char, value: Value) -> &mut Self {
        let text = checked_path(quantity).and_then(|it| Ok(format!("start {{ {it} {sign} {}; }}", value.0?)));
        self.push(format!("start of \"{quantity}\""), text);
        self
    }

    /// An expression with a name, to be named by others.
    pub fn signal(&mut self, name: &str, unit: &str, value: impl Into<Value>) -> &mut Self {
        let value = value.into().0;
        self.declared("signal", name, |name| Ok(format!("signal {name} {} = {};", bracketed(unit)?, value?)));
        self
    }

    /// A function by its values: `argument` and `unit` are those of the numbers, `argument` with its name before it.
    pub fn table(
        &mut self,
        name: &str,
        argument: [&str; 2],
        unit: &str,
        points: &[[f64; 2]],
        kind: Interpolation,
        outside: Outside,
    ) -> &mut Self {
        self.declared("table", name, |name| {
            let points: Vec<String> = points.iter().map(|point| tuple(point)).collect::<Result<_, _>>()?;
            let head = table_head(name, &[argument], unit)?;
            Ok(format!("{head} = [{}], {};", points.join(", "), goes_on(kind, outside)))
        });
        self
    }

    /// A function of two arguments by its values: those of both arguments, and a row for each value of the second.
    pub fn grid(
        &mut self,
        name: &str,
        arguments: [[&str; 2]; 2],
        unit: &str,
        axes: [&[f64]; 2],
        rows: &[&[f64]],
        (kind, outside): (Interpolation, Outside),
    ) -> &mut Self {
        self.declared("table", name, |name| {
            let rows: Vec<String> = rows.iter().map(|row| tuple(row)).collect::<Result<_, _>>()?;
            let (head, axes) =
                (table_head(name, &arguments, unit)?, [tuple(axes[0])?, tuple(axes[1])?].join(", "));
            let goes_on = goes_on(kind, outside);
            Ok(format!("{head} = grid({axes}, [{}]), {goes_on};", rows.join(", ")))
        });
        self
    }

    /// A value that is computed with the state.
    pub fn output(&mut self, name: &str, unit: &str, value: impl Into<Value>) -> &mut Self {
        let value = value.into().0;
        self.declared("output", name, |name| Ok(format!("output {name} {} = {};", bracketed(unit)?, value?)));
        self
    }

    /// A line of `options`, such as `("coordinates", "tree")`.
    pub fn option(&mut self, name: &str, word: &str) -> &mut Self {
        let text = checked_name(name)
            .and_then(|name| Ok(format!("options {{ {name} = {}; }}", checked_path(word)?)));
        self.push(format!("option \"{name}\""), text);
        self
    }

    /// How many degrees of freedom it is expected to have.
    pub fn expect_degrees_of_freedom(&mut self, count: usize) -> &mut Self {
        let text = format!("expect {{ degrees_of_freedom = {count}; }}");
        self.push("expectation of degrees of freedom".to_string(), Ok(text));
        self
    }

    /// The definition as it would stand in a file. What could not be written down is left out.
    pub fn text(&self) -> String {
        let written = self.statements.iter().filter_map(|it| it.text.as_deref().ok());
        let lines: String = written.map(|text| format!("    {text}\n")).collect();
        format!("{}\n{lines}}}\n", self.head)
    }

    /// The stages, in the coordinates of the definition or in others.
    ///
    /// # Errors
    /// Everything that could not be written down, else what the stages find, by part.
    pub fn compile(&self, coordinates: Option<Coordinates>) -> Result<Compiled, Vec<Fault>> {
        let unwritten: Vec<Fault> = self.statements.iter().filter_map(Statement::unwritten).collect();
        if !unwritten.is_empty() {
            return Err(unwritten);
        }
        let source = Source::new(self.name.as_str(), self.text());
        let (tokens, errors) = source::definition(&source);
        if !errors.is_empty() {
            return Err(self.by_part(&source, errors));
        }
        let compiled = driver::compile(tokens.stream.clone(), coordinates);
        compiled.map_err(|errors| self.by_part(&source, tokens.locate(errors)))
    }

    /// Warnings of a compiled mechanism by part.
    pub fn warnings(&self, compiled: &Compiled) -> Vec<Fault> {
        let source = Source::new(self.name.as_str(), self.text());
        let (tokens, _) = source::definition(&source);
        self.by_part(&source, tokens.locate(compiled.warnings.clone()))
    }

    fn by_part(&self, source: &Source, found: Vec<Located>) -> Vec<Fault> {
        // One statement a line, behind the head.
        let part = |range: &Range<usize>| {
            let line = source.position(range.start).line;
            let statement = line.checked_sub(2).and_then(|line| self.statements.get(line));
            statement.map_or_else(|| self.whole(), |statement| statement.part.clone())
        };
        let fault = |located: Located| Fault {
            severity: located.severity,
            part: part(&located.range),
            message: located.message,
            notes: located.notes.iter().map(|(range, note)| (part(range), note.clone())).collect(),
        };
        found.into_iter().map(fault).collect()
    }
}

/// `table lift(angle [deg]) [mm]`.
fn table_head(name: &str, arguments: &[[&str; 2]], unit: &str) -> Result<String, String> {
    let written = |[name, unit]: &[&str; 2]| Ok(format!("{} {}", checked_name(name)?, bracketed(unit)?));
    let arguments: Vec<String> = arguments.iter().map(written).collect::<Result<_, String>>()?;
    Ok(format!("table {name}({}) {}", arguments.join(", "), bracketed(unit)?))
}

/// `natural, outside = hold`; what is periodic has no outside.
fn goes_on(kind: Interpolation, outside: Outside) -> String {
    match kind {
        Interpolation::Periodic => kind.word().to_string(),
        _ => format!("{}, outside = {}", kind.word(), outside.word()),
    }
}

impl Statement {
    fn unwritten(&self) -> Option<Fault> {
        let message = self.text.as_ref().err()?.clone();
        Some(Fault { severity: Severity::Error, part: self.part.clone(), message, notes: Vec::new() })
    }
}

/// The properties of a body.
pub struct Body<'b> {
    statement: Option<&'b mut Statement>,
}

impl Body<'_> {
    /// A property of one number with its unit.
    pub fn value(self, name: &str, value: f64, unit: &str) -> Self {
        self.expression(name, Value::quantity(value, unit))
    }

    /// A property that is an expression of parameters.
    pub fn expression(self, name: &str, value: Value) -> Self {
        let text = checked_name(name).and_then(|name| Ok(format!("{name} = {};", value.0?)));
        self.push(text)
    }

    /// A property of several numbers with their unit, such as `center` or `size`.
    pub fn vector(self, name: &str, values: &[f64], unit: &str) -> Self {
        let text = checked_name(name)
            .and_then(|name| Ok(format!("{name} {} = {};", bracketed(unit)?, tuple(values)?)));
        self.push(text)
    }

    /// A named point in the axes of the body, m.
    pub fn point(self, name: &str, at: &[f64]) -> Self {
        let text = checked_name(name).and_then(|name| Ok(format!("point {name} [m] = {};", tuple(at)?)));
        self.push(text)
    }

    fn push(mut self, property: Result<String, String>) -> Self {
        if let Some(statement) = &mut self.statement {
            statement.text = match (std::mem::replace(&mut statement.text, Ok(String::new())), property) {
                (Ok(body), Ok(property)) => Ok(body.replacen(" }", &format!(" {property} }}"), 1)),
                (Err(first), _) | (_, Err(first)) => Err(first),
            };
        }
        self
    }
}
