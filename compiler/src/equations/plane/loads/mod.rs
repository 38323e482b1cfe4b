//! The loads that only the plane has, one file each with the same parts as in `equations::loads`.

mod bushing;
mod mesh;

pub use mesh::of_teeth;

use crate::equations::loads::LoadKind;

pub static LOADS: &[&LoadKind] = &[&bushing::LOAD, &mesh::LOAD];
