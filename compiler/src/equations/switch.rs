//! Redundant rows of which different ones are taken at different positions.
//!
//! Where no set of rows can be left out along the whole motion, some rows of the mechanism are slots: in each of several charts a
//! slot is another row of a joint. The chart taken at a position is the one whose rows have the largest det D Dᵀ, the squared
//! volume that they span; all span the same space, so that nothing but rounding changes where the chart does. Which charts
//! there are is decided in `check::assemble::charts`.

use super::jet::Moving;
use super::{Jet, Row, RowOfJoint};
use crate::forms::RowForm;
use crate::model::JointId;
use crate::symbolic::{Compare, Node, Scalar, Sheet};

/// Slots that are taken, in the order of their joint's, which has no more rows.
static TAKEN: [RowForm; 6] = [
    RowForm::own("switched_1"),
    RowForm::own("switched_2"),
    RowForm::own("switched_3"),
    RowForm::own("switched_4"),
    RowForm::own("switched_5"),
    RowForm::own("switched_6"),
];
/// Those that are not, where redundant rows are kept.
static IDLE: [RowForm; 6] = [
    RowForm::own("idle_1"),
    RowForm::own("idle_2"),
    RowForm::own("idle_3"),
    RowForm::own("idle_4"),
    RowForm::own("idle_5"),
    RowForm::own("idle_6"),
];

/// What is left out of the rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Omitted {
    /// Rows that are left out everywhere.
    pub dropped: Vec<RowOfJoint>,
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
    pub row: RowOfJoint,
    pub size: f64,
}

/// The slots of a switch, and which chart is taken.
pub struct Chosen<'g> {
    /// Per chart but the first: whether it is taken rather than one before it.
    masks: Vec<Scalar<'g>>,
}

/// Which chart of each switch is taken, by the rows as they are without switches.
pub fn choose<'g>(g: Sheet<'g>, rows: &[Row], switches: &[Switch], columns: &[f64]) -> Vec<Chosen<'g>> {
    switches.iter().map(|switch| chosen(g, rows, switch, columns)).collect()
}

fn chosen<'g>(g: Sheet<'g>, rows: &[Row], switch: &Switch, columns: &[f64]) -> Chosen<'g> {
    let mut named: Vec<&Sized> = switch.common.iter().collect();
    for row in switch.taken.iter().flatten() {
        if !named.iter().any(|known| known.row == row.row) {
            named.push(row);
        }
    }
    let jets: Vec<Jet> = named.iter().map(|named| scaled(g, rows, named).jet).collect();
    let mut gram = gram(g, &jets, columns);
    for common in 0..switch.common.len() {
        eliminate(&mut gram, common);
    }
    let place = |row: &Sized| named.iter().position(|known| known.row == row.row).unwrap_or(0);
    let mut volumes: Vec<Scalar> = Vec::new();
    for taken in &switch.taken {
        let at: Vec<usize> = taken.iter().map(place).collect();
        let own = at.iter().map(|i| at.iter().map(|j| gram[*i][*j]).collect()).collect();
        volumes.push(determinant(g, own));
    }
    let mut most = volumes[0];
    let mut masks = Vec::new();
    for volume in &volumes[1..] {
        masks.push(most.compare(Compare::Less, *volume));
        most = most.max(*volume);
    }
    Chosen { masks }
}

type Matrix<'g> = Vec<Vec<Scalar<'g>>>;

/// D W Dᵀ, W of the squares of `columns`.
fn gram<'g>(g: Sheet<'g>, jets: &[Jet], columns: &[f64]) -> Matrix<'g> {
    let mut gram = vec![vec![g.zero(); jets.len()]; jets.len()];
    for (i, a) in jets.iter().enumerate() {
        for (j, b) in jets.iter().enumerate().take(i + 1) {
            let both = a.columns.iter().filter_map(|(k, x)| b.columns.get(k).map(|y| (k, g.on(*x), *y)));
            gram[i][j] = g.sum(both.map(|(k, x, y)| columns[*k] * columns[*k] * (x * y)));
            gram[j][i] = gram[i][j];
        }
    }
    gram
}

/// Takes a row out of a symmetric matrix: the rest is orthogonal to it.
fn eliminate(a: &mut Matrix, pivot: usize) {
    let column: Vec<Scalar> = a.iter().map(|row| row[pivot]).collect();
    for i in pivot + 1..a.len() {
        let factor = column[i] / column[pivot];
        for j in pivot + 1..=i {
            a[i][j] -= factor * column[j];
            a[j][i] = a[i][j];
        }
    }
}

/// By cofactors of one and two rows, else by elimination: |A| of a symmetric matrix.
fn determinant<'g>(g: Sheet<'g>, mut a: Matrix<'g>) -> Scalar<'g> {
    match a.len() {
        0 => g.one(),
        1 => a[0][0],
        2 => a[0][0] * a[1][1] - a[0][1] * a[1][0],
        size => {
            let mut product = a[0][0];
            for pivot in 1..size {
                eliminate(&mut a, pivot - 1);
                product = product * a[pivot][pivot];
            }
            product
        }
    }
}

/// The rows as they are taken, of rows as they are without switches. `keeps`: those not taken follow as slots of their own.
pub fn apply(g: Sheet, all: &[Row], switches: &[Switch], chosen: &[Chosen], keeps: bool) -> Vec<Row> {
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
            let taken = forms(before.iter().map(|switch| &switch.taken), &switch.taken, &TAKEN);
            rows.extend(switch.slots(g, all, &chosen[at], &switch.taken, &taken));
            if keeps {
                let idle = forms(before.iter().map(|switch| &switch.idle), &switch.idle, &IDLE);
                rows.extend(switch.slots(g, all, &chosen[at], &switch.idle, &idle));
            }
        }
    }
    rows
}

/// The forms of a switch's slots, given the charts of the switches before it. They are numbered by joint over all switches, so that no
/// two rows of a joint share one.
fn forms<'a>(
    before: impl Iterator<Item = &'a Vec<Vec<Sized>>>,
    charts: &'a [Vec<Sized>],
    forms: &'static [RowForm],
) -> Vec<&'static RowForm> {
    let joints = |charts: &'a [Vec<Sized>]| charts[0].iter().map(|named| named.row.joint);
    let mut known: Vec<JointId> = before.flat_map(|charts| joints(charts)).collect();
    let mut found = Vec::new();
    for joint in joints(charts) {
        found.push(&forms[known.iter().filter(|other| **other == joint).count()]);
        known.push(joint);
    }
    found
}

/// λ of the rows as they are without switches, of multipliers of the rows that are taken: zero where a row is not.
pub fn multipliers(
    g: Sheet,
    all: &[Row],
    taken: &[Row],
    lambda: &[Node],
    switches: &[Switch],
    chosen: &[Chosen],
) -> Vec<Node> {
    let zero = g.zero();
    let mut result = Vec::new();
    for row in all {
        let Some(at) = switches.iter().position(|switch| switch.has(row)) else {
            let own = taken.iter().position(|other| same(other, row));
            result.push(own.map_or(zero.bare, |own| lambda[own]));
            continue;
        };
        let (switch, chosen) = (&switches[at], &chosen[at]);
        let slots = forms(switches[..at].iter().map(|switch| &switch.taken), &switch.taken, &TAKEN);
        let mut value = zero;
        for (chart, rows) in switch.taken.iter().enumerate() {
            let slot = rows.iter().position(|named| named.is(row));
            let own = slot.and_then(|slot| {
                let first = &switch.taken[0][slot];
                let own = RowOfJoint { joint: first.row.joint, form: slots[slot] };
                let at = taken.iter().position(|other| other.of_joint() == Some(own))?;
                Some(1.0 / rows[slot].size * g.on(lambda[at]))
            });
            let own = own.unwrap_or(zero);
            value = if chart == 0 { own } else { chosen.masks[chart - 1].select(own, value) };
        }
        result.push(value.bare);
    }
    result
}

fn same(a: &Row, b: &Row) -> bool {
    a.origin == b.origin && a.form == b.form
}

fn scaled<'g>(g: Sheet<'g>, rows: &[Row], named: &Sized) -> Moving<'g> {
    let moving = |jet: Jet| Moving { g, velocities: &[], jet };
    let factor = g.number(1.0 / named.size);
    match rows.iter().find(|row| named.is(row)) {
        Some(row) => factor * moving(row.jet.clone()),
        None => moving(Jet::constant(factor)),
    }
}

/// Whether a row is a slot that is not taken.
pub fn is_idle(row: &Row) -> bool {
    IDLE.contains(row.form)
}

impl Sized {
    fn is(&self, row: &Row) -> bool {
        row.of_joint() == Some(self.row)
    }
}

impl Switch {
    /// Whether a row is in one of the slots.
    pub fn has(&self, row: &Row) -> bool {
        self.taken.iter().chain(&self.idle).flatten().any(|named| named.is(row))
    }

    /// One row for each slot, brought to size one; by origin it is the first chart's.
    fn slots(
        &self,
        g: Sheet,
        all: &[Row],
        chosen: &Chosen,
        charts: &[Vec<Sized>],
        forms: &[&'static RowForm],
    ) -> Vec<Row> {
        let upright =
            |row: Option<&Row>| row.and_then(|row| row.upright).map_or_else(|| g.one(), |it| g.on(it));
        let find = |named: &Sized| all.iter().find(|row| named.is(row));
        let mut slots = Vec::new();
        for ((slot, first), &form) in charts[0].iter().enumerate().zip(forms) {
            let Some(stands) = find(first) else { continue };
            let mut jet = scaled(g, all, first);
            let mut cosine = upright(Some(stands));
            for (mask, chart) in chosen.masks.iter().zip(&charts[1..]) {
                jet = Moving::select(*mask, &scaled(g, all, &chart[slot]), &jet);
                cosine = mask.select(upright(find(&chart[slot])), cosine);
            }
            slots.push(Row {
                form,
                jet: jet.jet,
                upright: cosine.value().is_none().then_some(cosine.bare),
                axes: None,
                ..stands.clone()
            });
        }
        slots
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equations::Origin;
    use crate::forms::row;
    use crate::symbolic::{Class, Growing, evaluate};
    use proc_macro2::Span;

    static FORMS: [&RowForm; 4] = [&row::GAP[0], &row::GAP[1], &row::GAP[2], &row::AXIS[0]];

    fn sized(form: usize, size: f64) -> Sized {
        Sized { row: RowOfJoint { joint: JointId(0), form: FORMS[form] }, size }
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
        let graph = Growing::default();
        let own = {
            let g = graph.sheet();
            let rows = [3.0, 1.0, 1.0, 4.0].map(|entry| g.number(entry)).into_iter().zip(FORMS).map(
                |(entry, form)| {
                    let mut jet = Jet::constant(entry);
                    jet.columns.insert(0, entry.bare);
                    let (of, span) = ("pin".to_string(), Span::call_site().into());
                    Row { origin: Origin::Joint(JointId(0)), of, span, form, jet, upright: None, axes: None }
                },
            );
            let (all, switches): (Vec<Row>, _) = (rows.collect(), groups());
            let chosen = choose(g, &all, &switches, &[1.0]);
            let rows = apply(g, &all, &switches, &chosen, true);
            let names: Vec<&str> = rows.iter().map(|row| row.form.name).collect();
            assert_eq!(names, ["switched_1", "idle_1", "switched_2", "idle_2"]);
            let lambda = ["a", "b", "c", "d"].map(|name| g.symbol(name, Class::Input).bare);
            multipliers(g, &all, &rows, &lambda, &switches, &chosen)
        };
        let values = evaluate(&graph.read(), &[10.0, 0.0, 20.0, 0.0]);
        // The first group takes its first row, 3 beside 1/2, the second its second, 4/2 beside 1, by half.
        let own: Vec<f64> = own.iter().map(|node| values[node.index()]).collect();
        assert_eq!(own, [10.0, 0.0, 0.0, 10.0]);
    }
}
