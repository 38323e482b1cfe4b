//! Plots of curves over a common axis, as inline SVG with a legend beside it in HTML.
//!
//! Drawn by the crate `plotters` in colours that stand for roles; these are then replaced by the variables of the page's
//! style sheet, so that a plot follows the page from light to dark. Knows nothing of mechanisms.

use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::prelude::*;
use std::error::Error;
use std::ops::Range;

/// A diagram with one or more curves.
pub struct Plot {
    pub title: String,
    /// What is seen in it, a sentence in HTML.
    pub caption: String,
    pub x: Axis,
    pub y: Axis,
    pub curves: Vec<Curve>,
}

/// What an axis shows, and how.
pub struct Axis {
    /// With its unit.
    pub label: &'static str,
    pub logarithmic: bool,
}

/// One curve and the number of its colour in the page's palette.
pub struct Curve {
    pub label: String,
    pub colour: usize,
    pub dashed: bool,
    pub points: Vec<(f64, f64)>,
}

impl Axis {
    /// A linear axis that spans the curves.
    pub fn linear(label: &'static str) -> Axis {
        Axis { label, logarithmic: false }
    }

    /// A logarithmic axis that spans the curves.
    pub fn logarithmic(label: &'static str) -> Axis {
        Axis { label, logarithmic: true }
    }
}

/// Colours in the palette of the page.
pub const COLOURS: usize = 6;

/// Picture units in one unit of the page: the backend rounds to whole units, so these are fine ones.
const FINE: u32 = 8;
const WIDTH: u32 = 580 * FINE;
const HEIGHT: u32 = 320 * FINE;
/// Roles, in the order of the CSS variables they become.
const INK: RGBColor = RGBColor(1, 2, 3);
const GRID: RGBColor = RGBColor(1, 2, 4);
const FAINT: RGBColor = RGBColor(1, 2, 5);

impl Plot {
    /// The plot as an HTML figure.
    pub fn figure(&self) -> Result<String, Box<dyn Error>> {
        let legend: String = self.curves.iter().map(legend_entry).collect();
        Ok(format!(
            "<figure class=\"plot\"><h3>{}</h3><div class=\"legend\">{legend}</div>{}<figcaption>{}</figcaption></figure>\n",
            self.title,
            self.svg()?,
            self.caption
        ))
    }

    /// The plot as an SVG element that takes its colours from the page.
    pub fn svg(&self) -> Result<String, Box<dyn Error>> {
        let (x, y) = (self.range(&self.x, |point| point.0), self.range(&self.y, |point| point.1));
        let mut svg = String::new();
        {
            let root = SVGBackend::with_string(&mut svg, (WIDTH, HEIGHT)).into_drawing_area();
            if self.y.logarithmic {
                self.draw(&root, x, y.log_scale())?;
            } else {
                self.draw(&root, x, y)?;
            }
            root.present()?;
        }
        Ok(themed(&svg))
    }

    fn draw<Y>(
        &self,
        root: &DrawingArea<SVGBackend, plotters::coord::Shift>,
        x: Range<f64>,
        y: Y,
    ) -> Result<(), Box<dyn Error>>
    where
        Y: AsRangedCoord<Value = f64>,
        Y::CoordDescType: ValueFormatter<f64>,
    {
        let mut chart = ChartBuilder::on(root)
            .margin(4 * FINE)
            .margin_top(12 * FINE)
            .margin_right(14 * FINE)
            .x_label_area_size(46 * FINE)
            .y_label_area_size(86 * FINE)
            .build_cartesian_2d(x, y)?;
        let label = ("sans-serif", 20 * FINE).into_font().color(&INK);
        let exponents = self.y.logarithmic;
        chart
            .configure_mesh()
            .x_labels(9)
            .y_labels(8)
            .max_light_lines(0)
            .set_all_tick_mark_size(4 * FINE)
            .bold_line_style(ShapeStyle::from(GRID).stroke_width(FINE))
            .light_line_style(TRANSPARENT)
            .axis_style(ShapeStyle::from(FAINT).stroke_width(FINE))
            .x_desc(self.x.label)
            .y_desc(self.y.label)
            .label_style(label.clone())
            .axis_desc_style(label)
            .x_label_formatter(&|value| tick(*value))
            .y_label_formatter(&|value| if exponents { power_of_ten(*value) } else { tick(*value) })
            .draw()?;
        for curve in &self.curves {
            let style = ShapeStyle::from(colour(curve.colour)).stroke_width(2 * FINE);
            // A logarithm has no place for zero: the curve is interrupted there.
            let drawn = |point: &&(f64, f64)| !self.y.logarithmic || point.1 > 0.0;
            let points = curve.points.iter().filter(drawn).copied();
            if curve.dashed {
                chart.draw_series(DashedLineSeries::new(points, 6 * FINE, 4 * FINE, style))?;
            } else {
                chart.draw_series(LineSeries::new(points, style))?;
            }
        }
        Ok(())
    }

    /// The range of an axis on which all curves fit.
    fn range(&self, axis: &Axis, of: impl Fn(&(f64, f64)) -> f64) -> Range<f64> {
        let values = self.curves.iter().flat_map(|curve| &curve.points).map(of);
        let values = values.filter(|value| value.is_finite() && (!axis.logarithmic || *value > 0.0));
        let (least, most) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), value| (a.min(value), b.max(value)));
        if least > most {
            return if axis.logarithmic { 1e-1..1e1 } else { 0.0..1.0 };
        }
        if axis.logarithmic {
            return 10f64.powf(least.log10().floor())..10f64.powf(most.log10().ceil());
        }
        // A horizontal axis ends where its curves end.
        let margin = if std::ptr::eq(axis, &self.x) { 0.0 } else { 0.06 * (most - least).max(1e-12) };
        least - margin..most + margin
    }
}

fn legend_entry(curve: &Curve) -> String {
    let dash = if curve.dashed { " stroke-dasharray=\"6 4\"" } else { "" };
    format!(
        "<span><svg width=\"26\" height=\"10\" aria-hidden=\"true\"><line x1=\"1\" y1=\"5\" x2=\"25\" y2=\"5\" \
         stroke=\"var(--series-{})\" stroke-width=\"3\"{dash}/></svg>{}</span>",
        curve.colour % COLOURS,
        curve.label
    )
}

/// The colour that stands for one of the palette.
fn colour(index: usize) -> RGBColor {
    RGBColor(2, 2, (index % COLOURS) as u8)
}

/// Replaces the colours that stand for roles by the page's variables, and lets the picture take the page's width.
fn themed(svg: &str) -> String {
    let hex = |RGBColor(r, g, b): RGBColor| format!("#{r:02X}{g:02X}{b:02X}");
    let roles =
        [(INK, "var(--ink)".to_string()), (GRID, "var(--grid)".into()), (FAINT, "var(--faint)".into())];
    let series = (0..COLOURS).map(|index| (colour(index), format!("var(--series-{index})")));
    let themed = roles
        .into_iter()
        .chain(series)
        .fold(svg.to_string(), |svg, (role, variable)| svg.replace(&hex(role), &variable));
    let size = format!("width=\"{WIDTH}\" height=\"{HEIGHT}\" ");
    themed.replacen(&size, "role=\"img\" ", 1)
}

/// A number as short as it can be written without loss at an axis.
fn tick(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    format!("{}", if rounded == 0.0 { 0.0 } else { rounded }).replace('-', "−")
}

fn power_of_ten(value: f64) -> String {
    let exponent = value.log10().round() as i32;
    let digits: String = exponent
        .to_string()
        .chars()
        .map(|digit| match digit {
            '-' => '⁻',
            digit => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize - '0' as usize],
        })
        .collect();
    format!("10{digits}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_logarithmic_plot_spans_whole_decades_and_skips_zero() {
        let curve = Curve {
            label: "a".into(),
            colour: 0,
            dashed: false,
            points: vec![(0.0, 0.0), (1.0, 3e-7), (2.0, 2e-4)],
        };
        let plot = Plot {
            title: "t".into(),
            caption: String::new(),
            x: Axis::linear("x"),
            y: Axis::logarithmic("y"),
            curves: vec![curve],
        };
        let range = plot.range(&plot.y, |point| point.1);
        assert!((range.start / 1e-7 - 1.0).abs() < 1e-9 && (range.end / 1e-3 - 1.0).abs() < 1e-9);
        let svg = plot.svg().unwrap();
        assert!(svg.contains("var(--series-0)") && svg.contains("var(--ink)"));
        assert_eq!(power_of_ten(1e-12), "10⁻¹²");
    }
}
