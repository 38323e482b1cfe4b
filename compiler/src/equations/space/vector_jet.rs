//! A vector of the motion up to its second time derivative, carried from the axes of one link to those of another.
//!
//! Along w = at + axes (slide + R u), with ω of the link against its parent in the link's axes:
//!   ẇ = axes (… + R (u̇ + ω × u)),   ẅ = axes (… + R (ü + 2 ω × u̇ + ω̇ × u + ω × (ω × u))),
//! and the other way u̇ = Rᵀ ẇ − ω × u, ü = Rᵀ ẅ − 2 ω × u̇ − ω̇ × u − ω × (ω × u).
//! (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 2.9.)

use super::kinematics::Kinematics;
use super::links::{GROUND, Link, LinkId};
use super::vector::{self, Mat3, Vec3};
use crate::equations::jet::{Jet, Moving};
use crate::symbolic::{Bare, On, Sheet};
use std::collections::BTreeMap;
use std::ops::{Add, Sub};

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
    pub fn fixed(value: On<Vec3>) -> Self {
        let zero = vector::zero(value.g).bare;
        VectorJet { value: value.bare, columns: BTreeMap::new(), rate: zero, drift: zero, bias: zero }
    }

    /// A place of the ground, which moves with time only.
    pub fn of_time(place: &[Moving; 3]) -> Self {
        let drift = [0, 1, 2].map(|k| place[k].jet.drift);
        VectorJet {
            value: [0, 1, 2].map(|k| place[k].jet.value),
            columns: BTreeMap::new(),
            rate: drift,
            drift,
            bias: [0, 1, 2].map(|k| place[k].jet.bias),
        }
    }

    /// A linear function of the vector.
    fn map<'g>(&self, g: Sheet<'g>, f: impl Fn(On<'g, Vec3>) -> On<'g, Vec3>) -> Self {
        let f = |x: Vec3| f(g.on(x)).bare;
        let columns = self.columns.iter().map(|(k, column)| (*k, f(*column))).collect();
        VectorJet {
            value: f(self.value),
            columns,
            rate: f(self.rate),
            drift: f(self.drift),
            bias: f(self.bias),
        }
    }
}

impl<'g> Moving<'g, VectorJet> {
    pub fn value(&self) -> On<'g, Vec3> {
        self.g.on(self.jet.value)
    }
    pub fn rate(&self) -> On<'g, Vec3> {
        self.g.on(self.jet.rate)
    }
    pub fn bias(&self) -> On<'g, Vec3> {
        self.g.on(self.jet.bias)
    }
    pub fn column(&self, velocity: usize) -> On<'g, Vec3> {
        match self.jet.columns.get(&velocity) {
            Some(column) => self.g.on(*column),
            None => vector::zero(self.g),
        }
    }

    fn of<J>(&self, jet: J) -> Moving<'g, J> {
        Moving { g: self.g, velocities: self.velocities, jet }
    }

    fn map(&self, f: impl Fn(On<'g, Vec3>) -> On<'g, Vec3>) -> Self {
        self.of(self.jet.map(self.g, f))
    }

    /// Constant components along other axes, as the rows of a matrix.
    pub fn along(&self, axes: Mat3) -> Self {
        self.map(|x| axes * x)
    }

    /// u·x with u constant.
    pub fn project(&self, u: impl Bare<Vec3>) -> Moving<'g> {
        let u = self.g.on(u.bare());
        let mut columns = BTreeMap::new();
        for (k, column) in &self.jet.columns {
            let entry = u.dot(*column);
            if !entry.is_zero() {
                columns.insert(*k, entry.bare);
            }
        }
        self.of(Jet {
            value: u.dot(self.jet.value).bare,
            columns,
            drift: u.dot(self.jet.drift).bare,
            bias: u.dot(self.jet.bias).bare,
            known_rate: Some(u.dot(self.jet.rate).bare),
        })
    }

    /// The three components.
    pub fn components(&self) -> [Moving<'g>; 3] {
        [0, 1, 2].map(|axis| self.project(vector::unit(self.g, axis)))
    }

    /// From the axes of a link to those of its parent.
    fn up(&self, link: On<'g, &Link>, kind: Kind) -> Self {
        let mut seen = self.clone();
        let (omega, turning) = (link.omega(self.velocities), link.turning());
        if !turning.is_empty() {
            for (velocity, axis) in turning {
                let column = self.column(velocity) + axis.cross(self.value());
                seen.jet.columns.insert(velocity, column.bare);
            }
            let swept = omega.cross(self.value());
            let turned = self.bias() + link.turning_bias().cross(self.value());
            seen.jet.bias = (turned + omega.cross(2.0 * self.rate() + swept)).bare;
            seen.jet.rate = (self.rate() + swept).bare;
            seen = seen.map(|x| link.turn(x));
        }
        if let (Kind::Point, Some(slide)) = (kind, self.slide(link)) {
            seen = seen + slide;
        }
        seen = seen.map(|x| link.bare.axes * x);
        if kind == Kind::Point { seen + self.foot(link) } else { seen }
    }

    /// From the axes of a link's parent to its own.
    fn down(&self, link: On<'g, &Link>, kind: Kind) -> Self {
        let seen = self.clone();
        let seen = if kind == Kind::Point { seen - self.foot(link) } else { seen };
        let axes = vector::transposed(&link.bare.axes);
        let mut seen = seen.map(|x| axes * x);
        if let (Kind::Point, Some(slide)) = (kind, self.slide(link)) {
            seen = seen - slide;
        }
        let (omega, turning) = (link.omega(self.velocities), link.turning());
        if !turning.is_empty() {
            seen = seen.map(|x| link.turn_back(x));
            let swept = omega.cross(seen.value());
            // u̇, then 2 ω × u̇ + ω × (ω × u) = ω × (2 u̇ + ω × u)
            let rate = seen.rate() - swept;
            let turned = seen.bias() - link.turning_bias().cross(seen.value());
            seen.jet.bias = (turned - omega.cross(2.0 * rate + swept)).bare;
            seen.jet.rate = rate.bare;
            for (velocity, axis) in turning {
                let column = seen.column(velocity) - axis.cross(seen.value());
                seen.jet.columns.insert(velocity, column.bare);
            }
        }
        seen
    }

    /// `at` of a link in motion.
    fn foot(&self, link: On<'g, &Link>) -> Self {
        let Link { at, at_drift, at_bias, .. } = *link.bare;
        self.of(VectorJet {
            value: at,
            columns: BTreeMap::new(),
            rate: at_drift,
            drift: at_drift,
            bias: at_bias,
        })
    }

    /// The slide of a link in motion, in its own axes.
    fn slide(&self, link: On<'g, &Link>) -> Option<Self> {
        let rate = link.sliding_by(self.velocities)?;
        let fixed = VectorJet::fixed(link.slide());
        let columns = link.sliding().into_iter().map(|(velocity, axis)| (velocity, axis.bare)).collect();
        let bias = link.sliding_bias().bare;
        Some(self.of(VectorJet { columns, rate: rate.bare, bias, ..fixed }))
    }

    fn combine(&self, other: &Self, join: fn(On<'g, Vec3>, Vec3) -> On<'g, Vec3>) -> Self {
        let mut columns = self.jet.columns.clone();
        for (k, column) in &other.jet.columns {
            columns.insert(*k, join(self.column(*k), *column).bare);
        }
        let join = |a: Vec3, b: Vec3| join(self.g.on(a), b).bare;
        let (a, b) = (&self.jet, &other.jet);
        self.of(VectorJet {
            value: join(a.value, b.value),
            columns,
            rate: join(a.rate, b.rate),
            drift: join(a.drift, b.drift),
            bias: join(a.bias, b.bias),
        })
    }
}

impl Add for Moving<'_, VectorJet> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.combine(&other, |a, b| a + b)
    }
}

impl Sub for Moving<'_, VectorJet> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.combine(&other, |a, b| a - b)
    }
}

impl<'g> On<'g, &'g Kinematics> {
    /// A vector given in the axes of `from`, as seen from `to`.
    pub fn carry(self, jet: VectorJet, from: LinkId, to: LinkId, kind: Kind) -> Moving<'g, VectorJet> {
        let link = |at: LinkId| self.g.on(&self.bare.links[at]);
        let below = self.bare.ancestors(to);
        let mut seen = self.moving(&self.bare.velocities, jet);
        let mut at = from;
        while !below.contains(&at) {
            seen = seen.up(link(at), kind);
            at = self.bare.links[at].parent;
        }
        let meeting = below.iter().position(|link| *link == at).unwrap_or(0);
        for at in below[..meeting].iter().rev() {
            seen = seen.down(link(*at), kind);
        }
        seen
    }
}

impl Kinematics {
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
