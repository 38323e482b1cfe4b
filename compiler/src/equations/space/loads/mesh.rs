//! Teeth that give, about parallel axes in space: what the force between them does to wheels and centres.
//!
//! N is the force along the line of action in the transverse section, N cos α_w across the line of centres and |N| sin α_w along it as in the plane. Slanted teeth push
//! along their axles too, the second wheel by −N tan β_b with β_b the helix of the first on its base circle (Litvin & Fuentes, Gear Geometry and Applied Theory, 2004, 17.4). The
//! whole acts at the pitch point, and its opposite on the first wheel. Where joints hold the centres in the tree, nothing but u moves. Racks, cones and worms are pushed
//! where their pitch surfaces touch, by N along one direction and |N| along another of what holds them.

use crate::drawing::load::Symbol;
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::equations::loads::teeth::{FORM, Teeth, force};
use crate::equations::loads::{LoadKind, LoadTerms, along, no_rotors, together};
use crate::equations::space::vector::Vec3;
use crate::model::gears::{Pair, ToothingId, Touch};
use crate::model::{Axes, Expr, Load, Place};
use crate::symbolic::{On, Scalar};

pub static LOAD: LoadKind =
    LoadKind { form: FORM, terms, inner: None, effort: Some(force), counted: no_rotors, symbol };

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let Some(teeth) = Teeth::of(laws, load) else { return LoadTerms::none(laws) };
    let Teeth { pair, mesh, .. } = &teeth;
    let force = teeth.force();
    let potential = teeth.stored();
    if let Some(touch) = &pair.touch {
        return LoadTerms { potential, ..where_they_touch(laws, &teeth, touch, force) };
    }
    let Some([x, y, axle]) = pair.axes else { return LoadTerms::none(laws) };
    let [e, f] = pair.between.map(|part| part / pair.distance());
    // From the first centre to the second, and across that; fixed to the carrier.
    let apart = [0, 1, 2].map(|k| e * x[k] + f * y[k]);
    let across = [0, 1, 2].map(|k| e * y[k] - f * x[k]);
    if [apart, across, axle].iter().all(|along| stands(laws, pair, *along)) {
        return LoadTerms { potential, ..along(&teeth.turned, -force) };
    }

    let ring = mesh.sense < 0.0;
    let ring_is_second = ring && pair.wheel == 0;
    let angle = mesh.working_angle.unwrap_or(0.0);
    let (cosine, sine) = (libm::cos(angle), libm::sin(angle));
    let world = |along: [f64; 3]| in_world(laws, pair, along);
    let [first, _] = pair.on.map(|id| laws.mechanism.toothing(id));
    let tangential = (if ring_is_second { -cosine } else { cosine }) * force;
    let radial = (if ring { -sine } else { sine }) * force.abs();
    let (apart, axle) = (world(apart), world(axle));
    let mut pushed = tangential * world(across) + radial * apart;
    if first.helix != 0.0 {
        pushed += (-libm::tan(first.base_helix()) * force) * axle;
    }
    // From each centre to the pitch point, which is on the line of centres and along the axles in their middle: a ring is around its wheel.
    let near = if ring_is_second { -mesh.base[0] } else { mesh.base[0] } / cosine;
    let mut terms = LoadTerms { potential, ..LoadTerms::none(laws) };
    for ((id, arm), pushed) in pair.on.iter().zip([near, near - pair.distance()]).zip([-pushed, pushed]) {
        let along = if *id == pair.on[0] { 0.5 * pair.beside } else { -0.5 * pair.beside };
        terms = terms.and(at(laws, *id, arm * apart + along * axle, pushed));
    }
    terms
}

/// A force that far from the centre of a toothing.
fn at<'g>(laws: &Laws<'g>, id: ToothingId, arm: On<'g, Vec3>, pushed: On<'g, Vec3>) -> LoadTerms<'g> {
    let moment: On<Vec3> = arm.cross(pushed);
    let center = laws.kinematics().world(laws, &laws.mechanism.toothing(id).center);
    let force = together(laws, &center, &pushed.bare);
    force.and(together(laws, &laws.kinematics().turning(id.body), &moment.bare))
}

/// At the point where pitch surfaces touch, which what holds them carries.
fn where_they_touch<'g>(
    laws: &Laws<'g>,
    teeth: &Teeth<'g, '_>,
    touch: &Touch,
    force: Scalar<'g>,
) -> LoadTerms<'g> {
    let pair = teeth.pair;
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    if pair.travels.is_empty() && axes.iter().all(|along| stands(laws, pair, *along)) {
        return along(&teeth.turned, -force);
    }
    let [push, part, near] = [touch.push, touch.part, touch.at].map(|vector| in_world(laws, pair, vector));
    let pushed = force * push + force.abs() * part;
    let center = |which: usize| {
        let place = laws.kinematics().world(laws, &laws.mechanism.toothing(pair.on[which]).center);
        laws.g.on([0, 1, 2].map(|k| place[k].value().bare))
    };
    let [from, other] = [touch.from, 1 - touch.from];
    let far = near + center(from) - center(other);
    let sign = if from == 0 { -1.0 } else { 1.0 };
    at(laws, pair.on[from], near, sign * pushed).and(at(laws, pair.on[other], far, -sign * pushed))
}

/// A direction of what holds the wheels.
fn in_world<'g>(laws: &Laws<'g>, pair: &Pair, along: [f64; 3]) -> On<'g, Vec3> {
    let direction = laws.kinematics().direction(laws, &carrier(laws, pair), &along.map(Expr::Number));
    laws.g.on([0, 1, 2].map(|k| direction[k].value().bare))
}

/// A place of what holds the centres, with its axes.
fn carrier(laws: &Laws, pair: &Pair) -> Place {
    let center = &laws.mechanism.toothing(pair.on[0]).center;
    let at = [0.0; 3].map(Expr::Number);
    Place { frame: pair.carrier, at, axes: Axes::Parallel, of_mean: false, ..center.clone() }
}

/// Whether the centres stand against each other along a direction of what holds them, whatever moves.
fn stands(laws: &Laws, pair: &Pair, along: [f64; 3]) -> bool {
    let (carrier, along) = (carrier(laws, pair), along.map(Expr::Number));
    let centers = pair.on.map(|id| &laws.mechanism.toothing(id).center);
    centers.iter().all(|center| {
        let way: Moving = laws.kinematics().way(laws, &carrier, &along, center);
        way.jet.columns.is_empty()
    })
}

fn symbol(s: &mut Symbol) {
    s.line();
}
