//! Joints, constraints and loads: a name, a colon, a kind with places and named arguments.
//!
//! A table says which arguments each kind takes; what the places are is left to `model`.

use super::definition::{
    Constraint, ConstraintTerm, Entry, FirstTerm, Joint, JointWord, Label, LineTerm, Load, LoadTerm,
    Operator, PlaceTerm, Space, Term, TermKind, Tuple,
};
use super::expression::is_call;
use super::parser::{Failed, Parsed, Parser};
use super::token::Cursor;
use crate::diagnostics::Region;
use crate::messages::{self, Habit};
use proc_macro2::Delimiter;

/// What a positional argument is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Place,
    Line,
    /// The name of a joint or body.
    Rotor,
}

/// How a kind is written.
struct Form {
    word: &'static str,
    positional: &'static [Kind],
    /// Name and whether it must be given.
    named: &'static [(&'static str, bool)],
}

const PLACES: &[Kind] = &[Kind::Place, Kind::Place];

const JOINTS: [Form; 5] = [
    Form { word: "fixed", positional: PLACES, named: &[("angle", false)] },
    Form { word: "revolute", positional: PLACES, named: &[] },
    Form { word: "prismatic", positional: PLACES, named: &[("axis", true), ("angle", false)] },
    Form { word: "point_on_line", positional: &[Kind::Line, Kind::Place], named: &[] },
    Form { word: "distance", positional: PLACES, named: &[("length", true)] },
];

/// Whether an axis must be written depends on whether a place has one: that is left to `model`.
const SPATIAL_JOINTS: [Form; 12] = [
    Form { word: "fixed", positional: PLACES, named: &[] },
    Form { word: "revolute", positional: PLACES, named: &[("axis", false)] },
    Form { word: "prismatic", positional: PLACES, named: &[("axis", false)] },
    Form { word: "cylindrical", positional: PLACES, named: &[("axis", false)] },
    Form { word: "screw", positional: PLACES, named: &[("axis", false), ("pitch", true)] },
    Form { word: "universal", positional: PLACES, named: &[("axis", true), ("second_axis", true)] },
    Form { word: "spherical", positional: PLACES, named: &[] },
    Form { word: "planar", positional: PLACES, named: &[("axis", false)] },
    Form { word: "constant_velocity", positional: PLACES, named: &[("axis", false)] },
    Form { word: "point_on_line", positional: &[Kind::Line, Kind::Place], named: &[] },
    Form { word: "point_on_plane", positional: PLACES, named: &[("axis", false)] },
    Form { word: "distance", positional: PLACES, named: &[("length", true)] },
];

const ROTORS: &[Kind] = &[Kind::Rotor, Kind::Rotor];

/// Bevel and worm gears are gears, whatever the axes; a belt is a gear by its radii, a screw a rack by its pitch, and a
/// differential an equation.
const COUPLINGS: [Form; 7] = [
    Form { word: "gear", positional: ROTORS, named: &[("ratio", true), ("phase", false)] },
    Form { word: "bevel", positional: ROTORS, named: &[("ratio", true), ("phase", false)] },
    Form { word: "worm", positional: ROTORS, named: &[("ratio", true), ("phase", false)] },
    Form {
        word: "belt",
        positional: ROTORS,
        named: &[("radius", true), ("second_radius", true), ("phase", false)],
    },
    Form { word: "rack", positional: ROTORS, named: &[("radius", true), ("phase", false)] },
    Form { word: "screw", positional: ROTORS, named: &[("pitch", true), ("phase", false)] },
    Form { word: "differential", positional: &[Kind::Rotor, Kind::Rotor, Kind::Rotor], named: &[] },
];

const LOADS: [Form; 5] = [
    Form { word: "force", positional: &[Kind::Place], named: &[("direction", false)] },
    Form { word: "torque", positional: &[Kind::Rotor], named: &[] },
    Form {
        word: "spring",
        positional: &[Kind::Place, Kind::Place],
        named: &[("stiffness", true), ("length", true), ("damping", false)],
    },
    Form { word: "damper", positional: &[Kind::Place, Kind::Place], named: &[("damping", true)] },
    Form {
        word: "torsion_spring",
        positional: &[Kind::Rotor],
        named: &[("stiffness", true), ("angle", false), ("damping", false)],
    },
];

/// The arguments of one call.
#[derive(Default)]
struct Arguments {
    places: Vec<PlaceTerm>,
    lines: Vec<LineTerm>,
    rotors: Vec<Label>,
    entries: Vec<(Label, Entry)>,
    tuples: Vec<(Label, Tuple)>,
}

impl Arguments {
    fn place(&mut self) -> Parsed<PlaceTerm> {
        if self.places.is_empty() { Err(Failed) } else { Ok(self.places.remove(0)) }
    }

    fn rotor(&mut self) -> Parsed<Label> {
        if self.rotors.is_empty() { Err(Failed) } else { Ok(self.rotors.remove(0)) }
    }

    fn entry(&mut self, name: &str) -> Option<Entry> {
        let index = self.entries.iter().position(|(label, _)| label.text == name)?;
        Some(self.entries.remove(index).1)
    }

    fn required(&mut self, name: &str) -> Parsed<Entry> {
        self.entry(name).ok_or(Failed)
    }

    fn tuple(&mut self, name: &str) -> Option<Tuple> {
        let index = self.tuples.iter().position(|(label, _)| label.text == name)?;
        Some(self.tuples.remove(index).1)
    }
}

impl Parser {
    /// `name: kind(…);` after the word `joint`.
    pub fn joint(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the joint")?;
        if !c.eat_punct(':') {
            return self.expected(c, "`:` and what the joint is, such as `revolute(…);`");
        }
        let forms = match self.definition.space {
            Space::Planar => JOINTS.as_slice(),
            Space::Spatial => SPATIAL_JOINTS.as_slice(),
        };
        let (form, mut arguments) = self.call_of(c, forms, "joint")?;
        self.semicolon(c)?;
        let kind = JointWord::ALL.into_iter().find(|kind| kind.text() == form.word).ok_or(Failed)?;
        let first = match arguments.lines.pop() {
            Some(line) => FirstTerm::Line(line),
            None => FirstTerm::Place(arguments.place()?),
        };
        let second = arguments.place()?;
        self.definition.joints.push(Joint {
            name,
            kind,
            first,
            second,
            axis: arguments.tuple("axis"),
            second_axis: arguments.tuple("second_axis"),
            angle: arguments.entry("angle"),
            length: arguments.entry("length"),
            pitch: arguments.entry("pitch"),
        });
        Ok(())
    }

    /// `name: gear(…);`, `name: rack(…);` or `name: left = right;` after the word `constraint`.
    pub fn constraint(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the constraint")?;
        self.punct(c, ':')?;
        if c.word().is_some_and(|word| COUPLINGS.iter().any(|form| form.word == word)) && is_call(c) {
            return self.coupling_call(c, name);
        }
        let left = self.expression(c)?;
        if !c.eat_punct('=') {
            let what = "`=` between the two sides of the constraint";
            return match left.kind {
                TermKind::Operation(Operator::Equal, _) => {
                    self.advised(c, what, &Habit::EqualsTwice.advice())
                }
                _ => self.expected(c, what),
            };
        }
        let right = self.expression(c)?;
        self.semicolon(c)?;
        self.definition.constraints.push(Constraint { name, kind: ConstraintTerm::Equation { left, right } });
        Ok(())
    }

    /// `name: gear(…);` after the word of the coupling.
    pub fn coupling(&mut self, c: &mut Cursor, word: &str) -> Parsed<()> {
        let name = self.declared(c, "the name of the constraint")?;
        self.punct(c, ':')?;
        if !c.at_word(word) {
            return self.expected(c, &format!("`{word}(…)`"));
        }
        self.coupling_call(c, name)
    }

    fn coupling_call(&mut self, c: &mut Cursor, name: Label) -> Parsed<()> {
        let (form, mut arguments) = self.call_of(c, &COUPLINGS, "constraint")?;
        let region = name.region.to(c.previous());
        self.semicolon(c)?;
        let (first, second) = (arguments.rotor()?, arguments.rotor()?);
        let phase = arguments.entry("phase");
        let kind = match form.word {
            "rack" => ConstraintTerm::Rack {
                pinion: first,
                rail: second,
                radius: arguments.required("radius")?,
                phase,
            },
            "screw" => {
                // travel = pitch/(2π) · angle
                let turn = number(region, "2").times(Term::name(region, "pi"));
                let radius = arguments.required("pitch")?.term().over(turn);
                ConstraintTerm::Rack { pinion: first, rail: second, radius: Entry::bare(radius), phase }
            }
            "belt" => {
                // r₁ θ₁ = r₂ θ₂
                let (own, other) = (arguments.required("radius")?, arguments.required("second_radius")?);
                let ratio = Entry::bare(other.term().over(own.term()));
                ConstraintTerm::Gear { first, second, ratio, phase }
            }
            "differential" => {
                // The carrier turns by the mean of both wheels.
                let angle = |label: &Label| Term::name(label.region, &format!("{}.angle", label.text));
                let (carrier, a, b) = (angle(&first), angle(&second), angle(&arguments.rotor()?));
                ConstraintTerm::Equation { left: a.plus(b), right: number(region, "2").times(carrier) }
            }
            _ => ConstraintTerm::Gear { first, second, ratio: arguments.required("ratio")?, phase },
        };
        self.definition.constraints.push(Constraint { name, kind });
        Ok(())
    }

    /// `name: kind(…) = law;` after `force` or the load's own word.
    pub fn load(&mut self, c: &mut Cursor, word: &str) -> Parsed<()> {
        let name = self.declared(c, "the name of the load")?;
        self.punct(c, ':')?;
        let at = c.region();
        let (form, mut arguments) = self.call_of(c, &LOADS, "load")?;
        if word != "force" && word != form.word {
            return self.fail(at, messages::other_load(word, form.word));
        }
        let has_law = matches!(form.word, "force" | "torque");
        if has_law && !c.eat_punct('=') {
            return self.expected(c, &format!("`=` and the law of the {}", form.word));
        }
        if !has_law && c.at_punct('=') {
            return self.fail(c.region(), messages::load_without_law(form.word));
        }
        let kind = match form.word {
            "force" => {
                let place = arguments.place()?;
                let several = c.inside(Delimiter::Parenthesis).is_some_and(|inside| inside.has_comma());
                match (arguments.tuple("direction"), place) {
                    (Some(_), _) if several => {
                        return self.fail(c.region(), messages::direction_and_components());
                    }
                    (Some(direction), place) => {
                        LoadTerm::Force { place, direction, value: self.expression(c)? }
                    }
                    (None, PlaceTerm::Named(path)) if path.parts.len() == 1 && !several => {
                        LoadTerm::Push { on: path.parts[0].clone(), value: self.expression(c)? }
                    }
                    (None, place) => LoadTerm::Components { place, components: self.components(c)? },
                }
            }
            "torque" => {
                let on = arguments.rotor()?;
                let several = c.inside(Delimiter::Parenthesis).is_some_and(|inside| inside.has_comma());
                if several && self.definition.space == Space::Spatial {
                    LoadTerm::BodyTorque { on, components: self.vector(c, None)? }
                } else {
                    LoadTerm::Torque { on, value: self.expression(c)? }
                }
            }
            "spring" => LoadTerm::Spring {
                first: arguments.place()?,
                second: arguments.place()?,
                stiffness: arguments.required("stiffness")?,
                length: arguments.required("length")?,
                damping: arguments.entry("damping"),
            },
            "damper" => LoadTerm::Damper {
                first: arguments.place()?,
                second: arguments.place()?,
                damping: arguments.required("damping")?,
            },
            _ => LoadTerm::TorsionSpring {
                on: arguments.rotor()?,
                stiffness: arguments.required("stiffness")?,
                angle: arguments.entry("angle"),
                damping: arguments.entry("damping"),
            },
        };
        self.semicolon(c)?;
        self.definition.loads.push(Load { name, kind });
        Ok(())
    }

    /// `(fx, fy)`, the law of a force without a direction.
    fn components(&mut self, c: &mut Cursor) -> Parsed<Tuple> {
        match c.inside(Delimiter::Parenthesis) {
            Some(inside) if inside.has_comma() => self.vector(c, None),
            _ => self.fail(c.region(), messages::force_without_direction(self.definition.space)),
        }
    }

    /// A kind out of `forms` and its arguments, complete.
    fn call_of<'f>(
        &mut self,
        c: &mut Cursor,
        forms: &'f [Form],
        what: &str,
    ) -> Parsed<(&'f Form, Arguments)> {
        let words: Vec<&str> = forms.iter().map(|form| form.word).collect();
        let kind = self.word(c, &format!("the kind of the {what} ({})", words.join(", ")))?;
        let Some(form) = forms.iter().find(|form| form.word == kind.text) else {
            return self
                .fail(kind.region, messages::unknown_kind(what, &kind.text, &words, self.definition.space));
        };
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let region = kind.region.to(c.previous());
        let mut arguments = Arguments::default();
        for (index, positional) in form.positional.iter().enumerate() {
            self.positional(&mut inside, form, index, *positional, region, &mut arguments)?;
        }
        while !inside.is_done() {
            self.named(&mut inside, form, &mut arguments)?;
        }
        for (name, _) in form.named.iter().filter(|(_, required)| *required) {
            let given = arguments.entries.iter().any(|(label, _)| label.text == *name)
                || arguments.tuples.iter().any(|(label, _)| label.text == *name);
            if !given {
                return self.fail(region, messages::missing_argument(form.word, name, self.definition.space));
            }
        }
        Ok((form, arguments))
    }

    fn positional(
        &mut self,
        c: &mut Cursor,
        form: &Form,
        index: usize,
        kind: Kind,
        region: Region,
        arguments: &mut Arguments,
    ) -> Parsed<()> {
        let mut ahead = c.clone();
        ahead.advance();
        while ahead.enter(Delimiter::Bracket).is_some() {}
        if c.is_done() || ahead.at_punct('=') {
            let message =
                messages::missing_place(form.word, form.positional.len(), index, kind == Kind::Place);
            return self.fail(region, message);
        }
        match kind {
            Kind::Place => arguments.places.push(self.place(c)?),
            Kind::Line => arguments.lines.push(self.line_argument(c)?),
            Kind::Rotor => {
                arguments.rotors.push(self.label(c, "the name of a joint or body")?);
                if c.at_punct('.') {
                    return self.advised(c, "`,` or `)`", messages::names_without_point());
                }
            }
        }
        if c.is_done() { Ok(()) } else { self.argument_end(c) }
    }

    /// `,` between arguments.
    fn argument_end(&mut self, c: &mut Cursor) -> Parsed<()> {
        if c.is_done() || c.eat_punct(',') { Ok(()) } else { self.expected(c, "`,` or `)`") }
    }

    /// `guide.slot` or `line(from, to)`.
    fn line_argument(&mut self, c: &mut Cursor) -> Parsed<LineTerm> {
        if c.at_word("ground") && is_call(c) {
            return self.fail(c.region(), messages::place_for_line());
        }
        if !(c.at_word("line") && is_call(c)) {
            return Ok(LineTerm::Named(self.path(c, "a line")?));
        }
        let start = c.region();
        c.advance();
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let region = start.to(c.previous());
        let from = self.place(&mut inside)?;
        self.punct(&mut inside, ',')?;
        let to = self.place(&mut inside)?;
        inside.eat_punct(',');
        self.end(&inside, "`)` after two places")?;
        Ok(LineTerm::Inline { from, to, region })
    }

    /// `name [unit] = value`.
    fn named(&mut self, c: &mut Cursor, form: &Form, arguments: &mut Arguments) -> Parsed<()> {
        if c.word().is_none() {
            let names: Vec<&str> = form.named.iter().map(|(name, _)| *name).collect();
            return self.advised(c, "a named argument", &messages::named_arguments(&names));
        }
        let label = self.word(c, "a named argument")?;
        let known = form.named.iter().any(|(name, _)| *name == label.text);
        if !known {
            let names: Vec<&str> = form.named.iter().map(|(name, _)| *name).collect();
            let message = if c.at_punct('=') || c.inside(Delimiter::Bracket).is_some() {
                messages::unknown_argument(form.word, &label.text, &names)
            } else {
                messages::too_many_places(form.word, form.positional.len())
            };
            return self.fail(label.region, message);
        }
        let earlier = arguments.entries.iter().map(|(label, _)| label);
        let earlier = earlier.chain(arguments.tuples.iter().map(|(label, _)| label));
        if let Some(first) = earlier.into_iter().find(|first| first.text == label.text) {
            let message = messages::property_twice(&label.text, form.word);
            let note = messages::first_here(&label.text);
            self.diagnostics.conflict(label.region, message, first.region, note);
            return Err(Failed);
        }
        let unit = self.unit(c)?;
        if matches!(label.text.as_str(), "axis" | "second_axis" | "direction") {
            self.punct(c, '=')?;
            let tuple = self.vector(c, unit)?;
            arguments.tuples.push((label, tuple));
        } else {
            let entry = self.entry(c, unit)?;
            arguments.entries.push((label, entry));
        }
        self.argument_end(c)
    }
}

/// Digits as if written at `region`.
fn number(region: Region, digits: &str) -> Term {
    Term { kind: TermKind::Number { text: digits.to_string(), unit: None }, region, height: 0 }
}
