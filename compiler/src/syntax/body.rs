//! `body crank { mass [kg] = 1; point tip [m] = (1, 0); … }` and the shapes.

use super::definition::{Body, Shape};
use super::parser::{Parsed, Parser};
use super::token::Cursor;
use crate::messages;
use proc_macro2::Delimiter;

/// Properties that a shape may have.
fn properties(shape: Shape) -> &'static [&'static str] {
    match shape {
        Shape::Body => &["mass", "inertia"],
        Shape::Rod => &["mass", "length", "inertia"],
        Shape::Disk => &["mass", "radius", "inertia"],
        Shape::Box => &["mass", "width", "height", "inertia"],
        Shape::Particle => &["mass"],
    }
}

impl Parser {
    /// `name { … }` after the word of the shape.
    pub fn body(&mut self, c: &mut Cursor, shape: Shape) -> Parsed<()> {
        let name = self.declared(c, "the name of the body")?;
        let mut inside = self.group(c, Delimiter::Brace)?;
        let mut body =
            Body { name, shape, properties: Vec::new(), center: None, points: Vec::new(), lines: Vec::new() };
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
        self.attributes(c)?;
        let shape = body.shape;
        let allowed = properties(shape);
        match c.word() {
            Some("point" | "line") if shape == Shape::Particle => {
                self.fail(c.region(), messages::particle_with_places(&body.name.text))
            }
            Some("point") => {
                c.advance();
                let (name, unit) = self.declared_with_unit(c, "the name of the point")?;
                self.punct(c, '=')?;
                let pair = self.pair(c, unit)?;
                self.semicolon(c)?;
                body.points.push((name, pair));
                Ok(())
            }
            Some("line") => {
                c.advance();
                let line = self.line(c)?;
                body.lines.push(line);
                Ok(())
            }
            Some("center") if shape != Shape::Body => {
                self.fail(c.region(), messages::center_of_shape(shape.text()))
            }
            Some("center") => {
                let label = self.word(c, "`center`")?;
                let unit = self.unit(c)?;
                self.punct(c, '=')?;
                let pair = self.pair(c, unit)?;
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
            Some(word) => {
                let message = messages::unknown_property(shape.text(), word, allowed);
                self.fail(c.region(), message)
            }
            None => self.expected(c, "a property of the body"),
        }
    }
}
