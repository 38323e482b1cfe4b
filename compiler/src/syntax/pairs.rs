//! Contacts of all pairs: `contact pads: between(each shoe[i].pad, each wheel[j].rim) = law;` is one contact `pads[i][j]` for each pair of the surfaces that
//! are declared before it.

use super::definition::{Label, Path};
use super::parser::{Parsed, Parser};
use super::token::{Cursor, Kind, Token};
use crate::messages;
use proc_macro2::Delimiter;

/// So many contacts are written out.
const MOST: usize = 64;
/// Stands where the index of `each` does, in names that are compared.
const HERE: char = '\u{1}';

/// What one `each` goes over.
struct Each {
    variable: Label,
    /// The surfaces' name, with a mark in place of the index.
    pattern: String,
    values: Vec<i64>,
}

impl Parser<'_> {
    /// `name: between(…) = law;` or `name: gap(…) = law;` after the word `contact`, as often as it says `each`.
    pub fn contact(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the contact")?;
        let name = self.own(name);
        self.punct(c, ':')?;
        let all = self.all_of(c)?;
        if let [first, second] = &all[..]
            && first.variable.text == second.variable.text
        {
            return self.fail(second.variable.region, messages::index_shadowed(&second.variable.text));
        }
        let mut rounds = vec![Vec::new()];
        for Each { variable, values, .. } in &all {
            let with = |round: &Vec<(String, i64)>, value: &i64| {
                let own = (variable.text.clone(), *value);
                round.iter().cloned().chain([own]).collect::<Vec<_>>()
            };
            rounds =
                rounds.iter().flat_map(|round| values.iter().map(move |value| with(round, value))).collect();
        }
        // Of surfaces among each other every pair counts once.
        if let [first, second] = &all[..]
            && first.pattern == second.pattern
        {
            rounds.retain(|round| matches!(&round[..], [(_, one), (_, other)] if one < other));
        }
        match rounds.len() {
            0 => return self.fail(name.region, messages::each_of_itself(&name.text)),
            count if count > MOST => {
                return self.fail(name.region, messages::too_many_pairs(&name.text, count, MOST));
            }
            _ => {}
        }
        let start = c.clone();
        for round in rounds {
            *c = start.clone();
            let indices: String = round.iter().map(|(_, value)| format!("[{value}]")).collect();
            let own = Label { text: format!("{}{indices}", name.text), region: name.region };
            let outer = self.indices.len();
            self.indices.extend(round);
            let read = self.contact_of(c, own);
            self.indices.truncate(outer);
            read?;
        }
        Ok(())
    }

    /// Over what each `each` in the parentheses ahead goes.
    fn all_of(&mut self, c: &Cursor) -> Parsed<Vec<Each>> {
        let mut ahead = c.clone();
        ahead.advance();
        let Some(mut inside) = ahead.inside(Delimiter::Parenthesis).filter(|_| c.at_word("between")) else {
            return Ok(Vec::new());
        };
        let mut all = Vec::new();
        while !inside.is_done() {
            match eat_each(&mut inside) {
                true => all.push(self.each(&mut inside)?),
                false => inside.advance().map(|_| ()).unwrap_or_default(),
            }
        }
        Ok(all)
    }

    /// `shoe[i].pad` behind `each`: `i` is what it goes over.
    fn each(&mut self, c: &mut Cursor) -> Parsed<Each> {
        let start = c.region();
        let (mut parts, mut variable) = (Vec::new(), None);
        loop {
            let mut label = self.word(c, "the name of a surface")?;
            while let Some(inside) = c.enter(Delimiter::Bracket) {
                let own = self.free_index(&inside);
                match own.filter(|_| variable.is_none()) {
                    Some(own) => {
                        variable = Some(own);
                        label.text.push_str(&format!("[{HERE}]"));
                    }
                    None => label.text.push_str(&format!("[{}]", self.index(inside)?)),
                }
            }
            parts.push(label);
            if !(c.at_punct('.') && matches!(c.peek_second(), Some(Token { kind: Kind::Word(_), .. }))) {
                break;
            }
            c.advance();
        }
        let region = start.to(c.previous());
        let Some(variable) = variable else {
            return self.fail(region, messages::each_of_one());
        };
        let pattern = self.resolved(Path::joined(parts))?.text;
        let values = self.indices_of(&pattern);
        if values.is_empty() {
            let said = pattern.replace(HERE, &variable.text);
            return self.fail(region, messages::each_of_none(&said));
        }
        Ok(Each { variable, pattern, values })
    }

    /// A word in brackets that is no index yet.
    fn free_index(&self, inside: &Cursor) -> Option<Label> {
        let text = inside.word()?.to_string();
        let mut behind = inside.clone();
        behind.advance();
        let is_known =
            self.indices.iter().any(|(known, _)| *known == text) || self.constants.contains_key(&text);
        (behind.is_done() && !is_known).then(|| Label { text, region: inside.region() })
    }

    /// The indices of the surfaces of this name that are declared so far, ascending.
    fn indices_of(&self, pattern: &str) -> Vec<i64> {
        let Some((before, behind)) = pattern.split_once(HERE) else { return Vec::new() };
        let definition = &self.definition;
        let of_bodies = definition.bodies.iter().map(|body| format!("{}.surface", body.name.text));
        let names = definition.surfaces.iter().map(|surface| surface.name.text.clone()).chain(of_bodies);
        let index = |name: String| name.strip_prefix(before)?.strip_suffix(behind)?.parse::<i64>().ok();
        let mut found: Vec<i64> = names.filter_map(index).collect();
        found.sort_unstable();
        found.dedup();
        found
    }
}

/// `each` in front of a name.
pub(super) fn eat_each(c: &mut Cursor) -> bool {
    let is_each = c.at_word("each") && matches!(c.peek_second(), Some(Token { kind: Kind::Word(_), .. }));
    if is_each {
        c.advance();
    }
    is_each
}
