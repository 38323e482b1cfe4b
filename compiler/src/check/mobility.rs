//! How easily a mechanism gives way along a direction at its start: J A Jᵀ with A the inverse of M on the velocities that constraints admit.

use super::assemble::{Ancestry, Point};
use super::elimination::Eliminated;
use crate::equations::{Equations, Jet};
use crate::symbolic::Node;

/// A direction, by the velocities that have a part in it.
pub type Direction = Vec<(usize, f64)>;

/// [M Dᵀ; D 0] at a state; nothing where that is singular, as of what has no mass.
pub struct Mobility(Option<Eliminated>);

impl Mobility {
    pub fn at(point: &mut Point) -> Self {
        let equations: &Equations = point.equations;
        let rows: Vec<&Jet> = equations.rows.iter().map(|row| &row.jet).collect();
        let masses: Vec<Node> = equations.mass.values().copied().collect();
        let columns = rows.iter().flat_map(|jet| jet.columns.values().copied());
        point.evaluate(&Ancestry::of(equations, masses.into_iter().chain(columns)));
        let n = equations.layout.velocities();
        let size = n + rows.len();
        let mut matrix = vec![vec![0.0; size]; size];
        for ((i, j), node) in &equations.mass {
            let value = point.get(*node);
            (matrix[*i][*j], matrix[*j][*i]) = (value, value);
        }
        for (row, jet) in rows.iter().enumerate() {
            for (index, column) in &jet.columns {
                let value = point.get(*column);
                (matrix[n + row][*index], matrix[*index][n + row]) = (value, value);
            }
        }
        Mobility(Eliminated::of(matrix).ok())
    }

    /// J A Jᵀ, 1/kg of a length and 1/(kg m²) of an angle; nothing where it is not known or not above zero.
    pub fn along(&self, direction: &Direction) -> Option<f64> {
        let eliminated = self.0.as_ref()?;
        let mut right = vec![0.0; eliminated.size()];
        direction.iter().for_each(|(index, value)| right[*index] += value);
        let moved = eliminated.solve(&right);
        let mobility: f64 = direction.iter().map(|(index, value)| value * moved[*index]).sum();
        (mobility > 0.0).then_some(mobility)
    }
}
