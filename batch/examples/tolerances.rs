//! What tolerances of the lengths make of a four-bar's rocker: 20 000 mechanisms whose bars and pivots are off by up to half a millimetre.
//!
//! Each is assembled and turned through a whole turn of its crank; the angle through which its rocker swings is compared with the closed form,
//! whose ends are where crank and coupler lie in line (VDI 2130; Norton, *Design of Machinery*, 3.3).
//!
//! ```text
//! cargo run --release -p linkwright-batch --example tolerances [-- members]
//! ```

use linkwright::Rk4;
use linkwright_batch::Batch;
use linkwright_models::general_four_bar::{ParametricFourBar, ParametricFourBarParameters};
use std::error::Error;

/// The step, s, and how many make a turn and a half at 3 rad/s.
const H: f64 = 1e-3;
const STEPS: usize = 3200;
/// By how much a length may be off, m.
const OFF: f64 = 0.5e-3;

fn main() -> Result<(), Box<dyn Error>> {
    let members = std::env::args().nth(1).map_or(Ok(20_000), |text| text.parse::<usize>())?;
    let parameters: Vec<_> = {
        let mut random = Random(0x9E37_79B9_7F4A_7C15);
        (0..members).map(|_| made(&mut random)).collect()
    };
    let mut batch = Batch::<ParametricFourBar, _>::prepare(members, Rk4, |member| parameters[member])?;
    let begin = [f64::INFINITY, f64::NEG_INFINITY];
    let ends = batch.fold(&(), H, STEPS, begin, |_, [least, most], outputs| {
        (*least, *most) = (least.min(outputs.rocking), most.max(outputs.rocking));
    });
    for (member, failure) in batch.failures() {
        println!("member {member}: {failure}");
    }

    let swings: Vec<f64> = ends.iter().map(|[least, most]| (most - least).to_degrees()).collect();
    let apart =
        swings.iter().zip(&parameters).map(|(swing, parameters)| (swing - closed_form(parameters)).abs());
    let apart = apart.fold(0.0, f64::max);
    let mean = swings.iter().sum::<f64>() / members as f64;
    let deviation = (swings.iter().map(|swing| (swing - mean).powi(2)).sum::<f64>() / members as f64).sqrt();
    println!(
        "the rocker swings by {mean:.4}°, standard deviation {deviation:.4}°; at most {apart:.1e}° off the closed form\n"
    );
    histogram(&swings, mean, deviation);
    // Ends that lie between two samples are missed by (ω h)²/8 of the swing.
    assert!(apart < 1e-3, "the motion and the closed form disagree");
    Ok(())
}

/// A mechanism as it comes from the shop; no gravity, so that the crank turns through.
fn made(random: &mut Random) -> ParametricFourBarParameters {
    let p = ParametricFourBarParameters::default();
    let mut off = |length: f64| length + OFF * random.unit();
    ParametricFourBarParameters {
        gravity_x: 0.0,
        gravity_y: 0.0,
        crank_length: off(p.crank_length),
        coupler_length: off(p.coupler_length),
        rocker_length: off(p.rocker_length),
        rocker_x: off(p.rocker_x),
        rocker_y: off(p.rocker_y),
        ..p
    }
}

/// The angle between the rocker's dead centres, °.
fn closed_form(p: &ParametricFourBarParameters) -> f64 {
    let ground = (p.rocker_x - p.crank_x).hypot(p.rocker_y - p.crank_y);
    let at = |reach: f64| {
        let cosine =
            (ground.powi(2) + p.rocker_length.powi(2) - reach.powi(2)) / (2.0 * ground * p.rocker_length);
        cosine.acos()
    };
    let (out, back) = (p.coupler_length + p.crank_length, p.coupler_length - p.crank_length);
    (at(out) - at(back)).to_degrees()
}

fn histogram(values: &[f64], mean: f64, deviation: f64) {
    const BARS: usize = 17;
    let width = 6.0 * deviation / BARS as f64;
    let place = |value: f64| ((value - mean) / width + 0.5 * BARS as f64).floor();
    let mut counts = [0_usize; BARS];
    for &value in values {
        if let Some(count) = counts.get_mut(place(value).clamp(0.0, (BARS - 1) as f64) as usize) {
            *count += 1;
        }
    }
    let most = counts.into_iter().max().unwrap_or(1).max(1);
    for (bar, count) in counts.into_iter().enumerate() {
        let middle = mean + (bar as f64 + 0.5 - 0.5 * BARS as f64) * width;
        println!("{middle:>9.3}° {:<50} {count}", "█".repeat(50 * count / most));
    }
}

/// Marsaglia's xorshift: the same numbers in every run.
struct Random(u64);

impl Random {
    /// In [−1, 1).
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
