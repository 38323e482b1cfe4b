//! States that outlive a program: plain arrays with a version and a fingerprint of the definition.

use crate::clock::Clock;
use crate::real::Real;
use crate::state::{State, Variables};

/// The version of the format.
const VERSION: u32 = 1;

/// A saved state of the mechanism `M`.
pub type SavedOf<M, R = f64> = Saved<
    <M as Variables<R>>::Q,
    <M as Variables<R>>::V,
    <M as Variables<R>>::Z,
    <M as Variables<R>>::Gates,
    R,
>;

/// What a stepper keeps: time and state, and what they belong to. Parameters are not part of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Saved<Q, V, Z, G, R = f64> {
    /// The version of the format.
    pub version: u32,
    /// The fingerprint of the definition ([`Mechanism::fingerprint`](crate::Mechanism::fingerprint)).
    pub fingerprint: u64,
    /// The clock, s: three numbers whose sum is the time.
    pub time: [R; 3],
    /// Positions.
    pub q: Q,
    /// Velocities.
    pub v: V,
    /// Internal states.
    pub z: Z,
    /// What is held between events.
    pub gates: G,
}

impl<Q: Clone, V: Clone, Z: Clone, G: Clone, R: Real> Saved<Q, V, Z, G, R> {
    pub(super) fn new(fingerprint: u64, clock: &Clock<R>, state: &State<Q, V, Z, G>) -> Self {
        let State { q, v, z, gates } = state.clone();
        Saved { version: VERSION, fingerprint, time: clock.terms(), q, v, z, gates }
    }

    /// Whether it is of this definition and version.
    pub(super) fn is_of(&self, fingerprint: u64) -> bool {
        self.version == VERSION && self.fingerprint == fingerprint
    }

    /// The clock, if the three numbers are one.
    pub(super) fn clock(&self) -> Option<Clock<R>> {
        Clock::of_terms(self.time)
    }

    /// The state, as it was saved.
    pub(super) fn state(&self) -> State<Q, V, Z, G> {
        let Saved { q, v, z, gates, .. } = self.clone();
        State { q, v, z, gates }
    }
}
