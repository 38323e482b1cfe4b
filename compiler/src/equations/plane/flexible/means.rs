//! Integrals of fields of a beam in the plane, out of the means of the functions that they are sums of.

use super::{Field, Flexible};
use crate::equations::means::{Bent, Means};
use crate::equations::plane::vector::{self, Pair};
use crate::symbolic::{On, Scalar, Sheet};

pub(super) struct Integrals<'g> {
    g: Sheet<'g>,
    means: Means<'g>,
}

impl<'g> Integrals<'g> {
    pub fn new(g: Sheet<'g>, flexible: &Flexible) -> Self {
        let bent = flexible.modes.iter().map(|modal| Bent { value: modal.value, rate: modal.rate });
        let bent: Vec<Bent> = bent.collect();
        Integrals { g, means: Means::new(g, &flexible.slender, &bent) }
    }

    /// ∫ F over the mass, by the mass.
    pub fn mean(&self, field: &Field) -> On<'g, Pair> {
        let terms = field.parts.iter().map(|(index, w)| self.means.first(*index) * self.g.on(*w));
        terms.fold(vector::zero(self.g), |sum, term| sum + term)
    }

    /// ∫ F·G and ∫ F×G, by the mass.
    pub fn products(&self, one: &Field, other: &Field) -> [Scalar<'g>; 2] {
        let g = self.g;
        let mut sums = [g.zero(), g.zero()];
        for (i, u) in &one.parts {
            for (k, w) in &other.parts {
                let mean = self.means.second(*i, *k);
                if !mean.is_zero() {
                    sums[0] += mean * g.on(*u).dot(*w);
                    sums[1] += mean * g.on(*u).cross(*w);
                }
            }
        }
        sums
    }
}
