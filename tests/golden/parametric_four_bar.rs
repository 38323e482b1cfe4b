/// Four-bar of which every number is a parameter; its defaults are the literals of [`GeneralFourBar`].
///
///Equations of motion of the planar mechanism `ParametricFourBar`.
#[cfg_attr(
    doc,
    doc = ::linkwright::__private::v1::mechanism_page!{#[doc = r" Four-bar of which every number is a parameter; its defaults are the literals of [`GeneralFourBar`]."]pub
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
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ParametricFourBar<R = ::core::primitive::f64> {
    parameters: ParametricFourBarParameters<R>,
    phases: [R; 0],
    constants: [R; 44],
}
///Parameters of [`ParametricFourBar`], in SI units.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ParametricFourBarParameters<R = ::core::primitive::f64> {
    ///`m/s^2`, default 0.31 in SI units.
    pub gravity_x: R,
    ///`m/s^2`, default -9.73 in SI units.
    pub gravity_y: R,
    ///`m`, default -0.15 in SI units.
    pub crank_x: R,
    ///`m`, default 0.24 in SI units.
    pub crank_y: R,
    ///`m`, default 0.93 in SI units.
    pub rocker_x: R,
    ///`m`, default 0.45 in SI units.
    pub rocker_y: R,
    ///`m`, default 0.4 in SI units.
    pub crank_length: R,
    ///`kg`, default 0.71 in SI units.
    pub crank_mass: R,
    ///`kg*m^2`, default 0.013 in SI units.
    pub crank_inertia: R,
    ///`m`, default 0.17 in SI units.
    pub crank_center_x: R,
    ///`m`, default 0.033 in SI units.
    pub crank_center_y: R,
    ///`m`, default 1.0 in SI units.
    pub coupler_length: R,
    ///`kg`, default 1.93 in SI units.
    pub coupler_mass: R,
    ///`kg*m^2`, default 0.187 in SI units.
    pub coupler_inertia: R,
    ///`m`, default 0.43 in SI units.
    pub coupler_center_x: R,
    ///`m`, default -0.12 in SI units.
    pub coupler_center_y: R,
    ///`m`, default 0.62 in SI units.
    pub tracer_x: R,
    ///`m`, default 0.29 in SI units.
    pub tracer_y: R,
    ///`m`, default 0.9 in SI units.
    pub rocker_length: R,
    ///`kg`, default 1.37 in SI units.
    pub rocker_mass: R,
    ///`kg*m^2`, default 0.091 in SI units.
    pub rocker_inertia: R,
    ///`m`, default 0.52 in SI units.
    pub rocker_center_x: R,
    ///`m`, default 0.071 in SI units.
    pub rocker_center_y: R,
    ///`deg`, default 0.6981317007977318 in SI units.
    pub start_angle: R,
    ///`rad/s`, default 3.0 in SI units.
    pub start_rate: R,
}
///Outputs of [`ParametricFourBar`], in SI units.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ParametricFourBarOutputs<R = ::core::primitive::f64> {
    ///`m` (SI).
    pub trace_x: R,
    ///`m` (SI).
    pub trace_y: R,
    ///`rad` (SI).
    pub rocking: R,
}
///Positions and velocities of [`ParametricFourBar`].
pub type ParametricFourBarState<R = ::core::primitive::f64> = ::linkwright::__private::v1::State<
    [R; 6],
    [R; 3],
>;
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
    pub const OPERATIONS: ::core::primitive::usize = 98;
    ///The definition as written.
    pub const SOURCE: &'static ::core::primitive::str = (
        "# [doc = r\" Four-bar of which every number is a parameter; its defaults are the literals of [`GeneralFourBar`].\"] pub planar ParametricFourBar { param gravity_x [m / s ^ 2] = 0.31 ; param gravity_y [m / s ^ 2] = - 9.73 ; param crank_x [m] = - 0.15 ; param crank_y [m] = 0.24 ; param rocker_x [m] = 0.93 ; param rocker_y [m] = 0.45 ; param crank_length [m] = 0.4 in 0.01 .. 10 ; param crank_mass [kg] = 0.71 ; param crank_inertia [kg * m ^ 2] = 0.013 ; param crank_center_x [m] = 0.17 ; param crank_center_y [m] = 0.033 ; param coupler_length [m] = 1.0 in 0.01 .. 10 ; param coupler_mass [kg] = 1.93 ; param coupler_inertia [kg * m ^ 2] = 0.187 ; param coupler_center_x [m] = 0.43 ; param coupler_center_y [m] = - 0.12 ; param tracer_x [m] = 0.62 ; param tracer_y [m] = 0.29 ; param rocker_length [m] = 0.9 in 0.01 .. 10 ; param rocker_mass [kg] = 1.37 ; param rocker_inertia [kg * m ^ 2] = 0.091 ; param rocker_center_x [m] = 0.52 ; param rocker_center_y [m] = 0.071 ; param start_angle [deg] = 40 ; param start_rate [rad / s] = 3 ; gravity [m / s ^ 2] = (gravity_x , gravity_y) ; body crank { mass [kg] = crank_mass ; inertia [kg * m ^ 2] = crank_inertia ; center [m] = (crank_center_x , crank_center_y) ; point tip [m] = (crank_length , 0) ; } body coupler { mass [kg] = coupler_mass ; inertia [kg * m ^ 2] = coupler_inertia ; center [m] = (coupler_center_x , coupler_center_y) ; point tip [m] = (coupler_length , 0) ; point tracer [m] = (tracer_x , tracer_y) ; } body rocker { mass [kg] = rocker_mass ; inertia [kg * m ^ 2] = rocker_inertia ; center [m] = (rocker_center_x , rocker_center_y) ; point tip [m] = (rocker_length , 0) ; } joint crank_pin : revolute (ground (crank_x , crank_y) [m] , crank . origin) ; joint rocker_pin : revolute (ground (rocker_x , rocker_y) [m] , rocker . origin) ; joint left : revolute (crank . tip , coupler . origin) ; joint right : revolute (coupler . tip , rocker . tip) ; start { crank_pin . angle [rad] = start_angle ; crank_pin . rate [rad / s] = start_rate ; rocker_pin . angle [deg] ~ 100 ; coupler . angle [deg] ~ 40 ; } expect { degrees_of_freedom = 1 ; } output trace_x [m] = coupler . tracer . x ; output trace_y [m] = coupler . tracer . y ; output rocking [rad] = rocker_pin . angle ; }",
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
    use ::core::primitive::{bool, f64, u16, u32, usize, str};
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
        fn from_array(values: [R; 25]) -> Self {
            ParametricFourBarParameters {
                gravity_x: values[0],
                gravity_y: values[1],
                crank_x: values[2],
                crank_y: values[3],
                rocker_x: values[4],
                rocker_y: values[5],
                crank_length: values[6],
                crank_mass: values[7],
                crank_inertia: values[8],
                crank_center_x: values[9],
                crank_center_y: values[10],
                coupler_length: values[11],
                coupler_mass: values[12],
                coupler_inertia: values[13],
                coupler_center_x: values[14],
                coupler_center_y: values[15],
                tracer_x: values[16],
                tracer_y: values[17],
                rocker_length: values[18],
                rocker_mass: values[19],
                rocker_inertia: values[20],
                rocker_center_x: values[21],
                rocker_center_y: values[22],
                start_angle: values[23],
                start_rate: values[24],
            }
        }
        fn to_array(&self) -> [R; 25] {
            [
                self.gravity_x,
                self.gravity_y,
                self.crank_x,
                self.crank_y,
                self.rocker_x,
                self.rocker_y,
                self.crank_length,
                self.crank_mass,
                self.crank_inertia,
                self.crank_center_x,
                self.crank_center_y,
                self.coupler_length,
                self.coupler_mass,
                self.coupler_inertia,
                self.coupler_center_x,
                self.coupler_center_y,
                self.tracer_x,
                self.tracer_y,
                self.rocker_length,
                self.rocker_mass,
                self.rocker_inertia,
                self.rocker_center_x,
                self.rocker_center_y,
                self.start_angle,
                self.start_rate,
            ]
        }
    }
    impl<R: Real> Fields<R> for Outputs<R> {
        const NAMES: &'static [&'static str] = &["trace_x", "trace_y", "rocking"];
        type Array = [R; 3];
        fn from_array(values: [R; 3]) -> Self {
            ParametricFourBarOutputs {
                trace_x: values[0],
                trace_y: values[1],
                rocking: values[2],
            }
        }
        fn to_array(&self) -> [R; 3] {
            [self.trace_x, self.trace_y, self.rocking]
        }
    }
    impl<R: Real> Default for Parameters<R> {
        fn default() -> Self {
            ParametricFourBarParameters {
                gravity_x: R::from_f64(0.31),
                gravity_y: R::from_f64(-9.73),
                crank_x: R::from_f64(-0.15),
                crank_y: R::from_f64(0.24),
                rocker_x: R::from_f64(0.93),
                rocker_y: R::from_f64(0.45),
                crank_length: R::from_f64(0.4),
                crank_mass: R::from_f64(0.71),
                crank_inertia: R::from_f64(0.013),
                crank_center_x: R::from_f64(0.17),
                crank_center_y: R::from_f64(0.033),
                coupler_length: R::ONE,
                coupler_mass: R::from_f64(1.93),
                coupler_inertia: R::from_f64(0.187),
                coupler_center_x: R::from_f64(0.43),
                coupler_center_y: R::from_f64(-0.12),
                tracer_x: R::from_f64(0.62),
                tracer_y: R::from_f64(0.29),
                rocker_length: R::from_f64(0.9),
                rocker_mass: R::from_f64(1.37),
                rocker_inertia: R::from_f64(0.091),
                rocker_center_x: R::from_f64(0.52),
                rocker_center_y: R::from_f64(0.071),
                start_angle: R::from_f64(0.6981317007977318),
                start_rate: R::from_f64(3.0),
            }
        }
    }
    impl<R: Real> Default for ParametricFourBar<R> {
        fn default() -> Self {
            Self::with(Default::default(), [])
        }
    }
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
        /// The parameters the model was prepared with.
        pub fn parameters(&self) -> &Parameters<R> {
            &self.parameters
        }
        fn with(parameters: Parameters<R>, phases: Phases<R>) -> Self {
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
            let a5 = crank_center_y * crank_center_y;
            let a6 = crank_center_x.mul_add(crank_center_x, a5);
            let a7 = crank_mass * a6;
            let a8 = coupler_mass.mul_add(a4, a7);
            let a9 = crank_inertia + a8;
            let a10 = rocker_center_y * rocker_center_y;
            let a11 = rocker_center_x.mul_add(rocker_center_x, a10);
            let a12 = rocker_mass.mul_add(a11, rocker_inertia);
            let a13 = coupler_center_y * coupler_center_y;
            let a14 = coupler_center_x.mul_add(coupler_center_x, a13);
            let a15 = coupler_mass.mul_add(a14, coupler_inertia);
            let a16 = rocker_x - crank_x;
            let a17 = rocker_y - crank_y;
            let a18 = gravity_y * crank_length;
            let a19 = gravity_x * crank_center_y;
            let a20 = (-gravity_y).mul_add(crank_center_x, a19);
            let a21 = crank_mass * a20;
            let a22 = (-coupler_mass).mul_add(a18, a21);
            let a23 = gravity_x * crank_length;
            let a24 = gravity_y * crank_center_y;
            let a25 = gravity_x.mul_add(crank_center_x, a24);
            let a26 = crank_mass * a25;
            let a27 = coupler_mass.mul_add(a23, a26);
            let a28 = gravity_x * coupler_center_y;
            let a29 = (-gravity_y).mul_add(coupler_center_x, a28);
            let a30 = coupler_mass * a29;
            let a31 = gravity_y * coupler_center_y;
            let a32 = gravity_x.mul_add(coupler_center_x, a31);
            let a33 = coupler_mass * a32;
            let a34 = gravity_x * rocker_center_y;
            let a35 = (-gravity_y).mul_add(rocker_center_x, a34);
            let a36 = rocker_mass * a35;
            let a37 = gravity_y * rocker_center_y;
            let a38 = gravity_x.mul_add(rocker_center_x, a37);
            let a39 = rocker_mass * a38;
            let a40 = R::ONE / a9;
            let a41 = R::ONE / a12;
            let a42 = R::ONE / a15;
            let a43 = R::from_f64(0.8275232094153417) * coupler_length;
            let a44 = a43 * a43;
            let a45 = R::from_f64(0.971820281433286) * rocker_length;
            let a46 = a45 * a45;
            let a47 = R::from_f64(0.6427876096865394) * crank_length;
            let a48 = a47 * a47;
            let a49 = a40 * a48;
            let a50 = a41.mul_add(a46, a49);
            let a51 = a42.mul_add(a44, a50);
            let a52 = R::from_f64(2.6455251711937597) * a51;
            let a53 = R::from_f64(0.7021406963575164) * coupler_length;
            let a54 = a53 * a53;
            let a55 = R::from_f64(0.8614660779177452) * rocker_length;
            let a56 = a55 * a55;
            let a57 = R::from_f64(0.993650416208718) * crank_length;
            let a58 = a57 * a57;
            let a59 = a40 * a58;
            let a60 = a41.mul_add(a56, a59);
            let a61 = a42.mul_add(a54, a60);
            let a62 = R::from_f64(1.5347207530430917) * a61;
            let a63 = rocker_length * a41;
            let a64 = crank_length * a40;
            Self {
                parameters,
                phases,
                constants: [
                    a1,
                    a3,
                    a9,
                    a12,
                    a15,
                    crank_length,
                    coupler_length,
                    rocker_length,
                    a16,
                    a17,
                    a22,
                    a27,
                    a30,
                    a33,
                    a36,
                    a39,
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
                    a40,
                    a41,
                    a52,
                    a62,
                    a63,
                    a64,
                    tracer_x,
                    tracer_y,
                    start_angle,
                    start_rate,
                ],
            }
        }
        /// Position, velocity and acceleration of every body's centre of mass, in the order of `BODIES`,
        /// from a state and its accelerations.
        pub fn motions(
            &self,
            time: R,
            q: &Q<R>,
            v: &V<R>,
            a: &V<R>,
        ) -> [BodyMotion<R>; 3] {
            let constants = &self.constants;
            let crank_cos = q[0];
            let crank_sin = q[1];
            let rocker_cos = q[2];
            let rocker_sin = q[3];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let crank_rate = v[0];
            let rocker_rate = v[1];
            let coupler_rate = v[2];
            let crank_rate_dot = a[0];
            let rocker_rate_dot = a[1];
            let coupler_rate_dot = a[2];
            let crank_length = constants[5];
            let crank_center_x = constants[18];
            let crank_center_y = constants[19];
            let coupler_center_x = constants[22];
            let coupler_center_y = constants[23];
            let rocker_center_x = constants[26];
            let rocker_center_y = constants[27];
            let crank_x = constants[30];
            let crank_y = constants[31];
            let rocker_x = constants[32];
            let rocker_y = constants[33];
            let a0 = crank_center_x * crank_cos;
            let a1 = (-crank_center_y).mul_add(crank_sin, a0);
            let a2 = crank_x + a1;
            let a3 = crank_center_y * crank_cos;
            let a4 = crank_center_x.mul_add(crank_sin, a3);
            let a5 = crank_y + a4;
            let a6 = crank_rate * a4;
            let a7 = -a6;
            let a8 = crank_rate * a1;
            let a9 = crank_rate * crank_rate;
            let a10 = a9 * a1;
            let a11 = (-crank_rate_dot).mul_add(a4, (-a10));
            let a12 = crank_rate_dot * a1;
            let a13 = (-a9).mul_add(a4, a12);
            let a14 = crank_length * crank_cos;
            let a15 = crank_x + a14;
            let a16 = coupler_center_x * coupler_cos;
            let a17 = (-coupler_center_y).mul_add(coupler_sin, a16);
            let a18 = a15 + a17;
            let a19 = crank_length * crank_sin;
            let a20 = crank_y + a19;
            let a21 = coupler_center_y * coupler_cos;
            let a22 = coupler_center_x.mul_add(coupler_sin, a21);
            let a23 = a20 + a22;
            let a24 = crank_rate * a19;
            let a25 = (-coupler_rate).mul_add(a22, (-a24));
            let a26 = crank_rate * a14;
            let a27 = coupler_rate.mul_add(a17, a26);
            let a28 = coupler_rate * coupler_rate;
            let a29 = a14 * a9;
            let a30 = a28.mul_add(a17, a29);
            let a31 = crank_rate_dot * a19;
            let a32 = coupler_rate_dot.mul_add(a22, a31);
            let a33 = a30 + a32;
            let a34 = -a33;
            let a35 = crank_rate_dot * a14;
            let a36 = coupler_rate_dot.mul_add(a17, a35);
            let a37 = a19 * a9;
            let a38 = a28.mul_add(a22, a37);
            let a39 = a36 - a38;
            let a40 = rocker_center_x * rocker_cos;
            let a41 = (-rocker_center_y).mul_add(rocker_sin, a40);
            let a42 = rocker_x + a41;
            let a43 = rocker_center_y * rocker_cos;
            let a44 = rocker_center_x.mul_add(rocker_sin, a43);
            let a45 = rocker_y + a44;
            let a46 = rocker_rate * a44;
            let a47 = -a46;
            let a48 = rocker_rate * a41;
            let a49 = rocker_rate * rocker_rate;
            let a50 = a49 * a41;
            let a51 = (-rocker_rate_dot).mul_add(a44, (-a50));
            let a52 = rocker_rate_dot * a41;
            let a53 = (-a49).mul_add(a44, a52);
            [
                BodyMotion {
                    position: [a2, a5],
                    orientation: [crank_cos, crank_sin],
                    velocity: [a7, a8],
                    rate: crank_rate,
                    acceleration: [a11, a13],
                    angular_acceleration: crank_rate_dot,
                },
                BodyMotion {
                    position: [a18, a23],
                    orientation: [coupler_cos, coupler_sin],
                    velocity: [a25, a27],
                    rate: coupler_rate,
                    acceleration: [a34, a39],
                    angular_acceleration: coupler_rate_dot,
                },
                BodyMotion {
                    position: [a42, a45],
                    orientation: [rocker_cos, rocker_sin],
                    velocity: [a47, a48],
                    rate: rocker_rate,
                    acceleration: [a51, a53],
                    angular_acceleration: rocker_rate_dot,
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
        ) -> [Reaction<R>; 4] {
            let constants = &self.constants;
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
            let crank_length = constants[5];
            let crank_mass = constants[16];
            let crank_center_x = constants[18];
            let crank_center_y = constants[19];
            let coupler_mass = constants[20];
            let coupler_center_x = constants[22];
            let coupler_center_y = constants[23];
            let rocker_mass = constants[24];
            let rocker_center_x = constants[26];
            let rocker_center_y = constants[27];
            let gravity_x = constants[28];
            let gravity_y = constants[29];
            let a0 = crank_center_y * crank_cos;
            let a1 = crank_center_x.mul_add(crank_sin, a0);
            let a2 = crank_rate * crank_rate;
            let a3 = crank_center_x * crank_cos;
            let a4 = (-crank_center_y).mul_add(crank_sin, a3);
            let a5 = a2 * a4;
            let a6 = crank_rate_dot.mul_add(a1, a5);
            let a7 = gravity_x + a6;
            let a8 = coupler_rate * coupler_rate;
            let a9 = coupler_center_x * coupler_cos;
            let a10 = (-coupler_center_y).mul_add(coupler_sin, a9);
            let a11 = crank_length * crank_cos;
            let a12 = a11 * a2;
            let a13 = a8.mul_add(a10, a12);
            let a14 = coupler_center_y * coupler_cos;
            let a15 = coupler_center_x.mul_add(coupler_sin, a14);
            let a16 = crank_length * crank_sin;
            let a17 = crank_rate_dot * a16;
            let a18 = coupler_rate_dot.mul_add(a15, a17);
            let a19 = a13 + a18;
            let a20 = gravity_x + a19;
            let a21 = (-coupler_mass).mul_add(a20, lambda_right_x);
            let a22 = (-crank_mass).mul_add(a7, a21);
            let a23 = crank_rate_dot * a4;
            let a24 = (-a2).mul_add(a1, a23);
            let a25 = a24 - gravity_y;
            let a26 = crank_rate_dot * a11;
            let a27 = coupler_rate_dot.mul_add(a10, a26);
            let a28 = a16 * a2;
            let a29 = a8.mul_add(a15, a28);
            let a30 = a27 - a29;
            let a31 = a30 - gravity_y;
            let a32 = coupler_mass.mul_add(a31, lambda_right_y);
            let a33 = crank_mass.mul_add(a25, a32);
            let a34 = rocker_center_y * rocker_cos;
            let a35 = rocker_center_x.mul_add(rocker_sin, a34);
            let a36 = rocker_rate * rocker_rate;
            let a37 = rocker_center_x * rocker_cos;
            let a38 = (-rocker_center_y).mul_add(rocker_sin, a37);
            let a39 = a36 * a38;
            let a40 = rocker_rate_dot.mul_add(a35, a39);
            let a41 = gravity_x + a40;
            let a42 = (-rocker_mass).mul_add(a41, (-lambda_right_x));
            let a43 = rocker_rate_dot * a38;
            let a44 = (-a36).mul_add(a35, a43);
            let a45 = a44 - gravity_y;
            let a46 = rocker_mass.mul_add(a45, (-lambda_right_y));
            [
                Reaction {
                    force: [a22, a33],
                    torque: R::ZERO,
                },
                Reaction {
                    force: [a42, a46],
                    torque: R::ZERO,
                },
                Reaction {
                    force: [a21, a32],
                    torque: R::ZERO,
                },
                Reaction {
                    force: [lambda_right_x, lambda_right_y],
                    torque: R::ZERO,
                },
            ]
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
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let crank_rate = state.v[0];
            let coupler_rate = state.v[2];
            let crank_rate_dot = a[0];
            let rocker_rate_dot = a[1];
            let coupler_rate_dot = a[2];
            let k0 = constants[0];
            let k1 = constants[1];
            let k2 = constants[2];
            let k3 = constants[3];
            let k4 = constants[4];
            let k10 = constants[10];
            let k11 = constants[11];
            let k12 = constants[12];
            let k13 = constants[13];
            let k14 = constants[14];
            let k15 = constants[15];
            let a0 = crank_cos * coupler_sin;
            let a1 = (-crank_sin).mul_add(coupler_cos, a0);
            let a2 = crank_cos * coupler_cos;
            let a3 = crank_sin.mul_add(coupler_sin, a2);
            let a4 = k0 * a3;
            let a5 = (-k1).mul_add(a1, a4);
            let a6 = coupler_rate * coupler_rate;
            let a7 = k1 * a3;
            let a8 = k0.mul_add(a1, a7);
            let a9 = k10 * crank_cos;
            let a10 = k11.mul_add(crank_sin, a9);
            let a11 = a6.mul_add(a8, (-a10));
            let a12 = k2.mul_add(crank_rate_dot, (-a11));
            let a13 = coupler_rate_dot.mul_add(a5, a12);
            let a14 = k14 * rocker_cos;
            let a15 = k15.mul_add(rocker_sin, a14);
            let a16 = k3.mul_add(rocker_rate_dot, a15);
            let a17 = crank_rate * crank_rate;
            let a18 = k12 * coupler_cos;
            let a19 = k13.mul_add(coupler_sin, a18);
            let a20 = a17.mul_add(a8, a19);
            let a21 = crank_rate_dot.mul_add(a5, a20);
            let a22 = k4.mul_add(coupler_rate_dot, a21);
            [a13, a16, a22]
        }
        /// Power of each load (W), in the order of `LOADS`, what springs store included.
        pub fn powers(&self, time: R, state: &State<Q<R>, V<R>>, u: &()) -> [R; 0] {
            []
        }
        /// Effort of each driver along its quantity (N m or N) and its power (W), from the multipliers.
        pub fn driver_efforts(
            &self,
            time: R,
            q: &Q<R>,
            v: &V<R>,
            lambda: &Lambda<R>,
        ) -> [[R; 2]; 0] {
            []
        }
    }
    impl<R: Real> Variables<R> for ParametricFourBar<R> {
        const LAYOUT: Layout = Layout {
            linear: 0,
            rotations: 3,
            quaternions: 0,
            angles: &[],
        };
        type Q = Q<R>;
        type V = V<R>;
        type Lambda = Lambda<R>;
        type Z = ();
        type Gates = ();
    }
    impl<R: Real> Mechanism<R> for ParametricFourBar<R> {
        const NAME: &'static str = "ParametricFourBar";
        const ROWS: &'static [Row] = &[
            Row { of: "right", what: "x" },
            Row { of: "right", what: "y" },
        ];
        const POSITION_NAMES: &'static [&'static str] = &[
            "crank.cos",
            "crank.sin",
            "rocker.cos",
            "rocker.sin",
            "coupler.cos",
            "coupler.sin",
        ];
        const VELOCITY_NAMES: &'static [&'static str] = &[
            "crank.rate",
            "rocker.rate",
            "coupler.rate",
        ];
        const MASS_PATTERN: &'static [(u16, u16)] = &[(0, 0), (1, 1), (2, 0), (2, 2)];
        const JACOBIAN_PATTERN: &'static [(u16, u16)] = &[
            (0, 0),
            (0, 1),
            (0, 2),
            (1, 0),
            (1, 1),
            (1, 2),
        ];
        type Mass = Mass<R>;
        type Jacobian = Jacobian<R>;
        type Inputs = ();
        type Outputs = Outputs<R>;
        fn mass_matrix(&self, time: R, q: &Q<R>, out: &mut Mass<R>) {
            let constants = &self.constants;
            let crank_cos = q[0];
            let crank_sin = q[1];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let k0 = constants[0];
            let k1 = constants[1];
            let k2 = constants[2];
            let k3 = constants[3];
            let k4 = constants[4];
            let a0 = crank_cos * coupler_sin;
            let a1 = (-crank_sin).mul_add(coupler_cos, a0);
            let a2 = crank_cos * coupler_cos;
            let a3 = crank_sin.mul_add(coupler_sin, a2);
            let a4 = k0 * a3;
            let a5 = (-k1).mul_add(a1, a4);
            *out = [k2, k3, a5, k4];
        }
        fn constraints(&self, time: R, q: &Q<R>, out: &mut Lambda<R>) {
            let constants = &self.constants;
            let crank_cos = q[0];
            let crank_sin = q[1];
            let rocker_cos = q[2];
            let rocker_sin = q[3];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let crank_length = constants[5];
            let coupler_length = constants[6];
            let rocker_length = constants[7];
            let k8 = constants[8];
            let k9 = constants[9];
            let a0 = (-crank_length).mul_add(crank_cos, k8);
            let a1 = rocker_length.mul_add(rocker_cos, a0);
            let phi_right_x = coupler_length.mul_add(coupler_cos, (-a1));
            let a3 = (-crank_length).mul_add(crank_sin, k9);
            let a4 = rocker_length.mul_add(rocker_sin, a3);
            let phi_right_y = coupler_length.mul_add(coupler_sin, (-a4));
            *out = [phi_right_x, phi_right_y];
        }
        fn constraint_jacobian(&self, time: R, q: &Q<R>, out: &mut Jacobian<R>) {
            let constants = &self.constants;
            let crank_cos = q[0];
            let crank_sin = q[1];
            let rocker_cos = q[2];
            let rocker_sin = q[3];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let crank_length = constants[5];
            let coupler_length = constants[6];
            let rocker_length = constants[7];
            let a0 = crank_length * crank_sin;
            let a1 = -a0;
            let a2 = rocker_length * rocker_sin;
            let a3 = coupler_length * coupler_sin;
            let a4 = -a3;
            let a5 = crank_length * crank_cos;
            let a6 = rocker_length * rocker_cos;
            let a7 = -a6;
            let a8 = coupler_length * coupler_cos;
            *out = [a1, a2, a4, a5, a7, a8];
        }
        fn nu(&self, time: R, q: &Q<R>, out: &mut Lambda<R>) {
            *out = [R::ZERO, R::ZERO];
        }
        fn gamma(&self, time: R, q: &Q<R>, v: &V<R>, out: &mut Lambda<R>) {
            let constants = &self.constants;
            let crank_cos = q[0];
            let crank_sin = q[1];
            let rocker_cos = q[2];
            let rocker_sin = q[3];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let crank_rate = v[0];
            let rocker_rate = v[1];
            let coupler_rate = v[2];
            let crank_length = constants[5];
            let coupler_length = constants[6];
            let rocker_length = constants[7];
            let a0 = coupler_length * coupler_cos;
            let a1 = coupler_rate * coupler_rate;
            let a2 = rocker_length * rocker_cos;
            let a3 = rocker_rate * rocker_rate;
            let a4 = crank_length * crank_cos;
            let a5 = crank_rate * crank_rate;
            let a6 = a4 * a5;
            let a7 = (-a2).mul_add(a3, a6);
            let gamma_right_x = a0.mul_add(a1, a7);
            let a9 = coupler_length * coupler_sin;
            let a10 = rocker_length * rocker_sin;
            let a11 = crank_length * crank_sin;
            let a12 = a11 * a5;
            let a13 = (-a10).mul_add(a3, a12);
            let gamma_right_y = a9.mul_add(a1, a13);
            *out = [gamma_right_x, gamma_right_y];
        }
        fn forces(&self, time: R, state: &State<Q<R>, V<R>>, u: &(), out: &mut V<R>) {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let crank_rate = state.v[0];
            let coupler_rate = state.v[2];
            let k0 = constants[0];
            let k1 = constants[1];
            let k10 = constants[10];
            let k11 = constants[11];
            let k12 = constants[12];
            let k13 = constants[13];
            let k14 = constants[14];
            let k15 = constants[15];
            let a0 = coupler_rate * coupler_rate;
            let a1 = crank_cos * coupler_sin;
            let a2 = (-crank_sin).mul_add(coupler_cos, a1);
            let a3 = crank_cos * coupler_cos;
            let a4 = crank_sin.mul_add(coupler_sin, a3);
            let a5 = k1 * a4;
            let a6 = k0.mul_add(a2, a5);
            let a7 = k10 * crank_cos;
            let a8 = k11.mul_add(crank_sin, a7);
            let force_crank_rate = a0.mul_add(a6, (-a8));
            let a10 = k14 * rocker_cos;
            let force_rocker_rate = (-k15).mul_add(rocker_sin, (-a10));
            let a12 = crank_rate * crank_rate;
            let a13 = k12 * coupler_cos;
            let a14 = k13.mul_add(coupler_sin, a13);
            let force_coupler_rate = (-a12).mul_add(a6, (-a14));
            *out = [force_crank_rate, force_rocker_rate, force_coupler_rate];
        }
        fn kinetic_energy(&self, time: R, q: &Q<R>, v: &V<R>) -> R {
            let constants = &self.constants;
            let crank_cos = q[0];
            let crank_sin = q[1];
            let rocker_cos = q[2];
            let rocker_sin = q[3];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let crank_rate = v[0];
            let rocker_rate = v[1];
            let coupler_rate = v[2];
            let crank_length = constants[5];
            let crank_mass = constants[16];
            let crank_inertia = constants[17];
            let crank_center_x = constants[18];
            let crank_center_y = constants[19];
            let coupler_mass = constants[20];
            let coupler_inertia = constants[21];
            let coupler_center_x = constants[22];
            let coupler_center_y = constants[23];
            let rocker_mass = constants[24];
            let rocker_inertia = constants[25];
            let rocker_center_x = constants[26];
            let rocker_center_y = constants[27];
            let a0 = rocker_rate * rocker_rate;
            let a1 = rocker_center_x * rocker_cos;
            let a2 = (-rocker_center_y).mul_add(rocker_sin, a1);
            let a3 = rocker_rate * a2;
            let a4 = rocker_center_y * rocker_cos;
            let a5 = rocker_center_x.mul_add(rocker_sin, a4);
            let a6 = rocker_rate * a5;
            let a7 = a6 * a6;
            let a8 = a3.mul_add(a3, a7);
            let a9 = coupler_rate * coupler_rate;
            let a10 = coupler_center_x * coupler_cos;
            let a11 = (-coupler_center_y).mul_add(coupler_sin, a10);
            let a12 = crank_length * crank_cos;
            let a13 = crank_rate * a12;
            let a14 = coupler_rate.mul_add(a11, a13);
            let a15 = coupler_center_y * coupler_cos;
            let a16 = coupler_center_x.mul_add(coupler_sin, a15);
            let a17 = crank_length * crank_sin;
            let a18 = crank_rate * a17;
            let a19 = coupler_rate.mul_add(a16, a18);
            let a20 = a19 * a19;
            let a21 = a14.mul_add(a14, a20);
            let a22 = crank_rate * crank_rate;
            let a23 = crank_center_x * crank_cos;
            let a24 = (-crank_center_y).mul_add(crank_sin, a23);
            let a25 = crank_rate * a24;
            let a26 = crank_center_y * crank_cos;
            let a27 = crank_center_x.mul_add(crank_sin, a26);
            let a28 = crank_rate * a27;
            let a29 = a28 * a28;
            let a30 = a25.mul_add(a25, a29);
            let a31 = crank_mass * a30;
            let a32 = crank_inertia.mul_add(a22, a31);
            let a33 = coupler_mass.mul_add(a21, a32);
            let a34 = coupler_inertia.mul_add(a9, a33);
            let a35 = rocker_mass.mul_add(a8, a34);
            let a36 = rocker_inertia.mul_add(a0, a35);
            let a37 = R::from_f64(0.5) * a36;
            a37
        }
        fn potential_energy(&self, time: R, state: &State<Q<R>, V<R>>) -> R {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let crank_length = constants[5];
            let crank_mass = constants[16];
            let crank_center_x = constants[18];
            let crank_center_y = constants[19];
            let coupler_mass = constants[20];
            let coupler_center_x = constants[22];
            let coupler_center_y = constants[23];
            let rocker_mass = constants[24];
            let rocker_center_x = constants[26];
            let rocker_center_y = constants[27];
            let gravity_x = constants[28];
            let gravity_y = constants[29];
            let crank_x = constants[30];
            let crank_y = constants[31];
            let rocker_x = constants[32];
            let rocker_y = constants[33];
            let a0 = rocker_center_y * rocker_cos;
            let a1 = rocker_center_x.mul_add(rocker_sin, a0);
            let a2 = rocker_y + a1;
            let a3 = rocker_center_x * rocker_cos;
            let a4 = (-rocker_center_y).mul_add(rocker_sin, a3);
            let a5 = rocker_x + a4;
            let a6 = gravity_x * a5;
            let a7 = gravity_y.mul_add(a2, a6);
            let a8 = crank_length.mul_add(crank_sin, crank_y);
            let a9 = coupler_center_y * coupler_cos;
            let a10 = coupler_center_x.mul_add(coupler_sin, a9);
            let a11 = a8 + a10;
            let a12 = crank_length.mul_add(crank_cos, crank_x);
            let a13 = coupler_center_x * coupler_cos;
            let a14 = (-coupler_center_y).mul_add(coupler_sin, a13);
            let a15 = a12 + a14;
            let a16 = gravity_x * a15;
            let a17 = gravity_y.mul_add(a11, a16);
            let a18 = crank_center_y * crank_cos;
            let a19 = crank_center_x.mul_add(crank_sin, a18);
            let a20 = crank_y + a19;
            let a21 = crank_center_x * crank_cos;
            let a22 = (-crank_center_y).mul_add(crank_sin, a21);
            let a23 = crank_x + a22;
            let a24 = gravity_x * a23;
            let a25 = gravity_y.mul_add(a20, a24);
            let a26 = crank_mass * a25;
            let a27 = coupler_mass.mul_add(a17, a26);
            let a28 = (-rocker_mass).mul_add(a7, (-a27));
            a28
        }
        fn acceleration(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &(),
            a_out: &mut V<R>,
            lambda_out: &mut Lambda<R>,
        ) -> R {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let crank_rate = state.v[0];
            let rocker_rate = state.v[1];
            let coupler_rate = state.v[2];
            let k0 = constants[0];
            let k1 = constants[1];
            let k4 = constants[4];
            let crank_length = constants[5];
            let coupler_length = constants[6];
            let rocker_length = constants[7];
            let k10 = constants[10];
            let k11 = constants[11];
            let k12 = constants[12];
            let k13 = constants[13];
            let k14 = constants[14];
            let k15 = constants[15];
            let k34 = constants[34];
            let k35 = constants[35];
            let k36 = constants[36];
            let k37 = constants[37];
            let k38 = constants[38];
            let k39 = constants[39];
            let a0 = k39 * crank_cos;
            let a1 = crank_length * crank_cos;
            let a2 = crank_cos * coupler_sin;
            let a3 = (-crank_sin).mul_add(coupler_cos, a2);
            let a4 = crank_cos * coupler_cos;
            let a5 = crank_sin.mul_add(coupler_sin, a4);
            let a6 = k0 * a5;
            let a7 = (-k1).mul_add(a3, a6);
            let a8 = k34 * a7;
            let a9 = coupler_length * coupler_cos;
            let a10 = (-a1).mul_add(a8, a9);
            let a11 = crank_length * crank_sin;
            let a12 = coupler_length * coupler_sin;
            let a13 = a11.mul_add(a8, (-a12));
            let a14 = (-a7).mul_add(a8, k4);
            let a15 = R::ONE / a14;
            let a16 = a13 * a15;
            let a17 = k39 * crank_sin;
            let a18 = rocker_length * rocker_cos;
            let a19 = k38 * rocker_sin;
            let a20 = a18 * a19;
            let a21 = a1.mul_add(a17, a20);
            let a22 = (-a10).mul_add(a16, a21);
            let a23 = rocker_length * rocker_sin;
            let a24 = a23 * a19;
            let a25 = a11.mul_add(a17, a24);
            let a26 = a13.mul_add(a16, a25);
            let a27 = R::ONE / a26;
            let a28 = a22 * a27;
            let a29 = a10 * a15;
            let a30 = k38 * rocker_cos;
            let a31 = a18 * a30;
            let a32 = a1.mul_add(a0, a31);
            let a33 = a10.mul_add(a29, a32);
            let a34 = (-a22).mul_add(a28, a33);
            let a35 = R::ONE / a34;
            let a36 = coupler_rate * coupler_rate;
            let a37 = k1 * a5;
            let a38 = k0.mul_add(a3, a37);
            let a39 = k10 * crank_cos;
            let a40 = k11.mul_add(crank_sin, a39);
            let a41 = a36.mul_add(a38, (-a40));
            let a42 = crank_rate * crank_rate;
            let a43 = k12 * coupler_cos;
            let a44 = k13.mul_add(coupler_sin, a43);
            let a45 = a42.mul_add(a38, a44);
            let a46 = a41.mul_add(a8, a45);
            let a47 = k14 * rocker_cos;
            let a48 = k15.mul_add(rocker_sin, a47);
            let a49 = rocker_rate * rocker_rate;
            let a50 = a1 * a42;
            let a51 = (-a18).mul_add(a49, a50);
            let a52 = a9.mul_add(a36, a51);
            let a53 = a48.mul_add(a19, a52);
            let a54 = a41.mul_add(a17, a53);
            let a55 = a16.mul_add(a46, a54);
            let a56 = a11 * a42;
            let a57 = (-a23).mul_add(a49, a56);
            let a58 = a12.mul_add(a36, a57);
            let a59 = a48.mul_add(a30, (-a58));
            let a60 = a41.mul_add(a0, a59);
            let a61 = (-a29).mul_add(a46, a60);
            let a62 = (-a28).mul_add(a55, a61);
            let lambda_right_y_ = a35 * a62;
            let a64 = a28 * lambda_right_y_;
            let lambda_right_x_ = (-a27).mul_add(a55, a64);
            let a66 = a15 * a46;
            let a67 = a16.mul_add(lambda_right_x_, a66);
            let a68 = a29.mul_add(lambda_right_y_, a67);
            let a69 = k34 * a41;
            let a70 = a8.mul_add(a68, a69);
            let a71 = a17.mul_add(lambda_right_x_, a70);
            let crank_rate_dot_ = (-a0).mul_add(lambda_right_y_, a71);
            let a73 = k35 * a48;
            let a74 = a19.mul_add(lambda_right_x_, a73);
            let rocker_rate_dot_ = a30.mul_add(lambda_right_y_, (-a74));
            let coupler_rate_dot_ = -a68;
            let a77 = k36 * a27;
            let a78 = a35.abs();
            let a79 = k37 * a78;
            let a80 = a77.max(a79);
            let smallest_pivot = R::ONE / a80;
            *a_out = [crank_rate_dot_, rocker_rate_dot_, coupler_rate_dot_];
            *lambda_out = [lambda_right_x_, lambda_right_y_];
            smallest_pivot
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
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let crank_rate = state.v[0];
            let rocker_rate = state.v[1];
            let coupler_rate = state.v[2];
            let k0 = constants[0];
            let k1 = constants[1];
            let k4 = constants[4];
            let crank_length = constants[5];
            let coupler_length = constants[6];
            let rocker_length = constants[7];
            let k8 = constants[8];
            let k9 = constants[9];
            let k10 = constants[10];
            let k11 = constants[11];
            let k12 = constants[12];
            let k13 = constants[13];
            let k14 = constants[14];
            let k15 = constants[15];
            let k34 = constants[34];
            let k35 = constants[35];
            let k36 = constants[36];
            let k37 = constants[37];
            let k38 = constants[38];
            let k39 = constants[39];
            let a0 = k39 * crank_cos;
            let a1 = crank_length * crank_cos;
            let a2 = crank_cos * coupler_sin;
            let a3 = (-crank_sin).mul_add(coupler_cos, a2);
            let a4 = crank_cos * coupler_cos;
            let a5 = crank_sin.mul_add(coupler_sin, a4);
            let a6 = k0 * a5;
            let a7 = (-k1).mul_add(a3, a6);
            let a8 = k34 * a7;
            let a9 = coupler_length * coupler_cos;
            let a10 = (-a1).mul_add(a8, a9);
            let a11 = crank_length * crank_sin;
            let a12 = coupler_length * coupler_sin;
            let a13 = a11.mul_add(a8, (-a12));
            let a14 = (-a7).mul_add(a8, k4);
            let a15 = R::ONE / a14;
            let a16 = a13 * a15;
            let a17 = k39 * crank_sin;
            let a18 = rocker_length * rocker_cos;
            let a19 = k38 * rocker_sin;
            let a20 = a18 * a19;
            let a21 = a1.mul_add(a17, a20);
            let a22 = (-a10).mul_add(a16, a21);
            let a23 = rocker_length * rocker_sin;
            let a24 = a23 * a19;
            let a25 = a11.mul_add(a17, a24);
            let a26 = a13.mul_add(a16, a25);
            let a27 = R::ONE / a26;
            let a28 = a22 * a27;
            let a29 = a10 * a15;
            let a30 = k38 * rocker_cos;
            let a31 = a18 * a30;
            let a32 = a1.mul_add(a0, a31);
            let a33 = a10.mul_add(a29, a32);
            let a34 = (-a22).mul_add(a28, a33);
            let a35 = R::ONE / a34;
            let a36 = coupler_rate * coupler_rate;
            let a37 = k1 * a5;
            let a38 = k0.mul_add(a3, a37);
            let a39 = k10 * crank_cos;
            let a40 = k11.mul_add(crank_sin, a39);
            let a41 = a36.mul_add(a38, (-a40));
            let a42 = crank_rate * crank_rate;
            let a43 = k12 * coupler_cos;
            let a44 = k13.mul_add(coupler_sin, a43);
            let a45 = a42.mul_add(a38, a44);
            let a46 = a41.mul_add(a8, a45);
            let a47 = k14 * rocker_cos;
            let a48 = k15.mul_add(rocker_sin, a47);
            let a49 = k8 - a1;
            let a50 = a49 + a18;
            let a51 = a50 - a9;
            let a52 = rocker_rate * a23;
            let a53 = (-crank_rate).mul_add(a11, a52);
            let a54 = (-coupler_rate).mul_add(a12, a53);
            let a55 = rocker_rate * rocker_rate;
            let a56 = a1 * a42;
            let a57 = (-a18).mul_add(a55, a56);
            let a58 = a9.mul_add(a36, a57);
            let a59 = two_alpha.mul_add(a54, (-a58));
            let a60 = (-beta_squared).mul_add(a51, a59);
            let a61 = (-a48).mul_add(a19, a60);
            let a62 = (-a41).mul_add(a17, a61);
            let a63 = (-a16).mul_add(a46, a62);
            let a64 = k9 - a11;
            let a65 = a64 + a23;
            let a66 = a65 - a12;
            let a67 = crank_rate * a1;
            let a68 = (-rocker_rate).mul_add(a18, a67);
            let a69 = coupler_rate.mul_add(a9, a68);
            let a70 = a11 * a42;
            let a71 = (-a23).mul_add(a55, a70);
            let a72 = a12.mul_add(a36, a71);
            let a73 = two_alpha.mul_add(a69, (-a72));
            let a74 = (-beta_squared).mul_add(a66, a73);
            let a75 = a48.mul_add(a30, a74);
            let a76 = a41.mul_add(a0, a75);
            let a77 = (-a29).mul_add(a46, a76);
            let a78 = a28.mul_add(a63, a77);
            let lambda_right_y_ = a35 * a78;
            let a80 = a27 * a63;
            let lambda_right_x_ = a28.mul_add(lambda_right_y_, a80);
            let a82 = a15 * a46;
            let a83 = a16.mul_add(lambda_right_x_, a82);
            let a84 = a29.mul_add(lambda_right_y_, a83);
            let a85 = k34 * a41;
            let a86 = a8.mul_add(a84, a85);
            let a87 = a17.mul_add(lambda_right_x_, a86);
            let crank_rate_dot_ = (-a0).mul_add(lambda_right_y_, a87);
            let a89 = k35 * a48;
            let a90 = a19.mul_add(lambda_right_x_, a89);
            let rocker_rate_dot_ = a30.mul_add(lambda_right_y_, (-a90));
            let coupler_rate_dot_ = -a84;
            let a93 = k36 * a27;
            let a94 = a35.abs();
            let a95 = k37 * a94;
            let a96 = a93.max(a95);
            let smallest_pivot = R::ONE / a96;
            *a_out = [crank_rate_dot_, rocker_rate_dot_, coupler_rate_dot_];
            *lambda_out = [lambda_right_x_, lambda_right_y_];
            smallest_pivot
        }
        fn outputs(&self, time: R, state: &State<Q<R>, V<R>>, u: &()) -> Outputs<R> {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let crank_length = constants[5];
            let crank_x = constants[30];
            let crank_y = constants[31];
            let tracer_x = constants[40];
            let tracer_y = constants[41];
            let a0 = crank_length.mul_add(crank_cos, crank_x);
            let a1 = tracer_x * coupler_cos;
            let a2 = (-tracer_y).mul_add(coupler_sin, a1);
            let trace_x = a0 + a2;
            let a4 = crank_length.mul_add(crank_sin, crank_y);
            let a5 = tracer_y * coupler_cos;
            let a6 = tracer_x.mul_add(coupler_sin, a5);
            let trace_y = a4 + a6;
            let rocking = rocker_sin.atan2(rocker_cos);
            ParametricFourBarOutputs {
                trace_x: trace_x,
                trace_y: trace_y,
                rocking: rocking,
            }
        }
        fn unwrap(outputs: &mut Outputs<R>, previous: &Outputs<R>) {
            outputs.rocking = unwrap_angle(outputs.rocking, previous.rocking);
        }
    }
    impl<R: Real> Assemble<R> for ParametricFourBar<R> {
        const CONDITIONS: &'static [Condition] = &[
            Condition {
                of: "crank_pin.angle",
                kind: ConditionKind::Angle,
            },
        ];
        const START_CONDITIONS: &'static [u16] = &[0];
        const START_RATES: &'static [u16] = &[0];
        const INDEPENDENT: &'static [u16] = &[0];
        const FLIPS: &'static [u16] = &[];
        const DEPENDENT: &'static [(u16, u16)] = &[(0, 1), (1, 2)];
        const ROW_SIZES: &'static [f64] = &[1.5953757201770884, 1.5898406659339488];
        const SCALES: &'static [f64] = &[4.0, 1.0, 1.0];
        const CONDITION_PATTERN: &'static [(u16, u16)] = &[(0, 0)];
        const ELIMINATION: Elimination = Elimination {
            order: &[1, 2, 0, 3, 4, 5],
            position: &[2, 0, 1, 3, 4, 5],
            row_start: &[0, 0, 0, 1, 4, 8, 11],
            columns: &[1, 0, 1, 2, 0, 1, 2, 3, 2, 3, 4],
        };
        type Conditions = Conditions<R>;
        type ConditionJacobian = ConditionJacobian<R>;
        type Factor = Factor<R>;
        type System = System<R>;
        type Dense = Dense<R>;
        type Basis = Basis<R>;
        type Reduced = Reduced<R>;
        type Choice = [u16; 3];
        fn choice() -> [u16; 3] {
            [0; 3]
        }
        fn condition_residual(
            &self,
            time: R,
            q: &Q<R>,
            target: &Conditions<R>,
            out: &mut Conditions<R>,
        ) {
            let crank_cos = q[0];
            let crank_sin = q[1];
            let target_crank_pin_angle = target[0];
            let a0 = target_crank_pin_angle.sin();
            let a1 = target_crank_pin_angle.cos();
            let a2 = crank_sin * a1;
            let a3 = (-crank_cos).mul_add(a0, a2);
            *out = [a3];
        }
        fn condition_cosines(
            &self,
            time: R,
            q: &Q<R>,
            target: &Conditions<R>,
            out: &mut Conditions<R>,
        ) {
            let crank_cos = q[0];
            let crank_sin = q[1];
            let target_crank_pin_angle = target[0];
            let a0 = target_crank_pin_angle.sin();
            let a1 = target_crank_pin_angle.cos();
            let a2 = crank_cos * a1;
            let a3 = crank_sin.mul_add(a0, a2);
            *out = [a3];
        }
        fn condition_jacobian(&self, time: R, q: &Q<R>, out: &mut ConditionJacobian<R>) {
            *out = [R::ONE];
        }
        fn condition_bias(&self, time: R, q: &Q<R>, v: &V<R>, out: &mut Conditions<R>) {
            *out = [R::ZERO];
        }
        fn condition_drift(&self, time: R, q: &Q<R>, out: &mut Conditions<R>) {
            *out = [R::ZERO];
        }
        fn row_cosines(&self, time: R, q: &Q<R>, out: &mut Lambda<R>) {
            *out = [R::ONE, R::ONE];
        }
        fn row_scales(&self, out: &mut Lambda<R>) {
            let constants = &self.constants;
            let k36 = constants[36];
            let k37 = constants[37];
            *out = [k36, k37];
        }
        fn start_targets(
            &self,
            positions: &mut Conditions<R>,
            rates: &mut Conditions<R>,
        ) {
            let constants = &self.constants;
            let start_angle = constants[42];
            let start_rate = constants[43];
            *positions = [start_angle];
            *rates = [start_rate];
        }
        type Store = tabled::Store<R, Self>;
        fn store() -> Self::Store {
            tabled::store::<R, Self>()
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
            tabled::solve::<R, Self>(store, forces, rows, a, lambda)
        }
        type Lu = ();
        fn lu() {}
        fn start_q() -> Q<R> {
            [
                R::from_f64(0.7660444431189781),
                R::from_f64(0.6427876096865394),
                R::from_f64(-0.23572301668468654),
                R::from_f64(0.971820281433286),
                R::from_f64(0.561431507736191),
                R::from_f64(0.8275232094153417),
            ]
        }
        fn start_v() -> V<R> {
            [
                R::from_f64(3.0),
                R::from_f64(-0.49151144248599554),
                R::from_f64(-1.4516086406815356),
            ]
        }
    }
};
const _: ::core::option::Option<&'static ::core::primitive::str> = ::core::option_env!(
    "LINKWRIGHT_SELF_CHECK"
);
