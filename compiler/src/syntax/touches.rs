//! Laws that are told the speed of each touch, `speed = touch`: it is a memory, and an event sets it as the gap closes.
//!
//! ```text
//! memory touch.speed = 0;
//! event touch.touches: touch.gap falls 0 { touch.speed = touch.closing; }
//! ```

use super::definition::{Entry, Event, Label, Memory, Named, Occasion, Path, Term, TermKind, Way};
use super::expression::number;
use super::parser::Parser;
use proc_macro2::TokenStream;

/// What stands for the speed of each touch.
const WORD: &str = "touch";

impl Parser<'_> {
    /// Declares what keeps the speeds with which the contact `name` touches, if its law asks for that, and writes its name there.
    pub(super) fn remember_touches(&mut self, name: &Label, law: &mut Named) {
        let Some((_, speed)) = law.entries.iter_mut().find(|(label, _)| label.text == "speed") else {
            return;
        };
        let region = speed.value.region;
        if !self.is_touch(speed) {
            return;
        }
        let of_contact = |what: &str| {
            let kind =
                TermKind::Name(Path::joined(vec![name.clone(), Label { text: what.to_string(), region }]));
            Term { kind, region, height: 0 }
        };
        let own = |what: &str| Label { text: format!("{}.{what}", name.text), region };
        speed.value = of_contact("speed");
        self.definition.memories.push(Memory {
            name: own("speed"),
            docs: TokenStream::new(),
            entry: Entry::bare(number(region, "0")),
            touch_of: Some(name.clone()),
        });
        let (value, way, level) = (of_contact("gap"), Way::Falls, number(region, "0"));
        self.definition.events.push(Event {
            name: own("touches"),
            occasion: Occasion::Passing { value, way, level },
            sets: vec![(own("speed"), of_contact("closing"))],
            jump: None,
        });
    }

    /// A word, unless something has that name.
    fn is_touch(&self, speed: &Entry) -> bool {
        let (TermKind::Name(path), None) = (&speed.value.kind, &speed.unit) else { return false };
        let definition = &self.definition;
        let constants = definition.constants.iter().map(|constant| &constant.name);
        let mut named = definition.parameters.iter().map(|parameter| &parameter.name).chain(constants);
        path.text.rsplit('.').next() == Some(WORD) && named.all(|name| name.text != path.text)
    }
}
