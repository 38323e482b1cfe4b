//! Where a motorcycle's rear wheel flutters under braking: a map over speed and slip, with the boundary of flutter, as a picture.
//!
//! ```text
//! cargo run --release -p linkwright-models --example stability_map                 writes stability_map.svg in the target directory
//! cargo run --release -p linkwright-models --example stability_map -- FILE.svg
//! ```
//! Each cell is the largest real part of the eigenvalues of the state matrix about steady running; the boundary is found by bisection.

use linkwright::{AssembleExt, Linearisation, Mechanism};
use linkwright_models::rear_wheel::{RearWheel, RearWheelParameters};
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;

/// m/s, from left to right.
const SPEEDS: (f64, f64) = (5.0, 60.0);
/// Slip of the braked wheel, from top to bottom.
const SLIPS: (f64, f64) = (0.0, -0.08);
const CELLS: (usize, usize) = (110, 80);
/// Growth, 1/s, of the darkest colours.
const DARKEST: f64 = 20.0;
/// Picture units of the map, and of its corner.
const SIZE: (f64, f64) = (660.0, 480.0);
const CORNER: (f64, f64) = (80.0, 40.0);

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args()
        .nth(1)
        .map_or_else(|| linkwright_examples::in_target("stability_map.svg"), PathBuf::from);
    let mut boundary = Vec::new();
    println!("speed, m/s   slip at the boundary   force on the wheel, N   frequency, Hz");
    for step in 0..=CELLS.0 {
        let speed = between(SPEEDS, step as f64 / CELLS.0 as f64);
        let Some(slip) = flutter(speed)? else { continue };
        boundary.push((speed, slip));
        if step % 10 == 0 {
            let (roots, force) = running(speed, slip)?;
            let critical =
                roots.iter().fold(roots[0], |most, root| if root.0 > most.0 { *root } else { most });
            let frequency = critical.1.abs() / std::f64::consts::TAU;
            println!("{speed:10.1}{slip:23.6}{force:24.1}{frequency:16.2}");
        }
    }
    std::fs::write(&file, picture(&boundary)?)?;
    println!("{} shows where it flutters", file.display());
    Ok(())
}

fn between((first, last): (f64, f64), share: f64) -> f64 {
    first + (last - first) * share
}

/// As (real, imaginary), 1/s.
type Roots = [(f64, f64); 4];

/// Eigenvalues about steady running, and the force on the wheel, N.
fn running(speed: f64, braking: f64) -> Result<(Roots, f64), Box<dyn Error>> {
    let model = RearWheel::<f64>::prepare(RearWheelParameters { speed, braking, ..Default::default() })?;
    let start = model.assemble(&RearWheel::START)?;
    let a = Linearisation::at(&model, 0.0, &start, &())?.state_space()?.a;
    Ok((roots(characteristic(&a)), model.outputs(0.0, &start, &()).force))
}

/// The largest real part.
fn growth(speed: f64, slip: f64) -> Result<f64, Box<dyn Error>> {
    let (roots, _) = running(speed, slip)?;
    Ok(roots.iter().fold(f64::NEG_INFINITY, |most, root| most.max(root.0)))
}

/// The slip at which flutter begins, if it does within the map.
fn flutter(speed: f64) -> Result<Option<f64>, Box<dyn Error>> {
    let (mut calm, mut flutters) = SLIPS;
    if growth(speed, flutters)? < 0.0 {
        return Ok(None);
    }
    for _ in 0..50 {
        let middle = 0.5 * (calm + flutters);
        if growth(speed, middle)? < 0.0 { calm = middle } else { flutters = middle }
    }
    Ok(Some(calm))
}

/// c₁ … c₄ of λ⁴ + c₁ λ³ + c₂ λ² + c₃ λ + c₄ = det(λ − A), after Faddeev and Le Verrier.
fn characteristic(a: &[f64]) -> [f64; 4] {
    let mut power = a.to_vec();
    std::array::from_fn(|k| {
        let c = -(0..4).map(|i| power[5 * i]).sum::<f64>() / (k + 1) as f64;
        (0..4).for_each(|i| power[5 * i] += c);
        power = (0..16).map(|at| (0..4).map(|k| a[at / 4 * 4 + k] * power[4 * k + at % 4]).sum()).collect();
        c
    })
}

/// All roots at once, after Durand and Kerner.
fn roots(coefficients: [f64; 4]) -> [(f64, f64); 4] {
    let times = |a: (f64, f64), b: (f64, f64)| (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0);
    // About as large as the roots.
    let size = coefficients[3].abs().powf(0.25).max(1.0);
    let mut found: [(f64, f64); 4] = std::array::from_fn(|k| {
        let angle = 0.4 + std::f64::consts::FRAC_PI_2 * k as f64;
        (size * angle.cos(), size * angle.sin())
    });
    for _ in 0..200 {
        for k in 0..4 {
            let x = found[k];
            let value = coefficients.iter().fold((1.0, 0.0), |sum, c| {
                let next = times(sum, x);
                (next.0 + c, next.1)
            });
            let others = (0..4).filter(|other| *other != k);
            let apart = others.fold((1.0, 0.0), |all, j| times(all, (x.0 - found[j].0, x.1 - found[j].1)));
            let square = apart.0 * apart.0 + apart.1 * apart.1;
            if square > 0.0 {
                let step = times(value, (apart.0 / square, -apart.1 / square));
                found[k] = (x.0 - step.0, x.1 - step.1);
            }
        }
    }
    found
}

/// Blue where it is calm, red where it flutters.
fn colour(growth: f64) -> String {
    let depth = (growth.abs() / DARKEST).min(1.0).sqrt();
    let [r, g, b] = if growth < 0.0 { [33.0, 102.0, 172.0] } else { [178.0, 24.0, 43.0] };
    let mix = |part: f64| (255.0 + (part - 255.0) * depth).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(r), mix(g), mix(b))
}

/// A place of the map in picture units.
fn place(speed: f64, slip: f64) -> (f64, f64) {
    let x = (speed - SPEEDS.0) / (SPEEDS.1 - SPEEDS.0);
    let y = (slip - SLIPS.0) / (SLIPS.1 - SLIPS.0);
    (CORNER.0 + SIZE.0 * x, CORNER.1 + SIZE.1 * y)
}

fn picture(boundary: &[(f64, f64)]) -> Result<String, Box<dyn Error>> {
    let (width, height) = (CORNER.0 + SIZE.0 + 30.0, CORNER.1 + SIZE.1 + 60.0);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"14\">\n\
         <title>Flutter of a motorcycle's rear wheel under braking</title>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n<g shape-rendering=\"crispEdges\">\n"
    );
    let cell = (SIZE.0 / CELLS.0 as f64, SIZE.1 / CELLS.1 as f64);
    for row in 0..CELLS.1 {
        let slip = between(SLIPS, (row as f64 + 0.5) / CELLS.1 as f64);
        for column in 0..CELLS.0 {
            let speed = between(SPEEDS, (column as f64 + 0.5) / CELLS.0 as f64);
            let (x, y) = place(speed, slip);
            let (x, y) = (x - 0.5 * cell.0, y - 0.5 * cell.1);
            let fill = colour(growth(speed, slip)?);
            writeln!(
                svg,
                "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"{fill}\"/>",
                cell.0 + 0.1,
                cell.1 + 0.1
            )?;
        }
    }
    svg.push_str("</g>\n");
    let points: Vec<String> = boundary
        .iter()
        .map(|&(speed, slip)| {
            let (x, y) = place(speed, slip);
            format!("{x:.1},{y:.1}")
        })
        .collect();
    writeln!(
        svg,
        "<polyline points=\"{}\" fill=\"none\" stroke=\"black\" stroke-width=\"2.5\"/>",
        points.join(" ")
    )?;
    if let Some(&(speed, slip)) = boundary.get(boundary.len() / 2) {
        let (x, y) = place(speed, slip);
        writeln!(svg, "<text x=\"{:.1}\" y=\"{:.1}\">calm</text>", x + 10.0, y - 30.0)?;
        writeln!(svg, "<text x=\"{:.1}\" y=\"{:.1}\">flutter</text>", x + 10.0, y + 90.0)?;
    }
    let (right, bottom) = (CORNER.0 + SIZE.0, CORNER.1 + SIZE.1);
    for speed in (10..=60).step_by(10) {
        let (x, _) = place(f64::from(speed), SLIPS.0);
        writeln!(svg, "<path d=\"M{x:.1} {bottom}v6\" stroke=\"black\"/>")?;
        writeln!(svg, "<text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{speed}</text>", bottom + 22.0)?;
    }
    for hundredths in (0..=8).step_by(2) {
        let (_, y) = place(SPEEDS.0, -0.01 * f64::from(hundredths));
        writeln!(svg, "<path d=\"M{} {y:.1}h-6\" stroke=\"black\"/>", CORNER.0)?;
        let sign = if hundredths == 0 { "" } else { "−" };
        writeln!(
            svg,
            "<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{sign}0.0{hundredths}</text>",
            CORNER.0 - 10.0,
            y + 5.0
        )?;
    }
    writeln!(
        svg,
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"black\"/>\n\
         <text x=\"{}\" y=\"{}\" text-anchor=\"middle\">speed, m/s</text>\n\
         <text transform=\"translate(22 {}) rotate(-90)\" text-anchor=\"middle\">slip of the braked wheel</text>\n\
         <text x=\"{}\" y=\"24\" text-anchor=\"middle\">Rear wheel under braking: growth of its fastest motion, \
         −{DARKEST} 1/s (blue) to {DARKEST} 1/s (red)</text>\n</svg>",
        CORNER.0,
        CORNER.1,
        SIZE.0,
        SIZE.1,
        0.5 * (CORNER.0 + right),
        bottom + 45.0,
        0.5 * (CORNER.1 + bottom),
        0.5 * (CORNER.0 + right)
    )?;
    Ok(svg)
}
