//! Files → definitions with their places.

use linkwright_compiler::file::{self, Named};
use linkwright_compiler::source::{self, Invocation, Located, Source, Tokens};
use std::ffi::OsStr;
use std::io::Read;
use std::ops::Range;
use std::path::Path;
use std::rc::Rc;

/// A definition that was found.
#[derive(Clone, Debug)]
pub struct Found {
    /// The text in which it stands.
    pub source: Rc<Source>,
    /// Where in it.
    pub range: Range<usize>,
    pub tokens: Tokens,
    /// What of it is no token; then it is not read any further.
    pub errors: Vec<Located>,
}

/// The definitions of a file, in the order written; the error is one of reading it.
pub fn definitions(path: &OsStr) -> Result<Vec<Found>, String> {
    let source = Rc::new(read(path)?);
    let is_rust = match Path::new(path).extension().and_then(OsStr::to_str) {
        Some("rs") => true,
        Some("mech") => false,
        _ => source::is_rust(&source),
    };
    if !is_rust {
        return Ok(vec![whole(source)]);
    }
    match source::invocations(&source) {
        Ok(invocations) => Ok(invocations.into_iter().map(|one| resolve(&source, one)).collect()),
        Err(error) => {
            let range = error.range.clone();
            Ok(vec![Found { source, range, tokens: Tokens::default(), errors: vec![error] }])
        }
    }
}

fn read(path: &OsStr) -> Result<Source, String> {
    if path != "-" {
        return file::open(Path::new(path));
    }
    let mut bytes = Vec::new();
    let read = std::io::stdin().lock().read_to_end(&mut bytes);
    read.map_err(|error| format!("standard input cannot be read: {error}"))?;
    file::text("standard input", bytes)
}

/// A text that is one definition.
fn whole(source: Rc<Source>) -> Found {
    let (tokens, errors) = source::definition(&source);
    let range = 0..source.text.len();
    Found { source, range, tokens, errors }
}

/// The definition that a macro holds, or that the file holds which it names.
fn resolve(source: &Rc<Source>, Invocation { range, tokens, errors }: Invocation) -> Found {
    let here =
        |errors| Found { source: source.clone(), range: range.clone(), tokens: tokens.clone(), errors };
    match file::named(&tokens.stream) {
        _ if !errors.is_empty() => here(errors),
        None => here(Vec::new()),
        Some(Err(errors)) => here(tokens.locate(errors)),
        Some(Ok(Named { name, region })) => match file::read(&name, Some(Path::new(&source.name))) {
            Ok(named) => whole(Rc::new(named)),
            Err(message) => here(vec![Located::new(tokens.place(region), message)]),
        },
    }
}
