//! Teeth that give, in the plane: what the force between them does to wheels and centres.
//!
//! On the wheels act −r_b1 N and ∓r_b2 N, and on their centres opposite forces along the line of action: N cos α_w across the line of centres,
//! |N| sin α_w along it, which parts external wheels. Where axes move, N₊ and N₋ act along two lines of action, by virtual work. A rack is pushed at the pitch point.

use crate::drawing::load::Symbol;
use crate::equations::laws::Laws;
use crate::equations::loads::teeth::{FORM, Teeth, force};
use crate::equations::loads::{LoadKind, LoadTerms, along, no_rotors};
use crate::model::gears::Touch;
use crate::model::{Frame, Load, Rotor};

pub static LOAD: LoadKind =
    LoadKind { form: FORM, terms, inner: None, effort: Some(force), counted: no_rotors, symbol };

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let Some(teeth) = Teeth::of(laws, load) else { return LoadTerms::none(laws) };
    if let Some(axes) = &teeth.axes {
        let [ahead, behind] = teeth.pressed(axes);
        let terms = along(&teeth.turned, behind - ahead).and(along(&axes.play, ahead + behind));
        return LoadTerms { potential: teeth.stored(), ..terms };
    }
    if let Some(touch) = &teeth.pair.touch {
        return on_rack(laws, &teeth, touch);
    }
    let Teeth { pair, mesh, .. } = &teeth;
    let force = teeth.force();
    let rotor = |frame: Frame| match frame {
        Frame::Ground => laws.still(laws.g.zero()),
        Frame::Body(body) => laws.kinematics().rotor_rate(laws, Rotor::Body(body)),
    };
    let own = pair.on.map(|id| rotor(Frame::Body(id.body)));
    let torques = [-mesh.base[0], -mesh.sense * mesh.base[1]];
    let mut terms = along(&own[0], torques[0] * force).and(along(&own[1], torques[1] * force));

    // On the second centre, and turned about on the first: along and across the line of centres, which the carrier carries.
    let [x, y] = pair.between.map(|part| part / pair.distance());
    let unit = laws.g.on([laws.g.number(x).bare, laws.g.number(y).bare]);
    let plane = laws.plane();
    let [first, second] = pair.on.map(|id| plane.place(laws, &laws.mechanism.toothing(id).center));
    let delta = (second - first).bare;
    let [apart, across] = [unit, unit.perpendicular()].map(|direction| {
        let (frame, direction) = plane.carried_by(pair.carrier, direction);
        plane.project(frame, direction, &delta)
    });
    let ring = mesh.sense < 0.0;
    let angle = mesh.working_angle.unwrap_or(0.0);
    let (cosine, sine) = (libm::cos(angle), libm::sin(angle));
    let tangential = (if ring && pair.wheel == 0 { -cosine } else { cosine }) * force;
    let carrier = rotor(pair.carrier);
    if apart.jet.columns.is_empty() && across.jet.columns.is_empty() {
        // Held by their carrier: nothing but its turn moves them.
        terms = terms.and(along(&carrier, tangential * pair.distance()));
    } else {
        let radial = (if ring { -sine } else { sine }) * force.abs();
        let turning = tangential * apart.value() - radial * across.value();
        terms =
            terms.and(along(&across, tangential)).and(along(&apart, radial)).and(along(&carrier, turning));
    }
    LoadTerms { potential: teeth.stored(), ..terms }
}

/// F = N n + |N| m at the pitch point P, from the pinion's centre to which it is D, n and m in the axes of the carrier. On the pinion and the rack F does the work
/// ∓F·δc and ∓(P − c) × F·δθ; with the way Δ between both centres as the carrier sees it F·δΔ is Σ F_e δ(e·Δ) + Δ × F·δθ_c.
fn on_rack<'g>(laws: &Laws<'g>, teeth: &Teeth<'g, '_>, touch: &Touch) -> LoadTerms<'g> {
    let (pair, plane, force) = (teeth.pair, laws.plane(), teeth.force());
    let [pinion, rack] = [touch.from, 1 - touch.from];
    // The pair's second body is pushed.
    let sign = if pinion == 0 { 1.0 } else { -1.0 };
    let pushed = [0, 1].map(|k| sign * (touch.push[k] * force + touch.part[k] * force.abs()));
    let centers =
        [pinion, rack].map(|which| plane.place(laws, &laws.mechanism.toothing(pair.on[which]).center));
    let [near, far] = centers;
    let delta = (far - near).bare;
    let ways = [[1.0, 0.0], [0.0, 1.0]].map(|axis| {
        let axis = laws.g.on(axis.map(|part| laws.g.number(part).bare));
        let (frame, direction) = plane.carried_by(pair.carrier, axis);
        plane.project(frame, direction, &delta)
    });
    let rotor = |frame: Frame| match frame {
        Frame::Ground => laws.still(laws.g.zero()),
        Frame::Body(body) => laws.kinematics().rotor_rate(laws, Rotor::Body(body)),
    };
    let [x, y] = pushed;
    let of_point = touch.at[0] * y - touch.at[1] * x;
    let of_way = ways[0].value() * y - ways[1].value() * x;
    let [pinion, rack] = [pinion, rack].map(|which| rotor(Frame::Body(pair.on[which].body)));
    let carrier = rotor(pair.carrier);
    let mut terms = along(&ways[0], x).and(along(&ways[1], y)).and(along(&pinion, -of_point));
    if rack.jet == carrier.jet {
        terms = terms.and(along(&carrier, of_point));
    } else {
        terms = terms.and(along(&rack, of_point - of_way)).and(along(&carrier, of_way));
    }
    LoadTerms { potential: teeth.stored(), ..terms }
}

fn symbol(s: &mut Symbol) {
    s.line();
}
