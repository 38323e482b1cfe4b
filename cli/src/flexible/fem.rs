//! Modal data in the text format of MBDyn's modal joint (MBDyn input manual, *modal*; written by `femgen`, Code_Aster's macro and `mboct-fem-pkg`): record groups behind
//! lines of comment that number them.
//!
//! Taken are 1 (how many nodes and modes), 2 (numbers of nodes), 5 to 7 (places), 8 (modes, six rows for each node), 9 and 10 (mass and stiffness of modes),
//! 11 (six lumped masses for each node) and, to compare with, 12 (mass, centre, inertia about it). Left are starting values (3, 4) and damping (13), which a definition states,
//! and invariants (14 on): `.flex` needs ∫ φ_j φ_kᵀ dm whole, of which they have the antisymmetric part alone, and lumped masses have it.

use super::integrals::{Masses, Modes};
use super::model::ROWS;
use linkwright_compiler::modal::{Reduced, Square};
use std::collections::BTreeMap;

/// Relative, between what lumped masses add up to and what the file says of the body.
const EQUAL: f64 = 1e-6;

/// Numbers of record groups, with the lines where the groups begin.
struct Records<'t> {
    name: &'t str,
    groups: BTreeMap<usize, (usize, Vec<f64>)>,
}

pub fn read(name: &str, text: &str) -> Result<Reduced, String> {
    let records = Records::read(name, text)?;
    let (line, header) = records.group(1)?;
    let whole = |k: usize| header.get(k).filter(|it| it.fract() == 0.0 && **it >= 0.0).map(|it| *it as usize);
    let counts: Option<Vec<usize>> = (0..5).map(whole).collect();
    let Some([count, normal, attached, constrained, rejected]) = counts.as_deref() else {
        let what = "the header has a word and five whole numbers: nodes, and normal, attachment, constraint and rejected modes";
        return Err(records.at(line, what));
    };
    let Some(modes) = (normal + attached + constrained).checked_sub(*rejected).filter(|modes| *modes > 0)
    else {
        return Err(records.at(line, "more modes are rejected than there are, or as many"));
    };
    let numbers = records.numbers(2, *count, "one for each node")?;
    let places: Vec<&[f64]> =
        (5..8).map(|group| records.numbers(group, *count, "one for each node")).collect::<Result<_, _>>()?;
    let nodes: Vec<_> =
        (0..*count).map(|k| (numbers[k] as u64, [0, 1, 2].map(|axis| places[axis][k]))).collect();
    let shapes: Vec<Vec<f64>> = records
        .numbers(8, modes * count * ROWS, "six for each mode and node")?
        .chunks(count * ROWS)
        .map(<[f64]>::to_vec)
        .collect();
    let square = |group: usize| -> Result<Square, String> {
        let entries = records.numbers(group, modes * modes, "a square of as many rows as modes")?;
        Ok(entries.chunks(modes).map(<[f64]>::to_vec).collect())
    };
    let masses = records.masses(*count)?;
    let kept: Vec<usize> = (0..*count).collect();
    let reduced =
        Modes { nodes: &nodes, masses: &masses, shapes: &shapes }.reduced(square(9)?, square(10)?, &kept);
    records.agree(&reduced)?;
    Ok(reduced)
}

impl<'t> Records<'t> {
    fn read(name: &'t str, text: &str) -> Result<Self, String> {
        let mut records = Records { name, groups: BTreeMap::new() };
        let mut group = None;
        for (index, line) in text.lines().enumerate() {
            if let Some(comment) = line.trim_start().strip_prefix("**") {
                if let Some((_, behind)) = comment.split_once("RECORD GROUP") {
                    let number =
                        behind.trim_start().split(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
                    let Ok(number) = number.parse() else {
                        return Err(records.at(index + 1, "a record group has a number"));
                    };
                    records.groups.insert(number, (index + 1, Vec::new()));
                    group = Some(number);
                }
                continue;
            }
            let Some(number) = group else { continue };
            let Some((_, values)) = records.groups.get_mut(&number) else { continue };
            let is_header = number == 1;
            let skipped = usize::from(is_header && values.is_empty());
            for word in line.split_whitespace().skip(skipped) {
                // Fortran writes 1.0D+00.
                match word.replace(['D', 'd'], "e").parse::<f64>() {
                    Ok(value) if value.is_finite() => values.push(value),
                    _ => return Err(records.at(index + 1, &format!("numbers stand here, found `{word}`"))),
                }
            }
        }
        if records.groups.is_empty() {
            return Err(format!(
                "`{name}` has no line `** RECORD GROUP 1, HEADER`: it is no modal data of MBDyn"
            ));
        }
        Ok(records)
    }

    fn at(&self, line: usize, what: &str) -> String {
        format!("`{}`, line {line}: {what}", self.name)
    }

    fn group(&self, number: usize) -> Result<(usize, &[f64]), String> {
        let found = self.groups.get(&number).map(|(line, values)| (*line, values.as_slice()));
        found.ok_or_else(|| {
            let why = match number {
                11 => ", the lumped masses of its nodes, of which the integrals over the mass are sums: let them be written, as `femgen` does",
                _ => "",
            };
            format!("`{}` has no record group {number}{why}", self.name)
        })
    }

    fn numbers(&self, group: usize, count: usize, each: &str) -> Result<&[f64], String> {
        let (line, values) = self.group(group)?;
        if values.len() != count {
            let what = format!("record group {group} has {} numbers, and not {count}: {each}", values.len());
            return Err(self.at(line, &what));
        }
        Ok(values)
    }

    /// Of group 11, which are the same along all axes.
    fn masses(&self, count: usize) -> Result<Masses, String> {
        let rows = self.numbers(11, ROWS * count, "six for each node")?;
        let (line, _) = self.group(11)?;
        let mut masses = Masses { moved: Vec::new(), turned: Vec::new() };
        for (node, row) in rows.chunks(ROWS).enumerate() {
            let [x, y, z, about_x, about_y, about_z] = row else { continue };
            if (x - y).abs().max((x - z).abs()) > EQUAL * x.abs() {
                let what = format!(
                    "the lumped masses of node {} of {count} are {x}, {y} and {z} kg along x, y and z: mass that a place has is the same along all of them",
                    node + 1
                );
                return Err(self.at(line, &what));
            }
            masses.moved.push((node, node, *x));
            let inertia = [[*about_x, 0.0, 0.0], [0.0, *about_y, 0.0], [0.0, 0.0, *about_z]];
            masses.turned.push((node, node, inertia));
        }
        Ok(masses)
    }

    /// Whether group 12, where it is there, says what lumped masses add up to.
    fn agree(&self, found: &Reduced) -> Result<(), String> {
        if !self.groups.contains_key(&12) {
            return Ok(());
        }
        let stated = self.numbers(12, 13, "mass, centre of mass, and nine of the inertia about it")?;
        let (line, _) = self.group(12)?;
        let (moments, products) = found.about_center();
        let [xx, yy, zz] = moments;
        let [xy, xz, yz] = products;
        let [x, y, z] = found.center;
        let added = [found.mass, x, y, z, xx, xy, xz, xy, yy, yz, xz, yz, zz];
        let reach = ((xx + yy + zz) / found.mass).sqrt();
        for (k, (stated, added)) in stated.iter().zip(added).enumerate() {
            let (what, unit, size) = match k {
                0 => ("mass", "kg", found.mass),
                1..4 => ("centre of mass", "m", reach),
                _ => ("inertia about the centre of mass", "kg m²", xx + yy + zz),
            };
            if (stated - added).abs() > EQUAL * size {
                let what = format!(
                    "the {what} is {stated} {unit} here, and {added} {unit} by the lumped masses of record group 11: let the nodes with all of the mass be \
                     written"
                );
                return Err(self.at(line, &what));
            }
        }
        Ok(())
    }
}
