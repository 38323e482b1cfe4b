//! Laws of contacts: forces by the depth d = −g > 0 and its rate ḋ = −ġ. None pulls. Where gates are held, it is they that end a touch where the
//! force would pull: the law is then what it is without that end, and smooth over a step.

use super::pairs::Meeting;
use super::restitution::{self, Damping};
use super::{closing, depth, product, pushing, quotient, sum};
use crate::diagnostics::Region;
use crate::forms::{ContactLaw, ContactLawForm};
use crate::messages;
use crate::model::lower::{Lowering, Use};
use crate::model::unused::Scope;
use crate::model::{Comparison, Condition, Expr, Function1, Function2, fold};
use crate::syntax::{Entry, Named, TermKind};
use crate::units::Dimension;

/// What is taken for a depth relative to that of a law where its power has no slope at zero.
const LEAST: f64 = 1e-12;

/// A named law.
pub(super) struct NamedLaw {
    pub force: Expr,
    /// K, n and the impact speed, or 1 m/s where none is written.
    pub elastic: [Expr; 3],
}

impl<'d> Lowering<'d> {
    pub(super) fn named_law(
        &mut self,
        form: &'static ContactLawForm,
        named: &'d Named,
        region: Region,
        meeting: &Meeting,
        way: Dimension,
    ) -> Option<NamedLaw> {
        let one = || Expr::Number(1.0);
        match form.kind {
            ContactLaw::KelvinVoigt => {
                let (force, stiffness) = self.kelvin_voigt(named, meeting, way)?;
                Some(NamedLaw { force, elastic: [stiffness, one(), one()] })
            }
            ContactLaw::HuntCrossley => {
                let effort = Dimension::TORQUE.over(way);
                let force = self.positive(named, "force", effort)?;
                let scale = self.positive(named, "depth", way)?;
                let exponent = match named.entry("exponent") {
                    Some(entry) => match &self.exponent(entry, "exponent")?[..] {
                        [Expr::Number(exponent)] => *exponent,
                        _ => return None,
                    },
                    None => 1.5,
                };
                let relative = fold::binary(
                    Function2::Div,
                    fold::unary(Function1::Neg, meeting.gap.clone()),
                    scale.clone(),
                );
                let elastic = product(force.clone(), self.powered(relative, exponent));
                let stiffness = quotient(force, fold::power(scale, exponent));
                let (force, speed) = self.dissipating(named, region, elastic, meeting, way)?;
                Some(NamedLaw {
                    force,
                    elastic: [stiffness, Expr::Number(exponent), speed.unwrap_or_else(one)],
                })
            }
            ContactLaw::Hertz => {
                let (elastic, stiffness) = self.hertz(named, region, meeting)?;
                let (force, speed) = self.dissipating(named, region, elastic, meeting, way)?;
                Some(NamedLaw { force, elastic: [stiffness, Expr::Number(1.5), speed.unwrap_or_else(one)] })
            }
            // It has no law of its depth.
            ContactLaw::Rigid => None,
        }
    }

    /// F = max(0, k d + c ḋ), c times the release where ḋ < 0 (Goldsmith, Impact, 1960).
    fn kelvin_voigt(&mut self, named: &'d Named, meeting: &Meeting, way: Dimension) -> Option<(Expr, Expr)> {
        let stiffness = Dimension::TORQUE.over(way).over(way);
        let k = self.positive(named, "stiffness", stiffness)?;
        let c = self.not_negative(named, "damping", stiffness.times(Dimension::TIME))?;
        let held = self.holds_gates();
        let gap = &meeting.gap;
        let d = if held { fold::unary(Function1::Neg, gap.clone()) } else { depth(gap) };
        let rate = closing(gap);
        let elastic = product(k.clone(), d);
        let resisted = match named.entry("release") {
            None => product(c, rate),
            Some(entry) => {
                let share = self.number(entry, Dimension::ONE, "release")?;
                if !(0.0..=1.0).contains(&share) {
                    self.diagnostics.error(entry.value.region, messages::release_out_of_range(share));
                    return None;
                }
                let inwards = Condition::Compare(Comparison::Less, Expr::Number(0.0), rate.clone());
                let weight =
                    Expr::If(Box::new(inwards), Box::new(Expr::Number(1.0)), Box::new(Expr::Number(share)));
                product(product(c, weight), rate)
            }
        };
        let force = sum(elastic, resisted);
        Some((if held { force } else { pushing(force) }, k))
    }

    /// F = K d^{3/2} with K = 4/(3(σ₁ + σ₂)) √R, σ = (1 − ν²)/E (Hertz 1882; Johnson, Contact Mechanics, 1985, 4.2).
    fn hertz(&mut self, named: &'d Named, region: Region, meeting: &Meeting) -> Option<(Expr, Expr)> {
        let (first, second) = (self.compliance(named, "first"), self.compliance(named, "second"));
        let compliance = sum(first?, second?);
        let Some(radius) = meeting.radius.clone() else {
            self.diagnostics.error(region, messages::hertz_without_radii());
            return None;
        };
        let modulus = quotient(Expr::Number(4.0 / 3.0), compliance);
        let stiffness = product(modulus, fold::unary(Function1::Sqrt, radius));
        let elastic =
            product(stiffness.clone(), self.powered(fold::unary(Function1::Neg, meeting.gap.clone()), 1.5));
        Some((elastic, stiffness))
    }

    /// (1 − ν²)/E of a material.
    fn compliance(&mut self, named: &'d Named, which: &str) -> Option<Expr> {
        let entry = named.entry(which)?;
        let material = match (&entry.value.kind, &entry.unit) {
            (TermKind::Name(path), None) => self.names.material(&path.text),
            _ => None,
        };
        let definition = self.definition;
        let Some(index) = material else {
            let known = definition.materials.iter().map(|it| it.name.text.as_str());
            self.diagnostics.error(entry.value.region, messages::no_such_material(known));
            return None;
        };
        let material = &definition.materials[index];
        self.used.insert((Scope::Material, &material.name.text));
        let of = |name: &str| {
            material.entries.iter().find(|(label, _)| label.text == name).map(|(_, entry)| entry)
        };
        let (modulus, poisson) = (of("modulus")?, of("poisson")?);
        let pressure = Dimension::STIFFNESS.over(Dimension::LENGTH);
        let e = self.number(modulus, pressure, "modulus")?;
        let nu = self.number(poisson, Dimension::ONE, "poisson")?;
        if e <= 0.0 {
            let message = messages::size_of_load("modulus", &material.name.text, e);
            self.diagnostics.error(modulus.value.region, message);
            return None;
        }
        if !(-1.0..=0.5).contains(&nu) {
            self.diagnostics.error(poisson.value.region, messages::poisson_out_of_range(nu));
            return None;
        }
        Some(Expr::Number((1.0 - nu * nu) / e))
    }

    /// F max(0, 1 + b ḋ) (Hunt and Crossley, J. Appl. Mech. 42 (1975) 440), b as written or from a restitution at a speed.
    fn dissipating(
        &mut self,
        named: &'d Named,
        region: Region,
        elastic: Expr,
        meeting: &Meeting,
        way: Dimension,
    ) -> Option<(Expr, Option<Expr>)> {
        let per_speed = Dimension::TIME.over(way);
        let (b, speed) = match (named.entry("dissipation"), named.entry("restitution")) {
            (Some(_), Some(restitution)) => {
                self.diagnostics.error(restitution.value.region, messages::two_dissipations());
                return None;
            }
            (None, None) => {
                self.diagnostics.error(region, messages::no_dissipation());
                return None;
            }
            (Some(_), None) => (self.not_negative(named, "dissipation", per_speed)?, None),
            (None, Some(entry)) => self.by_restitution(named, entry, way)?,
        };
        if let (Some(_), Some(other)) =
            (named.entry("dissipation"), named.entry("speed").or(named.entry("damping")))
        {
            self.diagnostics.error(other.value.region, messages::belongs_to_restitution());
            return None;
        }
        if b == Expr::Number(0.0) {
            return Some((elastic, speed));
        }
        let factor = sum(Expr::Number(1.0), product(b, closing(&meeting.gap)));
        Some((product(elastic, if self.holds_gates() { factor } else { pushing(factor) }), speed))
    }

    fn by_restitution(
        &mut self,
        named: &'d Named,
        entry: &'d Entry,
        way: Dimension,
    ) -> Option<(Expr, Option<Expr>)> {
        let e = self.number(entry, Dimension::ONE, "restitution")?;
        if !(0.0..=1.0).contains(&e) {
            self.diagnostics.error(entry.value.region, messages::restitution_out_of_range(e));
            return None;
        }
        let damping = match named.entry("damping") {
            None => Damping::Exact,
            Some(word) => Damping::ALL[self.word_of(word, &Damping::WORDS)?],
        };
        let Some(speed) = named.entry("speed") else {
            self.diagnostics.error(entry.value.region, messages::restitution_without_speed());
            return None;
        };
        if let TermKind::Name(path) = &speed.value.kind
            && path.text.rsplit('.').next() == Some("touch")
            && self.names.value(&path.text).is_none()
        {
            self.diagnostics.error(speed.value.region, messages::speed_of_touch());
            return None;
        }
        let v = self.positive(named, "speed", way.over(Dimension::TIME))?;
        if e < restitution::LEAST {
            self.diagnostics.error(entry.value.region, messages::restitution_too_small(e));
            return None;
        }
        Some((quotient(Expr::Number(damping.number(e)), v.clone()), Some(v)))
    }

    fn positive(&mut self, named: &'d Named, what: &str, dimension: Dimension) -> Option<Expr> {
        self.sized(named, what, dimension, |found| found > 0.0)
    }

    fn not_negative(&mut self, named: &'d Named, what: &str, dimension: Dimension) -> Option<Expr> {
        self.sized(named, what, dimension, |found| found >= 0.0)
    }

    fn sized(
        &mut self,
        named: &'d Named,
        what: &str,
        dimension: Dimension,
        fits: fn(f64) -> bool,
    ) -> Option<Expr> {
        let Some(entry) = named.entry(what) else { return Some(Expr::Number(0.0)) };
        let value = self.entry(entry, dimension, Use::COEFFICIENT, what)?;
        if let Some(found) = fold::evaluate(&value, self.defaults()).filter(|found| !fits(*found)) {
            self.diagnostics.error(entry.value.region, messages::contact_pulls(what, found));
            return None;
        }
        Some(value)
    }

    /// max(x, 0)ⁿ; what is no whole power by a base that is not zero, where its slope is finite.
    fn powered(&self, x: Expr, exponent: f64) -> Expr {
        if exponent == 1.0 && self.holds_gates() {
            return x;
        }
        let least = if exponent.fract() == 0.0 { 0.0 } else { LEAST };
        fold::power(fold::binary(Function2::Max, x, Expr::Number(least)), exponent)
    }
}
