//! Pairs of toothings as tables and pictures: teeth in mesh with their circles and the line of action, the stiffness over a pitch, and how many pairs touch.

use super::figure::{escaped, number};
use super::plot::{Line, Plot};
use super::stand::{Pose, Stand};
use super::table::{Table, code};
use super::text::decimal;
use crate::compiled::Compiled;
use crate::drawing::canvas::ACCENT;
use crate::equations::loads::teeth::of_teeth;
use crate::model::OfTeeth;
use crate::model::gears::meshes;
use crate::model::gears::{Gives, Meeting, Mesh, Pair, Told, Toothing, involute};
use crate::numbers;
use std::fmt::Write;

/// Side of a close-up, px, and what it shows: modules to each side of the pitch point, or the path of contact and so much of it.
const SIDE: f64 = 260.0;
const MODULES: f64 = 3.2;
const PATH: f64 = 0.8;
/// Teeth to each side of the one in the middle.
const TEETH: i32 = 3;
/// Places along a flank, and along a circle between teeth.
const PLACES: i32 = 8;
/// Places over a pitch.
const POSITIONS: usize = 200;

/// Pairs of toothings, whether they are held by a constraint or a load.
pub fn tables(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let mut table = Table::new(&["pair", "of", "teeth", "axes", "contact", "meeting"]);
    for pair in &mechanism.pairs {
        table.row(Told::of(mechanism, pair).cells(code));
    }
    table.write(page, "Teeth");
    let mut table = Table::new(&["mesh", "stiffness", "mass", "frequency", "gap", "phase at the start"]);
    let phases = phases(compiled);
    for (gives, phase) in Gives::all(mechanism).iter().zip(phases) {
        let mut cells = gives.cells(code);
        cells.push(format!("{} of a pitch", numbers::coordinate(phase, 4)));
        table.row(cells);
    }
    table.write(page, "Teeth that give");
    let mut table =
        Table::new(&["mesh", "stiffness over a pitch, N/m", "left out by the series, rms", "largest step"]);
    for load in &mechanism.loads {
        let Some(series) = load.teeth.as_ref().and_then(|teeth| teeth.series.as_ref()) else { continue };
        let waves: Vec<String> = series.waves.iter().map(|[a, b]| decimal(a.hypot(*b))).collect();
        let percent = |part: f64| format!("{} %", decimal(100.0 * part));
        table.row(vec![
            code(&load.name.text),
            format!("{}, waves of {}", decimal(series.mean), waves.join(", ")),
            percent(series.left_out),
            percent(series.step),
        ]);
    }
    table.write(page, "Stiffness of teeth");
}

/// Of all loads between teeth at the start, of a pitch.
fn phases(compiled: &Compiled) -> Vec<f64> {
    Stand::of(compiled, &Pose::start(compiled)).built(|laws| {
        let loads = laws.mechanism.loads.iter().filter(|load| load.teeth.is_some());
        loads.map(|load| of_teeth(laws, load, OfTeeth::Phase).bare).collect()
    })
}

/// Close-ups of all pairs, and the curves of those whose stiffness follows from their shape.
pub fn pictures(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let pairs: Vec<&Pair> =
        mechanism.pairs.iter().filter(|pair| pair.meeting == Meeting::Cylinders).collect();
    if pairs.is_empty() {
        return;
    }
    page.push_str("\n<div>\n");
    for pair in pairs {
        let (toothings, mesh) = mechanism.mesh_of(pair);
        page.push_str(&close_up(pair, toothings, &mesh));
    }
    page.push_str("</div>\n\n");
    page.push_str(
        "Tip circles are full, pitch circles broken, base circles dotted; the line of action goes from base circle to base circle, and teeth touch along its thick part.\n",
    );
    let mut plots = String::new();
    for load in &mechanism.loads {
        let Some((exact, series)) = meshes::by_shape(mechanism, load) else { continue };
        let name = &load.name.text;
        let over = |value: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
            // To where the next pair begins to touch.
            let phases = (0..=POSITIONS).map(|at| (at as f64 / POSITIONS as f64).min(1.0 - 1e-9));
            phases.map(|phase| [phase, value(phase)]).collect()
        };
        let plot = |what: &str, up: String, lines: Vec<Line>| Plot {
            title: format!("{name}, {what}"),
            across: "phase, pitches".to_string(),
            up,
            from_zero: true,
            lines,
        };
        let stiffness = [(over(&|phase| exact.at(phase)), false), (over(&|phase| series.at(phase)), true)];
        let lines = stiffness.map(|(points, broken)| Line { points, broken });
        plots.push_str(&plot("stiffness", format!("{name}.stiffness, N/m"), lines.into()).svg());
        let pairs = Line { points: over(&|phase| exact.pairs(phase) as f64), broken: false };
        plots.push_str(&plot("pairs that touch", format!("{name}: pairs that touch"), vec![pairs]).svg());
    }
    if !plots.is_empty() {
        let _ =
            write!(page, "\n<div>\n{plots}</div>\n\nBroken lines are the series that the equations have.\n");
    }
}

/// A wheel as the close-up places it: a point of it, x along the line of centres, m.
struct Placed<'t> {
    toothing: &'t Toothing,
    center: f64,
    /// The middle of the tooth that touches.
    middle: f64,
}

fn close_up(pair: &Pair, toothings: [&Toothing; 2], mesh: &Mesh) -> String {
    let wheel = pair.wheel;
    let [one, other] = [toothings[wheel], toothings[1 - wheel]];
    let [base, other_base] = [mesh.base[wheel], mesh.base[1 - wheel]];
    let working = mesh.working_angle.unwrap_or(0.0);
    let (sine, cosine) = (libm::sin(working), libm::cos(working));
    // From the wheel's base tangent point T along the line of action: the pitch point, and where teeth are shown to touch.
    let pitch_point = base * sine / cosine;
    let [begin, end] = mesh.path;
    let touched = pitch_point.clamp(begin, end.max(begin));
    let ring = other.is_internal();
    let center = if ring { -pair.distance() } else { pair.distance() };
    // The flank of the wheel has its foot on the base circle at α_w − ξ/r_b, its tooth counter-clockwise from there.
    let inv = involute(one.transverse_angle());
    let middle = working - touched / base + one.half_tooth() + inv;
    let other_inv = involute(other.transverse_angle());
    let other_middle = if ring {
        let along = touched + pair.distance() * sine;
        working - along / other_base - (other.half_tooth() - other_inv)
    } else {
        let along = pair.distance() * sine - touched;
        std::f64::consts::PI + working - along / other_base + other.half_tooth() + other_inv
    };
    let shown = [
        Placed { toothing: one, center: 0.0, middle },
        Placed { toothing: other, center, middle: other_middle },
    ];

    let half = (MODULES * one.transverse_module()).max(PATH * (end - begin));
    let (scale, at) = (0.5 * SIDE / half, base / cosine);
    let place = |[x, y]: [f64; 2]| [0.5 * SIDE + scale * (x - at), 0.5 * SIDE - scale * y];
    let path = |points: &[[f64; 2]]| {
        let points: Vec<String> = points.iter().map(|point| place(*point).map(number).join(" ")).collect();
        format!("M{}", points.join("L"))
    };
    let title = format!("{}: teeth of {} and {}", pair.name.text, toothings[0].text, toothings[1].text);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{0}\" height=\"{0}\" viewBox=\"0 0 {0} {0}\" \
         font-family=\"sans-serif\" font-size=\"11\" style=\"margin-right:16px;vertical-align:top\">\n<title>{1}</title>\n",
        number(SIDE),
        escaped(&title)
    );
    for Placed { toothing, center, middle } in &shown {
        let outline: Vec<[f64; 2]> =
            flanks(toothing, *middle).into_iter().map(|[x, y]| [x + center, y]).collect();
        let _ = writeln!(
            svg,
            "<path d=\"{}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.4\" stroke-linejoin=\"round\"/>",
            path(&outline)
        );
        let working_radius = toothing.base_radius() / cosine;
        for (radius, dashes) in [
            (toothing.tip_radius(), ""),
            (working_radius, " stroke-dasharray=\"9 3 2 3\""),
            (toothing.base_radius(), " stroke-dasharray=\"1 3\""),
        ] {
            let [x, y] = place([*center, 0.0]).map(number);
            let _ = writeln!(
                svg,
                "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"0.6\"{dashes}/>",
                number(scale * radius)
            );
        }
    }
    let on_line = |along: f64| [base * cosine + along * sine, base * sine - along * cosine];
    let far = if ring { end + half } else { pair.distance() * sine };
    for (from, to, width) in [(0.0, far, 0.8), (begin, end, 2.6)] {
        let _ = writeln!(
            svg,
            "<path d=\"{}\" fill=\"none\" stroke=\"{ACCENT}\" stroke-width=\"{width}\"/>",
            path(&[on_line(from), on_line(to)])
        );
    }
    let [x, y] = place(on_line(touched)).map(number);
    let _ = writeln!(svg, "<circle cx=\"{x}\" cy=\"{y}\" r=\"3\" fill=\"{ACCENT}\"/>");
    let _ = writeln!(svg, "<text x=\"6\" y=\"14\" fill=\"currentColor\">{}</text>", escaped(&pair.name.text));
    svg.push_str("</svg>\n");
    svg
}

/// The outline of some teeth about the one whose middle is at an angle: flanks, tips and roots. Below the base circle flanks are radial.
fn flanks(toothing: &Toothing, middle: f64) -> Vec<[f64; 2]> {
    let (base, tip, root) = (toothing.base_radius(), toothing.tip_radius(), toothing.root_radius());
    let inv = involute(toothing.transverse_angle());
    let inwards = if toothing.is_internal() { 1.0 } else { -1.0 };
    let half = |radius: f64| {
        let angle = libm::acos((base / radius.max(base)).min(1.0));
        (toothing.half_tooth() - inwards * (inv - involute(angle))).max(0.0)
    };
    let polar = |radius: f64, angle: f64| [radius * libm::cos(angle), radius * libm::sin(angle)];
    let pitch = std::f64::consts::TAU / toothing.teeth;
    let between =
        |from: f64, to: f64| (0..=PLACES).map(move |k| from + (to - from) * f64::from(k) / f64::from(PLACES));
    let mut outline = Vec::new();
    for tooth in -TEETH..=TEETH {
        let middle = middle + pitch * f64::from(tooth);
        outline.extend(between(root, tip).map(|radius| polar(radius, middle - half(radius))));
        outline.extend(between(-half(tip), half(tip)).map(|angle| polar(tip, middle + angle)));
        outline.extend(between(tip, root).map(|radius| polar(radius, middle + half(radius))));
        outline.extend(between(half(root), pitch - half(root)).map(|angle| polar(root, middle + angle)));
    }
    outline
}
