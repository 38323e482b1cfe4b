//! What follows from the lengths of a body: moments of inertia about the centre of mass, and the volume. The formulas stand with
//! the kinds of bodies.

use super::lower::{Lowering, Use};
use super::{Expr, Function2, Vector, ZERO, fold};
use crate::forms::{Length, Moment, Need, Solid, Volume};
use crate::messages;
use crate::syntax;
use crate::units::Dimension;

/// Lengths by name.
pub type Lengths = Vec<(&'static str, Expr)>;

impl<'d> Lowering<'d> {
    /// A length of a shape; what is missing is said only once, when the body itself is lowered.
    pub fn shape_length(&mut self, body: &'d syntax::Body, property: &str, report: bool) -> Option<Expr> {
        let Some((label, entry)) = body.property(property) else {
            if report {
                self.missing(body, property);
            }
            return None;
        };
        let length = self.entry(entry, Dimension::LENGTH, Use::PROPERTY, property)?;
        if let (true, Expr::Number(value)) = (report, &length)
            && *value <= 0.0
        {
            let message = messages::not_positive(property, &body.name.text, *value);
            self.diagnostics.error(label.region.to(entry.value.region), message);
            return None;
        }
        Some(length)
    }

    /// The edges of a box in space.
    pub fn size(&mut self, body: &'d syntax::Body, report: bool) -> Option<Vector> {
        let Some((label, tuple)) = body.vector("size") else {
            if report {
                self.missing(body, "size");
            }
            return None;
        };
        let size = self.vector(tuple, Dimension::LENGTH, Use::PROPERTY, "size")?;
        let short = size.iter().find_map(|edge| match edge {
            Expr::Number(value) if *value <= 0.0 => Some(*value),
            _ => None,
        });
        if let (true, Some(value)) = (report, short) {
            let message = messages::not_positive("size", &body.name.text, value);
            self.diagnostics.error(label.region.to(tuple.region), message);
            return None;
        }
        Some(size)
    }

    /// All lengths of a body, zero where they may be left out and are; `None` after an error.
    fn lengths(&mut self, body: &'d syntax::Body, report: bool) -> Option<Lengths> {
        let solid = body.form.solid(self.definition.space)?;
        let size = if solid.has_size() { Some(self.size(body, report)?) } else { None };
        let mut found = Vec::new();
        for length in solid.lengths {
            found.push((length.name, self.length(body, length, size.as_ref(), report)));
        }
        found.into_iter().map(|(name, length)| Some((name, length?))).collect()
    }

    fn length(
        &mut self,
        body: &'d syntax::Body,
        length: &Length,
        size: Option<&Vector>,
        report: bool,
    ) -> Option<Expr> {
        match (length.of_size, length.need) {
            (Some(component), _) => size.map(|size| size[component].clone()),
            (None, Need::Always) => self.shape_length(body, length.name, report),
            (None, _) if body.property(length.name).is_some() => self.shape_length(body, length.name, report),
            (None, _) => Some(Expr::Number(0.0)),
        }
    }

    /// The lengths of a body that are given.
    pub fn dimensions(&mut self, body: &'d syntax::Body) -> Option<Lengths> {
        let solid = body.form.solid(self.definition.space)?;
        let is_given = |name: &str| {
            let length = solid.lengths.iter().find(|length| length.name == name);
            length.is_some_and(|length| length.of_size.is_some() || body.property(name).is_some())
        };
        let mut lengths = self.lengths(body, false)?;
        lengths.retain(|(name, _)| is_given(name));
        Some(lengths)
    }

    /// The moments that follow from the lengths, if any do; its lengths are checked whether they are needed or not.
    pub fn shape_inertia(&mut self, body: &'d syntax::Body, mass: Option<&Expr>) -> Option<Vector> {
        let Solid { moments, .. } = body.form.solid(self.definition.space)?;
        let lengths = self.lengths(body, true);
        let moments = moments.as_ref()?;
        if moments.iter().all(|moment| moment.squares.is_empty()) {
            return Some(ZERO);
        }
        let (lengths, mass) = (lengths?, mass?);
        Some(moments.each_ref().map(|moment| moment_of(moment, mass, &lengths)))
    }

    /// m³; `None` where it does not follow, which is said.
    pub fn volume(&mut self, body: &'d syntax::Body) -> Option<Expr> {
        if body.form.is_beam() {
            return self.volume_of_beam(body);
        }
        let Solid { volume, lengths: forms, .. } = body.form.solid(self.definition.space)?;
        let Volume { factor, edges } = volume.as_ref()?;
        let left_out = |name: &str| {
            let length = forms.iter().find(|length| length.name == name);
            length.is_some_and(|length| length.need != Need::Always) && body.property(name).is_none()
        };
        if let Some((missing, _)) = edges.iter().find(|(name, _)| left_out(name)) {
            let message = messages::density_needs(body.form.word, &body.name.text, missing);
            self.diagnostics.error(body.name.region, message);
            return None;
        }
        let lengths = self.lengths(body, false)?;
        let powers = edges.iter().map(|(name, power)| raised(by_name(&lengths, name), *power));
        Some(powers.fold(Expr::Number(*factor), times))
    }
}

/// m Σ factor · length² / divisor.
fn moment_of(moment: &Moment, mass: &Expr, lengths: &Lengths) -> Expr {
    let squares = moment.squares.iter().map(|(factor, name)| (*factor, square(by_name(lengths, name))));
    let squares: Vec<(f64, Expr)> = squares.filter(|(_, it)| !matches!(it, Expr::Number(0.0))).collect();
    // A thin disk has across it half of what it has about itself, to the last digit.
    if let [(factor, only)] = squares.as_slice()
        && moment.divisor % factor == 0.0
    {
        return over(times(mass.clone(), only.clone()), moment.divisor / factor);
    }
    let terms = squares.into_iter().map(|(factor, square)| times(Expr::Number(factor), square));
    over(times(mass.clone(), terms.fold(Expr::Number(0.0), add)), moment.divisor)
}

fn by_name(lengths: &Lengths, name: &str) -> Expr {
    let found = lengths.iter().find(|(known, _)| *known == name);
    found.map_or(Expr::Number(0.0), |(_, length)| length.clone())
}

fn raised(length: Expr, power: u32) -> Expr {
    match power {
        1 => length,
        2 => square(length),
        _ => times(length.clone(), raised(length, power - 1)),
    }
}

fn square(length: Expr) -> Expr {
    times(length.clone(), length)
}

fn times(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Mul, a, b)
}

fn add(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Add, a, b)
}

fn over(a: Expr, divisor: f64) -> Expr {
    fold::binary(Function2::Div, a, Expr::Number(divisor))
}
