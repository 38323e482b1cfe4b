//! What holds the axles of two wheels: a body, or the ground, to which the centres of both are pinned; and which orientations do
//! not change against each other.

use super::super::{BodyId, Expr, Frame, Joint, Mechanism, Place, fold};

/// A place of something, its coordinates numbers.
type Known = (Frame, [f64; 3]);

/// The body, or the ground, in which both places are fixed, and where they are there. `own`: the wheels themselves, which hold nothing.
pub fn carrier(
    mechanism: &Mechanism,
    places: [&Place; 2],
    own: [Frame; 2],
) -> Option<(Frame, [[f64; 3]; 2])> {
    let [first, second] = places.map(|place| pinned(mechanism, place));
    let shared = first.iter().filter(|(frame, _)| !own.contains(frame)).filter_map(|(frame, at)| {
        let (_, other) = second.iter().find(|(other, _)| other == frame)?;
        Some((*frame, [*at, *other]))
    });
    // The ground before bodies: what it holds does not turn.
    shared.min_by_key(|(frame, _)| *frame)
}

/// The places that coincide with one, joint by joint.
pub fn pinned(mechanism: &Mechanism, place: &Place) -> Vec<Known> {
    let Some(start) = known(mechanism, place) else { return Vec::new() };
    let mut found = vec![start];
    let mut at = 0;
    while at < found.len() {
        let here = found[at];
        at += 1;
        for joint in mechanism.joints.iter().filter(|joint| joint.holds() && joint.form.keeps_place) {
            let ends = [known(mechanism, &joint.first), known(mechanism, &joint.second)];
            let [Some(first), Some(second)] = ends else { continue };
            for (near, far) in [(first, second), (second, first)] {
                if same(near, here) && found.iter().all(|(frame, _)| *frame != far.0) {
                    found.push(far);
                }
            }
        }
    }
    found
}

fn same(a: Known, b: Known) -> bool {
    let size = a.1.iter().chain(&b.1).fold(0.0_f64, |most, x| most.max(x.abs()));
    a.0 == b.0 && a.1.iter().zip(b.1).all(|(a, b)| (a - b).abs() <= 1e-9 * size.max(1e-12))
}

/// By how much the second body of a joint that keeps orientation is turned, in the plane.
pub fn turned(mechanism: &Mechanism, joint: &Joint) -> Option<f64> {
    let scalars = joint.form.call.named.iter().filter(|argument| !argument.is_direction());
    match scalars.zip(&joint.scalars).find(|(argument, _)| argument.name == "angle") {
        Some((_, angle)) => fold::evaluate(angle, &mechanism.defaults()),
        None => Some(0.0),
    }
}

/// At the defaults of parameters; none where it moves with time.
pub fn known(mechanism: &Mechanism, place: &Place) -> Option<Known> {
    let value = |expr: &Expr| fold::evaluate(expr, &mechanism.defaults());
    let at: Option<Vec<f64>> = place.at.iter().map(value).collect();
    Some((place.frame, at?.try_into().ok()?))
}

/// Which orientations are fixed against each other, by index of body behind that of the ground: the same number, and the angle
/// against the first of them.
#[derive(Debug)]
pub struct Orientations {
    of: Vec<(usize, f64)>,
}

impl Orientations {
    pub fn of(mechanism: &Mechanism) -> Self {
        let mut of: Vec<(usize, f64)> = (0..=mechanism.bodies.len()).map(|index| (index, 0.0)).collect();
        for joint in mechanism.joints.iter().filter(|joint| joint.holds() && joint.form.keeps_orientation) {
            let Some(angle) = turned(mechanism, joint) else { continue };
            let [(a, of_a), (b, of_b)] =
                [joint.first.frame, joint.second.frame].map(|frame| of[index(frame)]);
            // θ₂ = θ₁ + angle; the ground, which comes first, keeps its number.
            let turn = of_a + angle - of_b;
            let (keep, lose, turn) = if a <= b { (a, b, turn) } else { (b, a, -turn) };
            for entry in of.iter_mut().filter(|(class, _)| *class == lose && keep != lose) {
                *entry = (keep, entry.1 + turn);
            }
        }
        Orientations { of }
    }

    /// The number of what turns with a frame, zero for the ground, and the angle against it.
    pub fn class(&self, frame: Frame) -> (usize, f64) {
        self.of[index(frame)]
    }
}

fn index(frame: Frame) -> usize {
    match frame {
        Frame::Ground => 0,
        Frame::Body(BodyId(index)) => index + 1,
    }
}
