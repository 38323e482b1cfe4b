//! What is written in several ways, of which the compiler takes one that counts less, is the same in all of them, whichever it takes.

use crate::compiled;
use linkwright_compiler::Compiled;
use linkwright_compiler::equations::space::{Cosines, Inertial, joints};
use linkwright_compiler::equations::{JointRow, Laws};
use linkwright_compiler::model::JointId;
use linkwright_compiler::schedule::Inputs;
use linkwright_compiler::self_check::{Random, state};
use linkwright_compiler::solve::{Damping, null_space};
use linkwright_compiler::symbolic::{Computed, Node, Op, evaluate};

/// Two bodies between which the joint `k` closes a loop: `HOLD` hangs them on something.
const PAIR: &str = "spatial Pair {
    gravity [m/s^2] = (0.1, 0.2, -9.81);
    body base { mass [kg] = 3; inertia [kg*m^2] = (0.05, 0.04, 0.06); center [m] = (0.1, 0.1, 0);
                point left [m] = (0, 0, 0.1); point right [m] = (0.5, 0, 0.1); }
    body a { mass [kg] = 2; inertia [kg*m^2] = (0.03, 0.04, 0.05); products [kg*m^2] = (0.001, 0.002, 0.003);
             center [m] = (0.05, 0.1, 0.2); point tip [m] = (0.25, 0.3, 0.1); }
    body b { mass [kg] = 1.5; inertia [kg*m^2] = (0.02, 0.03, 0.02); center [m] = (0, 0.03, 0.1);
             point tip [m] = (-0.25, 0.3, 0.1); }
    HOLD
    joint k: JOINT;
}";

/// From the ground, where the loop's ways meet; from a body that moves; free bodies; and where one way is made of hinges.
const HOLDS: [&str; 4] = [
    "joint left: spherical(ground(0, 0, 0.1) [m], a.origin); joint right: spherical(ground(0.5, 0, 0.1) [m], b.origin);
     joint swing: revolute(ground(0, 0, 0) [m], base.origin, axis = (0, 1, 0)); options { coordinates = tree; cut = (k); }",
    "joint left: spherical(base.left, a.origin); joint right: spherical(base.right, b.origin);
     joint swing: revolute(ground(0, 0, 0) [m], base.origin, axis = (1, 2, 2)); options { coordinates = tree; cut = (k); }",
    "options { coordinates = absolute; }",
    "joint left: universal(base.left, a.origin, axis = (1, 0, 0), second_axis = (0, 1, 0));
     joint right: spherical(ground(0.5, 0, 0.1) [m], b.origin);
     joint swing: revolute(ground(0, 0, 0) [m], base.origin, axis = (1, 2, 2)); options { coordinates = tree; cut = (k); }",
];

/// With each kind of row.
const JOINTS: [&str; 8] = [
    "spherical(a.tip, b.tip)",
    "revolute(a.tip, b.tip, axis = (1, 2, 2))",
    "cylindrical(a.tip, b.tip, axis = (1, 0, 2))",
    "planar(a.tip, b.tip, axis = (1, 2, 0))",
    "parallel(a.tip, b.tip)",
    "universal(a.tip, b.tip, axis = (1, 0, 0), second_axis = (0, 1, 0))",
    "constant_velocity(a.tip, b.tip, axis = (1, 2, 2))",
    "distance(a.center, b.tip, length [m] = 0.4)",
];

fn pair(hold: &str, joint: &str) -> Compiled {
    compiled(&PAIR.replace("HOLD", hold).replace("JOINT", joint)).expect("it compiles")
}

/// Values of nodes at a state.
fn values(compiled: &Compiled, at: &Inputs, nodes: &[Node]) -> Vec<f64> {
    let equations = &compiled.complete.equations;
    let (symbols, graph) = (&equations.symbols, equations.graph.read());
    let mut given = vec![0.0; graph.len()];
    let lists = [(&symbols.q, &at.q), (&symbols.v, &at.v), (&symbols.parameters, &at.parameters)];
    let lists = lists.into_iter().flat_map(|(nodes, values)| nodes.iter().zip(values));
    let scalars = [(&symbols.two_alpha, &at.two_alpha), (&symbols.beta_squared, &at.beta_squared)];
    for (node, value) in lists.chain(scalars) {
        if let Op::Symbol(symbol) = graph.op(*node) {
            given[symbol as usize] = *value;
        }
    }
    let values = evaluate(&graph, &given);
    nodes.iter().map(|node| values[node.index()]).collect()
}

fn assert_same(one: &[f64], other: &[f64], of: &str) {
    assert_eq!(one.len(), other.len(), "{of}");
    let size = one.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
    for (a, b) in one.iter().zip(other) {
        assert!((a - b).abs() < 1e-12 * size, "{of}: {one:?} and {other:?}");
    }
    assert!(one.iter().any(|x| x.abs() > 1e-3), "{of}: nothing is compared");
}

#[test]
fn rows_of_joints() {
    let mut random = Random::new(3);
    for hold in HOLDS {
        for joint in JOINTS {
            let compiled = pair(hold, joint);
            let equations = &compiled.complete.equations;
            let g = equations.graph.sheet();
            let laws = Laws::moving(
                g,
                &compiled.mechanism,
                &equations.symbols,
                &equations.layout,
                &equations.kinematics,
            );
            let id = compiled.mechanism.joints.iter().position(|joint| joint.name.text == "k");
            let id = JointId(id.expect("it is there"));
            let space = laws.space().expect("a spatial mechanism");
            let directions = Inertial::new(space, Computed::default());
            let turning = directions.with(Cosines::Turning);
            let ways = [None, Some(&directions), Some(&turning)];
            let ways = ways.map(|way| joints::rows(&laws, &equations.tree, id, way));
            let part = |row: &JointRow, which: usize| -> Vec<Node> {
                let columns = (0..equations.symbols.v.len())
                    .map(|velocity| row.jet.columns.get(&velocity).copied().unwrap_or(equations.zero));
                match which {
                    0 => vec![row.jet.value],
                    1 => columns.collect(),
                    2 => vec![row.jet.rate(g, &equations.symbols.v).bare],
                    _ => vec![row.jet.bias],
                }
            };
            for which in 0..4 {
                let parts = ways
                    .each_ref()
                    .map(|rows| rows.iter().flat_map(|row| part(row, which)).collect::<Vec<Node>>());
                let at = state(&compiled, &mut random, true);
                let [one, others @ ..] = parts.each_ref().map(|nodes| values(&compiled, &at, nodes));
                for other in others {
                    assert_same(
                        &one,
                        &other,
                        &format!("{} of {joint}, {hold}", ["Φ", "D", "D v", "−γ"][which]),
                    );
                }
            }
        }
    }
}

#[test]
fn baumgartes_first_term() {
    let mut random = Random::new(5);
    for hold in &HOLDS[..2] {
        let compiled = pair(hold, JOINTS[1]);
        let equations = &compiled.complete.equations;
        let dampings = [Damping::InRows, Damping::ByShift, Damping::ByShiftOfDependent];
        let solutions = dampings.map(|damping| {
            null_space(
                equations,
                &compiled.complete.further.partition,
                false,
                None,
                Some(damping),
                usize::MAX,
            )
            .expect("nothing is too much")
        });
        let at = state(&compiled, &mut random, true);
        let [one, others @ ..] = solutions.each_ref().map(|written| {
            let nodes: Vec<Node> =
                written.stabilised.acceleration.iter().chain(&written.stabilised.lambda).copied().collect();
            values(&compiled, &at, &nodes)
        });
        others.iter().for_each(|other| assert_same(&one, other, hold));
        let [one, other, third] = solutions.each_ref().map(|written| written.asked.clone());
        let all_differ = one != other && other != third && third != one;
        assert!(all_differ, "{hold}: the rows ask the same");
    }
}
