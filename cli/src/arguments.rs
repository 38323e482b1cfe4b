//! What is asked for on the command line.

use crate::flexible::{self, Import};
use crate::study::options::{self, Study};
use linkwright_compiler::export::Scalar;
use linkwright_compiler::model::Coordinates;
use linkwright_compiler::spelling::closest;
use std::ffi::OsString;
use std::path::PathBuf;

pub const HELP: &str = "\
Runs, draws, checks, explains, counts and exports definitions of mechanisms.

usage: linkwright run     [options] FILE    moves it and writes what is measured; `linkwright run --help`
       linkwright plot    [options] FILE    what a run shows over time, as SVG
       linkwright animate [options] FILE    a page with its motion
       linkwright sweep   [options] FILE    what is measured of runs with many values of a parameter
       linkwright influence [options] FILE  by how much a quantity changes with each parameter
       linkwright draw    [options] FILE    a drawing of it, as SVG
       linkwright watch   [options] FILE    a page on this machine that follows it as it is edited
       linkwright check   [options] FILE…   errors of every definition, as the macro reports them
       linkwright explain [options] FILE    what the compiler found: parts, freedoms, coordinates, start
       linkwright counts  [options] FILE    operations of every generated function
       linkwright export c [options] FILE…  every definition as a source file and a header in C99
       linkwright flexible import …         modes of a finite element model as a file; `linkwright flexible --help`

FILE is a definition (.mech), a Rust file (.rs), in which every `mechanism! { … }` and `mechanism!(file = \"…\")` is
taken, or `-` for standard input, which may be either.

options:
  --coordinates absolute|tree   in these coordinates, whatever the definition says
  --json                        for machines; the format is described in docs/command-line.md
  --scalar f64|f32              numbers of exported files: double, which is the default, or float
  --output FOLDER               where exported files go; without it, the present folder
  -h, --help                    this text
  -V, --version                 the version

Errors go to standard error, all else to standard output. Colours are used on a terminal, unless NO_COLOR is set.

exit code: 0  all is well
           1  a definition has errors, or a run failed
           2  wrong usage, a file that cannot be read, or no definition in any file
";

/// What to do with the files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    Check,
    Explain,
    Counts,
    Export,
}

impl Command {
    const ALL: [Command; 4] = [Command::Check, Command::Explain, Command::Counts, Command::Export];

    pub fn text(self) -> &'static str {
        match self {
            Command::Check => "check",
            Command::Explain => "explain",
            Command::Counts => "counts",
            Command::Export => "export",
        }
    }
}

/// A command with its files.
#[derive(Clone, Debug)]
pub struct Job {
    pub command: Command,
    pub files: Vec<OsString>,
    pub coordinates: Option<Coordinates>,
    pub json: bool,
    /// Of exported files.
    pub scalar: Scalar,
    /// Where they go.
    pub output: PathBuf,
}

/// All that can be asked for.
#[derive(Clone, Debug)]
pub enum Asked {
    Job(Job),
    Study(Box<Study>),
    Import(Import),
    /// The help of a command.
    Text(&'static str),
    Help,
    Version,
}

/// Reads the arguments behind the program's name; the error is complete but for a pointer to `--help`.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Asked, String> {
    use lexopt::Arg::{Long, Short, Value};
    let mut arguments: Vec<OsString> = arguments.into_iter().collect();
    // `help run` is `run --help`.
    if arguments.first().is_some_and(|word| word == "help") {
        arguments.remove(0);
        arguments.push("--help".into());
    }
    if let Some(study) = study_named(arguments.first()) {
        let parsed = options::parse(study, arguments.into_iter().skip(1))?;
        return Ok(parsed.map_or_else(Asked::Text, |study| Asked::Study(Box::new(study))));
    }
    if arguments.first().is_some_and(|word| word == FLEXIBLE) {
        let parsed = flexible::parse(arguments.into_iter().skip(1))?;
        return Ok(parsed.map_or(Asked::Text(flexible::HELP), Asked::Import));
    }
    let mut parser = lexopt::Parser::from_args(arguments);
    let (mut command, mut files, mut coordinates, mut json) = (None, Vec::new(), None, false);
    let (mut language, mut scalar, mut output) = (None, None, None);
    while let Some(argument) = parser.next().map_err(|error| error.to_string())? {
        match argument {
            Short('h') | Long("help") => return Ok(Asked::Help),
            Short('V') | Long("version") => return Ok(Asked::Version),
            Long("json") => json = true,
            Long("coordinates") => {
                let value = parser.value().map_err(|error| error.to_string())?;
                coordinates = Some(set(&value.to_string_lossy())?);
            }
            Long("scalar") => {
                let value = parser.value().map_err(|error| error.to_string())?;
                scalar = Some(scalar_named(&value.to_string_lossy())?);
            }
            Long("output") => output = Some(parser.value().map_err(|error| error.to_string())?),
            Value(word) if command == Some(Command::Export) && language.is_none() => {
                language = Some(is_language(&word.to_string_lossy())?);
            }
            Value(word) if command.is_none() => command = Some(named(&word.to_string_lossy())?),
            Value(file) => files.push(file),
            other => return Err(other.unexpected().to_string()),
        }
    }
    let Some(command) = command else {
        return Err(format!("no command is given: there are {ALL}"));
    };
    if command == Command::Export && language.is_none() {
        return Err("export needs a language: write `linkwright export c FILE`".into());
    }
    if command != Command::Export && (scalar.is_some() || output.is_some()) {
        return Err(format!("--scalar and --output belong to export; {} writes no files", command.text()));
    }
    match (command, files.len()) {
        (_, 0) => Err(format!("{} needs a file: write its path, or `-` for standard input", command.text())),
        (Command::Explain | Command::Counts, 2..) => {
            Err(format!("{} takes one file, {} are given", command.text(), files.len()))
        }
        _ => Ok(Asked::Job(Job {
            command,
            files,
            coordinates,
            json,
            scalar: scalar.unwrap_or_default(),
            output: output.map_or_else(PathBuf::new, PathBuf::from),
        })),
    }
}

/// The command of this name that moves or shows a mechanism.
fn study_named(word: Option<&OsString>) -> Option<options::Command> {
    let word = word?.to_str()?;
    options::Command::ALL.into_iter().find(|command| command.text() == word)
}

fn named(word: &str) -> Result<Command, String> {
    if let Some(found) = Command::ALL.into_iter().find(|command| command.text() == word) {
        return Ok(found);
    }
    if word == FLEXIBLE || study_named(Some(&word.into())).is_some() {
        return Err(format!(
            "`{word}` has options of its own: write it first, `linkwright {word} [options] FILE`"
        ));
    }
    let studies = options::Command::ALL.into_iter().map(options::Command::text);
    let near = closest(word, Command::ALL.into_iter().map(Command::text).chain(studies).chain([FLEXIBLE]));
    let meant = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
    Err(format!("no command is called \"{word}\"{meant}: there are {ALL}"))
}

/// All commands.
const ALL: &str =
    "run, plot, animate, sweep, influence, draw, watch, check, explain, counts, export and flexible";
const FLEXIBLE: &str = "flexible";

fn is_language(word: &str) -> Result<(), String> {
    match word {
        "c" | "C" => Ok(()),
        _ => Err(format!("nothing is exported to \"{word}\": there is c")),
    }
}

fn scalar_named(word: &str) -> Result<Scalar, String> {
    Scalar::named(word).ok_or_else(|| format!("no scalar is called \"{word}\": there are f64 and f32"))
}

fn set(word: &str) -> Result<Coordinates, String> {
    match word {
        "absolute" => Ok(Coordinates::Absolute),
        "tree" => Ok(Coordinates::Tree),
        _ => Err(format!("no coordinates are called \"{word}\": there are absolute and tree")),
    }
}
