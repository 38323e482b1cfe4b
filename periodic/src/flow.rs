//! One period of a mechanism: its motion by steps, with their exact derivatives, from switch to switch.
//!
//! A step is the classical one of Runge and Kutta. Its derivative follows the same stages in the coordinates x = (s, ṡ, z), in which small motions obey
//! δẋ = A(t) δx with A of [`Linearisation::state_space`]. Where the law switches is `crossing.rs`.

use crate::coordinates::{difference, numbers, seen, size};
use crate::cycle::{Cycle, output};
use crate::error::PeriodicError;
use linkwright::{
    AssembleExt, Derivative, DerivativeOf, Dynamics, Fields, FixedStep, Linearisation, Rk4, StateOf, Tangent,
    Vector,
};
use nalgebra::{DMatrix, DVector};

/// Halvings of a step in which an output may touch its level.
const HALVINGS: u32 = 6;

/// How much of a step's own change an output may be from its level at its turning point, and the step is halved.
const NEAR: f64 = 0.3;

/// What became of a state after one period.
pub(crate) struct Flow<M: Tangent<f64>> {
    pub end: StateOf<M>,
    /// φ(x).
    pub x: DVector<f64>,
    /// ∂φ/∂x, where it was asked for.
    pub derivative: Option<DMatrix<f64>>,
    /// How far each number of x went from its value at the beginning, but for what it goes on by evenly.
    pub swing: DVector<f64>,
    pub switchings: Vec<Switching>,
}

/// The law switched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switching {
    /// s from the beginning of the cycle.
    pub time: f64,
    /// The output that passed its level.
    pub output: &'static str,
    /// That level, SI.
    pub level: f64,
    /// Whether it was passed upwards.
    pub rising: bool,
}

/// A state at a time.
pub(crate) struct At<M: Tangent<f64>> {
    pub time: f64,
    pub state: StateOf<M>,
}

impl<M: Tangent<f64>> Clone for At<M> {
    fn clone(&self) -> Self {
        At { time: self.time, state: self.state.clone() }
    }
}

/// A mechanism on its way through a period.
pub(crate) struct Path<'a, M: Tangent<f64>> {
    pub cycle: &'a Cycle<'a, M>,
    pub model: &'a M,
    pub value: f64,
    pub period: f64,
    /// For each switch its output.
    outputs: Vec<usize>,
    pub derivative: Option<DMatrix<f64>>,
    pub switchings: Vec<Switching>,
    /// What sees each step without a switch within: its beginning, middle and end.
    observer: Option<&'a mut Observer<'a, M>>,
}

/// See [`Path::observer`].
pub(crate) type Observer<'a, M> = dyn FnMut([&At<M>; 3]) + 'a;

/// A period from a state at time zero. `derivative` asks for ∂φ/∂x.
pub(crate) fn flow<M: Tangent<f64>>(
    cycle: &Cycle<'_, M>,
    model: &M,
    value: f64,
    from: &StateOf<M>,
    derivative: bool,
) -> Result<Flow<M>, PeriodicError> {
    let period = cycle.period(value)?;
    let mut path = Path::new(cycle, model, value, period)?;
    path.derivative = derivative.then(|| DMatrix::identity(size(model), size(model)));
    path.run(0.0, from)
}

/// The period after the first one, without derivatives.
pub(crate) fn second<M: Tangent<f64>>(
    cycle: &Cycle<'_, M>,
    model: &M,
    value: f64,
    from: &StateOf<M>,
) -> Result<Flow<M>, PeriodicError> {
    let period = cycle.period(value)?;
    Path::new(cycle, model, value, period)?.run(period, from)
}

/// The same without derivatives, seen.
pub(crate) fn observe<'a, M: Tangent<f64>>(
    cycle: &'a Cycle<'a, M>,
    model: &'a M,
    value: f64,
    from: &StateOf<M>,
    observer: &'a mut Observer<'a, M>,
) -> Result<Flow<M>, PeriodicError> {
    let mut path = Path::new(cycle, model, value, cycle.period(value)?)?;
    path.observer = Some(observer);
    path.run(0.0, from)
}

impl<'a, M: Tangent<f64>> Path<'a, M> {
    fn new(cycle: &'a Cycle<'_, M>, model: &'a M, value: f64, period: f64) -> Result<Self, PeriodicError> {
        let outputs =
            cycle.switches.iter().map(|switch| output(model, switch.output)).collect::<Result<_, _>>()?;
        Ok(Path {
            cycle,
            model,
            value,
            period,
            outputs,
            derivative: None,
            switchings: Vec::new(),
            observer: None,
        })
    }

    fn run(mut self, begins: f64, from: &StateOf<M>) -> Result<Flow<M>, PeriodicError> {
        let (steps, model) = (self.cycle.steps, self.model);
        let begin = numbers(model, begins, from);
        let mut swing = DVector::zeros(begin.len());
        let mut here = At { time: begins, state: from.clone() };
        let mut x = begin.clone();
        for step in 1..=steps {
            let end = begins + self.period * step as f64 / steps as f64;
            here = self.advance(here, end, 0)?;
            x = numbers(model, here.time, &here.state);
            let moved = difference(self.cycle, model, [&x, &begin], step as f64 / steps as f64);
            swing.zip_apply(&moved, |swing: &mut f64, moved| *swing = swing.max(moved.abs()));
        }
        Ok(Flow { end: here.state, x, derivative: self.derivative, swing, switchings: self.switchings })
    }

    /// From here to a time, by one step or, where the law switches or might, by more.
    pub(crate) fn advance(&mut self, here: At<M>, end: f64, halvings: u32) -> Result<At<M>, PeriodicError> {
        let h = end - here.time;
        let step = self.step(&here, h, self.derivative.is_some())?;
        let sides = [self.gaps(&here), self.gaps(&step.end)];
        if (sides[0].iter().zip(&sides[1])).any(|(&before, &after)| side(before) != side(after)) {
            let beyond = self.cross(here, h)?;
            // What is left of the step may be nothing.
            return if end - beyond.time > 1e-12 * self.period {
                self.advance(beyond, end, halvings)
            } else {
                Ok(beyond)
            };
        }
        if halvings < HALVINGS && !self.outputs.is_empty() {
            let middle = self.gaps(&self.step(&here, 0.5 * h, false)?.end);
            let touches = |at: usize| touches(sides[0][at], middle[at], sides[1][at]);
            if (0..middle.len()).any(touches) {
                let half = self.advance(here.clone(), here.time + 0.5 * h, halvings + 1)?;
                return self.advance(half, end, halvings + 1);
            }
        }
        self.accept(&here, step)
    }

    /// Goes on by a step that was tried.
    pub(crate) fn accept(&mut self, here: &At<M>, step: Tried<M>) -> Result<At<M>, PeriodicError> {
        if let (Some(derivative), Some(along)) = (&mut self.derivative, &step.along) {
            *derivative = along * &*derivative;
        }
        if self.observer.is_some() {
            let middle = self.step(here, 0.5 * (step.end.time - here.time), false)?.end;
            if let Some(observer) = &mut self.observer {
                observer([here, &middle, &step.end]);
            }
        }
        Ok(step.end)
    }

    /// A step of any size, negative ones too, and its derivative if it is asked for.
    pub(crate) fn step(&self, here: &At<M>, h: f64, derivative: bool) -> Result<Tried<M>, PeriodicError> {
        let mut stages = Stages { path: self, derivative, matrices: Vec::new(), error: None };
        let stepped = Rk4.take(&mut stages, here.time, h, &here.state);
        let Stages { matrices, error, .. } = stages;
        if let Some(error) = error {
            return Err(error);
        }
        let time = here.time + h;
        let Ok(mut state) = stepped else {
            let what = self.model.name();
            return Err(PeriodicError::Linearisation(linkwright::LinearisationError::NonFinite {
                time,
                what,
            }));
        };
        if self.model.row_count() > 0 {
            state = self.model.project(time, &state).map_err(PeriodicError::Assembly)?;
        }
        let along = derivative.then(|| chain(&matrices, h));
        Ok(Tried { end: At { time, state }, along })
    }

    /// The equations here.
    pub(crate) fn linearised(&self, here: &At<M>) -> Result<Linearisation<'a, f64, M>, PeriodicError> {
        let inputs = self.cycle.inputs_at(self.value, here.time);
        Linearisation::at(self.model, here.time, &here.state, &inputs).map_err(PeriodicError::Linearisation)
    }

    /// For each switch how far its output is above its level.
    pub(crate) fn gaps(&self, here: &At<M>) -> Vec<f64> {
        if self.outputs.is_empty() {
            return Vec::new();
        }
        let inputs = self.cycle.inputs_at(self.value, here.time);
        let outputs = self.model.outputs(here.time, &here.state, &inputs).to_array();
        let value =
            |(&output, switch): (&usize, &crate::cycle::Switch)| outputs.as_slice()[output] - switch.level;
        self.outputs.iter().zip(&self.cycle.switches).map(value).collect()
    }

    /// The output of a switch.
    pub(crate) fn output(&self, switch: usize) -> usize {
        self.outputs[switch]
    }

    /// (s̈, ż) here, as differences of accelerations from `base` and as rates.
    pub(crate) fn rates(&self, here: &At<M>, base: &M::V) -> Result<(M::V, DVector<f64>), PeriodicError> {
        let at = self.linearised(here)?;
        let mut z = self.model.zero_z();
        let inputs = self.cycle.inputs_at(self.value, here.time);
        let a = at.acceleration().clone();
        self.model.internal_rates(here.time, &here.state, &inputs, &a, at.multipliers(), &mut z);
        let delta = a.plus(-1.0, base);
        let mut rates = vec![0.0; self.model.states().len()];
        rates.extend(seen(self.model, here.time, &here.state.q, &delta));
        rates.extend_from_slice(z.as_slice());
        Ok((a, DVector::from_vec(rates)))
    }
}

/// Which side of its level a switch is on; at the level itself it has not passed.
pub(crate) fn side(gap: f64) -> bool {
    gap > 0.0
}

/// Whether an output that is on the same side at the beginning, the middle and the end of a step comes near its level between: by the parabola through
/// the three.
fn touches(begin: f64, middle: f64, end: f64) -> bool {
    let (slope, bend) = (0.5 * (end - begin), begin - 2.0 * middle + end);
    if side(middle) != side(begin) {
        return true;
    }
    // The turning point lies within where the slope changes its sign.
    if slope.abs() >= bend.abs() || bend == 0.0 {
        return false;
    }
    let turning = middle - 0.5 * slope * slope / bend;
    side(turning) != side(begin) || turning.abs() < NEAR * bend.abs()
}

/// A step that was tried.
pub(crate) struct Tried<M: Tangent<f64>> {
    pub end: At<M>,
    along: Option<DMatrix<f64>>,
}

/// The derivative of a step with A at its four stages.
fn chain(matrices: &[DMatrix<f64>], h: f64) -> DMatrix<f64> {
    let [first, second, third, fourth] = matrices else {
        unreachable!("the classical method has four stages");
    };
    let unit = DMatrix::identity(first.nrows(), first.ncols());
    let k1 = first.clone();
    let k2 = second * (&unit + &k1 * (0.5 * h));
    let k3 = third * (&unit + &k2 * (0.5 * h));
    let k4 = fourth * (&unit + &k3 * h);
    unit + (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (h / 6.0)
}

/// The mechanism as the integrator sees it.
struct Stages<'p, 'a, M: Tangent<f64>> {
    path: &'p Path<'a, M>,
    derivative: bool,
    /// A at each stage.
    matrices: Vec<DMatrix<f64>>,
    /// The first.
    error: Option<PeriodicError>,
}

impl<M: Tangent<f64>> Stages<'_, '_, M> {
    fn stage(&mut self, here: &At<M>) -> Result<DerivativeOf<M>, PeriodicError> {
        let (model, mut z) = (self.path.model, self.path.model.zero_z());
        let at = self.path.linearised(here)?;
        let a = at.acceleration().clone();
        let inputs = self.path.cycle.inputs_at(self.path.value, here.time);
        model.internal_rates(here.time, &here.state, &inputs, &a, at.multipliers(), &mut z);
        if self.derivative {
            let space = at.state_space().map_err(PeriodicError::Linearisation)?;
            let size = size(model);
            self.matrices.push(DMatrix::from_row_slice(size, size, space.a.as_slice()));
        }
        Ok(Derivative { v: here.state.v.clone(), a, z })
    }
}

impl<M: Tangent<f64>> Dynamics<f64> for Stages<'_, '_, M> {
    type Variables = M;

    fn variables(&self) -> &M {
        self.path.model
    }

    fn derivative(&mut self, time: f64, state: &mut StateOf<M>) -> DerivativeOf<M> {
        let here = At { time, state: state.clone() };
        self.stage(&here).unwrap_or_else(|error| {
            self.error.get_or_insert(error);
            let model = self.path.model;
            Derivative { v: state.v.clone(), a: model.zero_v(), z: model.zero_z() }
        })
    }

    fn broke_down(&self) -> bool {
        self.error.is_some()
    }
}
