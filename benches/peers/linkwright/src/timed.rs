//! What is timed of a mechanism: evaluations of v̇ as formulations ask it, Baumgarte's terms included, and steps of RK4.

use linkwright::lanes::InScalars;
use linkwright::{
    Assemble, AssembleExt, Baumgarte, Fields, Mechanism, Rk4, State, StateOf, Variables, Vector,
};
use std::hint::black_box;

/// α = β of Baumgarte's terms, 1/s, in all peers that have them.
pub const RATE: f64 = 10.0;
/// What a result is multiplied by before the next state is shifted by it: nothing is left, and the processor cannot know.
const NEXT_TO_NOTHING: f64 = 1e-60;

/// What the interface asks, whatever the mechanism is.
pub trait Timed {
    fn sizes(&self) -> [usize; 2];
    fn give(&mut self, rows: &[f64]);
    fn accelerations(&mut self) -> Vec<f64>;
    fn evaluate(&mut self, first: usize, count: usize);
    fn chain(&mut self, count: usize);
    fn simulate(&mut self, step: f64, steps: usize, row: &mut [f64]) -> usize;
    fn batch(&self, members: usize, threads: usize, step: f64, steps: usize) -> f64;
    fn start_motions(&self) -> Vec<f64>;
    fn motions_of(&self, row: &[f64]) -> Vec<f64>;
    /// Rows of states, of accelerations, and of the motions of bodies.
    fn states(&self, seed: u64, count: usize) -> [Vec<f64>; 3];
}

type Evaluation<M> = fn(
    &M,
    f64,
    &StateOf<M>,
    &<M as Mechanism<f64>>::Inputs,
    f64,
    f64,
    &mut <M as Variables<f64>>::V,
    &mut <M as Variables<f64>>::Lambda,
) -> f64;

pub type Motions<M> = fn(&M, &StateOf<M>, &<M as Variables<f64>>::V) -> Vec<f64>;

/// A mechanism of one type, with its states.
pub struct Of<M: Assemble<f64>> {
    pub model: M,
    pub inputs: M::Inputs,
    pub motions: Motions<M>,
    /// Seconds between states along the motion.
    pub pace: f64,
    /// Called through a pointer, like all others, so that nothing is kept from one state to the next.
    evaluation: Evaluation<M>,
    given: Vec<StateOf<M>>,
    a: M::V,
    lambda: M::Lambda,
}

impl<M> Of<M>
where
    M: InScalars + Assemble<f64, Z = (), Gates = ()>,
    M::Inputs: Fields<f64>,
{
    pub fn new(pace: f64, inputs: <M::Inputs as Fields<f64>>::Array, motions: Motions<M>) -> Self
    where
        M: Default,
    {
        let model = M::default();
        let evaluation: Evaluation<M> =
            if model.null_space_first() { M::null_space_baumgarte } else { M::acceleration_baumgarte };
        Of {
            inputs: M::Inputs::from_array(inputs),
            motions,
            pace,
            evaluation: black_box(evaluation),
            given: vec![model.start()],
            a: model.zero_v(),
            lambda: model.zero_lambda(),
            model,
        }
    }

    pub fn state(&self, row: &[f64]) -> StateOf<M> {
        let mut state: StateOf<M> = self.model.start();
        let (q, v) = row.split_at(state.q.as_slice().len());
        state.q.as_mut_slice().copy_from_slice(q);
        state.v.as_mut_slice().copy_from_slice(v);
        state
    }

    pub fn acceleration(&self, state: &StateOf<M>) -> M::V {
        let (mut a, mut lambda) = (self.model.zero_v(), self.model.zero_lambda());
        (self.evaluation)(
            &self.model,
            0.0,
            state,
            &self.inputs,
            2.0 * RATE,
            RATE * RATE,
            &mut a,
            &mut lambda,
        );
        a
    }
}

impl<M> Timed for Of<M>
where
    M: InScalars + Assemble<f64, Z = (), Gates = ()> + Clone + Send + Sync + 'static,
    M::Inputs: Fields<f64> + Send + Sync,
{
    fn sizes(&self) -> [usize; 2] {
        let State { q, v, .. } = self.model.start();
        [q.as_slice().len(), v.as_slice().len()]
    }

    fn give(&mut self, rows: &[f64]) {
        let width = self.sizes().iter().sum();
        self.given = rows.chunks(width).map(|row| self.state(row)).collect();
    }

    fn accelerations(&mut self) -> Vec<f64> {
        self.given.iter().flat_map(|state| self.acceleration(state).as_slice().to_vec()).collect()
    }

    fn evaluate(&mut self, first: usize, count: usize) {
        let Of { model, inputs, evaluation, given, a, lambda, .. } = self;
        let mut at = first % given.len();
        for _ in 0..count {
            let state = &given[black_box(at)];
            let pivot = evaluation(model, 0.0, state, inputs, 2.0 * RATE, RATE * RATE, a, lambda);
            black_box((pivot, &a, &lambda));
            at += 1;
            if at == given.len() {
                at = 0;
            }
        }
    }

    fn chain(&mut self, count: usize) {
        let Of { model, inputs, evaluation, given, a, lambda, .. } = self;
        let mut state = given[0].clone();
        for _ in 0..count {
            evaluation(model, 0.0, black_box(&state), inputs, 2.0 * RATE, RATE * RATE, a, lambda);
            let shift = black_box(NEXT_TO_NOTHING) * a.as_slice()[0];
            for value in state.q.as_mut_slice().iter_mut().chain(state.v.as_mut_slice()) {
                *value += shift;
            }
        }
        black_box(&state);
    }

    fn simulate(&mut self, step: f64, steps: usize, row: &mut [f64]) -> usize {
        let mut stepper = self.model.stepper(self.state(row), (Rk4, Baumgarte { alpha: RATE, beta: RATE }));
        let good = (0..steps).take_while(|_| stepper.step(&self.inputs, step).is_ok()).count();
        let State { q, v, .. } = stepper.state();
        let n = q.as_slice().len();
        row[..n].copy_from_slice(q.as_slice());
        row[n..].copy_from_slice(v.as_slice());
        good
    }

    fn batch(&self, members: usize, threads: usize, step: f64, steps: usize) -> f64 {
        crate::batch::seconds::<M>(members, threads, step, steps)
    }

    fn start_motions(&self) -> Vec<f64> {
        let start = self.model.start();
        (self.motions)(&self.model, &start, &self.acceleration(&start))
    }

    fn motions_of(&self, row: &[f64]) -> Vec<f64> {
        let state = self.state(row);
        (self.motions)(&self.model, &state, &self.acceleration(&state))
    }

    fn states(&self, seed: u64, count: usize) -> [Vec<f64>; 3] {
        let mut found = [const { Vec::new() }; 3];
        for state in crate::states::consistent(self, seed, count) {
            let a = self.acceleration(&state);
            found[0].extend(state.q.as_slice().iter().chain(state.v.as_slice()));
            found[1].extend(a.as_slice());
            found[2].extend((self.motions)(&self.model, &state, &a));
        }
        found
    }
}
