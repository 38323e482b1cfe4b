//! What functions in C that `options { export_c = …; }` emits do with a mechanism: a [`Stepper`] for the length of a call, put together from
//! plain parts that have the layout of the C header, and taken apart again. The shims around these functions turn pointers into references;
//! nothing here knows a pointer.

use crate::error::StepError;
use crate::fields::{Fields, Parametric};
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::{State, StateOf};
use crate::stepper::{StepMethod, Stepper, Tick};

/// The status of what went well.
pub const OK: i32 = 0;
/// Other than those of [`StepError`]: a parameter, an assembly, a null pointer.
pub const PARAMETER: i32 = 8;
/// See [`PARAMETER`].
pub const ASSEMBLY: i32 = 9;
/// See [`PARAMETER`].
pub const NULL: i32 = 10;

/// The plant of the header: model, clock, state, and what is last where the mechanism has that. `E` keeps a model without entries from
/// being no struct in C.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Plant<M, S, R, L, E> {
    /// The prepared model.
    pub model: M,
    /// A number where that has no entries.
    pub empty: E,
    /// The clock, s.
    pub time: [R; 3],
    /// The present state.
    pub state: S,
    /// The outputs last read.
    pub last: L,
}

/// The outputs last read, and whether there are some.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Last<O> {
    /// They.
    pub outputs: O,
    /// One where there are some.
    pub seen: u32,
}

/// A saved state of the header.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct SavedInC<S, R> {
    /// Of the definition.
    pub fingerprint: u64,
    /// Of the format.
    pub version: u32,
    /// Of this struct, bytes.
    pub size: u32,
    /// The clock, s.
    pub time: [R; 3],
    /// The state.
    pub state: S,
}

/// The version of the format.
const VERSION: u32 = 1;

type PlantOf<M, R, L, E> = Plant<M, StateOf<M, R>, R, L, E>;

/// What forgets the outputs last read.
pub trait Forget {
    /// A beginning.
    fn forget(&mut self);
}

impl Forget for () {
    fn forget(&mut self) {}
}

impl<O> Forget for Last<O> {
    fn forget(&mut self) {
        self.seen = 0;
    }
}

fn stepper<M, R, L, E, S>(plant: &PlantOf<M, R, L, E>, method: S) -> Result<Stepper<M, S, R>, StepError>
where
    R: Real,
    M: Mechanism<R> + Clone,
    S: StepMethod<R, M>,
{
    Stepper::resumed(plant.model.clone(), plant.time, plant.state.clone(), method)
}

fn keep<M, R, L, E, S>(plant: &mut PlantOf<M, R, L, E>, stepper: &Stepper<M, S, R>)
where
    R: Real,
    M: Mechanism<R> + Clone,
    S: StepMethod<R, M>,
{
    plant.time = stepper.clock().terms();
    plant.state = stepper.state().clone();
}

fn code(result: Result<(), StepError>) -> i32 {
    result.map_or_else(|error| i32::from(error.code()), |()| OK)
}

/// A model with other parameters; as it is made by default where none are given.
pub fn model<M: Parametric<R> + Default, R: Real>(parameters: Option<&M::Parameters>) -> Result<M, i32> {
    match parameters {
        None => Ok(M::default()),
        Some(parameters) => M::prepare(parameters.clone()).map_err(|_| PARAMETER),
    }
}

/// A plant at the start and time zero.
pub fn init<M, R, L, E>(model: M, last: L, empty: E) -> PlantOf<M, R, L, E>
where
    R: Real,
    M: Assemble<R>,
{
    let state = State {
        q: model.start_q(),
        v: model.start_v(),
        z: model.start_internal(),
        gates: model.start_gates(),
    };
    Plant { model, empty, time: [R::ZERO; 3], state, last }
}

/// Goes on with other parameters.
pub fn set_parameters<M, R, L, E>(plant: &mut PlantOf<M, R, L, E>, parameters: &M::Parameters) -> i32
where
    R: Real,
    M: Assemble<R> + Parametric<R>,
{
    let Ok(mut model) = M::prepare(parameters.clone()) else { return PARAMETER };
    model.fix_phases(&plant.state.q);
    plant.model = model;
    OK
}

/// What is wrong with parameters, by name.
pub fn wrong_parameter<M: Parametric<R>, R: Real>(parameters: &M::Parameters) -> Option<&'static str> {
    M::prepare(parameters.clone()).err().map(|error| error.what)
}

/// Goes on from another state.
pub fn set_state<M, R, L, E, S>(
    plant: &mut PlantOf<M, R, L, E>,
    time: R,
    state: &StateOf<M, R>,
    method: S,
) -> i32
where
    R: Real,
    M: Mechanism<R> + Clone,
    S: StepMethod<R, M>,
    L: Forget,
{
    let mut stepper = Stepper::new(plant.model.clone(), plant.state.clone(), method);
    let done = stepper.set_state(time, state.clone());
    if done.is_ok() {
        keep(plant, &stepper);
        plant.last.forget();
    }
    code(done)
}

/// A step.
#[inline]
pub fn step<M, R, L, E, S>(
    plant: &mut PlantOf<M, R, L, E>,
    inputs: &M::Inputs,
    h: R,
    method: S,
    tick: Option<&mut Tick<R>>,
) -> i32
where
    R: Real,
    M: Assemble<R, Inputs: Fields<R>> + Clone,
    S: StepMethod<R, M>,
{
    let stepped = stepper(plant, method).and_then(|mut stepper| {
        let found = stepper.step(inputs, h)?;
        keep(plant, &stepper);
        if let Some(tick) = tick {
            *tick = found;
        }
        Ok(())
    });
    code(stepped)
}

/// Brings the state to the constraints.
pub fn assemble<M, R, L, E, S>(plant: &mut PlantOf<M, R, L, E>, method: S) -> i32
where
    R: Real,
    M: Assemble<R> + Clone,
    S: StepMethod<R, M>,
{
    let Ok(mut stepper) = stepper(plant, method) else { return ASSEMBLY };
    if stepper.assemble().is_err() {
        return ASSEMBLY;
    }
    keep(plant, &stepper);
    OK
}

/// The outputs, whose angles continue those last read.
pub fn read_outputs<M, R, E>(plant: &mut PlantOf<M, R, Last<M::Outputs>, E>, inputs: &M::Inputs) -> M::Outputs
where
    R: Real,
    M: Mechanism<R>,
{
    let mut outputs = plant.model.outputs(plant.time[0], &plant.state, inputs);
    match plant.last.seen {
        0 => plant.model.unwrap_start(&mut outputs),
        _ => plant.model.unwrap(&mut outputs, &plant.last.outputs),
    }
    plant.last = Last { outputs: outputs.clone(), seen: 1 };
    outputs
}

/// What is to be kept.
pub fn save<M, R, L, E>(plant: &PlantOf<M, R, L, E>) -> SavedInC<StateOf<M, R>, R>
where
    R: Real,
    M: Mechanism<R>,
{
    let size = size_of::<SavedInC<StateOf<M, R>, R>>() as u32;
    let (fingerprint, state) = (plant.model.fingerprint(), plant.state.clone());
    SavedInC { fingerprint, version: VERSION, size, time: plant.time, state }
}

/// Goes on from what was kept, of which the caller says the size.
pub fn restore<M, R, L, E, S>(
    plant: &mut PlantOf<M, R, L, E>,
    saved: &SavedInC<StateOf<M, R>, R>,
    size: usize,
    method: S,
) -> i32
where
    R: Real,
    M: Mechanism<R> + Clone,
    S: StepMethod<R, M>,
    L: Forget,
{
    let own = size_of::<SavedInC<StateOf<M, R>, R>>();
    let fits = size == own && saved.size as usize == own;
    if !fits || saved.version != VERSION || saved.fingerprint != plant.model.fingerprint() {
        return i32::from(StepError::OtherModel.code());
    }
    let resumed = Stepper::resumed(plant.model.clone(), saved.time, saved.state.clone(), method);
    let checked = resumed.and_then(|stepper| stepper.check(&saved.state).map(|()| stepper));
    if let Ok(stepper) = &checked {
        keep(plant, stepper);
        plant.last.forget();
    }
    code(checked.map(|_| ()))
}
