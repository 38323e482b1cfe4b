//! The symbolic core: one hash-consed graph of scalar operations, its operations as a closed table, exact derivatives, and an
//! interpreter. It knows nothing of mechanisms, tokens or Rust and imports nothing else of the crate.

mod computed;
mod counts;
mod derivative;
mod evaluate;
mod few;
mod graph;
mod hash;
mod operation;
mod rounding;
mod sheet;
mod substitute;
mod table;

pub use computed::Computed;
pub use counts::Counts;
pub use derivative::Gradient;
pub use evaluate::{evaluate, evaluate_reachable, evaluate_with};
pub use few::Few;
pub use graph::{Class, Graph, Node, Op};
pub use hash::{FastHash, Known, mix};
pub use operation::{Compare, Unary, max, min};
pub use rounding::{of_patch, of_piece, of_quotient, passed_on};
pub use sheet::{Bare, Growing, On, Scalar, Sheet, all_bare};
pub use table::{AXIS, BICUBIC, Orders, PATCHES, PIECES, Table};
