//! The sheet: shapes in the order of their depth, as SVG that takes its colours from the page around it.

use super::view::Spot;
use std::fmt::Write;

/// What is behind everything, in light and dark themes of rustdoc, and elsewhere.
pub const PAPER: &str = "var(--main-background-color,Canvas)";
/// Loads.
pub const ACCENT: &str = "#c4601c";

/// How a shape is drawn.
#[derive(Clone, Copy, Debug)]
pub enum Pen {
    /// A line of this width, px.
    Line(f64),
    /// The same, broken: axes and pitch circles.
    Broken(f64),
    /// A line of this width in the colour of the paper.
    Erase(f64),
    /// A line around the colour of the paper.
    Outline(f64),
    /// A face and a line around it, both in the colour of the paper.
    Blank(f64),
    /// A faint tint, also under a line of this width around it.
    Tint(f64),
    Solid,
    /// Lines and faces of loads.
    Load(f64),
    SolidLoad,
}

/// What can be seen of a shape: where names would cover it. Widths are halves, px.
#[derive(Clone, Copy, Debug)]
pub enum Trace {
    Line([Spot; 2], f64),
    /// A ring, or all that is within it.
    Circle {
        center: Spot,
        radius: f64,
        half: f64,
        is_full: bool,
    },
}

/// Shapes with one name and one depth.
#[derive(Clone, Debug)]
pub struct Group {
    pub layer: usize,
    /// How near to the eye: the nearer of two in one layer is drawn later.
    pub nearness: f64,
    title: String,
    text: String,
    traces: Vec<Trace>,
}

impl Group {
    pub fn new(layer: usize, nearness: f64, title: impl Into<String>) -> Self {
        Group { layer, nearness, title: title.into(), text: String::new(), traces: Vec::new() }
    }

    pub fn traces(&self) -> &[Trace] {
        &self.traces
    }

    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    pub fn line(&mut self, a: Spot, b: Spot, pen: Pen) {
        self.path(&[a, b], false, pen);
    }

    pub fn path(&mut self, points: &[Spot], is_closed: bool, pen: Pen) {
        let mut path = String::new();
        for (index, point) in points.iter().enumerate() {
            let word = if index == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{word}{} {}", number(point[0]), number(point[1]));
        }
        if is_closed {
            path.push('Z');
        }
        let _ = write!(self.text, "<path d=\"{path}\" {}/>", pen.attributes());
        let Some(half) = pen.half() else { return };
        let closing = is_closed.then(|| points.first()).flatten();
        let ends = points.iter().skip(1).chain(closing);
        self.traces.extend(points.iter().zip(ends).map(|(a, b)| Trace::Line([*a, *b], half)));
    }

    pub fn circle(&mut self, center: Spot, radius: f64, pen: Pen) {
        let [x, y] = center.map(number);
        let r = number(radius);
        let _ = write!(self.text, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" {}/>", pen.attributes());
        if let Some(half) = pen.half() {
            let is_full = matches!(pen, Pen::Solid | Pen::SolidLoad);
            self.traces.push(Trace::Circle { center, radius, half, is_full });
        }
    }

    /// A line with a head at its end.
    pub fn arrow(&mut self, from: Spot, to: Spot, pen: Pen, head: Pen) {
        let way = [to[0] - from[0], to[1] - from[1]];
        let size = libm::sqrt(way[0] * way[0] + way[1] * way[1]).max(1e-9);
        let e = way.map(|x| x / size);
        let back = |along: f64, aside: f64| {
            [to[0] - along * e[0] - aside * e[1], to[1] - along * e[1] + aside * e[0]]
        };
        self.line(from, back(5.0, 0.0), pen);
        self.path(&[to, back(8.0, 3.0), back(8.0, -3.0)], true, head);
    }

    pub fn write(&self, svg: &mut String) {
        if self.title.is_empty() {
            let _ = writeln!(svg, "<g>{}</g>", self.text);
        } else {
            let _ = writeln!(svg, "<g><title>{}</title>{}</g>", escaped(&self.title), self.text);
        }
    }
}

impl Pen {
    /// Half the width of what it leaves; nothing where that is the colour of the paper, or a tint.
    fn half(self) -> Option<f64> {
        match self {
            Pen::Line(width) | Pen::Broken(width) | Pen::Outline(width) | Pen::Load(width) => {
                Some(width / 2.0)
            }
            Pen::Solid | Pen::SolidLoad => Some(0.0),
            Pen::Erase(_) | Pen::Blank(_) | Pen::Tint(_) => None,
        }
    }

    fn attributes(self) -> String {
        let line = |colour: &str, width: f64| {
            format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\"", number(width))
        };
        match self {
            Pen::Line(width) => line("currentColor", width),
            Pen::Broken(width) => format!("{} stroke-dasharray=\"9 3 2 3\"", line("currentColor", width)),
            Pen::Erase(width) => line(PAPER, width),
            Pen::Outline(width) => {
                format!("fill=\"{PAPER}\" stroke=\"currentColor\" stroke-width=\"{}\"", number(width))
            }
            Pen::Blank(width) => {
                format!("fill=\"{PAPER}\" stroke=\"{PAPER}\" stroke-width=\"{}\"", number(width))
            }
            Pen::Tint(0.0) => "fill=\"currentColor\" fill-opacity=\"0.07\" stroke=\"none\"".to_string(),
            // Face and line as one, so that the tint is the same where they overlap.
            Pen::Tint(width) => format!(
                "fill=\"currentColor\" stroke=\"currentColor\" stroke-width=\"{}\" opacity=\"0.07\"",
                number(width)
            ),
            Pen::Solid => "fill=\"currentColor\" stroke=\"none\"".to_string(),
            Pen::Load(width) => line(ACCENT, width),
            Pen::SolidLoad => format!("fill=\"{ACCENT}\" stroke=\"none\""),
        }
    }
}

/// A coordinate to a tenth of a pixel.
pub fn number(value: f64) -> String {
    let rounded = (10.0 * value).round() / 10.0;
    // No −0.
    format!("{}", rounded + 0.0)
}

/// Text between tags.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
