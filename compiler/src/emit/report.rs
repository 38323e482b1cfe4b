//! The implementation of `Report`: the model's own functions for code that serves every mechanism.
//!
//! ```text
//! impl<R: Real> Report<R> for FourBar<R> {
//!     type Motion = BodyMotion<R>;
//!     type Motions = [BodyMotion<R>; 3];
//!     fn motions(&self, time: R, q: &Q<R>, v: &V<R>, a: &V<R>) -> [BodyMotion<R>; 3] { FourBar::<R>::motions(self, time, q, v, a) }
//! }
//! ```

use super::{Emitter, tables};
use crate::functions::{Argument, FUNCTIONS, Interface, MOTION, REACTION, Shape, Signature};
use crate::model::Space;
use std::fmt::Write;

pub fn report(text: &mut String, emitter: &Emitter) {
    let Emitter { inner, compiled, mechanism, .. } = emitter;
    let _ = writeln!(text, "impl<R: Real> Report<R> for {inner}<R> {{");
    for constant in ["BODIES", "JOINTS", "LOADS"] {
        let list = format!("{inner}::<f64>::{constant}");
        tables::method(text, &constant.to_lowercase(), "&[&'static str]", &list);
    }
    let length = |shape: Shape| compiled.entries(shape).to_string();
    text.push_str(&types(mechanism.space, |shape| emitter.type_of(shape), length));
    for signature in own() {
        let arguments: Vec<&str> = given(signature).map(Argument::name).collect();
        let (head, name) = (emitter.head(signature), signature.name);
        let _ = writeln!(text, "{head} {{ {inner}::<R>::{name}(self, {}) }}", arguments.join(", "));
    }
    text.push_str("}\n");
}

/// The same of a definition with errors: functions that do nothing, of types that nobody knows.
pub fn stub(unknown: &str, head: impl Fn(&Signature) -> String) -> String {
    let mut text = String::new();
    for constant in ["bodies", "joints", "loads"] {
        tables::method(&mut text, constant, "&[&'static str]", "&[]");
    }
    for name in ["Motion", "Motions", "Reaction", "Reactions", "Powers", "Efforts"] {
        let _ = writeln!(text, "type {name} = {unknown};");
    }
    for signature in own() {
        let _ = writeln!(text, "{} {{ loop {{}} }}", head(signature));
    }
    text
}

fn types(space: Space, type_of: impl Fn(Shape) -> String, length_of: impl Fn(Shape) -> String) -> String {
    let mut text = String::new();
    let entries =
        [("Motion", Shape::Bodies(&MOTION), &MOTION), ("Reaction", Shape::Joints(&REACTION), &REACTION)];
    for (name, shape, record) in entries {
        let _ =
            writeln!(text, "type {name} = {}<R>;\ntype {name}s = {};", record.of(space).name, type_of(shape));
    }
    let _ = writeln!(text, "type Powers = {};", type_of(Shape::Loads));
    let _ = writeln!(text, "type Efforts = [[R; 2]; {}];", length_of(Shape::Drivers));
    text
}

fn own() -> impl Iterator<Item = &'static Signature> {
    FUNCTIONS.iter().filter(|signature| signature.interface == Interface::Model)
}

fn given(signature: &Signature) -> impl Iterator<Item = Argument> {
    signature.arguments.iter().copied().filter(|argument| *argument != Argument::Constants)
}
