//! Two toothings that mesh: distances, contact ratio, and the sum of angles that both hold.

use super::super::{Frame, JointId, Name, Rotor};
use super::toothing::{Toothing, ToothingId, angle_of_involute, involute};
use super::vector::{V3, scaled};
use std::f64::consts::{PI, TAU};

/// How two toothings stand to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meeting {
    /// Wheels about parallel axes, one of them a ring perhaps.
    Cylinders,
    Rack,
    /// Bevel gears, with Σ between their axes.
    Cones(f64),
    Worm,
}

/// A pair of toothings, of a constraint or of a load.
#[derive(Clone, Debug)]
pub struct Pair {
    /// Of what it is the pair.
    pub name: Name,
    pub on: [ToothingId; 2],
    pub meeting: Meeting,
    /// Whether nothing holds the centres, of a load: then those are as far apart as teeth without play ask for, along x, and there are no terms.
    pub axes_move: bool,
    /// Numbers of teeth.
    pub teeth: [f64; 2],
    /// What holds both centres.
    pub carrier: Frame,
    /// From the first centre to the second one, in the axes of the carrier, m. Of a rack and a worm as far as its line or axis, of cones as long
    /// as these, along x.
    pub between: [f64; 2],
    /// Of parallel axes in space: x and y that `between` counts along, and z along the first wheel's axle, in the axes of the carrier.
    pub axes: Option<[[f64; 3]; 3]>,
    /// And how far the second centre is from the first along the last of them.
    pub beside: f64,
    /// In space the direction of each wheel's axle there, if it has one.
    pub axles: Option<[V3; 2]>,
    /// Σ factor · angle + Σ factor · travel = constant + 2πk, in radians of a pitch: those of the wheels against the carrier.
    pub terms: Vec<(f64, Rotor)>,
    pub travels: Vec<(f64, JointId)>,
    pub constant: f64,
    /// The wheel that the phase of the mesh is counted by: of two the first, else that in the ring, on the rack or driven by the worm; its angle against the carrier less `still`.
    pub wheel: usize,
    pub turns: Vec<(f64, Rotor)>,
    pub still: f64,
    /// Of that wheel: the middle of a tooth about the axle that its angle is counted about, the direction to its partner, and ±1 as its turn counts in the terms.
    pub first: f64,
    pub psi: f64,
    pub side: f64,
    /// Where the teeth of all but cylinders press.
    pub touch: Option<Touch>,
    /// By what the pairs before it fix this one, if they do: pairs and factors, Σ over these and this one is no motion.
    pub follows: Option<Vec<(usize, f64)>>,
}

/// Where pitch surfaces touch, in the axes of the carrier: there the second body is pushed by N `push` + |N| `part`, and the first by the opposite.
#[derive(Clone, Copy, Debug)]
pub struct Touch {
    /// From the centre of one of both to that point.
    pub from: usize,
    pub at: V3,
    /// The part of the normal of the teeth along which they are driven, and that which parts them.
    pub push: V3,
    pub part: V3,
    /// By so much the deflection grows with the sum of the terms.
    pub radius: f64,
}

impl Touch {
    /// The same with the wheels in the other order.
    pub fn reversed(self) -> Touch {
        Touch { from: 1 - self.from, push: scaled(-1.0, self.push), part: scaled(-1.0, self.part), ..self }
    }
}

impl Pair {
    /// a.
    pub fn distance(&self) -> f64 {
        libm::hypot(self.between[0], self.between[1])
    }

    /// What the row of the pair is divided by: teeth of the first of both, of a rack those of its pinion.
    pub fn scale(&self) -> f64 {
        if self.teeth[0] > 0.0 { self.teeth[0] } else { self.teeth[1] }
    }
}

/// What follows from two toothings at the distance of their axes.
#[derive(Clone, Copy, Debug)]
pub struct Mesh {
    /// +1 of two wheels, −1 of a wheel in a ring.
    pub sense: f64,
    /// r_b1 and r_b2.
    pub base: [f64; 2],
    /// a, at which the flanks touch on both sides without play.
    pub nominal: f64,
    /// α_w at the distance of the axes; none where the base circles are further apart.
    pub working_angle: Option<f64>,
    /// ε_α, and what it would be if the path of contact did not end at a base tangent point.
    pub contact_ratio: f64,
    pub unclamped_ratio: f64,
    /// p_b = π m_t cos α_t.
    pub base_pitch: f64,
    /// Where contact begins and ends, along the line of action from the base tangent point of the wheel, of two wheels the first.
    pub path: [f64; 2],
    /// ε_β = b sin β/(π m).
    pub overlap: f64,
    /// Which of the wheels has its base tangent point within the addendum of the other.
    pub clamped: [bool; 2],
}

/// What follows from the toothings of a pair.
pub fn of([first, second]: [&Toothing; 2], pair: &Pair) -> Mesh {
    match pair.meeting {
        Meeting::Cylinders => mesh(first, second, pair.distance()),
        Meeting::Cones(_) => {
            let [one, other] = spurs([first, second], pair);
            mesh(&one, &other, one.pitch_radius() + other.pitch_radius())
        }
        Meeting::Rack | Meeting::Worm => {
            let [wheel, rack] = if pair.wheel == 0 { [first, second] } else { [second, first] };
            let played = if pair.meeting == Meeting::Worm { 0.5 * rack.diameter } else { 0.0 };
            on_rack(wheel, rack, pair.wheel, played)
        }
    }
}

/// What teeth are like in the section in which they mesh: those of cones like the teeth of spur gears, in the middle of their face.
pub fn spurs(toothings: [&Toothing; 2], pair: &Pair) -> [Toothing; 2] {
    match pair.meeting {
        Meeting::Cones(_) => {
            let middle = middle(toothings);
            toothings
                .map(Toothing::virtual_spur)
                .map(|spur| Toothing { module: middle * spur.module, ..spur })
        }
        Meeting::Cylinders | Meeting::Rack | Meeting::Worm => toothings.map(Toothing::clone),
    }
}

/// Where the middle of the face is on cones, as a part of their length; without a face their outer end.
pub fn middle([first, second]: [&Toothing; 2]) -> f64 {
    let cone = first.pitch_radius() / libm::sin(first.cone);
    1.0 - 0.5 * face([first, second]).unwrap_or(0.0) / cone
}

/// The width along which both have teeth.
pub fn face([first, second]: [&Toothing; 2]) -> Option<f64> {
    match (first.face_width, second.face_width) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

/// A wheel on straight flanks, `beyond` its pitch line by so much: contact begins where their tips cross the line of action.
fn on_rack(wheel: &Toothing, rack: &Toothing, which: usize, beyond: f64) -> Mesh {
    let angle = wheel.transverse_angle();
    let (tip, base) = (wheel.tip_radius(), wheel.base_radius());
    let base_pitch = PI * wheel.transverse_module() * libm::cos(angle);
    let shift = wheel.module * wheel.shift;
    let begin =
        wheel.pitch_radius() * libm::sin(angle) - (rack.module * rack.addendum - shift) / libm::sin(angle);
    let end = libm::sqrt((tip * tip - base * base).max(0.0));
    let by_order = |wheel, rack| if which == 0 { [wheel, rack] } else { [rack, wheel] };
    Mesh {
        sense: 1.0,
        base: if which == 0 { [base, 0.0] } else { [0.0, base] },
        nominal: wheel.pitch_radius() + shift + beyond,
        working_angle: Some(angle),
        contact_ratio: (end - begin.max(0.0)) / base_pitch,
        unclamped_ratio: (end - begin) / base_pitch,
        base_pitch,
        path: [begin.max(0.0), end],
        overlap: 0.0,
        clamped: by_order(begin < 0.0, false),
    }
}

/// Of two toothings whose modules and angles agree. Contact ratios: Litvin & Fuentes, Gear Geometry and Applied Theory (2004), 10.5
/// and 11.5.
fn mesh(first: &Toothing, second: &Toothing, distance: f64) -> Mesh {
    let ring = first.is_internal() || second.is_internal();
    // Of a ring the wheel comes first.
    let [wheel, other] = if first.is_internal() { [second, first] } else { [first, second] };
    let angle = first.transverse_angle();
    let sense = if ring { -1.0 } else { 1.0 };
    let (shifts, teeth) = if ring {
        (other.shift - wheel.shift, other.teeth - wheel.teeth)
    } else {
        (wheel.shift + other.shift, wheel.teeth + other.teeth)
    };
    let played = involute(angle) + 2.0 * shifts * libm::tan(first.pressure_angle) / teeth;
    let unshifted = 0.5 * first.transverse_module() * teeth;
    let nominal = match angle_of_involute(played) {
        Some(working) => unshifted * libm::cos(angle) / libm::cos(working),
        None => f64::NAN,
    };
    let reach = (other.base_radius() + sense * wheel.base_radius()).abs();
    let cosine = reach / distance;
    let working_angle = (cosine <= 1.0 && distance > 0.0).then(|| libm::acos(cosine));
    let base_pitch = PI * first.transverse_module() * libm::cos(angle);
    // Lengths along the line of action: from the wheel's base tangent point T₁ on.
    let tangent = distance * working_angle.map_or(0.0, libm::sin);
    let along = |toothing: &Toothing| {
        let (tip, base) = (toothing.tip_radius(), toothing.base_radius());
        libm::sqrt((tip * tip - base * base).max(0.0))
    };
    let (path, open, clamped) = if ring {
        // The ring's tip circle is where contact begins, not before T₁.
        let begin = along(other) - tangent;
        ([begin.max(0.0), along(wheel)], [begin, along(wheel)], [begin < 0.0, false])
    } else {
        let (begin, end) = (tangent - along(other), along(wheel));
        ([begin.max(0.0), end.min(tangent)], [begin, end], [begin < 0.0, end > tangent])
    };
    let clamped = if first.is_internal() { [clamped[1], clamped[0]] } else { clamped };
    let width = face([first, second]).unwrap_or(0.0);
    Mesh {
        sense,
        base: [first.base_radius(), second.base_radius()],
        nominal,
        working_angle,
        contact_ratio: (path[1] - path[0]) / base_pitch,
        unclamped_ratio: (open[1] - open[0]) / base_pitch,
        base_pitch,
        path,
        overlap: width * libm::sin(first.helix.abs()) / (PI * first.module),
        clamped,
    }
}

/// The distance at which the flanks of two cylindrical toothings touch on both sides without play.
pub fn nominal(first: &Toothing, second: &Toothing) -> f64 {
    mesh(first, second, f64::NAN).nominal
}

/// Between which distances of their centres the flanks of two cylindrical toothings can touch: the base circles leave a line of action, and the tip circles
/// cross.
pub fn reach([first, second]: [&Toothing; 2]) -> [f64; 2] {
    let (a, b) = (first.base_radius(), second.base_radius());
    let tips = [first.tip_radius(), second.tip_radius()];
    match (first.is_internal(), second.is_internal()) {
        (false, false) => [a + b, tips[0] + tips[1]],
        // The wheel leaves the teeth of its ring towards the middle, and reaches into its body where it goes out.
        (true, _) => [(a - b).max(tips[0] - tips[1]), first.root_radius() - tips[1]],
        (_, true) => [(b - a).max(tips[1] - tips[0]), second.root_radius() - tips[0]],
    }
}

/// What the sum z₁(θ₁ − θ_c) ± z₂(θ₂ − θ_c) is, but for whole turns, where a tooth of the one faces a space of the other. ψ is the
/// direction from the first centre to the second one, of a ring that from its centre to the wheel's; φ are the middles of teeth about the first axle.
pub fn facing(first: &Toothing, second: &Toothing, between: [f64; 2], [phi1, phi2]: [f64; 2]) -> f64 {
    let [x, y] = between;
    let (z1, z2) = (first.teeth, second.teeth);
    let sum = if second.is_internal() {
        let psi = libm::atan2(-y, -x);
        PI + (z1 - z2) * psi - z1 * phi1 + z2 * phi2
    } else if first.is_internal() {
        let psi = libm::atan2(y, x);
        PI + (z1 - z2) * psi - z1 * phi1 + z2 * phi2
    } else {
        let psi = libm::atan2(y, x);
        PI + z1 * psi + z2 * (psi + PI) - z1 * phi1 - z2 * phi2
    };
    remainder(sum)
}

/// An angle less whole turns, in [−π, π).
pub fn remainder(angle: f64) -> f64 {
    angle - TAU * libm::floor(angle / TAU + 0.5)
}
