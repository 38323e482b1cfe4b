//! Machine code of every program of every mechanism gives the bits of the interpreter.

use linkwright_compiler::compile;
use linkwright_compiler::functions::{ARGUMENTS, Argument};
use linkwright_compiler::schedule::{Inputs, Instruction, Operand, Program, Source, run_straight};
use linkwright_compiler::symbolic::{Compare, Unary};
use linkwright_engine::{Engine, REGISTERS, Translator};
use linkwright_native::Native;
use linkwright_runtime::{AssembleExt, Baumgarte, Simulation, Vector};
use mechanisms::registry::{Model, Random, compiled, for_each};
use std::sync::Arc;

/// What machine code leaves of a program, with the arguments in registers one behind another.
fn translated(program: &Program, inputs: &Inputs) -> Vec<f64> {
    let mut registers: Box<[f64; REGISTERS]> =
        vec![f64::NAN; REGISTERS].into_boxed_slice().try_into().expect("as many");
    let mut places = [0u16; ARGUMENTS.len()];
    let mut free = 0;
    for given in &ARGUMENTS {
        // The state as a whole is no argument of programs: its parts are.
        if given.argument == Argument::State {
            continue;
        }
        places[given.argument as usize] = free as u16;
        let values = inputs.of(given.argument);
        registers[free..free + values.len()].copy_from_slice(values);
        free += values.len();
    }
    let before = registers.clone();
    let register = |operand| match operand {
        Operand::Source(Source { argument, index }) => Some(places[argument as usize] + index as u16),
        _ => None,
    };
    let native = Native::new().expect("this processor is known");
    let code = native.translate(program, &register, free as u16).expect("it can be translated");
    code.run(&mut registers);
    let end = free + program.outputs.len();
    let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&registers[..free]), bits(&before[..free]), "arguments stay");
    assert_eq!(bits(&registers[end..]), bits(&before[end..]), "nothing else is written");
    registers[free..end].to_vec()
}

/// Bits; what is no number is none in both.
fn same(what: &str, one: &[f64], other: &[f64]) {
    let equal = |a: &f64, b: &f64| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    let differs = one.iter().zip(other).position(|(a, b)| !equal(a, b));
    assert!(one.len() == other.len() && differs.is_none(), "{what}, {differs:?}: {one:?} and {other:?}");
}

for_each!(programs);

fn programs<M: Model>() {
    let compiled = compiled::<M>(None);
    let mut point = Random::new(11).point(&compiled);
    let prepare = linkwright_compiler::functions::Function::Prepare;
    point.prepared = run_straight(compiled.programs.get(prepare), &point);
    for (function, program) in &compiled.programs.functions {
        same(function.name(), &translated(program, &point), &run_straight(program, &point));
    }
}

/// Every operation on zeros of both signs, infinities, what is no number, and ordinary numbers.
#[test]
fn operations() {
    let special =
        [0.0, -0.0, 1.0, -1.0, 0.3, -2.7, 1e300, -1e-310, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    let [a, b, c] = [0, 1, 2].map(|index| Operand::Source(Source { argument: Argument::Q, index }));
    let mut instructions = vec![
        Instruction::Neg(a),
        Instruction::Add(a, b),
        Instruction::Sub(a, b),
        Instruction::Mul(a, b),
        Instruction::Div(a, b),
        Instruction::Min(a, b),
        Instruction::Max(a, b),
        Instruction::Atan2(a, b),
        Instruction::And(a, b),
        Instruction::Or(a, b),
        Instruction::Not(a),
        Instruction::Select(a, b, c),
        Instruction::Add(Operand::Constant(-0.0), a),
    ];
    for [product, addend] in [[false, false], [false, true], [true, false], [true, true]] {
        instructions.push(Instruction::MulAdd(a, b, c, product, addend));
    }
    instructions.extend(Unary::ALL.map(|function| Instruction::Unary(function, a)));
    let comparisons = [Compare::Less, Compare::LessEqual, Compare::Equal];
    instructions.extend(comparisons.map(|comparison| Instruction::Compare(comparison, a, b)));
    let mut outputs: Vec<Operand> = (0..instructions.len() as u32).map(Operand::Value).collect();
    outputs.extend([a, Operand::Constant(7.5), Operand::Value(1)]);
    let program = Program { instructions, outputs, ..Program::default() };
    for x in special {
        for y in special {
            for z in [0.5, -0.0, f64::INFINITY] {
                let inputs = Inputs { q: vec![x, y, z], ..Inputs::default() };
                same(
                    &format!("{x:?}, {y:?}, {z:?}"),
                    &translated(&program, &inputs),
                    &run_straight(&program, &inputs),
                );
            }
        }
    }
}

/// Results that would stand behind the last register are refused.
#[test]
fn no_room() {
    let program = Program { outputs: vec![Operand::Constant(1.0); 3], ..Program::default() };
    let native = Native::new().expect("this processor is known");
    assert!(native.translate(&program, &|_| Some(0), (REGISTERS - 2) as u16).is_none());
    assert!(native.translate(&program, &|_| Some(0), (REGISTERS - 3) as u16).is_some());
}

/// Whole runs are those of the interpreter, on other threads and with other parameters too.
#[test]
fn runs() {
    macro_rules! each {
        ($($model:path),*) => { $( run(<$model>::SOURCE); )* };
    }
    each!(
        linkwright_models::four_bar::FourBar,
        linkwright_models::bricard::Bricard,
        linkwright_models::motor_gear_load::MotorGearLoad
    );
}

fn run(source: &str) {
    let compiled = compile(source.parse().expect("tokens"), None).expect("it is well");
    let native = Arc::new(Native::new().expect("this processor is known"));
    let translated: Engine = Engine::translated(&compiled, native).expect("it fits");
    let interpreted: Engine = Engine::of(&compiled).expect("it fits");
    let moved = |engine: &Engine| {
        let start = engine.assemble(&engine.start()).expect("it closes");
        let formulation = Baumgarte { alpha: 20.0, beta: 20.0 };
        let mut simulation =
            Simulation::new(engine, start).formulation(formulation).constant(engine.no_inputs()).step(1e-3);
        simulation.advance_steps(200).expect("it moves");
        let mut end = simulation.state().q.as_slice().to_vec();
        end.extend(simulation.state().v.as_slice());
        end.push(simulation.energy());
        end
    };
    let here = moved(&interpreted);
    same("here", &moved(&translated), &here);
    let clone = translated.clone();
    let there = std::thread::spawn(move || moved(&clone)).join().expect("it ends");
    same("there", &there, &here);
    let parameters: Vec<f64> = translated.parameters().iter().map(|value| value * 1.001).collect();
    let [one, other] =
        [&translated, &interpreted].map(|engine| engine.prepared(&parameters).expect("nearly the same"));
    same("with other parameters", &moved(&one), &moved(&other));
}
