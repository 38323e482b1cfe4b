//! A finite element model becomes a file of modes, and what takes it moves as the beam of the language.

mod finite_elements;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn linkwright(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_linkwright"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the program is built")
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).expect("it writes text")
}

/// What it writes, where all is well.
fn well(folder: &Path, arguments: &[&str]) -> String {
    let Output { status, stdout, stderr } = linkwright(folder, arguments);
    let stderr = text(stderr);
    assert!(status.success(), "{arguments:?}: {stderr}");
    text(stdout)
}

/// A folder of its own with M, K and nodes of a bar.
fn files(name: &str, elements: usize) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("the folder can be made");
    let beam = finite_elements::beam(elements);
    let rows = finite_elements::ROWS * beam.nodes.len();
    let write =
        |name: &str, text: String| std::fs::write(folder.join(name), text).expect("it can be written");
    for (name, entries) in [("M.mtx", &beam.mass), ("K.mtx", &beam.stiffness)] {
        let lines: String =
            entries.iter().map(|(i, k, value)| format!("{} {} {value:e}\n", i + 1, k + 1)).collect();
        let head = "%%MatrixMarket matrix coordinate real general";
        write(name, format!("{head}\n{rows} {rows} {}\n{lines}", entries.len()));
    }
    let lines: String =
        beam.nodes.iter().map(|(number, [x, y, z])| format!("{number},{x},{y},{z}\n")).collect();
    write("nodes.csv", format!("node,x,y,z\n{lines}"));
    folder
}

/// An arm on a hub that turns, and which swings under its weight, with a block at its end.
fn mechanism(arm: &str) -> String {
    format!(
        "spatial Arm {{
    gravity [m/s^2] = (0, -4, -9.81);
    body hub {{ mass [kg] = 1; inertia [kg*m^2] = (0.2, 0.2, 0.2); }}
    {arm}
    body block {{ mass [kg] = 0.2; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); }}
    joint base: revolute(ground(0, 0, 0) [m], hub.origin, axis = (0, 0, 1));
    joint root: fixed(hub.origin, arm.start);
    joint hold: fixed(arm.end, block.origin);
    start {{ base.angle [rad] = 0.2; base.rate [rad/s] = 3; }}
    output y [mm] = block.center.y;
    output z [mm] = block.center.z;
}}
"
    )
}

/// The rows of y and z, mm, by the program's own run.
fn moved(folder: &Path, name: &str, text: String) -> Vec<[f64; 2]> {
    std::fs::write(folder.join(name), text).expect("it can be written");
    let out = well(
        folder,
        &["run", name, "--for", "100ms", "--step", "10us", "--every", "1ms", "--show", "outputs"],
    );
    let rows = out.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    rows.map(|line| {
        let values: Vec<f64> = line.split(',').map(|it| it.trim().parse().expect(line)).collect();
        [values[1], values[2]]
    })
    .collect()
}

/// By the file of a bar of finite elements the arm moves as with the beam, the nearer the shorter the elements: their masses are lumped, which
/// lowers frequencies by the square of the length of an element.
#[test]
fn a_bar_of_finite_elements_moves_as_the_beam() {
    use finite_elements::{DENSITY, SHEAR, TORSION, YOUNG, area, second_moments};
    let [about_z, about_y] = second_moments();
    let beam = format!(
        "#[allow(slender)] beam arm {{ length [m] = 1; area [m^2] = {:e}; second_moment_z [m^4] = {about_z:e}; second_moment_y [m^4] = {about_y:e};
        torsion_constant [m^4] = {TORSION:e}; young [Pa] = {YOUNG:e}; shear_modulus [Pa] = {SHEAR:e}; density [kg/m^3] = {DENSITY:e};
        modes = (bending_y = 4, bending_z = 4, torsion = 1); shapes = static; }}",
        area()
    );
    let mut errors = Vec::new();
    for elements in [8, 16] {
        let folder = files(&format!("flexible-{elements}"), elements);
        let end = (10 + elements).to_string();
        let import = [
            "flexible",
            "import",
            "M.mtx",
            "K.mtx",
            "nodes.csv",
            "--held",
            "10",
            "--interface",
            &end,
            "--modes",
            "6",
        ];
        let to_file = [&import[..], &["--out", "bar.flex"]].concat();
        assert_eq!(well(&folder, &to_file), "");
        let written = std::fs::read_to_string(folder.join("bar.flex")).expect("it was written");
        assert_eq!(well(&folder, &import), written);
        assert!(written.starts_with("# Craig and Bampton's modes of M.mtx, K.mtx: held [10], interface ["));
        // Without the row along x, which the beam has not.
        let file = format!(
            "flexible arm(file = \"bar.flex\") {{ point start = node(10); point end = node({end}); modes = 2..12; }}"
        );
        let by_file = moved(&folder, "file.mech", mechanism(&file));
        let by_beam = moved(&folder, "beam.mech", mechanism(&beam));
        assert_eq!((by_file.len(), by_beam.len()), (101, 101));
        let largest = by_beam.iter().map(|row| row[1].abs()).fold(0.0, f64::max);
        let off = |axis: usize| by_file.iter().zip(&by_beam).map(move |(a, b)| (a[axis] - b[axis]).abs());
        errors.push(off(0).chain(off(1)).fold(0.0, f64::max) / largest);
    }
    assert!(errors[1] < 3e-3 && errors[1] < 0.3 * errors[0], "{errors:?}");
}

/// What is wrong is said before a file is written.
#[test]
fn wrong_usage_is_said() {
    let folder = files("flexible-wrong", 2);
    for (arguments, code, message) in [
        (
            &["flexible", "export"] as &[&str],
            2,
            "`flexible` knows `import` and nothing else, found \"export\"",
        ),
        (
            &["flexible", "import", "M.mtx", "K.mtx"],
            2,
            "flexible import takes three files or one, 2 are given",
        ),
        (
            &["flexible", "import", "M.mtx", "K.mtx", "nodes.csv"],
            2,
            "--held names the nodes that have the frame",
        ),
        (
            &["flexible", "import", "bar.fem", "--held", "1"],
            2,
            "`bar.fem` has its modes, and takes no --held: leave it out",
        ),
        (
            &["flexible", "import", "arm.SID_FEM"],
            2,
            "`arm.SID_FEM` is standard input data (SID, Wallrapp 1994)",
        ),
        (
            &["flexible", "import", "arm.mnf"],
            2,
            "`arm.mnf` is a modal neutral file, whose format is not published",
        ),
        (
            &["flexible", "import", "arm.dat"],
            2,
            "`arm.dat` alone is no modal data: its name ends in .fem (MBDyn)",
        ),
        (&["flexible", "import", "bar.fem"], 1, "`bar.fem` cannot be read"),
        (
            &["flexible", "import", "M.mtx", "K.mtx", "nodes.csv", "--held", "x"],
            2,
            "--held takes numbers of nodes, such as 1,17; found \"x\"",
        ),
        (
            &["flexible", "import", "M.mtx", "K.mtx", "nodes.csv", "--held", "10", "--modes", "-1"],
            2,
            "--modes takes a whole number, found \"-1\"",
        ),
        (
            &[
                "flexible",
                "import",
                "M.mtx",
                "K.mtx",
                "nodes.csv",
                "--held",
                "10",
                "--interface",
                "12",
                "--out",
                "no/where.flex",
            ],
            1,
            "`no/where.flex` cannot be written",
        ),
        (
            &["flexible", "import", "M.mtx", "K.mtx", "nodes.csv", "--held", "10", "--interface", "99"],
            1,
            "there is no node 99 among the 3 of the file",
        ),
    ] {
        let Output { status, stderr, .. } = linkwright(&folder, arguments);
        let stderr = text(stderr);
        assert!(stderr.contains(message) && status.code() == Some(code), "{arguments:?}: {status} {stderr}");
    }
    assert!(well(&folder, &["flexible", "--help"]).contains("usage: linkwright flexible import"));
}
