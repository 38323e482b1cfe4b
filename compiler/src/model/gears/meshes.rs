//! Loads between teeth: their stiffness as a series in the angle of a wheel, and their damping, once the pairs are known.

use super::super::{BodyId, Expr, Frame, Load, Mechanism, fold};
use super::Toothing;
use super::holding::Orientations;
use super::pair::{Meeting, Mesh, Pair, face, spurs};
use super::stiffness::{self, Material, Series, Stiffness};
use super::vector::{self, V3};
use super::{about_axes, racks};
use crate::diagnostics::Diagnostics;
use crate::forms::Rim;
use crate::messages;
use std::f64::consts::TAU;

/// Indices of named arguments of `mesh`.
pub const STIFFNESS: usize = 0;
pub const DAMPING: usize = 1;
pub const DAMPING_RATIO: usize = 2;
pub const BACKLASH: usize = 3;
pub const ERROR: usize = 4;
pub const ERROR_RATE: usize = 5;
pub const SENSE: usize = 6;

pub fn settle(mechanism: &mut Mechanism, diagnostics: &mut Diagnostics) {
    let orientations = Orientations::of(mechanism);
    for at in 0..mechanism.loads.len() {
        let Some(teeth) = mechanism.loads[at].teeth.clone() else { continue };
        let pair = &mechanism.pairs[teeth.pair];
        if pair.meeting == Meeting::Worm && teeth.material.is_some() {
            let [first, second] = pair.on.map(|id| &mechanism.toothing(id).text);
            let message = messages::involute_of_threads(first, second);
            diagnostics.error(mechanism.loads[at].name.span, message);
            continue;
        }
        let ([first, second], mesh) = mechanism.mesh_of(pair);
        let load = &mechanism.loads[at];
        let number = |which: usize| fold::evaluate(load.value(which), &mechanism.defaults());
        let mut values = load.values.clone();
        let mut series = None;
        if let Some(material) = teeth.material {
            let Some(exact) = exact(mechanism, pair, material) else {
                let message = messages::involute_without_width(&first.text, &second.text);
                diagnostics.error(load.name.span, message);
                continue;
            };
            let found = exact.series(material.harmonics);
            values[STIFFNESS] = in_angle(&found, phase(pair, [first, second], &mesh, load));
            series = Some(found);
        }
        if let Some(most) = number(BACKLASH).filter(|backlash| *backlash > 0.5 * mesh.base_pitch) {
            diagnostics.error(
                load.name.span,
                messages::backlash_too_wide(&load.name.text, most, 0.5 * mesh.base_pitch),
            );
        }
        if let (Some(ratio), Some(mass)) =
            (number(DAMPING_RATIO), reduced_mass(mechanism, &orientations, pair, &mesh))
        {
            let mean = fold::evaluate(&values[STIFFNESS][0], &mechanism.defaults());
            match (ratio != 0.0, mean.filter(|mean| *mean >= 0.0)) {
                (false, _) => {}
                (true, Some(mean)) => {
                    values[DAMPING] = vec![Expr::Number(2.0 * ratio * libm::sqrt(mean * mass))];
                }
                (true, None) => {
                    let message = messages::ratio_of_changing_stiffness(&load.name.text, mass, ratio);
                    diagnostics.error(load.name.span, message);
                }
            }
        }
        let without = |which: usize| matches!(values[which][..], [Expr::Number(0.0)]);
        let always = values[DAMPING].len() > 1;
        let stores = values[STIFFNESS].len() == 1
            && !values[STIFFNESS][0].varies()
            && without(ERROR)
            && (without(BACKLASH) && !teeth.axes_move || always || without(DAMPING));
        let load = &mut mechanism.loads[at];
        load.values = values;
        if let Some(teeth) = &mut load.teeth {
            (teeth.series, teeth.stores) = (series, stores);
        }
    }
}

/// Of a load between teeth whose stiffness follows from their shape: that stiffness, and the series that the equations have.
pub fn by_shape<'m>(mechanism: &Mechanism, load: &'m Load) -> Option<(Stiffness, &'m Series)> {
    let teeth = load.teeth.as_ref()?;
    let exact = exact(mechanism, &mechanism.pairs[teeth.pair], teeth.material?)?;
    Some((exact, teeth.series.as_ref()?))
}

/// The stiffness of a pair by the shape of its teeth, if their width is known.
fn exact(mechanism: &Mechanism, pair: &Pair, material: Material) -> Option<Stiffness> {
    let (toothings, mesh) = mechanism.mesh_of(pair);
    let mut wheels = spurs(toothings, pair);
    wheels.rotate_left(pair.wheel);
    let distance = match pair.meeting {
        Meeting::Cones(_) => wheels[0].pitch_radius() + wheels[1].pitch_radius(),
        Meeting::Cylinders | Meeting::Rack | Meeting::Worm => pair.distance(),
    };
    Some(Stiffness::new(wheels, mesh, distance, face(toothings)?, material))
}

/// The phase τ where the turns of the wheel are zero, and the sense in which it grows with them.
pub fn phase(pair: &Pair, toothings: [&Toothing; 2], mesh: &Mesh, load: &Load) -> [f64; 2] {
    let sense = match load.value(SENSE) {
        Expr::Number(sense) if *sense < 0.0 => -1.0,
        _ => 1.0,
    };
    // Where a ring drives, its wheel is touched from behind.
    let sense = pair.side * sense;
    let turned = pair.teeth[pair.wheel] * (pair.still + pair.first - pair.psi) / TAU;
    [stiffness::phase(&spurs(toothings, pair)[pair.wheel], mesh) + sense * turned, sense]
}

/// Σ a cos 2πhτ + b sin 2πhτ with 2πτ = 2πτ₀ + s x by cos hx and sin hx: the mean, then two numbers for each harmonic.
fn in_angle(series: &Series, [start, sense]: [f64; 2]) -> Vec<Expr> {
    let waves = series.waves.iter().enumerate().flat_map(|(h, [a, b])| {
        let angle = TAU * (h + 1) as f64 * start;
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        [a * cosine + b * sine, sense * (b * cosine - a * sine)]
    });
    std::iter::once(series.mean).chain(waves).map(Expr::Number).collect()
}

/// I of a body about an axle of the carrier, or out of the plane.
fn about(mechanism: &Mechanism, axle: Option<V3>, body: usize) -> Option<f64> {
    let inertia = &mechanism.bodies[body].inertia;
    let value = |expr: &Expr| fold::evaluate(expr, &mechanism.defaults());
    let Some(axis) = axle else { return value(&inertia.moments[2]) };
    let axes = about_axes::columns(mechanism, &inertia.axes)?;
    // In the axes that the moments are of.
    let [x, y, z] = axes.map(|column| vector::dot(column, axis));
    let [moments, products] = [&inertia.moments, &inertia.products].map(|of| of.each_ref().map(value));
    let ([a, b, c], [ab, ac, bc]) = (moments, products);
    Some(a? * x * x + b? * y * y + c? * z * z + 2.0 * (ab? * x * y + ac? * x * z + bc? * y * z))
}

/// m_e = 1/Σ (∂u/∂θ)²/I, I of what turns with each wheel; of a rack its mass along the line of action, m/cos² α.
pub fn reduced_mass(
    mechanism: &Mechanism,
    orientations: &Orientations,
    pair: &Pair,
    mesh: &Mesh,
) -> Option<f64> {
    let mut inverse = 0.0;
    for (which, id) in pair.on.iter().enumerate() {
        let frames: Vec<Frame> = if mechanism.toothing(*id).form.rim == Rim::Rack {
            racks::fixed_to(mechanism, mechanism.toothing(*id))
        } else {
            let class = orientations.class(Frame::Body(id.body)).0;
            let bodies = (0..mechanism.bodies.len()).map(|body| Frame::Body(BodyId(body)));
            std::iter::once(Frame::Ground)
                .chain(bodies)
                .filter(|frame| orientations.class(*frame).0 == class)
                .collect()
        };
        if frames.contains(&Frame::Ground) {
            continue;
        }
        let weight = |frame: &Frame| match (frame, mechanism.toothing(*id).form.rim) {
            (Frame::Body(body), Rim::Rack) => {
                fold::evaluate(&mechanism.bodies[body.0].mass, &mechanism.defaults())
            }
            (Frame::Body(body), _) => about(mechanism, pair.axles.map(|axles| axles[which]), body.0),
            (Frame::Ground, _) => None,
        };
        let all: f64 = frames.iter().map(weight).collect::<Option<Vec<f64>>>()?.into_iter().sum();
        let radius = match &pair.touch {
            None => mesh.base[which],
            Some(touch) if pair.teeth[which] == 0.0 => vector::length(touch.push),
            Some(touch) => touch.radius * pair.teeth[which],
        };
        inverse += radius * radius / all;
    }
    (inverse > 0.0).then(|| 1.0 / inverse)
}
