//! A bar of finite elements, assembled here, for tests of what is made of such models.

/// Rows of a node: along x, y, z and about x, y, z.
pub const ROWS: usize = 6;
pub const LENGTH: f64 = 1.0;
pub const YOUNG: f64 = 70e9;
pub const SHEAR: f64 = 27e9;
pub const DENSITY: f64 = 2700.0;
/// Torsion constant, m⁴.
pub const TORSION: f64 = 4.6e-9;
/// Along y and along z, m.
pub const SIDES: [f64; 2] = [0.01, 0.02];

pub fn area() -> f64 {
    SIDES[0] * SIDES[1]
}

/// About z, which bending along y takes, and about y.
pub fn second_moments() -> [f64; 2] {
    let [y, z] = SIDES;
    [z * y.powi(3) / 12.0, y * z.powi(3) / 12.0]
}

/// Numbers of nodes and their places, m, and the entries of M and K, row, column, value.
pub struct Beam {
    pub nodes: Vec<(u64, [f64; 3])>,
    pub mass: Vec<(usize, usize, f64)>,
    pub stiffness: Vec<(usize, usize, f64)>,
}

/// Euler and Bernoulli's elements along x with masses lumped at their ends, which turn about the axis alone.
pub fn beam(elements: usize) -> Beam {
    let count = elements + 1;
    let h = LENGTH / elements as f64;
    let nodes = (0..count).map(|k| (10 + k as u64, [h * k as f64, 0.0, 0.0])).collect();
    let (mut mass, mut stiffness) = (Vec::new(), Vec::new());
    let [about_z, about_y] = second_moments();
    for element in 0..elements {
        let row = |end: usize, which: usize| ROWS * (element + end) + which;
        let mut bar = |which: usize, k: f64| {
            for (i, j, sign) in [(0, 0, 1.0), (1, 1, 1.0), (0, 1, -1.0), (1, 0, -1.0)] {
                stiffness.push((row(i, which), row(j, which), sign * k));
            }
        };
        bar(0, YOUNG * area() / h);
        bar(3, SHEAR * TORSION / h);
        // Displacement and turn at both ends; along z the turn about y is against the slope.
        for (along, about, moment, sign) in [(1, 5, about_z, 1.0), (2, 4, about_y, -1.0)] {
            let (k, s) = (YOUNG * moment / h.powi(3), sign * h);
            let own = [row(0, along), row(0, about), row(1, along), row(1, about)];
            let entries = [
                [12.0, 6.0 * s, -12.0, 6.0 * s],
                [6.0 * s, 4.0 * h * h, -6.0 * s, 2.0 * h * h],
                [-12.0, -6.0 * s, 12.0, -6.0 * s],
                [6.0 * s, 2.0 * h * h, -6.0 * s, 4.0 * h * h],
            ];
            for (i, entries) in entries.iter().enumerate() {
                entries.iter().enumerate().for_each(|(j, entry)| stiffness.push((own[i], own[j], k * entry)));
            }
        }
        for end in 0..2 {
            let half = 0.5 * DENSITY * area() * h;
            (0..3).for_each(|axis| mass.push((row(end, axis), row(end, axis), half)));
            mass.push((row(end, 3), row(end, 3), half * (about_y + about_z) / area()));
        }
    }
    Beam { nodes, mass, stiffness }
}
