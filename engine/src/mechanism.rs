//! The engine as the runtime's `Variables` and `Mechanism`.

use crate::{Call, Engine, List, Numbers};
use linkwright_compiler::functions::Argument::{
    Acceleration, BetaSquared, Gates, Inputs, Lambda, Q, Time, TwoAlpha, V, Z,
};
use linkwright_compiler::functions::Function;
use linkwright_runtime::{Layout, Mechanism, Row, StateOf, Trigger, Variables, Vector, unwrap_angle};
use std::slice::from_ref;

impl<D: 'static> Variables<f64> for Engine<D> {
    fn layout(&self) -> &Layout<'_> {
        &self.shared.tables.layout
    }
    fn internal_scales(&self) -> &[f64] {
        &self.shared.tables.internal_scales
    }
    type Q = List;
    type V = List;
    type Z = List;
    type Gates = List;
    type Lambda = List;
}

impl<D: 'static> Mechanism<f64> for Engine<D> {
    fn name(&self) -> &'static str {
        self.shared.tables.name
    }
    fn fingerprint(&self) -> u64 {
        self.shared.tables.fingerprint
    }
    fn rows(&self) -> &[Row] {
        &self.shared.tables.rows
    }
    fn position_names(&self) -> &[&'static str] {
        self.shared.tables.positions
    }
    fn velocity_names(&self) -> &[&'static str] {
        self.shared.tables.velocities
    }
    fn internal_names(&self) -> &[&'static str] {
        self.shared.tables.internal
    }
    fn input_names(&self) -> &'static [&'static str] {
        self.shared.tables.inputs
    }
    fn output_names(&self) -> &'static [&'static str] {
        self.shared.tables.outputs
    }
    fn mass_pattern(&self) -> &[(u16, u16)] {
        &self.shared.tables.mass
    }
    fn jacobian_pattern(&self) -> &[(u16, u16)] {
        &self.shared.tables.jacobian
    }
    type Mass = List;
    type Jacobian = List;
    type Inputs = Numbers;
    type Outputs = Numbers;

    fn mass_matrix(&self, time: f64, q: &List, mass: &mut List) {
        self.at_position(Function::MassMatrix, time, q, mass);
    }
    fn constraints(&self, time: f64, q: &List, phi: &mut List) {
        self.at_position(Function::Constraints, time, q, phi);
    }
    fn constraint_jacobian(&self, time: f64, q: &List, d: &mut List) {
        self.at_position(Function::ConstraintJacobian, time, q, d);
    }
    fn nu(&self, time: f64, q: &List, nu: &mut List) {
        self.at_position(Function::Nu, time, q, nu);
    }
    fn gamma(&self, time: f64, q: &List, v: &List, gamma: &mut List) {
        let given = [(Time, from_ref(&time)), (Q, q.as_slice()), (V, v.as_slice())];
        self.call(Function::Gamma, &given, &mut [gamma.as_mut_slice()]);
    }
    fn forces(&self, time: f64, state: &StateOf<Self>, u: &Numbers, forces: &mut List) {
        self.at_state(time, state, u).results(Function::Forces, &mut [forces.as_mut_slice()]);
    }
    fn rubs(&self) -> bool {
        self.has(Function::FrictionForces)
    }
    fn friction_forces(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &List,
        lambda: &List,
        forces: &mut List,
    ) {
        if self.rubs() {
            let out = &mut [forces.as_mut_slice()];
            self.with_solution(Function::FrictionForces, time, state, u, a, lambda, out);
        } else {
            forces.as_mut_slice().fill(0.0);
        }
    }
    fn kinetic_energy(&self, time: f64, q: &List, v: &List) -> f64 {
        let given = [(Time, from_ref(&time)), (Q, q.as_slice()), (V, v.as_slice())];
        self.call(Function::KineticEnergy, &given, &mut [])
    }
    fn potential_energy(&self, time: f64, state: &StateOf<Self>) -> f64 {
        let [q, v] = [(Q, state.q.as_slice()), (V, state.v.as_slice())];
        let [z, gates] = [(Z, state.z.as_slice()), (Gates, state.gates.as_slice())];
        self.call(Function::PotentialEnergy, &[(Time, from_ref(&time)), q, v, z, gates], &mut [])
    }
    fn gate_names(&self) -> &[&'static str] {
        self.shared.tables.gates
    }
    fn memory_names(&self) -> &[&'static str] {
        self.shared.tables.memories
    }
    fn triggers(&self) -> &[Trigger] {
        &self.shared.tables.triggers
    }
    fn assignments(&self, time: f64, state: &StateOf<Self>, u: &Numbers, after: &mut List) {
        if self.has(Function::Assignments) {
            self.at_state(time, state, u).results(Function::Assignments, &mut [after.as_mut_slice()]);
        }
    }
    fn guards(&self, time: f64, state: &StateOf<Self>, gaps: &mut List, forces: &mut List) {
        if !self.gate_names().is_empty() {
            let [q, v] = [(Q, state.q.as_slice()), (V, state.v.as_slice())];
            let [z, gates] = [(Z, state.z.as_slice()), (Gates, state.gates.as_slice())];
            let given = [(Time, from_ref(&time)), q, v, z, gates];
            self.call(Function::Guards, &given, &mut [gaps.as_mut_slice(), forces.as_mut_slice()]);
        }
    }
    fn is_rigid(&self) -> bool {
        self.shared.tables.rigid
    }
    fn parts_by_impulses(&self) -> bool {
        self.shared.tables.by_impulses
    }
    fn pressed_by(&self) -> &[Option<usize>] {
        &self.shared.tables.pressed_by
    }
    fn slide_as_one(&self) -> &[usize] {
        &self.shared.tables.slide_as_one
    }
    fn grips(&self, holding: &mut List, sliding: &mut List) {
        if self.has(Function::Grips) {
            self.call(Function::Grips, &[], &mut [holding.as_mut_slice(), sliding.as_mut_slice()]);
        }
    }
    fn sticks(&self) -> bool {
        self.shared.tables.sticks
    }
    fn bounds(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &List,
        lambda: &List,
        holding: &mut List,
        sliding: &mut List,
    ) {
        if self.has(Function::Bounds) {
            let out = &mut [holding.as_mut_slice(), sliding.as_mut_slice()];
            self.with_solution(Function::Bounds, time, state, u, a, lambda, out);
        }
    }
    fn strikes(
        &self,
        time: f64,
        q: &List,
        v: &List,
        rates: &mut List,
        biases: &mut List,
        restitutions: &mut List,
    ) {
        if self.has(Function::Strikes) {
            let given = [(Time, from_ref(&time)), (Q, q.as_slice()), (V, v.as_slice())];
            let out = &mut [rates.as_mut_slice(), biases.as_mut_slice(), restitutions.as_mut_slice()];
            self.call(Function::Strikes, &given, out);
        }
    }
    fn acceleration(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &mut List,
        lambda: &mut List,
    ) -> f64 {
        self.solution(Function::Acceleration, time, state, u, a, lambda)
    }
    fn acceleration_baumgarte(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        two_alpha: f64,
        beta_squared: f64,
        a: &mut List,
        lambda: &mut List,
    ) -> f64 {
        if self.rows().is_empty() {
            // Nothing to stabilise.
            return self.acceleration(time, state, u, a, lambda);
        }
        let function = Function::AccelerationBaumgarte;
        self.stabilised(function, time, state, u, two_alpha, beta_squared, a, lambda)
    }
    fn null_space_first(&self) -> bool {
        self.shared.tables.null_space_first
    }
    fn null_space(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &mut List,
        lambda: &mut List,
    ) -> f64 {
        if !self.has(Function::NullSpace) {
            return 0.0;
        }
        self.solution(Function::NullSpace, time, state, u, a, lambda)
    }
    fn null_space_baumgarte(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        two_alpha: f64,
        beta_squared: f64,
        a: &mut List,
        lambda: &mut List,
    ) -> f64 {
        if !self.has(Function::NullSpaceBaumgarte) {
            return 0.0;
        }
        let function = Function::NullSpaceBaumgarte;
        self.stabilised(function, time, state, u, two_alpha, beta_squared, a, lambda)
    }
    fn internal_rates(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &List,
        lambda: &List,
        rates: &mut List,
    ) {
        if !rates.as_slice().is_empty() {
            self.with_solution(
                Function::InternalRates,
                time,
                state,
                u,
                a,
                lambda,
                &mut [rates.as_mut_slice()],
            );
        }
    }
    fn outputs(&self, time: f64, state: &StateOf<Self>, u: &Numbers) -> Numbers {
        let mut outputs = List::zeros(self.output_names().len());
        self.at_state(time, state, u).results(Function::Outputs, &mut [outputs.as_mut_slice()]);
        Numbers(outputs)
    }
    fn unwrap(&self, outputs: &mut Numbers, previous: &Numbers) {
        let (outputs, previous) = (outputs.0.as_mut_slice(), previous.as_slice());
        for (output, _) in &self.shared.tables.angles {
            outputs[*output] = unwrap_angle(outputs[*output], previous[*output]);
        }
    }
    fn unwrap_start(&self, outputs: &mut Numbers) {
        use linkwright_runtime::Assemble;
        let (mut positions, mut rates) = (self.zero_conditions(), self.zero_conditions());
        self.start_targets(&mut positions, &mut rates);
        let outputs = outputs.0.as_mut_slice();
        for (output, stated) in &self.shared.tables.angles {
            if let Some(at) = stated {
                outputs[*output] = unwrap_angle(outputs[*output], positions.as_slice()[*at]);
            }
        }
    }
}

impl<D: 'static> Engine<D> {
    /// Whether the mechanism has this function.
    pub(crate) fn has(&self, function: Function) -> bool {
        self.shared.code[function as usize].outputs() > 0
    }

    /// A function of time and position.
    pub(crate) fn at_position(&self, function: Function, time: f64, q: &List, out: &mut List) {
        let given = [(Time, from_ref(&time)), (Q, q.as_slice())];
        self.call(function, &given, &mut [out.as_mut_slice()]);
    }

    #[allow(clippy::too_many_arguments)]
    #[inline]
    fn stabilised(
        &self,
        function: Function,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        two_alpha: f64,
        beta_squared: f64,
        a: &mut List,
        lambda: &mut List,
    ) -> f64 {
        let terms =
            self.at_state(time, state, u).with(TwoAlpha, &[two_alpha]).with(BetaSquared, &[beta_squared]);
        terms.results(function, &mut [a.as_mut_slice(), lambda.as_mut_slice()])
    }

    /// A function of time, state and inputs, which are arguments by now.
    #[inline(always)]
    pub(crate) fn at_state(&self, time: f64, state: &StateOf<Self>, u: &Numbers) -> Call<'_> {
        let position = self.arguments().with(Time, &[time]).with(Q, state.q.as_slice());
        let state = position
            .with(V, state.v.as_slice())
            .with(Z, state.z.as_slice())
            .with(Gates, state.gates.as_slice());
        state.with(Inputs, u.as_slice())
    }

    #[inline]
    fn solution(
        &self,
        function: Function,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &mut List,
        lambda: &mut List,
    ) -> f64 {
        self.at_state(time, state, u).results(function, &mut [a.as_mut_slice(), lambda.as_mut_slice()])
    }

    /// A function of time, state, inputs and a solution.
    #[allow(clippy::too_many_arguments)]
    pub(crate) fn with_solution(
        &self,
        function: Function,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &List,
        lambda: &List,
        out: &mut [&mut [f64]],
    ) {
        let state = self.at_state(time, state, u);
        state.with(Acceleration, a.as_slice()).with(Lambda, lambda.as_slice()).results(function, out);
    }
}
