//! Tables: their mistakes, what they give, where they may stand, and those in files.

use crate::{each_has_one_message, good, slider_crank, underlined, warnings};
use linkwright_compiler::model::{Coordinate, Expr, Quantity};
use linkwright_compiler::source::written::Place;
use linkwright_compiler::{Expansion, compile_at};
use std::path::Path;

#[test]
fn one_message_for_each_mistake() {
    each_has_one_message(&MISTAKES);
}

const MISTAKES: [(&str, &str); 49] = [
    (
        "table t: rad -> m = [];",
        "the head of a table is written as its call, with units: `table t(angle [deg]) [mm] = …` is called by `t(crank.angle)`",
    ),
    ("table t(a, b, c) = [];", "a table has one argument, or two if it is a grid; `t` is written with 3"),
    ("table t() = [];", "a table has one argument, or two if it is a grid; `t` is written with 0"),
    ("table t(x) = 3;", "expected `[(x, y), …]`, `file(\"…\")` or `grid(…)`, found `3`"),
    ("table t(x) = file(cam);", "the file of a table is named by a string: write `file(\"cam.csv\")`"),
    ("table t(x) = file(\"\");", "the file of a table is named by a string: write `file(\"cam.csv\")`"),
    (
        "table t(x) = file(\"cam.csv\", skip = -1);",
        "-1 lines cannot be skipped: `skip` is how many stand before the first one of the table",
    ),
    ("table t(x) = [(0, 0), (1, 1)], cubic, cubic;", "this is said of `t` already: leave one of the two out"),
    (
        "table t(x) = [(0, 0), (1, 1)], outside = zero;",
        "a table goes on outside of its knots as `linear`, with value and slope at the end, or as `hold`, with the value alone; \
         \"zero\" is neither",
    ),
    (
        "table t(x) = [(0, 0), (1, 1)], akime;",
        "a table goes on between its knots in no way called \"akime\"; did you mean `akima`?",
    ),
    (
        "table t(x, y) = grid((0, 1), (0, 1), [(0, 0), (1, 1)]), bicubic;",
        "`t` has 2 knots along an argument, and `bicubic` takes at least 4: add some, or write `bilinear`",
    ),
    (
        "table t(x) = [(0, 0), (1, 1)], nearest;",
        "a table goes on between its knots in no way called \"nearest\"; there are linear, akima, modified_akima, monotone, pchip, \
         cubic, natural, periodic, bilinear, bicubic, and `outside = …`, `columns = …`",
    ),
    (
        "table t(x) = [(0, 0), (1, 1)], columns = (1, 2);",
        "`columns` are those of a file: leave it out, the points are written here",
    ),
    (
        "table t(x) = [(0, 0), (1, 1)], bilinear;",
        "`bilinear` is for tables of two arguments, and this one has one argument",
    ),
    (
        "table t(x, y) = grid((0, 1), (0, 1), [(0, 0), (1, 1)]), cubic;",
        "`cubic` is for tables of one argument, and this one has two arguments",
    ),
    (
        "table t(x) = grid((0, 1), (0, 1), [(0, 0), (1, 1)]);",
        "`t` has one argument: write its points as `[(x, y), …]` or name a `file(\"…\")`",
    ),
    (
        "table t(x, y) = [(0, 1), (1, 2)];",
        "`t` has two arguments: write it as `grid((x, …), (y, …), [(z, …), …])`, a row for each y, or name a `file(\"…\")`",
    ),
    (
        "table t(x) = [(0, 0), (1, 0)], periodic, outside = hold;",
        "what is periodic has no outside: leave `outside` out",
    ),
    ("table t(x [m]) = [(0, 0), (1 [rad], 1)];", "a knot of `t` is given an angle: expected m, found rad"),
    ("table t(x) [m] = [(0, 0), (1, 1 [N])];", "a value of `t` is given a force: expected m, found N"),
    (
        "table t(x) = [(0, 0), (heavy, 1)];",
        "`heavy` is a parameter, but a table may depend on constants only",
    ),
    (
        "table t(x) = [(0, 0)];",
        "`t` has 1 knots along an argument, and `monotone` takes at least 2: add some",
    ),
    (
        "table t(x) = [(0, 0), (1, 1), (2, 2)], natural;",
        "`t` has 3 knots along an argument, and `natural` takes at least 4: add some, or write `linear`",
    ),
    (
        "table t(x [deg]) = [(0, 0), (20, 1), (10, 2)];",
        "the knots of `t` ascend, but 10 deg follows 20 deg: sort them, each once",
    ),
    (
        "table t(x) = [(0, 0), (2, 1), (2, 2)];",
        "the knots of `t` ascend, but 2 stands there twice: sort them, each once",
    ),
    (
        "table t(x, y) = grid((0, 1), (3, 2), [(0, 0), (1, 1)]);",
        "the knots of `t` ascend, but 2 follows 3: sort them, each once",
    ),
    (
        "table t(x [deg]) [mm] = [(0, 1), (180, 3), (360, 1.5)], periodic;",
        "`t` is periodic and ends on another value than it begins with, 1.5 mm in place of 1 mm: they differ by 0.5 mm. Write \
         the same value at both ends",
    ),
    (
        "table t(x, y) = grid((0, 1), (0, 1), [(0, 0)]);",
        "`t` has 1 rows of values for 2 of `y`: a grid has one row for each value of the second argument",
    ),
    (
        "table t(x, y) = grid((0, 1), (0, 1), [(0, 0), (1, 1, 1)]);",
        "this row of `t` has 3 values for 2 of `x`: it has one for each value of the first argument",
    ),
    (
        "table t(x [quark]) = [(0, 0), (1, 1)];",
        "no unit called \"quark\"; units are m g s N Pa J W Hz A V ohm H F Wb with prefixes, kg rad deg rev rpm min h t bar",
    ),
    ("table sin(x) = [(0, 0), (1, 1)];", "`sin` has a meaning of its own here; choose another name"),
    (
        "table t(x) = [(0, 0), (1, 1)]; table t(y) = [(0, 0), (1, 1)];",
        "`t` is declared twice; rename one of them",
    ),
    ("table t(x) = [(0, 0), (1, 1)]; output o [1] = t(1, 2);", "`t` takes 1 argument, found 2"),
    (
        "table t(x) = [(0, 0), (1, 1)]; output o [1] = t;",
        "`t` is a table: its argument stands in parentheses behind it, as in `t(x)`",
    ),
    (
        "table t(x, y) = grid((0, 1), (0, 1), [(0, 0), (1, 1)]); output o [1] = t(1);",
        "`t` takes 2 arguments, found 1",
    ),
    (
        "table t(x, y) = grid((0, 1), (0, 1), [(0, 0), (1, 1)]); output o [1] = t.slope(1, 2);",
        "`t` has two arguments and a slope along each: `slope` is of tables of one argument",
    ),
    (
        "table lift(x [rad]) [m] = [(0, 0), (1, 1)]; output o [m] = lift(link.end.x);",
        "the argument `x` of `lift` is given a length: expected rad, found m",
    ),
    (
        "table lift(x [rad]) [m] = [(0, 0), (1, 1)]; output o [m] = lift(30);",
        "the argument `x` of `lift` is given a plain number: expected rad; write the unit, as in `30 [deg]`",
    ),
    (
        "table lift(x [rad]) [m] = [(0, 0), (1, 1)]; output o [N] = lift(base.angle);",
        "`o` is given a length: expected N, found m",
    ),
    (
        "table lift(x) = [(0, 0), (1, 1)]; output o [1] = lift.bend(2);",
        "expected `;`, found `(`; functions stand before their argument: `bend(…)`",
    ),
    ("output o [1] = lift.slope(2);", "no function called \"lift.slope\""),
    (
        "table lift(x) = [(0, 0), (1, 1)]; output o [1] = lft(2);",
        "no function called \"lft\"; did you mean \"lift\"?",
    ),
    (
        "table t(x) = [(0, 0), (1, 1)]; const A = t(0.5);",
        "`t` is not known here: tables are made of constants, so that constants and tables name none; write the number",
    ),
    (
        "table t(x) = [(0, 0), (1, u(1))]; table u(x) = [(0, 0), (1, 1)];",
        "`u` is not known here: tables are made of constants, so that constants and tables name none; write the number",
    ),
    (
        "table t(x [rad]) [m] = [(0, 0), (1, 1)], linear; constraint c: link.end.x = t(base.angle);",
        "the slope of `t` jumps at its knots, but a constraint is differentiated twice: write `cubic`, `natural` or `periodic` behind \
         the table",
    ),
    (
        "table t(x [s]) [rad] = [(0, 0), (1, 1)]; drive d: base.angle = t.slope(time)*1 [s];",
        "the slope of `t` (in `t.slope`) jumps at its knots, but the law of a driver is differentiated twice: write `cubic`, `natural` \
         or `periodic` behind the table",
    ),
    (
        "table t(x [rad]) [m] = [(0, 0), (1, 1)], linear; signal s [m] = 2*t(base.angle); constraint c: link.end.x = s;",
        "the slope of `t` (in `s`) jumps at its knots, but a constraint is differentiated twice: write `cubic`, `natural` or `periodic` \
         behind the table",
    ),
    (
        "table t(x) = [(0, 0), (1, 1)]; output o [1] = t(base.rate);",
        "the argument `x` of `t` is given an angular rate: expected 1, found rad/s",
    ),
    (
        "table t(x [rad]) [m] = [(0, 0), (1, 1)]; signal s [m] = t(base.angle)*base.rate/1 [rad/s]; output o [m/s] = s.rate;",
        "`s.rate` depends on a velocity, but a rate may depend on constants, parameters, time and positions only",
    ),
];

#[test]
fn too_many_knots() {
    let knots: String = (0..5000).map(|k| format!("({k}, 0), ")).collect();
    let source = format!("table t(x) = [{knots}];");
    each_has_one_message(&[(
        &source,
        "`t` has 5000 values and may have 4096: leave out those that its neighbours tell",
    )]);
}

#[test]
fn a_mistake_is_shown_at_its_knot() {
    let source = slider_crank("table t(x) = [(0, 0), (2, 1), (1, 2)];");
    let errors = crate::bad(&source);
    let shown = underlined(&source, errors.iter().next().expect("an error").region);
    assert!(shown.lines().nth(1).is_some_and(|marks| marks.trim() == "~" && marks.len() == 32), "{shown}");
}

/// Where accelerations follow it, a table has to be smooth; elsewhere it need not.
#[test]
fn smoothness() {
    let table = |kind: &str, tail: &str| {
        slider_crank(&format!(
            "table t(x [rad]) [m] = [(-3, 0), (-1, 1), (1, 2), (3, 0)], {kind}; output o [m] = t(base.angle); {tail}"
        ))
    };
    let constraint = "signal s [m] = t(base.angle); constraint c: link.end.x = s;";
    let jump = "accelerations jump at the knots of `t`: write `cubic`, `natural` or `periodic` behind the table, or \
                `#[allow(kinks)]` before this";
    for kind in ["akima", "modified_akima", "monotone", "pchip"] {
        let found = warnings(&table(kind, constraint));
        let texts: Vec<&str> = found.iter().map(|warning| warning.message.as_str()).collect();
        assert_eq!(texts, [jump], "{kind}");
        let allowed = constraint.replace("constraint", "#[allow(kinks)] constraint");
        assert!(warnings(&table(kind, &allowed)).is_empty());
    }
    for kind in ["cubic", "natural", "periodic"] {
        assert!(warnings(&table(kind, constraint)).is_empty(), "{kind}");
    }
    for kind in ["linear", "monotone", "cubic"] {
        assert!(warnings(&table(kind, "force f: force(crank.pin) = (t(base.angle)*1 [N/m], 0);")).is_empty());
        // Of what does not move.
        assert!(warnings(&table(kind, "constraint c: link.end.x = t(heavy*1 [rad/kg]);")).is_empty());
    }
}

#[test]
fn what_nothing_names() {
    let found = warnings(&slider_crank("table t(x) = [(0, 0), (1, 1)]; table _u(x) = [(0, 0), (1, 1)];"));
    let texts: Vec<&str> = found.iter().map(|warning| warning.message.as_str()).collect();
    assert_eq!(
        texts,
        [
            "nothing names the table `t`, so it stands for nothing: use it or leave it out, or write `#[allow(unused)]` before it"
        ]
    );
}

/// What is known at expansion is looked up there, in SI; names of tables are no names of anything else.
#[test]
fn known_values() {
    let mechanism = good(&slider_crank(
        "const TOP [mm] = 8; table heavy(x [deg]) [mm] = [(0, 0), (90, TOP)], linear; param p [mm] = heavy(45 [deg]); \
         output o [m] = heavy(pi/2*1 [rad]) + p; output s [m/rad] = heavy.slope(0.1 [rad]); output h [kg] = heavy;",
    ));
    assert!((mechanism.parameters[1].default - 0.004).abs() < 1e-15);
    let number = |index: usize| match &mechanism.outputs[index].value {
        Expr::Number(value) => *value,
        Expr::Binary(_, first, _) => match &**first {
            Expr::Number(value) => *value,
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    };
    assert!((number(0) - 0.008).abs() < 1e-15 && (number(1) - 0.016 / std::f64::consts::PI).abs() < 1e-15);
    let called = good(&slider_crank(
        "repeat i in 0..2 { table t[i](x [rad]) [m] = [(0, 0), (1, i + 1)]; } output o [m] = t[1](base.angle);\
         output unused [m] = t[0](1 [rad]);",
    ));
    let Expr::Table(look_up) = &called.outputs[0].value else { panic!("a table") };
    assert_eq!(look_up.curve.name(), "t[1]");
    assert!(matches!(look_up.arguments[..], [Expr::Quantity(Quantity::Coordinate(Coordinate::Angle(_)))]));
}

#[test]
fn a_table_in_the_exported_definition() {
    let source = slider_crank(
        "table lift(x [deg]) [mm] = [(0, 0), (90, -8)], outside = hold; table grip(s, n [N]) [N] = grid((0, 1), (0, 2), [(0, 3), (1, 4)]);",
    );
    let definition = linkwright_compiler::parse(source.parse().expect("tokens")).expect("a definition");
    let json = linkwright_compiler::syntax::definition_json(&definition);
    let tables = r#""tables":[{"name":"lift","arguments":[{"name":"x","unit":"deg"}],"unit":"mm","kind":"monotone","outside":"hold","points":[[{"number":"0"},{"number":"0"}],[{"number":"90"},{"op":"neg","args":[{"number":"8"}]}]]},"#;
    assert!(json.contains(tables), "{json}");
    let grid = r#"{"name":"grip","arguments":[{"name":"s","unit":"1"},{"name":"n","unit":"N"}],"unit":"N","kind":"bilinear","outside":"linear","axes":[[{"number":"0"},{"number":"1"}],[{"number":"0"},{"number":"2"}]],"rows":[[{"number":"0"},{"number":"3"}],[{"number":"1"},{"number":"4"}]]}]"#;
    assert!(json.contains(grid), "{json}");
}

/// A file of the test's folder as it is named there.
fn in_file(name: &str, text: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("tables");
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join(name), text).expect("it can be written");
    folder.join("caller.rs").display().to_string()
}

fn pendulum(data: &str) -> String {
    format!(
        "planar Arm {{ table lift(angle [deg]) [N*m] = {data}; rod arm {{ mass [kg] = 1; length [m] = 1; }} \
         joint hinge: revolute(ground(0, 0), arm.start); torque cam: torque(hinge) = lift(hinge.angle); }}"
    )
}

/// The knots in degrees and the values of the only table.
fn read(name: &str, text: &str, data: &str) -> Result<(Vec<f64>, Vec<f64>), String> {
    let caller = in_file(name, text);
    let tokens = pendulum(data).parse().expect("tokens");
    let compiled = compile_at(tokens, None, &|_| Some(caller.clone().into()));
    compiled.map_err(|errors| errors.iter().map(|error| error.message.clone()).collect()).map(|compiled| {
        let table = &compiled.mechanism.tables[0];
        (table.knots[0].iter().map(|knot| knot.to_degrees().round()).collect(), table.values[0].clone())
    })
}

/// The knots and the values of the only table, a grid.
fn read_grid(text: &str, data: &str) -> Result<[Vec<Vec<f64>>; 2], String> {
    let caller = in_file("grid.csv", text);
    let tokens = format!(
        "planar Arm {{ table drag(rate [rad/s], load [N]) [N*m] = {data}; rod arm {{ mass [kg] = 1; length [m] = 1; }} \
         joint hinge: revolute(ground(0, 0), arm.start); torque air: torque(hinge) = -drag(hinge.rate, 2 [N]); }}"
    );
    let compiled = compile_at(tokens.parse().expect("tokens"), None, &|_| Some(caller.clone().into()));
    compiled.map_err(|errors| errors.iter().map(|error| error.message.clone()).collect()).map(|compiled| {
        let table = &compiled.mechanism.tables[0];
        [table.knots.clone(), table.values.clone()]
    })
}

#[test]
fn grids_of_files() {
    let knots = vec![vec![-1.0, 0.0, 1.0], vec![0.0, 4.0]];
    let values = vec![vec![-2.0, 0.0, 2.0], vec![-3.0, 0.1, 4.0]];
    for text in [
        ",-1,0,1\n0,-2,0,2\n4,-3,0.1,4\n",
        "# measured\nload; -1; 0; 1 # rad/s\n0; -2; 0; 2\n\n4; -3; 1e-1; 4",
        "0 -1 0 1\n0 -2 0 2\n4 -3 .1 4\n",
    ] {
        assert_eq!(read_grid(text, "file(\"grid.csv\")"), Ok([knots.clone(), values.clone()]), "{text}");
    }
    assert_eq!(
        read_grid("x\nl,-1,0,1\n0,-2,0,2\n4,-3,.1,4\n", "file(\"grid.csv\", skip = 1)"),
        Ok([knots, values])
    );
    for (text, data, expected) in [
        ("# nothing\n", "file(\"grid.csv\")", "grid.csv` has no line of numbers"),
        (
            ",-1,0,1\n0,-2,0\n",
            "file(\"grid.csv\")",
            "grid.csv`, line 2, column 7: this line has 3 fields, and the first one that is read has 4",
        ),
        (",-1,x,1\n0,-2,0,2\n", "file(\"grid.csv\")", "grid.csv`, line 1, column 5: \"x\" is no number"),
        (
            ",-1,0,1\n0,-2,0,2\n4,-3,one,4\n",
            "file(\"grid.csv\")",
            "grid.csv`, line 3, column 6: \"one\" is no number",
        ),
        (",-1,0,1\n4,-2,0,2\n0,-3,1,4\n", "file(\"grid.csv\")", "0 N follows 4 N (line 3 of `"),
        (",1,0\n4,-2,0\n5,-3,1\n", "file(\"grid.csv\")", "0 rad/s follows 1 rad/s (line 1 of `"),
        (",-1,0,1\n0,-2,0,2\n", "file(\"grid.csv\")", "`drag` has 1 "),
        (
            ",-1,0\n0,-2,0\n4,-3,1\n",
            "file(\"grid.csv\"), columns = (1, 2)",
            "`drag` has two arguments, and is read from all columns: the first line has the values of the first argument behind a field that is left out, each line behind it one of the second argument and the values there",
        ),
        (",-1,0\n0,-2,0\n4,-3,1\n", "file(\"grid.csv\"), bicubic", "`drag` has 2 knots"),
    ] {
        let found = read_grid(text, data).expect_err(text);
        assert!(found.contains(expected), "{text}: {found}");
    }
}

#[test]
fn columns_of_files() {
    let expected = Ok((vec![0.0, 90.0, 180.0], vec![-1.0, 2.5, 3e-3]));
    for (text, data) in [
        ("0,-1\n90,2.5\n180,3e-3\n", "file(\"a.csv\")"),
        ("# a comment\n0 -1\n\n90\t2.5 # another\r\n  180   3e-3", "file(\"a.csv\")"),
        ("angle, lift\n0, -1\n90, 2.5\n180, 0.003\n", "file(\"a.csv\"), columns = (angle, lift)"),
        (
            "\"time\";\"lift [N*m]\";\"angle (deg)\"\n1;-1;0\n2;2.5;90\n3;0.003;180\n",
            "file(\"a.csv\"), columns = (angle, lift)",
        ),
        (
            "Measured by hand\nin May\n9,0,-1\n9,90,2.5\n9,180,.003\n",
            "file(\"a.csv\", skip = 2), columns = (2, 3)",
        ),
        ("\u{feff}x,y\n0,-1\n90,2.5\n180,0.003\n", "file(\"a.csv\")"),
    ] {
        assert_eq!(read("a.csv", text, data), expected, "{text}");
    }
}

#[test]
fn mistakes_in_files() {
    for (text, data, expected) in [
        ("", "file(\"b.csv\")", "b.csv` has no line of numbers behind those that are skipped"),
        (
            "0,1\n2,3,4\n",
            "file(\"b.csv\")",
            "b.csv`, line 2, column 5: this line has 3 fields, and the first one that is read has 2: lines before the table are left \
             out by `skip`",
        ),
        ("0,1\n2\n", "file(\"b.csv\")", "b.csv`, line 2, column 2: this line has 1 fields"),
        (
            "0,1\n90, two\n",
            "file(\"b.csv\")",
            "b.csv`, line 2, column 5: \"two\" is no number: numbers have a decimal point, and comments begin with `#`",
        ),
        ("0,1\n90,nan\n", "file(\"b.csv\")", "b.csv`, line 2, column 4: \"nan\" is no number"),
        (
            "0,1\n",
            "file(\"b.csv\"), columns = (1, 3)",
            "there is no column 3: the file has 2, counted from 1",
        ),
        (
            "0,1\n",
            "file(\"b.csv\"), columns = (angle, 2)",
            "the file has no column called \"angle\"; its columns have no names, and are told by their numbers, `columns = (1, 2)`",
        ),
        (
            "angle,lift\n0,1\n",
            "file(\"b.csv\"), columns = (angel, lift)",
            "the file has no column called \"angel\"; did you mean \"angle\"?",
        ),
        (
            "angle,lift\n0,1\n",
            "file(\"b.csv\"), columns = (stroke, lift)",
            "the file has no column called \"stroke\"; there are angle, lift",
        ),
        ("0,1\n90,2\n# dwell\n80,3\n", "file(\"b.csv\")", "80 deg follows 90 deg (line 4 of `"),
        ("0,1\n90,2\n", "file(\"c.csv\")", "c.csv`; did you mean \""),
    ] {
        let error = read("b.csv", text, data).expect_err("it is wrong");
        assert!(error.contains(expected), "{error}\n  in place of {expected}");
    }
}

/// What is built again when the file changes, and where the page finds it.
#[test]
fn a_file_is_depended_on() {
    let caller = in_file("d.csv", "0,1\n90,2\n");
    let tokens = pendulum("file(\"d.csv\")").parse().expect("tokens");
    let Expansion::Items { text, .. } =
        linkwright_compiler::expand(tokens, |_| Some(Place::somewhere(&caller)))
    else {
        panic!("it expands");
    };
    let path = Path::new(&caller).with_file_name("d.csv");
    assert!(text.contains(&format!("include_bytes!({path:?})")), "{text}");
    let page = text
        .split_once("mechanism_page! {")
        .and_then(|(_, rest)| rest.split_once("})]\n"))
        .expect("a page")
        .0;
    assert!(page.trim_start().starts_with(&format!("in {:?}", path.parent().expect("a folder"))), "{page}");
    let page = linkwright_compiler::expand_page(page.parse().expect("tokens"));
    assert!(page.contains("# Operations"), "{page}");
}
