//! A beam of finite elements, assembled here: its frequencies against those of the clamped bar, and what is refused.

use super::craig_bampton::{reduced, shapes};
use super::fem;
use super::integrals::Placed;
use super::market::{self, Matrix};
use super::model::{Model, ROWS, nodes};
use linkwright_compiler::modal::{cholesky, eigen, reduced_by};
use linkwright_compiler::source::{self, Source};

#[path = "../../tests/finite_elements/mod.rs"]
mod finite_elements;

use finite_elements::{DENSITY, LENGTH, YOUNG, area, second_moments};

/// The bar as files have it.
fn beam(elements: usize) -> (Vec<Placed>, Matrix, Matrix) {
    let found = finite_elements::beam(elements);
    let rows = ROWS * found.nodes.len();
    let matrix = |name: &str, entries| Matrix { name: name.to_string(), rows, entries };
    (found.nodes, matrix("M.mtx", found.mass), matrix("K.mtx", found.stiffness))
}

fn rates(of: &linkwright_compiler::modal::Reduced) -> Vec<f64> {
    let l = cholesky(&of.generalised_mass).expect("it is positive definite");
    let mut squares = eigen(&reduced_by(&l, &of.stiffness)).0;
    squares.sort_by(f64::total_cmp);
    squares.into_iter().map(f64::sqrt).collect()
}

/// ω = (λ/L)² √(EI/ρA), λ = 1.875104, 4.694091 (Blevins, table 8-1); lumped masses are off by the square of the elements' length. The file keeps
/// to all rules of a file, and the end deflects as a cantilever.
#[test]
fn a_clamped_bar() {
    let mut errors = Vec::new();
    for elements in [20, 40] {
        let (nodes, mass, stiffness) = beam(elements);
        let end = 10 + elements as u64;
        let model = Model::new(nodes, &mass, &stiffness).expect("it is lumped");
        let natural = reduced(&model, &[10], &[], 6).expect("it is clamped");
        let joined = reduced(&model, &[10], &[end], 4).expect("it is clamped");
        let inertia = second_moments();
        let bar =
            |moment: f64, root: f64| (root / LENGTH).powi(2) * (YOUNG * moment / (DENSITY * area())).sqrt();
        let mut expected: Vec<f64> = inertia
            .iter()
            .flat_map(|it| [1.875_104_068_711_961, 4.694_091_132_974_175].map(|root| bar(*it, root)))
            .collect();
        expected.sort_by(f64::total_cmp);
        let found = rates(&natural);
        let worst = |found: &[f64]| {
            let off = expected.iter().zip(found).map(|(expected, found)| (found / expected - 1.0).abs());
            off.fold(0.0, f64::max)
        };
        errors.push(worst(&found));
        // With a clamped end and its six rows the slowest are the same.
        let by_interface = rates(&joined);
        for (found, expected) in by_interface.iter().zip(&found).take(2) {
            assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
        }
        // A force at the end: p = K⁻¹ f of the row along y alone, L³/3EI.
        let stiffness_at_end = cholesky(&joined.stiffness).expect("it is positive definite");
        let n = joined.modes();
        let mut p = vec![0.0; n];
        p[1] = 1.0;
        for i in 0..n {
            let sum: f64 = (0..i).map(|k| stiffness_at_end[i][k] * p[k]).sum();
            p[i] = (p[i] - sum) / stiffness_at_end[i][i];
        }
        for i in (0..n).rev() {
            let sum: f64 = (i + 1..n).map(|k| stiffness_at_end[k][i] * p[k]).sum();
            p[i] = (p[i] - sum) / stiffness_at_end[i][i];
        }
        let closed = LENGTH.powi(3) / (3.0 * YOUNG * inertia[0]);
        assert!((p[1] / closed - 1.0).abs() < 1e-7, "{} {closed}", p[1]);
        let mass = DENSITY * area() * LENGTH;
        assert!((joined.mass / mass - 1.0).abs() < 1e-12);
        assert!((joined.center[0] - 0.5 * LENGTH).abs() < 1e-12);
        let text = joined.text("");
        source::modes(&Source::new("bar.flex", text)).unwrap_or_else(|message| panic!("{message}"));
    }
    assert!(errors[0] < 6e-3 && errors[1] < 0.27 * errors[0], "{errors:?}");
}

#[test]
fn models_that_are_refused() {
    let (nodes_of, mass, stiffness) = beam(3);
    let refused = |change: &dyn Fn(&mut Matrix)| {
        let mut changed = mass.clone();
        change(&mut changed);
        Model::new(nodes_of.clone(), &changed, &stiffness).map(|_| ()).expect_err("it is refused")
    };
    let coupled = refused(&|mass| mass.entries.extend([(1, 5, 0.1), (5, 1, 0.1)]));
    assert!(coupled.contains("for nodes 10 and 10, along y and about z, where 0e0 is expected"), "{coupled}");
    let uneven = refused(&|mass| mass.entries.push((1, 1, 0.1)));
    assert!(uneven.contains("let the code write lumped masses"), "{uneven}");
    let asymmetric = refused(&|mass| mass.entries.push((1, 0, 0.1)));
    assert!(
        asymmetric
            .contains("`M.mtx` is not symmetric: 0e0 in row 1 and column 2, 1e-1 in row 2 and column 1")
            || asymmetric
                .contains("`M.mtx` is not symmetric: 1e-1 in row 2 and column 1, 0e0 in row 1 and column 2"),
        "{asymmetric}"
    );
    let short = refused(&|mass| mass.rows = 12);
    assert!(short.contains("`M.mtx` has 12 rows, and 4 nodes have 24: six each"), "{short}");
    let model = Model::new(nodes_of.clone(), &mass, &stiffness).expect("it is lumped");
    let reduce = |held: &[u64], interface: &[u64], modes: usize| {
        reduced(&model, held, interface, modes).map(|_| ()).expect_err("it is refused")
    };
    assert!(reduce(&[9], &[], 1).contains("there is no node 9 among the 4 of the file"));
    assert!(
        reduce(&[10], &[10], 1).contains("node 10 is held, and does not move: leave it out of --interface")
    );
    assert!(reduce(&[10], &[], 0).contains("nothing is left to move"));
    assert!(reduce(&[10], &[], 19).contains("18 rows between the nodes have as many modes, and not 19"));
    assert!(
        reduce(&[10], &[], 18)
            .contains("rows between the nodes have mass, and not 18: ask for fewer --modes")
    );
    // Nothing holds the turn about the axis; the last pivot of its rows is rounding, and not nothing.
    let mut swivels = stiffness.clone();
    swivels.entries.retain(|(i, k, _)| i % ROWS != 3 && k % ROWS != 3);
    for (one, other, spring) in [(9, 15, 0.1), (15, 21, 0.7)] {
        swivels.entries.extend([
            (one, one, spring),
            (other, other, spring),
            (one, other, -spring),
            (other, one, -spring),
        ]);
    }
    let swivels = Model::new(nodes_of.clone(), &mass, &swivels).expect("it is lumped");
    let message = reduced(&swivels, &[10], &[], 1).map(|_| ()).expect_err("it turns");
    assert!(message.contains("the stiffness is not positive definite"), "{message}");
    let mut loose = stiffness.clone();
    loose.entries.retain(|(i, k, _)| i / ROWS < 3 && k / ROWS < 3);
    let loose = Model::new(nodes_of, &mass, &loose).expect("it is lumped");
    let message = reduced(&loose, &[10], &[], 1).map(|_| ()).expect_err("it is loose");
    assert!(
        message.contains("the stiffness is not positive definite where nodes are held and joined"),
        "{message}"
    );
}

#[test]
fn matrices_of_files() {
    let read = |text: &str| market::read("K.mtx", text);
    let symmetric = "%%MatrixMarket matrix coordinate real symmetric\n% of a bar\n2 2 2\n1 1 4\n2 1 -3.5e0\n";
    assert_eq!(read(symmetric).expect("it is well").entries, [(0, 0, 4.0), (1, 0, -3.5), (0, 1, -3.5)]);
    let array = "%%MatrixMarket matrix array real general\n2 2\n1\n2\n0\n4\n";
    assert_eq!(read(array).expect("it is well").entries, [(0, 0, 1.0), (1, 0, 2.0), (1, 1, 4.0)]);
    for (text, expected) in [
        ("", "`K.mtx`, line 1: a matrix begins with `%%MatrixMarket matrix coordinate real symmetric`"),
        ("%%MatrixMarket matrix coordinate complex general\n1 1 1\n", "line 1: a matrix begins with"),
        (
            "%%MatrixMarket matrix coordinate real general\n",
            "line 1: the file ends before the size of the matrix",
        ),
        (
            "%%MatrixMarket matrix coordinate real general\n2 3 1\n",
            "line 2: the matrix is square, found 2 rows and 3 columns",
        ),
        (
            "%%MatrixMarket matrix coordinate real general\n2 2 1\n1 x 2\n",
            "line 3: 3 numbers stand here, found `1 x 2`",
        ),
        (
            "%%MatrixMarket matrix coordinate real general\n2 2 1\n1 3 2\n",
            "line 3: row 1 and column 3 are not within 1 to 2",
        ),
        (
            "%%MatrixMarket matrix coordinate real general\n2 2 2\n1 1 2\n",
            "has 2 entries by its size, and ends behind 1",
        ),
        (
            "%%MatrixMarket matrix coordinate real general\n2 2 1\n1 1 2\n2 2 3\n",
            "line 4: all entries of the matrix stand before this line, found `2 2 3`",
        ),
        (
            "%%MatrixMarket matrix coordinate real symmetric\n2 2 1\n1 2 2\n",
            "line 3: a symmetric matrix has its lower half alone",
        ),
        (
            "%%MatrixMarket matrix coordinate real general\n2 2 1\n1.5 2 2\n",
            "line 3: row 1.5 and column 2 are not within 1 to 2",
        ),
        (
            "%%MatrixMarket matrix coordinate real general\n2.5 2.5 1\n1 1 2\n",
            "sizes are whole numbers, found 2.5",
        ),
    ] {
        let found = read(text).map(|_| ()).expect_err(text);
        assert!(found.contains(expected), "{found}\n{expected}");
    }
}

#[test]
fn nodes_of_files() {
    let read = |text: &str| nodes("nodes.csv", text);
    let expected = vec![(1, [0.0, 0.0, 0.0]), (7, [0.5, -1.0, 2.0])];
    assert_eq!(read("node,x,y,z\n1, 0, 0, 0\n7;0.5;-1;2 # the end\n"), Ok(expected));
    for (text, expected) in [
        ("", "`nodes.csv` has no nodes"),
        ("1 0 0\n", "`nodes.csv`, line 1: a node is its number and x, y, z, found `1 0 0`"),
        ("1 0 0 0\n1 0 0 1\n", "line 2: node 1 is there already"),
    ] {
        assert_eq!(read(text).map(|_| ()).map_err(|found| found.contains(expected)), Err(true), "{text}");
    }
}

/// A model's modes as MBDyn has them.
fn modal_data(model: &Model, shapes: &[Vec<f64>], of: &linkwright_compiler::modal::Reduced) -> String {
    let lines = |values: &[f64], width: usize| -> String {
        let line = |row: &[f64]| row.iter().map(|it| format!(" {it:.17E}")).collect::<String>() + "\n";
        values.chunks(width).map(line).collect()
    };
    let count = model.nodes.len();
    let group =
        |number: usize, what: &str, text: String| format!("** RECORD GROUP {number}, {what}\n{text}**\n");
    let axis = |axis: usize| lines(&model.nodes.iter().map(|node| node.1[axis]).collect::<Vec<_>>(), 1);
    let shape = |(k, shape): (usize, &Vec<f64>)| {
        format!("**    NORMAL MODE SHAPE #  {}\n{}", k + 1, lines(shape, ROWS))
    };
    let lumped: Vec<f64> = (0..ROWS * count).map(|row| model.mass[(row, row)]).collect();
    let (moments, products) = of.about_center();
    let [[xx, yy, zz], [xy, xz, yz]] = [moments, products];
    let rigid = [of.mass]
        .iter()
        .chain(&of.center)
        .chain(&[xx, xy, xz, xy, yy, yz, xz, yz, zz])
        .copied()
        .collect::<Vec<_>>();
    let numbers: Vec<String> = model.nodes.iter().map(|node| node.0.to_string()).collect();
    let header = format!(
        "**   REVISION,  NODE,  NORMAL, ATTACHMENT, CONSTRAINT, REJECTED MODES.\n REV0 {count} {} 0 1 1\n",
        shapes.len()
    );
    [
        "** MBDyn MODAL DATA FILE\n** NODE SET \"ALL\"\n".to_string(),
        group(1, "HEADER", header),
        group(2, "FINITE ELEMENT NODE LIST", numbers.join(" ") + "\n"),
        group(3, "INITIAL MODAL DISPLACEMENTS", lines(&vec![0.0; shapes.len()], shapes.len())),
        group(5, "NODAL X COORDINATES", axis(0)),
        group(6, "NODAL Y COORDINATES", axis(1)),
        group(7, "NODAL Z COORDINATES", axis(2)),
        group(8, "MODE SHAPES", shapes.iter().enumerate().map(shape).collect()),
        group(9, "MODAL MASS MATRIX", lines(&of.generalised_mass.concat(), shapes.len())),
        // As Fortran writes.
        group(10, "MODAL STIFFNESS MATRIX", lines(&of.stiffness.concat(), shapes.len()).replace('E', "D")),
        group(11, "DIAGONAL OF LUMPED MASS MATRIX", lines(&lumped, ROWS)),
        group(12, "RIGID BODY INERTIA MATRIX", lines(&rigid, 13)),
    ]
    .concat()
}

/// What lumped masses and shapes of such a file add up to is what the model itself has.
#[test]
fn modal_data_of_mbdyn() {
    let (nodes, mass, stiffness) = beam(12);
    let model = Model::new(nodes, &mass, &stiffness).expect("it is lumped");
    let expected = reduced(&model, &[10], &[22], 3).expect("it is clamped");
    let rows = |nodes: std::ops::Range<usize>| (ROWS * nodes.start..ROWS * nodes.end).collect::<Vec<_>>();
    let shapes = shapes(&model, &rows(12..13), &rows(1..12), 3).expect("it is clamped");
    let text = modal_data(&model, &shapes, &expected);
    let found = fem::read("bar.fem", &text).expect("it is well");
    let near = |found: &[f64], expected: &[f64], what: &str| {
        let size = expected.iter().fold(0.0, |size: f64, it| size.max(it.abs()));
        assert_eq!(found.len(), expected.len(), "{what}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-12 * size, "{what}: {found} {expected}");
        }
    };
    near(&[found.mass], &[expected.mass], "mass");
    near(&found.center, &expected.center, "centre");
    near(found.inertia.as_flattened(), expected.inertia.as_flattened(), "inertia");
    near(&found.moments.concat(), &expected.moments.concat(), "moments");
    near(found.momentum.as_flattened(), expected.momentum.as_flattened(), "momentum");
    near(found.angular_momentum.as_flattened(), expected.angular_momentum.as_flattened(), "angular momentum");
    near(&found.generalised_mass.concat(), &expected.generalised_mass.concat(), "mass of modes");
    near(&found.stiffness.concat(), &expected.stiffness.concat(), "stiffness");
    assert_eq!(found.nodes.len(), 13);
    source::modes(&Source::new("bar.flex", found.text(""))).unwrap_or_else(|message| panic!("{message}"));
    let last = found.nodes.last().map(|node| node.shifts.as_flattened().to_vec());
    let joined = expected.nodes.last().map(|node| node.shifts.as_flattened().to_vec());
    assert_eq!((found.nodes[12].number, last), (22, joined));

    let refused = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        fem::read("bar.fem", &text.replacen(from, to, 1)).map(|_| ()).expect_err(to)
    };
    for (from, to, expected) in [
        ("GROUP 11,", "GROUP 21,", "`bar.fem` has no record group 11, the lumped masses of its nodes"),
        ("GROUP 9,", "GROUP 99,", "`bar.fem` has no record group 9"),
        ("GROUP 9,", "GROUP,", "a record group has a number"),
        (" REV0 13 9 0 1 1", " REV0 13 9 0 1", "line 3: the header has a word and five whole numbers"),
        (" REV0 13 9 0 1 1", " REV0 13 9 0 1 10", "more modes are rejected than there are, or as many"),
        (
            " REV0 13 9 0 1 1",
            " REV0 14 9 0 1 1",
            "record group 2 has 13 numbers, and not 14: one for each node",
        ),
        ("10 11 12", "10 eleven 12", "numbers stand here, found `eleven`"),
        ("GROUP 1, HEADER", "", "it is no modal data of MBDyn"),
    ] {
        let text = if to.is_empty() { "** nothing\n1 2 3\n".to_string() } else { refused(from, to) };
        let message =
            if to.is_empty() { fem::read("bar.fem", &text).map(|_| ()).expect_err("nothing") } else { text };
        assert!(message.contains(expected), "{message}\n{expected}");
    }
    let lumped = format!(" {:.17E}", model.mass[(ROWS, ROWS)]);
    let uneven = refused(&lumped, " 0.5");
    assert!(uneven.contains("the lumped masses of node 2 of 13 are 0.5"), "{uneven}");
    let rigid = format!(" {:.17E}", expected.mass);
    let heavy = refused(&rigid, " 0.9");
    assert!(heavy.contains("the mass is 0.9 kg here, and 0.5"), "{heavy}");
}
