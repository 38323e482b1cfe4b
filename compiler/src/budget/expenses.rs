//! Where the operations of a function go, in the words of mechanics: what a budget that is exceeded shows.
//!
//! Every instruction is counted once: under the purpose that needs it if that is only one, else as shared; what no purpose
//! of the equations needs belongs to their solution. A product that goes into a sum is counted where the sum is.

use crate::compiled::Compiled;
use crate::equations::Equations;
use crate::functions::{self, Function, outputs};
use crate::order::Strategy;
use crate::schedule::{count, nodes_of};
use crate::symbolic::{Class, Node};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// One line of the table.
pub struct Expense {
    pub purpose: String,
    pub operations: usize,
    /// Joints, loads or bodies that take most of it, with what only they need.
    pub most: Vec<(String, usize)>,
}

/// Something that operations are for.
struct Purpose {
    what: String,
    /// The joint or load; empty where they are not told apart.
    of: String,
    roots: Vec<Node>,
}

const SHARED_POSITIONS: &str = "positions and directions that several of these need";
const SHARED_RATES: &str = "rates and forces that several of these need";
const MASS: &str = "the mass matrix M";
const ROWS: &str = "the constraint rows D";
const GAMMA: &str = "γ of the constraint rows";
const STABILISED: &str = "γ of the constraint rows with Baumgarte's terms";
const INERTIA: &str = "gravity and gyroscopic forces";
const LOADS: &str = "loads";
const SUMS: &str = "sums of forces and of rows";
const FACTORISATION: &str = "the factorisation";
const SUBSTITUTION: &str = "the substitution";
const RECURSION: &str = "the recursion of articulated bodies";
const WATCH: &str = "the watch over the pivots";

/// The lines in the order of the calculation; those that are not named here stand between the shared and the rest.
const ORDER: [&str; 13] = [
    SHARED_POSITIONS,
    SHARED_RATES,
    MASS,
    ROWS,
    GAMMA,
    STABILISED,
    INERTIA,
    LOADS,
    SUMS,
    FACTORISATION,
    SUBSTITUTION,
    RECURSION,
    WATCH,
];

/// The table of one function; its operations add up to those of the program.
pub fn expenses(compiled: &Compiled, function: Function) -> Vec<Expense> {
    let equations = compiled.complete.equations.clone();
    let nodes = nodes_of(&equations, &outputs(&compiled.complete, function));
    let (purposes, rest) = if function.pair().is_some() {
        (of_the_solution(compiled, &equations, function), Rest::of(compiled, &equations, function))
    } else {
        (of_outputs(compiled, function), Rest::default())
    };
    if purposes.len() < 2 {
        return by_kind(compiled, function);
    }
    let graph = equations.graph.read();
    let mut needs: Vec<Vec<u32>> = vec![Vec::new(); graph.len()];
    for (index, purpose) in purposes.iter().enumerate() {
        for node in graph.reachable(purpose.roots.iter().copied()) {
            needs[node.index()].push(index as u32);
        }
    }
    let mut table = Table::default();
    for node in nodes {
        let needed = needs[node.index()].iter().map(|index| &purposes[*index as usize]);
        let needed: Vec<&Purpose> = needed.collect();
        match needed.as_slice() {
            [] => table.add(rest.purpose(node), None),
            [first, others @ ..] if others.iter().all(|other| other.what == first.what) => {
                table.add(&first.what, others.is_empty().then_some(&first.of));
            }
            _ if graph.class(node) <= Class::Position => table.add(SHARED_POSITIONS, None),
            _ => table.add(SHARED_RATES, None),
        }
    }
    table.in_order()
}

/// The parts from which the equations are set up.
fn of_the_solution(compiled: &Compiled, equations: &Equations, function: Function) -> Vec<Purpose> {
    let mut purposes = Purposes::default();
    purposes.add(MASS, "", equations.mass.values().copied());
    purposes.add(INERTIA, "", equations.contributions.inertia_and_gravity.iter().copied());
    for (load, terms) in compiled.mechanism.loads.iter().zip(&equations.contributions.loads) {
        purposes.add(LOADS, &load.name.text, terms.iter().copied());
    }
    for (row, minus_gamma) in equations.rows.iter().zip(minus_gamma(compiled, equations, function)) {
        purposes.add(ROWS, &row.of, row.jet.columns.values().copied());
        let what = if function.is_stabilised() { STABILISED } else { GAMMA };
        purposes.add(what, &row.of, [minus_gamma]);
    }
    purposes.0
}

/// What rows ask of accelerations.
fn minus_gamma(compiled: &Compiled, equations: &Equations, function: Function) -> Vec<Node> {
    match functions::asked(&compiled.complete, function) {
        Some(rows) => rows.to_vec(),
        None => equations.rows.iter().map(|row| row.jet.bias).collect(),
    }
}

/// The nodes that each part of a function's result needs, by the names of joints, loads, bodies and outputs.
fn of_outputs(compiled: &Compiled, function: Function) -> Vec<Purpose> {
    let (mechanism, equations) = (&compiled.mechanism, &compiled.complete.equations);
    let mut purposes = Purposes::default();
    let by_row = |purposes: &mut Purposes, of: &dyn Fn(usize) -> Vec<Node>| {
        for (index, row) in equations.rows.iter().enumerate() {
            purposes.add(&quoted(&row.of), "", of(index));
        }
    };
    match function {
        Function::Outputs => {
            for (output, node) in mechanism.outputs.iter().zip(&equations.outputs) {
                purposes.add(&quoted(&output.name.text), "", [*node]);
            }
        }
        Function::Powers => {
            for (load, node) in mechanism.loads.iter().zip(&equations.powers) {
                purposes.add(&quoted(&load.name.text), "", [*node]);
            }
        }
        Function::Forces => {
            let contributions = &equations.contributions;
            purposes.add(INERTIA, "", contributions.inertia_and_gravity.iter().copied());
            for (load, terms) in mechanism.loads.iter().zip(&contributions.loads) {
                purposes.add(&quoted(&load.name.text), "", terms.iter().copied());
            }
        }
        Function::Motions => {
            for (body, motion) in mechanism.bodies.iter().zip(&equations.motions) {
                purposes.add(&quoted(&body.name.text), "", motion.flat());
            }
        }
        Function::Reactions => {
            for (joint, wrench) in mechanism.joints.iter().zip(&equations.reactions) {
                purposes.add(&quoted(&joint.name.text), "", wrench.iter().copied());
            }
        }
        Function::Constraints => by_row(&mut purposes, &|row| vec![equations.rows[row].jet.value]),
        Function::Gamma => by_row(&mut purposes, &|row| vec![equations.gamma[row]]),
        Function::ConstraintJacobian => {
            by_row(&mut purposes, &|row| equations.rows[row].jet.columns.values().copied().collect());
        }
        _ => {}
    }
    purposes.0
}

fn quoted(name: &str) -> String {
    format!("\"{name}\"")
}

/// Where no part of the mechanism can be told from another: what is done.
fn by_kind(compiled: &Compiled, function: Function) -> Vec<Expense> {
    let counts = count(compiled.programs.get(function));
    let kinds = [
        ("additions, subtractions and negations", counts.additions),
        ("multiplications", counts.multiplications),
        ("multiplications with an addition", counts.fused_multiply_adds),
        ("divisions", counts.divisions),
        ("square roots", counts.square_roots),
        ("choices and comparisons", counts.choices),
        ("sin, cos, exp and the like", counts.transcendentals),
    ];
    let used = kinds.into_iter().filter(|(_, operations)| *operations > 0);
    used.map(|(what, operations)| Expense { purpose: what.to_string(), operations, most: Vec::new() })
        .collect()
}

#[derive(Default)]
struct Purposes(Vec<Purpose>);

impl Purposes {
    /// More roots for a purpose.
    fn add(&mut self, what: &str, of: &str, roots: impl IntoIterator<Item = Node>) {
        match self.0.iter_mut().find(|known| known.what == what && known.of == of) {
            Some(known) => known.roots.extend(roots),
            None => {
                let (what, of) = (what.to_string(), of.to_string());
                self.0.push(Purpose { what, of, roots: roots.into_iter().collect() });
            }
        }
    }
}

/// The steps that are done with the equations once they are set up. The sets hold what they need, too.
#[derive(Default)]
struct Rest {
    /// Whether there is a solution; else only sums are left.
    solves: bool,
    sums: BTreeSet<Node>,
    factorisation: BTreeSet<Node>,
    solution: BTreeSet<Node>,
    recursion: bool,
}

impl Rest {
    fn of(compiled: &Compiled, equations: &Equations, function: Function) -> Rest {
        let Some((solution, factored)) = functions::solution(&compiled.complete, function) else {
            return Rest::default();
        };
        let minus_gamma = minus_gamma(compiled, equations, function);
        let graph = equations.graph.read();
        let needs = |nodes: &mut dyn Iterator<Item = Node>| graph.reachable(nodes).into_iter().collect();
        Rest {
            solves: true,
            sums: needs(&mut equations.forces.iter().copied().chain(minus_gamma)),
            factorisation: needs(&mut factored.iter().copied()),
            solution: needs(&mut solution.acceleration.iter().chain(&solution.lambda).copied()),
            recursion: compiled.complete.solved.order.strategy == Strategy::ArticulatedBodies,
        }
    }

    fn purpose(&self, node: Node) -> &'static str {
        if self.recursion {
            RECURSION
        } else if !self.solves || self.sums.contains(&node) {
            SUMS
        } else if self.factorisation.contains(&node) {
            FACTORISATION
        } else if self.solution.contains(&node) {
            SUBSTITUTION
        } else {
            WATCH
        }
    }
}

#[derive(Default)]
struct Table {
    lines: BTreeMap<String, BTreeMap<String, usize>>,
}

impl Table {
    fn add(&mut self, what: &str, of: Option<&String>) {
        let line = self.lines.entry(what.to_string()).or_default();
        *line.entry(of.cloned().unwrap_or_default()).or_default() += 1;
    }

    fn in_order(self) -> Vec<Expense> {
        let mut table: Vec<Expense> =
            self.lines.into_iter().map(|(what, parts)| expense(what, parts)).collect();
        let place = |purpose: &str| ORDER.iter().position(|known| *known == purpose).unwrap_or(2);
        table.sort_by_key(|line| (place(&line.purpose), Reverse(line.operations)));
        table
    }
}

/// At most so many joints or loads are named.
const NAMED: usize = 3;

fn expense(purpose: String, parts: BTreeMap<String, usize>) -> Expense {
    let operations = parts.values().sum();
    let mut most: Vec<(String, usize)> = parts.into_iter().filter(|(of, _)| !of.is_empty()).collect();
    most.sort_by_key(|(_, operations)| Reverse(*operations));
    most.truncate(NAMED);
    Expense { purpose, operations, most }
}
