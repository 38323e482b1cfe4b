//! How far a place (x, y) is out of a closed curve c(φ) = (b + r(φ)) e_r(φ), along the axes of the curve.
//!
//! ```text
//! (p − c(φ))·c′(φ) = 0,    d = n·(p − c(φ)),    n = (r e_r − r′ e_φ)/√(r² + r′²)
//! ∂d/∂p = n,    ∂²d/∂p² = κ/(1 + κ d) t tᵀ,    κ = (r² + 2 r′² − r r″)/(r² + r′²)^1.5
//! ```
//! b + r written r (Gilbarg, Trudinger, *Elliptic Partial Differential Equations of Second Order*, 14.6). The foot φ is found by Newton's method from the angle of p, in passes that are written out: d is least there, so that
//! what is left of φ enters it squared. Where the curve is hollow and p so far out that another foot is nearer, its slope is kept from zero.

use crate::model::{Curve, LookUp};
use crate::symbolic::{Orders, Scalar, Unary};

/// ρ², m²: below it a place is in the middle.
const TINY: f64 = 1e-24;
/// Of |c′|²: the least slope of (p − c)·c′.
const LEAST: f64 = 0.25;

/// The point of a curve that is nearest to a place.
pub struct Foot<'g> {
    /// d, m.
    distance: Scalar<'g>,
    normal: [Scalar<'g>; 2],
    /// κ/(1 + κ d).
    bent: Scalar<'g>,
}

impl<'g> Foot<'g> {
    /// If it is a curve that is asked for.
    pub fn of(look_up: &LookUp, arguments: &[Scalar<'g>]) -> Option<Self> {
        let (Curve::Profile { pieces, period: [start, length], passes }, [x, y, base]) =
            (&*look_up.curve, arguments)
        else {
            return None;
        };
        let g = x.g;
        let table = g.graph().enter(pieces);
        let far = (x.square() + y.square()).max(g.number(TINY)).sqrt();
        let azimuth = y.atan2(*x);
        let mut beside = g.zero();
        for _ in 0..*passes {
            let Polar { r, first, second, out, across } =
                polar(table, [*start, *length], *base, azimuth, beside, far);
            let square = r.square() + first.square();
            let slope = square - out * (second - r) - 2.0 * (across * first);
            beside += (out * first + across * r) / slope.max(LEAST * square);
        }
        let Polar { r, first, second, out, across } =
            polar(table, [*start, *length], *base, azimuth, beside, far);
        let square = r.square() + first.square();
        let inverse = square.sqrt().reciprocal();
        let (along, aside) = (r * inverse, -(first * inverse));
        let distance = along * out + aside * across;
        let curvature = (square + first.square() - r * second) * (inverse * inverse.square());
        let (sin, cos) = (beside.sin(), beside.cos());
        let [cos, sin] = [(*x * cos - *y * sin) / far, (*y * cos + *x * sin) / far];
        let normal = [along * cos - aside * sin, along * sin + aside * cos];
        Some(Foot { distance, normal, bent: curvature / (1.0 + curvature * distance) })
    }

    /// d, or its derivatives by x and y up to the second.
    pub fn derivative(&self, orders: Orders) -> Scalar<'g> {
        let [x, y] = self.normal;
        match (orders.first(), orders.second()) {
            (0, 0) => self.distance,
            (1, 0) => x,
            (0, 1) => y,
            (2, 0) => self.bent * y.square(),
            (1, 1) => -(self.bent * (x * y)),
            _ => self.bent * x.square(),
        }
    }
}

/// A curve at an angle, and a place from there.
struct Polar<'g> {
    /// With the base.
    r: Scalar<'g>,
    first: Scalar<'g>,
    second: Scalar<'g>,
    /// Along e_r and e_φ.
    out: Scalar<'g>,
    across: Scalar<'g>,
}

/// At φ = φ_p + δ, φ_p the angle of the place, ρ its distance: (p − c)·e_r = ρ cos δ − r, (p − c)·e_φ = −ρ sin δ.
fn polar<'g>(
    table: u16,
    [start, length]: [f64; 2],
    base: Scalar<'g>,
    azimuth: Scalar<'g>,
    beside: Scalar<'g>,
    far: Scalar<'g>,
) -> Polar<'g> {
    let angle = azimuth + beside;
    let angle = angle - length * ((angle - start) / length).unary(Unary::Floor);
    let cell = angle.cell(table);
    let [r, first, second] = [0, 1, 2].map(|order| angle.piece(table, order, cell));
    let r = r + base;
    Polar { r, first, second, out: far * beside.cos() - r, across: -(far * beside.sin()) }
}
