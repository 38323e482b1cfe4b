/// A four-bar that a torsion spring holds, with more inputs than it needs.
///
///Equations of motion of the planar mechanism `Gripper`.
#[cfg_attr(
    doc,
    doc = ::linkwright::__private::v1::mechanism_page!{#[doc = r" A four-bar that a torsion spring holds, with more inputs than it needs."]pub
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
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Gripper<R = ::core::primitive::f64> {
    parameters: GripperParameters<R>,
    phases: [R; 0],
    constants: [R; 21],
}
///Parameters of [`Gripper`], in SI units.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct GripperParameters<R = ::core::primitive::f64> {
    ///`N*m/rad`, default 6.0 in SI units.
    pub stiffness: R,
    ///`m`, default 0.9 in SI units.
    pub length: R,
    ///`kg`, default 1.2 in SI units.
    pub weight: R,
}
///Inputs of [`Gripper`], in SI units.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct GripperInputs<R = ::core::primitive::f64> {
    ///`N*m` (SI).
    pub drive: R,
    ///`N` (SI).
    pub pull: R,
}
///Outputs of [`Gripper`], in SI units.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct GripperOutputs<R = ::core::primitive::f64> {
    ///`m` (SI).
    pub reach: R,
    ///`rad` (SI).
    pub swing: R,
    ///`rad/s` (SI).
    pub swinging: R,
    ///`J` (SI).
    pub stored: R,
}
///Positions and velocities of [`Gripper`].
pub type GripperState<R = ::core::primitive::f64> = ::linkwright::__private::v1::State<
    [R; 8],
    [R; 3],
>;
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
    pub const OPERATIONS: ::core::primitive::usize = 105;
    ///The definition as written.
    pub const SOURCE: &'static ::core::primitive::str = (
        "# [doc = r\" A four-bar that a torsion spring holds, with more inputs than it needs.\"] pub planar Gripper { param stiffness [N * m / rad] = 6 ; param length [m] = 0.9 ; param weight [kg] = 1.2 in 0.1 .. 10 ; input drive [N * m] ; input pull [N] ; gravity [m / s ^ 2] = (0 , - 9.81) ; rod crank { mass [kg] = weight ; length [m] = 0.4 ; } rod coupler { mass [kg] = 0.8 ; length [m] = length ; } rod rocker { mass [kg] = 0.6 ; length [m] = 0.7 ; } joint a : revolute (ground (0 , 0) [m] , crank . start) ; joint b : revolute (crank . end , coupler . start) ; joint c : revolute (coupler . end , rocker . end) ; joint d : revolute (ground (0.8 , 0) [m] , rocker . start) ; torsion_spring coil : torsion_spring (a , stiffness = stiffness , angle = 40 [deg] , damping = 0.2 [N * m * s / rad]) ; torque motor : torque (a) = drive ; force rope : force (coupler . center , direction = (1 , 2)) = pull ; start { a . angle [deg] = 70 ; a . rate [rad / s] = 1 ; d . angle [deg] ~ 80 ; coupler . angle [rad] ~ 0.3 ; } options { emit = (tangent) ; } expect { degrees_of_freedom = 1 ; } output reach [m] = coupler . center . x ; output swing [rad] = d . angle ; output swinging [rad / s] = d . rate ; output stored [J] = potential_energy ; }",
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
    use ::core::primitive::{bool, f64, u16, u32, usize, str};
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
        fn from_array(values: [R; 3]) -> Self {
            GripperParameters {
                stiffness: values[0],
                length: values[1],
                weight: values[2],
            }
        }
        fn to_array(&self) -> [R; 3] {
            [self.stiffness, self.length, self.weight]
        }
    }
    impl<R: Real> Fields<R> for Inputs<R> {
        const NAMES: &'static [&'static str] = &["drive", "pull"];
        type Array = [R; 2];
        fn from_array(values: [R; 2]) -> Self {
            GripperInputs {
                drive: values[0],
                pull: values[1],
            }
        }
        fn to_array(&self) -> [R; 2] {
            [self.drive, self.pull]
        }
    }
    impl<R: Real> Fields<R> for Outputs<R> {
        const NAMES: &'static [&'static str] = &["reach", "swing", "swinging", "stored"];
        type Array = [R; 4];
        fn from_array(values: [R; 4]) -> Self {
            GripperOutputs {
                reach: values[0],
                swing: values[1],
                swinging: values[2],
                stored: values[3],
            }
        }
        fn to_array(&self) -> [R; 4] {
            [self.reach, self.swing, self.swinging, self.stored]
        }
    }
    impl<R: Real> Default for Parameters<R> {
        fn default() -> Self {
            GripperParameters {
                stiffness: R::from_f64(6.0),
                length: R::from_f64(0.9),
                weight: R::from_f64(1.2),
            }
        }
    }
    impl<R: Real> Default for Gripper<R> {
        fn default() -> Self {
            Self::with(Default::default(), [])
        }
    }
    impl<R: Real> Gripper<R> {
        /// The model with these parameters; what depends on nothing else is computed once, here.
        ///
        /// # Errors
        /// A parameter that is not finite or out of its bounds, or a mass that is not positive.
        pub fn prepare(parameters: Parameters<R>) -> Result<Self, SettingError> {
            check_finite("stiffness", parameters.stiffness)?;
            check_finite("length", parameters.length)?;
            check_setting(
                "weight",
                parameters.weight,
                0.1,
                10.0,
                "from 0.1 to 10.0 in SI units, by its declaration",
            )?;
            let model = Self::with(parameters, []);
            check_mass("mass of \"crank\"", model.constants[8], true)?;
            check_mass("inertia of \"crank\"", model.constants[9], true)?;
            check_mass("inertia of \"coupler\"", model.constants[10], true)?;
            check_mass("length of \"coupler\"", model.constants[3], true)?;
            check_constants(&model.constants)?;
            Ok(model)
        }
        /// The parameters the model was prepared with.
        pub fn parameters(&self) -> &Parameters<R> {
            &self.parameters
        }
        fn with(parameters: Parameters<R>, phases: Phases<R>) -> Self {
            let stiffness = parameters.stiffness;
            let length = parameters.length;
            let weight = parameters.weight;
            let a0 = R::from_f64(0.16000000000000003) * length;
            let a1 = R::from_f64(0.013333333333333336) * weight;
            let a2 = R::from_f64(0.04000000000000001)
                .mul_add(weight, R::from_f64(0.12800000000000003));
            let a3 = a1 + a2;
            let a4 = R::from_f64(0.5) * length;
            let a5 = a4 * a4;
            let a6 = length * length;
            let a7 = R::from_f64(0.06666666666666667) * a6;
            let a8 = R::from_f64(0.8).mul_add(a5, a7);
            let a9 = R::from_f64(1.9620000000000002) * weight;
            let a10 = a9 + R::from_f64(3.1392000000000007);
            let a11 = R::from_f64(3.9240000000000004) * length;
            let a12 = R::from_f64(0.5) * stiffness;
            let a13 = R::ONE / a3;
            let a14 = R::ONE / a8;
            let a15 = R::from_f64(0.8553343370791797) * length;
            let a16 = a15 * a15;
            let a17 = R::from_f64(0.005234360729529799)
                .mul_add(a13, R::from_f64(4.963666551909257));
            let a18 = a14.mul_add(a16, a17);
            let a19 = R::from_f64(2.0686756477018693) * a18;
            let a20 = R::from_f64(0.8401161899960727) * length;
            let a21 = a20 * a20;
            let a22 = R::from_f64(0.15682644486514283)
                .mul_add(a13, R::from_f64(1.974689704964116));
            let a23 = a14.mul_add(a21, a22);
            let a24 = R::from_f64(1.471067913519537) * a23;
            let a25 = a0 * a13;
            let a26 = R::from_f64(0.4) * a13;
            let a27 = R::from_f64(0.22360679774997896) * length;
            let a28 = R::from_f64(0.4472135954999579) * length;
            let a29 = R::from_f64(0.5333333333333333) * length;
            Self {
                parameters,
                phases,
                constants: [
                    a0,
                    a3,
                    a8,
                    length,
                    stiffness,
                    a4,
                    a10,
                    a11,
                    weight,
                    a1,
                    a7,
                    a9,
                    a12,
                    a13,
                    a19,
                    a24,
                    a25,
                    a26,
                    a27,
                    a28,
                    a29,
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
            let k5 = constants[5];
            let a0 = R::from_f64(0.2) * crank_cos;
            let a1 = R::from_f64(0.2) * crank_sin;
            let a2 = crank_rate * a1;
            let a3 = -a2;
            let a4 = crank_rate * a0;
            let a5 = crank_rate * crank_rate;
            let a6 = a5 * a0;
            let a7 = (-crank_rate_dot).mul_add(a1, (-a6));
            let a8 = crank_rate_dot * a0;
            let a9 = (-a5).mul_add(a1, a8);
            let a10 = R::from_f64(0.4) * crank_cos;
            let a11 = k5 * coupler_cos;
            let a12 = a10 + a11;
            let a13 = R::from_f64(0.4) * crank_sin;
            let a14 = k5 * coupler_sin;
            let a15 = a13 + a14;
            let a16 = crank_rate * a13;
            let a17 = (-coupler_rate).mul_add(a14, (-a16));
            let a18 = crank_rate * a10;
            let a19 = coupler_rate.mul_add(a11, a18);
            let a20 = coupler_rate * coupler_rate;
            let a21 = a10 * a5;
            let a22 = a20.mul_add(a11, a21);
            let a23 = crank_rate_dot * a13;
            let a24 = coupler_rate_dot.mul_add(a14, a23);
            let a25 = a22 + a24;
            let a26 = -a25;
            let a27 = crank_rate_dot * a10;
            let a28 = coupler_rate_dot.mul_add(a11, a27);
            let a29 = a13 * a5;
            let a30 = a20.mul_add(a14, a29);
            let a31 = a28 - a30;
            let a32 = R::from_f64(0.35) * rocker_cos;
            let a33 = R::from_f64(0.8) + a32;
            let a34 = R::from_f64(0.35) * rocker_sin;
            let a35 = rocker_rate * a34;
            let a36 = -a35;
            let a37 = rocker_rate * a32;
            let a38 = rocker_rate * rocker_rate;
            let a39 = a38 * a32;
            let a40 = (-rocker_rate_dot).mul_add(a34, (-a39));
            let a41 = rocker_rate_dot * a32;
            let a42 = (-a38).mul_add(a34, a41);
            [
                BodyMotion {
                    position: [a0, a1],
                    orientation: [crank_cos, crank_sin],
                    velocity: [a3, a4],
                    rate: crank_rate,
                    acceleration: [a7, a9],
                    angular_acceleration: crank_rate_dot,
                },
                BodyMotion {
                    position: [a12, a15],
                    orientation: [coupler_cos, coupler_sin],
                    velocity: [a17, a19],
                    rate: coupler_rate,
                    acceleration: [a26, a31],
                    angular_acceleration: coupler_rate_dot,
                },
                BodyMotion {
                    position: [a33, a34],
                    orientation: [rocker_cos, rocker_sin],
                    velocity: [a36, a37],
                    rate: rocker_rate,
                    acceleration: [a40, a42],
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
            u: &Inputs<R>,
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
            let pull = u.pull;
            let crank_rate_dot = a[0];
            let rocker_rate_dot = a[1];
            let coupler_rate_dot = a[2];
            let lambda_c_x = lambda[0];
            let lambda_c_y = lambda[1];
            let k5 = constants[5];
            let weight = constants[8];
            let a0 = R::from_f64(0.2) * crank_sin;
            let a1 = crank_rate * crank_rate;
            let a2 = R::from_f64(0.2) * crank_cos;
            let a3 = a1 * a2;
            let a4 = crank_rate_dot.mul_add(a0, a3);
            let a5 = coupler_rate * coupler_rate;
            let a6 = k5 * coupler_cos;
            let a7 = R::from_f64(0.4) * crank_cos;
            let a8 = a7 * a1;
            let a9 = a5.mul_add(a6, a8);
            let a10 = k5 * coupler_sin;
            let a11 = R::from_f64(0.4) * crank_sin;
            let a12 = crank_rate_dot * a11;
            let a13 = coupler_rate_dot.mul_add(a10, a12);
            let a14 = a9 + a13;
            let a15 = R::from_f64(0.4472135954999579) * pull;
            let a16 = R::from_f64(0.8).mul_add(a14, a15);
            let a17 = lambda_c_x - a16;
            let a18 = (-weight).mul_add(a4, a17);
            let a19 = crank_rate_dot * a2;
            let a20 = (-a1).mul_add(a0, a19);
            let a21 = R::from_f64(9.81) + a20;
            let a22 = crank_rate_dot * a7;
            let a23 = coupler_rate_dot.mul_add(a6, a22);
            let a24 = a11 * a1;
            let a25 = a5.mul_add(a10, a24);
            let a26 = a23 - a25;
            let a27 = R::from_f64(9.81) + a26;
            let a28 = R::from_f64(0.8) * a27;
            let a29 = R::from_f64(-0.8944271909999159).mul_add(pull, a28);
            let a30 = lambda_c_y + a29;
            let a31 = weight.mul_add(a21, a30);
            let a32 = R::from_f64(0.35) * rocker_sin;
            let a33 = rocker_rate * rocker_rate;
            let a34 = R::from_f64(0.35) * rocker_cos;
            let a35 = a33 * a34;
            let a36 = rocker_rate_dot.mul_add(a32, a35);
            let a37 = R::from_f64(-0.6).mul_add(a36, (-lambda_c_x));
            let a38 = rocker_rate_dot * a34;
            let a39 = (-a33).mul_add(a32, a38);
            let a40 = R::from_f64(9.81) + a39;
            let a41 = R::from_f64(0.6).mul_add(a40, (-lambda_c_y));
            [
                Reaction {
                    force: [a18, a31],
                    torque: R::ZERO,
                },
                Reaction {
                    force: [a17, a30],
                    torque: R::ZERO,
                },
                Reaction {
                    force: [lambda_c_x, lambda_c_y],
                    torque: R::ZERO,
                },
                Reaction {
                    force: [a37, a41],
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
            u: &Inputs<R>,
            a: &V<R>,
        ) -> V<R> {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
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
            let k0 = constants[0];
            let k1 = constants[1];
            let k2 = constants[2];
            let stiffness = constants[4];
            let k5 = constants[5];
            let k6 = constants[6];
            let k7 = constants[7];
            let a0 = R::from_f64(0.4) * crank_cos;
            let a1 = R::from_f64(0.8944271909999159) * pull;
            let a2 = R::from_f64(0.4) * crank_sin;
            let a3 = R::from_f64(0.4472135954999579) * pull;
            let a4 = crank_cos * coupler_cos;
            let a5 = crank_sin.mul_add(coupler_sin, a4);
            let a6 = k0 * a5;
            let a7 = coupler_rate * coupler_rate;
            let a8 = crank_cos * coupler_sin;
            let a9 = (-crank_sin).mul_add(coupler_cos, a8);
            let a10 = k0 * a9;
            let a11 = a7 * a10;
            let a12 = (-k6).mul_add(crank_cos, a11);
            let a13 = k1.mul_add(crank_rate_dot, (-a12));
            let a14 = coupler_rate_dot.mul_add(a6, a13);
            let a15 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a16 = a15 - R::from_f64(0.6981317007977318);
            let a17 = stiffness * a16;
            let a18 = R::from_f64(0.2).mul_add(crank_rate, a17);
            let a19 = a14 + a18;
            let a20 = a19 - drive;
            let a21 = a2.mul_add(a3, a20);
            let a22 = (-a0).mul_add(a1, a21);
            let a23 = R::from_f64(2.0601) * rocker_cos;
            let a24 = R::from_f64(0.09799999999999998).mul_add(rocker_rate_dot, a23);
            let a25 = k5 * coupler_cos;
            let a26 = k5 * coupler_sin;
            let a27 = crank_rate * crank_rate;
            let a28 = k7 * coupler_cos;
            let a29 = a27.mul_add(a10, a28);
            let a30 = crank_rate_dot.mul_add(a6, a29);
            let a31 = k2.mul_add(coupler_rate_dot, a30);
            let a32 = a26.mul_add(a3, a31);
            let a33 = (-a25).mul_add(a1, a32);
            [a22, a24, a33]
        }
        /// Power of each load (W), in the order of `LOADS`, what springs store included.
        pub fn powers(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &Inputs<R>,
        ) -> [R; 3] {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let a_turns = state.q[6];
            let a_remainder = state.q[7];
            let crank_rate = state.v[0];
            let coupler_rate = state.v[2];
            let drive = u.drive;
            let pull = u.pull;
            let stiffness = constants[4];
            let k5 = constants[5];
            let a0 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a1 = a0 - R::from_f64(0.6981317007977318);
            let a2 = stiffness * a1;
            let a3 = R::from_f64(0.2).mul_add(crank_rate, a2);
            let a4 = crank_rate * a3;
            let a5 = -a4;
            let a6 = crank_rate * drive;
            let a7 = k5 * coupler_sin;
            let a8 = R::from_f64(0.4) * crank_sin;
            let a9 = crank_rate * a8;
            let a10 = coupler_rate.mul_add(a7, a9);
            let a11 = R::from_f64(0.4472135954999579) * pull;
            let a12 = k5 * coupler_cos;
            let a13 = R::from_f64(0.4) * crank_cos;
            let a14 = crank_rate * a13;
            let a15 = coupler_rate.mul_add(a12, a14);
            let a16 = R::from_f64(0.8944271909999159) * pull;
            let a17 = a15 * a16;
            let a18 = (-a10).mul_add(a11, a17);
            [a5, a6, a18]
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
    impl<R: Real> Variables<R> for Gripper<R> {
        const LAYOUT: Layout = Layout {
            linear: 0,
            rotations: 3,
            quaternions: 0,
            angles: &[MultiTurn { rate: &[(0, 1.0)] }],
        };
        type Q = Q<R>;
        type V = V<R>;
        type Lambda = Lambda<R>;
        type Z = ();
        type Gates = ();
    }
    impl<R: Real> Mechanism<R> for Gripper<R> {
        const NAME: &'static str = "Gripper";
        const ROWS: &'static [Row] = &[
            Row { of: "c", what: "x" },
            Row { of: "c", what: "y" },
        ];
        const POSITION_NAMES: &'static [&'static str] = &[
            "crank.cos",
            "crank.sin",
            "rocker.cos",
            "rocker.sin",
            "coupler.cos",
            "coupler.sin",
            "a.turns",
            "a.remainder",
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
        type Inputs = Inputs<R>;
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
            let a0 = crank_cos * coupler_cos;
            let a1 = crank_sin.mul_add(coupler_sin, a0);
            let a2 = k0 * a1;
            *out = [k1, R::from_f64(0.09799999999999998), a2, k2];
        }
        fn constraints(&self, time: R, q: &Q<R>, out: &mut Lambda<R>) {
            let constants = &self.constants;
            let crank_cos = q[0];
            let crank_sin = q[1];
            let rocker_cos = q[2];
            let rocker_sin = q[3];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let length = constants[3];
            let a0 = R::from_f64(-0.4).mul_add(crank_cos, R::from_f64(0.8));
            let a1 = R::from_f64(0.7).mul_add(rocker_cos, a0);
            let phi_c_x = length.mul_add(coupler_cos, (-a1));
            let a3 = R::from_f64(0.7) * rocker_sin;
            let a4 = R::from_f64(-0.4).mul_add(crank_sin, a3);
            let phi_c_y = length.mul_add(coupler_sin, (-a4));
            *out = [phi_c_x, phi_c_y];
        }
        fn constraint_jacobian(&self, time: R, q: &Q<R>, out: &mut Jacobian<R>) {
            let constants = &self.constants;
            let crank_cos = q[0];
            let crank_sin = q[1];
            let rocker_cos = q[2];
            let rocker_sin = q[3];
            let coupler_cos = q[4];
            let coupler_sin = q[5];
            let length = constants[3];
            let a0 = R::from_f64(-0.4) * crank_sin;
            let a1 = R::from_f64(0.7) * rocker_sin;
            let a2 = length * coupler_sin;
            let a3 = -a2;
            let a4 = R::from_f64(0.4) * crank_cos;
            let a5 = R::from_f64(-0.7) * rocker_cos;
            let a6 = length * coupler_cos;
            *out = [a0, a1, a3, a4, a5, a6];
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
            let length = constants[3];
            let a0 = length * coupler_cos;
            let a1 = coupler_rate * coupler_rate;
            let a2 = R::from_f64(0.7) * rocker_cos;
            let a3 = rocker_rate * rocker_rate;
            let a4 = R::from_f64(0.4) * crank_cos;
            let a5 = crank_rate * crank_rate;
            let a6 = a4 * a5;
            let a7 = (-a2).mul_add(a3, a6);
            let gamma_c_x = a0.mul_add(a1, a7);
            let a9 = length * coupler_sin;
            let a10 = R::from_f64(0.7) * rocker_sin;
            let a11 = R::from_f64(0.4) * crank_sin;
            let a12 = a11 * a5;
            let a13 = (-a10).mul_add(a3, a12);
            let gamma_c_y = a9.mul_add(a1, a13);
            *out = [gamma_c_x, gamma_c_y];
        }
        fn forces(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &Inputs<R>,
            out: &mut V<R>,
        ) {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let a_turns = state.q[6];
            let a_remainder = state.q[7];
            let crank_rate = state.v[0];
            let coupler_rate = state.v[2];
            let drive = u.drive;
            let pull = u.pull;
            let k0 = constants[0];
            let stiffness = constants[4];
            let k5 = constants[5];
            let k6 = constants[6];
            let k7 = constants[7];
            let a0 = R::from_f64(0.4) * crank_cos;
            let a1 = R::from_f64(0.8944271909999159) * pull;
            let a2 = R::from_f64(0.4) * crank_sin;
            let a3 = R::from_f64(0.4472135954999579) * pull;
            let a4 = coupler_rate * coupler_rate;
            let a5 = crank_cos * coupler_sin;
            let a6 = (-crank_sin).mul_add(coupler_cos, a5);
            let a7 = k0 * a6;
            let a8 = a4 * a7;
            let a9 = (-k6).mul_add(crank_cos, a8);
            let a10 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a11 = a10 - R::from_f64(0.6981317007977318);
            let a12 = stiffness * a11;
            let a13 = R::from_f64(0.2).mul_add(crank_rate, a12);
            let a14 = a9 - a13;
            let a15 = drive + a14;
            let a16 = (-a2).mul_add(a3, a15);
            let force_crank_rate = a0.mul_add(a1, a16);
            let force_rocker_rate = R::from_f64(-2.0601) * rocker_cos;
            let a19 = k5 * coupler_cos;
            let a20 = k5 * coupler_sin;
            let a21 = crank_rate * crank_rate;
            let a22 = k7 * coupler_cos;
            let a23 = a21.mul_add(a7, a22);
            let a24 = a20.mul_add(a3, a23);
            let force_coupler_rate = a19.mul_add(a1, (-a24));
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
            let k5 = constants[5];
            let weight = constants[8];
            let k9 = constants[9];
            let k10 = constants[10];
            let a0 = rocker_rate * rocker_rate;
            let a1 = R::from_f64(0.35) * rocker_cos;
            let a2 = rocker_rate * a1;
            let a3 = R::from_f64(0.35) * rocker_sin;
            let a4 = rocker_rate * a3;
            let a5 = a4 * a4;
            let a6 = a2.mul_add(a2, a5);
            let a7 = coupler_rate * coupler_rate;
            let a8 = k5 * coupler_cos;
            let a9 = R::from_f64(0.4) * crank_cos;
            let a10 = crank_rate * a9;
            let a11 = coupler_rate.mul_add(a8, a10);
            let a12 = k5 * coupler_sin;
            let a13 = R::from_f64(0.4) * crank_sin;
            let a14 = crank_rate * a13;
            let a15 = coupler_rate.mul_add(a12, a14);
            let a16 = a15 * a15;
            let a17 = a11.mul_add(a11, a16);
            let a18 = crank_rate * crank_rate;
            let a19 = R::from_f64(0.2) * crank_cos;
            let a20 = crank_rate * a19;
            let a21 = R::from_f64(0.2) * crank_sin;
            let a22 = crank_rate * a21;
            let a23 = a22 * a22;
            let a24 = a20.mul_add(a20, a23);
            let a25 = weight * a24;
            let a26 = k9.mul_add(a18, a25);
            let a27 = R::from_f64(0.8).mul_add(a17, a26);
            let a28 = k10.mul_add(a7, a27);
            let a29 = R::from_f64(0.6).mul_add(a6, a28);
            let a30 = R::from_f64(0.024499999999999994).mul_add(a0, a29);
            let a31 = R::from_f64(0.5) * a30;
            a31
        }
        fn potential_energy(&self, time: R, state: &State<Q<R>, V<R>>) -> R {
            let constants = &self.constants;
            let crank_sin = state.q[1];
            let rocker_sin = state.q[3];
            let coupler_sin = state.q[5];
            let a_turns = state.q[6];
            let a_remainder = state.q[7];
            let k5 = constants[5];
            let k11 = constants[11];
            let k12 = constants[12];
            let a0 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a1 = a0 - R::from_f64(0.6981317007977318);
            let a2 = a1 * a1;
            let a3 = R::from_f64(0.4) * crank_sin;
            let a4 = k5.mul_add(coupler_sin, a3);
            let a5 = k11 * crank_sin;
            let a6 = R::from_f64(7.848000000000001).mul_add(a4, a5);
            let a7 = R::from_f64(2.0601).mul_add(rocker_sin, a6);
            let a8 = k12.mul_add(a2, a7);
            a8
        }
        fn acceleration(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &Inputs<R>,
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
            let a_turns = state.q[6];
            let a_remainder = state.q[7];
            let crank_rate = state.v[0];
            let rocker_rate = state.v[1];
            let coupler_rate = state.v[2];
            let drive = u.drive;
            let pull = u.pull;
            let k0 = constants[0];
            let k2 = constants[2];
            let length = constants[3];
            let stiffness = constants[4];
            let k5 = constants[5];
            let k6 = constants[6];
            let k7 = constants[7];
            let k13 = constants[13];
            let k14 = constants[14];
            let k15 = constants[15];
            let k16 = constants[16];
            let k17 = constants[17];
            let a0 = k17 * crank_cos;
            let a1 = R::from_f64(0.4) * crank_cos;
            let a2 = crank_cos * coupler_cos;
            let a3 = crank_sin.mul_add(coupler_sin, a2);
            let a4 = k16 * a3;
            let a5 = length * coupler_cos;
            let a6 = (-a1).mul_add(a4, a5);
            let a7 = R::from_f64(0.4) * crank_sin;
            let a8 = length * coupler_sin;
            let a9 = a7.mul_add(a4, (-a8));
            let a10 = k0 * a3;
            let a11 = (-a10).mul_add(a4, k2);
            let a12 = R::ONE / a11;
            let a13 = a9 * a12;
            let a14 = k17 * crank_sin;
            let a15 = R::from_f64(0.7) * rocker_cos;
            let a16 = R::from_f64(7.142857142857145) * rocker_sin;
            let a17 = a15 * a16;
            let a18 = a1.mul_add(a14, a17);
            let a19 = (-a6).mul_add(a13, a18);
            let a20 = R::from_f64(0.7) * rocker_sin;
            let a21 = a20 * a16;
            let a22 = a7.mul_add(a14, a21);
            let a23 = a9.mul_add(a13, a22);
            let a24 = R::ONE / a23;
            let a25 = a19 * a24;
            let a26 = a6 * a12;
            let a27 = R::from_f64(7.142857142857145) * rocker_cos;
            let a28 = a15 * a27;
            let a29 = a1.mul_add(a0, a28);
            let a30 = a6.mul_add(a26, a29);
            let a31 = (-a19).mul_add(a25, a30);
            let a32 = R::ONE / a31;
            let a33 = R::from_f64(0.8944271909999159) * pull;
            let a34 = R::from_f64(0.4472135954999579) * pull;
            let a35 = coupler_rate * coupler_rate;
            let a36 = crank_cos * coupler_sin;
            let a37 = (-crank_sin).mul_add(coupler_cos, a36);
            let a38 = k0 * a37;
            let a39 = a35 * a38;
            let a40 = (-k6).mul_add(crank_cos, a39);
            let a41 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a42 = a41 - R::from_f64(0.6981317007977318);
            let a43 = stiffness * a42;
            let a44 = R::from_f64(0.2).mul_add(crank_rate, a43);
            let a45 = a40 - a44;
            let a46 = drive + a45;
            let a47 = (-a7).mul_add(a34, a46);
            let a48 = a1.mul_add(a33, a47);
            let a49 = k5 * coupler_cos;
            let a50 = k5 * coupler_sin;
            let a51 = crank_rate * crank_rate;
            let a52 = k7 * coupler_cos;
            let a53 = a51.mul_add(a38, a52);
            let a54 = a50.mul_add(a34, a53);
            let a55 = a49.mul_add(a33, (-a54));
            let a56 = (-a48).mul_add(a4, a55);
            let a57 = R::from_f64(2.0601) * rocker_cos;
            let a58 = rocker_rate * rocker_rate;
            let a59 = a1 * a51;
            let a60 = (-a15).mul_add(a58, a59);
            let a61 = a5.mul_add(a35, a60);
            let a62 = a57.mul_add(a16, a61);
            let a63 = a48.mul_add(a14, a62);
            let a64 = a13.mul_add(a56, (-a63));
            let a65 = a7 * a51;
            let a66 = (-a20).mul_add(a58, a65);
            let a67 = a8.mul_add(a35, a66);
            let a68 = a57.mul_add(a27, (-a67));
            let a69 = a48.mul_add(a0, a68);
            let a70 = a26.mul_add(a56, a69);
            let a71 = a25.mul_add(a64, a70);
            let lambda_c_y_ = a32 * a71;
            let a73 = a24 * a64;
            let lambda_c_x_ = a25.mul_add(lambda_c_y_, a73);
            let a75 = a12 * a56;
            let a76 = (-a13).mul_add(lambda_c_x_, a75);
            let coupler_rate_dot_ = (-a26).mul_add(lambda_c_y_, a76);
            let a78 = k13 * a48;
            let a79 = (-a4).mul_add(coupler_rate_dot_, a78);
            let a80 = a14.mul_add(lambda_c_x_, a79);
            let crank_rate_dot_ = (-a0).mul_add(lambda_c_y_, a80);
            let a82 = R::from_f64(21.021428571428576) * rocker_cos;
            let a83 = a16.mul_add(lambda_c_x_, a82);
            let rocker_rate_dot_ = a27.mul_add(lambda_c_y_, (-a83));
            let a85 = k14 * a24;
            let a86 = a32.abs();
            let a87 = k15 * a86;
            let a88 = a85.max(a87);
            let smallest_pivot = R::ONE / a88;
            *a_out = [crank_rate_dot_, rocker_rate_dot_, coupler_rate_dot_];
            *lambda_out = [lambda_c_x_, lambda_c_y_];
            smallest_pivot
        }
        fn acceleration_baumgarte(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &Inputs<R>,
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
            let a_turns = state.q[6];
            let a_remainder = state.q[7];
            let crank_rate = state.v[0];
            let rocker_rate = state.v[1];
            let coupler_rate = state.v[2];
            let drive = u.drive;
            let pull = u.pull;
            let k0 = constants[0];
            let k2 = constants[2];
            let length = constants[3];
            let stiffness = constants[4];
            let k5 = constants[5];
            let k6 = constants[6];
            let k7 = constants[7];
            let k13 = constants[13];
            let k14 = constants[14];
            let k15 = constants[15];
            let k16 = constants[16];
            let k17 = constants[17];
            let a0 = k17 * crank_cos;
            let a1 = R::from_f64(0.4) * crank_cos;
            let a2 = crank_cos * coupler_cos;
            let a3 = crank_sin.mul_add(coupler_sin, a2);
            let a4 = k16 * a3;
            let a5 = length * coupler_cos;
            let a6 = (-a1).mul_add(a4, a5);
            let a7 = R::from_f64(0.4) * crank_sin;
            let a8 = length * coupler_sin;
            let a9 = a7.mul_add(a4, (-a8));
            let a10 = k0 * a3;
            let a11 = (-a10).mul_add(a4, k2);
            let a12 = R::ONE / a11;
            let a13 = a9 * a12;
            let a14 = k17 * crank_sin;
            let a15 = R::from_f64(0.7) * rocker_cos;
            let a16 = R::from_f64(7.142857142857145) * rocker_sin;
            let a17 = a15 * a16;
            let a18 = a1.mul_add(a14, a17);
            let a19 = (-a6).mul_add(a13, a18);
            let a20 = R::from_f64(0.7) * rocker_sin;
            let a21 = a20 * a16;
            let a22 = a7.mul_add(a14, a21);
            let a23 = a9.mul_add(a13, a22);
            let a24 = R::ONE / a23;
            let a25 = a19 * a24;
            let a26 = a6 * a12;
            let a27 = R::from_f64(7.142857142857145) * rocker_cos;
            let a28 = a15 * a27;
            let a29 = a1.mul_add(a0, a28);
            let a30 = a6.mul_add(a26, a29);
            let a31 = (-a19).mul_add(a25, a30);
            let a32 = R::ONE / a31;
            let a33 = R::from_f64(0.8944271909999159) * pull;
            let a34 = R::from_f64(0.4472135954999579) * pull;
            let a35 = coupler_rate * coupler_rate;
            let a36 = crank_cos * coupler_sin;
            let a37 = (-crank_sin).mul_add(coupler_cos, a36);
            let a38 = k0 * a37;
            let a39 = a35 * a38;
            let a40 = (-k6).mul_add(crank_cos, a39);
            let a41 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a42 = a41 - R::from_f64(0.6981317007977318);
            let a43 = stiffness * a42;
            let a44 = R::from_f64(0.2).mul_add(crank_rate, a43);
            let a45 = a40 - a44;
            let a46 = drive + a45;
            let a47 = (-a7).mul_add(a34, a46);
            let a48 = a1.mul_add(a33, a47);
            let a49 = k5 * coupler_cos;
            let a50 = k5 * coupler_sin;
            let a51 = crank_rate * crank_rate;
            let a52 = k7 * coupler_cos;
            let a53 = a51.mul_add(a38, a52);
            let a54 = a50.mul_add(a34, a53);
            let a55 = a49.mul_add(a33, (-a54));
            let a56 = (-a48).mul_add(a4, a55);
            let a57 = R::from_f64(2.0601) * rocker_cos;
            let a58 = R::from_f64(0.8) - a1;
            let a59 = a58 + a15;
            let a60 = a59 - a5;
            let a61 = rocker_rate * a20;
            let a62 = (-crank_rate).mul_add(a7, a61);
            let a63 = (-coupler_rate).mul_add(a8, a62);
            let a64 = rocker_rate * rocker_rate;
            let a65 = a1 * a51;
            let a66 = (-a15).mul_add(a64, a65);
            let a67 = a5.mul_add(a35, a66);
            let a68 = two_alpha.mul_add(a63, (-a67));
            let a69 = (-beta_squared).mul_add(a60, a68);
            let a70 = (-a57).mul_add(a16, a69);
            let a71 = (-a48).mul_add(a14, a70);
            let a72 = a13.mul_add(a56, a71);
            let a73 = a20 - a7;
            let a74 = a73 - a8;
            let a75 = crank_rate * a1;
            let a76 = (-rocker_rate).mul_add(a15, a75);
            let a77 = coupler_rate.mul_add(a5, a76);
            let a78 = a7 * a51;
            let a79 = (-a20).mul_add(a64, a78);
            let a80 = a8.mul_add(a35, a79);
            let a81 = two_alpha.mul_add(a77, (-a80));
            let a82 = (-beta_squared).mul_add(a74, a81);
            let a83 = a57.mul_add(a27, a82);
            let a84 = a48.mul_add(a0, a83);
            let a85 = a26.mul_add(a56, a84);
            let a86 = a25.mul_add(a72, a85);
            let lambda_c_y_ = a32 * a86;
            let a88 = a24 * a72;
            let lambda_c_x_ = a25.mul_add(lambda_c_y_, a88);
            let a90 = a12 * a56;
            let a91 = (-a13).mul_add(lambda_c_x_, a90);
            let coupler_rate_dot_ = (-a26).mul_add(lambda_c_y_, a91);
            let a93 = k13 * a48;
            let a94 = (-a4).mul_add(coupler_rate_dot_, a93);
            let a95 = a14.mul_add(lambda_c_x_, a94);
            let crank_rate_dot_ = (-a0).mul_add(lambda_c_y_, a95);
            let a97 = R::from_f64(21.021428571428576) * rocker_cos;
            let a98 = a16.mul_add(lambda_c_x_, a97);
            let rocker_rate_dot_ = a27.mul_add(lambda_c_y_, (-a98));
            let a100 = k14 * a24;
            let a101 = a32.abs();
            let a102 = k15 * a101;
            let a103 = a100.max(a102);
            let smallest_pivot = R::ONE / a103;
            *a_out = [crank_rate_dot_, rocker_rate_dot_, coupler_rate_dot_];
            *lambda_out = [lambda_c_x_, lambda_c_y_];
            smallest_pivot
        }
        fn outputs(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &Inputs<R>,
        ) -> Outputs<R> {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let rocker_sin = state.q[3];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let a_turns = state.q[6];
            let a_remainder = state.q[7];
            let rocker_rate = state.v[1];
            let k5 = constants[5];
            let k11 = constants[11];
            let k12 = constants[12];
            let a0 = R::from_f64(0.4) * crank_cos;
            let reach = k5.mul_add(coupler_cos, a0);
            let swing = rocker_sin.atan2(rocker_cos);
            let a3 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a4 = a3 - R::from_f64(0.6981317007977318);
            let a5 = a4 * a4;
            let a6 = R::from_f64(0.4) * crank_sin;
            let a7 = k5.mul_add(coupler_sin, a6);
            let a8 = k11 * crank_sin;
            let a9 = R::from_f64(7.848000000000001).mul_add(a7, a8);
            let a10 = R::from_f64(2.0601).mul_add(rocker_sin, a9);
            let stored = k12.mul_add(a5, a10);
            GripperOutputs {
                reach: reach,
                swing: swing,
                swinging: rocker_rate,
                stored: stored,
            }
        }
        fn unwrap(outputs: &mut Outputs<R>, previous: &Outputs<R>) {
            outputs.swing = unwrap_angle(outputs.swing, previous.swing);
        }
    }
    impl<R: Real> Assemble<R> for Gripper<R> {
        const CONDITIONS: &'static [Condition] = &[
            Condition {
                of: "a.angle",
                kind: ConditionKind::Linear,
            },
        ];
        const START_CONDITIONS: &'static [u16] = &[0];
        const START_RATES: &'static [u16] = &[0];
        const INDEPENDENT: &'static [u16] = &[0];
        const FLIPS: &'static [u16] = &[];
        const DEPENDENT: &'static [(u16, u16)] = &[(0, 1), (1, 2)];
        const ROW_SIZES: &'static [f64] = &[1.394904042702733, 1.0867628625141583];
        const SCALES: &'static [f64] = &[2.0, 2.0, 1.0];
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
            let a_turns = q[6];
            let a_remainder = q[7];
            let target_a_angle = target[0];
            let a0 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a1 = a0 - target_a_angle;
            *out = [a1];
        }
        fn condition_cosines(
            &self,
            time: R,
            q: &Q<R>,
            target: &Conditions<R>,
            out: &mut Conditions<R>,
        ) {
            *out = [R::ONE];
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
            let k14 = constants[14];
            let k15 = constants[15];
            *out = [k14, k15];
        }
        fn start_targets(
            &self,
            positions: &mut Conditions<R>,
            rates: &mut Conditions<R>,
        ) {
            *positions = [R::from_f64(1.2217304763960306)];
            *rates = [R::ONE];
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
                R::from_f64(0.34202014332566893),
                R::from_f64(0.9396926207859084),
                R::from_f64(0.2652451324560043),
                R::from_f64(0.9641810098256431),
                R::from_f64(0.943181705987706),
                R::from_f64(0.3322773984039853),
                R::ZERO,
                R::from_f64(1.2217304763960306),
            ]
        }
        fn start_v() -> V<R> {
            [R::ONE, R::from_f64(0.5376077677321333), R::from_f64(-0.043575398512411094)]
        }
    }
    impl<R: Real> Tangent<R> for Gripper<R> {
        const STATES: &'static [u16] = &[0];
        const STIFFNESS_PATTERN: &'static [(u16, u16)] = &[
            (0, 0),
            (0, 2),
            (1, 1),
            (2, 0),
            (2, 2),
        ];
        const DAMPING_PATTERN: &'static [(u16, u16)] = &[(0, 0), (0, 2), (2, 0)];
        const ROW_STIFFNESS_PATTERN: &'static [(u16, u16)] = &[
            (0, 0),
            (0, 1),
            (0, 2),
            (1, 0),
            (1, 1),
            (1, 2),
        ];
        const ROW_DAMPING_PATTERN: &'static [(u16, u16)] = &[
            (0, 0),
            (0, 1),
            (0, 2),
            (1, 0),
            (1, 1),
            (1, 2),
        ];
        const RATE_PATTERN: &'static [(u16, u16)] = &[
            (0, 0),
            (0, 1),
            (0, 2),
            (1, 0),
            (1, 1),
            (1, 2),
        ];
        const INPUT_PATTERN: &'static [(u16, u16)] = &[(0, 0), (0, 1), (2, 1)];
        const PARAMETER_PATTERN: &'static [(u16, u16)] = &[
            (0, 0),
            (0, 1),
            (0, 2),
            (2, 1),
            (3, 1),
            (4, 1),
            (5, 1),
            (6, 1),
            (7, 1),
            (8, 1),
            (9, 1),
            (12, 0),
            (12, 1),
            (12, 2),
        ];
        const OUTPUT_PATTERN: &'static [(u16, u16)] = &[
            (0, 0),
            (0, 2),
            (1, 1),
            (2, 4),
            (3, 0),
            (3, 1),
            (3, 2),
        ];
        const COORDINATE_PATTERN: &'static [(u16, u16)] = &[(0, 3)];
        type Stiffness = Stiffness<R>;
        type Damping = Damping<R>;
        type RowStiffness = RowStiffness<R>;
        type RowDamping = RowDamping<R>;
        type RateTangent = RateTangent<R>;
        type InputTangent = InputTangent<R>;
        type ParameterTangent = ParameterTangent<R>;
        type OutputTangent = OutputTangent<R>;
        type CoordinateTangent = CoordinateTangent<R>;
        type StateMatrix = StateMatrix<R>;
        type InputMatrix = InputMatrix<R>;
        type OutputMatrix = OutputMatrix<R>;
        type Feedthrough = Feedthrough<R>;
        type Unknowns = Unknowns<R>;
        type Bordered = Bordered<R>;
        type Parameters = Parameters<R>;
        type Order = [u16; 5];
        fn order() -> [u16; 5] {
            [0; 5]
        }
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
            let a0 = R::from_f64(0.4) * crank_cos;
            let a1 = R::from_f64(0.4) * crank_sin;
            let a2 = R::from_f64(0.8944271909999159) * pull;
            let a3 = R::from_f64(0.4472135954999579) * pull;
            let a4 = crank_cos * coupler_cos;
            let a5 = crank_sin.mul_add(coupler_sin, a4);
            let a6 = k0 * a5;
            let a7 = coupler_rate * coupler_rate;
            let a8 = crank_cos * coupler_sin;
            let a9 = (-crank_sin).mul_add(coupler_cos, a8);
            let a10 = k0 * a9;
            let a11 = a7 * a10;
            let a12 = (-k6).mul_add(crank_cos, a11);
            let a13 = k1.mul_add(crank_rate_dot, (-a12));
            let a14 = coupler_rate_dot.mul_add(a6, a13);
            let a15 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a16 = a15 - R::from_f64(0.6981317007977318);
            let a17 = stiffness * a16;
            let a18 = R::from_f64(0.2).mul_add(crank_rate, a17);
            let a19 = a14 + a18;
            let a20 = a19 - drive;
            let a21 = a1.mul_add(a3, a20);
            let a22 = (-a0).mul_add(a2, a21);
            let a23 = (-a1).mul_add(lambda_c_x, a22);
            let a24 = a0.mul_add(lambda_c_y, a23);
            let a25 = R::from_f64(0.7) * rocker_cos;
            let a26 = R::from_f64(0.7) * rocker_sin;
            let a27 = R::from_f64(2.0601) * rocker_cos;
            let a28 = R::from_f64(0.09799999999999998).mul_add(rocker_rate_dot, a27);
            let a29 = a26.mul_add(lambda_c_x, a28);
            let a30 = (-a25).mul_add(lambda_c_y, a29);
            let a31 = length * coupler_cos;
            let a32 = length * coupler_sin;
            let a33 = k5 * coupler_cos;
            let a34 = k5 * coupler_sin;
            let a35 = crank_rate * crank_rate;
            let a36 = k7 * coupler_cos;
            let a37 = a35.mul_add(a10, a36);
            let a38 = crank_rate_dot.mul_add(a6, a37);
            let a39 = k2.mul_add(coupler_rate_dot, a38);
            let a40 = a34.mul_add(a3, a39);
            let a41 = (-a33).mul_add(a2, a40);
            let a42 = (-a32).mul_add(lambda_c_x, a41);
            let a43 = a31.mul_add(lambda_c_y, a42);
            *out = [a24, a30, a43];
        }
        fn rate_tangent(&self, time: R, q: &Q<R>, v: &V<R>, out: &mut RateTangent<R>) {
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
            let length = constants[3];
            let a0 = R::from_f64(0.4) * crank_cos;
            let a1 = crank_rate * a0;
            let a2 = -a1;
            let a3 = R::from_f64(0.7) * rocker_cos;
            let a4 = rocker_rate * a3;
            let a5 = length * coupler_cos;
            let a6 = coupler_rate * a5;
            let a7 = -a6;
            let a8 = R::from_f64(0.4) * crank_sin;
            let a9 = crank_rate * a8;
            let a10 = -a9;
            let a11 = R::from_f64(0.7) * rocker_sin;
            let a12 = rocker_rate * a11;
            let a13 = length * coupler_sin;
            let a14 = coupler_rate * a13;
            let a15 = -a14;
            *out = [a2, a4, a7, a10, a12, a15];
        }
        fn input_tangent(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &Inputs<R>,
            out: &mut InputTangent<R>,
        ) {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let k18 = constants[18];
            let k19 = constants[19];
            let a0 = R::from_f64(0.17888543819998318) * crank_sin;
            let a1 = R::from_f64(-0.35777087639996635).mul_add(crank_cos, a0);
            let a2 = k18 * coupler_sin;
            let a3 = (-k19).mul_add(coupler_cos, a2);
            *out = [R::from_f64(-1.0), a1, a3];
        }
        fn parameter_tangent(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &Inputs<R>,
            a: &V<R>,
            lambda: &Lambda<R>,
            out: &mut ParameterTangent<R>,
        ) {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let a_turns = state.q[6];
            let a_remainder = state.q[7];
            let crank_rate = state.v[0];
            let coupler_rate = state.v[2];
            let pull = u.pull;
            let crank_rate_dot = a[0];
            let coupler_rate_dot = a[2];
            let lambda_c_x = lambda[0];
            let lambda_c_y = lambda[1];
            let k20 = constants[20];
            let a0 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a1 = a0 - R::from_f64(0.6981317007977318);
            let a2 = coupler_rate * coupler_rate;
            let a3 = crank_cos * coupler_sin;
            let a4 = (-crank_sin).mul_add(coupler_cos, a3);
            let a5 = R::from_f64(0.16000000000000003) * a4;
            let a6 = crank_cos * coupler_cos;
            let a7 = crank_sin.mul_add(coupler_sin, a6);
            let a8 = R::from_f64(0.16000000000000003) * a7;
            let a9 = coupler_rate_dot * a8;
            let a10 = (-a2).mul_add(a5, a9);
            let a11 = R::from_f64(1.9620000000000002) * crank_cos;
            let a12 = R::from_f64(0.053333333333333344).mul_add(crank_rate_dot, a11);
            let a13 = R::from_f64(0.8944271909999159) * pull;
            let a14 = R::from_f64(0.5) * coupler_cos;
            let a15 = R::from_f64(0.4472135954999579) * pull;
            let a16 = R::from_f64(0.5) * coupler_sin;
            let a17 = crank_rate * crank_rate;
            let a18 = R::from_f64(3.9240000000000004) * coupler_cos;
            let a19 = a17.mul_add(a5, a18);
            let a20 = crank_rate_dot.mul_add(a8, a19);
            let a21 = k20.mul_add(coupler_rate_dot, a20);
            let a22 = a15.mul_add(a16, a21);
            let a23 = (-a13).mul_add(a14, a22);
            let a24 = (-coupler_sin).mul_add(lambda_c_x, a23);
            let a25 = coupler_cos.mul_add(lambda_c_y, a24);
            let a26 = coupler_cos * a2;
            let a27 = (-coupler_sin).mul_add(coupler_rate_dot, (-a26));
            let a28 = coupler_cos * coupler_rate_dot;
            let a29 = (-coupler_sin).mul_add(a2, a28);
            let a30 = coupler_sin * coupler_rate;
            let a31 = -a30;
            let a32 = coupler_cos * coupler_rate;
            let a33 = a1 * a1;
            let a34 = R::from_f64(0.5) * a33;
            let a35 = R::from_f64(3.9240000000000004) * coupler_sin;
            let a36 = R::from_f64(1.9620000000000002) * crank_sin;
            *out = [
                a1,
                a10,
                a12,
                a25,
                a27,
                a29,
                a31,
                a32,
                coupler_cos,
                coupler_sin,
                a14,
                a34,
                a35,
                a36,
            ];
        }
        fn output_tangent(
            &self,
            time: R,
            state: &State<Q<R>, V<R>>,
            u: &Inputs<R>,
            lambda: &Lambda<R>,
            out: &mut OutputTangent<R>,
        ) {
            let constants = &self.constants;
            let crank_cos = state.q[0];
            let crank_sin = state.q[1];
            let rocker_cos = state.q[2];
            let coupler_cos = state.q[4];
            let coupler_sin = state.q[5];
            let a_turns = state.q[6];
            let a_remainder = state.q[7];
            let stiffness = constants[4];
            let k5 = constants[5];
            let k6 = constants[6];
            let k7 = constants[7];
            let a0 = R::from_f64(-0.4) * crank_sin;
            let a1 = k5 * coupler_sin;
            let a2 = -a1;
            let a3 = R::from_f64(6.283185307179586).mul_add(a_turns, a_remainder);
            let a4 = a3 - R::from_f64(0.6981317007977318);
            let a5 = k6 * crank_cos;
            let a6 = stiffness.mul_add(a4, a5);
            let a7 = R::from_f64(2.0601) * rocker_cos;
            let a8 = k7 * coupler_cos;
            *out = [a0, a2, R::ONE, R::ONE, a6, a7, a8];
        }
        fn coordinate_tangent(
            &self,
            time: R,
            q: &Q<R>,
            v: &V<R>,
            a: &V<R>,
            out: &mut CoordinateTangent<R>,
        ) {
            *out = [R::ONE];
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
            let a0 = R::from_f64(0.4) * crank_sin;
            let a1 = R::from_f64(0.4) * crank_cos;
            let a2 = R::from_f64(0.8944271909999159) * pull;
            let a3 = R::from_f64(0.4472135954999579) * pull;
            let a4 = crank_cos * coupler_sin;
            let a5 = (-crank_sin).mul_add(coupler_cos, a4);
            let a6 = k0 * a5;
            let a7 = coupler_rate * coupler_rate;
            let a8 = crank_cos * coupler_cos;
            let a9 = crank_sin.mul_add(coupler_sin, a8);
            let a10 = k0 * a9;
            let a11 = a7 * a10;
            let a12 = k6.mul_add(crank_sin, (-a11));
            let a13 = coupler_rate_dot.mul_add(a6, (-a12));
            let a14 = stiffness + a13;
            let a15 = a1.mul_add(a3, a14);
            let a16 = a0.mul_add(a2, a15);
            let a17 = (-a1).mul_add(lambda_c_x, a16);
            let a18 = (-a0).mul_add(lambda_c_y, a17);
            let a19 = (-coupler_rate_dot).mul_add(a6, (-a11));
            let a20 = R::from_f64(0.7) * rocker_sin;
            let a21 = R::from_f64(0.7) * rocker_cos;
            let a22 = a21 * lambda_c_x;
            let a23 = R::from_f64(-2.0601).mul_add(rocker_sin, a22);
            let a24 = a20.mul_add(lambda_c_y, a23);
            let a25 = crank_rate * crank_rate;
            let a26 = a25 * a10;
            let a27 = crank_rate_dot.mul_add(a6, (-a26));
            let a28 = length * coupler_sin;
            let a29 = length * coupler_cos;
            let a30 = k5 * coupler_sin;
            let a31 = k5 * coupler_cos;
            let a32 = (-k7).mul_add(coupler_sin, a26);
            let a33 = (-crank_rate_dot).mul_add(a6, a32);
            let a34 = a31.mul_add(a3, a33);
            let a35 = a30.mul_add(a2, a34);
            let a36 = (-a29).mul_add(lambda_c_x, a35);
            let a37 = (-a28).mul_add(lambda_c_y, a36);
            let a38 = R::from_f64(2.0) * coupler_rate;
            let a39 = a38 * a6;
            let a40 = -a39;
            let a41 = R::from_f64(2.0) * crank_rate;
            let a42 = a41 * a6;
            *stiffness_out = [a18, a19, a24, a27, a37];
            *damping_out = [R::from_f64(0.2), a40, a42];
        }
        fn row_tangent(
            &self,
            time: R,
            q: &Q<R>,
            v: &V<R>,
            a: &V<R>,
            stiffness_out: &mut RowStiffness<R>,
            damping_out: &mut RowDamping<R>,
        ) {
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
            let length = constants[3];
            let a0 = R::from_f64(0.4) * crank_cos;
            let a1 = R::from_f64(0.4) * crank_sin;
            let a2 = crank_rate * crank_rate;
            let a3 = a1 * a2;
            let a4 = (-crank_rate_dot).mul_add(a0, a3);
            let a5 = R::from_f64(0.7) * rocker_sin;
            let a6 = rocker_rate * rocker_rate;
            let a7 = R::from_f64(0.7) * rocker_cos;
            let a8 = rocker_rate_dot * a7;
            let a9 = (-a5).mul_add(a6, a8);
            let a10 = length * coupler_cos;
            let a11 = length * coupler_sin;
            let a12 = coupler_rate * coupler_rate;
            let a13 = a11 * a12;
            let a14 = (-coupler_rate_dot).mul_add(a10, a13);
            let a15 = a0 * a2;
            let a16 = (-crank_rate_dot).mul_add(a1, (-a15));
            let a17 = a7 * a6;
            let a18 = rocker_rate_dot.mul_add(a5, a17);
            let a19 = a10 * a12;
            let a20 = (-coupler_rate_dot).mul_add(a11, (-a19));
            let a21 = R::from_f64(2.0) * crank_rate;
            let a22 = a0 * a21;
            let a23 = -a22;
            let a24 = R::from_f64(2.0) * rocker_rate;
            let a25 = a7 * a24;
            let a26 = R::from_f64(2.0) * coupler_rate;
            let a27 = a10 * a26;
            let a28 = -a27;
            let a29 = a1 * a21;
            let a30 = -a29;
            let a31 = a5 * a24;
            let a32 = a11 * a26;
            let a33 = -a32;
            *stiffness_out = [a4, a9, a14, a16, a18, a20];
            *damping_out = [a23, a25, a28, a30, a31, a33];
        }
    }
};
const _: ::core::option::Option<&'static ::core::primitive::str> = ::core::option_env!(
    "LINKWRIGHT_SELF_CHECK"
);
