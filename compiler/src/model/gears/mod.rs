//! Toothings, and what their numbers say of the pairs that mesh: which angles they couple, and with which constant.
//!
//! All of it is known at expansion and independent of how a pair is used: without play by a constraint, or by a load.

mod about_axes;
mod bevels;
mod cylinders;
mod following;
mod holding;
mod lowering;
pub mod meshes;
mod pair;
mod racks;
pub mod stiffness;
mod told;
mod toothing;
mod vector;
mod worms;

pub use lowering::Meshing;
pub use pair::{Meeting, Mesh, Pair, Touch, reach, spurs};
pub use told::{Gives, Told};
pub use toothing::{Toothing, ToothingId, involute};

use super::{ConstraintKind, Frame, JointId, Load, Mechanism, Name, Rotor, Space, Subject};
use crate::diagnostics::Diagnostics;
use crate::forms::Rim;
use crate::messages;
use about_axes::Turn;
use following::{Row, follow};
use holding::Orientations;
use std::collections::BTreeMap;
use vector::V3;

impl Mechanism {
    pub fn toothing(&self, id: ToothingId) -> &Toothing {
        &self.bodies[id.body.0].toothings[id.index]
    }

    /// Whether a load is one between teeth whose angles are counted: on axes that move there is a pitch and no turn.
    pub fn has_phase(&self, load: &Load) -> bool {
        load.teeth.as_ref().is_some_and(|teeth| !self.pairs[teeth.pair].axes_move)
    }

    /// The toothings of a pair, and what follows from their distance.
    pub fn mesh_of(&self, pair: &Pair) -> ([&Toothing; 2], Mesh) {
        let toothings = pair.on.map(|id| self.toothing(id));
        (toothings, pair::of(toothings, pair))
    }
}

/// Finds the pairs of a mechanism, and of each constraint and load the number of its own.
pub(super) fn settle(mechanism: &mut Mechanism, diagnostics: &mut Diagnostics) {
    let mut meshing: Vec<Wanted> = Vec::new();
    for constraint in &mut mechanism.constraints {
        if let ConstraintKind::Teeth { on, pair, .. } = &mut constraint.kind {
            *pair = meshing.len();
            meshing.push(Wanted { name: constraint.name.clone(), on: *on, gives: false, axes_move: false });
        }
    }
    for load in &mut mechanism.loads {
        let ids: Vec<ToothingId> = load.on.iter().filter_map(toothing_of).collect();
        if let (Some(teeth), [first, second]) = (&mut load.teeth, &ids[..]) {
            teeth.pair = meshing.len();
            let on = [*first, *second];
            meshing.push(Wanted { name: load.name.clone(), on, gives: true, axes_move: teeth.axes_move });
        }
    }
    if meshing.is_empty() {
        return;
    }
    let orientations = Orientations::of(mechanism);
    let mut pairs = Vec::new();
    for wanted in meshing {
        match pair(mechanism, &orientations, &wanted) {
            Ok(pair) => pairs.push(pair),
            Err(message) => diagnostics.error(wanted.name.span, message),
        }
    }
    if !diagnostics.is_empty() {
        return;
    }
    let mut modules: Vec<f64> = Vec::new();
    for module in pairs.iter().flat_map(|pair| pair.on).map(|id| mechanism.toothing(id).module) {
        if !modules.contains(&module) {
            modules.push(module);
        }
    }
    let rows = pairs.iter().enumerate();
    let rows: Vec<Row> = rows.map(|(at, pair)| row(mechanism, &orientations, (at, pair), &modules)).collect();
    for (at, follows) in follow(&rows).into_iter().enumerate() {
        let Some(follows) = follows else { continue };
        if follows.apart != 0.0 {
            let message = not_assembled(mechanism, &pairs, at, &follows.of, follows.apart);
            diagnostics.error(pairs[at].name.span, message);
            return;
        }
        pairs[at].follows = Some(follows.of);
    }
    mechanism.pairs = pairs;
    meshes::settle(mechanism, diagnostics);
}

fn toothing_of(subject: &Subject) -> Option<ToothingId> {
    match subject {
        Subject::Toothing(id) => Some(*id),
        _ => None,
    }
}

/// A pair to be made: of a constraint, or of a load, whose teeth give.
struct Wanted {
    name: Name,
    on: [ToothingId; 2],
    gives: bool,
    axes_move: bool,
}

fn pair(mechanism: &Mechanism, orientations: &Orientations, wanted: &Wanted) -> Result<Pair, String> {
    let Wanted { name, on, gives, axes_move } = wanted;
    let (on, axes_move) = (*on, *axes_move);
    let toothings = on.map(|id| mechanism.toothing(id));
    let [first, second] = toothings;
    let own = on.map(|id| Frame::Body(id.body));
    if on[0].body == on[1].body || orientations.class(own[0]).0 == orientations.class(own[1]).0 {
        // A rack that cannot move against its pinion is told of where its rail is looked for.
        if first.form.rim != Rim::Rack && second.form.rim != Rim::Rack || on[0].body == on[1].body {
            return Err(messages::teeth_on_one_shaft(&first.text, &second.text));
        }
    }
    let wheels = Wheels { mechanism, orientations, own, toothings, gives: *gives, axes_move };
    let (meeting, found) = match toothings.map(|toothing| toothing.form.rim) {
        [Rim::Internal, Rim::Internal] => return Err(messages::two_rings(&first.text, &second.text)),
        [Rim::External | Rim::Internal, Rim::External | Rim::Internal] => {
            (Meeting::Cylinders, cylinders::couple(&wheels)?)
        }
        [Rim::External, Rim::Rack] => (Meeting::Rack, racks::couple(&wheels, 0)?),
        [Rim::Rack, Rim::External] => (Meeting::Rack, racks::couple(&wheels, 1)?),
        [Rim::Bevel, Rim::Bevel] => {
            bevels::couple(&wheels).map(|(axes, found)| (Meeting::Cones(axes), found))?
        }
        [Rim::Worm, Rim::External] => (Meeting::Worm, worms::couple(&wheels, 0)?),
        [Rim::External, Rim::Worm] => (Meeting::Worm, worms::couple(&wheels, 1)?),
        rims => {
            let words = toothings.map(|toothing| toothing.form.call.word);
            // The one that has its partner in few others.
            let which = usize::from(matches!(rims[0], Rim::External | Rim::Internal));
            return Err(messages::no_partners([&first.text, &second.text], words, rims[which]));
        }
    };
    if axes_move && meeting != Meeting::Cylinders {
        return Err(messages::moving_axes_of_cylinders(&first.text, &second.text));
    }
    let wheel = usize::from(matches!(first.form.rim, Rim::Internal | Rim::Rack | Rim::Worm));
    let (turns, still) = match mechanism.space {
        Space::Planar if axes_move => (Vec::new(), 0.0),
        Space::Spatial => (found.turns[wheel].clone(), 0.0),
        Space::Planar => cylinders::in_the_plane(
            orientations,
            [1.0, -1.0, 0.0],
            [own[wheel], found.carrier, Frame::Ground],
        ),
    };
    Ok(Pair {
        name: name.clone(),
        on,
        axes_move,
        meeting,
        teeth: toothings.map(|toothing| toothing.teeth),
        carrier: found.carrier,
        between: found.between,
        axes: found.axes,
        beside: found.beside,
        axles: found.axles,
        terms: found.terms,
        travels: found.travels,
        constant: pair::remainder(found.constant),
        wheel,
        turns,
        still,
        first: found.first[wheel],
        psi: found.psi[wheel],
        side: found.side[wheel],
        touch: found.touch,
        follows: None,
    })
}

/// Two toothings of two bodies.
struct Wheels<'m> {
    mechanism: &'m Mechanism,
    orientations: &'m Orientations,
    own: [Frame; 2],
    toothings: [&'m Toothing; 2],
    gives: bool,
    axes_move: bool,
}

/// A sum of angles of joints, and the axis of these.
type Axle = (Vec<(f64, Rotor)>, V3);

/// What a pair couples, and where its centres are.
struct Coupled {
    carrier: Frame,
    between: [f64; 2],
    terms: Vec<(f64, Rotor)>,
    travels: Vec<(f64, JointId)>,
    constant: f64,
    /// Of parallel axes in space: see `Pair::axes`, and by which angles each wheel turns about the last of them.
    axes: Option<[V3; 3]>,
    beside: f64,
    axles: Option<[V3; 2]>,
    turns: [Vec<(f64, Rotor)>; 2],
    /// Of each wheel: see `Pair`.
    first: [f64; 2],
    psi: [f64; 2],
    side: [f64; 2],
    touch: Option<pair::Touch>,
}

impl Wheels<'_> {
    fn texts(&self) -> [&str; 2] {
        self.toothings.map(|toothing| toothing.text.as_str())
    }

    /// Axes that are not parallel are in space.
    fn in_space(&self) -> Result<(), String> {
        match self.mechanism.space {
            Space::Spatial => Ok(()),
            Space::Planar => {
                let words = self.toothings.map(|toothing| toothing.form.call.word);
                Err(messages::axes_out_of_the_plane(self.texts(), words))
            }
        }
    }

    /// What holds both centres, and where these are in it.
    fn held(&self) -> Result<(Frame, [V3; 2]), String> {
        let [first, second] = self.toothings;
        let held = holding::carrier(self.mechanism, [&first.center, &second.center], self.own);
        held.ok_or_else(|| messages::centres_not_held(&first.text, &second.text, self.gives))
    }

    /// In space: by which joints each turns against what holds both.
    fn turning(&self, carrier: Frame) -> Result<[Turn; 2], String> {
        let turns = self.own.map(|wheel| about_axes::turn(self.mechanism, self.orientations, wheel, carrier));
        match turns {
            [Some(first), Some(second)] => Ok([first, second]),
            _ => Err(messages::no_axle(self.texts()[0], self.texts()[1])),
        }
    }

    /// The same where the axes are not parallel: both turn.
    fn axles(&self, carrier: Frame) -> Result<[Axle; 2], String> {
        let [one, other] = self.turning(carrier)?;
        match (one.axis, other.axis) {
            (Some(a), Some(b)) => Ok([(one.terms, a), (other.terms, b)]),
            _ => Err(messages::teeth_on_one_shaft(self.texts()[0], self.texts()[1])),
        }
    }
}

/// Equal terms put together, without those that cancel.
fn collected(all: impl IntoIterator<Item = (f64, Rotor)>) -> Vec<(f64, Rotor)> {
    let mut terms: Vec<(f64, Rotor)> = Vec::new();
    for (factor, rotor) in all {
        match terms.iter_mut().find(|(_, known)| *known == rotor) {
            Some((sum, _)) => *sum += factor,
            None => terms.push((factor, rotor)),
        }
    }
    terms.retain(|(factor, _)| *factor != 0.0);
    terms
}

/// A sum of angles times a number.
fn times(factor: f64, terms: Vec<(f64, Rotor)>) -> impl Iterator<Item = (f64, Rotor)> {
    terms.into_iter().map(move |(own, rotor)| (factor * own, rotor))
}

/// Wheels that turn together count as one. Nothing fixes a pair whose axes move: it counts by itself.
fn row(
    mechanism: &Mechanism,
    orientations: &Orientations,
    (at, pair): (usize, &Pair),
    modules: &[f64],
) -> Row {
    let mut factors: BTreeMap<usize, i64> = BTreeMap::new();
    let mut constant = pair.constant;
    if pair.axes_move {
        factors.insert(usize::MAX - at, 1);
    }
    for (factor, rotor) in &pair.terms {
        let key = match rotor {
            Rotor::Body(body) => {
                let (class, angle) = orientations.class(Frame::Body(*body));
                constant -= factor * angle;
                class
            }
            Rotor::Joint(joint, _) => mechanism.bodies.len() + 1 + joint.0,
        };
        *factors.entry(key).or_default() += *factor as i64;
    }
    // A travel counts in half modules of its rack: those of one rail and one module are the same.
    for (factor, joint) in &pair.travels {
        let module = mechanism.toothing(pair.on[1 - pair.wheel]).module;
        let joints = mechanism.bodies.len() + 1 + mechanism.joints.len();
        let key = joints
            + joint.0
            + mechanism.joints.len() * modules.iter().position(|it| *it == module).unwrap_or(0);
        *factors.entry(key).or_default() += libm::round(0.5 * module * factor) as i64;
    }
    Row { factors, constant }
}

/// A loop of wheels whose teeth do not meet; of planets between two wheels on one axis with how many would.
fn not_assembled(
    mechanism: &Mechanism,
    pairs: &[Pair],
    at: usize,
    of: &[(usize, f64)],
    apart: f64,
) -> String {
    let mut loop_of: Vec<&str> = of.iter().map(|(pair, _)| pairs[*pair].name.text.as_str()).collect();
    loop_of.push(&pairs[at].name.text);
    let name = &pairs[at].name.text;
    // A sun, a ring and planets of one size: (z_s + z_r)/n is whole for planets that stand equally apart.
    let toothings = pairs.iter().flat_map(|pair| pair.on).map(|id| mechanism.toothing(id));
    let mut sun_and_ring = [None, None];
    for toothing in toothings {
        if toothing.is_internal() {
            sun_and_ring[1] = Some(toothing.teeth);
        }
    }
    let planets: Vec<ToothingId> = pairs
        .iter()
        .filter(|pair| pair.on.iter().any(|id| mechanism.toothing(*id).is_internal()))
        .flat_map(|pair| pair.on)
        .filter(|id| !mechanism.toothing(*id).is_internal())
        .collect();
    for pair in pairs {
        for [one, other] in [[pair.on[0], pair.on[1]], [pair.on[1], pair.on[0]]] {
            if planets.contains(&one) && !mechanism.toothing(other).is_internal() {
                sun_and_ring[0] = Some(mechanism.toothing(other).teeth);
            }
        }
    }
    match sun_and_ring {
        [Some(sun), Some(ring)] if planets.len() > 1 => {
            messages::planets_not_assembled(name, apart, sun, ring, planets.len())
        }
        _ => messages::loop_not_assembled(name, &loop_of, apart),
    }
}
