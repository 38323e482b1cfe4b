//! States, motions of single coordinates, and the results of kinematics.
//!
//! Plain values without behaviour; they are made consistent in `assembly` and advanced in `simulation.rs`.

/// The positions and velocities of a mechanism at one time. The meaning of the entries is said by
/// [`Layout`](crate::layout::Layout).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<Q, V> {
    /// Positions, shape n_q.
    pub q: Q,
    /// Velocities, shape n_v, m/s and rad/s.
    pub v: V,
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
