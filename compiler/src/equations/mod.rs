//! Equations of motion, symbolic: M v̇ + Dᵀλ = Q, D v = ν, D v̇ = γ, with energies, powers, reactions and outputs.
//!
//! One derivation serves both sets of coordinates: in absolute coordinates every body is free, in tree coordinates
//! bodies hang on the joints of a spanning tree. What differs between the plane and space stands in `plane` and `space`,
//! under the same names. How the linear system is solved is left to `solve`.
//!
//! Equations are written with operators, on values that know their graph: numbers, vectors, and [jets](Moving) as functions of the
//! motion. What is kept of them are bare nodes.

pub mod bodies;
pub mod conditions;
pub mod coordinates;
pub mod couplings;
pub mod elastic;
mod friction;
mod jet;
mod kinematics;
mod laws;
pub mod loads;
mod look_up;
mod means;
mod memories;
pub mod plane;
mod rows;
pub mod space;
mod spanning_tree;
mod switch;
pub mod tangent;
pub mod toothings;

pub use conditions::{Condition, Conditions, StartTarget};
pub use coordinates::{Ball, Layout, Linear, MultiTurn, Owner, Rotation, Symbols};
pub use friction::{Braked, Friction, braked, closed};
pub use jet::{Jet, Moving};
pub use kinematics::Kinematics;
pub use laws::{Laws, Totals, power};
pub use loads::penalty::penalties;
pub use rows::{JointRow, Origin, Row, RowOfJoint};
pub use spanning_tree::{Attachment, SpanningTree};
pub use switch::{Omitted, Sized, Switch};
pub use tangent::Tangents;

use crate::beams::Way;
use crate::forms::{CONTACT_LAWS, SURFACES, Sign, Vocabulary};
use crate::model::{Coordinate, Mechanism, Rate, Redundant, Space, identifier};
use crate::symbolic::{Class, Computed, Growing, Node, Scalar, Sheet, all_bare};
use std::collections::{BTreeMap, BTreeSet};

/// Motion of a body: of its centre of mass in world axes, and its orientation. In the plane the pair (cos, sin), ω and ω̇;
/// in space the rotation matrix row by row, and ω and ω̇ in body axes.
#[derive(Clone, Debug)]
pub struct BodyMotion {
    pub position: Vec<Node>,
    pub orientation: Vec<Node>,
    pub velocity: Vec<Node>,
    pub rate: Vec<Node>,
    pub acceleration: Vec<Node>,
    pub angular_acceleration: Vec<Node>,
}

impl BodyMotion {
    /// All of it, in the order of the fields.
    pub fn flat(&self) -> Vec<Node> {
        let parts = [
            &self.position,
            &self.orientation,
            &self.velocity,
            &self.rate,
            &self.acceleration,
            &self.angular_acceleration,
        ];
        parts.into_iter().flatten().copied().collect()
    }
}

/// What a joint exerts on the second place's body: force (world axes) at the second place, and torque about it.
pub type Wrench = Vec<Node>;

/// Inertia and gravity, before loads.
pub struct Dynamics<'g> {
    /// M, lower triangle.
    pub mass: BTreeMap<(usize, usize), Scalar<'g>>,
    /// Gyroscopic and gravity forces, with the sign of Q.
    pub forces: Vec<Scalar<'g>>,
    /// M v̇ less those.
    pub inverse: Vec<Scalar<'g>>,
    pub kinetic_energy: Scalar<'g>,
    /// Of gravity.
    pub potential_energy: Scalar<'g>,
    /// In space: the masses of the links that M is made of.
    pub distributions: Vec<space::Distribution>,
}

impl<'g> Dynamics<'g> {
    /// Of nothing.
    fn none(g: Sheet<'g>) -> Self {
        Dynamics {
            mass: BTreeMap::new(),
            forces: Vec::new(),
            inverse: Vec::new(),
            kinetic_energy: g.zero(),
            potential_energy: g.zero(),
            distributions: Vec::new(),
        }
    }
}

/// What Q and V consist of.
#[derive(Clone, Debug)]
pub struct Contributions {
    /// Gyroscopic and gravity forces, with the sign of Q.
    pub inertia_and_gravity: Vec<Node>,
    /// Per load, what it adds to entries of Q.
    pub loads: Vec<Vec<Node>>,
    /// Per load, the energy it stores.
    pub potentials: Vec<Node>,
}

/// What follows from v̇ and λ.
pub struct Consequences {
    pub motions: Vec<BodyMotion>,
    pub reactions: Vec<Wrench>,
}

/// Everything about the motion as expressions on one graph.
#[derive(Clone, Debug)]
pub struct Equations {
    pub graph: Growing,
    pub symbols: Symbols,
    pub tree: SpanningTree,
    pub layout: Layout,
    pub kinematics: Kinematics,
    /// M, lower triangle.
    pub mass: BTreeMap<(usize, usize), Node>,
    /// In space: the masses of the links that M is made of.
    pub distributions: Vec<space::Distribution>,
    /// Q.
    pub forces: Vec<Node>,
    pub contributions: Contributions,
    /// M v̇ − Q with v̇ as given.
    pub inverse: Vec<Node>,
    /// The same less what rubs by reactions, where these follow from v̇: of a tree. Where there are rows λ is open, and it is left out.
    pub inverse_dynamics: Vec<Node>,
    pub rows: Vec<Row>,
    /// Rows that are kept though others fix what they fix: their multipliers are zero.
    pub idle: BTreeSet<usize>,
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
    /// With v̇ and λ as given.
    pub outputs: Vec<Node>,
    /// The efforts that `expect` bounds, likewise.
    pub expected: Vec<Node>,
    /// What rubs by reactions.
    pub friction: Friction,
    /// Of each gate that is held, the gap, and the force of its law without the gate; of events and memories likewise.
    pub guards: Vec<[Node; 2]>,
    /// All that is held after the events that occur, with v̇ and λ as given; nothing without memories.
    pub assignments: Vec<Node>,
    /// Of each gap of a rigid contact, its rate, its second time derivative at v̇ = 0, and the restitution; of dry friction the sliding and its
    /// derivative.
    pub strikes: Vec<[Node; 3]>,
    /// μ_s and μ_k of each gate, where any is of dry friction of a contact.
    pub grips: Vec<[Node; 2]>,
    /// What each dry friction of a joint holds and slides with, of v̇ and λ.
    pub bounds: Vec<[Node; 2]>,
    /// ż of the internal states, likewise, and their values at the start.
    pub internal_rates: Vec<Node>,
    pub internal_starts: Vec<Node>,
    /// Of `start`.
    pub conditions: Conditions,
    /// Masses, inertias and lengths that depend on parameters, `mass of "crank"`.
    pub masses: Vec<(String, Node)>,
    /// Positions that `start` guesses.
    pub guesses: Vec<(Condition, Node)>,
    /// Of each pair of toothings the sum of angles that says which teeth face which spaces.
    pub teeth: Vec<Condition>,
    /// Of each of them whose axes move, the distance of its centres.
    pub distances: Vec<Option<Node>>,
    /// Drivers' quantities and the values of their laws.
    pub driven: Vec<(Condition, Node)>,
}

/// Derives the equations in the coordinates of `tree`, without the rows that are `omitted`; where redundant rows are kept, the slots
/// of switches that are not taken are rows without a part in the solution.
pub fn derive(mechanism: &Mechanism, tree: SpanningTree, omitted: &Omitted) -> Equations {
    let graph = Growing::default();
    let g = graph.sheet();
    let rotors = couplings::multi_turn_rotors(mechanism);
    let (layout, mut symbols, kinematics) = match mechanism.space {
        Space::Planar => {
            let (layout, symbols, plane) = plane::coordinates(g, mechanism, &tree, &rotors);
            (layout, symbols, Kinematics::Plane(plane))
        }
        Space::Spatial => {
            let (layout, symbols, space) = space::coordinates(g, mechanism, &tree, &rotors);
            (layout, symbols, Kinematics::Space(space))
        }
    };

    // Inertia and gravity.
    let without_multipliers = symbols.clone();
    let laws = Laws::moving(g, mechanism, &without_multipliers, &layout, &kinematics);
    let dynamics = match mechanism.space {
        Space::Planar => plane::dynamics(&laws),
        Space::Spatial => space::dynamics(&laws),
    };
    let mut computed = Computed::default();
    let nodes = dynamics.mass.values().chain(&dynamics.forces).map(|entry| entry.bare);
    computed.add(&g.graph(), &nodes.collect::<Vec<_>>());

    // Constraint rows, and a multiplier for each.
    let carrying = tree.carrying(mechanism);
    let keeps = mechanism.options.redundant == Redundant::Keep;
    let dropped: &[RowOfJoint] = if keeps { &[] } else { &omitted.dropped };
    let all = rows::rows(&laws, &tree, &carrying, dropped, Some(computed));
    let chosen = switch::choose(g, &all, &omitted.switches, &omitted.columns);
    let rows = switch::apply(g, &all, &omitted.switches, &chosen, keeps);
    let lambda = rows
        .iter()
        .map(|row| format!("lambda_{}_{}", identifier(&row.of), row.form.name))
        .map(|name| g.symbol(name, Class::Input).bare)
        .collect();
    symbols.lambda = lambda;
    symbols.normals = friction::symbols(g, mechanism);
    let laws = Laws::moving(g, mechanism, &symbols, &layout, &kinematics);

    // Loads.
    let Dynamics { mass, mut forces, mut inverse, kinetic_energy, mut potential_energy, distributions } =
        dynamics;
    let inertia_and_gravity = all_bare(&forces);
    let mut contributions = Contributions { inertia_and_gravity, loads: Vec::new(), potentials: Vec::new() };
    let mut powers = Vec::new();
    for load in &mechanism.loads {
        let terms = loads::terms(&laws, load);
        contributions.loads.push(terms.forces.iter().map(|(_, force)| force.bare).collect());
        contributions.potentials.push(terms.potential.bare);
        for (index, force) in terms.forces {
            forces[index] += force;
            inverse[index] -= force;
        }
        potential_energy += terms.potential;
        powers.push(terms.power.bare);
    }

    // What follows from v̇ and λ.
    let first_driver = rows.len() - mechanism.drivers.len();
    let mut totals = Totals {
        kinetic: Some(kinetic_energy.bare),
        potential: Some(potential_energy.bare),
        powers: powers.clone(),
        ..Totals::default()
    };
    // The effort acts along the driven quantity, whose rate is that of the law.
    for (driver, lambda) in mechanism.drivers.iter().zip(&symbols.lambda[first_driver..]) {
        let effort = -g.on(*lambda);
        totals.efforts.push(effort.bare);
        totals.driver_powers.push((effort * laws.jet(&driver.law).jet.drift).bare);
    }
    // Each joint exerts what its own rows do, whichever of them are taken.
    let lambda = switch::multipliers(g, &all, &rows, &symbols.lambda, &omitted.switches, &chosen);
    let Consequences { motions, reactions } = match mechanism.space {
        Space::Planar => plane::consequences(&laws, &tree, &all, &lambda, dropped),
        Space::Spatial => space::consequences(&laws, &tree, &all, &lambda, dropped),
    };

    // What has no row exerts nothing.
    totals.constraint_efforts = vec![g.zero().bare; mechanism.constraints.len()];
    for (row, lambda) in all.iter().zip(&lambda) {
        if let Origin::Constraint(constraint) = row.origin {
            totals.constraint_efforts[constraint.0] = (-g.on(*lambda)).bare;
        }
    }
    totals.reactions.clone_from(&reactions);
    let outputs_laws = laws.with_totals(&totals);
    let forces = all_bare(&forces);
    let friction = friction::friction(&laws, &forces, &reactions);
    let outputs: Vec<Node> =
        mechanism.outputs.iter().map(|output| outputs_laws.value(&output.value).bare).collect();

    let expected = mechanism.expect.motion.efforts.iter();
    let expected = expected.map(|effort| outputs_laws.value(&effort.value).bare).collect();
    let assignments = memories::assignments(&outputs_laws);
    let guards = loads::guards(&laws).into_iter().chain(memories::guards(&laws)).collect();
    let strikes = memories::with_jumps(&laws, loads::strikes(&laws));
    let grips = memories::with_none(&laws, loads::grips(&laws));
    let bounds = memories::with_none(&laws, loads::bounds(&outputs_laws));
    let states = mechanism.states.iter();
    let internal_rates = states.clone().map(|state| rate(&outputs_laws, &state.rate).bare).collect();
    let internal_starts = states.map(|state| outputs_laws.value(&state.start).bare).collect();

    let conditions = conditions::start_conditions(&laws);

    let mut masses = masses(&laws);
    masses.retain(|(_, node)| g.on(*node).class() == Class::Parameter);
    let guesses = conditions::guesses(&laws);
    let teeth = mechanism.pairs.iter().map(|pair| couplings::facing(&laws, pair)).collect();
    let distances = mechanism.pairs.iter().map(|pair| couplings::distance(&laws, pair)).collect();
    let driven = mechanism
        .drivers
        .iter()
        .map(|driver| (conditions::condition(&laws, &driver.coordinate).0, laws.value(&driver.law).bare))
        .collect();
    let nu = rows.iter().map(|row| (-g.on(row.jet.drift)).bare).collect();
    let gamma = rows.iter().map(|row| (-g.on(row.jet.bias)).bare).collect();
    let (zero, one) = (g.zero().bare, g.one().bare);
    let inverse = all_bare(&inverse);
    let mass = mass.into_iter().map(|(at, entry)| (at, entry.bare)).collect();
    let (kinetic_energy, potential_energy) = (kinetic_energy.bare, potential_energy.bare);
    let equations = Equations {
        nu,
        gamma,
        zero,
        one,
        symbols,
        mass,
        distributions,
        forces,
        contributions,
        inverse_dynamics: inverse.clone(),
        inverse,
        idle: idle(&rows, omitted, keeps),
        rows,
        kinetic_energy,
        potential_energy,
        powers,
        friction,
        driver_efforts: totals.efforts,
        driver_powers: totals.driver_powers,
        motions,
        reactions,
        outputs,
        expected,
        guards,
        assignments,
        strikes,
        grips,
        bounds,
        internal_rates,
        internal_starts,
        conditions,
        masses,
        guesses,
        teeth,
        distances,
        driven,
        tree,
        layout,
        kinematics,
        graph,
    };
    equations.without_normals()
}

/// ż of an internal state.
fn rate<'g>(laws: &Laws<'g>, rate: &Rate) -> Scalar<'g> {
    match rate {
        Rate::Written(expr) => laws.value(expr),
        Rate::OfLoad(load, which) => loads::rate(laws, &laws.mechanism.loads[load.0], *which),
    }
}

/// The equations as `options { redundant = … }` wants them, given those with all rows.
pub fn without_redundant(
    mechanism: &Mechanism,
    tree: SpanningTree,
    all: Equations,
    omitted: &Omitted,
) -> Equations {
    match mechanism.options.redundant {
        _ if omitted.is_empty() => all,
        Redundant::Keep if omitted.switches.is_empty() => {
            let idle = idle(&all.rows, omitted, true);
            Equations { idle, ..all }
        }
        _ => derive(mechanism, tree, omitted),
    }
}

/// The rows without a part in the solution, where those that repeat others are kept.
fn idle(rows: &[Row], omitted: &Omitted, keeps: bool) -> BTreeSet<usize> {
    let is_idle =
        |row: &Row| switch::is_idle(row) || row.of_joint().is_some_and(|row| omitted.dropped.contains(&row));
    let rows = rows.iter().enumerate().filter(|(_, row)| keeps && is_idle(row));
    rows.map(|(index, _)| index).collect()
}

impl Equations {
    /// With N in v̇ and λ wherever results stand, and without it in Q: what rubs by N is `friction.forces`.
    fn without_normals(mut self) -> Self {
        if self.friction.presses_nowhere() {
            return self;
        }
        let (results, none) = (self.friction.in_results(), self.friction.without(self.graph.sheet()));
        {
            let sheet = self.graph.sheet();
            let replace = |nodes: &mut [Node], by: &BTreeMap<Node, Node>| {
                let replaced = sheet.graph().substitute(nodes, by);
                nodes.copy_from_slice(&replaced);
            };
            replace(&mut self.forces, &none);
            replace(&mut self.inverse, &none);
            replace(&mut self.powers, &results);
            replace(&mut self.outputs, &results);
            replace(&mut self.expected, &results);
            replace(&mut self.assignments, &results);
            replace(&mut self.internal_rates, &results);
            self.bounds.iter_mut().for_each(|bounds| replace(bounds, &results));
            replace(&mut self.driver_efforts, &results);
            replace(&mut self.driver_powers, &results);
            self.reactions.iter_mut().for_each(|wrench| replace(wrench, &results));
            self.contributions.loads.iter_mut().for_each(|load| replace(load, &results));
        }
        self.inverse_dynamics.clone_from(&self.inverse);
        if self.rows.is_empty() {
            let g = self.graph.sheet();
            let inverse = self.inverse.iter().zip(&self.friction.forces);
            self.inverse_dynamics = inverse.map(|(inverse, force)| (g.on(*inverse) - *force).bare).collect();
        }
        self
    }

    /// v̇, then λ: what results depend on.
    pub fn results(&self) -> impl Iterator<Item = Node> {
        self.symbols.acceleration.iter().chain(&self.symbols.lambda).copied()
    }

    /// Rows of the couplings whose phase comes from the assembled start.
    pub fn open_rows(&self, mechanism: &Mechanism) -> Vec<usize> {
        let is_open = |row: &Row| match row.origin {
            Origin::Constraint(constraint) => couplings::is_open(&mechanism.constraints[constraint.0]),
            Origin::Joint(_) | Origin::Driver(_) => false,
        };
        (0..self.rows.len()).filter(|row| is_open(&self.rows[*row])).collect()
    }

    /// Whether an input decides the value of a node.
    pub fn takes_inputs(&self, node: Node) -> bool {
        self.graph.read().reachable([node]).iter().any(|node| self.symbols.inputs.contains(node))
    }

    /// With the starts of these internal states.
    pub fn starting_at(self, mechanism: &Mechanism) -> Self {
        let laws = Laws::constant(self.graph.sheet(), mechanism, &self.symbols);
        let starts = mechanism.states.iter().map(|state| laws.value(&state.start).bare);
        let internal_starts = starts.collect();
        Equations { internal_starts, ..self }
    }

    /// With another start of a coordinate that `start` states.
    pub fn begin_at(&mut self, coordinate: &Coordinate, value: f64) {
        let known = self.conditions.rows.iter().position(|known| known.coordinate == *coordinate);
        if let Some(index) = known {
            self.conditions.start[index].position = Some(self.graph.sheet().number(value).bare);
        }
    }

    /// What laws make of the motion, on the graph.
    pub fn built(&self, mechanism: &Mechanism, of: impl for<'g> Fn(&Laws<'g>) -> Scalar<'g>) -> Node {
        let (g, symbols) = (self.graph.sheet(), &self.symbols);
        of(&Laws::moving(g, mechanism, symbols, &self.layout, &self.kinematics)).bare
    }

    /// The row of one coordinate and a new symbol for its target.
    pub fn condition(&self, mechanism: &Mechanism, coordinate: &Coordinate) -> (Condition, Node) {
        let (g, symbols) = (self.graph.sheet(), &self.symbols);
        conditions::condition(
            &Laws::moving(g, mechanism, symbols, &self.layout, &self.kinematics),
            coordinate,
        )
    }
}

/// Masses, moments of inertia and lengths with their names.
fn masses(laws: &Laws) -> Vec<(String, Node)> {
    let mut masses = Vec::new();
    for body in &laws.mechanism.bodies {
        let name = &body.name.text;
        masses.push((format!("mass of \"{name}\""), laws.value(&body.mass).bare));
        if body.form.turns {
            let moments = laws.vector(&body.inertia.moments).bare;
            match laws.mechanism.space {
                Space::Planar => masses.push((format!("inertia of \"{name}\""), moments[2])),
                Space::Spatial => {
                    masses.extend(["x", "y", "z"].iter().zip(moments).map(|(axis, moment)| {
                        (format!("moment of inertia of \"{name}\" about {axis}"), moment)
                    }))
                }
            }
        }
    }
    for body in &laws.mechanism.bodies {
        for (what, length) in &body.dimensions {
            masses.push((format!("{what} of \"{}\"", body.name.text), laws.value(length).bare));
        }
    }
    for body in &laws.mechanism.bodies {
        let Some(beam) = body.beam() else { continue };
        for way in Way::of(beam.space).iter().filter(|way| **way != Way::Torsion || beam.has(Way::Torsion)) {
            let (what, rigidity) = (way.word(beam.space), beam.rigidity(*way));
            masses.push((format!("{what} stiffness of \"{}\"", body.name.text), laws.value(rigidity).bare));
        }
    }
    for joint in &laws.mechanism.joints {
        let scalars = joint.form.call.named.iter().filter(|argument| !argument.is_direction());
        for (argument, value) in
            scalars.zip(&joint.scalars).filter(|(argument, _)| argument.sign == Sign::Positive)
        {
            masses.push((format!("{} of \"{}\"", argument.name, joint.name.text), laws.value(value).bare));
        }
    }
    for load in &laws.mechanism.loads {
        for (argument, values) in load.arguments().filter(|(argument, _)| argument.sign == Sign::Positive) {
            let what = format!("{} of \"{}\"", argument.name, load.name.text);
            let held = values.iter().filter(|value| !value.varies());
            masses.extend(held.map(|value| (what.clone(), laws.value(value).bare)));
        }
    }
    masses
}

/// The words of all elements.
pub static VOCABULARY: Vocabulary = Vocabulary {
    bodies: bodies::BODIES,
    joints: |space| match space {
        Space::Planar => plane::joints::JOINTS.iter().map(|joint| &joint.form).collect(),
        Space::Spatial => space::joints::JOINTS.iter().map(|joint| &joint.form).collect(),
    },
    toothings: toothings::TOOTHINGS,
    couplings: couplings::COUPLINGS,
    loads: |space| loads::of_space(space).map(|load| &load.form).collect(),
    surfaces: SURFACES,
    contact_laws: CONTACT_LAWS,
    contact: &loads::CONTACT.form,
    penalty: &loads::PENALTY.form,
};
