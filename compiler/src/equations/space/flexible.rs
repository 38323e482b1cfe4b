//! Bodies in space that deform, in a floating frame of reference: where their places and sections are, and what their mass has beyond that of a
//! rigid body at the instant.
//!
//! A material point is, from the origin of the link in its axes, at Σ_i φ_i w_i: φ = 1 along what leads to the body's origin; of a beam x along
//! e₁, and the shape N_j of a mode along e_j times p_j; of a finite element model x, y, z along the axes, and the three components of each mode
//! along these times p_j (`shapes`). With m the mass and C_ik the mean of φ_i φ_k over it (the inertia shape integrals,
//! Shabana, *Dynamics of Multibody Systems*, 5.5) all integrals are sums of h_i = Σ_k C_ik w_k:
//!   first moment m h₁, second moments m Σ w_i h_iᵀ, and of a mode the force m C_j1 e_j and the moment m h_j × e_j about the origin.
//! With stiffening there are the functions D_j and E of [`Means`] too, along e₁. What M leaves of the inertia forces while the modes move is 2 ω × ẇ + ẅ at every point; all else is what the rigid body of the instant
//! has, which `dynamics` knows.
//!
//! What turns has T = ½ ω·J ω + ω·Σ B_j ṗ_j + ½ ṗ·D ṗ beyond that, with constants in the axes of the body: it gives the body the moment
//! Σ B_j p̈_j + ω × Σ B_j ṗ_j beside that of J, and the mode B_j·α + Σ D_jk p̈_k. Sections of a beam turn about e₁ by Σ N_t ṗ_t more than its frame, with
//! the moment of inertia about the axis of each, to which the turns of bending add nothing (no rotary inertia): with J = ∫ j dx and the means ν_j of N_j
//! and ν_jk of N_j N_k these are J e₁ e₁ᵀ, J ν_j e₁ and J ν_jk. Sections that shear turn about all axes, by ψ in bending, with their own moments of
//! inertia: the same sums over three axes (`beams::Turning`).
//!
//! A section is turned by φ, of a beam (Σ N_t p_t, −Σ N′ p_z, Σ N′ p_y), which the theory knows to first order. What is carried has to be turned by a
//! rotation, of which here Cayley's has this first order, without trigonometry: with c = φ/2
//!   R = 1 + 2 (c̃ + c̃²)/(1 + c²),  ω = (φ̇ − c × φ̇)/(1 + c²) in the axes of the section
//! (Géradin, Cardona, *Flexible Multibody Dynamics*, 4.6, Rodrigues parameters).

use super::dynamics::LinkMotion;
use super::kinematics::Kinematics;
use super::links::{Link, LinkId, Motion, Placement};
use super::shapes::{Rows, Shapes};
use super::tensor::{Distribution, ENTRIES, Symmetric};
use super::vector::{self, Mat3, Vec3};
use super::vector_jet::VectorJet;
use crate::equations::jet::{Jet, Moving};
use crate::equations::means::{Bent, Means};
use crate::equations::{Laws, elastic};
use crate::modal::Rotary;
use crate::model::{BodyId, Deforms, Frame, Mechanism};
use crate::symbolic::{Node, On, Scalar, Sheet};
use std::collections::BTreeMap;

/// The modes of a body.
#[derive(Clone, Debug)]
pub struct Flexible {
    pub shapes: Shapes,
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
    fn parts<'g>(
        &self,
        g: Sheet<'g>,
        of: &[[f64; 3]],
        sign: f64,
    ) -> impl Iterator<Item = (Modal, On<'g, Vec3>)> {
        let modes = self.modes.iter().zip(of).filter(|(_, part)| part.iter().any(|it| *it != 0.0));
        modes.map(move |(modal, part)| (*modal, numbers(g, part.map(|it| sign * it))))
    }

    /// How a place is moved from where it is while nothing deforms, in the axes of the body; `None` where it stays.
    pub fn shift<'g>(&self, g: Sheet<'g>, velocities: &[Node], rows: &Rows, sign: f64) -> Option<Motion> {
        let (mut offset, mut bias) = (vector::zero(g), vector::zero(g));
        let mut along: BTreeMap<usize, On<'g, Vec3>> = BTreeMap::new();
        let mut add = |velocity: usize, axis: On<'g, Vec3>| {
            let sum = along.get(&velocity).map_or(axis, |known| *known + axis);
            along.insert(velocity, sum);
        };
        for (modal, axis) in self.parts(g, &rows.shifts, sign) {
            offset += g.on(modal.value) * axis;
            add(modal.velocity, axis);
        }
        // −½ pᵀ Γ p along the axis, its columns −Γ p, and −ṗᵀ Γ ṗ.
        for (pair, gamma) in self.shapes.shortenings().iter().zip(&rows.gammas) {
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

    /// How a section is turned against its place while nothing deforms, or back; `None` where it keeps its direction.
    pub fn lean<'g>(&self, g: Sheet<'g>, velocities: &[Node], rows: &Rows, sign: f64) -> Option<Motion> {
        let (mut half, mut rate, mut turns) = (vector::zero(g), vector::zero(g), Vec::new());
        for (modal, about) in self.parts(g, &rows.turns, sign) {
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

    /// A point of the body on its link, which is at `fixed` while nothing deforms.
    pub fn moved<'g>(
        &self,
        kinematics: On<'g, &'g Kinematics>,
        placement: &Placement,
        rows: &Rows,
        fixed: VectorJet,
    ) -> VectorJet {
        let g = kinematics.g;
        let shift = self.shift(g, &kinematics.bare.velocities, rows, 1.0);
        let Some(Motion::Shift { offset, along, bias }) = shift else { return fixed };
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
    /// Makes the sections of a body at the places that are named or joined.
    pub fn add_sections(&mut self, g: Sheet, mechanism: &Mechanism, body: BodyId, placement: &Placement) {
        let Some(flexible) = &placement.flexible else { return };
        let joints = mechanism.joints.iter().flat_map(|joint| [&joint.first, &joint.second]);
        let joined = joints.filter(|place| place.frame == Frame::Body(body)).map(|place| &place.at);
        let named = mechanism.bodies[body.0].points.iter().map(|point| &point.at);
        for at in joined.chain(named) {
            let Some(station) = flexible.shapes.station_of(at) else { continue };
            let key = (body.0, station);
            if self.sections.contains_key(&key) {
                continue;
            }
            let place = numbers(g, flexible.shapes.place(station));
            let rows = flexible.shapes.rows(station);
            let foot = Link {
                at: g.on(placement).point(place).bare,
                axes: placement.axes,
                ..Link::still(g, placement.link)
            };
            let motion = flexible.shift(g, &self.velocities, &rows, 1.0).unwrap_or(Motion::None);
            let mut last = self.push(Link { motion, ..foot });
            if let Some(motion) = flexible.lean(g, &self.velocities, &rows, 1.0) {
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
    mode: usize,
}

/// A body that deforms with its mass, on its link.
pub struct Spread<'g> {
    pub link: LinkId,
    mass: Scalar<'g>,
    /// Link ← body.
    axes: On<'g, Mat3>,
    /// What turns beyond places that move, times a factor: of beams kg m² about their axis.
    rotary: Rotary,
    turning: Scalar<'g>,
    means: Means<'g>,
    position: Field<'g>,
    pub shares: Vec<Share<'g>>,
    /// E e₁.
    faster: Field<'g>,
}

impl<'g> Spread<'g> {
    /// The bodies that deform.
    pub fn all(laws: &Laws<'g>, kinematics: On<'g, &'g Kinematics>) -> Vec<Self> {
        let mut all = Vec::new();
        for (index, placement) in kinematics.bare.bodies.iter().enumerate() {
            let body = &laws.mechanism.bodies[index];
            if let (Some(flexible), Some(deforms)) = (&placement.flexible, &body.deforms) {
                let mass = laws.value(&body.mass);
                let turning = turning_factor(laws, mass, deforms);
                all.push(Self::new(kinematics, placement, flexible, mass, turning));
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
        turning: Scalar<'g>,
    ) -> Self {
        let g = kinematics.g;
        let shapes = &flexible.shapes;
        let axes = g.on(placement.axes);
        let modes = flexible.modes.len();
        let rate_of = |modal: &Modal| kinematics.bare.velocities[modal.velocity];
        let bent = flexible.modes.iter().map(|modal| Bent { value: modal.value, rate: rate_of(modal) });
        let bent: Vec<Bent> = bent.collect();
        let functions = shapes.functions();
        let mut position = vec![(0, g.on(placement.at))];
        let still = functions.iter().enumerate().filter(|(_, function)| function.mode.is_none());
        position.extend(still.map(|(k, function)| (1 + k, axes.column(function.axis))));
        let mut shares = Vec::new();
        // Along the axis of a beam, behind its shapes.
        let (along, drawn) = (axes.column(0), 1 + functions.len());
        for (mode, modal) in flexible.modes.iter().enumerate() {
            let (velocity, rate) = (modal.velocity, g.on(rate_of(modal)));
            let mut column = Vec::new();
            let own = functions.iter().enumerate().filter(|(_, function)| function.mode == Some(mode));
            for (k, function) in own.filter(|_| shapes.moves(mode)) {
                let axis = axes.column(function.axis);
                position.push((1 + k, g.on(modal.value) * axis));
                column.push((1 + k, axis));
            }
            if shapes.draws_in(mode) {
                position.push((drawn + mode, 0.5 * (g.on(modal.value) * along)));
                column.push((drawn + mode, along));
            }
            shares.push(Share { velocity, rate, column, mode });
        }
        let stiffens = !shapes.shortenings().is_empty();
        let faster = if stiffens { vec![(drawn + modes, along)] } else { Vec::new() };
        let (means, rotary) = (shapes.means(g, &bent), shapes.rotary());
        Spread { link: placement.link, mass, axes, rotary, turning, means, position, shares, faster }
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
            let spin = self.turned(i, j);
            if i == j {
                self.mass * (squares[(k + 1) % 3] + squares[(k + 2) % 3]) + spin
            } else {
                spin - self.mass * second(i, j)
            }
        });
        let first = self.mass * h[0];
        g.on(Distribution { mass: self.mass.bare, first: first.bare, inertia: inertia.bare })
    }

    /// An entry of J in the axes of the link.
    fn turned(&self, i: usize, j: usize) -> Scalar<'g> {
        let mut sum = self.mass.g.zero();
        for (a, row) in self.rotary.inertia.iter().enumerate() {
            for (b, entry) in row.iter().enumerate().filter(|(_, entry)| **entry != 0.0) {
                let both = self.axes.column(a).at(i) * self.axes.column(b).at(j);
                sum += self.turning * (*entry * both);
            }
        }
        sum
    }

    /// Twice the energy with which a section of a beam turns, about its axis or with shear about all, were it as heavy as the whole: the link turns
    /// by ω, and modes turn the section by these rows.
    pub fn twice_turning_of_section(&self, omega: On<'g, Vec3>, rows: &Rows) -> Scalar<'g> {
        let about = |axis: usize| {
            let along = self.axes.column(axis).dot(omega);
            let rate =
                self.shares.iter().fold(along, |sum, share| sum + rows.turns[share.mode][axis] * share.rate);
            self.rotary.inertia[axis][axis] * rate.square()
        };
        self.turning * self.mass.g.sum([0, 1, 2].map(about))
    }

    /// Twice the energy of what turns by itself, with the rates of the link and of the modes.
    pub fn twice_turning(&self, omega: On<'g, Vec3>) -> Scalar<'g> {
        let rates = [0, 1, 2].map(|axis| self.axes.column(axis).dot(omega));
        let all: Vec<Scalar> = rates.into_iter().chain(self.shares.iter().map(|share| share.rate)).collect();
        let entry = |i: usize, k: usize| match (i, k) {
            (0..3, 0..3) => self.rotary.inertia[i][k],
            (0..3, _) => self.rotary.momentum[k - 3][i],
            (_, 0..3) => self.rotary.momentum[i - 3][k],
            _ => self.rotary.modal[i - 3][k - 3],
        };
        let pairs = (0..all.len()).flat_map(|i| (0..all.len()).map(move |k| (i, k)));
        self.turning * self.mass.g.sum(pairs.map(|(i, k)| entry(i, k) * (all[i] * all[k])))
    }

    /// B_j of a mode along the axes of the body, where it is anything.
    fn momentum(&self, share: &Share<'g>) -> impl Iterator<Item = (Scalar<'g>, On<'g, Vec3>)> + '_ {
        let along = self.rotary.momentum[share.mode].into_iter().enumerate();
        along
            .filter(|(_, part)| *part != 0.0)
            .map(|(axis, part)| (self.mass.g.number(part), self.axes.column(axis)))
    }

    /// D_jk.
    fn both_turn(&self, one: &Share<'g>, other: &Share<'g>) -> Scalar<'g> {
        self.mass.g.number(self.rotary.modal[one.mode][other.mode])
    }

    /// Whether a mode turns something by itself.
    fn turns(&self, share: &Share<'g>) -> bool {
        let is_any = |row: &[f64]| row.iter().any(|it| *it != 0.0);
        is_any(&self.rotary.momentum[share.mode]) || is_any(&self.rotary.modal[share.mode])
    }

    /// Moment about the origin of the link and force of a mode that is accelerated by one.
    pub fn column(&self, share: &Share<'g>) -> [On<'g, Vec3>; 2] {
        let (moment, force) = (self.cross(&self.position, &share.column), self.h(0, &share.column));
        let turning = self.momentum(share);
        let moment = match self.turns_with_mass() {
            true => self.mass * turning.fold(moment, |sum, (part, axis)| sum + part * axis),
            false => turning.fold(self.mass * moment, |sum, (part, axis)| sum + (self.turning * part) * axis),
        };
        [moment, self.mass * force]
    }

    /// Whether what turns has the factor of what moves, so that one may take the other away: modes of free beams carry no moment of momentum.
    fn turns_with_mass(&self) -> bool {
        self.turning.bare == self.mass.bare
    }

    /// M of two modes.
    pub fn mass_of(&self, one: &Share<'g>, other: &Share<'g>) -> Scalar<'g> {
        let (dot, turning) = (self.dot(&one.column, &other.column), self.both_turn(one, other));
        if self.turns_with_mass() {
            self.mass * (dot + turning)
        } else {
            self.mass * dot + self.turning * turning
        }
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
        let mut about = vector::zero(self.mass.g);
        for (axis, rate) in self.momenta(|share| share.rate) {
            about += rate * motion.omega.cross(axis);
        }
        if let Some(a) = accelerations {
            for (axis, rate) in self.momenta(|share| self.mass.g.on(a[share.velocity])) {
                about += rate * axis;
            }
        }
        [self.mass * moment + self.turning * about, self.mass * force]
    }

    /// Force along each mode that the motion of the link and of the modes needs.
    pub fn forces(
        &self,
        motion: &LinkMotion<'g>,
        accelerations: Option<&[Node]>,
    ) -> Vec<(usize, Scalar<'g>)> {
        let [rates, own] = self.moving(accelerations);
        let force = |share: &Share<'g>| {
            let turning = self.turns(share).then(|| {
                let own = self.momentum(share).map(|(part, axis)| part * axis.dot(motion.alpha));
                let mut sum = self.mass.g.sum(own);
                if let Some(a) = accelerations {
                    let both = |its: &Share<'g>| self.both_turn(share, its) * a[its.velocity];
                    sum += self.mass.g.sum(self.shares.iter().map(both));
                }
                self.turning * sum
            });
            if let (Some(turning), true) = (turning, share.column.is_empty()) {
                return (share.velocity, turning);
            }
            let mut sum = self.h(0, &share.column).dot(motion.acceleration);
            for (k, w) in &share.column {
                let carried = motion.spin * self.h(*k, &self.position);
                sum += w.dot(carried + 2.0 * motion.omega.cross(self.h(*k, &rates)));
            }
            let force = self.mass * (sum + self.dot(&share.column, &own));
            (share.velocity, turning.map_or(force, |turning| force + turning))
        };
        self.shares.iter().map(force).collect()
    }

    /// What T has beyond that of the rigid body of the instant.
    pub fn kinetic_energy(&self, motion: &LinkMotion<'g>) -> Scalar<'g> {
        let rates = self.rates();
        let mixed =
            motion.velocity.dot(self.h(0, &rates)) + motion.omega.dot(self.cross(&self.position, &rates));
        let own = self.momenta(|share| share.rate).into_iter();
        let turning = self.mass.g.sum(own.map(|(axis, rate)| axis.dot(motion.omega) * rate));
        let pairs = self.shares.iter().flat_map(|one| {
            self.shares.iter().map(move |other| self.both_turn(one, other) * (one.rate * other.rate))
        });
        let twisting = turning + 0.5 * self.mass.g.sum(pairs);
        self.mass * (mixed + 0.5 * self.dot(&rates, &rates)) + self.turning * twisting
    }

    /// Σ B_j times these, axis by axis of the body, along which there is any.
    fn momenta(&self, of: impl Fn(&Share<'g>) -> Scalar<'g>) -> Vec<(On<'g, Vec3>, Scalar<'g>)> {
        let g = self.mass.g;
        let along = |axis: usize| {
            let part = |share: &Share<'g>| g.number(self.rotary.momentum[share.mode][axis]);
            (self.axes.column(axis), g.sum(self.shares.iter().map(|share| part(share) * of(share))))
        };
        [0, 1, 2].map(along).into_iter().filter(|(_, sum)| !sum.is_zero()).collect()
    }
}

/// What the rotary constants of a body are multiplied with: of a beam its moment of inertia about its axis, or where sections shear its mass.
pub fn turning_factor<'g>(laws: &Laws<'g>, mass: Scalar<'g>, deforms: &Deforms) -> Scalar<'g> {
    match deforms {
        Deforms::Beam(beam) if beam.slender.turning.is_some() => mass,
        Deforms::Beam(beam) => mass * laws.value(&beam.spin),
        Deforms::Modal(_) => laws.g.one(),
    }
}

fn numbers<'g>(g: Sheet<'g>, values: [f64; 3]) -> On<'g, Vec3> {
    vector::vector(|k| g.number(if values[k] == 0.0 { 0.0 } else { values[k] }))
}

/// −K p − C ṗ of all modes, by velocity.
pub fn elastic_forces<'g>(laws: &Laws<'g>, kinematics: On<'g, &'g Kinematics>) -> Vec<(usize, Scalar<'g>)> {
    let mut forces = Vec::new();
    for (index, body) in laws.mechanism.bodies.iter().enumerate() {
        let (Some(deforms), Some(flexible)) = (&body.deforms, &kinematics.bare.bodies[index].flexible) else {
            continue;
        };
        let rate = |modal: &Modal| kinematics.g.on(kinematics.bare.velocities[modal.velocity]);
        let bent = flexible.modes.iter().map(|modal| (kinematics.g.on(modal.value), rate(modal)));
        let resisted = elastic::resistance(laws, BodyId(index), deforms, &bent.collect::<Vec<_>>());
        forces.extend(flexible.modes.iter().zip(resisted).map(|(modal, force)| (modal.velocity, -force)));
    }
    forces
}

/// ½ pᵀ K p.
pub fn elastic_energy<'g>(laws: &Laws<'g>, kinematics: On<'g, &'g Kinematics>) -> Scalar<'g> {
    let g = kinematics.g;
    let mut sum = g.zero();
    for (body, placement) in laws.mechanism.bodies.iter().zip(&kinematics.bare.bodies) {
        let (Some(deforms), Some(flexible)) = (&body.deforms, &placement.flexible) else { continue };
        let values: Vec<Scalar> = flexible.modes.iter().map(|modal| g.on(modal.value)).collect();
        for energy in elastic::energies(laws, deforms, &values) {
            sum += energy;
        }
    }
    sum
}
