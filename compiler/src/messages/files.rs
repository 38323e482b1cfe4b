//! Texts about files that hold definitions, and about the characters in them.

pub(crate) fn foreign_character(character: char) -> String {
    let instead = match character {
        '−' | '–' | '—' => "write the minus sign `-`",
        '×' | '·' | '⋅' => "write `*`",
        '÷' => "write `/`",
        '²' => "write `^2`",
        '³' => "write `^3`",
        '°' => "write the unit, such as `[deg]`",
        '“' | '”' | '„' => "write `\"`",
        '≤' => "write `<=`",
        '≥' => "write `>=`",
        '≠' => "write `!=`",
        _ => "leave it out",
    };
    format!("the character {character:?} has no meaning here: {instead}")
}

pub(crate) fn unterminated(what: &str, end: &str) -> String {
    format!("this {what} never ends: write `{end}` where it does")
}

pub(crate) fn lone_quote() -> String {
    "a `'` alone has no meaning here: names consist of letters, digits and `_`, texts stand in `\"`"
        .to_string()
}

pub(crate) fn not_a_literal(text: &str) -> String {
    format!("`{text}` is not a literal of Rust")
}

pub(crate) fn nothing_to_close(opening: char, closing: char) -> String {
    format!(
        "this `{closing}` closes nothing: leave it out, or write the `{opening}` that it belongs to before it"
    )
}

pub(crate) fn wrong_delimiter(found: char, (opening, closing): (char, char)) -> String {
    format!("this `{found}` stands where a `{opening}` is still open: write `{closing}` before it")
}

pub(crate) fn opened_here(opening: char) -> String {
    format!("the `{opening}` is opened here")
}

pub(crate) fn never_closed((opening, closing): (char, char)) -> String {
    format!("this `{opening}` is never closed: write `{closing}` where it ends")
}

pub(crate) fn closes_askew((opening, closing): (&str, &str), line: usize) -> String {
    format!(
        "this `{closing}` closes the `{opening}` of line {line}, which is indented otherwise: one may be missing there"
    )
}

pub(crate) fn written_by_macro() -> String {
    "in what this macro writes".to_string()
}

pub(crate) fn macro_not_followed(name: &str) -> String {
    format!(
        "what `{name}!` writes here cannot be told without rustc, so the definition in it is not checked: no rule of it fits, \
         it takes more than `ident`, `tt`, `literal`, `meta`, `lifetime`, `vis`, `block` and `expr`, or it calls itself too often"
    )
}

pub(crate) fn file_without_name() -> String {
    "a definition in a file is named by a string: write `mechanism!(file = \"arm.mech\")`".to_string()
}

pub(crate) fn file_and_more() -> String {
    "nothing else stands beside the name of the file; the definition is in it".to_string()
}

pub(crate) fn file_in_file() -> String {
    "a file holds the definition itself, it does not name another: write `planar Name { … }` or `spatial Name { … }`"
        .to_string()
}

pub(crate) fn macro_in_file() -> String {
    "a file holds what stands inside of `mechanism! { … }`: leave `mechanism! {` and its `}` out".to_string()
}

/// `from` says where its path begins.
pub(crate) fn no_file(path: &str, from: &str, similar: Option<&str>) -> String {
    let hint = match similar {
        Some(similar) => format!("; did you mean \"{similar}\"?"),
        None => ".".to_string(),
    };
    format!("there is no file `{path}`{hint} Paths are taken {from}")
}

pub(crate) fn is_directory(path: &str) -> String {
    format!("`{path}` is a directory: name a file in it")
}

pub(crate) fn unreadable_file(path: &str, error: &str) -> String {
    format!("`{path}` cannot be read: {error}")
}

pub(crate) fn not_utf8(path: &str, line: usize, column: usize) -> String {
    format!("`{path}` is not text in UTF-8: line {line} has other bytes at column {column}; save it as UTF-8")
}

pub(crate) fn path_not_unicode(path: &str) -> String {
    format!("the path `{path}` is not Unicode, and Rust cannot name it: rename the file or its folder")
}

pub(crate) fn beside_caller(file: &str) -> String {
    format!("beside the file that names them, here `{file}`")
}

pub(crate) fn from_folder(folder: &str) -> String {
    format!("from the folder `{folder}`")
}

pub(crate) fn beside_manifest(folder: &str) -> String {
    format!(
        "beside the file that names them; which one that is could not be found out here, so the folder of Cargo.toml was \
         taken, `{folder}`"
    )
}
