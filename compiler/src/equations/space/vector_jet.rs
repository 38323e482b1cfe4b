//! A vector of the motion up to its second time derivative, carried from the axes of one link to those of another.
//!
//! Along w = at + axes (slide + R u), with ω of the link against its parent in the link's axes:
//!   ẇ = axes (… + R (u̇ + ω × u)),   ẅ = axes (… + R (ü + 2 ω × u̇ + ω̇ × u + ω × (ω × u))),
//! and the other way u̇ = Rᵀ ẇ − ω × u, ü = Rᵀ ẅ − 2 ω × u̇ − ω̇ × u − ω × (ω × u).
//! (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 2.9.)

use super::kinematics::Kinematics;
use super::links::{GROUND, Link, LinkId};
use super::vector::{self, Vec3};
use crate::equations::Jet;
use crate::symbolic::{Graph, Node};
use std::collections::BTreeMap;

#[derive(Clone, Debug)]
pub struct VectorJet {
    pub value: Vec3,
    /// ∂ẋ/∂v.
    pub columns: BTreeMap<usize, Vec3>,
    /// ẋ.
    pub rate: Vec3,
    /// ẋ at v = 0.
    pub drift: Vec3,
    /// ẍ at v̇ = 0.
    pub bias: Vec3,
}

/// Whether a vector has a foot that matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// From the origin of the link.
    Point,
    /// The same wherever it is drawn.
    Direction,
}

impl VectorJet {
    pub fn fixed(g: &mut Graph, value: Vec3) -> Self {
        let zero = vector::zero(g);
        VectorJet { value, columns: BTreeMap::new(), rate: zero, drift: zero, bias: zero }
    }

    /// A place of the ground, which moves with time only.
    pub fn of_time(place: &[Jet; 3]) -> Self {
        let drift = [0, 1, 2].map(|k| place[k].drift);
        VectorJet {
            value: [0, 1, 2].map(|k| place[k].value),
            columns: BTreeMap::new(),
            rate: drift,
            drift,
            bias: [0, 1, 2].map(|k| place[k].bias),
        }
    }

    fn map(&self, g: &mut Graph, f: impl Fn(&mut Graph, Vec3) -> Vec3) -> Self {
        let columns = self.columns.iter().map(|(k, column)| (*k, f(g, *column))).collect();
        VectorJet {
            value: f(g, self.value),
            columns,
            rate: f(g, self.rate),
            drift: f(g, self.drift),
            bias: f(g, self.bias),
        }
    }

    /// Constant components along other axes, as the rows of a matrix.
    pub fn along(&self, g: &mut Graph, axes: &vector::Mat3) -> Self {
        self.map(g, |g, x| vector::apply(g, axes, x))
    }

    pub fn sub(&self, g: &mut Graph, other: &VectorJet) -> VectorJet {
        let mut columns = self.columns.clone();
        for (k, column) in &other.columns {
            let own = columns.get(k).copied().unwrap_or(vector::zero(g));
            columns.insert(*k, vector::sub(g, own, *column));
        }
        VectorJet {
            value: vector::sub(g, self.value, other.value),
            columns,
            rate: vector::sub(g, self.rate, other.rate),
            drift: vector::sub(g, self.drift, other.drift),
            bias: vector::sub(g, self.bias, other.bias),
        }
    }

    /// u·x with u constant.
    pub fn project(&self, g: &mut Graph, u: Vec3) -> Jet {
        let mut columns = BTreeMap::new();
        for (k, column) in &self.columns {
            let entry = vector::dot(g, u, *column);
            if !g.is_zero(entry) {
                columns.insert(*k, entry);
            }
        }
        Jet {
            value: vector::dot(g, u, self.value),
            columns,
            drift: vector::dot(g, u, self.drift),
            bias: vector::dot(g, u, self.bias),
            known_rate: Some(vector::dot(g, u, self.rate)),
        }
    }

    /// The three components.
    pub fn components(&self, g: &mut Graph) -> [Jet; 3] {
        [0, 1, 2].map(|axis| {
            let u = vector::unit(g, axis);
            self.project(g, u)
        })
    }

    /// From the axes of a link to those of its parent.
    fn up(&self, g: &mut Graph, link: &Link, v: &[Node], kind: Kind) -> Self {
        let mut jet = self.clone();
        let (omega, turning) = (link.omega(g, v), link.turning(g));
        if !turning.is_empty() {
            for (velocity, axis) in turning {
                let own = jet.columns.get(&velocity).copied().unwrap_or(vector::zero(g));
                let turned = vector::cross(g, axis, self.value);
                jet.columns.insert(velocity, vector::add(g, own, turned));
            }
            let swept = vector::cross(g, omega, self.value);
            let two = g.constant(2.0);
            let doubled = vector::scale(g, two, self.rate);
            let inner = vector::add(g, doubled, swept);
            let outer = vector::cross(g, omega, inner);
            jet.bias = vector::add(g, jet.bias, outer);
            jet.rate = vector::add(g, jet.rate, swept);
            jet = jet.map(g, |g, x| link.turn(g, x));
        }
        if let (Kind::Point, Some((velocity, axis))) = (kind, link.sliding(g)) {
            let slide = link.slide(g);
            jet.value = vector::add(g, jet.value, slide);
            let own = jet.columns.get(&velocity).copied().unwrap_or(vector::zero(g));
            jet.columns.insert(velocity, vector::add(g, own, axis));
            let speed = vector::scale(g, v[velocity], axis);
            jet.rate = vector::add(g, jet.rate, speed);
        }
        jet = jet.map(g, |g, x| vector::apply(g, &link.axes, x));
        if kind == Kind::Point {
            jet.value = vector::add(g, jet.value, link.at);
            jet.rate = vector::add(g, jet.rate, link.at_drift);
            jet.drift = vector::add(g, jet.drift, link.at_drift);
            jet.bias = vector::add(g, jet.bias, link.at_bias);
        }
        jet
    }

    /// From the axes of a link's parent to its own.
    fn down(&self, g: &mut Graph, link: &Link, v: &[Node], kind: Kind) -> Self {
        let mut jet = self.clone();
        if kind == Kind::Point {
            jet.value = vector::sub(g, jet.value, link.at);
            jet.rate = vector::sub(g, jet.rate, link.at_drift);
            jet.drift = vector::sub(g, jet.drift, link.at_drift);
            jet.bias = vector::sub(g, jet.bias, link.at_bias);
        }
        jet = jet.map(g, |g, x| vector::apply_transposed(g, &link.axes, x));
        if let (Kind::Point, Some((velocity, axis))) = (kind, link.sliding(g)) {
            let slide = link.slide(g);
            jet.value = vector::sub(g, jet.value, slide);
            let own = jet.columns.get(&velocity).copied().unwrap_or(vector::zero(g));
            jet.columns.insert(velocity, vector::sub(g, own, axis));
            let speed = vector::scale(g, v[velocity], axis);
            jet.rate = vector::sub(g, jet.rate, speed);
        }
        let (omega, turning) = (link.omega(g, v), link.turning(g));
        if !turning.is_empty() {
            jet = jet.map(g, |g, x| link.turn_back(g, x));
            let swept = vector::cross(g, omega, jet.value);
            // u̇, then 2 ω × u̇ + ω × (ω × u) = ω × (2 u̇ + ω × u)
            jet.rate = vector::sub(g, jet.rate, swept);
            let two = g.constant(2.0);
            let doubled = vector::scale(g, two, jet.rate);
            let inner = vector::add(g, doubled, swept);
            let outer = vector::cross(g, omega, inner);
            jet.bias = vector::sub(g, jet.bias, outer);
            for (velocity, axis) in turning {
                let own = jet.columns.get(&velocity).copied().unwrap_or(vector::zero(g));
                let turned = vector::cross(g, axis, jet.value);
                jet.columns.insert(velocity, vector::sub(g, own, turned));
            }
        }
        jet
    }
}

impl Kinematics {
    /// A vector given in the axes of `from`, as seen from `to`.
    pub fn carry(&self, g: &mut Graph, jet: VectorJet, from: LinkId, to: LinkId, kind: Kind) -> VectorJet {
        let below = self.ancestors(to);
        let mut jet = jet;
        let mut at = from;
        while !below.contains(&at) {
            jet = jet.up(g, &self.links[at], &self.velocities, kind);
            at = self.links[at].parent;
        }
        let meeting = below.iter().position(|link| *link == at).unwrap_or(0);
        for link in below[..meeting].iter().rev() {
            jet = jet.down(g, &self.links[*link], &self.velocities, kind);
        }
        jet
    }

    /// A link, its parent, and so on to the ground.
    pub fn ancestors(&self, link: LinkId) -> Vec<LinkId> {
        let mut path = vec![link];
        let mut at = link;
        while at != GROUND {
            at = self.links[at].parent;
            path.push(at);
        }
        path
    }

    /// Where the ways of two links to the ground meet.
    pub fn meeting(&self, a: LinkId, b: LinkId) -> LinkId {
        let above = self.ancestors(a);
        self.ancestors(b).into_iter().find(|link| above.contains(link)).unwrap_or(GROUND)
    }
}
