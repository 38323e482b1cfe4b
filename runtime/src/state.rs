//! States and their derivatives, motions of single coordinates, and the results of kinematics.
//!
//! A state is everything that decides how a mechanism goes on: positions, velocities, the internal states of its force laws,
//! and what is held between events. States are made consistent in `assembly`, moved by `integrator`, and their derivatives come from
//! `formulation` and the model. The types of the parts are those of a mechanism's [`Variables`].

use crate::layout::{Layout, retract};
use crate::real::Real;
use crate::vector::Vector;

/// The types of the variables that make a state, and how its positions move.
///
/// A mechanism has one set of them; so have the [`Dynamics`](crate::Dynamics) made of it.
pub trait Variables<R: Real> {
    /// Which entries of q and v are linear, rotations, quaternions and multi-turn angles, and so how many there are.
    fn layout(&self) -> &Layout<'_>;
    /// Positions, `[R; n_q]`.
    type Q: Vector<R>;
    /// Velocities and accelerations, `[R; n_v]`.
    type V: Vector<R>;
    /// Internal states of force laws, such as currents or the deflection of bristles; `()` where there are none.
    type Z: Vector<R>;
    /// What is held between events, such as whether a contact is closed; `()` where there is nothing.
    type Gates: Vector<R>;
    /// Whether there may be such a thing. It is known when a program is compiled, and what touches, sticks and occurs is left out of programs
    /// where there is not.
    const HOLDS: bool = size_of::<Self::Gates>() > 0;
    /// For each internal state the size below which its errors count as absolute, in its own unit; none given counts as 1.
    #[inline]
    fn internal_scales(&self) -> &[f64] {
        &[]
    }
    /// Multipliers of the constraints, `[R; m]`.
    type Lambda: Vector<R>;
}

/// The state of a mechanism at one time. The meaning of its positions and velocities is said by
/// [`Layout`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct State<Q, V, Z = (), G = ()> {
    /// Positions, shape n_q.
    pub q: Q,
    /// Velocities, shape n_v, m/s and rad/s.
    pub v: V,
    /// Internal states of force laws, in their own units.
    pub z: Z,
    /// What is held between events: 1 or 0 for a gate. No integrator moves it.
    pub gates: G,
}

/// The state of what has the variables `X`, such as a mechanism.
pub type StateOf<X, R = f64> =
    State<<X as Variables<R>>::Q, <X as Variables<R>>::V, <X as Variables<R>>::Z, <X as Variables<R>>::Gates>;

/// The derivative of the state of what has the variables `X`.
pub type DerivativeOf<X, R = f64> = Derivative<<X as Variables<R>>::V, <X as Variables<R>>::Z>;

impl<Q, V> State<Q, V> {
    /// The state of a mechanism without internal states or gates.
    pub const fn new(q: Q, v: V) -> Self {
        State { q, v, z: (), gates: () }
    }
}

/// The rate of a state: (q̇, v̇, ż), with q̇ as a velocity on the group of positions.
///
/// Derivatives at one state are vectors, and times a duration they are increments. Those at different states are of different
/// axes where quaternions turn; [`inverse_differential`](crate::inverse_differential) brings them to one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivative<V, Z = ()> {
    /// The velocity on the group: u̇ of q(t) = q₀ ⊕ u(t).
    pub v: V,
    /// v̇, m/s² and rad/s².
    pub a: V,
    /// ż, in the units of the internal states per s.
    pub z: Z,
}

impl<Q, V, Z, G> State<Q, V, Z, G> {
    /// The state after `h` (s) with this derivative kept: q ⊕ h v, v + h a, z + h ż.
    #[inline]
    #[must_use]
    pub fn advance<R: Real>(&self, layout: &Layout<'_>, h: R, along: &Derivative<V, Z>) -> Self
    where
        Q: Vector<R>,
        V: Vector<R>,
        Z: Vector<R>,
        G: Clone,
    {
        self.moved(layout, &along.v.scaled(h), self.v.plus(h, &along.a), self.z.plus(h, &along.z))
    }

    /// The state at q ⊕ u, with these velocities and internal states.
    #[inline]
    #[must_use]
    pub fn moved<R: Real>(&self, layout: &Layout<'_>, u: &V, v: V, z: Z) -> Self
    where
        Q: Vector<R>,
        V: Vector<R>,
        Z: Vector<R>,
        G: Clone,
    {
        let mut q = Q::zeros(self.q.as_slice().len());
        retract(layout, &self.q, u, &mut q);
        State { q, v, z, gates: self.gates.clone() }
    }
}

impl<V, Z> Derivative<V, Z> {
    /// `self + c·other`.
    #[inline]
    #[must_use]
    pub fn plus<R: Real>(&self, c: R, other: &Self) -> Self
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        Derivative { v: self.v.plus(c, &other.v), a: self.a.plus(c, &other.a), z: self.z.plus(c, &other.z) }
    }

    /// `c·self`.
    #[inline]
    #[must_use]
    pub fn scaled<R: Real>(&self, c: R) -> Self
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        Derivative { v: self.v.scaled(c), a: self.a.scaled(c), z: self.z.scaled(c) }
    }

    /// Whether all entries are finite.
    #[inline]
    pub fn is_finite<R: Real>(&self) -> bool
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let parts = [self.v.first_not_finite(), self.a.first_not_finite(), self.z.first_not_finite()];
        parts.iter().all(Option::is_none)
    }
}

/// The prescribed motion of one coordinate at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<R = f64> {
    /// Its value, rad or m.
    pub position: R,
    /// Its first time derivative, rad/s or m/s.
    pub rate: R,
    /// Its second time derivative, rad/s² or m/s².
    pub acceleration: R,
}

/// Positions, velocities and accelerations that satisfy all constraints at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kinematics<Q, V> {
    /// Positions, shape n_q.
    pub q: Q,
    /// Velocities, shape n_v, m/s and rad/s.
    pub v: V,
    /// Accelerations, shape n_v, m/s² and rad/s².
    pub a: V,
}

impl<Q: Clone, V: Clone> Kinematics<Q, V> {
    /// The state in this motion of a mechanism without internal states or gates.
    pub fn state(&self) -> State<Q, V> {
        State::new(self.q.clone(), self.v.clone())
    }
}
