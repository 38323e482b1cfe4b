//! Every mechanism as generic checks see it: [`Model`], implemented for all shipped models, and random data for them.
//!
//! A check is a function `fn check<M: Model>()`; [`for_each`] makes a test of it for each shipped model and for the
//! mechanisms of `zoo.rs`, so that a new model is checked by being listed in `models/src/lib.rs`.

use linkwright::{Assemble, Fields, Layout, Report, SettingError, State, StateOf, Vector};
use linkwright_compiler::model::{Coordinates, Mechanism};
use linkwright_compiler::schedule::Inputs;
use linkwright_compiler::{Compiled, compile};

/// An emitted mechanism, with what follows from its states in flat lists.
pub trait Model:
    Assemble<
        f64,
        Q: Copy,
        V: Copy,
        Z: Copy,
        Gates: Copy,
        Lambda: Copy,
        Inputs: Fields<f64> + Copy,
        Outputs: Fields<f64> + Copy,
        Conditions: Copy,
        Store: Copy,
    > + Report<f64>
    + Sized
{
    /// The definition, with names of files from the root of the file system.
    fn source() -> &'static str;
    /// The same mechanism in single precision.
    type Single: Assemble<f32, Inputs: Fields<f32>, Outputs: Fields<f32>>;

    /// The model with its default parameters.
    fn standard() -> Self;
    fn single() -> Self::Single;
    fn prepared(parameters: &[f64]) -> Result<Self, SettingError>;
    fn parameter_values(&self) -> Vec<f64>;

    /// Whether steps are taken whole. Where gates of contacts are held within a step, touches part it, and steppers, lanes and C refuse.
    fn takes_whole_steps(&self) -> bool {
        self.gate_names().is_empty()
    }

    fn flat_motions(&self, time: f64, q: &Self::Q, v: &Self::V, a: &Self::V) -> Vec<f64> {
        flat(self.motions(time, q, v, a).as_ref())
    }
    fn flat_reactions(&self, at: &At<Self>, a: &Self::V, lambda: &Self::Lambda) -> Vec<f64> {
        flat(self.reactions(at.time, &at.state(), &at.u, a, lambda).as_ref())
    }
    fn flat_inverse_dynamics(&self, at: &At<Self>, a: &Self::V) -> Vec<f64> {
        self.inverse_dynamics(at.time, &at.state(), &at.u, a).as_slice().to_vec()
    }
    fn flat_powers(&self, at: &At<Self>) -> Vec<f64> {
        self.powers(at.time, &at.state(), &at.u).as_slice().to_vec()
    }
    /// Whether motions, reactions, inverse dynamics and powers are finite; found without allocation.
    fn derived_finite(&self, at: &At<Self>, a: &Self::V, lambda: &Self::Lambda) -> bool {
        let At { time, q, v, u, .. } = at;
        let state = &at.state();
        finite(self.motions(*time, q, v, a).as_ref())
            && finite(self.reactions(*time, state, u, a, lambda).as_ref())
            && self.inverse_dynamics(*time, state, u, a).as_slice().iter().all(|x| x.is_finite())
            && self.powers(*time, state, u).as_slice().iter().all(|x| x.is_finite())
    }
    /// Efforts, then powers.
    fn flat_driver_efforts(&self, at: &At<Self>, lambda: &Self::Lambda) -> Vec<f64> {
        let efforts = self.driver_efforts(at.time, &at.q, &at.v, lambda);
        let efforts = efforts.as_ref();
        efforts.iter().map(|[effort, _]| *effort).chain(efforts.iter().map(|[_, power]| *power)).collect()
    }
}

/// All numbers of motions or reactions.
fn flat<F: Fields<f64>>(list: &[F]) -> Vec<f64> {
    list.iter().flat_map(|fields| fields.to_array().as_slice().to_vec()).collect()
}

fn finite<F: Fields<f64>>(list: &[F]) -> bool {
    list.iter().all(|fields| fields.to_array().as_slice().iter().all(|number| number.is_finite()))
}

/// Time, state and inputs.
pub struct At<M: Model> {
    pub time: f64,
    pub q: M::Q,
    pub v: M::V,
    /// Internal states.
    pub z: M::Z,
    /// What is held within a step, by [`gates`].
    pub gates: M::Gates,
    pub u: M::Inputs,
}

/// Implements [`Model`] for emitted mechanisms: `model!(Pendulum, inner::FourBar)`.
#[macro_export]
macro_rules! model {
    ($($first:tt $(:: $segment:ident)*),* $(,)?) => { $(
        impl $crate::registry::Model for $first $(:: $segment)* <f64> {
            type Single = $first $(:: $segment)* <f32>;

            fn source() -> &'static str {
                static TEXT: std::sync::OnceLock<String> = std::sync::OnceLock::new();
                TEXT.get_or_init(|| $crate::files::from_the_root(<$first $(:: $segment)* <f64>>::SOURCE))
            }
            fn standard() -> Self {
                Self::default()
            }
            fn single() -> Self::Single {
                Self::Single::default()
            }
            fn prepared(parameters: &[f64]) -> Result<Self, linkwright::SettingError> {
                Self::prepare($crate::registry::fields(parameters))
            }
            fn parameter_values(&self) -> Vec<f64> {
                linkwright::Fields::<f64>::to_array(self.parameters()).to_vec()
            }
        }
    )* };
}
pub use crate::model;

macro_rules! implement {
    ($($name:ident: $first:tt $(:: $segment:ident)*),* $(,)?) => { model!($($first $(:: $segment)*),*); };
}
linkwright_models::for_each_model!(implement);

/// A test of the function `check::<M>` for each model `M`, shipped or of the zoo, in a module of that function's name; `in zoo` for those
/// of the zoo alone, which have every element, and `in sample` for some of both, which have every kind: what is compiled many times for each
/// mechanism is asked of these.
#[macro_export]
macro_rules! for_each {
    ($check:ident) => {
        $crate::registry::for_each! { @ ($) $check, linkwright_models::for_each_model, $crate::zoo::for_each_in_zoo }
    };
    (in zoo, $check:ident) => {
        $crate::registry::for_each! { @ ($) $check, $crate::zoo::for_each_in_zoo }
    };
    (in sample, $check:ident) => {
        $crate::registry::for_each! { @ ($) $check, $crate::zoo::for_each_in_sample }
    };
    // The dollar is handed in, because a macro cannot write the variables of the macro it defines.
    (@ ($dollar:tt) $check:ident $(, $list:path)*) => {
        mod $check {
            macro_rules! tests {
                ($dollar($dollar name:ident: $dollar model:path),* $dollar(,)?) => {
                    $dollar(
                        #[test]
                        fn $dollar name() {
                            super::$check::<$dollar model>();
                        }
                    )*
                };
            }
            $($list!(tests);)*
        }
    };
}
pub use crate::for_each;

/// Inputs, outputs or parameters from their values.
pub fn fields<F: Fields<f64>>(values: &[f64]) -> F {
    F::from_array(vector(values))
}

pub fn vector<V: Vector<f64>>(values: &[f64]) -> V {
    let mut vector = V::zeros(values.len());
    vector.as_mut_slice().copy_from_slice(values);
    vector
}

/// The mechanism through all stages but the last, in the coordinates of its emitted code or in others.
pub fn compiled<M: Model>(coordinates: Option<Coordinates>) -> Compiled {
    let tokens = M::source().parse().expect("the source was tokens");
    compile(tokens, coordinates).expect("the definition was compiled before")
}

/// Gates as a run may hold them, from numbers in [−1, 1): 0 or 1; of rigid contacts a force that pushes, N or N m. Events are as gates,
/// memories any number.
pub fn gates(mechanism: &Mechanism, mut unit: impl FnMut() -> f64) -> Vec<f64> {
    let gate = |_| match mechanism.is_rigid() {
        true => 5.0 + 5.0 * unit(),
        false => f64::from(u8::from(unit() > 0.0)),
    };
    let mut held: Vec<f64> = mechanism.gates().map(gate).collect();
    held.extend(mechanism.events.iter().map(|_| f64::from(u8::from(unit() > 0.0))));
    held.extend(mechanism.memories.iter().map(|_| unit()));
    held
}

impl<M: Model> At<M> {
    /// The time, state and inputs of a point.
    pub fn of(point: &Inputs) -> Self {
        let Inputs { time, q, v, internal, gates, inputs, .. } = point;
        let (z, gates) = (vector(internal), vector(gates));
        At { time: *time, q: vector(q), v: vector(v), z, gates, u: fields(inputs) }
    }

    pub fn state(&self) -> StateOf<M> {
        self.at(self.q, self.v)
    }

    /// The same at another position and velocity.
    pub fn at(&self, q: M::Q, v: M::V) -> StateOf<M> {
        State { q, v, z: self.z, gates: self.gates }
    }
}

/// Uniform random numbers, the same in every run.
pub struct Random(crate::random::Random);

impl Random {
    pub fn new(seed: u64) -> Self {
        Random(crate::random::Random::new(seed))
    }

    /// In [−1, 1).
    pub fn unit(&mut self) -> f64 {
        self.0.unit()
    }

    pub fn vector(&mut self, length: usize) -> Vec<f64> {
        (0..length).map(|_| self.unit()).collect()
    }

    /// Any position: pairs on the circle, whole turns, nothing consistent.
    pub fn position(&mut self, layout: &Layout<'_>) -> Vec<f64> {
        let mut q = self.vector(layout.linear);
        for _ in 0..layout.rotations {
            let angle = 4.0 * self.unit();
            q.extend([angle.cos(), angle.sin()]);
        }
        for _ in 0..layout.quaternions {
            let part = self.vector(4);
            let length = part.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
            q.extend(part.iter().map(|x| x / length));
        }
        for _ in layout.angles {
            q.extend([(5.0 * self.unit()).round(), 3.0 * self.unit()]);
        }
        q
    }

    /// Parameters within a tenth of their defaults, and within their bounds.
    pub fn parameters(&mut self, compiled: &Compiled) -> Vec<f64> {
        let parameters = compiled.mechanism.parameters.iter().map(|parameter| {
            let near = parameter.default + 0.1 * self.unit() * parameter.default.abs();
            let (least, most) = parameter.bounds.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            near.clamp(least, most)
        });
        parameters.collect()
    }

    /// Internal states, of the size that their authors say.
    pub fn internal(&mut self, compiled: &Compiled) -> Vec<f64> {
        let states = compiled.mechanism.states.iter();
        states.map(|state| state.scale.unwrap_or(1.0) * self.unit()).collect()
    }

    /// Values of everything that a program can ask for, except the prepared constants.
    pub fn point(&mut self, compiled: &Compiled) -> Inputs {
        let (layout, e) = (layout(compiled), &compiled.complete.equations);
        Inputs {
            parameters: self.parameters(compiled),
            phases: compiled.assembly.phases.clone(),
            time: 2.0 + self.unit(),
            q: self.position(&layout),
            v: self.vector(layout.velocities()),
            inputs: self.vector(e.symbols.inputs.len()),
            internal: self.internal(compiled),
            gates: gates(&compiled.mechanism, || self.unit()),
            two_alpha: 10.0 + self.unit(),
            beta_squared: 25.0 + self.unit(),
            acceleration: self.vector(layout.velocities()),
            lambda: self.vector(e.rows.len()),
            targets: self.vector(compiled.complete.conditions.rows.len()),
            compliance: 0.01 * (2.0 + self.unit()),
            given_forces: self.vector(layout.velocities()),
            given_rows: self.vector(e.rows.len()),
            // By `Function::Factor`.
            kept: vec![0.0; compiled.complete.further.kept().len()],
            // By `Function::FactorJacobian`.
            lu: vec![0.0; compiled.complete.further.lu().len()],
            prepared: Vec::new(),
        }
    }
}

/// The runtime's layout of a mechanism that was not emitted. Rates of angles are left out.
fn layout(compiled: &Compiled) -> Layout<'static> {
    const ANGLE: linkwright::MultiTurn = linkwright::MultiTurn { rate: &[] };
    const ANGLES: [linkwright::MultiTurn; 64] = [ANGLE; 64];
    let layout = &compiled.complete.equations.layout;
    let angles = &const { &ANGLES }[..layout.angles.len()];
    Layout {
        linear: layout.linear.len(),
        rotations: layout.rotations.len(),
        quaternions: layout.quaternions.len(),
        angles,
    }
}
