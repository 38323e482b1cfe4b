//! What follows from a state and its solution, in flat lists: motions of bodies, reactions of joints, powers. Entries have the order
//! of the fields of the runtime's structs. The trait `Report` is not implemented, because its entries are structs in the plane or in
//! space, and which of them a definition is in is known only when it is read.

use crate::{Engine, List, Numbers};
use linkwright_compiler::functions::Argument::{Acceleration, Lambda, Q, Time, V};
use linkwright_compiler::functions::Function;
use linkwright_runtime::{Mechanism, StateOf, Vector};
use std::slice::from_ref;

/// The solution at a state: what motions and reactions follow from.
#[derive(Clone, Debug, PartialEq)]
pub struct Follows {
    /// v̇, m/s² and rad/s².
    pub acceleration: List,
    /// λ.
    pub multipliers: List,
    /// The smallest relative pivot of the factorisation; below 10⁻¹⁴ the rest means nothing.
    pub pivot: f64,
}

impl<D: 'static> Engine<D> {
    /// v̇ and λ at a state.
    pub fn solution_at(&self, time: f64, state: &StateOf<Self>, u: &Numbers) -> Follows {
        let (mut acceleration, mut multipliers) = (self.zero_v(), self.zero_lambda());
        let pivot = self.acceleration(time, state, u, &mut acceleration, &mut multipliers);
        Follows { acceleration, multipliers, pivot }
    }

    /// Of every body the fields of its motion ([`BodyMotion`](linkwright_runtime::BodyMotion), in space
    /// [`SpatialMotion`](linkwright_runtime::SpatialMotion)), body after body.
    pub fn motions(&self, time: f64, q: &List, v: &List, a: &List) -> List {
        let mut motions = self.results(Function::Motions);
        self.moving(Function::Motions, time, q, v, a, &mut [motions.as_mut_slice()]);
        motions
    }

    /// How many numbers one body has in [`motions`](Engine::motions), and one joint in [`reactions`](Engine::reactions).
    pub fn lengths(&self) -> [usize; 2] {
        self.shared.tables.lengths
    }

    /// Of every joint force (N) and torque (N m) on the body of its second place, joint after joint.
    pub fn reactions(&self, time: f64, state: &StateOf<Self>, u: &Numbers, a: &List, lambda: &List) -> List {
        let mut reactions = self.results(Function::Reactions);
        self.with_solution(Function::Reactions, time, state, u, a, lambda, &mut [reactions.as_mut_slice()]);
        reactions
    }

    /// M a − Q.
    pub fn inverse_dynamics(&self, time: f64, state: &StateOf<Self>, u: &Numbers, a: &List) -> List {
        let mut forces = self.results(Function::InverseDynamics);
        let given = self.at_state(time, state, u).with(Acceleration, a.as_slice());
        given.results(Function::InverseDynamics, &mut [forces.as_mut_slice()]);
        forces
    }

    /// Power of each load, W.
    pub fn powers(&self, time: f64, state: &StateOf<Self>, u: &Numbers) -> List {
        let mut powers = self.results(Function::Powers);
        self.at_state(time, state, u).results(Function::Powers, &mut [powers.as_mut_slice()]);
        powers
    }

    /// Efforts of all drivers (N m or N), then their powers (W).
    pub fn driver_efforts(&self, time: f64, q: &List, v: &List, lambda: &List) -> List {
        let mut efforts = self.results(Function::DriverEfforts);
        let given =
            [(Time, from_ref(&time)), (Q, q.as_slice()), (V, v.as_slice()), (Lambda, lambda.as_slice())];
        self.call(Function::DriverEfforts, &given, &mut [efforts.as_mut_slice()]);
        efforts
    }

    fn results(&self, function: Function) -> List {
        List::zeros(self.shared.code[function as usize].outputs())
    }
}
