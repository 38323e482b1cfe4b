//! A picture that plays by itself, without a script: SVG whose paths change from frame to frame, for a README.

use super::animate::Film;
use super::short;
use linkwright_compiler::drawing_text::escaped;
use linkwright_compiler::page::magnified;
use linkwright_compiler::page::scene::{Lines, Scene, Shape, Spot, Surface, Wheel};
use std::fmt::Write;

/// Frames of the picture: few enough that it stays small.
const FRAMES: usize = 60;
const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 420.0;
const MARGIN: f64 = 36.0;
/// Radius of what is a mass and nothing else.
const DOT: f64 = 11.0;
const HUES: [&str; 6] = ["#1f6fd1", "#d1495b", "#2a9d6f", "#c77d0a", "#7a4fc4", "#4a5568"];

/// The world at one sample.
struct Moment<'f> {
    scene: &'f Scene,
    pose: &'f [f64],
}

impl Moment<'_> {
    fn place(&self, Spot { body, at, station }: Spot) -> [f64; 3] {
        let Some(body) = body else { return at };
        let [x, y, z] = match (&self.scene.bodies[body].lines, station) {
            (Some(lines), Some(station)) => lines.place(station, self.modes()),
            _ => at,
        };
        if self.scene.is_planar {
            let [px, py, c, s] = *self.of(body) else { return [0.0; 3] };
            return [px + c * x - s * y, py + s * x + c * y, z];
        }
        let [px, py, pz, turned @ ..] = self.of(body) else { return [0.0; 3] };
        let row = |k: usize| turned[3 * k] * x + turned[3 * k + 1] * y + turned[3 * k + 2] * z;
        [px + row(0), py + row(1), pz + row(2)]
    }

    fn of(&self, body: usize) -> &[f64] {
        let length = if self.scene.is_planar { 4 } else { 12 };
        &self.pose[body * length..(body + 1) * length]
    }

    fn modes(&self) -> &[f64] {
        &self.pose[self.pose.len() - self.scene.modes.len()..]
    }

    /// What a bar or plate is drawn through, or lines as they are bent.
    fn spots(&self, body: usize, shape: &Shape) -> Vec<[f64; 3]> {
        if let Some(Lines { counts, .. }) = &shape.lines {
            let bent = |station| Spot { body: Some(body), at: [0.0; 3], station: Some(station) };
            return (0..counts.iter().sum()).map(|station| self.place(bent(station))).collect();
        }
        let local = |at: &[f64; 3]| self.place(fixed(body, *at));
        let mut spots: Vec<[f64; 3]> = shape.spots.iter().map(local).collect();
        if spots.len() < 2 {
            spots.push(self.place(fixed(body, [0.0; 3])));
        }
        spots
    }
}

fn fixed(body: usize, at: [f64; 3]) -> Spot {
    Spot { body: Some(body), at, station: None }
}

/// From the world to the picture.
struct Eye {
    right: [f64; 3],
    rise: [f64; 3],
    scale: f64,
    shift: [f64; 2],
}

impl Eye {
    fn new(scene: &Scene, points: &[[f64; 3]]) -> Eye {
        let (right, rise) = directions(scene);
        let flat: Vec<[f64; 2]> = points.iter().map(|at| [dot(right, *at), -dot(rise, *at)]).collect();
        let least = [0, 1].map(|k| flat.iter().map(|at| at[k]).fold(f64::INFINITY, f64::min));
        let most = [0, 1].map(|k| flat.iter().map(|at| at[k]).fold(f64::NEG_INFINITY, f64::max));
        let fit = |k: usize, room: f64| (room - 2.0 * MARGIN) / (most[k] - least[k]).max(1e-9);
        let scale = fit(0, WIDTH).min(fit(1, HEIGHT));
        let shift = [0, 1].map(|k| [WIDTH, HEIGHT][k] / 2.0 - scale * (least[k] + most[k]) / 2.0);
        Eye { right, rise, scale, shift }
    }

    fn spot(&self, at: [f64; 3]) -> [f64; 2] {
        [self.shift[0] + self.scale * dot(self.right, at), self.shift[1] - self.scale * dot(self.rise, at)]
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// To the right and upwards, of the eye of the drawing at the start.
fn directions(scene: &Scene) -> ([f64; 3], [f64; 3]) {
    if scene.is_planar {
        return ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    }
    let up = scene.up;
    let a = if up[0].abs() > 0.5 { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] };
    let b = cross(up, a);
    let (azimuth, height) = (-1.01_f64, 0.44_f64);
    let out = [0, 1, 2].map(|k| azimuth.cos() * a[k] + azimuth.sin() * b[k]);
    let toward = [0, 1, 2].map(|k| height.cos() * out[k] + height.sin() * up[k]);
    let right = cross(up, out);
    (right, cross(toward, right))
}

/// One path of the picture, the same number of corners in every frame, drawn with one style over the other.
struct Moving {
    frames: Vec<String>,
    styles: Vec<String>,
}

impl Moving {
    fn new(moments: &[Moment], style: String, frame: impl Fn(&Moment) -> String) -> Moving {
        Moving { frames: moments.iter().map(frame).collect(), styles: vec![style] }
    }
}

/// The picture; the motion has `speed` times its speed.
pub fn picture(name: &str, film: &Film, speed: f64) -> String {
    let (scene, times) = (&film.scene, &film.run.trajectory.times);
    let count = film.poses.len();
    let frames = FRAMES.min(count).max(1);
    let chosen: Vec<usize> = (0..frames).map(|k| k * (count - 1) / (frames - 1).max(1)).collect();
    let moments: Vec<Moment> = chosen.iter().map(|k| Moment { scene, pose: &film.poses[*k] }).collect();
    let mut points: Vec<[f64; 3]> = Vec::new();
    for moment in &moments {
        for (index, body) in scene.bodies.iter().enumerate() {
            points.extend(moment.spots(index, body));
            if !matches!(body.outline, "bar" | "lines") {
                let [x, y, z] = moment.place(fixed(index, [0.0; 3]));
                let r = if body.outline == "box" {
                    0.5 * body.lengths.iter().map(|x| x * x).sum::<f64>().sqrt()
                } else {
                    body.lengths[0]
                };
                points.extend([[x - r, y - r, z], [x + r, y + r, z]]);
            }
        }
        let rims = scene.wheels.iter().flat_map(|wheel| rim(wheel.center, wheel.about, wheel.radius, 8));
        points.extend(rims.map(|spot| moment.place(spot)));
        let of_surfaces = scene.surfaces.iter().flat_map(|it| it.lines.iter().flatten());
        points.extend(of_surfaces.map(|spot| moment.place(*spot)));
        points.extend(scene.joints.iter().map(|joint| moment.place(joint.second)));
        points.extend(scene.loads.iter().flat_map(|load| load.ends.iter().map(|end| moment.place(*end))));
    }
    let eye = Eye::new(scene, &points);
    let mut paths: Vec<Moving> = scene.surfaces.iter().map(|it| surface(&eye, &moments, it)).collect();
    for (index, body) in scene.bodies.iter().enumerate() {
        shapes(&mut paths, &eye, &moments, index, body);
    }
    paths.extend(scene.wheels.iter().map(|wheel| pitch_circle(&eye, &moments, wheel)));
    for load in scene.loads.iter().filter(|load| load.ends.len() > 1) {
        let style = "fill=\"none\" stroke=\"#c4601c\" stroke-width=\"1.6\"".to_string();
        let frame = |moment: &Moment| {
            let ends: Vec<[f64; 2]> = load.ends.iter().map(|end| eye.spot(moment.place(*end))).collect();
            if load.kind.contains("spring") && ends.len() == 2 {
                coil(ends[0], ends[1])
            } else {
                path(&ends, false)
            }
        };
        paths.push(Moving::new(&moments, style, frame));
    }
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\">\n\
         <title>{}, in motion{}</title>\n\
         <style>svg{{--ink:#1b2330;--paper:#fff}}@media(prefers-color-scheme:dark){{svg{{--ink:#e4e9f0;--paper:#12161d}}}}\
         path,circle{{stroke-linecap:round;stroke-linejoin:round}}</style>\n\
         <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" rx=\"12\" fill=\"var(--paper)\"/>\n",
        escaped(name),
        if speed == 1.0 { String::new() } else { format!(" at {} times its speed", short(speed)) }
    );
    grounds(&mut svg, &eye, &moments);
    let passed = times.last().copied().unwrap_or_default() - times.first().copied().unwrap_or_default();
    let duration = (passed / speed).max(0.1);
    for (index, Moving { frames, styles }) in paths.iter().enumerate() {
        if let [style] = &styles[..] {
            let _ = write!(svg, "<path d=\"{}\" {style}>", frames[0]);
            animated(&mut svg, "d", frames, duration);
            svg.push_str("</path>\n");
            continue;
        }
        let _ = write!(svg, "<defs><path id=\"p{index}\" d=\"{}\">", frames[0]);
        animated(&mut svg, "d", frames, duration);
        svg.push_str("</path></defs>\n");
        for style in styles {
            let _ = writeln!(svg, "<use href=\"#p{index}\" {style}/>");
        }
    }
    for joint in &scene.joints {
        let spots: Vec<[f64; 2]> =
            moments.iter().map(|moment| eye.spot(moment.place(joint.second))).collect();
        let _ = write!(
            svg,
            "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"4.5\" fill=\"var(--paper)\" stroke=\"var(--ink)\" stroke-width=\"1.8\">",
            spots[0][0], spots[0][1]
        );
        for (k, name) in ["cx", "cy"].iter().enumerate() {
            animated(
                &mut svg,
                name,
                &spots.iter().map(|spot| format!("{:.1}", spot[k])).collect::<Vec<_>>(),
                duration,
            );
        }
        svg.push_str("</circle>\n");
    }
    if scene.times != 1.0 {
        let _ = writeln!(
            svg,
            "<text x=\"{}\" y=\"{}\" text-anchor=\"end\" font-family=\"sans-serif\" font-size=\"12\" fill=\"var(--ink)\">{}</text>",
            WIDTH - 14.0,
            HEIGHT - 14.0,
            magnified(scene.times)
        );
    }
    svg.push_str("</svg>\n");
    svg
}

/// The values of an attribute over the duration, again and again; none if they are all the same.
fn animated(svg: &mut String, attribute: &str, frames: &[String], duration: f64) {
    if frames.iter().all(|frame| *frame == frames[0]) {
        return;
    }
    let values = frames.join(";");
    let _ = write!(
        svg,
        "<animate attributeName=\"{attribute}\" dur=\"{duration:.3}s\" repeatCount=\"indefinite\" values=\"{values}\"/>"
    );
}

/// Places on the circle about an axis; the first along x where the axis is z.
fn rim(center: Spot, about: [f64; 3], radius: f64, count: u32) -> impl Iterator<Item = Spot> {
    // Across the axis: with the coordinate that it has least of.
    let least = (0..3).rev().min_by(|a, b| about[*a].abs().total_cmp(&about[*b].abs())).unwrap_or_default();
    let mut aside = [0.0; 3];
    aside[least] = 1.0;
    let first = cross(aside, about);
    let size = dot(first, first).sqrt().max(1e-12);
    let first = first.map(|x| x / size);
    let second = cross(about, first);
    (0..count).map(move |k| {
        let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / f64::from(count)).sin_cos();
        let at = [0, 1, 2].map(|k| center.at[k] + radius * (cos * first[k] + sin * second[k]));
        Spot { at, ..center }
    })
}

/// What is round, with a radius that shows how it turns.
fn round(eye: &Eye, moment: &Moment, center: Spot, about: [f64; 3], radius: f64) -> String {
    let count = if moment.scene.is_planar { 1 } else { 28 };
    let spots = rim(center, about, radius, count).map(|spot| eye.spot(moment.place(spot)));
    let (spots, center) = (spots.collect::<Vec<_>>(), eye.spot(moment.place(center)));
    if moment.scene.is_planar {
        return circle(center, spots[0]);
    }
    path(&spots, true) + &path(&[center, spots[0]], false)
}

fn surface(eye: &Eye, moments: &[Moment], surface: &Surface) -> Moving {
    let style = "fill=\"none\" stroke=\"var(--ink)\" stroke-opacity=\"0.7\" stroke-width=\"1.2\"";
    let frame = |moment: &Moment| {
        let line = |line: &Vec<Spot>| {
            let spots: Vec<[f64; 2]> = line.iter().map(|spot| eye.spot(moment.place(*spot))).collect();
            path(&spots, false)
        };
        surface.lines.iter().map(line).collect()
    };
    Moving::new(moments, style.to_string(), frame)
}

fn pitch_circle(eye: &Eye, moments: &[Moment], wheel: &Wheel) -> Moving {
    let style = "fill=\"none\" stroke=\"var(--ink)\" stroke-opacity=\"0.6\" stroke-width=\"1.2\"";
    let frame = |moment: &Moment| round(eye, moment, wheel.center, wheel.about, wheel.radius);
    Moving::new(moments, style.to_string(), frame)
}

/// Bars between spots, and declared shapes.
fn shapes(paths: &mut Vec<Moving>, eye: &Eye, moments: &[Moment], index: usize, body: &Shape) {
    let hue = HUES[index % HUES.len()];
    let filled = |opacity: f64| {
        format!("fill=\"{hue}\" fill-opacity=\"{opacity}\" stroke=\"var(--ink)\" stroke-width=\"1.4\"")
    };
    match (body.outline, &body.lengths[..]) {
        ("disk" | "ball", [radius, ..]) => {
            let center = fixed(index, [0.0; 3]);
            let frame = |moment: &Moment| round(eye, moment, center, [0.0, 0.0, 1.0], *radius);
            paths.push(Moving::new(moments, filled(0.2), frame));
            return;
        }
        ("box", [a, b, ..]) => {
            let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
            let corners = corners.map(|[x, y]| fixed(index, [x * a / 2.0, y * b / 2.0, 0.0]));
            let frame = |moment: &Moment| path(&corners.map(|at| eye.spot(moment.place(at))), true);
            paths.push(Moving::new(moments, filled(0.2), frame));
            return;
        }
        _ => {}
    }
    let spots = |moment: &Moment| -> Vec<[f64; 2]> {
        moment.spots(index, body).iter().map(|spot| eye.spot(*spot)).collect()
    };
    if body.lines.is_none() && body.spots.iter().all(|at| at.iter().all(|x| *x == 0.0)) {
        // A mass and nothing else: a dot of one size, with a radius where it turns in the plane.
        let frame = |moment: &Moment| {
            let place = |at: [f64; 3]| eye.spot(moment.place(fixed(index, at)));
            let center = place([0.0; 3]);
            let along =
                if moment.scene.is_planar { place([1.0, 0.0, 0.0]) } else { [center[0] + 1.0, center[1]] };
            let size = (along[0] - center[0]).hypot(along[1] - center[1]).max(1e-9);
            circle(center, [0, 1].map(|k| center[k] + DOT * (along[k] - center[k]) / size))
        };
        paths.push(Moving::new(moments, filled(0.3), frame));
        return;
    }
    let outline = |corners: Vec<[f64; 2]>| match &body.lines {
        Some(lines) => {
            let mut rest = &corners[..];
            let line = |count: &usize| {
                let (line, after) = rest.split_at(*count);
                rest = after;
                path(line, false)
            };
            lines.counts.iter().map(line).collect()
        }
        None => path(&corners, corners.len() > 2),
    };
    let frames: Vec<String> = moments.iter().map(|moment| outline(spots(moment))).collect();
    let strokes = [(11.0, "var(--ink)", 1.0), (8.4, "var(--paper)", 1.0), (8.4, hue, 0.35)];
    let styles = strokes.map(|(width, colour, opacity)| {
        format!("fill=\"none\" stroke=\"{colour}\" stroke-opacity=\"{opacity}\" stroke-width=\"{width}\"")
    });
    paths.push(Moving { frames, styles: styles.to_vec() });
}

/// A line from corner to corner.
fn path(points: &[[f64; 2]], closed: bool) -> String {
    let mut path = String::new();
    for (k, [x, y]) in points.iter().enumerate() {
        let _ = write!(path, "{}{x:.1} {y:.1}", if k == 0 { 'M' } else { 'L' });
    }
    if closed {
        path.push('Z');
    }
    path
}

/// About a centre through a place, with the radius to it. The arcs do not turn, so that they stay arcs between frames.
fn circle(center: [f64; 2], rim: [f64; 2]) -> String {
    let ([x, y], [a, b]) = (center, rim);
    let r = (a - x).hypot(b - y);
    let (left, right) = (x - r, x + r);
    format!(
        "M{left:.1} {y:.1}A{r:.1} {r:.1} 0 1 1 {right:.1} {y:.1}A{r:.1} {r:.1} 0 1 1 {left:.1} {y:.1}M{x:.1} {y:.1}L{a:.1} {b:.1}"
    )
}

/// As many turns at any length.
fn coil(a: [f64; 2], b: [f64; 2]) -> String {
    let way = [b[0] - a[0], b[1] - a[1]];
    let length = way[0].hypot(way[1]).max(1e-9);
    let at = |share: f64, aside: f64| {
        [a[0] + share * way[0] - aside * way[1] / length, a[1] + share * way[1] + aside * way[0] / length]
    };
    let mut points = vec![a, at(0.1, 0.0)];
    points.extend((1..16).map(|k| at(0.1 + 0.05 * f64::from(k), if k % 2 == 0 { 6.0 } else { -6.0 })));
    points.extend([at(0.9, 0.0), b]);
    path(&points, false)
}

/// Triangles where the ground holds something.
fn grounds(svg: &mut String, eye: &Eye, moments: &[Moment]) {
    let Some(first) = moments.first() else { return };
    for joint in &first.scene.joints {
        let held = [joint.first, joint.second].into_iter().find(|spot| spot.body.is_none());
        let Some(held) = held.filter(|_| !joint.slides) else { continue };
        let [x, y] = eye.spot(first.place(held));
        let _ = writeln!(
            svg,
            "<path d=\"M{x:.1} {y:.1}l-10 17h20zm-16 17h32\" fill=\"none\" stroke=\"var(--ink)\" stroke-opacity=\"0.7\" stroke-width=\"1.5\"/>"
        );
    }
}
