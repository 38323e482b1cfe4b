//! The exported definition.

use crate::definitions::QUICK_RETURN;
use linkwright_compiler::parse;
use linkwright_compiler::syntax::definition_json;

fn json(source: &str) -> String {
    definition_json(&parse(source.parse().expect("tokens")).unwrap_or_else(|d| panic!("{d}")))
}

#[test]
fn quick_return() {
    let text = json(QUICK_RETURN);
    for part in [
        r#"{"linkwright":1,"kind":"planar","name":"QuickReturn","constants":[{"name":"GUIDE","unit":"m","value":{"number":"0.4"}}]"#,
        r#""parameters":[{"name":"flywheel","unit":"kg*m^2","value":{"number":"1.26069"},"min":null,"max":null}]"#,
        r#""inputs":[{"name":"drive","unit":"N*m"},{"name":"cutting","unit":"N"}],"gravity":null"#,
        r#"{"name":"crank","kind":"body","properties":{"mass":{"unit":"kg","value":{"number":"0.368"}},"inertia":{"unit":"kg*m^2","value":{"name":"flywheel"}}},"center":null,"points":["#,
        r#"{"name":"pivot","unit":"m","value":[{"op":"/","args":[{"op":"neg","args":[{"name":"GUIDE"}]},{"number":"2"}]},{"number":"0"}]}"#,
        r#""lines":[{"name":"slot","from":{"place":"guide.pivot"},"to":{"place":"guide.tip"}}]"#,
        r#"{"name":"guide_pin","kind":"revolute","first":{"ground":[{"number":"0"},{"op":"neg","args":[{"number":"0.2"}]}],"unit":"m"},"second":{"place":"guide.pivot"}}"#,
        r#"{"name":"block","kind":"point_on_line","first":{"line":"guide.slot"},"second":{"place":"crank.tip"}}"#,
        r#""second":{"place":"slider.center"},"axis":{"unit":"1","value":[{"number":"1"},{"number":"0"}]}}"#,
        r#"{"name":"motor","kind":"torque","on":"crank_pin","value":{"name":"drive"}}"#,
        r#"{"name":"cut","kind":"force","place":{"place":"slider.center"},"direction":[{"number":"1"},{"number":"0"}],"value":{"name":"cutting"}}"#,
        r#"{"quantity":{"name":"guide_pin.angle"},"exact":false,"unit":"rad","value":{"number":"0.7"}}"#,
        r#""outputs":[{"name":"stroke","unit":"m","value":{"name":"slider.center.x"}}]"#,
        r#""options":{"coordinates":"auto","redundant":"refuse"},"expect":{"degrees_of_freedom":1,"operations":[{"of":null,"at_most":400}]}}"#,
    ] {
        assert!(text.contains(part), "missing {part}\nin {text}");
    }
}

#[test]
fn indices_calls_and_units_are_kept() {
    let text = json(
        "planar K {
            line way = (ground(0, 0), ground(1, 0) [mm]);
            repeat i in 2..3 {
                param k[i] [N/m] = (1 + i) [kN/m] in 1..2;
                joint j[i]: point_on_line(way, b[i].center);
                constraint c[i]: if(b[i].angle < 1 [rad], distance(b[i].p, ground(0, 1) [m]), 0) = 0;
                constraint g[i]: gear(j[i], b[i], ratio = -i);
                damper d[i]: damper(b[i].p, ground(0, 0), damping = 3 [N*s/m]);
                drive r[i]: j[i].travel = time * 1 [m/s];
            }
        }",
    );
    for part in [
        r#"{"name":"k[2]","unit":"N/m","value":{"value":{"op":"+","args":[{"number":"1"},{"number":"2"}]},"unit":"kN/m"},"min":{"number":"1"},"max":{"number":"2"}}"#,
        r#""first":{"from":{"ground":[{"number":"0"},{"number":"0"}],"unit":null},"to":{"ground":[{"number":"1"},{"number":"0"}],"unit":"mm"}},"second":{"place":"b[2].center"}"#,
        r#"{"name":"c[2]","kind":"equation","left":{"call":"if","args":[{"op":"<","args":[{"name":"b[2].angle"},{"number":"1","unit":"rad"}]},{"call":"distance","args":[{"name":"b[2].p"},{"ground":[{"number":"0"},{"number":"1"}],"unit":"m"}]},{"number":"0"}]},"right":{"number":"0"}}"#,
        r#"{"name":"g[2]","kind":"gear","first":"j[2]","second":"b[2]","ratio":{"unit":null,"value":{"op":"neg","args":[{"number":"2"}]}},"phase":null}"#,
        r#"{"name":"d[2]","kind":"spring","first":{"place":"b[2].p"},"second":{"ground":[{"number":"0"},{"number":"0"}],"unit":null},"damping":{"unit":null,"value":{"number":"3","unit":"N*s/m"}}}"#,
        r#"{"name":"r[2]","quantity":{"name":"j[2].travel"},"law":{"unit":null,"value":{"op":"*","args":[{"name":"time"},{"number":"1","unit":"m/s"}]}}}"#,
    ] {
        assert!(text.contains(part), "missing {part}\nin {text}");
    }
}

#[test]
fn expectations_of_the_motion() {
    let text = json(
        "planar K { expect { rotates = (a, b[1+1]); no_singularity; knee.angle in 10..-2*5 [deg]; x.y.z [m] in 0..1; } }",
    );
    let expected = r#""expect":{"rotates":["a","b[2]"],"no_singularity":true,"ranges":[{"quantity":{"name":"knee.angle"},"from":{"number":"10"},"to":{"op":"*","args":[{"op":"neg","args":[{"number":"2"}]},{"number":"5","unit":"deg"}]},"unit":null},{"quantity":{"name":"x.y.z"},"from":{"number":"0"},"to":{"number":"1"},"unit":"m"}]}"#;
    assert!(text.contains(expected), "missing {expected}\nin {text}");
}

/// Balanced, and no comma out of place: enough of a grammar to notice a writer gone wrong.
#[test]
fn the_text_is_well_formed() {
    let text = json(QUICK_RETURN);
    let mut open = Vec::new();
    let mut in_string = false;
    let mut last = ' ';
    for character in text.chars() {
        match character {
            '"' => in_string = !in_string,
            '{' | '[' if !in_string => open.push(character),
            '}' | ']' if !in_string => {
                assert_ne!(last, ',');
                let expected = if character == '}' { '{' } else { '[' };
                assert_eq!(open.pop(), Some(expected));
            }
            ',' if !in_string => assert!(!",:{[".contains(last)),
            _ => {}
        }
        last = character;
    }
    assert!(open.is_empty() && !in_string);
}
