//! What the instructions of a solution are for, as far as their order tells it: the sections that emitted code shows.
//!
//! Selection goes depth first, so that M and D come with their factorisation, and forces and γ with the substitution. A border
//! stands only where all before it is of earlier steps than all behind it; an interleaved program may have none.

use super::Function;
use crate::complete::Complete;
use crate::functions;
use crate::symbolic::{Class, Node};

/// Instructions from one on, up to the next section.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    pub start: usize,
    pub title: String,
}

/// What an instruction is for, by the first step that needs it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Step {
    /// These and what follows from rates stand wherever the later steps need them.
    Positions,
    Rates,
    Factorisation,
    Substitution,
    Watch,
}

impl Step {
    const ALL: [Step; 5] =
        [Step::Positions, Step::Rates, Step::Factorisation, Step::Substitution, Step::Watch];

    fn text(self) -> &'static str {
        match self {
            Step::Positions => "positions",
            Step::Rates => "rates and forces",
            Step::Factorisation => "factorisation of M and D",
            Step::Substitution => "substitution",
            Step::Watch => "smallest relative pivot",
        }
    }

    /// Whether a border may stand before the first of it.
    fn parts(self) -> bool {
        self >= Step::Factorisation
    }
}

/// The sections of a function whose instructions compute these nodes; none of one that solves nothing.
pub fn sections(complete: &Complete, function: Function, nodes: &[Node]) -> Vec<Section> {
    let equations = &complete.equations;
    let Some((solution, factored)) =
        functions::solution(complete, function).filter(|(_, factored)| !factored.is_empty())
    else {
        return Vec::new();
    };
    let graph = equations.graph.read();
    let mut first = vec![Step::Watch; graph.len()];
    let mut mark = |roots: &mut dyn Iterator<Item = Node>, step: Step| {
        for node in graph.reachable(roots) {
            first[node.index()] = step;
        }
    };
    mark(&mut solution.acceleration.iter().chain(&solution.lambda).copied(), Step::Substitution);
    mark(&mut factored.iter().copied(), Step::Factorisation);
    let rows =
        equations.rows.iter().flat_map(|row| row.jet.columns.values().chain([&row.jet.value, &row.jet.bias]));
    mark(&mut rows.chain(equations.mass.values()).chain(&equations.forces).copied(), Step::Rates);
    let step = |node: &Node| match first[node.index()] {
        Step::Rates if graph.class(*node) <= Class::Position => Step::Positions,
        step => step,
    };
    parted(&nodes.iter().map(step).collect::<Vec<_>>())
}

/// Sections between borders, each with the steps in it.
fn parted(steps: &[Step]) -> Vec<Section> {
    // The earliest of the later steps from each place on.
    let mut earliest = vec![Step::Watch; steps.len() + 1];
    for (index, step) in steps.iter().enumerate().rev() {
        earliest[index] = if step.parts() { earliest[index + 1].min(*step) } else { earliest[index + 1] };
    }
    let mut starts = vec![0];
    let mut latest = None;
    for (index, step) in steps.iter().enumerate() {
        // What the next step needs stands before it and belongs to it.
        if latest.is_some_and(|latest| latest < earliest[index]) {
            starts.push(index);
            latest = None;
        }
        if step.parts() {
            latest = latest.max(Some(*step));
        }
    }
    let ends = starts.iter().skip(1).copied().chain([steps.len()]);
    let parts = starts.iter().zip(ends).filter(|(start, end)| **start < *end);
    parts.map(|(start, end)| Section { start: *start, title: title(&steps[*start..end]) }).collect()
}

/// `positions, factorisation of M and D`.
fn title(steps: &[Step]) -> String {
    let found = Step::ALL.into_iter().filter(|step| steps.contains(step));
    found.map(Step::text).collect::<Vec<_>>().join(", ")
}
