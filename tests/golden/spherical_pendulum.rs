// `SphericalPendulum` of models/src/spatial_pendulums.rs.
// Left out: acceleration_baumgarte, choice, condition_bias, condition_cosines, condition_drift, condition_jacobian, condition_pattern, condition_residual, conditions, constraint_jacobian, constraints, default, driver_efforts, elimination, factor, fingerprint, flips, from, from_array, gamma, independent, input_names, internal_rates, inverse_dynamics, jacobian_pattern, layout, lu, mass_pattern, name, nu, output_names, outputs, parameters, position_names, positions, potential_energy, powers, prepare, row_cosines, row_scales, row_sizes, rows, solve, start_conditions, start_gates, start_internal, start_q, start_rates, start_targets, start_v, store, to_array, unwrap, velocities, velocity_names, with, zip.
/// Bar on a spherical joint (Spherical_Case01), released from the horizontal.
///
///Equations of motion of the spatial mechanism `SphericalPendulum`.
#[cfg_attr(
    doc,
    doc = ::linkwright::__private::v1::mechanism_page!{#[doc = " Bar on a spherical joint (Spherical_Case01), released from the horizontal."]pub
    spatial
    SphericalPendulum{gravity[m/s^2]= (0, 0, -9.80665);body
    bar{mass[kg]= 1;inertia[kg*m^2]= (0.04, 0.1, 0.1);center[m]= (2, 0, 0);}joint
    pivot:spherical(
        ground(0, 0, 0)[m],
        bar.origin
    );start{bar.orientation = (
        1,
        0,
        0,
        0
    );bar.rate.x[rad/s]= 0;bar.rate.y[rad/s]= 0;bar.rate.z[rad/s]= 0;}expect{degrees_of_freedom = 3;}output
    x[m]= bar.center.x;output
    y[m]= bar.center.y;output
    z[m]= bar.center.z;output
    velocity_x[m/s]= bar.center.velocity.x;output
    velocity_y[m/s]= bar.center.velocity.y;output
    velocity_z[m/s]= bar.center.velocity.z;}}
)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct SphericalPendulum<R = ::core::primitive::f64> {
    parameters: SphericalPendulumParameters<R>,
    phases: [R; 0],
    constants: [R; 0],
}
///Parameters of [`SphericalPendulum`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct SphericalPendulumParameters<R = ::core::primitive::f64> {
    #[doc(hidden)]
    pub scalar: ::core::marker::PhantomData<R>,
}
///Outputs of [`SphericalPendulum`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct SphericalPendulumOutputs<R = ::core::primitive::f64> {
    ///In `m`.
    pub x: R,
    ///In `m`.
    pub y: R,
    ///In `m`.
    pub z: R,
    ///In `m/s`.
    pub velocity_x: R,
    ///In `m/s`.
    pub velocity_y: R,
    ///In `m/s`.
    pub velocity_z: R,
}
///Positions and velocities of [`SphericalPendulum`].
pub type SphericalPendulumState<R = ::core::primitive::f64> = ::linkwright::__private::v1::State<
    [R; 4],
    [R; 3],
>;
///Positions of [`SphericalPendulum`] by name; [`From`] and [`Into`] the array of a state.
#[allow(dead_code)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct SphericalPendulumPositions<R = ::core::primitive::f64> {
    ///A unit quaternion (w, x, y, z).
    pub pivot_orientation: [R; 4],
}
///Velocities of [`SphericalPendulum`] by name; [`From`] and [`Into`] the array of a state.
#[allow(dead_code)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct SphericalPendulumVelocities<R = ::core::primitive::f64> {
    ///ω along the turned axes, rad/s.
    pub pivot_rate: [R; 3],
}
#[allow(clippy::all)]
impl SphericalPendulum<::core::primitive::f64> {
    ///Consistent start state for the default parameters, assembled at compile time.
    pub const START: SphericalPendulumState = ::linkwright::__private::v1::State::new(
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
    );
    ///Degrees of freedom, drivers removed.
    pub const DEGREES_OF_FREEDOM: ::core::primitive::usize = 3;
    ///Operations of the default acceleration function (Baumgarte), a fused multiply-add counted once.
    pub const OPERATIONS: ::core::primitive::usize = 15;
    ///The definition as written.
    pub const SOURCE: &'static ::core::primitive::str = (
        "# [doc = \" Bar on a spherical joint (Spherical_Case01), released from the horizontal.\"] pub spatial SphericalPendulum { gravity [m / s ^ 2] = (0 , 0 , - 9.80665) ; body bar { mass [kg] = 1 ; inertia [kg * m ^ 2] = (0.04 , 0.1 , 0.1) ; center [m] = (2 , 0 , 0) ; } joint pivot : spherical (ground (0 , 0 , 0) [m] , bar . origin) ; start { bar . orientation = (1 , 0 , 0 , 0) ; bar . rate . x [rad / s] = 0 ; bar . rate . y [rad / s] = 0 ; bar . rate . z [rad / s] = 0 ; } expect { degrees_of_freedom = 3 ; } output x [m] = bar . center . x ; output y [m] = bar . center . y ; output z [m] = bar . center . z ; output velocity_x [m / s] = bar . center . velocity . x ; output velocity_y [m / s] = bar . center . velocity . y ; output velocity_z [m / s] = bar . center . velocity . z ; }",
    )
        .0;
    ///The definition as versioned JSON: kinds, shapes and units as written.
    pub const DEFINITION: &'static ::core::primitive::str = (
        "{\"linkwright\":1,\"kind\":\"spatial\",\"name\":\"SphericalPendulum\",\"constants\":[],\"parameters\":[],\"inputs\":[],\"gravity\":{\"unit\":\"m/s^2\",\"value\":[{\"number\":\"0\"},{\"number\":\"0\"},{\"op\":\"neg\",\"args\":[{\"number\":\"9.80665\"}]}]},\"markers\":[],\"bodies\":[{\"name\":\"bar\",\"kind\":\"body\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"number\":\"1\"}}},\"vectors\":{\"inertia\":{\"unit\":\"kg*m^2\",\"value\":[{\"number\":\"0.04\"},{\"number\":\"0.1\"},{\"number\":\"0.1\"}]}},\"inertia_axes\":null,\"markers\":[],\"center\":{\"unit\":\"m\",\"value\":[{\"number\":\"2\"},{\"number\":\"0\"},{\"number\":\"0\"}]},\"points\":[],\"lines\":[]}],\"joints\":[{\"name\":\"pivot\",\"kind\":\"spherical\",\"first\":{\"ground\":[{\"number\":\"0\"},{\"number\":\"0\"},{\"number\":\"0\"}],\"unit\":\"m\"},\"second\":{\"place\":\"bar.origin\"}}],\"constraints\":[],\"drivers\":[],\"loads\":[],\"start\":[{\"quantity\":{\"name\":\"bar.rate.x\"},\"exact\":true,\"unit\":\"rad/s\",\"value\":{\"number\":\"0\"}},{\"quantity\":{\"name\":\"bar.rate.y\"},\"exact\":true,\"unit\":\"rad/s\",\"value\":{\"number\":\"0\"}},{\"quantity\":{\"name\":\"bar.rate.z\"},\"exact\":true,\"unit\":\"rad/s\",\"value\":{\"number\":\"0\"}}],\"orientations\":[{\"quantity\":{\"name\":\"bar.orientation\"},\"exact\":true,\"unit\":null,\"value\":[{\"number\":\"1\"},{\"number\":\"0\"},{\"number\":\"0\"},{\"number\":\"0\"}]}],\"outputs\":[{\"name\":\"x\",\"unit\":\"m\",\"value\":{\"name\":\"bar.center.x\"}},{\"name\":\"y\",\"unit\":\"m\",\"value\":{\"name\":\"bar.center.y\"}},{\"name\":\"z\",\"unit\":\"m\",\"value\":{\"name\":\"bar.center.z\"}},{\"name\":\"velocity_x\",\"unit\":\"m/s\",\"value\":{\"name\":\"bar.center.velocity.x\"}},{\"name\":\"velocity_y\",\"unit\":\"m/s\",\"value\":{\"name\":\"bar.center.velocity.y\"}},{\"name\":\"velocity_z\",\"unit\":\"m/s\",\"value\":{\"name\":\"bar.center.velocity.z\"}}],\"options\":{},\"expect\":{\"degrees_of_freedom\":3}}",
    )
        .0;
    ///What the entries of q and v and the constraint rows are, as JSON.
    pub const COORDINATES: &'static ::core::primitive::str = (
        "{\"coordinates\":\"tree\",\"tree\":[{\"body\":\"bar\",\"joint\":\"pivot\",\"parent\":\"ground\"}],\"linear\":[],\"rotations\":[],\"quaternions\":[{\"joint\":\"pivot\"}],\"angles\":[],\"rows\":[]}",
    )
        .0;
    ///Names of the bodies, in the order of `motions`.
    pub const BODIES: &'static [&'static ::core::primitive::str] = &["bar"];
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
    type Q<R> = [R; 4];
    type V<R> = [R; 3];
    type Lambda<R> = [R; 0];
    type Mass<R> = [R; 3];
    type Jacobian<R> = [R; 0];
    type Conditions<R> = [R; 6];
    type ConditionJacobian<R> = [R; 12];
    type Factor<R> = [R; 24];
    type System<R> = [R; 9];
    type Dense<R> = [R; 0];
    type Basis<R> = [R; 9];
    type Reduced<R> = [R; 9];
    type Parameters<R> = SphericalPendulumParameters<R>;
    type Outputs<R> = SphericalPendulumOutputs<R>;
    impl<R: Real> Fields<R> for Parameters<R> {
        const NAMES: &'static [&'static str] = &[];
        type Array = [R; 0];
    }
    impl<R: Real> Fields<R> for Outputs<R> {
        const NAMES: &'static [&'static str] = &[
            "x",
            "y",
            "z",
            "velocity_x",
            "velocity_y",
            "velocity_z",
        ];
        type Array = [R; 6];
    }
    impl<R: Real> From<Q<R>> for SphericalPendulumPositions<R> {}
    impl<R: Real> From<SphericalPendulumPositions<R>> for Q<R> {}
    impl<R: Real> From<V<R>> for SphericalPendulumVelocities<R> {}
    impl<R: Real> From<SphericalPendulumVelocities<R>> for V<R> {}
    impl<R: Real> Default for Parameters<R> {}
    impl<R: Real> Default for SphericalPendulum<R> {}
    impl<R: Real> SphericalPendulum<R> {
        /// Position, velocity and acceleration of every body's centre of mass, in the order of `BODIES`,
        /// from a state and its accelerations.
        pub fn motions(
            &self,
            time: R,
            q: &Q<R>,
            v: &V<R>,
            a: &V<R>,
        ) -> [SpatialMotion<R>; 1] {
            // 46 operations.
            let pivot_orientation_w = q[0];
            let pivot_orientation_x = q[1];
            let pivot_orientation_y = q[2];
            let pivot_orientation_z = q[3];
            let pivot_rate_x = v[0];
            let pivot_rate_y = v[1];
            let pivot_rate_z = v[2];
            let pivot_rate_x_dot = a[0];
            let pivot_rate_y_dot = a[1];
            let pivot_rate_z_dot = a[2];
            let a0 = R::from_f64(2.0) * pivot_orientation_z;
            let a1 = pivot_orientation_z * a0;
            let a2 = R::from_f64(2.0) * pivot_orientation_y;
            let a3 = pivot_orientation_y * a2;
            let a4 = a3 + a1;
            let a5 = R::ONE - a4;
            let a6 = R::from_f64(2.0) * a5;
            let a7 = pivot_orientation_x * a2;
            let a8 = pivot_orientation_w.mul_add(a0, a7);
            let a9 = R::from_f64(2.0) * a8;
            let a10 = pivot_orientation_x * a0;
            let a11 = (-pivot_orientation_w).mul_add(a2, a10);
            let a12 = R::from_f64(2.0) * a11;
            let a13 = (-pivot_orientation_w).mul_add(a0, a7);
            let a14 = pivot_orientation_w.mul_add(a2, a10);
            let a15 = R::from_f64(2.0) * pivot_orientation_x;
            let a16 = (-pivot_orientation_x).mul_add(a15, R::ONE);
            let a17 = a16 - a1;
            let a18 = pivot_orientation_y * a0;
            let a19 = (-pivot_orientation_w).mul_add(a15, a18);
            let a20 = pivot_orientation_w.mul_add(a15, a18);
            let a21 = a16 - a3;
            let a22 = R::from_f64(2.0) * pivot_rate_z;
            let a23 = a13 * a22;
            let a24 = R::from_f64(2.0) * pivot_rate_y;
            let a25 = (-a14).mul_add(a24, a23);
            let a26 = a17 * a22;
            let a27 = (-a19).mul_add(a24, a26);
            let a28 = a20 * a22;
            let a29 = (-a21).mul_add(a24, a28);
            let a30 = pivot_rate_x.mul_add(pivot_rate_y, pivot_rate_z_dot);
            let a31 = R::from_f64(2.0) * a30;
            let a32 = a13 * a31;
            let a33 = pivot_rate_x.mul_add(pivot_rate_z, -pivot_rate_y_dot);
            let a34 = R::from_f64(2.0) * a33;
            let a35 = a14.mul_add(a34, a32);
            let a36 = pivot_rate_z * pivot_rate_z;
            let a37 = pivot_rate_y.mul_add(pivot_rate_y, a36);
            let a38 = R::from_f64(2.0) * a37;
            let a39 = (-a5).mul_add(a38, a35);
            let a40 = a17 * a31;
            let a41 = a19.mul_add(a34, a40);
            let a42 = (-a8).mul_add(a38, a41);
            let a43 = a20 * a31;
            let a44 = a21.mul_add(a34, a43);
            let a45 = (-a11).mul_add(a38, a44);
            [
                SpatialMotion {
                    position: [a6, a9, a12],
                    orientation: [[a5, a13, a14], [a8, a17, a19], [a11, a20, a21]],
                    velocity: [a25, a27, a29],
                    rate: [pivot_rate_x, pivot_rate_y, pivot_rate_z],
                    acceleration: [a39, a42, a45],
                    angular_acceleration: [
                        pivot_rate_x_dot,
                        pivot_rate_y_dot,
                        pivot_rate_z_dot,
                    ],
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
        ) -> [SpatialReaction<R>; 1] {
            // 65 operations.
            let pivot_orientation_w = state.q[0];
            let pivot_orientation_x = state.q[1];
            let pivot_orientation_y = state.q[2];
            let pivot_orientation_z = state.q[3];
            let pivot_rate_x = state.v[0];
            let pivot_rate_y = state.v[1];
            let pivot_rate_z = state.v[2];
            let pivot_rate_x_dot = a[0];
            let pivot_rate_y_dot = a[1];
            let pivot_rate_z_dot = a[2];
            let a0 = pivot_rate_x.mul_add(pivot_rate_y, pivot_rate_z_dot);
            let a1 = R::from_f64(2.0) * a0;
            let a2 = R::from_f64(2.0) * pivot_orientation_y;
            let a3 = pivot_orientation_x * a2;
            let a4 = R::from_f64(2.0) * pivot_orientation_z;
            let a5 = (-pivot_orientation_w).mul_add(a4, a3);
            let a6 = a5 * a1;
            let a7 = pivot_rate_x.mul_add(pivot_rate_z, -pivot_rate_y_dot);
            let a8 = R::from_f64(2.0) * a7;
            let a9 = pivot_orientation_x * a4;
            let a10 = pivot_orientation_w.mul_add(a2, a9);
            let a11 = a10.mul_add(a8, a6);
            let a12 = pivot_rate_z * pivot_rate_z;
            let a13 = pivot_rate_y.mul_add(pivot_rate_y, a12);
            let a14 = R::from_f64(2.0) * a13;
            let a15 = pivot_orientation_z * a4;
            let a16 = pivot_orientation_y * a2;
            let a17 = a16 + a15;
            let a18 = R::ONE - a17;
            let a19 = (-a18).mul_add(a14, a11);
            let a20 = R::from_f64(2.0) * pivot_orientation_x;
            let a21 = (-pivot_orientation_x).mul_add(a20, R::ONE);
            let a22 = a21 - a15;
            let a23 = a22 * a1;
            let a24 = pivot_orientation_y * a4;
            let a25 = (-pivot_orientation_w).mul_add(a20, a24);
            let a26 = a25.mul_add(a8, a23);
            let a27 = pivot_orientation_w.mul_add(a4, a3);
            let a28 = (-a27).mul_add(a14, a26);
            let a29 = pivot_orientation_w.mul_add(a20, a24);
            let a30 = a29.mul_add(a1, R::from_f64(9.80665));
            let a31 = a21 - a16;
            let a32 = a31.mul_add(a8, a30);
            let a33 = (-pivot_orientation_w).mul_add(a2, a9);
            let a34 = (-a33).mul_add(a14, a32);
            let a35 = R::from_f64(0.1) * pivot_rate_y_dot;
            let a36 = R::from_f64(0.04) * pivot_rate_x;
            let a37 = pivot_rate_z.mul_add(a36, a35);
            let a38 = R::from_f64(0.1) * pivot_rate_z;
            let a39 = (-pivot_rate_x).mul_add(a38, a37);
            let a40 = a5 * a39;
            let a41 = R::from_f64(0.1) * pivot_rate_z_dot;
            let a42 = (-pivot_rate_y).mul_add(a36, a41);
            let a43 = R::from_f64(0.1) * pivot_rate_y;
            let a44 = pivot_rate_x.mul_add(a43, a42);
            let a45 = a10.mul_add(a44, a40);
            let a46 = R::from_f64(0.04) * pivot_rate_x_dot;
            let a47 = (-pivot_rate_z).mul_add(a43, a46);
            let a48 = pivot_rate_y.mul_add(a38, a47);
            let a49 = a18.mul_add(a48, a45);
            let a50 = R::from_f64(2.0) * a33;
            let a51 = (-a50).mul_add(a28, a49);
            let a52 = R::from_f64(2.0) * a27;
            let a53 = a52.mul_add(a34, a51);
            let a54 = a27 * a48;
            let a55 = a22.mul_add(a39, a54);
            let a56 = a25.mul_add(a44, a55);
            let a57 = a50.mul_add(a19, a56);
            let a58 = R::from_f64(2.0) * a18;
            let a59 = (-a58).mul_add(a34, a57);
            let a60 = a33 * a48;
            let a61 = a29.mul_add(a39, a60);
            let a62 = a31.mul_add(a44, a61);
            let a63 = (-a52).mul_add(a19, a62);
            let a64 = a58.mul_add(a28, a63);
            [
                SpatialReaction {
                    force: [a19, a28, a34],
                    torque: [a53, a59, a64],
                },
            ]
        }
    }
    impl<R: Real> Parametric<R> for SphericalPendulum<R> {
        type Parameters = Parameters<R>;
    }
    impl<S> InScalars for SphericalPendulum<S> {
        type In<R: Real> = SphericalPendulum<R>;
    }
    impl<R: Real> Variables<R> for SphericalPendulum<R> {
        type Q = Q<R>;
        type V = V<R>;
        type Lambda = Lambda<R>;
        type Z = ();
        type Gates = ();
    }
    impl<R: Real> Mechanism<R> for SphericalPendulum<R> {
        type Mass = Mass<R>;
        type Jacobian = Jacobian<R>;
        type Inputs = ();
        type Outputs = Outputs<R>;
        fn mass_matrix(&self, time: R, q: &Q<R>, out: &mut Mass<R>) {
            // M(t, q): its stored entries (kg, kg m, kg m²).
            *out = [R::from_f64(0.04), R::from_f64(4.1), R::from_f64(4.1)];
        }
        fn forces(&self, time: R, state: &State<Q<R>, V<R>>, u: &(), out: &mut V<R>) {
            // Q(t, q, v, u): loads, gravity and gyroscopic forces of M v̇ + Dᵀ λ = Q (N or N m).
            // 13 operations.
            let pivot_orientation_w = state.q[0];
            let pivot_orientation_x = state.q[1];
            let pivot_orientation_y = state.q[2];
            let pivot_orientation_z = state.q[3];
            let pivot_rate_x = state.v[0];
            let pivot_rate_y = state.v[1];
            let pivot_rate_z = state.v[2];
            let a0 = pivot_rate_x * pivot_rate_z;
            let a1 = R::from_f64(4.06) * a0;
            let a2 = R::from_f64(2.0) * pivot_orientation_x;
            let a3 = (-pivot_orientation_x).mul_add(a2, R::ONE);
            let a4 = R::from_f64(2.0) * pivot_orientation_y;
            let a5 = (-pivot_orientation_y).mul_add(a4, a3);
            let force_pivot_rate_y = R::from_f64(19.6133).mul_add(a5, a1);
            let a7 = pivot_rate_x * pivot_rate_y;
            let a8 = R::from_f64(4.06) * a7;
            let a9 = pivot_orientation_w * a2;
            let a10 = R::from_f64(2.0) * pivot_orientation_z;
            let a11 = pivot_orientation_y.mul_add(a10, a9);
            let force_pivot_rate_z = R::from_f64(-19.6133).mul_add(a11, -a8);
            *out = [R::ZERO, force_pivot_rate_y, force_pivot_rate_z];
        }
        fn kinetic_energy(&self, time: R, q: &Q<R>, v: &V<R>) -> R {
            // T(t, q, v) (J).
            // 6 operations.
            let pivot_rate_x = v[0];
            let pivot_rate_y = v[1];
            let pivot_rate_z = v[2];
            let a0 = R::from_f64(0.04) * pivot_rate_x;
            let a1 = pivot_rate_x * a0;
            let a2 = pivot_rate_z * pivot_rate_z;
            let a3 = pivot_rate_y.mul_add(pivot_rate_y, a2);
            let a4 = R::from_f64(4.1).mul_add(a3, a1);
            let a5 = R::from_f64(0.5) * a4;
            a5
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
            // 15 operations.
            let pivot_orientation_w = state.q[0];
            let pivot_orientation_x = state.q[1];
            let pivot_orientation_y = state.q[2];
            let pivot_orientation_z = state.q[3];
            let pivot_rate_x = state.v[0];
            let pivot_rate_y = state.v[1];
            let pivot_rate_z = state.v[2];
            let a0 = pivot_rate_x * pivot_rate_z;
            let a1 = R::from_f64(4.06) * a0;
            let a2 = R::from_f64(2.0) * pivot_orientation_x;
            let a3 = (-pivot_orientation_x).mul_add(a2, R::ONE);
            let a4 = R::from_f64(2.0) * pivot_orientation_y;
            let a5 = (-pivot_orientation_y).mul_add(a4, a3);
            let a6 = R::from_f64(19.6133).mul_add(a5, a1);
            let pivot_rate_y_dot = R::from_f64(0.24390243902439027) * a6;
            let a8 = pivot_rate_x * pivot_rate_y;
            let a9 = R::from_f64(4.06) * a8;
            let a10 = pivot_orientation_w * a2;
            let a11 = R::from_f64(2.0) * pivot_orientation_z;
            let a12 = pivot_orientation_y.mul_add(a11, a10);
            let a13 = R::from_f64(19.6133).mul_add(a12, a9);
            let pivot_rate_z_dot = R::from_f64(-0.24390243902439027) * a13;
            *a_out = [R::ZERO, pivot_rate_y_dot, pivot_rate_z_dot];
            *lambda_out = [];
            R::ONE
        }
    }
    impl<R: Real> Report<R> for SphericalPendulum<R> {
        type Motion = SpatialMotion<R>;
        type Motions = [SpatialMotion<R>; 1];
        type Reaction = SpatialReaction<R>;
        type Reactions = [SpatialReaction<R>; 1];
        type Powers = [R; 0];
        type Efforts = [[R; 2]; 0];
    }
    impl<R: Real> Assemble<R> for SphericalPendulum<R> {
        type Conditions = Conditions<R>;
        type ConditionJacobian = ConditionJacobian<R>;
        type Factor = Factor<R>;
        type System = System<R>;
        type Dense = Dense<R>;
        type Basis = Basis<R>;
        type Reduced = Reduced<R>;
        type Choice = [u16; 3];
        type Store = tabled::Store<R, Self>;
        type Lu = ();
    }
};
const _: ::core::option::Option<&'static ::core::primitive::str> = ::core::option_env!(
    "LINKWRIGHT_SELF_CHECK"
);
