//! Many members at once, in lanes and on threads.

use crate::timed::RATE;
use linkwright::lanes::InScalars;
use linkwright::{AssembleExt, Baumgarte, Fields, Mechanism, Rk4, Vector};
use linkwright_batch::{Batch, Constant};
use std::time::Instant;

/// Seconds for so many steps of RK4 of all members, which start alike.
pub fn seconds<M: InScalars>(members: usize, threads: usize, step: f64, steps: usize) -> f64 {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let model = M::In::<f64>::default();
    let count = model.input_names().len();
    let inputs = Constant(<M::In<f64> as Mechanism<f64>>::Inputs::from_array(Vector::zeros(count)));
    let method = (Rk4, Baumgarte { alpha: RATE, beta: RATE });
    let mut batch = Batch::<M, _>::alike(members, &model, &model.start(), method).expect("there are members");
    let begin = Instant::now();
    let summary = pool.install(|| batch.run(&inputs, step, steps));
    assert_eq!(summary.failed, 0, "members failed");
    begin.elapsed().as_secs_f64()
}
