//! The loads that only space has, one file each with the same parts as in `equations::loads`.

mod body_torque;
mod bushing;
mod mesh;

use crate::equations::loads::LoadKind;

pub static LOADS: &[&LoadKind] = &[&body_torque::LOAD, &bushing::LOAD, &mesh::LOAD];
