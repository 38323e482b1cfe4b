//! A mechanism as the runtime sees it: its sizes, its equations, its tables.
//!
//! The compiler emits one implementation of [`Mechanism`] and of [`Assemble`] per definition; everything else in this
//! crate is written against these two traits. They hold no algorithm: integration is `simulation.rs`, the sparse
//! factorisation `ldl.rs`, consistent states `assembly.rs`.
//!
//! # Sizes and tables
//! A mechanism tells them through `&self`. A compiled one returns constants, which the optimiser sees; one whose definition is read
//! while the program runs keeps them as fields and its vectors as lists. Names alone are `'static`, and so are the rows and
//! conditions that are made of them, because errors carry them: whoever reads definitions at run time makes each name once, for
//! as long as the program runs (`String::leak`), and keeps the lists of names itself. A list inside a list, of
//! [`Flips`] and [`MultiTurn`](crate::MultiTurn), it keeps in an arena or leaks as well.
//!
//! # Conventions
//! M v̇ + Dᵀ λ = Q, D v = ν, D v̇ = γ, where Φ(t, q) = 0 are the constraints and Φ̇ = D v − ν, so that D is the exact
//! derivative of Φ also off the constraints. The force of the constraints on the mechanism is −Dᵀ λ. SI units.

use crate::assembly::system::subtract_product;
use crate::real::Real;
use crate::state::{State, StateOf, Variables};
use crate::trigger::{Places, Trigger};
use crate::vector::{Vector, at, put};
use core::fmt::Debug;

/// A constraint row of D, by the names its author knows. It is copied into errors, and so its names live as long as the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The joint, constraint or driver that the row belongs to.
    pub of: &'static str,
    /// Which of its equations: `"x"`, `"y"`, `"z"`, `"angle"`, `"normal"`, `"normal_1"`, `"normal_2"`, `"axis_1"`,
    /// `"axis_2"`, `"cross"`, `"twist"`, `"screw"`, `"distance"`, `"equation"`, `"gear"`, `"rack"` or `"driver"`; of redundant joints of
    /// which different equations are taken at different positions `"switched_1"` and so on, and `"idle_1"` for those that are not.
    pub what: &'static str,
}

/// The hash FNV-1a of texts and of where they end (Fowler, Noll, Vo; draft-eastlake-fnv).
fn fingerprint<'t>(texts: impl Iterator<Item = &'t str>) -> u64 {
    let bytes = texts.flat_map(|text| text.bytes().chain([0]));
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// The row of this index, or what stands for all of them.
pub(crate) fn name_row<R: Real, M: Mechanism<R>>(model: &M, index: Option<usize>) -> Row {
    let row = index.and_then(|index| model.rows().get(index).copied());
    row.unwrap_or(Row { of: model.name(), what: "constraints" })
}

/// The equations of motion of one mechanism, evaluated in the scalars `R`.
///
/// Functions of the geometry take time, q and v; functions of loads or of the solution take the state as a whole.
/// Every function writes all entries of its result and never fails; where a pivot vanishes the returned relative pivot says
/// so. Those of a compiled mechanism allocate nothing. Shapes: n_q positions, n_v velocities, m constraint rows.
///
/// ```
/// use linkwright_runtime::{Mechanism, StateOf, Vector};
///
/// /// The row that a state violates most, with its residual, m or rad.
/// fn worst<M: Mechanism<f64>>(model: &M, time: f64, state: &StateOf<M>) -> Option<(String, f64)> {
///     let mut phi = model.zero_lambda();
///     model.constraints(time, &state.q, &mut phi);
///     let rows = model.rows().iter().zip(phi.as_slice());
///     rows.map(|(row, phi)| (format!("{}.{}", row.of, row.what), phi.abs())).max_by(|a, b| a.1.total_cmp(&b.1))
/// }
/// ```
pub trait Mechanism<R: Real>: Variables<R> {
    /// The mechanism's name.
    fn name(&self) -> &'static str;
    /// A number that tells definitions apart: saved states carry it. That of a compiled mechanism is of the whole definition; by
    /// itself it is of the names of coordinates and rows.
    fn fingerprint(&self) -> u64 {
        let names = [self.position_names(), self.velocity_names(), self.internal_names()];
        let rows = self.rows().iter().flat_map(|row| [row.of, row.what]);
        fingerprint(names.into_iter().flatten().copied().chain(rows).chain([self.name()]))
    }
    /// The names of the m constraint rows, in order.
    fn rows(&self) -> &[Row];
    /// One name for each entry of q.
    fn position_names(&self) -> &[&'static str];
    /// One name for each entry of v.
    fn velocity_names(&self) -> &[&'static str];
    /// One name for each internal state.
    #[inline]
    fn internal_names(&self) -> &[&'static str] {
        &[]
    }
    /// One name for each input, in the order of [`Fields`](crate::Fields). Errors list them.
    fn input_names(&self) -> &'static [&'static str];
    /// One name for each output, in the order of [`Fields`](crate::Fields). Errors list them.
    fn output_names(&self) -> &'static [&'static str];
    /// (row, column) of each stored entry of M: lower triangle with the diagonal, row ≥ column.
    fn mass_pattern(&self) -> &[(u16, u16)];
    /// (row, column) of each stored entry of D, in row-major order.
    fn jacobian_pattern(&self) -> &[(u16, u16)];

    /// The stored entries of M, in the order of [`mass_pattern`](Mechanism::mass_pattern).
    type Mass: Vector<R>;
    /// The stored entries of D, in the order of [`jacobian_pattern`](Mechanism::jacobian_pattern).
    type Jacobian: Vector<R>;
    /// The values given from outside; `()` for a mechanism without inputs.
    type Inputs: Clone;
    /// The named outputs.
    type Outputs: Clone;

    /// M(t, q), kg, kg·m and kg·m².
    fn mass_matrix(&self, time: R, q: &Self::Q, mass: &mut Self::Mass);
    /// Φ(t, q), the constraints' residuals.
    fn constraints(&self, time: R, q: &Self::Q, phi: &mut Self::Lambda);
    /// D(t, q), with Φ̇ = D v − ν.
    fn constraint_jacobian(&self, time: R, q: &Self::Q, d: &mut Self::Jacobian);
    /// ν(t, q) = −∂Φ/∂t, zero except where time appears in a constraint.
    fn nu(&self, time: R, q: &Self::Q, nu: &mut Self::Lambda);
    /// γ(t, q, v) of D v̇ = γ, that is ν̇ − Ḋ v.
    fn gamma(&self, time: R, q: &Self::Q, v: &Self::V, gamma: &mut Self::Lambda);
    /// Q(t, q, v, z, u) of M v̇ + Dᵀ λ = Q: applied, gravity and gyroscopic forces.
    fn forces(&self, time: R, state: &StateOf<Self, R>, u: &Self::Inputs, forces: &mut Self::V);
    /// Whether friction follows from reactions: the equations are then M v̇ + Dᵀ λ = Q + Q_f(v̇, λ), with Q_f by
    /// [`friction_forces`](Mechanism::friction_forces).
    #[inline(always)]
    fn rubs(&self) -> bool {
        false
    }
    /// Q_f(t, q, v, z, u, v̇, λ), friction by the reactions that v̇ and λ make, in N or N·m of each velocity. `a` and `lambda` need not solve
    /// anything.
    #[inline]
    #[allow(clippy::too_many_arguments)]
    fn friction_forces(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &Self::V,
        lambda: &Self::Lambda,
        forces: &mut Self::V,
    ) {
        let _ = (time, state, u, a, lambda);
        forces.as_mut_slice().fill(R::ZERO);
    }
    /// ½ vᵀ M v, J.
    fn kinetic_energy(&self, time: R, q: &Self::Q, v: &Self::V) -> R;
    /// The energy of gravity and springs, J.
    fn potential_energy(&self, time: R, state: &StateOf<Self, R>) -> R;
    /// v̇ and λ of M v̇ + Dᵀ λ = Q, D v̇ = γ; returns the smallest relative pivot of the factorisation.
    fn acceleration(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &mut Self::V,
        lambda: &mut Self::Lambda,
    ) -> R;
    /// As [`acceleration`](Mechanism::acceleration) with γ − 2α(D v − ν) − β² Φ in place of γ (Baumgarte 1972).
    #[allow(clippy::too_many_arguments)]
    fn acceleration_baumgarte(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        two_alpha: R,
        beta_squared: R,
        a: &mut Self::V,
        lambda: &mut Self::Lambda,
    ) -> R;
    /// Whether [`null_space`](Mechanism::null_space) and [`null_space_baumgarte`](Mechanism::null_space_baumgarte) are written out and
    /// are to be asked first: because they take fewer operations, or because of `options { solution = independent; }`.
    #[inline(always)]
    fn null_space_first(&self) -> bool {
        false
    }
    /// As [`acceleration`](Mechanism::acceleration), by way of independent velocities. Returns the smallest pivot of D for the dependent
    /// velocities chosen at expansion, squared, or of Rᵀ M R if that is smaller. Below 10⁻⁴ more than two digits are lost: the mechanism
    /// is near a dead centre of these velocities, which need not be singular. Zero where it is not written out, and then nothing is
    /// computed.
    fn null_space(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &mut Self::V,
        lambda: &mut Self::Lambda,
    ) -> R {
        let _ = (time, state, u, a, lambda);
        R::ZERO
    }
    /// As [`acceleration_baumgarte`](Mechanism::acceleration_baumgarte), by way of independent velocities.
    #[allow(clippy::too_many_arguments)]
    fn null_space_baumgarte(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        two_alpha: R,
        beta_squared: R,
        a: &mut Self::V,
        lambda: &mut Self::Lambda,
    ) -> R {
        let _ = (time, state, u, two_alpha, beta_squared, a, lambda);
        R::ZERO
    }
    /// ż(t, q, v, z, u, v̇, λ) of the internal states, in their units per s. `state` is as the formulation left it.
    #[allow(clippy::too_many_arguments)]
    fn internal_rates(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &Self::V,
        lambda: &Self::Lambda,
        rates: &mut Self::Z,
    );
    /// The contact of each gate that is held over a step, then events and memories; none of a mechanism that holds nothing.
    #[inline]
    fn gate_names(&self) -> &[&'static str] {
        &[]
    }
    /// The memories, which are the last of what is held.
    #[inline(always)]
    fn memory_names(&self) -> &[&'static str] {
        &[]
    }
    /// What lets each event occur: first those that pass a level, then those with a period.
    #[inline(always)]
    fn triggers(&self) -> &[Trigger] {
        &[]
    }
    /// All that is held after the events whose places in the state are 1: memories as these set them, at the places
    /// of events what their speeds jump to (m/s or rad/s), the rest as it is.
    #[inline(always)]
    fn assignments(&self, time: R, state: &StateOf<Self, R>, u: &Self::Inputs, after: &mut Self::Gates) {
        let _ = (time, state, u, after);
    }
    /// Of each gate that is held the gap (m or rad), and the force of its law without the gate (N or N·m).
    #[inline(always)]
    fn guards(&self, time: R, state: &StateOf<Self, R>, gaps: &mut Self::Gates, forces: &mut Self::Gates) {
        let _ = (time, state, gaps, forces);
    }
    /// Whether gates are forces, which the run finds: of rigid contacts, N or N·m, zero where they are open, or of dry friction in joints.
    /// The forces of [`guards`](Mechanism::guards) are none then.
    #[inline(always)]
    fn is_rigid(&self) -> bool {
        false
    }
    /// Whether the restitution of rigid contacts is of impulses (Poisson), and not of speeds (Newton).
    #[inline(always)]
    fn parts_by_impulses(&self) -> bool {
        false
    }
    /// Of each gate the one of the gap that presses, where it is the dry friction of a rigid contact; empty where nothing rubs so.
    #[inline(always)]
    fn pressed_by(&self) -> &[Option<usize>] {
        &[]
    }
    /// Of each dry friction the shares μ_s and μ_k of the force that presses, with which it holds and slides.
    #[inline(always)]
    fn grips(&self, holding: &mut Self::Gates, sliding: &mut Self::Gates) {
        let _ = (holding, sliding);
    }
    /// Whether the gates are the forces of dry friction in joints, N or N·m: all are, or none.
    #[inline(always)]
    fn sticks(&self) -> bool {
        false
    }
    /// Of each gate the first of those that slide as one with it, where the surfaces of a joint, or of a contact in space, slide along several
    /// directions: what resists them is then against the whole sliding, of which each gate has a component; empty where each slides by itself.
    #[inline(always)]
    fn slide_as_one(&self) -> &[usize] {
        &[]
    }
    /// Of the dry friction of each joint the most that it holds with, and what it slides with, N or N·m, of these v̇ and λ.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn bounds(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &Self::V,
        lambda: &Self::Lambda,
        holding: &mut Self::Gates,
        sliding: &mut Self::Gates,
    ) {
        let _ = (time, state, u, a, lambda, holding, sliding);
    }
    /// Of each rigid contact the rate ġ of its gap (m/s or rad/s), what of g̈ is there at v̇ = 0 (m/s² or rad/s²), and the share of
    /// the speed of approach with which it parts; of each dry friction the speed of its sliding (m/s), what of its derivative is there, and 0;
    /// of each event whose speed jumps that (m/s or rad/s), 0, and 1.
    #[inline(always)]
    fn strikes(
        &self,
        time: R,
        q: &Self::Q,
        v: &Self::V,
        rates: &mut Self::Gates,
        biases: &mut Self::Gates,
        restitutions: &mut Self::Gates,
    ) {
        let _ = (time, q, v, rates, biases, restitutions);
    }
    /// The gates as they are at a state, whatever its own are: 1 where the gap is below zero and the force of the law above, else 0; 0, which
    /// is open, of rigid contacts. Likewise the sides on which events stand that pass a level; ticks and memories
    /// are those of the state. What a state that was put together by hand needs, and one at which derivatives are asked for.
    ///
    /// ```text
    /// state.gates = model.live_gates(time, &state);
    /// ```
    #[inline]
    fn live_gates(&self, time: R, state: &StateOf<Self, R>) -> Self::Gates {
        let zeros = || Self::Gates::zeros(self.gate_names().len());
        let places = Places::of(self);
        if self.is_rigid() && places.contacts == self.gate_names().len() {
            return zeros();
        }
        let (mut gates, mut forces) = (zeros(), zeros());
        self.guards(time, state, &mut gates, &mut forces);
        for (gate, &force) in gates.as_mut_slice().iter_mut().zip(forces.as_slice()) {
            let closed = gate.less(R::ZERO) & force.greater(R::ZERO);
            *gate = R::select(closed, R::ONE, R::ZERO);
        }
        for place in 0..if self.is_rigid() { places.contacts } else { 0 } {
            put(gates.as_mut_slice(), place, R::ZERO);
        }
        for place in places.passing..self.gate_names().len() {
            put(gates.as_mut_slice(), place, at(state.gates.as_slice(), place));
        }
        gates
    }
    /// The named outputs; angles among them in (−π, π].
    fn outputs(&self, time: R, state: &StateOf<Self, R>, u: &Self::Inputs) -> Self::Outputs;
    /// Adds whole turns to the angles among the outputs so that they continue `previous`; see
    /// [`unwrap_angle`](crate::rotation::unwrap_angle).
    fn unwrap(&self, outputs: &mut Self::Outputs, previous: &Self::Outputs);
    /// Adds whole turns to the angles among the outputs so that they come nearest to what `start` states of them, for
    /// the first sample of a simulation.
    fn unwrap_start(&self, outputs: &mut Self::Outputs) {
        let _ = outputs;
    }

    /// n_v.
    #[inline]
    fn velocity_count(&self) -> usize {
        self.layout().velocities()
    }
    /// n_z, the number of internal states.
    #[inline]
    fn internal_count(&self) -> usize {
        self.internal_names().len()
    }
    /// m.
    #[inline]
    fn row_count(&self) -> usize {
        self.rows().len()
    }
    /// Zeros for velocities, accelerations or forces, to be written.
    #[inline]
    fn zero_v(&self) -> Self::V {
        Vector::zeros(self.velocity_count())
    }
    /// Zeros for multipliers or residuals of the rows.
    #[inline]
    fn zero_lambda(&self) -> Self::Lambda {
        Vector::zeros(self.row_count())
    }
    /// Zeros for the internal states or their rates.
    #[inline]
    fn zero_z(&self) -> Self::Z {
        Vector::zeros(self.internal_count())
    }
    /// Zeros for the entries of M.
    #[inline]
    fn zero_mass(&self) -> Self::Mass {
        Vector::zeros(self.mass_pattern().len())
    }
    /// Zeros for the entries of D.
    #[inline]
    fn zero_jacobian(&self) -> Self::Jacobian {
        Vector::zeros(self.jacobian_pattern().len())
    }
}

/// A quantity of the mechanism that assembly can hold at a value, as a row beside the constraints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Condition {
    /// The quantity's name, such as `"crank_pin.angle"`.
    pub of: &'static str,
    /// Whether it turns or slides.
    pub kind: ConditionKind,
}

/// Whether a condition's values are equal up to whole turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConditionKind {
    /// An angle on the circle, rad.
    Angle,
    /// A travel or a position, m, or an angle whose turns are counted, rad.
    Linear,
    /// A rate without a coordinate, ω of a body in space, rad/s: a velocity can have it, a position cannot.
    Rate,
}

/// The equations and tables that assembly needs beyond those of motion: conditions, values that `start` states, the order of elimination.
///
/// All functions write all entries of their results. Conditions are `coordinate(t, q) = target`. What is made of them is in
/// [`AssembleExt`](crate::AssembleExt) and in [`assembly`](crate::assembly); what the documentation does not show are the tables and
/// factorisations that these and the formulations work with.
///
/// ```
/// use linkwright_runtime::{Assemble, AssembleExt, AssemblyError, Motion};
///
/// /// The angle (or travel) of the first independent coordinate, and the velocities at which it moves by 1 rad/s (or m/s).
/// fn led<M: Assemble<f64>>(model: &M, position: f64) -> Result<(&'static str, M::V), AssemblyError> {
///     let coordinate = model.conditions()[usize::from(model.independent()[0])];
///     let given = [Motion { position, rate: 1.0, acceleration: 0.0 }];
///     let found = model.kinematics(0.0, &model.start().q, &given)?;
///     Ok((coordinate.of, found.v))
/// }
/// ```
pub trait Assemble<R: Real>: Mechanism<R> {
    /// The quantities that can be held.
    fn conditions(&self) -> &[Condition];
    /// Indices into [`conditions`](Assemble::conditions): positions that `start` states exactly.
    fn start_conditions(&self) -> &[u16];
    /// Indices into [`conditions`](Assemble::conditions): quantities whose rate `start` states exactly.
    fn start_rates(&self) -> &[u16];
    /// Indices into [`conditions`](Assemble::conditions): the independent coordinates, one per degree of freedom.
    fn independent(&self) -> &[u16];
    /// (row, column) of each stored entry of the conditions' Jacobian, in row-major order.
    #[doc(hidden)]
    fn condition_pattern(&self) -> &[(u16, u16)];
    /// Constraint rows of the form sin Δθ = 0, which must not end on the flipped root Δθ = π, joint by joint.
    #[doc(hidden)]
    fn flips(&self) -> &[Flips<'_>];
    /// Rows, ascending, that repeat what others fix and are kept: they vanish with the others, have the multiplier zero, and
    /// take no part in factorisations.
    #[doc(hidden)]
    #[inline]
    fn idle(&self) -> &[u16] {
        &[]
    }
    /// (row, dependent velocity) of each row that is not [`idle`](Assemble::idle), in the order in which D is factored: chosen at
    /// the start position. The velocity is `u16::MAX` where none is chosen.
    #[doc(hidden)]
    #[inline]
    fn dependent(&self) -> &[(u16, u16)] {
        &[]
    }
    /// The factors of the columns of D by which entries are compared, because columns have different units; empty if all
    /// of them are one.
    #[doc(hidden)]
    #[inline]
    fn scales(&self) -> &[f64] {
        &[]
    }
    /// The largest entry of each row of D along the motion, after multiplication by [`scales`](Assemble::scales): what pivots of D are
    /// measured by.
    #[doc(hidden)]
    fn row_sizes(&self) -> Self::Lambda;
    /// Rows, ascending, that hold velocities without mass of their own.
    #[doc(hidden)]
    #[inline]
    fn massless_rows(&self) -> &[u16] {
        &[]
    }
    /// ρ of each of these rows, with which its dᵀ d is added to M, kg.
    #[doc(hidden)]
    #[inline]
    fn massless_weights(&self) -> &[f64] {
        &[]
    }
    /// The order of elimination and the pattern of the factor.
    #[doc(hidden)]
    fn elimination(&self) -> Elimination<'_>;

    /// One entry for each condition.
    type Conditions: Vector<R>;
    /// The stored entries of the conditions' Jacobian.
    type ConditionJacobian: Vector<R>;
    /// The stored entries of L: as many as `elimination().columns`.
    #[doc(hidden)]
    type Factor: Vector<R>;
    /// One entry for each unknown: velocities, constraint rows, conditions.
    #[doc(hidden)]
    type System: Vector<R>;
    /// D as a full matrix, m n_v entries.
    #[doc(hidden)]
    type Dense: Vector<R>;
    /// A basis of the null space of D, n_v entries for each degree of freedom.
    #[doc(hidden)]
    type Basis: Vector<R>;
    /// A square matrix of the size of the degrees of freedom.
    #[doc(hidden)]
    type Reduced: Vector<R>;
    /// A whole number for each velocity.
    #[doc(hidden)]
    type Choice: Clone + Debug + AsRef<[u16]> + AsMut<[u16]>;
    /// The values that [`factor`](Assemble::factor) keeps of a factorisation.
    #[doc(hidden)]
    type Store: Clone + Debug;
    /// The values that [`factor_jacobian`](Assemble::factor_jacobian) keeps of one; `()` where it is not written out.
    #[doc(hidden)]
    type Lu: Clone + Debug;

    /// Zeros.
    #[doc(hidden)]
    fn choice(&self) -> Self::Choice;
    /// An empty store.
    #[doc(hidden)]
    fn store(&self) -> Self::Store;
    /// An empty D = L U.
    #[doc(hidden)]
    fn lu(&self) -> Self::Lu;
    /// Factors D at a position for the velocities of [`dependent`](Assemble::dependent); returns the square of the smallest pivot,
    /// relative to the size of its rows ([`row_sizes`](Assemble::row_sizes)), to a power of two. Zero where it is not written out
    /// (`options { emit = (null_space) }`): the runtime then factors by tables, as it does where a pivot is too small.
    #[doc(hidden)]
    fn factor_jacobian(&self, time: R, q: &Self::Q, lu: &mut Self::Lu) -> R {
        let _ = (time, q, lu);
        R::ZERO
    }
    /// The velocities with D v = `rows` whose independent entries are those of `v`, with the factors in `lu`; never called
    /// where [`factor_jacobian`](Assemble::factor_jacobian) returned zero.
    #[doc(hidden)]
    fn dependent_velocities(&self, lu: &Self::Lu, rows: &Self::Lambda, v: &Self::V, out: &mut Self::V) {
        let _ = (lu, rows);
        out.clone_from(v);
    }
    /// Sᵢ of each row, twice the largest Dᵢ M⁻¹ Dᵢᵀ along the motion (1/kg of a row in m, 1/(kg m²) of one in rad): what pivots of D M⁻¹ Dᵀ
    /// are measured by, the same at all positions, so that a row that vanishes as a whole is seen to vanish.
    #[doc(hidden)]
    fn row_scales(&self, scales: &mut Self::Lambda);
    /// Factors K(c) = \[M, Dᵀ; D, −c\] at a position, c ≥ 0 the compliance of the constraints (1/kg); returns the smallest
    /// relative pivot: of the rows (d + c)/Sᵢ, d the pivot of D M⁻¹ Dᵀ and Sᵢ that of [`row_scales`](Assemble::row_scales). With c = 0
    /// it is a pivot of D M⁻¹ Dᵀ with its rows brought to length one, never below its least eigenvalue.
    #[doc(hidden)]
    fn factor(&self, time: R, q: &Self::Q, compliance: R, store: &mut Self::Store) -> R;
    /// Factors K(c) and evaluates its right-hand sides Q and γ − 2α(D v − ν) − β² Φ; returns the smallest relative pivot of
    /// the velocities where M alone is singular, else one.
    #[doc(hidden)]
    #[allow(clippy::too_many_arguments)]
    fn system(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        two_alpha: R,
        beta_squared: R,
        compliance: R,
        store: &mut Self::Store,
        forces: &mut Self::V,
        rows: &mut Self::Lambda,
    ) -> R {
        let State { q, v, .. } = state;
        let pivot = self.factor(time, q, compliance, store);
        self.forces(time, state, u, forces);
        self.gamma(time, q, v, rows);
        let (mut phi, mut rest) = (self.zero_lambda(), self.zero_lambda());
        self.constraints(time, q, &mut phi);
        self.nu(time, q, &mut rest);
        let mut jacobian = self.zero_jacobian();
        self.constraint_jacobian(time, q, &mut jacobian);
        subtract_product(self.jacobian_pattern(), jacobian.as_slice(), v.as_slice(), rest.as_mut_slice());
        rows.axpy(two_alpha, &rest);
        rows.axpy(-beta_squared, &phi);
        // Softened rows have no pivot that could vanish.
        if self.massless_rows().is_empty() { R::ONE } else { pivot }
    }
    /// a and λ of M a + Dᵀ λ = `forces`, D a − c λ = `rows`, with the factor in `store`.
    #[doc(hidden)]
    fn solve(
        &self,
        store: &Self::Store,
        forces: &Self::V,
        rows: &Self::Lambda,
        a: &mut Self::V,
        lambda: &mut Self::Lambda,
    );

    /// Angle: sin(θ − target); linear, which includes angles whose turns are counted: value − target.
    fn condition_residual(
        &self,
        time: R,
        q: &Self::Q,
        target: &Self::Conditions,
        residual: &mut Self::Conditions,
    );
    /// Angle: cos(θ − target); linear: 1.
    fn condition_cosines(
        &self,
        time: R,
        q: &Self::Q,
        target: &Self::Conditions,
        cosines: &mut Self::Conditions,
    );
    /// ∂(coordinate's rate)/∂v, not multiplied by any cosine.
    fn condition_jacobian(&self, time: R, q: &Self::Q, jacobian: &mut Self::ConditionJacobian);
    /// The coordinate's second time derivative at v̇ = 0.
    fn condition_bias(&self, time: R, q: &Self::Q, v: &Self::V, bias: &mut Self::Conditions);
    /// The coordinate's rate at v = 0, from places that depend on time.
    fn condition_drift(&self, time: R, q: &Self::Q, drift: &mut Self::Conditions);
    /// cos Δθ for the rows of [`flips`](Assemble::flips), 1 for the others.
    #[doc(hidden)]
    fn row_cosines(&self, time: R, q: &Self::Q, cosines: &mut Self::Lambda);
    /// The values that `start` states, with this model's parameters; entries of conditions it does not state are ignored.
    fn start_targets(&self, positions: &mut Self::Conditions, rates: &mut Self::Conditions);
    /// The positions assembled at expansion, for the default parameters.
    fn start_q(&self) -> Self::Q;
    /// The velocities assembled at expansion, for the default parameters.
    fn start_v(&self) -> Self::V;
    /// The internal states at the start, with this model's parameters.
    fn start_internal(&self) -> Self::Z;
    /// The gates of contacts at the start, for the default parameters.
    fn start_gates(&self) -> Self::Gates;
    /// Takes the phases of couplings that state none (gears, racks) from an assembled position.
    fn fix_phases(&mut self, q: &Self::Q) {
        let _ = q;
    }

    /// Zeros for the conditions.
    #[inline]
    fn zero_conditions(&self) -> Self::Conditions {
        Vector::zeros(self.conditions().len())
    }
    /// Zeros for the entries of the conditions' Jacobian.
    #[inline]
    fn zero_condition_jacobian(&self) -> Self::ConditionJacobian {
        Vector::zeros(self.condition_pattern().len())
    }
    /// Zeros for the unknowns of K.
    #[doc(hidden)]
    #[inline]
    fn zero_system(&self) -> Self::System {
        Vector::zeros(self.elimination().order.len())
    }
    /// Zeros for D as a full matrix.
    #[doc(hidden)]
    #[inline]
    fn zero_dense(&self) -> Self::Dense {
        Vector::zeros(self.row_count() * self.velocity_count())
    }
    /// The degrees of freedom, as rows leave them.
    #[doc(hidden)]
    #[inline]
    fn freedoms(&self) -> usize {
        (self.velocity_count() + self.idle().len()).saturating_sub(self.row_count())
    }
    /// Zeros for a basis of the null space of D.
    #[doc(hidden)]
    #[inline]
    fn zero_basis(&self) -> Self::Basis {
        Vector::zeros(self.freedoms() * self.velocity_count())
    }
    /// Zeros for a square matrix of the size of the degrees of freedom.
    #[doc(hidden)]
    #[inline]
    fn zero_reduced(&self) -> Self::Reduced {
        Vector::zeros(self.freedoms() * self.freedoms())
    }
}

/// The constraint rows of one joint of the form sin Δθ = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Flips<'a> {
    /// The two that make axes parallel, with one cosine.
    pub axes: Option<[u16; 2]>,
    /// Those of turns: about these axes where there are some, else each by itself.
    pub turns: &'a [u16],
}

impl Flips<'_> {
    /// All of them.
    pub fn rows(&self) -> impl Iterator<Item = u16> {
        self.axes.into_iter().flatten().chain(self.turns.iter().copied())
    }
}

/// The order in which the unknowns of K = \[W, D̂ᵀ; D̂, 0\] are eliminated, and the pattern of its factor L.
///
/// D̂ has the constraint rows, then the condition rows. Unknowns are numbered: velocities, constraint rows,
/// conditions. A row is eliminated only after all velocities in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Elimination<'a> {
    /// `order[k]` is the unknown eliminated k-th.
    pub order: &'a [u16],
    /// The inverse: `position[unknown]` is the place of an unknown in `order`.
    pub position: &'a [u16],
    /// Row k of L (in order of elimination) has the columns `columns[row_start[k]..row_start[k + 1]]`.
    pub row_start: &'a [u32],
    /// Columns of L's rows below the diagonal, ascending, in order of elimination, fill included.
    pub columns: &'a [u16],
}
