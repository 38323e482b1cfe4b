//! Laws of contacts: forces by the depth d = −g > 0 and its rate ḋ = −ġ. None pulls, unless `adhesion = on` says so. Where gates are held, it is they that end a touch where the
//! force would pull: the law is then what it is without that end, and smooth over a step.

use super::pairs::Meeting;
use super::restitution::{self, Damping};
use super::{closing, depth, difference, least, most, product, pushing, quotient, sum};
use crate::diagnostics::Region;
use crate::forms::{ContactLaw, ContactLawForm};
use crate::messages;
use crate::model::lower::{Lowering, Use};
use crate::model::unused::Scope;
use crate::model::{Comparison, Condition, Expr, Function1, Function2, MemoryId, Space, fold};
use crate::syntax::{Entry, Named, TermKind};
use crate::units::Dimension;
use std::f64::consts::PI;

/// What is taken for a depth relative to that of a law where its power has no slope at zero.
const LEAST: f64 = 1e-12;
/// What counts as the speed of a touch at least, m/s or rad/s.
const SLOWEST: f64 = 1e-3;
/// Of Newton's method for s − ln s = η, to the last digit from η = 2 on.
const PASSES: usize = 3;
/// s at η = 2, where d = 4 ΔR e⁻³.
const S_MOST_DEEP: f64 = 3.1461932206205825;
/// s at d = ΔR/1000, for what a touch takes.
const S_TYPICAL: f64 = 9.550659890711273;

/// A named law.
pub(super) struct NamedLaw {
    pub force: Expr,
    /// K, n and the impact speed, or 1 m/s where none is written.
    pub elastic: [Expr; 3],
    /// Whether it pulls where it is below zero.
    pub adheres: bool,
}

/// F(d, ḋ) of a law whose losses grow with its elastic force, and the speed that they are meant for.
struct Resisted {
    force: Expr,
    speed: Expr,
    adheres: bool,
}

impl<'d> Lowering<'d> {
    pub(super) fn named_law(
        &mut self,
        contact: usize,
        form: &'static ContactLawForm,
        named: &'d Named,
        region: Region,
        meeting: &Meeting,
        way: Dimension,
    ) -> Option<NamedLaw> {
        let one = || Expr::Number(1.0);
        let law = |resisted: Resisted, stiffness, exponent| {
            let Resisted { force, speed, adheres } = resisted;
            Some(NamedLaw { force, elastic: [stiffness, Expr::Number(exponent), speed], adheres })
        };
        match form.kind {
            ContactLaw::KelvinVoigt => {
                let adheres = self.adheres(named)?;
                let (force, stiffness) = self.kelvin_voigt(named, meeting, way, adheres)?;
                Some(NamedLaw { force, elastic: [stiffness, one(), one()], adheres })
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
                law(self.dissipating(contact, named, region, elastic, meeting, way)?, stiffness, exponent)
            }
            ContactLaw::Hertz => {
                let (elastic, stiffness) = self.hertz(named, region, meeting)?;
                law(self.dissipating(contact, named, region, elastic, meeting, way)?, stiffness, 1.5)
            }
            ContactLaw::HertzLine => {
                let (elastic, stiffness) = self.hertz_line(named, region, meeting)?;
                law(self.dissipating(contact, named, region, elastic, meeting, way)?, stiffness, 1.0)
            }
            // It has no law of its depth.
            ContactLaw::Rigid => None,
        }
    }

    /// F = max(0, k d + c ḋ), c times the release where ḋ < 0 (Goldsmith, Impact, 1960).
    fn kelvin_voigt(
        &mut self,
        named: &'d Named,
        meeting: &Meeting,
        way: Dimension,
        adheres: bool,
    ) -> Option<(Expr, Expr)> {
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
        Some((if held || adheres { force } else { pushing(force) }, k))
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

    /// F(d) of d = F/(π E l) (ln(4 π E l ΔR/F) − 1), 1/E = σ₁ + σ₂, ΔR = R₁ ± R₂ (Johnson, Contact Mechanics, 1985, 5.6, of both cylinders
    /// with half of the compliance each). With s = ln(4 π E l ΔR/F) − 1 that is
    ///   F = π E l d/s,  s − ln s = ln(4 ΔR/d) − 1,  F′ = π E l/(s − 1),
    /// s by Newton's method. Beyond 4 ΔR e⁻³, a fifth of ΔR, F goes on with the slope that it has there: at 4 ΔR e⁻² none would be left.
    fn hertz_line(&mut self, named: &'d Named, region: Region, meeting: &Meeting) -> Option<(Expr, Expr)> {
        let (first, second) = (self.compliance(named, "first"), self.compliance(named, "second"));
        let length = self.positive(named, "length", Dimension::LENGTH);
        let compliance = sum(first?, second?);
        let Some(radii) = meeting.radii.clone().filter(|_| self.definition.space == Space::Planar) else {
            self.diagnostics.error(region, messages::hertz_line_without_radii(self.definition.space));
            return None;
        };
        let number = Expr::Number;
        let stiffness = quotient(product(number(PI), length?), compliance);
        let most_deep = product(number(4.0 * libm::exp(-3.0)), radii.clone());
        let least_deep = product(number(LEAST), radii.clone());
        let depth = fold::unary(Function1::Neg, meeting.gap.clone());
        let bent = least(depth.clone(), most_deep.clone());
        let within = most(bent.clone(), least_deep);
        let ln = |x: &Expr| fold::unary(Function1::Ln, x.clone());
        let far = difference(ln(&quotient(product(number(4.0), radii), within.clone())), number(1.0));
        // s ≈ η + ln η + ln η/η, less than a twentieth off.
        let mut s = sum(sum(far.clone(), ln(&far)), quotient(ln(&far), far.clone()));
        for _ in 0..PASSES {
            let ahead = sum(far.clone(), difference(ln(&s), number(1.0)));
            s = quotient(product(s.clone(), ahead), difference(s, number(1.0)));
        }
        let beyond = most(difference(depth, most_deep), number(0.0));
        let force = sum(quotient(most(bent, number(0.0)), s), quotient(beyond, number(S_MOST_DEEP - 1.0)));
        let typical = quotient(stiffness.clone(), number(S_TYPICAL));
        Some((product(stiffness, force), typical))
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
        contact: usize,
        named: &'d Named,
        region: Region,
        elastic: Expr,
        meeting: &Meeting,
        way: Dimension,
    ) -> Option<Resisted> {
        let per_speed = Dimension::TIME.over(way);
        let adheres = self.adheres(named)?;
        let (b, speed) = match (named.entry("dissipation"), named.entry("restitution")) {
            (Some(_), Some(restitution)) => {
                self.diagnostics.error(restitution.value.region, messages::two_dissipations());
                return None;
            }
            (None, None) => {
                self.diagnostics.error(region, messages::no_dissipation());
                return None;
            }
            (Some(_), None) => (self.not_negative(named, "dissipation", per_speed)?, Expr::Number(1.0)),
            (None, Some(entry)) => self.by_restitution(contact, named, entry, way)?,
        };
        let of_restitution = ["speed", "slowest", "damping"].iter().find_map(|name| named.entry(name));
        if let (Some(_), Some(other)) = (named.entry("dissipation"), of_restitution) {
            self.diagnostics.error(other.value.region, messages::belongs_to_restitution());
            return None;
        }
        let resisted = |force| Some(Resisted { force, speed, adheres });
        if b == Expr::Number(0.0) {
            return resisted(elastic);
        }
        let factor = sum(Expr::Number(1.0), product(b, closing(&meeting.gap)));
        let pulls = self.holds_gates() || adheres;
        resisted(product(elastic, if pulls { factor } else { pushing(factor) }))
    }

    fn adheres(&mut self, named: &'d Named) -> Option<bool> {
        let Some(entry) = named.entry("adhesion") else { return Some(false) };
        self.word_of(entry, &["on"]).map(|_| true)
    }

    /// b, and the speed that it is for.
    fn by_restitution(
        &mut self,
        contact: usize,
        named: &'d Named,
        entry: &'d Entry,
        way: Dimension,
    ) -> Option<(Expr, Expr)> {
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
        let (v, expected) = match self.memory_of_touches(contact) {
            Some(memory) => (self.speed_at_touch(contact, memory, named, speed, way)?, Expr::Number(1.0)),
            None => {
                if let Some(slowest) = named.entry("slowest") {
                    self.diagnostics.error(slowest.value.region, messages::slowest_of_one_speed());
                    return None;
                }
                let v = self.positive(named, "speed", way.over(Dimension::TIME))?;
                (v.clone(), v)
            }
        };
        if e < restitution::LEAST {
            self.diagnostics.error(entry.value.region, messages::restitution_too_small(e));
            return None;
        }
        Some((quotient(Expr::Number(damping.number(e)), v), expected))
    }

    /// The speed of the touch that lasts, or the slowest that counts.
    fn speed_at_touch(
        &mut self,
        contact: usize,
        memory: MemoryId,
        named: &'d Named,
        speed: &'d Entry,
        way: Dimension,
    ) -> Option<Expr> {
        let definition = self.definition;
        let (name, at) = (&definition.contacts[contact].name.text, speed.value.region);
        self.used.insert((Scope::Value, &definition.memories[memory.0].name.text));
        if !self.holds_gates() {
            let rigid = definition.contacts.iter().find(|it| super::rigid::is_rigid(it));
            self.diagnostics.error(at, messages::speed_of_touch(rigid.map(|it| it.name.text.as_str())));
            return None;
        }
        let gaps = self.gaps_of_contact(contact)?;
        if gaps > 1 {
            self.diagnostics.error(at, messages::touches_at_several(name, gaps));
            return None;
        }
        let slowest = match named.entry("slowest") {
            Some(_) => self.positive(named, "slowest", way.over(Dimension::TIME))?,
            None => Expr::Number(SLOWEST),
        };
        Some(most(Expr::Memory(memory), slowest))
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
