//! Joints that stand in one spot: a hinge in space may be drawn anywhere along its axis, and so they stand beside each other.

use crate::drawing::Hinge;
use crate::drawing::load::Effort;
use crate::drawing::shapes::away;
use crate::drawing::vector::along;
use crate::drawing::view::{Spot, View};
use crate::forms::Spans;

/// From one symbol to the next, and how far a hinge is moved at most, units.
const APART: f64 = 5.0;
const SHIFTS: [f64; 9] = [0.0, 4.0, -4.0, 6.0, -6.0, 8.0, -8.0, 11.0, -11.0];

/// The joints, with hinges moved along their axes where others stand in their spot.
pub fn apart(view: &View, unit: f64, hinges: &[Hinge]) -> Vec<Hinge> {
    // Those that cannot be moved first.
    let mut taken: Vec<Spot> =
        hinges.iter().filter(|hinge| !can_move(hinge)).map(|hinge| view.spot(hinge.at)).collect();
    let mut placed = hinges.to_vec();
    for hinge in placed.iter_mut().filter(|hinge| can_move(hinge)) {
        let at = |shift: f64| along(hinge.at, shift * unit / view.scale, hinge.axis);
        let nearest = |shift: f64| {
            let spot = view.spot(at(shift));
            taken.iter().map(|other| away(*other, spot)).fold(f64::INFINITY, f64::min)
        };
        let free = SHIFTS.into_iter().find(|shift| nearest(*shift) >= APART * unit);
        let farthest = || SHIFTS.into_iter().max_by(|a, b| nearest(*a).total_cmp(&nearest(*b)));
        hinge.at = at(free.or_else(farthest).unwrap_or(0.0));
        taken.push(view.spot(hinge.at));
    }
    placed
}

/// What acts about an axis, where the hinge with that axis is drawn.
pub fn with_its_hinge(effort: &Effort, hinges: &[Hinge]) -> Effort {
    let mut moved = effort.clone();
    for end in &mut moved.ends {
        let own =
            hinges.iter().find(|hinge| can_move(hinge) && hinge.second == end.at && hinge.axis == end.axis);
        end.at = own.map_or(end.at, |hinge| hinge.at);
    }
    moved
}

/// A hinge.
fn can_move(hinge: &Hinge) -> bool {
    hinge.form.angles.len() == 1 && hinge.form.travels.is_empty() && hinge.form.spans == Spans::Nothing
}
