//! Vectors with their derivatives as the ground sees them, by ω and U = α̃ + ω̃ ω̃ of the links, which inertia forces need anyway.
//!
//! Along w = at + axes (slide + R u), with ẋ, ẍ as the ground sees them, in the axes of each link, at v̇ = 0:
//!   ẇ = ω × s + ṡ + axes R u̇,   ẅ = U s + 2 ω × ṡ + s̈ + axes R ü,
//! where s = at + axes slide is what the parent holds, and ṡ, s̈ how that moves in it; nothing is turned but the sums.
//! (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 5; Luh, Walker, Paul 1980.)

use super::dynamics::{LinkMotion, motions};
use super::kinematics::{Kinematics, Spot};
use super::links::{GROUND, LinkId};
use super::vector::{self, Vec3};
use super::vector_jet::{Kind, VectorJet};
use crate::equations::jet::{Jet, Moving};
use crate::symbolic::On;
use std::collections::BTreeMap;

/// The links, with their motions at v̇ = 0.
pub struct Inertial<'g> {
    kinematics: On<'g, &'g Kinematics>,
    motions: Vec<LinkMotion<'g>>,
}

impl<'g> Inertial<'g> {
    pub fn new(kinematics: On<'g, &'g Kinematics>) -> Self {
        let motions = motions(kinematics, None, vector::zero(kinematics.g));
        Inertial { kinematics, motions }
    }

    /// A place on a link, as seen from the ground, m: ẋ and ẍ at v̇ = 0 as above, m/s and m/s².
    pub fn point(&self, at: VectorJet, from: LinkId) -> Moving<'g, VectorJet> {
        self.seen(at, from, GROUND, Kind::Point)
    }

    /// u·w of directions that are fixed on the links of two places. With n = u × w the rate is n·(ω₁ − ω₂), so that the entry of D is a·n for a
    /// velocity about a on the way to the first, and −a·n on that to the second; ü·w + 2 u̇·ẇ + u·ẅ at v̇ = 0.
    pub fn cosine(&self, [first, second]: [&Spot<'g>; 2], u: On<'g, Vec3>, w: On<'g, Vec3>) -> Moving<'g> {
        let kinematics = self.kinematics;
        let g = kinematics.g;
        let ends = [first.link, second.link];
        let meeting = kinematics.bare.meeting(ends[0], ends[1]);
        let seen = |fixed: On<'g, Vec3>, link: LinkId| {
            self.seen(VectorJet::fixed(fixed), link, meeting, Kind::Direction)
        };
        let (u, w) = (seen(u, ends[0]), seen(w, ends[1]));
        let normal = u.value().cross(w.value());
        let mut columns = BTreeMap::new();
        for (end, normal) in ends.into_iter().zip([normal, -normal]) {
            let way = kinematics.bare.ancestors(end);
            for at in way.into_iter().take_while(|at| *at != meeting) {
                for (velocity, axis) in g.on(&kinematics.bare.links[at]).turning() {
                    let axis = kinematics.carry(VectorJet::fixed(axis), at, meeting, Kind::Direction).value();
                    let entry = columns.entry(velocity).or_insert_with(|| g.zero());
                    *entry += axis.dot(normal);
                }
            }
        }
        columns.retain(|_, entry| !entry.is_zero());
        let bias = u.bias().dot(w.value()) + u.value().dot(w.bias()) + 2.0 * u.rate().dot(w.rate());
        let rate = u.rate().dot(w.value()) + u.value().dot(w.rate());
        let jet = Jet {
            value: u.value().dot(w.value()).bare,
            columns: columns.into_iter().map(|(velocity, entry)| (velocity, entry.bare)).collect(),
            drift: g.zero().bare,
            bias: bias.bare,
            known_rate: Some(rate.bare),
        };
        g.zero().moving(&kinematics.bare.velocities, jet)
    }

    /// A vector of a link in the axes of one that carries it.
    fn seen(&self, jet: VectorJet, from: LinkId, to: LinkId, kind: Kind) -> Moving<'g, VectorJet> {
        let kinematics = self.kinematics;
        let (g, v) = (kinematics.g, &kinematics.bare.velocities);
        let [value, rate, bias] = [jet.value, jet.rate, jet.bias].map(|part| g.on(part));
        let mut seen = kinematics.carry(jet, from, to, kind);
        let (mut rate, mut bias) = self.swept(from, value, rate, bias);
        for at in kinematics.bare.ancestors(from).into_iter().take_while(|at| *at != to) {
            let link = g.on(&kinematics.bare.links[at]);
            (rate, bias) = (link.up(rate), link.up(bias));
            if kind == Kind::Point {
                let slides = link.sliding_by(v).unwrap_or_else(|| vector::zero(g));
                let own_rate = g.on(link.bare.at_drift) + link.bare.axes * slides;
                let own_bias = g.on(link.bare.at_bias) + link.bare.axes * link.sliding_bias();
                let own = self.swept(link.bare.parent, link.offset(), own_rate, own_bias);
                (rate, bias) = (rate + own.0, bias + own.1);
            }
        }
        (seen.jet.rate, seen.jet.bias) = (rate.bare, bias.bare);
        seen
    }

    /// ω × s + ṡ and U s + 2 ω × ṡ + s̈ of a vector in the axes of a link.
    fn swept(
        &self,
        link: LinkId,
        value: On<'g, Vec3>,
        rate: On<'g, Vec3>,
        bias: On<'g, Vec3>,
    ) -> (On<'g, Vec3>, On<'g, Vec3>) {
        if link == GROUND {
            return (rate, bias);
        }
        let LinkMotion { omega, spin, .. } = &self.motions[link];
        let turned = *spin * value + 2.0 * omega.cross(rate);
        (omega.cross(value) + rate, turned + bias)
    }
}
