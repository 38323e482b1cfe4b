//! From the graph to straight-line programs, one per emitted function, in sections by how often values change:
//! constants are folded, parameter-only terms go to `prepare`, the rest to each function.
//!
//! AFTER THIS POINT there is no graph, only instructions in order.

mod count;
mod evaluate;
mod program;
mod select;

pub use count::{Counts, count};
pub use evaluate::{Inputs, run};
pub use program::{Instruction, Operand, Program, Source};

use crate::equations::Equations;
use crate::solve::Solved;
use crate::symbolic::Node;
use select::{Prepared, select};

/// The functions of a mechanism, by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// Parameters and phases → constants of the prepared model.
    Prepare,
    MassMatrix,
    Constraints,
    ConstraintJacobian,
    Nu,
    Gamma,
    Forces,
    KineticEnergy,
    PotentialEnergy,
    Acceleration,
    AccelerationBaumgarte,
    Outputs,
    Powers,
    DriverEfforts,
    Motions,
    Reactions,
    RowCosines,
    ConditionResidual,
    ConditionUpright,
    ConditionJacobian,
    ConditionBias,
    ConditionDrift,
    /// Values, then rates, that `start` asks of each condition; 0 where it asks none.
    StartTargets,
    /// Masses and inertias that depend on parameters.
    Masses,
}

impl Function {
    pub const ALL: [Function; 24] = [
        Function::MassMatrix,
        Function::Constraints,
        Function::ConstraintJacobian,
        Function::Nu,
        Function::Gamma,
        Function::Forces,
        Function::KineticEnergy,
        Function::PotentialEnergy,
        Function::Acceleration,
        Function::AccelerationBaumgarte,
        Function::Outputs,
        Function::Powers,
        Function::DriverEfforts,
        Function::Motions,
        Function::Reactions,
        Function::RowCosines,
        Function::ConditionResidual,
        Function::ConditionUpright,
        Function::ConditionJacobian,
        Function::ConditionBias,
        Function::ConditionDrift,
        Function::StartTargets,
        Function::Masses,
        // Last: it computes what all others asked for.
        Function::Prepare,
    ];

    /// Name of the emitted function.
    pub fn name(self) -> &'static str {
        match self {
            Function::Prepare => "prepare",
            Function::MassMatrix => "mass_matrix",
            Function::Constraints => "constraints",
            Function::ConstraintJacobian => "constraint_jacobian",
            Function::Nu => "nu",
            Function::Gamma => "gamma",
            Function::Forces => "forces",
            Function::KineticEnergy => "kinetic_energy",
            Function::PotentialEnergy => "potential_energy",
            Function::Acceleration => "acceleration",
            Function::AccelerationBaumgarte => "acceleration_baumgarte",
            Function::Outputs => "outputs",
            Function::Powers => "powers",
            Function::DriverEfforts => "driver_efforts",
            Function::Motions => "motions",
            Function::Reactions => "reactions",
            Function::RowCosines => "row_cosines",
            Function::ConditionResidual => "condition_residual",
            Function::ConditionUpright => "condition_upright",
            Function::ConditionJacobian => "condition_jacobian",
            Function::ConditionBias => "condition_bias",
            Function::ConditionDrift => "condition_drift",
            Function::StartTargets => "start_targets",
            Function::Masses => "masses",
        }
    }
}

/// All programs of one mechanism.
#[derive(Clone, Debug)]
pub struct Programs {
    /// In the order of [`Function::ALL`].
    pub functions: Vec<(Function, Program)>,
    /// Number of constants of the prepared model.
    pub prepared: usize,
}

impl Programs {
    pub fn get(&self, function: Function) -> &Program {
        static EMPTY: Program = Program { instructions: Vec::new(), outputs: Vec::new() };
        self.functions.iter().find(|(known, _)| *known == function).map_or(&EMPTY, |(_, program)| program)
    }
}

/// Compiles every function of the mechanism.
pub fn schedule(equations: &Equations, solved: &Solved) -> Programs {
    let sources = sources(equations);
    let mut prepared = Prepared::default();
    let mut functions = Vec::new();
    for function in Function::ALL {
        let program = if function == Function::Prepare {
            select(&equations.graph, &sources, None, &prepared.nodes)
        } else {
            let outputs = outputs(equations, solved, function);
            select(&equations.graph, &sources, Some(&mut prepared), &outputs)
        };
        functions.push((function, program));
    }
    Programs { functions, prepared: prepared.nodes.len() }
}

/// One function on its own, its constants of parameters set apart as in [`schedule`].
pub fn program(equations: &Equations, solved: &Solved, function: Function) -> Program {
    let outputs = outputs(equations, solved, function);
    select(&equations.graph, &sources(equations), Some(&mut Prepared::default()), &outputs)
}

/// What each symbol of the graph stands for.
pub fn sources(equations: &Equations) -> Vec<Source> {
    let symbols = &equations.symbols;
    let mut sources = vec![Source::Time; equations.graph.symbol_count()];
    let mut assign = |nodes: &[Node], source: fn(u32) -> Source| {
        for (index, node) in nodes.iter().enumerate() {
            if let crate::symbolic::Op::Symbol(symbol) = equations.graph.op(*node) {
                sources[symbol as usize] = source(index as u32);
            }
        }
    };
    assign(&symbols.parameters, Source::Parameter);
    assign(&symbols.phases, Source::Phase);
    assign(&[symbols.time], |_| Source::Time);
    assign(&symbols.q, Source::Q);
    assign(&symbols.v, Source::V);
    assign(&symbols.inputs, Source::Input);
    assign(&[symbols.two_alpha], |_| Source::TwoAlpha);
    assign(&[symbols.beta_squared], |_| Source::BetaSquared);
    assign(&symbols.acceleration, Source::Acceleration);
    assign(&symbols.lambda, Source::Lambda);
    assign(&symbols.targets, Source::Target);
    sources
}

/// What a function computes, in the order of its outputs.
pub fn outputs(equations: &Equations, solved: &Solved, function: Function) -> Vec<Node> {
    let e = equations;
    let rows = || e.rows.iter();
    let conditions = || e.conditions.iter();
    let zero = e.zero;
    match function {
        Function::Prepare => Vec::new(),
        Function::MassMatrix => e.mass.values().copied().collect(),
        Function::Constraints => rows().map(|row| row.jet.value).collect(),
        Function::ConstraintJacobian => rows().flat_map(|row| row.jet.columns.values().copied()).collect(),
        Function::Nu => e.nu.clone(),
        Function::Gamma => e.gamma.clone(),
        Function::Forces => e.forces.clone(),
        Function::KineticEnergy => vec![e.kinetic_energy],
        Function::PotentialEnergy => vec![e.potential_energy],
        Function::Acceleration => solution(&solved.index1),
        Function::AccelerationBaumgarte => solution(&solved.baumgarte),
        Function::Outputs => e.outputs.clone(),
        Function::Powers => e.powers.clone(),
        Function::DriverEfforts => e.driver_efforts.iter().chain(&e.driver_powers).copied().collect(),
        Function::Motions => e.motions.iter().flat_map(|motion| motion.flat()).collect(),
        Function::Reactions => e.reactions.iter().flatten().copied().collect(),
        Function::RowCosines => rows().map(|row| row.upright.unwrap_or(e.one)).collect(),
        Function::ConditionResidual => conditions().map(|c| c.residual).collect(),
        Function::ConditionUpright => conditions().map(|c| c.upright).collect(),
        Function::ConditionJacobian => conditions().flat_map(|c| c.jet.columns.values().copied()).collect(),
        Function::ConditionBias => conditions().map(|c| c.jet.bias).collect(),
        Function::ConditionDrift => conditions().map(|c| c.jet.drift).collect(),
        Function::StartTargets => {
            let target = |value: Option<Node>| value.unwrap_or(zero);
            let positions = e.start_targets.iter().map(|start| target(start.position));
            positions.chain(e.start_targets.iter().map(|start| target(start.rate))).collect()
        }
        Function::Masses => e.masses.iter().map(|(_, node)| *node).collect(),
    }
}

fn solution(solution: &crate::solve::Solution) -> Vec<Node> {
    solution.acceleration.iter().chain(&solution.lambda).chain([&solution.pivot]).copied().collect()
}
