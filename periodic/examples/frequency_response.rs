//! The jump of a spur gear pair with backlash: all motions of the period of its load, stable and unstable, and what a sweep sees of them.
//!
//! ```text
//! cargo run --release -p linkwright-periodic --example frequency_response                writes frequency_response.svg in the target directory
//! cargo run --release -p linkwright-periodic --example frequency_response -- FILE.svg
//! ```
//! Teeth part where the load swings them through half the backlash; the mean stiffness falls, and the peak leans towards lower frequencies. Between the
//! two folds there are three motions, of which one is unstable; a sweep upwards jumps at one fold and a sweep downwards at the other.

use linkwright::AssembleExt;
use linkwright_models::gear_pair::{GearPairOscillator, GearPairOscillatorParameters};
use linkwright_periodic::{Along, Cycle, PeriodicError};
use std::error::Error;
use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Half the backlash, m, and what is shown as one.
const UNIT: f64 = 1e-6;
/// Frequencies, of that at which the pair would swing without backlash.
const WITHIN: (f64, f64) = (0.5, 1.6);
const MOST: f64 = 0.26;
/// Picture units of the diagram, and of its corner.
const SIZE: (f64, f64) = (660.0, 400.0);
const CORNER: (f64, f64) = (80.0, 50.0);

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).map_or_else(in_target, PathBuf::from);
    let model =
        |omega| GearPairOscillator::prepare(GearPairOscillatorParameters { omega, shake: 0.05, swing: 0.0 });
    let cycle = Cycle::new(model, |omega| TAU / omega).switch("x", UNIT).switch("x", -UNIT);
    let start = GearPairOscillator::<f64>::default().start();

    let first = cycle.settle(WITHIN.0, &start, 40)?;
    let branch = cycle.branch(&first, &Along::new(WITHIN.0..=WITHIN.1))?;
    for fold in &branch.folds {
        let contact = cycle.measure(fold, "x")?;
        println!("fold at {:.7}, rms {:.5} of half the backlash", fold.value, contact.rms / UNIT);
    }
    let mut curves: Vec<(bool, Vec<(f64, f64)>)> = Vec::new();
    for motion in &branch.motions {
        let point = (motion.value, cycle.measure(motion, "x")?.rms / UNIT);
        let stable = motion.is_stable();
        match curves.last_mut() {
            Some((same, points)) if *same == stable => points.push(point),
            last => {
                // Curves meet where one ends.
                let joint = last.and_then(|(_, points)| points.last().copied());
                curves.push((stable, joint.into_iter().chain([point]).collect()));
            }
        }
    }
    let up = sweep(&cycle, 0.6, 0.02)?;
    let down = sweep(&cycle, 1.0, -0.02)?;
    let jump = |points: &[(f64, f64)]| {
        let pair = points.windows(2).find(|pair| (pair[1].1 - pair[0].1).abs() > 0.05);
        pair.map(|pair| [pair[0].0, pair[1].0])
    };
    let ([Some(up_jump), Some(down_jump)], [low, high]) =
        ([jump(&up), jump(&down)], [branch.folds[1].value, branch.folds[0].value])
    else {
        return Err("a sweep has not jumped".into());
    };
    println!("a sweep upwards jumps between {:.2} and {:.2}", up_jump[0], up_jump[1]);
    println!("a sweep downwards jumps between {:.2} and {:.2}", down_jump[0], down_jump[1]);
    assert!(up_jump[0] < high && high < up_jump[1]);
    assert!(down_jump[1] < low && low < down_jump[0]);
    std::fs::write(&file, picture(&curves, &up, &down)?)?;
    println!("{} shows the jump", file.display());
    Ok(())
}

/// A hundred periods at each frequency from where the one before ended, and the rms of the motion that is left.
fn sweep(
    cycle: &Cycle<'_, GearPairOscillator<f64>>,
    from: f64,
    step: f64,
) -> Result<Vec<(f64, f64)>, PeriodicError> {
    let mut state = GearPairOscillator::<f64>::default().start();
    let mut points = Vec::new();
    for index in 0..21 {
        let omega = from + step * f64::from(index);
        state = cycle.after(omega, &state, 100)?;
        let motion = cycle.close(omega, &state)?;
        points.push((omega, cycle.measure(&motion, "x")?.rms / UNIT));
    }
    Ok(points)
}

/// In the target directory, which is the workspace's.
fn in_target() -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    target
        .unwrap_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../target"))
        .join("frequency_response.svg")
}

fn place((omega, rms): (f64, f64)) -> (f64, f64) {
    let x = (omega - WITHIN.0) / (WITHIN.1 - WITHIN.0);
    (CORNER.0 + SIZE.0 * x, CORNER.1 + SIZE.1 * (1.0 - rms / MOST))
}

fn picture(
    curves: &[(bool, Vec<(f64, f64)>)],
    up: &[(f64, f64)],
    down: &[(f64, f64)],
) -> Result<String, std::fmt::Error> {
    let (width, height) = (CORNER.0 + SIZE.0 + 30.0, CORNER.1 + SIZE.1 + 60.0);
    let (right, bottom) = (CORNER.0 + SIZE.0, CORNER.1 + SIZE.1);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"14\">\n\
         <title>The jump of a gear pair with backlash</title>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n\
         <text x=\"{}\" y=\"28\" text-anchor=\"middle\" font-size=\"17\">Gear pair with backlash: motions of the period of the load</text>\n",
        0.5 * (CORNER.0 + right)
    );
    for tenths in 5..=16 {
        let omega = f64::from(tenths) / 10.0;
        let (x, _) = place((omega, 0.0));
        writeln!(svg, "<path d=\"M{x:.1} {bottom}v6\" stroke=\"black\"/>")?;
        writeln!(svg, "<text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{omega:.1}</text>", bottom + 22.0)?;
    }
    for twentieths in 0..=5 {
        let rms = f64::from(twentieths) / 20.0;
        let (_, y) = place((WITHIN.0, rms));
        writeln!(svg, "<path d=\"M{} {y:.1}h-6\" stroke=\"black\"/>", CORNER.0)?;
        writeln!(
            svg,
            "<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{rms:.2}</text>",
            CORNER.0 - 10.0,
            y + 5.0
        )?;
    }
    for (stable, points) in curves {
        let points: Vec<String> =
            (points.iter().map(|point| place(*point))).map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let dashes = if *stable { "" } else { " stroke-dasharray=\"5 4\"" };
        writeln!(
            svg,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"black\" stroke-width=\"1.5\"{dashes}/>",
            points.join(" ")
        )?;
    }
    for (points, colour, shape) in [(up, "#2166ac", "m-5 4 5-9 5 9z"), (down, "#b2182b", "m-5-4 5 9 5-9z")] {
        for point in points {
            let (x, y) = place(*point);
            writeln!(svg, "<path d=\"M{x:.1} {y:.1}{shape}\" fill=\"{colour}\"/>")?;
        }
    }
    for (row, (mark, text)) in [
        ("<path d=\"m-12 0h24\" stroke=\"black\" stroke-width=\"1.5\"/>", "stable"),
        (
            "<path d=\"m-12 0h24\" stroke=\"black\" stroke-width=\"1.5\" stroke-dasharray=\"5 4\"/>",
            "unstable",
        ),
        ("<path d=\"m-5 4 5-9 5 9z\" fill=\"#2166ac\"/>", "sweep upwards"),
        ("<path d=\"m-5-4 5 9 5-9z\" fill=\"#b2182b\"/>", "sweep downwards"),
    ]
    .into_iter()
    .enumerate()
    {
        let (x, y) = (right - 140.0, CORNER.1 + 25.0 + 22.0 * row as f64);
        writeln!(svg, "<g transform=\"translate({x} {y})\">{mark}<text x=\"20\" y=\"5\">{text}</text></g>")?;
    }
    writeln!(
        svg,
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"black\"/>\n\
         <text x=\"{}\" y=\"{}\" text-anchor=\"middle\">frequency of the load, of that of the pair</text>\n\
         <text transform=\"translate(22 {}) rotate(-90)\" text-anchor=\"middle\">rms of the deflection, of half the backlash</text>\n</svg>",
        CORNER.0,
        CORNER.1,
        SIZE.0,
        SIZE.1,
        0.5 * (CORNER.0 + right),
        bottom + 45.0,
        0.5 * (CORNER.1 + bottom),
    )?;
    Ok(svg)
}
