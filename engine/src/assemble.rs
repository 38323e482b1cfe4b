//! The engine as the runtime's `Assemble`.

use crate::{Engine, List, Numbers};
use linkwright_compiler::functions::Argument::{
    BetaSquared, Compliance, GivenForces, GivenRows, Lu, Q, Store as Kept, Target, Time, TwoAlpha, V,
};
use linkwright_compiler::functions::Function;
use linkwright_runtime::{
    Assemble, AssembleExt, AssemblyError, Condition, Elimination, Flips, Mechanism, State, StateOf, Vector,
    assemble_position, assemble_velocity, tabled,
};
use std::fmt;
use std::slice::from_ref;

/// What is kept of a factorisation of K(c): by the mechanism's own function where it has one, else by tables.
pub enum Store<D: 'static> {
    /// By its own.
    Own(List),
    /// By tables.
    Tabled(Box<tabled::Store<f64, Engine<D>>>),
}

impl<D> Clone for Store<D> {
    fn clone(&self) -> Self {
        match self {
            Store::Own(kept) => Store::Own(kept.clone()),
            Store::Tabled(store) => Store::Tabled(store.clone()),
        }
    }
}

impl<D> fmt::Debug for Store<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Store::Own(kept) => kept.fmt(f),
            Store::Tabled(store) => store.fmt(f),
        }
    }
}

impl<D: 'static> Assemble<f64> for Engine<D> {
    fn conditions(&self) -> &[Condition] {
        &self.shared.tables.conditions
    }
    fn start_conditions(&self) -> &[u16] {
        &self.shared.tables.start_conditions
    }
    fn start_rates(&self) -> &[u16] {
        &self.shared.tables.start_rates
    }
    fn independent(&self) -> &[u16] {
        &self.shared.tables.independent
    }
    fn condition_pattern(&self) -> &[(u16, u16)] {
        &self.shared.tables.condition_jacobian
    }
    fn flips(&self) -> &[Flips<'_>] {
        &self.shared.tables.flips
    }
    fn idle(&self) -> &[u16] {
        &self.shared.tables.idle
    }
    fn dependent(&self) -> &[(u16, u16)] {
        &self.shared.tables.dependent
    }
    fn scales(&self) -> &[f64] {
        &self.shared.tables.scales
    }
    fn row_sizes(&self) -> List {
        List::of(&self.shared.tables.row_sizes)
    }
    fn massless_rows(&self) -> &[u16] {
        &self.shared.tables.massless_rows
    }
    fn massless_weights(&self) -> &[f64] {
        &self.shared.tables.massless_weights
    }
    fn elimination(&self) -> Elimination<'_> {
        self.shared.tables.elimination()
    }
    type Conditions = List;
    type ConditionJacobian = List;
    type Factor = List;
    type System = List;
    type Dense = List;
    type Basis = List;
    type Reduced = List;
    type Choice = Vec<u16>;
    type Store = Store<D>;
    type Lu = List;

    fn choice(&self) -> Vec<u16> {
        vec![0; self.velocity_count()]
    }
    fn store(&self) -> Store<D> {
        if self.has(Function::Factor) {
            Store::Own(List::zeros(self.shared.tables.store))
        } else {
            Store::Tabled(Box::new(tabled::store(self)))
        }
    }
    fn lu(&self) -> List {
        List::zeros(if self.has(Function::FactorJacobian) { self.shared.tables.lu } else { 0 })
    }
    fn factor_jacobian(&self, time: f64, q: &List, lu: &mut List) -> f64 {
        if !self.has(Function::FactorJacobian) {
            return 0.0;
        }
        let given = [(Time, from_ref(&time)), (Q, q.as_slice())];
        self.call(Function::FactorJacobian, &given, &mut [lu.as_mut_slice()])
    }
    fn dependent_velocities(&self, lu: &List, rows: &List, v: &List, out: &mut List) {
        if !self.has(Function::FactorJacobian) {
            out.clone_from(v);
            return;
        }
        let given = [(Lu, lu.as_slice()), (GivenRows, rows.as_slice()), (V, v.as_slice())];
        self.call(Function::DependentVelocities, &given, &mut [out.as_mut_slice()]);
    }
    fn row_scales(&self, scales: &mut List) {
        self.call(Function::RowScales, &[], &mut [scales.as_mut_slice()]);
    }
    fn factor(&self, time: f64, q: &List, compliance: f64, store: &mut Store<D>) -> f64 {
        match store {
            Store::Own(kept) => {
                let given = [(Time, from_ref(&time)), (Q, q.as_slice()), (Compliance, from_ref(&compliance))];
                self.call(Function::Factor, &given, &mut [kept.as_mut_slice()])
            }
            Store::Tabled(store) => tabled::factor(self, time, q, compliance, store),
        }
    }
    fn system(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        two_alpha: f64,
        beta_squared: f64,
        compliance: f64,
        store: &mut Store<D>,
        forces: &mut List,
        rows: &mut List,
    ) -> f64 {
        match store {
            Store::Own(kept) if self.has(Function::System) => {
                let terms = self.at_state(time, state, u).with(TwoAlpha, &[two_alpha]);
                let terms = terms.with(BetaSquared, &[beta_squared]).with(Compliance, &[compliance]);
                let out = &mut [kept.as_mut_slice(), forces.as_mut_slice(), rows.as_mut_slice()];
                terms.results(Function::System, out)
            }
            _ => {
                let pivot = self.factor(time, &state.q, compliance, store);
                self.right_hand_sides(time, state, u, [two_alpha, beta_squared], forces, rows);
                // Softened rows have no pivot that could vanish.
                if self.massless_rows().is_empty() { 1.0 } else { pivot }
            }
        }
    }
    fn solve(&self, store: &Store<D>, forces: &List, rows: &List, a: &mut List, lambda: &mut List) {
        match store {
            Store::Own(kept) => {
                let given =
                    [(Kept, kept.as_slice()), (GivenForces, forces.as_slice()), (GivenRows, rows.as_slice())];
                self.call(Function::Solve, &given, &mut [a.as_mut_slice(), lambda.as_mut_slice()]);
            }
            Store::Tabled(store) => tabled::solve(self, store, forces, rows, a, lambda),
        }
    }

    fn condition_residual(&self, time: f64, q: &List, target: &List, residual: &mut List) {
        let given = [(Time, from_ref(&time)), (Q, q.as_slice()), (Target, target.as_slice())];
        self.call(Function::ConditionResidual, &given, &mut [residual.as_mut_slice()]);
    }
    fn condition_cosines(&self, time: f64, q: &List, target: &List, cosines: &mut List) {
        let given = [(Time, from_ref(&time)), (Q, q.as_slice()), (Target, target.as_slice())];
        self.call(Function::ConditionCosines, &given, &mut [cosines.as_mut_slice()]);
    }
    fn condition_jacobian(&self, time: f64, q: &List, jacobian: &mut List) {
        self.at_position(Function::ConditionJacobian, time, q, jacobian);
    }
    fn condition_bias(&self, time: f64, q: &List, v: &List, bias: &mut List) {
        let given = [(Time, from_ref(&time)), (Q, q.as_slice()), (V, v.as_slice())];
        self.call(Function::ConditionBias, &given, &mut [bias.as_mut_slice()]);
    }
    fn condition_drift(&self, time: f64, q: &List, drift: &mut List) {
        self.at_position(Function::ConditionDrift, time, q, drift);
    }
    fn row_cosines(&self, time: f64, q: &List, cosines: &mut List) {
        self.at_position(Function::RowCosines, time, q, cosines);
    }
    fn start_targets(&self, positions: &mut List, rates: &mut List) {
        self.call(Function::StartTargets, &[], &mut [positions.as_mut_slice(), rates.as_mut_slice()]);
    }
    fn start_q(&self) -> List {
        List::of(&self.shared.tables.start_q)
    }
    fn start_v(&self) -> List {
        List::of(&self.shared.tables.start_v)
    }
    fn start_internal(&self) -> List {
        let mut internal = List::zeros(self.internal_count());
        self.call(Function::StartInternal, &[], &mut [internal.as_mut_slice()]);
        internal
    }
    fn start_gates(&self) -> List {
        List::of(&self.shared.tables.start_gates)
    }
    fn fix_phases(&mut self, q: &List) {
        if self.shared.tables.open.is_empty() {
            return;
        }
        // The residual with the old phase is what the new phase differs by.
        let mut phi = self.zero_lambda();
        self.constraints(0.0, q, &mut phi);
        let open = self.shared.tables.open.iter();
        for (phase, row) in self.phases.as_mut_slice().iter_mut().zip(open) {
            *phase += phi.as_slice()[*row];
        }
        self.constants();
    }
}

impl<D: 'static> Engine<D> {
    /// The start with these parameters, near that of the definition. What `start` says of a coordinate that a driver moves is left to the
    /// driver, whose law says it too, with these parameters perhaps otherwise: stated twice it could not be solved for.
    ///
    /// # Errors
    /// As [`assemble`](AssembleExt::assemble).
    pub fn assembled_start(&self) -> Result<StateOf<Self>, AssemblyError> {
        let near = self.start();
        let (mut positions, mut rates) = (self.zero_conditions(), self.zero_conditions());
        self.start_targets(&mut positions, &mut rates);
        let driven = &self.shared.tables.driven;
        let others = |stated: &[u16]| -> Vec<u16> {
            stated.iter().copied().filter(|index| !driven.contains(index)).collect()
        };
        let q = assemble_position(self, 0.0, &near.q, &positions, &others(self.start_conditions()))?;
        let v = assemble_velocity(self, 0.0, &q, &rates, &others(self.start_rates()))?;
        let mut state = State { q, v, z: self.start_internal(), gates: self.start_gates() };
        if !state.gates.as_slice().is_empty() {
            state.gates = self.live_gates(0.0, &state);
        }
        Ok(state)
    }

    /// Q and γ − 2α (D v − ν) − β² Φ, in the order of operations of the runtime's `system`.
    fn right_hand_sides(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        [two_alpha, beta_squared]: [f64; 2],
        forces: &mut List,
        rows: &mut List,
    ) {
        self.forces(time, state, u, forces);
        self.gamma(time, &state.q, &state.v, rows);
        let (mut phi, mut rest) = (self.zero_lambda(), self.zero_lambda());
        self.constraints(time, &state.q, &mut phi);
        self.nu(time, &state.q, &mut rest);
        let mut jacobian = self.zero_jacobian();
        self.constraint_jacobian(time, &state.q, &mut jacobian);
        for (entry, (row, column)) in jacobian.as_slice().iter().zip(self.jacobian_pattern()) {
            rest.as_mut_slice()[usize::from(*row)] -= entry * state.v.as_slice()[usize::from(*column)];
        }
        rows.axpy(two_alpha, &rest);
        rows.axpy(-beta_squared, &phi);
    }
}
