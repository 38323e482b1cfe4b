//! The table of all functions. A new function is a variant of [`Function`] and an entry here.

use super::Argument::{
    Acceleration, BetaSquared, Compliance, Constants, GivenForces, GivenRows, Inputs, Lambda, Lu, Parameters,
    Phases, Q, State, Store, Target, Time, TwoAlpha, V,
};
use super::Interface::{Assemble, Mechanism, Model, Preparation, Tangent};
use super::signature::{signature, value, written};
use super::{Argument, Function, Shape, Signature, shape};
use crate::complete::Complete;
use crate::equations::StartTarget;
use crate::solve::{NullSpace, Stored};
use crate::symbolic::Node;

const POSITION: &[Argument] = &[Constants, Time, Q];
const STATE: &[Argument] = &[Constants, Time, Q, V];
// What depends on loads is handed the state as a whole.
const WITH_INPUTS: &[Argument] = &[Constants, Time, State, Inputs];
/// Of the accelerations: those of `acceleration` are the first of `acceleration_baumgarte`.
const SOLUTION: &[Argument] = WITH_INPUTS;
const STABILISED: &[Argument] = &[Constants, Time, State, Inputs, TwoAlpha, BetaSquared];
const MOVING: &[Argument] = &[Constants, Time, Q, V, Acceleration];
const EVERYTHING: &[Argument] = &[Constants, Time, State, Inputs, Acceleration, Lambda];

/// Every function.
pub static FUNCTIONS: [Signature; 52] = [
    signature(
        Function::MassMatrix,
        "mass_matrix",
        Mechanism,
        "M(t, q): its stored entries (kg, kg m, kg m²).",
        POSITION,
        &[written("out", Shape::Matrix(&shape::MASS), |c| shape::MASS.nodes(c))],
    ),
    signature(
        Function::Constraints,
        "constraints",
        Mechanism,
        "Φ(t, q) of each row (m, or 1 for directions and angles).",
        POSITION,
        &[written("out", Shape::Rows, |c| c.equations.rows.iter().map(|row| row.jet.value).collect())
            .called("phi_{}")],
    ),
    signature(
        Function::ConstraintJacobian,
        "constraint_jacobian",
        Mechanism,
        "D(t, q), Φ̇ = D v − ν: its stored entries.",
        POSITION,
        &[written("out", Shape::Matrix(&shape::JACOBIAN), |c| shape::JACOBIAN.nodes(c))],
    ),
    signature(
        Function::Nu,
        "nu",
        Mechanism,
        "ν(t, q) = −∂Φ/∂t, the right-hand side of D v = ν.",
        POSITION,
        &[written("out", Shape::Rows, |c| c.equations.nu.clone()).called("nu_{}")],
    ),
    signature(
        Function::Gamma,
        "gamma",
        Mechanism,
        "γ(t, q, v), the right-hand side of D v̇ = γ.",
        STATE,
        &[written("out", Shape::Rows, |c| c.equations.gamma.clone()).called("gamma_{}")],
    ),
    signature(
        Function::Forces,
        "forces",
        Mechanism,
        "Q(t, q, v, u): loads, gravity and gyroscopic forces of M v̇ + Dᵀ λ = Q (N or N m).",
        WITH_INPUTS,
        &[written("out", Shape::Velocities, |c| c.equations.forces.clone()).called("force_{}")],
    ),
    signature(
        Function::FrictionForces,
        "friction_forces",
        Mechanism,
        "Q_f(t, q, v, z, u, v̇, λ): friction that follows from reactions, in M v̇ + Dᵀ λ = Q + Q_f (N or N m).",
        EVERYTHING,
        &[written("out", Shape::Velocities, |c| c.equations.friction.forces.clone()).called("friction_{}")],
    )
    .only(has_friction),
    signature(
        Function::KineticEnergy,
        "kinetic_energy",
        Mechanism,
        "T(t, q, v) (J).",
        STATE,
        &[value("energy", Shape::Scalar, |c| vec![c.equations.kinetic_energy])],
    ),
    signature(
        Function::PotentialEnergy,
        "potential_energy",
        Mechanism,
        "V(t, q) of gravity and springs (J).",
        &[Constants, Time, State],
        &[value("energy", Shape::Scalar, |c| vec![c.equations.potential_energy])],
    ),
    signature(
        Function::Acceleration,
        "acceleration",
        Mechanism,
        "v̇ and λ of M v̇ + Dᵀ λ = Q, D v̇ = γ; the smallest relative pivot.",
        SOLUTION,
        &[
            written("a_out", Shape::Velocities, |c| c.solved.index1.acceleration.clone()).called("{}_dot"),
            written("lambda_out", Shape::Rows, |c| c.solved.index1.lambda.clone()).called("lambda_{}"),
            value("pivot", Shape::Scalar, |c| vec![c.solved.index1.pivot]).called("smallest_pivot"),
        ],
    ),
    signature(
        Function::AccelerationBaumgarte,
        "acceleration_baumgarte",
        Mechanism,
        "v̇ and λ of M v̇ + Dᵀ λ = Q, D v̇ = γ − 2α (D v − ν) − β² Φ (Baumgarte 1972); the \
         smallest relative pivot.",
        STABILISED,
        &[
            written("a_out", Shape::Velocities, |c| c.solved.baumgarte.acceleration.clone()).called("{}_dot"),
            written("lambda_out", Shape::Rows, |c| c.solved.baumgarte.lambda.clone()).called("lambda_{}"),
            value("pivot", Shape::Scalar, |c| vec![c.solved.baumgarte.pivot]).called("smallest_pivot"),
        ],
    ),
    signature(
        Function::NullSpace,
        "null_space",
        Mechanism,
        "As `acceleration`, by independent velocities; the smallest pivot, squared where it is one \
         of D.",
        SOLUTION,
        &[
            written("a_out", Shape::Velocities, |c| independent(c, |n| n.plain.acceleration.clone()))
                .called("{}_dot"),
            written("lambda_out", Shape::Rows, |c| independent(c, |n| n.plain.lambda.clone()))
                .called("lambda_{}"),
            value("pivot", Shape::Scalar, |c| independent(c, |n| vec![n.plain.pivot]))
                .called("smallest_pivot"),
        ],
    )
    .only(|c| c.further.null_space.is_some()),
    signature(
        Function::NullSpaceBaumgarte,
        "null_space_baumgarte",
        Mechanism,
        "As `acceleration_baumgarte`, by independent velocities; the smallest pivot, squared where \
         it is one of D.",
        STABILISED,
        &[
            written("a_out", Shape::Velocities, |c| independent(c, |n| n.stabilised.acceleration.clone()))
                .called("{}_dot"),
            written("lambda_out", Shape::Rows, |c| independent(c, |n| n.stabilised.lambda.clone()))
                .called("lambda_{}"),
            value("pivot", Shape::Scalar, |c| independent(c, |n| vec![n.stabilised.pivot]))
                .called("smallest_pivot"),
        ],
    )
    .only(|c| c.further.leads),
    signature(
        Function::Outputs,
        "outputs",
        Mechanism,
        "The outputs of the definition, in SI units.",
        WITH_INPUTS,
        &[value("outputs", Shape::Outputs, |c| c.solved.outputs.clone()).called("{}")],
    ),
    signature(
        Function::InternalRates,
        "internal_rates",
        Mechanism,
        "ż of the internal states, in their units per s.",
        EVERYTHING,
        &[written("rates", Shape::Internal, |c| c.equations.internal_rates.clone()).called("{}_dot")],
    )
    .only(has_internal_states),
    signature(
        Function::Guards,
        "guards",
        Mechanism,
        "Of each gate that is held the gap (m or rad), and the force of its law without the gate (N or N m).",
        &[Constants, Time, State],
        &[
            written("gaps", Shape::Gates, |c| guards(c, 0)).called("gap_{}"),
            written("forces", Shape::Gates, |c| guards(c, 1)).called("force_{}"),
        ],
    )
    .only(|c| !c.equations.guards.is_empty()),
    signature(
        Function::Assignments,
        "assignments",
        Mechanism,
        "All that is held after the events whose places are 1: memories as these set them (SI), at the places of events what\n\
         their speeds jump to (m/s or rad/s), the rest as it is.",
        WITH_INPUTS,
        &[written("after", Shape::Gates, |c| c.solved.assignments.clone()).called("{}_after")],
    )
    .only(|c| !c.solved.assignments.is_empty()),
    signature(
        Function::Strikes,
        "strikes",
        Mechanism,
        "Of each rigid contact the rate of its gap (m/s or rad/s), what of its second time derivative is there at v̇ = 0\n\
         (m/s² or rad/s²), and its restitution; of each dry friction its sliding (m/s), the same of its derivative, and 0;\n\
         of each event whose speed jumps that (m/s or rad/s), 0, and 1.",
        &[Constants, Time, Q, V],
        &[
            written("rates", Shape::Gates, |c| strikes(c, 0)).called("rate_{}"),
            written("biases", Shape::Gates, |c| strikes(c, 1)).called("bias_{}"),
            written("restitutions", Shape::Gates, |c| strikes(c, 2)).called("restitution_{}"),
        ],
    )
    .only(|c| !c.equations.strikes.is_empty()),
    signature(
        Function::Grips,
        "grips",
        Mechanism,
        "Of each dry friction the shares of what presses with which it holds and slides; 0 of other gates.",
        &[Constants],
        &[
            written("holding", Shape::Gates, |c| grips(c, 0)).called("holding_{}"),
            written("sliding", Shape::Gates, |c| grips(c, 1)).called("sliding_{}"),
        ],
    )
    .only(|c| !c.equations.grips.is_empty()),
    signature(
        Function::Bounds,
        "bounds",
        Mechanism,
        "Of each dry friction of a joint the most that it holds with, and what it slides with (N or N m).",
        EVERYTHING,
        &[
            written("holding", Shape::Gates, |c| bounds(c, 0)).called("holding_{}"),
            written("sliding", Shape::Gates, |c| bounds(c, 1)).called("sliding_{}"),
        ],
    )
    .only(|c| !c.equations.bounds.is_empty()),
    signature(
        Function::InverseDynamics,
        "inverse_dynamics",
        Model,
        "M v̇ − Q: the forces that the accelerations `a` need beside loads and constraints, one \
         for each velocity\n\
         (N m or N). Of a tree without constraints these are the efforts of its joints (inverse \
         dynamics).",
        &[Constants, Time, State, Inputs, Acceleration],
        &[value("forces", Shape::Velocities, |c| c.equations.inverse_dynamics.clone())],
    ),
    signature(
        Function::Powers,
        "powers",
        Model,
        "Power of each load (W), in the order of `LOADS`, what springs store included.",
        WITH_INPUTS,
        &[value("powers", Shape::Loads, |c| c.solved.powers.clone())],
    ),
    signature(
        Function::DriverEfforts,
        "driver_efforts",
        Model,
        "Effort of each driver along its quantity (N m or N) and its power (W), from the \
         multipliers.",
        &[Constants, Time, Q, V, Lambda],
        &[
            value("efforts", Shape::Drivers, |c| c.equations.driver_efforts.clone()),
            value("powers", Shape::Drivers, |c| c.equations.driver_powers.clone()),
        ],
    ),
    signature(
        Function::Motions,
        "motions",
        Model,
        "Position, velocity and acceleration of every body's centre of mass, in the order of \
         `BODIES`,\n\
         from a state and its accelerations.",
        MOVING,
        &[value("motions", Shape::Bodies(&shape::MOTION), |c| {
            c.equations.motions.iter().flat_map(|motion| motion.flat()).collect()
        })],
    ),
    signature(
        Function::Reactions,
        "reactions",
        Model,
        "Force and torque that each joint exerts on the body of its second place, in the order of \
         `JOINTS`:\n\
         force in world axes at that place (N), torque about it (N m).",
        EVERYTHING,
        &[value("reactions", Shape::Joints(&shape::REACTION), |c| {
            c.equations.reactions.iter().flatten().copied().collect()
        })],
    ),
    signature(
        Function::RowCosines,
        "row_cosines",
        Assemble,
        "Of each row that fixes a direction the cosine that tells it from its opposite; 1 of \
         others.",
        POSITION,
        &[written("out", Shape::Rows, |c| {
            c.equations.rows.iter().map(|row| row.upright.unwrap_or(c.equations.one)).collect()
        })],
    ),
    signature(
        Function::ConditionResidual,
        "condition_residual",
        Assemble,
        "What each condition of the start is off its target by, as a length or a sine.",
        &[Constants, Time, Q, Target],
        &[written("out", Shape::Conditions, |c| c.conditions.rows.iter().map(|c| c.residual).collect())],
    ),
    signature(
        Function::ConditionCosines,
        "condition_cosines",
        Assemble,
        "The cosine that belongs to that sine; 1 of lengths.",
        &[Constants, Time, Q, Target],
        &[written("out", Shape::Conditions, |c| c.conditions.rows.iter().map(|c| c.upright).collect())],
    ),
    signature(
        Function::ConditionJacobian,
        "condition_jacobian",
        Assemble,
        "J(t, q), the rate of a condition being J v + b: its stored entries.",
        POSITION,
        &[written("out", Shape::Matrix(&shape::CONDITION_JACOBIAN), |c| shape::CONDITION_JACOBIAN.nodes(c))],
    ),
    signature(
        Function::ConditionBias,
        "condition_bias",
        Assemble,
        "The rate of J v + b where v̇ = 0.",
        STATE,
        &[written("out", Shape::Conditions, |c| c.conditions.rows.iter().map(|c| c.jet.bias).collect())],
    ),
    signature(
        Function::ConditionDrift,
        "condition_drift",
        Assemble,
        "b(t, q), the rate of a condition where v = 0.",
        POSITION,
        &[written("out", Shape::Conditions, |c| c.conditions.rows.iter().map(|c| c.jet.drift).collect())],
    ),
    signature(
        Function::StartTargets,
        "start_targets",
        Assemble,
        "Values, and rates, that `start` asks of each condition; 0 where it asks none.",
        &[Constants],
        &[
            written("positions", Shape::Conditions, |c| targets(c, |target| target.position)),
            written("rates", Shape::Conditions, |c| targets(c, |target| target.rate)),
        ],
    ),
    signature(
        Function::StartInternal,
        "start_internal",
        Assemble,
        "The internal states at the start.",
        &[Constants],
        &[value("internal", Shape::Internal, |c| c.equations.internal_starts.clone())],
    )
    .only(has_internal_states),
    signature(
        Function::Masses,
        "masses",
        Preparation,
        "Masses and inertias that depend on parameters.",
        &[Constants],
        &[value("masses", Shape::Masses, |c| c.equations.masses.iter().map(|(_, node)| *node).collect())],
    ),
    signature(
        Function::RowScales,
        "row_scales",
        Assemble,
        "Sᵢ of each row, twice the largest Dᵢ M⁻¹ Dᵢᵀ along the motion (1/kg or 1/(kg m²)): what \
         pivots of rows are measured by.",
        &[Constants],
        &[written("out", Shape::Rows, |c| c.solved.row_scales.clone())],
    ),
    signature(
        Function::Factor,
        "factor",
        Assemble,
        "K(c) = (M Dᵀ; D −c) factored: what is kept of it; the smallest relative pivot.",
        &[Constants, Time, Q, Compliance],
        &[
            written("store", Shape::Store, |c| stored(c, |k| k.kept.clone())),
            value("pivot", Shape::Scalar, |c| stored(c, |k| vec![k.pivot])),
        ],
    )
    .only(|c| c.further.stored.is_some()),
    signature(
        Function::System,
        "system",
        Assemble,
        "Factors K(c) and evaluates its right-hand sides Q (N, N m) and γ − 2α (D v − ν) − β² Φ; \
         the smallest relative pivot of the\n\
         velocities where M alone is singular, else one.",
        &[Constants, Time, State, Inputs, TwoAlpha, BetaSquared, Compliance],
        &[
            written("store_out", Shape::Store, |c| stored(c, |k| k.kept.clone())),
            written("forces_out", Shape::Velocities, |c| c.equations.forces.clone()),
            written("rows_out", Shape::Rows, |c| stored(c, |k| k.rows.clone())),
            value("pivot", Shape::Scalar, |c| stored(c, |k| vec![k.velocity_pivot])),
        ],
    )
    .only(|c| c.further.emits_system && c.further.stored.is_some()),
    signature(
        Function::Solve,
        "solve",
        Assemble,
        "a and λ of K(c) (a, λ) = (forces, rows), from what is kept of its factorisation.",
        &[Constants, Store, GivenForces, GivenRows],
        &[
            written("a_out", Shape::Velocities, |c| {
                stored(c, |k| k.solution.iter().copied().take(c.equations.layout.velocities()).collect())
            }),
            written("lambda_out", Shape::Rows, |c| {
                stored(c, |k| k.solution.iter().copied().skip(c.equations.layout.velocities()).collect())
            }),
        ],
    )
    .only(|c| c.further.stored.is_some()),
    signature(
        Function::FactorJacobian,
        "factor_jacobian",
        Assemble,
        "D = L U in the dependent velocities: what is kept of it; the smallest pivot squared.",
        POSITION,
        &[
            written("lu", Shape::Lu, |c| independent(c, |n| n.kept.clone())),
            value("pivot", Shape::Scalar, |c| independent(c, |n| vec![n.partition_pivot])),
        ],
    )
    .only(|c| c.further.emits_factors),
    signature(
        Function::DependentVelocities,
        "dependent_velocities",
        Assemble,
        "Velocities with D v = rows, from what is kept of D, the rows, and the independent \
         velocities.",
        &[Constants, Lu, GivenRows, V],
        &[written("out", Shape::Velocities, |c| independent(c, |n| n.dependent.clone()))],
    )
    .only(|c| c.further.emits_factors),
    signature(
        Function::Residual,
        "residual",
        Tangent,
        "r = M v̇ + Dᵀ λ − Q (N or N m).",
        EVERYTHING,
        &[written("out", Shape::Velocities, |c| {
            c.tangents.iter().flat_map(|tangents| tangents.residual.clone()).collect()
        })],
    ),
    signature(
        Function::Tangent,
        "tangent",
        Tangent,
        "∂r/∂q along increments of q, and ∂r/∂v: the stored entries.",
        EVERYTHING,
        &[
            written("stiffness_out", Shape::Matrix(&shape::STIFFNESS), |c| shape::STIFFNESS.nodes(c)),
            written("damping_out", Shape::Matrix(&shape::DAMPING), |c| shape::DAMPING.nodes(c)),
        ],
    ),
    signature(
        Function::RowTangent,
        "row_tangent",
        Tangent,
        "∂(D v̇ − γ)/∂q along increments of q, and ∂(D v̇ − γ)/∂v: the stored entries.",
        MOVING,
        &[
            written("stiffness_out", Shape::Matrix(&shape::ROW_STIFFNESS), |c| shape::ROW_STIFFNESS.nodes(c)),
            written("damping_out", Shape::Matrix(&shape::ROW_DAMPING), |c| shape::ROW_DAMPING.nodes(c)),
        ],
    ),
    signature(
        Function::RateTangent,
        "rate_tangent",
        Tangent,
        "∂(D v − ν)/∂q along increments of q: the stored entries.",
        STATE,
        &[written("out", Shape::Matrix(&shape::RATE), |c| shape::RATE.nodes(c))],
    ),
    signature(
        Function::InputTangent,
        "input_tangent",
        Tangent,
        "∂r/∂u = −∂Q/∂u: the stored entries.",
        WITH_INPUTS,
        &[written("out", Shape::Matrix(&shape::INPUT), |c| shape::INPUT.nodes(c))],
    ),
    signature(
        Function::InternalTangent,
        "internal_tangent",
        Tangent,
        "∂r/∂z = −∂Q/∂z of the internal states: the stored entries.",
        WITH_INPUTS,
        &[written("out", Shape::Matrix(&shape::INTERNAL), |c| shape::INTERNAL.nodes(c))],
    )
    .only(has_internal_tangent),
    signature(
        Function::FrictionTangent,
        "friction_tangent",
        Tangent,
        "∂(−Q_f)/∂(u, λ, z, v̇) of friction by reactions: the stored entries.",
        EVERYTHING,
        &[written("out", Shape::Matrix(&shape::FRICTION), |c| shape::FRICTION.nodes(c))],
    )
    .only(|c| c.tangents.is_some() && has_friction(c)),
    signature(
        Function::ParameterTangent,
        "parameter_tangent",
        Tangent,
        "Derivatives by the parameters of r, D v̇ − γ, D v − ν, Φ, the outputs, ż and z₀: the stored \
         entries.",
        EVERYTHING,
        &[written("out", Shape::Matrix(&shape::PARAMETER), |c| shape::PARAMETER.nodes(c))],
    ),
    signature(
        Function::OutputTangent,
        "output_tangent",
        Tangent,
        "Derivatives of the outputs by q, v, u, λ, z and v̇: the stored entries.",
        EVERYTHING,
        &[written("out", Shape::Matrix(&shape::OUTPUT), |c| shape::OUTPUT.nodes(c))],
    ),
    signature(
        Function::InternalRateTangent,
        "internal_rate_tangent",
        Tangent,
        "Derivatives of ż of the internal states by q, v, u, λ, z and v̇: the stored entries.",
        EVERYTHING,
        &[written("out", Shape::Matrix(&shape::INTERNAL_RATE), |c| shape::INTERNAL_RATE.nodes(c))],
    )
    .only(has_internal_tangent),
    signature(
        Function::CoordinateTangent,
        "coordinate_tangent",
        Tangent,
        "∂(ṡ, s̈)/∂(q, v) of the independent coordinates s at given v̇: the stored entries.",
        MOVING,
        &[written("out", Shape::Matrix(&shape::COORDINATE), |c| shape::COORDINATE.nodes(c))],
    ),
    signature(
        Function::Prepare,
        "prepare",
        Preparation,
        "What depends on parameters and phases alone: the constants of the prepared model.",
        &[Parameters, Phases],
        &[value("constants", Shape::Constants, |_| Vec::new())],
    ),
];

/// What the factorisation of K(c) keeps or gives, where it is asked for.
fn stored(complete: &Complete, of: impl Fn(&Stored) -> Vec<Node>) -> Vec<Node> {
    complete.further.stored.as_ref().map_or(Vec::new(), of)
}

fn independent(complete: &Complete, of: impl Fn(&NullSpace) -> Vec<Node>) -> Vec<Node> {
    complete.further.null_space.as_ref().map_or(Vec::new(), of)
}

fn targets(complete: &Complete, of: fn(&StartTarget) -> Option<Node>) -> Vec<Node> {
    complete.conditions.start.iter().map(|target| of(target).unwrap_or(complete.equations.zero)).collect()
}

fn has_friction(complete: &Complete) -> bool {
    !complete.equations.friction.is_none()
}

fn guards(complete: &Complete, which: usize) -> Vec<Node> {
    complete.equations.guards.iter().map(|guard| guard[which]).collect()
}

fn grips(complete: &Complete, which: usize) -> Vec<Node> {
    complete.equations.grips.iter().map(|shares| shares[which]).collect()
}

fn bounds(complete: &Complete, which: usize) -> Vec<Node> {
    complete.equations.bounds.iter().map(|bounds| bounds[which]).collect()
}

fn strikes(complete: &Complete, which: usize) -> Vec<Node> {
    complete.equations.strikes.iter().map(|strike| strike[which]).collect()
}

fn has_internal_states(complete: &Complete) -> bool {
    !complete.equations.internal_rates.is_empty()
}

fn has_internal_tangent(complete: &Complete) -> bool {
    complete.tangents.is_some() && has_internal_states(complete)
}
