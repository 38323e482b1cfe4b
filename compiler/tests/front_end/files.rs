//! Definitions in files: places of errors by line and column, what is no token, delimiters that do not balance, Rust files
//! around definitions.

use crate::slider_crank;
use linkwright_compiler::source::written::Place;
use linkwright_compiler::source::{self, Located, Source};
use linkwright_compiler::{Expansion, compile, file};

/// The errors of a file that holds this text.
fn errors(text: &str) -> (Source, Vec<Located>) {
    let source = Source::new("arm.mech", text);
    let (tokens, mut errors) = source::definition(&source);
    if errors.is_empty() {
        errors =
            compile(tokens.stream.clone(), None).map_or_else(|found| tokens.locate(found), |_| Vec::new());
    }
    (source, errors)
}

/// Line, column, text and message of all errors, and of their notes behind them.
fn found(text: &str) -> Vec<String> {
    let (source, errors) = errors(text);
    let mut found = Vec::new();
    let place = |range: &std::ops::Range<usize>, message: &str| {
        let at = source.position(range.start);
        let text = source.text[range.clone()].lines().next().unwrap_or_default();
        format!("{}:{} `{text}` {message}", at.line, at.column)
    };
    for error in &errors {
        found.push(place(&error.range, &error.message));
        found.extend(error.notes.iter().map(|(range, message)| place(range, message)));
    }
    found
}

#[track_caller]
fn finds(text: &str, expected: &[&str]) {
    assert_eq!(found(text), expected);
}

#[test]
fn errors_of_every_stage_have_places() {
    // Syntax, names, units, rules, assembly; behind a doc comment and non-ASCII text on the same line.
    finds(
        &slider_crank("/// größer\n  output o [m] = /* µ */ nothing;"),
        &["15:26 `nothing` no value called \"nothing\""],
    );
    finds(
        &slider_crank("joint extra revolute(ground(0, 0), crank.pin);"),
        &["14:13 `revolute` expected `:` and what the joint is, such as `revolute(…);`, found `revolute`"],
    );
    finds(
        &slider_crank("rod crank { mass [kg] = 1; length [m] = 1; }"),
        &[
            "14:5 `crank` `crank` is declared twice; rename one of them",
            "5:10 `crank` the first `crank` is here",
        ],
    );
    finds(
        &slider_crank(
            "body b { mass [kg] = 2 - 3; inertia [kg*m^2] = 1; }\njoint j: revolute(ground(0, 0), b.center);",
        ),
        &["14:22 `2 - 3` the mass of `b` is negative: -1 kg; it must be zero or more"],
    );
    let text = slider_crank(
        "start { base.angle [rad] = 1; knee.angle [rad] ~ -1.2; } expect { degrees_of_freedom = 2; }",
    );
    let found = found(&text);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("14:67 `degrees_of_freedom = 2` expected 2 degrees"), "{found:?}");
}

#[test]
fn what_is_missing_is_missing_behind_the_last_token() {
    finds("", &["1:1 `` the definition is empty: write `planar Name { … }` or `spatial Name { … }`"]);
    finds(
        "// nothing\n\n",
        &["1:11 `` the definition is empty: write `planar Name { … }` or `spatial Name { … }`"],
    );
    finds("planar", &["1:1 `planar` expected the name of the mechanism, found the end"]);
    finds("planar A", &["1:8 `A` expected `{`, found the end"]);
}

#[test]
fn what_is_no_token() {
    finds("planar A { const B = 3 × 4; }", &["1:24 `×` the character '×' has no meaning here: write `*`"]);
    finds(
        "planar A { const B [deg] = 45°; const C = 1 − 2; const D = 5m²; }",
        &[
            "1:30 `°` the character '°' has no meaning here: write the unit, such as `[deg]`",
            "1:45 `−` the character '−' has no meaning here: write the minus sign `-`",
            "1:62 `²` the character '²' has no meaning here: write `^2`",
        ],
    );
    finds("planar A { /* to do }", &["1:12 `/*` this comment never ends: write `*/` where it does"]);
    finds("#[doc = \"arm] planar A { }", &["1:9 `\"` this string never ends: write `\"` where it does"]);
    finds(
        "#[doc = r##\"arm\"#] planar A { }",
        &["1:9 `r##\"` this string never ends: write `\"##` where it does"],
    );
    finds(
        "planar A { param x' [m] = 1 \\ 2; }",
        &[
            "1:19 `'` a `'` alone has no meaning here: names consist of letters, digits and `_`, texts stand in `\"`",
            "1:29 `\\` the character '\\\\' has no meaning here: leave it out",
        ],
    );
    // The prefix of a byte without its end.
    finds("planar A { param b'x [m] = 1; }", &["1:19 `'` expected `=`, found `'`"]);
    let number = |digits: &str| format!("planar A {{ const B = {digits}; }}");
    for digits in ["1e", "3em", "0x", "0b2", "0o_"] {
        finds(
            &number(digits),
            &[&format!(
                "1:22 `{digits}` `{digits}` is not a plain decimal number: write digits without suffix, such as `1.5` or `2e-3`"
            )],
        );
    }
    finds(
        "planar r#self { }",
        &["1:8 `r#self` `self` is a word of Rust and cannot be a name; choose another"],
    );
}

#[test]
fn delimiters_that_do_not_balance() {
    let arm = "planar A {\n    rod a { mass [kg] = 1; length [m] = 1; }\n    start { b.angle = (1; }\n}\n";
    finds(
        arm,
        &[
            "3:27 `}` this `}` stands where a `(` is still open: write `)` before it",
            "3:23 `(` the `(` is opened here",
        ],
    );
    // The brace of `a` is missing, and those behind close the wrong ones.
    finds(
        "planar A {\n    rod a {\n        mass [kg] = 1;\n    start {\n    }\n}\n",
        &[
            "1:10 `{` this `{` is never closed: write `}` where it ends",
            "6:1 `}` this `}` closes the `{` of line 2, which is indented otherwise: one may be missing there",
        ],
    );
    finds(
        "planar A {\n    start {\n    } }\n}\n",
        &["4:1 `}` this `}` closes nothing: leave it out, or write the `{` that it belongs to before it"],
    );
    let deep = format!("planar A {{ const B = {}1{}; }}", "(".repeat(200_000), ")".repeat(200_000));
    finds(&deep, &["1:117 `(` nested more than 96 deep; name a part of it by a `const` or `param`"]);
}

#[test]
fn what_a_file_holds() {
    finds(
        "mechanism! {\n    planar A { }\n}",
        &[
            "1:1 `mechanism` a file holds what stands inside of `mechanism! { … }`: leave `mechanism! {` and its `}` out",
        ],
    );
    finds(
        "file = \"arm.mech\"",
        &[
            "1:1 `file` a file holds the definition itself, it does not name another: write `planar Name { … }` or \
           `spatial Name { … }`",
        ],
    );
    finds(
        &format!("{}\nplanar B {{ }}", slider_crank("")),
        &["16:1 `planar` expected the end: one mechanism for each macro, found `planar`"],
    );
    // A byte order mark and the line ends of another system.
    finds(&format!("\u{feff}{}", slider_crank("").replace('\n', "\r\n")), &[]);
}

/// The expansion of these tokens, called from a Rust file in the folder of this test's data.
fn expansion(tokens: &str) -> String {
    let caller = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/caller.rs");
    match linkwright_compiler::expand(tokens.parse().expect("tokens"), |_| Some(Place::somewhere(caller))) {
        Expansion::Items { text, .. } => text,
        Expansion::Errors(tokens) => tokens.to_string(),
    }
}

#[test]
fn a_file_becomes_what_the_macro_becomes() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/pendulum.mech");
    let text = std::fs::read_to_string(path).expect("data of the test");
    let (of_macro, of_file) = (expansion(&text), expansion("file = \"pendulum.mech\""));
    let depends = format!("const _: &'static [::core::primitive::u8] = ::core::include_bytes!({path:?});\n");
    let without_source = |text: &str| -> String {
        let (before, page) = text.split_once("mechanism_page! {").expect("a page");
        let after = page.split_once("})]\n").expect("its end").1;
        let lines = after.lines().filter(|line| !line.contains("pub const SOURCE"));
        before.to_string() + &lines.map(|line| format!("{line}\n")).collect::<String>()
    };
    assert!(of_file.ends_with(&depends), "{}", &of_file[of_file.len() - 300..]);
    assert_eq!(without_source(&of_file), without_source(&of_macro) + &depends);
    let source = of_file.lines().find(|line| line.contains("pub const SOURCE")).expect("a constant");
    assert!(source.contains(&format!("{text:?}")), "{source}");
}

#[test]
fn what_names_no_file() {
    let missing = expansion("file = \"pendulm.mech\"");
    assert!(missing.contains("there is no file `"), "{missing}");
    assert!(missing.contains("pendulm.mech`; did you mean \\\"pendulum.mech\\\"? Paths are taken beside the file that names them"), "{missing}");
    assert!(expansion("file = \".\"").contains("is a directory: name a file in it"));
    for wrong in [
        "file",
        "file = ",
        "file = 3",
        "file = \"\"",
        "file = arm",
        "file(\"arm.mech\")",
        "file: \"arm.mech\"",
    ] {
        let text = expansion(wrong);
        assert!(text.contains("a definition in a file is named by a string"), "{wrong}: {text}");
    }
    assert!(
        expansion("file = \"pendulum.mech\", planar A { }").contains("nothing else stands beside the name")
    );
    assert!(expansion("file = r\"pendulum.mech\",").contains("pub struct Pendulum"));
}

/// Where rustc does not say which file calls, the folder of Cargo.toml is taken, and the message says so.
#[test]
fn an_unknown_caller() {
    let named = |name: &str| {
        linkwright_compiler::expand(format!("file = {name:?}").parse().expect("tokens"), |_| None)
    };
    assert!(matches!(named("tests/data/pendulum.mech"), Expansion::Items { .. }));
    let Expansion::Errors(tokens) = named("pendulum.mech") else { panic!("there is no such file") };
    let text = tokens.to_string();
    assert!(text.contains("could not be found out here, so the folder of Cargo.toml was taken, `"), "{text}");
}

#[test]
fn bytes_that_are_no_text() {
    let error = file::text("arm.mech", b"planar A {\n  // \xe9t\xe9\n}".to_vec()).expect_err("it is Latin-1");
    assert_eq!(
        error,
        "`arm.mech` is not text in UTF-8: line 2 has other bytes at column 6; save it as UTF-8"
    );
}

#[test]
fn definitions_in_rust_files() {
    let text = "#!/usr/bin/env run\n//! mechanism! { no }\nmacro_rules! m { ($n:ident) => { mechanism! { planar $n { } } }; }\n\
                linkwright::mechanism! { planar A { rod a { mass [kg] = 1; length [m] = x; } } }\n\
                mod deep { fn f() { mechanism!(file = \"a.mech\"); } }\nconst C: char = '{'; /* mechanism! { */\n\
                mechanism![planar B { const C = 1 \\ 2; }];";
    let source = Source::new("a.rs", text);
    assert!(source::is_rust(&source));
    let found = source::invocations(&source).expect("balanced");
    let starts: Vec<usize> = found.iter().map(|one| source.position(one.range.start).line).collect();
    assert_eq!(starts, [4, 5, 7]);
    let errors = compile(found[0].tokens.stream.clone(), None).expect_err("it has mistakes");
    let located = found[0].tokens.locate(errors);
    assert_eq!(&text[located[0].range.clone()], "x");
    let named = file::named(&found[1].tokens.stream).expect("a file").expect("its name");
    assert_eq!(named.name, "a.mech");
    assert_eq!(found[2].errors.len(), 1);
    assert!(found[0].errors.is_empty() && found[1].errors.is_empty());
    let open = Source::new("a.rs", "fn f() { mechanism! { planar A { }");
    assert_eq!(
        source::invocations(&open).expect_err("it is open").message,
        "this `{` is never closed: write `}` where it ends"
    );
    assert!(!source::is_rust(&Source::new("arm", "planar mechanism { }")));
}

#[test]
fn macros_that_write_definitions() {
    let text = "macro_rules! one { ($(#[$d:meta])* $v:vis $n:ident, $l:literal $(, $k:ident = $t:tt)*; $e:expr) => { mechanism! { \
                $(#[$d])* $v planar $n { const L = $l; const E = $e*2; $(const $k = $t;)* } } };\n\
                ($n:ident) => { one! { pub $n, -1.5, A = (1), B = 2; 3 + 4 } } }\n\
                one! { /// Doc.\n    First, 1; x }\nfn f() { one!(Second); one!(3); }\n\
                macro_rules! many { () => { many! {} many! {} mechanism! {} } }\nmany!();";
    let source = Source::new("a.rs", text);
    let found = source::invocations(&source).expect("balanced");
    let written = |index: usize| found[index].tokens.stream.to_string();
    assert_eq!(written(0), "# [doc = \" Doc.\"] planar First { const L = 1 ; const E = x * 2 ; }",);
    let second: String = written(1).split_whitespace().collect();
    assert_eq!(second, "pubplanarSecond{constL=-1.5;constE=3+4*2;constA=(1);constB=2;}");
    // The sum of the call is one operand, as rustc reads it.
    let sum = found[1].tokens.stream.clone().into_iter().last().map(|body| match body {
        proc_macro2::TokenTree::Group(body) => body.stream().into_iter().nth(8),
        _ => None,
    });
    assert!(
        matches!(sum.flatten(), Some(proc_macro2::TokenTree::Group(sum)) if sum.stream().to_string() == "3 + 4")
    );
    assert_eq!(source.position(found[0].range.start).line, 3);
    assert_eq!(source.position(found[1].range.start).line, 5);
    assert!(found[2].errors[0].message.starts_with("what `one!` writes here cannot be told without rustc"));
    // One that calls itself for ever is left at some time.
    assert!((4..3000).contains(&found.len()), "{}", found.len());
    // Long calls and deep rules take no time and no stack.
    let long = format!(
        "{}one!(L, 1; x {});",
        &text[..text.find("one! { ///").expect("a call")],
        "+ 1 ".repeat(20_000)
    );
    assert_eq!(source::invocations(&Source::new("a.rs", long)).expect("balanced").len(), 1);
    let matcher = "$(".repeat(50_000) + &")*".repeat(50_000);
    let deep = format!("macro_rules! d {{ ({matcher}) => {{ mechanism! {{}} }} }} d!();");
    let found = source::invocations(&Source::new("a.rs", deep)).expect("balanced");
    assert!(found[0].errors[0].message.starts_with("what `d!` writes"));
}
