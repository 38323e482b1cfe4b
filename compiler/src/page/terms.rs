//! Sums of products while they are being written: what is alike is one term, and products of cosines and sines are those of
//! sums of angles.

use crate::symbolic::Node;
use std::collections::BTreeMap;

/// Σ weight · angle, by index of rotation.
pub type Angle = Vec<(usize, i32)>;

/// Something that is multiplied.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Factor {
    Node(Node),
    /// A sum all of whose terms are negative, with the other sign.
    Opposite(Node),
    /// Sine or cosine of Σ weight · angle, by index of rotation.
    Turned {
        is_sine: bool,
        angle: Angle,
    },
    /// An angle over several turns, by its index.
    Counted(usize),
}

/// A coefficient and powers of factors.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    pub coefficient: f64,
    pub factors: BTreeMap<Factor, i32>,
}

impl Term {
    pub fn times(mut self, factor: f64) -> Term {
        self.coefficient *= factor;
        self
    }

    /// Times another to the power of one or minus one.
    pub fn by(mut self, other: &Term, power: i32) -> Term {
        self.coefficient *= if power > 0 { other.coefficient } else { 1.0 / other.coefficient };
        for (factor, exponent) in &other.factors {
            let own = self.factors.entry(factor.clone()).or_insert(0);
            *own += power * exponent;
            if *own == 0 {
                self.factors.remove(factor);
            }
        }
        self
    }

    /// Takes a power of a factor away.
    fn lower(&mut self, factor: &Factor, power: i32) {
        let left = self.factors.remove(factor).unwrap_or(0) - power;
        if left != 0 {
            self.factors.insert(factor.clone(), left);
        }
    }

    /// What is left of the factors without those of another.
    fn without(&self, other: &Term) -> Vec<(Factor, i32)> {
        let mut rest = Vec::new();
        for (factor, power) in &self.factors {
            let less = power - other.factors.get(factor).copied().unwrap_or(0);
            if less != 0 {
                rest.push((factor.clone(), less));
            }
        }
        rest.extend(
            other
                .factors
                .iter()
                .filter(|(factor, _)| !self.factors.contains_key(*factor))
                .map(|(f, p)| (f.clone(), -p)),
        );
        rest
    }
}

/// cos² a + sin² a = 1, cos a cos b ± sin a sin b = cos(a ∓ b) and sin a cos b ± cos a sin b = sin(a ± b), whatever both are multiplied by;
/// terms that differ in their coefficient alone are one.
pub fn merged(mut terms: Vec<Term>) -> Vec<Term> {
    'again: loop {
        for i in 0..terms.len() {
            for j in i + 1..terms.len() {
                if let Some(one) = together(&terms[i], &terms[j]) {
                    terms[i] = one;
                    terms.remove(j);
                    continue 'again;
                }
            }
        }
        return terms;
    }
}

fn together(a: &Term, b: &Term) -> Option<Term> {
    let rest = a.without(b);
    if rest.is_empty() {
        return Some(Term { coefficient: a.coefficient + b.coefficient, factors: a.factors.clone() });
    }
    let ratio = b.coefficient / a.coefficient;
    if let [
        (Factor::Turned { is_sine: a_sine, angle: x }, m),
        (Factor::Turned { is_sine: b_sine, angle: y }, n),
    ] = &rest[..]
        && (a_sine != b_sine && x == y && m.abs() == 2 && *m == -*n && (ratio - 1.0).abs() <= 1e-14)
    {
        let (own, _) = rest.iter().find(|(_, power)| *power == 2)?;
        let mut one = a.clone();
        one.lower(own, 2);
        return Some(one);
    }
    if rest.len() != 4 || !ratio.is_finite() || (ratio.abs() - 1.0).abs() > 1e-14 {
        return None;
    }
    let side = |power: i32| -> Option<[(bool, Angle); 2]> {
        let found = rest.iter().filter(|(_, own)| *own == power).filter_map(|(factor, _)| match factor {
            Factor::Turned { is_sine, angle } => Some((*is_sine, angle.clone())),
            _ => None,
        });
        found.collect::<Vec<_>>().try_into().ok()
    };
    let ([(sine_a, x), (sine_b, y)], [(sine_c, z), (sine_d, w)]) = (side(1)?, side(-1)?);
    // The same two angles on both sides, each once as a sine and once as a cosine.
    let swapped = (sine_a != sine_c && x == z && sine_b != sine_d && y == w)
        || (sine_a != sine_d && x == w && sine_b != sine_c && y == z);
    if !swapped || x == y {
        return None;
    }
    let sign = if ratio > 0.0 { 1 } else { -1 };
    let (is_sine, (angle, factor)) = match (sine_a, sine_b) {
        // cos x cos y ± sin x sin y; sin x sin y ± cos x cos y = ±(cos x cos y ± sin x sin y).
        (false, false) => (false, (added(&x, &y, -sign), 1.0)),
        (true, true) => (false, (added(&x, &y, -sign), f64::from(sign))),
        // Cosines stand before sines.
        _ => (true, (added(&y, &x, sign), 1.0)),
    };
    let leading = angle.first().is_some_and(|(_, weight)| *weight < 0);
    let (angle, factor) = match leading {
        true => (angle.iter().map(|(r, w)| (*r, -w)).collect(), if is_sine { -factor } else { factor }),
        false => (angle, factor),
    };
    let mut one = a.clone();
    one.coefficient *= factor;
    for (own, power) in rest.iter().filter(|(_, power)| *power > 0) {
        one.lower(own, *power);
    }
    *one.factors.entry(Factor::Turned { is_sine, angle }).or_insert(0) += 1;
    Some(one)
}

/// a ± b, without what cancels.
fn added(a: &[(usize, i32)], b: &[(usize, i32)], sign: i32) -> Vec<(usize, i32)> {
    let mut sum: BTreeMap<usize, i32> = a.iter().copied().collect();
    for (rotation, weight) in b {
        *sum.entry(*rotation).or_insert(0) += sign * weight;
    }
    sum.into_iter().filter(|(_, weight)| *weight != 0).collect()
}

/// Numbers last, and first what has no sign.
pub fn in_order(terms: &[Term]) -> Vec<&Term> {
    let (numbers, mut terms): (Vec<&Term>, Vec<&Term>) =
        terms.iter().filter(|term| term.coefficient != 0.0).partition(|term| term.factors.is_empty());
    if let Some(first) = terms.iter().position(|term| term.coefficient > 0.0) {
        terms[..=first].rotate_right(1);
    } else if numbers.first().is_some_and(|number| number.coefficient > 0.0) {
        return numbers.into_iter().chain(terms).collect();
    }
    terms.extend(numbers);
    terms
}
