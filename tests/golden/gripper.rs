// `Gripper` of tests/mechanisms/src/zoo_tangent.rs.
// Left out: acceleration, acceleration_baumgarte, choice, condition_bias, condition_cosines, condition_drift, condition_jacobian, condition_pattern, condition_residual, conditions, constraint_jacobian, constraints, coordinate_pattern, coordinate_tangent, damping_pattern, default, dependent, driver_efforts, elimination, factor, fingerprint, flips, forces, from, from_array, gamma, independent, input_names, input_pattern, input_tangent, internal_rates, inverse_dynamics, jacobian_pattern, kinetic_energy, layout, lu, mass_matrix, mass_pattern, motions, name, nu, null_space, null_space_baumgarte, null_space_first, order, output_names, output_pattern, output_tangent, outputs, parameter_names, parameter_pattern, parameter_tangent, parameters, position_names, positions, potential_energy, powers, prepare, rate_pattern, rate_tangent, reactions, row_cosines, row_damping_pattern, row_scales, row_sizes, row_stiffness_pattern, row_tangent, rows, scales, solve, start_conditions, start_gates, start_internal, start_q, start_rates, start_targets, start_v, states, stiffness_pattern, store, to_array, unwrap, velocities, velocity_names, with, zip.
/// A four-bar that a torsion spring holds, with more inputs than it needs.
///
///Equations of motion of the planar mechanism `Gripper`.
#[cfg_attr(
    doc,
    doc = ::linkwright::__private::v1::mechanism_page!{#[doc = " A four-bar that a torsion spring holds, with more inputs than it needs."]pub
    planar
    Gripper{param
    stiffness[N*m/rad]= 6;param
    length[m]= 0.9;param
    weight[kg]= 1.2
    in
    0.1..10;input
    drive[N*m];input
    pull[N];gravity[m/s^2]= (0, -9.81);rod
    crank{mass[kg]= weight;length[m]= 0.4;}rod
    coupler{mass[kg]= 0.8;length[m]= length;}rod
    rocker{mass[kg]= 0.6;length[m]= 0.7;}joint
    a:revolute(ground(0, 0)[m], crank.start);joint
    b:revolute(crank.end, coupler.start);joint
    c:revolute(coupler.end, rocker.end);joint
    d:revolute(ground(0.8, 0)[m], rocker.start);torsion_spring
    coil:torsion_spring(
        a,
        stiffness = stiffness,
        angle = 40[deg],
        damping = 0.2[N*m*s/rad]
    );torque
    motor:torque(a)= drive;force
    rope:force(
        coupler.center,
        direction = (1, 2)
    )= pull;start{a.angle[deg]= 70;a.rate[rad/s]= 1;d.angle[deg]~80;coupler.angle[rad]~0.3;}options{emit = (
        tangent
    );}expect{degrees_of_freedom = 1;}output
    reach[m]= coupler.center.x;output
    swing[rad]= d.angle;output
    swinging[rad/s]= d.rate;output
    stored[J]= potential_energy;}}
)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct Gripper<R = ::core::primitive::f64> {
    parameters: GripperParameters<R>,
    phases: [R; 0],
    constants: [R; 21],
}
///Parameters of [`Gripper`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct GripperParameters<R = ::core::primitive::f64> {
    ///In `N*m/rad`, default 6.0.
    pub stiffness: R,
    ///In `m`, default 0.9.
    pub length: R,
    ///In `kg`, default 1.2.
    pub weight: R,
}
///Inputs of [`Gripper`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct GripperInputs<R = ::core::primitive::f64> {
    ///In `N*m`.
    pub drive: R,
    ///In `N`.
    pub pull: R,
}
///Outputs of [`Gripper`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct GripperOutputs<R = ::core::primitive::f64> {
    ///In `m`.
    pub reach: R,
    ///In `rad`.
    pub swing: R,
    ///In `rad/s`.
    pub swinging: R,
    ///In `J`.
    pub stored: R,
}
///Positions and velocities of [`Gripper`].
pub type GripperState<R = ::core::primitive::f64> = ::linkwright::__private::v1::State<
    [R; 8],
    [R; 3],
>;
///Positions of [`Gripper`] by name; [`From`] and [`Into`] the array of a state.
#[allow(dead_code)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct GripperPositions<R = ::core::primitive::f64> {
    ///rad, by its cosine and sine.
    pub crank_angle: ::linkwright::__private::v1::Angle<R>,
    ///rad, by its cosine and sine.
    pub rocker_angle: ::linkwright::__private::v1::Angle<R>,
    ///rad, by its cosine and sine.
    pub coupler_angle: ::linkwright::__private::v1::Angle<R>,
    ///rad, over several turns.
    pub a_turns: ::linkwright::__private::v1::Turns<R>,
}
///Velocities of [`Gripper`] by name; [`From`] and [`Into`] the array of a state.
#[allow(dead_code)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct GripperVelocities<R = ::core::primitive::f64> {
    ///rad/s.
    pub crank_rate: R,
    ///rad/s.
    pub rocker_rate: R,
    ///rad/s.
    pub coupler_rate: R,
}
#[allow(clippy::all)]
impl Gripper<::core::primitive::f64> {
    ///Consistent start state for the default parameters, assembled at compile time.
    pub const START: GripperState = ::linkwright::__private::v1::State::new(
        [
            0.34202014332566893,
            0.9396926207859084,
            0.2652451324560043,
            0.9641810098256431,
            0.943181705987706,
            0.3322773984039853,
            0.0,
            1.2217304763960306,
        ],
        [1.0, 0.5376077677321333, -0.043575398512411094],
    );
    ///Degrees of freedom, drivers removed.
    pub const DEGREES_OF_FREEDOM: ::core::primitive::usize = 1;
    ///Operations of the default acceleration function (Baumgarte), a fused multiply-add counted once.
    pub const OPERATIONS: ::core::primitive::usize = 81;
    ///The definition as written.
    pub const SOURCE: &'static ::core::primitive::str = (
        "# [doc = \" A four-bar that a torsion spring holds, with more inputs than it needs.\"] pub planar Gripper { param stiffness [N * m / rad] = 6 ; param length [m] = 0.9 ; param weight [kg] = 1.2 in 0.1 .. 10 ; input drive [N * m] ; input pull [N] ; gravity [m / s ^ 2] = (0 , - 9.81) ; rod crank { mass [kg] = weight ; length [m] = 0.4 ; } rod coupler { mass [kg] = 0.8 ; length [m] = length ; } rod rocker { mass [kg] = 0.6 ; length [m] = 0.7 ; } joint a : revolute (ground (0 , 0) [m] , crank . start) ; joint b : revolute (crank . end , coupler . start) ; joint c : revolute (coupler . end , rocker . end) ; joint d : revolute (ground (0.8 , 0) [m] , rocker . start) ; torsion_spring coil : torsion_spring (a , stiffness = stiffness , angle = 40 [deg] , damping = 0.2 [N * m * s / rad]) ; torque motor : torque (a) = drive ; force rope : force (coupler . center , direction = (1 , 2)) = pull ; start { a . angle [deg] = 70 ; a . rate [rad / s] = 1 ; d . angle [deg] ~ 80 ; coupler . angle [rad] ~ 0.3 ; } options { emit = (tangent) ; } expect { degrees_of_freedom = 1 ; } output reach [m] = coupler . center . x ; output swing [rad] = d . angle ; output swinging [rad / s] = d . rate ; output stored [J] = potential_energy ; }",
    )
        .0;
    ///The definition as versioned JSON: kinds, shapes and units as written.
    pub const DEFINITION: &'static ::core::primitive::str = (
        "{\"linkwright\":1,\"kind\":\"planar\",\"name\":\"Gripper\",\"constants\":[],\"parameters\":[{\"name\":\"stiffness\",\"unit\":\"N*m/rad\",\"value\":{\"number\":\"6\"},\"min\":null,\"max\":null},{\"name\":\"length\",\"unit\":\"m\",\"value\":{\"number\":\"0.9\"},\"min\":null,\"max\":null},{\"name\":\"weight\",\"unit\":\"kg\",\"value\":{\"number\":\"1.2\"},\"min\":{\"number\":\"0.1\"},\"max\":{\"number\":\"10\"}}],\"inputs\":[{\"name\":\"drive\",\"unit\":\"N*m\"},{\"name\":\"pull\",\"unit\":\"N\"}],\"gravity\":{\"unit\":\"m/s^2\",\"value\":[{\"number\":\"0\"},{\"op\":\"neg\",\"args\":[{\"number\":\"9.81\"}]}]},\"bodies\":[{\"name\":\"crank\",\"kind\":\"rod\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"name\":\"weight\"}},\"length\":{\"unit\":\"m\",\"value\":{\"number\":\"0.4\"}}},\"center\":null,\"points\":[],\"lines\":[]},{\"name\":\"coupler\",\"kind\":\"rod\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"number\":\"0.8\"}},\"length\":{\"unit\":\"m\",\"value\":{\"name\":\"length\"}}},\"center\":null,\"points\":[],\"lines\":[]},{\"name\":\"rocker\",\"kind\":\"rod\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"number\":\"0.6\"}},\"length\":{\"unit\":\"m\",\"value\":{\"number\":\"0.7\"}}},\"center\":null,\"points\":[],\"lines\":[]}],\"joints\":[{\"name\":\"a\",\"kind\":\"revolute\",\"first\":{\"ground\":[{\"number\":\"0\"},{\"number\":\"0\"}],\"unit\":\"m\"},\"second\":{\"place\":\"crank.start\"}},{\"name\":\"b\",\"kind\":\"revolute\",\"first\":{\"place\":\"crank.end\"},\"second\":{\"place\":\"coupler.start\"}},{\"name\":\"c\",\"kind\":\"revolute\",\"first\":{\"place\":\"coupler.end\"},\"second\":{\"place\":\"rocker.end\"}},{\"name\":\"d\",\"kind\":\"revolute\",\"first\":{\"ground\":[{\"number\":\"0.8\"},{\"number\":\"0\"}],\"unit\":\"m\"},\"second\":{\"place\":\"rocker.start\"}}],\"constraints\":[],\"drivers\":[],\"loads\":[{\"name\":\"coil\",\"kind\":\"torsion_spring\",\"on\":\"a\",\"stiffness\":{\"unit\":null,\"value\":{\"name\":\"stiffness\"}},\"angle\":{\"unit\":null,\"value\":{\"number\":\"40\",\"unit\":\"deg\"}},\"damping\":{\"unit\":null,\"value\":{\"number\":\"0.2\",\"unit\":\"N*m*s/rad\"}}},{\"name\":\"motor\",\"kind\":\"torque\",\"on\":\"a\",\"value\":{\"name\":\"drive\"}},{\"name\":\"rope\",\"kind\":\"force\",\"place\":{\"place\":\"coupler.center\"},\"direction\":[{\"number\":\"1\"},{\"number\":\"2\"}],\"value\":{\"name\":\"pull\"}}],\"start\":[{\"quantity\":{\"name\":\"a.angle\"},\"exact\":true,\"unit\":\"deg\",\"value\":{\"number\":\"70\"}},{\"quantity\":{\"name\":\"a.rate\"},\"exact\":true,\"unit\":\"rad/s\",\"value\":{\"number\":\"1\"}},{\"quantity\":{\"name\":\"d.angle\"},\"exact\":false,\"unit\":\"deg\",\"value\":{\"number\":\"80\"}},{\"quantity\":{\"name\":\"coupler.angle\"},\"exact\":false,\"unit\":\"rad\",\"value\":{\"number\":\"0.3\"}}],\"outputs\":[{\"name\":\"reach\",\"unit\":\"m\",\"value\":{\"name\":\"coupler.center.x\"}},{\"name\":\"swing\",\"unit\":\"rad\",\"value\":{\"name\":\"d.angle\"}},{\"name\":\"swinging\",\"unit\":\"rad/s\",\"value\":{\"name\":\"d.rate\"}},{\"name\":\"stored\",\"unit\":\"J\",\"value\":{\"name\":\"potential_energy\"}}],\"options\":{},\"expect\":{\"degrees_of_freedom\":1}}",
    )
        .0;
    ///What the entries of q and v and the constraint rows are, as JSON.
    pub const COORDINATES: &'static ::core::primitive::str = (
        "{\"coordinates\":\"tree\",\"tree\":[{\"body\":\"crank\",\"joint\":\"a\",\"parent\":\"ground\"},{\"body\":\"rocker\",\"joint\":\"d\",\"parent\":\"ground\"},{\"body\":\"coupler\",\"joint\":\"b\",\"parent\":\"crank\"}],\"linear\":[],\"rotations\":[{\"body\":\"crank\"},{\"body\":\"rocker\"},{\"body\":\"coupler\"}],\"angles\":[{\"of\":\"a\",\"rate\":[[0,1.0]]}],\"rows\":[{\"of\":\"c\",\"what\":\"x\"},{\"of\":\"c\",\"what\":\"y\"}]}",
    )
        .0;
    ///Names of the bodies, in the order of `motions`.
    pub const BODIES: &'static [&'static ::core::primitive::str] = &[
        "crank",
        "coupler",
        "rocker",
    ];
    ///Names of the joints, in the order of `reactions`.
    pub const JOINTS: &'static [&'static ::core::primitive::str] = &["a", "b", "c", "d"];
    ///Names of the loads, in the order of `powers`.
    pub const LOADS: &'static [&'static ::core::primitive::str] = &[
        "coil",
        "motor",
        "rope",
    ];
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
    type Constants<R> = [R; 21];
    type Phases<R> = [R; 0];
    type Q<R> = [R; 8];
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
    type Parameters<R> = GripperParameters<R>;
    type Inputs<R> = GripperInputs<R>;
    type Outputs<R> = GripperOutputs<R>;
    type Stiffness<R> = [R; 5];
    type Damping<R> = [R; 3];
    type RowStiffness<R> = [R; 6];
    type RowDamping<R> = [R; 6];
    type RateTangent<R> = [R; 6];
    type InputTangent<R> = [R; 3];
    type ParameterTangent<R> = [R; 14];
    type OutputTangent<R> = [R; 7];
    type CoordinateTangent<R> = [R; 1];
    type StateMatrix<R> = [R; 4];
    type InputMatrix<R> = [R; 4];
    type OutputMatrix<R> = [R; 8];
    type Feedthrough<R> = [R; 8];
    type Unknowns<R> = [R; 5];
    type Bordered<R> = [R; 25];
    impl<R: Real> Fields<R> for Parameters<R> {
        const NAMES: &'static [&'static str] = &["stiffness", "length", "weight"];
        type Array = [R; 3];
    }
    impl<R: Real> Fields<R> for Inputs<R> {
        const NAMES: &'static [&'static str] = &["drive", "pull"];
        type Array = [R; 2];
    }
    impl<R: Real> Fields<R> for Outputs<R> {
        const NAMES: &'static [&'static str] = &["reach", "swing", "swinging", "stored"];
        type Array = [R; 4];
    }
    impl<R: Real> From<Q<R>> for GripperPositions<R> {}
    impl<R: Real> From<GripperPositions<R>> for Q<R> {}
    impl<R: Real> From<V<R>> for GripperVelocities<R> {}
    impl<R: Real> From<GripperVelocities<R>> for V<R> {}
    impl<R: Real> Default for Parameters<R> {}
    impl<R: Real> Default for Gripper<R> {}
    impl<R: Real> Gripper<R> {}
    impl<R: Real> Parametric<R> for Gripper<R> {
        type Parameters = Parameters<R>;
    }
    impl<S> InScalars for Gripper<S> {
        type In<R: Real> = Gripper<R>;
    }
    impl<R: Real> Variables<R> for Gripper<R> {
        type Q = Q<R>;
        type V = V<R>;
        type Lambda = Lambda<R>;
        type Z = ();
        type Gates = ();
    }
    impl<R: Real> Mechanism<R> for Gripper<R> {
        type Mass = Mass<R>;
        type Jacobian = Jacobian<R>;
        type Inputs = Inputs<R>;
        type Outputs = Outputs<R>;
    }
    impl<R: Real> Report<R> for Gripper<R> {
        type Motion = BodyMotion<R>;
        type Motions = [BodyMotion<R>; 3];
        type Reaction = Reaction<R>;
        type Reactions = [Reaction<R>; 4];
        type Powers = [R; 3];
        type Efforts = [[R; 2]; 0];
    }
    impl<R: Real> Assemble<R> for Gripper<R> {
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
    impl<R: Real> Tangent<R> for Gripper<R> {
        type Stiffness = Stiffness<R>;
        type Damping = Damping<R>;
        type RowStiffness = RowStiffness<R>;
        type RowDamping = RowDamping<R>;
        type RateTangent = RateTangent<R>;
        type InputTangent = InputTangent<R>;
        type InternalTangent = ();
        type FrictionTangent = ();
        type ParameterTangent = ParameterTangent<R>;
        type OutputTangent = OutputTangent<R>;
        type InternalRateTangent = ();
        type CoordinateTangent = CoordinateTangent<R>;
        type StateMatrix = StateMatrix<R>;
        type InputMatrix = InputMatrix<R>;
        type OutputMatrix = OutputMatrix<R>;
        type Feedthrough = Feedthrough<R>;
        type Unknowns = Unknowns<R>;
        type Bordered = Bordered<R>;
        type Parameters = Parameters<R>;
        type Order = [u16; 5];
        fn residual(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &Inputs<R>,
            a: &V<R>,
            lambda: &Lambda<R>,
            out: &mut V<R>,
        ) {
            let constants = &self.constants;
            // r = M v̇ + Dᵀ λ − Q (N or N m).
            // 39 operations.
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let a_turns = state.q[6];
            let a_remainder = state.q[7];
            let crank_rate = state.v[0];
            let coupler_rate = state.v[2];
            let drive = u.drive;
            let pull = u.pull;
            let crank_rate_dot = a[0];
            let rocker_rate_dot = a[1];
            let coupler_rate_dot = a[2];
            let lambda_c_x = lambda[0];
            let lambda_c_y = lambda[1];
            let k0 = constants[0];
            let k1 = constants[1];
            let k2 = constants[2];
            let length = constants[3];
            let stiffness = constants[4];
            let k5 = constants[5];
            let k6 = constants[6];
            let k7 = constants[7];
            let a0 = k1.mul_add(crank_rate_dot, -drive);
            let a1 = k6.mul_add(crank_cos, a0);
            let a2 = R::from_f64(0.2).mul_add(crank_rate, a1);
            let a3 = R::from_f64(0.4) * crank_cos;
            let a4 = a3.mul_add(lambda_c_y, a2);
            let a5 = R::from_f64(0.4) * crank_sin;
            let a6 = (-a5).mul_add(lambda_c_x, a4);
            let a7 = R::from_f64(0.4472135954999579) * pull;
            let a8 = a5.mul_add(a7, a6);
            let a9 = R::from_f64(0.8944271909999159) * pull;
            let a10 = (-a3).mul_add(a9, a8);
            let a11 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a12 = a11 - R::from_f64(0.6981317007977318);
            let a13 = stiffness.mul_add(a12, a10);
            let a14 = crank_sin * coupler_sin;
            let a15 = crank_cos.mul_add(coupler_cos, a14);
            let a16 = k0 * a15;
            let a17 = coupler_rate_dot.mul_add(a16, a13);
            let a18 = coupler_rate * coupler_rate;
            let a19 = crank_sin * coupler_cos;
            let a20 = crank_cos.mul_add(coupler_sin, -a19);
            let a21 = k0 * a20;
            let a22 = (-a21).mul_add(a18, a17);
            let a23 = R::from_f64(0.09799999999999998) * rocker_rate_dot;
            let a24 = R::from_f64(2.0601).mul_add(rocker_cos, a23);
            let a25 = lambda_c_y * rocker_cos;
            let a26 = (-lambda_c_x).mul_add(rocker_sin, a25);
            let a27 = R::from_f64(-0.7).mul_add(a26, a24);
            let a28 = k2 * coupler_rate_dot;
            let a29 = k7.mul_add(coupler_cos, a28);
            let a30 = lambda_c_y * coupler_cos;
            let a31 = (-lambda_c_x).mul_add(coupler_sin, a30);
            let a32 = length.mul_add(a31, a29);
            let a33 = crank_rate_dot.mul_add(a16, a32);
            let a34 = crank_rate * crank_rate;
            let a35 = a34.mul_add(a21, a33);
            let a36 = a7 * coupler_sin;
            let a37 = a9.mul_add(coupler_cos, -a36);
            let a38 = (-k5).mul_add(a37, a35);
            *out = [a22, a27, a38];
        }
        fn tangent(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &Inputs<R>,
            a: &V<R>,
            lambda: &Lambda<R>,
            stiffness_out: &mut Stiffness<R>,
            damping_out: &mut Damping<R>,
        ) {
            let constants = &self.constants;
            // ∂r/∂q along increments of q, and ∂r/∂v: the stored entries.
            // 40 operations.
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let crank_rate = state.v[0];
            let coupler_rate = state.v[2];
            let pull = u.pull;
            let crank_rate_dot = a[0];
            let coupler_rate_dot = a[2];
            let lambda_c_x = lambda[0];
            let lambda_c_y = lambda[1];
            let k0 = constants[0];
            let length = constants[3];
            let stiffness = constants[4];
            let k5 = constants[5];
            let k6 = constants[6];
            let k7 = constants[7];
            let a0 = coupler_rate * coupler_rate;
            let a1 = crank_sin * coupler_sin;
            let a2 = crank_cos.mul_add(coupler_cos, a1);
            let a3 = k0 * a2;
            let a4 = a3 * a0;
            let a5 = (-k6).mul_add(crank_sin, stiffness);
            let a6 = R::from_f64(0.4) * crank_cos;
            let a7 = (-a6).mul_add(lambda_c_x, a5);
            let a8 = R::from_f64(0.4) * crank_sin;
            let a9 = (-a8).mul_add(lambda_c_y, a7);
            let a10 = R::from_f64(0.4472135954999579) * pull;
            let a11 = a6.mul_add(a10, a9);
            let a12 = R::from_f64(0.8944271909999159) * pull;
            let a13 = a8.mul_add(a12, a11);
            let a14 = crank_sin * coupler_cos;
            let a15 = crank_cos.mul_add(coupler_sin, -a14);
            let a16 = k0 * a15;
            let a17 = coupler_rate_dot.mul_add(a16, a13);
            let a18 = a17 + a4;
            let a19 = (-coupler_rate_dot).mul_add(a16, -a4);
            let a20 = R::from_f64(0.7) * rocker_cos;
            let a21 = a20 * lambda_c_x;
            let a22 = R::from_f64(0.7).mul_add(lambda_c_y, R::from_f64(-2.0601));
            let a23 = rocker_sin.mul_add(a22, a21);
            let a24 = crank_rate * crank_rate;
            let a25 = a3 * a24;
            let a26 = crank_rate_dot.mul_add(a16, -a25);
            let a27 = (-k7).mul_add(coupler_sin, a25);
            let a28 = lambda_c_y * coupler_sin;
            let a29 = lambda_c_x.mul_add(coupler_cos, a28);
            let a30 = (-length).mul_add(a29, a27);
            let a31 = (-crank_rate_dot).mul_add(a16, a30);
            let a32 = a10 * coupler_cos;
            let a33 = a12.mul_add(coupler_sin, a32);
            let a34 = k5.mul_add(a33, a31);
            let a35 = R::from_f64(2.0) * coupler_rate;
            let a36 = a16 * a35;
            let a37 = -a36;
            let a38 = R::from_f64(2.0) * crank_rate;
            let a39 = a16 * a38;
            *stiffness_out = [a18, a19, a23, a26, a34];
            *damping_out = [R::from_f64(0.2), a37, a39];
        }
    }
};
const _: ::core::option::Option<&'static ::core::primitive::str> = ::core::option_env!(
    "LINKWRIGHT_SELF_CHECK"
);
