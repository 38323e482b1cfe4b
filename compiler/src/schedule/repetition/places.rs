//! Where in a row of alike parts an entry of an argument stands: `link[3].cos` is number 3 of `link[#].cos`.

use super::FEWEST_ROUNDS;
use crate::complete::Complete;
use crate::functions::{ARGUMENTS, Given, Shape};
use crate::schedule::Source;
use crate::symbolic::Op;
use std::collections::BTreeMap;

/// A number in a family whose entries follow one another at equal distances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    pub family: u32,
    pub at: i64,
}

impl Place {
    /// The same where only every so manieth is alike.
    pub fn every(self, period: u32) -> Place {
        Place {
            family: self.family * period + self.at.rem_euclid(i64::from(period)) as u32,
            at: self.at.div_euclid(i64::from(period)),
        }
    }
}

/// The places of those entries of arguments that have one, by argument and index.
#[derive(Clone, Debug, Default)]
pub struct Places {
    of: Vec<Vec<Option<Place>>>,
    count: usize,
}

impl Places {
    pub fn get(&self, source: Source) -> Option<Place> {
        *self.of.get(source.argument as usize)?.get(source.index as usize)?
    }

    fn set(&mut self, source: Source, place: Place) {
        let (argument, index) = (source.argument as usize, source.index as usize);
        self.of.resize(self.of.len().max(argument + 1), Vec::new());
        let own = &mut self.of[argument];
        own.resize(own.len().max(index + 1), None);
        own[index] = Some(place);
        self.count += 1;
    }

    /// By the names in the equations. Of several numbers in a name that one counts which gives most entries a place.
    pub fn of(complete: &Complete) -> Places {
        let named = named(complete);
        let most = named.iter().map(|(_, name)| numbers(name).count()).max().unwrap_or(0);
        let all = (0..most).map(|which| by_number(&named, which));
        all.rev().max_by_key(|places| places.count).unwrap_or_default()
    }
}

/// Entries that a loop can count through, with their names.
fn named(complete: &Complete) -> Vec<(Source, String)> {
    let graph = complete.equations.graph.read();
    let mut named = Vec::new();
    for Given { argument, shape, symbols, .. } in &ARGUMENTS {
        // Parameters and inputs are fields, and a number is no row.
        if matches!(shape, Shape::Scalar | Shape::Parameters | Shape::Inputs) {
            continue;
        }
        for (index, node) in symbols(complete).iter().enumerate() {
            if let Op::Symbol(symbol) = graph.op(*node) {
                let source = Source { argument: *argument, index: index as u32 };
                named.push((source, graph.symbol_name(symbol).to_string()));
            }
        }
    }
    named
}

/// Where numbers stand in a name.
fn numbers(name: &str) -> impl Iterator<Item = (usize, usize)> {
    let bytes = name.as_bytes();
    let digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    let starts = (0..bytes.len()).filter(move |at| digit(*at) && (*at == 0 || !digit(at - 1)));
    starts.map(move |start| (start, (start..).find(|at| !digit(*at)).unwrap_or(bytes.len())))
}

fn by_number(named: &[(Source, String)], which: usize) -> Places {
    let mut families: BTreeMap<_, Vec<(i64, Source)>> = BTreeMap::new();
    for (source, name) in named {
        let Some((start, end)) = numbers(name).nth(which) else { continue };
        let Ok(number) = name[start..end].parse::<u32>() else { continue };
        let family = (source.argument, &name[..start], &name[end..]);
        families.entry(family).or_default().push((i64::from(number), *source));
    }
    let mut places = Places::default();
    let mut family = 0;
    for (_, mut members) in families {
        members.sort_unstable();
        let mut rest = members.as_slice();
        while !rest.is_empty() {
            let (own, others) = rest.split_at(regular(rest));
            rest = others;
            if own.len() >= FEWEST_ROUNDS {
                own.iter().for_each(|(at, source)| places.set(*source, Place { family, at: *at }));
            }
            family += 1;
        }
    }
    places
}

/// How many of them follow one another, by number and at equal distances.
fn regular(members: &[(i64, Source)]) -> usize {
    let distance = |pair: &[(i64, Source)]| {
        let [(_, one), (_, next)] = pair else { return 0 };
        i64::from(next.index) - i64::from(one.index)
    };
    let first = members.get(..2).map_or(0, distance);
    let follows = |pair: &&[(i64, Source)]| pair[1].0 == pair[0].0 + 1 && distance(pair) == first;
    1 + members.windows(2).take_while(follows).count()
}
