//! The command line of Linkwright: `check`, `explain` and `counts` for definitions in files and in Rust sources. A shell
//! around `linkwright-compiler`, whose messages it draws.

mod arguments;
mod explain;
mod input;
mod json;
mod motion;
mod report;
mod run;
mod start;
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
        Ok(Asked::Job(job)) => run::run(&job),
        Err(error) => {
            eprintln!("error: {error}\nSee `linkwright --help`.");
            ExitCode::from(USAGE)
        }
    }
}

/// Writes the result. A reader that stops early (`| head`) is no failure.
fn answer(text: &str) -> ExitCode {
    let _ = std::io::stdout().write_all(text.as_bytes());
    ExitCode::SUCCESS
}
