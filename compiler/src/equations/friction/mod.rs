//! Friction in joints and contacts: what resists the sliding of two surfaces, by the force N that presses them together, which is the
//! reaction that the joint has, or what the contact exerts.
//!
//! ```text
//! F = N p(v) + o(v)    against each component of the sliding v (N or N m; N in N)
//! ```
//! N is a symbol here, one for each friction that has one, and Q is affine in these symbols. What N is in v̇ and λ stands in
//! `normal`, what it is for a state in `solve::friction`. N of a contact is its law, which is a function of the state. One file for each law
//! p, o; what slides, and what presses, is `bearing` in joints and `touching` in contacts.

mod asperity;
mod bearing;
mod bristles;
mod coulomb;
mod dry;
mod lugre;
mod magnitudes;
mod normal;
mod stribeck;
mod touching;

pub use dry::{bounds, shares, slidings};
pub use normal::{Friction, closed, friction, symbols};

use super::jet::{Jet, Moving};
use super::laws::Laws;
use super::loads::{LoadKind, LoadTerms, along};
use crate::model::Load;
use crate::symbolic::{Compare, Node, Scalar};

/// The laws of friction, which the plane and space have in common.
pub static LAWS: &[&LoadKind] = &[&coulomb::LOAD, &stribeck::LOAD, &lugre::LOAD, &asperity::LOAD, &dry::LOAD];

/// p and o of each component of a sliding v: rad/s where the surfaces turn on each other, else m/s. Laws that remember have a
/// deflection z of each component too.
type Resistance = for<'g> fn(&Laws<'g>, &Load, v: &[Scalar<'g>], z: &[Scalar<'g>]) -> Vec<[Scalar<'g>; 2]>;

/// −(N a p + o) along each of the coordinates that slide, a being the radius of what turns; and where a length of surface
/// turns and shifts, by the same law along both.
fn terms<'g>(laws: &Laws<'g>, load: &Load, resistance: Resistance) -> LoadTerms<'g> {
    slips(laws, load).into_iter().zip(deflections(laws, load)).fold(
        LoadTerms::none(laws),
        |sum, (slip, z)| {
            let efforts = slip.efforts(laws, load, &z, resistance);
            slip.along
                .iter()
                .zip(efforts)
                .fold(sum, |sum, ((coordinate, _), effort)| sum.and(along(coordinate, effort)))
        },
    )
}

/// What it exerts along the first coordinate that slides.
fn effort<'g>(laws: &Laws<'g>, load: &Load, resistance: Resistance) -> Scalar<'g> {
    let mut slips = slips(laws, load);
    if load.contact().is_none() {
        slips.truncate(1);
    }
    // Each gap of a contact slides along one of its own.
    let first =
        |(slip, z): (&Slip<'g>, Vec<Scalar<'g>>)| slip.efforts(laws, load, &z, resistance).first().copied();
    laws.g.sum(slips.iter().zip(deflections(laws, load)).filter_map(first))
}

/// z of each slip, as many as it has components; none where the law does not remember.
fn deflections<'g>(laws: &Laws<'g>, load: &Load) -> Vec<Vec<Scalar<'g>>> {
    let mut states = laws.states(load).into_iter();
    slips(laws, load).iter().map(|slip| states.by_ref().take(slip.along.len()).collect()).collect()
}

/// N, the preload included.
pub fn pressed<'g>(laws: &Laws<'g>, load: &Load) -> Scalar<'g> {
    if let Some(contact) = load.contact() {
        let contact = &laws.mechanism.loads[contact.0];
        return laws.g.sum(contact.law.iter().map(|force| touching::pressing(laws, contact, force)));
    }
    let own = load.normal.and_then(|which| laws.symbols.normals.get(which));
    let own = own.map_or_else(|| laws.g.zero(), |own| laws.g.on(*own));
    own + laws.value(load.named("preload"))
}

/// What slides as one: coordinates whose rates, each times its lever, are the components of v.
struct Slip<'g> {
    along: Vec<(Moving<'g>, Scalar<'g>)>,
    /// What N acts by: the radius where v is an angular velocity, else 1.
    radius: Scalar<'g>,
    /// N, N.
    pressed: Scalar<'g>,
    /// In the contacts of space the direction of which v has no part.
    normal: Vec<Scalar<'g>>,
    /// Of a contact, whether it is closed.
    closed: Option<Scalar<'g>>,
}

/// What a friction brakes: coordinates whose rates, each times its lever, are the components of one sliding.
pub struct Braked {
    pub along: Vec<Jet>,
    pub levers: Vec<Node>,
    /// What N acts by.
    pub arm: Node,
    /// N.
    pub pressed: Node,
}

pub fn braked(laws: &Laws, load: &Load) -> Vec<Braked> {
    let of = |slip: Slip| Braked {
        along: slip.along.iter().map(|(coordinate, _)| coordinate.jet.clone()).collect(),
        levers: slip.along.iter().map(|(_, lever)| lever.bare).collect(),
        arm: slip.radius.bare,
        pressed: slip.pressed.bare,
    };
    slips(laws, load).into_iter().map(of).collect()
}

fn slips<'g>(laws: &Laws<'g>, load: &Load) -> Vec<Slip<'g>> {
    match load.contact() {
        Some(contact) => touching::slips(laws, &laws.mechanism.loads[contact.0]),
        None => bearing::slips(laws, load),
    }
}

/// The sliding of a contact: of one of its gaps, else of the deepest; along an axis of the world, or 0 where there is one.
pub fn sliding<'g>(laws: &Laws<'g>, contact: &Load, which: Option<usize>, axis: usize) -> Scalar<'g> {
    let slips = contact.slides.iter().map(|sliding| touching::slip(laws, sliding).sliding());
    let along = slips.map(|v| v.get(axis).copied().unwrap_or_else(|| laws.g.zero()));
    let mut all = contact.along().map(|gap| laws.value(gap)).zip(along);
    let found = match which {
        Some(which) => all.nth(which),
        None => all.reduce(|(gap, v), (other, own)| {
            (gap.min(other), other.compare(Compare::Less, gap).select(own, v))
        }),
    };
    found.map_or_else(|| laws.g.zero(), |(_, v)| v)
}

impl<'g> Slip<'g> {
    /// v.
    fn sliding(&self) -> Vec<Scalar<'g>> {
        let rates: Vec<Scalar> =
            self.along.iter().map(|(coordinate, lever)| *lever * coordinate.rate()).collect();
        touching::beside(&self.normal, rates)
    }

    fn efforts(
        &self,
        laws: &Laws<'g>,
        load: &Load,
        z: &[Scalar<'g>],
        resistance: Resistance,
    ) -> Vec<Scalar<'g>> {
        let resisted = resistance(laws, load, &self.sliding(), z);
        let efforts = self.along.iter().zip(resisted);
        let own = |o: Scalar<'g>| self.closed.map_or(o, |closed| closed.select(o, laws.g.zero()));
        efforts.map(|((_, lever), [p, o])| -(*lever * (self.pressed * (self.radius * p) + own(o)))).collect()
    }
}

/// v/√(v·v + v_s²): of one root, smooth, and as good as the direction of v well above v_s.
fn direction<'g>(v: &[Scalar<'g>], speed: Scalar<'g>) -> Vec<Scalar<'g>> {
    let inverse = size(v, speed).reciprocal();
    v.iter().map(|v| *v * inverse).collect()
}

/// √(v·v + v_s²).
fn size<'g>(v: &[Scalar<'g>], speed: Scalar<'g>) -> Scalar<'g> {
    v.iter().fold(speed.square(), |sum, v| sum + v.square()).sqrt()
}
