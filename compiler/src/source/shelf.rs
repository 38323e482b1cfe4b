//! Parts that stand outside of a definition: files that it names, and the library.

use super::{Source, disk, snippet, tokens::definition_at};
use crate::syntax::{self, FileTerm, OnDisk, PartText};
use proc_macro2::Span;
use std::path::PathBuf;

/// The file that a token stands in, where that is known.
pub type FileOf<'a> = &'a dyn Fn(Span) -> Option<PathBuf>;

/// The parts of the library and their texts.
const LIBRARY: [(&str, &str, &str); 4] = [
    ("DcMotor", "dc_motor.mech", include_str!("../../parts/dc_motor.mech")),
    ("HydraulicCylinder", "hydraulic_cylinder.mech", include_str!("../../parts/hydraulic_cylinder.mech")),
    ("Strut", "strut.mech", include_str!("../../parts/strut.mech")),
    ("Tyre", "tyre.mech", include_str!("../../parts/tyre.mech")),
];

/// The names of the library's parts.
pub const PARTS: [&str; LIBRARY.len()] = {
    let mut names = [""; LIBRARY.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = LIBRARY[at].0;
        at += 1;
    }
    names
};

/// The text of a part of the library.
pub fn library(part: &str) -> Option<&'static str> {
    LIBRARY.iter().find(|(name, ..)| *name == part).map(|(_, _, text)| *text)
}

/// What is beside the files that tokens stand in, and the library.
pub(crate) struct Shelf<'a> {
    pub file_of: FileOf<'a>,
}

impl syntax::Shelf for Shelf<'_> {
    fn file(&self, file: &FileTerm) -> Result<PartText, String> {
        let caller = (self.file_of)(file.region.start);
        let source = disk::read(&file.name, caller.as_deref())?;
        let on_disk = disk::on_disk(&source, caller)?;
        text(source, Some(on_disk), file.region.start)
    }

    fn library(&self, part: &str) -> Option<PartText> {
        let (_, file, own) = LIBRARY.iter().find(|(name, ..)| *name == part)?;
        text(Source::new(format!("the library's {file}"), *own), None, Span::call_site()).ok()
    }

    fn names(&self) -> &[&'static str] {
        &PARTS
    }
}

fn text(source: Source, on_disk: Option<OnDisk>, span: Span) -> Result<PartText, String> {
    let (tokens, errors) = definition_at(&source, span);
    match errors.first() {
        Some(error) => Err(snippet::text(&source, error)),
        None => Ok(PartText {
            tokens: tokens.stream,
            shown: source.name,
            on_disk,
            text: source.text,
            places: tokens.places,
        }),
    }
}
