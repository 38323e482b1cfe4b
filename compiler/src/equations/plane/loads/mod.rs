//! The loads that only the plane has, one file each with the same parts as in `equations::loads`.

mod bushing;
mod mesh;

use crate::equations::loads::LoadKind;

pub static LOADS: &[&LoadKind] = &[&bushing::LOAD, &mesh::LOAD];
