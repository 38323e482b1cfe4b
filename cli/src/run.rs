//! A command over its files: reads, compiles, reports, and decides the exit code.

use crate::arguments::{Command, Job};
use crate::input::{self, Found};
use crate::{ERRORS, USAGE, answer, explain, json, report, text};
use annotate_snippets::Renderer;
use linkwright_compiler::counts::{self, Row};
use linkwright_compiler::diagnostics::Diagnostics;
use linkwright_compiler::export::Files;
use linkwright_compiler::model::Coordinates;
use linkwright_compiler::source::Located;
use linkwright_compiler::syntax::Definition;
use linkwright_compiler::{Compiled, compile_definition, compile_with, export, header, parse_at};
use serde_json::Value;
use std::ffi::OsStr;
use std::io::{IsTerminal, stderr};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Work that takes longer than this is worth a word on a terminal.
const PATIENCE: Duration = Duration::from_secs(1);

/// Does what is asked for.
pub fn run(job: &Job) -> ExitCode {
    let mut run = Run::new(job);
    for (index, file) in job.files.iter().enumerate() {
        match input::definitions(file) {
            Ok(found) => run.file(index, file, &found),
            Err(message) => run.unreadable(file, message),
        }
    }
    run.finish()
}

/// What has come out so far.
struct Run<'j> {
    job: &'j Job,
    renderer: Renderer,
    begin: Instant,
    definitions: usize,
    wrong: usize,
    unreadable: Vec<(String, String)>,
    mechanisms: Vec<Value>,
    text: String,
    /// The names of files that were written, and where the definitions stand.
    exported: Vec<(String, String)>,
}

impl<'j> Run<'j> {
    fn new(job: &'j Job) -> Self {
        let colours =
            stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
        Run {
            job,
            renderer: report::renderer(colours),
            begin: Instant::now(),
            definitions: 0,
            wrong: 0,
            unreadable: Vec::new(),
            mechanisms: Vec::new(),
            text: String::new(),
            exported: Vec::new(),
        }
    }

    fn unreadable(&mut self, file: &OsStr, message: String) {
        if !self.job.json {
            eprint!("{}", report::plain(&self.renderer, &message));
        }
        self.unreadable.push((file.to_string_lossy().into_owned(), message));
    }

    fn file(&mut self, index: usize, file: &OsStr, found: &[Found]) {
        if found.is_empty() && !self.job.json {
            eprintln!("{}: no `mechanism!` in it", file.to_string_lossy());
        }
        for one in found {
            self.progress(index, file);
            self.definitions += 1;
            self.definition(one);
        }
    }

    /// Says on a terminal what is being done, if it takes long.
    fn progress(&self, index: usize, file: &OsStr) {
        if self.begin.elapsed() > PATIENCE && stderr().is_terminal() {
            eprintln!("file {} of {}: {}", index + 1, self.job.files.len(), file.to_string_lossy());
        }
    }

    fn definition(&mut self, found: &Found) {
        let name = header(found.tokens.stream.clone(), &|_| None).map(|header| header.name.to_string());
        let mut warnings = Vec::new();
        let mut warn = |compiled: &Compiled| warnings = found.tokens.locate(compiled.warnings.clone());
        let result = match self.job.command {
            Command::Check => compiled(found, self.job.coordinates).map(|(_, compiled)| {
                warn(&compiled);
                None
            }),
            Command::Explain => compiled(found, self.job.coordinates).map(|(definition, compiled)| {
                warn(&compiled);
                let explanation = explain::explain(&definition, &compiled);
                self.text.push_str(&text::explanation(&explanation, &place(found)));
                Some(("explanation", json::explanation(&explanation)))
            }),
            Command::Export => {
                compiled_with(found, self.job.coordinates, &["projection"]).and_then(|(_, compiled)| {
                    if let Some(refused) = export::refused(&compiled) {
                        return Err(found.tokens.locate(refused));
                    }
                    warn(&compiled);
                    let files = export::c(&compiled, self.job.scalar);
                    Ok(Some(("exported", self.write(&files, place(found)))))
                })
            }
            Command::Counts => counts(found, name.as_deref(), self.job.coordinates).map(|rows| {
                self.text.push_str(&counts::as_tables(&rows));
                Some(("counts", json::counts(&rows)))
            }),
        };
        let errors = result.as_ref().err().map_or(&[] as &[Located], |errors| errors);
        self.wrong += usize::from(!errors.is_empty());
        let findings: Vec<Located> = errors.iter().cloned().chain(warnings).collect();
        let mut object = json::mechanism(found, name.as_deref(), &findings);
        if !self.job.json {
            for finding in &findings {
                eprintln!("{}", report::finding(&self.renderer, &found.source, finding));
            }
        }
        if let Ok(Some((key, value))) = result {
            object[key] = value;
        }
        self.mechanisms.push(object);
    }

    /// Writes the files of a mechanism, and tells which.
    fn write(&mut self, files: &Files, from: String) -> Value {
        let Files { name, header, source, class } = files;
        if let Some((_, first)) = self.exported.iter().find(|(known, _)| known == name) {
            let message = format!(
                "the definitions at {first} and {from} would both be written to `{name}.c`: rename one, or export them to different \
                 folders with `--output`"
            );
            self.unreadable(from.as_ref(), message);
            return Value::Array(Vec::new());
        }
        self.exported.push((name.clone(), from));
        let texts =
            [(format!("{name}.h"), header), (format!("{name}.c"), source), (format!("{name}.hpp"), class)];
        let mut written = Vec::new();
        for (name, text) in texts {
            let path = self.job.output.join(name);
            let folder = std::fs::create_dir_all(&self.job.output).or_else(|error| {
                match self.job.output.as_os_str() {
                    none if none.is_empty() => Ok(()),
                    _ => Err(error),
                }
            });
            match folder.and_then(|()| std::fs::write(&path, text)) {
                Ok(()) => written.push(path.display().to_string()),
                Err(error) => {
                    let message = format!("`{}` cannot be written: {error}", path.display());
                    self.unreadable(path.as_os_str(), message);
                }
            }
        }
        written.iter().for_each(|path| self.text.push_str(&format!("{path}\n")));
        Value::from(written)
    }

    fn finish(self) -> ExitCode {
        let plural =
            |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
        let mut text = self.text;
        if self.job.json {
            text = json::document(self.job.command, self.mechanisms, &self.unreadable);
        } else if self.job.command == Command::Check && self.definitions > 0 {
            let checked = plural(self.definitions, "definition");
            let verdict =
                if self.wrong == 0 { "all well".to_string() } else { format!("{} with errors", self.wrong) };
            text = format!("{checked} checked, {verdict}\n");
        } else if self.definitions == 0 && self.unreadable.is_empty() {
            eprint!("{}", report::plain(&self.renderer, "there is no definition in what was given"));
        }
        answer(&text);
        match () {
            _ if !self.unreadable.is_empty() || self.definitions == 0 => ExitCode::from(USAGE),
            _ if self.wrong > 0 => ExitCode::from(ERRORS),
            _ => ExitCode::SUCCESS,
        }
    }
}

/// `models/src/four_bar.rs:5:1`.
fn place(found: &Found) -> String {
    let at = found.source.position(found.range.start);
    format!("{}:{}:{}", found.source.name, at.line, at.column)
}

/// The stages, errors at their places.
fn compiled(found: &Found, coordinates: Option<Coordinates>) -> Result<(Definition, Compiled), Vec<Located>> {
    compiled_with(found, coordinates, &[])
}

/// The same with more words of `emit`.
fn compiled_with(
    found: &Found,
    coordinates: Option<Coordinates>,
    emit: &[&str],
) -> Result<(Definition, Compiled), Vec<Located>> {
    if !found.errors.is_empty() {
        return Err(found.errors.clone());
    }
    let stages = || -> Result<(Definition, Compiled), Diagnostics> {
        let beside = || Some(PathBuf::from(&found.source.name));
        let definition = parse_at(found.tokens.stream.clone(), &|_| beside())?;
        let compiled = compile_with(&definition, coordinates, emit)?;
        Ok((definition, compiled))
    };
    stages().map_err(|errors| found.tokens.locate(errors))
}

/// Operations in the coordinates asked for, else in both sets, or in the one that the mechanism admits.
fn counts(
    found: &Found,
    name: Option<&str>,
    coordinates: Option<Coordinates>,
) -> Result<Vec<Row>, Vec<Located>> {
    let (definition, _) = compiled(found, coordinates)?;
    let asked =
        counts::COORDINATES.into_iter().filter(|(_, set)| coordinates.is_none_or(|asked| asked == *set));
    let sets = asked.map(|(coordinates, set)| {
        let compiled = compile_definition(&definition, Some(set))?;
        Ok(counts::rows_of(name.unwrap_or_default(), &compiled, coordinates))
    });
    let (rows, errors): (Vec<Result<Vec<Row>, Diagnostics>>, Vec<_>) = sets.partition(Result::is_ok);
    let rows: Vec<Row> = rows.into_iter().flatten().flatten().collect();
    match errors.into_iter().find_map(Result::err) {
        Some(errors) if rows.is_empty() => Err(found.tokens.locate(errors)),
        _ => Ok(rows),
    }
}
