//! Parameters, inputs and outputs as generic code sees them: named numbers in the order of their declaration.
//!
//! Written code uses the fields of the emitted structs by name; this is for what serves every mechanism alike, such as
//! tables, files and tests.

use crate::error::SettingError;
use crate::real::Real;
use crate::vector::Vector;

/// A struct whose fields are all scalars; implemented by the emitted parameters, inputs and outputs.
pub trait Fields<R: Real>: Clone {
    /// The fields' names as in the definition, in order, where the program knows them when it is compiled. Those of inputs and
    /// outputs the mechanism itself tells: [`input_names`](crate::Mechanism::input_names),
    /// [`output_names`](crate::Mechanism::output_names).
    const NAMES: &'static [&'static str];
    /// One entry for each field, `[R; NAMES.len()]`.
    type Array: Vector<R>;

    /// The struct with these values, SI units.
    fn from_array(values: Self::Array) -> Self;
    /// The values of all fields, SI units.
    fn to_array(&self) -> Self::Array;
}

/// A model that is prepared from parameters; implemented by every emitted mechanism.
pub trait Parametric<R: Real>: Sized {
    /// The parameters.
    type Parameters: Fields<R>;

    /// Those it was prepared with, SI units.
    fn parameters(&self) -> &Self::Parameters;
    /// The model with these parameters.
    ///
    /// # Errors
    /// A parameter that is not finite or out of its bounds, or a mass that is not positive.
    fn prepare(parameters: Self::Parameters) -> Result<Self, SettingError>;
}

/// Inputs or outputs of a mechanism that has none.
impl<R: Real> Fields<R> for () {
    const NAMES: &'static [&'static str] = &[];
    type Array = [R; 0];

    fn from_array(_values: [R; 0]) -> Self {}
    fn to_array(&self) -> [R; 0] {
        []
    }
}
