//! The code that is emitted for small models, one of them with its derivatives, as `tests/golden/*.rs` has it: a change of
//! emitted code shows in review as what a user would read. `UPDATE_GOLDEN=1 cargo test --test expansions` writes them anew.
//!
//! The text is formatted by `prettyplease`, with its comments, and of the larger models some functions are kept only.

#[path = "checks/golden.rs"]
mod golden;

use golden::compare_text;
use linkwright_compiler::source::{Source, invocations};
use linkwright_compiler::{Expansion, expand};
use std::path::Path;
use syn::{Expr, ImplItem, Item, Stmt};

/// What a person reads in a review.
const MOST_LINES: usize = 600;

#[test]
fn simple_pendulum() {
    compare("simple_pendulum", "models/src/simple_pendulum.rs", "SimplePendulum", None);
}

#[test]
fn four_bar() {
    let kept = [
        "mass_matrix",
        "constraint_jacobian",
        "gamma",
        "acceleration_baumgarte",
        "outputs",
        "motions",
        "reactions",
    ];
    compare("four_bar", "models/src/four_bar.rs", "FourBar", Some(&kept));
}

/// Parameters, and constants of the prepared model.
#[test]
fn parametric_four_bar() {
    let kept = ["prepare", "with", "mass_matrix"];
    compare("parametric_four_bar", "models/src/general_four_bar.rs", "ParametricFourBar", Some(&kept));
}

#[test]
fn spherical_pendulum() {
    let kept = ["mass_matrix", "forces", "acceleration", "kinetic_energy", "motions", "reactions"];
    compare("spherical_pendulum", "models/src/spatial_pendulums.rs", "SphericalPendulum", Some(&kept));
}

#[test]
fn gripper() {
    let kept = ["residual", "tangent"];
    compare("gripper", "tests/mechanisms/src/zoo_tangent.rs", "Gripper", Some(&kept));
}

/// The expansion of a definition in a file; `kept`: the functions that are shown, if not all.
fn compare(name: &str, file: &str, mechanism: &str, kept: Option<&[&str]>) {
    let expansion = expansion(file, mechanism);
    assert_eq!(
        expansion,
        self::expansion(file, mechanism),
        "{name}: the same definition expands to the same bytes"
    );
    let mut items =
        syn::parse_file(&with_comments_as_macros(&expansion)).expect("the expansion is a list of items");
    let mut left_out = Vec::new();
    if let Some(kept) = kept {
        items.items.iter_mut().for_each(|item| keep(item, kept, &mut left_out));
        left_out.sort();
        left_out.dedup();
    }
    let mut text = format!("// `{mechanism}` of {file}.\n");
    if !left_out.is_empty() {
        text += &format!("// Left out: {}.\n", left_out.join(", "));
    }
    text += &with_macros_as_comments(&prettyplease::unparse(&items));
    let lines = text.lines().count();
    assert!(lines <= MOST_LINES, "{name}: {lines} lines");
    compare_text(&format!("{name}.rs"), &text);
}

fn expansion(file: &str, mechanism: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let source = Source::new(file, std::fs::read_to_string(path).expect("sources are text"));
    for invocation in invocations(&source).expect("it is read") {
        match expand(invocation.tokens.stream, |_| None) {
            Expansion::Items { text, .. } if text.contains(&format!("struct {mechanism}<")) => return text,
            Expansion::Items { .. } => {}
            Expansion::Errors(errors) => panic!("{errors}"),
        }
    }
    panic!("{mechanism} is not in {file}")
}

/// Comments are no tokens; in bodies of functions macros stand for them.
fn with_comments_as_macros(text: &str) -> String {
    let line = |line: &str| match line.strip_prefix("// ") {
        Some(comment) => format!("comment!(r#\"{comment}\"#);\n"),
        None => format!("{line}\n"),
    };
    text.lines().map(line).collect()
}

/// A long one is broken into three lines.
fn with_macros_as_comments(text: &str) -> String {
    let mut result = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        let Some((indent, rest)) = line.split_once("comment!(") else {
            result += &format!("{line}\n");
            continue;
        };
        let literal = if rest.is_empty() { lines.next().unwrap_or_default() } else { rest };
        let comment =
            literal.trim().trim_start_matches("r#\"").trim_end_matches(");").trim_end_matches("\"#");
        result += &format!("{indent}// {comment}\n");
        if rest.is_empty() {
            lines.next();
        }
    }
    result
}

/// Leaves out functions of implementations that are not kept, and the functions that only these call.
fn keep(item: &mut Item, kept: &[&str], left_out: &mut Vec<String>) {
    let Item::Const(constant) = item else { return };
    let Expr::Block(block) = &mut *constant.expr else { return };
    let is_kept = |name: &str| kept.contains(&name);
    let is_part =
        |name: &str| name == "factored" || kept.iter().any(|kept| name.strip_suffix("_part") == Some(kept));
    block.block.stmts.retain_mut(|statement| match statement {
        Stmt::Item(Item::Impl(implementation)) => {
            implementation.items.retain(|item| match item {
                ImplItem::Fn(function) if !is_kept(&function.sig.ident.to_string()) => {
                    left_out.push(function.sig.ident.to_string());
                    false
                }
                _ => true,
            });
            true
        }
        Stmt::Item(Item::Fn(function)) => {
            let name = function.sig.ident.to_string();
            is_part(name.rsplit_once('_').map_or(name.as_str(), |(prefix, _)| prefix))
        }
        _ => true,
    });
}
