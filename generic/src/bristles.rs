//! Frictions that remember: each component of the sliding v has a deflection z, an internal state, and what resists is
//! N p(v, z) + o(v).

use crate::kinematics::Kinematics;
use crate::law::{Law, Scratch};

/// s: what open contacts forget in.
pub(crate) const FORGETTING: f64 = 1e-3;
/// Of v_t, v_s, μ/k and μ: what lengths of several components are not less than.
const LEAST: f64 = 1e-6;
/// Of μ/k: where an anchor begins to be dragged.
const SOFTLY: f64 = 0.05;

#[derive(Clone, Debug)]
pub(crate) struct Bristles {
    pub kind: Kind,
    /// The first of its states among those of the mechanism.
    pub first: usize,
    /// How many the sliding has at each place where surfaces touch.
    pub components: usize,
}

#[derive(Clone, Debug)]
pub(crate) enum Kind {
    LuGre { most: Law, least: Law, transition: f64, stiffness: f64, damping: f64, viscous: f64 },
    Asperity { most: Law, stiffness: f64, speed: f64 },
}

fn length(x: &[f64], least: f64) -> f64 {
    match x {
        [only] => only.abs(),
        several => several.iter().map(|x| x * x).sum::<f64>().sqrt().hypot(least),
    }
}

impl Bristles {
    /// Those of the components from one on.
    pub fn deflections<'k>(&self, at: &'k Kinematics, from: usize, count: usize) -> &'k [f64] {
        &at.internal[self.first + from..][..count]
    }

    /// ż.
    pub fn bending(
        &self,
        v: &[f64],
        z: &[f64],
        at: &Kinematics,
        inputs: &[f64],
        scratch: &mut Scratch,
    ) -> Vec<f64> {
        match &self.kind {
            Kind::LuGre { most, least, transition, stiffness, .. } => {
                let (most, least) = (most.value(at, inputs, scratch), least.value(at, inputs, scratch));
                let square: f64 = v.iter().map(|v| v * v).sum();
                let steady = least + (most - least) * (-square / (transition * transition)).exp();
                let back = stiffness * length(v, LEAST * transition) / steady;
                v.iter().zip(z).map(|(v, z)| v - back * z).collect()
            }
            Kind::Asperity { most, stiffness, .. } => {
                let most = most.value(at, inputs, scratch);
                let size = length(z, LEAST * most / stiffness);
                let rest = ((1.0 - stiffness * size / most) / SOFTLY).clamp(0.0, 1.0);
                let held = rest * rest * (3.0 - 2.0 * rest);
                // What of v goes on along z.
                let along = v.iter().zip(z).map(|(v, z)| v * z).sum::<f64>().max(0.0);
                let dragged = if along > 0.0 { (1.0 - held) * along / (size * size) } else { 0.0 };
                v.iter().zip(z).map(|(v, z)| v - dragged * z).collect()
            }
        }
    }

    /// p and o of each component.
    pub fn resisted(
        &self,
        v: &[f64],
        z: &[f64],
        at: &Kinematics,
        inputs: &[f64],
        scratch: &mut Scratch,
    ) -> Vec<[f64; 2]> {
        match &self.kind {
            Kind::LuGre { stiffness, damping, viscous, .. } => {
                let rates = self.bending(v, z, at, inputs, scratch);
                let parts = v.iter().zip(z).zip(rates);
                parts.map(|((v, z), rate)| [stiffness * z + damping * rate, viscous * v]).collect()
            }
            Kind::Asperity { most, stiffness, speed } => {
                let most = most.value(at, inputs, scratch);
                let fast = length(v, LEAST * speed).max(*speed);
                let asked: Vec<f64> = v.iter().zip(z).map(|(v, z)| most * v / fast + stiffness * z).collect();
                let held = most / length(&asked, LEAST * most).max(most);
                asked.into_iter().map(|asked| [held * asked, 0.0]).collect()
            }
        }
    }
}
