//! A definition as JSON text, version 1: what was written, nothing converted. Generic solvers, scripts and
//! exporters rebuild the mechanism from it without this compiler.

use super::definition::*;
use crate::beams::{Theory, Way};
use crate::forms::{Argument, Interpolation, Outside, Value};
use crate::modal::Reduced;

/// The definition as one line of JSON.
pub fn definition_json(definition: &Definition) -> String {
    let mut w = Writer { text: String::new() };
    w.object(|w| {
        w.key("linkwright").raw("1");
        w.key("kind").string(definition.space.text());
        w.key("name").string(&definition.name.text);
        w.key("constants").list(&definition.constants, |w, constant| {
            w.named_entry(&constant.name, &constant.entry);
        });
        w.key("parameters").list(&definition.parameters, |w, parameter| {
            w.named_entry(&parameter.name, &parameter.entry);
            let bounds = parameter.bounds.as_ref();
            w.key("min").optional(bounds.map(|b| &b.0), Writer::term);
            w.key("max").optional(bounds.map(|b| &b.1), Writer::term);
        });
        w.key("inputs").list(&definition.inputs, |w, input| {
            w.key("name").string(&input.name.text);
            w.key("unit").unit(input.unit.as_ref(), Some("1"));
        });
        if !definition.signals.is_empty() {
            w.key("signals")
                .list(&definition.signals, |w, signal| w.named_entry(&signal.name, &signal.entry));
        }
        if !definition.states.is_empty() {
            w.key("states").list(&definition.states, |w, state| {
                w.named_entry(&state.name, &state.entry);
                w.key("scale").optional(state.scale.as_ref(), Writer::term);
            });
            w.key("rates").list(&definition.rates, |w, rate| {
                w.key("name").string(&rate.name.text);
                w.key("value").term(&rate.value);
            });
        }
        if !definition.memories.is_empty() {
            w.key("memories")
                .list(&definition.memories, |w, memory| w.named_entry(&memory.name, &memory.entry));
        }
        if !definition.events.is_empty() {
            w.key("events").list(&definition.events, Writer::event);
        }
        if !definition.tables.is_empty() {
            w.key("tables").list(&definition.tables, Writer::table);
        }
        w.key("gravity").optional(definition.gravity.as_ref(), |w, tuple| w.tuple(tuple, None));
        if definition.space == Space::Spatial {
            w.key("markers").list(&definition.markers, Writer::marker);
        }
        w.key("bodies").list(&definition.bodies, |w, body| w.body(body, definition.space));
        w.key("joints").list(&definition.joints, |w, joint| w.joint(joint, definition));
        w.key("constraints").list(&definition.constraints, Writer::constraint);
        w.key("drivers").list(&definition.drivers, |w, driver| {
            w.key("name").string(&driver.name.text);
            w.key("quantity").name(&driver.quantity.text);
            w.key("law").object(|w| {
                w.key("unit").raw("null");
                w.key("value").term(&driver.law);
            });
        });
        w.key("loads").list(&definition.loads, Writer::load);
        if !definition.contacts.is_empty() {
            w.key("surfaces").list(&definition.surfaces, |w, surface| w.surface(surface, definition));
            w.key("materials").list(&definition.materials, |w, material| {
                w.key("name").string(&material.name.text);
                material.entries.iter().for_each(|(label, entry)| w.key(&label.text).entry(entry));
            });
            w.key("contacts").list(&definition.contacts, Writer::contact);
        }
        w.key("start").list(&definition.start, |w, start| {
            w.key("quantity").name(&start.quantity.text);
            w.key("exact").raw(if start.exact { "true" } else { "false" });
            w.entry_fields(&start.entry);
        });
        if !definition.steady.is_empty() {
            w.key("steady").array(&definition.steady, |w, state| w.string(&state.text));
        }
        if !definition.deflected.is_empty() {
            w.key("static").array(&definition.deflected, |w, body| w.string(&body.text));
        }
        if definition.space == Space::Spatial {
            w.key("orientations").list(&definition.orientations, |w, start| {
                w.key("quantity").name(&start.quantity.text);
                w.key("exact").raw(if start.exact { "true" } else { "false" });
                w.tuple_fields(&start.value, None);
            });
        }
        w.key("outputs").list(&definition.outputs, |w, output| w.named_entry(&output.name, &output.entry));
        w.key("options").object(|w| definition.options.iter().for_each(|option| w.option(option)));
        w.key("expect").object(|w| w.expectations(&definition.expect));
    });
    w.text
}

/// Appends JSON; commas are put where something precedes.
struct Writer {
    text: String,
}

impl Writer {
    fn raw(&mut self, text: &str) {
        self.text.push_str(text);
    }

    fn string(&mut self, text: &str) {
        self.text.push('"');
        for character in text.chars() {
            match character {
                '"' => self.text.push_str("\\\""),
                '\\' => self.text.push_str("\\\\"),
                c if u32::from(c) < 0x20 => self.text.push_str(&format!("\\u{:04x}", u32::from(c))),
                c => self.text.push(c),
            }
        }
        self.text.push('"');
    }

    fn comma(&mut self) {
        if !self.text.ends_with(['{', '[']) {
            self.text.push(',');
        }
    }

    fn key(&mut self, key: &str) -> &mut Self {
        self.comma();
        self.string(key);
        self.text.push(':');
        self
    }

    fn object(&mut self, fields: impl FnOnce(&mut Self)) {
        self.text.push('{');
        fields(self);
        self.text.push('}');
    }

    fn array<T>(&mut self, elements: &[T], mut element: impl FnMut(&mut Self, &T)) {
        self.text.push('[');
        for (index, value) in elements.iter().enumerate() {
            if index > 0 {
                self.text.push(',');
            }
            element(self, value);
        }
        self.text.push(']');
    }

    /// An array of objects.
    fn list<T>(&mut self, elements: &[T], mut fields: impl FnMut(&mut Self, &T)) {
        self.array(elements, |w, element| w.object(|w| fields(w, element)));
    }

    fn optional<T: ?Sized>(&mut self, value: Option<&T>, write: impl FnOnce(&mut Self, &T)) {
        match value {
            Some(value) => write(self, value),
            None => self.raw("null"),
        }
    }

    fn unit(&mut self, unit: Option<&WrittenUnit>, default: Option<&str>) {
        match (unit, default) {
            (Some(written), _) => self.string(&written.unit.text),
            (None, Some(default)) => self.string(default),
            (None, None) => self.raw("null"),
        }
    }

    fn name(&mut self, name: &str) {
        self.object(|w| w.key("name").string(name));
    }

    fn entry_fields(&mut self, entry: &Entry) {
        self.key("unit").unit(entry.unit.as_ref(), None);
        self.key("value").term(&entry.value);
    }

    fn entry(&mut self, entry: &Entry) {
        self.object(|w| w.entry_fields(entry));
    }

    /// Present only if it was written.
    fn entry_if(&mut self, key: &str, entry: Option<&Entry>) {
        if let Some(entry) = entry {
            self.key(key).entry(entry);
        }
    }

    fn named_entry(&mut self, name: &Label, entry: &Entry) {
        self.key("name").string(&name.text);
        self.key("unit").unit(entry.unit.as_ref(), Some("1"));
        self.key("value").term(&entry.value);
    }

    fn tuple_fields(&mut self, tuple: &Tuple, default: Option<&str>) {
        self.key("unit").unit(tuple.unit.as_ref(), default);
        self.key("value").array(&tuple.values, Self::term);
    }

    fn tuple(&mut self, tuple: &Tuple, default: Option<&str>) {
        self.object(|w| w.tuple_fields(tuple, default));
    }

    /// Present only if it was written.
    fn tuple_if(&mut self, key: &str, tuple: Option<&Tuple>, default: Option<&str>) {
        if let Some(tuple) = tuple {
            self.key(key).tuple(tuple, default);
        }
    }

    /// One value, or one for each axis; present only if it was written.
    fn diagonal_if(&mut self, key: &str, named: &Named) {
        self.entry_if(key, named.entry(key));
        self.tuple_if(key, named.tuple(key), None);
    }

    fn place(&mut self, place: &PlaceTerm) {
        match place {
            PlaceTerm::Named(path) => self.object(|w| w.key("place").string(&path.text)),
            PlaceTerm::Ground(ground) => self.ground(ground),
        }
    }

    fn ground(&mut self, ground: &Ground) {
        self.object(|w| {
            w.key("ground").array(&ground.at, Self::term);
            w.key("unit").unit(ground.unit.as_ref(), None);
        });
    }

    fn term(&mut self, term: &Term) {
        match &term.kind {
            TermKind::Ground(ground) => self.ground(ground),
            TermKind::Name(path) => self.name(&path.text),
            TermKind::Number { text, unit } => self.object(|w| {
                w.key("number").string(text);
                if let Some(unit) = unit {
                    w.key("unit").string(&unit.unit.text);
                }
            }),
            TermKind::Operation(operator, operands) => self.object(|w| {
                w.key("op").string(operator.text());
                w.key("args").array(operands, Self::term);
            }),
            TermKind::Call(function, arguments) => self.object(|w| {
                w.key("call").string(&function.text);
                w.key("args").array(arguments, Self::term);
            }),
            TermKind::Measured(inner, unit) => self.object(|w| {
                w.key("value").term(inner);
                w.key("unit").string(&unit.unit.text);
            }),
        }
    }

    /// Points of a file stand here as they were read.
    fn event(&mut self, event: &Event) {
        self.key("name").string(&event.name.text);
        match &event.occasion {
            Occasion::Passing { value, way, level } => {
                self.key(way.word()).term(level);
                self.key("value").term(value);
            }
            Occasion::Every(period) => self.key("every").term(period),
        }
        self.key("sets").list(&event.sets, |w, (memory, value)| {
            w.key("name").string(&memory.text);
            w.key("value").term(value);
        });
        if let Some(Jump { speed, to }) = &event.jump {
            self.key("jump").object(|w| {
                w.key("speed").name(&speed.text);
                w.key("value").term(to);
            });
        }
    }

    fn table(&mut self, table: &TableTerm) {
        self.key("name").string(&table.name.text);
        self.key("arguments").list(&table.arguments, |w, (label, unit)| {
            w.key("name").string(&label.text);
            w.key("unit").unit(unit.as_ref(), Some("1"));
        });
        self.key("unit").unit(table.unit.as_ref(), Some("1"));
        let kind = table.kind.map_or(Interpolation::of(table.arguments.len()), |(kind, _)| kind);
        self.key("kind").string(kind.word());
        let outside = table.outside.map_or(Outside::Linear, |(outside, _)| outside);
        self.key("outside").string(outside.word());
        match &table.data {
            TableData::Points(points) => {
                self.key("points").array(points, |w, point| w.array(point, Self::term));
            }
            TableData::Grid { axes, rows } => {
                self.key("axes").array(axes, |w, axis| w.array(axis, Self::term));
                self.key("rows").array(rows, |w, (row, _)| w.array(row, Self::term));
            }
            TableData::File(file) => self.key("file").string(&file.name),
        }
    }

    fn marker(&mut self, marker: &Marker) {
        self.key("name").string(&marker.name.text);
        self.tuple_fields(&marker.at, None);
        self.key("axes").list(&marker.axes, |w, (label, axes)| {
            w.key("key").string(&label.text);
            match axes {
                MarkerAxes::Direction(tuple) => w.tuple_fields(tuple, None),
                MarkerAxes::Angle(entry) => w.entry_fields(entry),
            }
        });
    }

    fn body(&mut self, body: &Body, space: Space) {
        self.key("name").string(&body.name.text);
        self.key("kind").string(body.form.word);
        self.key("properties").object(|w| {
            for (label, entry) in &body.properties {
                w.key(&label.text).entry(entry);
            }
        });
        if let Some(reduced) = body.reduced() {
            self.key("modal").object(|w| w.reduced(reduced));
        }
        if body.form.is_beam() {
            self.key("beam").object(|w| w.beam(&body.beam, space));
        }
        if space == Space::Spatial {
            self.key("vectors").object(|w| {
                for (label, tuple) in &body.vectors {
                    w.key(&label.text).tuple(tuple, None);
                }
            });
            self.key("inertia_axes").optional(body.inertia_axes.as_ref(), |w, label| w.string(&label.text));
            self.key("markers").list(&body.markers, Self::marker);
        }
        self.key("center").optional(body.center.as_ref(), |w, (_, tuple)| w.tuple(tuple, None));
        self.key("points").list(&body.points, |w, (label, tuple)| {
            w.key("name").string(&label.text);
            w.tuple_fields(tuple, None);
        });
        self.key("lines").list(&body.lines, |w, line| {
            w.key("name").string(&line.name.text);
            w.key("from").place(&line.from);
            w.key("to").place(&line.to);
        });
        if !body.toothings.is_empty() {
            self.key("toothings").list(&body.toothings, |w, toothing| {
                w.key("name").string(&toothing.name.text);
                w.key("kind").string(toothing.form.call.word);
                for (label, entry) in &toothing.named.entries {
                    w.key(&label.text).entry(entry);
                }
                if let Some(at) = &toothing.at {
                    w.key("at").string(&at.text);
                }
                if let Some(LineTerm::Named(line)) = &toothing.line {
                    w.key("line").string(&line.text);
                }
            });
        }
    }

    /// Numbers of modes and the shapes stand here where they were not written too.
    fn beam(&mut self, beam: &BeamTerm, space: Space) {
        self.key("section").optional(beam.section.as_ref(), |w, section| {
            w.object(|w| {
                w.key("kind").string(&section.kind.text);
                section.lengths.iter().for_each(|(label, entry)| w.key(&label.text).entry(entry));
            });
        });
        let counts = beam.counts(space);
        // What few beams do stands here where they do.
        for way in Way::of(space).iter().filter(|way| **way != Way::Torsion || counts.torsion > 0) {
            self.key(way.word(space)).raw(&counts.of(*way).to_string());
        }
        let quadratic = counts.quadratic;
        if quadratic {
            self.key("quadratic").raw("true");
        }
        self.key("shapes").string(beam.shapes().word());
        if beam.stiffens() {
            self.key("stiffening").raw("true");
        }
        if beam.theory() == Theory::Timoshenko {
            self.key("theory").string(beam.theory().word());
        }
    }

    /// In the order of the modes that are taken.
    fn reduced(&mut self, of: &Reduced) {
        self.key("mass").raw(&format!("{:?}", of.mass));
        self.key("center").numbers(&of.center);
        self.key("inertia").rows(&of.inertia);
        self.key("momentum").rows(&of.momentum);
        self.key("angular_momentum").rows(&of.angular_momentum);
        self.key("moments").rows(&of.moments);
        self.key("generalised_mass").rows(&of.generalised_mass);
        self.key("stiffness").rows(&of.stiffness);
        self.key("modes").array(&of.numbers, |w, number| w.raw(&number.to_string()));
        self.key("nodes").list(&of.nodes, |w, node| {
            w.key("at").numbers(&node.at);
            w.key("shifts").rows(&node.shifts);
            w.key("turns").rows(&node.turns);
        });
    }

    fn numbers(&mut self, of: &[f64]) {
        self.array(of, |w, number| w.raw(&format!("{number:?}")));
    }

    fn rows<R: AsRef<[f64]>>(&mut self, of: &[R]) {
        self.array(of, |w, row| w.numbers(row.as_ref()));
    }

    fn joint(&mut self, joint: &Joint, definition: &Definition) {
        self.key("name").string(&joint.name.text);
        self.key("kind").string(joint.form.call.word);
        self.key("first");
        match &joint.first {
            FirstTerm::Line(line) => self.line(line, definition),
            FirstTerm::Place(place) => self.place(place),
        }
        self.key("second").place(&joint.second);
        for Argument { name, value, .. } in joint.form.call.named {
            match value {
                Value::Direction => self.tuple_if(name, joint.named.tuple(name), Some("1")),
                Value::Scalar(_) | Value::Moving(_) | Value::Outline | Value::OfParameter(_) => {
                    self.entry_if(name, joint.named.entry(name))
                }
                Value::Diagonal(_) => self.diagonal_if(name, &joint.named),
                // Joints resist no way.
                Value::Varying(_)
                | Value::RateOf { .. }
                | Value::Way
                | Value::Law(_)
                | Value::Along { .. }
                | Value::Stiffness
                | Value::Exponent
                | Value::Backbone
                | Value::OfGap
                | Value::Word
                | Value::TeethStiffness
                | Value::TeethDamping => {}
            }
        }
        if let Some(penalty) = &joint.penalty {
            self.key("penalty").object(|w| w.named(&penalty.named));
        }
        if joint.loose {
            self.key("play").raw("true");
        }
    }

    /// A line of the ground is written out, as only bodies carry lines in the file.
    fn line(&mut self, line: &LineTerm, definition: &Definition) {
        let ends = match line {
            LineTerm::Inline { from, to, .. } => Some((from, to)),
            LineTerm::Named(path) => definition
                .lines
                .iter()
                .find(|line| line.name.text == path.text)
                .map(|line| (&line.from, &line.to)),
        };
        match (ends, line) {
            (Some((from, to)), _) => self.object(|w| {
                w.key("from").place(from);
                w.key("to").place(to);
            }),
            (None, LineTerm::Named(path)) => self.object(|w| w.key("line").string(&path.text)),
            (None, LineTerm::Inline { .. }) => self.raw("null"),
        }
    }

    fn constraint(&mut self, constraint: &Constraint) {
        self.key("name").string(&constraint.name.text);
        match &constraint.kind {
            ConstraintTerm::Coupling { kind, on, factor, phase, .. } => {
                self.key("kind").string(kind.exported);
                for ((key, _), subject) in kind.on.iter().zip(on) {
                    self.subject([key; 2], subject);
                }
                self.key(kind.factor.0).entry(factor);
                self.key("phase").optional(phase.as_ref(), Self::entry);
            }
            ConstraintTerm::Teeth { on, .. } => {
                self.key("kind").string("teeth");
                for (key, subject) in ["first", "second"].into_iter().zip(on) {
                    self.subject([key; 2], subject);
                }
                self.key("phase").raw("null");
            }
            ConstraintTerm::Equation { left, right } => {
                self.key("kind").string("equation");
                self.key("left").term(left);
                self.key("right").term(right);
            }
        }
    }

    fn load(&mut self, load: &Load) {
        self.key("name").string(&load.name.text);
        self.key("kind").string(load.form.exported);
        match &load.on[..] {
            [one] => self.subject(["on", "place"], one),
            several => {
                for (key, one) in ["first", "second"].into_iter().zip(several) {
                    self.subject([key; 2], one);
                }
                if let Some(further @ [_, ..]) = several.get(2..) {
                    self.key("further").array(further, |w, one| {
                        if let SubjectTerm::Place(place) = one {
                            w.place(place);
                        }
                    });
                }
            }
        }
        for Argument { name, value, .. } in load.form.call.named {
            match value {
                Value::Direction => {
                    if let Some(tuple) = load.named.tuple(name) {
                        self.key(name).array(&tuple.values, Self::term);
                    }
                }
                Value::Scalar(_)
                | Value::Moving(_)
                | Value::Varying(_)
                | Value::RateOf { .. }
                | Value::Way
                | Value::Law(_)
                | Value::Along { .. }
                | Value::Stiffness
                | Value::Exponent
                | Value::Backbone
                | Value::Outline
                | Value::OfParameter(_)
                | Value::OfGap
                | Value::Word
                | Value::TeethDamping => self.entry_if(name, load.named.entry(name)),
                Value::TeethStiffness => match load.named.call(name) {
                    Some(call) => self.key(name).object(|w| {
                        w.key("involute").object(|w| {
                            call.entries.iter().for_each(|(label, entry)| w.key(&label.text).entry(entry));
                        });
                    }),
                    None => self.entry_if(name, load.named.entry(name)),
                },
                Value::Diagonal(_) => self.diagonal_if(name, &load.named),
            }
        }
        match &load.law {
            LawTerm::None => {}
            LawTerm::Value(value) => self.key("value").term(value),
            LawTerm::Components(components) => {
                self.key("components").array(&components.values, |w, value| w.with_unit(value, components));
            }
        }
    }

    fn surface(&mut self, surface: &Surface, definition: &Definition) {
        self.key("name").string(&surface.name.text);
        self.key("kind").string(surface.form.call.word);
        self.key("places").array(&surface.places, Self::place);
        if let Some(line) = &surface.line {
            self.key("line").line(line, definition);
        }
        self.named(&surface.named);
    }

    fn named(&mut self, named: &Named) {
        named.entries.iter().for_each(|(label, entry)| self.key(&label.text).entry(entry));
        named.tuples.iter().for_each(|(label, tuple)| self.key(&label.text).tuple(tuple, Some("1")));
    }

    fn contact(&mut self, contact: &Contact) {
        self.key("name").string(&contact.name.text);
        match &contact.on {
            ContactTerm::Between(first, second) => {
                self.key("kind").string("between");
                self.key("first").string(&first.text);
                self.key("second").string(&second.text);
            }
            ContactTerm::Gap(gap, slip) => {
                self.key("kind").string("gap");
                self.key("expression").term(gap);
                if let Some(slip) = slip {
                    self.key("slip").entry(slip);
                }
            }
            ContactTerm::Limit(quantity, range) => {
                self.key("kind").string("limit");
                self.key("quantity").name(&quantity.text);
                self.key("from").term(&range.from);
                self.key("to").term(&range.to);
                self.key("unit").optional(range.unit.as_ref(), |w, unit| w.string(&unit.unit.text));
            }
        }
        self.key("law").object(|w| match &contact.law {
            ContactLawTerm::Named(form, named, _) => {
                w.key("kind").string(form.call.word);
                w.named(named);
            }
            ContactLawTerm::Expression(term) => {
                w.key("kind").string("expression");
                w.key("value").term(term);
            }
        });
    }

    /// Under the first key a name, under the second a place.
    fn subject(&mut self, [name, at]: [&str; 2], subject: &SubjectTerm) {
        match subject {
            SubjectTerm::Name(label) => self.key(name).string(&label.text),
            SubjectTerm::Place(place) => self.key(at).place(place),
            SubjectTerm::Expression(term) => self.key("expression").term(term),
        }
    }

    /// A component whose unit stands behind the tuple.
    fn with_unit(&mut self, value: &Term, tuple: &Tuple) {
        match &tuple.unit {
            Some(unit) => self.object(|w| {
                w.key("value").term(value);
                w.key("unit").string(&unit.unit.text);
            }),
            None => self.term(value),
        }
    }

    fn option(&mut self, option: &OptionEntry) {
        match option {
            OptionEntry::Coordinates(word) => self.key("coordinates").string(&word.text),
            OptionEntry::Redundant(word) => self.key("redundant").string(&word.text),
            OptionEntry::Inertia(word) => self.key("inertia").string(&word.text),
            OptionEntry::Cut(joints) => self.key("cut").array(joints, |w, joint| w.string(&joint.text)),
            OptionEntry::Contact(word) => self.key("contact").string(&word.text),
            OptionEntry::Impact(word) => self.key("impact").string(&word.text),
            OptionEntry::Independent(paths) => {
                self.key("independent").array(paths, |w, path| w.name(&path.text));
            }
            // No property of the mechanism.
            OptionEntry::Solution(_)
            | OptionEntry::Emit(_)
            | OptionEntry::SelfCheck(_)
            | OptionEntry::FrictionPasses(..)
            | OptionEntry::ExportC(_)
            | OptionEntry::Crate(_) => {}
        }
    }

    fn expectations(&mut self, expect: &[ExpectEntry]) {
        for entry in expect {
            if let ExpectEntry::DegreesOfFreedom(count, _) = entry {
                self.key("degrees_of_freedom").raw(&count.to_string());
            }
        }
        for of in Budgeted::ALL {
            let budgets: Vec<&Budget> = expect
                .iter()
                .filter_map(|entry| match entry {
                    ExpectEntry::Budget(budget) if budget.of == of => Some(budget),
                    _ => None,
                })
                .collect();
            if !budgets.is_empty() {
                self.key(of.word()).list(&budgets, |w, budget| {
                    w.key("of").optional(budget.function.as_ref(), |w, label| w.string(&label.text));
                    w.key("at_most").raw(&budget.limit.to_string());
                });
            }
        }
        self.motion_expectations(expect);
    }

    fn motion_expectations(&mut self, expect: &[ExpectEntry]) {
        let rotates = expect.iter().filter_map(|entry| match entry {
            ExpectEntry::Rotates(labels) => Some(labels),
            _ => None,
        });
        let rotates: Vec<&Label> = rotates.flatten().collect();
        if !rotates.is_empty() {
            self.key("rotates").array(&rotates, |w, label| w.string(&label.text));
        }
        if expect.iter().any(|entry| matches!(entry, ExpectEntry::NoSingularity(_))) {
            self.key("no_singularity").raw("true");
        }
        let ranges = expect.iter().filter_map(|entry| match entry {
            ExpectEntry::Within(quantity, range) => Some((quantity, range)),
            _ => None,
        });
        let ranges: Vec<(&Path, &RangeTerm)> = ranges.collect();
        if !ranges.is_empty() {
            self.key("ranges").list(&ranges, |w, (quantity, range)| {
                w.key("quantity").name(&quantity.text);
                w.key("from").term(&range.from);
                w.key("to").term(&range.to);
                w.key("unit").optional(range.unit.as_ref(), |w, unit| w.string(&unit.unit.text));
            });
        }
    }
}
