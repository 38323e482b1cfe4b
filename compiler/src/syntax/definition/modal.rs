//! Bodies that deform by the modes of a file, as written, and what the file says.

use super::{FileTerm, Label, OnDisk, WrittenUnit};
use crate::diagnostics::Region;
use crate::modal::Reduced;
use std::sync::Arc;

/// `(file = "arm.flex")`, and what stands in the braces beside values.
#[derive(Clone, Debug)]
pub struct ModalTerm {
    pub file: FileTerm,
    /// The first and the last, from 1.
    pub modes: Option<([usize; 2], Region)>,
    pub nodes: Vec<NodeTerm>,
    /// What the file says of these modes, once it has been read.
    pub read: Option<ReadModes>,
}

/// `point tip = node(204);`
#[derive(Clone, Debug)]
pub struct NodeTerm {
    pub name: Label,
    pub number: u64,
    pub region: Region,
    /// Of places in files: metres.
    pub unit: Option<WrittenUnit>,
}

#[derive(Clone, Debug)]
pub struct ReadModes {
    /// The file as messages show it.
    pub shown: String,
    pub on_disk: OnDisk,
    pub reduced: Arc<Reduced>,
}
