//! The hash-consed expression graph. Equal expressions are one node, so common subexpressions cost nothing, across
//! all outputs; constructors fold constants and bring signs and coefficients into one form, so that expressions
//! that are equal up to sign meet. Nothing is ever expanded.

use super::few::Few;
use super::hash::{FastHash, Known};
use super::rounding::Roundings;
use super::{Compare, Orders, Table, Unary};
use std::hash::BuildHasher;
use std::sync::Arc;

/// A node of a [`Graph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Node(pub(super) u32);

impl Node {
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// How often a value changes; a node has the largest class of its operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Class {
    Constant,
    /// When parameters are set.
    Parameter,
    /// With time and position.
    Position,
    /// With velocity.
    Velocity,
    /// With inputs and settings.
    Input,
}

/// One operation. `Constant` holds the bits of an `f64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    Constant(u64),
    Symbol(u32),
    Neg(Node),
    Add(Node, Node),
    Sub(Node, Node),
    Mul(Node, Node),
    Div(Node, Node),
    Unary(Unary, Node),
    Min(Node, Node),
    Max(Node, Node),
    Atan2(Node, Node),
    /// A mask.
    Compare(Compare, Node, Node),
    /// Both of two masks; `Or`: one of them.
    And(Node, Node),
    Or(Node, Node),
    Not(Node),
    /// mask, then, otherwise.
    Select(Node, Node, Node),
    /// The row of a table that an argument is in, as a number.
    Cell(u16, Node),
    /// A derivative of the cubic piece in that row: table, orders, row, argument.
    Piece(u16, Orders, Node, Node),
    /// A derivative of the patch in that row: table, orders, row, both arguments.
    Patch(u16, Orders, Node, Node, Node),
}

impl Op {
    /// Operands in order.
    pub fn operands(self) -> Few<Node> {
        match self {
            Op::Constant(_) | Op::Symbol(_) => Few::new([Node(0); 3], 0),
            Op::Neg(a) | Op::Unary(_, a) | Op::Not(a) | Op::Cell(_, a) => Few::new([a; 3], 1),
            Op::Add(a, b)
            | Op::Sub(a, b)
            | Op::Mul(a, b)
            | Op::Div(a, b)
            | Op::Min(a, b)
            | Op::Max(a, b)
            | Op::Atan2(a, b)
            | Op::Compare(_, a, b)
            | Op::And(a, b)
            | Op::Or(a, b)
            | Op::Piece(_, _, a, b) => Few::new([a, b, b], 2),
            Op::Select(a, b, c) | Op::Patch(_, _, a, b, c) => Few::new([a, b, c], 3),
        }
    }
}

/// The graph: nodes in the order of their creation, operands before users.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    ops: Vec<Op>,
    classes: Vec<Class>,
    symbols: Vec<(String, Class)>,
    known: Known,
    /// Asked for at every turn.
    zero: Option<Node>,
    tables: Vec<Arc<Table>>,
    pub(super) roundings: Roundings,
}

impl Graph {
    pub fn new() -> Self {
        Self::default()
    }
    pub fn len(&self) -> usize {
        self.ops.len()
    }
    pub fn is_empty(&self) -> bool {
        self.ops.is_empty()
    }
    pub fn op(&self, node: Node) -> Op {
        self.ops[node.index()]
    }
    pub fn class(&self, node: Node) -> Class {
        self.classes[node.index()]
    }
    pub fn nodes(&self) -> impl DoubleEndedIterator<Item = (Node, Op)> + '_ {
        self.ops.iter().enumerate().map(|(index, op)| (Node(index as u32), *op))
    }
    /// The operations of what was added since there were so many nodes.
    pub fn since(&self, count: usize) -> &[Op] {
        &self.ops[count..]
    }
    /// The same graph with one node computed by another operation on older nodes: for tests that must notice.
    pub fn with(&self, node: Node, op: Op) -> Graph {
        let mut changed = self.clone();
        changed.ops[node.index()] = op;
        changed
    }
    /// Name and class of a symbol.
    pub fn symbol_name(&self, symbol: u32) -> &str {
        &self.symbols[symbol as usize].0
    }
    pub fn symbol_count(&self) -> usize {
        self.symbols.len()
    }

    /// The tables that are looked up in, by their numbers.
    pub fn tables(&self) -> &[Arc<Table>] {
        &self.tables
    }
    pub fn table(&self, number: u16) -> &Table {
        &self.tables[usize::from(number)]
    }

    /// A new unknown; two symbols are never equal, whatever their names.
    pub fn symbol(&mut self, name: impl Into<String>, class: Class) -> Node {
        let op = Op::Symbol(self.symbols.len() as u32);
        self.symbols.push((name.into(), class));
        self.intern(op)
    }

    pub fn constant(&mut self, value: f64) -> Node {
        // One zero: −0 would make equal expressions differ.
        if value == 0.0 {
            if let Some(zero) = self.zero {
                return zero;
            }
            let zero = self.intern(Op::Constant(0.0_f64.to_bits()));
            self.zero = Some(zero);
            return zero;
        }
        self.intern(Op::Constant(value.to_bits()))
    }

    /// The constant, if it stands on the graph.
    pub(super) fn known_constant(&self, value: f64) -> Option<Node> {
        self.find(&Op::Constant(value.to_bits()))
    }

    /// The node of a symbol.
    pub(super) fn symbol_node(&mut self, symbol: u32) -> Node {
        self.intern(Op::Symbol(symbol))
    }

    /// The node's value if it is a constant.
    pub fn value(&self, node: Node) -> Option<f64> {
        match self.op(node) {
            Op::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }
    pub fn is_zero(&self, node: Node) -> bool {
        self.zero == Some(node)
    }
    pub fn is_one(&self, node: Node) -> bool {
        self.value(node) == Some(1.0)
    }

    pub fn neg(&mut self, a: Node) -> Node {
        match self.op(a) {
            Op::Constant(bits) => self.constant(-f64::from_bits(bits)),
            Op::Neg(x) => x,
            Op::Sub(x, y) => self.sub(y, x),
            _ => self.intern(Op::Neg(a)),
        }
    }

    pub fn add(&mut self, a: Node, b: Node) -> Node {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        match (self.op(a), self.op(b)) {
            (Op::Constant(x), Op::Constant(y)) => {
                return self.folded_sum(f64::from_bits(x), f64::from_bits(y));
            }
            (Op::Neg(x), Op::Neg(y)) => {
                let sum = self.add(x, y);
                return self.neg(sum);
            }
            (_, Op::Neg(y)) => return self.sub(a, y),
            (Op::Neg(x), _) => return self.sub(b, x),
            // x + (y − x) = y
            (_, Op::Sub(y, x)) if x == a => return y,
            (Op::Sub(y, x), _) if x == b => return y,
            _ => {}
        }
        if a == b {
            let two = self.constant(2.0);
            return self.mul(two, a);
        }
        for (x, choice) in [(a, b), (b, a)] {
            if let Some(left) = self.unless_taken(x, choice, true) {
                return left;
            }
        }
        if let Some(sum) = self.collect_terms(a, b, false) {
            return sum;
        }
        // Constants are positive: −k + x is x − k.
        for (k, x) in [(a, b), (b, a)] {
            if let Some(value) = self.value(k).filter(|value| *value < 0.0) {
                let positive = self.constant(-value);
                return self.sub(x, positive);
            }
        }
        // What changes seldom is added first, so that it can be computed seldom.
        if let Some(sum) = self.join_seldom(a, b) {
            return sum;
        }
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        self.intern(Op::Add(a, b))
    }

    pub fn sub(&mut self, a: Node, b: Node) -> Node {
        if self.is_zero(b) {
            return a;
        }
        if self.is_zero(a) {
            return self.neg(b);
        }
        match (self.op(a), self.op(b)) {
            (Op::Constant(x), Op::Constant(y)) => {
                return self.folded_sum(f64::from_bits(x), -f64::from_bits(y));
            }
            (Op::Neg(x), Op::Neg(y)) => return self.sub(y, x),
            (_, Op::Neg(y)) => return self.add(a, y),
            (Op::Neg(x), _) => {
                let sum = self.add(x, b);
                return self.neg(sum);
            }
            // (x + y) − x = y, x − (x − y) = y
            (Op::Add(x, y), _) if x == b => return y,
            (Op::Add(x, y), _) if y == b => return x,
            (_, Op::Sub(x, y)) if x == a => return y,
            _ => {}
        }
        if a == b {
            return self.constant(0.0);
        }
        if let Some(left) = self.unless_taken(a, b, false) {
            return left;
        }
        if let Some(difference) = self.collect_terms(a, b, true) {
            return difference;
        }
        if let Some(value) = self.value(b).filter(|value| *value < 0.0) {
            let positive = self.constant(-value);
            return self.add(a, positive);
        }
        // −k − x is −(k + x), so that it meets k + x.
        if let Some(value) = self.value(a).filter(|value| *value < 0.0) {
            let positive = self.constant(-value);
            let sum = self.add(positive, b);
            return self.neg(sum);
        }
        // (x − r) − p = x − (r + p), (r + x) − p = (r − p) + x for what changes seldom.
        if self.class(b) <= Class::Parameter && self.class(a) > Class::Parameter {
            match self.op(a) {
                Op::Sub(x, r) if self.class(r) <= Class::Parameter => {
                    let seldom = self.add(r, b);
                    return self.sub(x, seldom);
                }
                Op::Sub(r, x) if self.class(r) <= Class::Parameter => {
                    let seldom = self.sub(r, b);
                    return self.sub(seldom, x);
                }
                Op::Add(r, x) if self.class(r) <= Class::Parameter => {
                    let seldom = self.sub(r, b);
                    return self.add(seldom, x);
                }
                _ => {}
            }
        }
        // a − b is −(b − a), if that is known already.
        if let Some(known) = self.find(&Op::Sub(b, a)) {
            return self.intern(Op::Neg(known));
        }
        self.intern(Op::Sub(a, b))
    }

    pub fn mul(&mut self, a: Node, b: Node) -> Node {
        // Constants and parameters in front.
        let (a, b) = if (self.class(a).min(Class::Position), a) <= (self.class(b).min(Class::Position), b) {
            (a, b)
        } else {
            (b, a)
        };
        if let Some(x) = self.value(a) {
            if x == 1.0 {
                return b;
            }
            if let Some(y) = self.value(b) {
                return self.folded_product(x, y);
            }
            if x == 0.0 {
                return a;
            }
            // Coefficients are positive, so that k·x and −k·x meet.
            if x < 0.0 {
                let positive = self.constant(-x);
                let product = self.mul(positive, b);
                return self.neg(product);
            }
        }
        match (self.op(a), self.op(b)) {
            (Op::Neg(x), Op::Neg(y)) => return self.mul(x, y),
            (Op::Neg(x), _) => {
                let product = self.mul(x, b);
                return self.neg(product);
            }
            (_, Op::Neg(y)) => {
                let product = self.mul(a, y);
                return self.neg(product);
            }
            // k·(l·x) = (k·l)·x for coefficients k, l. Three parameters stay as they are: sorted by age, they would
            // be regrouped for ever.
            (_, Op::Mul(l, x))
                if self.class(a) <= Class::Parameter
                    && self.class(l) <= Class::Parameter
                    && (self.class(x) > Class::Parameter
                        || (self.value(a).is_some() && self.value(l).is_some())) =>
            {
                let coefficient = self.mul(a, l);
                return self.mul(coefficient, x);
            }
            // x·(1/x) = 1
            (Op::Unary(Unary::Reciprocal, x), _) if x == b => return self.constant(1.0),
            (_, Op::Unary(Unary::Reciprocal, x)) if x == a => return self.constant(1.0),
            _ => {}
        }
        self.intern(Op::Mul(a, b))
    }

    pub fn div(&mut self, a: Node, b: Node) -> Node {
        if let (Some(x), Some(y)) = (self.value(a), self.value(b)) {
            return self.folded_quotient(x, y);
        }
        if self.is_zero(a) || self.is_one(b) {
            return a;
        }
        if a == b {
            return self.constant(1.0);
        }
        if let Some(y) = self.value(b) {
            let reciprocal = self.folded_quotient(1.0, y);
            return self.mul(reciprocal, a);
        }
        match (self.op(a), self.op(b)) {
            (Op::Neg(x), Op::Neg(y)) => return self.div(x, y),
            (Op::Neg(x), _) => {
                let quotient = self.div(x, b);
                return self.neg(quotient);
            }
            (_, Op::Neg(y)) => {
                let quotient = self.div(a, y);
                return self.neg(quotient);
            }
            _ => {}
        }
        if self.is_one(a) || self.class(b) <= Class::Parameter {
            let reciprocal = self.unary(Unary::Reciprocal, b);
            return self.mul(a, reciprocal);
        }
        self.intern(Op::Div(a, b))
    }

    pub fn unary(&mut self, function: Unary, a: Node) -> Node {
        if let Some(x) = self.value(a) {
            return self.folded_unary(function, x);
        }
        match (function, self.op(a)) {
            (Unary::Reciprocal, Op::Unary(Unary::Reciprocal, x)) => return x,
            (Unary::Cos | Unary::Abs, Op::Neg(x)) => return self.unary(function, x),
            (Unary::Sin | Unary::Tan | Unary::Asin | Unary::Sign | Unary::Reciprocal, Op::Neg(x)) => {
                let value = self.unary(function, x);
                return self.neg(value);
            }
            (Unary::Abs, Op::Unary(Unary::Abs | Unary::Sqrt, _)) => return a,
            _ => {}
        }
        self.intern(Op::Unary(function, a))
    }

    pub fn min(&mut self, a: Node, b: Node) -> Node {
        self.symmetric(a, b, super::min, Op::Min)
    }
    pub fn max(&mut self, a: Node, b: Node) -> Node {
        self.symmetric(a, b, super::max, Op::Max)
    }
    pub fn atan2(&mut self, y: Node, x: Node) -> Node {
        match (self.value(y), self.value(x)) {
            (Some(y), Some(x)) => self.constant(libm::atan2(y, x)),
            _ => self.intern(Op::Atan2(y, x)),
        }
    }
    pub fn compare(&mut self, comparison: Compare, a: Node, b: Node) -> Node {
        self.intern(Op::Compare(comparison, a, b))
    }
    pub fn and(&mut self, a: Node, b: Node) -> Node {
        self.intern(Op::And(a, b))
    }
    pub fn or(&mut self, a: Node, b: Node) -> Node {
        self.intern(Op::Or(a, b))
    }
    pub fn not(&mut self, a: Node) -> Node {
        self.intern(Op::Not(a))
    }
    pub fn select(&mut self, mask: Node, then: Node, otherwise: Node) -> Node {
        if then == otherwise {
            return then;
        }
        // What is nothing elsewhere, and nothing elsewhere again: one choice by both masks, which many have in common.
        let outer = self.taken_if(mask, then, otherwise);
        let inner = outer.and_then(|(_, choice)| match self.op(choice) {
            Op::Select(mask, then, otherwise) => self.taken_if(mask, then, otherwise),
            _ => None,
        });
        match (outer, inner) {
            (Some(((mask, true), _)), Some(((inner, true), x))) => {
                let both = self.and(mask, inner);
                let zero = self.constant(0.0);
                self.intern(Op::Select(both, x, zero))
            }
            (Some(((mask, false), _)), Some(((inner, false), x))) => {
                let one = self.or(mask, inner);
                let zero = self.constant(0.0);
                self.intern(Op::Select(one, zero, x))
            }
            _ => self.intern(Op::Select(mask, then, otherwise)),
        }
    }

    /// Of a choice with nothing on one side: the mask and whether it has to be true for the other side, and this.
    fn taken_if(&self, mask: Node, then: Node, otherwise: Node) -> Option<((Node, bool), Node)> {
        if self.is_zero(otherwise) {
            return Some(((mask, true), then));
        }
        self.is_zero(then).then_some(((mask, false), otherwise))
    }

    /// x − (m: x, else 0) = (m: 0, else x), and the other way round; where `is_sum`, x + (m: −x, else 0).
    fn unless_taken(&mut self, x: Node, choice: Node, is_sum: bool) -> Option<Node> {
        let Op::Select(mask, then, otherwise) = self.op(choice) else { return None };
        let is_own = |it: Node| if is_sum { self.op(it) == Op::Neg(x) } else { it == x };
        match (then, otherwise) {
            (own, zero) if is_own(own) && self.is_zero(zero) => Some(self.select(mask, zero, x)),
            (zero, own) if is_own(own) && self.is_zero(zero) => Some(self.select(mask, x, zero)),
            _ => None,
        }
    }

    /// The number of a table on this graph.
    pub fn enter(&mut self, table: &Arc<Table>) -> u16 {
        let known = self.tables.iter().position(|known| Arc::ptr_eq(known, table) || known == table);
        let number = known.unwrap_or_else(|| {
            self.tables.push(table.clone());
            self.tables.len() - 1
        });
        u16::try_from(number).expect("there are fewer tables than that")
    }

    /// The row of a table that x is in.
    pub fn cell(&mut self, table: u16, x: Node) -> Node {
        match self.value(x) {
            Some(x) => self.constant(self.table(table).cell(x)),
            None => self.intern(Op::Cell(table, x)),
        }
    }

    /// A derivative of a cubic piece; what vanishes in all of them is zero.
    pub fn piece(&mut self, table: u16, orders: Orders, cell: Node, x: Node) -> Node {
        if self.table(table).vanishes(orders) {
            return self.constant(0.0);
        }
        match (self.value(cell), self.value(x)) {
            (Some(cell), Some(x)) => self.folded_piece(table, orders, cell, x),
            _ => self.intern(Op::Piece(table, orders, cell, x)),
        }
    }

    /// A derivative of a patch.
    pub fn patch(&mut self, table: u16, orders: Orders, cell: Node, x: Node, y: Node) -> Node {
        if self.table(table).vanishes(orders) {
            return self.constant(0.0);
        }
        match [cell, x, y].map(|node| self.value(node)) {
            [Some(cell), Some(x), Some(y)] => self.folded_patch(table, orders, cell, [x, y]),
            _ => self.intern(Op::Patch(table, orders, cell, x, y)),
        }
    }

    /// x to an integer power by repeated squaring.
    pub fn power(&mut self, x: Node, exponent: i32) -> Node {
        let mut result = self.constant(1.0);
        let mut square = x;
        let mut rest = exponent.unsigned_abs();
        while rest > 0 {
            if rest & 1 == 1 {
                result = self.mul(result, square);
            }
            rest >>= 1;
            if rest > 0 {
                square = self.mul(square, square);
            }
        }
        if exponent < 0 { self.unary(Unary::Reciprocal, result) } else { result }
    }

    /// Σ terms, left to right.
    pub fn sum(&mut self, terms: impl IntoIterator<Item = Node>) -> Node {
        let zero = self.constant(0.0);
        terms.into_iter().fold(zero, |sum, term| self.add(sum, term))
    }

    /// a·x ± b·x = (a ± b)·x for coefficients a, b that change more seldom than x.
    fn collect_terms(&mut self, a: Node, b: Node, subtract: bool) -> Option<Node> {
        let (k, x) = self.split(a);
        let (l, y) = self.split(b);
        if x != y || (k.is_none() && l.is_none()) {
            return None;
        }
        let one = self.constant(1.0);
        let (k, l) = (k.unwrap_or(one), l.unwrap_or(one));
        let coefficient = if subtract { self.sub(k, l) } else { self.add(k, l) };
        Some(self.mul(coefficient, x))
    }

    /// The node as (coefficient, rest), coefficient of class Parameter at most.
    fn split(&self, a: Node) -> (Option<Node>, Node) {
        match self.op(a) {
            Op::Mul(k, x) if self.class(k) <= Class::Parameter => (Some(k), x),
            _ => (None, a),
        }
    }

    /// The constant k, x and y of k·x and k·y, whichever of them are negative.
    pub(super) fn common_coefficient(&mut self, a: Node, b: Node) -> Option<(Node, [Node; 2])> {
        let scaled = |node: Node| match self.op(node) {
            Op::Neg(positive) => (true, self.split(positive)),
            _ => (false, self.split(node)),
        };
        let ((a_minus, (k, x)), (b_minus, (l, y))) = (scaled(a), scaled(b));
        let k = k.filter(|k| l == Some(*k) && self.value(*k).is_some())?;
        let signed = |graph: &mut Self, minus: bool, part: Node| if minus { graph.neg(part) } else { part };
        Some((k, [signed(self, a_minus, x), signed(self, b_minus, y)]))
    }

    /// p + (r + x) = (p + r) + x where p and r change more seldom than x.
    fn join_seldom(&mut self, a: Node, b: Node) -> Option<Node> {
        for (p, sum) in [(a, b), (b, a)] {
            if self.class(p) > Class::Parameter || self.class(sum) <= Class::Parameter {
                continue;
            }
            match self.op(sum) {
                Op::Add(r, x) if self.class(r) <= Class::Parameter => {
                    let seldom = self.add(p, r);
                    return Some(self.add(seldom, x));
                }
                Op::Sub(r, x) if self.class(r) <= Class::Parameter => {
                    let seldom = self.add(p, r);
                    return Some(self.sub(seldom, x));
                }
                Op::Sub(x, r) if self.class(r) <= Class::Parameter => {
                    let seldom = self.sub(p, r);
                    return Some(self.add(seldom, x));
                }
                _ => {}
            }
        }
        None
    }

    fn symmetric(&mut self, a: Node, b: Node, value: fn(f64, f64) -> f64, op: fn(Node, Node) -> Op) -> Node {
        if let (Some(x), Some(y)) = (self.value(a), self.value(b)) {
            return self.constant(value(x, y));
        }
        if a == b {
            return a;
        }
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        self.intern(op(a, b))
    }

    fn find(&self, op: &Op) -> Option<Node> {
        let is_same = |number: u32| self.ops[number as usize] == *op;
        self.known.get(FastHash::default().hash_one(op), is_same).map(Node)
    }

    fn intern(&mut self, op: Op) -> Node {
        let hash = FastHash::default().hash_one(op);
        if let Some(number) = self.known.get(hash, |number| self.ops[number as usize] == op) {
            return Node(number);
        }
        let class = match op {
            Op::Symbol(symbol) => self.symbols[symbol as usize].1,
            _ => op.operands().map(|node| self.class(node)).max().unwrap_or(Class::Constant),
        };
        self.ops.push(op);
        self.classes.push(class);
        Node(self.known.add(hash))
    }
}
