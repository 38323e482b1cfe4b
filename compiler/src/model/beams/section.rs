//! Cross-sections of beams: of a shape with its lengths, or as their integrals are written.

use super::times;
use crate::forms::second_moments;
use crate::messages;
use crate::model::lower::{Lowering, Use};
use crate::model::{Expr, Function1, Function2, Space, fold};
use crate::syntax;
use crate::units::Dimension;
use std::f64::consts::PI;

/// A cross-section: m², m⁴ about z and about y, and Saint-Venant's torsion constant J_t, m⁴.
pub(super) struct Section {
    pub area: Expr,
    pub about_z: Expr,
    pub about_y: Expr,
    pub torsion: Expr,
}

impl<'d> Lowering<'d> {
    /// Of the section, or as written.
    pub(super) fn section(&mut self, body: &'d syntax::Body) -> Option<Section> {
        let name = &body.name.text;
        let space = self.definition.space;
        let words = ["area"].iter().chain(second_moments(space)).chain(&["torsion_constant"]);
        let written = words.into_iter().find_map(|property| body.property(property));
        let Some(section) = &body.beam.section else {
            if written.is_none() {
                self.diagnostics.error(body.name.region, messages::beam_without_section(name, space));
                return None;
            }
            let area = self.positive_of_beam(body, "area", Dimension::AREA, "mm^2");
            let mut moments = second_moments(space)
                .iter()
                .map(|word| self.positive_of_beam(body, word, Dimension::SECOND_MOMENT, "mm^4"))
                .collect::<Vec<_>>()
                .into_iter();
            let about_z = moments.next().flatten();
            let about_y = moments.next().unwrap_or(Some(Expr::Number(0.0)));
            let torsion = if body.beam.counts(space).torsion > 0 {
                self.positive_of_beam(body, "torsion_constant", Dimension::SECOND_MOMENT, "mm^4")
            } else {
                Some(Expr::Number(0.0))
            };
            return Some(Section { area: area?, about_z: about_z?, about_y: about_y?, torsion: torsion? });
        };
        if let Some((label, _)) = written {
            let message = messages::section_and_property(name, &label.text);
            let note = messages::property_here("section");
            self.diagnostics.conflict(label.region, message, section.kind.region, note);
            return None;
        }
        let mut lengths = Vec::new();
        for (label, entry) in &section.lengths {
            let length = self.entry(entry, Dimension::LENGTH, Use::PROPERTY, &label.text)?;
            if let Some(found) = fold::evaluate(&length, self.defaults())
                && found <= 0.0
            {
                let message = messages::not_positive(&label.text, name, found);
                self.diagnostics.error(entry.value.region, message);
                return None;
            }
            lengths.push((label.text.as_str(), length));
        }
        let of = |wanted: &str| {
            let found = lengths.iter().find(|(known, _)| *known == wanted);
            found.map_or(Expr::Number(0.0), |(_, length)| length.clone())
        };
        let [area, about_z, about_y, torsion] = match section.kind.text.as_str() {
            "rectangle" => {
                let (height, width) = (of("height"), of("width"));
                let about = |across: &Expr, along: &Expr| {
                    scaled(1.0 / 12.0, times(along.clone(), fold::power(across.clone(), 3.0)))
                };
                let value = |side: &Expr| fold::evaluate(side, self.defaults());
                let torsion = match (value(&height), value(&width)) {
                    (Some(high), Some(wide)) if high > wide => torsion_of_rectangle(&height, &width),
                    _ => torsion_of_rectangle(&width, &height),
                };
                let area = times(height.clone(), width.clone());
                [area, about(&height, &width), about(&width, &height), torsion]
            }
            "tube" => {
                let (outer, inner) = (of("outer"), of("inner"));
                let value = |expr: &Expr| fold::evaluate(expr, self.defaults());
                if let (Some(inside), Some(outside)) = (value(&inner), value(&outer))
                    && inside >= outside
                {
                    let message = messages::tube_inside_out(name, inside, outside);
                    self.diagnostics.error(section.kind.region, message);
                    return None;
                }
                let ring = |power: f64| {
                    let [outer, inner] = [&outer, &inner].map(|it| fold::power(it.clone(), power));
                    fold::binary(Function2::Sub, outer, inner)
                };
                let second_moment = scaled(PI / 64.0, ring(4.0));
                round(scaled(PI / 4.0, ring(2.0)), second_moment)
            }
            _ => {
                let power = |power: f64| fold::power(of("diameter"), power);
                let second_moment = scaled(PI / 64.0, power(4.0));
                round(scaled(PI / 4.0, power(2.0)), second_moment)
            }
        };
        let about_y = if space == Space::Spatial { about_y } else { Expr::Number(0.0) };
        Some(Section { area, about_z, about_y, torsion })
    }

    /// m³.
    pub(in crate::model) fn volume_of_beam(&mut self, body: &'d syntax::Body) -> Option<Expr> {
        let errors = self.diagnostics.iter().count();
        let section = self.section(body);
        if section.is_none() && self.diagnostics.iter().count() > errors {
            // Said here, and again where the section itself is read: messages of one place are one.
            return None;
        }
        Some(times(section?.area, self.shape_length(body, "length", false)?))
    }
}

/// The polar moment of a round section is its torsion constant.
fn round(area: Expr, second_moment: Expr) -> [Expr; 4] {
    [area, second_moment.clone(), second_moment.clone(), scaled(2.0, second_moment)]
}

/// a b³ (1/3 − (64/π⁵) (b/a) Σ tanh(nπa/2b)/n⁵) over odd n (Timoshenko, Goodier, *Theory of Elasticity*, 109), summed as
/// Σ 1/n⁵ = 31 ζ(5)/32 less Σ (1 − tanh)/n⁵, of which five terms leave nothing where a ≥ b, and 1e-11 where a = b/2.
fn torsion_of_rectangle(a: &Expr, b: &Expr) -> Expr {
    const ODD_FIFTHS: f64 = 1.004_523_762_795_139_6;
    let ratio = fold::binary(Function2::Div, a.clone(), b.clone());
    let sum = [1.0_f64, 3.0, 5.0, 7.0, 9.0].into_iter().fold(Expr::Number(ODD_FIFTHS), |sum, n| {
        let tanh = fold::unary(Function1::Tanh, scaled(0.5 * PI * n, ratio.clone()));
        let less = scaled(n.powi(-5), fold::binary(Function2::Sub, Expr::Number(1.0), tanh));
        fold::binary(Function2::Sub, sum, less)
    });
    let lost = scaled(64.0 / PI.powi(5), fold::binary(Function2::Div, sum, ratio));
    let kept = fold::binary(Function2::Sub, Expr::Number(1.0 / 3.0), lost);
    times(times(a.clone(), fold::power(b.clone(), 3.0)), kept)
}

fn scaled(factor: f64, a: Expr) -> Expr {
    times(Expr::Number(factor), a)
}
