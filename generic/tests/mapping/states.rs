//! States of emitted models along their motion, and with other velocities there.

use linkwright::{
    Assemble, AssembleExt, Baumgarte, Fields, Report, Simulation, State, StateOf, Vector, project_velocity,
};

/// Seconds between states along the motion.
const APART: f64 = 0.004;

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
