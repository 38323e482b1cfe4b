//! `linkwright plot`: what a run shows over time, or against another quantity, as SVG: a panel for each quantity, never two on one
//! axis.

pub use super::animate::Curve;
use super::animate::{Film, film};
use super::expression::unknown;
use super::options::Study;
use super::picture::write_picture;
use super::record::Group;
use super::{Done, Failure, Loaded, short};
use linkwright_compiler::drawing_text::escaped;
use serde_json::json;
use std::fmt::Write;

const WIDTH: f64 = 720.0;
/// Of a panel, with its title.
const HEIGHT: f64 = 150.0;
const LEFT: f64 = 74.0;
const RIGHT: f64 = 16.0;
const TITLE: f64 = 22.0;
const FOOT: f64 = 8.0;
/// Below all of them, for the numbers and the name of the horizontal axis.
const BELOW: f64 = 34.0;

/// The command.
pub fn plot(study: &Study, loaded: &Loaded) -> Result<Done, Failure> {
    let film = film(study, loaded)?;
    let has_outputs = !loaded.compiled.mechanism.outputs.is_empty();
    let standard = vec![if has_outputs { Group::Outputs } else { Group::Energy }];
    let groups = study.show.clone().unwrap_or(standard);
    let curves: Vec<&Curve> = groups
        .iter()
        .flat_map(|group| film.curves.iter().filter(move |curve| curve.group == *group))
        .collect();
    if curves.is_empty() {
        let names: Vec<&str> = groups.iter().map(|group| group.text()).collect();
        return Err(Failure::Usage(format!("--show {}: {} has none", names.join(","), loaded.name)));
    }
    let axis = match &study.against {
        None => Axis { name: "time", unit: "s", values: &film.run.trajectory.times },
        Some(wanted) => Axis::of(&film, wanted)?,
    };
    let curves: Vec<&Curve> = curves.into_iter().filter(|curve| curve.name != axis.name).collect();
    let svg = picture(&loaded.name, &axis, &curves, &[]);
    let stopped = film.run.stopped.as_ref().map(|error| error.to_string());
    if study.json {
        if let Some(out) = &study.out {
            write_picture(Some(out), &svg)?;
        }
    } else {
        write_picture(study.out.as_deref(), &svg)?;
        if let Some(error) = &stopped {
            let end = film.run.trajectory.times.last().copied().unwrap_or_default();
            eprintln!("stopped at {} s of {} s: {error}", short(end), short(study.course.duration));
        }
    }
    let names: Vec<&str> = curves.iter().map(|curve| curve.name.as_str()).collect();
    Ok(Done {
        value: json!({ "svg": svg, "panels": names, "stopped": stopped }),
        failed: film.run.stopped.is_some(),
    })
}

/// What lies along the horizontal axis.
struct Axis<'f> {
    name: &'f str,
    unit: &'f str,
    values: &'f [f64],
}

impl<'f> Axis<'f> {
    /// The quantity of a name.
    fn of(film: &'f Film, wanted: &str) -> Result<Axis<'f>, Failure> {
        // Titles have spaces in place of the underscores of names.
        let written = |curve: &Curve| curve.name.replace(' ', "_");
        let found = film.curves.iter().find(|curve| curve.name == wanted || written(curve) == wanted);
        let Some(Curve { name, unit, values, .. }) = found else {
            let names: Vec<String> = film.curves.iter().map(written).collect();
            let names = names.iter().map(String::as_str);
            return Err(Failure::Usage(unknown("--against: there is no quantity", wanted, names)));
        };
        Ok(Axis { name, unit, values })
    }

    fn label(&self) -> String {
        format!("{}, {}", self.name, typeset(self.unit))
    }

    /// Least and most of what is finite.
    fn range(&self) -> (f64, f64) {
        let finite = || self.values.iter().copied().filter(|value| value.is_finite());
        let (least, most) =
            (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
        if least > most { (0.0, 1.0) } else { (least, most.max(least + 1e-12)) }
    }

    /// The height of a panel: a length against a length is to scale, as the way of a point has to be.
    fn height(&self, curve: &Curve) -> f64 {
        if self.unit != curve.unit || !["m", "cm", "mm"].contains(&self.unit) {
            return HEIGHT;
        }
        let (least, most) = self.range();
        let finite = || curve.values.iter().copied().filter(|value| value.is_finite());
        let upward = finite().fold(f64::NEG_INFINITY, f64::max) - finite().fold(f64::INFINITY, f64::min);
        // As in `panel`: six hundredths on either side.
        let inner = 1.12 * upward * (WIDTH - LEFT - RIGHT) / (most - least);
        if inner.is_finite() { inner.clamp(60.0, 1200.0) + TITLE + 4.0 + FOOT } else { HEIGHT }
    }
}

/// The picture of curves against a quantity with its unit and its values. Of each curve the least and the most that its panel shows, where
/// it has to be compared with others.
pub fn picture_against(
    name: &str,
    axis: (&str, &str, &[f64]),
    curves: &[Curve],
    ranges: &[Option<[f64; 2]>],
) -> String {
    let (of, unit, values) = axis;
    let curves: Vec<&Curve> = curves.iter().collect();
    picture(name, &Axis { name: of, unit, values }, &curves, ranges)
}

/// A unit as it is printed.
pub fn typeset(unit: &str) -> String {
    unit.replace('*', "·").replace("^2", "²").replace("^3", "³")
}

/// The beginning of a picture with its title, the colours of light and dark surroundings, and its paper.
pub fn head(title: &str, width: f64, height: f64) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" font-size=\"12\">\n<title>{}</title>\n\
         <style>svg{{--ink:#1b2330;--muted:#586373;--grid:#e3e7ed;--line:#1f6fd1;--paper:#fff}}\
         @media(prefers-color-scheme:dark){{svg{{--ink:#e4e9f0;--muted:#9aa7b8;--grid:#2a323e;--line:#62a5f5;--paper:#12161d}}}}\
         text{{fill:var(--muted)}}.title{{fill:var(--ink);font-weight:600}}.grid{{stroke:var(--grid)}}</style>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"var(--paper)\"/>\n",
        escaped(title)
    )
}

fn picture(name: &str, axis: &Axis, curves: &[&Curve], ranges: &[Option<[f64; 2]>]) -> String {
    let heights: Vec<f64> = curves.iter().map(|curve| axis.height(curve)).collect();
    let height = heights.iter().sum::<f64>() + BELOW;
    let over = if axis.name == "time" { "over" } else { "against" };
    let mut svg = head(&format!("{name} {over} {}", axis.name), WIDTH, height);
    let (begin, end) = axis.range();
    let span = (end - begin).max(1e-12);
    let across = |time: f64| LEFT + (WIDTH - LEFT - RIGHT) * (time - begin) / span;
    let mut foot = 0.0;
    for (index, (curve, height)) in curves.iter().zip(heights).enumerate() {
        let range = ranges.get(index).copied().flatten();
        panel(&mut svg, curve, range, axis.values, (foot, height), &across);
        foot += height;
    }
    for time in ticks(begin, end, 5.0) {
        let x = across(time);
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
            foot + 12.0,
            figure(time)
        );
    }
    let _ = writeln!(
        svg,
        "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>\n</svg>",
        (LEFT + WIDTH - RIGHT) / 2.0,
        foot + 28.0,
        escaped(&axis.label())
    );
    svg
}

/// What a value is on its axis: residuals by their powers of ten.
fn scaled(curve: &Curve, value: f64) -> f64 {
    if is_logarithmic(curve) { value.max(1e-17).log10() } else { value }
}

fn is_logarithmic(curve: &Curve) -> bool {
    curve.group == Group::Residual && curve.values.iter().any(|value| *value > 0.0)
}

fn panel(
    svg: &mut String,
    curve: &Curve,
    range: Option<[f64; 2]>,
    along: &[f64],
    (top, height): (f64, f64),
    across: &impl Fn(f64) -> f64,
) {
    let finite = || curve.values.iter().filter(|value| value.is_finite()).map(|value| scaled(curve, *value));
    let (mut least, mut most) =
        (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
    if let Some(range) = range {
        (least, most) = (range[0], range[1]);
    } else if least > most {
        (least, most) = (0.0, 1.0);
    }
    let size = most.abs().max(least.abs());
    if is_logarithmic(curve) {
        (least, most) = (least.floor(), most.ceil().max(least.floor() + 1.0));
    } else if most - least <= 1e-9 * size.max(1e-12) {
        // A line in the middle is what stays the same.
        let by = (0.05 * size).max(1e-6);
        (least, most) = (least - by, most + by);
    } else {
        let by = 0.06 * (most - least);
        (least, most) = (least - by, most + by);
    }
    let (above, below) = (top + TITLE + 4.0, top + height - FOOT);
    let upward = |value: f64| below - (below - above) * (value - least) / (most - least);
    let unit = if curve.unit.is_empty() { String::new() } else { format!(", {}", typeset(&curve.unit)) };
    let _ = writeln!(
        svg,
        "<text class=\"title\" x=\"{LEFT}\" y=\"{:.1}\">{}{}</text>",
        top + TITLE - 4.0,
        escaped(&curve.name),
        escaped(&unit)
    );
    let marks = if is_logarithmic(curve) {
        let middle = ((least + most) / 2.0).round();
        let mut marks = vec![least, middle, most];
        marks.dedup();
        marks
    } else {
        ticks(least, most, 3.0)
    };
    for mark in marks {
        let y = upward(mark);
        let text = if is_logarithmic(curve) { format!("10{}", raised(mark as i32)) } else { figure(mark) };
        let _ = writeln!(
            svg,
            "<line class=\"grid\" x1=\"{LEFT}\" x2=\"{:.1}\" y1=\"{y:.1}\" y2=\"{y:.1}\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{text}</text>",
            WIDTH - RIGHT,
            LEFT - 6.0,
            y + 4.0
        );
    }
    let mut path = String::new();
    let mut is_down = false;
    for (at, value) in along.iter().zip(&curve.values) {
        let is_known = value.is_finite() && at.is_finite();
        if is_known {
            let word = if is_down { 'L' } else { 'M' };
            let _ = write!(path, "{word}{:.1} {:.1}", across(*at), upward(scaled(curve, *value)));
        }
        is_down = is_known;
    }
    let _ = writeln!(
        svg,
        "<path d=\"{path}\" fill=\"none\" stroke=\"var(--line)\" stroke-width=\"1.6\" stroke-linejoin=\"round\"/>"
    );
}

/// Round numbers between two, at least about so many.
pub fn ticks(least: f64, most: f64, count: f64) -> Vec<f64> {
    if least >= most {
        return vec![least];
    }
    let rough = (most - least) / count;
    let power = 10_f64.powf(rough.log10().floor());
    let steps = [10.0, 5.0, 2.0, 1.0].into_iter().map(|k| k * power);
    let step = steps.into_iter().find(|step| *step <= rough * 1.001).unwrap_or(power);
    let first = (least / step - 1e-9).ceil() as i64;
    (first..).map(|k| k as f64 * step).take_while(|mark| *mark <= most + 1e-9 * step).take(50).collect()
}

fn raised(power: i32) -> String {
    let of = |c: char| match c {
        '-' => '⁻',
        digit => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit.to_digit(10).unwrap_or(0) as usize).unwrap_or(digit),
    };
    power.to_string().chars().map(of).collect()
}

/// A number of an axis.
pub fn figure(value: f64) -> String {
    let text = short((value * 1e12).round() / 1e12).replace('-', "−");
    match text.split_once('e') {
        Some((digits, power)) => {
            format!("{digits}·10{}", raised(power.replace('−', "-").parse().unwrap_or(0)))
        }
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_have_round_numbers() {
        assert_eq!(ticks(0.0, 10.0, 5.0), [0.0, 2.0, 4.0, 6.0, 8.0, 10.0]);
        assert_eq!(ticks(-0.34, 0.27, 3.0), [-0.2, 0.0, 0.2]);
        assert_eq!(figure(-1.5e-7), "−1.5·10⁻⁷");
        assert_eq!(figure(2500.0), "2500");
    }
}
