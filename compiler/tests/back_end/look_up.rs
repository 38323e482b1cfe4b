//! Tables in programs: one search for value and derivatives, derivatives that are those of differences, and what is the same after
//! many turns.

use crate::compiled;
use linkwright_compiler::schedule::{Function, Inputs, Instruction, count, run};
use linkwright_compiler::symbolic::{
    AXIS, Class, Gradient, Growing, Node, Orders, PATCHES, PIECES, Scalar, Sheet, Table, evaluate,
};
use std::collections::BTreeMap;
use std::sync::Arc;

const CAM: &str = "planar Cam {
    table lift(angle [deg]) [mm] = [(0, 0), (60, 4), (120, 9), (180, 8), (240, 4), (360, 0)], periodic;
    disk cam { mass [kg] = 1; radius [mm] = 40; }
    body follower { mass [kg] = 0.3; inertia [kg*m^2] = 1e-4; }
    joint shaft: revolute(ground(0, 0), cam.center);
    joint rail: prismatic(ground(0, 0.06) [m], follower.center, axis = (0, 1));
    constraint follow: rail.travel = lift(shaft.angle + 0.1 [rad]);
    start { shaft.angle [deg] = 30; shaft.rate [rad/s] = 2; }
    options { emit = (tangent); }
    output lifted [mm] = lift(shaft.angle + 0.1 [rad]);
    output steep [mm/rad] = lift.slope(shaft.angle + 0.1 [rad]);
}";

/// Of Φ, D and γ of a constraint, and of both outputs.
#[test]
fn one_search_for_value_and_derivatives() {
    let compiled = compiled(CAM).expect("it compiles");
    let cells = |function: Function| {
        let instructions = &compiled.programs.get(function).instructions;
        let of = |test: fn(&&Instruction) -> bool| instructions.iter().filter(test).count();
        (of(|it| matches!(it, Instruction::Cell(..))), of(|it| matches!(it, Instruction::Piece(..))))
    };
    assert_eq!(cells(Function::AccelerationBaumgarte), (1, 3));
    assert_eq!(cells(Function::Outputs), (1, 2));
    assert_eq!(cells(Function::RowTangent).0, 1);
    // ⌈log₂ 7⌉ + 6 for the value and 4 for the slope; three for whole periods, and the angle plus a number.
    let program = compiled.programs.get(Function::Constraints);
    let look_up = program.instructions.iter().filter(|it| it.table().is_some()).count();
    assert_eq!(look_up, 2);
    let others = program.instructions.len() - look_up;
    assert_eq!(count(program).total(), others + 3 + 6);
}

/// Whole turns are whole periods: they are left out and not rounded.
#[test]
fn many_turns_later() {
    let compiled = compiled(CAM).expect("it compiles");
    let at = |turns: f64| {
        let mut q = compiled.assembly.q.clone();
        let names = compiled.complete.equations.layout.position_names(&compiled.mechanism);
        let index = names.iter().position(|name| name.ends_with(".turns")).expect("a counted angle");
        q[index] = turns;
        let inputs = Inputs { q, v: compiled.assembly.v.clone(), ..Inputs::default() };
        run(compiled.programs.get(Function::Outputs), &inputs)
    };
    assert_eq!(at(0.0), at(1e9));
    assert!((at(0.0)[0] - compiled.assembly.q[0]).abs() < 1.0);
}

fn cubic() -> Arc<Table> {
    let rows = [
        [0.0, 1.0, 2.0, 0.0, 0.0],
        [0.0, 1.0, 2.0, -3.0, 0.5],
        [1.0, 0.5, -2.5, 1.0, 2.0],
        [2.0, 1.0, 5.5, 0.0, 0.0],
    ];
    Arc::new(Table::new("cubic", PIECES, rows.concat()))
}

/// ∂f/∂x and ∂f/∂y against central differences, extrapolated.
fn check(function: impl for<'g> Fn(Scalar<'g>, Scalar<'g>, Sheet<'g>) -> Scalar<'g>, points: &[[f64; 2]]) {
    let graph = Growing::default();
    let g = graph.sheet();
    let symbols = ["x", "y"].map(|name| g.symbol(name, Class::Position));
    let one = g.one().bare;
    let seed: BTreeMap<Node, Gradient> =
        symbols.iter().enumerate().map(|(k, symbol)| (symbol.bare, Gradient::from([(k, one)]))).collect();
    let root = function(symbols[0], symbols[1], g).bare;
    let gradient = g.differentiate(&[root], &seed).remove(0);
    let graph = graph.read();
    let value = |node: Node, at: [f64; 2]| evaluate(&graph, &at)[node.index()];
    for at in points {
        for k in 0..2 {
            let slope = |h: f64| {
                let (mut ahead, mut behind) = (*at, *at);
                ahead[k] += h;
                behind[k] -= h;
                (value(root, ahead) - value(root, behind)) / (2.0 * h)
            };
            let expected = (4.0 * slope(5e-4) - slope(1e-3)) / 3.0;
            let found = gradient.get(&k).map_or(0.0, |node| value(*node, *at));
            assert!(
                (found - expected).abs() <= 1e-9 * (1.0 + expected.abs()),
                "{at:?}, {k}: {found} {expected}"
            );
        }
    }
}

#[test]
fn derivatives_by_differences() {
    for order in 0..4 {
        let piece = |x: Scalar<'_>, g: Sheet<'_>| {
            let table = g.graph().enter(&cubic());
            g.on(x.piece(table, order, x.cell(table)).bare).bare
        };
        let points = [[-0.7, 0.2], [0.3, -0.5], [1.4, 0.8], [2.6, 0.1]];
        check(|x, _, g| g.on(piece(x, g)), &points);
        check(|x, y, g| g.on(piece(x * y, g)) * y, &points);
    }
    let axis = Arc::new(Table::new("axis", AXIS, vec![0.0, 0.0, 1.0]));
    let rows: Vec<f64> =
        (0..9).flat_map(|k| [0.0, 1.0, 0.5, f64::from(k), 2.0 - f64::from(k), 0.3 * f64::from(k)]).collect();
    let patches = Arc::new(Table::new("patches", PATCHES, rows));
    for orders in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        check(
            |x, y, g| {
                let axis = g.graph().enter(&axis);
                let table = g.graph().enter(&patches);
                let cell = 3.0 * x.cell(axis) + y.cell(axis);
                x.patch(table, Orders::new(orders.0, orders.1), cell, y)
            },
            &[[-0.7, 0.2], [0.3, -0.5], [1.4, 0.8], [2.6, 1.1]],
        );
    }
}

/// What is no number gives none, at every order.
#[test]
fn no_number_gives_none() {
    let cubic = cubic();
    for order in 0..4 {
        assert!(cubic.piece(order, cubic.cell(f64::NAN), f64::NAN).is_nan());
    }
}
