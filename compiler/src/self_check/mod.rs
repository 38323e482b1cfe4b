//! The compiler checks its own work, on the model at hand: what the programs compute at a few states against identities
//! that hold of any mechanism, and against the graph they were written from.
//!
//! | check | by |
//! |---|---|
//! | Φ | zero at the start |
//! | D v − ν | differences of Φ along v |
//! | γ | differences of D v − ν along v |
//! | M | the kinetic energy, which is a square of velocities |
//! | M v̇ − Q | powers, and differences of the energies |
//! | v̇, λ | M v̇ + Dᵀ λ − Q and D v̇ − γ, with and without Baumgarte's terms |
//! | every function | the graph |
//! | in the thorough check: springs one by one; beams slice by slice; motions of bodies; K(c), independent velocities; derivatives | differences and residuals |
//! | what rows are measured by | D M⁻¹ Dᵀ along the motion |
//!
//! What no identity speaks of is seen by the last line before this alone: reactions, outputs, conditions of the start, the watch
//! over pivots. And a mechanism that is derived right, but is another than the definition says, is none of these checks' business: that is
//! what the independent derivation of `tests/reference` is for.
//!
//! No model that is right is refused: every number carries the bound of its rounding, differences the doubt about their own
//! error, and nothing is claimed where there is no value or no derivative. A contradiction is a mistake of this crate; the message
//! says so and what to report. There is no model then, rather than a wrong one.
//!
//! AFTER THIS POINT the programs are what was derived, as far as that can be seen at a few states.

mod beams;
mod beyond;
mod dynamics;
mod friction;
mod machine;
mod programs;
mod quantity;
mod rows;
mod scales;

use crate::compiled::Compiled;
use crate::messages;
use crate::schedule::Inputs;
use machine::Machine;
pub use machine::{Random, state};
use quantity::Quantity;
use std::fmt;

/// How much is checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    Off,
    /// Identities of the equations and of their solution at one state: part of every expansion.
    Passing,
    /// Everything, at several states and with other parameters: `self_check = on`, or the environment's
    /// `LINKWRIGHT_SELF_CHECK=1`.
    Thorough,
}

/// States of the thorough check.
const STATES: usize = 4;

impl Extent {
    /// As the definition says; else as the environment of the build says, for continuous integration.
    pub fn asked(written: Option<bool>) -> Extent {
        match written {
            Some(true) => Extent::Thorough,
            Some(false) => Extent::Off,
            None => match std::env::var(VARIABLE).as_deref() {
                Ok("1" | "on") => Extent::Thorough,
                Ok("0" | "off") => Extent::Off,
                _ => Extent::Passing,
            },
        }
    }
}

/// What makes the check thorough for all mechanisms of a build.
pub const VARIABLE: &str = "LINKWRIGHT_SELF_CHECK";

/// Two ways to one number that differ.
#[derive(Clone, Debug)]
pub struct Contradiction {
    /// Which check.
    pub check: Check,
    /// The row, coordinate or result, by name.
    pub at: String,
    /// What was computed, what it must be, and by how much they may differ.
    pub found: f64,
    pub expected: f64,
    pub margin: f64,
    /// The state, as numbers to be reported.
    pub state: String,
}

impl fmt::Display for Contradiction {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Contradiction { check, at, found, expected, margin, state } = self;
        f.write_str(&messages::contradiction(check.text(), at, [*found, *expected, *margin], state))
    }
}

/// The checks, in the order in which they run: a later one uses what an earlier one has seen to be right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Check {
    Start,
    Jacobian,
    Gamma,
    MassMatrix,
    InverseDynamics,
    Energy,
    Friction,
    Springs,
    Beams,
    Solution,
    Baumgarte,
    Motions,
    Factorisation,
    NullSpace,
    Tangent,
    Scales,
    Programs,
}

impl Check {
    /// What is compared with what.
    pub fn text(self) -> &'static str {
        match self {
            Check::Start => "the constraints with zero at the assembled start",
            Check::Jacobian => "D against differences of the constraints",
            Check::Gamma => "γ against differences of D v",
            Check::MassMatrix => "the mass matrix against the kinetic energy",
            Check::InverseDynamics => "inverse dynamics against the mass matrix and the forces",
            Check::Energy => "the balance of energies and powers",
            Check::Friction => "the power of friction with what takes energy out",
            Check::Springs => "the power of a spring against what it stores",
            Check::Beams => "bodies that deform against their slices and Lagrange's equations",
            Check::Solution => "accelerations and multipliers put into the equations",
            Check::Baumgarte => "stabilised accelerations and multipliers put into the equations",
            Check::Motions => "motions of the bodies against differences of each other",
            Check::Factorisation => "the factorisation put into its equations",
            Check::NullSpace => "independent velocities against the default accelerations",
            Check::Tangent => "derivatives against differences",
            Check::Scales => "what the constraints are measured by against their size along the motion",
            Check::Programs => "the code against the expressions it was written from",
        }
    }
}

/// What the checks have found at one state.
struct Report<'a> {
    inputs: &'a Inputs,
    found: Vec<Contradiction>,
}

impl Report<'_> {
    fn compare(&mut self, check: Check, at: impl FnOnce() -> String, found: Quantity, expected: Quantity) {
        if found.contradicts(expected) {
            self.found.push(Contradiction {
                check,
                at: at(),
                found: found.value,
                expected: expected.value,
                margin: found.margin + expected.margin,
                state: describe(self.inputs),
            });
        }
    }
}

/// The contradictions within a compiled model.
pub fn self_check(compiled: &Compiled, extent: Extent) -> Vec<Contradiction> {
    let states = match extent {
        Extent::Off => 0,
        Extent::Passing => 1,
        Extent::Thorough => STATES,
    };
    if states > 0 {
        let mut inputs = machine::start(compiled);
        let machine = Machine::new(compiled, &mut inputs);
        let mut report = Report { inputs: &inputs, found: Vec::new() };
        rows::at_the_start(&machine, &mut report);
        if extent == Extent::Thorough {
            scales::check(&machine, &mut report);
        }
        if !report.found.is_empty() {
            return report.found;
        }
    }
    let mut random = Random::new(1);
    for number in 0..states {
        let mut inputs = machine::state(compiled, &mut random, number > 0);
        let machine = Machine::new(compiled, &mut inputs);
        let mut report = Report { inputs: &inputs, found: Vec::new() };
        rows::check(&machine, &mut report);
        dynamics::check(&machine, &mut report);
        if extent == Extent::Thorough {
            beyond::check(&machine, &mut report);
        }
        programs::check(&machine, &mut report);
        // The first state that shows something is the simplest case: its parameters are the defaults.
        if !report.found.is_empty() {
            return report.found;
        }
    }
    Vec::new()
}

/// The state in as few numbers as reproduce it.
fn describe(inputs: &Inputs) -> String {
    let list = |name: &str, values: &[f64]| {
        let shown: Vec<String> = values.iter().take(MOST).map(|value| format!("{value:?}")).collect();
        let more = if values.len() > MOST { ", …" } else { "" };
        format!("{name} = [{}{more}]", shown.join(", "))
    };
    let mut parts = vec![format!("time = {:?}", inputs.time), list("q", &inputs.q), list("v", &inputs.v)];
    if !inputs.parameters.is_empty() {
        parts.push(list("parameters", &inputs.parameters));
    }
    parts.join(", ")
}

/// Numbers of a list that a message shows.
const MOST: usize = 16;
