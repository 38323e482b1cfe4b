//! What bending draws in: −½ pᵀ Γ(x) p along the axis, its columns D_j = −Σ_k Γ_jk p_k, and E = −ṗᵀ Γ ṗ of its acceleration.
//! Nothing where `stiffening` is off.

use super::{Field, Flexible, ModalMotion, Spread, vector};
use crate::beams::{Shortening, Way};
use crate::equations::plane::kinematics::LocalVector;
use crate::symbolic::{Node, Scalar, Sheet};

impl Flexible {
    /// Draws in a place at x.
    pub(super) fn shorten(&self, g: Sheet, x: f64, vector: &mut LocalVector) {
        if self.slender.shortenings.is_empty() {
            return;
        }
        let gammas = self.slender.shortenings_at(x);
        let along = vector::axis(g, 0);
        let add = |to: &mut [Node; 2], by: Scalar| *to = (g.on(*to) + by * along).bare;
        let all = self.slender.shortenings.iter().zip(&gammas);
        for (Shortening { modes: (j, k), .. }, gamma) in all.clone() {
            let (one, other) = (self.modes[*j], self.modes[*k]);
            // Both orders of a pair.
            let times = if j == k { 0.5 } else { 1.0 };
            add(&mut vector.at, -(times * gamma) * (g.on(one.value) * other.value));
            add(&mut vector.drift_rate, -(2.0 * times * gamma) * (g.on(one.rate) * other.rate));
        }
        for (mode, modal) in self.modes.iter().enumerate() {
            let terms = all.clone().filter_map(|(it, gamma)| Some((partner(it, mode)?, gamma)));
            let column = g.sum(terms.map(|(partner, gamma)| -*gamma * g.on(self.modes[partner].value)));
            match modal.motion {
                ModalMotion::Free(velocity) => {
                    let slide = vector.slides.entry(velocity).or_insert(vector::zero(g).bare);
                    add(slide, column);
                }
                ModalMotion::Given(acceleration) => {
                    add(&mut vector.drift, column * modal.rate);
                    add(&mut vector.drift_rate, column * acceleration);
                }
            }
        }
        vector.slides.retain(|_, direction| !g.on(*direction).is_zero());
    }
}

impl Spread<'_, '_> {
    /// −½ pᵀ Γ p = ½ Σ D_j p_j.
    pub(super) fn drawn_in(&self) -> Field {
        let g = self.offset.g;
        self.sum(|modal| (0.5 * g.on(modal.value)).bare, |mode| self.drawn_in_by(mode))
    }

    /// −ṗᵀ Γ ṗ: E.
    pub(super) fn drawn_in_faster(&self) -> Field {
        self.along(1 + 2 * self.flexible.modes.len())
    }

    /// −Σ_k Γ_jk p_k: D_j.
    pub(super) fn drawn_in_by(&self, mode: usize) -> Field {
        match self.flexible.slender.modes[mode].way {
            Way::Axial | Way::Torsion => Field::default(),
            Way::Bending | Way::BendingZ => self.along(1 + self.flexible.modes.len() + mode),
        }
    }

    fn along(&self, function: usize) -> Field {
        if self.flexible.slender.shortenings.is_empty() {
            return Field::default();
        }
        let along = vector::axis(self.offset.g, 0).turned(self.offset);
        Field { parts: vec![(function, along.bare)] }
    }
}

/// The other of a pair of modes.
fn partner(it: &Shortening, mode: usize) -> Option<usize> {
    match it.modes {
        (j, k) if j == mode => Some(k),
        (j, k) if k == mode => Some(j),
        _ => None,
    }
}
