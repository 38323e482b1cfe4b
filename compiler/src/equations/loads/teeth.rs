//! Teeth that give: how far the wheels have turned into each other, and the force along the line of action. What acts on bodies is that of the
//! plane and of space.
//!
//! u = (r_b1/z₁)(Σ n θ − phase) − e, positive where the first wheel is ahead counter-clockwise; N = k f(u) + c u̇ where teeth touch, f what of
//! u is beyond half the backlash (Kahraman & Singh, Non-linear dynamics of a spur gear pair, J. Sound Vib. 142, 1990, (1)–(4)). k is a law, or a series in
//! cos and sin of the turn of a wheel by its number of teeth, by powers of the pair (cos θ, sin θ): no turns are counted for it.
//!
//! Of a rack, cones and a worm (r_b1/z₁) is what the sum of teeth and travels moves along their common normal, `Touch::radius`.
//!
//! Where axes move, each side of a tooth has a line of action of its own and presses for itself, by ±u less half the backlash and less the play that the distance
//! of the axes gives: N = N₊ − N₋.

use crate::equations::couplings::{phase_of_load, sum_of_teeth as sum};
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::equations::plane::MovingAxes;
use crate::equations::plane::vector::{self, Pair as Turn};
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Positional, Value};
use crate::model::gears::meshes::{self, BACKLASH, DAMPING, ERROR, ERROR_RATE, STIFFNESS};
use crate::model::gears::{Mesh, Pair};
use crate::model::{Load, OfTeeth, Rotor};
use crate::symbolic::{Compare, On, Scalar, Unary};
use crate::units::Dimension;
use std::f64::consts::TAU;

pub const FORM: LoadForm = LoadForm {
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
            Argument::of("axes", Need::Never, Value::Word),
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
    holds: false,
    effort: Some("force"),
    doubt: None,
};

/// A load between teeth, with what follows from its pair.
pub struct Teeth<'g, 'l> {
    laws: &'l Laws<'g>,
    load: &'l Load,
    pub pair: &'g Pair,
    pub mesh: Mesh,
    /// u without the error, and the error.
    pub turned: Moving<'g>,
    error: Moving<'g>,
    /// Of axes that move.
    pub axes: Option<MovingAxes<'g>>,
}

impl<'g, 'l> Teeth<'g, 'l> {
    pub fn of(laws: &'l Laws<'g>, load: &'l Load) -> Option<Self> {
        let pair = &laws.mechanism.pairs[load.teeth.as_ref()?.pair];
        let (_, mesh) = laws.mechanism.mesh_of(pair);
        let axes = pair.axes_move.then(|| MovingAxes::of(laws, pair, &mesh));
        let turned = match &axes {
            Some(axes) => axes.turned.clone(),
            None => {
                let phase = laws.symbols.phases[phase_of_load(laws.mechanism, load)];
                let radius = pair.touch.as_ref().map_or(mesh.base[0] / pair.teeth[0], |touch| touch.radius);
                radius * (sum(laws, pair, 1.0) - laws.still(laws.g.on(phase)))
            }
        };
        let mut error = laws.still(laws.value(load.value(ERROR)));
        if let [rate] = load.components(ERROR_RATE) {
            error.jet.known_rate = Some(laws.value(rate).bare);
        }
        Some(Teeth { laws, load, pair, mesh, turned, error, axes })
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

    /// The turn of the wheel by its number of teeth.
    fn turn(&self) -> On<'g, Turn> {
        let wheel = self.pair.wheel;
        let angle = match &self.axes {
            Some(axes) => {
                let body = Rotor::Body(self.pair.on[wheel].body);
                axes.against_centres(self.laws.kinematics().rotor_pair(self.laws, body))
            }
            None => {
                let turns = self.pair.turns.iter().map(|(factor, rotor)| {
                    let pair = self.laws.kinematics().rotor_pair(self.laws, *rotor);
                    if *factor < 0.0 { pair.opposite() } else { pair }
                });
                turns.reduce(|a, b| a.turned(b)).unwrap_or_else(|| vector::unturned(self.laws.g))
            }
        };
        angle.times(self.pair.teeth[wheel] as u64)
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

    /// N₊ and N₋, of teeth on axes that move: none of them pulls, damping included.
    pub fn pressed(&self, axes: &MovingAxes<'g>) -> [Scalar<'g>; 2] {
        let zero = self.laws.g.zero();
        let k = self.stiffness();
        let damping = self.laws.value(&self.load.components(DAMPING)[0]);
        let within = 0.5 * self.value(BACKLASH) + axes.play.value();
        [1.0, -1.0].map(|side| {
            let deep = side * self.deflection() - within;
            let force = if damping.is_zero() {
                k * deep
            } else {
                (k * deep + damping * (side * self.rate() - axes.play.rate())).max(zero)
            };
            zero.compare(Compare::Less, deep).select(force, zero)
        })
    }

    /// N.
    pub fn force(&self) -> Scalar<'g> {
        let g = self.laws.g;
        if let Some(axes) = &self.axes {
            let [ahead, behind] = self.pressed(axes);
            return ahead - behind;
        }
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

    /// ½ k f², where that is an energy; on axes that move it is one of each side.
    pub fn stored(&self) -> Scalar<'g> {
        let g = self.laws.g;
        if !self.load.stores() {
            return g.zero();
        }
        let [k] = self.load.components(STIFFNESS) else { return g.zero() };
        let k = self.laws.value(k);
        let (u, backlash) = (self.deflection(), self.value(BACKLASH));
        if let Some(axes) = &self.axes {
            let within = 0.5 * backlash + axes.play.value();
            let [ahead, behind] = [u - within, -u - within].map(|deep| deep.max(g.zero()).square());
            return 0.5 * (k * (ahead + behind));
        }
        let beyond = if backlash.is_zero() { u } else { (u.abs() - 0.5 * backlash).max(g.zero()) };
        0.5 * (k * beyond.square())
    }

    /// τ, but for whole pitches.
    fn phase(&self) -> Scalar<'g> {
        let (toothings, mesh) = self.laws.mechanism.mesh_of(self.pair);
        let [start, sense] = meshes::phase(self.pair, toothings, &mesh, self.load);
        if self.axes.is_some() {
            let [cosine, sine] = self.turn().parts();
            return sine.atan2(cosine) * (sense / TAU) + start;
        }
        let turns =
            self.laws.sum_of_angles(&self.pair.turns, TAU / (sense * self.pair.teeth[self.pair.wheel]));
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

/// N, as the one quantity that it exerts.
pub fn force<'g>(laws: &Laws<'g>, load: &Load) -> Scalar<'g> {
    Teeth::of(laws, load).map_or_else(|| laws.g.zero(), |teeth| teeth.force())
}
