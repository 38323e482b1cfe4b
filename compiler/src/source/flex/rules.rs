//! What numbers of a `.flex` file have to be to one another, whichever program wrote them.

use super::read::{At, Places};
use crate::messages;
use crate::modal::{EQUAL, Reduced, Square, cholesky, eigen, reduced_by};

type Found = Result<(), (At, String)>;

/// Squares of rates below this part of the largest are those of rigid motions.
const RIGID: f64 = 1e-10;

/// To which nodes move as the rigid motion of a mode moves them, of the size of that motion.
const NODE_EQUAL: f64 = 1e-6;

pub(super) fn check(of: &Reduced, places: &Places) -> Found {
    if of.mass <= 0.0 {
        return Err((places.entry("mass", 0), messages::flex_not_positive("mass", of.mass)));
    }
    for (word, matrix) in
        [("moments", &of.moments), ("generalised_mass", &of.generalised_mass), ("stiffness", &of.stiffness)]
    {
        symmetric(word, matrix, places)?;
    }
    mass_is_positive(of, places)?;
    integrals_belong_together(of, places)?;
    nothing_turns_with_less(of, places)?;
    stiffness_is_not_negative(of, places)?;
    if let Some(at) = places.orthogonal {
        are_orthogonal(of, at)?;
    }
    rigid_modes_are_rigid(of, places)
}

/// How many of the modes, the first ones, are rigid motions.
pub(super) fn rigid(of: &Reduced) -> usize {
    let (values, largest) = squares_of_rates(of);
    values.iter().filter(|value| **value <= RIGID * largest).count()
}

/// Eigenvalues of K against M, (rad/s)², and the largest.
fn squares_of_rates(of: &Reduced) -> (Vec<f64>, f64) {
    let Some(l) = cholesky(&of.generalised_mass) else { return (Vec::new(), 0.0) };
    let (values, _) = eigen(&reduced_by(&l, &of.stiffness));
    let largest = values.iter().copied().fold(0.0, f64::max);
    (values, largest)
}

fn symmetric(word: &'static str, matrix: &Square, places: &Places) -> Found {
    let n = matrix.len();
    for i in 0..n {
        for k in 0..i {
            let (below, above) = (matrix[i][k], matrix[k][i]);
            let size = (matrix[i][i] * matrix[k][k]).abs().sqrt();
            if (below - above).abs() > EQUAL * size.max(below.abs()).max(above.abs()) {
                let message = messages::flex_not_symmetric(word, [i + 1, k + 1], below, above);
                return Err((places.entry(word, i * n + k), message));
            }
        }
    }
    Ok(())
}

fn mass_is_positive(of: &Reduced, places: &Places) -> Found {
    const WORD: &str = "generalised_mass";
    let n = of.modes();
    let first = |count: usize| -> Square {
        of.generalised_mass[..count].iter().map(|row| row[..count].to_vec()).collect()
    };
    if let Some(j) = (0..n).find(|j| of.generalised_mass[*j][*j] <= 0.0) {
        let message = messages::flex_mass_of_mode(j + 1, of.generalised_mass[j][j]);
        return Err((places.entry(WORD, j * n + j), message));
    }
    match (1..=n).find(|count| cholesky(&first(*count)).is_none()) {
        Some(count) => {
            let at = places.entry(WORD, (count - 1) * n + count - 1);
            Err((at, messages::flex_mass_not_definite(count)))
        }
        None => Ok(()),
    }
}

/// ∫ (1, f)(1, f)ᵀ dm is a sum of squares.
fn integrals_belong_together(of: &Reduced, places: &Places) -> Found {
    let (whole, n) = (of.whole(), 3 + 3 * of.modes());
    for i in 0..n {
        let (mean, square) = (whole[0][1 + i], whole[1 + i][1 + i]);
        if mean * mean - square > EQUAL * (mean * mean).max(square.abs()) || square < 0.0 {
            let message = messages::flex_sum_rule(&name(i), of.mass * square, of.mass * mean * mean);
            return Err((places.entry("moments", i * n + i), message));
        }
    }
    let sizes: Vec<f64> = whole.iter().enumerate().map(|(i, row)| row[i].sqrt()).collect();
    match negative(&whole, &sizes) {
        Some((value, largest)) => {
            let message = messages::flex_no_square(value, &largest_names(&largest));
            Err((places.entry("moments", 0), message))
        }
        None => Ok(()),
    }
}

/// Names of the two functions with the largest parts.
fn largest_names(parts: &[f64]) -> [String; 2] {
    let mut order: Vec<usize> = (0..parts.len()).collect();
    order.sort_by(|i, k| parts[*k].abs().total_cmp(&parts[*i].abs()));
    [order[0], order[1]].map(|i| if i == 0 { "1".to_string() } else { name(i - 1) })
}

/// An eigenvalue below zero of a matrix whose rows are divided by their sizes, and its vector.
fn negative(matrix: &Square, sizes: &[f64]) -> Option<(f64, Vec<f64>)> {
    let over = |i: usize| if sizes[i] > 0.0 { 1.0 / sizes[i] } else { 0.0 };
    let n = matrix.len();
    let scaled = (0..n).map(|i| (0..n).map(|k| matrix[i][k] * over(i) * over(k)).collect()).collect();
    let (values, vectors) = eigen(&scaled);
    let (least, value) = values.iter().enumerate().min_by(|(_, a), (_, b)| a.total_cmp(b))?;
    (*value < -EQUAL).then(|| (*value, vectors.iter().map(|row| row[least]).collect()))
}

/// The function of a row of the moments.
fn name(i: usize) -> String {
    let axis = ["x", "y", "z"][i % 3];
    if i < 3 { axis.to_string() } else { format!("phi_{axis} of mode {}", i / 3) }
}

/// What inertia, angular momenta and generalised mass have beyond the moments is a sum of squares, too.
fn nothing_turns_with_less(of: &Reduced, places: &Places) -> Found {
    let (rotary, n) = (of.rotary(), of.modes());
    for axis in 0..3 {
        let beyond = rotary.inertia[axis][axis];
        if beyond < 0.0 {
            let found = of.inertia[axis][axis];
            let message = messages::flex_less_inertia(["xx", "yy", "zz"][axis], found, found - beyond);
            return Err((places.entry("inertia", axis), message));
        }
    }
    for mode in 0..n {
        let beyond = rotary.modal[mode][mode];
        if beyond < 0.0 {
            let found = of.generalised_mass[mode][mode];
            let message = messages::flex_less_mass(mode + 1, found, found - beyond);
            return Err((places.entry("generalised_mass", mode * n + mode), message));
        }
    }
    let entry = |i: usize, k: usize| match (i, k) {
        (0..3, 0..3) => rotary.inertia[i][k],
        (0..3, _) => rotary.momentum[k - 3][i],
        (_, 0..3) => rotary.momentum[i - 3][k],
        _ => rotary.modal[i - 3][k - 3],
    };
    let matrix: Square = (0..3 + n).map(|i| (0..3 + n).map(|k| entry(i, k)).collect()).collect();
    // Against the whole, of which these are differences.
    let trace = of.inertia[0][0] + of.inertia[1][1] + of.inertia[2][2];
    let size = |i: usize| if i < 3 { trace.sqrt() } else { of.generalised_mass[i - 3][i - 3].sqrt() };
    let sizes: Vec<f64> = (0..3 + n).map(size).collect();
    match negative(&matrix, &sizes) {
        Some((value, _)) => Err((places.entry("angular_momentum", 0), messages::flex_turns_with_less(value))),
        None => Ok(()),
    }
}

fn stiffness_is_not_negative(of: &Reduced, places: &Places) -> Found {
    let (values, largest) = squares_of_rates(of);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let at = places.entry("stiffness", 0);
    if least < -RIGID * largest {
        return Err((at, messages::flex_stiffness_negative(least)));
    }
    let rigid = rigid(of);
    if rigid != 0 && rigid != 6 {
        return Err((at, messages::flex_rigid_modes(rigid)));
    }
    let own = |mode: usize| of.stiffness[mode][mode] / of.generalised_mass[mode][mode];
    match (0..rigid).find(|mode| own(*mode) > RIGID * largest) {
        Some(mode) => {
            let at = places.entry("stiffness", mode * of.modes() + mode);
            Err((at, messages::flex_rigid_modes_first(mode + 1, own(mode).sqrt())))
        }
        None => Ok(()),
    }
}

fn are_orthogonal(of: &Reduced, at: At) -> Found {
    for (word, matrix) in [("generalised_mass", &of.generalised_mass), ("stiffness", &of.stiffness)] {
        for i in 0..of.modes() {
            for k in 0..i {
                let size = (matrix[i][i] * matrix[k][k]).abs().sqrt();
                let share = matrix[i][k].abs() / size;
                if share > EQUAL {
                    return Err((at, messages::flex_not_orthogonal(word, [k + 1, i + 1], share)));
                }
            }
        }
    }
    Ok(())
}

/// A mode without stiffness moves everything by t + w × r: as that of all motions which has its momenta, it has no energy beyond them, and moves
/// nodes so.
fn rigid_modes_are_rigid(of: &Reduced, places: &Places) -> Found {
    for mode in 0..rigid(of) {
        let motion = rigid_motion(of, mode);
        let (t, w) = (&motion[..3], &motion[3..]);
        let momenta = of.momentum[mode].iter().chain(&of.angular_momentum[mode]);
        let carried: f64 = momenta.zip(&motion).map(|(momentum, rate)| momentum * rate).sum();
        let own = of.generalised_mass[mode][mode];
        if (own - carried).abs() > EQUAL * own {
            let at = places.entry("generalised_mass", mode * of.modes() + mode);
            return Err((at, messages::flex_rigid_energy(mode + 1, own, carried)));
        }
        let reach = ((of.inertia[0][0] + of.inertia[1][1] + of.inertia[2][2]) / of.mass).sqrt();
        let length = |vector: &[f64]| vector.iter().map(|it| it * it).sum::<f64>().sqrt();
        let size = length(t) + length(w) * reach;
        for (node, at) in of.nodes.iter().zip(&places.nodes) {
            let turned = |a: usize| {
                let (b, c) = ((a + 1) % 3, (a + 2) % 3);
                t[a] + w[b] * node.at[c] - w[c] * node.at[b]
            };
            let moved = [0, 1, 2].map(turned);
            let differs = |a: usize| (moved[a] - node.shifts[mode][a]).abs() > NODE_EQUAL * size;
            if let Some(axis) = (0..3).find(|axis| differs(*axis)) {
                let values = [node.shifts[mode][axis], moved[axis]];
                let message = messages::flex_rigid_node(mode + 1, node.number, ["x", "y", "z"][axis], values);
                return Err((*at, message));
            }
        }
    }
    Ok(())
}

/// (t, w) with the momentum and the angular momentum of a mode.
fn rigid_motion(of: &Reduced, mode: usize) -> Vec<f64> {
    let (m, c) = (of.mass, of.center);
    let cross = [[0.0, -c[2], c[1]], [c[2], 0.0, -c[0]], [-c[1], c[0], 0.0]];
    let entry = |i: usize, k: usize| match (i, k) {
        (0..3, 0..3) => f64::from(u8::from(i == k)) * m,
        (0..3, _) => -m * cross[i][k - 3],
        (_, 0..3) => m * cross[i - 3][k],
        _ => of.inertia[i - 3][k - 3],
    };
    let matrix: Square = (0..6).map(|i| (0..6).map(|k| entry(i, k)).collect()).collect();
    let mut b: Vec<f64> = of.momentum[mode].iter().chain(&of.angular_momentum[mode]).copied().collect();
    let Some(l) = cholesky(&matrix) else { return vec![0.0; 6] };
    for i in 0..6 {
        let sum: f64 = (0..i).map(|k| l[i][k] * b[k]).sum();
        b[i] = (b[i] - sum) / l[i][i];
    }
    for i in (0..6).rev() {
        let sum: f64 = (i + 1..6).map(|k| l[k][i] * b[k]).sum();
        b[i] = (b[i] - sum) / l[i][i];
    }
    b
}
