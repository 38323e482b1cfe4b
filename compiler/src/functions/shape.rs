//! Shapes of arguments and results: of what things a list has entries, and which fields an entry has.

use crate::complete::Complete;
use crate::equations::tangent::Matrix;
use crate::equations::{Equations, Jet, Tangents};
use crate::model::{Mechanism, Space};
use crate::symbolic::Node;

/// What a list has one entry for.
#[derive(Clone, Copy)]
pub enum Shape {
    /// One number.
    Scalar,
    /// q.
    Positions,
    /// v, v̇, forces.
    Velocities,
    /// z.
    Internal,
    /// What is held: 0 or 1, for each gate, then events and memories.
    Gates,
    /// q, v, z and the gates together.
    State,
    /// λ, Φ, ν, γ.
    Rows,
    /// The stored entries of a matrix.
    Matrix(&'static Sparse),
    Conditions,
    /// What is kept of K(c), and of D = L U.
    Store,
    Lu,
    /// Of the prepared model.
    Constants,
    Phases,
    /// A field for each, by the names in the definition.
    Parameters,
    Inputs,
    Outputs,
    /// Entries with fields.
    Bodies(&'static Record),
    Joints(&'static Record),
    Loads,
    Drivers,
    /// Masses and inertias that depend on parameters.
    Masses,
}

impl Shape {
    /// The names of its entries, where they have names: those of the user, as far as there are such.
    pub fn names(self, mechanism: &Mechanism, equations: &Equations) -> Vec<String> {
        match self {
            Shape::Positions => equations.layout.position_names(mechanism),
            Shape::Velocities => equations.layout.velocity_names(mechanism),
            Shape::Rows => equations.rows.iter().map(|row| format!("{}_{}", row.of, row.form.name)).collect(),
            Shape::Internal => mechanism.states.iter().map(|state| state.name.identifier()).collect(),
            Shape::Gates => {
                let gates = mechanism.gates();
                let gates = gates.map(|(load, which)| {
                    format!("{}_{}", mechanism.loads[load.0].name.identifier(), which + 1)
                });
                let behind = mechanism.held_names().into_iter().skip(mechanism.gates().count());
                gates.chain(behind.map(|name| name.identifier())).collect()
            }
            Shape::Inputs => mechanism.inputs.iter().map(|input| input.name.identifier()).collect(),
            Shape::Outputs => mechanism.outputs.iter().map(|output| output.name.identifier()).collect(),
            Shape::Parameters => mechanism.parameters.iter().map(|known| known.name.identifier()).collect(),
            Shape::Scalar => vec![String::new()],
            _ => Vec::new(),
        }
    }

    /// Whether its entries are counted; a number by itself and the fields of a struct are not.
    pub fn is_list(self) -> bool {
        !matches!(self, Shape::Scalar | Shape::State | Shape::Parameters | Shape::Inputs | Shape::Outputs)
    }

    /// The fields of its entries, where they have fields.
    pub fn record(self) -> Option<&'static Record> {
        match self {
            Shape::Bodies(record) | Shape::Joints(record) => Some(record),
            _ => None,
        }
    }
}

/// A matrix of which the structural non-zeros are stored.
pub struct Sparse {
    /// Name of its type, and of the table of its places.
    pub name: &'static str,
    pub pattern: &'static str,
    /// Its entries, row by row.
    pub entries: fn(&Complete) -> Vec<Entry>,
}

/// Row and column, and what stands there.
pub type Entry = ((usize, usize), Node);

impl Sparse {
    /// Row and column of each entry.
    pub fn places(&self, complete: &Complete) -> impl Iterator<Item = (usize, usize)> {
        (self.entries)(complete).into_iter().map(|(place, _)| place)
    }

    /// Its entries, row by row.
    pub fn nodes(&self, complete: &Complete) -> Vec<Node> {
        (self.entries)(complete).into_iter().map(|(_, node)| node).collect()
    }
}

const fn sparse(name: &'static str, pattern: &'static str, entries: fn(&Complete) -> Vec<Entry>) -> Sparse {
    Sparse { name, pattern, entries }
}

/// M, of which one triangle is stored.
pub static MASS: Sparse = sparse("Mass", "mass_pattern", |c| {
    c.equations.mass.iter().map(|(place, node)| (*place, *node)).collect()
});
/// D.
pub static JACOBIAN: Sparse =
    sparse("Jacobian", "jacobian_pattern", |c| of_jets(c.equations.rows.iter().map(|row| &row.jet)));
/// Of the conditions of the start.
pub static CONDITION_JACOBIAN: Sparse = sparse("ConditionJacobian", "condition_pattern", |c| {
    of_jets(c.conditions.rows.iter().map(|condition| &condition.jet))
});
/// ∂r/∂q along increments of q, r = M v̇ + Dᵀ λ − Q; and ∂r/∂v.
pub static STIFFNESS: Sparse = sparse("Stiffness", "stiffness_pattern", |c| of_tangents(c, |t| &t.stiffness));
pub static DAMPING: Sparse = sparse("Damping", "damping_pattern", |c| of_tangents(c, |t| &t.damping));
/// ∂(D v̇ − γ)/∂q along increments of q; and ∂(D v̇ − γ)/∂v.
pub static ROW_STIFFNESS: Sparse =
    sparse("RowStiffness", "row_stiffness_pattern", |c| of_tangents(c, |t| &t.row_stiffness));
pub static ROW_DAMPING: Sparse =
    sparse("RowDamping", "row_damping_pattern", |c| of_tangents(c, |t| &t.row_damping));
/// ∂(D v − ν)/∂q along increments of q.
pub static RATE: Sparse = sparse("RateTangent", "rate_pattern", |c| of_tangents(c, |t| &t.rate));
/// ∂r/∂u.
pub static INPUT: Sparse = sparse("InputTangent", "input_pattern", |c| of_tangents(c, |t| &t.input));
/// ∂r/∂z of the internal states.
pub static INTERNAL: Sparse =
    sparse("InternalTangent", "internal_pattern", |c| of_tangents(c, |t| &t.internal));
/// ∂(−Q_f)/∂(u, λ, z, v̇) of friction by reactions.
pub static FRICTION: Sparse =
    sparse("FrictionTangent", "friction_pattern", |c| of_tangents(c, |t| &t.friction));
/// By the parameters: of r, D v̇ − γ, D v − ν, Φ, the outputs, ż, and z at the start.
pub static PARAMETER: Sparse =
    sparse("ParameterTangent", "parameter_pattern", |c| of_tangents(c, |t| &t.parameter));
/// Of the outputs by q, v, u, λ, z and v̇.
pub static OUTPUT: Sparse = sparse("OutputTangent", "output_pattern", |c| of_tangents(c, |t| &t.output));
/// Of ż of the internal states, likewise.
pub static INTERNAL_RATE: Sparse =
    sparse("InternalRateTangent", "internal_rate_pattern", |c| of_tangents(c, |t| &t.internal_rate));
/// ∂(ṡ, s̈)/∂(q, v) of the independent coordinates s.
pub static COORDINATE: Sparse =
    sparse("CoordinateTangent", "coordinate_pattern", |c| of_tangents(c, |t| &t.coordinate));

/// The matrices of the trait `Tangent`.
pub static DERIVATIVES: [&Sparse; 12] = [
    &STIFFNESS,
    &DAMPING,
    &ROW_STIFFNESS,
    &ROW_DAMPING,
    &RATE,
    &INPUT,
    &INTERNAL,
    &FRICTION,
    &PARAMETER,
    &OUTPUT,
    &INTERNAL_RATE,
    &COORDINATE,
];

fn of_jets<'a>(jets: impl Iterator<Item = &'a Jet>) -> Vec<Entry> {
    let entries =
        |(row, jet): (usize, &'a Jet)| jet.columns.iter().map(move |(column, node)| ((row, *column), *node));
    jets.enumerate().flat_map(entries).collect()
}

/// Nothing where derivatives are not asked for.
fn of_tangents(complete: &Complete, of: fn(&Tangents) -> &Matrix) -> Vec<Entry> {
    let rows = complete.tangents.iter().flat_map(|tangents| of(tangents).iter().enumerate());
    rows.flat_map(|(row, entries)| entries.iter().map(move |(column, node)| ((row, *column), *node)))
        .collect()
}

/// Entries with fields, in the plane and in space.
pub struct Record {
    planar: Kind,
    spatial: Kind,
}

/// A struct of the runtime.
pub struct Kind {
    pub name: &'static str,
    pub fields: &'static [Field],
}

/// A field, stored row by row.
pub struct Field {
    pub name: &'static str,
    /// The lengths of its arrays, the outermost first; none of a number.
    pub extents: &'static [usize],
}

const fn field(name: &'static str, extents: &'static [usize]) -> Field {
    Field { name, extents }
}

/// Motion of a body: centre of mass in world axes (m, m/s, m/s²); orientation as (c, s), in space as the axes of the body;
/// rate and its derivative (rad/s, rad/s²), in space in body axes.
pub static MOTION: Record = Record {
    planar: Kind {
        name: "BodyMotion",
        fields: &[
            field("position", &[2]),
            field("orientation", &[2]),
            field("velocity", &[2]),
            field("rate", &[]),
            field("acceleration", &[2]),
            field("angular_acceleration", &[]),
        ],
    },
    spatial: Kind {
        name: "SpatialMotion",
        fields: &[
            field("position", &[3]),
            field("orientation", &[3, 3]),
            field("velocity", &[3]),
            field("rate", &[3]),
            field("acceleration", &[3]),
            field("angular_acceleration", &[3]),
        ],
    },
};

/// What a joint exerts: force (N) and torque (N m).
pub static REACTION: Record = Record {
    planar: Kind { name: "Reaction", fields: &[field("force", &[2]), field("torque", &[])] },
    spatial: Kind { name: "SpatialReaction", fields: &[field("force", &[3]), field("torque", &[3])] },
};

impl Record {
    /// Its struct in the plane or in space.
    pub fn of(&self, space: Space) -> &Kind {
        match space {
            Space::Planar => &self.planar,
            Space::Spatial => &self.spatial,
        }
    }
}

impl Kind {
    /// Numbers of one entry.
    pub fn length(&self) -> usize {
        self.fields.iter().map(Field::length).sum()
    }

    /// Where the numbers of one entry stand in it: `.position[0]`, `.rate`, `.orientation[2][1]`.
    pub fn places(&self) -> Vec<String> {
        let places = self.fields.iter().flat_map(|field| {
            let extents = field.extents.iter();
            extents.fold(vec![format!(".{}", field.name)], |places, extent| {
                let inner =
                    |place: &String| (0..*extent).map(|at| format!("{place}[{at}]")).collect::<Vec<_>>();
                places.iter().flat_map(inner).collect()
            })
        });
        places.collect()
    }

    /// The numbers of one entry by fields, `N` of them.
    pub fn split<'v, T, const N: usize>(&self, mut entry: &'v [T]) -> [&'v [T]; N] {
        debug_assert_eq!(N, self.fields.len(), "fields of {}", self.name);
        std::array::from_fn(|index| {
            let length = self.fields.get(index).map_or(0, Field::length);
            let (own, rest) = entry.split_at(length.min(entry.len()));
            entry = rest;
            own
        })
    }
}

impl Field {
    /// Numbers of the field.
    pub fn length(&self) -> usize {
        self.extents.iter().product()
    }
}
