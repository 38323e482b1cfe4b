//! The tables of bodies and joints in `docs/language.md` are what their records say: `UPDATE_GOLDEN=1 cargo test -p
//! linkwright-compiler --test front_end tables` writes them anew.

use linkwright_compiler::equations::VOCABULARY;
use linkwright_compiler::forms::{
    Argument, BodyForm, Form, JointForm, Moment, Need, Positional, Solid, Space, Value,
};
use std::fs;
use std::path::Path;

#[test]
fn tables_are_those_of_the_records() {
    compare("bodies of the plane", &bodies(Space::Planar));
    compare("bodies of space", &bodies(Space::Spatial));
    compare("joints of the plane", &joints(Space::Planar));
    compare("joints of space", &joints(Space::Spatial));
    compare("toothings", &toothings());
}

fn bodies(space: Space) -> String {
    let mut table = "| body | is | properties | inertia about the centre |\n|---|---|---|---|\n".to_string();
    for body in VOCABULARY.bodies {
        let Some(solid) = body.solid(space) else { continue };
        let cells = [code(body.word), body.is.into(), properties(body, solid), inertia(body, solid, space)];
        table += &format!("| {} |\n", cells.join(" | "));
    }
    table
}

/// What must be stated, then what may be.
fn properties(body: &BodyForm, solid: &Solid) -> String {
    if body.is_modal() {
        return "its file".to_string();
    }
    let mut names = vec![code("mass")];
    if solid.has_size() {
        names.push("`size = (a, b, c)`".to_string());
    }
    let own = |needed: bool| {
        let own = solid.lengths.iter().filter(move |length| length.of_size.is_none());
        own.filter(move |length| (length.need == Need::Always) == needed).map(|length| length.name)
    };
    names.extend(own(true).map(code));
    names.extend(solid.moments.is_none().then(|| code("inertia")));
    names.extend(body.states_center.then(|| "`center` unless 0".to_string()));
    names.extend(own(false).map(|name| format!("`{name}` unless 0")));
    names.join(", ")
}

/// `m (3 radius² + length²)/12`, about each axis in space.
fn inertia(body: &BodyForm, solid: &Solid, space: Space) -> String {
    if body.is_modal() {
        return "that of its file".to_string();
    }
    let Some(moments) = &solid.moments else { return "as written".to_string() };
    let edge = |name: &str| match solid.lengths.iter().find(|length| length.name == name) {
        Some(length) => length.of_size.map_or(name, |component| ["a", "b", "c"][component]).to_string(),
        None => name.to_string(),
    };
    let formula = |moment: &Moment| {
        if moment.squares.is_empty() {
            return "that of its section".to_string();
        }
        let term = |(factor, name): &(f64, &str)| match *factor {
            1.0 => format!("{}²", edge(name)),
            factor => format!("{factor} {}²", edge(name)),
        };
        let terms: Vec<String> = moment.squares.iter().map(term).collect();
        let sum = if terms.len() > 1 { format!("({})", terms.join(" + ")) } else { terms.concat() };
        format!("m {sum}/{}", moment.divisor)
    };
    match space {
        _ if !body.turns => "none: it has no orientation".to_string(),
        Space::Planar => formula(&moments[2]),
        Space::Spatial => moments.iter().map(formula).collect::<Vec<_>>().join(", "),
    }
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
        Positional::Places => "…".to_string(),
        Positional::Line => "line".to_string(),
        Positional::Rotor => "joint or body".to_string(),
        Positional::Toothing => "toothing".to_string(),
        Positional::Expression => "expression".to_string(),
    });
    positional.chain(form.named.iter().map(|argument| named(argument, space))).collect::<Vec<_>>().join(", ")
}

fn named(argument: &Argument, space: Space) -> String {
    let value = match (argument.value, argument.need) {
        (Value::Direction, _) => format!("({})", ["x", "y", "z"][..space.dimensions()].join(", ")),
        // What is not written is zero.
        (Value::Scalar(_) | Value::Moving(_) | Value::Diagonal(_), Need::Never) => "0".to_string(),
        (Value::Scalar(_) | Value::Moving(_) | Value::Diagonal(_), _) => "…".to_string(),
        (Value::Law(_) | Value::Along { .. }, Need::Never) => "0".to_string(),
        (Value::Law(_) | Value::Along { .. }, _) => "…".to_string(),
        (Value::Varying(_) | Value::RateOf { .. }, _) => "…".to_string(),
        (
            Value::Way | Value::Stiffness | Value::Exponent | Value::Backbone | Value::OfGap | Value::Word,
            _,
        ) => "…".to_string(),
        (Value::Outline, _) => "table".to_string(),
        (Value::OfParameter(_), Need::Never) => "parameter".to_string(),
        (Value::OfParameter(_), _) => "…".to_string(),
        (Value::TeethStiffness | Value::TeethDamping, _) => "…".to_string(),
    };
    format!("{} = {value}", argument.name)
}

fn toothings() -> String {
    let mut table = "| toothing | is | arguments |\n|---|---|---|\n".to_string();
    for toothing in VOCABULARY.toothings {
        let arguments = toothing.call.named.iter().map(|argument| match argument.need {
            Need::Never => format!("`{}`", argument.name),
            Need::Always | Need::UnlessMarked => format!("`{} = …`", argument.name),
        });
        let arguments = arguments.collect::<Vec<_>>().join(", ");
        table += &format!("| {} | {} | {arguments} |\n", code(toothing.call.word), toothing.is);
    }
    table
}

fn quantities(joint: &JointForm) -> String {
    let names = joint.travels.iter().chain(joint.angles).flatten().copied();
    names.chain(joint.effort()).map(code).collect::<Vec<_>>().join(", ")
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
