//! Integrators: one step of time on the group of positions.
//!
//! A method sees a mechanism only as [`Dynamics`]: states in, accelerations out. Positions move by
//! [`retract`](crate::layout::retract) with increments of the velocities' kind; methods above order 2 correct these by
//! [`inverse_differential`](crate::layout::inverse_differential). Step control, inputs and errors are
//! `simulation.rs`.

mod rk4;
mod semi_implicit_euler;

pub use rk4::Rk4;
pub use semi_implicit_euler::SemiImplicitEuler;

use crate::layout::Layout;
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// What is integrated: v̇ = f(t, q, v), with q moving by v on the group.
pub trait Dynamics<R: Real> {
    /// Which entries of q are linear, rotations, quaternions and multi-turn angles.
    const LAYOUT: Layout;
    /// Positions.
    type Q: Vector<R>;
    /// Velocities and accelerations.
    type V: Vector<R>;

    /// v̇ at a stage. The first call of a step must be at the step's own start, so that what was evaluated there
    /// already (the inputs) is not evaluated again.
    fn acceleration(&mut self, time: R, state: &State<Self::Q, Self::V>) -> Self::V;
}

/// A one-step method.
pub trait Integrator<R: Real> {
    /// The state at `time + h` from the one at `time`, s.
    fn step<D: Dynamics<R>>(
        &self,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &State<D::Q, D::V>,
    ) -> State<D::Q, D::V>;
}
