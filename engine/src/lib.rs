//! Mechanisms whose definition is read while the program runs.
//!
//! [`Engine`] takes what the compiler makes of a definition and implements the traits of the runtime with it: every formulation,
//! integrator, event, output and message is that of a compiled mechanism, and so is every number, to the bit (with the fused
//! multiply-add of the target, if it has one, but in tables). No Rust is compiled: programs are interpreted.
//!
//! ```
//! use linkwright_engine::{Engine, List};
//! use linkwright_runtime::{AssembleExt, Mechanism, Simulation, Vector};
//!
//! let pendulum = Engine::read("
//!     planar Pendulum {
//!         param length [m] = 0.5;
//!         gravity [m/s^2] = (0, -9.81);
//!         rod bob { mass [kg] = 1; length [m] = length; }
//!         joint pivot: revolute(ground(0, 0) [m], bob.start);
//!         start { pivot.angle [deg] = -60; }
//!         output angle [rad] = pivot.angle;
//!     }
//! ").unwrap();
//! let longer = pendulum.prepared(&[0.8]).unwrap();
//! let start = longer.assemble(&longer.start()).unwrap();
//! let mut simulation = Simulation::new(&longer, start).constant(longer.no_inputs()).step(1e-3);
//! let energy = simulation.energy();
//! simulation.advance_until(1.0).unwrap();
//! assert!((simulation.energy() - energy).abs() < 1e-8, "{energy}");
//! let angle = longer.outputs(1.0, simulation.state(), &longer.no_inputs()).as_slice()[0];
//! assert!(angle < -1.5, "it has swung through: {angle}");
//! ```
//!
//! Names, and the short lists of names that errors show, are kept as long as the program runs, each once: reading the same
//! definition again and again costs no memory for them, reading ever other ones a little.
#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod assemble;
mod code;
mod list;
mod mechanism;
mod names;
mod report;
mod tables;
mod tangent;
mod translate;

pub use list::{List, Numbers};
pub use report::Follows;
pub use tangent::Derivatives;
pub use translate::{REGISTERS, Translated, Translator};

use code::{Code, Places, Registers, TooLarge};
use linkwright_compiler::diagnostics::Diagnostics;
use linkwright_compiler::functions::{Argument, Function};
use linkwright_compiler::source::{self, Source};
use linkwright_compiler::{Compiled, compile_with, parse_at};
use linkwright_runtime::{Assemble, SettingError, Vector};
use std::cell::{RefCell, RefMut};
use std::fmt;
use std::marker::PhantomData;
use std::path::PathBuf;
use std::sync::Arc;
use tables::Tables;

/// A mechanism that is interpreted, prepared with parameters.
///
/// `D` says whether it has the derivatives of its equations, as `options { emit = (tangent); }` says of a compiled one:
/// [`Derivatives`] or nothing. A clone shares code and tables, and can be moved to another thread.
pub struct Engine<D = ()> {
    shared: Arc<Shared>,
    parameters: Numbers,
    phases: List,
    registers: RefCell<Registers>,
    derivatives: PhantomData<fn() -> D>,
}

/// What does not change with parameters.
struct Shared {
    places: Places,
    /// In the order of [`Function::ALL`].
    code: Vec<Code>,
    tables: Tables,
}

/// Why a definition does not become an engine.
#[derive(Debug)]
#[non_exhaustive]
pub enum EngineError {
    /// It cannot be compiled: the messages of the compiler.
    Definition(Diagnostics),
    /// What is no token of the language: a message with its line.
    Token(String),
    /// It needs more values at once than the interpreter has registers.
    TooLarge {
        /// How many it needs at least.
        registers: usize,
    },
    /// Its derivatives are asked for and it has been compiled without them.
    NoDerivatives,
}

impl fmt::Display for EngineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EngineError::Definition(errors) => errors.fmt(f),
            EngineError::Token(message) => message.fmt(f),
            EngineError::TooLarge { registers } => write!(
                f,
                "the mechanism is too large for the interpreter: it needs {registers} values at once or more, and there are 65536 \
                 registers; use the macro, or fewer parts"
            ),
            EngineError::NoDerivatives => {
                write!(
                    f,
                    "the derivatives of the equations are missing: compile the definition with the word `tangent` of `emit`"
                )
            }
        }
    }
}

impl std::error::Error for EngineError {}

impl From<TooLarge> for EngineError {
    fn from(TooLarge { registers }: TooLarge) -> Self {
        EngineError::TooLarge { registers }
    }
}

impl From<Diagnostics> for EngineError {
    fn from(errors: Diagnostics) -> Self {
        EngineError::Definition(errors)
    }
}

impl Engine {
    /// The mechanism of a definition, as `mechanism! { … }` takes it.
    ///
    /// # Errors
    /// What the compiler finds wrong with it.
    pub fn read(text: &str) -> Result<Self, EngineError> {
        read(text, &[])
    }
}

impl Engine<Derivatives> {
    /// The same with the derivatives of its equations, for linearisation, equilibria and implicit integrators.
    ///
    /// # Errors
    /// What the compiler finds wrong with it.
    pub fn read_with_derivatives(text: &str) -> Result<Self, EngineError> {
        read(text, &["tangent"])
    }
}

fn read<D: 'static>(text: &str, emit: &[&str]) -> Result<Engine<D>, EngineError>
where
    Engine<D>: Made,
{
    let source = Source::new("definition", text);
    let (tokens, errors) = source::definition(&source);
    if let Some(error) = errors.first() {
        let at = source.position(error.range.start);
        return Err(EngineError::Token(format!("{}:{}: {}", at.line, at.column, error.message)));
    }
    let definition = parse_at(tokens.stream, &|_| None::<PathBuf>)?;
    Engine::of(&compile_with(&definition, None, emit)?)
}

/// Engines with and without derivatives.
pub trait Made {
    /// Whether this kind of engine can be made of what is compiled.
    fn admits(compiled: &Compiled) -> bool;
}

impl Made for Engine {
    fn admits(_: &Compiled) -> bool {
        true
    }
}

impl Made for Engine<Derivatives> {
    fn admits(compiled: &Compiled) -> bool {
        compiled.complete.tangents.is_some()
    }
}

impl<D: 'static> Engine<D>
where
    Engine<D>: Made,
{
    /// The mechanism of what the compiler made, with its default parameters.
    ///
    /// # Errors
    /// [`TooLarge`](EngineError::TooLarge), [`NoDerivatives`](EngineError::NoDerivatives).
    pub fn of(compiled: &Compiled) -> Result<Self, EngineError> {
        Self::made(compiled, None)
    }

    /// The same with functions that this translator makes machine code of, each when it is first called.
    ///
    /// # Errors
    /// As [`of`](Engine::of).
    pub fn translated(compiled: &Compiled, translator: Arc<dyn Translator>) -> Result<Self, EngineError> {
        Self::made(compiled, Some(&translator))
    }

    fn made(compiled: &Compiled, translator: Option<&Arc<dyn Translator>>) -> Result<Self, EngineError> {
        if !Self::admits(compiled) {
            return Err(EngineError::NoDerivatives);
        }
        let programs = &compiled.programs;
        let length = |argument: Argument| match argument {
            // Its entries are those of q, v and z.
            Argument::State => 0,
            _ => compiled.entries(argument.given().shape),
        };
        let places = Places::new(length, programs.functions.iter().map(|(_, program)| program))?;
        let code = Function::ALL.iter().map(|function| {
            let program = programs.get(*function);
            let code = Code::new(program, &places)?;
            match translator {
                // What is not there needs no translation.
                Some(translator) if !program.outputs.is_empty() => {
                    code.translated_by(translator, program, &places)
                }
                _ => Ok(code),
            }
        });
        let code = code.collect::<Result<Vec<Code>, TooLarge>>()?;
        let tables = Tables::of(compiled);
        let (parameters, phases) = (Numbers::of(&tables.defaults), List::of(&tables.phases));
        let registers = RefCell::new(Registers::new(&places));
        let shared = Arc::new(Shared { places, code, tables });
        let engine = Engine { shared, parameters, phases, registers, derivatives: PhantomData };
        engine.constants();
        Ok(engine)
    }
}

impl<D: 'static> Engine<D> {
    /// The mechanism with these parameters, in the order of their declaration, SI units.
    ///
    /// # Errors
    /// A parameter that is not finite or out of its bounds, or a mass that is not positive; more or fewer values than there are parameters.
    pub fn prepared(&self, parameters: &[f64]) -> Result<Self, SettingError> {
        let Tables { defaults, bounds, masses, phases, open, parameters: known, .. } = &self.shared.tables;
        if parameters.len() != defaults.len() {
            let must_be = names::name(&format!("{}, one for each parameter", defaults.len()));
            return Err(SettingError {
                what: "the number of values",
                value: parameters.len() as f64,
                must_be,
            });
        }
        for ((what, bounds), &value) in known.iter().zip(bounds).zip(parameters) {
            if !value.is_finite() {
                return Err(SettingError { what, value, must_be: "finite" });
            }
            if let Some((least, most)) = *bounds
                && !(least..=most).contains(&value)
            {
                let must_be = format!("from {least:?} to {most:?} in SI units, by its declaration");
                return Err(SettingError { what, value, must_be: names::name(&must_be) });
            }
        }
        let phases = List::of(phases);
        let mut engine = Engine { parameters: Numbers::of(parameters), phases, ..self.clone() };
        let mut found = engine.constants();
        if !open.is_empty() {
            // Open phases belong to the start position; these parameters may ask for others there.
            let q = engine.start_q();
            engine.fix_phases(&q);
            found = engine.constants();
        }
        let values = engine.evaluate(Function::Masses, &[]);
        for ((what, positive, of_parameters), &value) in masses.iter().zip(values.as_slice()) {
            let fits = value.is_finite() && if *positive { value > 0.0 } else { value >= 0.0 };
            if *of_parameters && !fits {
                let must_be = if *positive { "positive" } else { "zero or positive" };
                return Err(SettingError { what, value, must_be });
            }
        }
        match found.as_slice().iter().find(|constant| !constant.is_finite()) {
            None => Ok(engine),
            Some(constant) => Err(SettingError {
                what: "the parameters together",
                value: *constant,
                must_be: "such that every length, mass and stiffness that follows from them is finite",
            }),
        }
    }

    /// The parameters it was prepared with, in the order of their declaration, SI units.
    pub fn parameters(&self) -> &[f64] {
        self.parameters.as_slice()
    }

    /// The phases of gears and racks that take them from the start.
    pub fn phases(&self) -> &[f64] {
        self.phases.as_slice()
    }

    /// Those of the definition.
    pub fn default_parameters(&self) -> &[f64] {
        &self.shared.tables.defaults
    }

    /// All inputs zero.
    pub fn no_inputs(&self) -> Numbers {
        Numbers(List::zeros(self.shared.tables.inputs.len()))
    }

    /// Computes what follows from parameters and phases alone, and keeps it in its registers; `prepare` of a compiled mechanism.
    fn constants(&self) -> List {
        let given =
            [(Argument::Parameters, self.parameters.as_slice()), (Argument::Phases, self.phases.as_slice())];
        let constants = self.evaluate(Function::Prepare, &given);
        self.registers.borrow_mut().set(self.shared.places.of(Argument::Constants), constants.as_slice());
        constants
    }

    /// All results of a function, in the order of its program's outputs.
    fn evaluate(&self, function: Function, given: &[(Argument, &[f64])]) -> List {
        let mut results = List::zeros(self.shared.code[function as usize].outputs());
        self.call(function, given, &mut [results.as_mut_slice()]);
        results
    }

    /// Writes the results of a function one after another to these lists; returns the one behind them, zero if there is none.
    fn call(&self, function: Function, given: &[(Argument, &[f64])], out: &mut [&mut [f64]]) -> f64 {
        let given = given.iter();
        let call = given.fold(self.arguments(), |call, (argument, values)| call.with(*argument, values));
        call.results(function, out)
    }

    /// A function, to be called with arguments that are still to be given.
    #[inline]
    fn arguments(&self) -> Call<'_> {
        Call { shared: &self.shared, registers: self.registers.borrow_mut() }
    }
}

/// A function that is about to be called: one argument after another is given to it. What is not given is what it was before.
struct Call<'e> {
    shared: &'e Shared,
    registers: RefMut<'e, Registers>,
}

impl Call<'_> {
    /// The entries of an argument.
    #[inline(always)]
    fn with(mut self, argument: Argument, values: &[f64]) -> Self {
        self.registers.set(self.shared.places.of(argument), values);
        self
    }

    /// Writes the results one after another to these lists; returns the one behind them, zero if there is none.
    #[inline(always)]
    fn results(mut self, function: Function, out: &mut [&mut [f64]]) -> f64 {
        let Shared { places, code, .. } = self.shared;
        let code = &code[function as usize];
        code.run(&mut self.registers, places).write(&self.registers, code.outputs(), out)
    }
}

impl<D> Clone for Engine<D> {
    fn clone(&self) -> Self {
        Engine {
            shared: self.shared.clone(),
            parameters: self.parameters.clone(),
            phases: self.phases.clone(),
            registers: self.registers.clone(),
            derivatives: PhantomData,
        }
    }
}

impl<D> fmt::Debug for Engine<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.shared.tables.name;
        f.debug_struct("Engine").field("name", &name).field("parameters", &self.parameters).finish()
    }
}
