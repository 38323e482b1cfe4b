//! Closed curves in polar form, b + r(φ), as numbers: how far they are from their middle and how they are bent.

use super::Curve;
use crate::messages;
use crate::model::lower::Lowering;
use crate::model::unused::Scope;
use crate::symbolic::Orders;
use crate::syntax::{Entry, TermKind};
use crate::units::Dimension;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Angles at which a curve is looked at.
const LOOKS: u32 = 720;

impl Curve {
    /// b + r, r′ and r″ at an angle.
    fn polar(&self, base: f64, angle: f64) -> [f64; 3] {
        let Curve::Profile { pieces, period: [start, length], .. } = self else { return [f64::NAN; 3] };
        let x = angle - length * libm::floor((angle - start) / length);
        let of = |order: u8| pieces.piece(Orders::new(order, 0).first(), pieces.cell(x), x);
        [base + of(0), of(1), of(2)]
    }

    /// Angles and distances from the middle of a curve that is looked at all around.
    pub fn around(&self, base: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
        angles().map(move |angle| (angle, self.polar(base, angle)[0]))
    }

    /// Where a curve does not go around its middle, and how far it is on the other side.
    pub fn not_around(&self, base: f64) -> Option<(f64, f64)> {
        self.around(base).min_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, radius)| *radius <= 0.0)
    }

    /// Where a curve is hollow most, and the radius of its curvature there: with κ = (r² + 2 r′² − r r″)/(r² + r′²)^1.5 it is −1/κ.
    pub fn hollow(&self, base: f64) -> Option<(f64, f64)> {
        let bent = |angle: f64| {
            let [r, first, second] = self.polar(base, angle);
            let square = r * r + first * first;
            (square + first * first - r * second) / (square * libm::sqrt(square))
        };
        let most = angles().map(|angle| (angle, bent(angle))).min_by(|a, b| a.1.total_cmp(&b.1))?;
        (most.1 < 0.0).then(|| (most.0, -1.0 / most.1))
    }
}

impl<'d> Lowering<'d> {
    /// The closed curve that a table is, with so many passes for the foot on it.
    pub(in crate::model) fn outline(
        &mut self,
        argument: &str,
        entry: &'d Entry,
        passes: usize,
    ) -> Option<Arc<Curve>> {
        let region = entry.value.region;
        let index = match (&entry.value.kind, &entry.unit) {
            (TermKind::Name(path), None) => self.names.table(&path.text),
            _ => None,
        };
        let Some(index) = index else {
            self.diagnostics.error(region, messages::profile_is_a_table(argument));
            return None;
        };
        self.used.insert((Scope::Table, &self.definition.tables[index].name.text));
        let table = self.tables.get(index)?.clone()?;
        let text = &table.name.text;
        let [angle] = &table.arguments[..] else {
            self.diagnostics.error(region, messages::profile_of_two(text));
            return None;
        };
        for (what, expected, found) in [
            (messages::knot_of(text), Dimension::ANGLE, angle.dimension),
            (messages::value_of(text), Dimension::LENGTH, table.value.dimension),
        ] {
            if !found.fits(expected) {
                self.diagnostics.error(region, messages::wrong_unit(&what, expected, found));
                return None;
            }
        }
        let Curve::Line { pieces, period: Some(period @ [_, length]) } = &*table.curve else {
            self.diagnostics.error(region, messages::profile_not_closed(text, None));
            return None;
        };
        if (length - TAU).abs() > 1e-9 {
            self.diagnostics.error(region, messages::profile_not_closed(text, Some(*length)));
            return None;
        }
        Some(Arc::new(Curve::Profile { pieces: pieces.clone(), period: *period, passes }))
    }
}

fn angles() -> impl Iterator<Item = f64> {
    (0..LOOKS).map(|k| TAU * f64::from(k) / f64::from(LOOKS))
}
