//! The motion of a body as it is told and set by name.

/// Position, orientation, velocity and acceleration of a body; of its centre of mass, world axes, where nothing else is said.
///
/// In the plane z components are zero, and ω and ω̇ are about z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMotion {
    /// m.
    pub position: [f64; 3],
    /// A, row by row: world ← body axes; the identity for a particle.
    pub orientation: [[f64; 3]; 3],
    /// θ over several turns in the plane, rad; zero in space.
    pub angle: f64,
    /// m/s.
    pub velocity: [f64; 3],
    /// ω, body axes, rad/s.
    pub rate: [f64; 3],
    /// m/s².
    pub acceleration: [f64; 3],
    /// ω̇, body axes, rad/s².
    pub angular_acceleration: [f64; 3],
}

/// At rest at the origin, axes along the world's.
impl Default for BodyMotion {
    fn default() -> Self {
        BodyMotion {
            position: [0.0; 3],
            orientation: crate::vector::IDENTITY,
            angle: 0.0,
            velocity: [0.0; 3],
            rate: [0.0; 3],
            acceleration: [0.0; 3],
            angular_acceleration: [0.0; 3],
        }
    }
}
