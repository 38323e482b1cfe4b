//! The functions of a mechanism: what is optimised, scheduled, emitted, counted and interpreted, by one list.

use crate::equations::tangent::Matrix;
use crate::equations::{Equations, Tangents};
use crate::solve::Solved;
use crate::symbolic::Node;

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
    InverseDynamics,
    Powers,
    DriverEfforts,
    Motions,
    Reactions,
    RowCosines,
    ConditionResidual,
    ConditionCosines,
    ConditionJacobian,
    ConditionBias,
    ConditionDrift,
    /// Values, then rates, that `start` asks of each condition; 0 where it asks none.
    StartTargets,
    /// Masses and inertias that depend on parameters.
    Masses,
    /// What the pivots of rows are measured by.
    RowScales,
    /// K(c) factored: what is kept, and the smallest relative pivot.
    Factor,
    /// The same with the right-hand sides of the penalty formulation: what is kept, Q, the rows, the pivot.
    System,
    /// a and λ of K(c) from what is kept and a right-hand side.
    Solve,
    /// D = L U: what is kept, and the smallest pivot squared.
    FactorJacobian,
    /// Velocities with D v = rows from what is kept, the rows, and the independent velocities.
    DependentVelocities,
    /// v̇, λ and the smallest pivot, in independent velocities.
    NullSpace,
    /// r = M a + Dᵀ λ − Q.
    Residual,
    /// ∂r/∂q, ∂r/∂v.
    Tangent,
    /// ∂(D a − γ)/∂q, ∂(D a − γ)/∂v.
    RowTangent,
    /// ∂(D v − ν)/∂q.
    RateTangent,
    InputTangent,
    ParameterTangent,
    OutputTangent,
    CoordinateTangent,
}

impl Function {
    /// Every function; those that a mechanism does not emit compute nothing.
    pub const ALL: [Function; 40] = [
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
        Function::InverseDynamics,
        Function::Powers,
        Function::DriverEfforts,
        Function::Motions,
        Function::Reactions,
        Function::RowCosines,
        Function::ConditionResidual,
        Function::ConditionCosines,
        Function::ConditionJacobian,
        Function::ConditionBias,
        Function::ConditionDrift,
        Function::StartTargets,
        Function::Masses,
        Function::RowScales,
        Function::Factor,
        Function::System,
        Function::Solve,
        Function::FactorJacobian,
        Function::DependentVelocities,
        Function::NullSpace,
        Function::Residual,
        Function::Tangent,
        Function::RowTangent,
        Function::RateTangent,
        Function::InputTangent,
        Function::ParameterTangent,
        Function::OutputTangent,
        Function::CoordinateTangent,
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
            Function::InverseDynamics => "inverse_dynamics",
            Function::Powers => "powers",
            Function::DriverEfforts => "driver_efforts",
            Function::Motions => "motions",
            Function::Reactions => "reactions",
            Function::RowCosines => "row_cosines",
            Function::ConditionResidual => "condition_residual",
            Function::ConditionCosines => "condition_cosines",
            Function::ConditionJacobian => "condition_jacobian",
            Function::ConditionBias => "condition_bias",
            Function::ConditionDrift => "condition_drift",
            Function::StartTargets => "start_targets",
            Function::Masses => "masses",
            Function::RowScales => "row_scales",
            Function::Factor => "factor",
            Function::System => "system",
            Function::Solve => "solve",
            Function::FactorJacobian => "factor_jacobian",
            Function::DependentVelocities => "dependent_velocities",
            Function::NullSpace => "null_space",
            Function::Residual => "residual",
            Function::Tangent => "tangent",
            Function::RowTangent => "row_tangent",
            Function::RateTangent => "rate_tangent",
            Function::InputTangent => "input_tangent",
            Function::ParameterTangent => "parameter_tangent",
            Function::OutputTangent => "output_tangent",
            Function::CoordinateTangent => "coordinate_tangent",
        }
    }
}

/// What a function computes, in the order of its outputs.
pub fn outputs(equations: &Equations, solved: &Solved, function: Function) -> Vec<Node> {
    let e = equations;
    let rows = || e.rows.iter();
    let conditions = || e.conditions.iter();
    let zero = e.zero;
    let stored = || solved.stored.iter();
    let independent = || solved.null_space.iter();
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
        Function::InverseDynamics => e.inverse.clone(),
        Function::Powers => e.powers.clone(),
        Function::DriverEfforts => e.driver_efforts.iter().chain(&e.driver_powers).copied().collect(),
        Function::Motions => e.motions.iter().flat_map(|motion| motion.flat()).collect(),
        Function::Reactions => e.reactions.iter().flatten().copied().collect(),
        Function::RowCosines => rows().map(|row| row.upright.unwrap_or(e.one)).collect(),
        Function::ConditionResidual => conditions().map(|c| c.residual).collect(),
        Function::ConditionCosines => conditions().map(|c| c.upright).collect(),
        Function::ConditionJacobian => conditions().flat_map(|c| c.jet.columns.values().copied()).collect(),
        Function::ConditionBias => conditions().map(|c| c.jet.bias).collect(),
        Function::ConditionDrift => conditions().map(|c| c.jet.drift).collect(),
        Function::StartTargets => {
            let target = |value: Option<Node>| value.unwrap_or(zero);
            let positions = e.start_targets.iter().map(|start| target(start.position));
            positions.chain(e.start_targets.iter().map(|start| target(start.rate))).collect()
        }
        Function::Masses => e.masses.iter().map(|(_, node)| *node).collect(),
        Function::RowScales => solved.row_scales.clone(),
        Function::Factor => stored().flat_map(|s| s.kept.iter().chain([&s.pivot])).copied().collect(),
        Function::System if !solved.emits_system => Vec::new(),
        Function::System => stored()
            .flat_map(|s| s.kept.iter().chain(&e.forces).chain(&s.rows).chain([&s.velocity_pivot]))
            .copied()
            .collect(),
        Function::Solve => stored().flat_map(|s| s.solution.iter().copied()).collect(),
        Function::FactorJacobian => {
            independent().flat_map(|n| n.kept.iter().chain([&n.partition_pivot])).copied().collect()
        }
        Function::DependentVelocities => independent().flat_map(|n| n.dependent.iter().copied()).collect(),
        Function::NullSpace => independent()
            .flat_map(|n| n.acceleration.iter().chain(&n.lambda).chain([&n.pivot]))
            .copied()
            .collect(),
        Function::Residual => e.tangents.iter().flat_map(|tangents| tangents.residual.clone()).collect(),
        Function::Tangent => matrices(e, |tangents| vec![&tangents.stiffness, &tangents.damping]),
        Function::RowTangent => matrices(e, |tangents| vec![&tangents.row_stiffness, &tangents.row_damping]),
        Function::RateTangent => matrices(e, |tangents| vec![&tangents.rate]),
        Function::InputTangent => matrices(e, |tangents| vec![&tangents.input]),
        Function::ParameterTangent => matrices(e, |tangents| vec![&tangents.parameter]),
        Function::OutputTangent => matrices(e, |tangents| vec![&tangents.output]),
        Function::CoordinateTangent => matrices(e, |tangents| vec![&tangents.coordinate]),
    }
}

/// The stored entries of matrices, row by row; nothing where they are not asked for.
fn matrices(equations: &Equations, of: fn(&Tangents) -> Vec<&Matrix>) -> Vec<Node> {
    let rows = equations.tangents.iter().flat_map(of).flatten();
    rows.flat_map(|row| row.values().copied()).collect()
}

fn solution(solution: &crate::solve::Solution) -> Vec<Node> {
    solution.acceleration.iter().chain(&solution.lambda).chain([&solution.pivot]).copied().collect()
}
