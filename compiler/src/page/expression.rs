//! Expressions of the graph as text: sums and products in one line, angles under their cosines and sines, and what is long
//! and occurs again under a name of its own.

use super::terms::{Angle, Factor, Term, in_order, merged};
use super::text::decimal;
use crate::equations::Equations;
use crate::model::Mechanism;
use crate::symbolic::{BICUBIC, Compare, Graph, Node, Op, Orders, PATCHES, Table, Unary};
use std::collections::{BTreeMap, HashMap};

/// Sums of more terms are not searched for cosines of sums.
const SEARCHED: usize = 60;
/// What occurs again gets a name from this size on.
const NAMED: usize = 9;
/// What is larger gets one anyway, so that no line is endless.
const ENDLESS: usize = 100;

pub struct Writer<'a> {
    graph: &'a Graph,
    symbols: HashMap<Node, String>,
    /// Rotation, and whether it is the sine.
    turned: HashMap<Node, (usize, bool)>,
    /// Multi-turn angle, and whether it is the remainder.
    counted: HashMap<Node, (usize, bool)>,
    angles: Vec<String>,
    counted_angles: Vec<String>,
    terms: HashMap<Node, Vec<Term>>,
    /// Nodes that are written by name; no name yet where they have not been met.
    named: HashMap<Node, Option<String>>,
    count: usize,
}

impl<'a> Writer<'a> {
    pub fn new(mechanism: &Mechanism, equations: &Equations, graph: &'a Graph) -> Self {
        let layout = &equations.layout;
        let (q, v) = (layout.position_names(mechanism), layout.velocity_names(mechanism));
        let symbols = &equations.symbols;
        let known = symbols.q.iter().zip(q.iter()).chain(symbols.v.iter().zip(v.iter()));
        let stem = |at: usize| q[at].rsplit_once('.').map_or(q[at].clone(), |(stem, _)| stem.to_string());
        let parameters = mechanism.parameters.iter().map(|parameter| parameter.name.text.clone());
        let inputs = mechanism.inputs.iter().map(|input| input.name.text.clone());
        let settings = symbols.parameters.iter().copied().zip(parameters);
        let states = mechanism.states.iter().map(|state| state.name.text.clone());
        let settings = settings.chain(symbols.inputs.iter().copied().zip(inputs));
        let settings = settings.chain(symbols.internal.iter().copied().zip(states));
        // A contact of several gaps has a gate for each; of a rigid one it is the force.
        let word = if mechanism.is_rigid() { "force" } else { "gate" };
        let contacts = mechanism.gates().map(|(load, which)| {
            let name = &mechanism.loads[load.0].name.text;
            if which == 0 { format!("{word}({name})") } else { format!("{word}({name}, {})", which + 1) }
        });
        let behind = mechanism.held_names().into_iter().skip(mechanism.gates().count());
        let held = contacts.chain(behind.map(|name| name.text.clone()));
        let settings = settings.chain(symbols.gates.iter().copied().zip(held));
        let accelerations =
            symbols.acceleration.iter().copied().zip(v.iter().map(|name| format!("v̇({name})")));
        let multipliers = symbols.lambda.iter().zip(&equations.rows);
        let multipliers = multipliers.map(|(node, row)| (*node, format!("λ({}.{})", row.of, row.form.name)));
        let mut writer = Writer {
            graph,
            symbols: known
                .map(|(node, name)| (*node, name.clone()))
                .chain(settings)
                .chain(multipliers)
                .chain(accelerations)
                .collect(),
            turned: HashMap::new(),
            counted: HashMap::new(),
            angles: (0..layout.rotations.len()).map(|r| stem(layout.pair(r))).collect(),
            counted_angles: (0..layout.angles.len())
                .map(|a| format!("{}.angle", stem(layout.turns(a))))
                .collect(),
            terms: HashMap::new(),
            named: HashMap::new(),
            count: 0,
        };
        for r in 0..layout.rotations.len() {
            let at = layout.pair(r);
            writer.turned.insert(symbols.q[at], (r, false));
            writer.turned.insert(symbols.q[at + 1], (r, true));
        }
        for a in 0..layout.angles.len() {
            let at = layout.turns(a);
            writer.counted.insert(symbols.q[at], (a, false));
            writer.counted.insert(symbols.q[at + 1], (a, true));
        }
        writer
    }

    /// Decides what of these expressions is written by name.
    pub fn share(&mut self, roots: &[Node]) {
        // A sign before a whole expression is no user of it.
        let roots: Vec<Node> = roots.iter().map(|root| self.without_sign(*root)).collect();
        let mut uses: HashMap<Node, usize> = HashMap::new();
        let mut waiting: Vec<Node> = Vec::new();
        for root in &roots {
            meet(&mut uses, &mut waiting, *root);
        }
        let mut met = Vec::new();
        while let Some(node) = waiting.pop() {
            met.push(node);
            if !self.is_short(node) && !self.named.contains_key(&node) {
                self.graph.op(node).operands().for_each(|operand| meet(&mut uses, &mut waiting, operand));
            }
        }
        met.sort_unstable();
        // Operands are older than their users.
        let mut sizes: HashMap<Node, usize> = HashMap::new();
        for node in met {
            let operands = self.graph.op(node).operands();
            let size = if self.is_short(node) || self.named.contains_key(&node) {
                1
            } else {
                1 + operands.map(|operand| sizes.get(&operand).copied().unwrap_or(1)).sum::<usize>()
            };
            let is_again = uses[&node] > 1 && size >= NAMED;
            if is_again || (size >= ENDLESS && !roots.contains(&node)) {
                self.named.insert(node, None);
                sizes.insert(node, 1);
            } else {
                sizes.insert(node, size);
            }
        }
        self.terms.clear();
    }

    fn without_sign(&self, node: Node) -> Node {
        match self.graph.op(node) {
            Op::Neg(a) => a,
            _ => node,
        }
    }

    /// A cosine or sine of some angle, or a leaf.
    fn is_short(&mut self, node: Node) -> bool {
        match self.graph.op(node) {
            Op::Constant(_) | Op::Symbol(_) => true,
            Op::Add(..) | Op::Sub(..) => {
                let terms = self.sum(node);
                matches!(&terms[..], [only] if only.factors.len() == 1)
            }
            _ => false,
        }
    }

    /// An expression, after the definitions that it needs and that have not been given yet.
    pub fn lines(&mut self, root: Node) -> (Vec<(String, String)>, String) {
        let mut definitions = Vec::new();
        for node in self.needed(root) {
            self.count += 1;
            let name = format!("h{}", self.count);
            let text = self.written(node);
            self.named.insert(node, Some(name.clone()));
            self.terms.clear();
            definitions.push((name, text));
        }
        let text = match self.named.get(&root) {
            Some(Some(name)) => name.clone(),
            _ => self.written(root),
        };
        (definitions, text)
    }

    /// How many definitions an expression still needs.
    pub fn wanting(&self, root: Node) -> usize {
        self.needed(root).len()
    }

    /// Nodes to be named before an expression can be written, in order.
    fn needed(&self, root: Node) -> Vec<Node> {
        let is_given = |node: Node| matches!(self.named.get(&node), Some(Some(_)));
        let reached = self.graph.reachable_until([root], is_given);
        reached.into_iter().filter(|node| matches!(self.named.get(node), Some(None))).collect()
    }

    fn written(&mut self, node: Node) -> String {
        // Its own name would say nothing.
        let own = self.named.remove(&node);
        let terms = self.sum(node);
        let text = self.sum_text(&terms);
        if let Some(own) = own {
            self.named.insert(node, own);
        }
        text
    }

    fn sum(&mut self, node: Node) -> Vec<Term> {
        if let Some(known) = self.terms.get(&node) {
            return known.clone();
        }
        let terms = match self.graph.op(node) {
            _ if self.named.contains_key(&node) => vec![self.atom(node)],
            Op::Add(a, b) => self.joined(a, b, 1.0),
            Op::Sub(a, b) => self.joined(a, b, -1.0),
            Op::Neg(a) => self.sum(a).into_iter().map(|term| term.times(-1.0)).collect(),
            _ => vec![self.product(node)],
        };
        self.terms.insert(node, terms.clone());
        terms
    }

    fn joined(&mut self, a: Node, b: Node, sign: f64) -> Vec<Term> {
        let mut terms = self.sum(a);
        let others = self.sum(b);
        terms.extend(others.into_iter().map(|term| term.times(sign)));
        if terms.len() <= SEARCHED { merged(terms) } else { terms }
    }

    fn atom(&self, node: Node) -> Term {
        let factor = match (self.turned.get(&node), self.counted.get(&node)) {
            (Some((rotation, is_sine)), _) => {
                Factor::Turned { is_sine: *is_sine, angle: vec![(*rotation, 1)] }
            }
            _ => Factor::Node(node),
        };
        let mut term = Term { coefficient: 1.0, factors: BTreeMap::from([(factor, 1)]) };
        // 2π · turns + remainder is the angle; the remainder stands for it, and the turns for nothing.
        if let Some((angle, is_remainder)) = self.counted.get(&node) {
            term.factors = BTreeMap::from([(Factor::Counted(*angle), 1)]);
            term.coefficient = if *is_remainder { 1.0 } else { 0.0 };
        }
        term
    }

    fn product(&mut self, node: Node) -> Term {
        if self.named.contains_key(&node) {
            return self.atom(node);
        }
        match self.graph.op(node) {
            Op::Constant(bits) => Term { coefficient: f64::from_bits(bits), factors: BTreeMap::new() },
            Op::Neg(a) => self.product(a).times(-1.0),
            Op::Mul(a, b) => {
                let (a, b) = (self.product(a), self.product(b));
                a.by(&b, 1)
            }
            Op::Div(a, b) => {
                let (a, b) = (self.product(a), self.product(b));
                a.by(&b, -1)
            }
            Op::Unary(Unary::Reciprocal, a) => {
                let one = Term { coefficient: 1.0, factors: BTreeMap::new() };
                one.by(&self.product(a), -1)
            }
            Op::Add(..) | Op::Sub(..) => match &self.sum(node)[..] {
                [only] => only.clone(),
                terms if terms.iter().all(|term| term.coefficient < 0.0) => {
                    Term { coefficient: -1.0, factors: BTreeMap::from([(Factor::Opposite(node), 1)]) }
                }
                _ => self.atom(node),
            },
            _ => self.atom(node),
        }
    }

    fn sum_text(&mut self, terms: &[Term]) -> String {
        let mut text = String::new();
        for term in in_order(terms) {
            let is_negative = term.coefficient < 0.0;
            match (text.is_empty(), is_negative) {
                (true, true) => text.push('−'),
                (true, false) => {}
                (false, true) => text.push_str(" − "),
                (false, false) => text.push_str(" + "),
            }
            text.push_str(&self.term_text(term));
        }
        if text.is_empty() { "0".to_string() } else { text }
    }

    /// Without its sign.
    fn term_text(&mut self, term: &Term) -> String {
        let size = term.coefficient.abs();
        let mut factors: Vec<(&Factor, i32)> =
            term.factors.iter().map(|(factor, power)| (factor, *power)).collect();
        // Numbers, then parameters, then what moves slowly.
        factors.sort_by_key(|(factor, _)| match factor {
            Factor::Node(node) | Factor::Opposite(node) => (self.graph.class(*node), 1),
            Factor::Turned { .. } => (crate::symbolic::Class::Position, 0),
            Factor::Counted(_) => (crate::symbolic::Class::Position, 2),
        });
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for (factor, power) in factors {
            let text = self.factor_text(factor, power.abs());
            if power > 0 { above.push(text) } else { below.push(text) }
        }
        if size != 1.0 || above.is_empty() {
            above.insert(0, decimal(size));
        }
        match below.len() {
            0 => above.join("·"),
            1 => format!("{}/{}", above.join("·"), below[0]),
            _ => format!("{}/({})", above.join("·"), below.join("·")),
        }
    }

    fn factor_text(&mut self, factor: &Factor, power: i32) -> String {
        let text = match factor {
            Factor::Node(node) => self.node_text(*node),
            Factor::Opposite(node) => {
                let terms: Vec<Term> = self.sum(*node).into_iter().map(|term| term.times(-1.0)).collect();
                format!("({})", self.sum_text(&terms))
            }
            Factor::Counted(angle) => self.counted_angles[*angle].clone(),
            Factor::Turned { is_sine, angle } => {
                let function = if *is_sine { "sin" } else { "cos" };
                return format!("{function}{}({})", raised(power), self.angle_text(angle));
            }
        };
        format!("{text}{}", raised(power))
    }

    fn angle_text(&self, angle: &[(usize, i32)]) -> String {
        let mut text = String::new();
        // What is added first.
        let positive = angle.iter().filter(|(_, weight)| *weight > 0);
        for (rotation, weight) in positive.chain(angle.iter().filter(|(_, weight)| *weight < 0)) {
            if !text.is_empty() {
                text.push_str(if *weight > 0 { " + " } else { " − " });
            } else if *weight < 0 {
                text.push('−');
            }
            if weight.abs() > 1 {
                text.push_str(&weight.abs().to_string());
                text.push(' ');
            }
            text.push_str(&self.angles[*rotation]);
        }
        text
    }

    /// atan2(sin a, cos a), in (−π, π].
    fn angle_of(&mut self, y: Node, x: Node) -> Option<String> {
        let (sine, cosine) = (self.sum(y), self.sum(x));
        let ([sine], [cosine]) = (&sine[..], &cosine[..]) else { return None };
        let turned = |term: &Term, is_sine: bool| match term.factors.first_key_value()? {
            (Factor::Turned { is_sine: own, angle }, 1) if *own == is_sine && term.factors.len() == 1 => {
                Some(angle.clone())
            }
            _ => None,
        };
        let angle = turned(sine, true).filter(|angle| Some(angle) == turned(cosine, false).as_ref())?;
        let sign = match (sine.coefficient, cosine.coefficient) {
            (1.0, 1.0) => 1,
            (-1.0, 1.0) => -1,
            _ => return None,
        };
        let angle: Angle = angle.iter().map(|(rotation, weight)| (*rotation, sign * weight)).collect();
        Some(format!("angle({})", self.angle_text(&angle)))
    }

    fn node_text(&mut self, node: Node) -> String {
        if let Some(name) = self.named.get(&node) {
            return name.clone().unwrap_or_else(|| "…".to_string());
        }
        if let Some(name) = self.symbols.get(&node) {
            return name.clone();
        }
        if let Op::Atan2(y, x) = self.graph.op(node)
            && let Some(angle) = self.angle_of(y, x)
        {
            return angle;
        }
        let graph = self.graph;
        let mut call = |name: &str, operands: &[Node]| {
            let operands: Vec<String> = operands.iter().map(|operand| self.whole(*operand)).collect();
            format!("{name}({})", operands.join(", "))
        };
        match graph.op(node) {
            Op::Symbol(symbol) => graph.symbol_name(symbol).to_string(),
            Op::Unary(Unary::Sqrt, a) => call("√", &[a]),
            Op::Unary(function, a) => call(function.name(), &[a]),
            Op::Min(a, b) => call("min", &[a, b]),
            Op::Max(a, b) => call("max", &[a, b]),
            Op::Atan2(a, b) => call("atan2", &[a, b]),
            Op::Select(mask, a, b) => call("if", &[mask, a, b]),
            Op::Cell(table, x) => call(&format!("row of {}", graph.table(table).name), &[x]),
            Op::Piece(table, orders, _, x) => call(&derivative(graph.table(table), orders), &[x]),
            Op::Patch(table, orders, _, x, y) => call(&derivative(graph.table(table), orders), &[x, y]),
            Op::And(a, b) => format!("({} and {})", self.whole(a), self.whole(b)),
            Op::Or(a, b) => format!("({} or {})", self.whole(a), self.whole(b)),
            Op::Not(a) => format!("not {}", self.whole(a)),
            Op::Compare(comparison, a, b) => {
                let sign = match comparison {
                    Compare::Less => "<",
                    Compare::LessEqual => "≤",
                    Compare::Equal => "=",
                };
                format!("{} {sign} {}", self.whole(a), self.whole(b))
            }
            _ => format!("({})", self.whole(node)),
        }
    }

    fn whole(&mut self, node: Node) -> String {
        let terms = self.sum(node);
        self.sum_text(&terms)
    }
}

/// `lift″`, of two arguments `∂₁∂₂grip`.
fn derivative(table: &Table, orders: Orders) -> String {
    let name = &table.name;
    match (table.width(), orders.first(), orders.second()) {
        (PATCHES | BICUBIC, first, second) => {
            let (first, second) = ("∂₁".repeat(first.into()), "∂₂".repeat(second.into()));
            format!("{first}{second}{name}")
        }
        (_, order, _) => format!("{name}{}", ["", "′", "″", "‴"][usize::from(order.min(3))]),
    }
}

fn meet(uses: &mut HashMap<Node, usize>, waiting: &mut Vec<Node>, node: Node) {
    let count = uses.entry(node).or_insert(0);
    *count += 1;
    if *count == 1 {
        waiting.push(node);
    }
}

fn raised(power: i32) -> String {
    match power {
        1 => String::new(),
        2 => "²".to_string(),
        3 => "³".to_string(),
        _ => format!("^{power}"),
    }
}
