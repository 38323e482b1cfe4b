//! Constraints between joint coordinates: couplings, one file each, general equations, and drivers.

mod belt;
mod bevel;
mod differential;
mod gear;
mod rack;
mod screw;
mod teeth;
mod worm;

pub use teeth::{distance, facing, sum as sum_of_teeth};

use super::jet::Moving;
use super::laws::Laws;
use super::loads;
use super::space::joints::{self, Elementary};
use crate::forms::{Argument, CouplingForm, Need, Positional, RowForm};
use crate::model::{
    Constraint, ConstraintKind, Coordinate, Coupled, Coupling, Driver, Expr, JointId, Load, Mechanism,
    Occasion, Quantity, Rotor, Space,
};
use crate::symbolic::Node;
use crate::units::Dimension;
use std::collections::BTreeSet;

/// The couplings of the plane and of space.
pub static COUPLINGS: &[&CouplingForm] = &[
    &gear::COUPLING,
    &teeth::COUPLING,
    &bevel::COUPLING,
    &worm::COUPLING,
    &belt::COUPLING,
    &rack::COUPLING,
    &screw::COUPLING,
    &differential::COUPLING,
];

const ROTORS: &[Positional] = &[Positional::Rotor, Positional::Rotor];
const RATIO: Argument = Argument::scalar("ratio", Need::Always, Dimension::ONE);
const PHASE: Argument = Argument::scalar("phase", Need::Never, Dimension::ANGLE);
const LENGTH_PHASE: Argument = Argument::scalar("phase", Need::Never, Dimension::LENGTH);

/// Couplings whose phase comes from the assembled start, then loads between teeth, by name, in order.
pub fn open_phases(mechanism: &Mechanism) -> impl Iterator<Item = String> + '_ {
    let open = |constraint: &&Constraint| has_row(mechanism, constraint) && is_open(constraint);
    let loads = mechanism.loads.iter().filter(|load| mechanism.has_phase(load));
    let constraints = mechanism.constraints.iter().filter(open).map(|constraint| &constraint.name);
    constraints.chain(loads.map(|load| &load.name)).map(|name| name.identifier())
}

/// The number of the phase of a load between teeth, behind those of constraints.
pub fn phase_of_load(mechanism: &Mechanism, load: &Load) -> usize {
    let open = |constraint: &&Constraint| has_row(mechanism, constraint) && is_open(constraint);
    let before = mechanism.loads.iter().take_while(|other| other.name.text != load.name.text);
    mechanism.constraints.iter().filter(open).count()
        + before.filter(|other| mechanism.has_phase(other)).count()
}

/// Whether a coupling's phase comes from the assembled start.
pub fn is_open(constraint: &Constraint) -> bool {
    match &constraint.kind {
        ConstraintKind::Coupling(coupling) => coupling.phase.is_none(),
        ConstraintKind::Teeth { .. } => true,
        ConstraintKind::Equation { .. } => false,
    }
}

/// Whether a constraint has a row: teeth that others hold in place already have none.
pub fn has_row(mechanism: &Mechanism, constraint: &Constraint) -> bool {
    match &constraint.kind {
        ConstraintKind::Teeth { pair, .. } => mechanism.pairs[*pair].follows.is_none(),
        ConstraintKind::Coupling(_) | ConstraintKind::Equation { .. } => true,
    }
}

static EQUATION: RowForm = RowForm::own("equation");
static DRIVER: RowForm = RowForm::own("driver");

/// The row of a constraint. `phase` is used where the definition gives none.
pub fn row<'g>(
    laws: &Laws<'g>,
    constraint: &Constraint,
    phase: Option<Node>,
) -> (&'static RowForm, Moving<'g>) {
    match &constraint.kind {
        ConstraintKind::Coupling(coupling) => (&coupling.kind.row, proportion(laws, coupling, phase)),
        ConstraintKind::Equation { residual } => (&EQUATION, laws.jet(residual)),
        ConstraintKind::Teeth { pair, .. } => {
            (&teeth::ROW, teeth::row(laws, &laws.mechanism.pairs[*pair], phase))
        }
    }
}

/// driven − factor · other − phase.
fn proportion<'g>(laws: &Laws<'g>, coupling: &Coupling, phase: Option<Node>) -> Moving<'g> {
    let coordinate = |coupled| match coupled {
        Coupled::Angle(rotor) => laws.angle(rotor),
        Coupled::Travel(joint) => laws.kinematics().travel(laws, joint, 0),
    };
    let factor = laws.value(&coupling.factor);
    let residual = coordinate(coupling.driven()) - factor * coordinate(coupling.other());
    let phase = match &coupling.phase {
        Some(given) => laws.value(given),
        None => phase.map_or_else(|| laws.g.zero(), |phase| laws.g.on(phase)),
    };
    residual - laws.still(phase)
}

/// quantity − law(time).
pub fn driver_row<'g>(laws: &Laws<'g>, driver: &Driver) -> (&'static RowForm, Moving<'g>) {
    (&DRIVER, laws.coordinate(&driver.coordinate) - laws.jet(&driver.law))
}

/// The rotors whose angle the dynamics use, and which therefore carry it over several turns.
pub fn multi_turn_rotors(mechanism: &Mechanism) -> Vec<Rotor> {
    let mut rotors = BTreeSet::new();
    for constraint in &mechanism.constraints {
        match &constraint.kind {
            ConstraintKind::Coupling(coupling) => rotors.extend(coupling.rotors()),
            ConstraintKind::Equation { residual } => angles_in(residual, &mut rotors),
            ConstraintKind::Teeth { pair, .. } => {
                rotors.extend(mechanism.pairs[*pair].terms.iter().map(|(_, rotor)| *rotor));
            }
        }
    }
    for driver in &mechanism.drivers {
        angles_of(&driver.coordinate, &mut rotors);
    }
    for load in &mechanism.loads {
        rotors.extend((loads::of(load.form).counted)(load));
        if let Some(teeth) = &load.teeth {
            let pair = &mechanism.pairs[teeth.pair];
            rotors.extend(pair.terms.iter().chain(&pair.turns).map(|(_, rotor)| *rotor));
        }
        load.expressions().for_each(|expression| angles_in(expression, &mut rotors));
    }
    // An angle that jumps by a turn passes no level, and what is remembered of one goes on.
    for event in &mechanism.events {
        if let Occasion::Passing(past, _) = &event.occasion {
            angles_in(past, &mut rotors);
        }
        let jump = event.jump.iter().map(|jump| &jump.to);
        event.sets.iter().map(|(_, value)| value).chain(jump).for_each(|value| angles_in(value, &mut rotors));
    }
    // The travel of a screw is its counted angle times the pitch.
    for (index, joint) in mechanism.joints.iter().enumerate() {
        if mechanism.space == Space::Spatial && joints::motions(joint).contains(&Elementary::Wind) {
            rotors.insert(Rotor::Joint(JointId(index), 0));
        }
    }
    rotors.into_iter().collect()
}

fn angles_in(expr: &Expr, rotors: &mut BTreeSet<Rotor>) {
    expr.quantities(&mut |quantity| {
        if let Quantity::Coordinate(coordinate) = quantity {
            angles_of(coordinate, rotors);
        }
    });
}

fn angles_of(coordinate: &Coordinate, rotors: &mut BTreeSet<Rotor>) {
    if let Coordinate::Angle(rotor) = coordinate {
        rotors.insert(*rotor);
    }
}
