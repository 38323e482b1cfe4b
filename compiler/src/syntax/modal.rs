//! What a body has that deforms by the modes of a file: `flexible arm(file = "arm.flex") { point tip = node(204); modes = 1..8; }`

use super::definition::{Body, FileTerm, Label, ModalTerm, NodeTerm, WrittenUnit};
use super::parser::{Failed, Parsed, Parser};
use super::token::Cursor;
use crate::messages;
use crate::units;
use proc_macro2::Delimiter;

/// What a body cannot have that deforms so.
const NOT_ON_IT: [&str; 3] = ["marker", "line", "toothing"];
const OF_THE_FILE: [&str; 4] = ["center", "inertia", "products", "inertia_axes"];

impl Parser<'_> {
    /// `(file = "arm.flex")` behind the name.
    pub fn modal(&mut self, c: &mut Cursor, body: &Label) -> Parsed<ModalTerm> {
        let at = c.region();
        let Some(mut inside) = c.enter(Delimiter::Parenthesis) else {
            return self.fail(at, messages::flexible_without_file(&body.text));
        };
        let region = inside.region();
        if !inside.eat_word("file") || !inside.eat_punct('=') {
            return self.fail(region, messages::flexible_without_file(&body.text));
        }
        let region = inside.region();
        let Some(name) = super::tables::file_name(&mut inside) else {
            return self.fail(region, messages::flexible_without_file(&body.text));
        };
        self.end(&inside, "`)`")?;
        Ok(ModalTerm { file: FileTerm { name, region, skip: 0 }, modes: None, nodes: Vec::new(), read: None })
    }

    /// `modes = 1..8;`, `point tip = node(204);`; `None` of anything else.
    pub fn of_modal(&mut self, c: &mut Cursor, body: &mut Body) -> Option<Parsed<()>> {
        let word = c.word()?;
        if NOT_ON_IT.contains(&word) {
            return Some(self.fail(c.region(), messages::not_on_flexible(word, &body.name.text)));
        }
        if OF_THE_FILE.contains(&word) {
            return Some(self.fail(c.region(), messages::of_the_file(word, &body.name.text)));
        }
        match word {
            "modes" => Some(self.modes_of_file(c, body)),
            "point" => Some(self.point_at_node(c, body)),
            _ => None,
        }
    }

    fn modes_of_file(&mut self, c: &mut Cursor, body: &mut Body) -> Parsed<()> {
        let label = self.word(c, "`modes`")?;
        self.punct(c, '=')?;
        let start = c.region();
        if c.inside(Delimiter::Parenthesis).is_some() {
            return self.expected(c, messages::modes_of_file());
        }
        let from = self.expression(c)?;
        let mut to = from.clone();
        if c.at_puncts('.', '.') {
            c.advance();
            c.advance();
            to = self.expression(c)?;
        }
        let region = start.to(to.region);
        let (from, to) = (self.integer(&from)?, self.integer(&to)?);
        self.semicolon(c)?;
        let Some(modal) = &mut body.modal else { return Err(Failed) };
        if let Some((_, first)) = &modal.modes {
            let message = messages::property_twice("modes", &body.name.text);
            self.diagnostics.conflict(label.region, message, *first, messages::first_here("modes"));
            return Err(Failed);
        }
        match (usize::try_from(from), usize::try_from(to)) {
            (Ok(first @ 1..), Ok(last)) if first <= last => modal.modes = Some(([first, last], region)),
            _ => return self.fail(region, messages::modes_upside_down(from, to)),
        }
        Ok(())
    }

    fn point_at_node(&mut self, c: &mut Cursor, body: &mut Body) -> Parsed<()> {
        c.advance();
        let (name, _) = self.declared_with_unit(c, "the name of the point")?;
        self.punct(c, '=')?;
        let start = c.region();
        if !c.eat_word("node") {
            return self.fail(start, messages::point_of_flexible(&body.name.text));
        }
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let term = self.expression(&mut inside)?;
        self.end(&inside, "`)`")?;
        let number = self.integer(&term)?;
        let region = start.to(c.previous());
        self.semicolon(c)?;
        let Ok(number) = u64::try_from(number) else {
            return self.fail(region, messages::point_of_flexible(&body.name.text));
        };
        if let Some(modal) = &mut body.modal {
            let unit = units::parse("m").ok().map(|unit| WrittenUnit { unit, region });
            modal.nodes.push(NodeTerm { name, number, region, unit });
        }
        Ok(())
    }
}
