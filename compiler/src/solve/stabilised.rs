//! What rows ask of accelerations with Baumgarte's terms.
//!
//! −γ, D v − ν and Φ of a loop are made of the same cosines and sines: what a rod adds to −γ is −l cos φ · φ̇², and to Φ it is l cos φ. Both
//! together are l cos φ (β² − φ̇²), which spares the sum Φ. What turns as a whole, a vector in moving axes, is likewise turned once in
//! place of three times.
//!
//! 2α (D v − ν) need not be formed at all. With w = v̇ + 2α v the equations are
//!
//! ```text
//! M w + Dᵀ λ = Q + 2α M v,    D w = γ + 2α ν − β² Φ,
//! ```
//!
//! so that a product for each velocity and M v take the place of D v. With w = v̇ + 2α v of dependent velocities alone the others stay in the rows,
//! 2α D_i v_i, and M takes the dependent ones.

use crate::equations::{Equations, Jet, Row};
use crate::symbolic::{Class, Computed, Graph, Node, Op, Sheet};

/// What rows ask of accelerations with Baumgarte's terms, α and β in 1/s. Source: Baumgarte, *Stabilization of constraints and integrals of
/// motion in dynamical systems*, Computer Methods in Applied Mechanics and Engineering 1 (1972).
pub struct Asked {
    /// −γ + 2α (D v − ν) + β² Φ, an entry for each row, in its unit (m, rad or 1) per s², or −γ − 2α ν + β² Φ where there is a shift.
    pub rows: Vec<Node>,
    /// Zero, or 2α v, an entry for each velocity, in its unit (m/s or rad/s) per s: the rows then ask this of v̇ + 2α v in place of v̇.
    pub shift: Vec<Node>,
}

/// How 2α (D v − ν) enters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Damping {
    InRows,
    ByShift,
    /// By a shift of the dependent velocities, of others in the rows.
    ByShiftOfDependent,
}

/// Each row is a sum of its parts or has their common factors taken out, whichever takes fewer operations beside M, D and Q.
/// `is_dependent`: which velocities are; empty where none is.
pub fn stabilised(equations: &Equations, damping: Damping, is_dependent: &[bool]) -> Asked {
    asked(equations, damping, is_dependent, known(equations))
}

/// The same as promises fewer operations, in the rows or by a shift of all, where writing all out to be counted takes too long. `beyond`: what a shift
/// takes besides.
pub fn stabilised_by_estimate(equations: &Equations, beyond: usize) -> Asked {
    let known = known(equations);
    let ways =
        [Damping::InRows, Damping::ByShift].map(|damping| asked(equations, damping, &[], known.clone()));
    let graph = equations.graph.read();
    let [in_rows, by_shift] = ways.each_ref().map(|asked| known.clone().cost(&graph, &asked.rows));
    let [first, second] = ways;
    if by_shift + beyond < in_rows { second } else { first }
}

fn asked(equations: &Equations, damping: Damping, is_dependent: &[bool], known: Computed) -> Asked {
    let Equations { graph, symbols, rows, zero, .. } = equations;
    let g = graph.sheet();
    let is_shifted = |velocity: usize| match damping {
        Damping::InRows => false,
        Damping::ByShift => true,
        Damping::ByShiftOfDependent => is_dependent.get(velocity) == Some(&true),
    };
    let shift = |(velocity, v): (usize, &Node)| match is_shifted(velocity) {
        true => (g.on(symbols.two_alpha) * *v).bare,
        false => *zero,
    };
    // What the rows have of 2α (D v − ν), divided by a factor.
    let two_alpha = g.on(symbols.two_alpha);
    let (factor, in_rows): (Node, &dyn Fn(&Jet) -> Node) = match damping {
        Damping::InRows => (two_alpha.bare, &|jet| jet.rate(g, &symbols.v).bare),
        Damping::ByShift => (two_alpha.bare, &|jet| jet.drift),
        // 2α v in place of v is a product for all rows.
        Damping::ByShiftOfDependent => (g.one().bare, &|jet| {
            let own = jet.columns.iter().filter(|(velocity, _)| !is_shifted(**velocity));
            let own = own.map(|(velocity, entry)| g.on(*entry) * (two_alpha * symbols.v[*velocity]));
            (g.sum(own) + two_alpha * jet.drift).bare
        }),
    };
    let rows = sums(g, rows, known, [factor, symbols.beta_squared], in_rows);
    Asked { rows, shift: symbols.v.iter().enumerate().map(shift).collect() }
}

/// M, D and Q.
fn known(equations: &Equations) -> Computed {
    let Equations { graph, rows, mass, forces, .. } = equations;
    let columns = rows.iter().flat_map(|row| row.jet.columns.values());
    let nodes: Vec<Node> = mass.values().chain(columns).chain(forces).copied().collect();
    let mut known = Computed::default();
    known.add(&graph.read(), &nodes);
    known
}

/// The rows, with what of D v − ν is to be in them.
fn sums(
    g: Sheet,
    rows: &[Row],
    mut known: Computed,
    factors: [Node; 2],
    rate: impl Fn(&Jet) -> Node,
) -> Vec<Node> {
    let mut all = Vec::with_capacity(rows.len());
    for rows in rows.chunk_by(|a, b| a.origin == b.origin) {
        let of = |row: &Row| [row.jet.bias, rate(&row.jet), row.jet.value];
        let apart: Vec<Node> = rows.iter().map(|row| added(g, of(row), factors)).collect();
        let together: Vec<Node> = rows.iter().map(|row| gathered(g, of(row), factors)).collect();
        let graph = g.graph();
        let taken = if known.cost(&graph, &together) < known.cost(&graph, &apart) { together } else { apart };
        known.add(&graph, &taken);
        all.extend(taken);
    }
    all
}

/// The bias, and the others times their factors.
fn added(g: Sheet, [bias, rate, value]: [Node; 3], [two_alpha, beta_squared]: [Node; 2]) -> Node {
    (g.on(bias) + g.on(two_alpha) * rate + g.on(beta_squared) * value).bare
}

/// The same with the terms of the others taken into those of the bias that have a factor in common with them.
fn gathered(g: Sheet, [bias, rate, value]: [Node; 3], [two_alpha, beta_squared]: [Node; 2]) -> Node {
    let graph = &mut g.graph();
    let (bias, rate) = taken_in(graph, bias, two_alpha, rate);
    let (bias, value) = taken_in(graph, bias, beta_squared, value);
    let [rate, value] =
        [(two_alpha, rate), (beta_squared, value)].map(|(factor, left)| graph.mul(factor, left));
    let sum = graph.add(bias, rate);
    graph.add(sum, value)
}

/// A sum with those terms of another, times `factor`, that share a factor with one of its own; and the sum of the others.
fn taken_in(g: &mut Graph, mut sum: Node, factor: Node, other: Node) -> (Node, Node) {
    let mut terms = Vec::new();
    terms_of(g, other, false, &mut terms);
    let mut left = g.constant(0.0);
    let mut all_left = true;
    for term in terms {
        match within(g, sum, false, factor, term) {
            Some(with) => (sum, all_left) = (with, false),
            None if term.minus => left = g.sub(left, term.node),
            None => left = g.add(left, term.node),
        }
    }
    // What is left of a sum in whole stays as it is written.
    (sum, if all_left { other } else { left })
}

/// A term of a sum.
#[derive(Clone, Copy)]
struct Term {
    minus: bool,
    node: Node,
}

/// The terms of a sum, left to right.
fn terms_of(g: &Graph, sum: Node, minus: bool, terms: &mut Vec<Term>) {
    match g.op(sum) {
        Op::Add(a, b) => {
            terms_of(g, a, minus, terms);
            terms_of(g, b, minus, terms);
        }
        Op::Sub(a, b) => {
            terms_of(g, a, minus, terms);
            terms_of(g, b, !minus, terms);
        }
        Op::Neg(a) => terms_of(g, a, !minus, terms),
        _ => terms.push(Term { minus, node: sum }),
    }
}

/// The sum and `factor` times the term, `minus`: of its negative, if a term of the sum has a factor in common with it.
fn within(g: &mut Graph, sum: Node, minus: bool, factor: Node, term: Term) -> Option<Node> {
    match g.op(sum) {
        Op::Add(a, b) => match within(g, a, minus, factor, term) {
            Some(a) => Some(g.add(a, b)),
            None => within(g, b, minus, factor, term).map(|b| g.add(a, b)),
        },
        Op::Sub(a, b) => match within(g, a, minus, factor, term) {
            Some(a) => Some(g.sub(a, b)),
            None => within(g, b, !minus, factor, term).map(|b| g.sub(a, b)),
        },
        Op::Neg(a) => within(g, a, !minus, factor, term).map(|a| g.neg(a)),
        _ => {
            let (common, own, other) = common(g, sum, term.node)?;
            let other = g.mul(factor, other);
            let both = if minus == term.minus { g.add(own, other) } else { g.sub(own, other) };
            Some(g.mul(common, both))
        }
    }
}

/// A common factor of a product and of a term, which may be that factor alone, and what is left of each.
fn common(g: &mut Graph, product: Node, term: Node) -> Option<(Node, Node, Node)> {
    let Op::Mul(x, y) = g.op(product) else { return None };
    let one = g.constant(1.0);
    let moves = |factor: Node| g.class(factor) > Class::Parameter;
    for (factor, own) in [(x, y), (y, x)].into_iter().filter(|(factor, _)| moves(*factor)) {
        match g.op(term) {
            _ if term == factor => return Some((factor, own, one)),
            Op::Mul(u, v) if u == factor => return Some((factor, own, v)),
            Op::Mul(u, v) if v == factor => return Some((factor, own, u)),
            _ => {}
        }
    }
    // k (x y) and k x.
    match g.op(term) {
        Op::Mul(k, term) if k == x && !moves(k) => {
            let (factor, own, other) = common(g, y, term)?;
            Some((g.mul(k, factor), own, other))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::{Growing, evaluate};

    const SYMBOLS: [&str; 8] = ["c", "s", "w", "d", "e", "u", "2 alpha", "beta^2"];

    fn values(graph: &Growing, nodes: &[Node]) -> Vec<f64> {
        let at: Vec<f64> = (0..SYMBOLS.len()).map(|at| 0.4 + 0.37 * at as f64).collect();
        let values = evaluate(&graph.read(), &at);
        nodes.iter().map(|node| values[node.index()]).collect()
    }

    /// Two rods in a row: −γ is −(l c w² + d u²), Φ is l c + d − 2, and the rate −(l s w + e u).
    #[test]
    fn a_rod_is_in_one_term() {
        let graph = Growing::default();
        let g = graph.sheet();
        let [c, s, w, d, e, u, two_alpha, beta_squared] = SYMBOLS.map(|name| g.symbol(name, Class::Velocity));
        let bias = -(0.3 * c * w.square() + d * u.square());
        let (rate, value) = (-(0.3 * s * w + e * u), 0.3 * c + d - 2.0);
        let row = [bias, rate, value].map(|part| part.bare);
        let factors = [two_alpha.bare, beta_squared.bare];
        let both = [added(g, row, factors), gathered(g, row, factors)];
        let expected = two_alpha * rate
            - 0.3 * c * (w.square() - beta_squared)
            - d * (u.square() - beta_squared)
            - 2.0 * beta_squared;
        let [apart, together, expected] = values(&graph, &[both[0], both[1], expected.bare])[..] else {
            panic!("three values");
        };
        assert!((apart - together).abs() < 1e-14 && (apart - expected).abs() < 1e-14, "{apart} {together}");
        let mut known = Computed::default();
        let costs = both.map(|row| known.cost(&g.graph(), &[row]));
        assert!(costs[1] < costs[0], "{costs:?}");
    }

    /// A vector that turns: all three have the same factors, and are turned together.
    #[test]
    fn a_vector_is_turned_once() {
        let graph = Growing::default();
        let g = graph.sheet();
        let [c, s, w, d, e, u, two_alpha, beta_squared] = SYMBOLS.map(|name| g.symbol(name, Class::Velocity));
        let turned = |x, y| [c * x - s * y, s * x + c * y];
        let [bias, rate, value] = [turned(w * d, u * u), turned(w, u), turned(d, e)];
        let factors = [two_alpha.bare, beta_squared.bare];
        let rows = [0, 1].map(|at| [bias[at].bare, rate[at].bare, value[at].bare]);
        let apart = rows.map(|row| added(g, row, factors));
        let together = rows.map(|row| gathered(g, row, factors));
        for (a, b) in values(&graph, &apart).into_iter().zip(values(&graph, &together)) {
            assert!((a - b).abs() < 1e-14, "{a} {b}");
        }
        let mut known = Computed::default();
        let costs = [apart, together].map(|rows| known.cost(&g.graph(), &rows));
        assert!(costs[1] + 6 <= costs[0], "{costs:?}");
    }
}
