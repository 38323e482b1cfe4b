//! A definition in SI at given values of its parameters: bodies, rows, loads. `reading` makes it from the tree; `system` solves it.

use crate::beam::Beam;
use crate::law::Law;
use crate::load::Load;
use crate::quantity::Quantity;
use crate::row::Row;
use crate::vector::{M3, V3};
use std::collections::HashMap;
use std::sync::Arc;

#[derive(Clone, Debug)]
pub(crate) struct Definition {
    pub name: String,
    pub spatial: bool,
    /// m/s².
    pub gravity: V3,
    pub parameters: Vec<Parameter>,
    pub inputs: Vec<String>,
    pub bodies: Vec<Body>,
    pub rows: Vec<Row>,
    pub loads: Vec<Load>,
    pub states: Vec<InternalState>,
    /// Angles of spatial joints, which are counted over several turns beside the orientations.
    pub counted: Vec<Quantity>,
    /// Whether it says that rows may repeat others.
    pub redundant: bool,
}

#[derive(Clone, Debug)]
pub(crate) struct Parameter {
    pub name: String,
    pub value: f64,
}

/// z with ż = rate(t, q, v, z, u).
#[derive(Clone, Debug)]
pub(crate) struct InternalState {
    pub name: String,
    pub start: f64,
    pub rate: Law,
}

#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub name: String,
    /// A particle has no orientation.
    pub particle: bool,
    /// kg.
    pub mass: f64,
    /// About the centre of mass in body axes, kg m²; in the plane its last entry alone.
    pub inertia: M3,
    /// From the body's origin, m.
    pub center: V3,
    /// From the body's origin, m.
    pub points: HashMap<String, V3>,
    /// Of its markers, body ← marker.
    pub markers: HashMap<String, M3>,
    /// What bends of it.
    pub beam: Option<Arc<Beam>>,
}
