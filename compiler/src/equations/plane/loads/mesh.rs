//! Teeth that give: a force along the line of action by how far the wheels have turned into each other.
//!
//! u = (r_b1/z₁)(Σ n θ − phase) − e, positive where the first wheel is ahead counter-clockwise; N = k f(u) + c u̇ where teeth touch, f what of
//! u is beyond half the backlash (Kahraman & Singh, Non-linear dynamics of a spur gear pair, J. Sound Vib. 142, 1990, (1)–(4)). On the wheels
//! act −r_b1 N and ∓r_b2 N, and on their centres opposite forces along the line of action: N cos α_w across the line of centres, |N| sin α_w
//! along it, which parts external wheels. k is a law, or a series in cos and sin of the turn of a wheel by its number of teeth, by powers of the
//! pair (cos θ, sin θ): no turns are counted for it.

use crate::drawing::load::Symbol;
use crate::equations::couplings::phase_of_load;
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::equations::loads::{LoadKind, LoadTerms, along, no_rotors};
use crate::equations::plane::vector::{self, Pair as Turn};
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Positional, Value};
use crate::model::gears::meshes::{self, BACKLASH, DAMPING, ERROR, ERROR_RATE, STIFFNESS};
use crate::model::gears::{Mesh, Pair};
use crate::model::{Frame, Load, OfTeeth, Rotor};
use crate::symbolic::{Compare, On, Scalar, Unary};
use crate::units::Dimension;
use std::f64::consts::TAU;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "mesh",
            elsewhere: &[],
            positional: &[Positional::Toothing, Positional::Toothing],
            named: &[
                Argument::of("stiffness", Need::Always, Value::TeethStiffness).restoring(),
                Argument::of("damping", Need::Never, Value::TeethDamping).restoring(),
                Argument::scalar("damping_ratio", Need::Never, Dimension::ONE).not_negative(),
                Argument::scalar("backlash", Need::Never, Dimension::LENGTH).not_negative(),
                Argument::of("error", Need::Never, Value::Varying(Dimension::LENGTH)),
                Argument::of(
                    "error_rate",
                    Need::Never,
                    Value::RateOf { varying: "error", for_sake_of: "damping" },
                ),
                Argument::scalar("sense", Need::Never, Dimension::ONE),
            ],
        },
        instead: Some("between joints or bodies write `gear(a, b, ratio = …)`"),
        meant: None,
        title: "teeth that give",
        exerts: "a force along the line of action, by how far the wheels have turned into each other",
        exported: "mesh",
        on: &[Acts::Toothing, Acts::Toothing],
        law: Law::None,
        stores: true,
        turns: false,
        owns: None,
        rubs: false,
        effort: Some("force"),
        doubt: None,
    },
    terms,
    inner: None,
    effort: Some(|laws, load| Teeth::of(laws, load).map_or_else(|| laws.g.zero(), |teeth| teeth.force())),
    counted: no_rotors,
    symbol,
};

/// A load between teeth, with what follows from its pair.
struct Teeth<'g, 'l> {
    laws: &'l Laws<'g>,
    load: &'l Load,
    pair: &'g Pair,
    mesh: Mesh,
    /// u without the error, and the error.
    turned: Moving<'g>,
    error: Moving<'g>,
}

impl<'g, 'l> Teeth<'g, 'l> {
    fn of(laws: &'l Laws<'g>, load: &'l Load) -> Option<Self> {
        let pair = &laws.mechanism.pairs[load.teeth.as_ref()?.pair];
        let (_, mesh) = laws.mechanism.mesh_of(pair);
        let phase = laws.symbols.phases[phase_of_load(laws.mechanism, load)];
        let radius = mesh.base[0] / pair.teeth[0];
        let turned = radius * (laws.sum_of_angles(&pair.terms, 1.0) - laws.still(laws.g.on(phase)));
        let mut error = laws.still(laws.value(load.value(ERROR)));
        if let [rate] = load.components(ERROR_RATE) {
            error.jet.known_rate = Some(laws.value(rate).bare);
        }
        Some(Teeth { laws, load, pair, mesh, turned, error })
    }

    fn value(&self, which: usize) -> Scalar<'g> {
        self.laws.value(self.load.value(which))
    }

    fn deflection(&self) -> Scalar<'g> {
        self.turned.value() - self.error.value()
    }

    fn rate(&self) -> Scalar<'g> {
        self.turned.rate() - self.error.rate()
    }

    /// The turn of the wheel by its number of teeth: (c, s)^z by squares.
    fn turn(&self) -> On<'g, Turn> {
        let g = self.laws.g;
        let turns = self.pair.turns.iter().map(|(factor, rotor)| {
            let pair = self.laws.kinematics().rotor_pair(self.laws, *rotor);
            if *factor < 0.0 { pair.opposite() } else { pair }
        });
        let angle = turns.reduce(|a, b| a.turned(b)).unwrap_or_else(|| vector::unturned(g));
        let mut teeth = self.pair.teeth[self.pair.wheel] as u64;
        let (mut power, mut result) = (angle, None);
        while teeth > 0 {
            if teeth % 2 == 1 {
                result = Some(result.map_or(power, |result: On<'g, Turn>| result.turned(power)));
            }
            teeth /= 2;
            if teeth > 0 {
                power = squared(power);
            }
        }
        result.unwrap_or_else(|| vector::unturned(g))
    }

    /// k; of a series k₀ + Re(P (γ₁ + P (γ₂ + …))) with γ = a − i b.
    fn stiffness(&self) -> Scalar<'g> {
        let laws = self.laws;
        let [mean, waves @ ..] = self.load.components(STIFFNESS) else { return laws.g.zero() };
        let mean = laws.value(mean);
        let waves: Vec<On<Turn>> = waves
            .chunks(2)
            .map(|wave| [laws.value(&wave[0]), -laws.value(&wave[1])])
            .map(|[a, b]| laws.g.on([a.bare, b.bare]))
            .collect();
        let Some((last, others)) = waves.split_last() else { return mean };
        let turn = self.turn();
        let sum = others.iter().rev().fold(*last, |sum, wave| *wave + sum.turned(turn));
        let ([a, b], [c, s]) = (sum.parts(), turn.parts());
        mean + (a * c - b * s)
    }

    /// N.
    fn force(&self) -> Scalar<'g> {
        let g = self.laws.g;
        let (k, u) = (self.stiffness(), self.deflection());
        let damping = self.laws.value(&self.load.components(DAMPING)[0]);
        let always = self.load.components(DAMPING).len() > 1;
        let resisted = if damping.is_zero() { g.zero() } else { damping * self.rate() };
        let backlash = self.value(BACKLASH);
        if backlash.is_zero() {
            return k * u + resisted;
        }
        let (half, zero) = (0.5 * backlash, g.zero());
        let beyond = |ahead: Scalar<'g>, inside: Scalar<'g>, behind: Scalar<'g>| {
            let back = u.compare(Compare::Less, -half).select(behind, inside);
            half.compare(Compare::Less, u).select(ahead, back)
        };
        if damping.is_zero() || always {
            return k * beyond(u - half, zero, u + half) + resisted;
        }
        // Teeth do not stick: damping takes away no more than there is.
        let ahead = (k * (u - half) + resisted).max(zero);
        let behind = (k * (u + half) + resisted).min(zero);
        beyond(ahead, zero, behind)
    }

    /// τ, as it is counted over several turns.
    fn phase(&self) -> Scalar<'g> {
        let (toothings, mesh) = self.laws.mechanism.mesh_of(self.pair);
        let wheel = toothings[self.pair.wheel];
        let [start, sense] = meshes::phase(self.pair, wheel, &mesh, self.load);
        let turns = self.laws.sum_of_angles(&self.pair.turns, TAU / (sense * wheel.teeth));
        turns.value() + start
    }

    fn quantity(&self, part: OfTeeth) -> Scalar<'g> {
        let wrapped = || {
            let phase = self.phase();
            phase - phase.unary(Unary::Floor)
        };
        match part {
            OfTeeth::Deflection => self.deflection(),
            OfTeeth::Stiffness => self.stiffness(),
            OfTeeth::Phase => wrapped(),
            OfTeeth::Pairs => {
                let whole = libm::floor(self.mesh.contact_ratio);
                let (one, none) = (self.laws.g.one(), self.laws.g.zero());
                let part = self.laws.g.number(self.mesh.contact_ratio - whole);
                wrapped().compare(Compare::Less, part).select(one, none) + whole
            }
        }
    }
}

/// One of its quantities.
pub fn of_teeth<'g>(laws: &Laws<'g>, load: &Load, part: OfTeeth) -> Scalar<'g> {
    Teeth::of(laws, load).map_or_else(|| laws.g.zero(), |teeth| teeth.quantity(part))
}

/// (c² − s², 2 c s).
fn squared<'g>(turn: On<'g, Turn>) -> On<'g, Turn> {
    let [c, s] = turn.parts();
    c.g.on([(c * c - s * s).bare, (2.0 * c * s).bare])
}

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let Some(teeth) = Teeth::of(laws, load) else { return LoadTerms::none(laws) };
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
    LoadTerms { potential: stored(&teeth), ..terms }
}

/// ½ k f², where that is an energy.
fn stored<'g>(teeth: &Teeth<'g, '_>) -> Scalar<'g> {
    let (g, load) = (teeth.laws.g, teeth.load);
    if !load.stores() {
        return g.zero();
    }
    let [k] = load.components(STIFFNESS) else { return g.zero() };
    let (u, backlash) = (teeth.deflection(), teeth.value(BACKLASH));
    let beyond = if backlash.is_zero() { u } else { (u.abs() - 0.5 * backlash).max(g.zero()) };
    0.5 * (teeth.laws.value(k) * beyond.square())
}

fn symbol(s: &mut Symbol) {
    s.line();
}
