//! Which of the positions that close is taken: the one nearest to the guess, by a scan of the circle.

use crate::open::ring;
use crate::put_together;
use crate::random::Random;
use linkwright_compiler::equations::Rotation;
use std::f64::consts::{PI, TAU};

#[test]
fn the_nearest_position_is_taken() {
    let mut random = Random::of_case(4321);
    let mut taken = 0;
    while taken < 60 {
        let [ground, crank, coupler, rocker] = [0; 4].map(|_| random.between(0.3, 3.0));
        // The far end of the rocker must be where crank and coupler reach.
        let reached = |angle: f64| {
            let far = (ground - rocker * angle.cos()).hypot(rocker * angle.sin());
            far <= crank + coupler && far >= (crank - coupler).abs()
        };
        let guess = random.between(-PI, PI);
        let off = |side: f64| {
            (0..31_416).map(|step| 1e-4 * f64::from(step)).find(|off| reached(guess + side * off))
        };
        let (Some(above), Some(below)) = (off(1.0), off(-1.0)) else { continue };
        let source = ring(&[ground, crank, coupler, rocker], &format!(" bar_3.angle [rad] ~ {guess:.17};"));
        let near = above.min(below);
        match put_together(&source) {
            Ok(start) => {
                let layout = &start.equations.layout;
                let is_rocker = |rotation: &Rotation| matches!(rotation, Rotation::Body(body) if start.mechanism.bodies[body.0].name.text == "bar_3");
                let at = layout.pair(layout.rotations.iter().position(is_rocker).expect("the rocker turns"));
                let angle = start.assembly.q[at + 1].atan2(start.assembly.q[at]);
                let found = angle - guess;
                let found = (found - TAU * (found / TAU).round()).abs();
                assert!((found - near).abs() < 2e-4, "{found} in place of {near}\n{source}");
                taken += 1;
            }
            Err(message) => panic!("{near}: {message}\n{source}"),
        }
    }
}
