//! The rotary inertia of sections that shear: ½ m (r_g² ω² + 2 ω Σ ν_j ṗ_j + Σ ν_jk ṗ_j ṗ_k), ν of [`Turning`] (Timoshenko). Its coefficients are
//! constants, so that in the plane it adds to M alone. Nothing of other beams.

use super::{ModalMotion, Spread};
use crate::beams::{Rule, Turning};
use crate::symbolic::{Node, Scalar};

/// What a velocity of a beam turns.
#[derive(Clone, Copy)]
pub(super) enum Turn {
    Frame,
    Mode(usize),
}

impl<'g> Spread<'_, 'g> {
    fn turning(&self) -> Option<&'g Turning> {
        self.flexible.slender.turning.as_ref()
    }

    /// ∫ of two columns over the mass, by the mass, with what turns.
    pub(super) fn with_turning(&self, dot: Scalar<'g>, one: Turn, other: Turn) -> Scalar<'g> {
        let Some(turning) = self.turning() else { return dot };
        let own = match (one, other) {
            (Turn::Frame, Turn::Frame) => turning.about_z,
            (Turn::Frame, Turn::Mode(mode)) | (Turn::Mode(mode), Turn::Frame) => turning.first[mode],
            (Turn::Mode(j), Turn::Mode(k)) => turning.second[j][k],
        };
        dot + self.offset.g.number(own)
    }

    /// Twice that energy, by the mass.
    pub(super) fn twice_turning(&self, omega: Option<Scalar<'g>>) -> Scalar<'g> {
        let g = self.offset.g;
        let Some(turning) = self.turning() else { return g.zero() };
        let rates: Vec<Scalar> = self.flexible.modes.iter().map(|modal| g.on(modal.rate)).collect();
        let pairs = (0..rates.len()).flat_map(|j| (0..rates.len()).map(move |k| (j, k)));
        let mut sum = g.sum(pairs.map(|(j, k)| turning.second[j][k] * (rates[j] * rates[k])));
        if let Some(omega) = omega {
            let mixed = g.sum(rates.iter().zip(&turning.first).map(|(rate, first)| *first * *rate));
            sum += turning.about_z * omega.square() + 2.0 * (omega * mixed);
        }
        sum
    }

    /// r_g² ω̇ + Σ ν_j p̈_j: the moment that it takes, by the mass.
    pub(super) fn turning_moment(&self, accelerations: &[Node], rate: Option<usize>) -> Scalar<'g> {
        let g = self.offset.g;
        let Some(turning) = self.turning() else { return g.zero() };
        let bent = self.flexible.modes.iter().zip(&turning.first).map(|(modal, first)| {
            *first
                * match modal.motion {
                    ModalMotion::Free(index) => g.on(accelerations[index]),
                    ModalMotion::Given(acceleration) => g.on(acceleration),
                }
        });
        let own = rate.map_or(g.zero(), |rate| turning.about_z * g.on(accelerations[rate]));
        own + g.sum(bent)
    }
}

/// Twice the energy with which the sections of a beam turn, by the mass, section by section.
pub fn twice_turning_of_slices<'g>(
    flexible: &super::Flexible,
    rule: &Rule,
    omega: Option<Scalar<'g>>,
    g: crate::symbolic::Sheet<'g>,
) -> Scalar<'g> {
    let slender = &flexible.slender;
    let Some(turning) = &slender.turning else { return g.zero() };
    let slice = |(share, weight): (f64, f64)| {
        let slopes = slender.slopes(slender.from + share * slender.length).into_iter();
        let rates = slopes.zip(&flexible.modes).map(|(slope, modal)| slope * g.on(modal.rate));
        let turned = omega.unwrap_or(g.zero()) + g.sum(rates);
        (weight * turning.about_z) * turned.square()
    };
    g.sum(rule.points().map(slice))
}
