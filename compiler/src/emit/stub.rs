//! What stands in the model's place after an error, so that one mistake gives one message.
//!
//! Every name that other code may use exists, with the types it would have as far as the broken definition tells; the
//! functions do nothing. None of it can run, because the crate does not compile.

use super::function::head;
use super::home::Home;
use super::names::{field, is_keyword};
use super::{declared, named, report};
use crate::driver::header;
use crate::functions::{DERIVATIVES, FUNCTIONS, Interface, Shape, Signature};
use crate::model::{DeclaredUnit, Space};
use crate::source::FileOf;
use crate::syntax::Header;
use proc_macro2::TokenStream;
use std::fmt::Write;

/// Entries of arrays whose length the definition would have told: more than other code is likely to index.
const MANY: usize = 1024;

/// Items with the model's names; nothing if not even a name was written.
pub fn stub(tokens: TokenStream, home: &Home, file_of: FileOf) -> TokenStream {
    let Some(header) = header(tokens, file_of) else { return TokenStream::new() };
    if is_keyword(&header.name.to_string()) {
        return TokenStream::new();
    }
    let mut text = String::new();
    structs(&mut text, &header);
    constants(&mut text, &header);
    implementations(&mut text, &header);
    let runtime = home
        .runtime(header.crate_path.as_ref().map(ToString::to_string).as_deref(), &header.name.to_string());
    let mut items = runtime.import;
    items.extend(text.replace("@RUNTIME@", &runtime.path).parse::<TokenStream>());
    items
}

impl Header {
    /// Fields of the parameters, inputs and outputs, and the end of the name of their struct.
    fn structs(&self) -> [(&[String], &'static str); 3] {
        [(&self.parameters, "Parameters"), (&self.inputs, "Inputs"), (&self.outputs, "Outputs")]
    }
}

fn structs(text: &mut String, header: &Header) {
    let (visibility, name) = (header.visibility.to_string(), header.name.to_string());
    let derives = "#[allow(missing_docs, dead_code)] #[derive(::core::clone::Clone, ::core::marker::Copy, \
                   ::core::fmt::Debug, ::core::cmp::PartialEq)]";
    let f64 = "::core::primitive::f64";
    let scalar = "scalar: ::core::marker::PhantomData<R>";
    let attributes = header.attributes.to_string();
    let _ = writeln!(text, "{attributes} {derives} {visibility} struct {name}<R = {f64}> {{ {scalar} }}");
    for (fields, suffix) in header.structs() {
        if fields.is_empty() && suffix != "Parameters" {
            continue;
        }
        let mut list: Vec<String> = fields.iter().map(|name| format!("pub {}: R", field(name))).collect();
        if list.is_empty() {
            list.push(format!("pub {scalar}"));
        }
        let _ = writeln!(
            text,
            "{derives} {visibility} struct {name}{suffix}<R = {f64}> {{ {} }}",
            list.join(", ")
        );
    }
    let _ = writeln!(
        text,
        "#[allow(missing_docs, dead_code)] {visibility} type {name}State<R = {f64}> = \
         @RUNTIME@::State<[R; {MANY}], [R; {MANY}]{}>;",
        if header.states.is_empty() { String::new() } else { format!(", [R; {MANY}]") }
    );
    let owners: Vec<&String> = header.bodies.iter().chain(&header.joints).collect();
    named::stub(text, (&visibility, &name), &owners, &header.states, MANY);
}

fn constants(text: &mut String, header: &Header) {
    let name = header.name.to_string();
    let zeros = format!("[0.0; {MANY}]");
    let (usize, str) = ("::core::primitive::usize", "&'static ::core::primitive::str");
    let _ = writeln!(text, "#[allow(missing_docs, dead_code)] impl {name}<::core::primitive::f64> {{");
    let internal = if header.states.is_empty() { "()" } else { &zeros };
    let _ = writeln!(
        text,
        "pub const START: {name}State = @RUNTIME@::State {{ q: {zeros}, v: {zeros}, z: {internal}, gates: () }};"
    );
    for constant in ["DEGREES_OF_FREEDOM", "OPERATIONS"] {
        let _ = writeln!(text, "pub const {constant}: {usize} = 1;");
    }
    for constant in ["SOURCE", "DEFINITION", "COORDINATES"] {
        let _ = writeln!(text, "pub const {constant}: {str} = \"\";");
    }
    for constant in ["BODIES", "JOINTS", "LOADS", "SHARED_REACTIONS"] {
        let _ = writeln!(text, "pub const {constant}: &'static [{str}] = &[\"\"; {MANY}];");
    }
    let _ = writeln!(text, "pub const REDUNDANT_ROWS: &'static [({str}, {str})] = &[(\"\", \"\"); {MANY}];");
    text.push_str("}\n");
}

fn implementations(text: &mut String, header: &Header) {
    let name = header.name.to_string();
    let list = format!("[R; {MANY}]");
    let functions = |interface: Interface| {
        let own = FUNCTIONS.iter().filter(|signature| signature.interface == interface);
        own.map(|signature| function(header, &list, signature)).collect::<String>()
    };
    let [_, inputs, outputs] = header.structs().map(|given| header.given(given));
    let matrices = DERIVATIVES.map(|matrix| {
        format!("fn {}(&self) -> &[(u16, u16)] {{ &[] }}\ntype {} = {list};\n", matrix.pattern, matrix.name)
    });
    let space = if header.spatial { Space::Spatial } else { Space::Planar };
    let report =
        report::stub(space, |shape| header.type_of(shape, &list), |shape| header.count(shape).to_string());
    let replaced = TEMPLATE
        .replace("@REPORT@", &report)
        .replace("@FUNCTIONS@", &functions(Interface::Model))
        .replace("@FUNCTIONS_OF_MECHANISM@", &functions(Interface::Mechanism))
        .replace("@FUNCTIONS_OF_ASSEMBLE@", &functions(Interface::Assemble))
        .replace("@FUNCTIONS_OF_TANGENT@", &functions(Interface::Tangent))
        .replace("@DECLARED@", &declared(header))
        .replace("@DERIVATIVES@", &matrices.concat())
        .replace("@NAME@", &name)
        .replace("@Z@", if header.states.is_empty() { "()" } else { &list })
        .replace("@INPUTS@", &inputs)
        .replace("@OUTPUTS@", &outputs)
        .replace("@LIST@", &list)
        .replace("@MANY@", &MANY.to_string());
    text.push_str(&replaced);
    for (fields, suffix) in header.structs() {
        if suffix == "Parameters" || !fields.is_empty() {
            let fields = FIELDS.replace("@STRUCT@", &format!("{name}{suffix}")).replace("@LIST@", &list);
            text.push_str(&fields);
        }
    }
}

/// Values in declared units.
fn declared(header: &Header) -> String {
    let mut text = String::new();
    for suffix in ["Parameters", "Inputs", "Outputs", "Internal"] {
        let own: Vec<(String, DeclaredUnit)> = header
            .declared
            .iter()
            .filter(|(of, ..)| *of == suffix)
            .map(|(_, name, unit)| {
                let unit = DeclaredUnit { text: unit.text.clone(), scale: unit.scale, si: String::new() };
                (name.clone(), unit)
            })
            .collect();
        let fields = own.iter().map(|(name, unit)| (name.clone(), unit));
        declared::of_struct(&mut text, &format!("{}{suffix}", header.name), fields, suffix != "Outputs");
    }
    text
}

/// A function that does nothing.
fn function(header: &Header, list: &str, signature: &Signature) -> String {
    let type_of = |shape: Shape| header.type_of(shape, list);
    let access = if signature.interface == Interface::Model { "pub " } else { "" };
    let head = head(signature, type_of, |shape| header.count(shape).to_string());
    format!("{access}{head} {{ loop {{}} }}\n")
}

impl Header {
    /// The struct of these fields; `()` where there are none.
    fn given(&self, (fields, suffix): (&[String], &str)) -> String {
        if fields.is_empty() && suffix != "Parameters" {
            "()".to_string()
        } else {
            format!("{}{suffix}<R>", self.name)
        }
    }

    /// A shape as far as the definition tells: lists of numbers are long.
    fn type_of(&self, shape: Shape, list: &str) -> String {
        let [parameters, inputs, outputs] = self.structs();
        let space = if self.spatial { Space::Spatial } else { Space::Planar };
        match shape {
            Shape::Scalar => "R".to_string(),
            Shape::State if self.states.is_empty() => format!("State<{list}, {list}>"),
            Shape::State => format!("State<{list}, {list}, {list}>"),
            Shape::Internal if self.states.is_empty() => "()".to_string(),
            Shape::Gates => "()".to_string(),
            Shape::Parameters => self.given(parameters),
            Shape::Inputs => self.given(inputs),
            Shape::Outputs => self.given(outputs),
            Shape::Bodies(record) | Shape::Joints(record) => {
                format!("[{}<R>; {}]", record.of(space).name, self.count(shape))
            }
            Shape::Loads | Shape::Drivers => format!("[R; {}]", self.count(shape)),
            _ => list.to_string(),
        }
    }

    /// Entries of lists whose length other code may rely on.
    fn count(&self, shape: Shape) -> usize {
        let [bodies, joints, loads, drivers] = self.counts.unwrap_or([MANY; 4]);
        match shape {
            Shape::Bodies(_) => bodies,
            Shape::Joints(_) => joints,
            Shape::Loads => loads,
            Shape::Drivers => drivers,
            _ => MANY,
        }
    }
}

const FIELDS: &str = "
const _: () = {
use ::core::prelude::rust_2024::*;
use @RUNTIME@::*;
impl<R: Real> Fields<R> for @STRUCT@<R> {
    const NAMES: &'static [&'static ::core::primitive::str] = &[];
    type Array = @LIST@;
    fn from_array(_: @LIST@) -> Self { loop {} }
    fn to_array(&self) -> @LIST@ { loop {} }
}
};
";

const TEMPLATE: &str = "
#[allow(unused, clippy::all)] const _: () = {
use ::core::prelude::rust_2024::*;
use @RUNTIME@::*;
use ::core::primitive::{bool, f64, u16, u32, usize, str};
impl<R: Real> Default for @NAME@Parameters<R> { fn default() -> Self { loop {} } }
@DECLARED@
impl<R: Real> Default for @NAME@<R> { fn default() -> Self { loop {} } }
impl<R: Real> @NAME@<R> {
    pub fn prepare(parameters: @NAME@Parameters<R>) -> Result<Self, SettingError> { loop {} }
    pub fn parameters(&self) -> &@NAME@Parameters<R> { loop {} }
    @FUNCTIONS@
}
impl<R: Real> Variables<R> for @NAME@<R> {
    fn layout(&self) -> &Layout<'_> { &Layout { linear: @MANY@, rotations: 0, quaternions: 0, angles: &[] } }
    type Q = @LIST@; type V = @LIST@; type Lambda = @LIST@; type Z = @Z@; type Gates = ();
}
impl<R: Real> Mechanism<R> for @NAME@<R> {
    fn name(&self) -> &'static str { \"\" }
    fn rows(&self) -> &[Row] { &[] }
    fn position_names(&self) -> &[&'static str] { &[] }
    fn velocity_names(&self) -> &[&'static str] { &[] }
    fn mass_pattern(&self) -> &[(u16, u16)] { &[] }
    fn jacobian_pattern(&self) -> &[(u16, u16)] { &[] }
    type Mass = @LIST@; type Jacobian = @LIST@;
    type Inputs = @INPUTS@; type Outputs = @OUTPUTS@;
    fn input_names(&self) -> &'static [&'static str] { &[] }
    fn output_names(&self) -> &'static [&'static str] { &[] }
    fn unwrap(&self, outputs: &mut @OUTPUTS@, previous: &@OUTPUTS@) {}
    @FUNCTIONS_OF_MECHANISM@
}
impl<R: Real> Parametric<R> for @NAME@<R> {
    type Parameters = @NAME@Parameters<R>;
    fn parameters(&self) -> &@NAME@Parameters<R> { loop {} }
    fn prepare(_parameters: @NAME@Parameters<R>) -> Result<Self, SettingError> { loop {} }
}
impl<S> InScalars for @NAME@<S> {
    type In<R: Real> = @NAME@<R>;
    fn zip<A: Real, B: Real, C: Real>(a: &@NAME@<A>, b: &@NAME@<B>, f: &mut impl FnMut(A, B) -> C) -> @NAME@<C> { loop {} }
}
impl<R: Real> Report<R> for @NAME@<R> {
    @REPORT@
}
impl<R: Real> Assemble<R> for @NAME@<R> {
    fn conditions(&self) -> &[Condition] { &[] }
    fn start_conditions(&self) -> &[u16] { &[] }
    fn start_rates(&self) -> &[u16] { &[] }
    fn independent(&self) -> &[u16] { &[] }
    fn condition_pattern(&self) -> &[(u16, u16)] { &[] }
    fn flips(&self) -> &[Flips<'_>] { &[] }
    fn row_sizes(&self) -> @LIST@ { loop {} }
    fn elimination(&self) -> Elimination<'_> { Elimination { order: &[], position: &[], row_start: &[], columns: &[] } }
    type Conditions = @LIST@; type ConditionJacobian = @LIST@; type Factor = @LIST@; type System = @LIST@;
    type Dense = @LIST@; type Basis = @LIST@; type Reduced = @LIST@; type Choice = [u16; @MANY@]; type Store = @LIST@;
    type Lu = @LIST@;
    fn lu(&self) -> @LIST@ { loop {} }
    fn choice(&self) -> [u16; @MANY@] { loop {} }
    fn store(&self) -> @LIST@ { loop {} }
    fn start_q(&self) -> @LIST@ { loop {} }
    fn start_v(&self) -> @LIST@ { loop {} }
    fn start_gates(&self) {}
    @FUNCTIONS_OF_ASSEMBLE@
}
impl<R: Real> Tangent<R> for @NAME@<R> {
    fn states(&self) -> &[u16] { &[] }
    @DERIVATIVES@
    type StateMatrix = @LIST@; type InputMatrix = @LIST@; type OutputMatrix = @LIST@;
    type Feedthrough = @LIST@; type Unknowns = @LIST@; type Bordered = @LIST@; type Parameters = @NAME@Parameters<R>;
    type Order = [u16; @MANY@];
    fn parameter_names(&self) -> &[&'static str] { &[] }
    fn order(&self) -> [u16; @MANY@] { loop {} }
    @FUNCTIONS_OF_TANGENT@
}
};
";
