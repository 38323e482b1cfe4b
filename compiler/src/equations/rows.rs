//! The rows of constraints: of the joints that carry nothing, of couplings and equations, and of drivers, in the order written.

use super::couplings;
use super::jet::{Jet, Moving};
use super::laws::Laws;
use super::space::{Cosines, Inertial};
use super::spanning_tree::SpanningTree;
use super::{plane, space};
use crate::diagnostics::Region;
use crate::forms::RowForm;
use crate::model::{ConstraintId, DriverId, Frame, JointId, Name, Space};
use crate::symbolic::{Computed, Node, Scalar};
use std::collections::BTreeMap;

/// One row of a joint's constraint.
#[derive(Clone, Debug)]
pub struct JointRow {
    pub form: &'static RowForm,
    pub jet: Jet,
    /// For a direction row, such as sin(Δθ) = 0: what must be positive on the right root, such as cos(Δθ).
    pub upright: Option<Node>,
    /// For a component of a distance in space: the axes along which it is taken.
    pub axes: Option<Frame>,
}

impl JointRow {
    pub fn new(form: &'static RowForm, row: Moving) -> Self {
        JointRow { form, jet: row.jet, upright: None, axes: None }
    }

    /// A row of a direction, and what must be positive on the right root.
    pub fn upright(form: &'static RowForm, row: Moving, upright: Scalar) -> Self {
        JointRow { upright: Some(upright.bare), ..JointRow::new(form, row) }
    }
}

/// What a row is a constraint of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    Joint(JointId),
    Constraint(ConstraintId),
    Driver(DriverId),
}

/// One constraint row.
#[derive(Clone, Debug)]
pub struct Row {
    pub origin: Origin,
    /// Name of the joint, constraint or driver.
    pub of: String,
    pub span: Region,
    pub form: &'static RowForm,
    /// Φ, D, −ν, −γ.
    pub jet: Jet,
    /// cos Δθ of a direction row, positive on the right root.
    pub upright: Option<Node>,
    pub axes: Option<Frame>,
}

impl Row {
    fn new(origin: Origin, name: &Name, row: JointRow) -> Self {
        let JointRow { form, jet, upright, axes } = row;
        Row { origin, of: name.text.clone(), span: name.span, form, jet, upright, axes }
    }

    pub fn joint(&self) -> Option<JointId> {
        match self.origin {
            Origin::Joint(joint) => Some(joint),
            Origin::Constraint(_) | Origin::Driver(_) => None,
        }
    }

    /// Which row of a joint it is.
    pub fn of_joint(&self) -> Option<RowOfJoint> {
        self.joint().map(|joint| RowOfJoint { joint, form: self.form })
    }
}

/// A row of a joint, whether it is taken or left out because others fix what it fixes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowOfJoint {
    pub joint: JointId,
    pub form: &'static RowForm,
}

/// All rows, but for those `dropped`; of the ways in which they can be derived, each joint's are in one that takes few operations
/// beside what is `computed` anyway, if that is said.
pub(super) fn rows<'g>(
    laws: &Laws<'g>,
    tree: &SpanningTree,
    carrying: &[bool],
    dropped: &[RowOfJoint],
    mut computed: Option<Computed>,
) -> Vec<Row> {
    let mechanism = laws.mechanism;
    let inertial = computed.as_ref().and_then(|known| Some(Inertial::new(laws.space()?, known.clone())));
    let turning = inertial.as_ref().map(|directions| directions.with(Cosines::Turning));
    let mut rows = Vec::new();
    for (index, joint) in mechanism.joints.iter().enumerate().filter(|(index, _)| !carrying[*index]) {
        let id = JointId(index);
        if !joint.holds() {
            continue;
        }
        let kept = |mut rows: Vec<JointRow>| {
            rows.retain(|row| !dropped.contains(&RowOfJoint { joint: id, form: row.form }));
            rows
        };
        let in_space = |inertial: Option<&Inertial<'g>>| kept(space::joints::rows(laws, tree, id, inertial));
        let kept = match (mechanism.space, &mut computed) {
            (Space::Planar, _) => kept(plane::joints::rows(laws, joint)),
            (Space::Spatial, None) => in_space(None),
            (Space::Spatial, Some(computed)) => {
                cheap(laws, [None, inertial.as_ref(), turning.as_ref()].map(in_space), computed)
            }
        };
        rows.extend(kept.into_iter().map(|row| Row::new(Origin::Joint(id), &joint.name, row)));
    }
    let mut phases = laws.symbols.phases.iter().copied();
    for (index, constraint) in mechanism.constraints.iter().enumerate() {
        if !couplings::has_row(mechanism, constraint) {
            continue;
        }
        let phase = if couplings::is_open(constraint) { phases.next() } else { None };
        let (form, row) = couplings::row(laws, constraint, phase);
        let origin = Origin::Constraint(ConstraintId(index));
        rows.push(Row::new(origin, &constraint.name, JointRow::new(form, row)));
    }
    for (index, driver) in mechanism.drivers.iter().enumerate() {
        let (form, row) = couplings::driver_row(laws, driver);
        rows.push(Row::new(Origin::Driver(DriverId(index)), &driver.name, JointRow::new(form, row)));
    }
    rows
}

/// A way is left for another that takes a twentieth less: what rows of other joints will have in common with either is not known yet.
const LESS: (usize, usize) = (19, 20);

/// The rows in a way that takes few operations beside what is computed anyway, which they are from then on.
fn cheap(laws: &Laws, ways: [Vec<JointRow>; 3], computed: &mut Computed) -> Vec<JointRow> {
    let graph = laws.g.graph();
    let nodes = |rows: &[JointRow]| -> Vec<Node> {
        let of_row = |row: &JointRow| {
            let Jet { value, columns, bias, .. } = &row.jet;
            columns.values().copied().chain([*value, *bias]).collect::<Vec<_>>()
        };
        rows.iter().flat_map(of_row).collect()
    };
    let mut costed = ways.into_iter().map(|rows| (computed.cost(&graph, &nodes(&rows)), rows));
    let first = costed.next().unwrap_or_default();
    let (_, least) =
        costed.fold(first, |least, other| if LESS.1 * other.0 < LESS.0 * least.0 { other } else { least });
    computed.add(&graph, &nodes(&least));
    least
}

/// The rows in whose place a load acts, seen from the first place.
pub fn that_yield(laws: &Laws, id: JointId) -> Vec<JointRow> {
    match laws.mechanism.space {
        Space::Planar => plane::joints::rows(laws, &laws.mechanism.joints[id.0]),
        Space::Spatial => space::joints::rows_that_yield(laws, id),
    }
}

/// Rows of each joint that has some, by index of joint.
pub(super) fn multipliers_of_joints(rows: &[Row]) -> BTreeMap<usize, Vec<usize>> {
    let mut found: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (index, row) in rows.iter().enumerate() {
        if let Some(joint) = row.joint() {
            found.entry(joint.0).or_default().push(index);
        }
    }
    found
}
