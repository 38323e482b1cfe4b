//! Motions of bodies and reactions of joints, as emitted functions report it, and the checks of a model's parameters.

use crate::error::SettingError;
use crate::fields::Fields;
use crate::quaternion::from_rotation_matrix;
use crate::real::Real;

/// Motion of one body in the plane at one time; position, velocity and acceleration are those of its centre of mass, world axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct BodyMotion<R = f64> {
    /// m.
    pub position: [R; 2],
    /// (cos θ, sin θ); (1, 0) for a particle.
    pub orientation: [R; 2],
    /// m/s.
    pub velocity: [R; 2],
    /// ω, rad/s.
    pub rate: R,
    /// m/s².
    pub acceleration: [R; 2],
    /// ω̇, rad/s².
    pub angular_acceleration: R,
}

impl<R: Real> BodyMotion<R> {
    /// World position of a point given in the body's axes from its centre of mass: r + A d, m.
    pub fn point(&self, [x, y]: [R; 2]) -> [R; 2] {
        let ([c, s], [px, py]) = (self.orientation, self.position);
        [px + c * x - s * y, py + s * x + c * y]
    }
}

/// Motion of one body in space at one time; position, velocity and acceleration are those of its centre of mass, world
/// axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct SpatialMotion<R = f64> {
    /// m.
    pub position: [R; 3],
    /// A, row by row: world ← body axes; the identity for a particle.
    pub orientation: [[R; 3]; 3],
    /// m/s.
    pub velocity: [R; 3],
    /// ω, body axes, rad/s.
    pub rate: [R; 3],
    /// m/s².
    pub acceleration: [R; 3],
    /// ω̇, body axes, rad/s².
    pub angular_acceleration: [R; 3],
}

impl<R: Real> SpatialMotion<R> {
    /// World position of a point given in the body's axes from its centre of mass: r + A d, m.
    pub fn point(&self, [x, y, z]: [R; 3]) -> [R; 3] {
        let ([a, b, c], [px, py, pz]) = (self.orientation, self.position);
        let along = |row: [R; 3]| row[0] * x + row[1] * y + row[2] * z;
        [px + along(a), py + along(b), pz + along(c)]
    }

    /// The orientation as a unit quaternion (w, x, y, z), w ≥ 0.
    pub fn quaternion(&self) -> [R; 4] {
        from_rotation_matrix(&self.orientation)
    }
}

/// The force and torque that a joint in the plane exerts on the body of its second place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Reaction<R = f64> {
    /// At the second place, world axes, N.
    pub force: [R; 2],
    /// About the second place, N m.
    pub torque: R,
}

/// The force and torque that a joint in space exerts on the body of its second place; world axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct SpatialReaction<R = f64> {
    /// At the second place, N.
    pub force: [R; 3],
    /// About the second place, N m.
    pub torque: [R; 3],
}

/// Position, orientation (cos θ, sin θ), velocity, ω, acceleration, ω̇.
impl<R: Real> Fields<R> for BodyMotion<R> {
    const NAMES: &'static [&'static str] = &[
        "position.x",
        "position.y",
        "orientation.cos",
        "orientation.sin",
        "velocity.x",
        "velocity.y",
        "rate",
        "acceleration.x",
        "acceleration.y",
        "angular_acceleration",
    ];
    type Array = [R; 10];

    fn from_array([x, y, c, s, vx, vy, rate, ax, ay, angular_acceleration]: [R; 10]) -> Self {
        BodyMotion {
            position: [x, y],
            orientation: [c, s],
            velocity: [vx, vy],
            rate,
            acceleration: [ax, ay],
            angular_acceleration,
        }
    }
    fn to_array(&self) -> [R; 10] {
        let [[x, y], [c, s], [vx, vy], [ax, ay]] =
            [self.position, self.orientation, self.velocity, self.acceleration];
        [x, y, c, s, vx, vy, self.rate, ax, ay, self.angular_acceleration]
    }
}

/// Position, A row by row, velocity, ω, acceleration, ω̇.
impl<R: Real> Fields<R> for SpatialMotion<R> {
    const NAMES: &'static [&'static str] = &[
        "position.x",
        "position.y",
        "position.z",
        "orientation.xx",
        "orientation.xy",
        "orientation.xz",
        "orientation.yx",
        "orientation.yy",
        "orientation.yz",
        "orientation.zx",
        "orientation.zy",
        "orientation.zz",
        "velocity.x",
        "velocity.y",
        "velocity.z",
        "rate.x",
        "rate.y",
        "rate.z",
        "acceleration.x",
        "acceleration.y",
        "acceleration.z",
        "angular_acceleration.x",
        "angular_acceleration.y",
        "angular_acceleration.z",
    ];
    type Array = [R; 24];

    fn from_array(values: [R; 24]) -> Self {
        let [x, y, z, xx, xy, xz, yx, yy, yz, zx, zy, zz, rest @ ..] = values;
        let [vx, vy, vz, wx, wy, wz, ax, ay, az, bx, by, bz] = rest;
        SpatialMotion {
            position: [x, y, z],
            orientation: [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]],
            velocity: [vx, vy, vz],
            rate: [wx, wy, wz],
            acceleration: [ax, ay, az],
            angular_acceleration: [bx, by, bz],
        }
    }
    fn to_array(&self) -> [R; 24] {
        let [x, y, z] = self.position;
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.orientation;
        let ([vx, vy, vz], [wx, wy, wz]) = (self.velocity, self.rate);
        let ([ax, ay, az], [bx, by, bz]) = (self.acceleration, self.angular_acceleration);
        [x, y, z, xx, xy, xz, yx, yy, yz, zx, zy, zz, vx, vy, vz, wx, wy, wz, ax, ay, az, bx, by, bz]
    }
}

/// Force, torque.
impl<R: Real> Fields<R> for Reaction<R> {
    const NAMES: &'static [&'static str] = &["force.x", "force.y", "torque"];
    type Array = [R; 3];

    fn from_array([x, y, torque]: [R; 3]) -> Self {
        Reaction { force: [x, y], torque }
    }
    fn to_array(&self) -> [R; 3] {
        let [x, y] = self.force;
        [x, y, self.torque]
    }
}

/// Force, torque.
impl<R: Real> Fields<R> for SpatialReaction<R> {
    const NAMES: &'static [&'static str] =
        &["force.x", "force.y", "force.z", "torque.x", "torque.y", "torque.z"];
    type Array = [R; 6];

    fn from_array([x, y, z, tx, ty, tz]: [R; 6]) -> Self {
        SpatialReaction { force: [x, y, z], torque: [tx, ty, tz] }
    }
    fn to_array(&self) -> [R; 6] {
        let ([x, y, z], [tx, ty, tz]) = (self.force, self.torque);
        [x, y, z, tx, ty, tz]
    }
}

/// A parameter must be finite.
#[doc(hidden)]
pub fn check_finite<R: Real>(what: &'static str, value: R) -> Result<(), SettingError> {
    if value.is_finite() {
        return Ok(());
    }
    Err(SettingError { what, value: value.to_f64(), must_be: "finite" })
}

/// A parameter must be finite and within its inclusive bounds.
#[doc(hidden)]
pub fn check_setting<R: Real>(
    what: &'static str,
    value: R,
    least: f64,
    most: f64,
    must_be: &'static str,
) -> Result<(), SettingError> {
    check_finite(what, value)?;
    let value = value.to_f64();
    if value < least || value > most {
        return Err(SettingError { what, value, must_be });
    }
    Ok(())
}

/// A mass, inertia or length must not be negative, and must be positive if it was in the definition.
#[doc(hidden)]
pub fn check_mass<R: Real>(what: &'static str, value: R, positive: bool) -> Result<(), SettingError> {
    let value = value.to_f64();
    if positive && !(value > 0.0 && value.is_finite()) {
        return Err(SettingError { what, value, must_be: "positive" });
    }
    if !(value >= 0.0 && value.is_finite()) {
        return Err(SettingError { what, value, must_be: "zero or positive" });
    }
    Ok(())
}

/// No constant of a prepared model may be infinite or NaN.
#[doc(hidden)]
pub fn check_constants<R: Real>(constants: &[R]) -> Result<(), SettingError> {
    match constants.iter().find(|constant| !constant.is_finite()) {
        None => Ok(()),
        Some(constant) => Err(SettingError {
            what: "the parameters together",
            value: constant.to_f64(),
            must_be: "such that every length, mass and stiffness that follows from them is finite",
        }),
    }
}
