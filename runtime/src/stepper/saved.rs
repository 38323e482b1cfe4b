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

    /// Clock, if it is one, and state, if they are of this definition and version.
    pub(super) fn of(&self, fingerprint: u64) -> Option<(Option<Clock<R>>, State<Q, V, Z, G>)> {
        let Saved { q, v, z, gates, .. } = self.clone();
        let fits = self.version == VERSION && self.fingerprint == fingerprint;
        fits.then(|| (Clock::of_terms(self.time), State { q, v, z, gates }))
    }
}
