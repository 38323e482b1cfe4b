//! From the optimised graph to straight-line programs, one per emitted function.
//!
//! AFTER THIS POINT there is no graph, only instructions in order.

mod arrange;
mod bounds;
mod count;
mod cut;
mod evaluate;
mod fewest_alive;
mod interleave;
mod liveness;
mod program;
mod regroup;
mod repetition;
mod rounds;
mod sections;
mod select;
mod share;
mod stretch;

pub use crate::functions::{Function, outputs};
pub use crate::symbolic::Counts;
pub use bounds::{Bounded, Errors, run_bounded};
pub use count::count;
pub use cut::{Cut, Part};
pub use evaluate::{Inputs, run, run_straight};
pub use liveness::live_values;
pub use program::{Instruction, Operand, Program, Source};
pub use repetition::{Carried, Copies, List, Result, Rolled, RolledLoop, Term};

use crate::complete::Complete;
use crate::equations::Equations;
use crate::functions::{ARGUMENTS, Argument, Given};
use crate::optimize::{self, Fused, Hoisted, Optimized};
use crate::symbolic::Node;
use repetition::{Places, Strands};
pub use sections::Section;
use select::Selected;

/// All programs of one mechanism.
#[derive(Clone, Debug)]
pub struct Programs {
    /// In the order of [`Function::ALL`].
    pub functions: Vec<(Function, Program)>,
    /// Number of constants of the prepared model.
    pub prepared: usize,
    /// How many instructions the functions of each pair of [`Function::SOLUTIONS`] begin with in common.
    pub shared: [usize; Function::SOLUTIONS.len()],
}

impl Programs {
    pub fn get(&self, function: Function) -> &Program {
        static EMPTY: Program = Program {
            instructions: Vec::new(),
            outputs: Vec::new(),
            sections: Vec::new(),
            tables: Vec::new(),
            rolled: None,
            alike: 0,
        };
        self.functions.iter().find(|(known, _)| *known == function).map_or(&EMPTY, |(_, program)| program)
    }
}

/// Writes every function as a program.
pub fn schedule(complete: &Complete, optimized: &Optimized) -> Programs {
    let (graph, sources) = (complete.equations.graph.read(), sources(complete));
    // `prepare` computes the constants that the others find in the prepared model.
    let none = Hoisted::default();
    let select = |(function, fused): &(Function, Fused)| {
        let hoisted = if *function == Function::Prepare { &none } else { &optimized.hoisted };
        (*function, select::select(&graph, &sources, hoisted, fused))
    };
    let mut selected: Vec<(Function, Selected)> = optimized.functions.iter().map(select).collect();
    let places = Places::of(complete);
    for (function, selected) in &mut selected {
        let strands = repetition::strands(&selected.program, &places);
        regroup::regroup(selected, &strands.as_ref().map_or_else(Vec::new, Strands::rows));
        if let Some(strands) = strands {
            let strands = strands.anew(&selected.program, &places);
            let lists = List::all(function.signature(), complete, &selected.program.outputs);
            repetition::roll(selected, strands, &lists);
        }
    }
    let fronts = Function::SOLUTIONS.map(|known| {
        let pair = selected.iter_mut().filter(|(function, _)| known.contains(function));
        let mut pair = pair.map(|(_, program)| program);
        match (pair.next(), pair.next()) {
            (Some(plain), Some(stabilised)) => share::share(plain, stabilised),
            _ => Vec::new(),
        }
    });
    let in_order = |(function, selected): (Function, Selected)| {
        let front = function.pair().map_or(&[][..], |pair| &fronts[pair]);
        let selected = arrange::arrange(selected, front);
        let sections = match selected.program.rolled {
            Some(_) => Vec::new(),
            None => sections::sections(complete, function, &selected.nodes),
        };
        (function, Program { sections, ..selected.program })
    };
    let functions = selected.into_iter().map(in_order).collect();
    Programs { functions, prepared: optimized.hoisted.len(), shared: fronts.map(|front| front.len()) }
}

/// Operations of a function with these outputs, as they will be emitted.
pub fn count_outputs(equations: &Equations, outputs: &[Node]) -> Counts {
    // The order of the instructions does not count.
    count(&alone(equations, outputs).program)
}

/// The nodes that the instructions of a function with these outputs compute, in no particular order.
pub fn nodes_of(equations: &Equations, outputs: &[Node]) -> Vec<Node> {
    alone(equations, outputs).nodes
}

/// A function by itself. Where its arguments come from does not count, as long as each comes from a place of its own.
fn alone(equations: &Equations, outputs: &[Node]) -> Selected {
    let graph = equations.graph.read();
    let (fused, hoisted) = optimize::alone(&graph, outputs);
    let somewhere = |index: usize| Source { argument: Argument::Q, index: index as u32 };
    let anywhere: Vec<Source> = (0..graph.symbol_count()).map(somewhere).collect();
    let mut selected = select::select(&graph, &anywhere, &hoisted, &fused);
    regroup::regroup(&mut selected, &[]);
    selected
}

/// The entry of an argument that each symbol of the graph stands for.
pub fn sources(complete: &Complete) -> Vec<Source> {
    let graph = complete.equations.graph.read();
    let mut sources = vec![Source { argument: Argument::Time, index: 0 }; graph.symbol_count()];
    for Given { argument, symbols, .. } in &ARGUMENTS {
        for (index, node) in symbols(complete).iter().enumerate() {
            if let crate::symbolic::Op::Symbol(symbol) = graph.op(*node) {
                sources[symbol as usize] = Source { argument: *argument, index: index as u32 };
            }
        }
    }
    sources
}
