//! Mechanisms that cannot close: the least gap must be named, which closed forms or brute force give. Of a loop that does not
//! close even alone it is the gap that this loop keeps, whatever the others and `start` ask; else the one with the other loops
//! closed and what `start` states held.

use crate::closable::{SliderCrank, Vec3};
use crate::random::Random;
use crate::{cases, put_together};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

struct Unclosable {
    kind: &'static str,
    source: String,
    /// m.
    gap: f64,
}

/// Bars in a ring, the first of them the ground; what `start` says.
pub fn ring(lengths: &[f64], start: &str) -> String {
    let mut text = String::from("planar Open {\n");
    for (bar, length) in lengths.iter().enumerate().skip(1) {
        let _ = writeln!(text, "    rod bar_{bar} {{ mass [kg] = 1; length [m] = {length:.17}; }}");
    }
    let last = lengths.len() - 1;
    let _ = writeln!(text, "    joint j0: revolute(ground(0, 0) [m], bar_1.start);");
    for bar in 1..last {
        let _ = writeln!(text, "    joint j{bar}: revolute(bar_{bar}.end, bar_{}.start);", bar + 1);
    }
    let _ = writeln!(text, "    joint j{last}: revolute(bar_{last}.end, ground({:.17}, 0) [m]);", lengths[0]);
    text + &format!("    start {{{start} }}\n}}")
}

/// One bar longer than all others together: they are all in one line at the nearest.
fn too_long(case: usize, random: &mut Random) -> Unclosable {
    let bars = 4 + case % 3;
    let mut lengths: Vec<f64> = (0..bars).map(|_| random.between(0.2, 1.0)).collect();
    let longest = random.index(bars);
    let others: f64 = lengths.iter().sum::<f64>() - lengths[longest];
    lengths[longest] = others * random.between(1.02, 2.5);
    let gap = lengths[longest] - others;
    let mut start = String::new();
    for bar in 1..bars {
        if random.next() < 0.7 {
            let _ = write!(start, " bar_{bar}.angle [rad] ~ {:.17};", random.between(-PI, PI));
        }
    }
    Unclosable { kind: "a bar too long", source: ring(&lengths, &start), gap }
}

/// By how much one length is greater than all others together.
fn excess(lengths: &[f64]) -> f64 {
    let longest = lengths.iter().fold(0.0_f64, |longest, length| longest.max(*length));
    2.0 * longest - lengths.iter().sum::<f64>()
}

/// A four-bar with its crank stated where coupler and rocker do not reach.
fn out_of_reach(random: &mut Random) -> Unclosable {
    loop {
        let [ground, crank, coupler, rocker] = [0; 4].map(|_| random.between(0.3, 2.0));
        let angle = random.between(-PI, PI);
        let diagonal = (ground * ground + crank * crank - 2.0 * ground * crank * angle.cos()).sqrt();
        let gap = (diagonal - coupler - rocker).max((coupler - rocker).abs() - diagonal);
        if gap > 0.02 {
            let alone = excess(&[ground, crank, coupler, rocker]);
            let gap = if alone > 0.0 { alone } else { gap };
            let start = format!(
                " bar_1.angle [rad] = {angle:.17}; bar_2.angle [rad] ~ {:.17};",
                random.between(-PI, PI)
            );
            return Unclosable {
                kind: "a crank out of reach",
                source: ring(&[ground, crank, coupler, rocker], &start),
                gap,
            };
        }
    }
}

/// A four-bar that closes, and two bars from its coupler to the ground that do not reach.
fn dyad(random: &mut Random) -> Unclosable {
    loop {
        let [ground, crank, coupler, rocker] = [0; 4].map(|_| random.between(0.5, 2.0));
        let arm = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        let foot = [random.between(2.0, 5.0), random.between(-4.0, 4.0)];
        let bars = [random.between(0.2, 0.6), random.between(0.2, 0.6)];
        let reach = |angle: f64, side: f64| {
            let [x, y] = [ground - crank * angle.cos(), -crank * angle.sin()];
            let diagonal = x.hypot(y);
            let cosine =
                (coupler * coupler + diagonal * diagonal - rocker * rocker) / (2.0 * coupler * diagonal);
            (cosine.abs() <= 1.0).then(|| {
                let turned = y.atan2(x) + side * cosine.acos();
                let (c, s) = (turned.cos(), turned.sin());
                let at = [
                    crank * angle.cos() + c * arm[0] - s * arm[1],
                    crank * angle.sin() + s * arm[0] + c * arm[1],
                ];
                (at[0] - foot[0]).hypot(at[1] - foot[1])
            })
        };
        let least = [-1.0, 1.0].map(|side| least(|angle| reach(angle, side).unwrap_or(f64::INFINITY)));
        let gap = least[0].min(least[1]) - bars[0] - bars[1];
        if !gap.is_finite() || gap < 0.05 {
            continue;
        }
        let alone = excess(&[foot[0].hypot(foot[1]), crank, arm[0].hypot(arm[1]), bars[0], bars[1]]);
        let gap = if alone > 0.0 { alone } else { gap };
        let source = format!(
            "planar Open {{
    rod crank {{ mass [kg] = 1; length [m] = {crank:.17}; }}
    body coupler {{ mass [kg] = 1; inertia [kg*m^2] = 1; point end [m] = ({coupler:.17}, 0); point arm [m] = ({:.17}, {:.17}); }}
    rod rocker {{ mass [kg] = 1; length [m] = {rocker:.17}; }}
    rod one {{ mass [kg] = 1; length [m] = {:.17}; }}
    rod two {{ mass [kg] = 1; length [m] = {:.17}; }}
    joint j0: revolute(ground(0, 0) [m], crank.start);
    joint j1: revolute(crank.end, coupler.origin);
    joint j2: revolute(coupler.end, rocker.end);
    joint j3: revolute(ground({ground:.17}, 0) [m], rocker.start);
    joint j4: revolute(coupler.arm, one.start);
    joint j5: revolute(one.end, two.start);
    joint j6: revolute(two.end, ground({:.17}, {:.17}) [m]);
    start {{ crank.angle [rad] ~ {:.17}; }}
}}",
            arm[0], arm[1], bars[0], bars[1], foot[0], foot[1], random.between(-PI, PI)
        );
        return Unclosable { kind: "a dyad too short", source, gap };
    }
}

/// The rod of a slider-crank in space too short for wherever the crank stands, or for where it is stated.
fn slider_crank(case: usize, random: &mut Random) -> Unclosable {
    loop {
        let parts = SliderCrank::random(random);
        let rod = random.between(0.02, 0.2);
        let apart = |angle: f64| from_line(parts.tip(angle), parts.rail, parts.along);
        let stated = random.between(-PI, PI);
        let anywhere = least(apart) - rod;
        let (kind, gap, start) = match case % 2 {
            0 if anywhere > 0.0 => {
                ("a rod too short", anywhere, format!("bearing.angle [rad] ~ {stated:.17};"))
            }
            1 if anywhere < 0.0 => (
                "a rod too short for the crank",
                apart(stated) - rod,
                format!("bearing.angle [rad] = {stated:.17};"),
            ),
            _ => continue,
        };
        if gap > 0.01 {
            return Unclosable { kind, source: parts.source(rod, case % 4 < 2, &start), gap };
        }
    }
}

fn from_line(place: Vec3, through: Vec3, along: Vec3) -> f64 {
    let apart = [0, 1, 2].map(|k| place[k] - through[k]);
    let part: f64 = apart.iter().zip(&along).map(|(a, b)| a * b).sum();
    let rest = [0, 1, 2].map(|k| apart[k] - part * along[k]);
    rest.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The least value of a function of an angle: on a grid, and then ever closer around the best of it.
fn least(f: impl Fn(f64) -> f64) -> f64 {
    let (mut at, mut width) = (0.0, PI);
    let mut best = f64::INFINITY;
    for points in [20_000, 200, 200, 200] {
        let middle = at;
        for point in 0..=points {
            let angle = middle + width * (2.0 * point as f64 / points as f64 - 1.0);
            let value = f(angle);
            if value < best {
                (best, at) = (value, angle);
            }
        }
        width *= 4.0 / points as f64;
        assert!(width < TAU);
    }
    best
}

/// The number before `m apart`.
fn named(message: &str) -> Option<f64> {
    message.split(" m apart").next()?.rsplit(' ').next()?.parse().ok()
}

#[test]
fn of_what_cannot_close_the_least_gap_is_named() {
    let mut wrong = Vec::new();
    let mut tried: BTreeMap<&str, usize> = BTreeMap::new();
    for case in 0..cases() / 4 {
        let mut random = Random::of_case(1_000_000 + case);
        let Unclosable { kind, source, gap } = match case % 4 {
            0 => too_long(case / 4, &mut random),
            1 => out_of_reach(&mut random),
            2 => dyad(&mut random),
            _ => slider_crank(case / 4, &mut random),
        };
        *tried.entry(kind).or_default() += 1;
        match put_together(&source) {
            Ok(_) => wrong.push(format!("{case}: {kind} is taken:\n{source}")),
            Err(message) => {
                if named(&message).is_none_or(|named| (named - gap).abs() > 0.01 * gap) {
                    wrong.push(format!("{case}: {kind}, least gap {gap}: {message}\n{source}"));
                }
            }
        }
    }
    println!("{tried:?}");
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong[..wrong.len().min(5)].join("\n"));
}
