//! The tables of a mechanism as small plots: knots as dots, what stands between and outside as a line; of a grid a line for each value
//! of the second argument.

use super::figure::{escaped, number};
use crate::compiled::Compiled;
use crate::model::Table;
use crate::symbolic::Orders;
use std::fmt::Write;

/// The frame, px, what of it is outside of the knots, and how finely a line is drawn.
const WIDTH: f64 = 180.0;
const HEIGHT: f64 = 110.0;
const OUTSIDE: f64 = 0.08;
const POINTS: usize = 120;
/// Space for the text around it.
const MARGIN: [f64; 2] = [8.0, 32.0];

pub fn curves(page: &mut String, compiled: &Compiled) {
    let tables = &compiled.mechanism.tables;
    if tables.is_empty() {
        return;
    }
    page.push_str("\n# Tables\n\n<div>\n");
    tables.iter().for_each(|table| page.push_str(&picture(table)));
    page.push_str("</div>\n\n");
    let captions: Vec<String> = tables.iter().map(caption).collect();
    let _ = writeln!(page, "{}.", captions.join("; "));
}

fn caption(table: &Table) -> String {
    let counts: Vec<String> = table.knots.iter().map(|knots| knots.len().to_string()).collect();
    format!("`{}`: {} knots, `{}`", table.name.text, counts.join(" × "), table.kind.word())
}

/// The polygon of each line and the dots on it, in the units of the head.
fn lines(table: &Table) -> Vec<[Vec<[f64; 2]>; 2]> {
    let (knots, scale) = (&table.knots[0], table.arguments[0].scale);
    let (first, last) = (knots[0], knots[knots.len() - 1]);
    let (from, to) = (first - OUTSIDE * (last - first), last + OUTSIDE * (last - first));
    let shown = |arguments: &[f64]| {
        [arguments[0] / scale, table.curve.at(Orders::new(0, 0), arguments) / table.value.scale]
    };
    let seconds: Vec<Option<f64>> = match table.knots.get(1) {
        Some(seconds) => seconds.iter().copied().map(Some).collect(),
        None => vec![None],
    };
    let of = |second: &Option<f64>, x: f64| match second {
        Some(second) => shown(&[x, *second]),
        None => shown(&[x]),
    };
    let line = |second: &Option<f64>| {
        let steps = (0..=POINTS).map(|k| from + (to - from) * k as f64 / POINTS as f64);
        let mut places: Vec<f64> = steps.chain(knots.iter().copied()).collect();
        places.sort_by(f64::total_cmp);
        let drawn = places.into_iter().map(|x| of(second, x)).collect();
        [drawn, knots.iter().map(|x| of(second, *x)).collect()]
    };
    seconds.iter().map(line).collect()
}

fn picture(table: &Table) -> String {
    let lines = lines(table);
    let all = || lines.iter().flatten().flatten();
    let range = |k: usize| {
        let values = || all().map(|point| point[k]);
        let (least, most) =
            (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        if most > least { [least, most] } else { [least - 1.0, most + 1.0] }
    };
    let (across, up) = (range(0), range(1));
    let place = |[x, y]: [f64; 2]| {
        let share = |value: f64, [least, most]: [f64; 2]| (value - least) / (most - least);
        [number(WIDTH * share(x, across)), number(HEIGHT * (1.0 - share(y, up)))]
    };
    let [side, text] = MARGIN;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{0}\" height=\"{1}\" viewBox=\"-{side} -{text} {0} {1}\" \
         font-family=\"sans-serif\" font-size=\"11\" style=\"margin-right:16px;vertical-align:top\">\n<title>{2}</title>\n",
        number(WIDTH + 2.0 * side),
        number(HEIGHT + 2.0 * text),
        escaped(&caption(table))
    );
    let mut write = |x: &str, y: f64, anchor: &str, content: &str| {
        let _ = writeln!(
            svg,
            "<text x=\"{x}\" y=\"{}\" text-anchor=\"{anchor}\" fill=\"currentColor\">{}</text>",
            number(y),
            escaped(content)
        );
    };
    let digits =
        |value: f64| super::text::decimal(crate::numbers::significant(value, 3).parse().unwrap_or(value));
    let axis =
        |name: &str, unit: &str| if unit == "1" { name.to_string() } else { format!("{name}, {unit}") };
    let argument = &table.arguments[0];
    write("0", -18.0, "start", &axis(&table.name.text, &table.value.unit));
    write("0", -5.0, "start", &format!("{} to {}", digits(up[0]), digits(up[1])));
    write("0", HEIGHT + 13.0, "start", &digits(across[0]));
    write(&number(WIDTH), HEIGHT + 13.0, "end", &digits(across[1]));
    write(&number(0.5 * WIDTH), HEIGHT + 26.0, "middle", &axis(&argument.name, &argument.unit));
    let _ = writeln!(
        svg,
        "<path d=\"M0 0h{0}v{1}h-{0}z\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"0.8\"/>",
        number(WIDTH),
        number(HEIGHT)
    );
    for (index, [drawn, dots]) in lines.iter().enumerate() {
        let points: Vec<String> = drawn.iter().map(|point| place(*point).join(" ")).collect();
        let opacity = number(1.0 - 0.6 * index as f64 / lines.len() as f64);
        let _ = writeln!(
            svg,
            "<path d=\"M{}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.4\" stroke-opacity=\"{opacity}\"/>",
            points.join("L")
        );
        // Many knots make a line of themselves.
        for [x, y] in dots.iter().filter(|_| dots.len() <= 60).map(|point| place(*point)) {
            let _ = writeln!(
                svg,
                "<circle cx=\"{x}\" cy=\"{y}\" r=\"1.8\" fill=\"currentColor\" fill-opacity=\"{opacity}\"/>"
            );
        }
    }
    svg.push_str("</svg>\n");
    svg
}
