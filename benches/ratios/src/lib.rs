//! Mechanisms that take turns: each is evaluated and stepped in many short slices, and the least time of each counts.

use linkwright::{Assemble, AssembleExt, Fields, Real, Rk4, StateOf};
use std::hint::black_box;
use std::time::Instant;

/// So few that a slice meets each several times: what others left in the caches is met by the first.
const STATES: usize = 8;
const ROUNDS: usize = 400;
/// Of a slice, ns, and how many calls it has at least.
const SLICE: f64 = 20e3;
const FEWEST: usize = 8 * STATES;

/// What is timed of one mechanism: so many evaluations, v̇ and λ with Baumgarte's terms by the way that leads, at states along the motion; so many
/// steps of RK4 by a stepper.
pub struct Timed {
    evaluations: Box<dyn FnMut(usize)>,
    steps: Box<dyn FnMut(usize)>,
}

impl Timed {
    /// With states ten of the first steps apart, in s, and timed in the second.
    pub fn new<R: Real, M>(model: M, inputs: M::Inputs, apart: R, step: R) -> Self
    where
        M: Assemble<R> + AssembleExt<R> + Clone + 'static,
        M::Inputs: Clone + Fields<R> + 'static,
        StateOf<M, R>: Clone,
    {
        let model: &'static M = Box::leak(Box::new(model));
        let mut stepper = model.clone().stepper(model.start(), Rk4);
        let states: Vec<StateOf<M, R>> = (0..STATES)
            .map(|_| {
                (0..10).for_each(|_| assert!(stepper.step(&inputs, apart).is_ok(), "it moves"));
                stepper.state().clone()
            })
            .collect();
        let function =
            if model.null_space_first() { M::null_space_baumgarte } else { M::acceleration_baumgarte };
        let (mut a, mut lambda, mut at) = (model.zero_v(), model.zero_lambda(), 0);
        let given = inputs.clone();
        let [alpha, beta] = [20.0, 100.0].map(R::from_f64);
        let evaluations = move |count: usize| {
            for _ in 0..count {
                at = (at + 1) % STATES;
                let state = black_box(&states[at]);
                let pivot =
                    black_box(function)(model, R::ZERO, state, &given, alpha, beta, &mut a, &mut lambda);
                black_box((pivot, &a, &lambda));
            }
        };
        let mut stepper = model.clone().stepper(model.start(), Rk4);
        let steps = move |count: usize| {
            (0..count).for_each(|_| assert!(black_box(stepper.step(&inputs, black_box(step))).is_ok()));
        };
        Timed { evaluations: Box::new(evaluations), steps: Box::new(steps) }
    }
}

/// ns of an evaluation and of a step of each, the least of many slices, in turns.
pub fn least(of: &mut [Timed]) -> Vec<[f64; 2]> {
    let count = |each: f64| FEWEST.max((SLICE / each).ceil() as usize);
    let counts: Vec<[usize; 2]> =
        of.iter_mut().map(|it| [time(&mut it.evaluations, 20), time(&mut it.steps, 20)].map(count)).collect();
    let mut least = vec![[f64::INFINITY; 2]; of.len()];
    for _ in 0..ROUNDS {
        for ((it, counts), least) in of.iter_mut().zip(&counts).zip(&mut least) {
            least[0] = least[0].min(time(&mut it.evaluations, counts[0]));
            least[1] = least[1].min(time(&mut it.steps, counts[1]));
        }
    }
    least
}

/// ns of each of so many calls.
fn time(call: &mut dyn FnMut(usize), count: usize) -> f64 {
    let start = Instant::now();
    call(count);
    start.elapsed().as_nanos() as f64 / count as f64
}
