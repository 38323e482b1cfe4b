//! What is asked for on the command line.

use linkwright_compiler::model::Coordinates;
use std::ffi::OsString;

pub const HELP: &str = "\
Checks, explains and counts definitions of mechanisms.

usage: linkwright check   [options] FILE…   errors of every definition, as the macro reports them
       linkwright explain [options] FILE    what the compiler found: parts, freedoms, coordinates, start
       linkwright counts  [options] FILE    operations of every generated function

FILE is a definition (.mech), a Rust file (.rs), in which every `mechanism! { … }` and `mechanism!(file = \"…\")` is
taken, or `-` for standard input, which may be either.

options:
  --coordinates absolute|tree   in these coordinates, whatever the definition says
  --json                        for machines; the format is described in docs/command-line.md
  -h, --help                    this text
  -V, --version                 the version

Errors go to standard error, all else to standard output. Colours are used on a terminal, unless NO_COLOR is set.

exit code: 0  all definitions are well
           1  a definition has errors
           2  wrong usage, a file that cannot be read, or no definition in any file
";

/// What to do with the files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    Check,
    Explain,
    Counts,
}

impl Command {
    const ALL: [Command; 3] = [Command::Check, Command::Explain, Command::Counts];

    pub fn text(self) -> &'static str {
        match self {
            Command::Check => "check",
            Command::Explain => "explain",
            Command::Counts => "counts",
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
}

/// All that can be asked for.
#[derive(Clone, Debug)]
pub enum Asked {
    Job(Job),
    Help,
    Version,
}

/// Reads the arguments behind the program's name; the error is complete but for a pointer to `--help`.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Asked, String> {
    use lexopt::Arg::{Long, Short, Value};
    let mut parser = lexopt::Parser::from_args(arguments);
    let (mut command, mut files, mut coordinates, mut json) = (None, Vec::new(), None, false);
    while let Some(argument) = parser.next().map_err(|error| error.to_string())? {
        match argument {
            Short('h') | Long("help") => return Ok(Asked::Help),
            Short('V') | Long("version") => return Ok(Asked::Version),
            Long("json") => json = true,
            Long("coordinates") => {
                let value = parser.value().map_err(|error| error.to_string())?;
                coordinates = Some(set(&value.to_string_lossy())?);
            }
            Value(word) if command.is_none() => command = Some(named(&word.to_string_lossy())?),
            Value(file) => files.push(file),
            other => return Err(other.unexpected().to_string()),
        }
    }
    let Some(command) = command else {
        return Err("no command is given: write check, explain or counts".into());
    };
    match (command, files.len()) {
        (_, 0) => Err(format!("{} needs a file: write its path, or `-` for standard input", command.text())),
        (Command::Explain | Command::Counts, 2..) => {
            Err(format!("{} takes one file, {} are given", command.text(), files.len()))
        }
        _ => Ok(Asked::Job(Job { command, files, coordinates, json })),
    }
}

fn named(word: &str) -> Result<Command, String> {
    let found = Command::ALL.into_iter().find(|command| command.text() == word);
    found.ok_or_else(|| format!("no command is called \"{word}\": there are check, explain and counts"))
}

fn set(word: &str) -> Result<Coordinates, String> {
    match word {
        "absolute" => Ok(Coordinates::Absolute),
        "tree" => Ok(Coordinates::Tree),
        _ => Err(format!("no coordinates are called \"{word}\": there are absolute and tree")),
    }
}
