//! Values given to assembly must be finite: no constraint may hold a coordinate, and then nothing else would tell.

use crate::error::AssemblyError;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::vector::Vector;

/// An error unless the time is finite.
pub(super) fn given_time<R: Real>(time: R) -> Result<(), AssemblyError> {
    if time.is_finite() { Ok(()) } else { Err(AssemblyError::GivenNotFinite { what: "time" }) }
}

/// An error that names the first entry that is infinite or NaN.
pub(super) fn given_finite<R: Real, V: Vector<R>>(
    values: &V,
    names: &[&'static str],
    else_named: &'static str,
) -> Result<(), AssemblyError> {
    match values.first_not_finite() {
        None => Ok(()),
        Some(index) => {
            let what = names.get(index).copied().unwrap_or(else_named);
            Err(AssemblyError::GivenNotFinite { what })
        }
    }
}

/// An error that names the first of the conditions held whose target is infinite or NaN.
pub(super) fn given_targets<R: Real, M: Assemble<R>>(
    model: &M,
    targets: &M::Conditions,
    active: &[u16],
) -> Result<(), AssemblyError> {
    let target = |&&index: &&u16| targets.as_slice().get(usize::from(index));
    match active.iter().find(|index| target(index).is_some_and(|target| !target.is_finite())) {
        None => Ok(()),
        Some(&index) => {
            let condition = model.conditions().get(usize::from(index));
            Err(AssemblyError::GivenNotFinite {
                what: condition.map_or(model.name(), |condition| condition.of),
            })
        }
    }
}
