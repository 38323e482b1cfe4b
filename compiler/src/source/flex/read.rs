//! The text of a `.flex` file: words and numbers between blanks, `#` before comments, version 1. A word is followed by as many numbers as it
//! takes, on as many lines as one likes.

use super::super::Source;
use crate::messages;
use crate::modal::{Node, Reduced, Square};
use std::collections::BTreeMap;

/// Most modes of a file.
const MOST_MODES: usize = 60;

/// Where a word stands: line and column from 1, columns in characters.
#[derive(Clone, Copy, Debug)]
pub(super) struct At {
    line: usize,
    column: usize,
}

impl At {
    pub fn of(self, source: &Source) -> String {
        messages::place_in_file(&source.name, self.line, self.column)
    }
}

/// Where numbers stand, section by section.
pub(super) struct Places {
    pub sections: BTreeMap<&'static str, Vec<At>>,
    pub nodes: Vec<At>,
    /// Where modes are said to be orthogonal.
    pub orthogonal: Option<At>,
}

impl Places {
    /// Of an entry of a section.
    pub fn entry(&self, section: &str, index: usize) -> At {
        let places = self.sections.get(section);
        places.and_then(|places| places.get(index)).copied().unwrap_or(At { line: 1, column: 1 })
    }
}

/// What stands behind the word of a section.
struct Section {
    word: &'static str,
    /// How many numbers, by the number of modes.
    count: fn(usize) -> usize,
    of_modes: bool,
}

const SECTIONS: [Section; 8] = [
    Section { word: "mass", count: |_| 1, of_modes: false },
    Section { word: "center", count: |_| 3, of_modes: false },
    Section { word: "inertia", count: |_| 6, of_modes: false },
    Section { word: "momentum", count: |n| 3 * n, of_modes: true },
    Section { word: "angular_momentum", count: |n| 3 * n, of_modes: true },
    Section { word: "moments", count: |n| (3 + 3 * n) * (3 + 3 * n), of_modes: true },
    Section { word: "generalised_mass", count: |n| n * n, of_modes: true },
    Section { word: "stiffness", count: |n| n * n, of_modes: true },
];

struct Words<'s> {
    source: &'s Source,
    all: Vec<(At, &'s str)>,
    next: usize,
}

impl<'s> Words<'s> {
    fn of(source: &'s Source) -> Self {
        let mut all = Vec::new();
        for (index, line) in source.text.lines().enumerate() {
            let line = line.trim_start_matches('\u{feff}');
            let told = line.split('#').next().unwrap_or_default();
            for word in told.split_whitespace() {
                let start = word.as_ptr() as usize - line.as_ptr() as usize;
                all.push((At { line: index + 1, column: line[..start].chars().count() + 1 }, word));
            }
        }
        Words { source, all, next: 0 }
    }

    fn next(&mut self) -> Option<(At, &'s str)> {
        let word = self.all.get(self.next).copied();
        self.next += 1;
        word
    }

    fn fail<T>(&self, at: At, message: String) -> Result<T, String> {
        Err(at.of(self.source) + &message)
    }

    /// As many numbers as `what` has.
    fn numbers(&mut self, at: At, what: &str, count: usize) -> Result<(Vec<f64>, Vec<At>), String> {
        let (mut values, mut places) = (Vec::new(), Vec::new());
        while values.len() < count {
            let Some((place, word)) = self.next() else {
                return self.fail(at, messages::flex_too_few(what, values.len(), count));
            };
            match word.parse::<f64>() {
                Ok(value) if value.is_finite() => values.push(value),
                _ if word.starts_with(|c: char| c.is_ascii_lowercase()) => {
                    return self.fail(place, messages::flex_ends_early(what, values.len(), count, word));
                }
                _ => return self.fail(place, messages::csv_no_number(word)),
            }
            places.push(place);
        }
        Ok((values, places))
    }

    fn whole(&mut self, at: At, what: &str) -> Result<(At, u64), String> {
        match self.next() {
            Some((place, word)) => match word.parse() {
                Ok(number) => Ok((place, number)),
                Err(_) => self.fail(place, messages::flex_no_count(what, word)),
            },
            None => self.fail(at, messages::flex_too_few(what, 0, 1)),
        }
    }
}

/// Everything in its place; nothing is known of its meaning yet.
pub(super) fn read(source: &Source) -> Result<(Reduced, Places), String> {
    let words = &mut Words::of(source);
    version(words)?;
    let mut places = Places { sections: BTreeMap::new(), nodes: Vec::new(), orthogonal: None };
    let mut found: BTreeMap<&'static str, Vec<f64>> = BTreeMap::new();
    let mut modes: Option<usize> = None;
    let mut nodes: Vec<Node> = Vec::new();
    while let Some((at, word)) = words.next() {
        let section = SECTIONS.iter().find(|section| section.word == word);
        match (word, section) {
            ("modes", _) => {
                let (place, count) = words.whole(at, "modes")?;
                if modes.is_some() {
                    return words.fail(at, messages::flex_twice("modes"));
                }
                modes = match usize::try_from(count) {
                    Ok(count @ 1..=MOST_MODES) => Some(count),
                    _ => return words.fail(place, messages::flex_modes_out_of_range(count, MOST_MODES)),
                };
            }
            ("orthogonal", _) => places.orthogonal = Some(at),
            ("node", _) => {
                let Some(modes) = modes else { return words.fail(at, messages::flex_modes_first("node")) };
                let node = node(words, at, modes, &nodes)?;
                nodes.push(node);
                places.nodes.push(at);
            }
            (_, Some(section)) => {
                if section.of_modes && modes.is_none() {
                    return words.fail(at, messages::flex_modes_first(word));
                }
                if found.contains_key(section.word) {
                    return words.fail(at, messages::flex_twice(word));
                }
                let (values, own) = words.numbers(at, word, (section.count)(modes.unwrap_or(0)))?;
                found.insert(section.word, values);
                places.sections.insert(section.word, own);
            }
            _ if word.parse::<f64>().is_ok() => return words.fail(at, messages::flex_too_many(word)),
            _ => {
                let known = SECTIONS.iter().map(|section| section.word);
                let known = known.chain(["modes", "orthogonal", "node"]);
                return words.fail(at, messages::flex_unknown(word, &known.collect::<Vec<_>>()));
            }
        }
    }
    let end = words.all.last().map_or(At { line: 1, column: 1 }, |(at, _)| *at);
    let Some(modes) = modes else { return words.fail(end, messages::flex_missing("modes")) };
    if let Some(missing) = SECTIONS.iter().find(|section| !found.contains_key(section.word)) {
        return words.fail(end, messages::flex_missing(missing.word));
    }
    if nodes.is_empty() {
        return words.fail(end, messages::flex_without_nodes());
    }
    Ok((reduced(&found, modes, nodes), places))
}

fn version(words: &mut Words) -> Result<(), String> {
    let start = At { line: 1, column: 1 };
    match (words.next(), words.next()) {
        (Some((_, "flex")), Some((_, "1"))) => Ok(()),
        (Some((_, "flex")), Some((at, version))) => words.fail(at, messages::flex_version(version)),
        (Some((at, _)), _) => words.fail(at, messages::flex_not_begun()),
        (None, _) => words.fail(start, messages::flex_not_begun()),
    }
}

/// `node 17  x y z`, and six rows of one number for each mode: how it moves along x, y, z and turns about them.
fn node(words: &mut Words, at: At, modes: usize, known: &[Node]) -> Result<Node, String> {
    let (_, number) = words.whole(at, "node")?;
    let (values, _) = words.numbers(at, &messages::flex_node(number), 3 + 6 * modes)?;
    let place = [values[0], values[1], values[2]];
    if known.iter().any(|node| node.number == number) {
        return words.fail(at, messages::flex_twice(&messages::flex_node(number)));
    }
    if let Some(other) = known.iter().find(|node| node.at == place) {
        return words.fail(at, messages::flex_nodes_at_one_place(number, other.number));
    }
    let rows = |first: usize| columns(&values[3 + first * modes..], modes);
    Ok(Node { number, at: place, shifts: rows(0), turns: rows(3) })
}

/// Three rows as one vector for each mode.
fn columns(rows: &[f64], modes: usize) -> Vec<[f64; 3]> {
    (0..modes).map(|mode| [0, 1, 2].map(|axis| rows[axis * modes + mode])).collect()
}

fn reduced(found: &BTreeMap<&'static str, Vec<f64>>, modes: usize, nodes: Vec<Node>) -> Reduced {
    let of = |word: &str| found[word].as_slice();
    let square = |word: &str, n: usize| -> Square { of(word).chunks(n).map(<[f64]>::to_vec).collect() };
    let [xx, yy, zz, xy, xz, yz] = [0, 1, 2, 3, 4, 5].map(|k| of("inertia")[k]);
    Reduced {
        mass: of("mass")[0],
        center: [0, 1, 2].map(|k| of("center")[k]),
        inertia: [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]],
        momentum: columns(of("momentum"), modes),
        angular_momentum: columns(of("angular_momentum"), modes),
        moments: square("moments", 3 + 3 * modes),
        generalised_mass: square("generalised_mass", modes),
        stiffness: square("stiffness", modes),
        nodes,
        numbers: (1..=modes).collect(),
    }
}
