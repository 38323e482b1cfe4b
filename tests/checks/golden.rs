//! Texts against files that hold what they were: a change shows in review as what a user would read. `UPDATE_GOLDEN=1` writes them anew.

use std::path::Path;

/// A text against the file of `tests/golden` that holds what it was.
pub fn compare_text(name: &str, text: &str) {
    compare_file(&format!("tests/golden/{name}"), text);
}

/// The same with any file of the workspace.
pub fn compare_file(name: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        std::fs::write(&path, text).expect("golden files can be written");
    }
    let golden = std::fs::read_to_string(&path).unwrap_or_default();
    if let Some((number, (old, new))) = first_difference(&golden, text) {
        panic!(
            "{name} has changed, first in line {number} of {}:\n- {old}\n+ {new}\n\
             if that is meant, write it anew with UPDATE_GOLDEN=1 and read the difference",
            path.display()
        );
    }
}

/// The first line, counted from one, in which two texts differ.
fn first_difference<'a>(old: &'a str, new: &'a str) -> Option<(usize, (&'a str, &'a str))> {
    let length = old.lines().count().max(new.lines().count());
    let (mut old, mut new) = (old.lines(), new.lines());
    let mut pairs = (1..=length).map(|n| (n, (old.next().unwrap_or("(end)"), new.next().unwrap_or("(end)"))));
    pairs.find(|(_, (old, new))| old != new)
}
