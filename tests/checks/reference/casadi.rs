//! The Python side: a virtual environment of its own under `target/`, and the script.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

/// Python with the pinned packages, or why there is none; installed by the first test that asks.
pub fn python() -> Result<PathBuf, String> {
    static PYTHON: OnceLock<Result<PathBuf, String>> = OnceLock::new();
    PYTHON.get_or_init(installed).clone()
}

fn installed() -> Result<PathBuf, String> {
    let home = target().join("reference-venv");
    let python = home.join("bin/python");
    let requirements = scripts().join("requirements.txt");
    let marker = home.join("installed.txt");
    let wanted = std::fs::read_to_string(&requirements).map_err(|error| error.to_string())?;
    if std::fs::read_to_string(&marker).is_ok_and(|installed| installed == wanted) {
        return Ok(python);
    }
    eprintln!("installing the reference's packages into {}", home.display());
    run(Command::new("python3").args(["-m", "venv", "--clear"]).arg(&home))?;
    run(Command::new(&python)
        .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"])
        .arg(&requirements))?;
    std::fs::write(&marker, wanted).map_err(|error| error.to_string())?;
    Ok(python)
}

/// Runs the script over a folder of requests; its report, `Err` if anything disagreed.
pub fn check(python: &Path, requests: &Path, arguments: &[&str]) -> Result<String, String> {
    let mut command = Command::new(python);
    command.arg(scripts().join("check.py")).arg(requests).args(arguments);
    run(&mut command)
}

fn run(command: &mut Command) -> Result<String, String> {
    let output = command.stdin(Stdio::null()).output().map_err(|error| format!("{command:?}: {error}"))?;
    let text =
        format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    if output.status.success() { Ok(text) } else { Err(text) }
}

pub fn scripts() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference")
}

/// Cargo's target directory, from where the test itself stands.
pub fn target() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).to_path_buf()
}
