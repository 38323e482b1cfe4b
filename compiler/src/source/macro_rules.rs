//! `macro_rules!` of a file that write definitions: rules, what they match, what they write. Every token keeps the place at
//! which it was written, in the rule or in the call.
//!
//! What matters for definitions is followed: repetitions, and the fragments `ident`, `tt`, `literal`, `meta`, `lifetime`,
//! `vis`, `block` and `expr`. A rule with another one fits nothing.

use super::tokens::{Piece, What, group, tree};
use crate::syntax::DEEPEST;
use proc_macro2::Delimiter;
use std::collections::BTreeMap;
use std::ops::Range;

/// The rules of one macro.
#[derive(Clone, Debug)]
pub(super) struct MacroRules {
    /// Where it is defined.
    pub range: Range<usize>,
    /// Matcher and what it writes.
    rules: Vec<(Vec<Piece>, Vec<Piece>)>,
}

/// What a variable stands for: tokens, or one of each round of a repetition.
#[derive(Clone, Debug)]
enum Bound {
    One(Vec<Piece>),
    Rounds(Vec<Bound>),
}

type Bindings = BTreeMap<String, Bound>;

impl MacroRules {
    /// `(matcher) => { text }; …`
    pub fn new(mut inside: &[Piece], range: Range<usize>) -> Self {
        let mut rules = Vec::new();
        if depth(inside) > DEEPEST {
            return Self { range, rules };
        }
        loop {
            let matcher = group(inside);
            let text = group(inside.get(matcher + 2..).unwrap_or_default());
            if matcher == 0 || text == 0 {
                return Self { range, rules };
            }
            let content = |start: usize, length: usize| inside[start + 1..start + length - 1].to_vec();
            rules.push((content(0, matcher), content(matcher + 2, text)));
            inside = &inside[matcher + 2 + text..];
            if inside.first().is_some_and(|piece| piece.is(";")) {
                inside = &inside[1..];
            }
        }
    }

    /// What the first rule writes that fits the call.
    pub fn expand(&self, call: &[Piece]) -> Option<Vec<Piece>> {
        let fitting = |(matcher, text): &(Vec<Piece>, Vec<Piece>)| {
            let mut bindings = Bindings::new();
            let taken = fit(matcher, call, &mut bindings)?;
            (taken == call.len()).then(|| write(text, &bindings))?
        };
        self.rules.iter().find_map(fitting)
    }
}

/// One step of a matcher or of a text.
enum Step<'p> {
    Token(&'p Piece),
    /// `$name`, and `:fragment` in a matcher.
    Variable(String, String),
    /// `$( … ) separator operator`.
    Repeat(&'p [Piece], Option<&'p Piece>, char),
}

/// The first step and how many pieces it has.
fn step(pieces: &[Piece]) -> (Step<'_>, usize) {
    let first = &pieces[0];
    let rest = &pieces[1..];
    if !first.is("$") || rest.is_empty() {
        return (Step::Token(first), 1);
    }
    let length = group(rest);
    if length > 0 {
        let operator =
            |at: usize| ["*", "+", "?"].into_iter().find(|text| rest.get(at).is_some_and(|p| p.is(text)));
        let inside = &rest[1..length - 1];
        let sign = |text: &str| text.chars().next().unwrap_or('*');
        return match (operator(length), operator(length + 1)) {
            (Some(text), _) => (Step::Repeat(inside, None, sign(text)), length + 2),
            (None, Some(text)) => (Step::Repeat(inside, rest.get(length), sign(text)), length + 3),
            (None, None) => (Step::Token(first), 1),
        };
    }
    match (rest[0].word(), rest.get(1), rest.get(2).and_then(Piece::word)) {
        (Some(name), Some(colon), Some(fragment)) if colon.is(":") => (Step::Variable(name, fragment), 4),
        (Some(name), ..) => (Step::Variable(name, String::new()), 2),
        _ => (Step::Token(first), 1),
    }
}

/// How many pieces of the call the matcher takes from its beginning; nothing if it does not fit.
fn fit(mut matcher: &[Piece], call: &[Piece], bindings: &mut Bindings) -> Option<usize> {
    let mut at = 0;
    while !matcher.is_empty() {
        let (step, length) = step(matcher);
        let rest = &call[at..];
        at += match step {
            Step::Token(expected) if same(expected, rest.first()?) => 1,
            Step::Token(_) => return None,
            Step::Variable(name, kind) => {
                let taken = fragment(&kind, rest)?;
                let mut tokens = rest[..taken].to_vec();
                if taken > 1 && ["expr", "literal"].contains(&kind.as_str()) {
                    tokens = grouped(tokens);
                }
                bindings.insert(name, Bound::One(tokens));
                taken
            }
            Step::Repeat(inside, separator, operator) => rounds(inside, separator, operator, rest, bindings)?,
        };
        matcher = &matcher[length..];
    }
    Some(at)
}

/// The rounds of a repetition, as many as fit.
fn rounds(
    inside: &[Piece],
    separator: Option<&Piece>,
    operator: char,
    call: &[Piece],
    bindings: &mut Bindings,
) -> Option<usize> {
    let mut found: Vec<Bindings> = Vec::new();
    let mut at = 0;
    while operator != '?' || found.is_empty() {
        let mut start = at;
        if let (Some(separator), false) = (separator, found.is_empty()) {
            match call.get(at) {
                Some(next) if same(separator, next) => start += 1,
                _ => break,
            }
        }
        let mut round = Bindings::new();
        match fit(inside, &call[start..], &mut round) {
            Some(taken) if taken > 0 => {
                at = start + taken;
                found.push(round);
            }
            _ => break,
        }
    }
    if operator == '+' && found.is_empty() {
        return None;
    }
    for name in variables(inside) {
        let rounds = found.iter().filter_map(|round| round.get(&name).cloned()).collect();
        bindings.insert(name, Bound::Rounds(rounds));
    }
    Some(at)
}

/// All variables, those in repetitions too.
fn variables(pieces: &[Piece]) -> Vec<String> {
    let pairs = pieces.windows(2).filter(|pair| pair[0].is("$"));
    pairs.filter_map(|pair| pair[1].word()).collect()
}

/// How many pieces a fragment of this kind takes.
fn fragment(kind: &str, call: &[Piece]) -> Option<usize> {
    let first = call.first();
    let length = match kind {
        "tt" => tree(call),
        "ident" => usize::from(first?.word().is_some()),
        "lifetime" if first?.is("'") => 2,
        "literal" if first?.is_literal() => 1,
        "literal" if first?.is("-") && call.get(1)?.is_literal() => 2,
        "block" if matches!(first?.what, What::Open(Delimiter::Brace)) => tree(call),
        "vis" if first.is_some_and(|piece| piece.is("pub")) => {
            let inside = matches!(call.get(1), Some(Piece { what: What::Open(Delimiter::Parenthesis), .. }));
            return Some(1 + if inside { tree(&call[1..]) } else { 0 });
        }
        "vis" => return Some(0),
        // `name`, `name(…)`, `name = value`; both end where their group ends, or where only these may follow.
        "meta" | "expr" => {
            let ends = |rest: &[Piece]| rest[0].is(",") || rest[0].is(";") || (kind == "expr" && arrow(rest));
            let mut at = 0;
            while tree(&call[at..]) > 0 && !ends(&call[at..]) {
                at += tree(&call[at..]);
            }
            at
        }
        _ => 0,
    };
    (length > 0).then_some(length)
}

fn arrow(call: &[Piece]) -> bool {
    matches!(call, [first, second, ..] if first.is("=") && second.is(">"))
}

/// A fragment that is one operand, whatever stands beside it.
fn grouped(tokens: Vec<Piece>) -> Vec<Piece> {
    let (first, last) = (tokens[0].place.start, tokens[tokens.len() - 1].place.end);
    let open = Piece { what: What::Open(Delimiter::None), place: first..first };
    let close = Piece { what: What::Close(Delimiter::None), place: last..last };
    [vec![open], tokens, vec![close]].concat()
}

fn same(expected: &Piece, found: &Piece) -> bool {
    match (&expected.what, &found.what) {
        (What::Leaf(one), What::Leaf(other)) => one.to_string() == other.to_string(),
        (What::Open(one), What::Open(other)) | (What::Close(one), What::Close(other)) => one == other,
        _ => false,
    }
}

/// How deep groups are nested.
fn depth(pieces: &[Piece]) -> usize {
    let (mut depth, mut most) = (0usize, 0);
    for piece in pieces {
        match piece.what {
            What::Open(_) => depth += 1,
            What::Close(_) => depth = depth.saturating_sub(1),
            What::Leaf(_) => {}
        }
        most = most.max(depth);
    }
    most
}

/// The text of a rule with its variables filled in; nothing if their repetitions do not fit.
fn write(mut text: &[Piece], bindings: &Bindings) -> Option<Vec<Piece>> {
    let mut written = Vec::new();
    while !text.is_empty() {
        let (step, length) = step_of_text(text);
        match step {
            Step::Token(piece) => written.push(piece.clone()),
            Step::Variable(name, _) => match bindings.get(&name) {
                Some(Bound::One(tokens)) => written.extend(tokens.iter().cloned()),
                Some(Bound::Rounds(_)) => return None,
                None => written.extend(text[..length].iter().cloned()),
            },
            Step::Repeat(inside, separator, _) => {
                let names = variables(inside);
                let repeated = |name: &String| match bindings.get(name) {
                    Some(Bound::Rounds(rounds)) => Some(rounds.len()),
                    _ => None,
                };
                let count = names.iter().filter_map(repeated).max()?;
                for round in 0..count {
                    let of_round = |name: &String| {
                        let bound = match bindings.get(name)? {
                            Bound::Rounds(rounds) => rounds.get(round)?,
                            one => one,
                        };
                        Some((name.clone(), bound.clone()))
                    };
                    let inner: Bindings = names.iter().filter_map(of_round).collect();
                    written.extend(separator.filter(|_| round > 0).cloned());
                    written.extend(write(inside, &inner)?);
                }
            }
        }
        text = &text[length..];
    }
    Some(written)
}

/// The same as [`step`]: behind a variable of a text a `:` belongs to the text.
fn step_of_text(text: &[Piece]) -> (Step<'_>, usize) {
    match step(text) {
        (Step::Variable(name, _), _) => (Step::Variable(name, String::new()), 2),
        other => other,
    }
}
