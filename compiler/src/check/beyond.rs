//! Tables that are asked for more than they say: arguments outside of the knots, at the start and along the motion.

use super::assemble::{Ancestry, Assembly, Point};
use super::messages;
use crate::diagnostics::{Diagnostics, Lint, Severity};
use crate::equations::{Equations, Laws};
use crate::model::{ConstraintKind, Coordinate, Curve, Expr, Mechanism, Name, Quantity, Table};

/// Of the width of a table, what is taken for rounding.
const ROUNDING: f64 = 1e-9;

/// A table in an expression of something with a name.
pub struct Asked<'m> {
    of: &'m Name,
    table: &'m Table,
    /// Which of its arguments.
    which: usize,
    argument: &'m Expr,
}

impl Asked<'_> {
    /// The coordinate that is the argument, where it is one.
    pub fn coordinate(&self) -> Option<&Coordinate> {
        match self.argument {
            Expr::Quantity(Quantity::Coordinate(coordinate)) => Some(coordinate),
            _ => None,
        }
    }

    /// A warning if values from the one to the other leave the knots.
    pub fn warn(&self, mechanism: &Mechanism, [from, to]: [f64; 2], along: bool, found: &mut Diagnostics) {
        let knots = &self.table.knots[self.which];
        let (first, last) = (knots[0], knots[knots.len() - 1]);
        let rounding = ROUNDING * (last - first);
        // A NaN is complained of elsewhere.
        if !(from < first - rounding || to > last + rounding) {
            return;
        }
        if mechanism.allowed.covers(Lint::OutsideTable, self.of.span) {
            return;
        }
        // What is said of the motion says more than the start does.
        let own = self.of.span.serials();
        let severity = Severity::Warning(Lint::OutsideTable);
        if found.iter().any(|known| known.severity == severity && known.region.serials() == own) {
            return;
        }
        let axis = &self.table.arguments[self.which];
        let [from, to, first, last] = [from, to, first, last].map(|value| axis.shown(value));
        let asked = if along { [from, to] } else { [from.clone(), from] };
        let message =
            messages::outside_table(&self.of.text, &self.table.name.text, &axis.name, asked, [first, last]);
        found.warning(Lint::OutsideTable, self.of.span, message);
    }
}

/// Every argument of every table that ends somewhere.
pub fn asked(mechanism: &Mechanism) -> Vec<Asked<'_>> {
    let laws = mechanism.loads.iter().flat_map(|load| {
        let arguments = load.values.iter().flatten().chain(&load.law);
        arguments.map(|expr| (&load.name, expr))
    });
    let constraints = mechanism.constraints.iter().filter_map(|constraint| match &constraint.kind {
        ConstraintKind::Equation { residual } => Some((&constraint.name, residual)),
        ConstraintKind::Coupling(_) | ConstraintKind::Teeth { .. } => None,
    });
    let drivers = mechanism.drivers.iter().map(|driver| (&driver.name, &driver.law));
    let curves = mechanism
        .joints
        .iter()
        .flat_map(|joint| joint.functions().into_iter().flatten().map(move |it| (&joint.name, it)));
    let rates = mechanism.states.iter().filter_map(|state| Some((&state.name, state.rate.written()?)));
    let mut found: Vec<Asked> = Vec::new();
    for (of, expr) in laws.chain(constraints).chain(curves).chain(drivers).chain(rates) {
        expr.visit(&mut |part| {
            let Expr::Table(look_up) = part else { return };
            let (Curve::Line { period: None, .. } | Curve::Grid { .. }) = &*look_up.curve else { return };
            let name = look_up.curve.name();
            let Some(table) = mechanism.tables.iter().find(|table| table.name.text == name) else { return };
            for (which, argument) in look_up.arguments.iter().enumerate() {
                let known = |it: &Asked| {
                    it.of.text == of.text
                        && it.table.name.text == name
                        && it.which == which
                        && it.argument == argument
                };
                if !found.iter().any(known) {
                    found.push(Asked { of, table, which, argument });
                }
            }
        });
    }
    found
}

/// Warnings of tables whose arguments are outside at the start, as far as no input or result decides that.
pub fn beyond_tables(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    found: &mut Diagnostics,
) {
    let asked = asked(mechanism);
    if asked.is_empty() {
        return;
    }
    let (g, symbols) = (equations.graph.sheet(), &equations.symbols);
    let laws = Laws::moving(g, mechanism, symbols, &equations.layout, &equations.kinematics);
    let nodes: Vec<_> = asked.iter().map(|asked| laws.value(asked.argument).bare).collect();
    let mut point = Point::at_start(mechanism, equations, assembly);
    point.evaluate(&Ancestry::of(equations, nodes.iter().copied()));
    for (asked, node) in asked.iter().zip(nodes) {
        let mut follows = false;
        asked.argument.quantities(&mut |quantity| {
            follows |=
                !matches!(quantity, Quantity::Coordinate(_) | Quantity::Rate(_) | Quantity::Sliding { .. });
        });
        if !follows && !equations.takes_inputs(node) {
            asked.warn(mechanism, [point.get(node); 2], false, found);
        }
    }
}
