//! One case: a mechanism, methods, a start and a few calls from ordinary to absurd, and what must be true after each.

use crate::methods::{Means, Of, Way};
use crate::models::{Crank, Folding, Rods, Subject, Swing, Top, Winch};
use crate::random::Random;
use linkwright::{
    AssembleExt, Direction, DormandPrince, Event, Fields, InputSource, Linearisation, Mechanism, Motion,
    Simulation, State, StateOf, Vector, actuation, equilibrium,
};
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Evaluations in one call after which it is said not to come back.
const EVALUATIONS: u64 = 200_000;

/// Steps, or samples, of a run that is waited for.
const PATIENCE: f64 = 1000.0;

/// Counts from which on a run is refused.
const MOST_STEPS: f64 = 9_007_199_254_740_992.0;
const MOST_SAMPLES: f64 = 4_294_967_296.0;

/// Thrown from the source of inputs where a call does not come back.
struct Endless;

thread_local! {
    /// Whether the case at hand chooses its own steps.
    static ADAPTIVE: Cell<bool> = const { Cell::new(false) };
}

/// Inputs of a case, which count how often they are asked for.
struct Counted<'c, M: Mechanism<f64>> {
    inputs: M::Inputs,
    count: &'c Cell<u64>,
}

impl<M: Mechanism<f64>> InputSource<f64, M> for Counted<'_, M> {
    const HELD: bool = false;

    fn sample(&mut self, _: f64, _: &StateOf<M>) -> M::Inputs {
        self.count.set(self.count.get() + 1);
        if self.count.get() > EVALUATIONS {
            std::panic::panic_any(Endless);
        }
        self.inputs.clone()
    }
}

/// What a case came to, for the statistics.
#[derive(Clone, Copy, Debug, Default)]
pub struct Verdict {
    pub calls: u64,
    pub good: u64,
}

/// Judges a case.
///
/// # Errors
/// What went wrong.
pub fn judge(seed: u64, number: u64) -> Result<Verdict, String> {
    let mut random = Random::of_case(seed, number);
    let run = AssertUnwindSafe(|| match random.below(6) {
        0 => of_model::<Swing<f64>>(&mut random),
        1 => of_model::<Winch<f64>>(&mut random),
        2 => of_model::<Crank<f64>>(&mut random),
        3 => of_model::<Rods<f64>>(&mut random),
        4 => of_model::<Top<f64>>(&mut random),
        _ => of_model::<Folding<f64>>(&mut random),
    });
    match catch_unwind(run) {
        Ok(verdict) => verdict,
        Err(thrown) if thrown.is::<Endless>() => {
            Err(format!("more than {EVALUATIONS} evaluations in one call"))
        }
        Err(thrown) => {
            let text = thrown.downcast_ref::<String>().map(String::as_str);
            Err(format!("panic: {}", text.or(thrown.downcast_ref::<&str>().copied()).unwrap_or("?")))
        }
    }
}

fn of_model<M: Subject>(random: &mut Random) -> Result<Verdict, String> {
    let model = M::any(random);
    let start = start::<M>(random, &model);
    let inputs = inputs::<M>(random);
    if random.once_in(3) {
        return solved(random, &model, &start, &inputs).map_err(|fault| format!("{}: {fault}", model.name()));
    }
    let (way, means) = (Way::any(random), Means::any(random));
    let moved = match way.pivot() {
        0 => moved(random, &model, start, inputs, Of::<0>(way), means),
        1 => moved(random, &model, start, inputs, Of::<1>(way), means),
        _ => moved(random, &model, start, inputs, Of::<2>(way), means),
    };
    moved.map_err(|fault| format!("{}, {way:?}, {means:?}: {fault}", model.name()))
}

/// The start, one near it that is consistent, or anything.
fn start<M: Subject>(random: &mut Random, model: &M) -> StateOf<M> {
    let mut start = model.start();
    match random.below(4) {
        0 => {}
        1 => start = model.assemble(&start).unwrap_or(start),
        2 => {
            for entry in start.v.as_mut_slice() {
                *entry += random.unit();
            }
            start = model.project(0.0, &start).unwrap_or(start);
        }
        _ => {
            for entry in start.q.as_mut_slice().iter_mut().chain(start.v.as_mut_slice()) {
                if random.once_in(4) {
                    *entry = random.near(*entry);
                }
            }
        }
    }
    start
}

fn inputs<M: Subject>(random: &mut Random) -> M::Inputs {
    let mut values = <M::Inputs as Fields<f64>>::Array::zeros(M::Inputs::NAMES.len());
    values.as_mut_slice().iter_mut().for_each(|value| *value = random.near(1.0));
    M::Inputs::from_array(values)
}

/// The bits of all numbers of a state and a time.
fn bits<M: Mechanism<f64>>(time: f64, state: &StateOf<M>) -> Vec<u64> {
    let numbers = state.q.as_slice().iter().chain(state.v.as_slice()).chain([&time]);
    numbers.map(|number| number.to_bits()).collect()
}

fn finite(what: &str, numbers: &[f64]) -> Result<(), String> {
    match numbers.iter().find(|number| !number.is_finite()) {
        None => Ok(()),
        Some(number) => Err(format!("Ok with {what} of {number}")),
    }
}

/// Steps, runs and events.
fn moved<M: Subject, const P: u8>(
    random: &mut Random,
    model: &M,
    start: StateOf<M>,
    inputs: M::Inputs,
    way: Of<P>,
    means: Means,
) -> Result<Verdict, String> {
    let (count, mut verdict) = (Cell::new(0), Verdict::default());
    ADAPTIVE.set(matches!(means, Means::DormandPrince(_)));
    let h = random.near(1e-3);
    let simulation =
        Simulation::new(model, start).formulation(way).input_source(Counted { inputs, count: &count });
    let mut simulation = simulation.integrator(means).step(h);
    if random.once_in(2) {
        simulation = simulation.accept_inconsistent_start();
    }
    if random.once_in(4) {
        simulation = simulation.step_over_breakdowns();
    }
    if random.once_in(3) {
        simulation = simulation.start_time(random.near(1.0));
    }
    for _ in 0..6 {
        count.set(0);
        let (time, state) = (simulation.time(), simulation.state().clone());
        let usual = time + h * (1 + random.below(20)) as f64;
        let end = if random.once_in(8) { random.near(usual) } else { usual };
        // What would take long takes long.
        let end = if waited((end - time) / h, MOST_STEPS) { end } else { usual };
        let (mut shown, mut steps_only) = (0_u64, false);
        let call = random.below(5);
        let outcome = match call {
            0 | 1 => {
                steps_only = true;
                simulation.advance().map(|step| step.time)
            }
            2 => simulation.advance_until(end).map(|_| end),
            3 => simulation.run_until(end, |_| shown += 1).map(|_| end),
            _ => {
                let (level, tolerance) = (random.near(0.1), random.near(1e-6));
                let direction = [Direction::Rising, Direction::Falling, Direction::Either][random.below(3)];
                let output = M::Outputs::NAMES[random.below(M::Outputs::NAMES.len())];
                let event = Event { output, level, direction, tolerance };
                let found = simulation.run_until_event(end, &[event], |_| shown += 1);
                found.map(|found| found.map_or(end, |found| found.time))
            }
        };
        verdict.calls += 1;
        verdict.good += u64::from(outcome.is_ok());
        let most = (end - time) / h;
        if matches!(call, 3 | 4) && !ADAPTIVE.get() && most.is_finite() && shown as f64 > most.max(0.0) + 3.0
        {
            return Err(format!("{shown} samples of {most} steps of {h:e} from {time:e} to {end:e}"));
        }
        if matches!(call, 2..=4) && most > MOST_STEPS && outcome.is_ok() && count.get() > 0 {
            return Err(format!("{most} steps were not refused"));
        }
        let now = simulation.state();
        let told = |fault: String| format!("call {call} with h = {h:e} from {time:e} to {end:e}: {fault}");
        match outcome {
            Ok(reached) => {
                if call < 2 || end > time {
                    finite("a coordinate", now.q.as_slice()).map_err(told)?;
                    finite("a velocity", now.v.as_slice()).map_err(told)?;
                }
                finite("a time", &[simulation.time()]).map_err(told)?;
                // −0 as an end is 0.
                if simulation.time() != reached {
                    return Err(told(format!(
                        "it stands at {:e} in place of {reached:e}",
                        simulation.time()
                    )));
                }
                // A step below the distance of neighbouring times moves the clock, but not yet its rounded value, which may stand half
                // of it ahead.
                let stands = simulation.time() < time || simulation.time() == time && time + 0.5 * h > time;
                if steps_only && stands && !ADAPTIVE.get() {
                    return Err(told("the time stands".into()));
                }
            }
            Err(error) => {
                let text = error.to_string();
                if text.is_empty() {
                    return Err(told("an error without a text".into()));
                }
                if steps_only && bits::<M>(time, &state) != bits::<M>(simulation.time(), now) {
                    return Err(told(format!("after an error the state is another: {text}")));
                }
                if shown > 0 || !steps_only {
                    let begun = finite("", state.q.as_slice()).and(finite("", state.v.as_slice()));
                    let stands = finite("", now.q.as_slice()).and(finite("", now.v.as_slice()));
                    if begun.is_ok() && stands.is_err() {
                        return Err(told(format!("the last good state is none: {text}")));
                    }
                }
            }
        }
        count.set(0);
        if let Ok(a) = simulation.acceleration() {
            finite("an acceleration", a.as_slice()).map_err(told)?;
        }
        if let Ok(lambda) = simulation.multipliers() {
            finite("a multiplier", lambda.as_slice()).map_err(told)?;
        }
    }
    Ok(verdict)
}

/// Positions, rates, derivatives, states between steps.
fn solved<M: Subject>(
    random: &mut Random,
    model: &M,
    start: &StateOf<M>,
    inputs: &M::Inputs,
) -> Result<Verdict, String> {
    let mut verdict = Verdict::default();
    let time = if random.once_in(3) { random.near(0.5) } else { 0.0 };
    let mut judged = |what: &str, numbers: Option<Vec<f64>>| {
        verdict.calls += 1;
        verdict.good += u64::from(numbers.is_some());
        numbers.map_or(Ok(()), |numbers| {
            finite("a number", &numbers).map_err(|fault| format!("{what}: {fault}"))
        })
    };
    let both = |state: StateOf<M>| [state.q.as_slice(), state.v.as_slice()].concat();
    judged("assemble", model.assemble(start).ok().map(both))?;
    judged("project", model.project(time, start).ok().map(both))?;
    let given: Vec<Motion> = (0..model.independent().len())
        .map(|_| Motion {
            position: random.near(1.0),
            rate: random.near(1.0),
            acceleration: random.near(1.0),
        })
        .collect();
    let kinematics = model.kinematics(time, &start.q, &given).ok();
    let all = kinematics
        .as_ref()
        .map(|found| [found.q.as_slice(), found.v.as_slice(), found.a.as_slice()].concat());
    judged("kinematics", all)?;
    let rest = equilibrium(model, time, &start.q, inputs).ok();
    judged("equilibrium", rest.map(|found| [found.q.as_slice(), found.lambda.as_slice()].concat()))?;
    if let Some(found) = kinematics {
        let state = State { q: found.q, v: found.v, ..start.clone() };
        let driven = actuation(model, time, &state, &found.a, inputs, M::Inputs::NAMES).ok();
        judged("actuation", driven.map(|found| found.inputs.to_array().as_slice().to_vec()))?;
    }
    if let Ok(here) = Linearisation::at(model, time, start, inputs) {
        judged(
            "linearisation",
            Some([here.acceleration().as_slice(), here.multipliers().as_slice()].concat()),
        )?;
        let matrices = here.state_space().ok();
        judged("state space", matrices.map(|found| [found.a.as_slice(), found.c.as_slice()].concat()))?;
        model.derived(time, start, inputs, here.acceleration(), here.multipliers());
    }

    let count = Cell::new(0);
    ADAPTIVE.set(true);
    let h = random.near(1e-2);
    let means = DormandPrince::tolerance(1e-5).most_steps(100);
    let source = Counted { inputs: inputs.clone(), count: &count };
    let mut simulation = Simulation::new(model, start.clone()).input_source(source).integrator(means).step(h);
    for _ in 0..3 {
        count.set(0);
        let before = simulation.time();
        let taken = simulation.advance().is_ok();
        let at = before + (simulation.time() - before) * random.near(0.5);
        judged("interpolate", simulation.interpolate(at).ok().filter(|_| taken).map(both))?;
    }
    count.set(0);
    let end = simulation.time() + 10.0 * h;
    let interval = random.near(h);
    let interval = if waited(10.0 * h / interval, MOST_SAMPLES) { interval } else { h };
    let reached = simulation.run_every(interval, end, |sample| _ = std::hint::black_box(sample.energy()));
    judged("run_every", reached.ok().map(both))?;
    Ok(verdict)
}

/// Whether a run of so many steps or samples is short, or refused at once.
fn waited(count: f64, most: f64) -> bool {
    count.is_nan() || count <= PATIENCE || count > 1.01 * most
}
