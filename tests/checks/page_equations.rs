//! The equations of every page are true: each line is read as a person would and computed at a random state, and compared with the
//! graph. What a line computes is known up to the six digits of its numbers, of each term.

use crate::registry::{Model, Random, compiled};
use linkwright_compiler::Compiled;
use linkwright_compiler::model::Table;
use linkwright_compiler::page;
use linkwright_compiler::symbolic::{Node, Op, Orders, evaluate};
use std::collections::BTreeMap;

crate::registry::for_each!(are_true);

/// Relative to the sum of the magnitudes of what is added.
const TOLERANCE: f64 = 3e-5;

fn are_true<M: Model>() {
    let compiled = compiled::<M>(None);
    let page = page(&compiled);
    let mut random = Random::new(77);
    let state = State::random(&compiled, &mut random);
    let mut checked = 0;
    for (section, entries) in sections(&compiled) {
        let Some(listing) = page.split(&format!("\n{section}:\n\n```text\n")).nth(1) else { continue };
        let listing = listing.split("\n```").next().unwrap_or_default();
        checked += check(section, listing, &entries, &state);
    }
    assert!(checked >= compiled.complete.equations.outputs.len().min(1), "something was read");
}

/// The listings of the page, and the nodes they are about.
fn sections(compiled: &Compiled) -> Vec<(&'static str, BTreeMap<String, Node>)> {
    let e = &compiled.complete.equations;
    let v = e.layout.velocity_names(&compiled.mechanism);
    let row = |index: usize| format!("{}.{}", e.rows[index].of, e.rows[index].form.name);
    let of_rows = |nodes: Vec<Node>| (0..e.rows.len()).map(row).zip(nodes).collect::<BTreeMap<_, _>>();
    let jacobian = e.rows.iter().enumerate().flat_map(|(index, own)| {
        let columns = own.jet.columns.iter();
        columns.map(|(column, node)| (format!("{}, {}", row(index), v[*column]), *node)).collect::<Vec<_>>()
    });
    let outputs = compiled.mechanism.outputs.iter().map(|output| output.name.text.clone());
    let states = compiled.mechanism.states.iter().map(|state| state.name.text.clone());
    vec![
        ("Φ, m or rad", of_rows(e.rows.iter().map(|row| row.jet.value).collect())),
        ("D", jacobian.collect()),
        (
            "M, lower triangle",
            e.mass.iter().map(|((i, j), node)| (format!("{}, {}", v[*i], v[*j]), *node)).collect(),
        ),
        ("Q", v.iter().cloned().zip(e.forces.iter().copied()).collect()),
        ("ν", of_rows(e.nu.clone())),
        ("γ", of_rows(e.gamma.clone())),
        (
            "Kinetic and potential energy, J",
            [("T".to_string(), e.kinetic_energy), ("V".to_string(), e.potential_energy)].into(),
        ),
        ("Rates of the states", states.zip(e.internal_rates.iter().copied()).collect()),
        ("Outputs", outputs.zip(e.outputs.iter().copied()).collect()),
    ]
}

/// Values of the nodes, and of what the text names; of the helpers of a listing with the magnitudes that made them.
struct State {
    nodes: Vec<f64>,
    names: std::cell::RefCell<BTreeMap<String, Value>>,
    /// Of rotations, by what stands in their cosines.
    angles: BTreeMap<String, f64>,
    tables: Vec<Table>,
}

impl State {
    fn random(compiled: &Compiled, random: &mut Random) -> State {
        let (mechanism, e) = (&compiled.mechanism, &compiled.complete.equations);
        let point = random.point(compiled);
        let mut symbols = vec![0.0; e.graph.read().symbol_count()];
        let mut names = BTreeMap::new();
        let mut set = |nodes: &[Node], values: &[f64], texts: Vec<String>| {
            for ((node, value), text) in nodes.iter().zip(values).zip(texts) {
                if let Op::Symbol(symbol) = e.graph.read().op(*node) {
                    symbols[symbol as usize] = *value;
                    names.insert(text, (*value, value.abs()));
                }
            }
        };
        let known = &e.symbols;
        let own = |node: &Node| match e.graph.read().op(*node) {
            Op::Symbol(symbol) => e.graph.read().symbol_name(symbol).to_string(),
            _ => String::new(),
        };
        let (q, v) = (e.layout.position_names(mechanism), e.layout.velocity_names(mechanism));
        let parameters = mechanism.parameters.iter().map(|it| it.name.text.clone()).collect();
        let inputs = mechanism.inputs.iter().map(|it| it.name.text.clone()).collect();
        let rows = e.rows.iter().map(|row| format!("λ({}.{})", row.of, row.form.name)).collect();
        set(&known.parameters, &point.parameters, parameters);
        set(&known.phases, &point.phases, known.phases.iter().map(own).collect());
        set(&[known.time], &[point.time], vec!["time".to_string()]);
        set(&known.q, &point.q, q.clone());
        set(&known.acceleration, &point.acceleration, v.iter().map(|name| format!("v̇({name})")).collect());
        set(&known.v, &point.v, v);
        let states = mechanism.states.iter().map(|it| it.name.text.clone()).collect();
        set(&known.internal, &point.internal, states);
        set(&known.inputs, &point.inputs, inputs);
        let gates = mechanism.gates().map(|(load, which)| {
            let word = if mechanism.is_rigid() { "force" } else { "gate" };
            let number = if which == 0 { String::new() } else { format!(", {}", which + 1) };
            format!("{word}({}{number})", mechanism.loads[load.0].name.text)
        });
        let behind = mechanism.held_names().into_iter().skip(mechanism.gates().count());
        let held = gates.chain(behind.map(|name| name.text.clone()));
        set(&known.gates, &point.gates, held.collect());
        set(&known.lambda, &point.lambda, rows);
        let stem = |at: usize| q[at].rsplit_once('.').expect("a part of a name").0.to_string();
        let pairs = (0..e.layout.rotations.len()).map(|r| e.layout.pair(r));
        let angles = pairs.map(|at| (stem(at), point.q[at + 1].atan2(point.q[at]))).collect();
        for a in 0..e.layout.angles.len() {
            let at = e.layout.turns(a);
            let angle = std::f64::consts::TAU * point.q[at] + point.q[at + 1];
            names.insert(format!("{}.angle", stem(at)), (angle, angle.abs()));
        }
        let tables = mechanism.tables.clone();
        State { nodes: evaluate(&e.graph.read(), &symbols), names: names.into(), angles, tables }
    }
}

/// Every line of a listing; gives how many were compared.
fn check(section: &str, listing: &str, entries: &BTreeMap<String, Node>, state: &State) -> usize {
    let mut lines: Vec<String> = Vec::new();
    for line in listing.lines().filter(|line| !line.starts_with('…')) {
        let is_definition =
            line.strip_prefix("  h").is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
        match lines.last_mut() {
            Some(last) if line.starts_with(' ') && !is_definition => {
                last.push(' ');
                last.push_str(line.trim_start());
            }
            _ => lines.push(line.to_string()),
        }
    }
    let mut compared = 0;
    for line in lines {
        let (label, text) = match line.strip_suffix(" = 0").and_then(|row| row.split_once(": ")) {
            Some(row) => row,
            None => line.split_once(" = ").unwrap_or_else(|| panic!("{section}: {line}")),
        };
        let mut reader = Reader { text: text.trim(), state, whole: &line };
        let (mut value, mut magnitude) = reader.sum(false);
        if label.starts_with("  h") && !reader.text.is_empty() {
            // A condition with a name.
            reader.text = text.trim();
            (value, magnitude) = (f64::from(u8::from(reader.condition())), 0.0);
        }
        assert!(reader.text.is_empty(), "{section}: {line}\nstops at {}", reader.text);
        match entries.get(label.trim()) {
            Some(node) => {
                let wanted = state.nodes[node.index()];
                let near = (value - wanted).abs() <= TOLERANCE * magnitude;
                assert!(near || !wanted.is_finite(), "{section}: {line}\n{value}, not {wanted}");
                compared += 1;
            }
            None => {
                assert!(label.starts_with("  h"), "{section}: {label} is no entry");
                state.names.borrow_mut().insert(label.trim().to_string(), (value, magnitude));
            }
        }
    }
    compared
}

/// Reads an expression; of each part its value and the sum of the magnitudes that made it.
struct Reader<'a> {
    text: &'a str,
    state: &'a State,
    whole: &'a str,
}

type Value = (f64, f64);

impl<'a> Reader<'a> {
    fn skip(&mut self, word: &str) -> bool {
        let rest = self.text.strip_prefix(word);
        self.text = rest.unwrap_or(self.text);
        rest.is_some()
    }

    fn expect(&mut self, word: &str) {
        assert!(self.skip(word), "{}\n{word} is missing before {}", self.whole, self.text);
    }

    /// With angles, names are those of rotations.
    fn sum(&mut self, angles: bool) -> Value {
        let mut sum = if self.skip("−") { negative(self.product(angles)) } else { self.product(angles) };
        loop {
            let next = if self.skip(" + ") {
                self.product(angles)
            } else if self.skip(" − ") {
                negative(self.product(angles))
            } else {
                return sum;
            };
            sum = (sum.0 + next.0, sum.1 + next.1);
        }
    }

    fn product(&mut self, angles: bool) -> Value {
        let mut product = self.power(angles);
        loop {
            // `2 crank` is twice an angle.
            let is_weight = angles
                && self.text.starts_with(' ')
                && !(self.text.starts_with(" +") || self.text.starts_with(" −"));
            if self.skip("·") || (is_weight && self.skip(" ")) {
                let next = self.power(angles);
                product = (product.0 * next.0, product.1 * next.1);
            } else if self.skip("/") {
                let next = self.power(angles);
                product = (product.0 / next.0, product.1 / next.0.abs() * (next.1 / next.0.abs()));
            } else {
                return product;
            }
        }
    }

    fn power(&mut self, angles: bool) -> Value {
        let base = self.atom(angles);
        let exponent = self.exponent();
        (base.0.powi(exponent), base.1.powi(exponent))
    }

    fn exponent(&mut self) -> i32 {
        if self.skip("²") {
            2
        } else if self.skip("³") {
            3
        } else if self.skip("^") {
            self.number() as i32
        } else {
            1
        }
    }

    fn number(&mut self) -> f64 {
        let is_part = |(at, c): &(usize, char)| {
            let after_e = self.text[..*at].ends_with('e');
            c.is_ascii_digit() || *c == '.' || *c == 'e' || (*c == '−' && after_e)
        };
        let end: usize = self.text.char_indices().take_while(is_part).map(|(_, c)| c.len_utf8()).sum();
        let (number, rest) = self.text.split_at(end);
        self.text = rest;
        number.replace('−', "-").parse().unwrap_or_else(|_| panic!("{}\n{number} is no number", self.whole))
    }

    fn atom(&mut self, angles: bool) -> Value {
        if self.text.starts_with(|c: char| c.is_ascii_digit()) {
            let number = self.number();
            return (number, number.abs());
        }
        if self.skip("(") {
            let value = self.sum(angles);
            self.expect(")");
            return value;
        }
        if self.skip("√(") {
            let value = self.sum(false);
            self.expect(")");
            return (value.0.sqrt(), value.1 / value.0.sqrt());
        }
        let is_part = |c: &char| c.is_alphanumeric() && !"²³".contains(*c) || "_.[]′″‴∂".contains(*c);
        let end: usize = self.text.chars().take_while(is_part).map(char::len_utf8).sum();
        let (name, rest) = self.text.split_at(end);
        self.text = rest;
        if ["λ", "gate", "force"].contains(&name) && self.text.starts_with('(') {
            let (of, rest) = self.text.split_once(')').expect("a row or a contact");
            self.text = rest;
            return self.named(&format!("{name}{of})"));
        }
        // The dot is a character of its own.
        if name == "v" && self.skip("\u{307}") {
            let (velocity, rest) = self.text.split_once(')').expect("a velocity");
            self.text = rest;
            return self.named(&format!("v\u{307}{velocity})"));
        }
        let function_power = if ["cos", "sin"].contains(&name) { self.exponent() } else { 1 };
        if !name.is_empty() && self.skip("(") {
            let value = self.call(name);
            return (value.0.powi(function_power), value.1.powi(function_power));
        }
        match self.state.angles.get(name) {
            Some(angle) if angles => (*angle, 1.0),
            _ => self.named(name),
        }
    }

    fn named(&self, name: &str) -> Value {
        let value = self.state.names.borrow().get(name).copied();
        value.unwrap_or_else(|| panic!("{}\n{name} is not known", self.whole))
    }

    fn call(&mut self, name: &str) -> Value {
        if name == "if" {
            let holds = self.condition();
            self.expect(", ");
            let then = self.sum(false);
            self.expect(", ");
            let otherwise = self.sum(false);
            self.expect(")");
            return if holds { then } else { otherwise };
        }
        let mut arguments = vec![self.sum(["cos", "sin", "angle"].contains(&name))];
        while self.skip(", ") {
            arguments.push(self.sum(false));
        }
        self.expect(")");
        let x = arguments[0].0;
        let spread = arguments.iter().map(|(_, magnitude)| magnitude).sum::<f64>();
        if let Some(value) = self.table(name, &arguments) {
            return value;
        }
        let value = match (name, &arguments[..]) {
            ("cos", _) => x.cos(),
            ("sin", _) => x.sin(),
            ("tan", _) => x.tan(),
            ("asin", _) => x.asin(),
            ("acos", _) => x.acos(),
            ("exp", _) => x.exp(),
            ("ln", _) => x.ln(),
            ("log10", _) => x.log10(),
            ("sinh", _) => x.sinh(),
            ("cosh", _) => x.cosh(),
            ("tanh", _) => x.tanh(),
            ("floor", _) => x.floor(),
            ("abs", _) => x.abs(),
            ("sign", _) => x.signum(),
            ("angle", _) => x.sin().atan2(x.cos()),
            ("min", [_, y]) => x.min(y.0),
            ("max", [_, y]) => x.max(y.0),
            ("atan2", [_, y]) => x.atan2(y.0),
            _ => panic!("{}\n{name} of {} is not known", self.whole, arguments.len()),
        };
        (value, value.abs() + spread)
    }

    /// `lift″(x)`, `∂₁grip(x, y)`; the place is known up to its digits, too.
    fn table(&self, name: &str, arguments: &[Value]) -> Option<Value> {
        let stem = name.trim_end_matches(['′', '″', '‴']).trim_start_matches(['∂', '₁', '₂']);
        let table = self.state.tables.iter().find(|table| table.name.text == stem)?;
        let primes = ["", "′", "″", "‴"]
            .iter()
            .position(|primes| name.ends_with(primes) && *primes == &name[stem.len()..]);
        let by = |which: &str| name.matches(which).count() as u8;
        let (first, second) = (primes.unwrap_or(0) as u8 + by("₁"), by("₂"));
        let at: Vec<f64> = arguments.iter().map(|(value, _)| *value).collect();
        let derivative = |more: [u8; 2]| table.curve.at(Orders::new(first + more[0], second + more[1]), &at);
        let mut magnitude = derivative([0, 0]).abs();
        for (more, (_, spread)) in [[1, 0], [0, 1]].into_iter().zip(arguments) {
            magnitude += derivative(more).abs() * spread;
        }
        Some((derivative([0, 0]), magnitude))
    }

    fn condition(&mut self) -> bool {
        if self.skip("not ") {
            return !self.condition();
        }
        // A parenthesis may also begin a sum.
        let begin = self.text;
        if self.skip("(") && (begin.contains(" and ") || begin.contains(" or ")) {
            let first = self.condition();
            let both = self.skip(" and ");
            if !both {
                self.expect(" or ");
            }
            let second = self.condition();
            self.expect(")");
            return if both { first && second } else { first || second };
        }
        self.text = begin;
        let left = self.sum(false).0;
        if self.skip(" < ") {
            return left < self.sum(false).0;
        }
        if self.skip(" ≤ ") {
            return left <= self.sum(false).0;
        }
        if self.skip(" = ") {
            return left == self.sum(false).0;
        }
        // One with a name.
        left != 0.0
    }
}

fn negative((value, magnitude): Value) -> Value {
    (-value, magnitude)
}
