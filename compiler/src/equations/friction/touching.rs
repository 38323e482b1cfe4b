//! The surfaces of contacts: how they slide on each other at the point P where they touch, pressed together by the contact's own force.
//!
//! ```text
//! v = ṗ₁ + ω₁ × (P − p₁) − ṗ₂ − ω₂ × (P − p₂),    v_t = v − n (n·v)    (m/s)
//! ```
//! of the material of both bodies, p being a place of each, ω of a beam that of the section there, and n the normal. In the plane it is one number, along n turned by a right angle
//! clockwise, which on a half-plane is the direction of its line. Forces along it act on both bodies at P: they are opposite, and turn
//! nothing together.

use super::Slip;
use crate::equations::jet::Moving;
use crate::equations::laws::{Known, Laws};
use crate::model::{Expr, Frame, Load, LoadId, Place, Sliding, Space, Spot};
use crate::symbolic::{Compare, Scalar};

/// Of each gap of a contact.
pub(super) fn slips<'g>(laws: &Laws<'g>, contact: &Load) -> Vec<Slip<'g>> {
    let forces = contact.along().zip(&contact.law);
    let id = laws.mechanism.loads.iter().position(|load| std::ptr::eq(load, contact)).map(LoadId);
    let slips = forces.zip(&contact.slides).enumerate().map(|(which, ((gap, force), sliding))| {
        // Where gates are held, so is what resists.
        let closed = match id.filter(|_| !contact.ungated.is_empty()) {
            Some(id) => laws.g.number(0.5).compare(Compare::Less, laws.gate(id, which)),
            None => laws.value(gap).compare(Compare::Less, laws.g.zero()),
        };
        Slip { pressed: pressing(laws, contact, force), closed: Some(closed), ..slip(laws, sliding) }
    });
    slips.collect()
}

/// What a contact presses with along one of its gaps: nothing while it pulls.
pub(super) fn pressing<'g>(laws: &Laws<'g>, contact: &Load, force: &Expr) -> Scalar<'g> {
    let force = laws.value(force);
    if contact.adheres { force.max(laws.g.zero()) } else { force }
}

/// Without what presses, whose law may name the sliding.
pub(super) fn slip<'g>(laws: &Laws<'g>, sliding: &Sliding) -> Slip<'g> {
    let (zero, one) = (laws.g.zero(), laws.g.one());
    let (along, normal) = match sliding {
        Sliding::Along(slip) => (vec![laws.jet(slip)], Vec::new()),
        Sliding::Surfaces(spot) => {
            // Both name few coordinates, often.
            let known = Known::default();
            let once = laws.knowing(&known);
            let values = |parts: &[Expr]| parts.iter().map(|part| laws.g.on(once.value(part).bare)).collect();
            let (point, normal): (Vec<Scalar>, _) = (values(&spot.point), values(&spot.normal));
            match laws.mechanism.space {
                Space::Planar => (vec![in_plane(laws, spot, &point, &normal)], Vec::new()),
                Space::Spatial => (in_space(laws, spot, &point), normal),
            }
        }
    };
    let along = along.into_iter().map(|it| (it, one)).collect();
    Slip { along, radius: one, pressed: zero, normal, closed: None }
}

/// What of a vector is along a surface, x − n (n·x); all of it where there is no normal.
pub(super) fn beside<'g>(normal: &[Scalar<'g>], x: Vec<Scalar<'g>>) -> Vec<Scalar<'g>> {
    let across = normal.iter().zip(&x).map(|(n, x)| *n * *x).reduce(|a, b| a + b);
    match across {
        Some(across) => x.iter().zip(normal).map(|(x, n)| *x - across * *n).collect(),
        None => x,
    }
}

/// How fast surfaces slide, and the derivative of that at v̇ = 0: one number in the plane; in space v_t along the axes of the world, and what of
/// its derivative is along the surface, v̇ − n (n·v̇) − ṅ (n·v).
pub(super) fn moved<'g>(laws: &Laws<'g>, sliding: &Sliding) -> Vec<[Scalar<'g>; 2]> {
    let spot = match sliding {
        Sliding::Along(slip) => {
            let slip = laws.jet(slip);
            return vec![[slip.rate(), slip.bias()]];
        }
        Sliding::Surfaces(spot) => spot,
    };
    let jets = |parts: &[Expr]| parts.iter().map(|part| laws.jet(part)).collect::<Vec<_>>();
    let (point, normal) = (jets(&spot.point), jets(&spot.normal));
    let values = |jets: &[Moving<'g>]| jets.iter().map(|jet| jet.value()).collect::<Vec<_>>();
    let (at, n) = (values(&point), values(&normal));
    if laws.mechanism.space == Space::Planar {
        let along = in_plane(laws, spot, &at, &n);
        return vec![[along.rate(), along.bias() + turned(laws, spot, &point, &normal)]];
    }
    let along = in_space(laws, spot, &at);
    let wandered = wandered(laws, spot, &point);
    let rates: Vec<Scalar> = along.iter().map(|along| along.rate()).collect();
    let biases: Vec<Scalar> = along.iter().zip(wandered).map(|(along, by)| along.bias() + by).collect();
    let across = n.iter().zip(&rates).map(|(n, rate)| *n * *rate).reduce(|a, b| a + b);
    let turned = beside(&n, biases).into_iter().zip(&normal).map(|(bias, n)| match across {
        Some(across) => bias - across * n.rate(),
        None => bias,
    });
    beside(&n, rates).into_iter().zip(turned).map(|(rate, bias)| [rate, bias]).collect()
}

/// What the wandering of P adds to the derivative of v in space, m/s²: of each body ω × (Ṗ − ṗ); that of the second taken off.
fn wandered<'g>(laws: &Laws<'g>, spot: &Spot, point: &[Moving<'g>]) -> Vec<Scalar<'g>> {
    let [first, second] = [0, 1].map(|which| {
        let place = &spot.places[which];
        let turning = turning(laws, place);
        if turning.is_empty() {
            return vec![laws.g.zero(); point.len()];
        }
        let at = laws.kinematics().world(laws, place);
        let arm: Vec<Scalar> = point.iter().zip(&at).map(|(p, at)| p.rate() - at.rate()).collect();
        let across = |axis: usize| {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            turning[j].rate() * arm[k] - turning[k].rate() * arm[j]
        };
        (0..point.len()).map(across).collect()
    });
    first.into_iter().zip(second).map(|(first, second)| first - second).collect()
}

/// What the turning of t and the wandering of P add to the derivative of t·v, t·v being linear in what moves: of each body
/// ṫ·(ṗ + ω × (P − p)) + t·(ω × (Ṗ − ṗ)), m/s²; that of the second taken off.
fn turned<'g>(laws: &Laws<'g>, spot: &Spot, point: &[Moving<'g>], normal: &[Moving<'g>]) -> Scalar<'g> {
    let (x, y) = (normal[1].value(), -normal[0].value());
    let (x_rate, y_rate) = (normal[1].rate(), -normal[0].rate());
    let [first, second] = [0, 1].map(|which| {
        let place = &spot.places[which];
        let at = laws.kinematics().world(laws, place);
        let along = x_rate * at[0].rate() + y_rate * at[1].rate();
        match turning(laws, place).first() {
            Some(turning) => {
                let [dx, dy] = [0, 1].map(|axis| point[axis].value() - at[axis].value());
                let [dx_rate, dy_rate] = [0, 1].map(|axis| point[axis].rate() - at[axis].rate());
                let lever = y_rate * dx - x_rate * dy + y * dx_rate - x * dy_rate;
                along + lever * turning.rate()
            }
            None => along,
        }
    });
    first - second
}

/// t·v.
fn in_plane<'g>(laws: &Laws<'g>, spot: &Spot, point: &[Scalar<'g>], normal: &[Scalar<'g>]) -> Moving<'g> {
    let (x, y) = (normal[1], -normal[0]);
    let [first, second] = [0, 1].map(|which| {
        let place = &spot.places[which];
        let at = laws.kinematics().world(laws, place);
        let along = x * &at[0] + y * &at[1];
        match turning(laws, place).first() {
            Some(turning) => {
                let lever = y * (point[0] - at[0].value()) - x * (point[1] - at[1].value());
                along + lever * turning
            }
            None => along,
        }
    });
    first - second
}

/// v along the axes of the world.
fn in_space<'g>(laws: &Laws<'g>, spot: &Spot, point: &[Scalar<'g>]) -> Vec<Moving<'g>> {
    let [first, second] = [0, 1].map(|which| {
        let place = &spot.places[which];
        let at = laws.kinematics().world(laws, place);
        let turning = turning(laws, place);
        if turning.is_empty() {
            return at;
        }
        let arm: Vec<Scalar> = point.iter().zip(&at).map(|(p, at)| *p - at.value()).collect();
        let axes = at.iter().enumerate();
        axes.map(|(axis, at)| {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            at + (arm[k] * &turning[j] - arm[j] * &turning[k])
        })
        .collect()
    });
    first.iter().zip(&second).map(|(first, second)| first - second).collect()
}

/// ω of the material at a place about the axes of the world, in the plane one; nothing of what does not turn.
fn turning<'g>(laws: &Laws<'g>, place: &Place) -> Vec<Moving<'g>> {
    match place.frame {
        Frame::Body(body) if laws.mechanism.bodies[body.0].form.turns => {
            laws.kinematics().turning_at(laws, place)
        }
        _ => Vec::new(),
    }
}
