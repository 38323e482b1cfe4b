//! The tables of joints in `docs/language.md` are what the records of the joints say: `UPDATE_GOLDEN=1 cargo test -p
//! linkwright-compiler --test front_end tables` writes them anew.

use linkwright_compiler::equations::VOCABULARY;
use linkwright_compiler::forms::{Argument, Form, JointForm, Need, Positional, Space, Value};
use std::fs;
use std::path::Path;

#[test]
fn joints_are_those_of_the_records() {
    compare("joints of the plane", &joints(Space::Planar));
    compare("joints of space", &joints(Space::Spatial));
}

fn joints(space: Space) -> String {
    let mut table = "| joint | arguments | holds | quantities |\n|---|---|---|---|\n".to_string();
    for joint in (VOCABULARY.joints)(space) {
        let cells = [code(joint.call.word), code(&written(&joint.call, space)), joint.holds.into()];
        table += &format!("| {} | {} |\n", cells.join(" | "), quantities(joint)).replace("|  |", "| |");
    }
    table
}

/// Positional arguments by what they are, others by name and what stands for their value.
fn written(form: &Form, space: Space) -> String {
    let positional = form.positional.iter().map(|positional| match positional {
        Positional::Place => "place".to_string(),
        Positional::Line => "line".to_string(),
        Positional::Rotor => "joint or body".to_string(),
    });
    positional.chain(form.named.iter().map(|argument| named(argument, space))).collect::<Vec<_>>().join(", ")
}

fn named(argument: &Argument, space: Space) -> String {
    let value = match (argument.value, argument.need) {
        (Value::Direction, _) => format!("({})", ["x", "y", "z"][..space.dimensions()].join(", ")),
        // What is not written is zero.
        (Value::Scalar(_) | Value::Moving(_) | Value::Diagonal(_), Need::Never) => "0".to_string(),
        (Value::Scalar(_) | Value::Moving(_) | Value::Diagonal(_), _) => "…".to_string(),
    };
    format!("{} = {value}", argument.name)
}

fn quantities(joint: &JointForm) -> String {
    let names = joint.travels.iter().chain(joint.angles).flatten();
    names.map(|name| code(name)).collect::<Vec<_>>().join(", ")
}

fn code(text: &str) -> String {
    format!("`{text}`")
}

/// A table against what stands between the comments that name it.
fn compare(name: &str, table: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/language.md");
    let page = fs::read_to_string(&path).expect("the page of the language");
    let (begin, end) = (format!("<!-- {name} -->\n"), format!("<!-- end of {name} -->\n"));
    let (before, rest) = page.split_once(&begin).expect("the comment before the table");
    let (shown, after) = rest.split_once(&end).expect("the comment behind the table");
    let expected = format!("\n{table}\n");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        if shown != expected {
            fs::write(&path, format!("{before}{begin}{expected}{end}{after}")).expect("docs can be written");
        }
        return;
    }
    assert_eq!(shown, expected, "docs/language.md: write the table anew with UPDATE_GOLDEN=1");
}
