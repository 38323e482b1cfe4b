//! A mechanism after all stages but the last: what the self-check, budgets, pages and back ends start from.

use crate::check::assemble::Assembly;
use crate::check::assemble::loose::{self, Loose};
use crate::check::motion::{self, Motion, Unswept};
use crate::choice::Choice;
use crate::complete::Complete;
use crate::diagnostics::Diagnostics;
use crate::functions::Shape;
use crate::model::Mechanism;
use crate::schedule::Programs;
use crate::solve::Partition;
use crate::solve::table::Table;
use crate::symbolic::Node;

/// A mechanism after all stages but the last.
#[derive(Clone, Debug)]
pub struct Compiled {
    pub mechanism: Mechanism,
    /// `DEFINITION`.
    pub definition: String,
    pub complete: Complete,
    pub assembly: Assembly,
    pub programs: Programs,
    /// The expressions that the constants of the prepared model are.
    pub hoisted: Vec<Node>,
    /// Factorisation for the cold paths.
    pub table: Table,
    /// Independent coordinates, indices into the conditions.
    pub independent: Vec<usize>,
    /// The dependent velocity of each row that is not idle.
    pub partition: Partition,
    /// Masses and inertias that depend on parameters, and whether they must be positive.
    pub masses: Vec<(String, bool)>,
    pub choice: Choice,
    /// What is possible and probably not meant.
    pub warnings: Diagnostics,
}

impl Compiled {
    /// How many entries lists of this shape have.
    pub fn entries(&self, shape: Shape) -> usize {
        let Compiled { mechanism, complete, .. } = self;
        let Complete { equations, conditions, further, .. } = complete;
        match shape {
            Shape::Scalar => 1,
            Shape::Positions => equations.layout.positions(),
            Shape::Velocities => equations.layout.velocities(),
            Shape::Internal => mechanism.states.len(),
            Shape::State => {
                equations.layout.positions() + equations.layout.velocities() + mechanism.states.len()
            }
            Shape::Rows => equations.rows.len(),
            Shape::Matrix(matrix) => matrix.places(complete).count(),
            Shape::Conditions => conditions.rows.len(),
            Shape::Store => further.kept().len(),
            Shape::Lu => further.lu().len(),
            Shape::Constants => self.programs.prepared,
            Shape::Phases => equations.symbols.phases.len(),
            Shape::Parameters => mechanism.parameters.len(),
            Shape::Inputs => mechanism.inputs.len(),
            Shape::Outputs => mechanism.outputs.len(),
            Shape::Bodies(_) => mechanism.bodies.len(),
            Shape::Joints(_) => mechanism.joints.len(),
            Shape::Loads => mechanism.loads.len(),
            Shape::Drivers => mechanism.drivers.len(),
            Shape::Masses => equations.masses.len(),
        }
    }

    /// The range of motion of all joints, for those who ask; expansion itself follows the motion only where `expect` does.
    pub fn motion(&self) -> Result<Motion, Unswept> {
        motion::sweep(
            &self.mechanism,
            &self.complete.equations,
            &self.assembly,
            &motion::of_joints(&self.mechanism),
        )
    }

    /// The bodies that can move while all others stand still: loose ones, and idle freedoms.
    pub fn loose(&self) -> Vec<Loose> {
        loose::find(&self.mechanism, &self.complete.equations, &self.assembly.q, &self.assembly.phases)
    }
}
