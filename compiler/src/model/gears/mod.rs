//! Toothings, and what their numbers say of the pairs that mesh: which angles they couple, and with which constant.
//!
//! All of it is known at expansion and independent of how a pair is used: without play by a constraint, or by a load.

mod about_axes;
mod following;
mod holding;
mod lowering;
pub mod meshes;
mod pair;
pub mod stiffness;
mod told;
mod toothing;

pub use lowering::Meshing;
pub use pair::{Mesh, Pair, mesh};
pub use told::Told;
pub use toothing::{Toothing, ToothingId, involute};

use super::{ConstraintKind, Frame, Mechanism, Name, Rotor, Space, Subject};
use crate::diagnostics::Diagnostics;
use crate::messages;
use following::{Row, follow};
use holding::Orientations;
use std::collections::BTreeMap;

impl Mechanism {
    pub fn toothing(&self, id: ToothingId) -> &Toothing {
        &self.bodies[id.body.0].toothings[id.index]
    }

    /// The toothings of a pair, and what follows from their distance.
    pub fn mesh_of(&self, pair: &Pair) -> ([&Toothing; 2], Mesh) {
        let toothings = pair.on.map(|id| self.toothing(id));
        (toothings, mesh(toothings[0], toothings[1], pair.distance()))
    }
}

/// Finds the pairs of a mechanism, and of each constraint and load the number of its own.
pub(super) fn settle(mechanism: &mut Mechanism, diagnostics: &mut Diagnostics) {
    let mut meshing: Vec<(Name, [ToothingId; 2])> = Vec::new();
    for constraint in &mut mechanism.constraints {
        if let ConstraintKind::Teeth { on, pair, .. } = &mut constraint.kind {
            *pair = meshing.len();
            meshing.push((constraint.name.clone(), *on));
        }
    }
    for load in &mut mechanism.loads {
        let ids: Vec<ToothingId> = load.on.iter().filter_map(toothing_of).collect();
        if let (Some(teeth), [first, second]) = (&mut load.teeth, &ids[..]) {
            teeth.pair = meshing.len();
            meshing.push((load.name.clone(), [*first, *second]));
        }
    }
    if meshing.is_empty() {
        return;
    }
    let orientations = Orientations::of(mechanism);
    let mut pairs = Vec::new();
    for (name, on) in meshing {
        match pair(mechanism, &orientations, name.clone(), on) {
            Ok(pair) => pairs.push(pair),
            Err(message) => diagnostics.error(name.span, message),
        }
    }
    if !diagnostics.is_empty() {
        return;
    }
    let rows: Vec<Row> = pairs.iter().map(|pair| row(mechanism, &orientations, pair)).collect();
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

fn pair(
    mechanism: &Mechanism,
    orientations: &Orientations,
    name: Name,
    on: [ToothingId; 2],
) -> Result<Pair, String> {
    let [first, second] = on.map(|id| mechanism.toothing(id));
    let own = on.map(|id| Frame::Body(id.body));
    if on[0].body == on[1].body || orientations.class(own[0]).0 == orientations.class(own[1]).0 {
        return Err(messages::teeth_on_one_shaft(&first.text, &second.text));
    }
    if first.is_internal() && second.is_internal() {
        return Err(messages::two_rings(&first.text, &second.text));
    }
    let held = holding::carrier(mechanism, [&first.center, &second.center], own);
    let Some((carrier, [from, to])) = held else {
        return Err(messages::centres_not_held(&first.text, &second.text));
    };
    let across = [0, 1, 2].map(|k| to[k] - from[k]);
    let sense = if first.is_internal() || second.is_internal() { -1.0 } else { 1.0 };
    let (between, terms, fixed) = match mechanism.space {
        Space::Planar => {
            let factors = [first.teeth, sense * second.teeth, -(first.teeth + sense * second.teeth)];
            let (terms, fixed) = in_the_plane(orientations, factors, [own[0], own[1], carrier]);
            ([across[0], across[1]], terms, fixed)
        }
        Space::Spatial => {
            let turns = own.map(|wheel| about_axes::turn(mechanism, orientations, wheel, carrier));
            let [Some(one), Some(other)] = turns else {
                return Err(messages::no_axle(&first.text, &second.text));
            };
            let (axis, sign) = match (one.axis, other.axis) {
                (Some(a), Some(b)) => match about_axes::parallel(a, b) {
                    Some(sign) => (a, sign),
                    None => return Err(messages::axes_not_parallel(&first.text, &second.text)),
                },
                (Some(axis), None) | (None, Some(axis)) => (axis, 1.0),
                (None, None) => return Err(messages::teeth_on_one_shaft(&first.text, &second.text)),
            };
            let of = |terms: Vec<(f64, Rotor)>, teeth: f64| {
                terms.into_iter().map(move |(factor, rotor)| (factor * teeth, rotor))
            };
            let mut terms: Vec<(f64, Rotor)> = Vec::new();
            for (factor, rotor) in
                of(one.terms, first.teeth).chain(of(other.terms, sign * sense * second.teeth))
            {
                match terms.iter_mut().find(|(_, known)| *known == rotor) {
                    Some((sum, _)) => *sum += factor,
                    None => terms.push((factor, rotor)),
                }
            }
            terms.retain(|(factor, _)| *factor != 0.0);
            (about_axes::across(axis, across), terms, 0.0)
        }
    };
    let constant = pair::facing(first, second, between) - fixed;
    let wheel = usize::from(first.is_internal());
    let (turns, still) = match mechanism.space {
        Space::Planar => in_the_plane(orientations, [1.0, -1.0, 0.0], [own[wheel], carrier, Frame::Ground]),
        // No load between teeth is in space.
        Space::Spatial => (Vec::new(), 0.0),
    };
    Ok(Pair {
        name,
        on,
        teeth: [first.teeth, second.teeth],
        carrier,
        between,
        terms,
        constant: pair::remainder(constant),
        wheel,
        turns,
        still,
        follows: None,
    })
}

/// Factors and angles of what turns against the ground, and what the others are.
fn in_the_plane(
    orientations: &Orientations,
    factors: [f64; 3],
    frames: [Frame; 3],
) -> (Vec<(f64, Rotor)>, f64) {
    let (mut terms, mut fixed) = (Vec::new(), 0.0);
    for (factor, frame) in factors.into_iter().zip(frames) {
        match (frame, orientations.class(frame)) {
            (_, (0, angle)) => fixed += factor * angle,
            (Frame::Body(body), _) if factor != 0.0 => terms.push((factor, Rotor::Body(body))),
            _ => {}
        }
    }
    (terms, fixed)
}

/// Wheels that turn together count as one.
fn row(mechanism: &Mechanism, orientations: &Orientations, pair: &Pair) -> Row {
    let mut factors: BTreeMap<usize, i64> = BTreeMap::new();
    let mut constant = pair.constant;
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
