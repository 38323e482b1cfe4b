//! The stages in order.

use crate::check::{self, assemble, assemble::Assembly};
use crate::diagnostics::Diagnostics;
use crate::equations::{self, Equations, SpanningTree};
use crate::model::{self, Coordinates, Mechanism};
use crate::schedule::{self, Counts, Function, Programs};
use crate::solve::table::Table;
use crate::symbolic::Node;
use crate::solve::{self, Solved};
use crate::{optimize, syntax};
use proc_macro2::TokenStream;

/// A mechanism after all stages but the last.
#[derive(Clone, Debug)]
pub struct Compiled {
    pub mechanism: Mechanism,
    /// `DEFINITION`.
    pub definition: String,
    pub equations: Equations,
    pub assembly: Assembly,
    pub solved: Solved,
    pub programs: Programs,
    /// The expressions that the constants of the prepared model are.
    pub hoisted: Vec<Node>,
    /// Factorisation for the cold paths.
    pub table: Table,
    /// Independent coordinates, indices into the conditions.
    pub independent: Vec<usize>,
    /// Masses and inertias that depend on parameters, and whether they must be positive.
    pub masses: Vec<(String, bool)>,
    pub choice: Choice,
}

/// Which coordinates were taken, and why.
#[derive(Clone, Debug)]
pub struct Choice {
    pub coordinates: Coordinates,
    /// Whether the definition said so.
    pub stated: bool,
    pub strategy: solve::order::Strategy,
    /// Default acceleration function in these coordinates, and in the others if they were tried.
    pub counts: Counts,
    pub rejected: Option<Counts>,
}

/// tokens → programs. `coordinates` overrides what the definition says.
pub fn compile(tokens: TokenStream, coordinates: Option<Coordinates>) -> Result<Compiled, Diagnostics> {
    let definition = syntax::parse(tokens)?;
    // AFTER THIS POINT the definition is well formed; nothing is known of what its names mean.
    let mechanism = model::lower(&definition)?;
    // AFTER THIS POINT names are resolved, units are SI, dimensions agree.
    check::check(&mechanism)?;
    // AFTER THIS POINT the parts are possible, each for itself.
    compile_model(mechanism, syntax::definition_json(&definition), coordinates)
}

/// model → programs: where every front end arrives.
pub fn compile_model(
    mechanism: Mechanism,
    definition: String,
    coordinates: Option<Coordinates>,
) -> Result<Compiled, Diagnostics> {
    let mut errors = Diagnostics::new();
    let mut tree = equations::derive(&mechanism, SpanningTree::spanning(&mechanism));
    let Some(assembly) = assemble::assemble(&mechanism, &mut tree, &mut errors) else {
        return Err(errors);
    };
    // AFTER THIS POINT a consistent start is known and the constraint rows are independent there.
    let asked = coordinates.unwrap_or(mechanism.options.coordinates);
    let as_defined = coordinates.is_none();
    let mut candidates = Vec::new();
    if asked != Coordinates::Tree {
        let mut absolute = equations::derive(&mechanism, SpanningTree::absolute(&mechanism));
        let state = assemble::carry_over(&mechanism, &tree, &assembly, &absolute);
        let massless = assemble::massless(&mechanism, &absolute, &state, &mut errors);
        let solved = solve::solve(&mut absolute, massless);
        candidates.push((Coordinates::Absolute, absolute, state, solved));
    }
    if asked != Coordinates::Absolute {
        let massless = assemble::massless(&mechanism, &tree, &assembly, &mut errors);
        let solved = solve::solve(&mut tree, massless);
        candidates.push((Coordinates::Tree, tree, assembly, solved));
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    // AFTER THIS POINT no linear system is left.
    let counts = candidates.iter().map(|(_, equations, _, solved)| {
        schedule::count_of(equations, solved, Function::AccelerationBaumgarte)
    });
    let counts: Vec<Counts> = counts.collect();
    let best = (0..counts.len()).min_by_key(|at| counts[*at].score()).unwrap_or(0);
    let rejected = counts.iter().enumerate().find(|(at, _)| *at != best).map(|(_, counts)| *counts);
    let (coordinates, mut equations, assembly, solved) = candidates.swap_remove(best);

    let independent = equations.add_conditions(&mechanism, &assembly.independent);
    let table = table(&equations);
    let optimized = optimize::optimize(&equations, &solved);
    let programs = schedule::schedule(&equations, &optimized);
    // AFTER THIS POINT there is no graph, only instructions.
    if as_defined {
        // Limits of the definition hold for the coordinates of the definition.
        check::budget(&mechanism, &programs, &mut errors);
    }
    let choice = Choice {
        coordinates,
        stated: asked != Coordinates::Auto,
        strategy: solved.order.strategy,
        counts: counts[best],
        rejected,
    };
    let masses = assemble::positive_masses(&mechanism, &equations);
    errors.finish(Compiled {
        mechanism,
        definition,
        equations,
        assembly,
        solved,
        programs,
        hoisted: optimized.hoisted.nodes,
        table,
        independent,
        masses,
        choice,
    })
}

impl Choice {
    /// What was chosen and why, for the documentation.
    pub fn explanation(&self) -> String {
        let name = |coordinates: Coordinates| match coordinates {
            Coordinates::Absolute => "absolute",
            _ => "tree",
        };
        let own = name(self.coordinates);
        let order = match self.strategy {
            solve::order::Strategy::MinimumDegree => "minimum degree",
            solve::order::Strategy::MinimumFill => "minimum fill",
            solve::order::Strategy::Schur => "all velocities first (Schur complement)",
        };
        let (operations, depth) = (self.counts.total(), self.counts.depth);
        let why = match (&self.rejected, self.stated) {
            (Some(other), _) => {
                let rival = if own == "tree" { "absolute" } else { "tree" };
                let (theirs, deep) = (other.total(), other.depth);
                format!("chosen by count: {operations} operations, depth {depth}, against {theirs} and {deep} in {rival} coordinates")
            }
            (None, _) => format!("as the definition says: {operations} operations, depth {depth}"),
        };
        format!("In {own} coordinates ({why}); elimination order: {order}.")
    }
}

/// Structure of [M D̂ᵀ; D̂ 0] with the conditions' rows, for the cold paths.
fn table(equations: &Equations) -> Table {
    let n = equations.layout.velocities();
    let rows = equations.rows.iter().map(|row| &row.jet);
    let jets: Vec<_> = rows.chain(equations.conditions.iter().map(|condition| &condition.jet)).collect();
    let entries = jets.iter().enumerate().flat_map(|(at, jet)| {
        jet.columns.keys().map(move |column| (n + at, *column)).collect::<Vec<_>>()
    });
    Table::new(n, jets.len(), equations.mass.keys().copied().chain(entries))
}
