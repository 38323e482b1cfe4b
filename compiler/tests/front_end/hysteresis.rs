//! Loads with internal states: their mistakes, the elements of backbones, and the states that they have.

use crate::{bad, good};
use linkwright_compiler::model::{Expr, Rate};

/// A cart on a rail with these statements.
fn cart(statements: &str) -> String {
    format!(
        "planar Mount {{ body cart {{ mass [kg] = 1; inertia [kg*m^2] = 0.1; }}
         joint rail: prismatic(ground(0, 0) [m], cart.center, axis = (1, 0)); {statements} }}"
    )
}

fn backbone(points: &str) -> String {
    cart(&format!("table bar(way [mm]) [N] = {points}; force bush: masing(rail, backbone = bar);"))
}

#[test]
fn one_message_for_each_mistake() {
    let law = |rest: &str| {
        cart(&format!("force bush: bouc_wen(rail, stiffness [N/m] = 1e5, beta = 0.5, gamma = 0.5, {rest});"))
    };
    for (source, expected) in [
        (
            backbone("[(0, 0), (1, 100), (2, 250)], linear"),
            "the backbone `bar` gets steeper at 1 mm: what yields gets less stiff from knot to knot",
        ),
        (
            backbone("[(0, 5), (1, 100)], linear"),
            "the backbone `bar` does not go through the origin, at 0 mm: begin it with (0, 0)",
        ),
        (
            backbone("[(1, 100), (2, 150)], linear"),
            "the backbone `bar` does not go through the origin, at 1 mm: begin it with (0, 0)",
        ),
        (
            backbone("[(-2, -150), (-1, -90), (1, 100), (2, 150)], linear"),
            "the backbone `bar` is not the same both ways, at -1 mm: opposite ways have opposite values; or give it from (0, 0) on",
        ),
        (
            backbone("[(-1, -100), (0, 0), (1, 100), (2, 150)], linear"),
            "the backbone `bar` is not the same both ways, at -1 mm: opposite ways have opposite values; or give it from (0, 0) on",
        ),
        (
            backbone("[(0, 0), (1, 100), (2, 90)], linear"),
            "the backbone `bar` falls before 2 mm: it rises from the origin, and from knot to knot less",
        ),
        (
            backbone("[(0, 0), (1, 100), (2, 200)], linear"),
            "nothing of the backbone `bar` yields: it is straight up to 2 mm and beyond; write `outside = hold` behind its points",
        ),
        (
            backbone("[(0, 0), (1, 100), (2, 150)]"),
            "a backbone goes straight from knot to knot, and `bar` is `monotone` between them: write `linear` behind its points",
        ),
        (
            cart("table bar(way [m], heat) [N] = grid((0, 1), (0, 1), [(0, 1), (0, 2)]); force bush: masing(rail, backbone = bar);"),
            "`bar` is a grid, and a backbone is a table of one argument, the way",
        ),
        (
            cart("force bush: masing(rail, backbone = 3);"),
            "a backbone is a table by its name: `backbone = bar`, with `table bar(way [mm]) [N] = [(0, 0), …], linear;`",
        ),
        (
            cart("table bar(turn [rad]) [N] = [(0, 0), (1, 1)], linear; force bush: masing(rail, backbone = bar);"),
            "a knot of `bar` is given an angle: expected m, found rad",
        ),
        (
            law("depth [mm] = 2, exponent = 0.5"),
            "the exponent must be at least 1, found 0.5: below it the way back has no end",
        ),
        (law("depth [mm] = 0, exponent = 2"), "the depth of `bush` must be positive, found 0"),
        (law("exponent = 2"), "`bouc_wen` needs its depth: write `depth = …`"),
        (
            cart("state bush_deflection = 0; rate bush_deflection = 1/1 [s];
                  force bush: bouc_wen(rail, stiffness [N/m] = 1, depth [m] = 1, beta = 1, gamma = 0, exponent = 1);"),
            "the load `bush` has a state `bush_deflection`, which is the name of another: call one of them otherwise",
        ),
        (
            cart("force bush: bouc_wen(rail, stiffness [N/m] = 1, depth [m] = 1, beta = 1, gamma = 0, exponent = 1);
                  output x [N] = bush.force;"),
            "`bush` has the quantity `bush.resistance`, and its power is `power(bush)`",
        ),
    ] {
        let found = bad(&source).to_string();
        assert!(found.contains(expected), "expected: {expected}\nfound: {found}");
    }
}

fn numbers(values: &[Expr]) -> Vec<f64> {
    values.iter().map(|value| if let Expr::Number(number) = value { *number } else { f64::NAN }).collect()
}

#[test]
fn elements_of_a_backbone() {
    let near = |points: &str, expected: &[f64]| {
        let mechanism = good(&backbone(points));
        let found = numbers(mechanism.loads[0].components(0));
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{found} for {expected}");
        }
    };
    let held = [0.0, 1e-3, 5e4, 2e-3, 2.5e4, 4e-3, 2.5e4];
    near("[(0, 0), (1, 100), (2, 150), (4, 200)], linear, outside = hold", &held);
    near("[(-4, -200), (-2, -150), (-1, -100), (1, 100), (2, 150), (4, 200)], linear, outside = hold", &held);
    near("[(-1, -100), (0, 0), (1, 100)], linear, outside = hold", &[0.0, 1e-3, 1e5]);
    // What lies beyond the last knot never yields; a knot without a corner is none.
    near("[(0, 0), (1, 100), (2, 150), (3, 200)], linear", &[5e4, 1e-3, 5e4]);
}

#[test]
fn states_of_loads_stand_behind_the_declared() {
    let mechanism = good(&cart(
        "param deep [mm] = 3; table bar(way [mm]) [N] = [(0, 0), (1, 100), (2, 150)], linear, outside = hold;
         state felt [N] = 0; rate felt = (bush.resistance - felt)/1 [s];
         force bush: masing(rail, backbone = bar);
         force tie: bouc_wen(cart.center.y + rail.travel, stiffness [N/m] = 1, depth = deep, beta = 1, gamma = 0, exponent = 1);",
    ));
    let found: Vec<_> = mechanism.states.iter().map(|it| (it.name.text.as_str(), it.scale)).collect();
    assert_eq!(
        found,
        [
            ("felt", None),
            ("bush.element[0]", Some(1e-3)),
            ("bush.element[1]", Some(2e-3)),
            ("tie.deflection", Some(3e-3))
        ]
    );
    assert!(matches!(mechanism.states[2].rate, Rate::OfLoad(load, 1) if load.0 == 0));
    assert_eq!(mechanism.loads[1].states, 3..4);
    assert_eq!(mechanism.states[3].name.identifier(), "tie_deflection");
}
