//! Beams in the plane, in a floating frame of reference: where places on the axis are, and what mass spread along it adds to M, to the
//! inertia forces and to the energies.
//!
//! A material point at x is at R + A F(x) with F = Σ_i φ_i(x) w_i in the frame's axes: φ₀ = x along e₁, and a mode's shape φ_j along e₁
//! or e₂ times p_j. So F, its columns F_ω = e₃ × F and F_j = φ_j e, and its accelerations are fields of one kind, and every integral over
//! the mass is one of a few constants: ∫ φ_i and ∫ φ_i φ_k (Shabana, *Dynamics of Multibody Systems*, 5.5, the inertia shape integrals).
//! M and the inertia forces are those of any mass, M_kl = ∫ u_k·u_l, −∫ u_k·a, where R may move with anything. What bending draws in
//! is in `stiffening`: fields too, whose columns move.

mod means;
mod stiffening;
mod turning;

use super::inertia::{Factor, Massive, Sums};
use super::kinematics::{FrameId, Kinematics, LocalVector};
use super::vector::{self, Pair};
use crate::beams::{Slender, Way};
use crate::equations::elastic::{damping, stiffness};
use crate::equations::jet::{Jet, Moving};
use crate::equations::laws::Laws;
use crate::model::{Beam, BodyId, Frame, Place};
use crate::symbolic::{Node, On, Scalar, Sheet};
use means::Integrals;
use std::collections::BTreeMap;
use std::sync::Arc;
use turning::Turn;
pub(super) use turning::twice_turning_of_slices;

/// The modes of a body and how they move.
#[derive(Clone, Debug)]
pub struct Flexible {
    pub slender: Arc<Slender>,
    pub modes: Vec<Modal>,
}

/// A mode's coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Modal {
    pub value: Node,
    pub rate: Node,
    pub motion: ModalMotion,
}

#[derive(Clone, Copy, Debug)]
pub enum ModalMotion {
    /// With a velocity of this index.
    Free(usize),
    /// As given: its acceleration.
    Given(Node),
}

/// Σ φ_i w_i in the axes of one frame, by the index of φ in [`Means`](crate::equations::means::Means).
#[derive(Clone, Debug, Default)]
pub struct Field {
    parts: Vec<(usize, Pair)>,
}

impl Flexible {
    /// A place on the axis given by x, in the axes of the body, as it is deformed.
    pub fn place<'g>(&self, at: On<'g, Pair>) -> LocalVector {
        let g = at.g;
        let mut vector = LocalVector::fixed(at);
        let Some(x) = at.parts()[0].value() else { return vector };
        let add = |sum: &mut Pair, part: On<'g, Pair>| *sum = (g.on(*sum) + part).bare;
        for (index, shape) in
            self.slender.values(x).into_iter().enumerate().filter(|(_, shape)| *shape != 0.0)
        {
            let direction = g.number(shape) * self.axis(g, index);
            let modal = self.modes[index];
            add(&mut vector.at, g.on(modal.value) * direction);
            match modal.motion {
                ModalMotion::Free(velocity) => {
                    vector.slides.insert(velocity, direction.bare);
                }
                ModalMotion::Given(acceleration) => {
                    add(&mut vector.drift, g.on(modal.rate) * direction);
                    add(&mut vector.drift_rate, g.on(acceleration) * direction);
                }
            }
        }
        self.shorten(g, x, &mut vector);
        vector
    }

    /// The coordinate of a mode.
    fn moving<'g>(&self, kinematics: On<'g, &'g Kinematics>, mode: usize) -> Moving<'g> {
        let (g, modal) = (kinematics.g, self.modes[mode]);
        let mut jet = Jet::constant(g.on(modal.value));
        match modal.motion {
            ModalMotion::Free(velocity) => {
                jet.columns.insert(velocity, g.one().bare);
            }
            ModalMotion::Given(acceleration) => (jet.drift, jet.bias) = (modal.rate, acceleration),
        }
        kinematics.moving(&kinematics.bare.velocities, jet)
    }

    /// Along which of the frame's axes a mode moves.
    fn axis<'g>(&self, g: Sheet<'g>, mode: usize) -> On<'g, Pair> {
        vector::axis(g, self.slender.modes[mode].way.axis())
    }
}

impl Field {
    fn perpendicular(&self, g: Sheet) -> Self {
        self.map(|w| g.on(w).perpendicular().bare)
    }

    fn map(&self, f: impl Fn(Pair) -> Pair) -> Self {
        Field { parts: self.parts.iter().map(|(index, w)| (*index, f(*w))).collect() }
    }

    fn and(mut self, other: Self) -> Self {
        self.parts.extend(other.parts);
        self
    }
}

/// A beam with its mass, in the frame it turns with.
struct Spread<'b, 'g> {
    body: &'b Massive<'g>,
    flexible: &'g Flexible,
    frame: FrameId,
    /// (cos, sin) of its axes within that frame.
    offset: On<'g, Pair>,
    means: Integrals<'g>,
}

impl<'b, 'g> Spread<'b, 'g> {
    fn all(kinematics: On<'g, &'g Kinematics>, bodies: &'b [Massive<'g>]) -> Vec<Self> {
        let mut spread = Vec::new();
        for (body, placement) in bodies.iter().zip(&kinematics.bare.bodies) {
            if let Some(flexible) = &placement.flexible {
                let offset = kinematics.g.on(placement.offset);
                let means = Integrals::new(kinematics.g, flexible);
                spread.push(Spread { body, flexible, frame: placement.frame, offset, means });
            }
        }
        spread
    }

    /// φ_j along the axis of a mode.
    fn shape(&self, mode: usize) -> Field {
        let axis = self.flexible.axis(self.offset.g, mode).turned(self.offset);
        Field { parts: vec![(mode + 1, axis.bare)] }
    }

    /// F_j.
    fn column(&self, mode: usize) -> Field {
        self.shape(mode).and(self.drawn_in_by(mode))
    }

    /// Σ F_j c_j.
    fn modal(&self, coefficients: impl Fn(&Modal) -> Node) -> Field {
        self.sum(coefficients, |mode| self.column(mode))
    }

    fn sum(&self, coefficients: impl Fn(&Modal) -> Node, of: impl Fn(usize) -> Field) -> Field {
        let g = self.offset.g;
        let modes = self.flexible.modes.iter().enumerate();
        let scaled = modes.map(|(mode, modal)| {
            let coefficient = g.on(coefficients(modal));
            of(mode).map(|w| (coefficient * g.on(w)).bare)
        });
        scaled.fold(Field::default(), Field::and)
    }

    /// F.
    fn position(&self) -> Field {
        let g = self.offset.g;
        let along = vector::axis(g, 0).turned(self.offset);
        let straight = Field { parts: vec![(0, along.bare)] };
        straight.and(self.sum(|modal| modal.value, |mode| self.shape(mode))).and(self.drawn_in())
    }

    /// Ḟ in the frame.
    fn rate(&self) -> Field {
        self.modal(|modal| modal.rate)
    }

    /// ω of the frame, if it turns.
    fn omega(&self, kinematics: On<'g, &'g Kinematics>) -> Option<(usize, Scalar<'g>)> {
        let rate = kinematics.bare.frames[self.frame].rate?;
        Some((rate, kinematics.g.on(kinematics.bare.velocities[rate])))
    }
}

/// Adds what the mass along the beams adds to what it would be at the origins of their frames.
pub(super) fn accumulate<'g>(
    kinematics: On<'g, &'g Kinematics>,
    bodies: &[Massive<'g>],
    gravity: Option<On<'g, Pair>>,
    sums: &mut Sums<'g>,
) {
    let g = kinematics.g;
    for beam in Spread::all(kinematics, bodies) {
        let (mass, frame, flexible) = (beam.body.mass, beam.frame, beam.flexible);
        let position = beam.position();
        let mut columns: Vec<(usize, Field)> = Vec::new();
        let mut turns: Vec<Turn> = Vec::new();
        let mut accelerations: Vec<(Factor, Field)> = Vec::new();
        for (mode, modal) in flexible.modes.iter().enumerate() {
            if let ModalMotion::Free(velocity) = modal.motion {
                columns.push((velocity, beam.column(mode)));
                turns.push(Turn::Mode(mode));
                if beam.omega(kinematics).is_some() {
                    accelerations.push((Factor::Coriolis(velocity), beam.column(mode).perpendicular(g)));
                }
            }
        }
        if !flexible.slender.shortenings.is_empty() {
            accelerations.push((Factor::Explicit, beam.drawn_in_faster()));
        }
        if let Some((rate, _)) = beam.omega(kinematics) {
            columns.push((rate, position.perpendicular(g)));
            turns.push(Turn::Frame);
            accelerations.push((Factor::Centripetal, position.map(|w| (-g.on(w)).bare)));
        }
        // With the origin of the frame, whose own columns may be of the same velocities.
        let origin: Vec<_> = beam.body.center.parts.iter().map(|(frame, it)| (*frame, it.clone())).collect();
        let rigid = super::inertia::columns(kinematics, &origin);
        let pulls = super::inertia::accelerations(kinematics, &origin, gravity);
        let mean = |field: &Field| beam.means.mean(field);
        for (velocity, field) in &columns {
            for other in &rigid {
                let times = if other.velocity == *velocity { 2.0 } else { 1.0 };
                let (own, far) = (times * mass * mean(field), other.u);
                sums.mass(*velocity, other.velocity, (frame, other.frame), own, far);
            }
            for (far, factor, w) in &pulls {
                sums.bias(*velocity, (frame, *far), *factor, mass * mean(field), *w);
            }
        }
        for own in &rigid {
            for (factor, field) in &accelerations {
                let u = mass * g.on(own.u);
                sums.bias(own.velocity, (own.frame, frame), *factor, u, mean(field).bare);
            }
        }
        // Among themselves.
        for (at, (velocity, field)) in columns.iter().enumerate() {
            for (which, (other, far)) in columns[..=at].iter().enumerate() {
                let [dot, _] = beam.means.products(field, far);
                let dot = beam.with_turning(dot, turns[at], turns[which]);
                sums.mass_of(*velocity, *other, frame, mass * dot);
            }
            for (factor, far) in &accelerations {
                // (e₃ × F)·F = 0.
                let turns = beam.omega(kinematics).is_some_and(|(rate, _)| rate == *velocity);
                if turns && *factor == Factor::Centripetal {
                    continue;
                }
                let [dot, _] = beam.means.products(field, far);
                sums.bias_of(*velocity, frame, *factor, mass * dot);
            }
        }
    }
}

/// What T has beyond ½ m |Ṙ|².
pub(super) fn kinetic_energy<'g>(laws: &Laws<'g>, bodies: &[Massive<'g>]) -> Scalar<'g> {
    let (g, kinematics) = (laws.g, laws.plane());
    let mut twice = g.zero();
    for beam in Spread::all(kinematics, bodies) {
        let mut velocity = beam.rate();
        if let Some((_, omega)) = beam.omega(kinematics) {
            let turning = beam.position().perpendicular(g);
            velocity = velocity.and(turning.map(|w| (omega * g.on(w)).bare));
        }
        let [x, y] = kinematics.world(&beam.body.center);
        let mean = kinematics.to_world(beam.frame, beam.means.mean(&velocity));
        let along = mean.dot([x.rate().bare, y.rate().bare]);
        let [square, _] = beam.means.products(&velocity, &velocity);
        let turning = beam.twice_turning(beam.omega(kinematics).map(|(_, omega)| omega));
        twice += beam.body.mass * (2.0 * along + square + turning);
    }
    0.5 * twice
}

/// What the potential of gravity has beyond −m g·R, and ½ pᵀ K p.
pub(super) fn potential_energy<'g>(
    laws: &Laws<'g>,
    bodies: &[Massive<'g>],
    gravity: Option<On<'g, Pair>>,
) -> Scalar<'g> {
    let (g, kinematics) = (laws.g, laws.plane());
    let mut sum = g.zero();
    for beam in Spread::all(kinematics, bodies) {
        if let Some(gravity) = gravity {
            let mean = kinematics.to_world(beam.frame, beam.means.mean(&beam.position()));
            sum -= beam.body.mass * gravity.dot(mean);
        }
    }
    for (index, beam) in laws.mechanism.bodies.iter().enumerate() {
        let (Some(beam), Some(flexible)) = (beam.beam(), &kinematics.bare.bodies[index].flexible) else {
            continue;
        };
        for (mode, modal) in flexible.modes.iter().enumerate() {
            sum += 0.5 * (stiffness(laws, beam, mode) * g.on(modal.value).square());
        }
    }
    sum
}

/// −K p − C ṗ of all modes, by velocity.
pub(super) fn elastic_forces<'g>(laws: &Laws<'g>) -> Vec<(usize, Scalar<'g>)> {
    let (g, kinematics) = (laws.g, laws.plane());
    let mut forces = Vec::new();
    for (index, body) in laws.mechanism.bodies.iter().enumerate() {
        let (Some(beam), Some(flexible)) = (body.beam(), &kinematics.bare.bodies[index].flexible) else {
            continue;
        };
        for (mode, modal) in flexible.modes.iter().enumerate() {
            if let ModalMotion::Free(velocity) = modal.motion {
                let rate = g.on(kinematics.bare.velocities[velocity]);
                let damping = damping(laws, BodyId(index), beam, mode);
                forces.push((velocity, -(stiffness(laws, beam, mode) * modal.value + damping * rate)));
            }
        }
    }
    forces
}

/// m a of the whole beam and its moment about the frame's origin, less what it is with all mass at the origin; `gravity` in world axes.
pub(super) fn inertia_beyond_origin<'g>(
    laws: &Laws<'g>,
    bodies: &[Massive<'g>],
    index: usize,
    acceleration: On<'g, Pair>,
) -> Option<[Scalar<'g>; 3]> {
    let (g, kinematics) = (laws.g, laws.plane());
    kinematics.bare.bodies[index].flexible.as_ref()?;
    let before = kinematics.bare.bodies[..index].iter().filter(|body| body.flexible.is_some()).count();
    let beam = Spread::all(kinematics, bodies).swap_remove(before);
    let accelerations = &laws.symbols.acceleration;
    let position = beam.position();
    let mut local = beam.modal(|modal| match modal.motion {
        ModalMotion::Free(index) => accelerations[index],
        ModalMotion::Given(acceleration) => acceleration,
    });
    local = local.and(beam.drawn_in_faster());
    if let Some((rate, omega)) = beam.omega(kinematics) {
        let scaled = |field: Field, by: Scalar<'g>| field.map(|w| (by * g.on(w)).bare);
        local = local.and(scaled(position.perpendicular(g), g.on(accelerations[rate])));
        local = local.and(scaled(position.clone(), -omega.square()));
        local = local.and(scaled(beam.rate().perpendicular(g), 2.0 * omega));
    }
    let mass = beam.body.mass;
    let force = mass * kinematics.to_world(beam.frame, beam.means.mean(&local));
    let arm = kinematics.to_world(beam.frame, beam.means.mean(&position));
    let [_, moment] = beam.means.products(&position, &local);
    let turning = beam.turning_moment(accelerations, beam.omega(kinematics).map(|(rate, _)| rate));
    let [x, y] = force.parts();
    Some([x, y, mass * (moment + turning + arm.cross(acceleration))])
}

impl<'g> On<'g, &'g Kinematics> {
    /// The coordinate of a mode of a body.
    pub fn mode(self, body: usize, mode: usize) -> Option<Moving<'g>> {
        let flexible = self.bare.bodies.get(body)?.flexible.as_ref()?;
        Some(flexible.moving(self, mode))
    }

    /// How much the section at a place is turned against its body, to first order: Σ N′ p. Nothing where it is not.
    pub fn slope(self, laws: &Laws<'g>, place: &Place) -> Option<Moving<'g>> {
        let Frame::Body(body) = place.frame else { return None };
        let flexible = self.bare.bodies.get(body.0)?.flexible.as_ref()?;
        let x = laws.value(&place.at[0]).value()?;
        let slopes = flexible.slender.slopes(x).into_iter().enumerate().filter(|(_, slope)| *slope != 0.0);
        let terms = slopes.map(|(mode, slope)| slope * flexible.moving(self, mode));
        terms.reduce(|sum, term| sum + term)
    }
}

/// The weights of the rates of modes in that of the section at a place, from the index of the first mode's velocity on.
pub(super) fn slope_weights(
    beam: Option<&Beam>,
    place: &Place,
    first: Option<usize>,
) -> BTreeMap<usize, f64> {
    let (Some(beam), Some(first), crate::model::Expr::Number(x)) = (beam, first, &place.at[0]) else {
        return BTreeMap::new();
    };
    debug_assert!(beam.slender.modes.iter().all(|mode| matches!(mode.way, Way::Axial | Way::Bending)));
    let slopes = beam.slender.slopes(*x).into_iter().enumerate();
    slopes.filter(|(_, slope)| *slope != 0.0).map(|(mode, slope)| (first + mode, slope)).collect()
}
