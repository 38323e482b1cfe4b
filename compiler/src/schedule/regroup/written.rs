//! Sums as instructions: the fewest that add up their terms.

use super::super::program::{Instruction, Operand};
use super::terms::{Of, Term};

/// Values from here on stand for the instructions of a sum itself.
pub(super) const OWN: u32 = 1 << 31;

/// A sum of more products than these keeps its order where its one other term comes latest: begun with it, it would be that much later.
const MANY: usize = 4;

/// The instructions of a sum, one after the other.
pub(super) type Sum = Vec<Instruction>;

/// Which of the terms comes first, second …
pub(super) fn order(terms: &[Term]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..terms.len()).collect();
    order.sort_by_key(|at| terms[*at].late);
    order
}

/// How many operations a sum of these takes.
pub(super) fn operations(terms: &[Term]) -> usize {
    let own = |term: &Term| match &term.of {
        Of::ProductOfSum(_, terms) => operations(terms),
        _ => 0,
    };
    let begins = terms.iter().any(|term| !term.is_product());
    terms.len() - usize::from(begins) + terms.iter().map(own).sum::<usize>()
}

/// The sum of these, one instruction after the other, where each is used by those behind it; `None` if that takes more than at present, or as much and no term is a product.
pub(super) fn added_up(terms: Vec<Term>, present: usize) -> Option<Sum> {
    let products = terms.iter().filter(|term| term.is_product()).count();
    let fewest = operations(&terms);
    let is_no_sum = matches!(&terms[..], [] | [Term { of: Of::Value(_) | Of::Product(..), .. }]);
    if is_no_sum || fewest > present || (products == 0 && fewest == present) {
        return None;
    }
    let first = terms.iter().position(|term| !term.is_product());
    if products == terms.len() - 1 && products > MANY && first == Some(products) {
        return None;
    }
    let mut sum = Vec::with_capacity(fewest);
    add_up(terms, &mut sum)?;
    Some(sum)
}

/// Appends the instructions that add up these terms, and says where the sum is. `None` where all terms are taken away and none is a product.
fn add_up(mut terms: Vec<Term>, sum: &mut Sum) -> Option<Operand> {
    fn last(sum: &Sum) -> Operand {
        Operand::Value(OWN + sum.len() as u32 - 1)
    }
    fn factors(of: Of, sum: &mut Sum) -> Option<[Operand; 2]> {
        match of {
            Of::Value(_) => None,
            Of::Product(a, b) => Some([a, b]),
            Of::ProductOfSum(a, terms) => add_up(terms, sum).map(|b| [a, b]),
        }
    }
    let first = terms.iter().position(|term| !term.is_product());
    let first = terms.remove(first.unwrap_or(0));
    // With a minus it is taken from a term that has none, or by a product, which takes any.
    if first.minus {
        let next = terms.iter().position(|term| term.is_product() || !term.minus)?;
        let next = terms.remove(next);
        terms.insert(0, next);
    }
    let mut so_far = match first.of {
        Of::Value(value) => value,
        of => {
            let [a, b] = factors(of, sum)?;
            sum.push(Instruction::Mul(a, b));
            last(sum)
        }
    };
    let mut negative = first.minus;
    for term in terms {
        let instruction = match (term.of, term.minus) {
            (Of::Value(value), false) if negative => Instruction::Sub(value, so_far),
            (Of::Value(value), false) => Instruction::Add(so_far, value),
            (Of::Value(value), true) => Instruction::Sub(so_far, value),
            (of, minus) => {
                let [a, b] = factors(of, sum)?;
                Instruction::MulAdd(a, b, so_far, minus, negative)
            }
        };
        sum.push(instruction);
        negative = false;
        so_far = last(sum);
    }
    Some(so_far)
}
