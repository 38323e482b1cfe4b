//! Expressions: dimension check, conversion to SI, folding. Functions and conditions stand in `functions`.

use super::fold;
use super::functions::is_function;
use super::lower::{Lowering, Use, declared};
use super::names::Value;
use super::unused::Scope;
use super::{Expr, Function1, Function2, InputId, MemoryId, ParameterId, StateId, Vector};
use crate::diagnostics::Region;
use crate::messages;
use crate::syntax::{Entry, Operator, Path, Term, TermKind, Tuple, WrittenUnit};
use crate::units::Dimension;

/// Values of a definition lie between these in SI units, or are zero: products of five are still finite.
const LEAST: f64 = 1e-60;
const MOST: f64 = 1e60;

/// A checked expression.
#[derive(Clone)]
pub(super) struct Typed {
    pub expr: Expr,
    pub dimension: Dimension,
    /// The literal 0, which fits any dimension.
    pub zero: bool,
    pub region: Region,
}

impl Typed {
    /// Its value, where that is written: digits, with a sign or without.
    pub fn number(&self) -> Option<f64> {
        let (first, last) = self.region.serials();
        match self.expr {
            Expr::Number(value) if last <= first + 1 => Some(value),
            _ => None,
        }
    }
}

impl Lowering<'_> {
    /// The value of a declaration `kind name [unit] = value`.
    pub fn declaration(&mut self, kind: &str, name: &str, entry: &Entry, usage: Use) -> Option<Expr> {
        let (dimension, what) = (declared(entry.unit.as_ref()), messages::quoted(name));
        if entry.unit.is_some() {
            return self.entry(entry, dimension, usage, &what);
        }
        let typed = self.value(&entry.value, usage)?;
        if !typed.dimension.is_one() {
            self.diagnostics.error(typed.region, messages::unit_left_out(kind, name, typed.dimension));
            return None;
        }
        Some(typed.expr)
    }

    /// An entry that must be a number at expansion.
    pub fn number(&mut self, entry: &Entry, expected: Dimension, what: &str) -> Option<f64> {
        let expr = self.entry(entry, expected, Use::CONSTANT, what)?;
        self.folded(expr, entry, what)
    }

    /// The value of a constant or the default of a parameter.
    pub fn declared_number(&mut self, kind: &str, name: &str, entry: &Entry) -> Option<f64> {
        let expr = self.declaration(kind, name, entry, Use::CONSTANT)?;
        self.folded(expr, entry, &messages::quoted(name))
    }

    fn folded(&mut self, expr: Expr, entry: &Entry, what: &str) -> Option<f64> {
        match expr {
            Expr::Number(value) => Some(value),
            // `if` is the only thing that does not fold.
            _ => {
                self.diagnostics.error(entry.value.region, messages::not_constant(what));
                None
            }
        }
    }

    /// A value with the unit of its name, or without one.
    pub fn entry(&mut self, entry: &Entry, expected: Dimension, usage: Use, what: &str) -> Option<Expr> {
        self.with_unit(&entry.value, entry.unit.as_ref(), expected, usage, what)
    }

    /// A vector; what the plane does not have is zero.
    pub fn vector(&mut self, tuple: &Tuple, expected: Dimension, usage: Use, what: &str) -> Option<Vector> {
        let values = self.tuple(tuple, expected, usage, what)?;
        Some(padded(values))
    }

    /// Values with one unit.
    pub fn tuple(&mut self, tuple: &Tuple, expected: Dimension, usage: Use, what: &str) -> Option<Vec<Expr>> {
        self.values(&tuple.values, tuple.unit.as_ref(), expected, usage, what)
    }

    /// Values with one unit.
    pub fn values(
        &mut self,
        values: &[Term],
        unit: Option<&WrittenUnit>,
        expected: Dimension,
        usage: Use,
        what: &str,
    ) -> Option<Vec<Expr>> {
        let mut found = Vec::new();
        for value in values {
            let lowered = self.with_unit(value, unit, expected, usage, what);
            if lowered.is_none() && unit.is_some_and(|written| !written.unit.dimension.fits(expected)) {
                // The unit has been complained of, once for all.
                return None;
            }
            found.push(lowered);
        }
        found.into_iter().collect()
    }

    /// Bare numbers take the unit only where the whole value names nothing and has no unit of its own.
    pub fn with_unit(
        &mut self,
        term: &Term,
        unit: Option<&WrittenUnit>,
        expected: Dimension,
        usage: Use,
        what: &str,
    ) -> Option<Expr> {
        if let Some(written) = unit {
            let found = written.unit.dimension;
            if !found.fits(expected) {
                self.diagnostics.error(written.region, messages::wrong_unit(what, expected, found));
                return None;
            }
        }
        let typed = self.value(term, usage)?;
        let region = typed.region;
        let expr = match unit {
            Some(written) if is_bare(term) => self.scaled(typed, written),
            _ => self.expect_dimension(typed, expected, what),
        };
        self.in_range(expr?, region)
    }

    /// What is known at expansion can be squared and multiplied without overflow.
    pub fn in_range(&mut self, expr: Expr, region: Region) -> Option<Expr> {
        match expr {
            Expr::Number(value) if value != 0.0 && !(LEAST..=MOST).contains(&value.abs()) => {
                self.diagnostics.error(region, messages::out_of_range(value, LEAST, MOST));
                None
            }
            _ => Some(expr),
        }
    }

    /// A bare number times a unit.
    fn scaled(&mut self, typed: Typed, written: &WrittenUnit) -> Option<Expr> {
        let unit = &written.unit;
        if !typed.dimension.is_one() {
            // `angle [rad] = acos(0.5)` is what it says; in degrees it would be converted twice.
            if unit.scale == 1.0 && typed.dimension.fits(unit.dimension) {
                return Some(typed.expr);
            }
            self.diagnostics.error(typed.region, messages::not_bare(typed.dimension, &unit.text));
            return None;
        }
        let scaled = fold::binary(Function2::Mul, typed.expr, Expr::Number(unit.scale));
        self.finite(scaled, typed.region)
    }

    /// A value of a known dimension.
    pub fn expect_dimension(&mut self, typed: Typed, expected: Dimension, what: &str) -> Option<Expr> {
        if typed.zero || typed.dimension.fits(expected) {
            return Some(typed.expr);
        }
        let message = messages::wrong_dimension(what, expected, typed.dimension, typed.number());
        self.diagnostics.error(typed.region, message);
        None
    }

    /// Two values that are added or compared: what both of them measure.
    pub fn same(&mut self, left: &Typed, right: &Typed, what: &str) -> Option<Dimension> {
        if left.zero {
            return Some(right.dimension);
        }
        if right.zero || left.dimension.fits(right.dimension) {
            return Some(if right.zero { left.dimension } else { left.dimension.merged(right.dimension) });
        }
        // The number that lacks a unit is the one to point at.
        let region = match (left.dimension == Dimension::ONE, right.dimension == Dimension::ONE) {
            (true, false) => left.region,
            (false, true) => right.region,
            _ => left.region.to(right.region),
        };
        let bare = if left.dimension == Dimension::ONE { left } else { right };
        let message = messages::different_dimensions(what, left.dimension, right.dimension, bare.number());
        self.diagnostics.error(region, message);
        None
    }

    /// An expression with its dimension.
    pub fn value(&mut self, term: &Term, usage: Use) -> Option<Typed> {
        let region = term.region;
        match &term.kind {
            TermKind::Number { text, unit } => self.literal(text, unit.as_ref(), region),
            TermKind::Name(path) => self.named(path, usage),
            TermKind::Operation(operator, operands) => self.operation(*operator, operands, region, usage),
            TermKind::Call(function, arguments) => self.call(function, arguments, region, usage),
            TermKind::Measured(inner, unit) => self.measured(inner, unit, region, usage),
            TermKind::Ground(_) => {
                self.diagnostics.error(region, messages::place_as_value());
                None
            }
        }
    }

    fn literal(&mut self, text: &str, unit: Option<&WrittenUnit>, region: Region) -> Option<Typed> {
        let digits: f64 = text.parse().ok()?;
        let scale = unit.map_or(1.0, |written| written.unit.scale);
        let expr = self.finite(Expr::Number(digits * scale), region)?;
        Some(Typed { expr, dimension: declared(unit), zero: digits == 0.0 && unit.is_none(), region })
    }

    fn measured(&mut self, inner: &Term, unit: &WrittenUnit, region: Region, usage: Use) -> Option<Typed> {
        let dimension = unit.unit.dimension;
        let typed = self.value(inner, usage)?;
        let expr = if is_bare(inner) {
            self.scaled(typed, unit)?
        } else {
            self.expect_dimension(typed, dimension, "the value in parentheses")?
        };
        Some(Typed { expr, dimension, zero: false, region })
    }

    fn named(&mut self, path: &Path, usage: Use) -> Option<Typed> {
        let typed = |expr, dimension| Some(Typed { expr, dimension, zero: false, region: path.region });
        if path.parts.len() == 1 {
            match self.names.value(&path.text) {
                Some(Value::Constant(index)) => {
                    self.used.insert((Scope::Value, &self.definition.constants[index].name.text));
                    let dimension = declared(self.definition.constants[index].entry.unit.as_ref());
                    return typed(Expr::Number(self.constants[index]?), dimension);
                }
                Some(Value::Parameter(index)) => {
                    self.used.insert((Scope::Value, &self.definition.parameters[index].name.text));
                    self.permit(usage.parameters, path, "a parameter", usage)?;
                    let dimension = declared(self.definition.parameters[index].entry.unit.as_ref());
                    return typed(Expr::Parameter(ParameterId(index)), dimension);
                }
                Some(Value::Input(index)) => {
                    self.used.insert((Scope::Value, &self.definition.inputs[index].name.text));
                    self.permit(usage.inputs, path, "an input", usage)?;
                    let dimension = declared(self.definition.inputs[index].unit.as_ref());
                    return typed(Expr::Input(InputId(index)), dimension);
                }
                Some(Value::State(index)) => {
                    self.used.insert((Scope::Value, &self.definition.states[index].name.text));
                    self.permit(usage.states, path, "a state", usage)?;
                    let dimension = declared(self.definition.states[index].entry.unit.as_ref());
                    return typed(Expr::State(StateId(index)), dimension);
                }
                Some(Value::Memory(index)) => {
                    self.used.insert((Scope::Value, &self.definition.memories[index].name.text));
                    self.permit(usage.states, path, "a memory", usage)?;
                    let dimension = self.dimension_of_memory(index)?;
                    return typed(Expr::Memory(MemoryId(index)), dimension);
                }
                Some(Value::Signal(index)) => return self.signal_at(index, path, usage),
                None if path.text == "pi" => {
                    return typed(Expr::Number(core::f64::consts::PI), Dimension::ONE);
                }
                None if path.text == "time" => {
                    self.permit(usage.time, path, "the time", usage)?;
                    return typed(Expr::Time, Dimension::TIME);
                }
                None => {}
            }
            if self.names.table(&path.text).is_some() && self.names.part(&path.text).is_none() {
                self.diagnostics.error(path.region, messages::table_without_call(&path.text));
                return None;
            }
        }
        if let Some(index) = self.rate_of_signal(path) {
            return self.signal_rate_at(index, path, usage);
        }
        if let Some(index) = self.contact_of(path) {
            return self.quantity_of_contact(index, path, usage);
        }
        let (quantity, dimension) = self.permitted_quantity(path, usage)?;
        typed(Expr::Quantity(quantity), dimension)
    }

    /// An error if this kind of thing may not stand here.
    pub fn permit(&mut self, permitted: bool, path: &Path, kind: &str, usage: Use) -> Option<()> {
        if !permitted {
            self.diagnostics.error(
                path.region,
                messages::not_permitted(&path.text, kind, usage.what, &usage.permitted()),
            );
        }
        permitted.then_some(())
    }

    fn operation(
        &mut self,
        operator: Operator,
        operands: &[Term],
        region: Region,
        usage: Use,
    ) -> Option<Typed> {
        match (operator, operands) {
            (Operator::Negate, [operand]) => {
                let typed = self.value(operand, usage)?;
                Some(Typed { expr: fold::unary(Function1::Neg, typed.expr), region, ..typed })
            }
            (Operator::Power, [base, exponent]) => self.power(base, exponent, region, usage),
            (Operator::Add, [a, b]) => self.sum(Function2::Add, a, b, region, usage),
            (Operator::Subtract, [a, b]) => self.sum(Function2::Sub, a, b, region, usage),
            (Operator::Multiply, [a, b]) => self.product(a, b, region, usage),
            (Operator::Divide, [a, b]) => self.quotient(a, b, region, usage),
            _ => {
                self.diagnostics.error(region, messages::condition_as_value());
                None
            }
        }
    }

    fn sum(&mut self, function: Function2, a: &Term, b: &Term, region: Region, usage: Use) -> Option<Typed> {
        let (a, b) = (self.value(a, usage), self.value(b, usage));
        let (a, b) = (a?, b?);
        let what = if function == Function2::Add { "the summands" } else { "the two sides of `-`" };
        let dimension = self.same(&a, &b, what)?;
        let zero = a.zero && b.zero;
        let expr = self.finite(fold::binary(function, a.expr, b.expr), region)?;
        Some(Typed { expr, dimension, zero, region })
    }

    fn product(&mut self, a: &Term, b: &Term, region: Region, usage: Use) -> Option<Typed> {
        let (a, b) = (self.value(a, usage), self.value(b, usage));
        let (a, b) = (a?, b?);
        let expr = self.finite(fold::binary(Function2::Mul, a.expr, b.expr), region)?;
        Some(Typed { expr, dimension: a.dimension.times(b.dimension), zero: false, region })
    }

    fn quotient(&mut self, a: &Term, b: &Term, region: Region, usage: Use) -> Option<Typed> {
        let (a, b) = (self.value(a, usage), self.value(b, usage));
        let (a, b) = (a?, b?);
        if matches!(b.expr, Expr::Number(0.0)) {
            self.diagnostics.error(region, messages::division_by_zero());
            return None;
        }
        let expr = self.finite(fold::binary(Function2::Div, a.expr, b.expr), region)?;
        Some(Typed { expr, dimension: a.dimension.over(b.dimension), zero: false, region })
    }

    fn power(&mut self, base: &Term, exponent: &Term, region: Region, usage: Use) -> Option<Typed> {
        let (base, power) = (self.value(base, usage), self.value(exponent, usage));
        let (base, power) = (base?, power?);
        let (Expr::Number(number), true) = (&power.expr, power.dimension.is_one()) else {
            self.diagnostics.error(exponent.region, messages::exponent());
            return None;
        };
        let Some(dimension) = base.dimension.power(*number) else {
            self.diagnostics.error(region, messages::power_of_dimension(base.dimension, *number));
            return None;
        };
        let expr = self.finite(fold::power(base.expr, *number), region)?;
        Some(Typed { expr, dimension, zero: false, region })
    }

    /// A folded number must be one.
    pub fn finite(&mut self, expr: Expr, region: Region) -> Option<Expr> {
        match expr {
            Expr::Number(value) if !value.is_finite() => {
                self.diagnostics.error(region, messages::not_finite(value));
                None
            }
            _ => Some(expr),
        }
    }
}

/// Components beyond those given are zero.
pub(super) fn padded(values: Vec<Expr>) -> Vector {
    let mut components = values.into_iter();
    std::array::from_fn(|_| components.next().unwrap_or(Expr::Number(0.0)))
}

/// Whether a value names nothing and carries no unit.
fn is_bare(term: &Term) -> bool {
    match &term.kind {
        TermKind::Number { unit, .. } => unit.is_none(),
        TermKind::Name(path) => path.text == "pi",
        TermKind::Operation(_, terms) => terms.iter().all(is_bare),
        // What a table gives has a unit.
        TermKind::Call(function, terms) => is_function(&function.text) && terms.iter().all(is_bare),
        TermKind::Ground(_) | TermKind::Measured(..) => false,
    }
}
