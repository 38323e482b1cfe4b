// `ParametricFourBar` of models/src/general_four_bar.rs.
// Left out: acceleration, acceleration_baumgarte, choice, condition_bias, condition_cosines, condition_drift, condition_jacobian, condition_pattern, condition_residual, conditions, constraint_jacobian, constraints, default, dependent, driver_efforts, elimination, factor, fingerprint, flips, forces, from, from_array, gamma, independent, input_names, internal_rates, inverse_dynamics, jacobian_pattern, kinetic_energy, layout, lu, mass_pattern, motions, name, nu, null_space, null_space_baumgarte, null_space_first, output_names, outputs, parameters, position_names, positions, potential_energy, powers, reactions, row_cosines, row_scales, row_sizes, rows, scales, set_start_angle_deg, solve, start_angle_deg, start_conditions, start_gates, start_internal, start_q, start_rates, start_targets, start_v, store, to_array, unwrap, velocities, velocity_names, zip.
/// Four-bar of which every number is a parameter; its defaults are the literals of [`GeneralFourBar`].
///
///Equations of motion of the planar mechanism `ParametricFourBar`.
#[cfg_attr(
    doc,
    doc = ::linkwright::__private::v1::mechanism_page!{#[doc = " Four-bar of which every number is a parameter; its defaults are the literals of [`GeneralFourBar`]."]pub
    planar
    ParametricFourBar{param
    gravity_x[m/s^2]= 0.31;param
    gravity_y[m/s^2]= -9.73;param
    crank_x[m]= -0.15;param
    crank_y[m]= 0.24;param
    rocker_x[m]= 0.93;param
    rocker_y[m]= 0.45;param
    crank_length[m]= 0.4
    in
    0.01..10;param
    crank_mass[kg]= 0.71;param
    crank_inertia[kg*m^2]= 0.013;param
    crank_center_x[m]= 0.17;param
    crank_center_y[m]= 0.033;param
    coupler_length[m]= 1.0
    in
    0.01..10;param
    coupler_mass[kg]= 1.93;param
    coupler_inertia[kg*m^2]= 0.187;param
    coupler_center_x[m]= 0.43;param
    coupler_center_y[m]= -0.12;param
    tracer_x[m]= 0.62;param
    tracer_y[m]= 0.29;param
    rocker_length[m]= 0.9
    in
    0.01..10;param
    rocker_mass[kg]= 1.37;param
    rocker_inertia[kg*m^2]= 0.091;param
    rocker_center_x[m]= 0.52;param
    rocker_center_y[m]= 0.071;param
    start_angle[deg]= 40;param
    start_rate[rad/s]= 3;gravity[m/s^2]= (gravity_x, gravity_y);body
    crank{mass[kg]= crank_mass;inertia[kg*m^2]= crank_inertia;center[m]= (
        crank_center_x,
        crank_center_y
    );point
    tip[m]= (crank_length, 0);}body
    coupler{mass[kg]= coupler_mass;inertia[kg*m^2]= coupler_inertia;center[m]= (
        coupler_center_x,
        coupler_center_y
    );point
    tip[m]= (coupler_length, 0);point
    tracer[m]= (tracer_x, tracer_y);}body
    rocker{mass[kg]= rocker_mass;inertia[kg*m^2]= rocker_inertia;center[m]= (
        rocker_center_x,
        rocker_center_y
    );point
    tip[m]= (rocker_length, 0);}joint
    crank_pin:revolute(ground(crank_x, crank_y)[m], crank.origin);joint
    rocker_pin:revolute(ground(rocker_x, rocker_y)[m], rocker.origin);joint
    left:revolute(crank.tip, coupler.origin);joint
    right:revolute(
        coupler.tip,
        rocker.tip
    );start{crank_pin.angle[rad]= start_angle;crank_pin.rate[rad/s]= start_rate;rocker_pin.angle[deg]~100;coupler.angle[deg]~40;}expect{degrees_of_freedom = 1;}output
    trace_x[m]= coupler.tracer.x;output
    trace_y[m]= coupler.tracer.y;output
    rocking[rad]= rocker_pin.angle;}}
)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct ParametricFourBar<R = ::core::primitive::f64> {
    parameters: ParametricFourBarParameters<R>,
    phases: [R; 0],
    constants: [R; 44],
}
///Parameters of [`ParametricFourBar`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct ParametricFourBarParameters<R = ::core::primitive::f64> {
    ///In `m/s^2`, default 0.31.
    pub gravity_x: R,
    ///In `m/s^2`, default -9.73.
    pub gravity_y: R,
    ///In `m`, default -0.15.
    pub crank_x: R,
    ///In `m`, default 0.24.
    pub crank_y: R,
    ///In `m`, default 0.93.
    pub rocker_x: R,
    ///In `m`, default 0.45.
    pub rocker_y: R,
    ///In `m`, default 0.4.
    pub crank_length: R,
    ///In `kg`, default 0.71.
    pub crank_mass: R,
    ///In `kg*m^2`, default 0.013.
    pub crank_inertia: R,
    ///In `m`, default 0.17.
    pub crank_center_x: R,
    ///In `m`, default 0.033.
    pub crank_center_y: R,
    ///In `m`, default 1.0.
    pub coupler_length: R,
    ///In `kg`, default 1.93.
    pub coupler_mass: R,
    ///In `kg*m^2`, default 0.187.
    pub coupler_inertia: R,
    ///In `m`, default 0.43.
    pub coupler_center_x: R,
    ///In `m`, default -0.12.
    pub coupler_center_y: R,
    ///In `m`, default 0.62.
    pub tracer_x: R,
    ///In `m`, default 0.29.
    pub tracer_y: R,
    ///In `m`, default 0.9.
    pub rocker_length: R,
    ///In `kg`, default 1.37.
    pub rocker_mass: R,
    ///In `kg*m^2`, default 0.091.
    pub rocker_inertia: R,
    ///In `m`, default 0.52.
    pub rocker_center_x: R,
    ///In `m`, default 0.071.
    pub rocker_center_y: R,
    ///In `rad`, default 0.6981317007977318. In `deg`, as it is declared: [`start_angle_deg`](ParametricFourBarParameters::start_angle_deg).
    pub start_angle: R,
    ///In `rad/s`, default 3.0.
    pub start_rate: R,
}
///Outputs of [`ParametricFourBar`], in SI units.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct ParametricFourBarOutputs<R = ::core::primitive::f64> {
    ///In `m`.
    pub trace_x: R,
    ///In `m`.
    pub trace_y: R,
    ///In `rad`.
    pub rocking: R,
}
///Positions and velocities of [`ParametricFourBar`].
pub type ParametricFourBarState<R = ::core::primitive::f64> = ::linkwright::__private::v1::State<
    [R; 6],
    [R; 3],
>;
///Positions of [`ParametricFourBar`] by name; [`From`] and [`Into`] the array of a state.
#[allow(dead_code)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct ParametricFourBarPositions<R = ::core::primitive::f64> {
    ///rad, by its cosine and sine.
    pub crank_angle: ::linkwright::__private::v1::Angle<R>,
    ///rad, by its cosine and sine.
    pub rocker_angle: ::linkwright::__private::v1::Angle<R>,
    ///rad, by its cosine and sine.
    pub coupler_angle: ::linkwright::__private::v1::Angle<R>,
}
///Velocities of [`ParametricFourBar`] by name; [`From`] and [`Into`] the array of a state.
#[allow(dead_code)]
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct ParametricFourBarVelocities<R = ::core::primitive::f64> {
    ///rad/s.
    pub crank_rate: R,
    ///rad/s.
    pub rocker_rate: R,
    ///rad/s.
    pub coupler_rate: R,
}
#[allow(clippy::all)]
impl ParametricFourBar<::core::primitive::f64> {
    ///Consistent start state for the default parameters, assembled at compile time.
    pub const START: ParametricFourBarState = ::linkwright::__private::v1::State::new(
        [
            0.7660444431189781,
            0.6427876096865394,
            -0.23572301668468654,
            0.971820281433286,
            0.561431507736191,
            0.8275232094153417,
        ],
        [3.0, -0.49151144248599554, -1.4516086406815356],
    );
    ///Degrees of freedom, drivers removed.
    pub const DEGREES_OF_FREEDOM: ::core::primitive::usize = 1;
    ///Operations of the default acceleration function (Baumgarte), a fused multiply-add counted once.
    pub const OPERATIONS: ::core::primitive::usize = 77;
    ///The definition as written.
    pub const SOURCE: &'static ::core::primitive::str = (
        "# [doc = \" Four-bar of which every number is a parameter; its defaults are the literals of [`GeneralFourBar`].\"] pub planar ParametricFourBar { param gravity_x [m / s ^ 2] = 0.31 ; param gravity_y [m / s ^ 2] = - 9.73 ; param crank_x [m] = - 0.15 ; param crank_y [m] = 0.24 ; param rocker_x [m] = 0.93 ; param rocker_y [m] = 0.45 ; param crank_length [m] = 0.4 in 0.01 .. 10 ; param crank_mass [kg] = 0.71 ; param crank_inertia [kg * m ^ 2] = 0.013 ; param crank_center_x [m] = 0.17 ; param crank_center_y [m] = 0.033 ; param coupler_length [m] = 1.0 in 0.01 .. 10 ; param coupler_mass [kg] = 1.93 ; param coupler_inertia [kg * m ^ 2] = 0.187 ; param coupler_center_x [m] = 0.43 ; param coupler_center_y [m] = - 0.12 ; param tracer_x [m] = 0.62 ; param tracer_y [m] = 0.29 ; param rocker_length [m] = 0.9 in 0.01 .. 10 ; param rocker_mass [kg] = 1.37 ; param rocker_inertia [kg * m ^ 2] = 0.091 ; param rocker_center_x [m] = 0.52 ; param rocker_center_y [m] = 0.071 ; param start_angle [deg] = 40 ; param start_rate [rad / s] = 3 ; gravity [m / s ^ 2] = (gravity_x , gravity_y) ; body crank { mass [kg] = crank_mass ; inertia [kg * m ^ 2] = crank_inertia ; center [m] = (crank_center_x , crank_center_y) ; point tip [m] = (crank_length , 0) ; } body coupler { mass [kg] = coupler_mass ; inertia [kg * m ^ 2] = coupler_inertia ; center [m] = (coupler_center_x , coupler_center_y) ; point tip [m] = (coupler_length , 0) ; point tracer [m] = (tracer_x , tracer_y) ; } body rocker { mass [kg] = rocker_mass ; inertia [kg * m ^ 2] = rocker_inertia ; center [m] = (rocker_center_x , rocker_center_y) ; point tip [m] = (rocker_length , 0) ; } joint crank_pin : revolute (ground (crank_x , crank_y) [m] , crank . origin) ; joint rocker_pin : revolute (ground (rocker_x , rocker_y) [m] , rocker . origin) ; joint left : revolute (crank . tip , coupler . origin) ; joint right : revolute (coupler . tip , rocker . tip) ; start { crank_pin . angle [rad] = start_angle ; crank_pin . rate [rad / s] = start_rate ; rocker_pin . angle [deg] ~ 100 ; coupler . angle [deg] ~ 40 ; } expect { degrees_of_freedom = 1 ; } output trace_x [m] = coupler . tracer . x ; output trace_y [m] = coupler . tracer . y ; output rocking [rad] = rocker_pin . angle ; }",
    )
        .0;
    ///The definition as versioned JSON: kinds, shapes and units as written.
    pub const DEFINITION: &'static ::core::primitive::str = (
        "{\"linkwright\":1,\"kind\":\"planar\",\"name\":\"ParametricFourBar\",\"constants\":[],\"parameters\":[{\"name\":\"gravity_x\",\"unit\":\"m/s^2\",\"value\":{\"number\":\"0.31\"},\"min\":null,\"max\":null},{\"name\":\"gravity_y\",\"unit\":\"m/s^2\",\"value\":{\"op\":\"neg\",\"args\":[{\"number\":\"9.73\"}]},\"min\":null,\"max\":null},{\"name\":\"crank_x\",\"unit\":\"m\",\"value\":{\"op\":\"neg\",\"args\":[{\"number\":\"0.15\"}]},\"min\":null,\"max\":null},{\"name\":\"crank_y\",\"unit\":\"m\",\"value\":{\"number\":\"0.24\"},\"min\":null,\"max\":null},{\"name\":\"rocker_x\",\"unit\":\"m\",\"value\":{\"number\":\"0.93\"},\"min\":null,\"max\":null},{\"name\":\"rocker_y\",\"unit\":\"m\",\"value\":{\"number\":\"0.45\"},\"min\":null,\"max\":null},{\"name\":\"crank_length\",\"unit\":\"m\",\"value\":{\"number\":\"0.4\"},\"min\":{\"number\":\"0.01\"},\"max\":{\"number\":\"10\"}},{\"name\":\"crank_mass\",\"unit\":\"kg\",\"value\":{\"number\":\"0.71\"},\"min\":null,\"max\":null},{\"name\":\"crank_inertia\",\"unit\":\"kg*m^2\",\"value\":{\"number\":\"0.013\"},\"min\":null,\"max\":null},{\"name\":\"crank_center_x\",\"unit\":\"m\",\"value\":{\"number\":\"0.17\"},\"min\":null,\"max\":null},{\"name\":\"crank_center_y\",\"unit\":\"m\",\"value\":{\"number\":\"0.033\"},\"min\":null,\"max\":null},{\"name\":\"coupler_length\",\"unit\":\"m\",\"value\":{\"number\":\"1.0\"},\"min\":{\"number\":\"0.01\"},\"max\":{\"number\":\"10\"}},{\"name\":\"coupler_mass\",\"unit\":\"kg\",\"value\":{\"number\":\"1.93\"},\"min\":null,\"max\":null},{\"name\":\"coupler_inertia\",\"unit\":\"kg*m^2\",\"value\":{\"number\":\"0.187\"},\"min\":null,\"max\":null},{\"name\":\"coupler_center_x\",\"unit\":\"m\",\"value\":{\"number\":\"0.43\"},\"min\":null,\"max\":null},{\"name\":\"coupler_center_y\",\"unit\":\"m\",\"value\":{\"op\":\"neg\",\"args\":[{\"number\":\"0.12\"}]},\"min\":null,\"max\":null},{\"name\":\"tracer_x\",\"unit\":\"m\",\"value\":{\"number\":\"0.62\"},\"min\":null,\"max\":null},{\"name\":\"tracer_y\",\"unit\":\"m\",\"value\":{\"number\":\"0.29\"},\"min\":null,\"max\":null},{\"name\":\"rocker_length\",\"unit\":\"m\",\"value\":{\"number\":\"0.9\"},\"min\":{\"number\":\"0.01\"},\"max\":{\"number\":\"10\"}},{\"name\":\"rocker_mass\",\"unit\":\"kg\",\"value\":{\"number\":\"1.37\"},\"min\":null,\"max\":null},{\"name\":\"rocker_inertia\",\"unit\":\"kg*m^2\",\"value\":{\"number\":\"0.091\"},\"min\":null,\"max\":null},{\"name\":\"rocker_center_x\",\"unit\":\"m\",\"value\":{\"number\":\"0.52\"},\"min\":null,\"max\":null},{\"name\":\"rocker_center_y\",\"unit\":\"m\",\"value\":{\"number\":\"0.071\"},\"min\":null,\"max\":null},{\"name\":\"start_angle\",\"unit\":\"deg\",\"value\":{\"number\":\"40\"},\"min\":null,\"max\":null},{\"name\":\"start_rate\",\"unit\":\"rad/s\",\"value\":{\"number\":\"3\"},\"min\":null,\"max\":null}],\"inputs\":[],\"gravity\":{\"unit\":\"m/s^2\",\"value\":[{\"name\":\"gravity_x\"},{\"name\":\"gravity_y\"}]},\"bodies\":[{\"name\":\"crank\",\"kind\":\"body\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"name\":\"crank_mass\"}},\"inertia\":{\"unit\":\"kg*m^2\",\"value\":{\"name\":\"crank_inertia\"}}},\"center\":{\"unit\":\"m\",\"value\":[{\"name\":\"crank_center_x\"},{\"name\":\"crank_center_y\"}]},\"points\":[{\"name\":\"tip\",\"unit\":\"m\",\"value\":[{\"name\":\"crank_length\"},{\"number\":\"0\"}]}],\"lines\":[]},{\"name\":\"coupler\",\"kind\":\"body\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"name\":\"coupler_mass\"}},\"inertia\":{\"unit\":\"kg*m^2\",\"value\":{\"name\":\"coupler_inertia\"}}},\"center\":{\"unit\":\"m\",\"value\":[{\"name\":\"coupler_center_x\"},{\"name\":\"coupler_center_y\"}]},\"points\":[{\"name\":\"tip\",\"unit\":\"m\",\"value\":[{\"name\":\"coupler_length\"},{\"number\":\"0\"}]},{\"name\":\"tracer\",\"unit\":\"m\",\"value\":[{\"name\":\"tracer_x\"},{\"name\":\"tracer_y\"}]}],\"lines\":[]},{\"name\":\"rocker\",\"kind\":\"body\",\"properties\":{\"mass\":{\"unit\":\"kg\",\"value\":{\"name\":\"rocker_mass\"}},\"inertia\":{\"unit\":\"kg*m^2\",\"value\":{\"name\":\"rocker_inertia\"}}},\"center\":{\"unit\":\"m\",\"value\":[{\"name\":\"rocker_center_x\"},{\"name\":\"rocker_center_y\"}]},\"points\":[{\"name\":\"tip\",\"unit\":\"m\",\"value\":[{\"name\":\"rocker_length\"},{\"number\":\"0\"}]}],\"lines\":[]}],\"joints\":[{\"name\":\"crank_pin\",\"kind\":\"revolute\",\"first\":{\"ground\":[{\"name\":\"crank_x\"},{\"name\":\"crank_y\"}],\"unit\":\"m\"},\"second\":{\"place\":\"crank.origin\"}},{\"name\":\"rocker_pin\",\"kind\":\"revolute\",\"first\":{\"ground\":[{\"name\":\"rocker_x\"},{\"name\":\"rocker_y\"}],\"unit\":\"m\"},\"second\":{\"place\":\"rocker.origin\"}},{\"name\":\"left\",\"kind\":\"revolute\",\"first\":{\"place\":\"crank.tip\"},\"second\":{\"place\":\"coupler.origin\"}},{\"name\":\"right\",\"kind\":\"revolute\",\"first\":{\"place\":\"coupler.tip\"},\"second\":{\"place\":\"rocker.tip\"}}],\"constraints\":[],\"drivers\":[],\"loads\":[],\"start\":[{\"quantity\":{\"name\":\"crank_pin.angle\"},\"exact\":true,\"unit\":\"rad\",\"value\":{\"name\":\"start_angle\"}},{\"quantity\":{\"name\":\"crank_pin.rate\"},\"exact\":true,\"unit\":\"rad/s\",\"value\":{\"name\":\"start_rate\"}},{\"quantity\":{\"name\":\"rocker_pin.angle\"},\"exact\":false,\"unit\":\"deg\",\"value\":{\"number\":\"100\"}},{\"quantity\":{\"name\":\"coupler.angle\"},\"exact\":false,\"unit\":\"deg\",\"value\":{\"number\":\"40\"}}],\"outputs\":[{\"name\":\"trace_x\",\"unit\":\"m\",\"value\":{\"name\":\"coupler.tracer.x\"}},{\"name\":\"trace_y\",\"unit\":\"m\",\"value\":{\"name\":\"coupler.tracer.y\"}},{\"name\":\"rocking\",\"unit\":\"rad\",\"value\":{\"name\":\"rocker_pin.angle\"}}],\"options\":{},\"expect\":{\"degrees_of_freedom\":1}}",
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
    type Constants<R> = [R; 44];
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
    type Parameters<R> = ParametricFourBarParameters<R>;
    type Outputs<R> = ParametricFourBarOutputs<R>;
    impl<R: Real> Fields<R> for Parameters<R> {
        const NAMES: &'static [&'static str] = &[
            "gravity_x",
            "gravity_y",
            "crank_x",
            "crank_y",
            "rocker_x",
            "rocker_y",
            "crank_length",
            "crank_mass",
            "crank_inertia",
            "crank_center_x",
            "crank_center_y",
            "coupler_length",
            "coupler_mass",
            "coupler_inertia",
            "coupler_center_x",
            "coupler_center_y",
            "tracer_x",
            "tracer_y",
            "rocker_length",
            "rocker_mass",
            "rocker_inertia",
            "rocker_center_x",
            "rocker_center_y",
            "start_angle",
            "start_rate",
        ];
        type Array = [R; 25];
    }
    impl<R: Real> Fields<R> for Outputs<R> {
        const NAMES: &'static [&'static str] = &["trace_x", "trace_y", "rocking"];
        type Array = [R; 3];
    }
    impl<R: Real> ParametricFourBarParameters<R> {}
    impl<R: Real> From<Q<R>> for ParametricFourBarPositions<R> {}
    impl<R: Real> From<ParametricFourBarPositions<R>> for Q<R> {}
    impl<R: Real> From<V<R>> for ParametricFourBarVelocities<R> {}
    impl<R: Real> From<ParametricFourBarVelocities<R>> for V<R> {}
    impl<R: Real> Default for Parameters<R> {}
    impl<R: Real> Default for ParametricFourBar<R> {}
    impl<R: Real> ParametricFourBar<R> {
        /// The model with these parameters; what depends on nothing else is computed once, here.
        ///
        /// # Errors
        /// A parameter that is not finite or out of its bounds, or a mass that is not positive.
        pub fn prepare(parameters: Parameters<R>) -> Result<Self, SettingError> {
            check_finite("gravity_x", parameters.gravity_x)?;
            check_finite("gravity_y", parameters.gravity_y)?;
            check_finite("crank_x", parameters.crank_x)?;
            check_finite("crank_y", parameters.crank_y)?;
            check_finite("rocker_x", parameters.rocker_x)?;
            check_finite("rocker_y", parameters.rocker_y)?;
            check_setting(
                "crank_length",
                parameters.crank_length,
                0.01,
                10.0,
                "from 0.01 to 10.0 in SI units, by its declaration",
            )?;
            check_finite("crank_mass", parameters.crank_mass)?;
            check_finite("crank_inertia", parameters.crank_inertia)?;
            check_finite("crank_center_x", parameters.crank_center_x)?;
            check_finite("crank_center_y", parameters.crank_center_y)?;
            check_setting(
                "coupler_length",
                parameters.coupler_length,
                0.01,
                10.0,
                "from 0.01 to 10.0 in SI units, by its declaration",
            )?;
            check_finite("coupler_mass", parameters.coupler_mass)?;
            check_finite("coupler_inertia", parameters.coupler_inertia)?;
            check_finite("coupler_center_x", parameters.coupler_center_x)?;
            check_finite("coupler_center_y", parameters.coupler_center_y)?;
            check_finite("tracer_x", parameters.tracer_x)?;
            check_finite("tracer_y", parameters.tracer_y)?;
            check_setting(
                "rocker_length",
                parameters.rocker_length,
                0.01,
                10.0,
                "from 0.01 to 10.0 in SI units, by its declaration",
            )?;
            check_finite("rocker_mass", parameters.rocker_mass)?;
            check_finite("rocker_inertia", parameters.rocker_inertia)?;
            check_finite("rocker_center_x", parameters.rocker_center_x)?;
            check_finite("rocker_center_y", parameters.rocker_center_y)?;
            check_finite("start_angle", parameters.start_angle)?;
            check_finite("start_rate", parameters.start_rate)?;
            let model = Self::with(parameters, []);
            check_mass("mass of \"crank\"", model.constants[16], true)?;
            check_mass("inertia of \"crank\"", model.constants[17], true)?;
            check_mass("mass of \"coupler\"", model.constants[20], true)?;
            check_mass("inertia of \"coupler\"", model.constants[21], true)?;
            check_mass("mass of \"rocker\"", model.constants[24], true)?;
            check_mass("inertia of \"rocker\"", model.constants[25], true)?;
            check_constants(&model.constants)?;
            Ok(model)
        }
        fn with(parameters: Parameters<R>, phases: Phases<R>) -> Self {
            // What depends on parameters and phases alone: the constants of the prepared model.
            // 64 operations.
            let gravity_x = parameters.gravity_x;
            let gravity_y = parameters.gravity_y;
            let crank_x = parameters.crank_x;
            let crank_y = parameters.crank_y;
            let rocker_x = parameters.rocker_x;
            let rocker_y = parameters.rocker_y;
            let crank_length = parameters.crank_length;
            let crank_mass = parameters.crank_mass;
            let crank_inertia = parameters.crank_inertia;
            let crank_center_x = parameters.crank_center_x;
            let crank_center_y = parameters.crank_center_y;
            let coupler_length = parameters.coupler_length;
            let coupler_mass = parameters.coupler_mass;
            let coupler_inertia = parameters.coupler_inertia;
            let coupler_center_x = parameters.coupler_center_x;
            let coupler_center_y = parameters.coupler_center_y;
            let tracer_x = parameters.tracer_x;
            let tracer_y = parameters.tracer_y;
            let rocker_length = parameters.rocker_length;
            let rocker_mass = parameters.rocker_mass;
            let rocker_inertia = parameters.rocker_inertia;
            let rocker_center_x = parameters.rocker_center_x;
            let rocker_center_y = parameters.rocker_center_y;
            let start_angle = parameters.start_angle;
            let start_rate = parameters.start_rate;
            let a0 = crank_length * coupler_center_x;
            let a1 = coupler_mass * a0;
            let a2 = crank_length * coupler_center_y;
            let a3 = coupler_mass * a2;
            let a4 = crank_length * crank_length;
            let a5 = coupler_mass.mul_add(a4, crank_inertia);
            let a6 = crank_center_x * crank_center_x;
            let a7 = crank_center_y.mul_add(crank_center_y, a6);
            let a8 = crank_mass.mul_add(a7, a5);
            let a9 = rocker_center_x * rocker_center_x;
            let a10 = rocker_center_y.mul_add(rocker_center_y, a9);
            let a11 = rocker_mass.mul_add(a10, rocker_inertia);
            let a12 = coupler_center_x * coupler_center_x;
            let a13 = coupler_center_y.mul_add(coupler_center_y, a12);
            let a14 = coupler_mass.mul_add(a13, coupler_inertia);
            let a15 = rocker_x - crank_x;
            let a16 = rocker_y - crank_y;
            let a17 = gravity_y * crank_length;
            let a18 = coupler_mass * a17;
            let a19 = gravity_y * crank_center_x;
            let a20 = gravity_x.mul_add(crank_center_y, -a19);
            let a21 = crank_mass.mul_add(a20, -a18);
            let a22 = gravity_x * crank_length;
            let a23 = coupler_mass * a22;
            let a24 = gravity_x * crank_center_x;
            let a25 = gravity_y.mul_add(crank_center_y, a24);
            let a26 = crank_mass.mul_add(a25, a23);
            let a27 = gravity_y * coupler_center_x;
            let a28 = gravity_x.mul_add(coupler_center_y, -a27);
            let a29 = coupler_mass * a28;
            let a30 = gravity_x * coupler_center_x;
            let a31 = gravity_y.mul_add(coupler_center_y, a30);
            let a32 = coupler_mass * a31;
            let a33 = gravity_y * rocker_center_x;
            let a34 = gravity_x.mul_add(rocker_center_y, -a33);
            let a35 = rocker_mass * a34;
            let a36 = gravity_x * rocker_center_x;
            let a37 = gravity_y.mul_add(rocker_center_y, a36);
            let a38 = rocker_mass * a37;
            let a39 = R::ONE / a8;
            let a40 = R::ONE / a11;
            let a41 = R::from_f64(0.6427876096865394) * crank_length;
            let a42 = a41 * a41;
            let a43 = a39 * a42;
            let a44 = R::from_f64(0.971820281433286) * rocker_length;
            let a45 = a44 * a44;
            let a46 = a40.mul_add(a45, a43);
            let a47 = R::from_f64(0.8275232094153417) * coupler_length;
            let a48 = a47 * a47;
            let a49 = R::ONE / a14;
            let a50 = a49.mul_add(a48, a46);
            let a51 = R::from_f64(2.6455251711937597) * a50;
            let a52 = R::from_f64(0.993650416208718) * crank_length;
            let a53 = a52 * a52;
            let a54 = a39 * a53;
            let a55 = R::from_f64(0.8614660779177452) * rocker_length;
            let a56 = a55 * a55;
            let a57 = a40.mul_add(a56, a54);
            let a58 = R::from_f64(0.7021406963575164) * coupler_length;
            let a59 = a58 * a58;
            let a60 = a49.mul_add(a59, a57);
            let a61 = R::from_f64(1.5347207530430917) * a60;
            let a62 = rocker_length * a40;
            let a63 = crank_length * a39;
            Self {
                parameters,
                phases,
                constants: [
                    a1,
                    a3,
                    a8,
                    a11,
                    a14,
                    crank_length,
                    coupler_length,
                    rocker_length,
                    a15,
                    a16,
                    a21,
                    a26,
                    a29,
                    a32,
                    a35,
                    a38,
                    crank_mass,
                    crank_inertia,
                    crank_center_x,
                    crank_center_y,
                    coupler_mass,
                    coupler_inertia,
                    coupler_center_x,
                    coupler_center_y,
                    rocker_mass,
                    rocker_inertia,
                    rocker_center_x,
                    rocker_center_y,
                    gravity_x,
                    gravity_y,
                    crank_x,
                    crank_y,
                    rocker_x,
                    rocker_y,
                    a39,
                    a40,
                    a51,
                    a61,
                    a62,
                    a63,
                    tracer_x,
                    tracer_y,
                    start_angle,
                    start_rate,
                ],
            }
        }
    }
    impl<R: Real> Parametric<R> for ParametricFourBar<R> {
        type Parameters = Parameters<R>;
        fn prepare(parameters: Parameters<R>) -> Result<Self, SettingError> {
            ParametricFourBar::<R>::prepare(parameters)
        }
    }
    impl<S> InScalars for ParametricFourBar<S> {
        type In<R: Real> = ParametricFourBar<R>;
    }
    impl<R: Real> Variables<R> for ParametricFourBar<R> {
        type Q = Q<R>;
        type V = V<R>;
        type Lambda = Lambda<R>;
        type Z = ();
        type Gates = ();
    }
    impl<R: Real> Mechanism<R> for ParametricFourBar<R> {
        type Mass = Mass<R>;
        type Jacobian = Jacobian<R>;
        type Inputs = ();
        type Outputs = Outputs<R>;
        fn mass_matrix(&self, time: R, q: &Q<R>, out: &mut Mass<R>) {
            let constants = &self.constants;
            // M(t, q): its stored entries (kg, kg m, kg m²).
            // 6 operations.
            let crank_cos = q[0];
            let crank_sin = q[1];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let k0 = constants[0];
            let k1 = constants[1];
            let k2 = constants[2];
            let k3 = constants[3];
            let k4 = constants[4];
            let a0 = crank_sin * coupler_sin;
            let a1 = crank_cos.mul_add(coupler_cos, a0);
            let a2 = k0 * a1;
            let a3 = crank_sin * coupler_cos;
            let a4 = crank_cos.mul_add(coupler_sin, -a3);
            let a5 = (-k1).mul_add(a4, a2);
            *out = [k2, k3, a5, k4];
        }
    }
    impl<R: Real> Report<R> for ParametricFourBar<R> {
        type Motion = BodyMotion<R>;
        type Motions = [BodyMotion<R>; 3];
        type Reaction = Reaction<R>;
        type Reactions = [Reaction<R>; 4];
        type Powers = [R; 0];
        type Efforts = [[R; 2]; 0];
    }
    impl<R: Real> Assemble<R> for ParametricFourBar<R> {
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
