//! An animated drawing of any planar mechanism: SVG that a small script moves.
//!
//! Bodies are drawn from the points, lines and outlines of the definition (`geometry.rs`), their motion is given as
//! frames. The first frame stands in the picture itself, so it shows without the script too.

use crate::geometry::{Body, Geometry, Kind, Outline, Place};
use crate::plots::COLOURS;
use crate::shapes::{LINK, link, pin_support, rectangle};
use crate::tables::escape;
use linkwright::BodyMotion;
use std::fmt::Write;

/// The script that moves all drawings of a page.
pub const SCRIPT: &str = include_str!("drawing.js");

/// A mechanism in motion.
pub struct Drawing<'g> {
    pub geometry: &'g Geometry,
    /// At equal distances of time.
    pub frames: &'g [Frame],
    /// Points (`body.point`) whose paths are drawn.
    pub traces: Vec<&'static str>,
    pub readouts: Vec<Readout>,
    /// How fast it may be played, as a fraction of real time; the first is chosen.
    pub speeds: Vec<f64>,
    /// What is seen, a sentence in HTML.
    pub caption: String,
}

/// Where all bodies are at one time.
pub struct Frame {
    pub time: f64,
    /// Centre of mass (m) and cosine and sine of the angle, in the order of `BODIES`.
    pub bodies: Vec<[f64; 4]>,
}

/// A quantity shown beside the drawing: one text a frame.
pub struct Readout {
    pub label: &'static str,
    pub unit: &'static str,
    pub values: Vec<String>,
}

impl Frame {
    /// The frame at `time` of what a model's `motions` returned.
    pub fn of(time: f64, motions: &[BodyMotion]) -> Frame {
        let pose = |motion: &BodyMotion| {
            [motion.position[0], motion.position[1], motion.orientation[0], motion.orientation[1]]
        };
        Frame { time, bodies: motions.iter().map(pose).collect() }
    }

    fn point(&self, place: Place) -> [f64; 2] {
        let Some(body) = place.body else { return place.at };
        let [x, y, c, s] = self.bodies[body];
        [x + c * place.at[0] - s * place.at[1], y + s * place.at[0] + c * place.at[1]]
    }

    /// The direction in world axes of one given in those of a body or of the ground.
    fn direction(&self, body: Option<usize>, axis: [f64; 2]) -> [f64; 2] {
        let [c, s] = body.map_or([1.0, 0.0], |body| [self.bodies[body][2], self.bodies[body][3]]);
        [c * axis[0] - s * axis[1], s * axis[0] + c * axis[1]]
    }
}

/// From metres to the picture's units, y downwards.
struct View {
    left: f64,
    top: f64,
    scale: f64,
    size: [f64; 2],
}

const WIDTH: f64 = 1000.0;
const TALLEST: f64 = 640.0;
const MARGIN: f64 = 46.0;

impl View {
    fn of(drawing: &Drawing) -> View {
        let (mut least, mut most) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for [x, y] in drawing.extent() {
            (least, most) = ([least[0].min(x), least[1].min(y)], [most[0].max(x), most[1].max(y)]);
        }
        let [width, height] = [most[0] - least[0], most[1] - least[1]].map(|length| length.max(1e-9));
        let scale = ((WIDTH - 2.0 * MARGIN) / width).min((TALLEST - 2.0 * MARGIN) / height);
        let left = least[0] - 0.5 * (WIDTH / scale - width);
        View { left, top: most[1] + MARGIN / scale, scale, size: [WIDTH, height * scale + 2.0 * MARGIN] }
    }

    fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [(x - self.left) * self.scale, (self.top - y) * self.scale]
    }

    /// Coordinates within a body's group.
    fn local(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x * self.scale, -y * self.scale]
    }
}

impl Drawing<'_> {
    /// The drawing as an HTML figure; the page needs [`SCRIPT`] once.
    pub fn figure(&self) -> String {
        let view = View::of(self);
        let [width, height] = view.size;
        let mut svg = format!("<svg class=\"stage\" viewBox=\"0 0 {width:.0} {height:.0}\" role=\"img\">\n");
        self.supports(&mut svg, &view);
        self.paths(&mut svg, &view);
        for (index, body) in self.geometry.bodies.iter().enumerate() {
            self.body(&mut svg, &view, index, body);
        }
        self.marks(&mut svg, &view);
        svg.push_str("</svg>\n");
        let bodies = self.geometry.bodies.iter().enumerate().map(|(index, body)| {
            format!(
                "<span><svg width=\"16\" height=\"10\" aria-hidden=\"true\"><rect width=\"16\" height=\"10\" rx=\"3\" \
                 fill=\"var(--series-{})\"/></svg>{}</span>",
                index % COLOURS,
                escape(&body.name)
            )
        });
        let legend = if self.geometry.bodies.len() <= 12 { bodies.collect() } else { String::new() };
        format!(
            "<figure class=\"drawing\"><div class=\"legend\">{legend}</div>\n{svg}{}\
             <script type=\"application/json\">{}</script>\n<figcaption>{}</figcaption></figure>",
            self.controls(),
            self.data(&view),
            self.caption
        )
    }

    /// All points that must be seen.
    fn extent(&self) -> Vec<[f64; 2]> {
        let geometry = self.geometry;
        let mut places: Vec<Place> =
            geometry.joints.iter().flat_map(|joint| [joint.first, joint.second]).collect();
        for (index, body) in geometry.bodies.iter().enumerate() {
            places
                .extend(drawn_points(geometry, index).into_iter().map(|at| Place { body: Some(index), at }));
            if let Outline::Disk { origin: [x, y], radius: r } = body.outline {
                let corners = [[x - r, y - r], [x + r, y + r], [x - r, y + r], [x + r, y - r]];
                places.extend(corners.map(|at| Place { body: Some(index), at }));
            }
        }
        self.frames.iter().flat_map(|frame| places.iter().map(|place| frame.point(*place))).collect()
    }

    /// Ground pins and rails.
    fn supports(&self, svg: &mut String, view: &View) {
        for joint in &self.geometry.joints {
            let axis = match joint.kind {
                Kind::Prismatic { axis } | Kind::PointOnLine { axis } => Some(axis),
                _ => None,
            };
            match (joint.first.body, joint.second.body, axis) {
                (None, _, Some(axis)) => self.rail(svg, view, joint.first.at, axis, joint.second),
                (None, _, None) => pin_support(svg, view.at(joint.first.at)),
                (_, None, _) => pin_support(svg, view.at(joint.second.at)),
                _ => {}
            }
        }
    }

    /// A rail on the ground, as long as what slides on it travels.
    fn rail(&self, svg: &mut String, view: &View, origin: [f64; 2], axis: [f64; 2], slides: Place) {
        let travel = self.frames.iter().map(|frame| {
            let [x, y] = frame.point(slides);
            (x - origin[0]) * axis[0] + (y - origin[1]) * axis[1]
        });
        let (least, most) = travel.fold((0f64, 0f64), |(a, b), s| (a.min(s), b.max(s)));
        let end = |s: f64| view.at([origin[0] + s * axis[0], origin[1] + s * axis[1]]);
        let beyond = 0.9 * MARGIN / view.scale;
        let ([ax, ay], [bx, by]) = (end(least - beyond), end(most + beyond));
        let length = (bx - ax).hypot(by - ay);
        let angle = (by - ay).atan2(bx - ax).to_degrees();
        let _ = writeln!(svg, "<g transform=\"translate({ax:.1} {ay:.1}) rotate({angle:.2})\">");
        for k in 0..(length / 14.0) as usize {
            let x = 14.0 * k as f64 + 12.0;
            let _ =
                writeln!(svg, "<line class=\"hatch\" x1=\"{x}\" y1=\"14\" x2=\"{}\" y2=\"23\"/>", x - 9.0);
        }
        let _ = writeln!(svg, "<line class=\"ground\" x1=\"0\" y1=\"14\" x2=\"{length:.1}\" y2=\"14\"/></g>");
    }

    fn paths(&self, svg: &mut String, view: &View) {
        for trace in &self.traces {
            let Some(place) = self.geometry.place(trace) else { continue };
            let points: Vec<String> = self
                .frames
                .iter()
                .map(|frame| view.at(frame.point(place)))
                .map(|[x, y]| format!("{x:.1},{y:.1}"))
                .collect();
            let _ = writeln!(
                svg,
                "<polyline class=\"trace\" stroke=\"{}\" points=\"{}\"/>",
                colour(place.body.unwrap_or(0)),
                points.join(" ")
            );
        }
    }

    fn body(&self, svg: &mut String, view: &View, index: usize, body: &Body) {
        let colour = colour(index);
        let _ = writeln!(svg, "<g data-body=\"{index}\" transform=\"{}\">", self.matrix(view, index));
        match body.outline {
            Outline::Disk { origin, radius } => {
                let ([x, y], r) = (view.local(origin), radius * view.scale);
                let _ = writeln!(
                    svg,
                    "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{r:.1}\" fill=\"{colour}\" fill-opacity=\".22\" \
                     stroke=\"{colour}\" stroke-width=\"3\"/><line x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{:.1}\" y2=\"{y:.1}\" \
                     stroke=\"{colour}\" stroke-width=\"2\"/>",
                    x + r
                );
            }
            Outline::Box { origin, width, height } => {
                let [x, y] = view.local(origin);
                let [w, h] = [width * view.scale, height * view.scale];
                rectangle(svg, [x - 0.5 * w, y - 0.5 * h, w, h], &colour, 0.0);
            }
            Outline::Particle => {
                let _ = writeln!(svg, "<circle r=\"11\" fill=\"{colour}\"/>");
            }
            Outline::None => {}
        }
        let points = drawn_points(self.geometry, index);
        match points.as_slice() {
            [] => {}
            // A body that is seen at one point only: the slider on its rail.
            [_] if matches!(body.outline, Outline::None) => {
                let angle = self.slides_along(index).map_or(0.0, |[x, y]| -y.atan2(x).to_degrees());
                rectangle(svg, [-34.0, -14.0, 68.0, 28.0], &colour, angle);
            }
            [_] => {}
            points => {
                let corners: Vec<[f64; 2]> = points.iter().map(|point| view.local(*point)).collect();
                link(svg, &corners, &colour);
            }
        }
        for [from, to] in &body.lines {
            let ([ax, ay], [bx, by]) = (view.local(*from), view.local(*to));
            let _ = writeln!(
                svg,
                "<line class=\"slot\" x1=\"{ax:.1}\" y1=\"{ay:.1}\" x2=\"{bx:.1}\" y2=\"{by:.1}\" stroke-width=\"{:.0}\"/>",
                0.45 * LINK
            );
        }
        let _ = writeln!(svg, "<circle class=\"mass\" r=\"2.6\"/></g>");
    }

    /// The direction in the body's own axes in which a prismatic joint lets it slide.
    fn slides_along(&self, body: usize) -> Option<[f64; 2]> {
        let frame = self.frames.first()?;
        let joint =
            self.geometry.joints.iter().find(|joint| {
                matches!(joint.kind, Kind::Prismatic { .. }) && joint.second.body == Some(body)
            })?;
        let Kind::Prismatic { axis } = joint.kind else { return None };
        let [x, y] = frame.direction(joint.first.body, axis);
        let [_, _, c, s] = frame.bodies[body];
        Some([c * x + s * y, c * y - s * x])
    }

    /// Pins and sliding blocks, drawn above the bodies.
    fn marks(&self, svg: &mut String, view: &View) {
        for joint in &self.geometry.joints {
            match joint.kind {
                Kind::PointOnLine { axis } => {
                    let turned = joint.first.body;
                    let [x, y] = view.local(axis);
                    let angle = y.atan2(x).to_degrees();
                    let block = format!(
                        "<rect class=\"block\" x=\"-17\" y=\"-10\" width=\"34\" height=\"20\" rx=\"3\" \
                         transform=\"rotate({angle:.2})\"/><circle class=\"pin\" r=\"5\"/>"
                    );
                    self.mark(svg, view, joint.second, turned, &block);
                }
                Kind::Revolute => {
                    // Both places: they are seen apart where a loop is not closed.
                    for place in [joint.first, joint.second] {
                        self.mark(svg, view, place, None, "<circle class=\"pin\" r=\"5.5\"/>");
                    }
                }
                Kind::Distance => {
                    for place in [joint.first, joint.second] {
                        self.mark(svg, view, place, None, "<circle class=\"pin\" r=\"4\"/>");
                    }
                }
                Kind::Prismatic { .. } | Kind::Fixed => {}
            }
        }
    }

    /// A mark at a place, turned like a body or upright.
    fn mark(&self, svg: &mut String, view: &View, place: Place, turned: Option<usize>, shape: &str) {
        let frame = &self.frames[0];
        let [x, y] = view.at(frame.point(place));
        let [c, s] = frame.direction(turned, [1.0, 0.0]);
        let number = |body: Option<usize>| body.map_or(-1, |body| body as i64);
        let [u, v] = if place.body.is_some() { view.local(place.at) } else { view.at(place.at) };
        let _ = writeln!(
            svg,
            "<g data-mark=\"{} {u:.2} {v:.2} {}\" transform=\"matrix({c:.5} {:.5} {s:.5} {c:.5} {x:.2} {y:.2})\">{shape}</g>",
            number(place.body),
            number(turned),
            -s
        );
    }

    fn matrix(&self, view: &View, body: usize) -> String {
        let [x, y, c, s] = self.frames[0].bodies[body];
        let [x, y] = view.at([x, y]);
        format!("matrix({c:.5} {:.5} {s:.5} {c:.5} {x:.2} {y:.2})", -s)
    }

    fn controls(&self) -> String {
        let speeds: String = self.speeds.iter().map(|speed| speed_choice(*speed)).collect();
        let readouts: String = self
            .readouts
            .iter()
            .map(|readout| {
                format!("<span>{} <b data-value>–</b> {}</span>", escape(readout.label), escape(readout.unit))
            })
            .collect();
        format!(
            "<div class=\"controls\"><button type=\"button\">Play</button>\
             <input type=\"range\" min=\"0\" max=\"{}\" value=\"0\" aria-label=\"time\">\
             <label>speed <select>{speeds}</select></label></div>\n\
             <div class=\"readouts\"><span>time <b data-clock>–</b> s</span>{readouts}</div>\n",
            self.frames.len() - 1
        )
    }

    /// Frames in the picture's units, and the texts beside them.
    fn data(&self, view: &View) -> String {
        let frames: Vec<String> = self
            .frames
            .iter()
            .map(|frame| {
                let mut text = format!("[{:.6}", frame.time);
                for [x, y, c, s] in &frame.bodies {
                    let [x, y] = view.at([*x, *y]);
                    let _ = write!(text, ",{x:.2},{y:.2},{c:.5},{s:.5}");
                }
                text + "]"
            })
            .collect();
        let readouts: Vec<String> =
            self.readouts.iter().map(|readout| format!("{:?}", readout.values)).collect();
        format!("{{\"frames\":[{}],\"readouts\":[{}]}}", frames.join(","), readouts.join(","))
    }
}

/// The points at which a body is drawn: those that joints use and those that have a name of their own, each once.
fn drawn_points(geometry: &Geometry, index: usize) -> Vec<[f64; 2]> {
    let body = &geometry.bodies[index];
    let joints = geometry.joints.iter().flat_map(|joint| [joint.first, joint.second]);
    let used = joints.filter(|place| place.body == Some(index)).map(|place| place.at);
    let named =
        body.points.iter().filter(|(name, _)| name != "center" && name != "origin").map(|(_, at)| *at);
    let mut points: Vec<[f64; 2]> = Vec::new();
    for at in named.chain(used) {
        if !points.iter().any(|[x, y]| (x - at[0]).hypot(y - at[1]) < 1e-12) {
            points.push(at);
        }
    }
    points
}

fn speed_choice(speed: f64) -> String {
    let label = if speed >= 1.0 { format!("{speed} ×") } else { format!("1/{:.0}", 1.0 / speed) };
    format!("<option value=\"{speed}\">{label}</option>")
}

fn colour(body: usize) -> String {
    format!("var(--series-{})", body % COLOURS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::baumgarte::ClosedLoop;

    #[test]
    fn a_drawing_shows_every_body_and_joint() {
        let geometry = Geometry::of(ClosedLoop::DEFINITION).unwrap();
        let start = ClosedLoop::START;
        let motions = ClosedLoop::<f64>::default().motions(0.0, &start.q, &start.v, &[0.0; 9]);
        let frames = vec![Frame::of(0.0, &motions), Frame::of(0.1, &motions)];
        let drawing = Drawing {
            geometry: &geometry,
            frames: &frames,
            traces: vec!["coupler.center"],
            readouts: Vec::new(),
            speeds: vec![1.0],
            caption: String::new(),
        };
        let figure = drawing.figure();
        assert_eq!(figure.matches("data-body=").count(), ClosedLoop::BODIES.len());
        assert_eq!(figure.matches("data-mark=").count(), 2 * ClosedLoop::JOINTS.len());
    }
}
