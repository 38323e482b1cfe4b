//! States of emitted models along their motion, with other velocities there, and away from it.

use linkwright::{
    Assemble, AssembleExt, Baumgarte, Fields, Report, Simulation, State, StateOf, Vector, project_position,
    project_velocity, retract,
};
use std::f64::consts::PI;

/// Seconds between states along the motion.
const APART: f64 = 0.004;
/// Of internal states that begin at nothing, as bristles do.
const SMALL: f64 = 1e-3;

/// Uniform in [−1, 1), the same in every run (splitmix64).
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as f64 / 2.0_f64.powi(63) - 1.0
    }
}

/// The values of inputs, field by field.
pub fn inputs<M: Report<f64, Inputs: Fields<f64>>>(values: &[f64]) -> M::Inputs {
    let mut fields: <M::Inputs as Fields<f64>>::Array = Vector::zeros(values.len());
    fields.as_mut_slice().copy_from_slice(values);
    M::Inputs::from_array(fields)
}

/// So many moments of the motion under constant inputs, each as it is and with a random velocity.
pub fn states<M>(
    name: &str,
    model: &M,
    values: &[f64],
    count: usize,
    random: &mut Random,
) -> Vec<(f64, StateOf<M>)>
where
    M: Assemble<f64> + Report<f64>,
    M::Inputs: Fields<f64>,
{
    let baumgarte = Baumgarte { alpha: 10.0, beta: 10.0 };
    // Its teeth swing at 55 kHz.
    let step = if name.starts_with("planetary_stage") { 1e-6 } else { 2e-5 };
    let given = |_: f64, _: &StateOf<M>| inputs::<M>(values);
    let mut simulation =
        Simulation::new(model, model.start()).formulation(baumgarte).sampled(given).step(step);
    let mut found = Vec::new();
    for k in 0..count {
        let time = k as f64 * APART;
        let along = simulation.advance_until(time).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut wish = model.zero_v();
        wish.as_mut_slice().iter_mut().for_each(|v| *v = random.unit());
        let other = project_velocity(model, time, &along.q, &wish).map(|v| State { v, ..along.clone() });
        // Gates that are held are there what they are of that state: the law is then the one without gates.
        let other = other.map(|state| State { gates: model.live_gates(time, &state), ..state });
        found.extend(std::iter::once(along).chain(other).map(|state| (time, state)));
    }
    found
}

/// A state away from the start: another position that closes, moved by so much at most (m and rad), a velocity that belongs to it, and other
/// internal states.
pub fn scattered<M: Assemble<f64>>(model: &M, spread: f64, random: &mut Random) -> Option<(f64, StateOf<M>)> {
    let start = model.start();
    let still = State { v: model.zero_v(), ..start };
    beside(model, &still, [spread * random.unit(), 1.0], random).map(|state| (0.0, state))
}

/// A state beside another at the start of time: moved by the first at most (m and rad), faster by the second (m/s and rad/s), both as the
/// mechanism lets it; with other internal states.
pub fn beside<M: Assemble<f64>>(
    model: &M,
    base: &StateOf<M>,
    [spread, faster]: [f64; 2],
    random: &mut Random,
) -> Option<StateOf<M>> {
    let mut shift = model.zero_v();
    shift.as_mut_slice().iter_mut().for_each(|x| *x = spread * random.unit());
    let mut q = base.q.clone();
    retract(model.layout(), &base.q, &shift, &mut q);
    let q = project_position(model, 0.0, &q).ok()?;
    let mut wish = base.v.clone();
    wish.as_mut_slice().iter_mut().for_each(|v| *v += faster * random.unit());
    let v = project_velocity(model, 0.0, &q, &wish).ok()?;
    let mut z = base.z.clone();
    z.as_mut_slice().iter_mut().for_each(|z| {
        let by = random.unit();
        *z = if *z == 0.0 { SMALL * 100.0_f64.powf(random.unit()) * by } else { *z * (1.0 + 0.5 * by) };
    });
    let state = State { q, v, z, ..base.clone() };
    Some(State { gates: model.live_gates(0.0, &state), ..state })
}

/// Whether no angle is beyond half a turn: a body's orientation does not say how often it has turned. Angles that are counted come last, each
/// with its whole turns and what is left.
pub fn is_within_half_a_turn<M: Assemble<f64>>(model: &M, state: &StateOf<M>) -> bool {
    let q = state.q.as_slice();
    let mut counted = q[q.len() - 2 * model.layout().angles.len()..].chunks(2);
    counted.all(|angle| angle[0] == 0.0 && angle[1].abs() < PI)
}
