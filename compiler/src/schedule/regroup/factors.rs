//! Common factors, taken out of the terms of a sum where that spares an operation.
//!
//! ```text
//! x·(a·b) + x·c + d:      a product, two fused multiply-adds
//! x·(a·b + c) + d:        two fused multiply-adds
//! k·(x·(y + l)) + d:      a sum, a product, a fused multiply-add
//! x·(k·y + k l) + d:      two fused multiply-adds
//! ```
//! (Horner's scheme; Knuth, The Art of Computer Programming 2, 4.6.4.)

use super::super::program::{Instruction, Operand};
use super::terms::{Of, Sums, Term, constants_added, is_sum};
use super::written::{operations, order};
use std::collections::BTreeMap;

/// What is left of a term without one of its factors.
enum Cofactor {
    Value(Operand),
    Product(Operand, Operand),
    Sum(Vec<Term>),
}

/// An operand, to be found by.
type Key = (u8, u64);

fn key(operand: Operand) -> Key {
    match operand {
        Operand::Constant(value) => (0, value.to_bits()),
        Operand::Source(source) => (1 + source.argument as u8, u64::from(source.index)),
        Operand::Value(value) => (u8::MAX, u64::from(value)),
    }
}

impl Sums<'_> {
    /// The terms in order with common factors taken out, and how many other instructions compute what has gone into them; nothing where that spares none.
    pub(super) fn factored(&self, terms: &[Term]) -> Option<(Vec<Term>, usize)> {
        let mut inner = 0;
        let mut kept: Vec<Option<Term>> = Vec::with_capacity(terms.len());
        // The last term that has each factor.
        let mut with: BTreeMap<Key, usize> = BTreeMap::new();
        for term in terms {
            let mut term = term.clone();
            if let Some((taken, gone)) = self.without_constant(&term) {
                (term, inner) = (taken, inner + gone);
            }
            let factors = loop {
                let factors = self.split(&term);
                let found = factors.iter().find_map(|(factor, cofactor)| {
                    let at = *with.get(&key(*factor))?;
                    let other = kept[at].as_ref()?;
                    Some((at, self.together(*factor, other, &term, cofactor)?))
                });
                let Some((at, (taken, gone))) = found else { break factors };
                kept[at] = None;
                (term, inner) = (taken, inner + gone);
            };
            with.extend(factors.into_iter().map(|(factor, _)| (key(factor), kept.len())));
            kept.push(Some(term));
        }
        if inner == 0 {
            return None;
        }
        let mut terms = in_order(kept.into_iter().flatten().collect());
        if let [Term { of: Of::ProductOfSum(_, inner), minus, .. }] = &mut terms[..]
            && std::mem::take(minus)
        {
            inner.iter_mut().for_each(|term| term.minus = !term.minus);
        }
        Some((terms, inner))
    }

    /// k·(x·(c + …)) as x·(k c + …), and how many instructions are in it.
    fn without_constant(&self, term: &Term) -> Option<(Term, usize)> {
        let (k, product) = match term.of {
            Of::Product(Operand::Constant(k), product) | Of::Product(product, Operand::Constant(k)) => {
                (k, product)
            }
            _ => return None,
        };
        let (x, y) = self.product_once(product)?;
        let (x, sum) = match (self.sum_once(x), self.sum_once(y)) {
            (_, Some(sum)) => (x, sum),
            (Some(sum), _) => (y, sum),
            _ => return None,
        };
        let (terms, inner) = self.terms(sum);
        let present = operations(&terms);
        let scaled: Option<Vec<Term>> = terms.into_iter().map(|term| self.scaled(k, term)).collect();
        let scaled = scaled.filter(|scaled| !scaled.is_empty() && operations(scaled) <= present)?;
        Some((self.term(Of::ProductOfSum(x, in_order(scaled)), term.minus), inner + 2))
    }

    /// k times a term that has a constant factor or is a constant.
    fn scaled(&self, k: f64, term: Term) -> Option<Term> {
        let times = |k: f64, other: Operand| match k {
            1.0 => Of::Value(other),
            k => Of::Product(Operand::Constant(k), other),
        };
        let of = match term.of {
            Of::Value(Operand::Constant(c)) => Of::Value(Operand::Constant(k * c)),
            Of::Value(Operand::Value(value)) => match self.program.instructions[value as usize] {
                Instruction::Mul(Operand::Constant(c), x) | Instruction::Mul(x, Operand::Constant(c)) => {
                    times(k * c, x)
                }
                _ => times(k, Operand::Value(value)),
            },
            Of::Value(other) => times(k, other),
            Of::Product(Operand::Constant(c), x) | Of::Product(x, Operand::Constant(c)) => times(k * c, x),
            _ => return None,
        };
        Some(self.term(of, term.minus))
    }

    /// Two terms as one product, where they have a factor in common and that spares an operation.
    fn together(&self, factor: Operand, one: &Term, other: &Term, its: &Cofactor) -> Option<(Term, usize)> {
        let (_, own) = self.split(one).into_iter().find(|(known, _)| *known == factor)?;
        let (mut inner, mut present, mut terms) = (0, 2, Vec::new());
        for (cofactor, minus) in [(&own, false), (its, one.minus != other.minus)] {
            let (own, gone) = self.terms_of(cofactor);
            present += operations(&own);
            inner += gone;
            terms.extend(own.into_iter().map(|term| Term { minus: term.minus != minus, ..term }));
        }
        let terms = in_order(constants_added(terms));
        let spares = !terms.is_empty() && 1 + operations(&terms) < present;
        spares.then(|| (self.term(Of::ProductOfSum(factor, terms), one.minus), inner))
    }

    /// The terms of a cofactor, and how many instructions compute it.
    fn terms_of(&self, cofactor: &Cofactor) -> (Vec<Term>, usize) {
        match cofactor {
            Cofactor::Sum(terms) => (terms.clone(), 0),
            Cofactor::Product(a, b) => (vec![self.term(Of::Product(*a, *b), false)], 1),
            Cofactor::Value(value) => match self.sum_once(*value) {
                Some(sum) => {
                    let (terms, inner) = self.terms(sum);
                    (terms, inner + 1)
                }
                None => (vec![self.term(Of::Value(*value), false)], 0),
            },
        }
    }

    /// The factors of a term, and what is left of it without each.
    fn split(&self, term: &Term) -> Vec<(Operand, Cofactor)> {
        let (a, b) = match &term.of {
            Of::Value(_) => return Vec::new(),
            Of::Product(a, b) => (*a, *b),
            Of::ProductOfSum(a, terms) => return vec![(*a, Cofactor::Sum(terms.clone()))],
        };
        let mut found = Vec::new();
        for (a, b) in [(a, b), (b, a)] {
            match self.product_once(b) {
                Some((p, q)) => {
                    found.push((a, Cofactor::Product(p, q)));
                    found.extend([(p, Cofactor::Product(a, q)), (q, Cofactor::Product(a, p))]);
                }
                None => found.push((a, Cofactor::Value(b))),
            }
        }
        found
    }

    /// The factors of a product that is needed once.
    fn product_once(&self, operand: Operand) -> Option<(Operand, Operand)> {
        let Operand::Value(value) = operand else { return None };
        match self.program.instructions[value as usize] {
            Instruction::Mul(a, b) if self.uses[value as usize] == 1 => Some((a, b)),
            _ => None,
        }
    }

    /// A sum that is needed once.
    fn sum_once(&self, operand: Operand) -> Option<u32> {
        let Operand::Value(value) = operand else { return None };
        let is_once = self.uses[value as usize] == 1 && is_sum(&self.program.instructions[value as usize]);
        is_once.then_some(value)
    }
}

fn in_order(terms: Vec<Term>) -> Vec<Term> {
    order(&terms).into_iter().map(|at| terms[at].clone()).collect()
}
