//! What stands in the model's place after an error, so that one mistake gives one message.
//!
//! Every name that other code may use exists. What a definition with errors does not tell, such as how many coordinates there are,
//! is of a type that rustc knows to be wrong already, so that it says nothing of the code that uses it. This type comes from
//! the errors themselves, which are what the value of a constant is:
//!
//! ```text
//! const _: () = {
//!     const UNKNOWN: usize = { ::core::compile_error! { "…" } … 0 };
//!     type Unknown<R> = <[R; UNKNOWN] as Iterator>::Item;
//!     impl<R: Real> Variables<R> for FourBar<R> { type Q = Unknown<R>; … }
//! };
//! pub type FourBarPositions<R = f64> = <FourBar<R> as Variables<R>>::Q;
//! ```
//! The functions do nothing. None of it can run, because the crate does not compile.

use super::function::head;
use super::home::Home;
use super::names::{field, inner, is_keyword};
use super::{declared, report};
use crate::driver::header;
use crate::functions::{DERIVATIVES, FUNCTIONS, Interface, Shape, Signature};
use crate::model::DeclaredUnit;
use crate::source::FileOf;
use crate::syntax::{Fields, Header};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::fmt::Write;

const DERIVES: &str = "#[allow(missing_docs, dead_code)] #[derive(::core::clone::Clone, ::core::marker::Copy, \
                       ::core::fmt::Debug, ::core::cmp::PartialEq)]";

/// The errors, and items with the model's names; the errors alone if not even a name was written.
pub fn stub(errors: TokenStream, tokens: TokenStream, home: &Home, file_of: FileOf) -> TokenStream {
    let Some(header) = header(tokens, file_of).filter(|header| !is_keyword(&header.name.to_string())) else {
        return errors;
    };
    let runtime = home
        .runtime(header.crate_path.as_ref().map(ToString::to_string).as_deref(), &header.name.to_string());
    let read =
        |text: String| text.replace("@RUNTIME@", &runtime.path).parse::<TokenStream>().unwrap_or_default();
    let mut hidden = read("const UNKNOWN: ::core::primitive::usize =".to_string());
    hidden.extend([braced(errors.into_iter().chain(read("0".to_string())).collect())]);
    hidden.extend(read(format!(";\n{}", implementations(&header))));
    let mut items = runtime.import;
    items.extend(read(structs(&header)));
    items.extend(read("#[allow(unused, clippy::all)] const _: () =".to_string()));
    items.extend([braced(hidden)]);
    items.extend(read(";".to_string()));
    items
}

fn braced(stream: TokenStream) -> TokenTree {
    TokenTree::Group(Group::new(Delimiter::Brace, stream))
}

impl Header {
    /// What is known of the structs of parameters, inputs and outputs: the end of the name, and the fields.
    fn structs(&self) -> [(&'static str, Option<&[String]>); 3] {
        let of = |of: fn(&Fields) -> &Vec<String>| self.fields.as_ref().map(|fields| of(fields).as_slice());
        [
            ("Parameters", of(|fields| &fields.parameters)),
            ("Inputs", of(|fields| &fields.inputs)),
            ("Outputs", of(|fields| &fields.outputs)),
        ]
    }

    /// The struct of this name; `()` where there are no fields.
    fn given(&self, suffix: &str) -> String {
        let is_absent = |(known, fields): &(&str, Option<&[String]>)| {
            *known == suffix && suffix != "Parameters" && fields.is_some_and(<[String]>::is_empty)
        };
        if self.structs().iter().any(is_absent) {
            "()".to_string()
        } else {
            format!("{}{suffix}<R>", self.name)
        }
    }

    /// A shape as far as the definition tells.
    fn type_of(&self, shape: Shape) -> String {
        match shape {
            Shape::Scalar => "R".to_string(),
            Shape::Parameters => self.given("Parameters"),
            Shape::Inputs => self.given("Inputs"),
            Shape::Outputs => self.given("Outputs"),
            _ => "Unknown<R>".to_string(),
        }
    }
}

fn structs(header: &Header) -> String {
    let (visibility, name) = (header.visibility.to_string(), header.name.to_string());
    let f64 = "::core::primitive::f64";
    let scalar = "scalar: ::core::marker::PhantomData<R>";
    let attributes = header.attributes.to_string();
    let mut text = format!("{attributes} {DERIVES} {visibility} struct {name}<R = {f64}> {{ {scalar} }}\n");
    if inner(&name) != name {
        let _ = writeln!(text, "type {}<R> = {name}<R>;", inner(&name));
    }
    let unknown = format!("<{name}<R> as @RUNTIME@::Variables<R>>::Q");
    let alias = |suffix: &str, of: &str| {
        format!("#[allow(missing_docs, dead_code)] {visibility} type {name}{suffix}<R = {f64}> = {of};\n")
    };
    for (suffix, fields) in header.structs() {
        let list = match fields {
            None => {
                text.push_str(&alias(suffix, &unknown));
                continue;
            }
            Some([]) if suffix != "Parameters" => continue,
            Some([]) => format!("pub {scalar}"),
            Some(fields) => {
                fields.iter().map(|name| format!("pub {}: R", field(name))).collect::<Vec<_>>().join(", ")
            }
        };
        let _ = writeln!(text, "{DERIVES} {visibility} struct {name}{suffix}<R = {f64}> {{ {list} }}");
    }
    let state = format!("@RUNTIME@::State<{unknown}, {unknown}, {unknown}, {unknown}>");
    text.push_str(&alias("State", &state));
    ["Positions", "Velocities", "Internal"].iter().for_each(|suffix| text.push_str(&alias(suffix, &unknown)));
    text
}

fn implementations(header: &Header) -> String {
    let name = header.name.to_string();
    let functions = |interface: Interface| {
        let own = FUNCTIONS.iter().filter(|signature| signature.interface == interface);
        own.map(|signature| function(header, signature)).collect::<String>()
    };
    let matrices = DERIVATIVES.map(|matrix| {
        format!(
            "fn {}(&self) -> &[(u16, u16)] {{ &[] }}\ntype {} = Unknown<R>;\n",
            matrix.pattern, matrix.name
        )
    });
    let mut text = TEMPLATE
        .replace("@REPORT@", &report::stub("Unknown<R>", |signature| header.head(signature)))
        .replace("@FUNCTIONS@", &functions(Interface::Model))
        .replace("@FUNCTIONS_OF_MECHANISM@", &functions(Interface::Mechanism))
        .replace("@FUNCTIONS_OF_ASSEMBLE@", &functions(Interface::Assemble))
        .replace("@FUNCTIONS_OF_TANGENT@", &functions(Interface::Tangent))
        .replace("@DERIVATIVES@", &matrices.concat())
        .replace("@NAME@", &name)
        .replace("@INNER@", &inner(&name))
        .replace("@INPUTS@", &header.given("Inputs"))
        .replace("@OUTPUTS@", &header.given("Outputs"));
    let Some(fields) = &header.fields else {
        return text;
    };
    let _ = writeln!(
        text,
        "impl<R: Real> Default for {name}Parameters<R> {{ fn default() -> Self {{ loop {{}} }} }}"
    );
    declared_units(&mut text, &name, fields);
    for (suffix, fields) in header.structs() {
        let count = fields.map_or(0, <[String]>::len);
        if suffix == "Parameters" || count > 0 {
            let fields = FIELDS.replace("@STRUCT@", &format!("{name}{suffix}"));
            text.push_str(&fields.replace("@COUNT@", &count.to_string()));
        }
    }
    text
}

/// Values in declared units.
fn declared_units(text: &mut String, name: &str, fields: &Fields) {
    for suffix in ["Parameters", "Inputs", "Outputs"] {
        let own: Vec<(String, DeclaredUnit)> = fields
            .declared
            .iter()
            .filter(|(of, ..)| *of == suffix)
            .map(|(_, name, unit)| {
                let unit = DeclaredUnit { text: unit.text.clone(), scale: unit.scale, si: String::new() };
                (name.clone(), unit)
            })
            .collect();
        let fields = own.iter().map(|(name, unit)| (name.clone(), unit));
        declared::of_struct(text, &format!("{name}{suffix}"), fields, suffix != "Outputs");
    }
}

impl Header {
    fn head(&self, signature: &Signature) -> String {
        head(signature, |shape| self.type_of(shape), |_| "UNKNOWN".to_string())
    }
}

/// A function that does nothing.
fn function(header: &Header, signature: &Signature) -> String {
    let access = if signature.interface == Interface::Model { "pub " } else { "" };
    format!("{access}{} {{ loop {{}} }}\n", header.head(signature))
}

const FIELDS: &str = "
impl<R: Real> Fields<R> for @STRUCT@<R> {
    const NAMES: &'static [&'static ::core::primitive::str] = &[];
    type Array = [R; @COUNT@];
    fn from_array(_: [R; @COUNT@]) -> Self { loop {} }
    fn to_array(&self) -> [R; @COUNT@] { loop {} }
}
";

const TEMPLATE: &str = "
use ::core::prelude::rust_2024::*;
use @RUNTIME@::*;
use ::core::primitive::{bool, f64, u16, u32, usize, str};
type Unknown<R> = <[R; UNKNOWN] as Iterator>::Item;
impl @INNER@<f64> {
    pub const START: Unknown<f64> = UNKNOWN;
    pub const DEGREES_OF_FREEDOM: usize = UNKNOWN;
    pub const OPERATIONS: usize = UNKNOWN;
    pub const SOURCE: &'static str = \"\";
    pub const DEFINITION: &'static str = \"\";
    pub const COORDINATES: &'static str = \"\";
    pub const BODIES: &'static [&'static str] = &[\"\"; UNKNOWN];
    pub const JOINTS: &'static [&'static str] = &[\"\"; UNKNOWN];
    pub const LOADS: &'static [&'static str] = &[\"\"; UNKNOWN];
    pub const SHARED_REACTIONS: &'static [&'static str] = &[\"\"; UNKNOWN];
    pub const REDUNDANT_ROWS: &'static [(&'static str, &'static str)] = &[(\"\", \"\"); UNKNOWN];
}
impl<R: Real> Default for @INNER@<R> { fn default() -> Self { loop {} } }
impl<R: Real> @INNER@<R> {
    pub fn prepare(parameters: @NAME@Parameters<R>) -> Result<Self, SettingError> { loop {} }
    pub fn parameters(&self) -> &@NAME@Parameters<R> { loop {} }
    pub fn positions(q: &Unknown<R>) -> Unknown<R> { loop {} }
    pub fn velocities(v: &Unknown<R>) -> Unknown<R> { loop {} }
    pub fn internal(z: &Unknown<R>) -> Unknown<R> { loop {} }
    @FUNCTIONS@
}
impl<R: Real> Variables<R> for @INNER@<R> {
    fn layout(&self) -> &Layout<'_> { &Layout { linear: 0, rotations: 0, quaternions: 0, angles: &[] } }
    type Q = Unknown<R>; type V = Unknown<R>; type Lambda = Unknown<R>; type Z = Unknown<R>; type Gates = Unknown<R>;
}
impl<R: Real> Mechanism<R> for @INNER@<R> {
    fn name(&self) -> &'static str { \"\" }
    fn rows(&self) -> &[Row] { &[] }
    fn position_names(&self) -> &[&'static str] { &[] }
    fn velocity_names(&self) -> &[&'static str] { &[] }
    fn mass_pattern(&self) -> &[(u16, u16)] { &[] }
    fn jacobian_pattern(&self) -> &[(u16, u16)] { &[] }
    type Mass = Unknown<R>; type Jacobian = Unknown<R>;
    type Inputs = @INPUTS@; type Outputs = @OUTPUTS@;
    fn input_names(&self) -> &'static [&'static str] { &[] }
    fn output_names(&self) -> &'static [&'static str] { &[] }
    fn unwrap(&self, outputs: &mut @OUTPUTS@, previous: &@OUTPUTS@) {}
    @FUNCTIONS_OF_MECHANISM@
}
impl<R: Real> Parametric<R> for @INNER@<R> {
    type Parameters = @NAME@Parameters<R>;
    fn parameters(&self) -> &@NAME@Parameters<R> { loop {} }
    fn prepare(_parameters: @NAME@Parameters<R>) -> Result<Self, SettingError> { loop {} }
}
impl<S> InScalars for @INNER@<S> {
    type In<R: Real> = @INNER@<R>;
    fn zip<A: Real, B: Real, C: Real>(a: &@INNER@<A>, b: &@INNER@<B>, f: &mut impl FnMut(A, B) -> C) -> @INNER@<C> { loop {} }
}
impl<R: Real> Report<R> for @INNER@<R> {
    @REPORT@
}
impl<R: Real> Assemble<R> for @INNER@<R> {
    fn conditions(&self) -> &[Condition] { &[] }
    fn start_conditions(&self) -> &[u16] { &[] }
    fn start_rates(&self) -> &[u16] { &[] }
    fn independent(&self) -> &[u16] { &[] }
    fn condition_pattern(&self) -> &[(u16, u16)] { &[] }
    fn flips(&self) -> &[Flips<'_>] { &[] }
    fn row_sizes(&self) -> Unknown<R> { loop {} }
    fn elimination(&self) -> Elimination<'_> { Elimination { order: &[], position: &[], row_start: &[], columns: &[] } }
    type Conditions = Unknown<R>; type ConditionJacobian = Unknown<R>; type Factor = Unknown<R>; type System = Unknown<R>;
    type Dense = Unknown<R>; type Basis = Unknown<R>; type Reduced = Unknown<R>; type Choice = Unknown<R>; type Store = Unknown<R>;
    type Lu = Unknown<R>;
    fn lu(&self) -> Unknown<R> { loop {} }
    fn choice(&self) -> Unknown<R> { loop {} }
    fn store(&self) -> Unknown<R> { loop {} }
    fn start_q(&self) -> Unknown<R> { loop {} }
    fn start_v(&self) -> Unknown<R> { loop {} }
    fn start_gates(&self) -> Unknown<R> { loop {} }
    @FUNCTIONS_OF_ASSEMBLE@
}
impl<R: Real> Tangent<R> for @INNER@<R> {
    fn states(&self) -> &[u16] { &[] }
    @DERIVATIVES@
    type StateMatrix = Unknown<R>; type InputMatrix = Unknown<R>; type OutputMatrix = Unknown<R>;
    type Feedthrough = Unknown<R>; type Unknowns = Unknown<R>; type Bordered = Unknown<R>; type Parameters = @NAME@Parameters<R>;
    type Order = Unknown<R>;
    fn parameter_names(&self) -> &[&'static str] { &[] }
    fn order(&self) -> Unknown<R> { loop {} }
    @FUNCTIONS_OF_TANGENT@
}
";
