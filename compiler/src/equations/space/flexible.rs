//! Beams in space, in a floating frame of reference: where their places and sections are, and what their mass has beyond that of a rigid
//! body at the instant.
//!
//! A material point at x is, from the origin of the link in its axes, at Σ_i φ_i w_i: φ = 1 along what leads to the body's origin, x along
//! e₁, and the shape N_j of a mode along e_j times p_j. With m the mass and C_ik the mean of φ_i φ_k over it (the inertia shape integrals,
//! Shabana, *Dynamics of Multibody Systems*, 5.5) all integrals are sums of h_i = Σ_k C_ik w_k:
//!   first moment m h₁, second moments m Σ w_i h_iᵀ, and of a mode the force m C_j1 e_j and the moment m h_j × e_j about the origin.
//! With stiffening there are the functions D_j and E of [`Means`] too, along e₁. What M leaves of the inertia forces while the modes move is 2 ω × ẇ + ẅ at every point; all else is what the rigid body of the instant
//! has, which `dynamics` knows.
//!
//! Sections that twist by Σ N_t p_t turn by that rate more about e₁, with the moment of inertia about the axis of each, to which the turns of
//! bending add nothing (no rotary inertia): T = ½ ∫ j (e₁·ω + Σ N_t ṗ_t)² dx, so that with the means ν_j of N_j and ν_jk of N_j N_k and J = ∫ j dx
//! the body is given the moment J (ν_j p̈_j e₁ + ν_j ṗ_j ω × e₁) and the mode J (ν_j e₁·α + ν_jk p̈_k).
//!
//! A section is turned by φ = (Σ N_t p_t, −Σ N′ p_z, Σ N′ p_y), which the theory knows to first order. What is carried has to be turned by a
//! rotation, of which here Cayley's has this first order, without trigonometry: with c = φ/2
//!   R = 1 + 2 (c̃ + c̃²)/(1 + c²),  ω = (φ̇ − c × φ̇)/(1 + c²) in the axes of the section
//! (Géradin, Cardona, *Flexible Multibody Dynamics*, 4.6, Rodrigues parameters).

use super::dynamics::LinkMotion;
use super::kinematics::Kinematics;
use super::links::{Link, LinkId, Motion, Placement};
use super::tensor::{Distribution, ENTRIES, Symmetric};
use super::vector::{self, Mat3, Vec3};
use super::vector_jet::VectorJet;
use crate::beams::{Slender, Way};
use crate::equations::jet::{Jet, Moving};
use crate::equations::means::{Bent, Means};
use crate::equations::{Laws, elastic};
use crate::model::{BodyId, Frame, Mechanism};
use crate::symbolic::{Node, On, Scalar, Sheet};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The modes of a body.
#[derive(Clone, Debug)]
pub struct Flexible {
    pub slender: Arc<Slender>,
    pub modes: Vec<Modal>,
}

/// The coordinate of a mode, and the index of its velocity.
#[derive(Clone, Copy, Debug)]
pub struct Modal {
    pub value: Node,
    pub velocity: usize,
}

impl Flexible {
    /// The modes with a part in something, and that part times a sign.
    fn parts(&self, of: Vec<f64>, sign: f64) -> impl Iterator<Item = (Way, Modal, f64)> {
        let modes = self.slender.modes.iter().zip(&self.modes).zip(of);
        modes
            .filter(|(_, part)| *part != 0.0)
            .map(move |((mode, modal), part)| (mode.way, *modal, sign * part))
    }

    /// How a place is moved from where it is straight, in the axes of the body; `None` where it stays.
    pub fn shift<'g>(&self, g: Sheet<'g>, velocities: &[Node], x: f64, sign: f64) -> Option<Motion> {
        let (mut offset, mut bias) = (vector::zero(g), vector::zero(g));
        let mut along: BTreeMap<usize, On<'g, Vec3>> = BTreeMap::new();
        let mut add = |velocity: usize, axis: On<'g, Vec3>| {
            let sum = along.get(&velocity).map_or(axis, |known| *known + axis);
            along.insert(velocity, sum);
        };
        for (way, modal, part) in self.parts(self.slender.values(x), sign) {
            let axis = part * vector::unit(g, way.axis());
            offset += g.on(modal.value) * axis;
            add(modal.velocity, axis);
        }
        // −½ pᵀ Γ p along the axis, its columns −Γ p, and −ṗᵀ Γ ṗ.
        for (pair, gamma) in self.slender.shortenings.iter().zip(self.slender.shortenings_at(x)) {
            let (j, k) = pair.modes;
            let (one, other) = (self.modes[j], self.modes[k]);
            let axis = -sign * gamma * vector::unit(g, 0);
            let times = if j == k { 0.5 } else { 1.0 };
            let rates = g.on(velocities[one.velocity]) * velocities[other.velocity];
            offset += times * (g.on(one.value) * other.value) * axis;
            bias += 2.0 * times * rates * axis;
            add(one.velocity, g.on(other.value) * axis);
            if j != k {
                add(other.velocity, g.on(one.value) * axis);
            }
        }
        let along: Vec<(usize, Vec3)> =
            along.into_iter().filter(|(_, axis)| !axis.is_zero()).map(|(k, axis)| (k, axis.bare)).collect();
        (!along.is_empty()).then_some(Motion::Shift { offset: offset.bare, along, bias: bias.bare })
    }

    /// How a section is turned against its place in the straight beam, or back; `None` where it keeps its direction.
    pub fn lean<'g>(&self, g: Sheet<'g>, velocities: &[Node], x: f64, sign: f64) -> Option<Motion> {
        let (mut half, mut rate, mut turns) = (vector::zero(g), vector::zero(g), Vec::new());
        for (way, modal, slope) in self.parts(self.slender.slopes(x), sign) {
            // What rises along y turns about z, what rises along z back about y, what twists about x.
            let about = match way {
                Way::Axial => continue,
                Way::Torsion => slope * vector::unit(g, 0),
                Way::Bending => slope * vector::unit(g, 2),
                Way::BendingZ => -slope * vector::unit(g, 1),
            };
            half += g.on(modal.value) * (0.5 * about);
            rate += g.on(velocities[modal.velocity]) * about;
            turns.push((modal.velocity, about));
        }
        if turns.is_empty() {
            return None;
        }
        let over = (1.0 + half.dot(half)).reciprocal();
        let swept = |turn: On<'g, Vec3>| over * (turn - half.cross(turn));
        let bias = -(over * half.dot(rate) * swept(rate));
        let about = turns.iter().map(|(velocity, turn)| (*velocity, swept(*turn).bare)).collect();
        Some(Motion::Lean { matrix: cayley(half, over), about, bias: bias.bare })
    }

    /// A point of the body on its link, which is at `fixed` while the beam is straight.
    pub fn moved<'g>(
        &self,
        kinematics: On<'g, &'g Kinematics>,
        placement: &Placement,
        at: On<'g, Vec3>,
        fixed: VectorJet,
    ) -> VectorJet {
        let g = kinematics.g;
        let shift = |x: f64| self.shift(g, &kinematics.bare.velocities, x, 1.0);
        let Some(Motion::Shift { offset, along, bias }) = at.at(0).value().and_then(shift) else {
            return fixed;
        };
        let turned = |w: Vec3| placement.axes * g.on(w);
        let columns: Vec<(usize, On<Vec3>)> =
            along.into_iter().map(|(velocity, axis)| (velocity, turned(axis))).collect();
        let rates =
            columns.iter().map(|(velocity, axis)| g.on(kinematics.bare.velocities[*velocity]) * *axis);
        let rate = rates.fold(vector::zero(g), |sum, rate| sum + rate);
        VectorJet {
            value: (g.on(fixed.value) + turned(offset)).bare,
            columns: columns.into_iter().map(|(velocity, axis)| (velocity, axis.bare)).collect(),
            rate: rate.bare,
            bias: turned(bias).bare,
            ..fixed
        }
    }
}

/// 1 + 2 (c̃ + c̃²)/(1 + c²), with `over` = 1/(1 + c²).
fn cayley<'g>(half: On<'g, Vec3>, over: Scalar<'g>) -> Mat3 {
    let g = half.g;
    let column = |k: usize| {
        let unit = vector::unit(g, k);
        let once = half.cross(unit);
        let both = once + half.cross(once);
        (unit + 2.0 * over * both).bare
    };
    vector::transposed(&[0, 1, 2].map(column))
}

impl Kinematics {
    /// Makes the sections of a beam at the places that are named or joined.
    pub fn add_sections(&mut self, g: Sheet, mechanism: &Mechanism, body: BodyId, placement: &Placement) {
        let Some(flexible) = &placement.flexible else { return };
        let joints = mechanism.joints.iter().flat_map(|joint| [&joint.first, &joint.second]);
        let joined = joints.filter(|place| place.frame == Frame::Body(body)).map(|place| &place.at);
        let named = mechanism.bodies[body.0].points.iter().map(|point| &point.at);
        for at in joined.chain(named) {
            let crate::model::Expr::Number(x) = at[0] else { continue };
            let key = (body.0, x.to_bits());
            if self.sections.contains_key(&key) {
                continue;
            }
            let along = x * vector::unit(g, 0);
            let foot = Link {
                at: g.on(placement).point(along).bare,
                axes: placement.axes,
                ..Link::still(g, placement.link)
            };
            let motion = flexible.shift(g, &self.velocities, x, 1.0).unwrap_or(Motion::None);
            let mut last = self.push(Link { motion, ..foot });
            if let Some(motion) = flexible.lean(g, &self.velocities, x, 1.0) {
                last = self.push(Link { motion, ..Link::still(g, last) });
            }
            self.sections.insert(key, last);
        }
    }

    pub fn push(&mut self, link: Link) -> LinkId {
        self.links.push(link);
        self.links.len() - 1
    }
}

impl<'g> On<'g, &'g Kinematics> {
    /// The coordinate of a mode of a body.
    pub fn mode(self, body: usize, mode: usize) -> Option<Moving<'g>> {
        let modal = self.bare.bodies.get(body)?.flexible.as_ref()?.modes[mode];
        let mut jet = Jet::constant(self.g.on(modal.value));
        jet.columns.insert(modal.velocity, self.g.one().bare);
        Some(self.moving(&self.bare.velocities, jet))
    }
}

/// Σ φ_i w_i in the axes of a link about its origin, by the number of φ_i: 1, and behind it those of [`Means`].
type Field<'g> = Vec<(usize, On<'g, Vec3>)>;

/// A mode with what belongs to it.
pub struct Share<'g> {
    pub velocity: usize,
    rate: Scalar<'g>,
    /// N_j e_j, and D_j e₁ of what bending draws in.
    column: Field<'g>,
    /// Of a mode in torsion: which it is.
    twist: Option<usize>,
}

/// A beam with its mass, on its link.
pub struct Spread<'g> {
    pub link: LinkId,
    mass: Scalar<'g>,
    /// About its own axis, kg m².
    spin: Scalar<'g>,
    along: On<'g, Vec3>,
    means: Means<'g>,
    position: Field<'g>,
    pub shares: Vec<Share<'g>>,
    /// E e₁.
    faster: Field<'g>,
}

impl<'g> Spread<'g> {
    /// The beams among the bodies.
    pub fn all(laws: &Laws<'g>, kinematics: On<'g, &'g Kinematics>) -> Vec<Self> {
        let mut all = Vec::new();
        for (index, placement) in kinematics.bare.bodies.iter().enumerate() {
            let body = &laws.mechanism.bodies[index];
            if let (Some(flexible), Some(beam)) = (&placement.flexible, &body.beam) {
                let mass = laws.value(&body.mass);
                let spin = mass * laws.value(&beam.spin);
                all.push(Self::new(kinematics, placement, flexible, mass, spin));
            }
        }
        all
    }

    /// With the axes and the origin of a placement.
    pub fn new(
        kinematics: On<'g, &'g Kinematics>,
        placement: &Placement,
        flexible: &'g Flexible,
        mass: Scalar<'g>,
        spin: Scalar<'g>,
    ) -> Self {
        let g = kinematics.g;
        let slender = &*flexible.slender;
        let axes = g.on(placement.axes);
        let (along, modes) = (axes.column(0), flexible.modes.len());
        let rate_of = |modal: &Modal| kinematics.bare.velocities[modal.velocity];
        let bent = flexible.modes.iter().map(|modal| Bent { value: modal.value, rate: rate_of(modal) });
        let bent: Vec<Bent> = bent.collect();
        let stiffens = !slender.shortenings.is_empty();
        let mut position = vec![(0, g.on(placement.at)), (1, along)];
        let mut shares = Vec::new();
        for (mode, modal) in flexible.modes.iter().enumerate() {
            let way = slender.modes[mode].way;
            let (velocity, rate) = (modal.velocity, g.on(rate_of(modal)));
            if way == Way::Torsion {
                shares.push(Share { velocity, rate, column: Vec::new(), twist: Some(mode) });
                continue;
            }
            let axis = axes.column(way.axis());
            position.push((2 + mode, g.on(modal.value) * axis));
            let mut column = vec![(2 + mode, axis)];
            if stiffens && way.bends() {
                let drawn = 2 + modes + mode;
                position.push((drawn, 0.5 * (g.on(modal.value) * along)));
                column.push((drawn, along));
            }
            shares.push(Share { velocity, rate, column, twist: None });
        }
        let faster = if stiffens { vec![(2 + 2 * modes, along)] } else { Vec::new() };
        let means = Means::new(g, slender, &bent);
        Spread { link: placement.link, mass, spin, along, means, position, shares, faster }
    }

    fn mean(&self, i: usize, k: usize) -> Scalar<'g> {
        match (i, k) {
            (0, 0) => self.mass.g.one(),
            (0, k) | (k, 0) => self.means.first(k - 1),
            (i, k) => self.means.second(i - 1, k - 1),
        }
    }

    /// h = Σ_k C_ik w_k of a field.
    fn h(&self, i: usize, field: &Field<'g>) -> On<'g, Vec3> {
        let terms = field.iter().filter_map(|(k, w)| {
            let mean = self.mean(i, *k);
            (!mean.is_zero()).then(|| mean * *w)
        });
        terms.fold(vector::zero(self.mass.g), |sum, term| sum + term)
    }

    fn dot(&self, one: &Field<'g>, other: &Field<'g>) -> Scalar<'g> {
        self.mass.g.sum(one.iter().map(|(i, u)| u.dot(self.h(*i, other))))
    }

    fn cross(&self, one: &Field<'g>, other: &Field<'g>) -> On<'g, Vec3> {
        let terms = other.iter().map(|(k, w)| self.h(*k, one).cross(*w));
        terms.fold(vector::zero(self.mass.g), |sum, term| sum + term)
    }

    /// Σ c_j (N_j e_j + D_j e₁).
    fn modal(&self, of: impl Fn(&Share<'g>) -> Scalar<'g>) -> Field<'g> {
        let scaled = |share: &Share<'g>| -> Field<'g> {
            share.column.iter().map(|(k, w)| (*k, of(share) * *w)).collect()
        };
        self.shares.iter().flat_map(scaled).collect()
    }

    fn rates(&self) -> Field<'g> {
        self.modal(|share| share.rate)
    }

    /// The rigid body of the instant about the origin of the link.
    pub fn distribution(&self) -> On<'g, Distribution> {
        let g = self.mass.g;
        let h: Vec<On<Vec3>> = self.position.iter().map(|(i, _)| self.h(*i, &self.position)).collect();
        let second = |a: usize, b: usize| {
            let terms = self.position.iter().zip(&h);
            g.sum(terms.map(|((_, w), h)| w.at(a) * h.at(b)))
        };
        let squares = [0, 1, 2].map(|k| second(k, k));
        let inertia = Symmetric::of(g, |k| {
            let (i, j) = ENTRIES[k];
            let spin = self.spin * (self.along.at(i) * self.along.at(j));
            if i == j {
                self.mass * (squares[(k + 1) % 3] + squares[(k + 2) % 3]) + spin
            } else {
                spin - self.mass * second(i, j)
            }
        });
        let first = self.mass * h[0];
        g.on(Distribution { mass: self.mass.bare, first: first.bare, inertia: inertia.bare })
    }

    /// Twice the energy with which a section turns about its axis, were it as heavy as the whole: the link turns by ω, and modes in torsion have
    /// these values at the section.
    pub fn twice_about_axis(&self, omega: On<'g, Vec3>, values: &[f64]) -> Scalar<'g> {
        let twisting = self.shares.iter().zip(values).filter(|(share, _)| share.twist.is_some());
        let rate = twisting.fold(self.along.dot(omega), |sum, (share, value)| sum + *value * share.rate);
        self.spin * rate.square()
    }

    /// ν_j of a mode in torsion, else nothing.
    fn twist(&self, share: &Share<'g>) -> Scalar<'g> {
        share.twist.map_or(self.mass.g.zero(), |mode| self.means.first(1 + mode))
    }

    /// ν_jk of two modes in torsion, else nothing.
    fn both_twist(&self, one: &Share<'g>, other: &Share<'g>) -> Scalar<'g> {
        let both = one.twist.zip(other.twist);
        both.map_or(self.mass.g.zero(), |(j, k)| self.means.second(1 + j, 1 + k))
    }

    /// Moment about the origin of the link and force of a mode that is accelerated by one.
    pub fn column(&self, share: &Share<'g>) -> [On<'g, Vec3>; 2] {
        let (moment, force) = (self.cross(&self.position, &share.column), self.h(0, &share.column));
        [self.mass * moment + (self.spin * self.twist(share)) * self.along, self.mass * force]
    }

    /// M of two modes.
    pub fn mass_of(&self, one: &Share<'g>, other: &Share<'g>) -> Scalar<'g> {
        self.mass * self.dot(&one.column, &other.column) + self.spin * self.both_twist(one, other)
    }

    /// What moves within the link: 2 ω × ẇ + ẅ at every point, in two parts.
    fn moving(&self, accelerations: Option<&[Node]>) -> [Field<'g>; 2] {
        let mut own = self.faster.clone();
        if let Some(a) = accelerations {
            own.extend(self.modal(|share| self.mass.g.on(a[share.velocity])));
        }
        [self.rates(), own]
    }

    /// What the mass on a link in motion needs beyond the rigid body of the instant, moment and force.
    pub fn beyond(&self, motion: &LinkMotion<'g>, accelerations: Option<&[Node]>) -> [On<'g, Vec3>; 2] {
        let [rates, own] = self.moving(accelerations);
        let coriolis: Field<'g> = rates.iter().map(|(k, w)| (*k, 2.0 * motion.omega.cross(*w))).collect();
        let force = self.h(0, &coriolis) + self.h(0, &own);
        let moment = self.cross(&self.position, &coriolis) + self.cross(&self.position, &own);
        let turning = self.turning(|share| share.rate);
        let mut about = turning * motion.omega.cross(self.along);
        if let Some(a) = accelerations {
            about += self.turning(|share| self.mass.g.on(a[share.velocity])) * self.along;
        }
        [self.mass * moment + self.spin * about, self.mass * force]
    }

    /// Force along each mode that the motion of the link and of the modes needs.
    pub fn forces(
        &self,
        motion: &LinkMotion<'g>,
        accelerations: Option<&[Node]>,
    ) -> Vec<(usize, Scalar<'g>)> {
        let [rates, own] = self.moving(accelerations);
        let force = |share: &Share<'g>| {
            if share.twist.is_some() {
                let mut sum = self.twist(share) * self.along.dot(motion.alpha);
                if let Some(a) = accelerations {
                    let both = |its: &Share<'g>| self.both_twist(share, its) * a[its.velocity];
                    sum += self.mass.g.sum(self.shares.iter().map(both));
                }
                return (share.velocity, self.spin * sum);
            }
            let mut sum = self.h(0, &share.column).dot(motion.acceleration);
            for (k, w) in &share.column {
                let carried = motion.spin * self.h(*k, &self.position);
                sum += w.dot(carried + 2.0 * motion.omega.cross(self.h(*k, &rates)));
            }
            (share.velocity, self.mass * (sum + self.dot(&share.column, &own)))
        };
        self.shares.iter().map(force).collect()
    }

    /// What T has beyond that of the rigid body of the instant.
    pub fn kinetic_energy(&self, motion: &LinkMotion<'g>) -> Scalar<'g> {
        let rates = self.rates();
        let mixed =
            motion.velocity.dot(self.h(0, &rates)) + motion.omega.dot(self.cross(&self.position, &rates));
        let turning = self.along.dot(motion.omega) * self.turning(|share| share.rate);
        let pairs = self.shares.iter().flat_map(|one| {
            self.shares.iter().map(move |other| self.both_twist(one, other) * (one.rate * other.rate))
        });
        let twisting = turning + 0.5 * self.mass.g.sum(pairs);
        self.mass * (mixed + 0.5 * self.dot(&rates, &rates)) + self.spin * twisting
    }

    /// Σ ν_j of modes in torsion times these.
    fn turning(&self, of: impl Fn(&Share<'g>) -> Scalar<'g>) -> Scalar<'g> {
        self.mass.g.sum(self.shares.iter().map(|share| self.twist(share) * of(share)))
    }
}

/// −K p − C ṗ of all modes, by velocity.
pub fn elastic_forces<'g>(laws: &Laws<'g>, kinematics: On<'g, &'g Kinematics>) -> Vec<(usize, Scalar<'g>)> {
    let mut forces = Vec::new();
    for (index, body) in laws.mechanism.bodies.iter().enumerate() {
        let (Some(beam), Some(flexible)) = (&body.beam, &kinematics.bare.bodies[index].flexible) else {
            continue;
        };
        for (mode, modal) in flexible.modes.iter().enumerate() {
            let rate = kinematics.g.on(kinematics.bare.velocities[modal.velocity]);
            let damping = elastic::damping(laws, BodyId(index), beam, mode);
            let resisted = elastic::stiffness(laws, beam, mode) * modal.value + damping * rate;
            forces.push((modal.velocity, -resisted));
        }
    }
    forces
}

/// ½ pᵀ K p.
pub fn elastic_energy<'g>(laws: &Laws<'g>, kinematics: On<'g, &'g Kinematics>) -> Scalar<'g> {
    let g = kinematics.g;
    let mut sum = g.zero();
    for (body, placement) in laws.mechanism.bodies.iter().zip(&kinematics.bare.bodies) {
        let (Some(beam), Some(flexible)) = (&body.beam, &placement.flexible) else { continue };
        for (mode, modal) in flexible.modes.iter().enumerate() {
            sum += 0.5 * (elastic::stiffness(laws, beam, mode) * g.on(modal.value).square());
        }
    }
    sum
}
