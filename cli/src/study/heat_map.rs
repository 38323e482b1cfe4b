//! What is measured over two parameters, as SVG: a map for each measure, whose colours a bar beside it tells.

use super::plot::{figure, head, ticks, typeset};
use super::short;
use linkwright_compiler::drawing_text::escaped;
use std::fmt::Write;

/// A parameter, and its values in its unit, in the order in which they are drawn.
pub struct Side<'s> {
    pub name: &'s str,
    pub unit: &'s str,
    pub values: Vec<f64>,
}

/// A measure, with a value for each pair: those of the second parameter one after another for each of the first. What has failed is no
/// number.
pub struct Map<'m> {
    pub name: &'m str,
    pub values: Vec<f64>,
}

const WIDTH: f64 = 720.0;
const LEFT: f64 = 74.0;
/// Of the cells.
const BROAD: f64 = 520.0;
const HIGH: f64 = 300.0;
/// Of the bar of colours, and where it begins.
const BAR: f64 = 16.0;
const BAR_LEFT: f64 = LEFT + BROAD + 24.0;
const TITLE: f64 = 24.0;
const BELOW: f64 = 44.0;

/// Colours from the least to the most, equally far from one another to the eye and in grey: `viridis` of N. Smith and S. van der Walt.
const COLOURS: [[u8; 3]; 9] = [
    [0x44, 0x01, 0x54],
    [0x47, 0x2d, 0x7b],
    [0x3b, 0x52, 0x8b],
    [0x2c, 0x72, 0x8e],
    [0x21, 0x91, 0x8c],
    [0x28, 0xae, 0x80],
    [0x5e, 0xc9, 0x62],
    [0xad, 0xdc, 0x30],
    [0xfd, 0xe7, 0x25],
];

/// The colour of a place between the least, 0, and the most, 1.
fn colour(place: f64) -> String {
    let last = COLOURS.len() - 1;
    let at = place.clamp(0.0, 1.0) * last as f64;
    let below = (at.floor() as usize).min(last - 1);
    let [from, to] = [COLOURS[below], COLOURS[below + 1]];
    let part = |k: usize| f64::from(from[k]) + (f64::from(to[k]) - f64::from(from[k])) * (at - below as f64);
    format!("#{:02x}{:02x}{:02x}", part(0).round() as u8, part(1).round() as u8, part(2).round() as u8)
}

/// The maps below one another, the first parameter across.
pub fn heat_maps(name: &str, sides: [&Side; 2], maps: &[Map]) -> String {
    let [across, upward] = sides;
    let each = TITLE + HIGH + BELOW;
    let title = format!("{name} over {} and {}", across.name, upward.name);
    let mut svg = head(&title, WIDTH, each * maps.len() as f64);
    for (index, map) in maps.iter().enumerate() {
        one(&mut svg, map, [across, upward], each * index as f64 + TITLE);
    }
    svg.push_str("</svg>\n");
    svg
}

fn one(svg: &mut String, map: &Map, [across, upward]: [&Side; 2], top: f64) {
    let finite = || map.values.iter().copied().filter(|value| value.is_finite());
    let (least, most) = (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
    let place = |value: f64| if most > least { (value - least) / (most - least) } else { 0.5 };
    let (broad, high) = (BROAD / across.values.len() as f64, HIGH / upward.values.len() as f64);
    let _ = writeln!(
        svg,
        "<text class=\"title\" x=\"{LEFT}\" y=\"{:.1}\">{}</text>",
        top - 8.0,
        escaped(map.name)
    );
    for (i, first) in across.values.iter().enumerate() {
        for (j, second) in upward.values.iter().enumerate() {
            let value = map.values[i * upward.values.len() + j];
            let (fill, said) = if value.is_finite() {
                (colour(place(value)), short(value))
            } else {
                ("var(--grid)".to_string(), "failed".to_string())
            };
            let _ = writeln!(
                svg,
                "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\" fill=\"{fill}\"><title>{} = {} {}, {} = {} {}: {said}</title></rect>",
                LEFT + broad * i as f64,
                top + HIGH - high * (j + 1) as f64,
                // Without seams.
                broad + 0.3,
                high + 0.3,
                escaped(across.name),
                short(*first),
                escaped(&typeset(across.unit)),
                escaped(upward.name),
                short(*second),
                escaped(&typeset(upward.unit)),
            );
        }
    }
    axes(svg, [across, upward], top);
    if most >= least {
        bar(svg, (least, most), top);
    }
}

/// Numbers where cells have their middle, and the names of the parameters.
fn axes(svg: &mut String, [across, upward]: [&Side; 2], top: f64) {
    let middle = |side: &Side, mark: f64, size: f64| {
        let (first, last) = (side.values[0], side.values[side.values.len() - 1]);
        let cell = size / side.values.len() as f64;
        cell / 2.0 + (size - cell) * (mark - first) / (last - first)
    };
    let marks = |side: &Side| {
        let (first, last) = (side.values[0], side.values[side.values.len() - 1]);
        ticks(first.min(last), first.max(last), 5.0)
    };
    for mark in marks(across) {
        let (x, y) = (LEFT + middle(across, mark, BROAD), top + HIGH);
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
            y + 15.0,
            figure(mark)
        );
    }
    for mark in marks(upward) {
        let y = top + HIGH - middle(upward, mark, HIGH);
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            LEFT - 6.0,
            y + 4.0,
            figure(mark)
        );
    }
    let label = |side: &Side| escaped(&format!("{}, {}", side.name, typeset(side.unit)));
    let _ = writeln!(
        svg,
        "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
        LEFT + BROAD / 2.0,
        top + HIGH + 32.0,
        label(across)
    );
    let (x, y) = (16.0, top + HIGH / 2.0);
    let _ = writeln!(
        svg,
        "<text x=\"{x}\" y=\"{y:.1}\" text-anchor=\"middle\" transform=\"rotate(-90 {x} {y:.1})\">{}</text>",
        label(upward)
    );
}

/// Which colour is which value, with the least and the most at its ends.
fn bar(svg: &mut String, (least, most): (f64, f64), top: f64) {
    const STEPS: usize = 50;
    let high = HIGH / STEPS as f64;
    for step in 0..STEPS {
        let y = top + HIGH - high * (step + 1) as f64;
        let fill = colour((step as f64 + 0.5) / STEPS as f64);
        let _ = writeln!(
            svg,
            "<rect x=\"{BAR_LEFT}\" y=\"{y:.2}\" width=\"{BAR}\" height=\"{:.2}\" fill=\"{fill}\"/>",
            high + 0.3
        );
    }
    for (value, y) in
        [(most, top + 10.0), ((least + most) / 2.0, top + HIGH / 2.0 + 4.0), (least, top + HIGH)]
    {
        let _ =
            writeln!(svg, "<text x=\"{:.1}\" y=\"{y:.1}\">{}</text>", BAR_LEFT + BAR + 5.0, figure(value));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ends of the bar have the first and the last colour, what lies between two neighbours is between them.
    #[test]
    fn colours() {
        assert_eq!([colour(0.0), colour(1.0), colour(-3.0)], ["#440154", "#fde725", "#440154"]);
        assert_eq!(colour(0.5), "#21918c");
        assert_eq!(colour(1.0 / 16.0), "#461768");
    }

    #[test]
    fn cells_stand_where_their_values_say() {
        let side = |name| Side { name, unit: "mm", values: vec![1.0, 2.0, 3.0] };
        let mut values: Vec<f64> = (0..9).map(f64::from).collect();
        values[5] = f64::NAN;
        let svg = heat_maps("Two", [&side("a"), &side("b")], &[Map { name: "max(x)", values }]);
        let cell = |text: &str| {
            let line = svg.lines().find(|line| line.contains(text)).expect(text);
            let number = |name: &str| -> f64 {
                let rest = line.split_once(&format!(" {name}=\"")).expect("it has one").1;
                rest.split_once('"').expect("an end").0.parse().expect("a number")
            };
            (number("x"), number("y"))
        };
        let (first, last) = (cell("a = 1 mm, b = 1 mm: 0<"), cell("a = 3 mm, b = 3 mm: 8<"));
        assert!(first.0 < last.0 && first.1 > last.1, "{first:?} {last:?}");
        assert!(svg.contains("a = 2 mm, b = 3 mm: failed<"), "{svg}");
        assert!(svg.contains("fill=\"#440154\"><title>a = 1 mm, b = 1 mm"));
    }
}
