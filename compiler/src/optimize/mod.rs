//! Passes over the graph, same values, fewer operations: one file a pass, one verb each.
//!
//! `hoist`: what depends on parameters only is computed once, when parameters are set.
//! `fuse`: products go into the sums that use them.
//!
//! AFTER THIS POINT it is decided what each function computes itself, and which products are no operations of their own.

mod fuse;
mod hoist;

pub use fuse::{Fused, fuse};
pub use hoist::Hoisted;

use crate::complete::Complete;
use crate::functions::{Function, outputs};
use crate::symbolic::{Graph, Node};

/// The nodes that each function computes.
#[derive(Clone, Debug)]
pub struct Optimized {
    /// In the order of [`Function::ALL`].
    pub functions: Vec<(Function, Fused)>,
    /// The constants of the prepared model.
    pub hoisted: Hoisted,
}

/// All passes, for all functions.
pub fn optimize(complete: &Complete) -> Optimized {
    let graph = &complete.equations.graph.read();
    let mut hoisted = Hoisted::default();
    let mut functions = Vec::new();
    for function in Function::ALL {
        // `Prepare` comes last: it computes what all others asked for.
        let fused = if function == Function::Prepare {
            fuse(graph, &hoisted.nodes, |_| false)
        } else {
            let outputs = outputs(complete, function);
            hoisted.hoist(graph, &outputs);
            fuse(graph, &outputs, |node| hoist::is_hoistable(graph, node))
        };
        functions.push((function, fused));
    }
    Optimized { functions, hoisted }
}

/// All passes, for one function with these outputs.
pub fn alone(graph: &Graph, outputs: &[Node]) -> (Fused, Hoisted) {
    let mut hoisted = Hoisted::default();
    hoisted.hoist(graph, outputs);
    (fuse(graph, outputs, |node| hoist::is_hoistable(graph, node)), hoisted)
}
