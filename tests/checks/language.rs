//! The macro in unkind surroundings: names that emitted code uses itself, modules without a prelude, several
//! mechanisms in one module, visibilities, another path to the crate. What does not compile is a failed test.

use linkwright::{AssembleExt, Fields, Mechanism, Simulation};

/// The user's own items by the names of the prelude, of the primitives and of the runtime.
#[allow(dead_code, non_camel_case_types)]
mod shadowed {
    pub struct Option;
    pub struct Some;
    pub struct Result;
    pub struct Ok;
    pub struct Default;
    pub struct Clone;
    pub struct Copy;
    pub struct Debug;
    pub struct PartialEq;
    pub struct Into;
    pub struct Vec;
    pub struct f64;
    pub struct usize;
    pub struct str;
    pub struct bool;
    pub struct Real;
    pub struct State;
    pub struct Layout;
    pub struct Assemble;
    pub struct Parameters;
    pub struct Inputs;
    pub struct Q;
    pub struct R;
    pub mod core {}
    pub mod std {}
    pub mod linkwright {}

    ::linkwright::mechanism! {
        pub planar Shadowed {
            param length [m] = 1 in 0.1..2;
            input push [N];
            rod arm { mass [kg] = 1; length [m] = length; }
            joint pivot: revolute(ground(0, 0) [m], arm.start);
            force hand: force(arm.end) = (push, 0);
            start { pivot.angle [rad] = 0.5; }
            output height [m] = arm.end.y;
        }
    }
}

mod bare {
    #![no_implicit_prelude]

    ::linkwright::mechanism! {
        pub(crate) planar Bare {
            param length [m] = 1;
            rod arm { mass [kg] = 1; length [m] = length; }
            joint pivot: revolute(ground(0, 0) [m], arm.start);
            start { pivot.angle [rad] = 0.5; }
            output height [m] = arm.end.y;
        }
    }
}

/// Two in one module, one of them seen from there only.
mod several {
    linkwright::mechanism! {
        pub(super) planar First {
            gravity [m/s^2] = (0, -9.81);
            rod arm { mass [kg] = 1; length [m] = 1; }
            joint pivot: revolute(ground(0, 0) [m], arm.start);
            start { pivot.angle [rad] = 0; }
        }
    }
    linkwright::mechanism! {
        planar Second {
            gravity [m/s^2] = (0, -9.81);
            rod arm { mass [kg] = 1; length [m] = 2; }
            joint pivot: revolute(ground(0, 0) [m], arm.start);
            start { pivot.angle [rad] = 0; }
        }
    }

    pub fn second() -> (&'static str, [f64; 2]) {
        (Second::<f64>::default().name(), Second::START.q)
    }
    use linkwright::Mechanism;
}

mod elsewhere {
    pub use linkwright as renamed;
}

linkwright::mechanism! {
    planar ByAnotherPath {
        options { crate = crate::language::elsewhere::renamed; }
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        start { pivot.angle [rad] = 0.5; }
        output height [m] = arm.end.y;
    }
}

linkwright::mechanism! {
    /// Names that are units, functions, or words of the language and of emitted code.
    planar Named {
        param q [m] = 1;
        param v [kg] = 1;
        param time_ [1] = 1;
        param a0 [1] = 1;
        param k0 [1] = 1;
        param self_ [1] = 2;
        input u [N*m];
        input rpm [N];
        rod kg { mass [kg] = v; length [m] = q; }
        rod m { mass [kg] = v*a0; length [m] = 1; }
        rod lambda { mass [kg] = 1; length [m] = k0 * 1 [m]; }
        joint w: revolute(ground(0, 0) [m], kg.start);
        joint s: revolute(kg.end, m.start);
        joint out: revolute(m.end, lambda.start);
        torque constants: torque(w) = u;
        force target: force(lambda.end) = (rpm, 0);
        start { w.angle [rad] = 0.5; s.angle [rad] = 0.1; out.angle [rad] = 0.1; }
        output a [m] = kg.end.x;
        output time_scale [1] = time_ * self_;
        output dot [rad/s] = w.rate;
    }
}

/// All of them exist, start where they were told to, and move.
#[test]
fn they_all_run() {
    let model = shadowed::Shadowed::default();
    let start = model.assemble(&shadowed::Shadowed::START).expect("it is consistent");
    let inputs = |_: f64, _: &shadowed::ShadowedState| shadowed::ShadowedInputs { push: 1.0 };
    Simulation::new(&model, start).sampled(inputs).step(1e-3).advance_until(0.1).expect("it runs");

    let model = bare::Bare::<f64>::prepare(bare::BareParameters { length: 2.0 }).expect("a length");
    let start = model.assemble(&bare::Bare::START).expect("it is consistent");
    let height = Simulation::new(&model, start).step(1e-3).sample().outputs.height;
    assert!((height - 2.0 * 0.5_f64.sin()).abs() < 1e-12, "{height}");

    assert_eq!(several::First::START.q, [1.0, 0.0]);
    assert_eq!(several::second(), ("Second", [1.0, 0.0]));

    let model = ByAnotherPath::<f64>::default();
    let outputs: ByAnotherPathOutputs = model.outputs(0.0, &ByAnotherPath::START, &());
    assert!((outputs.height - 0.5_f64.sin()).abs() < 1e-12);
    assert_eq!(ByAnotherPathOutputs::<f64>::NAMES, ["height"]);
}

#[test]
fn names_stay_what_they_were() {
    assert_eq!(NamedParameters::<f64>::NAMES, ["q", "v", "time_", "a0", "k0", "self_"]);
    assert_eq!(NamedInputs::<f64>::NAMES, ["u", "rpm"]);
    let model =
        Named::<f64>::prepare(NamedParameters { self_: 3.0, ..Default::default() }).expect("positive");
    let inputs = NamedInputs { u: 1.0, rpm: 0.5 };
    let outputs: NamedOutputs = model.outputs(0.0, &Named::START, &inputs);
    assert!((outputs.a - 0.5_f64.cos()).abs() < 1e-12 && outputs.time_scale == 3.0 && outputs.dot == 0.0);
    let (mut a, mut lambda) = ([0.0; 3], []);
    let pivot = model.acceleration(0.0, &Named::START, &inputs, &mut a, &mut lambda);
    assert!(pivot > 0.0 && a.iter().all(|a| a.is_finite() && *a != 0.0), "{a:?}");
}

/// Within a function, where items are the block's.
#[test]
fn a_mechanism_in_a_function() {
    linkwright::mechanism! {
        planar Local {
            gravity [m/s^2] = (0, -9.81);
            particle ball { mass [kg] = 2; }
            start { ball.center.x [m] = 0; ball.center.y [m] = 3; }
            output height [m] = ball.center.y;
        }
    }
    let model = Local::<f64>::default();
    let end = Simulation::new(&model, Local::START).step(1e-2).advance_until(0.5).expect("it falls");
    assert!((end.q[1] - (3.0 - 9.81 * 0.125)).abs() < 1e-12, "{end:?}");
}

/// Mechanisms by the names that emitted code uses for something else.
mod awkward {
    macro_rules! pendulum {
        ($($module:ident $name:ident),* $(,)?) => { $(
            pub mod $module {
                linkwright::mechanism! {
                    pub planar $name {
                        input push [N];
                        rod arm { mass [kg] = 1; length [m] = 1; }
                        joint pivot: revolute(ground(0, 0) [m], arm.start);
                        force hand: force(arm.end) = (push, 0);
                        start { pivot.angle [rad] = 0.5; }
                        output height [m] = arm.end.y;
                    }
                }
            }
        )* };
    }
    pendulum!(
        q Q, v V, mechanism Mechanism, state State, system System, layout Layout, inputs Inputs, outputs Outputs,
        parameters Parameters, real Real, row Row, mass Mass, factor Factor, option Option, result Result, some Some,
        default Default, my_inputs MyInputs, my_outputs MyOutputs, vector Vector, fields Fields, constants Constants,
    );

    #[test]
    fn they_are_what_they_are_called() {
        use linkwright::Mechanism as _;
        macro_rules! check {
            ($($module:ident $name:ident),* $(,)?) => { $(
                let model = $module::$name::<f64>::default();
                let outputs = model.outputs(0.0, &$module::$name::START, &linkwright::Fields::from_array([0.0]));
                assert!((outputs.height - 0.5_f64.sin()).abs() < 1e-12);
                assert_eq!(<$module::$name>::default().name(), stringify!($name));
            )* };
        }
        check!(
            q Q, v V, mechanism Mechanism, state State, system System, layout Layout, inputs Inputs, outputs Outputs,
            parameters Parameters, real Real, row Row, mass Mass, factor Factor, option Option, result Result, some Some,
            default Default, my_inputs MyInputs, my_outputs MyOutputs, vector Vector, fields Fields, constants Constants,
        );
    }
}

/// A line of the ground that moves and does not turn.
mod moving_line {
    macro_rules! on_a_line {
        ($name:ident, $coordinates:ident) => {
            ::linkwright::mechanism! {
                pub planar $name {
                    gravity [m/s^2] = (0, -9.81);
                    signal lift [m] = 0.1 [m]*sin(3 [rad/s]*time);
                    line ramp = (ground(0 [m], lift), ground(0.8 [m], lift + 0.6 [m]));
                    particle bead { mass [kg] = 2; }
                    joint ride: point_on_line(ramp, bead.center);
                    start { ride.travel [m] = 0.3; ride.speed [m/s] = 0; }
                    options { coordinates = $coordinates; }
                    output travel [m] = ride.travel;
                    output pressed [N] = ride.reaction.normal;
                }
            }
        };
    }
    on_a_line!(Carried, tree);
    on_a_line!(Tied, absolute);
}

/// Along a line that rises by 3 in 5: s̈ = −(g + ÿ) 3/5, N = m (g + ÿ) 4/5.
#[test]
fn a_bead_slides_on_a_line_that_moves() {
    fn ends<M: linkwright::Assemble<f64, Inputs = (), Outputs: Fields<f64>>>(model: &M) -> [f64; 2] {
        let mut simulation = Simulation::new(model, model.start()).step(1e-3);
        simulation.run_until(0.5, |_| ()).expect("it slides");
        let found = simulation.sample().outputs.to_array();
        [0, 1].map(|k| linkwright::Vector::as_slice(&found)[k])
    }
    let (t, g, w) = (0.5_f64, 9.81, 3.0_f64);
    let lift = 0.1 * (w * t).sin();
    // It begins at rest along the line: ṡ = −3/5 (g t + ẏ − ẏ₀).
    let travel = 0.3 - 0.6 * (0.5 * g * t * t + lift - 0.1 * w * t);
    let pressed = 2.0 * 0.8 * (g - w * w * lift);
    for found in [ends(&moving_line::Carried::<f64>::default()), ends(&moving_line::Tied::<f64>::default())] {
        assert!((found[0] - travel).abs() < 1e-9, "{found:?} {travel}");
        assert!((found[1].abs() - pressed).abs() < 1e-6, "{found:?} {pressed}");
    }
}
