//! Values in the units that they are declared in. The fields of the emitted structs are in SI units, as all of the code is; beside
//! a field whose unit is another one stand functions that have this unit in their name:
//!
//! ```text
//! pub struct LiftParameters<R = f64> { pub stroke: R, … }          // m
//! impl<R: Real> LiftParameters<R> {
//!     pub fn stroke_mm(&self) -> R { … }
//!     pub fn set_stroke_mm(&mut self, value: R) { … }
//! }
//! ```

use super::Emitter;
use super::names::field;
use super::rust::literal;
use crate::model::DeclaredUnit;
use std::fmt::Write;

/// What the documentation of a field says of its unit: `what` is the struct, of which `name` is a field.
pub fn doc(unit: &DeclaredUnit, what: &str, name: &str, default: Option<f64>) -> String {
    let default = default.map_or(String::new(), |default| format!(", default {default:?}"));
    match (unit.is_si(), unit.text.as_str()) {
        (true, "1") => format!("A plain number{default}."),
        (true, text) => format!("In `{text}`{default}."),
        (false, text) => {
            let method = method(name, unit);
            format!(
                "In `{}`{default}. In `{text}`, as it is declared: [`{method}`]({what}::{method}).",
                unit.si
            )
        }
    }
}

/// The functions of all structs.
pub fn functions(text: &mut String, emitter: &Emitter) {
    let mechanism = emitter.mechanism;
    let parameters = mechanism.parameters.iter().map(|it| (it.name.identifier(), &it.unit));
    let inputs = mechanism.inputs.iter().map(|it| (it.name.identifier(), &it.unit));
    let outputs = mechanism.outputs.iter().map(|it| (it.name.identifier(), &it.unit));
    let internal = mechanism.states.iter().map(|it| (it.name.identifier(), &it.unit));
    of_struct(text, &format!("{}Parameters", emitter.name), parameters, true);
    of_struct(text, &format!("{}Inputs", emitter.name), inputs, true);
    of_struct(text, &format!("{}Outputs", emitter.name), outputs, false);
    of_struct(text, &format!("{}Internal", emitter.name), internal, true);
}

/// Those of a struct whose fields have such units; of outputs there is nothing to set.
pub fn of_struct<'u>(
    text: &mut String,
    name: &str,
    fields: impl Iterator<Item = (String, &'u DeclaredUnit)>,
    set: bool,
) {
    let mut fields = fields.filter(|(_, unit)| !unit.is_si()).peekable();
    if fields.peek().is_none() {
        return;
    }
    let _ = writeln!(text, "impl<R: Real> {name}<R> {{");
    for (own, unit) in fields {
        let (method, scale, place) = (method(&own, unit), literal(unit.scale), field(&own));
        let (written, si) = (&unit.text, &unit.si);
        let _ = writeln!(
            text,
            "/// The value of `{own}` in `{written}`.\n\
             pub fn {method}(&self) -> R {{ self.{place} / R::from_f64({scale}) }}"
        );
        if set {
            let _ = writeln!(
                text,
                "/// Sets `{own}` (`{si}`) to a value in `{written}`.\n\
                 pub fn set_{method}(&mut self, value: R) {{ self.{place} = value * R::from_f64({scale}); }}"
            );
        }
    }
    text.push_str("}\n");
}

/// `stroke_mm`, `speed_km_per_h`.
fn method(name: &str, unit: &DeclaredUnit) -> String {
    let text = unit
        .text
        .replace('*', "_")
        .replace('/', "_per_")
        .replace('^', "")
        .replace(['\u{b5}', '\u{3bc}'], "u");
    let text = text.strip_prefix("1_").unwrap_or(&text);
    format!("{name}_{text}")
}
