//! Coordinates that can be held at a value: those that `start` states, and the independent ones.

use super::Equations;
use super::coordinates::{angle_name, mode_name, travel_name};
use super::jet::Jet;
use super::laws::Laws;
use super::rows::{JointRow, that_yield};
use crate::forms::RowForm;
use crate::model::{Coordinate, Joint, JointId, Mechanism, Place, Rotor, StartOrientation};
use crate::symbolic::{Class, Node};

/// One coordinate as a row beside the constraints.
#[derive(Clone, Debug)]
pub struct Condition {
    /// `crank_pin.angle`.
    pub of: String,
    pub coordinate: Coordinate,
    /// An angle: at expansion compared on the circle, because `start` speaks of positions.
    pub angular: bool,
    /// An angle whose turns the dynamics count: at run time compared with them, because laws depend on them.
    pub counted: bool,
    /// sin(θ − target) of an angle that is not counted, else value − target.
    pub residual: Node,
    /// cos(θ − target), or 1.
    pub upright: Node,
    /// Value (of an angle: atan2), columns and bias of the coordinate itself.
    pub jet: Jet,
}

/// Name of a coordinate, `crank_pin.angle`.
pub fn name(mechanism: &Mechanism, coordinate: &Coordinate) -> String {
    match coordinate {
        Coordinate::Angle(Rotor::Body(body)) => format!("{}.angle", mechanism.bodies[body.0].name.text),
        Coordinate::Angle(Rotor::Joint(id, which)) => angle_name(mechanism, *id, *which, 0),
        Coordinate::Travel(id, which) => travel_name(mechanism, *id, *which, 0),
        Coordinate::Mode(body, mode, _) => mode_name(mechanism, *body, usize::from(*mode)),
        Coordinate::Position(place, axis) => format!("{}.{}", place.text, ["x", "y", "z"][*axis]),
        Coordinate::Distance(a, b) => format!("distance({}, {})", a.text, b.text),
        Coordinate::Way(ends, _) => format!("way({}, {})", ends[0].text, ends[1].text),
        Coordinate::Square(a, b) => format!("square({}, {})", a.text, b.text),
        Coordinate::Direction(of, axis) => {
            format!("direction({}).{}", of.0.text, ["x", "y", "z"][*axis])
        }
        Coordinate::Turn(body, axis) => {
            format!("{}.rate.{}", mechanism.bodies[body.0].name.text, ["x", "y", "z"][*axis])
        }
        Coordinate::Closing(joint, row) => format!("{}.{}", mechanism.joints[joint.0].name.text, row.name),
        Coordinate::Deviation(body, axis) => {
            format!("{}.orientation.{}", mechanism.bodies[body.0].name.text, ["x", "y", "z"][*axis])
        }
    }
}

/// The row of one coordinate; makes a new target symbol.
pub fn condition(laws: &Laws, coordinate: &Coordinate) -> (Condition, Node) {
    let of = name(laws.mechanism, coordinate);
    let target = laws.g.symbol(format!("target_{of}"), Class::Input);
    let motion = laws.coordinate(coordinate);
    let rotor = match coordinate {
        Coordinate::Angle(rotor) => Some(*rotor),
        Coordinate::Travel(..)
        | Coordinate::Position(..)
        | Coordinate::Distance(..)
        | Coordinate::Way(..)
        | Coordinate::Square(..)
        | Coordinate::Direction(..)
        | Coordinate::Turn(..)
        | Coordinate::Mode(..)
        | Coordinate::Closing(..)
        | Coordinate::Deviation(..) => None,
    };
    let counted = rotor.is_some_and(|rotor| laws.is_counted(rotor));
    let (residual, upright) = match rotor.filter(|_| !counted) {
        Some(rotor) => {
            let [cos, sin] = laws.kinematics().rotor_pair(laws, rotor).parts();
            let (c, s) = (target.cos(), target.sin());
            (sin * c - cos * s, cos * c + sin * s)
        }
        None => {
            let upright = match coordinate {
                Coordinate::Closing(joint, form) => row_of(laws, *joint, form).and_then(|row| row.upright),
                _ => None,
            };
            (motion.value() - target, upright.map_or(laws.g.one(), |upright| laws.g.on(upright)))
        }
    };
    (
        Condition {
            of,
            coordinate: coordinate.clone(),
            angular: rotor.is_some(),
            counted,
            residual: residual.bare,
            upright: upright.bare,
            jet: motion.jet,
        },
        target.bare,
    )
}

/// What `start` asks of a condition.
#[derive(Clone, Debug, Default)]
pub struct StartTarget {
    pub position: Option<Node>,
    pub rate: Option<Node>,
}

/// Conditions, what `start` asks of each, and a symbol for the target of each.
#[derive(Clone, Debug, Default)]
pub struct Conditions {
    pub rows: Vec<Condition>,
    pub start: Vec<StartTarget>,
    pub targets: Vec<Node>,
}

impl Conditions {
    fn push(&mut self, (condition, target): (Condition, Node), start: StartTarget) {
        self.rows.push(condition);
        self.start.push(start);
        self.targets.push(target);
    }

    /// These and those of further coordinates, unless they are there, and the indices of the latter.
    pub fn with(
        &self,
        mechanism: &Mechanism,
        equations: &Equations,
        coordinates: &[Coordinate],
    ) -> (Conditions, Vec<usize>) {
        let (mut all, mut indices) = (self.clone(), Vec::new());
        for coordinate in coordinates {
            let known = all.rows.iter().position(|known| known.coordinate == *coordinate);
            indices.push(known.unwrap_or(all.rows.len()));
            if known.is_none() {
                all.push(equations.condition(mechanism, coordinate), StartTarget::default());
            }
        }
        (all, indices)
    }

    /// Each with what `start` asks of it.
    pub fn with_start(&self) -> impl Iterator<Item = (&Condition, &StartTarget)> {
        self.rows.iter().zip(&self.start)
    }
}

/// The positions that `start` guesses, with the values guessed.
pub fn guesses(laws: &Laws) -> Vec<(Condition, Node)> {
    let guessed = laws.mechanism.start.iter().filter(|start| !start.exact && !start.rate);
    let mut guesses: Vec<(Condition, Node)> = guessed
        .map(|start| {
            let (condition, _) = condition(laws, &start.coordinate);
            (condition, laws.value(&start.value).bare)
        })
        .collect();
    let zero = laws.g.zero().bare;
    for start in laws.mechanism.orientations.iter().filter(|start| !start.exact) {
        let rows = orientation(laws, start);
        guesses.extend(rows.into_iter().map(|(condition, _)| (condition, zero)));
    }
    let unsaid = laws.mechanism.joints.iter().flat_map(|joint| unsaid_offsets(laws.mechanism, joint));
    guesses.extend(unsaid.map(|coordinate| (condition(laws, &coordinate).0, zero)));
    guesses
}

/// Three rows that hold a body in space at an orientation A₀: Σ ½ A₀ e_j × A e_j, the axis of the turn between them
/// times its sine. Their targets are zero.
pub fn orientation(laws: &Laws, start: &StartOrientation) -> [(Condition, Node); 3] {
    [0, 1, 2].map(|axis| condition(laws, &Coordinate::Deviation(start.body, axis)))
}

/// A row of a joint that yields.
pub fn row_of(laws: &Laws, joint: JointId, form: &RowForm) -> Option<JointRow> {
    that_yield(laws, joint).into_iter().find(|row| row.form == form)
}

/// What `start` says of where a joint with play stands in it: along axes, or how far from the middle.
fn said_of_play<'m>(mechanism: &'m Mechanism, joint: &'m Joint) -> impl Iterator<Item = &'m Coordinate> {
    let is = |a: &Place, b: &Place| a.at == b.at && a.frame == b.frame;
    let between = move |a: &Place, b: &Place| is(a, &joint.first) && is(b, &joint.second);
    let of = move |coordinate: &Coordinate| match coordinate {
        Coordinate::Way(ends, _) => between(&ends[0], &ends[1]),
        Coordinate::Distance(first, second) => between(first, second),
        _ => false,
    };
    let said = mechanism.start.iter().filter(|start| !start.rate).map(|start| &start.coordinate);
    said.filter(move |coordinate| joint.loose.is_some() && of(coordinate))
}

/// The offsets of a joint with play of which `start` says nothing although it says others: those are zero where nothing else decides.
fn unsaid_offsets(mechanism: &Mechanism, joint: &Joint) -> Vec<Coordinate> {
    let said: Vec<_> = said_of_play(mechanism, joint).collect();
    let Some(ends) =
        said.iter().find_map(|it| if let Coordinate::Way(ends, _) = it { Some(ends) } else { None })
    else {
        return Vec::new();
    };
    let axes = 0..mechanism.space.dimensions();
    let all = axes.map(|axis| Coordinate::Way(ends.clone(), Box::new(Coordinate::along(axis))));
    all.filter(|offset| !said.contains(&offset)).collect()
}

/// The conditions of `start`, in order of first mention; joints that yield are closed there, and stand still.
pub fn start_conditions(laws: &Laws) -> Conditions {
    let mut conditions = Conditions::default();
    let zero = laws.g.zero().bare;
    for (id, joint) in laws.mechanism.joints.iter().enumerate().filter(|(_, joint)| !joint.holds()) {
        let is_placed = said_of_play(laws.mechanism, joint).next().is_some();
        let position = (!joint.eased && !is_placed).then_some(zero);
        let rate = (!joint.eased).then_some(zero);
        for row in that_yield(laws, JointId(id)) {
            let closing = condition(laws, &Coordinate::Closing(JointId(id), row.form));
            conditions.push(closing, StartTarget { position, rate });
        }
    }
    for start in laws.mechanism.start.iter().filter(|start| start.exact) {
        let known = conditions.rows.iter().position(|known| known.coordinate == start.coordinate);
        let index = known.unwrap_or(conditions.rows.len());
        if known.is_none() {
            conditions.push(condition(laws, &start.coordinate), StartTarget::default());
        }
        let value = Some(laws.value(&start.value).bare);
        let target = &mut conditions.start[index];
        *if start.rate { &mut target.rate } else { &mut target.position } = value;
    }
    for start in laws.mechanism.orientations.iter().filter(|start| start.exact) {
        for condition in orientation(laws, start) {
            conditions.push(condition, StartTarget { position: Some(zero), rate: None });
        }
    }
    conditions
}
