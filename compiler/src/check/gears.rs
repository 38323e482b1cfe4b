//! Rules and warnings of toothings that mesh: modules, distances, contact, undercut, tips in each other's way.

use super::warnings::Wanted;
use crate::diagnostics::{Diagnostics, Lint};
use crate::forms::Rim;
use crate::messages;
use crate::model::gears::stiffness::{Body, Tooth};
use crate::model::gears::{Meeting, Mesh, Pair, Toothing, involute, spurs};
use crate::model::{ConstraintKind, Mechanism};

/// Of the distance that teeth without play have.
const DISTANCE: f64 = 1e-6;
/// Two numbers that are written the same.
const SAME: f64 = 1e-9;
/// What the shifts of two wheels may add up to, in modules, each ending within 2.
const MOST_SHIFTED: f64 = 4.0;
/// Below this contact ratio errors of manufacture part the teeth.
const LOW: f64 = 1.1;
const WIDTHS: std::ops::RangeInclusive<f64> = 3.0..=40.0;

// Teeth that a gear holds do not give. Teeth that mesh have one module, one pressure angle and fitting helices; a ring has more teeth than what runs in it, and the axes stand
// where the teeth touch on both sides; at any time some teeth touch; and no tips run into each other.
pub fn pairs_mesh(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    // Those of rows come first.
    let rows = mechanism.constraints.iter().filter(|it| matches!(it.kind, ConstraintKind::Teeth { .. }));
    let rigid = rows.count();
    for (at, pair) in mechanism.pairs.iter().enumerate() {
        let toothings = pair.on.map(|id| mechanism.toothing(id));
        let same = |other: &&Pair| other.on == pair.on || other.on == [pair.on[1], pair.on[0]];
        if at >= rigid
            && let Some(first) = mechanism.pairs[..rigid].iter().find(same)
        {
            let names = toothings.map(|it| it.text.as_str());
            let message = messages::mesh_beside_gear(&pair.name.text, names, &first.name.text);
            let note = messages::first_here(&first.name.text);
            diagnostics.conflict(pair.name.span, message, first.name.span, note);
        } else if let Some(message) = unlike(pair.meeting, toothings).or_else(|| apart(mechanism, pair)) {
            diagnostics.error(pair.name.span, message);
        }
    }
}

fn unlike(meeting: Meeting, [first, second]: [&Toothing; 2]) -> Option<String> {
    let differ = |a: f64, b: f64| (a - b).abs() > SAME * (a.abs() + b.abs());
    let names = [first.text.as_str(), second.text.as_str()];
    // The modules and angles of a worm have been compared with those of its wheel.
    let is_worm = meeting == Meeting::Worm;
    if !is_worm && differ(first.module, second.module) {
        return Some(messages::modules_differ(names[0], names[1], [first.module, second.module]));
    }
    let degrees = [first, second].map(|it| it.pressure_angle.to_degrees());
    if differ(degrees[0], degrees[1]) {
        return Some(messages::pressure_angles_differ(names[0], names[1], degrees));
    }
    let ring = first.is_internal() || second.is_internal();
    let helices = [first, second].map(|it| it.helix.to_degrees());
    if !is_worm && differ(helices[0], if ring { helices[1] } else { -helices[1] }) {
        return Some(messages::helices_differ(names[0], names[1], helices, ring));
    }
    let [wheel, other] = in_ring([first, second]);
    if ring && other.teeth <= wheel.teeth {
        return Some(messages::ring_too_small([&wheel.text, &other.text], [wheel.teeth, other.teeth]));
    }
    None
}

/// The wheel first, then the ring.
fn in_ring([first, second]: [&Toothing; 2]) -> [&Toothing; 2] {
    if first.is_internal() { [second, first] } else { [first, second] }
}

fn apart(mechanism: &Mechanism, pair: &Pair) -> Option<String> {
    let ([first, second], mesh) = mechanism.mesh_of(pair);
    let (found, names) = (pair.distance(), [first.text.as_str(), second.text.as_str()]);
    let is_wrong = mesh.nominal.is_nan() || (found - mesh.nominal).abs() > DISTANCE * mesh.nominal;
    match pair.meeting {
        Meeting::Cylinders if mesh.nominal.is_nan() => {
            return Some(messages::no_distance(names, least_shifts([first, second])));
        }
        Meeting::Cylinders if is_wrong => {
            let shift = mesh.working_angle.map(|working| shifts([first, second], working));
            let shift = shift.filter(|shift| shift.abs() <= MOST_SHIFTED);
            return Some(messages::wrong_distance(names[0], names[1], found, mesh.nominal, shift));
        }
        Meeting::Rack | Meeting::Worm if is_wrong => {
            let toothing = [first, second][pair.wheel];
            let shift = toothing.shift + (found - mesh.nominal) / toothing.module;
            let names = [names[pair.wheel], names[1 - pair.wheel]];
            let is_worm = pair.meeting == Meeting::Worm;
            return Some(messages::rack_wrong_distance(names, is_worm, [found, mesh.nominal], shift));
        }
        // Of cones it has been judged where they roll.
        Meeting::Cylinders | Meeting::Rack | Meeting::Worm | Meeting::Cones(_) => {}
    }
    if mesh.contact_ratio + mesh.overlap < 1.0 {
        return Some(messages::teeth_lose_contact(names[0], names[1], mesh.contact_ratio + mesh.overlap));
    }
    let overlap = tips_in_ring([first, second], &mesh, found);
    if let Some(overlap) = overlap {
        let [wheel, ring] = in_ring([first, second]);
        return Some(messages::tips_collide([&wheel.text, &ring.text], [wheel.teeth, ring.teeth], overlap));
    }
    None
}

/// What the shifts must add up to at least, so that teeth without play touch somewhere: there α_w is zero.
fn least_shifts(toothings: [&Toothing; 2]) -> f64 {
    shifts(toothings, 0.0)
}

/// What the shifts add up to (of a ring: that of the ring less that of the wheel) where teeth without play have this working angle.
fn shifts(toothings: [&Toothing; 2], working: f64) -> f64 {
    let [wheel, other] = in_ring(toothings);
    let teeth = if other.is_internal() { other.teeth - wheel.teeth } else { wheel.teeth + other.teeth };
    (involute(working) - involute(wheel.transverse_angle())) * teeth / (2.0 * libm::tan(wheel.pressure_angle))
}

/// By how much the tip of a wheel enters that of its ring where their tip circles cross: the tip corner of the wheel must stand in the ring's
/// space,
/// z_w(θ_w + inv α_a − inv α_w) < z_r(θ_r + inv α_r − inv α_w) (trochoid
/// interference; Colbourne, The Geometry of Involute Gears, 1987, section 8.5).
fn tips_in_ring(toothings: [&Toothing; 2], mesh: &Mesh, distance: f64) -> Option<f64> {
    let [wheel, ring] = in_ring(toothings);
    if !ring.is_internal() {
        return None;
    }
    let (a, b, c) = (distance, wheel.tip_radius(), ring.tip_radius());
    // The tip circles cross only where the ring's is no larger than the wheel reaches.
    let of_wheel = (c * c - a * a - b * b) / (2.0 * a * b);
    let of_ring = (a * a + c * c - b * b) / (2.0 * a * c);
    if of_wheel.abs() > 1.0 || of_ring.abs() > 1.0 {
        return None;
    }
    let (on_wheel, on_ring) = (libm::acos(of_wheel), libm::acos(of_ring));
    let at =
        |toothing: &Toothing, radius: f64| involute(libm::acos((toothing.base_radius() / radius).min(1.0)));
    let working = involute(mesh.working_angle?);
    let left = wheel.teeth * (on_wheel + at(wheel, b) - working);
    let right = ring.teeth * (on_ring + at(ring, c) - working);
    let margin = left - right;
    (margin < 0.0).then(|| -margin / ring.teeth * c).filter(|overlap| *overlap > 1e-9 * c)
}

// Wheels that one body carries around do not touch each other.
pub fn planets_pass(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    for (at, one) in mechanism.pairs.iter().enumerate() {
        for other in &mechanism.pairs[..at] {
            if [one, other].iter().any(|pair| pair.meeting != Meeting::Cylinders || pair.axes_move) {
                continue;
            }
            // Around one wheel, held by one carrier: two others at their places.
            let Some([a, b]) = around(one, other) else { continue };
            let [from, to] = [a, b].map(|(pair, flipped)| {
                let sign = if flipped { -1.0 } else { 1.0 };
                [sign * pair.between[0], sign * pair.between[1]]
            });
            let [first, second] =
                [a, b].map(|(pair, flipped)| mechanism.toothing(pair.on[usize::from(!flipped)]));
            let center = mechanism.toothing(one.on[usize::from(a.1)]);
            // Two of three that all mesh with each other touch where they should.
            let ends = [a, b].map(|(pair, flipped)| pair.on[usize::from(!flipped)]);
            let mesh = mechanism.pairs.iter().any(|pair| ends.iter().all(|end| pair.on.contains(end)));
            if mesh || first.is_internal() || second.is_internal() || center.is_internal() {
                continue;
            }
            let distance = libm::hypot(from[0] - to[0], from[1] - to[1]);
            let tips = first.tip_radius() + second.tip_radius();
            if distance < tips * (1.0 - SAME) && distance > 0.0 && same_plane(first, second) {
                let message = messages::planets_collide(&first.text, &second.text, distance, tips);
                diagnostics.error(one.name.span, message);
                return;
            }
        }
    }
}

/// Wheels of one size are taken to be in one plane.
fn same_plane(first: &Toothing, second: &Toothing) -> bool {
    first.teeth == second.teeth && (first.module - second.module).abs() <= SAME * first.module
}

type Sided<'p> = (&'p Pair, bool);

/// Two pairs with a toothing in common, and of each whether that is the second one.
fn around<'p>(one: &'p Pair, other: &'p Pair) -> Option<[Sided<'p>; 2]> {
    if one.carrier != other.carrier {
        return None;
    }
    let sides = [(0, 0), (0, 1), (1, 0), (1, 1)];
    let (a, b) = sides.into_iter().find(|(a, b)| one.on[*a] == other.on[*b])?;
    (one.on[1 - a] != other.on[1 - b]).then_some([(one, a == 1), (other, b == 1)])
}

// Teeth are not undercut, tips do not reach below base circles, contact ratios are not low, and faces are as wide as those of gears.
pub(super) fn teeth_are_sound(mechanism: &Mechanism, wanted: &mut Wanted) {
    let mut told: Vec<&str> = Vec::new();
    for pair in &mechanism.pairs {
        let ([first, second], mesh) = mechanism.mesh_of(pair);
        for toothing in [first, second] {
            if told.contains(&toothing.text.as_str()) {
                continue;
            }
            told.push(&toothing.text);
            if let Some(message) = undercut(toothing) {
                wanted.push(Lint::Teeth, toothing.name.span, message);
            }
            if toothing.is_internal() && toothing.tip_radius() < toothing.base_radius() {
                let message =
                    messages::ring_inside_base(&toothing.text, toothing.tip_radius(), toothing.base_radius());
                wanted.push(Lint::Teeth, toothing.name.span, message);
            }
            let ratio = toothing.face_width.map_or(10.0, |width| width / toothing.module);
            if !WIDTHS.contains(&ratio) {
                wanted.push(
                    Lint::Proportion,
                    toothing.name.span,
                    messages::odd_face_width(&toothing.text, ratio),
                );
            }
        }
        for (cut, [own, other]) in mesh.clamped.into_iter().zip([[first, second], [second, first]]) {
            if cut {
                let ratios = [mesh.contact_ratio, mesh.unclamped_ratio];
                wanted.push(
                    Lint::Teeth,
                    pair.name.span,
                    messages::interference(&own.text, &other.text, ratios),
                );
            }
        }
        if mesh.contact_ratio + mesh.overlap < LOW {
            let message =
                messages::low_contact_ratio(&first.text, &second.text, mesh.contact_ratio + mesh.overlap);
            wanted.push(Lint::Teeth, pair.name.span, message);
        }
    }
}

/// A wheel is undercut where its teeth are few, a bevel gear where those of the spur gear that it is like are.
fn undercut(toothing: &Toothing) -> Option<String> {
    let least = toothing.least_teeth();
    match toothing.form.rim {
        Rim::External if toothing.teeth < least => {
            let sine = libm::sin(toothing.transverse_angle());
            let shift = toothing.addendum - toothing.teeth * sine * sine / (2.0 * libm::cos(toothing.helix));
            Some(messages::undercut(&toothing.text, toothing.teeth, least, shift))
        }
        Rim::Bevel if toothing.virtual_spur().teeth < least => {
            let same = toothing.virtual_spur().teeth;
            Some(messages::bevel_undercut(&toothing.text, toothing.teeth, same, least))
        }
        Rim::External | Rim::Internal | Rim::Rack | Rim::Bevel | Rim::Worm => None,
    }
}

// Wheels whose body counts in the stiffness of their teeth have teeth and bores of the sizes that its formula was made for.
pub(super) fn bodies_are_known(mechanism: &Mechanism, wanted: &mut Wanted) {
    let mut told: Vec<&str> = Vec::new();
    for load in &mechanism.loads {
        let Some(teeth) = &load.teeth else { continue };
        if teeth.material.is_none_or(|material| material.tooth != Tooth::Profile) {
            continue;
        }
        let pair = &mechanism.pairs[teeth.pair];
        let (toothings, _) = mechanism.mesh_of(pair);
        for (toothing, spur) in toothings.into_iter().zip(spurs(toothings, pair)) {
            let stands_on_body = !matches!(toothing.form.rim, Rim::Internal | Rim::Rack);
            let body = Body::of(&spur);
            if stands_on_body && !body.is_known() && !told.contains(&toothing.text.as_str()) {
                told.push(&toothing.text);
                let message = messages::body_beyond(&toothing.text, body.half, body.ratio);
                wanted.push(Lint::Teeth, toothing.name.span, message);
            }
        }
    }
}
