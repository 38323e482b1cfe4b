//! `body crank { mass [kg] = 1; point tip [m] = (1, 0); … }` and the shapes.

use super::attributes::Bearer;
use super::definition::{BeamTerm, Body, Label, Marker, MarkerAxes, Space};
use super::parser::{Failed, Parsed, Parser};
use super::token::Cursor;
use crate::forms::{BodyForm, Deforms};
use crate::messages;
use proc_macro2::Delimiter;

/// Whether several values in parentheses stand so many tokens ahead.
fn is_vector(c: &Cursor, ahead: usize) -> bool {
    let mut c = c.clone();
    for _ in 0..ahead {
        c.advance();
    }
    c.inside(Delimiter::Parenthesis).is_some_and(|inside| inside.has_comma())
}

impl Parser<'_> {
    /// `name { … }` after the word of the kind.
    pub fn body(&mut self, c: &mut Cursor, form: &'static BodyForm) -> Parsed<()> {
        let name = self.declared(c, "the name of the body")?;
        let name = self.own(name);
        let modal = if form.is_modal() { Some(self.modal(c, &name)?) } else { None };
        let mut inside = self.group(c, Delimiter::Brace)?;
        let mut body = Body {
            name,
            form,
            properties: Vec::new(),
            vectors: Vec::new(),
            inertia_axes: None,
            center: None,
            points: Vec::new(),
            markers: Vec::new(),
            lines: Vec::new(),
            toothings: Vec::new(),
            beam: BeamTerm::default(),
            modal,
        };
        while !inside.is_done() {
            let before = inside.clone();
            if self.property(&mut inside, &mut body).is_err() {
                inside = before;
                inside.skip_statement();
            }
        }
        self.definition.bodies.push(body);
        Ok(())
    }

    fn property(&mut self, c: &mut Cursor, body: &mut Body) -> Parsed<()> {
        let start = c.region();
        let attributes = self.attributes(c, Bearer::Part)?;
        let read = self.property_after(c, body);
        self.allow(&attributes.allowed, start.to(c.behind()));
        read
    }

    fn property_after(&mut self, c: &mut Cursor, body: &mut Body) -> Parsed<()> {
        let (form, space) = (body.form, self.definition.space);
        let (allowed, vectors) = (form.properties(space), form.vectors(space));
        if form.is_modal()
            && let Some(read) = self.of_modal(c, body)
        {
            return read;
        }
        match c.word() {
            Some(word) if form.is_beam() && super::beam::WORDS.contains(&word) => {
                self.of_beam(c, body, space)
            }
            Some("line") if form.is_beam() => self.fail(c.region(), messages::line_on_beam(&body.name.text)),
            Some("point" | "line" | "marker") if !form.turns => {
                self.fail(c.region(), messages::particle_with_places(&body.name.text))
            }
            Some("point") => {
                c.advance();
                let (name, unit) = self.declared_with_unit(c, "the name of the point")?;
                self.punct(c, '=')?;
                let pair = self.vector(c, unit)?;
                self.semicolon(c)?;
                body.points.push((name, pair));
                Ok(())
            }
            Some("toothing") if form.is_beam() => {
                self.fail(c.region(), messages::toothing_on_beam(&body.name.text))
            }
            Some("toothing") => {
                c.advance();
                let toothing = self.toothing(c, body)?;
                body.toothings.push(toothing);
                Ok(())
            }
            Some("line") => {
                c.advance();
                let line = self.line(c)?;
                body.lines.push(line);
                Ok(())
            }
            Some("marker") if form.is_beam() && space == Space::Spatial => {
                self.fail(c.region(), messages::marker_on_beam(&body.name.text))
            }
            Some("marker") => {
                c.advance();
                let marker = self.marker(c)?;
                body.markers.push(marker);
                Ok(())
            }
            Some("surface") => {
                c.advance();
                let surface = self.surface(c, Some(&body.name))?;
                self.definition.surfaces.push(surface);
                Ok(())
            }
            Some("center") if !form.states_center => {
                self.fail(c.region(), messages::center_of_shape(form.word))
            }
            Some("center") => {
                let label = self.word(c, "`center`")?;
                let unit = self.unit(c)?;
                self.punct(c, '=')?;
                let pair = self.vector(c, unit)?;
                self.semicolon(c)?;
                if let Some((first, _)) = &body.center {
                    let message = messages::property_twice("center", &body.name.text);
                    self.diagnostics.conflict(
                        label.region,
                        message,
                        first.region,
                        messages::first_here("center"),
                    );
                }
                body.center = Some((label, pair));
                Ok(())
            }
            Some(word) if allowed.contains(&word) => {
                let label = self.word(c, "a property")?;
                let unit = self.unit(c)?;
                if label.text == "inertia" && c.at_punct('=') && is_vector(c, 1) {
                    return self.fail(c.region(), messages::planar_inertia());
                }
                let entry = self.entry(c, unit)?;
                self.semicolon(c)?;
                if let Some((first, _)) = body.property(&label.text) {
                    let message = messages::property_twice(&label.text, &body.name.text);
                    let note = messages::first_here(&label.text);
                    self.diagnostics.conflict(label.region, message, first.region, note);
                }
                body.properties.push((label, entry));
                Ok(())
            }
            Some("inertia_axes") if vectors.contains(&"inertia_axes") => {
                c.advance();
                self.punct(c, '=')?;
                body.inertia_axes = Some(self.declared(c, "the name of a marker of this body")?);
                self.semicolon(c)
            }
            Some(word) if vectors.contains(&word) => {
                let label = self.word(c, "a property")?;
                let unit = self.unit(c)?;
                self.punct(c, '=')?;
                let example = match label.text.as_str() {
                    "inertia" => "the moments of inertia `(Ixx, Iyy, Izz)`",
                    "products" => "the products of inertia `(Ixy, Ixz, Iyz)`",
                    _ => "the three edges `(a, b, c)`",
                };
                let tuple = self.tuple(c, unit, 3, example)?;
                self.semicolon(c)?;
                if let Some((first, _)) = body.vector(&label.text) {
                    let message = messages::property_twice(&label.text, &body.name.text);
                    let note = messages::first_here(&label.text);
                    self.diagnostics.conflict(label.region, message, first.region, note);
                }
                body.vectors.push((label, tuple));
                Ok(())
            }
            Some(word) => {
                let of_beam: &[&str] = match form.deforms {
                    Deforms::Beam => &super::beam::WORDS,
                    Deforms::Modal => &["modes"],
                    Deforms::Not => &[],
                };
                let allowed: Vec<&str> = allowed.iter().chain(&vectors).chain(of_beam).copied().collect();
                let message = messages::unknown_property(form.word, word, &allowed, &self.statement_words());
                self.fail(c.region(), message)
            }
            None => self.expected(c, "a property of the body"),
        }
    }

    /// `name [unit] = (x, y, z), axis = (…), reference = (…);` or `…, about_x [deg] = 90, …;` after the word `marker`.
    pub fn marker(&mut self, c: &mut Cursor) -> Parsed<Marker> {
        const DIRECTIONS: [&str; 2] = ["axis", "reference"];
        const ANGLES: [&str; 3] = ["about_x", "about_y", "about_z"];
        if self.definition.space == Space::Planar {
            return self.fail(c.previous(), messages::only_in_space("marker"));
        }
        let (name, unit) = self.declared_with_unit(c, "the name of the marker")?;
        self.punct(c, '=')?;
        let at = self.vector(c, unit)?;
        let mut axes: Vec<(Label, MarkerAxes)> = Vec::new();
        while c.eat_punct(',') {
            let label = self.word(c, "`axis`, `reference`, `about_x`, `about_y` or `about_z`")?;
            let unit = self.unit(c)?;
            let angular = ANGLES.contains(&label.text.as_str());
            if !angular && !DIRECTIONS.contains(&label.text.as_str()) {
                let known: Vec<&str> = DIRECTIONS.into_iter().chain(ANGLES).collect();
                return self.fail(label.region, messages::unknown_argument("marker", &label.text, &known));
            }
            let mixed = axes.iter().any(|(_, other)| matches!(other, MarkerAxes::Angle(_)) != angular);
            if mixed {
                return self.fail(label.region, messages::marker_axes_mixed());
            }
            if let Some((first, _)) = axes.iter().find(|(first, _)| !angular && first.text == label.text) {
                let message = messages::property_twice(&label.text, &name.text);
                let note = messages::first_here(&label.text);
                self.diagnostics.conflict(label.region, message, first.region, note);
                return Err(Failed);
            }
            let given = if angular {
                MarkerAxes::Angle(self.entry(c, unit)?)
            } else {
                self.punct(c, '=')?;
                MarkerAxes::Direction(self.vector(c, unit)?)
            };
            axes.push((label, given));
        }
        if let [(label, MarkerAxes::Direction(_))] = axes.as_slice()
            && label.text == "reference"
        {
            return self.fail(label.region, messages::reference_without_axis());
        }
        self.semicolon(c)?;
        Ok(Marker { name, at, axes })
    }
}
