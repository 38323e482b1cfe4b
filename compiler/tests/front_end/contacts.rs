//! Contacts: what is warned of, what may be allowed, what a point on a plane costs, how long a touch takes.

use crate::{bad, underlined, warnings};
use linkwright_compiler::compile;
use linkwright_compiler::diagnostics::{Diagnostic, Lint, Severity};
use linkwright_compiler::schedule::{Function, count};

/// A ball above a floor, with these statements.
fn ball(height: f64, statements: &str) -> String {
    format!(
        "planar Bench {{ gravity [m/s^2] = (0, -9.81); disk ball {{ mass [kg] = 2; radius [m] = 0.1; }}
         surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
         start {{ ball.center.x [m] = 0; ball.center.y [m] = {height}; }} {statements} }}"
    )
}

#[track_caller]
fn compiled(source: &str) -> linkwright_compiler::Compiled {
    compile(source.parse().expect("tokens"), None).unwrap_or_else(|found| panic!("{found}"))
}

#[test]
fn a_start_within_may_be_allowed() {
    let contact = "contact touch: between(ball.surface, floor) = kelvin_voigt(stiffness [N/m] = 1e4);";
    assert!(compile(ball(0.09, contact).parse().unwrap(), None).is_err());
    compiled(&ball(0.09, &format!("#[allow(penetration)] {contact}")));
    compiled(&ball(0.11, contact));
}

#[test]
fn what_is_no_law_is_named() {
    let said = |law: &str, expected: &str| {
        let source = ball(0.5, &format!("contact touch: between(ball.surface, floor) = {law};"));
        let found = bad(&source).to_string();
        assert!(found.contains(expected), "{found}");
    };
    said(
        "kelvin_voight(stiffness [N/m] = 1e4, damping [N*s/m] = 10)",
        "no law of a contact called \"kelvin_voight\"; did you mean `kelvin_voigt`?",
    );
    said("ridgid(restitution = 0.5)", "no law of a contact called \"ridgid\"; did you mean `rigid`?");
    said("spring(stiffness [N/m] = 1e4)", "no law of a contact called \"spring\"; there are kelvin_voigt,");
    said(
        "penalty(stiffness [N/m] = 1e4)",
        "by a `penalty` a joint without play yields, and `touch` is a contact: it has a law of its depth, one of `kelvin_voigt`, ",
    );
    said("maximum(0, 1 [N])", "no function called \"maximum\"");
}

#[test]
fn what_yields_is_stiff() {
    let found =
        bad(&ball(0.5, "contact touch: between(ball.surface, floor) = kelvin_voigt(stiffness [N/m] = 0);"));
    assert!(found.to_string().contains("a contact that yields needs a `stiffness` above zero"), "{found}");
}

#[test]
fn smooth_friction_has_no_share_in_impulses() {
    let source = ball(
        0.5,
        "contact touch: between(ball.surface, floor) = rigid(restitution = 0.5);
         friction rub: on(touch) = coulomb(coefficient = 0.3, speed [m/s] = 0.01);",
    );
    let found = compile(source.parse().expect("tokens"), None).map(|_| ()).expect_err("it is refused");
    let [error] = &found.iter().collect::<Vec<_>>()[..] else { panic!("{found}") };
    let expected = "`dry` friction at the contact itself has a share: write that, leave `rub` out, or give `touch` a law of its depth";
    assert!(error.message.contains(expected), "{}", error.message);
    let shown = underlined(&source, error.region);
    let (line, marks) = shown.split_once('\n').unwrap_or_default();
    assert_eq!(&line[marks.len() - marks.trim().len()..marks.len()], "rub", "{shown}");
}

#[test]
fn a_contact_is_not_stated() {
    let found = bad(&ball(
        0.5,
        "contact touch: between(ball.surface, floor) = rigid(restitution = 0.5); start { touch.gap [m] = 0.3; }",
    ));
    let expected = "`touch.gap` cannot stand here: what `touch` is like follows from where its bodies are, so state or drive their \
                    angles, travels and positions";
    assert_eq!(found.iter().map(|one| one.message.as_str()).collect::<Vec<_>>(), [expected]);
}

#[test]
fn what_never_changes_is_warned_of() {
    let source = ball(
        1.0,
        "contact touch: between(ball.surface, floor) = kelvin_voigt(stiffness [N/m] = 1e4);
         body frame { mass [kg] = 1; inertia [kg*m^2] = 1; surface lug: circle(frame.center, radius [m] = 0.1); }
         joint weld: fixed(ground(0, 3) [m], frame.center);
         contact idle: between(frame.lug, floor) = kelvin_voigt(stiffness [N/m] = 1e4);
         surface spare: point(frame.center);",
    );
    let all = compiled(&source).warnings.to_string();
    assert!(all.contains("joints hold both sides of `idle` against each other"), "{all}");
    assert!(
        warnings(&source)
            .iter()
            .any(|it| it.message.contains("nothing names the surface `spare`, so it touches nothing")),
        "{all}"
    );
}

/// A crank that moves a block along a rail, with a stop before it, in a position and with more statements.
fn press(angle: &str, more: &str) -> String {
    format!(
        "planar Press {{ rod crank {{ mass [kg] = 1; length [m] = 0.1; }} rod rod_ {{ mass [kg] = 1; length [m] = 0.3; }}
            body block {{ mass [kg] = 1; inertia [kg*m^2] = 1; point front [m] = (0.05, 0); point low [m] = (0, -0.02);
                surface face: point(block.front); surface sole: point(block.low); }}
            joint main: revolute(ground(0, 0) [m], crank.start); joint big: revolute(crank.end, rod_.start);
            joint wrist: revolute(rod_.end, block.center); joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
            start {{ main.angle [deg] = {angle}; rod_.angle [deg] ~ -10; }} {more} }}"
    )
}

#[test]
fn a_surface_of_a_body_is_proposed() {
    let of = |what: &str| {
        let contact = format!("contact touch: between({what}, floor) = kelvin_voigt(stiffness [N/m] = 1e4);");
        let arm = "rod arm { mass [kg] = 1; length [m] = 1; surface tip: point(arm.end); surface foot: point(arm.start); } rod bar { mass [kg] = 1; length [m] = 1; }";
        let found = bad(&ball(1.0, &format!("{arm} {contact}")));
        found.iter().next().map(|one| one.message.clone()).unwrap_or_default()
    };
    let expected =
        |name: &str, such: &str| format!("`{name}` is a body, expected the name of a surface{such}");
    assert_eq!(of("ball"), expected("ball", ", such as `ball.surface`"));
    assert_eq!(of("arm"), expected("arm", ", such as `arm.foot`"));
    assert_eq!(of("bar"), expected("bar", ""));
}

/// What is warned of because it has no effect.
fn without_effect(source: &str) -> Vec<String> {
    let is_meant = |one: &&Diagnostic| one.severity == Severity::Warning(Lint::NoEffect);
    compiled(source).warnings.iter().filter(is_meant).map(|one| one.message.clone()).collect()
}

#[test]
fn what_joints_hold_is_named() {
    let floor = |height: &str, law: &str| {
        let floor =
            format!("surface floor: half_plane(line(ground(0, {height}) [m], ground(1, {height}) [m])); ");
        floor
            + &format!(
                "contact slides: between(block.sole, floor) = {law}; options {{ coordinates = absolute; }}"
            )
    };
    let rigid = "rigid(restitution = 0.5)";
    let warned = |more: &str| without_effect(&press("40", more));
    for law in [rigid, "kelvin_voigt(stiffness [N/m] = 1e4)"] {
        let expected = "no motion that the joints allow changes the gap of `slides`, which stays 30 mm: leave it out, touch what moves, or write \
                        `#[allow(no_effect)]` before it";
        assert_eq!(warned(&floor("-0.05", law)), [expected]);
    }
    assert!(warned(&floor("-0.05", rigid).replace("contact", "#[allow(no_effect)] contact")).is_empty());
    let source = press("40", &floor("-0.02", rigid));
    let found = compile(source.parse().unwrap(), None).expect_err("it can never part");
    let expected = "`slides` is closed at the start, and no motion that the joints allow opens it, so that no force of it could be known: leave it \
                    out, or touch what moves";
    assert_eq!(found.iter().map(|one| one.message.as_str()).collect::<Vec<_>>(), [expected]);
}

/// Where the block turns back its gap does not change for a moment, and a wall that time moves is none that stands.
#[test]
fn a_stop_at_a_dead_centre_is_one() {
    let stop = "surface wall: half_plane(line(ground(0.45, 0) [m], ground(0.45, 1) [m])); contact meets: between(block.face, wall) = rigid(restitution = 0.5);";
    for coordinates in ["absolute", "tree"] {
        let stop = format!("{stop} options {{ coordinates = {coordinates}; }}");
        assert!(without_effect(&press("0", &stop)).is_empty(), "{coordinates}");
        assert!(without_effect(&press("60", &stop)).is_empty(), "{coordinates}");
        let driven = format!("{stop} drive turn: main.angle = 1 [rad] + 3 [rad/s]*time;");
        let expected = "drivers alone decide the gap of `meets`, and where it closes no impulse of what is rigid stops them: leave it out, give it a law \
                        of its depth, such as `kelvin_voigt`, or write `#[allow(no_effect)]` before it";
        assert_eq!(
            without_effect(&press("60", &driven).replace("main.angle [deg] = 60;", "")),
            [expected],
            "{coordinates}"
        );
        let yields = driven.replace("rigid(restitution = 0.5)", "kelvin_voigt(stiffness [N/m] = 1e4)");
        assert!(
            without_effect(&press("60", &yields).replace("main.angle [deg] = 60;", "")).is_empty(),
            "{coordinates}"
        );
    }
}

/// Four pins of a four-bar: with μ r of 50 mm what presses is found in two passes, with 100 mm it has no solution at some positions.
#[test]
fn friction_that_locks_is_named() {
    let warned = |radius: &str, before: &str| {
        let pins: String = ["a", "b", "c", "d"]
            .iter()
            .map(|pin| format!("{before} friction f_{pin}: on({pin}) = coulomb(coefficient = 0.1, radius [m] = {radius}, speed [rad/s] = 0.05); "))
            .collect();
        let source = format!(
            "planar FourBar {{ gravity [m/s^2] = (0, -9.81); rod crank {{ mass [kg] = 1; length [m] = 0.2; }} rod coupler {{ mass [kg] = 2.5; length [m] = 0.5; }}
             rod rocker {{ mass [kg] = 2; length [m] = 0.4; }} joint a: revolute(ground(0, 0) [m], crank.start); joint b: revolute(crank.end, coupler.start);
             joint c: revolute(coupler.end, rocker.end); joint d: revolute(ground(0.6, 0) [m], rocker.start); {pins}
             start {{ a.angle [deg] = 60; rocker.angle [deg] ~ 98; }} }}"
        );
        compiled(&source).warnings.iter().map(|one| one.message.clone()).collect::<Vec<_>>()
    };
    assert!(warned("0.5", "").is_empty() && warned("1", "#[allow(locks)]").is_empty());
    let found = warned("1", "");
    assert!(
        matches!(&found[..], [one] if one.starts_with("friction at `f_a` makes reactions that make more friction")),
        "{found:?}"
    );
}

#[test]
fn friction_that_nothing_presses_is_named() {
    let of = |law: &str, gravity: &str| {
        without_effect(&format!(
            "planar Rail {{ {gravity} body b {{ mass [kg] = 1; inertia [kg*m^2] = 0.1; }} joint rail: prismatic(ground(0, 0) [m], b.center, axis = (1, 0));
             friction rub: on(rail) = coulomb({law}, speed [m/s] = 0.01); start {{ rail.travel [m] = 0; }} }}"
        ))
    };
    let expected = "no reaction presses at `rub`, wherever it is, so its friction does nothing: give it a `preload [N] = …` or a friction that does not depend on \
                    load, or leave it out";
    assert_eq!(of("coefficient = 0.3", ""), [expected]);
    assert!(of("coefficient = 0.3, preload [N] = 2", "").is_empty());
    assert!(of("coefficient = 0.3", "gravity [m/s^2] = (0, -9.81);").is_empty());
}

/// Of surfaces among each other each pair counts once: 55 of eleven are few enough, 66 of twelve are not.
#[test]
fn surfaces_among_each_other_are_pairs_once() {
    let balls = |count: usize| {
        format!(
            "planar Balls {{ repeat i in 0..{count} {{ disk ball[i] {{ mass [kg] = 1; radius [m] = 0.1; }}
             start {{ ball[i].center.x [m] = i; ball[i].center.y [m] = 0; ball[i].angle [rad] = 0; }} }}
             contact hit: between(each ball[i].surface, each ball[j].surface) = kelvin_voigt(stiffness [N/m] = 1e4); output force [N] = hit[9][10].force; }}"
        )
    };
    assert_eq!(compiled(&balls(11)).mechanism.loads.len(), 55);
    let found = bad(&balls(12));
    let found: Vec<&str> = found.iter().map(|error| error.message.as_str()).collect();
    assert!(matches!(found[..], [one] if one.contains("`hit` would be 66 contacts")), "{found:?}");
}

/// A point on a plane takes at most 25 operations beyond what moves it.
#[test]
fn a_point_on_a_plane_is_cheap() {
    let body = |contact: &str| {
        format!(
            "spatial Bench {{ gravity [m/s^2] = (0, 0, -9.81); body block {{ mass [kg] = 2; inertia [kg*m^2] = (1, 2, 3); point p [m] = (0.1, 0.2, 0.3);
             surface tip: point(block.p); }} surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));
             start {{ block.center.z [m] = 1; }} {contact} }}"
        )
    };
    let operations = |law: &str| {
        let compiled = compiled(&body(law));
        count(compiled.programs.get(Function::Forces)).total()
    };
    let with = operations(
        "contact touch: between(block.tip, floor) = kelvin_voigt(stiffness [N/m] = 1e4, damping [N*s/m] = 20);",
    );
    // The same kinematics: a force along the height of the point that depends on it and on its rate.
    let without = operations(
        "force pull: force(block.p) = (0, 0, -1 [N/m]*block.p.z - 2 [N*s/m]*block.p.velocity.z); contact touch: gap(block.p.x + 9 [m]) = 0 [N];",
    );
    println!("{with} operations with the contact, {without} with a spring and a damper");
    assert!(with <= without + 25, "{with} {without}");
}

/// π√(m/k), and 3.2181 (m²/(K² v))^(1/5) of Hertz' exponent.
#[test]
fn how_long_a_touch_takes() {
    let linear = compiled(&ball(
        1.0,
        "contact touch: between(ball.surface, floor) = kelvin_voigt(stiffness [N/m] = 800);",
    ));
    let [(_, blow)] = linear.blows[..] else { panic!("{:?}", linear.blows) };
    assert!((blow.mass - 2.0).abs() < 1e-12, "{blow:?}");
    assert!((blow.time - std::f64::consts::PI * (2.0_f64 / 800.0).sqrt()).abs() < 1e-12, "{blow:?}");
    let steep = compiled(&ball(
        1.0,
        "contact touch: between(ball.surface, floor) = hunt_crossley(force [N] = 1e3, depth [mm] = 10, restitution = 0.8, speed [m/s] = 3);",
    ));
    let [(_, blow)] = steep.blows[..] else { panic!("{:?}", steep.blows) };
    let expected = 3.218_1 * (4.0_f64 / (1e12 * 3.0)).powf(0.2);
    assert!((blow.time / expected - 1.0).abs() < 1e-4, "{blow:?} {expected}");
}

/// A ball at 3 m beside a profile about the origin with these knots and words behind them, and these arguments.
fn profiled(knots: &str, words: &str, arguments: &str) -> String {
    ball(
        3.0,
        &format!(
            "table flank(turn [deg]) [mm] = [{knots}]{words}; table grid(turn [deg], x [m]) [mm] = grid((0, 1), (0, 1), [(1, 2), (3, 4)]), bilinear;
             #[allow(unused)] surface lobe: profile(ground(0, 0) [m], {arguments});
             contact touch: between(ball.surface, lobe) = kelvin_voigt(stiffness [N/m] = 1e4);"
        ),
    )
}

/// Its one message has this in it.
#[track_caller]
fn only(source: &str, expected: &str) {
    let found = bad(source);
    let found: Vec<&str> = found.iter().map(|error| error.message.as_str()).collect();
    assert!(matches!(found[..], [message] if message.contains(expected)), "{found:?}, not {expected}");
}

const KNOTS: &str = "(0, 0), (90, 5), (180, 8), (270, 4), (360, 0)";

#[test]
fn a_profile_is_a_closed_curve_about_its_place() {
    compiled(&profiled(KNOTS, ", periodic", "radius = flank, base [mm] = 400"));
    for (knots, words, arguments, expected) in [
        (
            KNOTS,
            ", periodic",
            "radius = 20 [mm]",
            "`radius` of a profile is the name of a table of the angle: declare `table flank(turn [deg]) [mm] = [(0, 20), …, (360, 20)], \
             periodic;` and write `radius = flank`",
        ),
        (
            KNOTS,
            ", periodic",
            "radius = grid",
            "`grid` is a table of two arguments: the radius of a profile depends on the angle alone",
        ),
        (
            KNOTS,
            "",
            "radius = flank",
            "`flank` does not repeat itself: a profile comes round after a whole turn; let its knots go from 0 to 360 deg, and write `periodic` \
             behind them",
        ),
        (
            "(0, 400), (90, 420), (180, 400)",
            ", periodic",
            "radius = flank",
            "`flank` repeats itself after 180 degrees: a profile comes round after a whole turn; let its knots go from 0 to 360 deg, and write \
             `periodic` behind them",
        ),
        (
            KNOTS,
            ", periodic",
            "radius = flank, base [mm] = 400, refine = 1.5",
            "`refine` is how often the foot on the profile is made better, a whole number from 0 to 8, found 1.5",
        ),
        (
            KNOTS,
            ", periodic",
            "radius = flank",
            "a profile goes around its place, so that its radius is positive everywhere; add a `base`, as `base [mm] = 20`",
        ),
        (
            "(0, 0), (60, 0), (90, -150), (120, 0), (360, 0)",
            ", periodic",
            "radius = flank, base [mm] = 400",
            "it would touch at two places at once; make it smaller",
        ),
    ] {
        only(&profiled(knots, words, arguments), expected);
    }
    let grain = "planar Bench { particle grain { mass [kg] = 1; } disk ball { mass [kg] = 1; radius [m] = 0.1; }
        table flank(turn [deg]) [mm] = [(0, 400), (180, 420), (360, 400)], periodic; surface lobe: profile(grain.center, radius = flank);
        contact touch: between(ball.surface, lobe) = 0 [N]; start { ball.center.x [m] = 3; ball.center.y [m] = 0; grain.center.x [m] = 0; grain.center.y [m] = 0; } }";
    only(grain, "`grain.center` is a particle and has no orientation");
    let speed = "planar Bench { disk ball { mass [kg] = 1; radius [m] = 0.1; } table flank(turn [m]) [mm] = [(0, 400), (3, 420), (6, 400)], periodic;
        surface lobe: profile(ground(0, 0) [m], radius = flank); contact touch: between(ball.surface, lobe) = 0 [N];
        start { ball.center.x [m] = 3; ball.center.y [m] = 0; } }";
    only(speed, "expected rad, found m");
}

/// Those of surfaces and laws that no pair in `tests/messages/ui` shows.
#[test]
fn one_message_for_each_mistake() {
    let law = |rest: &str| ball(1.0, &format!("contact touch: between(ball.surface, floor) = {rest};"));
    let of = |statement: &str| ball(1.0, statement);
    let corners: Vec<String> = (0..17)
        .map(|k| f64::from(k) * 0.3)
        .map(|angle| format!("ground({}, {}) [m]", angle.cos(), angle.sin()))
        .collect();
    let many = format!(
        "surface round: polygon({}); contact touch: between(ball.surface, round) = 0 [N];",
        corners.join(", ")
    );
    let spatial = |rest: &str| {
        format!(
            "spatial Bench {{ sphere ball {{ mass [kg] = 1; radius [m] = 0.1; }} surface floor: plane(ground(0, 0, -1) [m], axis = (0, 0, 1));
             body coin {{ mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); surface rim: disk_rim(coin.center, axis = (0, 0, 1), radius [m] = 1); }} {rest} }}"
        )
    };
    for (source, expected) in [
        (
            of(
                "surface anvil: circle(ground(3, 0) [m], radius [m] = 0.1); contact hit: between(ball.surface, anvil) = rigid(restitution = 0.5); contact touch: between(ball.surface, floor) = \
                 hunt_crossley(force [N] = 1, depth [m] = 1, restitution = 0.5, speed = touch);",
            ),
            "`speed = touch` needs held gates, which beside `hit`, a rigid contact, what yields does not have yet: state the speed that is expected, `speed [m/s] = 1`",
        ),
        (
            of("contact touch: among(ball.surface, floor) = 0 [N];"),
            "a contact is `between(surface, surface)` or, for any other geometry, `gap(expression)` of positions that is negative in \
             contact; found `among`",
        ),
        (
            of(
                "material odd { modulus [Pa] = 1e9; poisson = 0.7; } contact touch: between(ball.surface, floor) = hertz(first = odd, second = odd, dissipation [s/m] = 0);",
            ),
            "Poisson's number lies between -1 and 0.5, found 0.7",
        ),
        (
            law(
                "hunt_crossley(force [N] = 1, depth [m] = 1, restitution = 0.5, speed [m/s] = 1, damping = exactly)",
            ),
            "this is a word: `exact`, `lankarani_nikravesh`, `hunt_crossley`, `flores`",
        ),
        (
            of(
                "surface bar: segment(ground(1, 1) [m], ground(1, 1) [m]); contact touch: between(ball.surface, bar) = 0 [N];",
            ),
            "the ends of the surface `bar` are one place, so it has no direction: give it two places apart, or make it a `point`",
        ),
        (
            of(
                "surface bar: segment(ground(1, 1) [m], ball.center); contact touch: between(ball.surface, bar) = 0 [N];",
            ),
            "the places `ground(1, 1)` and `ball.center` of the surface `bar` are of two bodies: a surface is of one body or of the ground",
        ),
        (of(&many), "a polygon has at most 16 corners, found 17: every step looks at all of its edges"),
        (
            spatial("contact touch: between(coin.rim, ball.surface) = 0 [N];"),
            "there is no closed form for the gap between the rim of a disk and a point, circle or sphere: a point or sphere meets a plane, \
             sphere, capsule, cylinder, ball_socket or bore; a capsule meets a plane or capsule, a disk_rim a plane. Any other gap is an \
             expression of positions, `gap(…)`",
        ),
        (
            of("contact touch: gap(ball.center.y) = 1 [N]; output x [m] = touch.point.x;"),
            "`touch` has no `point`: where a gap is an expression or the end of a range, no place follows from it",
        ),
        (
            spatial("contact touch: between(ball.surface, floor) = 0 [N]; output x [m] = touch.point;"),
            "a contact has `touch.gap`, `.depth`, `.closing`, `.force`, `.sliding.x`, `.point.x` and so on to `.z`, and `power(touch)`",
        ),
        (
            spatial("contact touch: between(ball.surface, floor) = 0 [N]; output v [m/s] = touch.sliding;"),
            "a contact has `touch.gap`, `.depth`, `.closing`, `.force`, `.sliding.x`, `.point.x` and so on to `.z`, and `power(touch)`",
        ),
        (
            spatial(
                "contact touch: between(ball.surface, floor) = 0 [N]; friction grip: on(touch) = coulomb(coefficient = 0.3, speed [m/s] = 0.01); output f [N] = grip.force;",
            ),
            "`grip` has the quantity `grip.normal`, and its power is `power(grip)`",
        ),
        (
            law("hunt_crossley(force [N] = 1, depth [m] = 1, dissipation [s/m] = 0.5, speed [m/s] = 1)"),
            "`speed` and `damping` say how a dissipation follows from a `restitution`: beside `dissipation` they say nothing",
        ),
        (
            law("kelvin_voigt(stiffness [N/m] = 1, release = 2)"),
            "`release` is the share of the damping that acts on the way out, 0 to 1, found 2",
        ),
    ] {
        let found = bad(&source);
        let found: Vec<&str> = found.iter().map(|error| error.message.as_str()).collect();
        assert_eq!(found, [expected], "{source}");
    }
}

/// A hub on a shaft with this statement between them.
fn hub(statement: &str, start: &str) -> String {
    format!(
        "planar Hub {{ body shaft {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; }} body hub {{ mass [kg] = 1; inertia [kg*m^2] = 0.05; }}
         param gap [rad] = 0.02 in 0.001..0.1; joint bearing: revolute(ground(0, 0) [m], shaft.center); joint seat: revolute(shaft.center, hub.center);
         {statement} start {{ seat.angle [rad] = {start}; }} }}"
    )
}

/// It is the limit that it is short for, and may be bent at the start.
#[test]
fn a_torsion_spring_with_play() {
    let values = "stiffness [N*m/rad] = 1000, damping [N*m*s/rad] = 0.5";
    for (short, long) in [
        (
            format!("torsion_spring bar: torsion_spring(seat, {values}, play [deg] = 2);"),
            format!("limit bar: seat.angle [deg] in -1..1 = kelvin_voigt({values});"),
        ),
        (
            format!("torsion_spring bar: torsion_spring(seat, {values}, play = gap, angle [rad] = 0.3);"),
            format!(
                "#[allow(penetration)] limit bar: seat.angle in 0.3 [rad] - gap/2..0.3 [rad] + gap/2 = kelvin_voigt({values});"
            ),
        ),
    ] {
        let [short, long] = [short, long].map(|statement| {
            format!("{:?}", compiled(&hub(&statement, "0.001")).programs.get(Function::Forces))
        });
        assert_eq!(short, long);
    }
    for play in ["[rad] = 0", "[rad] = -0.1"] {
        let statement = format!("torsion_spring bar: torsion_spring(seat, {values}, play {play});");
        let expected = "the play of `bar` is the whole gap in which it moves freely, more than zero: leave it out where there is none";
        only(&hub(&statement, "0"), expected);
    }
}
