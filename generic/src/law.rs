//! An expression with what it names: quantities of positions, and rates. Its value, its course along the motion, and its gradient.

use crate::energy::{Energies, Energy};
use crate::expression::{Expression, Scope};
use crate::kinematics::Kinematics;
use crate::load::Load;
use crate::number::{Number, Slope, Taylor};
use crate::quantity::{Jet, Pull, Quantity};
use crate::rubbing::Sliding;
use crate::vector::turned_back;
use std::sync::Arc;

#[derive(Clone, Debug)]
pub(crate) struct Law {
    pub expression: Expression,
    pub quantities: Vec<Quantity>,
    pub rates: Vec<Rate>,
}

/// What changes with velocities.
#[derive(Clone, Debug)]
pub(crate) enum Rate {
    /// d/dt of an expression of the law's quantities and time.
    Of(Expression),
    /// A component of ω in the body's own axes.
    Spin {
        body: usize,
        axis: usize,
    },
    /// The power of a load, W.
    Power(Box<Load>),
    /// Of one of the deflections of a friction that remembers.
    Bending(Box<Load>, usize),
    /// What a row exerts along its quantity, −λ.
    Effort(usize),
    Energy(Arc<Energies>, Energy),
    /// How surfaces slide, m/s.
    Sliding(Box<Sliding>),
}

/// What laws write while they are evaluated, kept from call to call.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    jets: Vec<Jet>,
    taylor: Vec<Taylor>,
    values: Vec<f64>,
    slopes: Vec<Slope>,
    rates: Vec<f64>,
    /// For laws within laws.
    inner: Option<Box<Scratch>>,
}

impl Law {
    pub fn constant(value: f64) -> Self {
        Law { expression: Expression::Number(value), quantities: Vec::new(), rates: Vec::new() }
    }

    /// At one state.
    pub fn value(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> f64 {
        scratch.taylor.clear();
        scratch.taylor.extend(self.quantities.iter().map(|quantity| quantity.jet(at).along));
        scratch.values.clear();
        scratch.values.extend(scratch.taylor.iter().map(|along| along.value));
        scratch.rates.clear();
        for rate in &self.rates {
            let rate = match rate {
                Rate::Of(expression) => {
                    let scope = Scope {
                        time: at.now(),
                        inputs: &[],
                        states: &[],
                        quantities: &scratch.taylor[..],
                        rates: &[],
                    };
                    expression.evaluate(&scope).rate
                }
                Rate::Power(load) => {
                    let mut inner = scratch.inner.take().unwrap_or_default();
                    let power = load.power(at, inputs, &mut inner);
                    scratch.inner = Some(inner);
                    power
                }
                Rate::Bending(load, which) => {
                    let mut inner = scratch.inner.take().unwrap_or_default();
                    let rates = load.bending(at, inputs, &mut inner);
                    scratch.inner = Some(inner);
                    rates[*which]
                }
                Rate::Sliding(sliding) => {
                    let mut inner = scratch.inner.take().unwrap_or_default();
                    let rate = sliding.rate(at, &mut inner);
                    scratch.inner = Some(inner);
                    rate
                }
                Rate::Effort(row) => -at.multipliers[*row],
                Rate::Energy(of, which) => of.of(*which, at),
                Rate::Spin { body, axis } => {
                    let frame = &at.frames[*body];
                    turned_back(&frame.axes, frame.spin)[*axis]
                }
            };
            scratch.rates.push(rate);
        }
        let scope = Scope {
            time: at.time,
            inputs,
            states: &at.internal,
            quantities: &scratch.values[..],
            rates: &scratch.rates,
        };
        self.expression.evaluate(&scope)
    }

    /// Of a law of positions and time: f, ḟ, the bias of f̈.
    pub fn course(&self, at: &Kinematics, scratch: &mut Scratch) -> Taylor {
        scratch.taylor.clear();
        scratch.taylor.extend(self.quantities.iter().map(|quantity| quantity.jet(at).along));
        let scope =
            Scope { time: at.now(), inputs: &[], states: &[], quantities: &scratch.taylor[..], rates: &[] };
        self.expression.evaluate(&scope)
    }

    /// Of a law of positions and time: the same, and ∂f/∂f_i times the gradient of each of its quantities f_i.
    pub fn jet(&self, at: &Kinematics, scratch: &mut Scratch, mut add: impl FnMut(Pull)) -> Taylor {
        scratch.jets.clear();
        scratch.jets.extend(self.quantities.iter().map(|quantity| quantity.jet(at)));
        scratch.taylor.clear();
        scratch.taylor.extend(scratch.jets.iter().map(|jet| jet.along));
        scratch.slopes.clear();
        scratch.slopes.extend(scratch.taylor.iter().map(|along| Slope::constant(along.value)));
        for (k, jet) in scratch.jets.iter().enumerate() {
            scratch.slopes[k].slope = 1.0;
            let time = Slope::constant(at.time);
            let scope = Scope { time, inputs: &[], states: &[], quantities: &scratch.slopes[..], rates: &[] };
            let slope = self.expression.evaluate(&scope).slope;
            scratch.slopes[k].slope = 0.0;
            for pull in jet.pulls {
                add(pull.scaled(slope));
            }
        }
        let scope =
            Scope { time: at.now(), inputs: &[], states: &[], quantities: &scratch.taylor[..], rates: &[] };
        self.expression.evaluate(&scope)
    }

    pub fn bodies(&self) -> impl Iterator<Item = usize> + '_ {
        self.quantities.iter().flat_map(|quantity| quantity.bodies()).flatten()
    }
}
