//! Uses of parts: `part left: Leg(hip = hull.left, side = -1);` reads the braces of `Leg` once more, with names of its own.

use super::definition::{Entry, Given, Label, PartUse, Path, PlaceTerm, PortKind, Signal, Term, WrittenUnit};
use super::parser::{Failed, Parsed, Parser};
use super::scope::{Port, Scope};
use super::shelf::Declared;
use super::token::{Cursor, Kind};
use crate::messages;
use proc_macro2::Delimiter;

/// `hip: place`, or `side [1] = 1`.
struct PortTerm<'t> {
    name: Label,
    /// Nothing of a value.
    kind: Option<PortKind>,
    unit: Option<WrittenUnit>,
    default: Option<Cursor<'t>>,
}

/// What stands behind the name of a port in a use.
struct Argument {
    name: Label,
    unit: Option<WrittenUnit>,
    value: ArgumentValue,
}

enum ArgumentValue {
    Place(PlaceTerm),
    Named(Path),
    Value(Term),
}

impl<'t> Parser<'t> {
    /// A declaration, which has been read before, or a use, after the word `part`.
    pub fn part(&mut self, c: &mut Cursor<'_>) -> Parsed<()> {
        let mut ahead = c.clone();
        ahead.advance();
        if ahead.enter(Delimiter::Parenthesis).is_some() || ahead.inside(Delimiter::Brace).is_some() {
            return self.declaration_of_part(c);
        }
        if ahead.at_punct('=') {
            return self.part_of_file(c);
        }
        let name = self.declared(c, "the name of the part")?;
        if !c.eat_punct(':') {
            return self.expected(c, "`:` and which part it is, such as `Leg(hip = hull.left);`");
        }
        let part = self.word(c, "the name of a declared part")?;
        if self.scope.file.is_none() && self.declarations.missing.contains(&part.text) {
            // Said where it should come from.
            return Err(Failed);
        }
        let Some(declared) = self.declarations.get(self.scope.file, &part.text).cloned() else {
            let message = messages::unknown("part", &part.text, self.declarations.similar(&part.text));
            return self.fail(part.region, message);
        };
        let inside = self.group(c, Delimiter::Parenthesis)?;
        let name = self.own(name);
        let used = PartUse {
            region: name.region.to(c.previous()),
            name,
            part: part.text.clone(),
            given: Vec::new(),
            file: declared.file,
        };
        self.semicolon(c)?;
        self.use_part(&part, used, &declared, inside)
    }

    /// Over `Leg(…) { … }`.
    fn declaration_of_part(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.word(c, "the name of the part")?;
        c.enter(Delimiter::Parenthesis);
        if c.enter(Delimiter::Brace).is_none() {
            return self.expected(c, "`{` and the statements of the part");
        }
        if self.scope.name.is_some() || !self.indices.is_empty() {
            return self.fail(name.region, messages::part_within(&name.text));
        }
        self.definition.parts.push(name);
        Ok(())
    }

    /// Over `Leg = file("leg.mech");`
    fn part_of_file(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.word(c, "the name of the part")?;
        self.punct(c, '=')?;
        if !c.eat_word("file") {
            return self.expected(c, "`file(\"…\")`");
        }
        let inside = self.group(c, Delimiter::Parenthesis)?;
        if !matches!(inside.peek().map(|token| &token.kind), Some(Kind::Text(_))) {
            return self.expected(&inside, "the name of a file in quotes");
        }
        self.semicolon(c)?;
        if self.scope.name.is_some() || !self.indices.is_empty() {
            return self.fail(name.region, messages::part_within(&name.text));
        }
        self.definition.parts.push(name);
        Ok(())
    }

    fn use_part(
        &mut self,
        part: &Label,
        used: PartUse,
        declared: &Declared<'t>,
        arguments: Cursor,
    ) -> Parsed<()> {
        let key = (declared.file, declared.name.text.clone());
        if self.scope.within.contains(&key) {
            let names = self.scope.within.iter().map(|(_, name)| name.as_str());
            let circle: Vec<&str> = names.skip_while(|name| *name != key.1).chain([key.1.as_str()]).collect();
            return self.fail(part.region, messages::part_of_itself(&circle));
        }
        if let Some(space) = declared.space.filter(|space| *space != self.definition.space) {
            return self.fail(part.region, messages::part_of_other_space(&part.text, space));
        }
        if let Some(first) = self.definition.uses.iter().find(|first| first.name.text == used.name.text) {
            let (at, name) = (used.name.region, &used.name.text);
            if first.name.region.serials() == at.serials() && first.name.region.brought() == at.brought() {
                return self.fail(at, messages::declared_by_rounds(name));
            }
            let (message, note) = (messages::duplicate(name, name), messages::first_here(name));
            self.diagnostics.conflict(at, message, first.name.region, note);
            return Err(Failed);
        }
        let statements = 1 + declared.body.count_statements();
        if statements > self.budget {
            self.budget = 0;
            return self.fail(part.region, messages::too_many_parts(super::MOST_STATEMENTS));
        }
        self.budget -= statements;
        let brought = self.definition.uses.len() as u32 + 1;
        let whole = used.region;
        // What it is given is said in the words of where it is used.
        let mut scope = Scope {
            name: Some(used.name.text.clone()),
            file: declared.file,
            within: self.scope.within.iter().cloned().chain([key]).collect(),
            inner: declared.inner.clone(),
            ..Scope::default()
        };
        self.definition.uses.push(used);
        let ports = self.ports(declared, brought)?;
        let mut given = self.arguments_of_part(&part.text, &ports, arguments)?;
        let mut missing = false;
        let mut values = Vec::new();
        for port in ports {
            let name = port.name.text.clone();
            let found = given.iter().position(|argument| argument.name.text == name);
            match (found.map(|index| given.swap_remove(index)), port.default.clone()) {
                (Some(Argument { value: ArgumentValue::Place(PlaceTerm::Ground(ground)), .. }), _) => {
                    scope.ports.insert(name, Port::Ground(ground));
                }
                (Some(Argument { value: ArgumentValue::Place(PlaceTerm::Named(path)), .. }), _)
                | (Some(Argument { value: ArgumentValue::Named(path), .. }), _) => {
                    let kind = port.kind.unwrap_or(PortKind::Place);
                    let entry = Given { port: name.clone(), kind, path: path.clone() };
                    self.definition.uses[brought as usize - 1].given.push(entry);
                    scope.ports.insert(name, Port::Named(path));
                }
                (Some(Argument { value: ArgumentValue::Value(value), unit, .. }), _) => {
                    scope.ports.insert(name, Port::Value);
                    values.push((port, Ok(Entry { unit, value }.term())));
                }
                (None, Some(default)) => {
                    scope.ports.insert(name, Port::Value);
                    values.push((port, Err(default)));
                }
                (None, None) => {
                    let kind = port.kind.map(PortKind::word);
                    let message = messages::port_not_given(&part.text, &name, kind);
                    self.diagnostics.error(whole, message);
                    missing = true;
                }
            }
        }
        if missing {
            return Err(Failed);
        }
        let outer = std::mem::replace(&mut self.scope, scope);
        let indices = std::mem::take(&mut self.indices);
        let read = self.inside_of_part(values, &declared.body.brought_by(brought));
        self.scope = outer;
        self.indices = indices;
        read
    }

    /// Values that were given, as signals, and the statements.
    fn inside_of_part(
        &mut self,
        values: Vec<(PortTerm<'t>, Result<Term, Cursor<'t>>)>,
        body: &Cursor,
    ) -> Parsed<()> {
        for (port, value) in values {
            let value = match value {
                Ok(value) => value,
                Err(mut default) => {
                    let value = self.expression(&mut default)?;
                    if !default.is_done() && !default.at_punct(',') {
                        return self.expected(&default, "`,` or `)`");
                    }
                    value
                }
            };
            let name = self.own(port.name);
            self.constants.insert(name.text.clone(), value.clone());
            self.definition.signals.push(Signal { name, entry: Entry { unit: port.unit, value } });
        }
        self.constants_first(body.clone());
        self.statements(body.clone());
        Ok(())
    }

    /// `(hip: place, side [1] = 1)`
    fn ports(&mut self, declared: &Declared<'t>, brought: u32) -> Parsed<Vec<PortTerm<'t>>> {
        let mut ports: Vec<PortTerm> = Vec::new();
        let Some(inside) = &declared.ports else { return Ok(ports) };
        let mut c = inside.brought_by(brought);
        while !c.is_done() {
            let name = self.word(&mut c, "the name of a port")?;
            let mut port = PortTerm { name, kind: None, unit: None, default: None };
            if BUILT_IN_OR_KEYWORD.iter().any(|words| words.contains(&port.name.text.as_str())) {
                return self.fail(port.name.region, messages::reserved(&port.name.text));
            }
            if let Some(first) = ports.iter().find(|first| first.name.text == port.name.text) {
                let (message, note) = (
                    messages::property_twice(&port.name.text, &declared.name.text),
                    messages::first_here(&port.name.text),
                );
                self.diagnostics.conflict(port.name.region, message, first.name.region, note);
                return Err(Failed);
            }
            if c.eat_punct(':') {
                let kind = self.word(&mut c, &messages::one_of(&PortKind::ALL.map(PortKind::word)))?;
                port.kind = PortKind::ALL.into_iter().find(|known| known.word() == kind.text);
                if port.kind.is_none() {
                    let message = messages::unknown_kind_of_port(&port.name.text, &kind.text);
                    return self.fail(kind.region, message);
                }
            } else {
                port.unit = self.unit(&mut c)?;
                if c.eat_punct('=') {
                    port.default = Some(c.clone());
                    while !c.is_done() && !c.at_punct(',') {
                        c.advance();
                    }
                }
            }
            ports.push(port);
            if !c.is_done() && !c.eat_punct(',') {
                return self.expected(&c, "`,` or `)`");
            }
        }
        Ok(ports)
    }

    /// `(hip = hull.left, side = -1)`
    fn arguments_of_part(&mut self, part: &str, ports: &[PortTerm], mut c: Cursor) -> Parsed<Vec<Argument>> {
        let mut arguments: Vec<Argument> = Vec::new();
        while !c.is_done() {
            let name = self.word(&mut c, "the name of a port")?;
            let names = || ports.iter().map(|port| port.name.text.as_str()).collect::<Vec<_>>();
            let Some(port) = ports.iter().find(|port| port.name.text == name.text) else {
                return self.fail(name.region, messages::no_such_port(part, &name.text, &names()));
            };
            if let Some(first) = arguments.iter().find(|first| first.name.text == name.text) {
                let (message, note) =
                    (messages::property_twice(&name.text, part), messages::first_here(&name.text));
                self.diagnostics.conflict(name.region, message, first.name.region, note);
                return Err(Failed);
            }
            let unit = if port.kind.is_none() { self.unit(&mut c)? } else { None };
            if !c.eat_punct('=') {
                let what = format!("`=` and what `{}` is given", name.text);
                return self.expected(&c, &what);
            }
            let value = match port.kind {
                Some(PortKind::Place) => ArgumentValue::Place(self.place(&mut c)?),
                Some(PortKind::Body | PortKind::Joint | PortKind::Table) => {
                    let label = self.label(&mut c, "a name")?;
                    let (text, region) = (label.text.clone(), label.region);
                    ArgumentValue::Named(Path { text, parts: vec![label], region })
                }
                None => ArgumentValue::Value(self.expression(&mut c)?),
            };
            arguments.push(Argument { name, unit, value });
            if !c.is_done() && !c.eat_punct(',') {
                return self.expected(&c, "`,` or `)`");
            }
        }
        Ok(arguments)
    }
}

/// What no port may be called.
const BUILT_IN_OR_KEYWORD: [&[&str]; 2] = [&super::scope::BUILT_IN, &super::token::KEYWORDS];
