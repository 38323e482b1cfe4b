//! Tables: knots in the units of their heads → rows of coefficients in SI, and the checks of knots.

mod calls;
mod pieces;
mod profile;
mod slopes;
mod splines;
#[cfg(test)]
mod tests;

use super::lower::{Lowering, Use, declared, declared_unit, name};
use super::{Expr, Name};
use crate::diagnostics::Region;
use crate::forms::{Interpolation, Outside};
use crate::messages;
use crate::symbolic::{self, AXIS, Orders, PIECES};
use crate::syntax::{ReadFile, TableData, TableTerm, Term, WrittenUnit};
use crate::units::Dimension;
use std::sync::Arc;

/// The most values that a table may have.
const MOST: usize = 4096;

/// A table, all quantities in SI units.
#[derive(Clone, Debug)]
pub struct Table {
    pub name: Name,
    /// One, or two of a grid.
    pub arguments: Vec<Axis>,
    /// What it is of.
    pub value: Axis,
    pub kind: Interpolation,
    pub outside: Outside,
    pub curve: Arc<Curve>,
    /// Values of each argument at the knots.
    pub knots: Vec<Vec<f64>>,
    /// Values of the table there, by rows of the second argument.
    pub values: Vec<Vec<f64>>,
    /// The file that it was read from.
    pub file: Option<ReadFile>,
}

/// An argument or the value of a table.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Nothing for the value.
    pub name: String,
    /// As written.
    pub unit: String,
    /// The unit in SI.
    pub scale: f64,
    pub dimension: Dimension,
}

/// What a table is where it is evaluated.
#[derive(Clone, Debug, PartialEq)]
pub enum Curve {
    /// Rows of cubic pieces; of what repeats itself, where a period begins and how long it is.
    Line { pieces: Arc<symbolic::Table>, period: Option<[f64; 2]> },
    /// Rows of both arguments and of the patches, those of one row of the first argument one behind the other.
    Grid { axes: [Arc<symbolic::Table>; 2], patches: Arc<symbolic::Table> },
    /// Of a place (x, y) and a base b, how far it is out of the closed curve b + r(φ): as many passes of Newton's method find the foot.
    Profile { pieces: Arc<symbolic::Table>, period: [f64; 2], passes: usize },
}

/// A derivative of a table in an expression.
#[derive(Clone, Debug, PartialEq)]
pub struct LookUp {
    pub curve: Arc<Curve>,
    pub orders: Orders,
    /// How often it can be differentiated with what comes out still continuous.
    pub smoothness: usize,
    pub arguments: Vec<Expr>,
}

impl Curve {
    /// Of the table.
    pub fn name(&self) -> &str {
        let (Curve::Line { pieces, .. }
        | Curve::Grid { patches: pieces, .. }
        | Curve::Profile { pieces, .. }) = self;
        &pieces.name
    }

    /// A derivative at a number, or at two.
    pub fn at(&self, orders: Orders, arguments: &[f64]) -> f64 {
        match (self, arguments) {
            (Curve::Line { pieces, period }, [x]) => {
                let x = match period {
                    Some([start, length]) => x - length * libm::floor((x - start) / length),
                    None => *x,
                };
                pieces.piece(orders.first(), pieces.cell(x), x)
            }
            (Curve::Grid { axes, patches }, [x, y]) => {
                let [row, column] = [axes[0].cell(*x), axes[1].cell(*y)];
                patches.patch(orders, row * axes[1].rows().len() as f64 + column, *x, *y)
            }
            _ => f64::NAN,
        }
    }
}

impl Axis {
    fn new(name: &str, unit: Option<&WrittenUnit>) -> Self {
        Axis {
            name: name.to_string(),
            unit: declared_unit(unit).text,
            scale: unit.map_or(1.0, |written| written.unit.scale),
            dimension: declared(unit),
        }
    }

    /// A number of SI in the unit of the head: `0.25 deg`.
    pub fn shown(&self, value: f64) -> String {
        let digits = crate::numbers::significant(value / self.scale, 8);
        if self.unit == "1" { digits } else { format!("{digits} {}", self.unit) }
    }
}

/// Numbers with their places, and what each message is told of where it stands beyond that.
struct Knots {
    values: Vec<f64>,
    places: Vec<(Region, String)>,
}

impl Lowering<'_> {
    /// All tables, after the constants that they name.
    pub fn all_tables(&mut self) {
        self.tables = Vec::with_capacity(self.definition.tables.len());
        for index in 0..self.definition.tables.len() {
            let table = self.table(index);
            self.tables.push(table);
        }
    }

    fn table(&mut self, index: usize) -> Option<Table> {
        let written = &self.definition.tables[index];
        let kind = self.interpolation(written)?;
        let arguments: Vec<Axis> =
            written.arguments.iter().map(|(label, unit)| Axis::new(&label.text, unit.as_ref())).collect();
        let value = Axis::new("", written.unit.as_ref());
        let outside = written.outside.map_or(Outside::Linear, |(outside, _)| outside);
        if let (Interpolation::Periodic, Some((_, at))) = (kind, written.outside) {
            self.diagnostics.error(at, messages::outside_of_periodic());
            return None;
        }
        let text = &written.name.text;
        let (knots, values, curve) = match &written.data {
            TableData::Points(points) if arguments.len() == 1 => {
                let (knots, mut values) = self.points(written, points, kind, &arguments[0], &value)?;
                if kind == Interpolation::Periodic {
                    self.repeats(written, &mut values, &value)?;
                }
                let period =
                    (kind == Interpolation::Periodic).then(|| [knots[0], knots[knots.len() - 1] - knots[0]]);
                let rows = pieces::of_line(&knots, &values, kind, outside);
                let pieces = Arc::new(symbolic::Table::new(text.as_str(), PIECES, rows));
                (vec![knots], vec![values], Curve::Line { pieces, period })
            }
            TableData::Grid { axes, rows } if arguments.len() == 2 => {
                let [x, y] = [0, 1].map(|k| self.axis(written, &axes[k], k, kind, &arguments[k]));
                let (x, y) = (x?, y?);
                let values = self.grid(written, rows, [x.len(), y.len()])?;
                let of_axis = |k: usize, knots: &[f64]| {
                    let name = format!("{text}.{}", written.arguments[k].0.text);
                    Arc::new(symbolic::Table::new(name, AXIS, pieces::of_axis(knots)))
                };
                let axes = [of_axis(0, &x), of_axis(1, &y)];
                let (width, rows) = pieces::of_grid(&x, &y, &values, kind, outside);
                let patches = Arc::new(symbolic::Table::new(text.as_str(), width, rows));
                (vec![x, y], values, Curve::Grid { axes, patches })
            }
            _ => {
                self.diagnostics.error(written.name.region, messages::table_data_of(text, arguments.len()));
                return None;
            }
        };
        let file = written.read.clone();
        let (name, curve) = (name(&written.name), Arc::new(curve));
        Some(Table { name, arguments, value, kind, outside, curve, knots, values, file })
    }

    /// What stands between its knots; it must be for as many arguments as there are.
    fn interpolation(&mut self, written: &TableTerm) -> Option<Interpolation> {
        let count = written.arguments.len();
        match written.kind {
            None => Some(Interpolation::of(count)),
            Some((kind, _)) if kind.arguments() == count => Some(kind),
            Some((kind, at)) => {
                self.diagnostics.error(at, messages::interpolation_of(kind.word(), kind.arguments(), count));
                None
            }
        }
    }

    /// Knots and values of a table of one argument.
    fn points(
        &mut self,
        written: &TableTerm,
        points: &[[Term; 2]],
        kind: Interpolation,
        argument: &Axis,
        value: &Axis,
    ) -> Option<(Vec<f64>, Vec<f64>)> {
        self.is_of_a_size(written, points.len(), kind)?;
        let (text, of) = (&written.name.text, |k: usize| points.iter().map(move |point| &point[k]));
        let unit = written.arguments[0].1.as_ref();
        let knots = self.numbers(written, of(0), unit, argument, &messages::knot_of(text), |k| k);
        let values =
            self.numbers(written, of(1), written.unit.as_ref(), value, &messages::value_of(text), |k| k);
        let (knots, values) = (knots?, values?);
        self.ascends(text, &knots, argument)?;
        Some((knots.values, values.values))
    }

    /// The knots of one argument of a grid.
    fn axis(
        &mut self,
        written: &TableTerm,
        terms: &[Term],
        at: usize,
        kind: Interpolation,
        argument: &Axis,
    ) -> Option<Vec<f64>> {
        self.is_of_a_size(written, terms.len(), kind)?;
        let text = &written.name.text;
        let unit = written.arguments[at].1.as_ref();
        // In a file the first argument has a line of its own, before those of the second.
        let line = |index: usize| if at == 0 { 0 } else { index + 1 };
        let knots = self.numbers(written, terms.iter(), unit, argument, &messages::knot_of(text), line)?;
        self.ascends(text, &knots, argument)?;
        Some(knots.values)
    }

    /// The values of a grid, by rows of the second argument.
    fn grid(
        &mut self,
        written: &TableTerm,
        rows: &[(Vec<Term>, Region)],
        [columns, count]: [usize; 2],
    ) -> Option<Vec<Vec<f64>>> {
        let text = &written.name.text;
        self.is_of_a_size(
            written,
            rows.iter().map(|(row, _)| row.len()).sum::<usize>().max(2),
            Interpolation::Bilinear,
        )?;
        if rows.len() != count {
            let message = messages::grid_rows(text, rows.len(), &written.arguments[1].0.text, count);
            self.diagnostics.error(written.name.region, message);
            return None;
        }
        let value = Axis::new("", written.unit.as_ref());
        let mut found = Vec::new();
        for (at, (row, region)) in rows.iter().enumerate() {
            if row.len() != columns {
                let message = messages::grid_columns(text, row.len(), &written.arguments[0].0.text, columns);
                self.diagnostics.error(*region, message);
                return None;
            }
            let numbers = self.numbers(
                written,
                row.iter(),
                written.unit.as_ref(),
                &value,
                &messages::value_of(text),
                |_| at + 1,
            );
            found.push(numbers?.values);
        }
        Some(found)
    }

    fn is_of_a_size(&mut self, written: &TableTerm, count: usize, kind: Interpolation) -> Option<()> {
        let text = &written.name.text;
        let message = if count < kind.fewest() {
            messages::few_knots(text, count, kind.word(), kind.fewest())
        } else if count > MOST {
            messages::many_knots(text, count, MOST)
        } else {
            return Some(());
        };
        self.diagnostics.error(written.name.region, message);
        None
    }

    /// Numbers in a unit of the head, known at expansion; `line` says which of a file's lines each stands in.
    fn numbers<'t>(
        &mut self,
        written: &TableTerm,
        terms: impl Iterator<Item = &'t Term>,
        unit: Option<&WrittenUnit>,
        axis: &Axis,
        what: &str,
        line: impl Fn(usize) -> usize,
    ) -> Option<Knots> {
        let mut found = Knots { values: Vec::new(), places: Vec::new() };
        for (index, term) in terms.enumerate() {
            let read = written.read.as_ref();
            let place = read.map(|read| messages::in_line(&read.shown, read.lines.get(line(index)).copied()));
            let Expr::Number(number) = self.with_unit(term, unit, axis.dimension, Use::TABLE, what)? else {
                self.diagnostics.error(term.region, messages::not_constant(what));
                return None;
            };
            found.values.push(number);
            found.places.push((term.region, place.unwrap_or_default()));
        }
        Some(found)
    }

    /// Each knot is above the one before it.
    fn ascends(&mut self, text: &str, knots: &Knots, axis: &Axis) -> Option<()> {
        for (index, pair) in knots.values.windows(2).enumerate() {
            if pair[0] < pair[1] {
                continue;
            }
            let (region, place) = &knots.places[index + 1];
            let [before, own] = [pair[0], pair[1]].map(|knot| axis.shown(knot));
            self.diagnostics.error(*region, messages::knots_descend(text, &before, &own, place));
            return None;
        }
        Some(())
    }

    /// The last value is the first one again.
    fn repeats(&mut self, written: &TableTerm, values: &mut [f64], axis: &Axis) -> Option<()> {
        let (first, last) = (values[0], values[values.len() - 1]);
        let largest = values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        if (last - first).abs() > 1e-12 * largest {
            let region = match &written.data {
                TableData::Points(points) => points[points.len() - 1][1].region,
                _ => written.name.region,
            };
            let shown = [first, last, last - first].map(|value| axis.shown(value));
            self.diagnostics.error(region, messages::period_does_not_close(&written.name.text, &shown));
            return None;
        }
        let end = values.len() - 1;
        values[end] = first;
        Some(())
    }
}
