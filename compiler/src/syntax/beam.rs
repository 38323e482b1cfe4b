//! What a beam has in its braces beside values: `section = circle(diameter [mm] = 7); modes = (axial = 2, bending = 5); shapes = free;`,
//! in space `modes = (bending_y = 2, bending_z = 2, torsion = 1);`.

use super::definition::{Body, ExpectEntry, ModesTerm, Path, SectionTerm, Side};
use super::parser::{Failed, Parsed, Parser};
use super::token::Cursor;
use crate::beams::{Counts, MOST_MODES, Shapes, Theory, Way};
use crate::diagnostics::Region;
use crate::forms::{SECTIONS, Space};
use crate::messages;
use proc_macro2::Delimiter;

/// Words before what is no value.
pub(super) const WORDS: [&str; 5] = ["section", "modes", "shapes", "theory", "stiffening"];

impl Parser<'_> {
    /// One of [`WORDS`] and what follows it.
    pub fn of_beam(&mut self, c: &mut Cursor, body: &mut Body, space: Space) -> Parsed<()> {
        let label = self.word(c, "a property")?;
        self.punct(c, '=')?;
        let (name, beam) = (body.name.text.clone(), &mut body.beam);
        let first = match label.text.as_str() {
            "section" => beam.section.as_ref().map(|section| section.kind.region),
            "modes" => beam.modes.as_ref().map(|modes| modes.region),
            "shapes" => beam.shapes.as_ref().map(|(label, _)| label.region),
            "stiffening" => beam.stiffening.as_ref().map(|(label, _)| label.region),
            _ => beam.theory.as_ref().map(|(label, _)| label.region),
        };
        if let Some(first) = first {
            let message = messages::property_twice(&label.text, &name);
            self.diagnostics.conflict(label.region, message, first, messages::first_here(&label.text));
            return Err(Failed);
        }
        match label.text.as_str() {
            "section" => beam.section = Some(self.section(c, space)?),
            "modes" => beam.modes = Some(self.modes(c, space)?),
            "shapes" => {
                let word = self.word(c, "`free`, `clamped`, `pinned` or `static`")?;
                match Shapes::ALL.into_iter().find(|shapes| shapes.word() == word.text) {
                    Some(shapes) => beam.shapes = Some((word, shapes)),
                    None => return self.fail(word.region, messages::unknown_shapes(&word.text)),
                }
            }
            "stiffening" => {
                let word = self.word(c, "`on` or `off`")?;
                let stiffens = match word.text.as_str() {
                    "on" => true,
                    "off" => false,
                    _ => return self.fail(word.region, messages::unknown_stiffening(&word.text)),
                };
                beam.stiffening = Some((word, stiffens));
            }
            _ => {
                let word = self.word(c, "`euler_bernoulli` or `timoshenko`")?;
                match Theory::ALL.into_iter().find(|theory| theory.word() == word.text) {
                    Some(theory) => beam.theory = Some((word, theory)),
                    None => return self.fail(word.region, messages::unknown_theory(&word.text)),
                }
            }
        }
        self.semicolon(c)
    }

    /// `(coupler.bending[0]) >= 200 [Hz]` after the word `frequency`.
    pub(super) fn frequency(&mut self, c: &mut Cursor) -> Parsed<ExpectEntry> {
        const SUCH: &str =
            "`>=` or `<=` and a frequency, such as `frequency(coupler.bending[0]) >= 200 [Hz]`";
        let (mode, side) = self.on_one_side(c, "a mode, such as `coupler.bending[0]`", SUCH)?;
        Ok(ExpectEntry::Frequency(mode, side, self.expression(c)?))
    }

    /// `(arm.end) <= 3 [mm]` after the word `deflection`.
    pub(super) fn deflection(&mut self, c: &mut Cursor) -> Parsed<ExpectEntry> {
        const SUCH: &str = "`>=` or `<=` and a length, such as `deflection(arm.end) <= 3 [mm]`";
        let (place, side) = self.on_one_side(c, "a point of a beam, such as `arm.end`", SUCH)?;
        Ok(ExpectEntry::Deflection(place, side, self.expression(c)?))
    }

    fn on_one_side(&mut self, c: &mut Cursor, what: &str, such: &str) -> Parsed<(Path, Side)> {
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let path = self.path(&mut inside, what)?;
        self.end(&inside, "`)`")?;
        let side = if c.at_puncts('>', '=') {
            Side::Above
        } else if c.at_puncts('<', '=') {
            Side::Below
        } else {
            return self.expected(c, such);
        };
        c.advance();
        c.advance();
        Ok((path, side))
    }

    fn section(&mut self, c: &mut Cursor, space: Space) -> Parsed<SectionTerm> {
        let kind = self.word(c, "`circle(…)`, `tube(…)` or `rectangle(…)`")?;
        let Some((_, lengths)) = SECTIONS.iter().find(|(word, _)| *word == kind.text) else {
            return self.fail(kind.region, messages::unknown_section(&kind.text, space));
        };
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let mut found = Vec::new();
        while !inside.is_done() {
            let label = self.word(&mut inside, "a length of the section")?;
            if !lengths.contains(&label.text.as_str()) {
                return self.fail(label.region, messages::unknown_argument(&kind.text, &label.text, lengths));
            }
            if found.iter().any(|(known, _): &(super::Label, _)| known.text == label.text) {
                return self.fail(label.region, messages::property_twice(&label.text, &kind.text));
            }
            let unit = self.unit(&mut inside)?;
            let entry = self.entry(&mut inside, unit)?;
            found.push((label, entry));
            if !inside.is_done() && !inside.eat_punct(',') {
                return self.expected(&inside, "`,` or `)`");
            }
        }
        let missing = lengths.iter().find(|name| !found.iter().any(|(label, _)| label.text == **name));
        if let Some(missing) = missing {
            return self.fail(kind.region, messages::section_without(&kind.text, missing));
        }
        Ok(SectionTerm { kind, lengths: found })
    }

    fn modes(&mut self, c: &mut Cursor, space: Space) -> Parsed<ModesTerm> {
        let Some(whole) = c.inside(Delimiter::Parenthesis).map(|inside| inside.whole()) else {
            return self.expected(c, messages::example_of_modes(space));
        };
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let (mut counts, mut quadratic): ([Option<usize>; 4], bool) = ([None; 4], false);
        while !inside.is_done() {
            let label = self.word(&mut inside, "a kind of modes")?;
            let Some(way) = Way::of(space).iter().find(|way| way.word(space) == label.text) else {
                return self.fail(label.region, messages::unknown_modes(&label.text, space));
            };
            let which = *way as usize;
            if counts[which].is_some() {
                return self.fail(label.region, messages::property_twice(&label.text, "modes"));
            }
            self.punct(&mut inside, '=')?;
            if inside.eat_word("quadratic") {
                if *way != Way::Axial {
                    return self.fail(label.region, messages::quadratic_across());
                }
                // As many functions as a polynomial of second degree has that vanishes at the start.
                (quadratic, counts[which]) = (true, Some(2));
            } else {
                let term = self.expression(&mut inside)?;
                let count = self.integer(&term)?;
                counts[which] = Some(self.modes_of(count, &label.text, term.region)?);
            }
            if !inside.is_done() && !inside.eat_punct(',') {
                return self.expected(&inside, "`,` or `)`");
            }
        }
        let [axial, bending, bending_z, torsion] = counts.map(|count| count.unwrap_or(0));
        if axial + bending + bending_z + torsion == 0 {
            return self.fail(whole, messages::no_modes(space));
        }
        Ok(ModesTerm { counts: Counts { axial, bending, bending_z, torsion, quadratic }, region: whole })
    }

    fn modes_of(&mut self, count: i64, kind: &str, region: Region) -> Parsed<usize> {
        match usize::try_from(count) {
            Ok(count) if count <= MOST_MODES => Ok(count),
            _ => self.fail(region, messages::modes_out_of_range(kind, count, MOST_MODES)),
        }
    }
}
