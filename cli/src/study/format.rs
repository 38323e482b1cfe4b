//! What a file is written as, which the end of its name says, and whether this program has been built with it.

use super::options::Study;
use std::path::Path;

/// What a file is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// What the command writes to standard output.
    Text,
    Png,
    Arrow,
}

impl Format {
    /// What the end of a name asks for.
    pub fn of(path: Option<&Path>) -> Format {
        let end = path.and_then(Path::extension).map(|end| end.to_string_lossy().to_lowercase());
        match end.as_deref() {
            Some("png") => Format::Png,
            Some("arrow" | "feather") => Format::Arrow,
            _ => Format::Text,
        }
    }

    /// Why it cannot be written by this command of this program, which is better known before a run than after it.
    pub fn check(study: &Study) -> Result<(), String> {
        use super::options::Command::{Draw, Influence, Plot, Run, Sweep};
        let format = Format::of(study.out.as_deref());
        let command = study.command;
        let (is_of_command, is_built) = match format {
            Format::Text => (true, true),
            Format::Png => (
                matches!(command, Draw | Plot) || matches!(command, Influence | Sweep) && study.svg,
                cfg!(feature = "png"),
            ),
            Format::Arrow => (command == Run, cfg!(feature = "arrow")),
        };
        let (name, instead) = match format {
            Format::Arrow => ("Arrow", "comma-separated values: a name that ends in .csv"),
            _ => ("PNG", "SVG: a name that ends in .svg"),
        };
        if !is_of_command {
            return Err(format!("--out: {} writes no {name}; give the file another name", command.text()));
        }
        if !is_built {
            let feature = name.to_lowercase();
            return Err(format!(
                "--out: this program has been built without {name}; install it with `--features {feature}`, or write {instead}"
            ));
        }
        Ok(())
    }
}
