//! From programs to Rust items: the model's struct, its parameters, inputs and outputs, and the implementation of the
//! runtime's traits. Everything is written as text, for the caller to parse once.
//!
//! ```text
//! pub struct FourBar<R = f64> { parameters: FourBarParameters<R>, phases: [R; 0], constants: [R; 2] }
//! pub struct FourBarParameters<R = f64> { pub mass: R }
//! pub type FourBarState<R = f64> = State<[R; 6], [R; 3]>;
//! impl FourBar<f64> { pub const START: FourBarState = …; pub const SOURCE: &str = …; }
//! const _: () = {
//!     impl<R: Real> FourBar<R> { pub fn prepare(parameters: FourBarParameters<R>) -> Result<Self, SettingError> … }
//!     impl<R: Real> Mechanism<R> for FourBar<R> { … }
//!     impl<R: Real> Assemble<R> for FourBar<R> { … }
//!     impl<R: Real> Tangent<R> for FourBar<R> { … } // with emit = (tangent)
//! };
//! ```

mod assemble;
mod coordinates_json;
mod declared;
mod dialect;
mod documentation;
mod function;
mod home;
mod inherent;
mod items;
mod look_up;
mod loops;
mod mechanism;
mod named;
mod names;
mod printer;
mod report;
mod rust;
mod solutions;
mod stub;
mod tables;
mod tangent;
mod types;

pub use coordinates_json::coordinates_json;
pub use dialect::{Dialect, Spelling};
pub use home::Home;
pub use names::field;
pub use printer::{Body, Printer};
pub use stub::stub;

use crate::compiled::Compiled;
use crate::model::Mechanism;
use crate::self_check;
use proc_macro2::TokenStream;
use rust::Rust;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Everything the macro expands to: an import, if the text needs one, and the text.
pub fn emit(compiled: &Compiled, source: &str, home: &Home) -> (TokenStream, String) {
    let mechanism = &compiled.mechanism;
    let runtime = home.runtime(mechanism.options.crate_path.as_deref(), &mechanism.name.text);
    (runtime.import, text(&Emitter::new(compiled, runtime.path), source))
}

fn text(emitter: &Emitter, source: &str) -> String {
    let mut text = String::new();
    items::items(&mut text, emitter, source);
    if emitter.inner != emitter.name {
        let _ = writeln!(text, "type {}<R> = {}<R>;", emitter.inner, emitter.name);
    }
    let _ = writeln!(text, "#[allow(unused, non_snake_case, clippy::all)] const _: () = {{");
    // The user's names must not reach in here, whatever they are.
    let _ = writeln!(text, "use ::core::prelude::rust_2024::*;");
    let _ = writeln!(text, "use {}::*;", emitter.path);
    let _ = writeln!(text, "use ::core::primitive::{{bool, f64, u16, u32, u64, usize, str}};");
    let mut implementations = String::new();
    types::aliases(&mut text, emitter);
    look_up::tables(&mut text, emitter);
    types::fields(&mut implementations, emitter);
    declared::functions(&mut implementations, emitter);
    named::conversions(&mut implementations, emitter);
    inherent::inherent(&mut implementations, emitter);
    mechanism::mechanism(&mut implementations, emitter);
    report::report(&mut implementations, emitter);
    assemble::assemble(&mut implementations, emitter);
    tangent::tangent(&mut text, &mut implementations, emitter);
    text.push_str(&implementations);
    text.push_str("};\n");
    let files: BTreeSet<&str> = emitter.mechanism.files().map(|file| file.path.as_str()).collect();
    files.into_iter().for_each(|file| text.push_str(&depends_on(file)));
    if emitter.mechanism.options.self_check.is_none() {
        text.push_str(&depends_on_variable(self_check::VARIABLE));
    }
    text
}

/// What makes cargo build the crate anew when this variable of the environment changes.
fn depends_on_variable(name: &str) -> String {
    format!(
        "const _: ::core::option::Option<&'static ::core::primitive::str> = ::core::option_env!({});\n",
        quoted(name)
    )
}

/// What makes cargo build the crate anew when this file changes.
pub fn depends_on(path: &str) -> String {
    format!("const _: &'static [::core::primitive::u8] = ::core::include_bytes!({});\n", quoted(path))
}

/// What emitting needs at hand.
struct Emitter<'a> {
    compiled: &'a Compiled,
    mechanism: &'a Mechanism,
    /// Name of the struct.
    name: String,
    /// Its name among the implementations, where the runtime's names and short ones are in scope.
    inner: String,
    /// `pub`, `pub(crate)` or nothing.
    visibility: String,
    /// The path of the names that emitted code may use, as `::linkwright::__private::v1`.
    path: String,
    printer: Printer<'a, Rust<'a>>,
}

impl<'a> Emitter<'a> {
    fn new(compiled: &'a Compiled, path: String) -> Self {
        let mechanism = &compiled.mechanism;
        Emitter {
            compiled,
            mechanism,
            name: mechanism.name.text.clone(),
            inner: names::inner(&mechanism.name.text),
            visibility: mechanism.visibility.clone(),
            path,
            printer: Printer::new(compiled, Rust(compiled)),
        }
    }
}

/// `[a, b, c]`.
fn array(elements: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", elements.into_iter().collect::<Vec<_>>().join(", "))
}

/// A string as a Rust literal.
fn quoted(text: &str) -> String {
    format!("{text:?}")
}
