//! The expansions of small models, one of them with its derivatives, formatted, against `tests/golden/*.rs`: a change of emitted code shows in
//! review as what a user would read. `UPDATE_GOLDEN=1 cargo test --test checks golden` writes them anew.

use crate::registry::Model;
use crate::zoo_tangent::Gripper;
use linkwright_compiler::{Expansion, expand};
use linkwright_models::four_bar::FourBar;
use linkwright_models::general_four_bar::ParametricFourBar;
use linkwright_models::simple_pendulum::SimplePendulum;
use linkwright_models::spatial_pendulums::SphericalPendulum;
use std::path::Path;

#[test]
fn simple_pendulum() {
    compare::<SimplePendulum>("simple_pendulum");
}

#[test]
fn four_bar() {
    compare::<FourBar>("four_bar");
}

#[test]
fn parametric_four_bar() {
    compare::<ParametricFourBar>("parametric_four_bar");
}

#[test]
fn spherical_pendulum() {
    compare::<SphericalPendulum>("spherical_pendulum");
}

#[test]
fn gripper() {
    compare::<Gripper>("gripper");
}

fn compare<M: Model>(name: &str) {
    let expansion = expansion::<M>();
    assert_eq!(expansion, self::expansion::<M>(), "{name}: the same definition expands to the same bytes");
    let file = syn::parse_file(&expansion).expect("the expansion is a list of items");
    compare_text(&format!("{name}.rs"), &prettyplease::unparse(&file));
}

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

fn expansion<M: Model>() -> String {
    match expand(M::SOURCE.parse().expect("the source was tokens"), |_| None) {
        Expansion::Items { text, .. } => text,
        Expansion::Errors(errors) => panic!("{errors}"),
    }
}

/// The first line, counted from one, in which two texts differ.
fn first_difference<'a>(old: &'a str, new: &'a str) -> Option<(usize, (&'a str, &'a str))> {
    let length = old.lines().count().max(new.lines().count());
    let (mut old, mut new) = (old.lines(), new.lines());
    let mut pairs = (1..=length).map(|n| (n, (old.next().unwrap_or("(end)"), new.next().unwrap_or("(end)"))));
    pairs.find(|(_, (old, new))| old != new)
}
