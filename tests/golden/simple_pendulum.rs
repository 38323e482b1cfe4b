// `SimplePendulum` of models/src/simple_pendulum.rs.
// Left out: condition_cosines, condition_drift, driver_efforts.
/// Simple pendulum: a point mass on a massless arm (IFToMM A01).
///
/// 1 kg, 1 m, g = 9.81 m/s², from (−1, 0) at rest. Period 2.367841947576237449 s.
///
///Equations of motion of the planar mechanism `SimplePendulum`.
#[cfg_attr(
    doc,
    doc = ::linkwright::__private::v1::mechanism_page!{#[doc = " Simple pendulum: a point mass on a massless arm (IFToMM A01)."]#[doc = ""]#[doc = " 1 kg, 1 m, g = 9.81 m/s², from (−1, 0) at rest. Period 2.367841947576237449 s."]pub
    planar
    SimplePendulum{gravity[m/s^2]= (0, -9.81);body
    arm{mass[kg]= 1;inertia[kg*m^2]= 0;center[m]= (1, 0);}joint
    pivot:revolute(
        ground(0, 0)[m],
        arm.origin
    );start{pivot.angle[deg]= 180;pivot.rate[rad/s]= 0;}expect{degrees_of_freedom = 1;}output
    x[m]= arm.center.x;output
    y[m]= arm.center.y;}}
)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct SimplePendulum<R = ::core::primitive::f64> {
    parameters: SimplePendulumParameters<R>,
    phases: [R; 0],
    constants: [R; 0],
}
///Parameters of [`SimplePendulum`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct SimplePendulumParameters<R = ::core::primitive::f64> {
    #[doc(hidden)]
    pub scalar: ::core::marker::PhantomData<R>,
}
///Outputs of [`SimplePendulum`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct SimplePendulumOutputs<R = ::core::primitive::f64> {
    ///In `m`.
    pub x: R,
    ///In `m`.
    pub y: R,
}
///Positions and velocities of [`SimplePendulum`].
pub type SimplePendulumState<R = ::core::primitive::f64> = ::linkwright::__private::v1::State<
    [R; 2],
    [R; 1],
>;
///Positions of [`SimplePendulum`] by name; [`From`] and [`Into`] the array of a state.
#[allow(dead_code)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct SimplePendulumPositions<R = ::core::primitive::f64> {
    ///rad, by its cosine and sine.
    pub arm_angle: ::linkwright::__private::v1::Angle<R>,
}
///Velocities of [`SimplePendulum`] by name; [`From`] and [`Into`] the array of a state.
#[allow(dead_code)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct SimplePendulumVelocities<R = ::core::primitive::f64> {
    ///rad/s.
    pub arm_rate: R,
}
#[allow(clippy::all)]
impl SimplePendulum<::core::primitive::f64> {
    ///Consistent start state for the default parameters, assembled at compile time.
    pub const START: SimplePendulumState = ::linkwright::__private::v1::State::new(
        [-1.0, 1.2246467991473532e-16],
        [0.0],
    );
    ///Degrees of freedom, drivers removed.
    pub const DEGREES_OF_FREEDOM: ::core::primitive::usize = 1;
    ///Operations of the default acceleration function (Baumgarte), a fused multiply-add counted once.
    pub const OPERATIONS: ::core::primitive::usize = 1;
    ///The definition as written.
    pub const SOURCE: &'static ::core::primitive::str = (
        "# [doc = \" Simple pendulum: a point mass on a massless arm (IFToMM A01).\"] # [doc = \"\"] # [doc = \" 1 kg, 1 m, g = 9.81 m/s², from (−1, 0) at rest. Period 2.367841947576237449 s.\"] pub planar SimplePendulum { gravity [m / s ^ 2] = (0 , - 9.81) ; body arm { mass [kg] = 1 ; inertia [kg * m ^ 2] = 0 ; center [m] = (1 , 0) ; } joint pivot : revolute (ground (0 , 0) [m] , arm . origin) ; start { pivot . angle [deg] = 180 ; pivot . rate [rad / s] = 0 ; } expect { degrees_of_freedom = 1 ; } output x [m] = arm . center . x ; output y [m] = arm . center . y ; }",
    )
        .0;
    ///The definition as versioned JSON: kinds, shapes and units as written.
    pub const DEFINITION: &'static ::core::primitive::str = (
        "{\"linkwright\":1,\"kind\":\"planar\",\"name\":\"SimplePendulum\",\"constants\":[],\"parameters\":[],\"inputs\":[],\"gravity\":{\"unit\":\"m/s^2\",\"value\":[{\"number\":\"0\"},{\"op\":\"neg\",\"args\":[{\"number\":\"9.81\"}]}]},\"bodies\":[{\"name\":\"arm\",\"kind\":\"body\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"number\":\"1\"}},\"inertia\":{\"unit\":\"kg*m^2\",\"value\":{\"number\":\"0\"}}},\"center\":{\"unit\":\"m\",\"value\":[{\"number\":\"1\"},{\"number\":\"0\"}]},\"points\":[],\"lines\":[]}],\"joints\":[{\"name\":\"pivot\",\"kind\":\"revolute\",\"first\":{\"ground\":[{\"number\":\"0\"},{\"number\":\"0\"}],\"unit\":\"m\"},\"second\":{\"place\":\"arm.origin\"}}],\"constraints\":[],\"drivers\":[],\"loads\":[],\"start\":[{\"quantity\":{\"name\":\"pivot.angle\"},\"exact\":true,\"unit\":\"deg\",\"value\":{\"number\":\"180\"}},{\"quantity\":{\"name\":\"pivot.rate\"},\"exact\":true,\"unit\":\"rad/s\",\"value\":{\"number\":\"0\"}}],\"outputs\":[{\"name\":\"x\",\"unit\":\"m\",\"value\":{\"name\":\"arm.center.x\"}},{\"name\":\"y\",\"unit\":\"m\",\"value\":{\"name\":\"arm.center.y\"}}],\"options\":{},\"expect\":{\"degrees_of_freedom\":1}}",
    )
        .0;
    ///What the entries of q and v and the constraint rows are, as JSON.
    pub const COORDINATES: &'static ::core::primitive::str = (
        "{\"coordinates\":\"tree\",\"tree\":[{\"body\":\"arm\",\"joint\":\"pivot\",\"parent\":\"ground\"}],\"linear\":[],\"rotations\":[{\"body\":\"arm\"}],\"angles\":[],\"rows\":[]}",
    )
        .0;
    ///Names of the bodies, in the order of `motions`.
    pub const BODIES: &'static [&'static ::core::primitive::str] = &["arm"];
    ///Names of the joints, in the order of `reactions`.
    pub const JOINTS: &'static [&'static ::core::primitive::str] = &["pivot"];
    ///Names of the loads, in the order of `powers`.
    pub const LOADS: &'static [&'static ::core::primitive::str] = &[];
    ///Constraint rows that repeat what others fix: joint and row. They are left out, or kept with the multiplier zero.
    pub const REDUNDANT_ROWS: &'static [(
        &'static ::core::primitive::str,
        &'static ::core::primitive::str,
    )] = &[];
    ///Joints whose reactions are not unique, because constraint rows repeat what others fix.
    pub const SHARED_REACTIONS: &'static [&'static ::core::primitive::str] = &[];
}
#[allow(unused, non_snake_case, clippy::all)]
const _: () = {
    use ::core::prelude::rust_2024::*;
    use ::linkwright::__private::v1::*;
    use ::core::primitive::{bool, f64, u16, u32, u64, usize, str};
    type Constants<R> = [R; 0];
    type Phases<R> = [R; 0];
    type Q<R> = [R; 2];
    type V<R> = [R; 1];
    type Lambda<R> = [R; 0];
    type Mass<R> = [R; 1];
    type Jacobian<R> = [R; 0];
    type Conditions<R> = [R; 1];
    type ConditionJacobian<R> = [R; 1];
    type Factor<R> = [R; 1];
    type System<R> = [R; 2];
    type Dense<R> = [R; 0];
    type Basis<R> = [R; 1];
    type Reduced<R> = [R; 1];
    type Parameters<R> = SimplePendulumParameters<R>;
    type Outputs<R> = SimplePendulumOutputs<R>;
    impl<R: Real> Fields<R> for Parameters<R> {
        const NAMES: &'static [&'static str] = &[];
        type Array = [R; 0];
        fn from_array(values: [R; 0]) -> Self {
            SimplePendulumParameters {
                scalar: ::core::marker::PhantomData,
            }
        }
        fn to_array(&self) -> [R; 0] {
            []
        }
    }
    impl<R: Real> Fields<R> for Outputs<R> {
        const NAMES: &'static [&'static str] = &["x", "y"];
        type Array = [R; 2];
        fn from_array(values: [R; 2]) -> Self {
            SimplePendulumOutputs {
                x: values[0],
                y: values[1],
            }
        }
        fn to_array(&self) -> [R; 2] {
            [self.x, self.y]
        }
    }
    impl<R: Real> From<Q<R>> for SimplePendulumPositions<R> {
        fn from(entries: Q<R>) -> Self {
            Self {
                arm_angle: Angle {
                    cos: entries[0],
                    sin: entries[1],
                },
            }
        }
    }
    impl<R: Real> From<SimplePendulumPositions<R>> for Q<R> {
        fn from(named: SimplePendulumPositions<R>) -> Self {
            [named.arm_angle.cos, named.arm_angle.sin]
        }
    }
    impl<R: Real> From<V<R>> for SimplePendulumVelocities<R> {
        fn from(entries: V<R>) -> Self {
            Self { arm_rate: entries[0] }
        }
    }
    impl<R: Real> From<SimplePendulumVelocities<R>> for V<R> {
        fn from(named: SimplePendulumVelocities<R>) -> Self {
            [named.arm_rate]
        }
    }
    impl<R: Real> Default for Parameters<R> {
        fn default() -> Self {
            SimplePendulumParameters {
                scalar: ::core::marker::PhantomData,
            }
        }
    }
    impl<R: Real> Default for SimplePendulum<R> {
        fn default() -> Self {
            Self::with(Default::default(), [])
        }
    }
    impl<R: Real> SimplePendulum<R> {
        /// The model with these parameters; what depends on nothing else is computed once, here.
        ///
        /// # Errors
        /// A parameter that is not finite or out of its bounds, or a mass that is not positive.
        pub fn prepare(parameters: Parameters<R>) -> Result<Self, SettingError> {
            let model = Self::with(parameters, []);
            check_constants(&model.constants)?;
            Ok(model)
        }
        /// The parameters the model was prepared with.
        pub fn parameters(&self) -> &Parameters<R> {
            &self.parameters
        }
        fn with(parameters: Parameters<R>, phases: Phases<R>) -> Self {
            // What depends on parameters and phases alone: the constants of the prepared model.
            Self {
                parameters,
                phases,
                constants: [],
            }
        }
        /// The positions of a state by name.
        pub fn positions(entries: &Q<R>) -> SimplePendulumPositions<R> {
            (*entries).into()
        }
        /// The velocities of a state by name.
        pub fn velocities(entries: &V<R>) -> SimplePendulumVelocities<R> {
            (*entries).into()
        }
        /// M v̇ − Q: the forces that the accelerations `a` need beside loads and constraints, one for each velocity
        /// (N m or N). Of a tree without constraints these are the efforts of its joints (inverse dynamics).
        pub fn inverse_dynamics(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &(),
            a: &V<R>,
        ) -> V<R> {
            // 1 operation.
            let arm_cos = state.q[0];
            let arm_rate_dot = a[0];
            let a0 = R::from_f64(9.81).mul_add(arm_cos, arm_rate_dot);
            [a0]
        }
        /// Power of each load (W), in the order of `LOADS`, what springs store included.
        pub fn powers(&self, time: R, state: &State<Q<R>, V<R>>, u: &()) -> [R; 0] {
            []
        }
        /// Position, velocity and acceleration of every body's centre of mass, in the order of `BODIES`,
        /// from a state and its accelerations.
        pub fn motions(
            &self,
            time: R,
            q: &Q<R>,
            v: &V<R>,
            a: &V<R>,
        ) -> [BodyMotion<R>; 1] {
            // 8 operations.
            let arm_cos = q[0];
            let arm_sin = q[1];
            let arm_rate = v[0];
            let arm_rate_dot = a[0];
            let a0 = arm_sin * arm_rate;
            let a1 = -a0;
            let a2 = arm_cos * arm_rate;
            let a3 = arm_sin * arm_rate_dot;
            let a4 = arm_rate * arm_rate;
            let a5 = (-arm_cos).mul_add(a4, -a3);
            let a6 = arm_cos * arm_rate_dot;
            let a7 = (-arm_sin).mul_add(a4, a6);
            [
                BodyMotion {
                    position: [arm_cos, arm_sin],
                    orientation: [arm_cos, arm_sin],
                    velocity: [a1, a2],
                    rate: arm_rate,
                    acceleration: [a5, a7],
                    angular_acceleration: arm_rate_dot,
                },
            ]
        }
        /// Force and torque that each joint exerts on the body of its second place, in the order of `JOINTS`:
        /// force in world axes at that place (N), torque about it (N m).
        pub fn reactions(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &(),
            a: &V<R>,
            lambda: &Lambda<R>,
        ) -> [Reaction<R>; 1] {
            // 5 operations.
            let arm_cos = state.q[0];
            let arm_sin = state.q[1];
            let arm_rate = state.v[0];
            let arm_rate_dot = a[0];
            let a0 = arm_sin * arm_rate_dot;
            let a1 = arm_rate * arm_rate;
            let a2 = (-arm_cos).mul_add(a1, -a0);
            let a3 = arm_cos.mul_add(arm_rate_dot, R::from_f64(9.81));
            let a4 = (-arm_sin).mul_add(a1, a3);
            [
                Reaction {
                    force: [a2, a4],
                    torque: R::ZERO,
                },
            ]
        }
    }
    impl<R: Real> Parametric<R> for SimplePendulum<R> {
        type Parameters = Parameters<R>;
        #[inline]
        fn parameters(&self) -> &Parameters<R> {
            &self.parameters
        }
        fn prepare(parameters: Parameters<R>) -> Result<Self, SettingError> {
            SimplePendulum::<R>::prepare(parameters)
        }
    }
    impl<S> InScalars for SimplePendulum<S> {
        type In<R: Real> = SimplePendulum<R>;
        fn zip<A: Real, B: Real, C: Real>(
            a: &SimplePendulum<A>,
            b: &SimplePendulum<B>,
            f: &mut impl FnMut(A, B) -> C,
        ) -> SimplePendulum<C> {
            SimplePendulum {
                parameters: zip_fields(&a.parameters, &b.parameters, f),
                phases: zip_arrays(&a.phases, &b.phases, f),
                constants: zip_arrays(&a.constants, &b.constants, f),
            }
        }
    }
    impl<R: Real> Variables<R> for SimplePendulum<R> {
        #[inline]
        fn layout(&self) -> &Layout<'_> {
            &Layout {
                linear: 0,
                rotations: 1,
                quaternions: 0,
                angles: &[],
            }
        }
        type Q = Q<R>;
        type V = V<R>;
        type Lambda = Lambda<R>;
        type Z = ();
        type Gates = ();
    }
    impl<R: Real> Mechanism<R> for SimplePendulum<R> {
        #[inline]
        fn name(&self) -> &'static str {
            "SimplePendulum"
        }
        #[inline]
        fn fingerprint(&self) -> u64 {
            0xe742058971ed10f6
        }
        #[inline]
        fn rows(&self) -> &[Row] {
            &[]
        }
        #[inline]
        fn position_names(&self) -> &[&'static str] {
            &["arm.cos", "arm.sin"]
        }
        #[inline]
        fn velocity_names(&self) -> &[&'static str] {
            &["arm.rate"]
        }
        #[inline]
        fn mass_pattern(&self) -> &[(u16, u16)] {
            &[(0, 0)]
        }
        #[inline]
        fn jacobian_pattern(&self) -> &[(u16, u16)] {
            &[]
        }
        type Mass = Mass<R>;
        type Jacobian = Jacobian<R>;
        type Inputs = ();
        #[inline]
        fn input_names(&self) -> &'static [&'static str] {
            <() as Fields<R>>::NAMES
        }
        type Outputs = Outputs<R>;
        #[inline]
        fn output_names(&self) -> &'static [&'static str] {
            <Outputs<R> as Fields<R>>::NAMES
        }
        fn mass_matrix(&self, time: R, q: &Q<R>, out: &mut Mass<R>) {
            // M(t, q): its stored entries (kg, kg m, kg m²).
            *out = [R::ONE];
        }
        fn constraints(&self, time: R, q: &Q<R>, out: &mut Lambda<R>) {
            // Φ(t, q) of each row (m, or 1 for directions and angles).
            *out = [];
        }
        fn constraint_jacobian(&self, time: R, q: &Q<R>, out: &mut Jacobian<R>) {
            // D(t, q), Φ̇ = D v − ν: its stored entries.
            *out = [];
        }
        fn nu(&self, time: R, q: &Q<R>, out: &mut Lambda<R>) {
            // ν(t, q) = −∂Φ/∂t, the right-hand side of D v = ν.
            *out = [];
        }
        fn gamma(&self, time: R, q: &Q<R>, v: &V<R>, out: &mut Lambda<R>) {
            // γ(t, q, v), the right-hand side of D v̇ = γ.
            *out = [];
        }
        fn forces(&self, time: R, state: &State<Q<R>, V<R>>, u: &(), out: &mut V<R>) {
            // Q(t, q, v, u): loads, gravity and gyroscopic forces of M v̇ + Dᵀ λ = Q (N or N m).
            // 1 operation.
            let arm_cos = state.q[0];
            let force_arm_rate = R::from_f64(-9.81) * arm_cos;
            *out = [force_arm_rate];
        }
        fn kinetic_energy(&self, time: R, q: &Q<R>, v: &V<R>) -> R {
            // T(t, q, v) (J).
            // 5 operations.
            let arm_cos = q[0];
            let arm_sin = q[1];
            let arm_rate = v[0];
            let a0 = arm_sin * arm_rate;
            let a1 = a0 * a0;
            let a2 = arm_cos * arm_rate;
            let a3 = a2.mul_add(a2, a1);
            let a4 = R::from_f64(0.5) * a3;
            a4
        }
        fn potential_energy(&self, time: R, state: &State<Q<R>, V<R>>) -> R {
            // V(t, q) of gravity and springs (J).
            // 1 operation.
            let arm_sin = state.q[1];
            let a0 = R::from_f64(9.81) * arm_sin;
            a0
        }
        #[inline(always)]
        fn acceleration(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &(),
            a_out: &mut V<R>,
            lambda_out: &mut Lambda<R>,
        ) -> R {
            // v̇ and λ of M v̇ + Dᵀ λ = Q, D v̇ = γ; the smallest relative pivot.
            // 1 operation.
            let arm_cos = state.q[0];
            let arm_rate_dot = R::from_f64(-9.81) * arm_cos;
            *a_out = [arm_rate_dot];
            *lambda_out = [];
            R::ONE
        }
        fn acceleration_baumgarte(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &(),
            two_alpha: R,
            beta_squared: R,
            a_out: &mut V<R>,
            lambda_out: &mut Lambda<R>,
        ) -> R {
            <Self as Mechanism<R>>::acceleration(self, time, state, u, a_out, lambda_out)
        }
        fn outputs(&self, time: R, state: &State<Q<R>, V<R>>, u: &()) -> Outputs<R> {
            // The outputs of the definition, in SI units.
            let arm_cos = state.q[0];
            let arm_sin = state.q[1];
            SimplePendulumOutputs {
                x: arm_cos,
                y: arm_sin,
            }
        }
        fn internal_rates(
            &self,
            _time: R,
            _state: &State<Q<R>, V<R>>,
            _u: &(),
            _a: &V<R>,
            _lambda: &Lambda<R>,
            _rates: &mut (),
        ) {}
        fn unwrap(&self, outputs: &mut Outputs<R>, previous: &Outputs<R>) {}
    }
    impl<R: Real> Report<R> for SimplePendulum<R> {
        type Motion = BodyMotion<R>;
        type Motions = [BodyMotion<R>; 1];
        type Reaction = Reaction<R>;
        type Reactions = [Reaction<R>; 1];
        type Powers = [R; 0];
        type Efforts = [[R; 2]; 0];
    }
    impl<R: Real> Assemble<R> for SimplePendulum<R> {
        #[inline]
        fn conditions(&self) -> &[Condition] {
            &[
                Condition {
                    of: "pivot.angle",
                    kind: ConditionKind::Angle,
                },
            ]
        }
        #[inline]
        fn start_conditions(&self) -> &[u16] {
            &[0]
        }
        #[inline]
        fn start_rates(&self) -> &[u16] {
            &[0]
        }
        #[inline]
        fn independent(&self) -> &[u16] {
            &[0]
        }
        #[inline]
        fn flips(&self) -> &[Flips<'_>] {
            &[]
        }
        #[inline]
        fn condition_pattern(&self) -> &[(u16, u16)] {
            &[(0, 0)]
        }
        #[inline]
        fn elimination(&self) -> Elimination<'_> {
            Elimination {
                order: &[0, 1],
                position: &[0, 1],
                row_start: &[0, 0, 1],
                columns: &[0],
            }
        }
        type Conditions = Conditions<R>;
        type ConditionJacobian = ConditionJacobian<R>;
        type Factor = Factor<R>;
        type System = System<R>;
        type Dense = Dense<R>;
        type Basis = Basis<R>;
        type Reduced = Reduced<R>;
        type Choice = [u16; 1];
        fn choice(&self) -> [u16; 1] {
            [0; 1]
        }
        fn row_cosines(&self, time: R, q: &Q<R>, out: &mut Lambda<R>) {
            // Of each row that fixes a direction the cosine that tells it from its opposite; 1 of others.
            *out = [];
        }
        fn condition_residual(
            &self,
            time: R,
            q: &Q<R>,
            target: &Conditions<R>,
            out: &mut Conditions<R>,
        ) {
            // What each condition of the start is off its target by, as a length or a sine.
            // 4 operations.
            let arm_cos = q[0];
            let arm_sin = q[1];
            let target_pivot_angle = target[0];
            let a0 = target_pivot_angle.cos();
            let a1 = arm_sin * a0;
            let a2 = target_pivot_angle.sin();
            let a3 = (-arm_cos).mul_add(a2, a1);
            *out = [a3];
        }
        fn condition_jacobian(&self, time: R, q: &Q<R>, out: &mut ConditionJacobian<R>) {
            // J(t, q), the rate of a condition being J v + b: its stored entries.
            *out = [R::ONE];
        }
        fn condition_bias(&self, time: R, q: &Q<R>, v: &V<R>, out: &mut Conditions<R>) {
            // The rate of J v + b where v̇ = 0.
            *out = [R::ZERO];
        }
        fn start_targets(
            &self,
            positions: &mut Conditions<R>,
            rates: &mut Conditions<R>,
        ) {
            // Values, and rates, that `start` asks of each condition; 0 where it asks none.
            *positions = [R::from_f64(3.141592653589793)];
            *rates = [R::ZERO];
        }
        fn row_scales(&self, out: &mut Lambda<R>) {
            // Sᵢ of each row, twice the largest Dᵢ M⁻¹ Dᵢᵀ along the motion (1/kg or 1/(kg m²)): what pivots of rows are measured by.
            *out = [];
        }
        type Store = tabled::Store<R, Self>;
        fn store(&self) -> Self::Store {
            tabled::store::<R, Self>(self)
        }
        fn factor(
            &self,
            time: R,
            q: &Q<R>,
            compliance: R,
            store: &mut Self::Store,
        ) -> R {
            tabled::factor::<R, Self>(self, time, q, compliance, store)
        }
        fn solve(
            &self,
            store: &Self::Store,
            forces: &V<R>,
            rows: &Lambda<R>,
            a: &mut V<R>,
            lambda: &mut Lambda<R>,
        ) {
            tabled::solve::<R, Self>(self, store, forces, rows, a, lambda)
        }
        type Lu = ();
        fn lu(&self) {}
        fn row_sizes(&self) -> Lambda<R> {
            []
        }
        fn start_q(&self) -> Q<R> {
            [R::from_f64(-1.0), R::from_f64(1.2246467991473532e-16)]
        }
        fn start_v(&self) -> V<R> {
            [R::ZERO]
        }
        fn start_internal(&self) {}
        fn start_gates(&self) {}
    }
};
const _: ::core::option::Option<&'static ::core::primitive::str> = ::core::option_env!(
    "LINKWRIGHT_SELF_CHECK"
);
