//! The drawing of a mechanism at its start, as SVG: in the plane to scale, in space along a fixed direction.

mod bent;
mod dimensions;
mod drives;
mod hinges;
mod labels;
mod loads;
mod parts;
mod plane;
mod room;
mod skin;
mod space;

pub use crate::drawing::canvas::{escaped, number};

use super::dimensions::Dimension;
use super::sketch::Sketch;
use crate::drawing::canvas::{Group, PAPER, Pen, Trace};
use crate::drawing::shapes::{self, heading, shifted};
use crate::drawing::vector::{Point, along, sum};
use crate::drawing::view::{Spot, View};
use crate::forms::Spans;
use crate::model::{Frame, Space};
use labels::{Kind, Label};
use room::Area;
use std::fmt::Write;

/// Layers, from the back to the front.
const SHAPES: usize = 0;
const GROUND: usize = 1;
const BLOCKS: usize = 2;
const BODIES: usize = 3;
const JOINTS: usize = 4;
const LOADS: usize = 5;

/// Paper and ink of a drawing that stands alone, light and dark.
const WHITE: &str = "#fff";
const INK: &str = "#1b2330";
const DARK: &str = "#12161d";
const LIGHT_INK: &str = "#e4e9f0";

/// Height of axes and scale, with room above them, px.
const BELOW: f64 = 62.0;

/// The sheet while it is being drawn.
struct Drawing {
    view: View,
    /// Radius of a pin, px.
    unit: f64,
    groups: Vec<Group>,
    labels: Vec<Label>,
    /// Texts that are no names of parts.
    texts: Vec<Area>,
    /// How many times as large deflections are.
    times: f64,
}

/// A drawing, and how many names found no place in it.
pub struct Figure {
    pub svg: String,
    pub left_out: usize,
    /// How many dimensions there are, and those that found no place.
    pub dimensions: usize,
    pub without_place: Vec<String>,
}

pub fn figure(name: &str, sketch: &Sketch, dimensions: &[Dimension]) -> Figure {
    let beside = dimensions::room(dimensions);
    let view = View::of(sketch.space, sketch.up, &extent(sketch), names(sketch), beside);
    let unit = unit(&view, sketch);
    let times = sketch.times;
    let mut drawing =
        Drawing { view, unit, groups: Vec::new(), labels: Vec::new(), texts: Vec::new(), times };
    for part in &sketch.parts {
        parts::part(&mut drawing, part);
    }
    for skin in &sketch.skins {
        skin::skin(&mut drawing, skin);
    }
    for wheel in &sketch.wheels {
        loads::wheel(&mut drawing, wheel);
    }
    let hinges = hinges::apart(&drawing.view, unit, &sketch.hinges);
    for hinge in &hinges {
        match sketch.space {
            Space::Planar => plane::joint(&mut drawing, hinge),
            Space::Spatial => space::joint(&mut drawing, hinge),
        }
        let anchor = drawing.view.spot(hinge.at);
        drawing.label(&hinge.name, vec![anchor], 2.0 * unit, Kind::Joint);
    }
    for link in &sketch.links {
        drives::link(&mut drawing, link, &sketch.wheels);
    }
    let asides = loads::asides(&drawing.view, &sketch.efforts);
    for ((kind, effort), aside) in sketch.efforts.iter().zip(asides) {
        loads::effort(&mut drawing, kind, &hinges::with_its_hinge(effort, &hinges), aside * unit.max(2.5));
    }
    for drive in &sketch.drives {
        drives::drive(&mut drawing, drive);
    }
    drawing.write(name, sketch.space, dimensions)
}

/// A drawing as a file of its own, on paper of its own: light, and dark where what shows it is.
pub fn alone(svg: &str) -> String {
    let begin = format!("<svg class=\"linkwright\" color=\"{INK}\" ");
    let (head, rest) = svg.split_once('\n').unwrap_or((svg, ""));
    let (title, rest) = rest.split_once('\n').unwrap_or((rest, ""));
    let style = format!(
        "<style>.linkwright{{background:{WHITE}}}@media(prefers-color-scheme:dark){{\
         .linkwright{{color:{LIGHT_INK};background:{DARK}}}\
         .linkwright [fill=\"{WHITE}\"]{{fill:{DARK}}}.linkwright [stroke=\"{WHITE}\"]{{stroke:{DARK}}}}}</style>"
    );
    format!("{}\n{title}\n{style}\n{rest}", head.replacen("<svg ", &begin, 1)).replace(PAPER, WHITE)
}

/// How many names it has.
fn names(sketch: &Sketch) -> usize {
    let Sketch { parts, hinges, efforts, links, drives, .. } = sketch;
    parts.len() + hinges.len() + efforts.len() + links.len() + drives.len()
}

/// Every point that must be in the picture.
pub fn extent(sketch: &Sketch) -> Vec<Point> {
    let of_parts = sketch.parts.iter().flat_map(parts::extent);
    let of_joints = sketch.hinges.iter().flat_map(|hinge| match hinge.form.spans {
        Spans::Line => vec![hinge.first, hinge.second, sum(hinge.first, hinge.axis)],
        // A rail of the ground is drawn as far as it is used.
        Spans::Rail if hinge.form.is_block() && hinge.first_on == Frame::Ground => vec![hinge.second],
        Spans::Nothing | Spans::Rod | Spans::Rail | Spans::Outline | Spans::Curve => {
            vec![hinge.first, hinge.second]
        }
    });
    let of_wheels = sketch.wheels.iter().flat_map(|wheel| {
        let [u, v] = shapes::across(wheel.about);
        let r = wheel.radius;
        [
            along(wheel.center, r, u),
            along(wheel.center, -r, u),
            along(wheel.center, r, v),
            along(wheel.center, -r, v),
        ]
    });
    // What acts between places is drawn from the one to the other.
    let between = sketch.efforts.iter().filter(|(_, effort)| effort.ends.len() > 1);
    let of_springs = between.flat_map(|(_, effort)| effort.ends.iter().map(|end| end.at));
    let of_skins = sketch.skins.iter().flat_map(|skin| skin.lines.iter().flatten().copied());
    of_parts.chain(of_joints).chain(of_wheels).chain(of_springs).chain(of_skins).collect()
}

/// Small where bodies are small, so that symbols leave something of them.
fn unit(view: &View, sketch: &Sketch) -> f64 {
    let mut sizes: Vec<f64> = sketch.parts.iter().map(|part| parts::size(view.scale, part)).collect();
    sizes.retain(|size| *size > 0.0);
    sizes.sort_by(f64::total_cmp);
    let median = sizes.get(sizes.len() / 2).copied().unwrap_or(100.0);
    (0.06 * median).clamp(1.5, 5.0)
}

impl Drawing {
    /// Of a body that its joints hide there is the name at least.
    fn add(&mut self, group: Group) {
        if group.layer == BODIES || !group.is_empty() {
            self.groups.push(group);
        }
    }

    fn label(&mut self, text: &str, anchors: Vec<Spot>, reach: f64, kind: Kind) {
        self.labels.push(Label { text: text.to_string(), anchors, reach, kind });
    }

    /// Symbols that hang low leave axes and scale below them.
    fn make_room_below(&mut self) {
        let low = |trace: &Trace| match trace {
            Trace::Line([a, b], half) => a[1].max(b[1]) + half,
            Trace::Circle { center, radius, half, .. } => center[1] + radius + half,
        };
        let lowest = self.groups.iter().flat_map(|group| group.traces()).map(low).fold(0.0, f64::max);
        self.view.height = self.view.height.max(lowest + BELOW);
    }

    fn write(mut self, name: &str, space: Space, dimensions: &[Dimension]) -> Figure {
        self.make_room_below();
        let View { width, height, .. } = self.view;
        let legend = self.legend();
        let mut shapes = String::new();
        self.groups.sort_by(|a, b| a.layer.cmp(&b.layer).then(a.nearness.total_cmp(&b.nearness)));
        self.groups.iter().for_each(|group| group.write(&mut shapes));
        shapes.push_str(&legend);
        // Bodies first: they have most freedom of place and matter most.
        let mut labels = std::mem::take(&mut self.labels);
        labels.sort_by_key(|label| label.kind);
        let mut drawn: Vec<Trace> = self.groups.iter().flat_map(|group| group.traces().to_vec()).collect();
        let size = labels::size(labels.len());
        let mut sheet = dimensions::Sheet::new(&self.view, self.unit, size, self.texts, &drawn);
        let left = sheet.write(&mut shapes, dimensions);
        let (told, more) = dimensions::told(&left, width, height);
        // Names have most freedom of place, so they make way for dimensions.
        let dimensions::Sheet { texts, lines, thin, .. } = sheet;
        drawn.extend(lines.into_iter().chain(thin));
        let left_out = labels::write(&mut shapes, &labels, texts, &drawn, [width, height]);
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" \
             font-family=\"sans-serif\" font-size=\"12\" stroke-linecap=\"round\" stroke-linejoin=\"round\" \
             style=\"max-width:100%;height:auto\">\n<title>{2}, {3} mechanism at its start</title>\n{shapes}{told}</svg>",
            number(width),
            number(height + more),
            escaped(name),
            space.text(),
        );
        let without_place = left.iter().map(|dimension| format!("{} ({})", dimension.text, dimension.of));
        Figure { svg, left_out, dimensions: dimensions.len(), without_place: without_place.collect() }
    }

    /// Axes of the world at the lower left, a scale at the lower right.
    fn legend(&mut self) -> String {
        let View { width, height, scale, space, .. } = self.view;
        let mut svg = String::new();
        let corner = [30.0, height - 26.0];
        let mut axes = Group::new(GROUND, 0.0, "axes of the world");
        let mut names = String::new();
        for (k, axis) in ["x", "y", "z"].iter().enumerate().take(space.dimensions()) {
            let mut e = [0.0; 3];
            e[k] = 1.0;
            let way = self.view.way(e);
            let end = shifted(corner, 26.0 / scale, way);
            axes.arrow(corner, end, Pen::Line(1.0), Pen::Solid);
            if let Some(e) = heading(corner, end) {
                let at = shifted(end, 7.0, e);
                let _ = writeln!(
                    names,
                    "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"currentColor\" font-size=\"11\">{axis}</text>",
                    number(at[0]),
                    number(at[1] + 4.0)
                );
            }
        }
        axes.write(&mut svg);
        svg.push_str(&names);
        self.texts.push(Area { center: [corner[0] + 8.0, corner[1] - 8.0], half: [30.0, 30.0] });

        let (length, text) = scale_bar(scale);
        let right = [width - 18.0, height - 16.0];
        let left = [right[0] - length * scale, right[1]];
        let mut bar = Group::new(GROUND, 0.0, "scale");
        bar.line(left, right, Pen::Line(1.4));
        for end in [left, right] {
            bar.line(shifted(end, -4.0, [0.0, 1.0]), shifted(end, 4.0, [0.0, 1.0]), Pen::Line(1.4));
        }
        bar.write(&mut svg);
        let middle = shapes::middle(left, right);
        let _ = writeln!(
            svg,
            "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"currentColor\" font-size=\"11\">{text}</text>",
            number(middle[0]),
            number(middle[1] - 8.0)
        );
        let half = [length * scale / 2.0 + 4.0, 16.0];
        self.texts.push(Area { center: [middle[0], middle[1] - 4.0], half });
        if self.times != 1.0 {
            svg.push_str(&self.magnified());
        }
        svg
    }
}

impl Drawing {
    /// That deflections are not to scale, above the scale.
    fn magnified(&mut self) -> String {
        let text = magnified(self.times);
        let half = labels::width(&text, false) * 11.0 / 2.0;
        let center = [self.view.width - 18.0 - half, self.view.height - 44.0];
        self.texts.push(Area { center, half: [half, 8.0] });
        format!(
            "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"currentColor\" font-size=\"11\">{text}</text>\n",
            number(center[0]),
            number(center[1] + 4.0)
        )
    }
}

/// What a picture says of deflections that it shows so many times as large.
pub fn magnified(times: f64) -> String {
    format!("deflections × {times}")
}

/// A round length of about a hundred pixels, m, and how it is called.
fn scale_bar(scale: f64) -> (f64, String) {
    let wanted = 110.0 / scale;
    let mut power = libm::pow(10.0, wanted.log10().floor());
    if power > wanted {
        power /= 10.0;
    }
    let digit = [5.0, 2.0, 1.0].into_iter().find(|digit| digit * power <= wanted).unwrap_or(1.0);
    let length = digit * power;
    let text = if length >= 1.0 { format!("{length:.0} m") } else { in_millimetres(1e3 * length) };
    (length, text)
}

fn in_millimetres(length: f64) -> String {
    if length >= 1.0 { format!("{length:.0} mm") } else { format!("{} mm", super::text::decimal(length)) }
}
