//! The mechanism that uses every operation of the language, against its closed forms; as one of the zoo it goes through
//! all three evaluators.

use crate::registry::{Model, Random, compiled, fields, vector};
use linkwright::{Mechanism, State};
use linkwright_compiler::schedule::{Function, Instruction};
use linkwright_compiler::symbolic::{Compare, Orders, Unary};
use mechanisms::everything::{Everything, EverythingOutputs};
use std::f64::consts::TAU;

/// The mechanism does what it was written for: no operation is missing from its programs.
#[test]
fn every_operation_occurs() {
    let compiled = compiled::<Everything>(None);
    let all = || compiled.programs.functions.iter().flat_map(|(_, program)| &program.instructions);
    let has = |test: fn(&Instruction) -> bool| all().any(test);
    for function in Unary::ALL {
        let found = all().any(|i| matches!(i, Instruction::Unary(known, _) if *known == function));
        assert!(found, "{function:?}");
    }
    for comparison in [Compare::Less, Compare::LessEqual, Compare::Equal] {
        let found = all().any(|i| matches!(i, Instruction::Compare(known, ..) if *known == comparison));
        assert!(found, "{comparison:?}");
    }
    assert!(has(|i| matches!(i, Instruction::Neg(..))));
    assert!(has(|i| matches!(i, Instruction::Add(..))));
    assert!(has(|i| matches!(i, Instruction::Sub(..))));
    assert!(has(|i| matches!(i, Instruction::Mul(..))));
    assert!(has(|i| matches!(i, Instruction::MulAdd(..))));
    assert!(has(|i| matches!(i, Instruction::Div(..))));
    assert!(has(|i| matches!(i, Instruction::Min(..))));
    assert!(has(|i| matches!(i, Instruction::Max(..))));
    assert!(has(|i| matches!(i, Instruction::Atan2(..))));
    assert!(has(|i| matches!(i, Instruction::And(..))));
    assert!(has(|i| matches!(i, Instruction::Or(..))));
    assert!(has(|i| matches!(i, Instruction::Not(..))));
    assert!(has(|i| matches!(i, Instruction::Select(..))));
    let tabled = self::compiled::<mechanisms::zoo_laws::Tabled>(None);
    let all = || tabled.programs.functions.iter().flat_map(|(_, program)| &program.instructions);
    assert!(all().any(|i| matches!(i, Instruction::Cell(..))));
    for order in 0..4 {
        assert!(
            all().any(|i| matches!(i, Instruction::Piece(_, orders, ..) if orders.first() == order)),
            "{order}"
        );
    }
    for orders in [(0, 0), (1, 0), (0, 1)] {
        let of = |orders: &Orders| (orders.first(), orders.second());
        assert!(
            all().any(|i| matches!(i, Instruction::Patch(_, own, ..) if of(own) == orders)),
            "{orders:?}"
        );
    }
    assert!(!compiled.programs.get(Function::Prepare).outputs.is_empty());
}

/// The outputs are what they say, computed here from the state.
#[test]
fn outputs_have_their_values() {
    let mut random = Random::new(3);
    for point in 0..50 {
        let scale = if point % 2 == 0 { 0.5 } else { 0.8 };
        let model = Everything::<f64>::prepared(&[scale, 0.3, 2.0]).unwrap();
        let (x0, speed, theta, omega) = (random.unit(), random.unit(), 3.0 * random.unit(), random.unit());
        let gain = if point % 5 == 0 { 0.2 } else { random.unit() };
        // In tree coordinates: the travel, the arm's orientation.
        assert_eq!(<Everything>::default().position_names(), ["rail.travel", "arm.cos", "arm.sin"]);
        let (q, v) = (vector(&[x0, theta.cos(), theta.sin()]), vector(&[speed, omega]));
        let at = |q, v| model.outputs(2.5, &State::new(q, v), &fields(&[0.7, gain]));
        let o: EverythingOutputs = at(q, v);
        let (x, y) = (x0 + theta.cos(), theta.sin());
        let choice = |holds: bool| if holds { 1.0 } else { -1.0 };
        let near =
            |name: &str, a: f64, b: f64| assert!((a - b).abs() <= 1e-13 * (1.0 + b.abs()), "{name}: {a} {b}");
        near("negated", o.negated, -x);
        near("sum", o.sum, x + y - 0.3);
        near("product", o.product, x * y);
        near("ratio", o.ratio, x / (3.0 + y));
        near("square", o.square, x * x);
        near("cube", o.cube, (3.0 + x).powi(-3));
        near("root", o.root, (3.0 + x).powi(3));
        near("general_power", o.general_power, (2.0 + gain).powf(1.3));
        near("square_root", o.square_root, (1.5 + gain).sqrt());
        near("magnitude", o.magnitude, x.abs());
        near("direction", o.direction, x.signum());
        near("sine", o.sine, theta.sin());
        near("cosine", o.cosine, (2.0 * theta).cos());
        near("tangent", o.tangent, gain.tan());
        near("arc_sine", o.arc_sine, gain.asin());
        near("arc_cosine", o.arc_cosine, gain.acos());
        near("arc_tangent", o.arc_tangent, y.atan2(x));
        near("exponential", o.exponential, gain.exp());
        near("logarithm", o.logarithm, (2.0 + gain).ln());
        near("decades", o.decades, (2.0 + gain).log10());
        near("hyperbolic_sine", o.hyperbolic_sine, gain.sinh());
        near("hyperbolic_cosine", o.hyperbolic_cosine, gain.cosh());
        near("hyperbolic_tangent", o.hyperbolic_tangent, (3.0 * gain).tanh());
        near("slope", o.slope, (2.0 * gain).atan());
        near("hypotenuse", o.hypotenuse, x.hypot(0.3));
        near("limited", o.limited, x.clamp(-0.5, 0.3));
        near("beyond", o.beyond, if y.abs() <= 0.3 { 0.0 } else { y - 0.3 * y.signum() });
        let share = ((gain + 0.4) / 0.9).clamp(0.0, 1.0);
        near("smooth", o.smooth, share * share * (3.0 - 2.0 * share));
        near("positive", o.positive, if gain > 0.0 { 1.0 } else { 0.0 });
        let turned = 5.0 * o.angle;
        near("wrapped", o.wrapped, turned - TAU * (turned / TAU).round());
        near("phase", o.phase, x.rem_euclid(0.3));
        near("smaller", o.smaller, x.min(y));
        near("larger", o.larger, x.max(0.3));
        near("less", o.less, choice(gain < 0.2));
        near("less_equal", o.less_equal, choice(gain <= 0.2));
        near("greater", o.greater, choice(gain > 0.2));
        near("greater_equal", o.greater_equal, choice(gain >= 0.2));
        near("equal", o.equal, choice(gain == 0.2));
        near("not_equal", o.not_equal, choice(gain != 0.2));
        near("both", o.both, choice(gain > -0.5 && gain < 0.5));
        near("either", o.either, choice(!(-0.5..=0.5).contains(&gain)));
        near("neither", o.neither, choice((-0.5..=0.5).contains(&gain)));
        near("of_parameters", o.of_parameters, choice(scale > 0.6) * gain);
        near(
            "of_parameters_too",
            o.of_parameters_too,
            if scale > 0.6 && gain > 0.0 { scale } else { 2.0 * scale },
        );
        near("angle", o.angle, theta);
        near("body_angle", o.body_angle, theta);
        near("rate", o.rate, omega);
        near("travel", o.travel, x0);
        near("speed", o.speed, speed);
        near("velocity", o.velocity, speed - omega * y);
        near("far", o.far, (x - 1.0).hypot(y - 2.0));
        near("clock", o.clock, 2.5);
        let wind = if y < 0.3 { 0.7 } else { 0.35 };
        let (along, across) = (speed - omega * y, omega * theta.cos());
        near("wind_power", o.wind_power, wind * (along + 2.0 * across) / 5.0_f64.sqrt());
        let (vx, vy) = (speed - omega * y / 2.0, omega * theta.cos() / 2.0);
        let kinetic = speed * speed + 0.5 * (vx * vx + vy * vy) + omega * omega / 24.0;
        near("moving", o.moving, kinetic);
        near("stored", o.stored, 9.81 * scale * y / 2.0);
        near("total", o.total, o.moving + o.stored);
    }
}
