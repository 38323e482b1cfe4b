//! `flexible import`: a finite element model to a `.flex` file, from matrices and nodes by Craig and Bampton's modes, or the modal data of MBDyn.

mod craig_bampton;
mod fem;
mod integrals;
mod market;
mod model;

#[cfg(test)]
mod tests;

use crate::{ERRORS, answer};
use linkwright_compiler::source::{self, Source};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub const HELP: &str = "\
Writes the modes of a finite element model as a file that `flexible arm(file = \"arm.flex\")` takes.

usage: linkwright flexible import [options] MASS.mtx STIFFNESS.mtx NODES.csv
       linkwright flexible import [--out FILE] MODES.fem

  --held LIST        nodes that do not move in the frame of the file: 1,2,3
  --interface LIST   nodes that joints and loads may take beside these; each has six modes of its own
  --modes NUMBER     natural modes with all of these clamped, the slowest; 0 if it is not given
  --out FILE         in place of standard output

Matrices are in Matrix Market's format, six rows for each node in the order of the nodes: along x, y, z and about x, y, z.
A line of nodes has its number and x, y, z. Units are those of SI. Masses are lumped: no row along an axis is coupled to
another one, or to one about an axis, but by m times the same for x, y and z. MODES.fem is modal data of MBDyn with lumped
masses (record group 11). The format is described in docs/flex-format.md.
";

/// What is asked for.
#[derive(Clone, Debug)]
pub struct Import {
    from: From,
    out: Option<PathBuf>,
}

/// What a finite element code has left.
#[derive(Clone, Debug)]
enum From {
    Matrices {
        mass: PathBuf,
        stiffness: PathBuf,
        nodes: PathBuf,
        held: Vec<u64>,
        interface: Vec<u64>,
        modes: usize,
    },
    Modes(PathBuf),
}

/// The arguments behind `flexible`; `None` asks for help.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Option<Import>, String> {
    use lexopt::Arg::{Long, Short, Value};
    let mut parser = lexopt::Parser::from_args(arguments);
    let (mut held, mut interface, mut modes, mut out) = (None, None, None, None);
    let (mut import, mut files) = (false, Vec::new());
    while let Some(argument) = parser.next().map_err(|error| error.to_string())? {
        match argument {
            Short('h') | Long("help") => return Ok(None),
            Long("held") => held = Some(list("held", &value(&mut parser)?.to_string_lossy())?),
            Long("interface") => interface = Some(list("interface", &value(&mut parser)?.to_string_lossy())?),
            Long("modes") => {
                let word = value(&mut parser)?.to_string_lossy().into_owned();
                let number =
                    word.parse().map_err(|_| format!("--modes takes a whole number, found \"{word}\""))?;
                modes = Some(number);
            }
            Long("out") => out = Some(PathBuf::from(value(&mut parser)?)),
            Value(word) if !import && word == "import" => import = true,
            Value(word) if !import => {
                let word = word.to_string_lossy().into_owned();
                return Err(format!("`flexible` knows `import` and nothing else, found \"{word}\""));
            }
            Value(file) => files.push(PathBuf::from(file)),
            other => return Err(other.unexpected().to_string()),
        }
    }
    let from = match <[PathBuf; 3]>::try_from(files) {
        Ok([mass, stiffness, nodes]) => {
            let Some(held) = held else {
                let what = "--held names the nodes that have the frame, at least one: write `--held 1`";
                return Err(what.to_string());
            };
            let (interface, modes) = (interface.unwrap_or_default(), modes.unwrap_or(0));
            From::Matrices { mass, stiffness, nodes, held, interface, modes }
        }
        Err(files) => {
            let file = of_modes(files)?;
            let given = [
                ("--held", held.is_some()),
                ("--interface", interface.is_some()),
                ("--modes", modes.is_some()),
            ];
            if let Some((option, _)) = given.into_iter().find(|(_, given)| *given) {
                return Err(format!(
                    "`{}` has its modes, and takes no {option}: leave it out",
                    file.display()
                ));
            }
            From::Modes(file)
        }
    };
    Ok(Some(Import { from, out }))
}

/// The one file of modes there is, of a kind that is read.
fn of_modes(files: Vec<PathBuf>) -> Result<PathBuf, String> {
    let count = files.len();
    let Ok([file]) = <[PathBuf; 1]>::try_from(files) else {
        return Err(format!(
            "flexible import takes three files or one, {count} are given: `linkwright flexible import M.mtx K.mtx nodes.csv`, or `modes.fem`"
        ));
    };
    let kind = file.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    match kind.as_str() {
        "fem" => Ok(file),
        "sid_fem" | "sid" => Err(format!(
            "`{}` is standard input data (SID, Wallrapp 1994), which has the tensor of inertia to the first order in the modes alone; M takes \
             ∫ φ_j φ_kᵀ dm whole: write mass, stiffness and nodes, `linkwright flexible import M.mtx K.mtx nodes.csv`",
            file.display()
        )),
        "mnf" => Err(format!(
            "`{}` is a modal neutral file, whose format is not published: write mass, stiffness and nodes, `linkwright flexible import M.mtx K.mtx \
             nodes.csv`",
            file.display()
        )),
        _ => Err(format!(
            "`{}` alone is no modal data: its name ends in .fem (MBDyn), or three files are given, `linkwright flexible import M.mtx K.mtx nodes.csv`",
            file.display()
        )),
    }
}

fn value(parser: &mut lexopt::Parser) -> Result<OsString, String> {
    parser.value().map_err(|error| error.to_string())
}

fn list(option: &str, words: &str) -> Result<Vec<u64>, String> {
    let number = |word: &str| {
        word.trim()
            .parse()
            .map_err(|_| format!("--{option} takes numbers of nodes, such as 1,17; found \"{word}\""))
    };
    words.split(',').map(number).collect()
}

/// Writes the file; tells what is wrong.
pub fn import(asked: &Import) -> ExitCode {
    match text(asked) {
        Ok(text) => match &asked.out {
            None => answer(text),
            Some(path) => match std::fs::write(path, text) {
                Ok(()) => ExitCode::SUCCESS,
                Err(error) => fail(&format!("`{}` cannot be written: {error}", path.display())),
            },
        },
        Err(message) => fail(&message),
    }
}

fn fail(message: &str) -> ExitCode {
    eprintln!("error: {message}");
    ExitCode::from(ERRORS)
}

fn text(asked: &Import) -> Result<String, String> {
    let read = |path: &Path| {
        std::fs::read_to_string(path).map_err(|error| format!("`{}` cannot be read: {error}", path.display()))
    };
    let (reduced, about) = match &asked.from {
        From::Matrices { mass, stiffness, nodes, held, interface, modes } => {
            let matrix = |path: &Path| market::read(&path.display().to_string(), &read(path)?);
            let [m, k] = [matrix(mass)?, matrix(stiffness)?];
            let placed = model::nodes(&nodes.display().to_string(), &read(nodes)?)?;
            let model = model::Model::new(placed, &m, &k)?;
            let about = format!(
                "Craig and Bampton's modes of {}, {}: held {held:?}, interface {interface:?}, {modes} natural modes.",
                mass.display(),
                stiffness.display()
            );
            (craig_bampton::reduced(&model, held, interface, *modes)?, about)
        }
        From::Modes(path) => {
            let name = path.display().to_string();
            (fem::read(&name, &read(path)?)?, format!("The modes of {name}."))
        }
    };
    let text = reduced.text(&about);
    // What is written keeps to the rules of what is read.
    source::modes(&Source::new("what would be written", text.clone()))?;
    Ok(text)
}
