//! Toothings as written: their numbers in SI, with what is common where nothing is written.

use super::super::lower::{Lowering, Use, name};
use super::super::names::Part;
use super::super::unused::Scope;
use super::super::{Axes, BodyId, Expr, Frame, Place, Subject, fold};
use super::stiffness::{Material, Series, Tooth};
use super::{Toothing, ToothingId};
use crate::forms::Rim;
use crate::messages;
use crate::syntax::{self, Path, PlaceTerm};
use crate::units::Dimension;

/// α where none is written.
const PRESSURE_ANGLE: f64 = 20.0 * std::f64::consts::PI / 180.0;
const FEWEST_TEETH: f64 = 4.0;
const MOST_TEETH: f64 = 10_000.0;
const MOST_STARTS: f64 = 12.0;
/// Of half the angle of a pitch cone, degrees.
const CONES: std::ops::RangeInclusive<f64> = 1.0..=89.0;

impl<'d> Lowering<'d> {
    /// The toothings of a body.
    pub fn toothings(&mut self, index: usize, body: &'d syntax::Body) -> Option<Vec<Toothing>> {
        let toothings: Vec<Option<Toothing>> =
            body.toothings.iter().map(|toothing| self.toothing(index, body, toothing)).collect();
        toothings.into_iter().collect()
    }

    fn toothing(
        &mut self,
        index: usize,
        body: &'d syntax::Body,
        written: &'d syntax::Toothing,
    ) -> Option<Toothing> {
        let own = &body.name.text;
        let value =
            |this: &mut Self, what: &str, dimension: Dimension, default: f64| match written.named.entry(what)
            {
                Some(entry) => this.number(entry, dimension, what),
                None => Some(default),
            };
        let rim = written.form.rim;
        let teeth = match rim.counts() {
            Some(what) => value(self, what, Dimension::ONE, 0.0),
            None => Some(0.0),
        };
        let module = value(self, "module", Dimension::LENGTH, 0.0);
        let pressure_angle = value(self, "pressure_angle", Dimension::ANGLE, PRESSURE_ANGLE);
        let helix = value(self, "helix", Dimension::ANGLE, 0.0);
        let shift = value(self, "shift", Dimension::ONE, 0.0);
        let addendum = value(self, "addendum", Dimension::ONE, 1.0);
        let dedendum = value(self, "dedendum", Dimension::ONE, 1.25);
        let first = value(self, "first", Dimension::ANGLE, 0.0);
        let cone = value(self, "cone", Dimension::ANGLE, 0.0);
        let diameter = value(self, "diameter", Dimension::LENGTH, 0.0);
        let face_width = value(self, "face_width", Dimension::LENGTH, 0.0);
        let bore = value(self, "bore", Dimension::LENGTH, 0.0);
        let (center, along) = self.stand(index, body, written)?;
        let given = |what: &str| written.named.entry(what).is_some();
        let toothing = Toothing {
            name: name(&written.name),
            text: format!("{own}.{}", written.name.text),
            form: written.form,
            center,
            teeth: teeth?,
            module: module?,
            pressure_angle: pressure_angle?,
            helix: helix?,
            shift: shift?,
            addendum: addendum?,
            dedendum: dedendum?,
            first: first?,
            cone: cone?,
            diameter: diameter?,
            along,
            face_width: face_width.filter(|_| given("face_width")),
            bore: bore.filter(|_| given("bore")),
        };
        let wrong = wrong(&toothing);
        if let Some((what, message)) = wrong {
            let region = written.named.entry(what).map_or(written.name.region, |entry| entry.value.region);
            self.diagnostics.error(region, message);
            return None;
        }
        Some(toothing)
    }

    /// The centre of a toothing; of a rack the first point of its line, and the direction of that.
    fn stand(
        &mut self,
        index: usize,
        body: &'d syntax::Body,
        written: &'d syntax::Toothing,
    ) -> Option<(Place, [f64; 3])> {
        let own = &body.name.text;
        if let Some(term) = &written.line {
            let line = self.line(term)?;
            if line.frame != Frame::Body(BodyId(index)) {
                self.diagnostics.error(term.region(), messages::rack_elsewhere(own, &line.text));
                return None;
            }
            let [from, to] = &line.ends;
            let way: Option<Vec<f64>> =
                fold::between(from, to).iter().map(|it| fold::evaluate(it, self.defaults())).collect();
            let way: [f64; 3] = way?.try_into().ok()?;
            let length = libm::sqrt(way.iter().map(|x| x * x).sum());
            // A line of no length has been told of.
            if length == 0.0 {
                return None;
            }
            let center = Place {
                frame: line.frame,
                at: from.clone(),
                axes: Axes::Parallel,
                of_mean: false,
                text: line.text,
                span: term.region(),
            };
            return Some((center, way.map(|x| x / length)));
        }
        let center = match &written.at {
            Some(path) => self.place(&PlaceTerm::Named(path.clone())),
            None => {
                let parts = vec![
                    body.name.clone(),
                    syntax::Label { text: "center".to_string(), ..body.name.clone() },
                ];
                self.place(&PlaceTerm::Named(Path::joined(parts)))
            }
        };
        let center = center?;
        if let (Some(path), true) = (&written.at, center.frame != Frame::Body(BodyId(index))) {
            self.diagnostics.error(path.region, messages::toothing_elsewhere(own, &path.text));
            return None;
        }
        Some((center, [0.0; 3]))
    }

    /// A toothing by its path.
    pub fn toothing_of(&mut self, path: &Path) -> Option<ToothingId> {
        let head = &path.parts[0];
        let Some(Part::Body(index)) = self.names.part(&head.text) else {
            let message = match self.names.part(&head.text) {
                Some(part) => messages::no_toothings(&head.text, part.kind()),
                None => {
                    let similar = self.names.similar_part(&head.text, |part| matches!(part, Part::Body(_)));
                    self.names.unknown("body", &head.text, similar)
                }
            };
            self.diagnostics.error(head.region, message);
            return None;
        };
        let body = &self.definition.bodies[index];
        let found = match path.parts.as_slice() {
            [_, rim] => body.toothings.iter().position(|toothing| toothing.name.text == rim.text),
            _ => None,
        };
        match found {
            Some(at) => {
                self.used.insert((Scope::Body(index), &body.toothings[at].name.text));
                Some(ToothingId { body: BodyId(index), index: at })
            }
            None => {
                let known: Vec<&str> =
                    body.toothings.iter().map(|toothing| toothing.name.text.as_str()).collect();
                let message = messages::unknown_toothing(&path.text, &head.text, &known);
                self.diagnostics.error(path.region, message);
                None
            }
        }
    }
}

/// The argument that no toothing has, and why.
fn wrong(toothing: &Toothing) -> Option<(&'static str, String)> {
    let Toothing { teeth, module, pressure_angle, helix, shift, addendum, dedendum, cone, diameter, .. } =
        *toothing;
    let (text, rim) = (&toothing.text, toothing.form.rim);
    if let Some(what) = rim.counts() {
        let range = if rim == Rim::Worm { [1.0, MOST_STARTS] } else { [FEWEST_TEETH, MOST_TEETH] };
        if teeth.fract() != 0.0 {
            return Some((what, messages::teeth_not_whole(text, what, teeth)));
        }
        if !(range[0]..=range[1]).contains(&teeth) {
            return Some((what, messages::number_of_teeth(text, what, teeth, range)));
        }
    }
    if module <= 0.0 {
        return Some(("module", messages::toothing_not_positive(text, "module", module)));
    }
    let degrees = pressure_angle.to_degrees();
    if !(5.0..=45.0).contains(&degrees) {
        return Some(("pressure_angle", messages::pressure_angle(text, degrees)));
    }
    if helix.to_degrees().abs() > 60.0 {
        return Some(("helix", messages::helix(text, helix.to_degrees())));
    }
    if rim == Rim::Bevel && !(CONES.contains(&cone.to_degrees())) {
        return Some(("cone", messages::cone(text, cone.to_degrees())));
    }
    if rim == Rim::Worm && diameter <= 2.0 * dedendum * module {
        return Some(("diameter", messages::worm_too_thin(text, diameter, 2.0 * dedendum * module)));
    }
    for (what, value) in [("addendum", addendum), ("dedendum", dedendum)] {
        if value <= 0.0 {
            return Some((what, messages::toothing_not_positive(text, what, value)));
        }
    }
    if shift.abs() > 2.0 {
        return Some(("shift", messages::shift_in_modules(text, shift)));
    }
    for (what, value) in [("face_width", toothing.face_width), ("bore", toothing.bore)] {
        if let Some(value) = value.filter(|value| *value <= 0.0) {
            return Some((what, messages::toothing_not_positive(text, what, value)));
        }
    }
    if let Some(bore) = toothing.bore.filter(|bore| 0.5 * bore >= toothing.root_radius()) {
        return Some(("bore", messages::bore_beyond_teeth(text, bore, 2.0 * toothing.root_radius())));
    }
    if rim == Rim::Bevel
        && let Some(width) = toothing.face_width
    {
        let cone = toothing.pitch_radius() / libm::sin(cone);
        if width >= cone {
            return Some(("face_width", messages::face_beyond_apex(text, width, cone)));
        }
    }
    None
}

/// A load between teeth.
#[derive(Clone, Debug)]
pub struct Meshing {
    /// Its pair, in `Mechanism::pairs`.
    pub pair: usize,
    /// Of `involute(…)`.
    pub material: Option<Material>,
    /// What its series is of.
    pub series: Option<Series>,
    pub stores: bool,
    /// `axes = moving`.
    pub axes_move: bool,
}

impl<'d> Lowering<'d> {
    /// What a load between teeth is, beyond its arguments.
    pub fn meshing(&mut self, load: &'d syntax::Load, on: &[Subject]) -> Option<Option<Meshing>> {
        if !on.iter().any(|subject| matches!(subject, Subject::Toothing(_))) {
            return Some(None);
        }
        if let (Some(ratio), Some(_)) = (load.named.entry("damping_ratio"), load.named.entry("damping")) {
            self.diagnostics.error(ratio.value.region, messages::damping_and_ratio());
            return None;
        }
        if let Some(sense) = load.named.entry("sense") {
            let value = self.number(sense, Dimension::ONE, "sense")?;
            if value.abs() != 1.0 {
                self.diagnostics.error(sense.value.region, messages::sense_of_teeth(value));
                return None;
            }
        }
        let material = match load.named.call("stiffness") {
            Some(call) => Some(self.material(call)?),
            None => None,
        };
        let axes_move = self.axes_move(load)?;
        Some(Some(Meshing { pair: 0, material, series: None, stores: false, axes_move }))
    }

    fn axes_move(&mut self, load: &'d syntax::Load) -> Option<bool> {
        let Some(entry) = load.named.entry("axes") else { return Some(false) };
        let found = match &entry.value.kind {
            syntax::TermKind::Name(path) => path.text.as_str(),
            _ => "a value",
        };
        if !["held", "moving"].contains(&found) {
            self.diagnostics.error(entry.value.region, messages::axes_of_what(found));
            return None;
        }
        let damping = load.named.entry("damping").map(|damping| &damping.value);
        if let (Some(damping), "moving") = (damping, found)
            && matches!(&damping.kind, syntax::TermKind::Call(label, _) if label.text == "always")
        {
            self.diagnostics.error(damping.region, messages::always_on_moving_axes());
            return None;
        }
        Some(found == "moving")
    }

    /// A law; what is made of the shape of teeth follows when their pair is known.
    pub fn teeth_stiffness(&mut self, load: &'d syntax::Load, name: &str) -> Option<Vec<Expr>> {
        match load.named.entry(name) {
            Some(entry) => Some(vec![self.entry(entry, Dimension::STIFFNESS, Use::VARYING, name)?]),
            None => Some(vec![Expr::Number(0.0)]),
        }
    }

    /// c, and a number where it acts always.
    pub fn teeth_damping(&mut self, load: &'d syntax::Load, name: &str) -> Option<Vec<Expr>> {
        let Some(entry) = load.named.entry(name) else { return Some(vec![Expr::Number(0.0)]) };
        let damping = |this: &mut Self, term: &'d syntax::Term| {
            this.with_unit(term, entry.unit.as_ref(), Dimension::DAMPING, Use::COEFFICIENT, name)
        };
        match &entry.value.kind {
            syntax::TermKind::Call(label, arguments) if label.text == "always" && arguments.len() == 1 => {
                Some(vec![damping(self, &arguments[0])?, Expr::Number(1.0)])
            }
            _ => Some(vec![damping(self, &entry.value)?]),
        }
    }

    fn material(&mut self, call: &'d syntax::Named) -> Option<Material> {
        let pressure = Dimension::FORCE.over(Dimension::LENGTH).over(Dimension::LENGTH);
        let young = self.number(call.entry("young")?, pressure, "young")?;
        let mut number = |what: &str, default: f64| match call.entry(what) {
            Some(entry) => self.number(entry, Dimension::ONE, what),
            None => Some(default),
        };
        let (poisson, harmonics, entry) =
            (number("poisson", 0.3)?, number("harmonics", 5.0)?, number("entry", 0.0)?);
        let tooth = match call.entry("tooth").map(|entry| (&entry.value.kind, entry.value.region)) {
            None => Tooth::Profile,
            Some((syntax::TermKind::Name(path), _)) if path.text == "profile" => Tooth::Profile,
            Some((syntax::TermKind::Name(path), _)) if path.text == "section" => Tooth::Section,
            Some((kind, region)) => {
                let found =
                    if let syntax::TermKind::Name(path) = kind { path.text.as_str() } else { "a value" };
                self.diagnostics.error(region, messages::involute_of_what(found));
                return None;
            }
        };
        let wrong = [
            ("young", young, young > 0.0, "above 0"),
            ("poisson", poisson, (0.0..0.5).contains(&poisson), "from 0 to 0.5"),
            ("entry", entry, (0.0..=0.5).contains(&entry), "from 0 to 0.5 pitches"),
        ];
        for (what, found, is_right, range) in wrong {
            if !is_right {
                let region = call.entry(what).map(|entry| entry.value.region)?;
                self.diagnostics.error(region, messages::involute_number(what, found, range));
                return None;
            }
        }
        if harmonics.fract() != 0.0 || !(1.0..=40.0).contains(&harmonics) {
            let region = call.entry("harmonics").map(|entry| entry.value.region)?;
            self.diagnostics.error(region, messages::involute_harmonics(harmonics));
            return None;
        }
        Some(Material { young, poisson, tooth, harmonics: harmonics as usize, entry })
    }
}
