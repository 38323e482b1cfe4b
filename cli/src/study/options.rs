//! The options of the commands that move a mechanism.

use super::expression::{Expression, unknown};
use super::format::Format;
use super::methods::{Chosen, Course, FORMULATIONS, INTEGRATORS, chosen};
use super::record::Group;
use super::sweep::Over;
use super::watch::PORT;
use lexopt::Arg::{Long, Short, Value};
use std::ffi::OsString;
use std::path::PathBuf;

/// A command that moves or shows a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    Run,
    Plot,
    Animate,
    Sweep,
    Influence,
    Draw,
    Watch,
}

impl Command {
    pub const ALL: [Command; 7] = [
        Command::Run,
        Command::Plot,
        Command::Animate,
        Command::Sweep,
        Command::Influence,
        Command::Draw,
        Command::Watch,
    ];

    pub fn text(self) -> &'static str {
        match self {
            Command::Run => "run",
            Command::Plot => "plot",
            Command::Animate => "animate",
            Command::Sweep => "sweep",
            Command::Influence => "influence",
            Command::Draw => "draw",
            Command::Watch => "watch",
        }
    }

    /// The options that it has.
    fn options(self) -> Vec<&'static str> {
        let own: &[&str] = match self {
            Command::Run => &["show", "out", "json"],
            Command::Plot => &["show", "against", "out", "json"],
            Command::Animate => &["svg", "speed", "out", "json"],
            Command::Sweep => &["over", "measure", "svg", "out", "json"],
            Command::Influence => &["of", "measure", "by", "along", "svg", "against", "csv", "out", "json"],
            Command::Draw => return vec!["mechanism", "set", "dimensions", "out", "json"],
            Command::Watch => &["port"],
        };
        [&OF_A_RUN, own].concat()
    }

    fn help(self) -> &'static str {
        match self {
            Command::Run => RUN,
            Command::Plot => PLOT,
            Command::Animate => ANIMATE,
            Command::Sweep => SWEEP,
            Command::Influence => INFLUENCE,
            Command::Draw => DRAW,
            Command::Watch => WATCH,
        }
    }
}

/// What every command that moves a mechanism is told.
const OF_A_RUN: [&str; 9] =
    ["mechanism", "for", "step", "every", "formulation", "integrator", "set", "input", "native"];

const RUN: &str = "\
Moves a mechanism and writes what is measured, as comma-separated values.

usage: linkwright run [options] FILE

  --mechanism NAME        which one, where the file has several
  --for DURATION          10s if it is not given; a number is in s, or write 500ms, 2min
  --step DURATION         1ms; of dormand_prince the largest step
  --every DURATION        between lines; every step if it is not given
  --formulation NAME      baumgarte:10, or lagrange, projected, null_space, partitioned, penalty, augmented_lagrangian
  --integrator NAME       rk4, or explicit_trapezoidal, semi_implicit_euler, dormand_prince:1e-8,
                          generalised_alpha:0.8, implicit_trapezoidal, ali3p
  --set NAME=VALUE        a parameter, in its unit; may be repeated
  --input NAME=EXPRESSION an input as a function of the time t, in its unit: 'drive=2*sin(pi*t)'; or NAME=FILE.csv, FILE.csv
  --native                machine code in place of the interpreter, for long runs and large mechanisms; the same numbers
  --show LIST             of outputs, inputs, state, energy, residual, reactions, efforts, powers, motions; or all
  --out FILE              in place of standard output; a name that ends in .arrow is written as Arrow
  --json                  for machines

A summary goes to standard error. A run that fails keeps what was computed, says where it stopped, and exits with 1.
";

const PLOT: &str = "\
Plots what a run shows over time, or against another quantity, as SVG: a panel for each quantity.

usage: linkwright plot [options] FILE

  --show LIST             of outputs, inputs, energy, residual, reactions (sizes of forces), efforts; outputs if it is not given
  --against NAME          a quantity along the horizontal axis, in place of the time
  --every DURATION        between samples; 600 of them if it is not given
  --out FILE              in place of standard output; a name that ends in .png is written as PNG
  --json                  for machines: the picture as a field

--mechanism, --for, --step, --formulation, --integrator, --set, --input and --native are those of `linkwright run`.
";

const ANIMATE: &str = "\
Writes a page with the motion: a scrubber, plots that share its cursor, values where one points, the parameters. The page
fetches nothing and works from a disk.

usage: linkwright animate [options] FILE

  --svg                   a picture that plays by itself, in place of the page
  --speed FACTOR          of that picture; 0.1 is a tenth of the motion's own speed
  --every DURATION        between samples; 600 of them if it is not given
  --out FILE              NAME.html or NAME.svg if it is not given, NAME that of the mechanism
  --json                  for machines: what was written

--mechanism, --for, --step, --formulation, --integrator, --set, --input and --native are those of `linkwright run`.
";

const SWEEP: &str = "\
Runs a mechanism for each value of a parameter, on all cores, and writes what is measured of each run, as comma-separated values.

usage: linkwright sweep [options] FILE

  --over NAME=FROM..TO:COUNT   values of a parameter, in its unit; given twice, all pairs of values
  --measure EXPRESSION         max, min, mean, rms, range, first or last of a column, 'max(swing) - min(swing)'; may be repeated.
                               Columns are those of `linkwright run --show outputs,energy,residual,reactions,efforts,powers`
  --svg                        a picture: what is measured against the parameter, or over both parameters in colours
  --out FILE                   in place of standard output; a picture whose name ends in .png is written as PNG
  --json                       for machines

--mechanism, --for, --step, --every, --formulation, --integrator, --set, --input and --native are those of `linkwright run`.
";

const INFLUENCE: &str = "\
Tells by how much an output, or what is measured of a run, changes with each parameter: a table, the most influential first.

usage: linkwright influence [options] FILE

  --of NAME               an output, whose derivatives are exact, or another column of `linkwright sweep`; may be repeated;
                          all outputs if neither --of nor --measure is given. The mechanism stays assembled: at the start, with
                          its independent coordinates and their rates held
  --measure EXPRESSION    of a run, as of `linkwright sweep`, by differences with an error; may be repeated
  --by NAME               a parameter; may be repeated; all of them if it is not given
  --along                 at each sample of a run, not at the start: outputs and their exact derivatives as comma-separated values
  --svg                   of --along a plot of what +1 % of each parameter does
  --against NAME          of that plot an output along the horizontal axis, in place of the time
  --csv                   comma-separated values, in place of a table
  --out FILE              in place of standard output
  --json                  for machines

--mechanism, --for, --step, --every, --formulation, --integrator, --set, --input and --native are those of `linkwright run`.
";

const DRAW: &str = "\
Draws a mechanism at its start, as SVG.

usage: linkwright draw [options] FILE

  --mechanism NAME        which one, where the file has several
  --set NAME=VALUE        a parameter, in its unit; may be repeated
  --dimensions            lengths between the joints of each body, with the names of parameters
  --out FILE              in place of standard output; a name that ends in .png is written as PNG
  --json                  for machines: the drawing as a field
";

const WATCH: &str = "\
Shows a page on this machine that follows a file as it is edited: messages at their lines, drawing, motion, sliders for
parameters, fields for inputs. Nobody but this machine is answered.

usage: linkwright watch [options] FILE

  --port NUMBER           4180 if it is not given; 0 is any that is free

--mechanism, --for, --step, --every, --formulation, --integrator, --set, --input and --native are those of `linkwright animate`.
";

/// What a command is asked to do.
#[derive(Clone, Debug)]
pub struct Study {
    pub command: Command,
    pub file: OsString,
    /// Which of the definitions of the file.
    pub mechanism: Option<String>,
    pub course: Course,
    /// Name and value in the unit of the parameter.
    pub set: Vec<(String, f64)>,
    pub inputs: Vec<String>,
    /// Machine code in place of the interpreter.
    pub native: bool,
    pub over: Vec<Over>,
    pub measures: Vec<String>,
    /// Quantities at the start, and parameters, of `influence`.
    pub of: Vec<String>,
    pub by: Vec<String>,
    /// Along a run.
    pub along: bool,
    pub csv: bool,
    pub show: Option<Vec<Group>>,
    /// The quantity along the horizontal axis of a plot; the time if none.
    pub against: Option<String>,
    pub out: Option<PathBuf>,
    /// Lengths in a drawing.
    pub dimensions: bool,
    /// A picture in place of a page.
    pub svg: bool,
    /// Of such a picture, as a multiple of the motion's own.
    pub speed: f64,
    pub json: bool,
    /// Where `watch` listens.
    pub port: u16,
}

/// Reads what stands behind the command.
pub fn parse(
    command: Command,
    arguments: impl IntoIterator<Item = OsString>,
) -> Result<Result<Study, &'static str>, String> {
    let mut parser = lexopt::Parser::from_args(arguments);
    let mut file = None;
    let mut course = Course {
        duration: 10.0,
        step: 1e-3,
        every: None,
        formulation: Chosen { name: "baumgarte", number: None },
        integrator: Chosen { name: "rk4", number: None },
    };
    let mut study = Study {
        command,
        file: OsString::new(),
        mechanism: None,
        course: course.clone(),
        set: Vec::new(),
        inputs: Vec::new(),
        native: false,
        over: Vec::new(),
        measures: Vec::new(),
        of: Vec::new(),
        by: Vec::new(),
        along: false,
        csv: false,
        show: None,
        against: None,
        out: None,
        dimensions: false,
        svg: false,
        speed: 1.0,
        json: false,
        port: PORT,
    };
    let mut formulation_given = false;
    while let Some(argument) = parser.next().map_err(|error| error.to_string())? {
        let option = match argument {
            Short('h') | Long("help") => return Ok(Err(command.help())),
            Value(word) if file.is_none() => {
                file = Some(word);
                continue;
            }
            Value(word) => {
                let text = command.text();
                return Err(format!(
                    "{text} takes one file, and \"{}\" is a second one",
                    word.to_string_lossy()
                ));
            }
            Long(option) => option.to_string(),
            other => return Err(other.unexpected().to_string()),
        };
        if !command.options().contains(&option.as_str()) {
            let what = format!("{} has no option", command.text());
            return Err(unknown(&what, &option, command.options().iter().copied()));
        }
        let flag = match option.as_str() {
            "json" => Some(&mut study.json),
            "dimensions" => Some(&mut study.dimensions),
            "svg" => Some(&mut study.svg),
            "native" => Some(&mut study.native),
            "along" => Some(&mut study.along),
            "csv" => Some(&mut study.csv),
            _ => None,
        };
        if let Some(flag) = flag {
            *flag = true;
            continue;
        }
        let value = parser.value().map_err(|error| error.to_string())?;
        let text = value.to_string_lossy().into_owned();
        let with_name = |error: String| format!("--{option}: {error}");
        match option.as_str() {
            "against" => study.against = Some(text),
            "mechanism" => study.mechanism = Some(text),
            "for" => course.duration = seconds(&text).map_err(with_name)?,
            "step" => course.step = seconds(&text).map_err(with_name)?,
            "every" => course.every = Some(seconds(&text).map_err(with_name)?),
            "formulation" => {
                course.formulation = chosen("formulation", &text, &FORMULATIONS)?;
                formulation_given = true;
            }
            "integrator" => course.integrator = chosen("integrator", &text, &INTEGRATORS)?,
            "set" => study.set.push(setting(&text).map_err(with_name)?),
            "input" => study.inputs.push(text),
            "over" => study.over.push(Over::parse(&text)?),
            "measure" => study.measures.push(text),
            "of" => study.of.push(text),
            "by" => study.by.push(text),
            "port" => {
                let wrong = |_| format!("--port: \"{text}\" is no port: write a number from 0 to 65535");
                study.port = text.parse().map_err(wrong)?;
            }
            "speed" => {
                let number = text.parse::<f64>().ok().filter(|number| *number > 0.0 && number.is_finite());
                let wrong =
                    || format!("--speed: \"{text}\" is no speed: write 0.1 for a tenth of the motion's own");
                study.speed = number.ok_or_else(wrong)?;
            }
            "show" => study.show = Some(Group::list(&text)?),
            _ => study.out = Some(PathBuf::from(value)),
        }
    }
    if course.integrator.is_implicit() {
        if formulation_given && course.formulation.name != "lagrange" {
            return Err(format!(
                "{} solves for the constraints itself: leave --formulation out, or write lagrange",
                course.integrator
            ));
        }
        course.formulation = Chosen { name: "lagrange", number: None };
    }
    if study.speed != 1.0 && !study.svg {
        return Err("--speed is of the picture that --svg writes; a page has a choice of its own".to_string());
    }
    if command == Command::Influence {
        if study.svg && !study.along {
            return Err("--svg is of --along: what is at the start alone is no curve".to_string());
        }
        if study.against.is_some() && !study.svg {
            return Err("--against is of the plot of --along --svg".to_string());
        }
    }
    let Some(file) = file else {
        return Err(format!("{} needs a file: write its path, or `-` for standard input", command.text()));
    };
    Format::check(&study)?;
    Ok(Ok(Study { file, course, ..study }))
}

/// `name=value`, the value an expression of numbers.
fn setting(text: &str) -> Result<(String, f64), String> {
    let Some((name, value)) = text.split_once('=') else {
        return Err(format!("\"{text}\" is not `name=value`"));
    };
    let expression = Expression::parse(value)?;
    expression.check(&[], &[])?;
    Ok((name.trim().to_string(), expression.value(&|_| None)))
}

/// `10`, `10s`, `500ms`, `2min`, `20us`: s.
pub fn seconds(text: &str) -> Result<f64, String> {
    let units = [("min", 60.0), ("ms", 1e-3), ("us", 1e-6), ("µs", 1e-6), ("h", 3600.0), ("s", 1.0)];
    let unit = units.iter().find(|(unit, _)| text.ends_with(unit));
    let (number, scale) =
        unit.map_or((text, 1.0), |(unit, scale)| (&text[..text.len() - unit.len()], *scale));
    match number.trim().parse::<f64>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok(number * scale),
        Ok(_) => Err(format!("\"{text}\" is not a positive duration")),
        Err(_) => Err(format!("\"{text}\" is no duration: write 10s, 500ms, 2min, or a number of seconds")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations() {
        for (text, value) in [("10", 10.0), ("10s", 10.0), ("1e-3", 1e-3), ("2min", 120.0), ("20 us", 2e-5)] {
            assert!((seconds(text).expect(text) - value).abs() < 1e-15, "{text}");
        }
        for text in ["", "s", "-1s", "0", "inf", "1d", "ms1"] {
            assert!(seconds(text).is_err(), "{text}");
        }
        assert!((seconds("1ms").expect("one") - 1e-3).abs() < 1e-18);
    }
}
