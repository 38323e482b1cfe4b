//! The engine as the runtime's `Tangent`, where it has derivatives.

use crate::{Engine, List, Numbers};
use linkwright_compiler::functions::Argument::{Acceleration, Q, Time, V};
use linkwright_compiler::functions::Function;
use linkwright_runtime::{StateOf, Tangent, Vector};
use std::slice::from_ref;

/// Says of an [`Engine`] that it has the derivatives of its equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Derivatives {}

/// The methods that return the patterns of matrices.
macro_rules! patterns {
    ($($method:ident),*) => {
        $(fn $method(&self) -> &[(u16, u16)] {
            self.shared.tables.derivative(stringify!($method))
        })*
    };
}

impl Tangent<f64> for Engine<Derivatives> {
    fn states(&self) -> &[u16] {
        &self.shared.tables.states
    }
    patterns!(
        stiffness_pattern,
        damping_pattern,
        row_stiffness_pattern,
        row_damping_pattern,
        rate_pattern,
        input_pattern,
        internal_pattern,
        friction_pattern,
        parameter_pattern,
        output_pattern,
        internal_rate_pattern,
        coordinate_pattern
    );

    type Stiffness = List;
    type Damping = List;
    type RowStiffness = List;
    type RowDamping = List;
    type RateTangent = List;
    type InputTangent = List;
    type InternalTangent = List;
    type FrictionTangent = List;
    type ParameterTangent = List;
    type OutputTangent = List;
    type InternalRateTangent = List;
    type CoordinateTangent = List;
    type StateMatrix = List;
    type InputMatrix = List;
    type OutputMatrix = List;
    type Feedthrough = List;
    type Unknowns = List;
    type Bordered = List;
    type Order = Vec<u16>;
    type Parameters = Numbers;

    fn parameter_names(&self) -> &[&'static str] {
        self.shared.tables.parameters
    }
    fn order(&self) -> Vec<u16> {
        vec![0; self.unknown_count()]
    }
    fn residual(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &List,
        lambda: &List,
        residual: &mut List,
    ) {
        self.with_solution(Function::Residual, time, state, u, a, lambda, &mut [residual.as_mut_slice()]);
    }
    fn tangent(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &List,
        lambda: &List,
        stiffness: &mut List,
        damping: &mut List,
    ) {
        let out = &mut [stiffness.as_mut_slice(), damping.as_mut_slice()];
        self.with_solution(Function::Tangent, time, state, u, a, lambda, out);
    }
    fn row_tangent(&self, time: f64, q: &List, v: &List, a: &List, stiffness: &mut List, damping: &mut List) {
        let out = &mut [stiffness.as_mut_slice(), damping.as_mut_slice()];
        self.moving(Function::RowTangent, time, q, v, a, out);
    }
    fn rate_tangent(&self, time: f64, q: &List, v: &List, rate: &mut List) {
        let given = [(Time, from_ref(&time)), (Q, q.as_slice()), (V, v.as_slice())];
        self.call(Function::RateTangent, &given, &mut [rate.as_mut_slice()]);
    }
    fn input_tangent(&self, time: f64, state: &StateOf<Self>, u: &Numbers, input: &mut List) {
        self.at_state(time, state, u).results(Function::InputTangent, &mut [input.as_mut_slice()]);
    }
    fn internal_tangent(&self, time: f64, state: &StateOf<Self>, u: &Numbers, internal: &mut List) {
        self.at_state(time, state, u).results(Function::InternalTangent, &mut [internal.as_mut_slice()]);
    }
    fn friction_tangent(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &List,
        lambda: &List,
        friction: &mut List,
    ) {
        if self.has(Function::FrictionTangent) {
            let out = &mut [friction.as_mut_slice()];
            self.with_solution(Function::FrictionTangent, time, state, u, a, lambda, out);
        }
    }
    fn parameter_tangent(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &List,
        lambda: &List,
        parameter: &mut List,
    ) {
        let out = &mut [parameter.as_mut_slice()];
        self.with_solution(Function::ParameterTangent, time, state, u, a, lambda, out);
    }
    fn output_tangent(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &List,
        lambda: &List,
        output: &mut List,
    ) {
        self.with_solution(Function::OutputTangent, time, state, u, a, lambda, &mut [output.as_mut_slice()]);
    }
    fn internal_rate_tangent(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers,
        a: &List,
        lambda: &List,
        rates: &mut List,
    ) {
        let out = &mut [rates.as_mut_slice()];
        self.with_solution(Function::InternalRateTangent, time, state, u, a, lambda, out);
    }
    fn coordinate_tangent(&self, time: f64, q: &List, v: &List, a: &List, coordinate: &mut List) {
        self.moving(Function::CoordinateTangent, time, q, v, a, &mut [coordinate.as_mut_slice()]);
    }
}

impl<D: 'static> Engine<D> {
    /// A function of time, position, velocity and acceleration.
    pub(crate) fn moving(
        &self,
        function: Function,
        time: f64,
        q: &List,
        v: &List,
        a: &List,
        out: &mut [&mut [f64]],
    ) {
        let given =
            [(Time, from_ref(&time)), (Q, q.as_slice()), (V, v.as_slice()), (Acceleration, a.as_slice())];
        self.call(function, &given, out);
    }
}
