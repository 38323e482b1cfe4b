//! The loads, one file each with the same parts in the same order: `LOAD` (the record), `terms` (generalised forces, power,
//! potential energy), `symbol`. What only the plane or only space has stands in `plane::loads` and `space::loads`.

mod bouc_wen;
mod cable;
mod contact;
mod damper;
mod expression;
mod force;
mod hysteresis;
mod masing;
pub mod penalty;
mod push;
mod shaft;
mod spring;
pub mod teeth;
mod torque;
mod torsion_spring;

pub use contact::{LOAD as CONTACT, bounds, grips, guards, strikes};
pub use hysteresis::Inner;
pub use penalty::LOAD as PENALTY;
pub use torque::CALL as TORQUE;

use super::jet::Moving;
use super::laws::Laws;
use super::{friction, plane, space};
use crate::drawing::load::Symbol;
use crate::forms::LoadForm;
use crate::model::{Expr, Load, Rotor, Space};
use crate::symbolic::{Node, Scalar};

/// A kind of load.
pub struct LoadKind {
    pub form: LoadForm,
    pub terms: for<'g> fn(&Laws<'g>, &Load) -> LoadTerms<'g>,
    /// Of its internal states, if its form says that it has any.
    pub inner: Option<&'static Inner>,
    /// What it exerts as one quantity, if its form has a name for that.
    pub effort: Option<for<'g> fn(&Laws<'g>, &Load) -> Scalar<'g>>,
    /// The rotors whose turns it needs counted, beyond those that its law names.
    pub counted: fn(&Load) -> Vec<Rotor>,
    pub symbol: fn(&mut Symbol),
}

/// The loads that the plane and space have in common.
pub static LOADS: &[&LoadKind] = &[
    &force::LOAD,
    &push::LOAD,
    &torque::LOAD,
    &spring::LOAD,
    &cable::LOAD,
    &damper::LOAD,
    &torsion_spring::LOAD,
    &shaft::LOAD,
    &expression::LOAD,
    &masing::LOAD,
    &bouc_wen::LOAD,
];

/// The loads of the plane or of space.
pub fn of_space(space: Space) -> impl Iterator<Item = &'static LoadKind> {
    let own = match space {
        Space::Planar => plane::loads::LOADS,
        Space::Spatial => space::loads::LOADS,
    };
    LOADS.iter().chain(friction::LAWS).chain(own).copied()
}

/// The load with a form, which is one of the lists' own.
pub fn of(form: &'static LoadForm) -> &'static LoadKind {
    let named = [Space::Planar, Space::Spatial].into_iter().flat_map(of_space);
    let mut all = named.chain([&contact::LOAD, &penalty::LOAD]);
    all.find(|load| std::ptr::eq(&load.form, form)).expect("forms come from the lists")
}

/// What one load does.
pub struct LoadTerms<'g> {
    /// Added to Q, per velocity.
    pub forces: Vec<(usize, Scalar<'g>)>,
    /// W, of everything the load exerts, springs' conservative part included.
    pub power: Scalar<'g>,
    /// J, of springs.
    pub potential: Scalar<'g>,
}

impl<'g> LoadTerms<'g> {
    pub fn none(laws: &Laws<'g>) -> Self {
        let zero = laws.g.zero();
        LoadTerms { forces: Vec::new(), power: zero, potential: zero }
    }

    /// What both do together.
    pub fn and(mut self, other: Self) -> Self {
        self.forces.extend(other.forces);
        self.power += other.power;
        self.potential += other.potential;
        self
    }
}

/// ż of one of a load's internal states.
pub fn rate<'g>(laws: &Laws<'g>, load: &Load, which: usize) -> Scalar<'g> {
    let rates = of(load.form).inner.map_or_else(Vec::new, |inner| (inner.rates)(laws, load));
    rates.get(which).copied().unwrap_or_else(|| laws.g.zero())
}

/// What a load exerts as one quantity: a resistance, a tension.
pub fn effort<'g>(laws: &Laws<'g>, load: &Load) -> Scalar<'g> {
    of(load.form).effort.map_or_else(|| laws.g.zero(), |effort| effort(laws, load))
}

pub fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    (of(load.form).terms)(laws, load)
}

/// Effort f along a coordinate: Q += Jᵀ f, power f·(rate).
pub fn along<'g>(coordinate: &Moving<'g>, effort: Scalar<'g>) -> LoadTerms<'g> {
    let columns = coordinate.jet.columns.iter();
    let forces = columns.map(|(index, column)| (*index, *column * effort)).collect();
    LoadTerms { forces, power: effort * coordinate.rate(), potential: effort.g.zero() }
}

/// Components of a force or torque along as many coordinates.
pub fn together<'g>(laws: &Laws<'g>, coordinates: &[Moving<'g>], efforts: &[Node]) -> LoadTerms<'g> {
    let efforts = coordinates.iter().zip(efforts);
    efforts.fold(LoadTerms::none(laws), |sum, (coordinate, effort)| {
        sum.and(along(coordinate, laws.g.on(*effort)))
    })
}

/// Effort −k x − c ẋ along a coordinate x, V = ½ k x².
pub fn restoring<'g>(coordinate: &Moving<'g>, x: Scalar<'g>, k: Scalar<'g>, c: Scalar<'g>) -> LoadTerms<'g> {
    let rate = coordinate.rate();
    let effort = -(k * x + c * rate);
    let terms = along(coordinate, effort);
    LoadTerms { potential: elastic_energy(k, x), ..terms }
}

/// The same along coordinates with a stiffness and damping each, at rest where all are zero.
pub fn restoring_each<'g>(
    laws: &Laws<'g>,
    coordinates: &[Moving<'g>],
    stiffness: &[Expr],
    damping: &[Expr],
) -> LoadTerms<'g> {
    let efforts = coordinates.iter().zip(stiffness.iter().zip(damping));
    efforts.fold(LoadTerms::none(laws), |sum, (x, (k, c))| {
        sum.and(restoring(x, x.value(), laws.value(k), laws.value(c)))
    })
}

/// ½ k x².
pub fn elastic_energy<'g>(k: Scalar<'g>, x: Scalar<'g>) -> Scalar<'g> {
    0.5 * (k * x.square())
}

/// The components of a law.
pub fn law(laws: &Laws, load: &Load) -> Vec<Node> {
    load.law.iter().map(|component| laws.value(component).bare).collect()
}

/// Of a load that needs no angle over several turns.
pub fn no_rotors(_: &Load) -> Vec<Rotor> {
    Vec::new()
}
