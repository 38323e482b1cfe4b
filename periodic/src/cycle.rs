//! What repeats: a mechanism that depends on one number, its period, its inputs, and where its laws have kinks.
//!
//! The integration of one period is `flow.rs`, motions that repeat are `motion.rs`, curves of them `branch.rs`.

use crate::error::PeriodicError;
use linkwright::{ConditionKind, Fields, SettingError, Tangent, Vector};

/// Steps of a period where nothing else is said.
const STEPS: usize = 200;

/// A mechanism under a load of period T, as it depends on one number p: the frequency, an amplitude, or any other parameter.
///
/// ```text
/// x(0), p  ↦  x(T(p)) = φ(x(0), p)        x = (s, ṡ, z): coordinates, their rates, internal states
/// ```
/// Every cycle begins at time zero. Laws of the mechanism may name `time`; inputs are given at all times, as exactly as laws are.
pub struct Cycle<'c, M: Tangent<f64>> {
    model: Box<dyn Fn(f64) -> Result<M, SettingError> + 'c>,
    period: Box<dyn Fn(f64) -> f64 + 'c>,
    inputs: Box<dyn Fn(f64, f64) -> M::Inputs + 'c>,
    pub(crate) switches: Vec<Switch>,
    pub(crate) turns: Vec<(&'static str, f64)>,
    pub(crate) steps: usize,
}

/// The law changes where an output passes a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch {
    /// The output, by its name.
    pub output: &'static str,
    /// SI units.
    pub level: f64,
}

impl<'c, M: Tangent<f64>> Cycle<'c, M> {
    /// The mechanism at a value of p, and its period (s) there. All inputs are zero.
    pub fn new(
        model: impl Fn(f64) -> Result<M, SettingError> + 'c,
        period: impl Fn(f64) -> f64 + 'c,
    ) -> Self {
        let none = |model: usize| <M::Inputs as Fields<f64>>::Array::zeros(model);
        let count = <M::Inputs as Fields<f64>>::NAMES.len();
        Cycle {
            model: Box::new(model),
            period: Box::new(period),
            inputs: Box::new(move |_, _| M::Inputs::from_array(none(count))),
            switches: Vec::new(),
            turns: Vec::new(),
            steps: STEPS,
        }
    }

    /// The inputs at a value of p and a time from 0 on; they must repeat with the period.
    #[must_use]
    pub fn inputs(mut self, inputs: impl Fn(f64, f64) -> M::Inputs + 'c) -> Self {
        self.inputs = Box::new(inputs);
        self
    }

    /// A law has a kink or a jump where `output` passes `level` (SI units): the flank of a backlash, an end stop, a clutch that opens. No step of
    /// the integration goes across, and the derivatives are carried over the jump. Where nothing is said, steps go across kinks as they come.
    #[must_use]
    pub fn switch(mut self, output: &'static str, level: f64) -> Self {
        self.switches.push(Switch { output, level });
        self
    }

    /// A coordinate that goes on by `advance` (rad or m) in each period: the turn by a tooth of a wheel that turns.
    #[must_use]
    pub fn advancing(mut self, coordinate: &'static str, advance: f64) -> Self {
        self.turns.push((coordinate, advance));
        self
    }

    /// Steps of a period (200, at least 8), each by the classical method of Runge and Kutta; more of them near switches.
    #[must_use]
    pub fn steps(mut self, steps: usize) -> Self {
        self.steps = steps.max(8);
        self
    }

    pub(crate) fn model(&self, value: f64) -> Result<M, PeriodicError> {
        let model = (self.model)(value).map_err(PeriodicError::Setting)?;
        check(self, &model)?;
        Ok(model)
    }

    pub(crate) fn period(&self, value: f64) -> Result<f64, PeriodicError> {
        let period = (self.period)(value);
        if period > 0.0 && period.is_finite() {
            Ok(period)
        } else {
            Err(PeriodicError::Period { value, period })
        }
    }

    pub(crate) fn inputs_at(&self, value: f64, time: f64) -> M::Inputs {
        (self.inputs)(value, time)
    }
}

/// Whether what was named is there, and x is as many numbers as the motion has.
fn check<M: Tangent<f64>>(cycle: &Cycle<'_, M>, model: &M) -> Result<(), PeriodicError> {
    let conditions = || model.states().iter().map(|&state| model.conditions()[usize::from(state)]);
    if let Some(ball) = conditions().find(|condition| condition.kind == ConditionKind::Rate) {
        return Err(PeriodicError::Orientation { rate: ball.of });
    }
    if conditions().count() != model.freedoms() {
        return Err(PeriodicError::Incomplete { needed: model.freedoms(), given: conditions().count() });
    }
    if !model.start_gates().as_slice().is_empty() {
        return Err(PeriodicError::Events { mechanism: model.name() });
    }
    for switch in &cycle.switches {
        output(model, switch.output)?;
    }
    for &(coordinate, _) in &cycle.turns {
        if !conditions().any(|condition| condition.of == coordinate) {
            let given = conditions().map(|condition| condition.of).collect();
            return Err(PeriodicError::NoSuchCoordinate { name: coordinate, given });
        }
    }
    Ok(())
}

/// The index of an output.
pub(crate) fn output<M: Tangent<f64>>(model: &M, name: &'static str) -> Result<usize, PeriodicError> {
    let given = model.output_names();
    given.iter().position(|&given| given == name).ok_or(PeriodicError::NoSuchOutput { name, given })
}
