//! Redundant rows of which different ones are taken at different positions.
//!
//! Where no set of rows can be left out along the whole motion, some rows of the mechanism are slots: in each of several charts a
//! slot is another row of a joint. The chart taken at a position is the one whose rows have the largest det D Dᵀ, the squared
//! volume that they span; all span the same space, so that nothing but rounding changes where the chart does. Which charts
//! there are is decided in `check::assemble::charts`.

use super::{Dropped, Jet, Row};
use crate::model::JointId;
use crate::symbolic::{Compare, Graph, Node};

/// The names of slots that are taken, in the order of their joint's, which has no more rows.
const TAKEN: [&str; 6] = ["switched_1", "switched_2", "switched_3", "switched_4", "switched_5", "switched_6"];
/// The names of those that are not, where redundant rows are kept.
const IDLE: [&str; 6] = ["idle_1", "idle_2", "idle_3", "idle_4", "idle_5", "idle_6"];

/// What is left out of the rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Omitted {
    /// Rows that are left out everywhere.
    pub dropped: Vec<Dropped>,
    /// Rows of which some are taken here, others there.
    pub switches: Vec<Switch>,
    /// What the entries of each column of D are multiplied by before they are compared, because columns have different units.
    pub columns: Vec<f64>,
}

impl Omitted {
    pub fn is_empty(&self) -> bool {
        self.dropped.is_empty() && self.switches.is_empty()
    }
}

/// Rows that repeat each other, and the charts of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Switch {
    /// Rows that every chart takes, of those that take part in the repetition.
    pub common: Vec<Sized>,
    /// By chart, the rows in the slots that are taken; of one length.
    pub taken: Vec<Vec<Sized>>,
    /// By chart, the rows in the slots that are not.
    pub idle: Vec<Vec<Sized>>,
}

/// A row and its size along the motion, a power of two.
#[derive(Clone, Debug, PartialEq)]
pub struct Sized {
    pub row: Dropped,
    pub size: f64,
}

/// The slots of a switch, and which chart is taken.
pub struct Chosen {
    /// Per chart but the first: whether it is taken rather than one before it.
    masks: Vec<Node>,
}

/// Which chart of each switch is taken, by the rows as they are without switches.
pub fn choose(g: &mut Graph, rows: &[Row], switches: &[Switch], columns: &[f64]) -> Vec<Chosen> {
    switches.iter().map(|switch| chosen(g, rows, switch, columns)).collect()
}

fn chosen(g: &mut Graph, rows: &[Row], switch: &Switch, columns: &[f64]) -> Chosen {
    let mut named: Vec<&Sized> = switch.common.iter().collect();
    for row in switch.taken.iter().flatten() {
        if !named.iter().any(|known| known.row == row.row) {
            named.push(row);
        }
    }
    let jets: Vec<Jet> = named.iter().map(|named| scaled(g, rows, named)).collect();
    let mut gram = gram(g, &jets, columns);
    for common in 0..switch.common.len() {
        eliminate(g, &mut gram, common);
    }
    let place = |row: &Sized| named.iter().position(|known| known.row == row.row).unwrap_or(0);
    let mut volumes: Vec<Node> = Vec::new();
    for taken in &switch.taken {
        let at: Vec<usize> = taken.iter().map(place).collect();
        let own: Vec<Vec<Node>> = at.iter().map(|i| at.iter().map(|j| gram[*i][*j]).collect()).collect();
        volumes.push(determinant(g, own));
    }
    let mut most = volumes[0];
    let mut masks = Vec::new();
    for volume in &volumes[1..] {
        masks.push(g.compare(Compare::Less, most, *volume));
        most = g.max(most, *volume);
    }
    Chosen { masks }
}

/// D W Dᵀ, W of the squares of `columns`.
fn gram(g: &mut Graph, jets: &[Jet], columns: &[f64]) -> Vec<Vec<Node>> {
    let zero = g.constant(0.0);
    let mut gram = vec![vec![zero; jets.len()]; jets.len()];
    for (i, a) in jets.iter().enumerate() {
        for (j, b) in jets.iter().enumerate().take(i + 1) {
            let mut terms = Vec::new();
            for (column, x) in &a.columns {
                let Some(y) = b.columns.get(column) else { continue };
                let product = g.mul(*x, *y);
                let weight = g.constant(columns[*column] * columns[*column]);
                terms.push(g.mul(weight, product));
            }
            gram[i][j] = g.sum(terms);
            gram[j][i] = gram[i][j];
        }
    }
    gram
}

/// Takes a row out of a symmetric matrix: the rest is orthogonal to it.
fn eliminate(g: &mut Graph, a: &mut [Vec<Node>], pivot: usize) {
    let column: Vec<Node> = a.iter().map(|row| row[pivot]).collect();
    for i in pivot + 1..a.len() {
        let factor = g.div(column[i], column[pivot]);
        for (j, entry) in column.iter().enumerate().take(i + 1).skip(pivot + 1) {
            let taken = g.mul(factor, *entry);
            a[i][j] = g.sub(a[i][j], taken);
            a[j][i] = a[i][j];
        }
    }
}

/// By cofactors of one and two rows, else by elimination: |A| of a symmetric matrix.
fn determinant(g: &mut Graph, mut a: Vec<Vec<Node>>) -> Node {
    match a.len() {
        0 => g.constant(1.0),
        1 => a[0][0],
        2 => {
            let (plus, minus) = (g.mul(a[0][0], a[1][1]), g.mul(a[0][1], a[1][0]));
            g.sub(plus, minus)
        }
        size => {
            let mut product = a[0][0];
            for pivot in 0..size - 1 {
                eliminate(g, &mut a, pivot);
                product = g.mul(product, a[pivot + 1][pivot + 1]);
            }
            product
        }
    }
}

/// The rows as they are taken, of rows as they are without switches. `keeps`: those not taken follow as slots of their own.
pub fn apply(g: &mut Graph, all: &[Row], switches: &[Switch], chosen: &[Chosen], keeps: bool) -> Vec<Row> {
    let is_slot = |row: &Row| switches.iter().any(|switch| switch.has(row));
    let mut rows: Vec<Row> = Vec::new();
    let mut written = vec![false; switches.len()];
    for row in all {
        if !is_slot(row) {
            rows.push(row.clone());
            continue;
        }
        // The slots stand where the first of their rows stood.
        for (at, switch) in switches.iter().enumerate() {
            if written[at] || !switch.has(row) {
                continue;
            }
            written[at] = true;
            let before = &switches[..at];
            let taken = names(before.iter().map(|switch| &switch.taken), &switch.taken, &TAKEN);
            rows.extend(switch.slots(g, all, &chosen[at], &switch.taken, &taken));
            if keeps {
                let idle = names(before.iter().map(|switch| &switch.idle), &switch.idle, &IDLE);
                rows.extend(switch.slots(g, all, &chosen[at], &switch.idle, &idle));
            }
        }
    }
    rows
}

/// The names of a switch's slots, given the charts of the switches before it. They are numbered by joint over all switches, so that no
/// two rows of a joint share one.
fn names<'a>(
    before: impl Iterator<Item = &'a Vec<Vec<Sized>>>,
    charts: &'a [Vec<Sized>],
    names: &[&'static str],
) -> Vec<&'static str> {
    let joints = |charts: &'a [Vec<Sized>]| charts[0].iter().map(|named| named.row.joint);
    let mut known: Vec<JointId> = before.flat_map(|charts| joints(charts)).collect();
    let mut found = Vec::new();
    for joint in joints(charts) {
        found.push(names[known.iter().filter(|other| **other == joint).count()]);
        known.push(joint);
    }
    found
}

/// λ of the rows as they are without switches, of multipliers of the rows that are taken: zero where a row is not.
pub fn multipliers(
    g: &mut Graph,
    all: &[Row],
    taken: &[Row],
    lambda: &[Node],
    switches: &[Switch],
    chosen: &[Chosen],
) -> Vec<Node> {
    let zero = g.constant(0.0);
    let mut result = Vec::new();
    for row in all {
        let Some(at) = switches.iter().position(|switch| switch.has(row)) else {
            let own = taken.iter().position(|other| same(other, row));
            result.push(own.map_or(zero, |own| lambda[own]));
            continue;
        };
        let (switch, chosen) = (&switches[at], &chosen[at]);
        let names = names(switches[..at].iter().map(|switch| &switch.taken), &switch.taken, &TAKEN);
        let mut value = zero;
        for (chart, rows) in switch.taken.iter().enumerate() {
            let slot = rows.iter().position(|named| named.is(row));
            let own = slot.and_then(|slot| {
                let first = &switch.taken[0][slot];
                let at = taken
                    .iter()
                    .position(|other| other.joint == Some(first.row.joint) && other.what == names[slot])?;
                let scale = g.constant(1.0 / rows[slot].size);
                Some(g.mul(scale, lambda[at]))
            });
            let own = own.unwrap_or(zero);
            value = if chart == 0 { own } else { g.select(chosen.masks[chart - 1], own, value) };
        }
        result.push(value);
    }
    result
}

fn same(a: &Row, b: &Row) -> bool {
    a.joint == b.joint && a.of == b.of && a.what == b.what
}

fn scaled(g: &mut Graph, rows: &[Row], named: &Sized) -> Jet {
    let row = rows.iter().find(|row| named.is(row));
    let factor = g.constant(1.0 / named.size);
    match row {
        Some(row) => row.jet.scale(g, factor),
        None => Jet::constant(g, factor),
    }
}

/// Whether a row is a slot that is not taken.
pub fn is_idle(row: &Row) -> bool {
    IDLE.contains(&row.what)
}

impl Sized {
    fn is(&self, row: &Row) -> bool {
        row.joint == Some(self.row.joint) && row.what == self.row.what
    }
}

impl Switch {
    /// Whether a row is in one of the slots.
    pub fn has(&self, row: &Row) -> bool {
        self.taken.iter().chain(&self.idle).flatten().any(|named| named.is(row))
    }

    /// One row for each slot, brought to size one; by name it is the first chart's.
    fn slots(
        &self,
        g: &mut Graph,
        all: &[Row],
        chosen: &Chosen,
        charts: &[Vec<Sized>],
        names: &[&'static str],
    ) -> Vec<Row> {
        let one = g.constant(1.0);
        let find = |named: &Sized| all.iter().find(|row| named.is(row));
        let mut slots = Vec::new();
        for ((slot, first), &what) in charts[0].iter().enumerate().zip(names) {
            let Some(stands) = find(first) else { continue };
            let mut jet = scaled(g, all, first);
            let mut upright = stands.upright.unwrap_or(one);
            for (mask, chart) in chosen.masks.iter().zip(&charts[1..]) {
                let other = scaled(g, all, &chart[slot]);
                jet = Jet::select(g, *mask, &other, &jet);
                let cosine = find(&chart[slot]).and_then(|row| row.upright).unwrap_or(one);
                upright = g.select(*mask, cosine, upright);
            }
            let upright = g.value(upright).is_none().then_some(upright);
            slots.push(Row { what, jet, upright, axes: None, ..stands.clone() });
        }
        slots
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::{Class, evaluate};
    use proc_macro2::Span;

    const WHATS: [&str; 4] = ["x", "y", "z", "axis_1"];

    fn sized(what: usize, size: f64) -> Sized {
        Sized { row: Dropped { joint: JointId(0), what: WHATS[what] }, size }
    }

    /// Two groups of one joint, each of two charts with a slot that is taken and one that is not.
    fn groups() -> Vec<Switch> {
        let group = |a: usize, b: usize| Switch {
            common: Vec::new(),
            taken: vec![vec![sized(a, 1.0)], vec![sized(b, 2.0)]],
            idle: vec![vec![sized(b, 2.0)], vec![sized(a, 1.0)]],
        };
        vec![group(0, 1), group(2, 3)]
    }

    /// Each multiplier goes to the row that its group takes, and rows of one joint have names of their own.
    #[test]
    fn groups_of_one_joint_share_no_name() {
        let mut graph = Graph::new();
        let g = &mut graph;
        let entries = [3.0, 1.0, 1.0, 4.0].map(|entry| g.constant(entry));
        let jets = entries.map(|entry| {
            let mut jet = Jet::constant(g, entry);
            jet.columns.insert(0, entry);
            jet
        });
        let rows = jets.into_iter().zip(WHATS).map(|(jet, what)| {
            let (of, span) = ("pin".to_string(), Span::call_site().into());
            Row { of, span, joint: Some(JointId(0)), what, jet, upright: None, axes: None }
        });
        let (all, switches): (Vec<Row>, _) = (rows.collect(), groups());
        let chosen = choose(g, &all, &switches, &[1.0]);
        let rows = apply(g, &all, &switches, &chosen, true);
        let names: Vec<&str> = rows.iter().map(|row| row.what).collect();
        assert_eq!(names, ["switched_1", "idle_1", "switched_2", "idle_2"]);
        let lambda = ["a", "b", "c", "d"].map(|name| g.symbol(name, Class::Input));
        let own = multipliers(g, &all, &rows, &lambda, &switches, &chosen);
        let values = evaluate(g, &[10.0, 0.0, 20.0, 0.0]);
        // The first group takes its first row, 3 beside 1/2, the second its second, 4/2 beside 1, by half.
        let own: Vec<f64> = own.iter().map(|node| values[node.index()]).collect();
        assert_eq!(own, [10.0, 0.0, 0.0, 10.0]);
    }
}
