//! The functions of the header over the mechanism in Rust: each turns pointers into references, behind which the runtime has what is to
//! be done. This is the only unsafe code that is ever emitted, and only where `options { export_c = f64; }` asks for it.
//!
//! ```text
//! /// # Safety …
//! #[unsafe(no_mangle)] pub unsafe extern "C" fn press_step_rk4(plant: *mut Plant, u: *const Inputs, h: R, tick: *mut Tick<R>) -> i32 { … }
//! ```

use super::Writer;
use super::evaluation::Call;
use super::header::STATUSES;
use crate::emit::field;
use crate::functions::{Argument, Interface, Shape, Signature, Way};
use crate::scalar::Scalar;
use std::fmt::Write;

/// What a caller has to see to.
const SAFETY: &str = "/// # Safety\n/// Pointers are null or valid for what the header says, aligned, and to nothing that others use meanwhile.\n";
/// The same of the functions that look at no pointer.
const VALID: &str = "/// # Safety\n/// Pointers are valid for what the header says, aligned, and to nothing that others use meanwhile.\n";

impl Writer<'_> {
    /// All of them, in a scope of their own, `path` being that of the runtime's names.
    pub fn shims(&self, path: &str) -> String {
        let mut text = String::from(
            "#[allow(unsafe_code, unused, missing_docs, non_upper_case_globals, improper_ctypes_definitions, clippy::all)] const _: () = {\n",
        );
        self.types(&mut text, path);
        self.constants(&mut text);
        self.plant(&mut text);
        self.steps_in_rust(&mut text);
        for signature in self.public() {
            self.equation(&mut text, signature, &self.call(signature));
        }
        text.push_str("};\n");
        text
    }

    fn has(&self, shape: Shape) -> bool {
        self.compiled.entries(shape) > 0
    }

    /// Short names, none of which is the user's.
    fn types(&self, text: &mut String, path: &str) {
        let name = &self.compiled.mechanism.name.text;
        let real = if self.scalar == Scalar::F64 { "f64" } else { "f32" };
        let own = |what: &str, has: bool| if has { format!("{name}{what}<Real_>") } else { "()".to_string() };
        let unwraps = !self.compiled.angles_in_outputs().is_empty();
        let some = self.has(Shape::Parameters) || self.has(Shape::Phases) || self.has(Shape::Constants);
        let _ = write!(
            text,
            "use {path} as __runtime;\nuse __runtime::c_interface as __c;\n\
             type Real_ = ::core::primitive::{real};\ntype Model_ = {name}<Real_>;\n\
             type Parameters_ = {name}Parameters<Real_>;\ntype Inputs_ = {};\ntype Outputs_ = {};\n\
             type State_ = {name}State<Real_>;\ntype Tick_ = __runtime::Tick<Real_>;\n\
             type Last_ = {};\ntype Empty_ = {};\n\
             type Plant_ = __c::Plant<Model_, State_, Real_, Last_, Empty_>;\n\
             type Saved_ = __c::SavedInC<State_, Real_>;\ntype Status_ = ::core::primitive::i32;\n\
             type Char_ = ::core::ffi::c_char;\n\
             // SAFETY: `to` is valid for what is written, says the caller.\n\
             unsafe fn put_<T, U>(to: *mut T, value: U) {{ unsafe {{ to.cast::<U>().write(value) }} }}\n",
            own("Inputs", self.has(Shape::Inputs)),
            own("Outputs", self.has(Shape::Outputs)),
            if unwraps { "__c::Last<Outputs_>" } else { "()" },
            if some { "()" } else { "::core::primitive::u32" },
        );
    }

    /// Numbers as an array in Rust.
    fn array(&self, values: &[f64]) -> String {
        let suffix = if self.scalar == Scalar::F64 { "f64" } else { "f32" };
        let literal = |value: &f64| match *value {
            value if value.is_finite() && self.scalar == Scalar::F64 => format!("{value:?}_{suffix}"),
            value if value.is_finite() => format!("{:?}_{suffix}", value as f32),
            _ => "Real_::NAN".to_string(),
        };
        format!("[{}]", values.iter().map(literal).collect::<Vec<_>>().join(", "))
    }

    fn constants(&self, text: &mut String) {
        let (prefix, compiled) = (&self.prefix.lower, self.compiled);
        let z = match compiled.mechanism.internal_starts().as_slice() {
            [] => "()".to_string(),
            z => self.array(z),
        };
        let _ = writeln!(
            text,
            "#[unsafe(no_mangle)] pub static {prefix}_start: State_ = __runtime::State {{ q: {}, v: {}, z: {z}, gates: () }};",
            self.array(&compiled.assembly.q),
            self.array(&compiled.assembly.v)
        );
        if self.has(Shape::Parameters) {
            let fields = compiled.mechanism.parameters.iter().map(|parameter| {
                let value = self.array(&[parameter.default]);
                format!("{}: {}", field(&parameter.name.identifier()), value.trim_matches(['[', ']']))
            });
            let _ = writeln!(
                text,
                "#[unsafe(no_mangle)] pub static {prefix}_default_parameters: Parameters_ = {}Parameters {{ {} }};",
                compiled.mechanism.name.text,
                fields.collect::<Vec<_>>().join(", ")
            );
        }
        let texts: Vec<String> =
            STATUSES.iter().map(|(_, text)| format!("{:?}", format!("{text}\0"))).collect();
        self.shim(
            text,
            "status_text",
            "status: Status_",
            "*const Char_",
            &format!(
                "let texts: [&::core::primitive::str; {}] = [{}];\n\
                 let text = ::core::convert::TryFrom::try_from(status).ok().and_then(|at: ::core::primitive::usize| texts.get(at).copied());\n\
                 text.unwrap_or(\"unknown status\\0\").as_ptr().cast()",
                texts.len(),
                texts.join(", ")
            ),
        );
    }

    fn shim(&self, text: &mut String, name: &str, arguments: &str, value: &str, body: &str) {
        let _ = writeln!(
            text,
            "{SAFETY}#[unsafe(no_mangle)] pub unsafe extern \"C\" fn {}_{name}({arguments}) -> {value} {{\n{body}\n}}",
            self.prefix.lower
        );
    }

    /// Beginning, parameters, states.
    fn plant(&self, text: &mut String) {
        let unwraps = !self.compiled.angles_in_outputs().is_empty();
        let last = match unwraps {
            // Zeros, which nobody reads before they are written.
            true => {
                "__c::Last { outputs: __runtime::Fields::<Real_>::from_array([0.0; ".to_string()
                    + &format!("{}]), seen: 0 }}", self.compiled.entries(Shape::Outputs))
            }
            false => "()".to_string(),
        };
        let some = self.has(Shape::Parameters) || self.has(Shape::Phases) || self.has(Shape::Constants);
        let empty = if some { "()" } else { "0" };
        let has_parameters = self.has(Shape::Parameters);
        let (argument, given) = match has_parameters {
            true => (", parameters: *const Parameters_", "unsafe { parameters.as_ref() }"),
            false => ("", "::core::option::Option::None"),
        };
        self.shim(
            text,
            "init",
            &format!("plant: *mut Plant_{argument}"),
            "Status_",
            &format!(
                "if plant.is_null() {{ return __c::NULL; }}\n\
                 // SAFETY: null or valid, says the caller.\n\
                 match __c::model::<Model_, Real_>({given}) {{\n\
                 ::core::result::Result::Err(status) => status,\n\
                 // SAFETY: valid, says the caller; what was there before is no value that is dropped.\n\
                 ::core::result::Result::Ok(model) => {{ unsafe {{ plant.write(__c::init(model, {last}, {empty})) }}; __c::OK }}\n}}"
            ),
        );
        let one = |pointers: &[(&str, bool)]| {
            let names: Vec<&str> = pointers.iter().map(|(name, _)| *name).collect();
            let references = pointers.iter().map(|(name, mutable)| {
                format!("unsafe {{ {name}.{}() }}", if *mutable { "as_mut" } else { "as_ref" })
            });
            let some = names.iter().map(|name| format!("::core::option::Option::Some({name})"));
            format!(
                "// SAFETY: null or valid, says the caller.\n\
                 let ({},) = ({},) else {{ return __c::NULL }};\n",
                some.collect::<Vec<_>>().join(", "),
                references.collect::<Vec<_>>().join(", ")
            )
        };
        if has_parameters {
            self.shim(
                text,
                "set_parameters",
                "plant: *mut Plant_, parameters: *const Parameters_",
                "Status_",
                &(one(&[("plant", true), ("parameters", false)]) + "__c::set_parameters(plant, parameters)"),
            );
            let compiled = self.compiled;
            let parameters = compiled.mechanism.parameters.iter().map(|known| known.name.text.clone());
            let masses = compiled.masses.iter().map(|(what, _)| what.clone());
            let names = parameters.chain(masses).chain(["the parameters together".to_string()]);
            let pairs = names.map(|name| format!("({name:?}, {:?})", format!("{name}\0")));
            self.shim(
                text,
                "wrong_parameter",
                "parameters: *const Parameters_",
                "*const Char_",
                &format!(
                    "// SAFETY: null or valid, says the caller.\n\
                     let wrong = unsafe {{ parameters.as_ref() }}.and_then(__c::wrong_parameter::<Model_, Real_>);\n\
                     let names = [{}];\n\
                     let found = wrong.and_then(|wrong| names.iter().find(|(name, _)| *name == wrong));\n\
                     found.map_or(::core::ptr::null(), |(_, text)| text.as_ptr().cast())",
                    pairs.collect::<Vec<_>>().join(", ")
                ),
            );
        }
        self.shim(
            text,
            "set_state",
            "plant: *mut Plant_, time: Real_, state: *const State_",
            "Status_",
            &(one(&[("plant", true), ("state", false)])
                + "__c::set_state(plant, time, state, __runtime::Rk4)"),
        );
        self.shim(
            text,
            "save",
            "plant: *const Plant_, saved: *mut Saved_",
            "Status_",
            &(one(&[("plant", false)])
                + "if saved.is_null() { return __c::NULL; }\n\
                   // SAFETY: valid, says the caller.\nunsafe { saved.write(__c::save(plant)) };\n__c::OK"),
        );
        self.shim(
            text,
            "restore",
            "plant: *mut Plant_, saved: *const Saved_, size: ::core::primitive::usize",
            "Status_",
            &(one(&[("plant", true), ("saved", false)]) + "__c::restore(plant, saved, size, __runtime::Rk4)"),
        );
        if self.has(Shape::Rows) {
            self.shim(
                text,
                "assemble",
                "plant: *mut Plant_",
                "Status_",
                &(one(&[("plant", true)]) + "__c::assemble(plant, __runtime::Rk4)"),
            );
        }
        if self.has(Shape::Outputs) {
            let (argument, pointers, u) = match self.has(Shape::Inputs) {
                true => ("u: *const Inputs_, ", vec![("plant", true), ("u", false)], "u"),
                false => ("", vec![("plant", true)], "&()"),
            };
            let found = match unwraps {
                true => format!("__c::read_outputs(plant, {u})"),
                false => format!(
                    "__runtime::Mechanism::<Real_>::outputs(&plant.model, plant.time[0], &plant.state, {u})"
                ),
            };
            self.shim(
                text,
                "read_outputs",
                &format!("plant: *mut Plant_, {argument}outputs: *mut Outputs_"),
                "Status_",
                &(one(&pointers)
                    + &format!(
                        "if outputs.is_null() {{ return __c::NULL; }}\n\
                         // SAFETY: valid, says the caller.\nunsafe {{ outputs.write({found}) }};\n__c::OK"
                    )),
            );
        }
    }

    fn steps_in_rust(&self, text: &mut String) {
        let corrected = "__runtime::Corrected::after(__runtime::LagrangeIndex1)";
        for (integrator, method) in
            [("rk4", "__runtime::Rk4"), ("semi_implicit_euler", "__runtime::SemiImplicitEuler")]
        {
            let ways = [
                (String::new(), method.to_string()),
                ("_corrected".to_string(), format!("({method}, {corrected})")),
            ];
            for (suffix, method) in ways.into_iter().take(if self.has(Shape::Rows) { 2 } else { 1 }) {
                let (argument, bound, u) = match self.has(Shape::Inputs) {
                    true => (
                        " u: *const Inputs_,",
                        "let (::core::option::Option::Some(plant), ::core::option::Option::Some(u)) = (unsafe { plant.as_mut() }, unsafe { u.as_ref() })",
                        "u",
                    ),
                    false => {
                        ("", "let ::core::option::Option::Some(plant) = (unsafe { plant.as_mut() })", "&()")
                    }
                };
                self.shim(
                    text,
                    &format!("step_{integrator}{suffix}"),
                    &format!("plant: *mut Plant_,{argument} h: Real_, tick: *mut Tick_"),
                    "Status_",
                    &format!(
                        "// SAFETY: null or valid, says the caller.\n{bound} else {{ return __c::NULL }};\n\
                         // SAFETY: as above.\n__c::step(plant, {u}, h, {method}, unsafe {{ tick.as_mut() }})"
                    ),
                );
            }
        }
    }

    /// One of the functions of the equations.
    fn equation(&self, text: &mut String, signature: &'static Signature, call: &Call) {
        let list = |shape: Shape| format!("[Real_; {}]", self.compiled.entries(shape));
        let declared = call.given.iter().map(|argument| match argument {
            Argument::Constants => "model: *const Model_".to_string(),
            Argument::State => "state: *const State_".to_string(),
            Argument::Inputs => "u: *const Inputs_".to_string(),
            argument if matches!(argument.given().shape, Shape::Scalar) => {
                format!("{}: Real_", argument.name())
            }
            argument => format!("{}: *const Real_", argument.name()),
        });
        let written = call.written.iter().map(|result| match result.extent {
            None => format!("{}: *mut Outputs_", result.name),
            Some(_) => format!("{}: *mut {}", result.name, self.entry_of(signature, result.name)),
        });
        let value = if call.value { "Real_" } else { "()" };
        let arguments: Vec<String> = declared.chain(written).collect();
        let _ = writeln!(
            text,
            "{VALID}#[unsafe(no_mangle)] pub unsafe extern \"C\" fn {}({}) -> {value} {{",
            call.name,
            arguments.join(", ")
        );
        text.push_str("// SAFETY: pointers are valid for these lengths, says the caller.\n");
        let mut given: Vec<String> = Vec::new();
        for argument in signature.arguments.iter().filter(|argument| **argument != Argument::Constants) {
            let has = call.given.contains(argument);
            given.push(match argument.given().shape {
                Shape::Scalar => argument.name().to_string(),
                Shape::Inputs if !has => "&()".to_string(),
                Shape::State | Shape::Inputs => format!("unsafe {{ &*{} }}", argument.name()),
                _ if !has => "&[]".to_string(),
                shape => format!("unsafe {{ &*{}.cast::<{}>() }}", argument.name(), list(shape)),
            });
        }
        for group in signature.results.iter().filter(|group| group.way == Way::Written) {
            given.push(match self.compiled.entries(group.shape) {
                0 => "&mut []".to_string(),
                _ => format!("unsafe {{ &mut *{}.cast::<{}>() }}", group.name, list(group.shape)),
            });
        }
        let of = match signature.interface {
            Interface::Mechanism => "<Model_ as __runtime::Mechanism<Real_>>",
            Interface::Tangent => "<Model_ as __runtime::Tangent<Real_>>",
            _ => "Model_",
        };
        let called = format!("{of}::{}(unsafe {{ &*model }}, {})", signature.name, given.join(", "));
        let values: Vec<&str> = signature
            .results
            .iter()
            .filter(|group| group.way == Way::Value && !matches!(group.shape, Shape::Scalar))
            .map(|group| group.name)
            .collect();
        let _ = match values.as_slice() {
            [] if call.value => writeln!(text, "{called}"),
            [] => writeln!(text, "{called};"),
            [one] => writeln!(text, "let value = {called};\nunsafe {{ put_({one}, value) }};"),
            several => {
                let _ = writeln!(text, "for (at, entry) in {called}.iter().enumerate() {{");
                for (index, name) in several.iter().enumerate() {
                    let _ = writeln!(text, "unsafe {{ {name}.add(at).write(entry[{index}]) }};");
                }
                writeln!(text, "}}")
            }
        };
        text.push_str("}\n");
    }

    /// The type of what a list has.
    fn entry_of(&self, signature: &Signature, name: &str) -> String {
        let group = signature.results.iter().find(|group| group.name == name);
        match group.and_then(|group| group.shape.record()) {
            Some(record) => format!("__runtime::{}<Real_>", record.of(self.compiled.mechanism.space).name),
            None => "Real_".to_string(),
        }
    }
}
