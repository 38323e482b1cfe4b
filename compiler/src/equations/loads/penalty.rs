//! A joint that yields: forces in place of its rows, along the same coordinates.
//!
//! With Φ the residuals of the rows, places that coincide being measured along the axes of what the first belongs to (`Ends` of both
//! folders of joints): V = Σ ½ k Φ², and by virtual work Q −= J_Φᵀ (k Φ + c Φ̇), k and c in N/m and N s/m where Φ is a way, in N m and N m s where it is
//! a direction (the sine of a small angle). Seen from the first body, Φ knows no motion that both have, so that momentum and angular
//! momentum balance. With `damping_along = line`, δ the way between places that coincide: c (δ·δ̇)/max(δ·δ, ε²) δ in place of c δ̇, equations
//! (28)–(32) of the tracked-vehicle model validated on an N-post motion simulator, which have no value at δ = 0 and hence no ε.

use super::{LoadKind, LoadTerms, along, elastic_energy, no_rotors};
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::equations::rows::{self, JointRow};
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Measures, Need, Value};
use crate::model::{Expr, JointId, Load};
use crate::symbolic::Scalar;
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "penalty",
            elsewhere: &[],
            positional: &[],
            named: &[
                Argument::scalar("stiffness", Need::Never, Dimension::STIFFNESS).positive(),
                Argument::scalar("damping", Need::Never, Dimension::DAMPING).not_negative(),
                Argument::scalar("torsional_stiffness", Need::Never, Dimension::TORQUE).positive(),
                Argument::scalar("torsional_damping", Need::Never, Dimension::ANGULAR_DAMPING).not_negative(),
                Argument::of("damping_along", Need::Never, Value::Word),
                Argument::scalar("smallest", Need::Never, Dimension::LENGTH).positive(),
            ],
        },
        instead: None,
        meant: None,
        title: "penalty",
        exerts: "forces and torques against what a joint holds, in place of its rows",
        exported: "penalty",
        on: &[Acts::Joint],
        law: Law::None,
        stores: true,
        turns: false,
        owns: None,
        rubs: false,
        holds: false,
        effort: None,
        doubt: None,
    },
    terms,
    inner: None,
    effort: None,
    counted: no_rotors,
    symbol: |_| {},
};

/// A row that yields: Φ, and what stands for its multiplier.
pub struct Yielding<'g> {
    pub row: JointRow,
    /// k.
    pub stiffness: Scalar<'g>,
    /// c, of all that damps where δ is zero.
    pub damping: Scalar<'g>,
    pub multiplier: Scalar<'g>,
}

/// k Φ + c Φ̇ of each row that a joint would have.
pub fn yielding<'g>(laws: &Laws<'g>, id: JointId) -> Vec<Yielding<'g>> {
    let joint = &laws.mechanism.joints[id.0];
    let Some(load) = joint.penalty.and_then(|load| laws.mechanism.loads.get(load.0)) else {
        return Vec::new();
    };
    let rows = rows::that_yield(laws, id);
    let coordinates: Vec<Moving> = rows.iter().map(|row| laws.moving_by(row.jet.clone())).collect();
    let turns = |row: &JointRow| row.form.measures == Measures::Direction;
    let shifts = || rows.iter().zip(&coordinates).filter(|(row, _)| !turns(row)).map(|(_, x)| x);
    let line = along_line(load).map(|smallest| {
        let square = laws.g.sum(shifts().map(|x| x.value().square()));
        let rate = laws.g.sum(shifts().map(|x| x.value() * x.rate()));
        rate / square.max(laws.value(smallest).square())
    });
    let of = |name: &str| laws.value(load.named(name));
    let yielding = rows.iter().zip(&coordinates).map(|(row, x)| {
        let (stiffness, damping, lost) = match (turns(row), line) {
            (true, _) => (of("torsional_stiffness"), of("torsional_damping"), None),
            (false, None) => (of("stiffness"), of("damping"), None),
            (false, Some(line)) => (of("stiffness"), laws.g.zero(), Some(of("damping") * (line * x.value()))),
        };
        let multiplier = stiffness * x.value() + lost.unwrap_or_else(|| damping * x.rate());
        Yielding { row: row.clone(), stiffness, damping, multiplier }
    });
    yielding.collect()
}

/// The rows of all joints that yield.
pub fn penalties<'g>(laws: &Laws<'g>) -> Vec<Yielding<'g>> {
    (0..laws.mechanism.joints.len()).flat_map(|joint| yielding(laws, JointId(joint))).collect()
}

/// ε, where damping acts along the line between the places.
fn along_line(load: &Load) -> Option<&Expr> {
    let smallest = load.named("smallest");
    (!matches!(smallest, Expr::Number(0.0))).then_some(smallest)
}

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let Some(joint) = load.in_place_of() else { return LoadTerms::none(laws) };
    yielding(laws, joint).into_iter().fold(LoadTerms::none(laws), |sum, it| {
        let x = laws.moving_by(it.row.jet);
        let terms = along(&x, -it.multiplier);
        sum.and(LoadTerms { potential: elastic_energy(it.stiffness, x.value()), ..terms })
    })
}
