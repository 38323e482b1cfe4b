//! Memories, and the events that set them.
//!
//! ```text
//! memory name [unit] = value;
//! event name: quantity rises|falls|crosses level { memory = value; … jump(speed) = value; }
//! event name: every period { memory = value; … jump(speed) = value; }
//! ```

use super::definition::{Event, Jump, Memory, Occasion, Way};
use super::parser::{Parsed, Parser};
use super::token::Cursor;
use crate::messages;
use proc_macro2::{Delimiter, TokenStream};

impl Parser<'_> {
    /// `name [unit] = value;` after the word `memory`.
    pub fn memory(&mut self, c: &mut Cursor, docs: TokenStream) -> Parsed<()> {
        let (name, unit) = self.declared_with_unit(c, "the name of the memory")?;
        let name = self.own(name);
        if c.is_done() || c.at_punct(';') {
            return self.fail(name.region, messages::memory_without_start(&name.text));
        }
        let entry = self.entry(c, unit)?;
        self.semicolon(c)?;
        self.definition.memories.push(Memory { name, docs, entry, touch_of: None });
        Ok(())
    }

    /// `name: occasion { memory = value; … }` after the word `event`.
    pub fn event(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the event")?;
        let name = self.own(name);
        self.punct(c, ':')?;
        let occasion = if c.eat_word("every") {
            Occasion::Every(self.expression(c)?)
        } else {
            let value = self.expression(c)?;
            let Some(way) = c.word().and_then(Way::named) else {
                return self.expected(c, "`rises`, `falls` or `crosses` and a level");
            };
            c.advance();
            Occasion::Passing { value, way, level: self.expression(c)? }
        };
        let mut inside = self.group(c, Delimiter::Brace)?;
        if inside.is_done() {
            return self.fail(name.region, messages::event_without_assignments(&name.text));
        }
        let (mut sets, mut jump) = (Vec::new(), None);
        while !inside.is_done() {
            if inside.at_word("jump") && is_called(inside.clone()) {
                let found = self.jump(&mut inside)?;
                if jump.is_some() {
                    return self.fail(found.speed.region, messages::second_jump(&name.text));
                }
                jump = Some(found);
                continue;
            }
            let memory = self.label(&mut inside, "the name of a memory")?;
            if inside.at_punct('.') {
                return self.fail(memory.region, messages::assigned_quantity(&memory.text));
            }
            self.punct(&mut inside, '=')?;
            let value = self.expression(&mut inside)?;
            self.semicolon(&mut inside)?;
            sets.push((memory, value));
        }
        self.definition.events.push(Event { name, occasion, sets, jump });
        Ok(())
    }

    /// `jump(speed) = value;`
    fn jump(&mut self, c: &mut Cursor) -> Parsed<Jump> {
        c.advance();
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let speed = self.path(&mut inside, "a speed or rate, such as `rail.speed`")?;
        if inside.at_punct('=') {
            return self.fail(inside.region(), messages::jump_closed_late(&speed.text));
        }
        self.end(&inside, "`)`")?;
        self.punct(c, '=')?;
        let to = self.expression(c)?;
        self.semicolon(c)?;
        Ok(Jump { speed, to })
    }
}

/// Whether parentheses follow the word.
fn is_called(mut c: Cursor) -> bool {
    c.advance();
    c.inside(Delimiter::Parenthesis).is_some()
}
