//! Formulations and integrators by name, and a run under any of them.

use super::expression::unknown;
use super::inputs::Laws;
use linkwright_engine::{Derivatives, Engine, List, Numbers};
use linkwright_runtime::{
    Ali3p, AugmentedLagrangian, Baumgarte, DormandPrince, ExplicitTrapezoidal, Formulation, GeneralisedAlpha,
    ImplicitTrapezoidal, InputSource, Integrator, LagrangeIndex1, MechanismDynamics, NullSpace, Partitioned,
    Penalty, Projected, Rk4, SemiImplicitEuler, Simulation, SimulationError, State,
};

pub type EngineState = State<List, List, List, List>;

/// A method with the number behind its colon.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    pub name: &'static str,
    pub number: Option<f64>,
}

/// Names, and what the number behind a colon is, where there may be one.
pub const FORMULATIONS: [(&str, &str); 7] = [
    ("lagrange", ""),
    ("baumgarte", "α = β in 1/s"),
    ("projected", ""),
    ("null_space", ""),
    ("partitioned", ""),
    ("penalty", "α"),
    ("augmented_lagrangian", "α"),
];

pub const INTEGRATORS: [(&str, &str); 7] = [
    ("rk4", ""),
    ("explicit_trapezoidal", ""),
    ("semi_implicit_euler", ""),
    ("dormand_prince", "tolerance"),
    ("generalised_alpha", "ρ∞"),
    ("implicit_trapezoidal", ""),
    ("ali3p", "α"),
];

/// The method of a list that `text` names: `baumgarte`, `baumgarte:20`.
pub fn chosen(what: &str, text: &str, list: &[(&'static str, &str)]) -> Result<Chosen, String> {
    let (word, number) = match text.split_once(':') {
        Some((word, number)) => (word, Some(number)),
        None => (text, None),
    };
    let Some((name, meaning)) = list.iter().find(|(name, _)| *name == word) else {
        return Err(unknown(&format!("no {what} is called"), word, list.iter().map(|(name, _)| *name)));
    };
    let number = match number {
        None => None,
        Some(_) if meaning.is_empty() => {
            return Err(format!("{what} `{name}` has no number: write `{name}`"));
        }
        Some(number) => match number.parse::<f64>() {
            Ok(number)
                if number > 0.0 && number.is_finite() || (*name == "generalised_alpha" && number == 0.0) =>
            {
                Some(number)
            }
            _ => return Err(format!("\"{number}\" behind `{name}:` is no positive number: it is {meaning}")),
        },
    };
    Ok(Chosen { name, number })
}

impl Chosen {
    /// Whether it needs the derivatives of the equations.
    pub fn is_implicit(&self) -> bool {
        matches!(self.name, "generalised_alpha" | "implicit_trapezoidal" | "ali3p")
    }
}

impl std::fmt::Display for Chosen {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.number {
            None => f.write_str(self.name),
            Some(number) => write!(f, "{}:{number}", self.name),
        }
    }
}

/// How a run goes.
#[derive(Clone, Debug)]
pub struct Course {
    pub duration: f64,
    pub step: f64,
    /// Between samples; every step if it is not given.
    pub every: Option<f64>,
    pub formulation: Chosen,
    pub integrator: Chosen,
}

/// Is shown a sample: time, state, inputs and outputs.
pub type Show<'s> = dyn FnMut(f64, &EngineState, &Numbers, &Numbers) + 's;

/// Inputs at every stage.
struct Given<'l>(&'l Laws);

impl<D: 'static> InputSource<f64, Engine<D>> for Given<'_> {
    const HELD: bool = false;

    fn sample(&mut self, time: f64, _state: &EngineState) -> Numbers {
        self.0.at(time)
    }
}

/// An engine with or without derivatives.
#[derive(Clone)]
pub enum AnyEngine {
    Plain(Engine),
    Implicit(Engine<Derivatives>),
}

/// Does the same with either engine.
#[macro_export]
macro_rules! with_engine {
    ($any:expr, |$engine:ident| $body:expr) => {
        match $any {
            $crate::study::methods::AnyEngine::Plain($engine) => $body,
            $crate::study::methods::AnyEngine::Implicit($engine) => $body,
        }
    };
}

/// Moves from a start and shows the samples, that of the start first. After an error all samples until then have been shown.
pub fn run(
    engine: &AnyEngine,
    start: &EngineState,
    laws: &Laws,
    course: &Course,
    show: &mut Show<'_>,
) -> Result<(), SimulationError> {
    let Chosen { name, number } = &course.integrator;
    match (engine, *name) {
        (AnyEngine::Implicit(engine), "generalised_alpha") => {
            let method = GeneralisedAlpha::new(number.unwrap_or(0.8));
            moved(engine, start, laws, course, LagrangeIndex1, method, show)
        }
        (AnyEngine::Implicit(engine), "implicit_trapezoidal") => {
            moved(engine, start, laws, course, LagrangeIndex1, ImplicitTrapezoidal::default(), show)
        }
        (AnyEngine::Implicit(engine), "ali3p") => {
            moved(engine, start, laws, course, LagrangeIndex1, Ali3p::new(number.unwrap_or(1e7)), show)
        }
        (AnyEngine::Implicit(engine), _) => explicit(engine, start, laws, course, show),
        (AnyEngine::Plain(engine), _) => explicit(engine, start, laws, course, show),
    }
}

fn explicit<D: 'static>(
    engine: &Engine<D>,
    start: &EngineState,
    laws: &Laws,
    course: &Course,
    show: &mut Show<'_>,
) -> Result<(), SimulationError> {
    let Chosen { name, number } = &course.formulation;
    let penalty = || match number {
        Some(alpha) => Penalty::new(*alpha),
        None => Penalty::for_model(engine, 0.0, &start.q, course.step),
    };
    match *name {
        "baumgarte" => {
            let alpha = number.unwrap_or(10.0);
            integrated(engine, start, laws, course, Baumgarte { alpha, beta: alpha }, show)
        }
        "projected" => integrated(engine, start, laws, course, Projected::after(LagrangeIndex1), show),
        "null_space" => integrated(engine, start, laws, course, NullSpace, show),
        "partitioned" => integrated(engine, start, laws, course, Partitioned::default(), show),
        "penalty" => integrated(engine, start, laws, course, penalty(), show),
        "augmented_lagrangian" => {
            integrated(engine, start, laws, course, AugmentedLagrangian::new(penalty()), show)
        }
        _ => integrated(engine, start, laws, course, LagrangeIndex1, show),
    }
}

fn integrated<D: 'static, F: Formulation<f64, Engine<D>>>(
    engine: &Engine<D>,
    start: &EngineState,
    laws: &Laws,
    course: &Course,
    formulation: F,
    show: &mut Show<'_>,
) -> Result<(), SimulationError> {
    match course.integrator.name {
        "dormand_prince" => {
            let method = DormandPrince::tolerance(course.integrator.number.unwrap_or(1e-8));
            moved(engine, start, laws, course, formulation, method, show)
        }
        "explicit_trapezoidal" => moved(engine, start, laws, course, formulation, ExplicitTrapezoidal, show),
        "semi_implicit_euler" => moved(engine, start, laws, course, formulation, SemiImplicitEuler, show),
        _ => moved(engine, start, laws, course, formulation, Rk4, show),
    }
}

fn moved<'m, D, F, I>(
    engine: &'m Engine<D>,
    start: &EngineState,
    laws: &'m Laws,
    course: &Course,
    formulation: F,
    integrator: I,
    show: &mut Show<'_>,
) -> Result<(), SimulationError>
where
    D: 'static,
    F: Formulation<f64, Engine<D>>,
    I: Integrator<f64, MechanismDynamics<'m, Engine<D>, f64, F, Given<'m>>>,
{
    let simulation =
        Simulation::new(engine, start.clone()).input_source(Given(laws)).formulation(formulation);
    let mut simulation = simulation.integrator(integrator).step(course.step);
    match course.every {
        None => {
            for sample in simulation.samples(course.duration) {
                let sample = sample?;
                show(sample.time, &sample.state, &sample.inputs, &sample.outputs);
            }
        }
        Some(every) => {
            let count = (course.duration / every * (1.0 + 1e-12)).floor() as u64;
            let times = (1..=count).map(|index| tidy(index as f64 * every).min(course.duration));
            let rest = (course.duration - count as f64 * every > 1e-9 * every).then_some(course.duration);
            let first = simulation.sample();
            show(first.time, &first.state, &first.inputs, &first.outputs);
            for time in times.chain(rest) {
                // All steps are sampled, so that angles are followed through their turns.
                simulation.run_until(time, |sample| {
                    if sample.time >= time {
                        show(sample.time, &sample.state, &sample.inputs, &sample.outputs);
                    }
                })?;
            }
        }
    }
    Ok(())
}

/// The number with twelve digits that is nearest: 0.6 for 3 · 0.2.
fn tidy(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}
