//! Coordinates by name: what the fields of a mechanism's emitted `…Positions` are where they are no plain numbers.
//!
//! Positions of orientations are pairs or quaternions, and angles over several turns are kept in two parts
//! ([`Layout`](crate::Layout)). The emitted structs give each coordinate its name and one of these types; lengths are plain
//! numbers, quaternions arrays (w, x, y, z).

use crate::real::Real;
use crate::rotation::wrap;

/// An orientation in the plane or about one axis, kept as (cos θ, sin θ).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle<R = f64> {
    /// cos θ.
    pub cos: R,
    /// sin θ.
    pub sin: R,
}

impl<R: Real> Angle<R> {
    /// The orientation at an angle (rad).
    ///
    /// ```
    /// use linkwright_runtime::Angle;
    ///
    /// assert_eq!(Angle::from_radians(0.0), Angle { cos: 1.0, sin: 0.0 });
    /// assert!((Angle::from_radians(2.0_f64).radians() - 2.0).abs() < 1e-15);
    /// ```
    pub fn from_radians(angle: R) -> Self {
        Angle { cos: angle.cos(), sin: angle.sin() }
    }

    /// θ in (−π, π], rad.
    pub fn radians(&self) -> R {
        self.sin.atan2(self.cos)
    }
}

/// An angle that is counted over several turns: 2π·turns + remainder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turns<R = f64> {
    /// Whole turns.
    pub turns: R,
    /// The rest in [−π, π), rad.
    pub remainder: R,
}

impl<R: Real> Turns<R> {
    /// The angle (rad) in its two parts.
    ///
    /// ```
    /// use linkwright_runtime::Turns;
    ///
    /// let angle = Turns::from_radians(10.0_f64);
    /// assert_eq!(angle.turns, 2.0);
    /// assert!((angle.radians() - 10.0).abs() < 1e-14);
    /// ```
    pub fn from_radians(angle: R) -> Self {
        let (turns, remainder) = wrap(R::ZERO, angle);
        Turns { turns, remainder }
    }

    /// The angle as one number, rad.
    pub fn radians(&self) -> R {
        self.turns.mul_add(R::from_f64(core::f64::consts::TAU), self.remainder)
    }
}
