//! The model's own functions: `prepare`, `parameters`, and what follows from a state.

use super::function::functions;
use super::names::field;
use super::rust::{OUT, constant, literal};
use super::{Emitter, array, named, quoted};
use crate::functions::{Function, Interface};
use crate::schedule::Operand;
use std::fmt::Write;

/// `prepare`, `parameters`, and what follows from a state.
pub fn inherent(text: &mut String, emitter: &Emitter) {
    let Emitter { name, inner, mechanism, compiled, .. } = emitter;
    let mut helpers = String::new();
    let defaults = mechanism
        .parameters
        .iter()
        .map(|parameter| format!("{}: {}", field(&parameter.name.identifier()), constant(parameter.default)));
    let scalar = mechanism.parameters.is_empty().then(|| "scalar: ::core::marker::PhantomData".to_string());
    let defaults = defaults.chain(scalar).collect::<Vec<_>>().join(", ");
    let phases = array(compiled.assembly.phases.iter().map(|phase| constant(*phase)));
    let _ = writeln!(
        text,
        "impl<R: Real> Default for Parameters<R> {{ fn default() -> Self {{ {name}Parameters {{ {defaults} }} }} }}"
    );
    let _ = writeln!(
        text,
        "impl<R: Real> Default for {inner}<R> {{ \
         fn default() -> Self {{ Self::with(Default::default(), {phases}) }} }}"
    );
    let _ = writeln!(text, "impl<R: Real> {inner}<R> {{");
    let _ = writeln!(
        text,
        "/// The model with these parameters; what depends on nothing else is computed once, here.\n\
         ///\n/// # Errors\n/// A parameter that is not finite or out of its bounds, or a mass that is not positive.\n\
         pub fn prepare(parameters: Parameters<R>) -> Result<Self, SettingError> {{"
    );
    for parameter in &mechanism.parameters {
        let (what, field) = (quoted(&parameter.name.text), field(&parameter.name.identifier()));
        let _ = match parameter.bounds {
            None => writeln!(text, "check_finite({what}, parameters.{field})?;"),
            Some((least, most)) => writeln!(
                text,
                "check_setting({what}, parameters.{field}, {}, {}, {})?;",
                literal(least),
                literal(most),
                quoted(&format!("from {least:?} to {most:?} in SI units, by its declaration"))
            ),
        };
    }
    if emitter.compiled.complete.equations.open_rows(emitter.mechanism).is_empty() {
        let _ = writeln!(text, "let model = Self::with(parameters, {phases});");
    } else {
        // Open phases belong to the start position; these parameters may ask for others there.
        let _ = writeln!(text, "let mut model = Self::with(parameters, {phases});");
        text.push_str("let q = <Self as Assemble<R>>::start_q(&model);\nmodel.fix_phases(&q);\n");
    }
    masses(text, emitter);
    text.push_str("check_constants(&model.constants)?;\nOk(model)\n}\n");
    let _ = writeln!(
        text,
        "/// The parameters the model was prepared with.\npub fn parameters(&self) -> &Parameters<R> {{ &self.parameters }}"
    );
    let body = emitter.printer.body(Function::Prepare);
    helpers.push_str(&body.helpers);
    let _ = writeln!(
        text,
        "fn with(parameters: Parameters<R>, phases: Phases<R>) -> Self {{\n{}\
         Self {{ parameters, phases, constants: {} }}\n}}",
        body.statements,
        if body.placed { OUT.to_string() } else { array(body.outputs) }
    );
    named::functions(text, emitter);
    functions(text, &mut helpers, emitter, Interface::Model);
    text.push_str("}\n");
    let _ = writeln!(
        text,
        "impl<R: Real> Parametric<R> for {inner}<R> {{\n\
         type Parameters = Parameters<R>;\n\
         #[inline] fn parameters(&self) -> &Parameters<R> {{ &self.parameters }}\n\
         fn prepare(parameters: Parameters<R>) -> Result<Self, SettingError> {{ {inner}::<R>::prepare(parameters) }}\n}}"
    );
    let _ = writeln!(
        text,
        "impl<S> InScalars for {inner}<S> {{\n\
         type In<R: Real> = {inner}<R>;\n\
         fn zip<A: Real, B: Real, C: Real>(a: &{inner}<A>, b: &{inner}<B>, f: &mut impl FnMut(A, B) -> C) -> {inner}<C> {{\n\
         {inner} {{ parameters: zip_fields(&a.parameters, &b.parameters, f), phases: zip_arrays(&a.phases, &b.phases, f), \
         constants: zip_arrays(&a.constants, &b.constants, f) }}\n}}\n}}"
    );
    text.push_str(&helpers);
}

/// Masses and inertias that depend on parameters must stay what mass and inertia are.
fn masses(text: &mut String, emitter: &Emitter) {
    let program = emitter.compiled.programs.get(Function::Masses);
    for ((what, positive), output) in emitter.compiled.masses.iter().zip(&program.outputs) {
        let Operand::Source(source) = output else { continue };
        let mut place = String::new();
        emitter.printer.entry(&mut place, Function::Masses.signature(), *source);
        let _ = writeln!(text, "check_mass({}, model.{place}, {positive})?;", quoted(what));
    }
}
