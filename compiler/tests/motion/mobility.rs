//! Degrees of freedom, counted and true, and what moves alone.

use crate::{compiled, errors};
use linkwright_compiler::equations::Row;

const PLANAR_FOUR_BAR: &str = "rod crank { mass [kg] = 1; length [m] = 1; }
    rod coupler { mass [kg] = 1; length [m] = 2; } rod rocker { mass [kg] = 1; length [m] = 1.5; }
    joint a: revolute(ground(0, 0) [m], crank.start); joint d: revolute(ground(2, 0) [m], rocker.start);
    joint b: revolute(crank.end, coupler.start); joint c: revolute(coupler.end, rocker.end);
    start { a.angle [deg] = 90; d.angle [deg] ~ 90; }";

#[test]
fn grueblers_count_in_the_plane() {
    let mobility = compiled(&format!("planar A {{ {PLANAR_FOUR_BAR} }}")).assembly.mobility;
    assert_eq!((mobility.apart, mobility.equations, mobility.counted()), (9, 8, 1));
    assert_eq!((mobility.at_start, mobility.generic), (1, 1));
    assert!(mobility.redundant.is_empty());
    // A driver holds nothing of this; a particle has two freedoms.
    let more = "particle bob { mass [kg] = 1; } joint e: revolute(coupler.center, bob.center);
                drive motor: a.angle = 90 [deg] + 1 [rad/s]*time;";
    let mobility = compiled(&format!("planar B {{ {PLANAR_FOUR_BAR} {more} }}")).assembly.mobility;
    assert_eq!((mobility.apart, mobility.equations, mobility.generic), (11, 10, 1));
}

/// The four-bar of revolutes in space: three equations of the loop repeat, whichever coordinates are emitted.
#[test]
fn redundant_equations_explain_the_difference() {
    for coordinates in ["tree", "absolute"] {
        let source = format!(
            "spatial A {{
                box crank {{ mass [kg] = 1; size [m] = (1, 0.1, 0.1); }} box rocker {{ mass [kg] = 1; size [m] = (1, 0.1, 0.1); }}
                box coupler {{ mass [kg] = 1; size [m] = (2, 0.1, 0.1); point near [m] = (-1, 0, 0); point far [m] = (1, 0, 0); }}
                joint a: revolute(ground(0, 0, 0) [m], crank.origin, axis = (0, 0, 1));
                joint d: revolute(ground(2, 0, 0) [m], rocker.origin, axis = (0, 0, 1));
                joint b: revolute(crank.tip, coupler.near, axis = (0, 0, 1));
                joint c: revolute(coupler.far, rocker.tip, axis = (0, 0, 1));
                start {{ a.angle [deg] = 60; d.angle [deg] ~ 80; coupler.rate.x [rad/s] = 0; }}
                options {{ redundant = drop; coordinates = {coordinates}; }}
            }}"
        );
        let source = source.replace("(1, 0.1, 0.1); }", "(1, 0.1, 0.1); point tip [m] = (1, 0, 0); }");
        let source =
            source.replace(" coupler.rate.x [rad/s] = 0;", "").replacen("(1, 0, 0); }", "(1.2, 0, 0); }", 1);
        let mobility = compiled(&source).assembly.mobility;
        assert_eq!((mobility.apart, mobility.equations, mobility.counted()), (18, 20, -2));
        assert_eq!((mobility.generic, mobility.redundant.len()), (1, 3));
        let reason = "the axes of a, d, b and c are parallel, so that the loop moves in a plane";
        assert_eq!(mobility.reasons, [reason], "{coordinates}");
        let text = mobility.to_string();
        let beginning = "1 degree of freedom; Grübler's count is 18 freedoms of 3 bodies less 20 equations of 4 joints, -2.";
        assert!(text.starts_with(beginning), "{text}");
    }
}

/// Sarrus' linkage: Grübler counts nothing, and it moves, because its axes have but two directions.
#[test]
fn two_directions_of_axes() {
    let leg = |name: &str, base: &str, head: &str| {
        format!(
            "rod lower_{name} {{ mass [kg] = 0.4; length [m] = 0.5; }} rod upper_{name} {{ mass [kg] = 0.4; length [m] = 0.5; }}
             joint foot_{name}: revolute({base}, lower_{name}.start, axis = (0, -1, 0));
             joint knee_{name}: revolute(lower_{name}.end, upper_{name}.start, axis = (0, -1, 0));
             joint head_{name}: revolute(upper_{name}.end, {head}, axis = (0, -1, 0));
             start {{ foot_{name}.angle [deg] ~ 60; knee_{name}.angle [deg] ~ 60; head_{name}.angle [deg] ~ -120; }}"
        )
    };
    let (one, other) = (leg("a", "ground(0.3, 0, 0) [m]", "platform.a"), leg("b", "base_b", "platform.b"));
    let source = format!(
        "spatial Sarrus {{
            box platform {{ mass [kg] = 1; size [m] = (0.6, 0.6, 0.02);
                           point a [m] = (0.3, 0, 0); marker b [m] = (0, 0.3, 0), about_z [deg] = 90; }}
            marker base_b [m] = (0, 0.3, 0), about_z [deg] = 90;
            {one} {other}
            options {{ redundant = drop; }}
        }}"
    );
    let mobility = compiled(&source).assembly.mobility;
    assert_eq!((mobility.counted(), mobility.generic, mobility.redundant.len()), (0, 1, 1));
    let reason =
        "the axes of foot_a, knee_a and head_a are parallel, and so are those of foot_b, knee_b and head_b";
    assert_eq!(mobility.reasons, [reason]);
}

/// In either set of coordinates the same bodies move alone.
#[test]
fn loose_bodies_and_idle_freedoms() {
    for coordinates in ["tree", "absolute"] {
        let source = format!(
            "spatial A {{
                body foot  {{ mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point hip [m] = (0, 0, 1); }}
                body lower {{ mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); }}
                body upper {{ mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); }}
                body flag  {{ mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); }}
                body pole  {{ mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); }}
                joint lift:  prismatic(ground(0, 0, 0) [m], foot.origin, axis = (0, 0, 1));
                joint below: spherical(ground(0.5, 0, 0) [m], lower.origin);
                joint slide: prismatic(lower.origin, upper.origin, axis = (0, 0, 1));
                joint above: spherical(foot.hip, upper.origin);
                joint tip:   revolute(foot.hip, pole.origin, axis = (1, 0, 0));
                joint seam:  fixed(pole.origin, flag.origin);
                start {{ lift.travel [m] = 0.1; slide.travel [m] ~ 1.2; }}
                options {{ coordinates = {coordinates}; }}
            }}"
        );
        let compiled = compiled(&source);
        assert_eq!(compiled.assembly.mobility.generic, 3);
        let loose: Vec<String> = compiled.loose().iter().map(ToString::to_string).collect();
        let expected = [
            "\"flag\" and \"pole\" can turn freely about \"tip\"",
            "\"lower\" and \"upper\" can spin about their own axis between their two spherical joints \"below\" and \"above\"",
        ];
        assert_eq!(loose, expected, "{coordinates}");
    }
}

/// At its return point the slider of a quick return stands still while the crank turns on: for an instant, which is no
/// freedom of the crank.
#[test]
fn dead_centres_are_no_idle_freedoms() {
    let source = "planar QuickReturn {
            rod crank { mass [kg] = 1; length [m] = 0.15; }
            rod guide { mass [kg] = 1; length [m] = 0.4; line slot = (guide.start, guide.end); }
            joint crank_pin: revolute(ground(0, 0) [m], crank.start);
            joint guide_pin: revolute(ground(0, -0.2) [m], guide.start);
            joint block:     point_on_line(guide.slot, crank.end);
            start { crank_pin.angle [rad] = 360 [deg] - asin(3/4); guide_pin.angle [deg] ~ 50; }
        }";
    assert!(compiled(source).loose().is_empty());
}

/// A roller that turns about its pin while the rest stands still, and a bob on a slide.
#[test]
fn loose_bodies_in_the_plane() {
    let more =
        "disk roller { mass [kg] = 1; radius [m] = 0.1; } joint pin: revolute(coupler.center, roller.center);
                body bead { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
                joint way: prismatic(rocker.center, bead.center, axis = (1, 0));";
    let compiled = compiled(&format!("planar A {{ {PLANAR_FOUR_BAR} {more} }}"));
    assert_eq!(compiled.assembly.mobility.generic, 3);
    let loose: Vec<String> = compiled.loose().iter().map(ToString::to_string).collect();
    assert_eq!(
        loose,
        ["\"roller\" can turn freely about \"pin\"", "\"bead\" can slide freely along \"way\""]
    );
}

/// A start that is singular beside redundancy is told apart from it, and so is one that no motion leaves.
#[test]
fn singular_starts_are_told_from_redundancy() {
    let flat = "spatial Flat {
            box crank { mass [kg] = 1; size [m] = (1, 0.1, 0.1); point tip [m] = (1, 0, 0); }
            box coupler { mass [kg] = 1; size [m] = (2, 0.1, 0.1); point near [m] = (-1, 0, 0); point far [m] = (1, 0, 0); }
            box rocker { mass [kg] = 1; size [m] = (1, 0.1, 0.1); point tip [m] = (1, 0, 0); }
            joint a: revolute(ground(0, 0, 0) [m], crank.origin, axis = (0, 0, 1));
            joint d: revolute(ground(2, 0, 0) [m], rocker.origin, axis = (0, 0, 1));
            joint b: revolute(crank.tip, coupler.near, axis = (0, 0, 1));
            joint c: revolute(coupler.far, rocker.tip, axis = (0, 0, 1));
            start { a.angle [deg] = 0; d.angle [deg] ~ 0; b.angle [deg] ~ 0; }
            expect { degrees_of_freedom = 1; }
            options { redundant = drop; }
        }";
    let text = errors(flat);
    assert_eq!(text.lines().count(), 1, "{text}");
    assert!(
        text.starts_with("error: at the start position the constraints lose rank (singular position"),
        "{text}"
    );
    assert!(text.contains("it is 1 there and 2 a little further on"), "{text}");
    let refused = errors(&flat.replace("drop", "refuse"));
    assert!(
        refused.starts_with("error: 4 joints give 20 constraint equations of rank 17, all along the motion"),
        "{refused}"
    );
    // 2 m of ground, and links of 1 m that just reach: they shake and cannot move; a little longer they are rigid.
    let two_links = |length: f64| {
        format!(
            "planar TwoLinks {{
                rod one {{ mass [kg] = 1; length [m] = 1; }} rod two {{ mass [kg] = 1; length [m] = {length}; }}
                joint a: revolute(ground(0, 0) [m], one.start);
                joint b: revolute(one.end, two.start);
                joint c: revolute(two.end, ground(2, 0) [m]);
                start {{ a.angle [deg] ~ 10; b.angle [deg] ~ -10; }}
            }}"
        )
    };
    let text = errors(&two_links(1.0));
    assert!(text.contains("no motion but an infinitesimal one (one and two in line)"), "{text}");
    let rigid = compiled(&two_links(1.1)).assembly.mobility;
    assert_eq!((rigid.counted(), rigid.generic), (0, 0));
}

/// A table on parallel cranks whose pins are not in line: of two rows a crank repeats one each after the second, and which one turns
/// with the cranks. A few such rows are switched, many are refused.
#[test]
fn many_rows_that_switch_are_refused() {
    let pins = ["0, 0", "1, 0.3", "2, 0", "0.5, 0.6", "1.5, -0.4", "0.2, -0.5", "1.8, 0.7"];
    let table = |count: usize| {
        let pins = || pins.iter().take(count).enumerate();
        let points: String = pins().map(|(i, at)| format!("point p{i} [m] = ({at}); ")).collect();
        let cranks = pins().map(|(i, at)| {
            let guess = if i == 0 { "a0.angle [deg] = 70;".to_string() } else { format!("a{i}.angle [deg] ~ 70;") };
            format!(
                "rod c{i} {{ mass [kg] = 1; length [m] = 1; }}
                 joint a{i}: revolute(ground({at}) [m], c{i}.start); joint b{i}: revolute(c{i}.end, table.p{i});
                 start {{ {guess} }}"
            )
        });
        format!(
            "planar Table {{ body table {{ mass [kg] = 2; inertia [kg*m^2] = 0.5; center [m] = (1, 0); {points} }} {}
               options {{ redundant = drop; }} }}",
            cranks.collect::<String>()
        )
    };
    for count in 3..=6 {
        let switched = |row: &&Row| row.form.name == "switched_1";
        let rows = compiled(&table(count)).complete.equations.rows;
        let expected = if count == 3 { 1 } else { count - 2 };
        assert_eq!(rows.iter().filter(switched).count(), expected, "{count} cranks");
        assert_eq!(rows.len(), count, "{count} cranks");
    }
    let text = errors(&table(7));
    assert!(
        text.starts_with(
            "error: \"b1\" repeats what the others fix, but which of its equations do so changes along the motion"
        ),
        "{text}"
    );
    assert_eq!(text.trim_end().lines().count(), 1, "{text}");
}
