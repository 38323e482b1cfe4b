//! K = \[W, D̂ᵀ; D̂, 0\] filled for one position, and its use: least corrections that satisfy all rows.
//!
//! D̂ has the constraint rows and the active ones among the conditions. The right-hand side is that of `position.rs`
//! or `rates.rs`.

use crate::error::AssemblyError;
use crate::ldl::{Ldl, Pivot};
use crate::mechanism::{Assemble, Row};
use crate::real::Real;
use crate::vector::{Vector, at, put};

/// The amount added to a singular mass matrix, relative to its largest diagonal entry. Small enough to leave the motion
/// of the bodies that have mass alone, large enough to keep half of the digits; a correction with the exact D̂
/// restores the other half.
const REGULARISATION: f64 = 1e-9;

/// The rows of D̂ at one position, the matrix and its factor.
pub(crate) struct System<'m, R: Real, M: Assemble<R>> {
    pub(crate) model: &'m M,
    matrix: Ldl<R, M::Factor, M::System>,
    jacobian: M::Jacobian,
    conditions: M::ConditionJacobian,
    /// 1 for the constraint rows that are let go, 0 for the others.
    free: M::Lambda,
    /// 1 for the conditions that are held, 0 for the others.
    pub(crate) active: M::Conditions,
}

impl<'m, R: Real, M: Assemble<R>> System<'m, R, M> {
    /// An empty system with the conditions `active` held.
    pub(crate) fn new(model: &'m M, active: &[u16]) -> Result<Self, AssemblyError> {
        let mut mask = model.zero_conditions();
        for &index in active {
            let index = index as usize;
            match mask.as_mut_slice().get_mut(index) {
                Some(entry) => *entry = R::ONE,
                None => {
                    return Err(AssemblyError::NoSuchCondition { index, count: model.conditions().len() });
                }
            }
        }
        Ok(System {
            model,
            matrix: Ldl::new(&model.elimination()),
            jacobian: model.zero_jacobian(),
            conditions: model.zero_condition_jacobian(),
            free: model.zero_lambda(),
            active: mask,
        })
    }

    /// Evaluates D̂ at (t, q), each constraint row divided by its entry of `divisors`, or left out where that is zero.
    pub(crate) fn evaluate(&mut self, time: R, q: &M::Q, divisors: Option<&M::Lambda>) {
        let model = self.model;
        model.constraint_jacobian(time, q, &mut self.jacobian);
        model.condition_jacobian(time, q, &mut self.conditions);
        self.free.as_mut_slice().fill(R::ZERO);
        if let Some(divisors) = divisors {
            for (entry, &(row, _)) in self.jacobian.as_mut_slice().iter_mut().zip(model.jacobian_pattern()) {
                let divisor = at(divisors.as_slice(), row as usize);
                *entry = if divisor == R::ZERO { R::ZERO } else { *entry / divisor };
            }
            for (free, &divisor) in self.free.as_mut_slice().iter_mut().zip(divisors.as_slice()) {
                *free = if divisor == R::ZERO { R::ONE } else { R::ZERO };
            }
        }
        for (entry, &(row, _)) in self.jacobian.as_mut_slice().iter_mut().zip(model.jacobian_pattern()) {
            if model.idle().contains(&row) {
                *entry = R::ZERO;
            }
        }
        for (entry, &(row, _)) in self.conditions.as_mut_slice().iter_mut().zip(model.condition_pattern()) {
            *entry = *entry * at(self.active.as_slice(), row as usize);
        }
    }

    /// Factors with W = 1; the pivots are then those of −D̂ D̂ᵀ.
    pub(crate) fn factor_unit(&mut self) -> Pivot<R> {
        let (model, tables) = (self.model, self.model.elimination());
        self.matrix.clear();
        for i in 0..model.velocity_count() {
            self.matrix.add(&tables, i, i, R::ONE);
        }
        self.add_rows();
        self.vanished_row().unwrap_or_else(|| self.matrix.factor(&tables))
    }

    /// Shows row, or after the rows condition, column and value of each entry of D̂ that takes part.
    pub(super) fn each_entry(&self, mut show: impl FnMut(usize, usize, R)) {
        let model = self.model;
        for (&entry, &(row, column)) in self.jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
            show(row as usize, column as usize, entry);
        }
        for (&entry, &(row, column)) in self.conditions.as_slice().iter().zip(model.condition_pattern()) {
            show(model.row_count() + row as usize, column as usize, entry);
        }
    }

    /// Factors with W = diag(`weights`) to the end; the pivots, by unknown, are written into `pivots`.
    pub(super) fn factor_weighted(&mut self, weights: &M::V, pivots: &mut M::System) {
        let (model, tables) = (self.model, self.model.elimination());
        self.matrix.clear();
        for (i, &weight) in weights.as_slice().iter().enumerate() {
            self.matrix.add(&tables, i, i, weight);
        }
        self.add_rows();
        let mut magnitudes = model.zero_system();
        self.matrix.factor_measured(&tables, model.velocity_count(), &mut magnitudes);
        let pivots = pivots.as_mut_slice();
        for (&pivot, &unknown) in self.matrix.pivots().iter().zip(model.elimination().order) {
            if let Some(to) = pivots.get_mut(unknown as usize) {
                *to = pivot;
            }
        }
    }

    /// A row that has vanished as a whole: all links lie in one line along an axis, or nothing can change a distance.
    /// Relative to its own terms, which are rounding, its pivot would look sound.
    fn vanished_row(&self) -> Option<Pivot<R>> {
        let model = self.model;
        let mut largest = model.zero_lambda();
        for (entry, &(row, column)) in self.jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
            let scale = model.scales().get(column as usize).map_or(R::ONE, |&scale| R::from_f64(scale));
            if let Some(most) = largest.as_mut_slice().get_mut(row as usize) {
                *most = most.max(entry.abs() * scale);
            }
        }
        let rounding = R::from_f64(64.0) * R::EPSILON;
        let held = |row: usize| !model.idle().contains(&(row as u16)) && self.is_held(row);
        let sizes = model.row_sizes();
        let rows = largest.as_slice().iter().zip(sizes.as_slice()).enumerate().filter(|(row, _)| held(*row));
        for (row, (&most, &size)) in rows {
            let share = most / size;
            if share < rounding {
                return Some(Pivot { value: share * share, unknown: model.velocity_count() + row });
            }
        }
        None
    }

    /// Whether a constraint row has not been let go.
    fn is_held(&self, row: usize) -> bool {
        self.free.as_slice().get(row).is_none_or(|&free| free == R::ZERO)
    }

    /// Factors with W = M + `shift`·max(M_ii)·1.
    pub(crate) fn factor_mass(&mut self, time: R, q: &M::Q, shift: R) -> Pivot<R> {
        let (model, tables) = (self.model, self.model.elimination());
        let mut mass = model.zero_mass();
        model.mass_matrix(time, q, &mut mass);
        self.matrix.clear();
        let mut largest = R::ZERO;
        for (&entry, &(i, j)) in mass.as_slice().iter().zip(model.mass_pattern()) {
            self.matrix.add(&tables, i as usize, j as usize, entry);
            if i == j {
                largest = largest.max(entry.abs());
            }
        }
        let largest = if largest > R::ZERO { largest } else { R::ONE };
        for i in 0..model.velocity_count() {
            self.matrix.add(&tables, i, i, shift * largest);
        }
        self.add_rows();
        self.vanished_row().unwrap_or_else(|| self.matrix.factor(&tables))
    }

    /// Factors with W = M, or with a little more on the diagonal where massless bodies leave M singular.
    pub(crate) fn factor_mass_or_shifted(&mut self, time: R, q: &M::Q) -> Result<(), AssemblyError> {
        let model = self.model;
        if self.factor_mass(time, q, R::ZERO).value >= R::BREAKDOWN {
            return Ok(());
        }
        let shift = R::from_f64(REGULARISATION).max(R::BREAKDOWN);
        let pivot = self.factor_mass(time, q, shift);
        if pivot.value >= R::BREAKDOWN { Ok(()) } else { Err(rank_deficient(model, pivot)) }
    }

    /// Adds D̂ and, for each row let go or idle and each condition that is not held, −1 on the diagonal, which keeps its
    /// pivot harmless.
    fn add_rows(&mut self) {
        let (model, tables) = (self.model, self.model.elimination());
        let first_row = model.velocity_count();
        for (&entry, &(row, column)) in self.jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
            self.matrix.add(&tables, first_row + row as usize, column as usize, entry);
        }
        for (i, &free) in self.free.as_slice().iter().enumerate() {
            self.matrix.add(&tables, first_row + i, first_row + i, -free);
        }
        for &row in model.idle() {
            let unknown = first_row + row as usize;
            self.matrix.add(&tables, unknown, unknown, -R::ONE);
        }
        let first_condition = first_row + model.row_count();
        for (&entry, &(row, column)) in self.conditions.as_slice().iter().zip(model.condition_pattern()) {
            self.matrix.add(&tables, first_condition + row as usize, column as usize, entry);
        }
        for (i, &active) in self.active.as_slice().iter().enumerate() {
            self.matrix.add(&tables, first_condition + i, first_condition + i, active - R::ONE);
        }
    }

    /// The δ of least ½ δᵀ W δ − `force`·δ with D̂ δ = (`rows`, `conditions`); conditions that are not held are left out.
    pub(crate) fn least(&self, force: &M::V, rows: &M::Lambda, conditions: &M::Conditions) -> M::V {
        let model = self.model;
        let mut right = model.zero_system();
        let held = conditions.as_slice().iter().zip(self.active.as_slice());
        let given = force.as_slice().iter().chain(rows.as_slice()).copied();
        let given = given.chain(held.map(|(&value, &active)| value * active));
        for (to, value) in right.as_mut_slice().iter_mut().zip(given) {
            *to = value;
        }
        let solution = self.matrix.solve(&self.model.elimination(), &right);
        let mut delta = model.zero_v();
        for (to, &value) in delta.as_mut_slice().iter_mut().zip(solution.as_slice()) {
            *to = value;
        }
        delta
    }

    /// (`rows`, `conditions`) − D̂ x.
    pub(crate) fn remaining(
        &self,
        rows: &M::Lambda,
        conditions: &M::Conditions,
        x: &M::V,
    ) -> (M::Lambda, M::Conditions) {
        let model = self.model;
        let (mut rows, mut conditions) = (rows.clone(), conditions.clone());
        subtract_product(
            model.jacobian_pattern(),
            self.jacobian.as_slice(),
            x.as_slice(),
            rows.as_mut_slice(),
        );
        subtract_product(
            model.condition_pattern(),
            self.conditions.as_slice(),
            x.as_slice(),
            conditions.as_mut_slice(),
        );
        (rows, conditions)
    }
}

/// `y ← y − A x` for a sparse A.
pub(crate) fn subtract_product<R: Real>(pattern: &[(u16, u16)], entries: &[R], x: &[R], y: &mut [R]) {
    for (&entry, &(row, column)) in entries.iter().zip(pattern) {
        let rest = at(y, row as usize) - entry * at(x, column as usize);
        put(y, row as usize, rest);
    }
}

/// M x.
pub(crate) fn mass_times<R: Real, M: Assemble<R>>(model: &M, mass: &M::Mass, x: &M::V) -> M::V {
    let mut product = model.zero_v();
    let (p, x) = (product.as_mut_slice(), x.as_slice());
    for (&entry, &(i, j)) in mass.as_slice().iter().zip(model.mass_pattern()) {
        let (i, j) = (i as usize, j as usize);
        put(p, i, entry.mul_add(at(x, j), at(p, i)));
        if i != j {
            put(p, j, entry.mul_add(at(x, i), at(p, j)));
        }
    }
    product
}

/// The name of an unknown of K: a velocity, a constraint row, or a condition (`what` is then `"held"`).
pub(crate) fn name_unknown<R: Real, M: Assemble<R>>(model: &M, unknown: usize) -> Row {
    if let Some(&of) = model.velocity_names().get(unknown) {
        return Row { of, what: "velocity" };
    }
    let row = unknown - model.velocity_count();
    if let Some(&row) = model.rows().get(row) {
        return row;
    }
    match model.conditions().get(row - model.row_count()) {
        Some(condition) => Row { of: condition.of, what: "held" },
        None => Row { of: model.name(), what: "unknown" },
    }
}

/// The error for a pivot below the breakdown.
pub(crate) fn rank_deficient<R: Real, M: Assemble<R>>(model: &M, pivot: Pivot<R>) -> AssemblyError {
    AssemblyError::RankDeficient { row: name_unknown(model, pivot.unknown), pivot: pivot.value.to_f64() }
}
