//! Bodies with the modes of a file: the files that tests of mechanisms use, made here from what they stand for, and every mistake of such a file
//! and of the definition that names it.

use crate::{front_end, good};
use linkwright_compiler::beams::{Counts, Shapes, Slender, Way};
use linkwright_compiler::modal::{Node, Reduced};
use linkwright_compiler::model::Expr;
use linkwright_compiler::source::{self, Source};
use std::fs;
use std::path::PathBuf;

const CLAMPED: &str = "a beam of 1 m, clamped at its start, with the section of 40 mm by 60 mm: E 0.5 GPa, G 0.2 GPa, 2700 kg/m3.\n\
     modes: axial, bending along y twice, along z once, torsion; shapes of the beam with these numbers.";
const BLOCK: &str = "seven points with masses and moments of inertia, moved and turned by three smooth fields, and a full stiffness.";

/// The same modes as `shapes = clamped` has, with the same integrals.
fn clamped() -> Reduced {
    let counts = Counts { axial: 1, bending: 2, bending_z: 1, torsion: 1, quadratic: false };
    let slender = Slender::new(Shapes::Clamped, 1.0, counts);
    let (height, width): (f64, f64) = (0.04, 0.06);
    let area = height * width;
    let (about_z, about_y) = (width * height.powi(3) / 12.0, height * width.powi(3) / 12.0);
    let mass = 2700.0 * area;
    let spin = mass * (about_z + about_y) / area;
    // Roark's constant of a rectangle is of no concern here: this is stated in the mechanism.
    let torsion_constant = 6e-7;
    let rigidity = |way: Way| match way {
        Way::Axial => 0.5e9 * area,
        Way::Bending => 0.5e9 * about_z,
        Way::BendingZ => 0.5e9 * about_y,
        Way::Torsion => 0.2e9 * torsion_constant,
    };
    let n = slender.modes.len();
    let twists = |mode: usize| slender.modes[mode].way == Way::Torsion;
    let axis = |mode: usize| slender.modes[mode].way.axis();
    let along = |mode: usize, part: f64| {
        let mut vector = [0.0; 3];
        if !twists(mode) {
            vector[axis(mode)] = part;
        }
        vector
    };
    let momentum = (0..n).map(|mode| along(mode, mass * slender.first[1 + mode])).collect();
    let angular = |mode: usize| {
        let moment = mass * slender.second[0][1 + mode];
        match slender.modes[mode].way {
            Way::Axial => [0.0; 3],
            Way::Bending => [0.0, 0.0, moment],
            Way::BendingZ => [0.0, -moment, 0.0],
            Way::Torsion => [spin * slender.first[1 + mode], 0.0, 0.0],
        }
    };
    // Which function of the beam a function of the file is.
    let function = |i: usize| match i {
        0 => Some(0),
        1 | 2 => None,
        _ => {
            let (mode, along) = ((i - 3) / 3, (i - 3) % 3);
            (!twists(mode) && axis(mode) == along).then_some(1 + mode)
        }
    };
    let moment = |i: usize, k: usize| match (function(i), function(k)) {
        (Some(i), Some(k)) => mass * slender.second[i][k],
        _ => 0.0,
    };
    let moved = |j: usize| if twists(j) { spin } else { mass };
    let same = |j: usize, k: usize| twists(j) == twists(k) && axis(j) == axis(k);
    let generalised =
        |j: usize, k: usize| if same(j, k) { moved(j) * slender.second[1 + j][1 + k] } else { 0.0 };
    let stiffness = |j: usize, k: usize| {
        if j == k { slender.modes[j].stiffness * rigidity(slender.modes[j].way) } else { 0.0 }
    };
    let node = |number: u64, x: f64| {
        let turned = |(mode, slope): (usize, f64)| match slender.modes[mode].way {
            Way::Axial => [0.0; 3],
            Way::Bending => [0.0, 0.0, slope],
            Way::BendingZ => [0.0, -slope, 0.0],
            Way::Torsion => [slope, 0.0, 0.0],
        };
        Node {
            number,
            at: [x, 0.0, 0.0],
            shifts: slender.values(x).into_iter().enumerate().map(|(mode, it)| along(mode, it)).collect(),
            turns: slender.slopes(x).into_iter().enumerate().map(turned).collect(),
        }
    };
    let across = mass * slender.second[0][0];
    Reduced {
        mass,
        center: [slender.first[0], 0.0, 0.0],
        inertia: [[spin, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, across]],
        momentum,
        angular_momentum: (0..n).map(angular).collect(),
        moments: (0..3 + 3 * n).map(|i| (0..3 + 3 * n).map(|k| moment(i, k)).collect()).collect(),
        generalised_mass: (0..n).map(|j| (0..n).map(|k| generalised(j, k)).collect()).collect(),
        stiffness: (0..n).map(|j| (0..n).map(|k| stiffness(j, k)).collect()).collect(),
        nodes: vec![node(1, 0.0), node(5, 0.4), node(11, 1.0)],
        numbers: (1..=n).collect(),
    }
}

/// Sums over points, of which each has a mass, a tensor of inertia of its own, and moves and turns with the modes.
fn block() -> Reduced {
    const MODES: usize = 3;
    let points: Vec<([f64; 3], f64, [f64; 3])> = (0..7)
        .map(|k| {
            let s = k as f64;
            let at = [0.1 * s, 0.05 * (1.3 * s).sin(), 0.08 * (0.7 * s).cos() + 0.02 * s];
            (at, 0.2 + 0.05 * (2.1 * s).sin(), [2e-4, 3e-4 + 1e-5 * s, 2.5e-4])
        })
        .collect();
    let shift = |mode: usize, [x, y, z]: [f64; 3]| match mode {
        0 => [0.1 * x * z, 1.2 * x * x, 0.3 * x * y],
        1 => [0.2 * y, -0.4 * x * x, 1.5 * x * x - 0.3 * x * x * x],
        _ => [0.5 * x * x, 2.0 * x * z, -1.7 * x * y + 0.2 * x * x],
    };
    // Half of the curl.
    let turn = |mode: usize, [x, y, z]: [f64; 3]| match mode {
        0 => [0.15 * x, 0.05 * x - 0.15 * y, 1.2 * x],
        1 => [0.0, -1.5 * x + 0.45 * x * x, -0.4 * x - 0.1],
        _ => [-1.85 * x, 0.85 * y - 0.2 * x, z],
    };
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let functions = |at: [f64; 3]| -> Vec<f64> {
        at.into_iter().chain((0..MODES).flat_map(|mode| shift(mode, at))).collect()
    };
    let n = 3 + 3 * MODES;
    let mut of = Reduced {
        mass: points.iter().map(|(_, mass, _)| mass).sum(),
        center: [0.0; 3],
        inertia: [[0.0; 3]; 3],
        momentum: vec![[0.0; 3]; MODES],
        angular_momentum: vec![[0.0; 3]; MODES],
        moments: vec![vec![0.0; n]; n],
        generalised_mass: vec![vec![0.0; MODES]; MODES],
        stiffness: vec![vec![900.0, 60.0, -40.0], vec![60.0, 1500.0, 110.0], vec![-40.0, 110.0, 2600.0]],
        nodes: Vec::new(),
        numbers: (1..=MODES).collect(),
    };
    for (at, mass, own) in &points {
        let f = functions(*at);
        for (i, row) in of.moments.iter_mut().enumerate() {
            row.iter_mut().zip(&f).for_each(|(entry, other)| *entry += mass * f[i] * other);
        }
        let square: f64 = at.iter().map(|x| x * x).sum();
        for i in 0..3 {
            of.center[i] += mass * at[i];
            for k in 0..3 {
                let same = f64::from(u8::from(i == k));
                of.inertia[i][k] += mass * (same * square - at[i] * at[k]) + same * own[i];
            }
        }
        for j in 0..MODES {
            let (moved, turned) = (shift(j, *at), turn(j, *at));
            let moment = cross(*at, moved);
            for axis in 0..3 {
                of.momentum[j][axis] += mass * moved[axis];
                of.angular_momentum[j][axis] += mass * moment[axis] + own[axis] * turned[axis];
            }
            for k in 0..MODES {
                let (its, its_turn) = (shift(k, *at), turn(k, *at));
                of.generalised_mass[j][k] += (0..3)
                    .map(|axis| mass * moved[axis] * its[axis] + own[axis] * turned[axis] * its_turn[axis])
                    .sum::<f64>();
            }
        }
    }
    of.center = of.center.map(|it| it / of.mass);
    let node = |(k, (at, _, _)): (usize, &([f64; 3], f64, [f64; 3]))| Node {
        number: 100 + k as u64,
        at: *at,
        shifts: (0..MODES).map(|mode| shift(mode, *at)).collect(),
        turns: (0..MODES).map(|mode| turn(mode, *at)).collect(),
    };
    of.nodes = points.iter().enumerate().filter(|(k, _)| [0, 3, 6].contains(k)).map(node).collect();
    of
}

fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/mechanisms/src/data").join(name)
}

fn read(text: &str) -> Result<Reduced, String> {
    source::modes(&Source::new("arm.flex", text))
}

/// The files are what these functions make, and read back to the same numbers.
#[test]
fn files_are_what_they_stand_for() {
    for (name, about, made) in [("clamped.flex", CLAMPED, clamped()), ("block.flex", BLOCK, block())] {
        let text = made.text(about);
        if std::env::var_os("UPDATE_GOLDEN").is_some() {
            fs::write(data(name), &text).expect("the folder is there");
        }
        assert_eq!(fs::read_to_string(data(name)).expect("the file is there"), text, "{name}");
        let found = read(&text).unwrap_or_else(|message| panic!("{message}"));
        assert_eq!(found.text(about), text);
    }
}

/// The message that a text is refused with.
fn refused(text: &str) -> String {
    read(text).map(|_| ()).expect_err("the file has a mistake")
}

/// Of numbers that something has been done to.
fn refused_when(change: impl Fn(&mut Reduced)) -> String {
    let mut of = block();
    change(&mut of);
    refused(&of.text(""))
}

#[test]
fn files_that_cannot_be_read() {
    let whole = block().text("");
    let changed = |from: &str, to: &str| {
        assert!(whole.contains(from), "{from}");
        refused(&whole.replacen(from, to, 1))
    };
    for (found, expected) in [
        (
            refused(""),
            "`arm.flex`, line 1, column 1: a file of modes begins with `flex 1`, its version: see \"The format `.flex`\" in the documentation",
        ),
        (refused("# words\n  fem 1"), "`arm.flex`, line 2, column 3: a file of modes begins with `flex 1`"),
        (
            changed("flex 1", "flex 2"),
            "`arm.flex`, line 1, column 6: this is version 2 of the format, and version 1 is read here: write the file anew, with `flex 1`",
        ),
        (
            changed("stiffness", "stifness"),
            "`stifness` is no word of a file of modes; did you mean `stiffness`?",
        ),
        (
            changed("stiffness", "springs"),
            "`springs` is no word of a file of modes; there are mass, center, inertia, ",
        ),
        (
            changed("stiffness", "generalised_mass"),
            "`generalised_mass` is there already: leave one of them out",
        ),
        (changed("node 103", "node 100"), "`node 100` is there already"),
        (
            changed("modes   3\n", ""),
            "line 6, column 1: how many numbers `momentum` has follows from the number of modes: write `modes 8` before it",
        ),
        (changed("modes   3", "modes 3 modes 3"), "`modes` is there already"),
        (changed("modes   3", "modes 61"), "a file has 1 to 60 modes, found 61: leave the fastest out"),
        (changed("modes   3", "modes 3.0"), "`modes` is followed by a whole number, found `3.0`"),
        (
            refused("flex 1 modes 2 mass"),
            "line 1, column 16: `mass` has one number, and the file ends behind 0",
        ),
        (
            changed("stiffness\n", "stiffness\n node 5"),
            "`stiffness` has 9 numbers, and behind 0 of them stands `node`",
        ),
        (
            changed("modes   3", "modes 3 4"),
            "column 9: `4` is one number too many: all that belong to the word before it are there",
        ),
        (changed("mass    ", "mass O"), "\" is no number: numbers have a decimal point"),
        (refused("flex 1 mass 2"), "the file ends without `modes`"),
        (refused("flex 1 modes 2 mass 2"), "the file ends without `center`"),
        (
            refused(whole.split("node").next().unwrap_or_default()),
            "the file ends without a node, and nothing could be attached to the body: write `node 17  x y z` and its six rows, one number \
             for each mode: moved along x, y, z and turned about x, y, z",
        ),
    ] {
        assert!(found.contains(expected), "{found}\n{expected}");
    }
    let together = refused_when(|of| of.nodes[2].at = of.nodes[0].at);
    let expected =
        "node 106 is where node 100 is, and places are told apart by where they are: leave one of them out";
    assert!(together.contains(expected), "{together}");
}

#[test]
fn numbers_that_cannot_be() {
    let expected = [
        (refused_when(|of| of.mass = -1.0), "line 2, column 9: the mass must be positive, found -1"),
        (
            refused_when(|of| of.stiffness[2][0] = -41.0),
            "`stiffness` is symmetric, but has -41 in row 3, column 1, and -40 in row 1, column 3",
        ),
        (refused_when(|of| of.moments[3][0] += 0.1), "`moments` is symmetric, but has "),
        (
            refused_when(|of| of.generalised_mass[1][1] = -0.5),
            "the generalised mass of mode 2 must be positive, found -0.5 kg: a mode that moves nothing is none",
        ),
        (
            refused_when(|of| {
                for k in 0..3 {
                    of.generalised_mass[1][k] = of.generalised_mass[0][k];
                }
                for k in 0..3 {
                    of.generalised_mass[k][1] = of.generalised_mass[k][0];
                }
                of.generalised_mass[1][1] = of.generalised_mass[0][0];
            }),
            "the generalised mass is not positive definite: mode 2 moves everything as a sum of those before it does, and is none of its \
             own; leave it out",
        ),
        (
            refused_when(|of| of.center[0] *= 2.0),
            "the integrals do not belong together: that of the square of x over the mass is ",
        ),
        (
            refused_when(|of| of.momentum[1][2] *= -3.0),
            "which its mean alone has. Compare `mass`, `center` and `momentum` with `moments`, all of them about the origin of the frame",
        ),
        (
            refused_when(|of| {
                let wrong = 0.9999 * (of.moments[1][1] * of.moments[4][4]).sqrt();
                (of.moments[1][4], of.moments[4][1]) = (wrong, wrong);
            }),
            ", has a square with the integral -",
        ),
        (
            refused_when(|of| of.inertia[1][1] *= 0.5),
            " kg m² which the moments of x, y and z have: both are about the origin of the frame, not about the centre of mass",
        ),
        (
            refused_when(|of| of.generalised_mass[1][1] *= 0.9),
            " kg which its moments have: one of them is scaled otherwise",
        ),
        (
            refused_when(|of| of.angular_momentum[0][0] += 0.3),
            "`inertia`, `angular_momentum` and `generalised_mass` do not belong together: what they have beyond `moments`, from nodes that \
             turn, is no sum of squares (",
        ),
        (
            refused_when(|of| of.stiffness[0][0] = -900.0),
            "the stiffness is not that of a body at rest: the square of its lowest rate is -",
        ),
        (
            refused(&format!("{}orthogonal\n", block().text(""))),
            "modes are said to be orthogonal here, but the `generalised_mass` of modes 1 and 2 is ",
        ),
    ];
    for (found, expected) in expected {
        assert!(found.contains(expected), "{found}\n{expected}");
    }
    let loose = refused_when(|of| {
        for k in 0..3 {
            (of.stiffness[0][k], of.stiffness[k][0]) = (0.0, 0.0);
        }
    });
    let expected = "1 of the modes has no stiffness; a body that is held has none of these, and one that nothing holds has six";
    assert!(loose.contains(expected), "{loose}");
}

/// The points of the block with their six rigid motions before the three modes.
fn loose() -> Reduced {
    let (of, n) = (block(), 9);
    // φ = t + w × r as combinations of the functions 1, x, y, z.
    let rigid = |mode: usize, axis: usize| -> [f64; 4] {
        let mut parts = [0.0; 4];
        match mode {
            0..3 => parts[0] = f64::from(u8::from(mode == axis)),
            _ => {
                let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
                if mode - 3 == b {
                    parts[1 + c] = 1.0;
                } else if mode - 3 == c {
                    parts[1 + b] = -1.0;
                }
            }
        }
        parts
    };
    let whole = of.whole();
    // Of each new function, its parts of the old ones (1, x, y, z, φ …).
    let parts = |i: usize| -> Vec<f64> {
        let mut parts = vec![0.0; whole.len()];
        match i {
            0..3 => parts[1 + i] = 1.0,
            3..21 => parts[..4].copy_from_slice(&rigid((i - 3) / 3, i % 3)),
            _ => parts[4 + i - 21] = 1.0,
        }
        parts
    };
    let integral = |one: &[f64], other: &[f64]| -> f64 {
        let pairs = (0..whole.len()).flat_map(|i| (0..whole.len()).map(move |k| (i, k)));
        of.mass * pairs.map(|(i, k)| one[i] * whole[i][k] * other[k]).sum::<f64>()
    };
    let count = 3 + 3 * n;
    let moments: Vec<Vec<f64>> =
        (0..count).map(|i| (0..count).map(|k| integral(&parts(i), &parts(k))).collect()).collect();
    let mut one = vec![0.0; whole.len()];
    one[0] = 1.0;
    let rotary = of.rotary();
    // What turns with each mode: rigid ones turn all by w.
    let turned = |i: usize, k: usize| match (i, k) {
        (0..3, _) | (_, 0..3) => 0.0,
        (3..6, 3..6) => rotary.inertia[i - 3][k - 3],
        (3..6, _) => rotary.momentum[k - 6][i - 3],
        (_, 3..6) => rotary.momentum[i - 6][k - 3],
        _ => rotary.modal[i - 6][k - 6],
    };
    let placed = |j: usize, k: usize| -> f64 { (0..3).map(|a| moments[3 + 3 * j + a][3 + 3 * k + a]).sum() };
    let swept = |mode: usize, a: usize| {
        let (b, c) = ((a + 1) % 3, (a + 2) % 3);
        moments[b][3 + 3 * mode + c] - moments[c][3 + 3 * mode + b]
    };
    let node = |node: &Node| {
        let moved = |mode: usize| {
            [0, 1, 2].map(|axis| {
                let [t, x, y, z] = rigid(mode, axis);
                t + x * node.at[0] + y * node.at[1] + z * node.at[2]
            })
        };
        let turned = |mode: usize| [0, 1, 2].map(|axis| f64::from(u8::from(mode == 3 + axis)));
        Node {
            shifts: (0..6).map(moved).chain(node.shifts.iter().copied()).collect(),
            turns: (0..6).map(turned).chain(node.turns.iter().copied()).collect(),
            ..node.clone()
        }
    };
    let stiff = |i: usize, k: usize| if i < 6 || k < 6 { 0.0 } else { of.stiffness[i - 6][k - 6] };
    Reduced {
        momentum: (0..n).map(|j| [0, 1, 2].map(|a| integral(&one, &parts(3 + 3 * j + a)))).collect(),
        angular_momentum: (0..n)
            .map(|j| [0, 1, 2].map(|a| swept(j, a) + if j < 3 { 0.0 } else { turned(3 + a, j) }))
            .collect(),
        generalised_mass: (0..n).map(|j| (0..n).map(|k| placed(j, k) + turned(j, k)).collect()).collect(),
        stiffness: (0..n).map(|j| (0..n).map(|k| stiff(j, k)).collect()).collect(),
        nodes: of.nodes.iter().map(node).collect(),
        numbers: (1..=n).collect(),
        moments,
        ..of
    }
}

/// Six rigid motions are known by K and checked against the integrals and the nodes; nothing else may be among them.
#[test]
fn rigid_modes() {
    let of = loose();
    let text = of.text("");
    let found = read(&text).unwrap_or_else(|message| panic!("{message}"));
    assert_eq!(found.modes(), 9);
    // Without them it is the block.
    let (left, block) = (found.only(7..=9), block());
    for (row, expected) in left.generalised_mass.iter().zip(&block.generalised_mass) {
        row.iter().zip(expected).for_each(|(a, b)| assert!((a - b).abs() < 1e-14));
    }
    let changed = |change: &dyn Fn(&mut Reduced)| {
        let mut of = loose();
        change(&mut of);
        refused(&of.text(""))
    };
    for (found, expected) in [
        (
            changed(&|of| of.nodes[1].shifts[4][2] += 0.1),
            "mode 5 is a rigid motion that moves node 103 by -0.3 along z, and the rows of the node have -0.2",
        ),
        (
            changed(&|of| of.generalised_mass[1][1] *= 1.1),
            "mode 2 has no stiffness, and is no rigid motion: its generalised mass is ",
        ),
        (
            changed(&|of| {
                let last = of.stiffness[8].clone();
                of.stiffness[0] = last.clone();
                for (row, entry) in of.stiffness.iter_mut().zip(&last) {
                    row[0] = *entry;
                }
                of.stiffness[0][0] = last[8];
            }),
            "six motions have no stiffness, and mode 1, at ",
        ),
    ] {
        assert!(found.contains(expected), "{found}\n{expected}");
    }
}

/// A definition with a flexible body of the file `block.flex`, and what is said of it.
fn told(inside: &str, rest: &str) -> String {
    let file = data("block.flex");
    let source = format!(
        "spatial Told {{ flexible arm(file = {:?}) {{ point a = node(100); point b = node(106); {inside} }} \
         joint base: fixed(ground(0, 0, 0) [m], arm.a); output end [m] = arm.b.x; {rest} }}",
        file.display().to_string()
    );
    match front_end(&source) {
        Ok(_) => String::new(),
        Err(errors) => errors.to_string(),
    }
}

#[test]
fn definitions_with_mistakes() {
    assert_eq!(told("mass [kg] = 1.4; modes = 2..3; damping_ratio = 0.01;", ""), "");
    for (found, expected) in [
        (told("point c = node(7);", ""), "block.flex` has no node 7; it has 100, 103, 106"),
        (told("modes = 1..4;", ""), "block.flex` has 3 modes, and there is no mode 4: write `1..3` at most"),
        (
            told("modes = 3..1;", ""),
            "modes are numbered from 1 on, the lower number first, found 3..1: both ends are taken",
        ),
        (
            told("modes = (axial = 1);", ""),
            "expected modes by their numbers in the file, such as `modes = 1..8;`",
        ),
        (told("modes = 1; modes = 2;", ""), "`modes` of `arm` is given twice"),
        (
            told("point c [m] = (1, 0, 0);", ""),
            "how a place of the flexible body `arm` moves is known at nodes of its file alone: write `point bearing = node(17);` with the \
             number of one",
        ),
        (
            told("marker c [m] = (1, 0, 0);", ""),
            "a marker on the flexible body `arm` would have to deform with it: fix a body to one of its nodes and give that the marker",
        ),
        (told("inertia [kg*m^2] = (1, 1, 1);", ""), "the inertia of `arm` is that of its file: leave it out"),
        (
            told("length [m] = 1;", ""),
            "a flexible body has no `length`; it has mass, damping_ratio, modes, and points at nodes",
        ),
        (told("mass [kg] = 1.5;", ""), "the mass of `arm` is written as 1.5 kg, and `"),
        (told("mass [kg] = 1.5;", ""), "block.flex` has 1.400849 kg: correct it or leave it out"),
        (
            told("damping_ratio = -1;", ""),
            "the damping ratio of the flexible body `arm` must not be negative, found -1",
        ),
        (
            told("", "output q [m] = arm.mode[4];"),
            "`arm` has no mode `arm.mode[4]`; it has `arm.mode[1]` to `arm.mode[3]`, each with `.rate`",
        ),
        (
            told("modes = 2;", "output q [m] = arm.mode[1];"),
            "`arm` has no mode `arm.mode[1]`; it has `arm.mode[2]`, each with",
        ),
        (
            told("", "torque t: torque(arm) = (1, 0, 0) [N*m];"),
            "a torque on the flexible body `arm` deforms it where it acts: let it act on a joint at one of its nodes, whose angle is that \
             of the node",
        ),
        (
            told("", "force f: force(arm.origin) = (1, 0, 0) [N];"),
            "`arm.origin` is the frame of a flexible body and no node of it, so that nothing can be attached to it: write a `point` at a \
             node",
        ),
        (
            told("", "expect { frequency(arm.mode[2]) >= 50 [Hz]; }"),
            "`arm.mode[2]` has 20.9359 Hz by itself, less than the 50 Hz expected",
        ),
        (
            told("", "flexible other { }"),
            "the modes of a flexible body stand in a file: write `flexible other(file = \"other.flex\") { … }`",
        ),
    ] {
        assert!(found.contains(expected), "{found}\n{expected}");
    }
}

/// What is built is built anew when the file changes, and has the mass of the file about its centre.
#[test]
fn a_body_is_that_of_its_file() {
    let file = data("block.flex");
    let mechanism = good(&format!(
        "spatial Told {{ flexible arm(file = {:?}) {{ point a = node(100); }} output end [m] = arm.a.x; }}",
        file.display().to_string()
    ));
    assert!(mechanism.files().any(|file| file.path.ends_with("block.flex")));
    let (body, block) = (&mechanism.bodies[0], block());
    let number = |expr: &Expr| match expr {
        Expr::Number(value) => *value,
        other => panic!("{other:?} is no number"),
    };
    assert_eq!(number(&body.mass), block.mass);
    let [x, y, z] = block.center;
    let own = number(&body.inertia.moments[0]) + block.mass * (y * y + z * z);
    assert!((own - block.inertia[0][0]).abs() < 1e-15);
    assert!((number(&body.inertia.products[1]) - block.mass * x * z - block.inertia[0][2]).abs() < 1e-15);
    assert_eq!(mechanism.modes().len(), 3);
}

/// The six rigid motions of a file are left out by who takes it.
#[test]
fn rigid_modes_are_not_taken() {
    let folder = std::env::temp_dir().join(format!("linkwright-flexible-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("loose.flex");
    fs::write(&file, loose().text("")).expect("a file");
    let with = |modes: &str, file: &PathBuf| {
        let source = format!(
            "spatial Loose {{ flexible arm(file = {:?}) {{ point a = node(100); {modes} }} output end [m] = arm.a.x; }}",
            file.display().to_string()
        );
        front_end(&source).map(|_| ()).map_err(|errors| errors.to_string())
    };
    let expected = "modes 1 to 6 of the file are rigid motions, which the frame of `arm` has anyway: write `modes = 7..9;`";
    for modes in ["", "modes = 6..9;"] {
        let found = with(modes, &file).expect_err("they are taken");
        assert!(found.contains(expected), "{found}");
    }
    assert_eq!(with("modes = 7..9;", &file), Ok(()));
    let only = folder.join("only.flex");
    fs::write(&only, loose().only(1..=6).text("")).expect("a file");
    let found = with("", &only).expect_err("there is nothing else");
    assert!(
        found.contains(
            "all modes of the file are rigid motions, which the frame of `arm` has anyway: take `body`"
        ),
        "{found}"
    );
    fs::remove_dir_all(&folder).expect("it is ours");
}
