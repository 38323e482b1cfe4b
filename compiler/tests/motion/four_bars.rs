//! Four-bars against Grashof's rule and the rule of cosines.

use crate::{Random, errors, motion, range};
use linkwright_compiler::check::motion::{End, Motion, Range};
use std::f64::consts::{PI, TAU};

/// Ground, crank, coupler, rocker.
type Lengths = [f64; 4];

/// Assembled with the crank at `angle` on the side on which the coupler turns counter-clockwise against the rocker
/// (`side` 1) or clockwise (−1).
fn definition([ground, crank, coupler, rocker]: Lengths, angle: f64, side: f64, more: &str) -> String {
    let [x, y] = [crank * angle.cos() - ground, crank * angle.sin()];
    let diagonal = x.hypot(y);
    let at_rocker =
        ((diagonal * diagonal + rocker * rocker - coupler * coupler) / (2.0 * diagonal * rocker)).acos();
    let rocker_angle = y.atan2(x) - side * at_rocker;
    let end = [ground + rocker * rocker_angle.cos(), rocker * rocker_angle.sin()];
    let coupler_angle = (end[1] - crank * angle.sin()).atan2(end[0] - crank * angle.cos());
    format!(
        "planar FourBar {{
            rod crank   {{ mass [kg] = 1; length [m] = {crank}; }}
            rod coupler {{ mass [kg] = 1; length [m] = {coupler}; }}
            rod rocker  {{ mass [kg] = 1; length [m] = {rocker}; }}
            joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
            joint rocker_pin: revolute(ground({ground}, 0) [m], rocker.start);
            joint left:  revolute(crank.end, coupler.start);
            joint right: revolute(coupler.end, rocker.end);
            start {{ crank_pin.angle [rad] = {angle}; rocker_pin.angle [rad] ~ {rocker_angle};
                     coupler.angle [rad] ~ {coupler_angle}; }}
            {more}
        }}"
    )
}

/// Range of the angle between two links at a pin, by the rule of cosines: the diagonal opposite lies between what both
/// pairs of links allow. `None`: the angle turns fully; else its least and largest magnitude, in 0..π.
fn between([a, b]: [f64; 2], [c, d]: [f64; 2]) -> Option<(f64, f64)> {
    let angle = |diagonal: f64| ((a * a + b * b - diagonal * diagonal) / (2.0 * a * b)).acos();
    let (nearest, furthest) = ((c - d).abs(), c + d);
    let folds = (a - b).abs() >= nearest;
    let stretches = a + b <= furthest;
    if folds && stretches {
        return None;
    }
    Some((if folds { 0.0 } else { angle(nearest) }, if stretches { PI } else { angle(furthest) }))
}

/// Checks a range against the two magnitudes that the rule of cosines gives, with the angle counted from `zero`.
fn check(found: &Range, expected: Option<(f64, f64)>, zero: f64, what: &str) {
    let Some((least, most)) = expected else {
        assert!(found.turns, "{what}: {found:?}");
        return;
    };
    assert!(!found.turns, "{what}: {found:?}");
    let (from, to) = (found.from - zero, found.to - zero);
    // On one side, through the folded position, or through the stretched one.
    let folded = least == 0.0;
    let stretched = most == PI;
    let candidates = match (folded, stretched) {
        (false, false) => vec![(least, most), (-most, -least)],
        (true, false) => vec![(-most, most)],
        _ => vec![(least, TAU - least)],
    };
    let fits = candidates.iter().any(|(least, most)| {
        let turns = TAU * ((from - least) / TAU).round();
        (from - turns - least).abs() < 1e-9 && (to - turns - most).abs() < 1e-9
    });
    assert!(fits, "{what}: {found:?}, expected {candidates:?} from {zero}");
}

/// All four pins.
fn check_all(motion: &Motion, [ground, crank, coupler, rocker]: Lengths, what: &str) {
    assert_eq!(motion.end, End::Closed, "{what}");
    assert!(motion.singular.is_empty(), "{what}: {:?}", motion.singular);
    // The angle between crank and ground is crank_pin's; between rocker and ground it is measured from the other side.
    check(range(motion, "crank_pin.angle"), between([crank, ground], [coupler, rocker]), 0.0, what);
    check(range(motion, "rocker_pin.angle"), between([rocker, ground], [coupler, crank]), PI, what);
    check(range(motion, "left.angle"), between([crank, coupler], [ground, rocker]), PI, what);
    check(range(motion, "right.angle"), between([coupler, rocker], [ground, crank]), 0.0, what);
}

/// A crank angle at which the loop closes with room to spare.
fn closing([ground, crank, coupler, rocker]: Lengths, random: &mut Random) -> Option<f64> {
    (0..50).map(|_| random.between(-3.0, 3.0)).find(|angle| {
        let diagonal = (ground * ground + crank * crank - 2.0 * ground * crank * angle.cos()).sqrt();
        diagonal > (coupler - rocker).abs() + 0.05 && diagonal < coupler + rocker - 0.05
    })
}

#[test]
fn ranges_follow_from_the_rule_of_cosines() {
    let mut random = Random(1);
    let mut kinds = [0; 4];
    for number in 0..60 {
        let lengths: Lengths = std::array::from_fn(|_| random.between(0.3, 3.0));
        let mut sorted = lengths;
        sorted.sort_by(f64::total_cmp);
        let margin = sorted[1] + sorted[2] - sorted[0] - sorted[3];
        // Near the change point the closed form is as ill-conditioned as the mechanism.
        if margin.abs() < 0.02 || sorted[3] > sorted[0] + sorted[1] + sorted[2] - 0.1 {
            continue;
        }
        let Some(angle) = closing(lengths, &mut random) else { continue };
        let side = if number % 2 == 0 { 1.0 } else { -1.0 };
        let source = definition(lengths, angle, side, "expect { no_singularity; }");
        let motion = motion(&source);
        check_all(&motion, lengths, &format!("{number}: {lengths:?} at {angle}"));
        let shortest = lengths.iter().position(|length| *length == sorted[0]).expect("one is shortest");
        // Grashof: which links turn fully.
        let turning = [range(&motion, "crank_pin.angle").turns, range(&motion, "rocker_pin.angle").turns];
        let kind = match (margin > 0.0, shortest) {
            (false, _) => (0, [false, false]),
            (true, 0) => (1, [true, true]),
            (true, 1) => (2, [true, false]),
            (true, 2) => (0, [false, false]),
            (true, _) => (3, [false, true]),
        };
        assert_eq!(turning, kind.1, "{lengths:?}");
        kinds[kind.0] += 1;
    }
    // Double rockers, double cranks and crank-rockers of both hands were among them.
    assert!(kinds.iter().all(|count| *count > 2), "{kinds:?}");
}
