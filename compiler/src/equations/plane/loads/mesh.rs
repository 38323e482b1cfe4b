//! Teeth that give, in the plane: what the force between them does to wheels and centres.
//!
//! On the wheels act −r_b1 N and ∓r_b2 N, and on their centres opposite forces along the line of action: N cos α_w across the line of centres,
//! |N| sin α_w along it, which parts external wheels. Where axes move, N₊ and N₋ act along two lines of action, by virtual work.

use crate::drawing::load::Symbol;
use crate::equations::laws::Laws;
use crate::equations::loads::teeth::{FORM, Teeth, force};
use crate::equations::loads::{LoadKind, LoadTerms, along, no_rotors};
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

fn symbol(s: &mut Symbol) {
    s.line();
}
