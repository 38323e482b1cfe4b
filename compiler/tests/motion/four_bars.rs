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
    let start = format!(
        "crank_pin.angle [rad] = {angle}; rocker_pin.angle [rad] ~ {rocker_angle}; coupler.angle [rad] ~ {coupler_angle};"
    );
    four_bar([ground, crank, coupler, rocker], &start, more)
}

/// Between pins on a line, with what `start` states.
pub fn four_bar([ground, crank, coupler, rocker]: Lengths, start: &str, more: &str) -> String {
    format!(
        "planar FourBar {{
            rod crank   {{ mass [kg] = 1; length [m] = {crank}; }}
            rod coupler {{ mass [kg] = 1; length [m] = {coupler}; }}
            rod rocker  {{ mass [kg] = 1; length [m] = {rocker}; }}
            joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
            joint rocker_pin: revolute(ground({ground}, 0) [m], rocker.start);
            joint left:  revolute(crank.end, coupler.start);
            joint right: revolute(coupler.end, rocker.end);
            start {{ {start} }}
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

/// At the limit of Grashof's rule the links can lie in one line, and the motion goes straight on there.
#[test]
fn change_points_are_found_and_passed() {
    let motion = motion(&definition([4.0, 1.0, 2.0, 3.0], 1.0, 1.0, ""));
    assert_eq!(motion.end, End::Closed);
    let at: Vec<f64> = motion.singular.iter().map(|singular| singular.reference).collect();
    // Both branches, one after the other: the cycle closes after two turns of the crank.
    assert_eq!(at.len(), 2, "{at:?}");
    assert!((at[0] - PI).abs() < 1e-8 && (at[1] - 3.0 * PI).abs() < 1e-8, "{at:?}");
    for singular in &motion.singular {
        assert_eq!(singular.lost, ["right"]);
        assert_eq!(singular.in_line, ["crank", "coupler", "rocker"]);
    }
    let crank = range(&motion, "crank_pin.angle");
    assert!((crank.to - crank.from - 2.0 * TAU).abs() < 1e-9, "{crank:?}");
    // cos of the rocker's angle against the ground, crank and coupler in line: (16 + 9 − 9)/24.
    let rocker = range(&motion, "rocker_pin.angle");
    let swing = (16.0_f64 / 24.0).acos();
    assert!(
        (rocker.from - (PI - swing)).abs() < 1e-9 && (rocker.to - (PI + swing)).abs() < 1e-9,
        "{rocker:?}"
    );
}

/// A little to either side of the limit the links come near to one line, turn sharply, and stay on their branch.
#[test]
fn near_misses_of_change_points_follow_grashof() {
    for exponent in 2..=9 {
        let little = 10f64.powi(-exponent);
        for (rocker, turns) in [(3.0 + little, true), (3.0 - little, false)] {
            let lengths = [4.0, 1.0, 2.0, rocker];
            let motion = motion(&definition(lengths, 1.0, 1.0, ""));
            assert_eq!((motion.end, motion.singular.len()), (End::Closed, 0), "{rocker}");
            let crank = range(&motion, "crank_pin.angle");
            assert_eq!(crank.turns, turns, "{rocker}: {crank:?}");
            if let Some((_, most)) = between([1.0, 4.0], [2.0, rocker]) {
                assert!(
                    (crank.to - most).abs() < 1e-6 && (crank.from + most).abs() < 1e-6,
                    "{rocker}: {crank:?}"
                );
            }
        }
    }
}

#[test]
fn parallelograms_stay_parallelograms() {
    let motion = motion(&definition([2.0, 1.0, 2.0, 1.0], 1.2, 1.0, ""));
    assert_eq!((motion.end, motion.singular.len()), (End::Closed, 2));
    assert!(["crank_pin.angle", "rocker_pin.angle"].iter().all(|of| range(&motion, of).turns));
    let [crank, rocker] = ["crank_pin.angle", "rocker_pin.angle"].map(|of| range(&motion, of));
    assert!((crank.from - rocker.from).abs() < 1e-9 && (crank.to - rocker.to).abs() < 1e-9);
}

/// Where two loops lose rank at once no determinant changes its sign.
#[test]
fn ladders_lose_rank_in_all_windows_at_once() {
    for windows in [2, 3, 8] {
        let source = format!(
            "planar Ladder {{
                const N = {windows};
                repeat i in 0..N+1 {{
                    rod upright[i] {{ mass [kg] = 1; length [m] = 1; }}
                    joint pin[i]: revolute(ground(i, 0) [m], upright[i].start);
                }}
                repeat i in 0..N {{
                    rod bar[i] {{ mass [kg] = 1; length [m] = 1; }}
                    joint left[i]:  revolute(upright[i].end, bar[i].start);
                    joint right[i]: revolute(bar[i].end, upright[i+1].end);
                    start {{ bar[i].angle [rad] ~ 0; pin[i+1].angle [deg] ~ 70; }}
                }}
                start {{ pin[0].angle [deg] = 70; }}
            }}"
        );
        let motion = motion(&source);
        assert_eq!((motion.end, motion.singular.len()), (End::Closed, 2), "{windows}");
        for singular in &motion.singular {
            assert_eq!(singular.lost.len(), windows);
        }
        assert!(range(&motion, &format!("pin[{windows}].angle")).turns);
    }
}

#[test]
fn what_is_as_expected_is_silent() {
    let more = "expect { degrees_of_freedom = 1; rotates = (crank_pin, crank); no_singularity; right.angle in 28..118 [deg];
                         rocker_pin.angle [rad] in 1..3; coupler.center.y in -100..1300 [mm]; }";
    motion(&definition([2.0, 1.0, 2.0, 1.5], 1.0, 1.0, more));
    // The same range a turn further.
    motion(&definition([2.0, 1.0, 2.0, 1.5], 1.0, 1.0, "expect { right.angle in 388 [deg]..8.4 [rad]; }"));
}

#[test]
fn what_is_not_as_expected_is_said_once_each() {
    let more = "expect { rotates = (rocker_pin, left); right.angle in 30..110 [deg]; crank_pin.angle in 0..90 [deg]; }";
    let errors = errors(&definition([2.0, 1.0, 2.0, 1.5], 1.0, 1.0, more));
    let beginnings = [
        "error: expected rocker_pin to turn fully, but it moves between 62.7 and 151.0 deg: dead centres there (crank and \
         coupler in line). Shortest + longest link = 3 m, the other two = 3.5 m: by Grashof's rule only the shortest link, \
         \"crank\", turns fully",
        "error: expected right.angle in 30..110 deg, but it moves between 28.96 and 117.3 deg, most at crank_pin.angle",
        "error: expected crank_pin.angle in 0..90 deg, but it turns fully",
    ];
    assert_eq!(errors.lines().count(), beginnings.len(), "{errors}");
    for (line, beginning) in errors.lines().zip(beginnings) {
        assert!(line.starts_with(beginning), "{line}\nshould begin with\n{beginning}");
    }
}
