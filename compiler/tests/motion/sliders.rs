//! Slider-cranks, the quick return, gears and racks against closed forms.

use crate::{Random, motion, range};
use linkwright_compiler::check::motion::End;
use std::f64::consts::{PI, TAU};

fn slider_crank(crank: f64, link: f64, offset: f64, angle: f64) -> String {
    let [x, y] = [crank * angle.cos(), crank * angle.sin()];
    let travel = x + (link * link - (offset - y).powi(2)).sqrt();
    let link_angle = (offset - y).atan2(travel - x);
    format!(
        "planar SliderCrank {{
            rod crank {{ mass [kg] = 1; length [m] = {crank}; }}
            rod link  {{ mass [kg] = 1; length [m] = {link}; }}
            body block {{ mass [kg] = 1; inertia [kg*m^2] = 1; }}
            joint main:  revolute(ground(0, 0) [m], crank.start);
            joint big:   revolute(crank.end, link.start);
            joint wrist: revolute(link.end, block.center);
            joint bore:  prismatic(ground(0, {offset}) [m], block.center, axis = (1, 0));
            start {{ main.angle [rad] = {angle}; bore.travel [m] ~ {travel}; link.angle [rad] ~ {link_angle}; }}
        }}"
    )
}

/// The piston turns back where crank and link are in line, at √((l ± r)² − e²); the crank turns if r + |e| < l.
#[test]
fn strokes_and_dead_centres_of_slider_cranks() {
    let mut random = Random(7);
    for _ in 0..12 {
        let (crank, offset) = (random.between(0.02, 2.0), random.between(-0.5, 0.5));
        let link = (crank + offset.abs()) * random.between(1.05, 4.0);
        let motion = motion(&slider_crank(crank, link, offset, random.between(-3.0, 3.0)));
        let what = format!("{crank} {link} {offset}");
        assert_eq!((motion.end, motion.singular.len()), (End::Closed, 0), "{what}");
        assert!(range(&motion, "main.angle").turns, "{what}");
        let at = |reach: f64| (reach * reach - offset * offset).sqrt();
        let bore = range(&motion, "bore.travel");
        assert!((bore.from - at(link - crank)).abs() < 1e-9 * link, "{what}: {bore:?}");
        assert!((bore.to - at(link + crank)).abs() < 1e-9 * link, "{what}: {bore:?}");
        let index = motion.ranges.iter().position(|range| range.of == "bore.travel").expect("watched");
        let limits: Vec<_> = motion.limits.iter().filter(|limit| limit.of == index).collect();
        assert_eq!(limits.len(), 2, "{what}");
        for limit in limits {
            assert_eq!(limit.in_line, ["crank", "link"], "{what}");
            // The crank points at the piston, or away from it.
            let mut reference = offset.atan2(limit.value);
            reference += if limit.value < 0.5 * (bore.from + bore.to) { PI } else { 0.0 };
            let miss = limit.reference - reference;
            assert!((miss - TAU * (miss / TAU).round()).abs() < 1e-6, "{what}: {limit:?}");
        }
    }
}

/// A crank longer than the link rocks: dead centres of the crank where the link stands across the bore.
#[test]
fn a_link_too_short_lets_the_crank_rock() {
    let (crank, link) = (1.0_f64, 0.6_f64);
    let motion = motion(&slider_crank(crank, link, 0.0, 0.1));
    let main = range(&motion, "main.angle");
    let most = (link / crank).asin();
    assert!(!main.turns && (main.to - most).abs() < 1e-9 && (main.from + most).abs() < 1e-9, "{main:?}");
    assert!(range(&motion, "wrist.angle").turns);
}

/// The guide swings by 2 asin(r/a) where the crank (r) stands across it; the slider's stroke follows from the guide.
#[test]
fn swing_of_a_quick_return() {
    let (crank, below, guide) = (0.15_f64, 0.2_f64, 0.4);
    let source = format!(
        "planar QuickReturn {{
            rod crank {{ mass [kg] = 1; length [m] = {crank}; }}
            rod guide {{ mass [kg] = 1; length [m] = {guide}; line slot = (guide.start, guide.end); }}
            joint crank_pin: revolute(ground(0, 0) [m], crank.start);
            joint guide_pin: revolute(ground(0, -{below}) [m], guide.start);
            joint block:     point_on_line(guide.slot, crank.end);
            start {{ crank_pin.angle [deg] = 20; guide_pin.angle [deg] ~ 60; }}
        }}"
    );
    let motion = motion(&source);
    assert!(range(&motion, "crank_pin.angle").turns);
    let (swing, found) = ((crank / below).asin(), range(&motion, "guide_pin.angle"));
    assert!((found.from - (0.5 * PI - swing)).abs() < 1e-9 && (found.to - (0.5 * PI + swing)).abs() < 1e-9);
    let block = range(&motion, "block.travel");
    assert!((block.from - (below - crank)).abs() < 1e-9 && (block.to - (below + crank)).abs() < 1e-9);
}

#[test]
fn gears_return_when_all_wheels_do_and_racks_do_not() {
    let wheels = "disk one { mass [kg] = 1; radius [m] = 1; } disk two { mass [kg] = 1; radius [m] = 1.5; }
                  joint first: revolute(ground(0, 0) [m], one.center);
                  joint second: revolute(ground(2.5, 0) [m], two.center);";
    let train = motion(&format!("planar Train {{ {wheels} gear mesh: gear(first, second, ratio = -3/2); }}"));
    assert_eq!(train.end, End::Closed);
    let [first, second] = ["first.angle", "second.angle"].map(|of| range(&train, of));
    assert!((first.to - first.from - 3.0 * TAU).abs() < 1e-9, "{first:?}");
    assert!((second.to - second.from - 2.0 * TAU).abs() < 1e-9, "{second:?}");
    let rack = motion(
        "planar Rack { disk pinion { mass [kg] = 1; radius [m] = 0.1; } body rail { mass [kg] = 1; inertia [kg*m^2] = 1; }
         joint axle: revolute(ground(0, 0.1) [m], pinion.center);
         joint way: prismatic(ground(0, 0) [m], rail.center, axis = (1, 0));
         rack mesh: rack(axle, way, radius [m] = 0.1); }",
    );
    assert_ne!(rack.end, End::Closed);
    assert!(range(&rack, "axle.angle").turns && range(&rack, "way.travel").to > 1.0);
}
