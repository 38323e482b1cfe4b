//! The shapes of which a drawing consists, as SVG in the picture's units (y downwards).
//!
//! Knows nothing of mechanisms; what is drawn where is decided in `drawing.rs`.

use std::fmt::Write;

/// Width of a link.
pub const LINK: f64 = 15.0;

/// A link: a bar between two points, a plate through more.
pub fn link(svg: &mut String, points: &[[f64; 2]], colour: &str) {
    let corners: Vec<String> =
        convex_hull(points).into_iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
    let _ = writeln!(
        svg,
        "<polygon points=\"{}\" fill=\"{colour}\" fill-opacity=\".3\" stroke=\"{colour}\" stroke-width=\"{LINK}\" \
         stroke-linejoin=\"round\"/>",
        corners.join(" ")
    );
}

/// The corners of the convex hull in order (Andrew's monotone chain); both ends for points in line.
fn convex_hull(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let chain = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..]
                && (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]) <= 1e-12
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = chain(&mut sorted.iter().copied());
    hull.extend(chain(&mut sorted.iter().rev().copied()));
    hull
}

/// A box by its corner, width and height, turned about the origin by an angle in degrees.
pub fn rectangle(svg: &mut String, [x, y, width, height]: [f64; 4], colour: &str, angle: f64) {
    let _ = writeln!(
        svg,
        "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" rx=\"4\" fill=\"{colour}\" \
         fill-opacity=\".3\" stroke=\"{colour}\" stroke-width=\"3\" transform=\"rotate({angle:.2})\"/>"
    );
}

/// A pin on the ground: a triangle on a hatched line.
pub fn pin_support(svg: &mut String, [x, y]: [f64; 2]) {
    let _ = writeln!(
        svg,
        "<g transform=\"translate({x:.1} {y:.1})\"><path class=\"ground\" d=\"M0 0L-13 21H13ZM-21 21H21\"/>"
    );
    for k in 0..5 {
        let x = -15 + 9 * k;
        let _ = writeln!(svg, "<line class=\"hatch\" x1=\"{x}\" y1=\"21\" x2=\"{}\" y2=\"29\"/>", x - 8);
    }
    svg.push_str("</g>\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_of_points_in_line_has_two_corners() {
        assert_eq!(convex_hull(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]).len(), 2);
        assert_eq!(convex_hull(&[[0.0, 0.0], [1.0, 0.2], [2.0, 0.0], [1.0, 2.0]]).len(), 3);
    }
}
