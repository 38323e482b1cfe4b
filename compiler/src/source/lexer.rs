//! Text → lexemes of Rust, each with its place. What cannot be a token is an error at its place.
//!
//! rustc reads what stands in a macro; this reads what stands in a file, which has to be placed by line and column, and
//! what rustc would only call an unknown token. Numbers, strings and words keep their text and are judged by the parser.

use super::Located;
use crate::messages;
use proc_macro2::Delimiter;
use std::ops::Range;
use unicode_ident::{is_xid_continue, is_xid_start};

/// What a lexeme is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Word,
    /// `r#word`.
    RawWord,
    Number,
    /// A string, character or their kin.
    Text,
    /// `'name`.
    Lifetime,
    Punct(char),
    Open(Delimiter),
    Close(Delimiter),
    /// A doc comment; its text begins and ends so many bytes inside of it.
    Doc {
        inner: bool,
        ahead: usize,
        behind: usize,
    },
}

/// A lexeme and its bytes.
#[derive(Clone, Debug)]
pub(super) struct Lexeme {
    pub kind: Kind,
    pub range: Range<usize>,
}

/// All lexemes of a text; what is none is reported and left out.
pub(super) fn lex(text: &str, errors: &mut Vec<Located>) -> Vec<Lexeme> {
    let mut lexer = Lexer { text, at: opening(text), errors };
    let mut lexemes = Vec::new();
    while let Some(first) = lexer.peek() {
        let start = lexer.at;
        if let Some(kind) = lexer.lexeme(first) {
            lexemes.push(Lexeme { kind, range: start..lexer.at });
        }
    }
    lexemes
}

/// What stands before the first lexeme: a byte order mark, and `#!/usr/bin/…` of a script.
fn opening(text: &str) -> usize {
    let mark = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
    let rest = &text[mark..];
    let script = rest.starts_with("#!") && !rest[2..].trim_start().starts_with('[');
    mark + if script { rest.find('\n').unwrap_or(rest.len()) } else { 0 }
}

struct Lexer<'t, 'e> {
    text: &'t str,
    at: usize,
    errors: &'e mut Vec<Located>,
}

impl<'t> Lexer<'t, '_> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    /// Takes characters as long as they belong.
    fn take_while(&mut self, belongs: impl Fn(char) -> bool) {
        let rest = self.rest();
        self.at += rest.find(|c| !belongs(c)).unwrap_or(rest.len());
    }

    fn error<T>(&mut self, range: Range<usize>, message: String) -> Option<T> {
        self.errors.push(Located::new(range, message));
        None
    }

    /// The lexeme that begins with `first`; nothing for spaces, comments and errors.
    fn lexeme(&mut self, first: char) -> Option<Kind> {
        match first {
            _ if first.is_whitespace() => {
                self.take_while(char::is_whitespace);
                None
            }
            '/' if self.rest().starts_with("//") => self.line_comment(),
            '/' if self.rest().starts_with("/*") => self.block_comment(),
            '"' => self.string(0),
            '\'' => self.quote(),
            '0'..='9' => Some(self.number()),
            _ if first == '_' || is_xid_start(first) => self.word(),
            _ => {
                self.at += first.len_utf8();
                self.character(first)
            }
        }
    }

    fn character(&mut self, character: char) -> Option<Kind> {
        Some(match character {
            '(' => Kind::Open(Delimiter::Parenthesis),
            ')' => Kind::Close(Delimiter::Parenthesis),
            '[' => Kind::Open(Delimiter::Bracket),
            ']' => Kind::Close(Delimiter::Bracket),
            '{' => Kind::Open(Delimiter::Brace),
            '}' => Kind::Close(Delimiter::Brace),
            _ if "~!@#$%^&*-=+|;:,<.>/?".contains(character) => Kind::Punct(character),
            _ => {
                let range = self.at - character.len_utf8()..self.at;
                return self.error(range, messages::foreign_character(character));
            }
        })
    }

    /// `// …`, which is documentation with a third slash or a `!`.
    fn line_comment(&mut self) -> Option<Kind> {
        let start = self.at;
        self.take_while(|c| c != '\n');
        let comment = self.text[start..self.at].trim_end_matches('\r');
        self.at = start + comment.len();
        let outer = comment.starts_with("///") && !comment.starts_with("////");
        let inner = comment.starts_with("//!");
        (outer || inner).then_some(Kind::Doc { inner, ahead: 3, behind: 0 })
    }

    /// `/* … */`, nested.
    fn block_comment(&mut self) -> Option<Kind> {
        let start = self.at;
        let mut depth = 0;
        loop {
            let rest = self.rest();
            if rest.starts_with("/*") {
                depth += 1;
                self.at += 2;
            } else if rest.starts_with("*/") {
                depth -= 1;
                self.at += 2;
            } else if let Some(next) = rest.chars().next() {
                self.at += next.len_utf8();
            } else {
                return self.error(start..start + 2, messages::unterminated("comment", "*/"));
            }
            if depth == 0 {
                break;
            }
        }
        let comment = &self.text[start..self.at];
        let outer = comment.starts_with("/**") && !comment.starts_with("/***") && comment != "/**/";
        let inner = comment.starts_with("/*!");
        (outer || inner).then_some(Kind::Doc { inner, ahead: 3, behind: 2 })
    }

    /// A string from its quote, with the length of what stands before it.
    fn string(&mut self, prefix: usize) -> Option<Kind> {
        let start = self.at;
        self.at += prefix + 1;
        loop {
            match self.peek() {
                Some('"') => break,
                Some('\\') => {
                    self.at += 1;
                    self.at += self.peek().map_or(0, char::len_utf8);
                }
                Some(next) => self.at += next.len_utf8(),
                None => return self.error(start..start + prefix + 1, messages::unterminated("string", "\"")),
            }
        }
        self.at += 1;
        self.take_while(is_xid_continue);
        Some(Kind::Text)
    }

    /// `r"…"` or `r#"…"#` from the prefix, which ends at `quote`.
    fn raw_string(&mut self, prefix: usize, hashes: usize) -> Option<Kind> {
        let start = self.at;
        let opening = start + prefix + hashes + 1;
        let closing = format!("\"{}", "#".repeat(hashes));
        match self.text[opening..].find(&closing) {
            Some(length) => {
                self.at = opening + length + closing.len();
                self.take_while(is_xid_continue);
                Some(Kind::Text)
            }
            None => {
                self.at = self.text.len();
                self.error(start..opening, messages::unterminated("string", &closing))
            }
        }
    }

    /// `'a'`, or `'name`.
    fn quote(&mut self) -> Option<Kind> {
        let start = self.at;
        if let Some(length) = character_length(self.rest()) {
            self.at += length;
            return Some(Kind::Text);
        }
        self.at += 1;
        if self.peek().is_some_and(|c| c == '_' || is_xid_start(c)) {
            self.take_while(is_xid_continue);
            return Some(Kind::Lifetime);
        }
        self.error(start..self.at, messages::lone_quote())
    }

    /// Digits with fraction, exponent and suffix.
    fn number(&mut self) -> Kind {
        let decimal = !["0x", "0o", "0b"].iter().any(|prefix| self.rest().starts_with(prefix));
        let digits = |c: char| c.is_ascii_digit() || c == '_';
        if decimal {
            self.take_while(digits);
            let mut after = self.rest().chars();
            let point = after.next() == Some('.');
            // `0..3` is a range, `1.x` a field.
            if point && !after.next().is_some_and(|c| c == '.' || c == '_' || is_xid_start(c)) {
                self.at += 1;
                self.take_while(digits);
            }
            let exponent = self.rest().strip_prefix(['e', 'E']).unwrap_or_default();
            let unsigned = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
            if unsigned.trim_start_matches('_').starts_with(|c: char| c.is_ascii_digit()) {
                self.at = self.text.len() - unsigned.len();
                self.take_while(digits);
            }
        }
        self.take_while(is_xid_continue);
        Kind::Number
    }

    /// A word, or the prefix of a string, a byte or a raw word.
    fn word(&mut self) -> Option<Kind> {
        let start = self.at;
        self.take_while(is_xid_continue);
        let (word, rest) = (&self.text[start..self.at], self.rest());
        let hashes = rest.len() - rest.trim_start_matches('#').len();
        let length = word.len();
        match (word, rest[hashes..].chars().next()) {
            ("b" | "c", Some('"')) if hashes == 0 => {
                self.at = start;
                self.string(length)
            }
            ("r" | "br" | "cr", Some('"')) => {
                self.at = start;
                self.raw_string(length, hashes)
            }
            ("b", Some('\'')) if hashes == 0 && character_length(rest).is_some() => self.quote(),
            ("r", Some(next)) if hashes == 1 && (next == '_' || is_xid_start(next)) => {
                self.at += 1;
                self.take_while(is_xid_continue);
                Some(Kind::RawWord)
            }
            _ => Some(Kind::Word),
        }
    }
}

/// Length of the character literal that begins here with its quote.
fn character_length(text: &str) -> Option<usize> {
    let line = text[1..].lines().next().unwrap_or_default();
    let first = line.chars().next().filter(|first| *first != '\'')?;
    // A backslash takes the character behind it along, whatever it is.
    let least = line.chars().take(if first == '\\' { 2 } else { 1 }).map(char::len_utf8).sum();
    let rest = &line[least..];
    let length = if first == '\\' { rest.find('\'')? } else { rest.starts_with('\'').then_some(0)? };
    Some(1 + least + length + 1)
}
