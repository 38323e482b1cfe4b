//! A mechanism in other languages than Rust: one source file and its header in C99, which need nothing but a compiler, and the
//! same as a class for C++.
//!
//! `dialect.rs` spells programs, `evaluation.rs` functions with their heads, `header.rs` and `source.rs` put the two files together
//! from the templates in `c/`, which are the runtime of these files; functions of `libm` are in `libm/`. The other way, `shims.rs` has the
//! functions of the same header in Rust.

mod dialect;
mod evaluation;
mod header;
mod libm;
mod names;
mod shims;
mod source;
mod tables;
mod template;

pub use crate::scalar::Scalar;
pub use dialect::C;
pub use evaluation::{Call, Written};
pub use names::Prefix;

use crate::compiled::Compiled;
use crate::diagnostics::Diagnostics;
use crate::emit::{Home, Printer};
use crate::messages;

/// A mechanism in C.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Files {
    /// The name of the files without `.h` and `.c`, with which the names of their items begin.
    pub name: String,
    pub header: String,
    pub source: String,
    /// The header for C++, which includes the other.
    pub class: String,
}

/// The mechanism in C, over one scalar. Its projection must be written out, if it has constraints: `options { emit = (projection); }`.
pub fn c(compiled: &Compiled, scalar: Scalar) -> Files {
    let writer = Writer::new(compiled, scalar);
    Files {
        header: writer.header(),
        source: writer.source(),
        class: writer.class(),
        name: writer.prefix.lower,
    }
}

/// Why a mechanism is not exported.
pub fn refused(compiled: &Compiled) -> Option<Diagnostics> {
    let mechanism = &compiled.mechanism;
    let mut found = Diagnostics::new();
    // Those of touches go with held gates.
    let mut memories = mechanism.memories.iter().filter(|memory| memory.touch_of.is_none());
    if let Some(memory) = memories.next() {
        found.error(memory.name.span, messages::memories_in_c(&memory.name.text));
        return Some(found);
    }
    if let Some(dry) = mechanism.loads.iter().find(|load| load.sticks()) {
        found.error(dry.name.span, messages::dry_in_c(&dry.name.text));
        return Some(found);
    }
    match (mechanism.loads.iter().find(|load| !load.restitutions.is_empty()), mechanism.options.held_at) {
        (Some(rigid), _) => found.error(rigid.name.span, messages::rigid_in_c(&rigid.name.text)),
        (None, at) => found.error(at?, messages::held_in_c()),
    }
    Some(found)
}

/// The functions of the equations in the source file, in its order; those that only steps call are the last.
pub fn calls(compiled: &Compiled, scalar: Scalar) -> Vec<Call> {
    let writer = Writer::new(compiled, scalar);
    writer.public().chain(writer.inner()).map(|signature| writer.call(signature)).collect()
}

/// The functions of the header over the mechanism in Rust, where its options ask for them; nothing otherwise.
pub fn shims(compiled: &Compiled, home: &Home) -> String {
    let options = &compiled.mechanism.options;
    let Some(scalar) = options.export_c else { return String::new() };
    let runtime = home.runtime(options.crate_path.as_deref(), &compiled.mechanism.name.text);
    Writer::new(compiled, scalar).shims(&runtime.path)
}

/// What writing needs at hand.
struct Writer<'a> {
    compiled: &'a Compiled,
    scalar: Scalar,
    prefix: Prefix,
    printer: Printer<'a, C>,
}

impl<'a> Writer<'a> {
    fn new(compiled: &'a Compiled, scalar: Scalar) -> Self {
        let prefix = Prefix::of(&compiled.mechanism.name.text);
        Writer { compiled, scalar, printer: Printer::new(compiled, C::new(&prefix, scalar)), prefix }
    }
}
