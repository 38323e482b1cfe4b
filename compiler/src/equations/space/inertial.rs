//! Vectors with their derivatives as the ground sees them, by ω and U = α̃ + ω̃ ω̃ of the links, which inertia forces need anyway.
//!
//! Along w = at + axes (slide + R u), with ẋ, ẍ as the ground sees them, in the axes of each link, at v̇ = 0:
//!   ẇ = ω × s + ṡ + axes R u̇,   ẅ = U s + 2 ω × ṡ + s̈ + axes R ü,
//! where s = at + axes slide is what the parent holds, and ṡ, s̈ how that moves in it; nothing is turned but the sums, or s first (`dynamics::turned`).
//! (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 5; Luh, Walker, Paul 1980.)
//!
//! The cosine u·w of directions that two links hold needs neither ü nor ẅ: with n = u × w and Ω = ω₁ − ω₂ its rate is Ω·n, and from
//! ṅ = u (ω₁·w) − w (ω₂·u) − Ω (u·w) follows, at v̇ = 0,
//!   (u·w)¨ = (α₁ − α₂)·n + 2 (Ω·u)(Ω·w) + (ω₂·w)(Ω·u) − (ω₁·u)(Ω·w) − Ω² (u·w),
//! where ω₁·u and ω₂·w are components in the links' own axes, and the components of n about the axes on the way to a link are the entries of D.

use super::dynamics::{self, LinkMotion};
use super::kinematics::{Kinematics, Spot};
use super::links::{GROUND, LinkId, Motion};
use super::vector::{self, Vec3};
use super::vector_jet::{Kind, VectorJet};
use crate::equations::jet::{Jet, Moving};
use crate::symbolic::{Computed, On, Scalar};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The entries of a row of D.
type Columns<'g> = BTreeMap<usize, Scalar<'g>>;

/// How cosines are derived.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cosines {
    /// By how the ground sees either direction move.
    Directions,
    /// By how the links turn against each other.
    Turning,
}

/// The links, with their motions at v̇ = 0.
pub struct Inertial<'g> {
    kinematics: On<'g, &'g Kinematics>,
    motions: Vec<LinkMotion<'g>>,
    /// What is computed anyway.
    computed: RefCell<Computed>,
    cosines: Cosines,
}

impl<'g> Inertial<'g> {
    /// With cosines by directions; accelerations of places in a way that takes few operations beside what is computed anyway.
    pub fn new(kinematics: On<'g, &'g Kinematics>, computed: Computed) -> Self {
        let motions = dynamics::motions(kinematics, None, vector::zero(kinematics.g));
        Inertial { kinematics, motions, computed: RefCell::new(computed), cosines: Cosines::Directions }
    }

    /// The same with cosines derived in this way.
    pub fn with(&self, cosines: Cosines) -> Self {
        let computed = self.computed.clone();
        Inertial { motions: self.motions.clone(), computed, cosines, ..*self }
    }

    /// A place on a link, as seen from the ground, m: ẋ and ẍ at v̇ = 0 as above, m/s and m/s².
    pub fn point(&self, at: VectorJet, from: LinkId) -> Moving<'g, VectorJet> {
        self.seen(at, from, GROUND, Kind::Point)
    }

    /// u·w of directions that are fixed on the links of two places. With n = u × w the rate is n·(ω₁ − ω₂), so that the entry of D is a·n for a
    /// velocity about a on the way to the first, and −a·n on that to the second; without unit, its rate in 1/s, (u·w)¨ at v̇ = 0 in 1/s².
    pub fn cosine(&self, places: [&Spot<'g>; 2], u: On<'g, Vec3>, w: On<'g, Vec3>) -> Moving<'g> {
        match self.cosines {
            Cosines::Directions => self.cosine_of_directions(places.map(|place| place.link), u, w),
            Cosines::Turning => self.cosine_of_turning(places.map(|place| place.link), u, w),
        }
    }

    /// ü·w + 2 u̇·ẇ + u·ẅ at v̇ = 0.
    fn cosine_of_directions(&self, ends: [LinkId; 2], u: On<'g, Vec3>, w: On<'g, Vec3>) -> Moving<'g> {
        let kinematics = self.kinematics;
        let g = kinematics.g;
        let meeting = kinematics.bare.meeting(ends[0], ends[1]);
        let seen = |fixed: On<'g, Vec3>, link: LinkId| {
            self.seen(VectorJet::fixed(fixed), link, meeting, Kind::Direction)
        };
        let (u, w) = (seen(u, ends[0]), seen(w, ends[1]));
        let normal = u.value().cross(w.value());
        let mut columns = Columns::new();
        for (end, normal) in ends.into_iter().zip([normal, -normal]) {
            for at in self.way(meeting, end).into_iter().rev() {
                for (velocity, axis) in g.on(&kinematics.bare.links[at]).turning() {
                    let axis = kinematics.carry(VectorJet::fixed(axis), at, meeting, Kind::Direction).value();
                    *columns.entry(velocity).or_insert_with(|| g.zero()) += axis.dot(normal);
                }
            }
        }
        let bias = u.bias().dot(w.value()) + u.value().dot(w.bias()) + 2.0 * u.rate().dot(w.rate());
        let rate = u.rate().dot(w.value()) + u.value().dot(w.rate());
        self.row(u.value().dot(w.value()), columns, bias, rate)
    }

    /// The same by the normal and how the links turn against each other, all of which is seen from where their ways meet.
    fn cosine_of_turning(&self, ends: [LinkId; 2], u: On<'g, Vec3>, w: On<'g, Vec3>) -> Moving<'g> {
        let kinematics = self.kinematics;
        let meeting = kinematics.bare.meeting(ends[0], ends[1]);
        let seen = |fixed: On<'g, Vec3>, link: LinkId| {
            kinematics.carry(VectorJet::fixed(fixed), link, meeting, Kind::Direction).value()
        };
        let own = |link: LinkId, direction: On<'g, Vec3>| self.motions[link].omega.dot(direction);
        let (first_about_u, second_about_w) = (own(ends[0], u), own(ends[1], w));
        let (u, w) = (seen(u, ends[0]), seen(w, ends[1]));
        let (value, normal) = (u.dot(w), u.cross(w));
        let omega = self.turns(meeting, ends[0]) - self.turns(meeting, ends[1]);
        let mut columns = Columns::new();
        let first = self.along_the_way(meeting, ends[0], normal, &mut columns);
        let second = self.along_the_way(meeting, ends[1], -normal, &mut columns);
        let (about_u, about_w) = (omega.dot(u), omega.dot(w));
        let bias = first + second + about_u * (2.0 * about_w + second_about_w)
            - first_about_u * about_w
            - omega.dot(omega) * value;
        self.row(value, columns, bias, omega.dot(normal))
    }

    /// The links from one that carries another, itself left out, to that other, from the inside out.
    fn way(&self, from: LinkId, to: LinkId) -> Vec<LinkId> {
        let links = self.kinematics.bare.ancestors(to);
        let mut way: Vec<LinkId> = links.into_iter().take_while(|at| *at != from).collect();
        way.reverse();
        way
    }

    /// ω of a link against one that carries it, in the axes of that.
    fn turns(&self, from: LinkId, to: LinkId) -> On<'g, Vec3> {
        let g = self.kinematics.g;
        let v = &self.kinematics.bare.velocities;
        let way = self.way(from, to).into_iter().rev();
        way.map(|at| g.on(&self.kinematics.bare.links[at]))
            .fold(vector::zero(g), |omega, link| link.up(omega + link.omega(v)))
    }

    /// Taken along from link to link, components of n are its entries of D; (α − α_from)·n at v̇ = 0.
    fn along_the_way(
        &self,
        from: LinkId,
        to: LinkId,
        mut normal: On<'g, Vec3>,
        columns: &mut Columns<'g>,
    ) -> Scalar<'g> {
        let g = self.kinematics.g;
        let mut gyration = g.zero();
        for at in self.way(from, to) {
            let link = g.on(&self.kinematics.bare.links[at]);
            let carrying = self.motions[link.bare.parent].omega;
            let (before, turned) = (link.before(normal), link.down(normal));
            // What turns about an axis is seen alike from before and behind it.
            let (seen, carrying) = match link.bare.motion {
                Motion::Turn { .. } => (before, link.before(carrying)),
                _ => (turned, link.down(carrying)),
            };
            for (velocity, axis) in link.turning() {
                *columns.entry(velocity).or_insert_with(|| g.zero()) += axis.dot(seen);
            }
            let turning = link.omega(&self.kinematics.bare.velocities);
            gyration += (carrying.cross(turning) + link.turning_bias()).dot(seen);
            normal = turned;
        }
        gyration
    }

    fn row(
        &self,
        value: Scalar<'g>,
        mut columns: Columns<'g>,
        bias: Scalar<'g>,
        rate: Scalar<'g>,
    ) -> Moving<'g> {
        let g = self.kinematics.g;
        columns.retain(|_, entry| !entry.is_zero());
        let jet = Jet {
            value: value.bare,
            columns: columns.into_iter().map(|(velocity, entry)| (velocity, entry.bare)).collect(),
            drift: g.zero().bare,
            bias: bias.bare,
            known_rate: Some(rate.bare),
        };
        g.zero().moving(&self.kinematics.bare.velocities, jet)
    }

    /// A vector of a link in the axes of one that carries it.
    fn seen(&self, jet: VectorJet, from: LinkId, to: LinkId, kind: Kind) -> Moving<'g, VectorJet> {
        let kinematics = self.kinematics;
        let (g, v) = (kinematics.g, &kinematics.bare.velocities);
        let mut held = [jet.value, jet.rate, jet.bias].map(|part| g.on(part));
        let mut seen = kinematics.carry(jet, from, to, kind);
        let mut moved = [vector::zero(g); 2];
        for at in kinematics.bare.ancestors(from).into_iter().take_while(|at| *at != to) {
            let link = g.on(&kinematics.bare.links[at]);
            moved = self.turned(at, held, moved).map(|part| link.bare.axes * part);
            held = [vector::zero(g); 3];
            if kind == Kind::Point {
                let slides = link.sliding_by(v).unwrap_or_else(|| vector::zero(g));
                let own_rate = g.on(link.bare.at_drift) + link.bare.axes * slides;
                let own_bias = g.on(link.bare.at_bias) + link.bare.axes * link.sliding_bias();
                held = [link.offset(), own_rate, own_bias];
            }
        }
        let own = self.swept(to, held);
        let [rate, bias] = [moved[0] + own[0], moved[1] + own[1]];
        (seen.jet.rate, seen.jet.bias) = (rate.bare, bias.bare);
        seen
    }

    /// ẋ and ẍ of what a link holds, with its own ṡ and s̈, and of what it carries, in the axes before its motion.
    fn turned(&self, at: LinkId, held: [On<'g, Vec3>; 3], carried: [On<'g, Vec3>; 2]) -> [On<'g, Vec3>; 2] {
        let link = self.kinematics.g.on(&self.kinematics.bare.links[at]);
        let own = self.swept(at, held);
        let [rate, bias] = [0, 1].map(|k| link.turn(carried[k] + own[k]));
        let [held, own_rate, own_bias] = held;
        if !(own_rate.is_zero() && own_bias.is_zero()) {
            return [rate, bias];
        }
        let computed = &mut self.computed.borrow_mut();
        [rate, dynamics::turned(link, &self.motions[at], carried[1], held, Some(computed))]
    }

    /// ω × s + ṡ and U s + 2 ω × ṡ + s̈ of a vector in the axes of a link.
    fn swept(&self, link: LinkId, [value, rate, bias]: [On<'g, Vec3>; 3]) -> [On<'g, Vec3>; 2] {
        if link == GROUND {
            return [rate, bias];
        }
        let LinkMotion { omega, spin, .. } = &self.motions[link];
        let turned = *spin * value + 2.0 * omega.cross(rate);
        [omega.cross(value) + rate, turned + bias]
    }
}
