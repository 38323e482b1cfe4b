//! What moves a mechanism and shows it, without Rust: `run`, `plot`, `animate`, `sweep`, `influence`, `draw`, `watch`. The definition is read by the engine, so that
//! every method and message is that of a compiled mechanism.

pub mod animate;
mod arrow;
pub mod draw;
pub mod expression;
mod format;
mod heat_map;
mod influence;
pub mod inputs;
mod measure;
pub mod methods;
pub mod moving_picture;
mod native;
pub mod options;
mod picture;
pub mod plot;
mod progress;
pub mod record;
pub mod run;
mod runs;
pub mod sweep;
pub mod watch;

use crate::input::{self, Found};
use crate::{ERRORS, USAGE, answer, json, report, with_engine};
use expression::unknown;
use inputs::Laws;
use linkwright_compiler::diagnostics::Diagnostics;
use linkwright_compiler::source::Located;
use linkwright_compiler::{Compiled, compile_with, header, parse_at};
use linkwright_engine::{Engine, EngineError, Made, Translator};
use linkwright_runtime::AssembleExt;
use methods::{AnyEngine, EngineState};
use options::{Command, Study};
use serde_json::{Value, json};
use std::io::{IsTerminal, stderr};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

/// Why a study ends early.
pub enum Failure {
    /// Wrong usage, or a file that cannot be read or written.
    Usage(String),
    /// Errors of the definition at their places.
    Definition(Vec<Located>),
    /// The mechanism does not do what is asked: an assembly, a setting, a run.
    Motion(String),
}

impl Failure {
    /// What it says, where it has no place in the definition.
    pub fn text(self) -> String {
        match self {
            Failure::Usage(message) | Failure::Motion(message) => message,
            Failure::Definition(errors) => errors.into_iter().map(|error| error.message).collect(),
        }
    }
}

/// A mechanism that was read.
pub struct Loaded {
    pub name: String,
    pub compiled: Compiled,
    pub engine: AnyEngine,
    pub warnings: Vec<Located>,
}

/// Does what is asked for.
pub fn study(study: &Study) -> ExitCode {
    if study.command == Command::Watch {
        return watch::watch(study);
    }
    let colours = stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
    let renderer = report::renderer(colours);
    let found = match one_definition(study) {
        Ok(found) => found,
        Err(message) => {
            if study.json {
                let unreadable = [(study.file.to_string_lossy().into_owned(), message)];
                answer(json::document_of(study.command.text(), Vec::new(), &unreadable));
            } else {
                eprint!("{}", report::plain(&renderer, &message));
            }
            return ExitCode::from(USAGE);
        }
    };
    let mut name = header(found.tokens.stream.clone(), &|_| None).map(|header| header.name.to_string());
    let outcome = load(&found, study).and_then(|loaded| {
        name = Some(loaded.name.clone());
        if !study.json {
            for warning in &loaded.warnings {
                eprintln!("{}", report::finding(&renderer, &found.source, warning));
            }
        }
        let done = match study.command {
            Command::Run => run::run(study, &loaded),
            Command::Plot => plot::plot(study, &loaded),
            Command::Animate => animate::animate(study, &loaded),
            Command::Sweep => sweep::sweep(study, &loaded),
            Command::Influence => influence::influence(study, &loaded),
            Command::Draw | Command::Watch => draw::draw(study, &loaded),
        };
        done.map(|value| (value, loaded.warnings))
    });
    let (code, findings, value, said) = match outcome {
        Ok((Done { value, failed }, warnings)) => {
            (if failed { ERRORS } else { 0 }, warnings, Some(value), None)
        }
        Err(Failure::Definition(errors)) => (ERRORS, errors, None, None),
        Err(Failure::Usage(message)) => (USAGE, Vec::new(), None, Some(message)),
        Err(Failure::Motion(message)) => (ERRORS, Vec::new(), None, Some(message)),
    };
    if study.json {
        let mut object = json::mechanism(&found, name.as_deref(), &findings);
        if let Some(value) = value {
            object[study.command.text()] = value;
        }
        if let Some(message) = said {
            object["failure"] = Value::from(message);
        }
        answer(json::document_of(study.command.text(), vec![object], &[]));
    } else {
        if code == ERRORS && value.is_none() {
            for finding in &findings {
                eprintln!("{}", report::finding(&renderer, &found.source, finding));
            }
        }
        if let Some(message) = said {
            eprint!("{}", report::plain(&renderer, &message));
        }
    }
    ExitCode::from(code)
}

/// What a command leaves behind: fields for machines, and whether something failed on the way.
pub struct Done {
    pub value: Value,
    pub failed: bool,
}

/// The definition that is meant: the only one of the file, or that of the name.
pub fn one_definition(study: &Study) -> Result<Found, String> {
    let mut found = input::definitions(&study.file)?;
    let file = study.file.to_string_lossy();
    let names = found.iter().map(|one| {
        let header = header(one.tokens.stream.clone(), &|_| None);
        header.map_or("?".to_string(), |header| header.name.to_string())
    });
    let names: Vec<String> = names.collect();
    match (&study.mechanism, found.len()) {
        (_, 0) => Err(format!("there is no definition in `{file}`")),
        (Some(wanted), _) => match names.iter().position(|name| name == wanted) {
            Some(index) => Ok(found.swap_remove(index)),
            None => {
                let what = format!("--mechanism: `{file}` has no definition");
                Err(unknown(&what, wanted, names.iter().map(String::as_str)))
            }
        },
        (None, 1) => Ok(found.remove(0)),
        (None, count) => {
            let names = names.join(", ");
            Err(format!("`{file}` has {count} definitions, {names}: say which with `--mechanism NAME`"))
        }
    }
}

/// Compiles it and sets parameters.
pub fn load(found: &Found, study: &Study) -> Result<Loaded, Failure> {
    if !found.errors.is_empty() {
        return Err(Failure::Definition(found.errors.clone()));
    }
    let differentiates = study.course.integrator.is_implicit() || study.command == Command::Influence;
    let emit: &[&str] = if differentiates { &["tangent"] } else { &[] };
    let stages = || -> Result<Compiled, Diagnostics> {
        let beside = || Some(PathBuf::from(&found.source.name));
        let definition = parse_at(found.tokens.stream.clone(), &|_| beside())?;
        compile_with(&definition, None, emit)
    };
    let mut compiled = stages().map_err(|errors| Failure::Definition(found.tokens.locate(errors)))?;
    let warnings = found.tokens.locate(std::mem::take(&mut compiled.warnings));
    let name = compiled.mechanism.name.text.clone();
    let parameters = parameters(&compiled, &study.set).map_err(Failure::Usage)?;
    let too_large = |error: EngineError| Failure::Motion(error.to_string());
    let translator = if study.native { Some(native::translator().map_err(Failure::Usage)?) } else { None };
    let engine = if differentiates {
        let engine = engine(&compiled, translator).map_err(too_large)?;
        AnyEngine::Implicit(prepared(engine, parameters.as_deref())?)
    } else {
        let engine = engine(&compiled, translator).map_err(too_large)?;
        AnyEngine::Plain(prepared(engine, parameters.as_deref())?)
    };
    Ok(Loaded { name, compiled, engine, warnings })
}

fn engine<D: 'static>(
    compiled: &Compiled,
    translator: Option<Arc<dyn Translator>>,
) -> Result<Engine<D>, EngineError>
where
    Engine<D>: Made,
{
    match translator {
        None => Engine::of(compiled),
        Some(translator) => Engine::translated(compiled, translator),
    }
}

fn prepared<D: 'static>(engine: Engine<D>, parameters: Option<&[f64]>) -> Result<Engine<D>, Failure> {
    match parameters {
        None => Ok(engine),
        Some(values) => engine.prepared(values).map_err(|error| Failure::Motion(error.to_string())),
    }
}

/// All parameters in SI, if any is set.
pub fn parameters(compiled: &Compiled, set: &[(String, f64)]) -> Result<Option<Vec<f64>>, String> {
    if set.is_empty() {
        return Ok(None);
    }
    let known = &compiled.mechanism.parameters;
    let mut values = compiled.mechanism.defaults();
    for (name, value) in set {
        let Some(index) = known.iter().position(|parameter| parameter.name.text == *name) else {
            let names = known.iter().map(|parameter| parameter.name.text.as_str());
            return Err(unknown("--set: no parameter is called", name, names));
        };
        values[index] = value * known[index].unit.scale;
    }
    Ok(Some(values))
}

/// The start of an engine; assembled anew where parameters differ from those of the definition.
pub fn start<D: 'static>(engine: &Engine<D>) -> Result<EngineState, Failure> {
    if engine.parameters() == engine.default_parameters() {
        return Ok(engine.start());
    }
    engine.assembled_start().map_err(|error| Failure::Motion(error.to_string()))
}

/// The inputs of a study.
pub fn laws(loaded: &Loaded, study: &Study) -> Result<Laws, Failure> {
    Laws::read(&loaded.compiled.mechanism, &study.inputs).map_err(Failure::Usage)
}

/// Writes to the file that was named, or to standard output.
pub fn write(out: Option<&Path>, content: impl AsRef<[u8]>) -> Result<(), Failure> {
    match out {
        None => {
            answer(content);
            Ok(())
        }
        Some(path) => std::fs::write(path, content)
            .map_err(|error| Failure::Usage(format!("`{}` cannot be written: {error}", path.display()))),
    }
}

/// A number of a message: six digits, no zeros behind them.
pub fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{}", value + 0.0);
    }
    let exponent = value.abs().log10().floor();
    if !(-4.0..6.0).contains(&exponent) {
        let text = format!("{value:.5e}");
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        let digits =
            if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits };
        return format!("{digits}e{power}");
    }
    let text = format!("{value:.*}", (5.0 - exponent).max(0.0) as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
}

/// The parameters for machines.
pub fn settings(loaded: &Loaded) -> Value {
    let values = with_engine!(&loaded.engine, |engine| engine.parameters());
    let known = loaded.compiled.mechanism.parameters.iter().zip(values);
    known
        .map(|(it, value)| json!({ "name": it.name.text, "value": value / it.unit.scale, "unit": it.unit.text }))
        .collect()
}
