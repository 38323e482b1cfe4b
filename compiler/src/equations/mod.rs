//! Equations of motion, symbolic: M v̇ + Dᵀλ = Q, D v = ν, D v̇ = γ, with energies, powers, reactions and outputs.
//!
//! One derivation serves both sets of coordinates: in absolute coordinates every body is free, in tree coordinates
//! bodies hang on the joints of a spanning tree. How the linear system is solved is left to `solve`.

pub mod bodies;
pub mod conditions;
pub mod coordinates;
pub mod couplings;
mod inertia;
mod jet;
mod joints;
mod kinematics;
mod laws;
mod loads;
mod spanning_tree;

pub use bodies::BodyMotion;
pub use conditions::{Condition, StartTarget};
pub use coordinates::{Layout, Linear, MultiTurn, Symbols};
pub use jet::Jet;
pub use joints::Wrench;
pub use kinematics::Kinematics;
pub use laws::{Laws, Totals};
pub use spanning_tree::{Attachment, SpanningTree};

use crate::model::{BodyKind, JointId, JointKind, Mechanism, Quantity};
use crate::symbolic::{Class, Graph, Node};
use inertia::Massive;
use proc_macro2::Span;
use std::collections::BTreeMap;

/// One constraint row.
#[derive(Clone, Debug)]
pub struct Row {
    /// Name of the joint, constraint or driver.
    pub of: String,
    pub span: Span,
    pub joint: Option<JointId>,
    /// `x`, `y`, `angle`, `normal`, `distance`, `gear`, `rack`, `equation`, `driver`.
    pub what: &'static str,
    /// Φ, D, −ν, −γ.
    pub jet: Jet,
    /// cos Δθ of a direction row, positive on the right root.
    pub upright: Option<Node>,
}

/// Everything about the motion as expressions on one graph.
#[derive(Clone, Debug)]
pub struct Equations {
    pub graph: Graph,
    pub symbols: Symbols,
    pub tree: SpanningTree,
    pub layout: Layout,
    pub kinematics: Kinematics,
    /// M, lower triangle.
    pub mass: BTreeMap<(usize, usize), Node>,
    /// Q.
    pub forces: Vec<Node>,
    pub rows: Vec<Row>,
    /// ν and γ of the rows.
    pub nu: Vec<Node>,
    pub gamma: Vec<Node>,
    pub zero: Node,
    pub one: Node,
    pub kinetic_energy: Node,
    pub potential_energy: Node,
    /// W, per load.
    pub powers: Vec<Node>,
    /// Per driver: effort along its quantity and power, functions of λ.
    pub driver_efforts: Vec<Node>,
    pub driver_powers: Vec<Node>,
    /// Per body, functions of v̇.
    pub motions: Vec<BodyMotion>,
    /// Per joint, functions of v̇ and λ.
    pub reactions: Vec<Wrench>,
    pub outputs: Vec<Node>,
    pub conditions: Vec<Condition>,
    pub start_targets: Vec<StartTarget>,
    /// Masses, inertias and lengths that depend on parameters, `mass of "crank"`.
    pub masses: Vec<(String, Node)>,
    /// Positions that `start` guesses.
    pub guesses: Vec<(Condition, Node)>,
    /// Drivers' quantities and the values of their laws.
    pub driven: Vec<(Condition, Node)>,
}

/// Derives the equations in the coordinates of `tree`.
pub fn derive(mechanism: &Mechanism, tree: SpanningTree) -> Equations {
    let mut graph = Graph::new();
    let g = &mut graph;
    let rotors = couplings::multi_turn_rotors(mechanism);
    let (layout, mut symbols, kinematics) = coordinates::coordinates(g, mechanism, &tree, &rotors);

    // Constraint rows, and a multiplier for each.
    let laws = Laws::moving(mechanism, &symbols, &layout, &kinematics);
    let carrying = tree.carrying(mechanism);
    let rows = rows(g, &laws, &carrying);
    let lambda = rows
        .iter()
        .map(|row| format!("lambda_{}_{}", identifier(&row.of), row.what))
        .map(|name| g.symbol(name, Class::Input))
        .collect();
    symbols.lambda = lambda;
    let laws = Laws::moving(mechanism, &symbols, &layout, &kinematics);

    // Inertia, gravity and loads.
    let massive = massive(g, &laws);
    let gravity = mechanism.gravity.as_ref().map(|gravity| laws.vector(g, gravity));
    let inertia::Inertia { mass, mut forces } = inertia::inertia(g, &kinematics, &massive, gravity);
    let kinetic_energy = kinetic_energy(g, &kinematics, &massive);
    let mut potential_energy = gravity_potential(g, &kinematics, &massive, gravity);
    let mut powers = Vec::new();
    for load in &mechanism.loads {
        let terms = loads::terms(g, &laws, load);
        for (index, force) in terms.forces {
            forces[index] = g.add(forces[index], force);
        }
        potential_energy = g.add(potential_energy, terms.potential);
        powers.push(terms.power);
    }

    // What follows from v̇ and λ.
    let first_driver = rows.len() - mechanism.drivers.len();
    let mut totals = Totals {
        kinetic: Some(kinetic_energy),
        potential: Some(potential_energy),
        powers: powers.clone(),
        ..Totals::default()
    };
    // The effort acts along the driven quantity, whose rate is that of the law.
    for (driver, lambda) in mechanism.drivers.iter().zip(&symbols.lambda[first_driver..]) {
        let effort = g.neg(*lambda);
        let rate = laws.jet(g, &driver.law).drift;
        totals.efforts.push(effort);
        totals.driver_powers.push(g.mul(effort, rate));
    }
    let motions = bodies::motions(g, &kinematics, &massive, &symbols);
    let overlay = bodies::overlay(g, &laws, &motions);
    let absolute = Laws::moving(mechanism, &symbols, &layout, &overlay);
    let absolute_rows = self::rows(g, &absolute, &carrying);
    let reactions = bodies::reactions(g, &laws, &absolute, &tree, &massive, &motions, &rows, &absolute_rows);

    let outputs_laws = laws.with_totals(&totals);
    let outputs = mechanism.outputs.iter().map(|output| outputs_laws.value(g, &output.value)).collect();

    let mut with_targets = symbols.clone();
    let (conditions, start_targets) = conditions::start_conditions(g, &laws, &mut with_targets);

    let mut masses = Vec::new();
    for (body, massive) in mechanism.bodies.iter().zip(&massive) {
        masses.push((format!("mass of \"{}\"", body.name.text), massive.mass));
        masses.extend(massive.inertia.map(|inertia| (format!("inertia of \"{}\"", body.name.text), inertia)));
    }
    for body in &mechanism.bodies {
        for (what, length) in &body.dimensions {
            masses.push((format!("{what} of \"{}\"", body.name.text), laws.value(g, length)));
        }
    }
    for joint in &mechanism.joints {
        if let JointKind::Distance { length } = &joint.kind {
            masses.push((format!("length of \"{}\"", joint.name.text), laws.value(g, length)));
        }
    }
    masses.retain(|(_, node)| g.class(*node) == Class::Parameter);
    let guesses = conditions::guesses(g, &laws);
    let driven = mechanism
        .drivers
        .iter()
        .map(|driver| (conditions::condition(g, &laws, &driver.quantity).0, laws.value(g, &driver.law)))
        .collect();
    let nu = rows.iter().map(|row| g.neg(row.jet.drift)).collect();
    let gamma = rows.iter().map(|row| g.neg(row.jet.bias)).collect();
    let (zero, one) = (g.constant(0.0), g.constant(1.0));
    Equations {
        nu,
        gamma,
        zero,
        one,
        symbols: with_targets,
        mass,
        forces,
        rows,
        kinetic_energy,
        potential_energy,
        powers,
        driver_efforts: totals.efforts,
        driver_powers: totals.driver_powers,
        motions,
        reactions,
        outputs,
        conditions,
        start_targets,
        masses,
        guesses,
        driven,
        tree,
        layout,
        kinematics,
        graph,
    }
}

impl Equations {
    /// Adds position coordinates to the conditions, unless they are there; gives their indices.
    pub fn add_conditions(&mut self, mechanism: &Mechanism, quantities: &[Quantity]) -> Vec<usize> {
        let mut indices = Vec::new();
        for quantity in quantities {
            let of = conditions::name(mechanism, quantity);
            let index = self.conditions.iter().position(|known| known.of == of);
            indices.push(index.unwrap_or_else(|| {
                let laws = Laws::moving(mechanism, &self.symbols, &self.layout, &self.kinematics);
                let (condition, target) = conditions::condition(&mut self.graph, &laws, quantity);
                self.symbols.targets.push(target);
                self.conditions.push(condition);
                self.start_targets.push(StartTarget::default());
                self.conditions.len() - 1
            }));
        }
        indices
    }
}

/// The rows of all joints that carry nothing, of the constraints and of the drivers, in the order written.
fn rows(g: &mut Graph, laws: &Laws, carrying: &[bool]) -> Vec<Row> {
    let mechanism = laws.mechanism;
    let mut rows = Vec::new();
    for (index, joint) in mechanism.joints.iter().enumerate().filter(|(index, _)| !carrying[*index]) {
        for row in joints::rows(g, laws, joint) {
            rows.push(Row {
                of: joint.name.text.clone(),
                span: joint.name.span,
                joint: Some(JointId(index)),
                what: row.what,
                jet: row.jet,
                upright: row.upright,
            });
        }
    }
    let mut phases = laws.symbols.phases.iter().copied();
    for constraint in &mechanism.constraints {
        let phase = if couplings::is_open(constraint) { phases.next() } else { None };
        let (what, jet) = couplings::row(g, laws, constraint, phase);
        let (of, span) = (constraint.name.text.clone(), constraint.name.span);
        rows.push(Row { of, span, joint: None, what, jet, upright: None });
    }
    for driver in &mechanism.drivers {
        let (what, jet) = couplings::driver_row(g, laws, driver);
        let (of, span) = (driver.name.text.clone(), driver.name.span);
        rows.push(Row { of, span, joint: None, what, jet, upright: None });
    }
    rows
}

fn massive(g: &mut Graph, laws: &Laws) -> Vec<Massive> {
    let mut massive = Vec::new();
    for (index, body) in laws.mechanism.bodies.iter().enumerate() {
        let at = laws.vector(g, &body.center);
        let rigid = body.kind == BodyKind::Rigid;
        massive.push(Massive {
            mass: laws.value(g, &body.mass),
            inertia: rigid.then(|| laws.value(g, &body.inertia)),
            center: laws.kinematics().point(g, index, at),
            frame: laws.kinematics().bodies[index].frame,
        });
    }
    massive
}

/// T = Σ ½ m |ẋ|² + ½ J ω².
fn kinetic_energy(g: &mut Graph, kinematics: &Kinematics, bodies: &[Massive]) -> Node {
    let mut twice = g.constant(0.0);
    for body in bodies {
        let v = &kinematics.velocities;
        let [x, y] = kinematics.world(g, &body.center);
        let (x, y) = (x.rate(g, v), y.rate(g, v));
        let (xx, yy) = (g.mul(x, x), g.mul(y, y));
        let square = g.add(xx, yy);
        let translation = g.mul(body.mass, square);
        twice = g.add(twice, translation);
        if let (Some(inertia), Some(rate)) = (body.inertia, kinematics.frames[body.frame].rate) {
            let square = g.mul(v[rate], v[rate]);
            let rotation = g.mul(inertia, square);
            twice = g.add(twice, rotation);
        }
    }
    let half = g.constant(0.5);
    g.mul(half, twice)
}

/// V = −Σ m g·r.
fn gravity_potential(
    g: &mut Graph,
    kinematics: &Kinematics,
    bodies: &[Massive],
    gravity: Option<[Node; 2]>,
) -> Node {
    let mut sum = g.constant(0.0);
    let Some(gravity) = gravity else { return sum };
    for body in bodies {
        let [x, y] = kinematics.world(g, &body.center);
        let (gx, gy) = (g.mul(gravity[0], x.value), g.mul(gravity[1], y.value));
        let height = g.add(gx, gy);
        let weight = g.mul(body.mass, height);
        sum = g.sub(sum, weight);
    }
    sum
}

/// A dotted or indexed name as an identifier.
pub fn identifier(name: &str) -> String {
    name.replace(['.', '['], "_").replace(']', "")
}
