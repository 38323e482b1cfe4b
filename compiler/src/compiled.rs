//! A mechanism after all stages but the last: what the self-check, budgets, pages and back ends start from.

use crate::check::assemble::loose::{self, Loose};
use crate::check::assemble::{Assembly, Point};
use crate::check::motion::{self, Least, Linkage, Motion, Reflected, Unswept};
use crate::check::{Blow, Braking, Vibration};
use crate::choice::Choice;
use crate::complete::Complete;
use crate::diagnostics::Diagnostics;
use crate::functions::{Function, Shape};
use crate::model::{Coordinate, Expr, LoadId, Mechanism, Quantity};
use crate::schedule::Programs;
use crate::solve::table::Table;
use crate::symbolic::Node;

/// An angle among the outputs whose turns the dynamics do not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AngleInOutputs {
    pub output: usize,
    /// The condition of the start that states it.
    pub stated: Option<usize>,
}

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
    /// Masses and inertias that depend on parameters, and whether they must be positive.
    pub masses: Vec<(String, bool)>,
    pub choice: Choice,
    /// What is possible and probably not meant.
    /// What blows of contacts are like at the start.
    pub blows: Vec<(LoadId, Blow)>,
    /// How frictions brake near rest, at the start.
    pub braking: Vec<(LoadId, Braking)>,
    /// The fastest that joints which yield make, at the start.
    pub vibration: Option<Vibration>,
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
            Shape::Gates => equations.guards.len(),
            Shape::State => {
                let moved = equations.layout.positions() + equations.layout.velocities();
                moved + mechanism.states.len() + equations.guards.len()
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

    /// How the accelerations are computed and what the compiler chose between, for the documentation.
    pub fn explanation(&self) -> String {
        let solution = self.complete.further.explanation();
        [self.choice.explanation()].into_iter().chain(solution).collect::<Vec<_>>().join(" ")
    }

    /// What the loops of each function save, and what they might have, of functions in which something repeats.
    pub fn repetition(&self) -> impl Iterator<Item = Repetition> {
        self.programs.functions.iter().filter_map(|(function, program)| {
            let operations = program.instructions.len();
            match &program.rolled {
                Some(rolled) => Some(Repetition {
                    function: function.name(),
                    operations,
                    statements: Some(rolled.statements(program)),
                    alike: rolled.alike(),
                }),
                None if program.alike > 0 => Some(Repetition {
                    function: function.name(),
                    operations,
                    statements: None,
                    alike: program.alike,
                }),
                None => None,
            }
        })
    }

    /// The gates of contacts at the start, for the default parameters.
    pub fn start_gates(&self) -> Vec<f64> {
        let equations = &self.complete.equations;
        let mut point = Point::at_start(&self.mechanism, equations, &self.assembly);
        point.gates()
    }

    /// The function that formulations with Baumgarte's terms ask first.
    pub fn default_solution(&self) -> Function {
        let [_, stabilised] = Function::SOLUTIONS[usize::from(self.complete.further.leads)];
        stabilised
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

    /// The same, and what designers of linkages ask of it.
    pub fn linkage(&self) -> Result<(Motion, Linkage), Unswept> {
        motion::of_linkage(&self.mechanism, &self.complete.equations, &self.assembly)
    }

    /// The efforts that `expect` bounds, where they are nearest to that, and the speed at which they reach it.
    pub fn efforts(&self) -> Vec<Least> {
        let found = motion::efforts(&self.mechanism, &self.complete.equations, &self.assembly);
        found.map_or(Vec::new(), |(found, _)| found)
    }

    /// Inertia and loads as each joint feels them at the start, of mechanisms with one degree of freedom.
    pub fn reflected(&self) -> Vec<Reflected> {
        motion::reflected(&self.mechanism, &self.complete.equations, &self.assembly)
    }

    /// Angles of the dynamics count their turns themselves; the others are unwrapped from sample to sample, the first time from what
    /// `start` states.
    pub fn angles_in_outputs(&self) -> Vec<AngleInOutputs> {
        let Complete { equations, conditions, .. } = &self.complete;
        let of = |(output, coordinate): (usize, &Coordinate)| {
            let Coordinate::Angle(rotor) = coordinate else { return None };
            if equations.layout.angles.iter().any(|angle| angle.rotor == *rotor) {
                return None;
            }
            let mut conditions = conditions.rows.iter().zip(&conditions.start);
            let stated = conditions.position(|(condition, target)| {
                target.position.is_some() && condition.coordinate == *coordinate
            });
            Some(AngleInOutputs { output, stated })
        };
        let coordinates =
            self.mechanism.outputs.iter().enumerate().filter_map(|(index, output)| match &output.value {
                Expr::Quantity(Quantity::Coordinate(coordinate)) => Some((index, coordinate)),
                _ => None,
            });
        coordinates.filter_map(of).collect()
    }

    /// The hash FNV-1a (Fowler, Noll, Vo; draft-eastlake-fnv) of the definition, the same on every machine.
    pub fn fingerprint(&self) -> u64 {
        let (basis, prime) = (0xcbf2_9ce4_8422_2325, 0x0100_0000_01b3);
        self.definition.bytes().fold(basis, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(prime))
    }

    /// The bodies that can move while all others stand still: loose ones, and idle freedoms.
    pub fn loose(&self) -> Vec<Loose> {
        loose::find(&self.mechanism, &self.complete.equations, &self.assembly.q, &self.assembly.phases)
    }
}

/// Repetition in one function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Repetition {
    pub function: &'static str,
    pub operations: usize,
    /// What its text has, where it has loops.
    pub statements: Option<usize>,
    /// Operations that repeat others.
    pub alike: usize,
}

impl std::fmt::Display for Repetition {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Repetition { function, operations, statements, alike } = self;
        match statements {
            Some(statements) => {
                write!(
                    f,
                    "{function}: {operations} operations, {alike} of them in loops, {statements} statements"
                )
            }
            None => write!(
                f,
                "{function}: {operations} operations, straight; {alike} of them repeat, with exceptions, and loops would not halve its text"
            ),
        }
    }
}
