//! The header: sizes, names of indices, structs, and what can be called.

use super::Writer;
use super::names::{constant, field, plain};
use super::source::tidy;
use crate::functions::{DERIVATIVES, JACOBIAN, MASS, MOTION, REACTION, Shape};
use crate::model::{DeclaredUnit, Name};
use std::collections::BTreeSet;
use std::fmt::Write;

/// What a function did, and what is to be done about it; the codes are those of the runtime's `StepError`.
pub const STATUSES: [(&str, &str); 11] = [
    ("OK", "all is well"),
    (
        "STEP_SIZE",
        "the size of a step must be positive, finite, and no less than a millionth of what the clock resolves",
    ),
    ("INPUT", "an input is not finite; the state is that before the step"),
    ("STATE", "the state is not finite, or an orientation is not of length 1; the state before is kept"),
    (
        "NOT_FINITE",
        "the step ended in a number that is not finite; take a smaller step, or look for a force that grows without bound",
    ),
    ("BREAKDOWN", "the equations have no solution here: a singular position; change the input or the state"),
    (
        "DIVERGED",
        "the step left the constraints; take a smaller step, a stronger correction, or assemble the state",
    ),
    (
        "OTHER_MODEL",
        "the saved state belongs to another definition, or to another version or size of its format",
    ),
    ("PARAMETER", "a parameter is not finite or out of its bounds, or a mass that follows is not positive"),
    ("ASSEMBLY", "the state cannot be brought to the constraints; the state before is kept"),
    ("NULL", "a pointer is null that must not be"),
];

impl Writer<'_> {
    pub fn header(&self) -> String {
        let mut template = self.template();
        let sizes = [&MASS, &JACOBIAN].into_iter().chain(DERIVATIVES).filter_map(|matrix| {
            let count = self.compiled.entries(Shape::Matrix(matrix));
            let name = super::Prefix::of(matrix.name).upper;
            (count > 0).then(|| format!("#define {}_{name}_ENTRIES {count}\n", self.prefix.upper))
        });
        template.word("sizes", sizes.collect());
        template.word("indices", self.indices());
        template.word("statuses", self.statuses());
        template.word("structs", self.structs());
        template.word("functions", self.heads());
        tidy(&template.fill(include_str!("c/interface.h")))
    }

    /// The header for C++.
    pub fn class(&self) -> String {
        let mut template = self.template();
        let given = self.compiled.entries(Shape::Inputs) > 0;
        template.word("cppinputs", if given { "const Inputs &inputs," } else { "" }.to_string());
        let parameters = self.compiled.entries(Shape::Parameters) > 0;
        template.word("cppnull", if parameters { ", nullptr" } else { "" }.to_string());
        template.word("class", plain(&self.compiled.mechanism.name.text));
        template.word("cppu", if given { " &inputs," } else { "" }.to_string());
        tidy(&template.fill(include_str!("c/interface.hpp"))).replace("( ", "(")
    }

    fn statuses(&self) -> String {
        let mut text = String::new();
        for (code, (name, what)) in STATUSES.iter().enumerate() {
            let _ = writeln!(
                text,
                "/* {what} */\n#define {}_{name} (({}_status_t){code})",
                self.prefix.upper, self.prefix.lower
            );
        }
        text
    }

    /// Constants for the entries of q, v, Φ and z.
    fn indices(&self) -> String {
        let (mechanism, equations) = (&self.compiled.mechanism, &self.compiled.complete.equations);
        let lists =
            [("Q", Shape::Positions), ("V", Shape::Velocities), ("ROW", Shape::Rows), ("Z", Shape::Internal)];
        let mut text = String::new();
        for (kind, shape) in lists {
            let mut taken = BTreeSet::new();
            for (index, name) in shape.names(mechanism, equations).iter().enumerate() {
                let mut name = constant(&self.prefix, kind, name);
                while !taken.insert(name.clone()) {
                    name.push('_');
                }
                let _ = writeln!(text, "#define {name} {index}");
            }
        }
        text
    }

    /// Parameters, inputs, outputs, and the records of bodies and joints.
    fn structs(&self) -> String {
        let mechanism = &self.compiled.mechanism;
        let mut text = String::new();
        let parameters = mechanism.parameters.iter().map(|it| (&it.name, &it.unit, it.bounds));
        let inputs = mechanism.inputs.iter().map(|it| (&it.name, &it.unit, None));
        let outputs = mechanism.outputs.iter().map(|it| (&it.name, &it.unit, None));
        self.fields(&mut text, "parameters", parameters);
        self.fields(&mut text, "inputs", inputs);
        self.fields(&mut text, "outputs", outputs);
        let (motion, reaction) = (MOTION.of(mechanism.space), REACTION.of(mechanism.space));
        if !mechanism.bodies.is_empty() {
            text.push_str(
                "/* Motion of a body: its centre of mass in world axes (m, m/s, m/s^2); its orientation as cosine and sine, in space as its \
                 axes; its\n   rate and that one's derivative (rad/s, rad/s^2), in space in its own axes. */\n",
            );
            text.push_str(&self.record("motion", motion));
        }
        if !mechanism.joints.is_empty() {
            text.push_str("/* What a joint exerts on the body of its second place: force (N) and torque (N m) in world axes. */\n");
            text.push_str(&self.record("reaction", reaction));
        }
        text
    }

    fn fields<'u>(
        &self,
        text: &mut String,
        what: &str,
        fields: impl Iterator<Item = (&'u Name, &'u DeclaredUnit, Option<(f64, f64)>)>,
    ) {
        let mut fields = fields.peekable();
        if fields.peek().is_none() {
            return;
        }
        let (prefix, real) = (&self.prefix.lower, self.scalar.c());
        let _ = writeln!(text, "typedef struct {prefix}_{what}_t {{");
        for (name, unit, bounds) in fields {
            let declared = match unit.is_si() {
                true if unit.text == "1" => "a plain number".to_string(),
                true => unit.text.clone(),
                false => format!("{}; declared in {}, of which one is {:?}", unit.si, unit.text, unit.scale),
            };
            let bounds =
                bounds.map_or(String::new(), |(least, most)| format!("; from {least:?} to {most:?}"));
            let _ = writeln!(text, "    {real} {}; /* {declared}{bounds} */", field(&name.identifier()));
        }
        let _ = writeln!(text, "}} {prefix}_{what}_t;\n");
    }

    /// What the equations can be asked for.
    fn heads(&self) -> String {
        let mut text = String::new();
        for signature in self.public() {
            let doc = signature.doc.replace('\n', "\n * ").replace('`', "");
            let _ = writeln!(text, "/* {doc} */\n{};\n", self.head(signature));
        }
        text
    }
}
