//! The source file: tables, functions of the equations, and the steps that call them.

use super::header::STATUSES;
use super::names::field;
use super::template::Template;
use super::{Writer, libm};
use crate::functions::{Function, JACOBIAN, Shape};
use crate::scalar::Scalar;
use crate::schedule::Operand;
use std::fmt::Write;

/// The part of the way back to the constraints that Baumgarte's terms take in a step is in the template; this is how far a row may be
/// off at the end of a step.
const OFF: f64 = 0.1;
/// How far the squared length of an orientation that is given may be from one.
const UNIT: f64 = 1e-3;
/// How far a stage is moved first where it is singular, as a part of the step.
const CLOSEST: f64 = 1e-4;
/// The part of the distance of neighbouring times that a step must be at least.
const LEAST_PART: f64 = 1.0 / 1_048_576.0;

impl Writer<'_> {
    pub fn source(&self) -> String {
        let mut template = self.template();
        let own = self.equations();
        let steps = self.steps(&mut template);
        let helpers = helpers(&template, &(own.clone() + &steps));
        let called = libm_calls(&own);
        let mut text = template.fill(include_str!("c/opening.c"));
        if !called.is_empty() {
            text.push_str(&libm::text(called));
            text.push('\n');
        }
        text.push_str(&helpers);
        text.push_str(&self.tables(&own));
        text.push_str(&own);
        text.push_str(&steps);
        tidy(&text)
    }

    /// The functions of the equations.
    fn equations(&self) -> String {
        let mut text = String::new();
        for signature in self.public() {
            let _ = writeln!(text, "{}", self.function(signature, false));
        }
        for signature in self.inner() {
            let _ = writeln!(text, "{}", self.function(signature, true));
        }
        text
    }

    /// What moves the mechanism by them.
    fn steps(&self, template: &mut Template) -> String {
        let layout = &self.compiled.complete.equations.layout;
        let rows = self.compiled.entries(Shape::Rows) > 0;
        let corrects = self.corrects();
        let mut text = String::new();
        let mut add = |template: &Template, part: &str| {
            text.push_str(&template.fill(part));
            text.push('\n');
        };
        add(template, include_str!("c/constants.c"));
        add(template, include_str!("c/finite.c"));
        add(template, include_str!("c/clock.c"));
        if !layout.rotations.is_empty() || !layout.quaternions.is_empty() {
            add(template, include_str!("c/turn.c"));
        }
        if !layout.rotations.is_empty() {
            add(template, include_str!("c/pairs.c"));
        }
        if !layout.quaternions.is_empty() {
            add(template, include_str!("c/quaternions.c"));
        }
        if !layout.angles.is_empty() {
            add(template, include_str!("c/wrap.c"));
        }
        add(template, include_str!("c/retract.c"));
        add(template, include_str!("c/prepare.c"));
        add(template, include_str!("c/course.c"));
        add(template, include_str!("c/rk4.c"));
        if corrects {
            add(template, include_str!("c/settle.c"));
        }
        add(template, include_str!("c/finish.c"));
        let leads = self.compiled.complete.further.leads;
        template.flag("leads", leads);
        let ways = [("stabilised", ""), ("corrected", "_corrected")];
        for (way, suffix) in ways.into_iter().take(if corrects { 2 } else { 1 }) {
            let stabilised = rows && suffix.is_empty();
            template.flag("corrected", !suffix.is_empty());
            let way = if rows { way } else { "unconstrained" };
            template.word("f", way.to_string());
            let lower = &self.prefix.lower;
            let [multipliers, leading] =
                Function::SOLUTIONS.map(|pair| format!("{lower}_{}", pair[usize::from(stabilised)].name()));
            let solve = if leads {
                format!("{lower}_solved_{way}(course")
            } else {
                format!("{multipliers}(course->model")
            };
            template.word("solve", solve);
            template.word("multipliers", multipliers);
            template.word("leading", leading);
            let inputs = if self.compiled.entries(Shape::Inputs) > 0 { ", course->u" } else { "" };
            let terms = if stabilised { ", course->two_alpha, course->beta_squared" } else { "" };
            let given = format!("{inputs}{terms}");
            template.word("stagearguments", if leads { String::new() } else { given.clone() });
            template.word("solvearguments", given);
            add(template, include_str!("c/stages.c"));
            for integrator in ["rk4", "semi_implicit_euler"] {
                template.word("integrator", integrator.to_string());
                template.word("method", format!("{integrator}{suffix}"));
                add(template, include_str!("c/step.c"));
            }
        }
        if !self.compiled.angles_in_outputs().is_empty() {
            add(template, include_str!("c/unwrap.c"));
        }
        add(template, include_str!("c/plant.c"));
        text
    }

    /// What the templates ask for.
    pub fn template(&self) -> Template {
        let mut template = Template::new(&self.prefix, self.scalar);
        self.sizes(&mut template);
        self.numbers_of(&mut template);
        self.arguments(&mut template);
        self.lists(&mut template);
        template
    }

    fn sizes(&self, template: &mut Template) {
        let compiled = self.compiled;
        let layout = &compiled.complete.equations.layout;
        let of = |shape| compiled.entries(shape);
        let open = compiled.complete.equations.open_rows(&compiled.mechanism).len();
        let (linear, rotations, quaternions) =
            (layout.linear.len(), layout.rotations.len(), layout.quaternions.len());
        let orientations = rotations + quaternions;
        let counts = [
            ("nq", of(Shape::Positions)),
            ("nv", of(Shape::Velocities)),
            ("nz", of(Shape::Internal)),
            ("nr", of(Shape::Rows)),
            ("nphases", of(Shape::Phases)),
            ("nopen", open),
            ("nconstants", of(Shape::Constants)),
            ("nstore", of(Shape::Store)),
            ("njacobian", of(Shape::Matrix(&JACOBIAN))),
            ("nlinear", linear),
            ("nrotations", rotations),
            ("npairs", 2 * rotations),
            ("nquaternions", quaternions),
            ("nquads", 4 * quaternions),
            ("nomegas", 3 * quaternions),
            ("atquads", linear + 2 * rotations),
            ("atomegas", linear + rotations),
            ("norientations", orientations),
            ("freedoms", compiled.assembly.mobility.generic),
            ("nwrong", compiled.mechanism.parameters.len() + compiled.masses.len()),
        ];
        counts.into_iter().for_each(|(name, count)| template.word(name, count.to_string()));
        let has = |shape| compiled.entries(shape) > 0;
        let flags = [
            ("single", self.scalar == Scalar::F32),
            ("rows", has(Shape::Rows)),
            ("corrects", self.corrects()),
            ("inputs", has(Shape::Inputs)),
            ("outputs", has(Shape::Outputs)),
            ("parameters", has(Shape::Parameters)),
            ("phases", has(Shape::Phases)),
            ("phased", open > 0 && has(Shape::Parameters)),
            ("constants", has(Shape::Constants)),
            ("some", has(Shape::Parameters) || has(Shape::Phases) || has(Shape::Constants)),
            ("internal", has(Shape::Internal)),
            ("linear", linear > 0),
            ("rotations", rotations > 0),
            ("quaternions", quaternions > 0),
            ("turns", orientations > 0),
            ("orientations", orientations > 0),
            ("angles", !layout.angles.is_empty()),
            ("counts", quaternions > 0 && !layout.angles.is_empty()),
        ];
        flags.into_iter().for_each(|(name, flag)| template.flag(name, flag));
    }

    fn numbers_of(&self, template: &mut Template) {
        let scalar = self.scalar;
        let single = scalar == Scalar::F32;
        let epsilon = if single { f64::from(f32::EPSILON) } else { f64::EPSILON };
        let tau = std::f64::consts::TAU;
        let numbers = [
            ("direct", if single { 0.0625 } else { 0.25 }),
            ("serves", if single { 1e-3 } else { 1e-4 }),
            ("breakdown", if single { 5e-6 } else { 1e-14 }),
            ("closest", CLOSEST),
            ("leaststep", epsilon * LEAST_PART),
            ("rounding", epsilon * 100.0),
            ("still", epsilon * 64.0),
            ("roundings", epsilon * 64.0),
            ("unit", UNIT),
            ("pi", std::f64::consts::PI),
            ("turn", 1.0 / tau),
            ("twopi", tau),
            ("third", 1.0 / 3.0),
            ("sixth", 1.0 / 6.0),
            ("twelfth", 1.0 / 12.0),
        ];
        numbers.into_iter().for_each(|(name, value)| template.word(name, scalar.literal(value)));
        template.word("version", env!("CARGO_PKG_VERSION").to_string());
        template.word("name", self.compiled.mechanism.name.text.clone());
        template.word("fingerprint", format!("{:#018x}U", self.compiled.fingerprint()));
    }

    /// What stands in heads and calls, where the mechanism has it.
    fn arguments(&self, template: &mut Template) {
        let (prefix, real) = (&self.prefix.lower, self.scalar.c());
        let has = |shape| self.compiled.entries(shape) > 0;
        let quaternions = !self.compiled.complete.equations.layout.quaternions.is_empty();
        let counts = quaternions && !self.compiled.complete.equations.layout.angles.is_empty();
        let mut given =
            |name, is: bool, text: String| template.word(name, if is { text } else { String::new() });
        given("inputsparameter", has(Shape::Inputs), format!(" const {prefix}_inputs_t *u,"));
        given("inputsargument", has(Shape::Inputs), " u,".to_string());
        given("inputsexample", has(Shape::Inputs), " &inputs,".to_string());
        given("uargument", has(Shape::Inputs), ", u".to_string());
        given("courseinputs", has(Shape::Inputs), ", course->u".to_string());
        given("plantnull", !has(Shape::Inputs), "plant == NULL".to_string());
        given("inputsnull", has(Shape::Inputs), "(plant == NULL) || (u == NULL)".to_string());
        given("initnull", has(Shape::Parameters), ", NULL".to_string());
        given(
            "parametersparameter",
            has(Shape::Parameters),
            format!(", const {prefix}_parameters_t *parameters"),
        );
        given(
            "lambdaparameter",
            has(Shape::Rows),
            format!(", {real} lambda[{}]", self.compiled.entries(Shape::Rows)),
        );
        given("lambdaargument", has(Shape::Rows), ", lambda".to_string());
        let prepared = [
            (Shape::Parameters, "&model->parameters"),
            (Shape::Phases, "model->phases"),
            (Shape::Constants, "model->constants"),
        ];
        let prepared: Vec<&str> =
            prepared.into_iter().filter(|(shape, _)| has(*shape)).map(|(_, text)| text).collect();
        given("preparearguments", true, prepared.join(", "));
        given("rate", true, if quaternions { "k" } else { "v" }.to_string());
        given("integral", true, if counts { "integral" } else { "u" }.to_string());
    }

    /// Lists, and lines that are as many as parts of the mechanism.
    fn lists(&self, template: &mut Template) {
        let compiled = self.compiled;
        let layout = &compiled.complete.equations.layout;
        let list =
            |items: &mut dyn Iterator<Item = String>| format!("{{{}}}", items.collect::<Vec<_>>().join(", "));
        let places = (0..layout.rotations.len()).map(|pair| (layout.linear.len() + 2 * pair, 2));
        let quads = layout.linear.len() + 2 * layout.rotations.len();
        let places = places.chain((0..layout.quaternions.len()).map(|quad| (quads + 4 * quad, 4)));
        template.word("orientations", list(&mut places.map(|(at, count)| format!("{{{at}, {count}}}"))));
        let open = compiled.complete.equations.open_rows(&compiled.mechanism);
        template.word("openrows", list(&mut open.iter().map(|row| row.to_string())));
        let (rows, columns): (Vec<usize>, Vec<usize>) = JACOBIAN.places(&compiled.complete).unzip();
        template.word("jacobianrows", list(&mut rows.iter().map(|row| row.to_string())));
        template.word("jacobiancolumns", list(&mut columns.iter().map(|column| column.to_string())));
        let bounds: Vec<f64> = compiled
            .complete
            .further
            .partition
            .row_sizes
            .iter()
            .map(|size| self.scalar.product(*size, OFF))
            .collect();
        template.word("rowbounds", self.numbers(&bounds));
        template.word("phases", self.numbers(&compiled.assembly.phases));
        let defaults: Vec<f64> = compiled.mechanism.parameters.iter().map(|known| known.default).collect();
        template.word("defaults", self.numbers(&defaults));
        template.word("startq", self.numbers(&compiled.assembly.q));
        template.word("startv", self.numbers(&compiled.assembly.v));
        template.word("startz", self.numbers(&compiled.mechanism.internal_starts()));
        let finite = compiled.mechanism.inputs.iter();
        let finite = finite.map(|input| format!("isfinite(u->{})", field(&input.name.identifier())));
        template.word("finiteinputs", finite.collect::<Vec<_>>().join(" && "));
        template.word("wraps", self.wraps());
        template.word("checks", self.checks());
        template.word("masses", self.masses());
        let quoted = |text: &str| format!("{text:?}");
        let together = "the parameters together".to_string();
        let names = compiled.mechanism.parameters.iter().map(|known| known.name.text.clone());
        let names = names.chain(compiled.masses.iter().map(|(what, _)| what.clone())).chain([together]);
        template.word("wrong", list(&mut names.map(|name| quoted(&name))));
        let texts = STATUSES.iter().map(|(_, text)| format!("        {},", quoted(text)));
        template.word("texts", texts.collect::<Vec<_>>().join("\n"));
        let angles = compiled.angles_in_outputs();
        let name = |output: usize| field(&compiled.mechanism.outputs[output].name.identifier());
        let unwrap = |output: usize, previous: String| {
            let (prefix, name) = (&self.prefix.lower, name(output));
            format!("        outputs->{name} = {prefix}_unwrap_angle(outputs->{name}, {previous});")
        };
        let next =
            angles.iter().map(|angle| unwrap(angle.output, format!("plant->last.{}", name(angle.output))));
        template.word("unwraps", next.collect::<Vec<_>>().join("\n"));
        let first =
            self.stated_angles().into_iter().map(|(output, at)| unwrap(output, format!("targets[{at}]")));
        template.word("unwrapsstart", first.collect::<Vec<_>>().join("\n"));
        template.flag("unwraps", !angles.is_empty());
        template.flag("stated", !self.stated_angles().is_empty());
        template.word("ntargets", compiled.entries(Shape::Conditions).to_string());
    }

    /// Angles of outputs that `start` states, and by which condition.
    pub fn stated_angles(&self) -> Vec<(usize, usize)> {
        let angles = self.compiled.angles_in_outputs().into_iter();
        angles.filter_map(|angle| Some((angle.output, angle.stated?))).collect()
    }

    /// Statements that move the counted angles.
    fn wraps(&self) -> String {
        let layout = &self.compiled.complete.equations.layout;
        let mut text = String::new();
        for (index, angle) in layout.angles.iter().enumerate() {
            let mut sum = self.scalar.literal(0.0);
            for (entry, weight) in &angle.rate {
                sum = format!("({sum} + ({} * integral[{entry}]))", self.scalar.operand(*weight));
            }
            let (at, prefix) = (layout.turns(index), &self.prefix.lower);
            let _ = writeln!(text, "    {prefix}_wrap(q[{at}], q[{}] + {sum}, &to[{at}]);", at + 1);
        }
        text.trim_end().to_string()
    }

    /// Statements that compare parameters with their bounds.
    fn checks(&self) -> String {
        let mut text = String::new();
        for (index, parameter) in self.compiled.mechanism.parameters.iter().enumerate() {
            let place = format!("parameters->{}", field(&parameter.name.identifier()));
            let bounds = parameter.bounds.map_or(String::new(), |(least, most)| {
                let least = self.scalar.operand(self.scalar.ceiling(least));
                let most = self.scalar.operand(-self.scalar.ceiling(-most));
                format!(" || ({place} < {least}) || ({place} > {most})")
            });
            let _ = writeln!(text, "    if (!isfinite({place}){bounds}) {{\n        return {index};\n    }}");
        }
        text.trim_end().to_string()
    }

    /// Statements that look at masses and inertias.
    fn masses(&self) -> String {
        let (compiled, zero) = (self.compiled, self.scalar.literal(0.0));
        let program = compiled.programs.get(Function::Masses);
        let mut text = String::new();
        for (index, ((_, positive), output)) in compiled.masses.iter().zip(&program.outputs).enumerate() {
            let Operand::Source(source) = output else { continue };
            let mut place = "model->".to_string();
            self.printer.entry(&mut place, Function::Masses.signature(), *source);
            let (relation, number) =
                (if *positive { ">" } else { ">=" }, compiled.mechanism.parameters.len() + index);
            let _ = writeln!(
                text,
                "    if (!(({place} {relation} {zero}) && isfinite({place}))) {{\n        return {number};\n    }}"
            );
        }
        text.trim_end().to_string()
    }
}

/// The small functions that a text calls, and those that they call.
fn helpers(template: &Template, text: &str) -> String {
    let all = include_str!("c/helpers.c");
    let functions: Vec<&str> = all.split("\n\n/* ").collect();
    let mut kept: Vec<&str> = Vec::new();
    // A function calls only what stands before it.
    for function in functions.iter().rev() {
        let name = name_of(function);
        let call = format!("{name}(");
        if text.contains(&call) || kept.iter().any(|other| other.contains(&call)) {
            kept.push(function);
        }
    }
    let mut found = String::new();
    for function in kept.iter().rev() {
        let begin = if function.starts_with("/* ") { "" } else { "/* " };
        let _ = writeln!(found, "{begin}{}\n", function.trim_end());
    }
    template.fill(&found)
}

/// The text without spaces at ends of lines and empty lines that separate nothing.
pub fn tidy(text: &str) -> String {
    let mut tidied: Vec<&str> = Vec::new();
    for line in text.lines().map(str::trim_end) {
        let opens = tidied.last().is_none_or(|last| last.is_empty() || last.ends_with('{'));
        if line.is_empty() && opens {
            continue;
        }
        if line.trim_start().starts_with('}') && tidied.last().is_some_and(|last| last.is_empty()) {
            tidied.pop();
        }
        tidied.push(line);
    }
    tidied.join("\n").trim_end().to_string() + "\n"
}

/// What a function of the helpers is called.
fn name_of(function: &str) -> &str {
    let head = function.lines().find(|line| line.starts_with("static")).unwrap_or_default();
    let head = head.split('(').next().unwrap_or_default();
    head.rsplit(' ').next().unwrap_or_default()
}

/// The functions of `libm` that programs call, in either scalar.
const CALLED: [&str; 24] = [
    "sin", "cos", "tan", "asin", "acos", "atan2", "exp", "log", "log10", "sinh", "cosh", "tanh", "sinf",
    "cosf", "tanf", "asinf", "acosf", "atan2f", "expf", "logf", "log10f", "sinhf", "coshf", "tanhf",
];

/// Those that a text calls.
fn libm_calls(text: &str) -> Vec<&'static str> {
    CALLED.into_iter().filter(|name| text.contains(&format!("lw_{name}("))).collect()
}
