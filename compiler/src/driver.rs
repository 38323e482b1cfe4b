//! The stages in order.

use crate::check::assemble::Assembly;
use crate::check::{self, assemble, motion};
use crate::choice::{self, Candidate};
use crate::compiled::Compiled;
use crate::complete::Complete;
use crate::diagnostics::Diagnostics;
use crate::equations::{self, Equations, Omitted, SpanningTree, Tangents, VOCABULARY};
use crate::model::{self, Coordinates, Mechanism};
use crate::schedule;
use crate::self_check::{self, Extent};
use crate::solve::Further;
use crate::solve::table::Table;
use crate::source::{self, FileOf, Shelf};
use crate::syntax::{Definition, Header};
use crate::{budget, optimize, syntax};
use proc_macro2::TokenStream;

/// tokens → what was written, in the words of all elements.
pub fn parse(tokens: TokenStream) -> Result<Definition, Diagnostics> {
    parse_at(tokens, &|_| None)
}

/// The same where the files are known that tokens stand in: tables in files of their own are beside them.
pub fn parse_at(tokens: TokenStream, file_of: FileOf) -> Result<Definition, Diagnostics> {
    let mut definition = syntax::parse(tokens, &VOCABULARY, &Shelf { file_of })
        .map_err(|(definition, found)| source::brought(&definition, found))?;
    match source::read_files(&mut definition, file_of) {
        Ok(()) => Ok(definition),
        Err(found) => Err(source::brought(&definition, found)),
    }
}

/// tokens → what can be said of a definition that may be full of errors.
pub fn header(tokens: TokenStream, file_of: FileOf) -> Option<Header> {
    syntax::header(tokens, &VOCABULARY, &Shelf { file_of })
}

/// tokens → programs. `coordinates` overrides what the definition says.
pub fn compile(tokens: TokenStream, coordinates: Option<Coordinates>) -> Result<Compiled, Diagnostics> {
    compile_definition(&parse(tokens)?, coordinates)
}

/// The same where the files are known that tokens stand in.
pub fn compile_at(
    tokens: TokenStream,
    coordinates: Option<Coordinates>,
    file_of: FileOf,
) -> Result<Compiled, Diagnostics> {
    compile_definition(&parse_at(tokens, file_of)?, coordinates)
}

/// What was written → programs.
pub fn compile_definition(
    definition: &Definition,
    coordinates: Option<Coordinates>,
) -> Result<Compiled, Diagnostics> {
    compile_with(definition, coordinates, &[])
}

/// The same with these words of `emit` beside those of the definition.
pub fn compile_with(
    definition: &Definition,
    coordinates: Option<Coordinates>,
    emit: &[&str],
) -> Result<Compiled, Diagnostics> {
    let shown = |found| source::brought(definition, found);
    // AFTER THIS POINT the definition is well formed; nothing is known of what its names mean.
    let mut mechanism = model::lower(definition).map_err(shown)?;
    emit.iter().for_each(|word| mechanism.options.emit.set(word));
    // AFTER THIS POINT names are resolved, units are SI, dimensions agree.
    let compiled = compile_model(mechanism, syntax::definition_json(definition), coordinates);
    let compiled = compiled.map_err(shown)?;
    let warnings = shown(compiled.warnings);
    Ok(Compiled { warnings, ..compiled })
}

/// A mechanism put together, in the coordinates of its tree and with all rows.
#[derive(Clone, Debug)]
pub struct Start {
    pub mechanism: Mechanism,
    pub equations: Equations,
    pub assembly: Assembly,
}

/// tokens → a consistent start: the stages up to assembly, for those who ask for nothing else.
pub fn start(tokens: TokenStream) -> Result<Start, Diagnostics> {
    let definition = parse(tokens)?;
    let shown = |found| source::brought(&definition, found);
    let mechanism = model::lower(&definition).map_err(shown)?;
    let asked = mechanism.options.coordinates;
    start_of_model(mechanism, asked).map_err(shown)
}

fn start_of_model(mechanism: Mechanism, asked: Coordinates) -> Result<Start, Diagnostics> {
    check::check(&mechanism)?;
    // AFTER THIS POINT the parts are possible, each for itself.
    let mut errors = Diagnostics::new();
    let spanning = SpanningTree::spanning(&mechanism);
    check::counted_angles(&mechanism, &spanning)?;
    check::curves(&mechanism, &spanning)?;
    check::ways(&mechanism, &spanning, &mut errors);
    if !errors.is_empty() {
        return Err(errors);
    }
    let equations = equations::derive(&mechanism, spanning, &Omitted::default());
    check::size(&mechanism, &equations, asked, &mut errors);
    if !errors.is_empty() {
        return Err(errors);
    }
    // AFTER THIS POINT what will be written out is of a size to be read.
    let Some((mechanism, equations, stand)) = assemble::taken_up(mechanism, equations, &mut errors) else {
        return Err(errors);
    };
    let Some((mechanism, equations)) = assemble::deflected(mechanism, equations, &mut errors) else {
        return Err(errors);
    };
    match assemble::assemble(&mechanism, &equations, stand, &mut errors) {
        Some(assembly) => Ok(Start { mechanism, equations, assembly }),
        None => Err(errors),
    }
}

/// model → programs: where every front end arrives.
pub fn compile_model(
    mechanism: Mechanism,
    definition: String,
    coordinates: Option<Coordinates>,
) -> Result<Compiled, Diagnostics> {
    let asked = coordinates.unwrap_or(mechanism.options.coordinates);
    let Start { mechanism, equations: tree, assembly } = start_of_model(mechanism, asked)?;
    let mut warnings = check::warnings(&mechanism, &assembly.shared);
    let mut errors = Diagnostics::new();
    let spanning = tree.tree.clone();
    let tree = equations::without_redundant(&mechanism, spanning, tree, &assembly.omitted);
    // AFTER THIS POINT a consistent start is known and the constraint rows are independent there.
    check::standing(&mechanism, &tree, &assembly, &mut errors);
    if !errors.is_empty() {
        return Err(errors);
    }
    check::deflections(&mechanism, &tree, &assembly, &mut errors);
    motion::check(&mechanism, &tree, &assembly, &mut warnings, &mut errors);
    if !errors.is_empty() {
        return Err(errors);
    }
    // AFTER THIS POINT the motion is what `expect` says of it.
    let as_defined = coordinates.is_none();
    let Some((candidate, choice)) = choice::choose(&mechanism, tree, assembly, asked, &mut errors) else {
        return Err(errors);
    };
    // AFTER THIS POINT no linear system is left.
    let Candidate { equations, assembly, solved } = candidate;
    let Some(states) = check::steady(&mechanism, &equations, &solved, &assembly, &mut errors) else {
        return Err(errors);
    };
    let mechanism = Mechanism { states, ..mechanism };
    let mut equations = equations.starting_at(&mechanism);
    let growing = check::unstable(&mechanism, &equations, &solved, &assembly);
    check::unstable_states(&mechanism, &growing, &mut warnings);
    check::beyond_tables(&mechanism, &equations, &assembly, &mut warnings);
    check::unstiffened(&mechanism, &equations, &solved, &assembly, &mut warnings);
    check::cords(&mechanism, &equations, &solved, &assembly, &mut errors);
    check::contacts(&mechanism, &equations, &assembly, &mut errors, &mut warnings);
    check::held(&mechanism, &equations, &assembly, &mut errors, &mut warnings);
    check::locks(&mechanism, &equations, &solved, &assembly, &mut warnings);
    let vibration = check::vibration(&mechanism, &equations, &assembly);
    let blows = check::contact_times(&mechanism, &equations, &assembly, &mut errors);
    let braking = check::braking(&mechanism, &equations, &solved, &assembly, &mut errors);
    // AFTER THIS POINT every state has its start.
    let (conditions, independent) = equations.conditions.with(&mechanism, &equations, &assembly.independent);
    let partitions = assemble::partitions(&mechanism, &equations, &conditions, &assembly, &independent);
    let further =
        Further::of(&mut equations, &solved, &mechanism.options, &partitions, &schedule::count_outputs);
    let (conditions, tangents) = if mechanism.options.emit.tangent {
        let others = assemble::completion(&mechanism, &equations, &conditions, &assembly, &independent);
        let (conditions, others) = conditions.with(&mechanism, &equations, &others);
        let states = independent.iter().copied().chain(others).collect();
        let tangents = Tangents::new(&equations, &conditions.rows, states);
        (conditions, Some(tangents))
    } else {
        (conditions, None)
    };
    let complete = Complete { equations, conditions, solved, further, tangents };
    // AFTER THIS POINT every expression that a function computes is on the graph.
    let table = table(&complete);
    let optimized = optimize::optimize(&complete);
    let programs = schedule::schedule(&complete, &optimized);
    // AFTER THIS POINT there is no graph, only instructions.
    let masses = assemble::positive_masses(&mechanism, &complete.equations);
    let compiled = Compiled {
        mechanism,
        definition,
        complete,
        assembly,
        programs,
        hoisted: optimized.hoisted.nodes,
        table,
        independent,
        masses,
        choice,
        blows,
        braking,
        vibration,
        warnings,
    };
    if as_defined {
        // Limits of the definition hold for the coordinates of the definition.
        budget::budget(&compiled, &compile_model, &mut errors);
    }
    let extent = Extent::asked(compiled.mechanism.options.self_check);
    if let Some(contradiction) = self_check::self_check(&compiled, extent).first() {
        errors.error(compiled.mechanism.name.span, contradiction.to_string());
    }
    // AFTER THIS POINT the programs are what was derived, as far as that can be seen at a few states.
    errors.finish(compiled)
}

/// Structure of [M D̂ᵀ; D̂ 0] with the conditions' rows, for the cold paths.
fn table(complete: &Complete) -> Table {
    let Complete { equations, conditions, solved, .. } = complete;
    let n = equations.layout.velocities();
    let rows = equations.rows.iter().map(|row| &row.jet);
    let jets: Vec<_> = rows.chain(conditions.rows.iter().map(|condition| &condition.jet)).collect();
    let entries = jets
        .iter()
        .enumerate()
        .flat_map(|(at, jet)| jet.columns.keys().map(move |column| (n + at, *column)).collect::<Vec<_>>());
    // M gets the squares of the rows that hold massless velocities.
    let held = solved.massless.rows.keys().flat_map(|row| {
        let columns = &equations.rows[*row].jet.columns;
        columns.keys().flat_map(|i| columns.range(..i).map(|(j, _)| (*i, *j))).collect::<Vec<_>>()
    });
    Table::new(n, jets.len(), equations.mass.keys().copied().chain(entries).chain(held))
}
