//! Curves over a common axis, panels one above the other, as an SVG file in the target directory. Knows nothing of mechanisms.

use plotters::prelude::*;
use std::error::Error;
use std::path::PathBuf;

/// Curves in one diagram.
pub struct Panel {
    /// Of the vertical axis, with its unit.
    pub label: &'static str,
    pub curves: Vec<Curve>,
}

pub struct Curve {
    pub label: &'static str,
    pub points: Vec<(f64, f64)>,
}

const WIDTH: u32 = 900;
const HEIGHT: u32 = 300;
const COLOURS: [RGBColor; 5] = [
    RGBColor(33, 102, 172),
    RGBColor(178, 24, 43),
    RGBColor(27, 120, 55),
    RGBColor(118, 42, 131),
    RGBColor(140, 90, 20),
];

/// Writes `name`.svg, or the file that the first argument of the program names, and gives its path.
pub fn draw(name: &str, title: &str, horizontal: &str, panels: &[Panel]) -> Result<PathBuf, Box<dyn Error>> {
    let file =
        std::env::args().nth(1).map_or_else(|| crate::in_target(&format!("{name}.svg")), PathBuf::from);
    let mut svg = String::new();
    {
        let root =
            SVGBackend::with_string(&mut svg, (WIDTH, 40 + HEIGHT * panels.len() as u32)).into_drawing_area();
        root.fill(&WHITE)?;
        let areas = root.titled(title, ("sans-serif", 20))?.split_evenly((panels.len(), 1));
        for (panel, area) in panels.iter().zip(&areas) {
            let points = || panel.curves.iter().flat_map(|curve| &curve.points);
            let (x, y) =
                (range(points().map(|point| point.0), 0.0), range(points().map(|point| point.1), 0.06));
            let mut chart = ChartBuilder::on(area)
                .margin(10)
                .margin_right(20)
                .x_label_area_size(40)
                .y_label_area_size(80)
                .build_cartesian_2d(x, y)?;
            let mesh = &mut chart.configure_mesh();
            mesh.max_light_lines(0)
                .x_desc(horizontal)
                .y_desc(panel.label)
                .label_style(("sans-serif", 14))
                .draw()?;
            for (index, curve) in panel.curves.iter().enumerate() {
                let style = ShapeStyle::from(COLOURS[index % COLOURS.len()]).stroke_width(2);
                let drawn = chart.draw_series(LineSeries::new(curve.points.iter().copied(), style))?;
                drawn.label(curve.label).legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], style));
            }
            let legend = &mut chart.configure_series_labels();
            legend
                .background_style(WHITE.mix(0.8))
                .border_style(BLACK.mix(0.3))
                .label_font(("sans-serif", 14))
                .draw()?;
        }
        root.present()?;
    }
    std::fs::write(&file, svg)?;
    Ok(file)
}

fn range(values: impl Iterator<Item = f64>, margin: f64) -> std::ops::Range<f64> {
    let (least, most) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), value| (a.min(value), b.max(value)));
    let margin = margin * (most - least).max(1e-12);
    least - margin..most + margin
}
