//! Positions as sums of vectors that are fixed, or slide, in turning frames.
//!
//! Every frame has one orientation, the pair (c, s) = (cos θ, sin θ), and turns at its own rate ω; frame 0 is the
//! ground. A position is Σ_f A_f d_f with d_f in the axes of frame f. Rotations never compose, and what is fixed in
//! one frame is added up there, once, by the compiler.

use crate::equations::jet::Jet;
use crate::symbolic::{Graph, Node};
use std::collections::BTreeMap;

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
#[derive(Clone, Debug)]
pub struct LocalVector {
    /// d.
    pub at: [Node; 2],
    /// ∂ḋ/∂(velocity): constant directions of slides.
    pub slides: BTreeMap<usize, [Node; 2]>,
    /// ∂d/∂t and ∂²d/∂t².
    pub drift: [Node; 2],
    pub drift_rate: [Node; 2],
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
    pub offset: [Node; 2],
}

impl LocalVector {
    pub fn fixed(g: &mut Graph, at: [Node; 2]) -> Self {
        let zero = [g.constant(0.0); 2];
        LocalVector { at, slides: BTreeMap::new(), drift: zero, drift_rate: zero }
    }

    /// ḋ = Σ slides + ∂d/∂t.
    pub fn rate(&self, g: &mut Graph, velocities: &[Node]) -> [Node; 2] {
        let mut rate = self.drift;
        for (index, direction) in &self.slides {
            for axis in 0..2 {
                let term = g.mul(direction[axis], velocities[*index]);
                rate[axis] = g.add(rate[axis], term);
            }
        }
        rate
    }

    fn combine(&self, g: &mut Graph, other: &Self, subtract: bool) -> Self {
        let zero = [g.constant(0.0); 2];
        let join = |g: &mut Graph, a: [Node; 2], b: [Node; 2]| {
            if subtract {
                [g.sub(a[0], b[0]), g.sub(a[1], b[1])]
            } else {
                [g.add(a[0], b[0]), g.add(a[1], b[1])]
            }
        };
        let mut slides = self.slides.clone();
        for (index, direction) in &other.slides {
            let own = slides.get(index).copied().unwrap_or(zero);
            let sum = join(g, own, *direction);
            if g.is_zero(sum[0]) && g.is_zero(sum[1]) {
                slides.remove(index);
            } else {
                slides.insert(*index, sum);
            }
        }
        LocalVector {
            at: join(g, self.at, other.at),
            slides,
            drift: join(g, self.drift, other.drift),
            drift_rate: join(g, self.drift_rate, other.drift_rate),
        }
    }

    fn is_zero(&self, g: &Graph) -> bool {
        let none = |pair: &[Node; 2]| g.is_zero(pair[0]) && g.is_zero(pair[1]);
        none(&self.at) && none(&self.drift) && none(&self.drift_rate) && self.slides.is_empty()
    }
}

impl Position {
    /// A vector fixed in one frame.
    pub fn fixed(g: &mut Graph, frame: FrameId, at: [Node; 2]) -> Self {
        Position::of(frame, LocalVector::fixed(g, at))
    }

    pub fn of(frame: FrameId, vector: LocalVector) -> Self {
        Position { parts: BTreeMap::from([(frame, vector)]) }
    }

    pub fn add(&self, g: &mut Graph, other: &Position) -> Position {
        self.combine(g, other, false)
    }

    pub fn sub(&self, g: &mut Graph, other: &Position) -> Position {
        self.combine(g, other, true)
    }

    fn combine(&self, g: &mut Graph, other: &Position, subtract: bool) -> Position {
        let mut parts = self.parts.clone();
        for (frame, vector) in &other.parts {
            let own = match parts.remove(frame) {
                Some(own) => own,
                None => {
                    let zero = [g.constant(0.0); 2];
                    LocalVector::fixed(g, zero)
                }
            };
            let sum = own.combine(g, vector, subtract);
            if !sum.is_zero(g) {
                parts.insert(*frame, sum);
            }
        }
        Position { parts }
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
}

/// (cos, sin) of the sum of two angles.
pub fn compose(g: &mut Graph, a: [Node; 2], b: [Node; 2]) -> [Node; 2] {
    let (cc, ss) = (g.mul(a[0], b[0]), g.mul(a[1], b[1]));
    let (sc, cs) = (g.mul(a[1], b[0]), g.mul(a[0], b[1]));
    [g.sub(cc, ss), g.add(sc, cs)]
}

/// A vector turned by an angle given as (cos, sin).
pub fn rotate(g: &mut Graph, pair: [Node; 2], d: [Node; 2]) -> [Node; 2] {
    compose(g, d, pair)
}

/// (cos, sin) of the opposite angle.
pub fn inverse(g: &mut Graph, pair: [Node; 2]) -> [Node; 2] {
    [pair[0], g.neg(pair[1])]
}

impl Kinematics {
    /// A_f u.
    pub fn to_world(&self, g: &mut Graph, frame: FrameId, u: [Node; 2]) -> [Node; 2] {
        let TurningFrame { cos, sin, .. } = self.frames[frame];
        rotate(g, [cos, sin], u)
    }

    /// (cos, sin) of θ_l − θ_k, the columns of A_kᵀ A_l.
    pub fn relative(&self, g: &mut Graph, k: FrameId, l: FrameId) -> [Node; 2] {
        if k == l {
            return [g.constant(1.0), g.constant(0.0)];
        }
        let (a, b) = (self.frames[k], self.frames[l]);
        // Always formed for k < l, so that both signs share one sine.
        let (a, b, swapped) = if k < l { (a, b, false) } else { (b, a, true) };
        let (cc, ss) = (g.mul(a.cos, b.cos), g.mul(a.sin, b.sin));
        let (cs, sc) = (g.mul(a.cos, b.sin), g.mul(a.sin, b.cos));
        let (cos, sin) = (g.add(cc, ss), g.sub(cs, sc));
        [cos, if swapped { g.neg(sin) } else { sin }]
    }

    /// Orientation of a body as (cos, sin).
    pub fn orientation(&self, g: &mut Graph, body: usize) -> [Node; 2] {
        let placement = &self.bodies[body];
        let frame = self.frames[placement.frame];
        compose(g, [frame.cos, frame.sin], placement.offset)
    }

    /// A point given in a body's own axes.
    pub fn point(&self, g: &mut Graph, body: usize, at: [Node; 2]) -> Position {
        let placement = &self.bodies[body];
        let local = rotate(g, placement.offset, at);
        let arm = Position::fixed(g, placement.frame, local);
        placement.origin.add(g, &arm)
    }

    /// World x and y of a position.
    pub fn world(&self, g: &mut Graph, position: &Position) -> [Jet; 2] {
        let zero = g.constant(0.0);
        let mut sum = [Jet::constant(g, zero), Jet::constant(g, zero)];
        for (frame, vector) in &position.parts {
            let part = self.world_part(g, *frame, vector);
            sum = [sum[0].add(g, &part[0]), sum[1].add(g, &part[1])];
        }
        sum
    }

    /// u·Δ for u fixed in `frame` and Δ any position difference: what is fixed in the same frame needs no rotation.
    pub fn project(&self, g: &mut Graph, frame: FrameId, u: [Node; 2], delta: &Position) -> Jet {
        let mut others = delta.clone();
        let own = others.parts.remove(&frame);
        let mut sum = {
            let zero = g.constant(0.0);
            Jet::constant(g, zero)
        };
        if !others.parts.is_empty() {
            let at = LocalVector::fixed(g, u);
            let direction = self.world_part(g, frame, &at);
            let difference = self.world(g, &others);
            for axis in 0..2 {
                let product = direction[axis].mul(g, &difference[axis], &self.velocities);
                sum = sum.add(g, &product);
            }
        }
        if let Some(own) = own {
            let dot = |g: &mut Graph, w: [Node; 2]| {
                let (x, y) = (g.mul(u[0], w[0]), g.mul(u[1], w[1]));
                g.add(x, y)
            };
            let columns = own.slides.iter().map(|(index, e)| (*index, dot(g, *e))).collect::<Vec<_>>();
            let local = Jet {
                value: dot(g, own.at),
                columns: columns.into_iter().filter(|(_, column)| !g.is_zero(*column)).collect(),
                drift: dot(g, own.drift),
                bias: dot(g, own.drift_rate),
                known_rate: None,
            };
            sum = sum.add(g, &local);
        }
        sum
    }

    /// A d with ẋ = ω × A d + A ḋ and its acceleration −ω² A d + 2 ω × A ḋ + A ∂²d/∂t² at v̇ = 0.
    fn world_part(&self, g: &mut Graph, frame: FrameId, d: &LocalVector) -> [Jet; 2] {
        let [x, y] = self.to_world(g, frame, d.at);
        let drift = self.to_world(g, frame, d.drift);
        let mut bias = self.to_world(g, frame, d.drift_rate);
        let mut columns = [BTreeMap::new(), BTreeMap::new()];
        for (index, direction) in &d.slides {
            let world = self.to_world(g, frame, *direction);
            for axis in 0..2 {
                if !g.is_zero(world[axis]) {
                    columns[axis].insert(*index, world[axis]);
                }
            }
        }
        if let Some(rate) = self.frames[frame].rate {
            let omega = self.velocities[rate];
            let square = g.mul(omega, omega);
            let two = g.constant(2.0);
            let local_rate = d.rate(g, &self.velocities);
            let relative = self.to_world(g, frame, local_rate);
            let twice = g.mul(two, omega);
            let (centripetal_x, centripetal_y) = (g.mul(x, square), g.mul(y, square));
            let (coriolis_x, coriolis_y) = (g.mul(relative[1], twice), g.mul(relative[0], twice));
            bias[0] = g.sub(bias[0], centripetal_x);
            bias[0] = g.sub(bias[0], coriolis_x);
            bias[1] = g.sub(bias[1], centripetal_y);
            bias[1] = g.add(bias[1], coriolis_y);
            let minus_y = g.neg(y);
            for (axis, column) in [minus_y, x].into_iter().enumerate() {
                if !g.is_zero(column) {
                    columns[axis].insert(rate, column);
                }
            }
        }
        let [columns_x, columns_y] = columns;
        [
            Jet { value: x, columns: columns_x, drift: drift[0], bias: bias[0], known_rate: None },
            Jet { value: y, columns: columns_y, drift: drift[1], bias: bias[1], known_rate: None },
        ]
    }
}
