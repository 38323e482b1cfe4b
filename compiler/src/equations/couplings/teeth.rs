//! A pair of toothings without play. The sum of angles that it holds is found in `model::gears`.
//!
//! External teeth: z₁(θ₁ − ψ) + z₂(θ₂ − ψ − π) = π + 2πk, of a ring z₁(θ₁ − ψ) − z₂(θ₂ − ψ) = π + 2πk, with the angles of tooth
//! middles and ψ that of the line of centres: a tooth of the one faces a space of the other (Parker & Lin, Mesh phasing
//! relationships in planetary and epicyclic gears, J. Mech. Des. 126, 2004, section 2). Where a carrier holds both axles, the angles
//! are those against it, and the row is Willis' equation. A rack has its travel over m/2 in place of z₂θ₂, bevel gears and worms have ψ of their own.

use crate::equations::conditions::Condition;
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::equations::plane::MovingAxes;
use crate::forms::{CouplingForm, Form, Means, Positional, RowForm};
use crate::model::Coordinate;
use crate::model::gears::Pair;
use crate::symbolic::Node;

pub static ROW: RowForm = RowForm::own("teeth");

pub static COUPLING: CouplingForm = CouplingForm {
    call: Form {
        word: "gear",
        elsewhere: &[],
        positional: &[Positional::Toothing, Positional::Toothing],
        named: &[],
    },
    holds: "the teeth of two toothings mesh, by their numbers and by where they stand",
    means: Means::Teeth { row: &ROW },
};

/// Σ factor · angle + Σ factor · travel, over a number.
pub fn sum<'g>(laws: &Laws<'g>, pair: &Pair, over: f64) -> Moving<'g> {
    let angles = laws.sum_of_angles(&pair.terms, over);
    pair.travels.iter().fold(angles, |sum, (factor, joint)| {
        sum + (factor / over) * laws.kinematics().travel(laws, *joint, 0)
    })
}

/// How far apart the centres of a pair are whose axes move.
pub fn distance(laws: &Laws, pair: &Pair) -> Option<Node> {
    let (_, mesh) = laws.mechanism.mesh_of(pair);
    pair.axes_move.then(|| MovingAxes::of(laws, pair, &mesh).distance.bare)
}

/// The sum over z₁, as if it were an angle of the first wheel, less the phase.
pub fn row<'g>(laws: &Laws<'g>, pair: &Pair, phase: Option<Node>) -> Moving<'g> {
    let phase = phase.map_or_else(|| laws.g.zero(), |phase| laws.g.on(phase));
    sum(laws, pair, pair.scale()) - laws.still(phase)
}

/// The sum as something that assembly can hold at a value, but for whole pitches. Where axes move it is that of the angles against their line of centres.
pub fn facing(laws: &Laws, pair: &Pair) -> Condition {
    let sum = if pair.axes_move {
        let (_, mesh) = laws.mechanism.mesh_of(pair);
        let turned = MovingAxes::of(laws, pair, &mesh).turned;
        (pair.teeth[0] / mesh.base[0]) * turned + laws.still(laws.g.number(pair.constant))
    } else {
        sum(laws, pair, 1.0)
    };
    let rotor = pair.terms.first().map(|(_, rotor)| *rotor);
    Condition {
        of: format!("the teeth of {}", pair.name.text),
        coordinate: rotor.map_or(Coordinate::Turn(pair.on[0].body, 2), Coordinate::Angle),
        angular: true,
        counted: true,
        residual: sum.jet.value,
        upright: laws.g.one().bare,
        jet: sum.jet,
    }
}
