//! Inputs, time ratios and transmission angles against the rule of cosines.

use crate::four_bars::four_bar;
use crate::{Random, compiled};
use linkwright_compiler::check::motion::{Linkage, Motion};
use std::f64::consts::PI;

fn linkage(source: &str) -> (Motion, Linkage) {
    compiled(source).linkage().unwrap_or_else(|unswept| panic!("{source}\n{unswept:?}"))
}

fn near(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() < 1e-7, "{what}: {found} in place of {expected}");
}

/// A crank-rocker that starts with the crank along x, told by the rocker: so that only the crank's full turns make it the input.
fn crank_rocker([ground, crank, coupler, rocker]: [f64; 4], more: &str) -> String {
    let diagonal = ground - crank;
    let at_rocker =
        ((diagonal * diagonal + rocker * rocker - coupler * coupler) / (2.0 * diagonal * rocker)).acos();
    let at_coupler =
        ((diagonal * diagonal + coupler * coupler - rocker * rocker) / (2.0 * diagonal * coupler)).acos();
    let start = format!(
        "rocker_pin.angle [rad] = {}; crank_pin.angle [rad] ~ 0; coupler.angle [rad] ~ {at_coupler};",
        PI - at_rocker
    );
    four_bar([ground, crank, coupler, rocker], &start, more)
}

#[test]
fn crank_rockers() {
    let mut random = Random(7);
    for _ in 0..12 {
        let crank = random.between(0.05, 0.3);
        let [coupler, rocker] = [random.between(0.6, 0.8), random.between(0.6, 0.8)];
        // Grashof's: the crank, shortest, and the ground, longest, are less than the others together.
        let ground = random.between(0.8, coupler + rocker - crank - 0.1);
        let (motion, found) = linkage(&crank_rocker([ground, crank, coupler, rocker], ""));
        let input = found.input.expect("the crank turns");
        assert_eq!(motion.ranges[input].of, "crank_pin.angle");

        // μ lies opposite to the diagonal from the crank to the rocker's pin; below it is the acute angle.
        let angle = |diagonal: f64| {
            let cosine =
                (coupler * coupler + rocker * rocker - diagonal * diagonal) / (2.0 * coupler * rocker);
            cosine.abs().acos()
        };
        let ends = [angle(ground - crank), angle(ground + crank)];
        let least = ends[0].min(ends[1]);
        let is_through_right_angle = {
            let square = coupler * coupler + rocker * rocker;
            (ground - crank).powi(2) < square && square < (ground + crank).powi(2)
        };
        let most = if is_through_right_angle { PI / 2.0 } else { ends[0].max(ends[1]) };
        let [transmission] = &found.transmissions[..] else { panic!("{found:?}") };
        assert_eq!((transmission.link.as_str(), transmission.driven.as_str()), ("coupler", "rocker"));
        near(transmission.least, least, "least transmission angle");
        near(transmission.most, most, "largest transmission angle");

        // The dead centres of the rocker, crank and coupler stretched and folded.
        let at_crank =
            |way: f64| ((ground * ground + way * way - rocker * rocker) / (2.0 * ground * way)).acos();
        let dead = [at_crank(coupler + crank), at_crank(coupler - crank) + PI];
        let of = |ratio: &&linkwright_compiler::check::motion::TimeRatio| {
            motion.ranges[ratio.of].of == "rocker_pin.angle"
        };
        let ratio = found.ratios.iter().find(of).expect("the rocker swings").ratio;
        let way = dead[1] - dead[0];
        near(ratio, way.max(2.0 * PI - way) / way.min(2.0 * PI - way), "time ratio");
        for limit in motion.limits.iter().filter(|limit| motion.ranges[limit.of].of == "rocker_pin.angle") {
            let turned = limit.values[input].rem_euclid(2.0 * PI);
            assert!(dead.iter().any(|angle| (angle - turned).abs() < 1e-6), "{turned} of {dead:?}");
        }
    }
}

/// What an input acts on is the input, even where another joint turns fully, and so is what a driver moves.
#[test]
fn inputs_are_what_moves_it() {
    let lengths = [0.9, 0.2, 0.7, 0.7];
    for (more, expected) in [
        ("input push [N*m]; torque motor: torque(rocker_pin) = push;", "rocker_pin.angle"),
        ("torque load: torque(rocker_pin) = 3 [N*m];", "crank_pin.angle"),
    ] {
        let (motion, found) = linkage(&crank_rocker(lengths, more));
        assert_eq!(found.input.map(|input| motion.ranges[input].of.as_str()), Some(expected), "{more}");
    }
    let driven =
        crank_rocker(lengths, "drive slow: rocker_pin.angle = 2.0943951023931953 [rad] + 0.1 [rad/s]*time;");
    let (motion, found) =
        linkage(&driven.replacen("rocker_pin.angle [rad] =", "rocker_pin.angle [rad] ~", 1));
    assert_eq!(found.input.map(|input| motion.ranges[input].of.as_str()), Some("rocker_pin.angle"));
}

/// A crank and a slider beside its line: pressure on the slider's way, and the quick return by the offset.
#[test]
fn slider_crank() {
    let (crank, rod) = (0.1, 0.35);
    for offset in [0.0, 0.06, -0.08] {
        let (motion, found) = linkage(&format!(
            "planar Press {{
                rod crank {{ mass [kg] = 1; length [m] = {crank}; }}
                rod push  {{ mass [kg] = 1; length [m] = {rod}; }}
                body ram  {{ mass [kg] = 1; inertia [kg*m^2] = 1; }}
                joint main:  revolute(ground(0, 0) [m], crank.start);
                joint big:   revolute(crank.end, push.start);
                joint small: revolute(push.end, ram.center);
                joint rail:  prismatic(ground(0, {offset}) [m], ram.center, axis = (1, 0));
                start {{ main.angle [deg] = 40; rail.travel [m] ~ 0.4; }}
            }}"
        ));
        let [transmission] = &found.transmissions[..] else { panic!("{found:?}") };
        // sin(pressure angle) = |crank sin θ − offset|/rod.
        near(transmission.least, ((crank + f64::abs(offset)) / rod).acos(), "least transmission angle");
        near(transmission.most, PI / 2.0, "largest transmission angle");
        let travel = found.ratios.iter().find(|ratio| motion.ranges[ratio.of].of == "rail.travel");
        let more = (f64::abs(offset) / (rod - crank)).asin() - (f64::abs(offset) / (rod + crank)).asin();
        near(travel.expect("it goes to and fro").ratio, (PI + more) / (PI - more), "time ratio");
    }
}
