//! The program as its users run it: exit codes, rendered errors, explanations, JSON.
//!
//! `UPDATE_GOLDEN=1 cargo test -p linkwright-cli` writes the expected texts anew; read them before keeping them.

use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// What a run has left behind.
struct Ran {
    code: i32,
    out: String,
    err: String,
}

/// Runs the program in the folder of the test data.
fn run(arguments: &[&str], input: &[u8]) -> Ran {
    let mut child = Command::new(env!("CARGO_BIN_EXE_linkwright"))
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program is built");
    child.stdin.take().expect("it is piped").write_all(input).expect("the program reads it or not");
    let Output { status, stdout, stderr } = child.wait_with_output().expect("it ends");
    let text = |bytes| String::from_utf8(bytes).expect("it writes text");
    Ran { code: status.code().expect("it was not killed"), out: text(stdout), err: text(stderr) }
}

fn ran(arguments: &[&str]) -> Ran {
    run(arguments, b"")
}

/// The answer as JSON, and the exit code.
fn json(arguments: &[&str]) -> (Value, i32) {
    let Ran { code, out, err } = ran(arguments);
    assert_eq!(err, "", "{arguments:?}");
    (serde_json::from_str(&out).expect("the answer is JSON"), code)
}

/// Compares with a file of `tests/golden`.
#[track_caller]
fn golden(name: &str, found: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name);
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        std::fs::write(&path, found).expect("the golden file can be written");
    }
    let expected = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(found, expected, "{name}");
}

#[test]
fn good_and_bad_files_have_their_exit_codes() {
    let good = ran(&["check", "good.mech"]);
    assert_eq!(
        (good.code, good.out.as_str(), good.err.as_str()),
        (0, "1 definition checked, all well\n", "")
    );
    for bad in ["misspelt_body.mech", "brace_forgotten.mech", "empty.mech", "several.rs"] {
        assert_eq!(ran(&["check", bad]).code, 1, "{bad}");
    }
    let mixed = ran(&["check", "good.mech", "empty.mech", "nowhere.mech"]);
    assert_eq!(mixed.code, 2, "an unreadable file outweighs errors in others");
    assert_eq!(mixed.out, "2 definitions checked, 1 with errors\n");
    assert!(mixed.err.contains("there is no file `nowhere.mech`"), "{}", mixed.err);
}

#[test]
fn wrong_usage_is_said() {
    for (arguments, message) in [
        (
            &[] as &[&str],
            "no command is given: there are run, plot, animate, sweep, influence, draw, watch, check, explain, counts, export and flexible",
        ),
        (&["export", "good.mech"], "nothing is exported to \"good.mech\": there is c"),
        (&["export"], "export needs a language: write `linkwright export c FILE`"),
        (&["export", "c"], "export needs a file"),
        (
            &["export", "c", "--scalar", "f16", "good.mech"],
            "no scalar is called \"f16\": there are f64 and f32",
        ),
        (&["check", "--output", "here", "good.mech"], "--scalar and --output belong to export"),
        (&["chekc", "good.mech"], "no command is called \"chekc\"; did you mean `check`?"),
        (&["check"], "check needs a file"),
        (&["explain", "good.mech", "good.mech"], "explain takes one file, 2 are given"),
        (&["check", "--coordinates", "polar", "good.mech"], "no coordinates are called \"polar\""),
        (&["check", "--coordinates"], "coordinates"),
        (&["check", "--colour", "good.mech"], "--colour"),
        (&["check", "."], "`.` is a directory: name a file in it"),
        (&["check", "no_definition.rs"], "there is no definition in what was given"),
        (&["counts", "nowhere.rs"], "there is no file `nowhere.rs`"),
    ] {
        let Ran { code, out, err } = ran(arguments);
        assert_eq!((code, out.as_str()), (2, ""), "{arguments:?}: {err}");
        assert!(err.contains(message), "{arguments:?}: {err}");
    }
    assert_eq!(ran(&["help", "rnu"]).code, 2);
    for command in [&[][..], &["check"], &["run"]] {
        let word = [&["help"][..], command].concat();
        let option = [command, &["--help"][..]].concat();
        assert_eq!((ran(&word).code, ran(&word).out), (0, ran(&option).out), "{word:?}");
    }
    let help = ran(&["check", "--help"]);
    assert_eq!((help.code, help.err.as_str()), (0, ""));
    for word in [
        "check",
        "explain",
        "counts",
        "export c",
        "--scalar",
        "--output",
        "--json",
        "--coordinates",
        "exit code: 0",
        "1  a definition",
        "2  wrong usage",
    ] {
        assert!(help.out.contains(word), "{word}");
    }
    assert!(ran(&["--version"]).out.starts_with("linkwright "));
}

/// What stands on standard error is drawn with the line of the file; nothing is coloured where it is no terminal.
#[test]
fn errors_are_drawn() {
    for name in [
        "misspelt_body.mech",
        "declared_twice.mech",
        "brace_forgotten.mech",
        "sign_of_multiplication.mech",
        "empty.mech",
        "several.rs",
    ] {
        let Ran { err, .. } = ran(&["check", name]);
        assert!(!err.contains('\u{1b}'), "{name} is coloured");
        golden(&format!("{name}.txt"), &err.replace(env!("CARGO_MANIFEST_DIR"), "cli"));
    }
}

#[test]
fn standard_input_is_a_definition_or_rust() {
    let data = |name: &str| {
        std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)).unwrap()
    };
    assert_eq!(run(&["check", "-"], &data("good.mech")).code, 0);
    let wrong = run(&["check", "-"], &data("misspelt_body.mech"));
    assert_eq!(wrong.code, 1);
    assert!(wrong.err.contains("--> standard input:8:43"), "{}", wrong.err);
    let rust = run(&["check", "-"], b"fn main() {}\nlinkwright::mechanism! { planar A { } }\n");
    assert!(rust.err.contains("--> standard input:2:33"), "{}", rust.err);
    let latin = run(&["check", "-"], b"planar \xff { }");
    assert_eq!(latin.code, 2);
    assert!(latin.err.contains("`standard input` is not text in UTF-8: line 1"), "{}", latin.err);
}

#[test]
fn explanations() {
    let Ran { code, out, err } = ran(&["explain", "good.mech"]);
    assert_eq!((code, err.as_str()), (0, ""));
    golden("explain.txt", &out);
    let absolute = ran(&["explain", "--coordinates=absolute", "good.mech"]).out;
    assert!(absolute.contains("In absolute coordinates (as asked:"), "{absolute}");
    // The start is the same in both, and so is Grübler's count.
    let start = |text: &str| {
        text.split("\nStart").nth(1).and_then(|rest| rest.split("\nOperations").next()).map(str::to_string)
    };
    assert_eq!(start(&absolute), start(&out));
    assert!(absolute.contains("Grübler's count is 9 freedoms of 3 bodies less 8 equations of 4 joints, 1."));
    assert_eq!(ran(&["explain", "empty.mech"]).code, 1);
}

#[test]
fn explanations_for_machines() {
    let (answer, code) = json(&["explain", "--json", "good.mech"]);
    assert_eq!((code, &answer["version"], &answer["command"]), (0, &1.into(), &"explain".into()));
    let one = &answer["mechanisms"][0];
    assert_eq!(one["name"], "CrankRocker");
    let told = &one["explanation"];
    assert_eq!(told["degrees_of_freedom"], 1);
    assert_eq!(told["gruebler"], 1);
    assert_eq!(told["independent"][0], "crank_pin.angle");
    assert_eq!(told["parameters"][0]["default"], 2000.0);
    assert_eq!(told["parameters"][0]["unit"], "g");
    assert_eq!(told["bodies"][2]["mass"], 2.0);
    let start = told["start"].as_array().expect("a list");
    let value = |name: &str| {
        let found = start.iter().find(|value| value["name"] == name).unwrap_or_else(|| panic!("{name}"));
        (found["value"].as_f64().expect("a number"), found["unit"].as_str().expect("a text").to_string())
    };
    assert!((value("crank_pin.angle").0 - 90.0).abs() < 1e-9);
    assert!((value("crank_pin.rate").0 - 60.0).abs() < 1e-9);
    assert_eq!(value("knee.angle").1, "deg");
    // The loop is closed: the rocker's tip is the coupler's end, 0.6 m from the crank's end (0, 0.2).
    let (rocker, unit) = value("rocker_pin.angle");
    assert_eq!(unit, "deg");
    let (x, y) = (0.5 + 0.4 * rocker.to_radians().cos(), 0.4 * rocker.to_radians().sin());
    assert!((x.hypot(y - 0.2) - 0.6).abs() < 1e-9, "{rocker}");
    assert!((told["outputs"][0]["value"].as_f64().expect("a number") - rocker).abs() < 1e-9);
}

#[test]
fn errors_for_machines() {
    let (answer, code) = json(&["check", "--json", "several.rs"]);
    assert_eq!(code, 1);
    let mechanisms = answer["mechanisms"].as_array().expect("a list");
    let names: Vec<&Value> = mechanisms.iter().map(|one| &one["name"]).collect();
    assert_eq!(
        names,
        ["Good", "Wrong", "FourBar", "", "Short", "Turned"]
            .map(|name| if name.is_empty() { Value::Null } else { name.into() })
            .iter()
            .collect::<Vec<_>>()
    );
    let errors = |index: usize| mechanisms[index]["diagnostics"].as_array().expect("a list");
    assert_eq!([0, 1, 2, 3, 4, 5].map(|index| errors(index).len()), [0, 1, 1, 1, 0, 1]);
    let wrong = &errors(1)[0];
    assert_eq!(wrong["file"], "several.rs");
    assert_eq!((&wrong["start"]["line"], &wrong["start"]["column"]), (&15.into(), &57.into()));
    let text =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/several.rs")).unwrap();
    let byte = |end: &str| wrong[end]["byte"].as_u64().expect("a number") as usize;
    assert_eq!(&text[byte("start")..byte("end")], "strat");
    let twice = &errors(2)[0];
    assert_eq!(twice["file"], "declared_twice.mech");
    assert_eq!(twice["notes"][0]["start"]["line"], 3);
    assert_eq!(twice["notes"][0]["message"], "the first `crank` is here");
    assert!(
        errors(3)[0]["message"].as_str().expect("a text").contains("there is no file `misspelled_body.mech`")
    );
    assert!(errors(5)[0]["notes"][0]["message"].as_str().expect("a text").contains("macro"));

    let (answer, code) = json(&["check", "--json", "nowhere.mech"]);
    assert_eq!(code, 2);
    assert_eq!(answer["mechanisms"], Value::Array(Vec::new()));
    assert!(answer["unreadable"][0]["message"].as_str().expect("a text").contains("there is no file"));
}

#[test]
fn counts_of_any_file() {
    let Ran { code, out, err } = ran(&["counts", "good.mech"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(
        out.contains("CrankRocker, absolute coordinates") && out.contains("CrankRocker, tree coordinates"),
        "{out}"
    );
    let (answer, _) = json(&["counts", "--json", "--coordinates", "tree", "good.mech"]);
    let rows = answer["mechanisms"][0]["counts"].as_array().expect("a list");
    let row = rows.iter().find(|row| row["function"] == "acceleration_baumgarte").expect("it is emitted");
    assert_eq!(row["coordinates"], "tree");
    assert!(
        out.contains(&format!("acceleration_baumgarte{:>9}", row["operations"].as_u64().expect("a number"))),
        "{out}"
    );
    assert!(rows.iter().all(|row| row["coordinates"] == "tree"));
    assert_eq!(ran(&["counts", "brace_forgotten.mech"]).code, 1);
}

/// Name and exported definition of every shipped model.
macro_rules! definitions {
    ($($name:ident: $model:path),* $(,)?) => { vec![$({ use $model as Model; (stringify!($model), Model::DEFINITION) }),*] };
}

/// Three files, whose names and contents follow from the definition; what they do is seen in `.ci/c` and in the tests of the compiler.
#[test]
fn mechanisms_are_exported() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("exported");
    let output = folder.display().to_string();
    let done = ran(&["export", "c", "--scalar", "f32", "--output", &output, "good.mech"]);
    assert_eq!((done.code, done.err.as_str()), (0, ""));
    let written: Vec<&str> = done.out.lines().collect();
    assert_eq!(written.len(), 3, "{written:?}");
    let text = |ending: &str| {
        let path = written.iter().find(|path| path.ends_with(ending)).expect("a file of each kind");
        std::fs::read_to_string(path).expect("it was written")
    };
    assert!(text(".h").contains("float q[") && !text(".h").contains("double"), "{}", text(".h"));
    assert!(text(".c").contains("_step_rk4_corrected("));
    assert!(text(".hpp").contains("namespace linkwright"));

    let (answer, code) = json(&["export", "c", "--json", "--output", &output, "good.mech", "several.rs"]);
    assert_eq!((answer["command"].as_str(), code), (Some("export"), 1));
    assert_eq!(answer["mechanisms"][0]["exported"].as_array().map(Vec::len), Some(3));

    // A file stands where the folder would.
    let taken = folder.join("taken");
    std::fs::write(&taken, "").expect("a file");
    let refused = ran(&["export", "c", "--output", &taken.display().to_string(), "good.mech"]);
    assert_eq!(refused.code, 2);
    assert!(refused.err.contains("cannot be written"), "{}", refused.err);
    // The second would be written over the first.
    let twice = ran(&["export", "c", "--output", &output, "good.mech", "good.mech"]);
    assert_eq!((twice.code, twice.out.lines().count()), (2, 3));
    assert!(twice.err.contains("would both be written to"), "{}", twice.err);
    // What has errors is not written.
    let wrong = ran(&["export", "c", "--output", &output, "misspelt_body.mech"]);
    assert_eq!((wrong.code, wrong.out.as_str()), (1, ""));
}

/// Every shipped definition is well, and what is found in its file is what the macro was given.
#[test]
fn shipped_models_are_found_and_well() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/src");
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).expect("the models").map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    let rust: Vec<&str> =
        files.iter().filter_map(|path| path.to_str()).filter(|path| path.ends_with(".rs")).collect();
    let checked = ran(&[&["check"], rust.as_slice()].concat());
    assert_eq!(checked.code, 0, "{}", checked.err);
    let shipped = linkwright_models::for_each_model!(definitions);
    assert_eq!(checked.out, format!("{} definitions checked, all well\n", shipped.len()));
    let mut found = std::collections::BTreeMap::new();
    for file in rust.iter().filter(|path| !path.ends_with("lib.rs")) {
        let (answer, code) = json(&["explain", "--json", file]);
        assert_eq!(code, 0, "{file}");
        for one in answer["mechanisms"].as_array().expect("a list") {
            let name = one["name"].as_str().expect("a name").to_string();
            found.insert(name, one["explanation"]["definition"].clone());
        }
    }
    assert_eq!(found.len(), shipped.len());
    for (path, definition) in shipped {
        let name = path.rsplit("::").next().unwrap_or_default().trim();
        let exported: Value = serde_json::from_str(definition).expect("it is JSON");
        assert_eq!(found[name], exported, "{name}");
    }
}

fn document(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)).expect(path)
}

/// What the page of the commands shows of them is what they write.
#[test]
fn the_page_shows_real_output() {
    let page = document("docs/command-line.md");
    let shown = |command: &str| -> Vec<String> {
        let rest = page.split_once(&format!("$ linkwright {command}\n")).expect(command).1;
        let block =
            rest.split("\n$ ").next().and_then(|block| block.split("\n```").next()).unwrap_or_default();
        block.lines().filter(|line| !line.is_empty() && *line != "…").map(str::to_string).collect()
    };
    let explained = ran(&["explain", "../../../examples/crank_rocker.rs"]).out;
    let checked = ran(&["check", "several.rs"]).err;
    for (command, output) in [("explain crank_rocker.rs", explained), ("check several.rs", checked)] {
        let lines = shown(command);
        assert!(lines.len() >= 5, "{command}");
        for line in lines {
            assert!(output.lines().any(|written| written == line), "{command}: {line}\n{output}");
        }
    }
}

/// Every field of the answers is described.
#[test]
fn the_format_is_described() {
    fn keys(value: &Value, found: &mut std::collections::BTreeSet<String>) {
        match value {
            // Described by its own version, where the constant is.
            Value::Object(object) => {
                object.iter().filter(|(key, _)| *key != "definition").for_each(|(key, value)| {
                    found.insert(key.clone());
                    keys(value, found);
                })
            }
            Value::Array(list) => list.iter().for_each(|value| keys(value, found)),
            _ => {}
        }
    }
    let page = document("docs/command-line.md");
    let mut found = std::collections::BTreeSet::from(["definition".to_string()]);
    for arguments in [
        &["explain", "--json", "good.mech"],
        &["check", "--json", "several.rs"],
        &["counts", "--json", "good.mech"],
        &["check", "--json", "nowhere.mech"],
    ] {
        keys(&json(arguments).0, &mut found);
    }
    assert!(found.len() > 40, "{found:?}");
    for key in found {
        assert!(page.contains(&format!("`{key}`")), "docs/command-line.md does not describe `{key}`");
    }
}

/// Without the feature the option says what to do; with it, `native.rs` compares.
#[cfg(not(feature = "native"))]
#[test]
fn machine_code_has_to_be_built_in() {
    let refused = ran(&["run", "../../../docs/mechanisms/crank_rocker.mech", "--for", "10ms", "--native"]);
    assert_eq!((refused.code, refused.out.as_str()), (2, ""), "{}", refused.err);
    assert!(refused.err.contains("install it with `--features native`"), "{}", refused.err);
}

/// Lengths between joints, for machines too; without any it is said, and so is an option that is misspelt.
#[test]
fn dimensions_are_drawn() {
    let one =
        b"planar Ball { disk ball { mass [kg] = 1; radius [m] = 0.1; } start { ball.center.x [m] = 0; }}";
    let none = run(&["draw", "-", "--dimensions"], one);
    assert_eq!(
        (none.code, none.err.as_str()),
        (0, "Ball: no body has two joints that turn, so there are no dimensions\n"),
    );
    let misspelt = ran(&["draw", "good.mech", "--dimension"]);
    assert_eq!(misspelt.code, 2);
    assert!(misspelt.err.contains("did you mean `dimensions`?"), "{}", misspelt.err);
    let short = b"planar Short {
        rod arm { mass [kg] = 1; length [mm] = 0.2; } rod hand { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start); joint elbow: revolute(arm.end, hand.start);
    }";
    let told = run(&["draw", "-", "--dimensions", "--json"], short);
    let told: Value = serde_json::from_str(&told.out).expect("the answer is JSON");
    let dimensions = &told["mechanisms"][0]["draw"]["dimensions"];
    assert_eq!(dimensions, &serde_json::json!({ "count": 2, "without_place": ["0.2 mm (arm)"] }), "{told}");
    let said = run(&["draw", "-", "--dimensions"], short);
    assert_eq!(said.err, "Short: no place in the drawing for the dimensions 0.2 mm (arm)\n");
    assert!(said.out.contains(">without a place: 0.2 mm (arm)<"), "{}", said.out);
}

/// The end of a file's name says what it is written as; what cannot be is said before anything is computed.
#[test]
fn formats_that_are_not_written() {
    let file = "../../../docs/mechanisms/crank_rocker.mech";
    for (arguments, message) in [
        (["sweep", "a.arrow"], "--out: sweep writes no Arrow; give the file another name"),
        (["run", "a.PNG"], "--out: run writes no PNG; give the file another name"),
        (["influence", "a.png"], "--out: influence writes no PNG; give the file another name"),
        (
            ["run", "a.arrow"],
            "without Arrow; install it with `--features arrow`, or write comma-separated values: a name that ends in .csv",
        ),
        (
            ["draw", "a.png"],
            "without PNG; install it with `--features png`, or write SVG: a name that ends in .svg",
        ),
    ] {
        let [command, out] = arguments;
        let Ran { code, err, .. } = ran(&[command, file, "--out", out]);
        assert_eq!(code, 2, "{err}");
        assert!(err.contains(message), "{err}");
    }
}

/// What the warnings of beams judge, and rates of modes by their names.
#[test]
fn beams_are_explained() {
    let text = b"planar Column { gravity [m/s^2] = (-10, 0);
        beam rod { length [m] = 2; section = rectangle(height [mm] = 10, width [mm] = 30); young [GPa] = 200; mass [kg] = 3; modes = (bending = 1);
                   shapes = clamped; }
        joint foot: fixed(ground(0, 0) [m], rod.start); start { rod.bending[0] [mm] = 1; } }";
    let found = run(&["explain", "-"], text);
    for expected in [
        "Beams at the start, against what they take (1)",
        "  rod  692.82 radii of gyration long  turns at 0 rad/s, clamped frequency 16.0483 rad/s  pressed with 30 N, Euler's load 308.425 N",
        "  rod.bending[0]       = 1 mm   stated",
        "  rod.bending[0].rate  = 0 m/s  stated",
    ] {
        assert!(found.out.contains(expected), "{}", found.out);
    }
    let found = run(&["explain", "--json", "-"], text);
    let found: Value = serde_json::from_str(&found.out).expect("the answer is JSON");
    let beam = &found["mechanisms"][0]["explanation"]["beams"][0];
    assert_eq!(beam["name"], "rod", "{found}");
    assert!((beam["thrust_N"].as_f64().expect("a number") - 30.0).abs() < 1e-9, "{beam}");
}
