//! What bends of the bodies in a picture: how their axes are shown, and their modes in a pose.

use crate::beams::{Bow, Held};
use crate::compiled::Compiled;
use crate::equations::Linear;
use crate::model::{Beam, BodyId, Expr, Frame, Joint, Place};

/// What is seen of a bent axis, of its length, against one that is straight.
const SEEN: f64 = 2e-3;

/// A beam.
#[derive(Clone, Debug)]
pub struct Bent {
    pub bow: Bow,
    /// Where its modes stand in q, and what they are.
    pub indices: Vec<usize>,
    pub modes: Vec<f64>,
}

impl Bent {
    /// Of each body.
    pub fn of_all(compiled: &Compiled, q: &[f64]) -> Vec<Option<Self>> {
        let bodies = compiled.mechanism.bodies.iter().enumerate();
        bodies.map(|(index, body)| Some(Self::new(compiled, index, body.beam()?, q))).collect()
    }

    fn new(compiled: &Compiled, body: usize, beam: &Beam, q: &[f64]) -> Self {
        let held = compiled.mechanism.joints.iter().flat_map(|joint| holds(joint, body));
        let bow = Bow::new(beam.slender.clone(), &held.collect::<Vec<_>>());
        // Linear coordinates stand first in q, in the order of v.
        let linear = &compiled.complete.equations.layout.linear;
        let index = |mode: usize| linear.iter().position(|it| *it == Linear::Mode(BodyId(body), mode));
        let indices: Vec<usize> = (0..beam.slender.modes.len()).filter_map(index).collect();
        let modes = indices.iter().map(|index| q[*index]).collect();
        Bent { bow, indices, modes }
    }

    /// The largest deflection across the axis that is magnified, of the length.
    pub fn deflection(&self) -> f64 {
        self.bow.deflection(&self.modes)
    }

    /// The same in other positions.
    pub fn deflection_at(&self, q: &[f64]) -> f64 {
        let modes: Vec<f64> = self.indices.iter().map(|index| q[*index]).collect();
        self.bow.deflection(&modes)
    }

    /// Whether it looks bent.
    pub fn is_seen(&self, times: f64) -> bool {
        times * self.deflection() > SEEN
    }
}

/// Where a joint holds a beam.
fn holds(joint: &Joint, body: usize) -> impl Iterator<Item = Held> + '_ {
    let turns_with = joint.form.keeps_orientation;
    let is_on = move |place: &&Place| place.frame == Frame::Body(BodyId(body));
    [&joint.first, &joint.second].into_iter().filter(is_on).filter_map(move |place| match place.at[0] {
        Expr::Number(x) => Some(Held { x, turns_with }),
        _ => None,
    })
}
