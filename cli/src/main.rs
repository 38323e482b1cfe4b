//! The command line of Linkwright: `run` and `draw`, `check`, `explain`, `counts` and `export` for definitions in files and in Rust
//! sources, and `flexible` for the modes that they name. A shell around `linkwright-compiler`, whose messages it draws, and `linkwright-engine`.

mod arguments;
mod explain;
mod flexible;
mod input;
mod json;
mod motion;
mod report;
mod run;
mod start;
mod study;
mod text;

use arguments::Asked;
use std::io::Write;
use std::process::ExitCode;

/// Exit codes beside 0; `--help` tells them.
const ERRORS: u8 = 1;
const USAGE: u8 = 2;

fn main() -> ExitCode {
    match arguments::parse(std::env::args_os().skip(1)) {
        Ok(Asked::Help) => answer(arguments::HELP),
        Ok(Asked::Version) => answer(concat!("linkwright ", env!("CARGO_PKG_VERSION"), "\n")),
        Ok(Asked::Text(text)) => answer(text),
        Ok(Asked::Job(job)) => run::run(&job),
        Ok(Asked::Import(asked)) => flexible::import(&asked),
        Ok(Asked::Study(study)) => study::study(&study),
        Err(error) => {
            eprintln!("error: {error}\nSee `linkwright --help`.");
            ExitCode::from(USAGE)
        }
    }
}

/// Writes the result. A reader that stops early (`| head`) is no failure.
fn answer(content: impl AsRef<[u8]>) -> ExitCode {
    let _ = std::io::stdout().write_all(content.as_ref());
    ExitCode::SUCCESS
}
