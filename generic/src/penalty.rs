//! Joints that yield: efforts −(k x + c ẋ) along what their rows would hold, places that coincide being seen from the first body; with
//! damping along the line δ between these, −c (δ·δ̇)/max(δ·δ, ε²) δ.

use crate::kinematics::Kinematics;
use crate::load::{Way, pulled};
use crate::quantity::Pull;

/// The ways of one joint, without the damping that acts along the line.
#[derive(Clone, Debug)]
pub(crate) struct Penalty {
    /// Components of δ, or what else measures a way.
    pub shifts: Vec<Way>,
    pub turns: Vec<Way>,
    /// c and ε.
    pub line: Option<[f64; 2]>,
}

impl Penalty {
    fn ways(&self) -> impl Iterator<Item = &Way> {
        self.shifts.iter().chain(&self.turns)
    }

    /// What acts along each way, and the rate of that.
    fn efforts(&self, at: &Kinematics) -> Vec<[f64; 2]> {
        let along = self.shifts.iter().map(|way| way.along(at));
        let (square, work) =
            along.fold((0.0, 0.0), |(square, work), x| (square + x.value * x.value, work + x.value * x.rate));
        let faded = self.line.map_or(0.0, |[c, smallest]| c * work / square.max(smallest * smallest));
        let shifts = self.shifts.iter().map(|way| {
            let x = way.along(at);
            [way.effort(x) - faded * x.value, x.rate]
        });
        let turns = self.turns.iter().map(|way| {
            let x = way.along(at);
            [way.effort(x), x.rate]
        });
        shifts.chain(turns).collect()
    }

    pub fn evaluate(&self, at: &Kinematics, mut add: impl FnMut(Pull)) {
        for (way, [effort, _]) in self.ways().zip(self.efforts(at)) {
            for (factor, quantity) in &way.terms {
                pulled(quantity.jet(at).pulls, factor * effort, &mut add);
            }
        }
    }

    pub fn power(&self, at: &Kinematics) -> f64 {
        self.efforts(at).iter().map(|[effort, rate]| effort * rate).sum()
    }

    pub fn energy(&self, at: &Kinematics) -> f64 {
        self.ways().map(|way| way.energy(at)).sum()
    }
}
