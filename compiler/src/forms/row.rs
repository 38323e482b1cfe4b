//! What anyone may know of a kind of constraint row.

/// A kind of row. Each is one static, and two rows are of one kind if they have the same.
#[derive(Debug)]
pub struct RowForm {
    /// As in NOTATION.md.
    pub name: &'static str,
    pub measures: Measures,
    /// The vector that it is a component of, together with the rows beside it.
    pub part_of: Option<Whole>,
    /// The motion that it prevents, in words.
    pub prevents: &'static str,
}

impl PartialEq for RowForm {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

/// What the residual of a row is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measures {
    /// m.
    Length,
    /// Half the difference of two squares of lengths, m².
    Squares,
    /// The sine of an angle or the cosine between two axes.
    Direction,
    /// As the quantities in it.
    Own,
}

/// A vector of which several rows are the components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whole {
    /// From one place to another.
    Gap,
    /// The same, across an axis.
    Offset,
    /// An axis, across another.
    Axis,
}

impl RowForm {
    const fn length(name: &'static str, part_of: Option<Whole>, prevents: &'static str) -> Self {
        RowForm { name, measures: Measures::Length, part_of, prevents }
    }

    /// A direction that is not part of a vector.
    pub const fn direction(name: &'static str, prevents: &'static str) -> Self {
        RowForm { name, measures: Measures::Direction, part_of: None, prevents }
    }

    /// A row of quantities that have units of their own.
    pub const fn own(name: &'static str) -> Self {
        RowForm { name, measures: Measures::Own, part_of: None, prevents: name }
    }
}

/// Two places are together: components of what lies between them.
pub static GAP: [RowForm; 3] = [
    RowForm::length("x", Some(Whole::Gap), "shifts along x"),
    RowForm::length("y", Some(Whole::Gap), "shifts along y"),
    RowForm::length("z", Some(Whole::Gap), "shifts along z"),
];

/// A place is on an axis: components of what lies between, across the axis.
pub static OFFSET: [RowForm; 2] = [
    RowForm::length("normal_1", Some(Whole::Offset), "shifts along x of its axes"),
    RowForm::length("normal_2", Some(Whole::Offset), "shifts along y of its axes"),
];

/// A place is on a line of the plane, or on a plane of space.
pub static NORMAL: RowForm = RowForm::length("normal", None, "shifts along its normal");

/// Two axes are parallel: components of the one across the other.
pub static AXIS: [RowForm; 2] = [
    RowForm {
        name: "axis_1",
        measures: Measures::Direction,
        part_of: Some(Whole::Axis),
        prevents: "turns about y of its axes",
    },
    RowForm {
        name: "axis_2",
        measures: Measures::Direction,
        part_of: Some(Whole::Axis),
        prevents: "turns about x of its axes",
    },
];

/// Two bodies do not turn against each other about an axis.
pub static ANGLE: RowForm = RowForm::direction("angle", "turns about its axis");

/// Two places keep their distance.
pub static DISTANCE: RowForm =
    RowForm { name: "distance", measures: Measures::Squares, part_of: None, prevents: "distance" };

/// A place stays out of a curve by the radius of its roller.
pub static CURVE: RowForm = RowForm::length("out", None, "shifts along the normal of the curve");

/// A place is on a curve: how far it is beside it, along the axis that is not the parameter.
pub static ON_CURVE: RowForm = RowForm::length("beside", None, "shifts along the normal of the curve");
