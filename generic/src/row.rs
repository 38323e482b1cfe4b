//! Constraint rows: Φ = 0 with Φ̇ and the bias of Φ̈, and their entries of D.

use crate::kinematics::{Kinematics, Place};
use crate::law::{Law, Scratch};
use crate::number::{Number, Taylor};
use crate::quantity::{Pull, Quantity, half_square};

/// A row with its name.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// The joint, constraint or driver.
    pub of: String,
    /// Which of its equations, as NOTATION.md has them.
    pub what: &'static str,
    pub equation: Equation,
}

#[derive(Clone, Debug)]
pub(crate) enum Equation {
    /// f = 0.
    Zero(Quantity),
    /// (Δ·Δ − L²)/2 = 0 with the length L of time.
    Distance { first: Place, second: Place, length: Law },
    /// Σ factor · f = phase.
    Sum { terms: Vec<(f64, Quantity)>, phase: Phase },
    /// f = 0 of an expression of positions and time.
    Law(Law),
}

/// What a sum is equal to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Phase {
    Given(f64),
    /// What the start gives; none is known yet.
    Open,
    /// What the start gave.
    Kept(f64),
}

impl Row {
    pub fn name(&self) -> String {
        format!("{}.{}", self.of, self.what)
    }

    /// The bodies whose velocities it has entries for.
    pub fn bodies(&self) -> Vec<usize> {
        let mut bodies: Vec<usize> = match &self.equation {
            Equation::Zero(quantity) => quantity.bodies().into_iter().flatten().collect(),
            Equation::Distance { first, second, .. } => {
                [first.body, second.body].into_iter().flatten().collect()
            }
            Equation::Sum { terms, .. } => terms.iter().flat_map(|(_, f)| f.bodies()).flatten().collect(),
            Equation::Law(law) => law.bodies().collect(),
        };
        bodies.sort_unstable();
        bodies.dedup();
        bodies
    }

    /// Φ, Φ̇ and the bias of Φ̈; its gradient goes to `add`.
    pub fn evaluate(&self, at: &Kinematics, scratch: &mut Scratch, mut add: impl FnMut(Pull)) -> Taylor {
        match &self.equation {
            Equation::Zero(quantity) => {
                let jet = quantity.jet(at);
                jet.pulls.into_iter().for_each(&mut add);
                jet.along
            }
            // Φ̇ = Δ·Δ̇ − L L̇, Φ̈ = Δ̇·Δ̇ + Δ·Δ̈ − L̇² − L L̈.
            Equation::Distance { first, second, length } => {
                let jet = half_square(at, first, second);
                jet.pulls.into_iter().for_each(&mut add);
                let length = length.course(at, scratch);
                jet.along.minus(length.times(length).scaled(0.5))
            }
            Equation::Sum { terms, phase } => {
                let phase = match phase {
                    Phase::Given(phase) | Phase::Kept(phase) => *phase,
                    Phase::Open => 0.0,
                };
                let mut sum = Taylor::constant(-phase);
                for (factor, quantity) in terms {
                    let jet = quantity.jet(at);
                    for pull in jet.pulls {
                        add(pull.scaled(*factor));
                    }
                    sum = sum.plus(jet.along.scaled(*factor));
                }
                sum
            }
            Equation::Law(law) => law.jet(at, scratch, add),
        }
    }
}
