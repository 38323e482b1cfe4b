//! Positions as sums of vectors that are fixed, or slide, in turning frames.
//!
//! Every frame has one orientation, the pair (c, s) = (cos θ, sin θ), and turns at its own rate ω; frame 0 is the
//! ground. A position is Σ_f A_f d_f with d_f in the axes of frame f. Rotations never compose, and what is fixed in
//! one frame is added up there, once, by the compiler.

use super::flexible::Flexible;
use super::vector::{self, Pair};
use crate::equations::jet::{Jet, Moving};
use crate::model::JointId;
use crate::symbolic::{Bare, Node, On, Sheet};
use std::borrow::Borrow;
use std::collections::BTreeMap;
use std::ops::{Add, Sub};

/// Index of a turning frame in [`Kinematics::frames`].
pub type FrameId = usize;
/// The frame that does not turn.
pub const GROUND: FrameId = 0;

/// A turning frame: A = [[c, −s], [s, c]].
#[derive(Clone, Copy, Debug)]
pub struct TurningFrame {
    pub cos: Node,
    pub sin: Node,
    /// Index of ω among the velocities; `None` for the ground.
    pub rate: Option<usize>,
}

/// A vector in the axes of one turning frame.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalVector {
    /// d.
    pub at: Pair,
    /// ∂ḋ/∂(velocity): constant directions of slides.
    pub slides: BTreeMap<usize, Pair>,
    /// ∂d/∂t and ∂²d/∂t².
    pub drift: Pair,
    pub drift_rate: Pair,
}

/// Σ_f A_f d_f.
#[derive(Clone, Debug, Default)]
pub struct Position {
    pub parts: BTreeMap<FrameId, LocalVector>,
}

/// Where a body is: its origin, and the frame it turns with, up to a constant angle.
#[derive(Clone, Debug)]
pub struct Placement {
    pub origin: Position,
    pub frame: FrameId,
    /// (cos, sin) of the body's orientation relative to its frame.
    pub offset: Pair,
    /// Its modes, if it has any.
    pub flexible: Option<Flexible>,
}

impl TurningFrame {
    pub fn still(g: Sheet) -> Self {
        let [cos, sin] = vector::unturned(g).bare;
        TurningFrame { cos, sin, rate: None }
    }
}

impl LocalVector {
    /// With two velocities, one along each axis.
    pub fn slide_freely(&mut self, g: Sheet, first: usize) {
        let (zero, one) = (g.zero().bare, g.one().bare);
        self.slides.extend([(first, [one, zero]), (first + 1, [zero, one])]);
    }

    pub fn fixed(at: On<Pair>) -> Self {
        let zero = vector::zero(at.g).bare;
        LocalVector { at: at.bare, slides: BTreeMap::new(), drift: zero, drift_rate: zero }
    }

    /// ḋ = Σ slides + ∂d/∂t.
    pub fn rate<'g>(&self, g: Sheet<'g>, velocities: &[Node]) -> On<'g, Pair> {
        let slides = self.slides.iter();
        slides.fold(g.on(self.drift), |rate, (index, e)| rate + g.on(velocities[*index]) * g.on(*e))
    }

    fn combine<'g>(&self, g: Sheet<'g>, other: &Self, join: fn(On<'g, Pair>, Pair) -> On<'g, Pair>) -> Self {
        let zero = vector::zero(g).bare;
        let join = |a: Pair, b: Pair| join(g.on(a), b).bare;
        let mut slides = self.slides.clone();
        for (index, direction) in &other.slides {
            let sum = join(slides.get(index).copied().unwrap_or(zero), *direction);
            if g.on(sum).is_zero() {
                slides.remove(index);
            } else {
                slides.insert(*index, sum);
            }
        }
        LocalVector {
            at: join(self.at, other.at),
            slides,
            drift: join(self.drift, other.drift),
            drift_rate: join(self.drift_rate, other.drift_rate),
        }
    }

    /// In axes turned by an angle that does not move.
    pub fn turned(&self, by: On<Pair>) -> Self {
        let turned = |pair: Pair| by.g.on(pair).turned(by).bare;
        LocalVector {
            at: turned(self.at),
            slides: self.slides.iter().map(|(index, e)| (*index, turned(*e))).collect(),
            drift: turned(self.drift),
            drift_rate: turned(self.drift_rate),
        }
    }

    fn is_zero(&self, g: Sheet) -> bool {
        let none = |pair: Pair| g.on(pair).is_zero();
        none(self.at) && none(self.drift) && none(self.drift_rate) && self.slides.is_empty()
    }
}

impl Position {
    pub fn of(frame: FrameId, vector: LocalVector) -> Self {
        Position { parts: BTreeMap::from([(frame, vector)]) }
    }
}

impl<'g> On<'g, Pair> {
    /// As a position fixed in one frame.
    pub fn fixed_in(self, frame: FrameId) -> On<'g, Position> {
        self.g.on(Position::of(frame, LocalVector::fixed(self)))
    }
}

impl<'g> On<'g, Position> {
    fn combine(self, other: &Position, join: fn(On<'g, Pair>, Pair) -> On<'g, Pair>) -> Self {
        let g = self.g;
        let mut parts = self.bare.parts;
        for (frame, vector) in &other.parts {
            let own = parts.remove(frame).unwrap_or_else(|| LocalVector::fixed(vector::zero(g)));
            let sum = own.combine(g, vector, join);
            if !sum.is_zero(g) {
                parts.insert(*frame, sum);
            }
        }
        g.on(Position { parts })
    }
}

impl Borrow<Position> for On<'_, Position> {
    fn borrow(&self) -> &Position {
        &self.bare
    }
}

impl<'g, B: Borrow<Position>> Add<B> for On<'g, Position> {
    type Output = Self;
    fn add(self, other: B) -> Self {
        self.combine(other.borrow(), |a, b| a + b)
    }
}

impl<'g, B: Borrow<Position>> Sub<B> for On<'g, Position> {
    type Output = Self;
    fn sub(self, other: B) -> Self {
        self.combine(other.borrow(), |a, b| a - b)
    }
}

/// Everything that moves, in one set of velocities.
#[derive(Clone, Debug)]
pub struct Kinematics {
    pub frames: Vec<TurningFrame>,
    /// v.
    pub velocities: Vec<Node>,
    /// One per body.
    pub bodies: Vec<Placement>,
    /// Of the joints whose travel does not follow from their places.
    pub travels: BTreeMap<JointId, Travelled>,
}

/// A travel that is a coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Travelled {
    pub value: Node,
    pub rate: Node,
    /// Of its rate among the velocities, if it is one of these.
    pub index: Option<usize>,
}

impl<'g> On<'g, &'g Kinematics> {
    /// (cos, sin) of a frame.
    fn pair(self, frame: FrameId) -> On<'g, Pair> {
        let TurningFrame { cos, sin, .. } = self.bare.frames[frame];
        self.g.on([cos, sin])
    }

    /// A_f u.
    pub fn to_world(self, frame: FrameId, u: impl Bare<Pair>) -> On<'g, Pair> {
        self.g.on(u.bare()).turned(self.pair(frame))
    }

    /// (cos, sin) of θ_l − θ_k, the columns of A_kᵀ A_l.
    pub fn relative(self, k: FrameId, l: FrameId) -> On<'g, Pair> {
        if k == l {
            return vector::unturned(self.g);
        }
        // Always formed for k < l, so that both signs share one sine.
        let pair = self.pair(k.max(l)).turned(self.pair(k.min(l)).opposite());
        if k < l { pair } else { pair.opposite() }
    }

    /// Orientation of a body as (cos, sin).
    pub fn orientation(self, body: usize) -> On<'g, Pair> {
        let placement = &self.bare.bodies[body];
        self.pair(placement.frame).turned(placement.offset)
    }

    /// A point given in a body's own axes.
    pub fn point(self, body: usize, at: On<'g, Pair>) -> On<'g, Position> {
        let placement = &self.bare.bodies[body];
        self.g.on(placement.origin.clone()) + at.in_frame(placement)
    }

    /// World x and y of a position.
    pub fn world(self, position: &Position) -> [Moving<'g>; 2] {
        let zero = || self.moving(&self.bare.velocities, Jet::constant(self.g.zero()));
        let mut sum = [zero(), zero()];
        for (frame, vector) in &position.parts {
            let part = self.world_part(*frame, vector);
            sum = [&sum[0] + &part[0], &sum[1] + &part[1]];
        }
        sum
    }

    /// u·Δ for u fixed in `frame` and Δ any position difference: what is fixed in the same frame needs no rotation.
    pub fn project(self, frame: FrameId, u: On<'g, Pair>, delta: &Position) -> Moving<'g> {
        let g = self.g;
        let mut others = delta.clone();
        let own = others.parts.remove(&frame);
        let mut sum = self.moving(&self.bare.velocities, Jet::constant(g.zero()));
        if !others.parts.is_empty() {
            let [x, y] = self.world_part(frame, &LocalVector::fixed(u));
            let [dx, dy] = self.world(&others);
            sum = sum + x * dx + y * dy;
        }
        if let Some(own) = own {
            let columns = own.slides.iter().map(|(index, e)| (*index, u.dot(*e).bare));
            let columns = columns.filter(|(_, column)| !g.is_zero(*column)).collect();
            let local = Jet {
                value: u.dot(own.at).bare,
                columns,
                drift: u.dot(own.drift).bare,
                bias: u.dot(own.drift_rate).bare,
                known_rate: None,
            };
            sum = sum + self.moving(&self.bare.velocities, local);
        }
        sum
    }

    /// A d with ẋ = ω × A d + A ḋ and its acceleration −ω² A d + 2 ω × A ḋ + A ∂²d/∂t² at v̇ = 0.
    fn world_part(self, frame: FrameId, d: &LocalVector) -> [Moving<'g>; 2] {
        let g = self.g;
        let velocities = &self.bare.velocities;
        let at = self.to_world(frame, d.at);
        let drift = self.to_world(frame, d.drift);
        let mut bias = self.to_world(frame, d.drift_rate);
        let mut columns = [BTreeMap::new(), BTreeMap::new()];
        let mut moves = |index: usize, column: On<Pair>| {
            for (columns, part) in columns.iter_mut().zip(column.bare) {
                if !g.is_zero(part) {
                    columns.insert(index, part);
                }
            }
        };
        for (index, direction) in &d.slides {
            moves(*index, self.to_world(frame, *direction));
        }
        if let Some(rate) = self.bare.frames[frame].rate {
            let omega = g.on(velocities[rate]);
            let relative = self.to_world(frame, d.rate(g, velocities));
            bias = bias - omega.square() * at + 2.0 * omega * relative.perpendicular();
            moves(rate, at.perpendicular());
        }
        let mut columns = columns.into_iter();
        [0, 1].map(|k| {
            let columns = columns.next().unwrap_or_default();
            let (value, drift, bias) = (at.bare[k], drift.bare[k], bias.bare[k]);
            self.moving(velocities, Jet { value, columns, drift, bias, known_rate: None })
        })
    }
}

impl<'g> On<'g, Pair> {
    /// A place of a body as part of a position, from its origin.
    pub fn in_frame(self, placement: &Placement) -> On<'g, Position> {
        self.arm(placement.frame, self.g.on(placement.offset), placement.flexible.as_ref())
    }

    /// The same of a body that is being placed.
    pub fn arm(self, frame: FrameId, offset: On<'g, Pair>, flexible: Option<&Flexible>) -> On<'g, Position> {
        match flexible {
            None => self.turned(offset).fixed_in(frame),
            Some(flexible) => self.g.on(Position::of(frame, flexible.place(self).turned(offset))),
        }
    }
}
