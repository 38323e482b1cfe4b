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
const MOST_LINES: usize = 640;

#[test]
fn simple_pendulum() {
    let left_out = ["condition_cosines", "condition_drift", "driver_efforts"];
    compare("simple_pendulum", "models/src/simple_pendulum.rs", "SimplePendulum", Shown::AllBut(&left_out));
}

#[test]
fn four_bar() {
    let kept = [
        "constraint_jacobian",
        "gamma",
        "acceleration_baumgarte",
        "null_space_baumgarte",
        "outputs",
        "reactions",
    ];
    compare("four_bar", "models/src/four_bar.rs", "FourBar", Shown::Only(&kept));
}

/// Parameters, and constants of the prepared model.
#[test]
fn parametric_four_bar() {
    let kept = ["prepare", "with", "mass_matrix"];
    compare("parametric_four_bar", "models/src/general_four_bar.rs", "ParametricFourBar", Shown::Only(&kept));
}

#[test]
fn spherical_pendulum() {
    let kept = ["mass_matrix", "forces", "acceleration", "kinetic_energy", "motions", "reactions"];
    compare("spherical_pendulum", "models/src/spatial_pendulums.rs", "SphericalPendulum", Shown::Only(&kept));
}

#[test]
fn gripper() {
    let kept = ["residual", "tangent"];
    compare("gripper", "tests/mechanisms/src/zoo_tangent.rs", "Gripper", Shown::Only(&kept));
}

/// Which functions are shown; of the trait `Report` none, because they call the model's own.
#[derive(Clone, Copy)]
enum Shown<'a> {
    /// With the tables.
    AllBut(&'a [&'a str]),
    /// Without the tables.
    Only(&'a [&'a str]),
}

impl Shown<'_> {
    fn shows(self, function: &str) -> bool {
        match self {
            Shown::AllBut(left_out) => !left_out.contains(&function),
            Shown::Only(kept) => kept.contains(&function),
        }
    }
}

/// The expansion of a definition in a file.
fn compare(name: &str, file: &str, mechanism: &str, shown: Shown) {
    let expansion = expansion(file, mechanism);
    assert_eq!(
        expansion,
        self::expansion(file, mechanism),
        "{name}: the same definition expands to the same bytes"
    );
    let mut items =
        syn::parse_file(&with_comments_as_macros(&expansion)).expect("the expansion is a list of items");
    let mut left_out = Vec::new();
    items.items.iter_mut().for_each(|item| keep(item, shown, &mut left_out));
    left_out.sort();
    left_out.dedup();
    let mut text = format!("// `{mechanism}` of {file}.\n");
    if !left_out.is_empty() {
        text += &format!("// Left out: {}.\n", left_out.join(", "));
    }
    text += &with_short_derives(&with_macros_as_comments(&prettyplease::unparse(&items)));
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

/// The same list of traits at every struct is worth one line.
fn with_short_derives(text: &str) -> String {
    let mut result = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        result += line;
        if line == "#[derive(" {
            let traits = lines.by_ref().take_while(|line| *line != ")]").map(str::trim);
            result += &format!("{})]", traits.collect::<Vec<_>>().join(" "));
        }
        result += "\n";
    }
    result
}

/// Leaves out functions of implementations that are not shown, and the functions that only these call.
fn keep(item: &mut Item, shown: Shown, left_out: &mut Vec<String>) {
    let Item::Const(constant) = item else { return };
    let Expr::Block(block) = &mut *constant.expr else { return };
    block.block.stmts.retain_mut(|statement| match statement {
        Stmt::Item(Item::Impl(implementation)) => {
            let of_trait = implementation.trait_.as_ref().and_then(|(path, _)| path.segments.last());
            let forwards = of_trait.is_some_and(|segment| segment.ident == "Report");
            implementation.items.retain(|item| {
                let ImplItem::Fn(function) = item else { return true };
                let name = function.sig.ident.to_string();
                let kept = !forwards && shown.shows(&name);
                if !kept && !forwards {
                    left_out.push(name);
                }
                kept
            });
            true
        }
        Stmt::Item(Item::Fn(function)) => {
            let name = function.sig.ident.to_string();
            let prefix = name.rsplit_once('_').map_or(name.as_str(), |(prefix, _)| prefix);
            prefix == "factored" || prefix.strip_suffix("_part").is_some_and(|of| shown.shows(of))
        }
        _ => true,
    });
}
