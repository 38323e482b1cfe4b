// `FourBar` of models/src/four_bar.rs.
// Left out: acceleration, choice, condition_bias, condition_cosines, condition_drift, condition_jacobian, condition_pattern, condition_residual, conditions, constraints, default, dependent, driver_efforts, elimination, factor, fingerprint, flips, forces, from, from_array, independent, input_names, internal_rates, inverse_dynamics, jacobian_pattern, kinetic_energy, layout, lu, mass_matrix, mass_pattern, motions, name, nu, null_space, null_space_first, output_names, parameters, position_names, positions, potential_energy, powers, prepare, row_cosines, row_scales, row_sizes, rows, solve, start_conditions, start_gates, start_internal, start_q, start_rates, start_targets, start_v, store, to_array, unwrap, velocities, velocity_names, with, zip.
/// Four-bar of unit rods (IFToMM A02 with one window).
///
/// Three uniform rods of 1 m and 1 kg, g = 9.81 m/s², cranks upright and turning at −1 rad/s. The cranks move as a
/// pendulum with θ̈ = −(6/5)(g/L) cos θ.
///
///Equations of motion of the planar mechanism `FourBar`.
#[cfg_attr(
    doc,
    doc = ::linkwright::__private::v1::mechanism_page!{#[doc = " Four-bar of unit rods (IFToMM A02 with one window)."]#[doc = ""]#[doc = " Three uniform rods of 1 m and 1 kg, g = 9.81 m/s², cranks upright and turning at −1 rad/s. The cranks move as a"]#[doc = " pendulum with θ\u{308} = −(6/5)(g/L) cos θ."]pub
    planar
    FourBar{gravity[m/s^2]= (0, -9.81);rod
    crank{mass[kg]= 1;length[m]= 1;}rod
    coupler{mass[kg]= 1;length[m]= 1;}rod
    rocker{mass[kg]= 1;length[m]= 1;}joint
    crank_pin:revolute(ground(0, 0)[m], crank.start);joint
    rocker_pin:revolute(ground(1, 0)[m], rocker.start);joint
    left:revolute(crank.end, coupler.start);joint
    right:revolute(
        coupler.end,
        rocker.end
    );start{crank_pin.angle[deg]= 90;crank_pin.rate[rad/s]= -1;rocker_pin.angle[deg]~90;coupler.angle[rad]~0;}expect{degrees_of_freedom = 1;operations<= 100;}output
    x[m]= crank.end.x;output
    angle[rad]= rocker_pin.angle;}}
)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct FourBar<R = ::core::primitive::f64> {
    parameters: FourBarParameters<R>,
    phases: [R; 0],
    constants: [R; 0],
}
///Parameters of [`FourBar`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct FourBarParameters<R = ::core::primitive::f64> {
    #[doc(hidden)]
    pub scalar: ::core::marker::PhantomData<R>,
}
///Outputs of [`FourBar`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct FourBarOutputs<R = ::core::primitive::f64> {
    ///In `m`.
    pub x: R,
    ///In `rad`.
    pub angle: R,
}
///Positions and velocities of [`FourBar`].
pub type FourBarState<R = ::core::primitive::f64> = ::linkwright::__private::v1::State<
    [R; 6],
    [R; 3],
>;
///Positions of [`FourBar`] by name; [`From`] and [`Into`] the array of a state.
#[allow(dead_code)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct FourBarPositions<R = ::core::primitive::f64> {
    ///rad, by its cosine and sine.
    pub crank_angle: ::linkwright::__private::v1::Angle<R>,
    ///rad, by its cosine and sine.
    pub rocker_angle: ::linkwright::__private::v1::Angle<R>,
    ///rad, by its cosine and sine.
    pub coupler_angle: ::linkwright::__private::v1::Angle<R>,
}
///Velocities of [`FourBar`] by name; [`From`] and [`Into`] the array of a state.
#[allow(dead_code)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct FourBarVelocities<R = ::core::primitive::f64> {
    ///rad/s.
    pub crank_rate: R,
    ///rad/s.
    pub rocker_rate: R,
    ///rad/s.
    pub coupler_rate: R,
}
#[allow(clippy::all)]
impl FourBar<::core::primitive::f64> {
    ///Consistent start state for the default parameters, assembled at compile time.
    pub const START: FourBarState = ::linkwright::__private::v1::State::new(
        [6.123233995736766e-17, 1.0, 6.123233995736766e-17, 1.0, 1.0, 0.0],
        [-1.0, -1.0, 0.0],
    );
    ///Degrees of freedom, drivers removed.
    pub const DEGREES_OF_FREEDOM: ::core::primitive::usize = 1;
    ///Operations of the default acceleration function (Baumgarte), a fused multiply-add counted once.
    pub const OPERATIONS: ::core::primitive::usize = 62;
    ///The definition as written.
    pub const SOURCE: &'static ::core::primitive::str = (
        "# [doc = \" Four-bar of unit rods (IFToMM A02 with one window).\"] # [doc = \"\"] # [doc = \" Three uniform rods of 1 m and 1 kg, g = 9.81 m/s², cranks upright and turning at −1 rad/s. The cranks move as a\"] # [doc = \" pendulum with θ\\u{308} = −(6/5)(g/L) cos θ.\"] pub planar FourBar { gravity [m / s ^ 2] = (0 , - 9.81) ; rod crank { mass [kg] = 1 ; length [m] = 1 ; } rod coupler { mass [kg] = 1 ; length [m] = 1 ; } rod rocker { mass [kg] = 1 ; length [m] = 1 ; } joint crank_pin : revolute (ground (0 , 0) [m] , crank . start) ; joint rocker_pin : revolute (ground (1 , 0) [m] , rocker . start) ; joint left : revolute (crank . end , coupler . start) ; joint right : revolute (coupler . end , rocker . end) ; start { crank_pin . angle [deg] = 90 ; crank_pin . rate [rad / s] = - 1 ; rocker_pin . angle [deg] ~ 90 ; coupler . angle [rad] ~ 0 ; } expect { degrees_of_freedom = 1 ; operations <= 100 ; } output x [m] = crank . end . x ; output angle [rad] = rocker_pin . angle ; }",
    )
        .0;
    ///The definition as versioned JSON: kinds, shapes and units as written.
    pub const DEFINITION: &'static ::core::primitive::str = (
        "{\"linkwright\":1,\"kind\":\"planar\",\"name\":\"FourBar\",\"constants\":[],\"parameters\":[],\"inputs\":[],\"gravity\":{\"unit\":\"m/s^2\",\"value\":[{\"number\":\"0\"},{\"op\":\"neg\",\"args\":[{\"number\":\"9.81\"}]}]},\"bodies\":[{\"name\":\"crank\",\"kind\":\"rod\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"number\":\"1\"}},\"length\":{\"unit\":\"m\",\"value\":{\"number\":\"1\"}}},\"center\":null,\"points\":[],\"lines\":[]},{\"name\":\"coupler\",\"kind\":\"rod\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"number\":\"1\"}},\"length\":{\"unit\":\"m\",\"value\":{\"number\":\"1\"}}},\"center\":null,\"points\":[],\"lines\":[]},{\"name\":\"rocker\",\"kind\":\"rod\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"number\":\"1\"}},\"length\":{\"unit\":\"m\",\"value\":{\"number\":\"1\"}}},\"center\":null,\"points\":[],\"lines\":[]}],\"joints\":[{\"name\":\"crank_pin\",\"kind\":\"revolute\",\"first\":{\"ground\":[{\"number\":\"0\"},{\"number\":\"0\"}],\"unit\":\"m\"},\"second\":{\"place\":\"crank.start\"}},{\"name\":\"rocker_pin\",\"kind\":\"revolute\",\"first\":{\"ground\":[{\"number\":\"1\"},{\"number\":\"0\"}],\"unit\":\"m\"},\"second\":{\"place\":\"rocker.start\"}},{\"name\":\"left\",\"kind\":\"revolute\",\"first\":{\"place\":\"crank.end\"},\"second\":{\"place\":\"coupler.start\"}},{\"name\":\"right\",\"kind\":\"revolute\",\"first\":{\"place\":\"coupler.end\"},\"second\":{\"place\":\"rocker.end\"}}],\"constraints\":[],\"drivers\":[],\"loads\":[],\"start\":[{\"quantity\":{\"name\":\"crank_pin.angle\"},\"exact\":true,\"unit\":\"deg\",\"value\":{\"number\":\"90\"}},{\"quantity\":{\"name\":\"crank_pin.rate\"},\"exact\":true,\"unit\":\"rad/s\",\"value\":{\"op\":\"neg\",\"args\":[{\"number\":\"1\"}]}},{\"quantity\":{\"name\":\"rocker_pin.angle\"},\"exact\":false,\"unit\":\"deg\",\"value\":{\"number\":\"90\"}},{\"quantity\":{\"name\":\"coupler.angle\"},\"exact\":false,\"unit\":\"rad\",\"value\":{\"number\":\"0\"}}],\"outputs\":[{\"name\":\"x\",\"unit\":\"m\",\"value\":{\"name\":\"crank.end.x\"}},{\"name\":\"angle\",\"unit\":\"rad\",\"value\":{\"name\":\"rocker_pin.angle\"}}],\"options\":{},\"expect\":{\"degrees_of_freedom\":1,\"operations\":[{\"of\":null,\"at_most\":100}]}}",
    )
        .0;
    ///What the entries of q and v and the constraint rows are, as JSON.
    pub const COORDINATES: &'static ::core::primitive::str = (
        "{\"coordinates\":\"tree\",\"tree\":[{\"body\":\"crank\",\"joint\":\"crank_pin\",\"parent\":\"ground\"},{\"body\":\"rocker\",\"joint\":\"rocker_pin\",\"parent\":\"ground\"},{\"body\":\"coupler\",\"joint\":\"left\",\"parent\":\"crank\"}],\"linear\":[],\"rotations\":[{\"body\":\"crank\"},{\"body\":\"rocker\"},{\"body\":\"coupler\"}],\"angles\":[],\"rows\":[{\"of\":\"right\",\"what\":\"x\"},{\"of\":\"right\",\"what\":\"y\"}]}",
    )
        .0;
    ///Names of the bodies, in the order of `motions`.
    pub const BODIES: &'static [&'static ::core::primitive::str] = &[
        "crank",
        "coupler",
        "rocker",
    ];
    ///Names of the joints, in the order of `reactions`.
    pub const JOINTS: &'static [&'static ::core::primitive::str] = &[
        "crank_pin",
        "rocker_pin",
        "left",
        "right",
    ];
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
    type Q<R> = [R; 6];
    type V<R> = [R; 3];
    type Lambda<R> = [R; 2];
    type Mass<R> = [R; 4];
    type Jacobian<R> = [R; 6];
    type Conditions<R> = [R; 1];
    type ConditionJacobian<R> = [R; 1];
    type Factor<R> = [R; 11];
    type System<R> = [R; 6];
    type Dense<R> = [R; 6];
    type Basis<R> = [R; 3];
    type Reduced<R> = [R; 1];
    type Parameters<R> = FourBarParameters<R>;
    type Outputs<R> = FourBarOutputs<R>;
    impl<R: Real> Fields<R> for Parameters<R> {
        const NAMES: &'static [&'static str] = &[];
        type Array = [R; 0];
    }
    impl<R: Real> Fields<R> for Outputs<R> {
        const NAMES: &'static [&'static str] = &["x", "angle"];
        type Array = [R; 2];
    }
    impl<R: Real> From<Q<R>> for FourBarPositions<R> {}
    impl<R: Real> From<FourBarPositions<R>> for Q<R> {}
    impl<R: Real> From<V<R>> for FourBarVelocities<R> {}
    impl<R: Real> From<FourBarVelocities<R>> for V<R> {}
    impl<R: Real> Default for Parameters<R> {}
    impl<R: Real> Default for FourBar<R> {}
    impl<R: Real> FourBar<R> {
        /// Force and torque that each joint exerts on the body of its second place, in the order of `JOINTS`:
        /// force in world axes at that place (N), torque about it (N m).
        pub fn reactions(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &(),
            a: &V<R>,
            lambda: &Lambda<R>,
        ) -> [Reaction<R>; 4] {
            // 28 operations.
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let crank_rate = state.v[0];
            let rocker_rate = state.v[1];
            let coupler_rate = state.v[2];
            let crank_rate_dot = a[0];
            let rocker_rate_dot = a[1];
            let coupler_rate_dot = a[2];
            let lambda_right_x = lambda[0];
            let lambda_right_y = lambda[1];
            let a0 = (-crank_sin).mul_add(crank_rate_dot, lambda_right_x);
            let a1 = crank_rate * crank_rate;
            let a2 = (-crank_cos).mul_add(a1, a0);
            let a3 = R::from_f64(0.5) * coupler_cos;
            let a4 = coupler_rate * coupler_rate;
            let a5 = (-a4).mul_add(a3, a2);
            let a6 = R::from_f64(0.5) * coupler_sin;
            let a7 = (-coupler_rate_dot).mul_add(a6, a5);
            let a8 = R::from_f64(0.5) * crank_cos;
            let a9 = (-a1).mul_add(a8, a7);
            let a10 = R::from_f64(0.5) * crank_sin;
            let a11 = (-crank_rate_dot).mul_add(a10, a9);
            let a12 = lambda_right_y + R::from_f64(9.81);
            let a13 = crank_cos.mul_add(crank_rate_dot, a12);
            let a14 = (-crank_sin).mul_add(a1, a13);
            let a15 = coupler_rate_dot.mul_add(a3, a14);
            let a16 = (-a4).mul_add(a6, a15);
            let a17 = crank_rate_dot.mul_add(a8, R::from_f64(9.81));
            let a18 = (-a1).mul_add(a10, a17);
            let a19 = a18 + a16;
            let a20 = R::from_f64(0.5) * rocker_cos;
            let a21 = rocker_rate * rocker_rate;
            let a22 = (-a21).mul_add(a20, -lambda_right_x);
            let a23 = R::from_f64(0.5) * rocker_sin;
            let a24 = (-rocker_rate_dot).mul_add(a23, a22);
            let a25 = R::from_f64(9.81) - lambda_right_y;
            let a26 = rocker_rate_dot.mul_add(a20, a25);
            let a27 = (-a21).mul_add(a23, a26);
            [
                Reaction {
                    force: [a11, a19],
                    torque: R::ZERO,
                },
                Reaction {
                    force: [a24, a27],
                    torque: R::ZERO,
                },
                Reaction {
                    force: [a7, a16],
                    torque: R::ZERO,
                },
                Reaction {
                    force: [lambda_right_x, lambda_right_y],
                    torque: R::ZERO,
                },
            ]
        }
    }
    impl<R: Real> Parametric<R> for FourBar<R> {
        type Parameters = Parameters<R>;
    }
    impl<S> InScalars for FourBar<S> {
        type In<R: Real> = FourBar<R>;
    }
    impl<R: Real> Variables<R> for FourBar<R> {
        type Q = Q<R>;
        type V = V<R>;
        type Lambda = Lambda<R>;
        type Z = ();
        type Gates = ();
    }
    impl<R: Real> Mechanism<R> for FourBar<R> {
        type Mass = Mass<R>;
        type Jacobian = Jacobian<R>;
        type Inputs = ();
        type Outputs = Outputs<R>;
        fn constraint_jacobian(&self, time: R, q: &Q<R>, out: &mut Jacobian<R>) {
            // D(t, q), Φ̇ = D v − ν: its stored entries.
            // 3 operations.
            let crank_cos = q[0];
            let crank_sin = q[1];
            let rocker_cos = q[2];
            let rocker_sin = q[3];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let a0 = -crank_sin;
            let a1 = -coupler_sin;
            let a2 = -rocker_cos;
            *out = [a0, rocker_sin, a1, crank_cos, a2, coupler_cos];
        }
        fn gamma(&self, time: R, q: &Q<R>, v: &V<R>, out: &mut Lambda<R>) {
            // γ(t, q, v), the right-hand side of D v̇ = γ.
            // 9 operations.
            let crank_cos = q[0];
            let crank_sin = q[1];
            let rocker_cos = q[2];
            let rocker_sin = q[3];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let crank_rate = v[0];
            let rocker_rate = v[1];
            let coupler_rate = v[2];
            let a0 = crank_rate * crank_rate;
            let a1 = crank_cos * a0;
            let a2 = coupler_rate * coupler_rate;
            let a3 = coupler_cos.mul_add(a2, a1);
            let a4 = rocker_rate * rocker_rate;
            let gamma_right_x = (-rocker_cos).mul_add(a4, a3);
            let a6 = crank_sin * a0;
            let a7 = coupler_sin.mul_add(a2, a6);
            let gamma_right_y = (-rocker_sin).mul_add(a4, a7);
            *out = [gamma_right_x, gamma_right_y];
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
            // v̇ and λ of M v̇ + Dᵀ λ = Q, D v̇ = γ − 2α (D v − ν) − β² Φ (Baumgarte 1972); the smallest relative pivot.
            // 81 operations.
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let crank_rate = state.v[0];
            let rocker_rate = state.v[1];
            let coupler_rate = state.v[2];
            // positions, rates and forces, factorisation of M and D, substitution
            let a0 = R::from_f64(14.715) * crank_cos;
            let a1 = coupler_rate * coupler_rate;
            let a2 = crank_sin * coupler_cos;
            let a3 = crank_cos.mul_add(coupler_sin, -a2);
            let a4 = R::from_f64(0.5) * a3;
            let a5 = a4.mul_add(a1, -a0);
            let a6 = R::from_f64(0.75) * a5;
            let a7 = R::from_f64(3.0) * rocker_cos;
            let a8 = R::from_f64(4.905) * rocker_cos;
            let a9 = a8 * a7;
            let a10 = rocker_rate.mul_add(rocker_rate, -beta_squared);
            let a11 = rocker_sin.mul_add(a10, a9);
            let a12 = crank_rate * crank_rate;
            let a13 = a12 - beta_squared;
            let a14 = (-crank_sin).mul_add(a13, a11);
            let a15 = a1 - beta_squared;
            let a16 = (-coupler_sin).mul_add(a15, a14);
            let a17 = coupler_cos * coupler_rate;
            let a18 = (-rocker_cos).mul_add(rocker_rate, a17);
            let a19 = crank_cos.mul_add(crank_rate, a18);
            let a20 = two_alpha.mul_add(a19, a16);
            let a21 = R::from_f64(0.75) * crank_cos;
            let a22 = a5.mul_add(a21, a20);
            let a23 = R::from_f64(4.905) * coupler_cos;
            let a24 = a12.mul_add(a4, a23);
            let a25 = crank_sin * coupler_sin;
            let a26 = crank_cos.mul_add(coupler_cos, a25);
            let a27 = R::from_f64(0.375) * a26;
            let a28 = a5.mul_add(a27, a24);
            let a29 = R::from_f64(0.5) * a26;
            let a30 = (-a29).mul_add(a27, R::from_f64(0.3333333333333333));
            let a31 = R::ONE / a30;
            let a32 = (-crank_cos).mul_add(a27, coupler_cos);
            let a33 = a32 * a31;
            let a34 = (-a33).mul_add(a28, a22);
            let a35 = R::from_f64(3.0) * rocker_sin;
            let a36 = (-a8).mul_add(a35, -beta_squared);
            let a37 = rocker_cos.mul_add(a10, a36);
            let a38 = (-crank_cos).mul_add(a13, a37);
            let a39 = (-coupler_cos).mul_add(a15, a38);
            let a40 = coupler_sin * coupler_rate;
            let a41 = (-crank_sin).mul_add(crank_rate, -a40);
            let a42 = rocker_sin.mul_add(rocker_rate, a41);
            let a43 = two_alpha.mul_add(a42, a39);
            let a44 = R::from_f64(0.75) * crank_sin;
            let a45 = (-a5).mul_add(a44, a43);
            let a46 = crank_sin.mul_add(a27, -coupler_sin);
            let a47 = a46 * a31;
            let a48 = (-a47).mul_add(a28, a45);
            let a49 = rocker_sin * a35;
            let a50 = crank_sin.mul_add(a44, a49);
            let a51 = a46.mul_add(a47, a50);
            let a52 = R::ONE / a51;
            let a53 = rocker_cos * a35;
            let a54 = crank_cos.mul_add(a44, a53);
            let a55 = (-a32).mul_add(a47, a54);
            let a56 = a55 * a52;
            let a57 = a56.mul_add(a48, a34);
            let a58 = rocker_cos * a7;
            let a59 = crank_cos.mul_add(a21, a58);
            let a60 = a32.mul_add(a33, a59);
            let a61 = (-a55).mul_add(a56, a60);
            let a62 = R::ONE / a61;
            let lambda_right_y = a62 * a57;
            let a64 = (-a21).mul_add(lambda_right_y, a6);
            let a65 = a52 * a48;
            let lambda_right_x = a56.mul_add(lambda_right_y, a65);
            let a67 = a44.mul_add(lambda_right_x, a64);
            let a68 = a31 * a28;
            let a69 = a33.mul_add(lambda_right_y, a68);
            let a70 = a47.mul_add(lambda_right_x, a69);
            let crank_rate_dot = a27.mul_add(a70, a67);
            let a72 = R::from_f64(14.715) * rocker_cos;
            let a73 = a7.mul_add(lambda_right_y, -a72);
            let rocker_rate_dot = (-a35).mul_add(lambda_right_x, a73);
            let coupler_rate_dot = -a70;
            // smallest relative pivot
            let a76 = a62.abs();
            let a77 = R::from_f64(16.0) * a76;
            let a78 = R::from_f64(8.0) * a52;
            let a79 = a78.max(a77);
            let smallest_pivot = R::ONE / a79;
            *a_out = [crank_rate_dot, rocker_rate_dot, coupler_rate_dot];
            *lambda_out = [lambda_right_x, lambda_right_y];
            smallest_pivot
        }
        #[inline(always)]
        fn null_space_baumgarte(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &(),
            two_alpha: R,
            beta_squared: R,
            a_out: &mut V<R>,
            lambda_out: &mut Lambda<R>,
        ) -> R {
            // As `acceleration_baumgarte`, by independent velocities; the smallest pivot, squared where it is one of D.
            // 62 operations.
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let crank_rate = state.v[0];
            let rocker_rate = state.v[1];
            let coupler_rate = state.v[2];
            // positions, rates and forces, factorisation of M and D, substitution
            let a0 = R::from_f64(14.715) * crank_cos;
            let a1 = coupler_rate * coupler_rate;
            let a2 = crank_sin * coupler_cos;
            let a3 = crank_cos.mul_add(coupler_sin, -a2);
            let a4 = R::from_f64(0.5) * a3;
            let a5 = a4.mul_add(a1, -a0);
            let a6 = coupler_rate * two_alpha;
            let a7 = rocker_rate.mul_add(rocker_rate, -beta_squared);
            let a8 = (-rocker_cos).mul_add(a7, beta_squared);
            let a9 = crank_rate * two_alpha;
            let a10 = crank_sin.mul_add(a9, a8);
            let a11 = crank_rate * crank_rate;
            let a12 = a11 - beta_squared;
            let a13 = crank_cos.mul_add(a12, a10);
            let a14 = a1 - beta_squared;
            let a15 = coupler_cos.mul_add(a14, a13);
            let a16 = rocker_cos * coupler_sin;
            let a17 = rocker_sin.mul_add(coupler_cos, -a16);
            let a18 = R::ONE / a17;
            let a19 = rocker_cos * a18;
            let a20 = a19.mul_add(a15, -a6);
            let a21 = rocker_sin * a7;
            let a22 = crank_cos.mul_add(a9, a21);
            let a23 = (-crank_sin).mul_add(a12, a22);
            let a24 = (-coupler_sin).mul_add(a14, a23);
            let a25 = rocker_sin * a18;
            let a26 = (-a25).mul_add(a24, a20);
            let a27 = crank_sin * coupler_sin;
            let a28 = crank_cos.mul_add(coupler_cos, a27);
            let a29 = R::from_f64(0.5) * a28;
            let a30 = (-a29).mul_add(a26, a5);
            let a31 = R::from_f64(4.905) * rocker_cos;
            let a32 = rocker_rate * two_alpha;
            let a33 = coupler_cos * a18;
            let a34 = a33.mul_add(a15, -a32);
            let a35 = coupler_sin * a18;
            let a36 = (-a35).mul_add(a24, a34);
            let a37 = R::from_f64(0.3333333333333333).mul_add(a36, a31);
            let a38 = a3 * a18;
            let a39 = a38.mul_add(a37, a30);
            let a40 = R::from_f64(4.905) * coupler_cos;
            let a41 = a11.mul_add(a4, a40);
            let a42 = R::from_f64(0.3333333333333333).mul_add(a26, a41);
            let a43 = crank_sin * a19;
            let a44 = crank_cos.mul_add(a25, -a43);
            let a45 = a44.mul_add(a42, a39);
            let a46 = R::from_f64(0.3333333333333333) * a38;
            let a47 = a38.mul_add(a46, R::from_f64(1.3333333333333333));
            let a48 = (-a29).mul_add(a44, a47);
            let a49 = R::from_f64(-0.3333333333333333).mul_add(a44, a29);
            let a50 = (-a44).mul_add(a49, a48);
            let a51 = R::ONE / a50;
            let crank_rate_dot = a51 * a45;
            let rocker_rate_dot = (-a38).mul_add(crank_rate_dot, a36);
            let coupler_rate_dot = (-a44).mul_add(crank_rate_dot, a26);
            let a55 = a46.mul_add(crank_rate_dot, -a37);
            let a56 = a33 * a55;
            let a57 = a49.mul_add(crank_rate_dot, a42);
            let lambda_right_x = (-a19).mul_add(a57, a56);
            let a59 = a35 * a55;
            let lambda_right_y = (-a25).mul_add(a57, a59);
            // smallest relative pivot
            let smallest_pivot = a17 * a17;
            *a_out = [crank_rate_dot, rocker_rate_dot, coupler_rate_dot];
            *lambda_out = [lambda_right_x, lambda_right_y];
            smallest_pivot
        }
        fn outputs(&self, time: R, state: &State<Q<R>, V<R>>, u: &()) -> Outputs<R> {
            // The outputs of the definition, in SI units.
            // 1 operation.
            let crank_cos = state.q[0];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let angle = rocker_sin.atan2(rocker_cos);
            FourBarOutputs {
                x: crank_cos,
                angle: angle,
            }
        }
    }
    impl<R: Real> Report<R> for FourBar<R> {
        type Motion = BodyMotion<R>;
        type Motions = [BodyMotion<R>; 3];
        type Reaction = Reaction<R>;
        type Reactions = [Reaction<R>; 4];
        type Powers = [R; 0];
        type Efforts = [[R; 2]; 0];
    }
    impl<R: Real> Assemble<R> for FourBar<R> {
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
