//! What stands in the model's place after an error, so that one mistake gives one message.
//!
//! Every name that other code may use exists, with the types it would have as far as the broken definition tells; the
//! functions do nothing. None of it can run, because the crate does not compile.

use super::home::Home;
use super::names::{field, is_keyword};
use crate::driver::header;
use crate::syntax::Header;
use proc_macro2::TokenStream;
use std::fmt::Write;

/// Entries of arrays whose length the definition would have told: more than other code is likely to index.
const MANY: usize = 1024;

/// Items with the model's names; nothing if not even a name was written.
pub fn stub(tokens: TokenStream, home: &Home) -> TokenStream {
    let Some(header) = header(tokens) else { return TokenStream::new() };
    if is_keyword(&header.name.to_string()) {
        return TokenStream::new();
    }
    let mut text = String::new();
    structs(&mut text, &header);
    constants(&mut text, &header);
    implementations(&mut text, &header);
    let runtime = home.runtime(header.crate_path.as_ref(), &header.name.to_string());
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
         @RUNTIME@::State<[R; {MANY}], [R; {MANY}]>;"
    );
}

fn constants(text: &mut String, header: &Header) {
    let name = header.name.to_string();
    let zeros = format!("[0.0; {MANY}]");
    let (usize, str) = ("::core::primitive::usize", "&'static ::core::primitive::str");
    let _ = writeln!(text, "#[allow(missing_docs, dead_code)] impl {name}<::core::primitive::f64> {{");
    let _ = writeln!(text, "pub const START: {name}State = @RUNTIME@::State {{ q: {zeros}, v: {zeros} }};");
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
    let given = |(fields, suffix): (&[String], &str)| {
        if fields.is_empty() { "()".to_string() } else { format!("{name}{suffix}<R>") }
    };
    let [_, inputs, outputs] = header.structs().map(given);
    let [bodies, joints, loads, drivers] = header.counts.unwrap_or([MANY; 4]).map(|count| count.to_string());
    let list = format!("[R; {MANY}]");
    let (motion, reaction) = match header.spatial {
        true => ("SpatialMotion", "SpatialReaction"),
        false => ("BodyMotion", "Reaction"),
    };
    let replaced = TEMPLATE
        .replace("@BODIES@", &bodies)
        .replace("@JOINTS@", &joints)
        .replace("@LOADS@", &loads)
        .replace("@DRIVERS@", &drivers)
        .replace("@MOTION@", motion)
        .replace("@REACTION@", reaction)
        .replace("@NAME@", &name)
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
impl<R: Real> Default for @NAME@<R> { fn default() -> Self { loop {} } }
impl<R: Real> @NAME@<R> {
    pub fn prepare(parameters: @NAME@Parameters<R>) -> Result<Self, SettingError> { loop {} }
    pub fn parameters(&self) -> &@NAME@Parameters<R> { loop {} }
    pub fn motions(&self, time: R, q: &@LIST@, v: &@LIST@, a: &@LIST@) -> [@MOTION@<R>; @BODIES@] { loop {} }
    pub fn reactions(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@, a: &@LIST@, l: &@LIST@) -> [@REACTION@<R>; @JOINTS@] { loop {} }
    pub fn inverse_dynamics(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@, a: &@LIST@) -> @LIST@ { loop {} }
    pub fn powers(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@) -> [R; @LOADS@] { loop {} }
    pub fn driver_efforts(&self, time: R, q: &@LIST@, v: &@LIST@, lambda: &@LIST@) -> [[R; 2]; @DRIVERS@] { loop {} }
}
impl<R: Real> Mechanism<R> for @NAME@<R> {
    const NAME: &'static str = \"\";
    const LAYOUT: Layout = Layout { linear: @MANY@, rotations: 0, quaternions: 0, angles: &[] };
    const ROWS: &'static [Row] = &[];
    const POSITION_NAMES: &'static [&'static str] = &[];
    const VELOCITY_NAMES: &'static [&'static str] = &[];
    const MASS_PATTERN: &'static [(u16, u16)] = &[];
    const JACOBIAN_PATTERN: &'static [(u16, u16)] = &[];
    type Q = @LIST@; type V = @LIST@; type Lambda = @LIST@; type Mass = @LIST@; type Jacobian = @LIST@;
    type Inputs = @INPUTS@; type Outputs = @OUTPUTS@;
    fn mass_matrix(&self, time: R, q: &@LIST@, out: &mut @LIST@) {}
    fn constraints(&self, time: R, q: &@LIST@, out: &mut @LIST@) {}
    fn constraint_jacobian(&self, time: R, q: &@LIST@, out: &mut @LIST@) {}
    fn nu(&self, time: R, q: &@LIST@, out: &mut @LIST@) {}
    fn gamma(&self, time: R, q: &@LIST@, v: &@LIST@, out: &mut @LIST@) {}
    fn forces(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@, out: &mut @LIST@) {}
    fn kinetic_energy(&self, time: R, q: &@LIST@, v: &@LIST@) -> R { loop {} }
    fn potential_energy(&self, time: R, q: &@LIST@) -> R { loop {} }
    fn acceleration(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@, a: &mut @LIST@, l: &mut @LIST@) -> R { loop {} }
    fn acceleration_baumgarte(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@, x: R, y: R, a: &mut @LIST@, l: &mut @LIST@) -> R { loop {} }
    fn outputs(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@) -> @OUTPUTS@ { loop {} }
    fn unwrap(outputs: &mut @OUTPUTS@, previous: &@OUTPUTS@) {}
}
impl<R: Real> Assemble<R> for @NAME@<R> {
    const CONDITIONS: &'static [Condition] = &[];
    const START_CONDITIONS: &'static [u16] = &[];
    const START_RATES: &'static [u16] = &[];
    const INDEPENDENT: &'static [u16] = &[];
    const CONDITION_PATTERN: &'static [(u16, u16)] = &[];
    const FLIPS: &'static [Flips] = &[];
    const ROW_SIZES: &'static [f64] = &[];
    const ELIMINATION: Elimination = Elimination { order: &[], position: &[], row_start: &[], columns: &[] };
    type Conditions = @LIST@; type ConditionJacobian = @LIST@; type Factor = @LIST@; type System = @LIST@;
    type Dense = @LIST@; type Basis = @LIST@; type Reduced = @LIST@; type Choice = [u16; @MANY@]; type Store = @LIST@;
    type Lu = @LIST@;
    fn lu() -> @LIST@ { loop {} }
    fn row_scales(&self, out: &mut @LIST@) {}
    fn choice() -> [u16; @MANY@] { loop {} }
    fn store() -> @LIST@ { loop {} }
    fn factor(&self, time: R, q: &@LIST@, compliance: R, store: &mut @LIST@) -> R { loop {} }
    fn solve(&self, store: &@LIST@, forces: &@LIST@, rows: &@LIST@, a: &mut @LIST@, lambda: &mut @LIST@) {}
    fn condition_residual(&self, time: R, q: &@LIST@, target: &@LIST@, out: &mut @LIST@) {}
    fn condition_cosines(&self, time: R, q: &@LIST@, target: &@LIST@, out: &mut @LIST@) {}
    fn condition_jacobian(&self, time: R, q: &@LIST@, out: &mut @LIST@) {}
    fn condition_bias(&self, time: R, q: &@LIST@, v: &@LIST@, out: &mut @LIST@) {}
    fn condition_drift(&self, time: R, q: &@LIST@, out: &mut @LIST@) {}
    fn row_cosines(&self, time: R, q: &@LIST@, out: &mut @LIST@) {}
    fn start_targets(&self, positions: &mut @LIST@, rates: &mut @LIST@) {}
    fn start_q() -> @LIST@ { loop {} }
    fn start_v() -> @LIST@ { loop {} }
}
impl<R: Real> Tangent<R> for @NAME@<R> {
    const STATES: &'static [u16] = &[];
    const STIFFNESS_PATTERN: &'static [(u16, u16)] = &[];
    const DAMPING_PATTERN: &'static [(u16, u16)] = &[];
    const ROW_STIFFNESS_PATTERN: &'static [(u16, u16)] = &[];
    const ROW_DAMPING_PATTERN: &'static [(u16, u16)] = &[];
    const RATE_PATTERN: &'static [(u16, u16)] = &[];
    const INPUT_PATTERN: &'static [(u16, u16)] = &[];
    const PARAMETER_PATTERN: &'static [(u16, u16)] = &[];
    const OUTPUT_PATTERN: &'static [(u16, u16)] = &[];
    const COORDINATE_PATTERN: &'static [(u16, u16)] = &[];
    type Stiffness = @LIST@; type Damping = @LIST@; type RowStiffness = @LIST@; type RowDamping = @LIST@;
    type RateTangent = @LIST@; type InputTangent = @LIST@; type ParameterTangent = @LIST@; type OutputTangent = @LIST@;
    type CoordinateTangent = @LIST@; type StateMatrix = @LIST@; type InputMatrix = @LIST@; type OutputMatrix = @LIST@;
    type Feedthrough = @LIST@; type Unknowns = @LIST@; type Bordered = @LIST@; type Parameters = @NAME@Parameters<R>;
    type Order = [u16; @MANY@];
    fn order() -> [u16; @MANY@] { loop {} }
    fn residual(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@, a: &@LIST@, lambda: &@LIST@, out: &mut @LIST@) {}
    fn tangent(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@, a: &@LIST@, lambda: &@LIST@, x: &mut @LIST@, y: &mut @LIST@) {}
    fn row_tangent(&self, time: R, q: &@LIST@, v: &@LIST@, a: &@LIST@, x: &mut @LIST@, y: &mut @LIST@) {}
    fn rate_tangent(&self, time: R, q: &@LIST@, v: &@LIST@, out: &mut @LIST@) {}
    fn input_tangent(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@, out: &mut @LIST@) {}
    fn parameter_tangent(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@, a: &@LIST@, lambda: &@LIST@, out: &mut @LIST@) {}
    fn output_tangent(&self, time: R, q: &@LIST@, v: &@LIST@, u: &@INPUTS@, lambda: &@LIST@, out: &mut @LIST@) {}
    fn coordinate_tangent(&self, time: R, q: &@LIST@, v: &@LIST@, a: &@LIST@, out: &mut @LIST@) {}
}
};
";
