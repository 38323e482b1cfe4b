//! Beams whose sections shear: what their shapes take of the section and the material, and how much of a section carries shear.
//!
//! Without `shear_factor` this is Cowper's (J. Appl. Mech. 33, 1966), with Poisson's ratio ν = E/(2 G) − 1 and m the ratio of the diameters:
//!   rectangle  10 (1 + ν)/(12 + 11 ν),   circle  6 (1 + ν)/(7 + 6 ν),
//!   tube       6 (1 + ν) (1 + m²)²/((7 + 6 ν) (1 + m²)² + (20 + 12 ν) m²).

use crate::beams::{Beyond, Counts, Shapes, Slender, Thick};
use crate::forms::second_moments;
use crate::messages;
use crate::model::lower::{Lowering, Use};
use crate::model::{Expr, Space, fold};
use crate::syntax;
use crate::units::Dimension;

impl<'d> Lowering<'d> {
    /// The shapes of a beam that shears; said where something is missing.
    pub(super) fn thick(&mut self, body: &'d syntax::Body, length: f64, counts: Counts) -> Option<Slender> {
        let (name, space) = (&body.name.text, self.definition.space);
        let shapes = body.beam.shapes();
        if shapes == Shapes::Static {
            let region = body.beam.theory.as_ref().map_or(body.name.region, |(label, _)| label.region);
            self.diagnostics.error(region, messages::thick_and_static(name));
            return None;
        }
        let [young, shear] = ["young", "shear_modulus"].map(|property| {
            let value = self.positive_of_beam(body, property, Dimension::PRESSURE, "GPa")?;
            self.known_of_thick(body, property, &value)
        });
        let section = self.section(body);
        let (young, shear, section) = (young?, shear?, section?);
        let words = second_moments(space);
        let moments = [(words[0], &section.about_z), (words[words.len() - 1], &section.about_y)];
        let area = self.known_of_thick(body, "area", &section.area);
        let [about_z, about_y] = moments.map(|(word, moment)| self.known_of_thick(body, word, moment));
        let (area, about_z, about_y) = (area?, about_z?, about_y?);
        let factor = self.shear_factor(body, young / (2.0 * shear) - 1.0)?;
        let softness = young / (factor * shear);
        // What is not there in the plane is asked for nothing.
        let about_y = if space == Space::Planar { about_z } else { about_y };
        let thick = [about_z, about_y].map(|moment| Thick { gyration: moment / area, softness });
        match Slender::thick(shapes, length, counts, thick) {
            Ok(slender) => Some(slender),
            Err(Beyond { way, below }) => {
                let region = body.beam.modes.as_ref().map_or(body.name.region, |modes| modes.region);
                let message = messages::beyond_cut_off(name, way.word(space), counts.of(way), below);
                self.diagnostics.error(region, message);
                None
            }
        }
    }

    /// A value that shapes depend on.
    fn known_of_thick(&mut self, body: &'d syntax::Body, property: &str, value: &Expr) -> Option<f64> {
        if let Expr::Number(value) = value {
            return Some(*value);
        }
        let written = body.property(property).map(|(label, _)| label.region);
        let section = body.beam.section.as_ref().map(|section| section.kind.region);
        let region = written.or(section).unwrap_or(body.name.region);
        let property = if written.is_some() { property } else { "section" };
        self.diagnostics.error(region, messages::thick_not_known(&body.name.text, property));
        None
    }

    /// κ, as written or of the section.
    fn shear_factor(&mut self, body: &'d syntax::Body, poisson: f64) -> Option<f64> {
        const WORD: &str = "shear_factor";
        let name = &body.name.text;
        if let Some((_, entry)) = body.property(WORD) {
            let value = self.entry(entry, Dimension::ONE, Use::PROPERTY, WORD)?;
            let factor = self.known_of_thick(body, WORD, &value)?;
            if factor > 0.0 && factor <= 1.0 {
                return Some(factor);
            }
            self.diagnostics.error(entry.value.region, messages::shear_factor_out_of_range(name, factor));
            return None;
        }
        let Some(section) = &body.beam.section else {
            self.diagnostics.error(body.name.region, messages::shear_factor_missing(name));
            return None;
        };
        if !(-1.0..=0.5).contains(&poisson) {
            self.diagnostics.error(body.name.region, messages::not_isotropic(name, poisson));
            return None;
        }
        let mut ratio = 0.0;
        if section.kind.text == "tube" {
            let mut diameter = |wanted: &str| {
                let (label, entry) = section.lengths.iter().find(|(label, _)| label.text == wanted)?;
                let value = self.entry(entry, Dimension::LENGTH, Use::PROPERTY, &label.text)?;
                fold::evaluate(&value, self.defaults())
            };
            ratio = diameter("inner")? / diameter("outer")?;
        }
        Some(match section.kind.text.as_str() {
            "rectangle" => 10.0 * (1.0 + poisson) / (12.0 + 11.0 * poisson),
            _ => {
                let square = ratio * ratio;
                let both = (1.0 + square).powi(2);
                6.0 * (1.0 + poisson) * both
                    / ((7.0 + 6.0 * poisson) * both + (20.0 + 12.0 * poisson) * square)
            }
        })
    }
}
