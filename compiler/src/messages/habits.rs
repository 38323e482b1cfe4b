//! Texts for habits of Rust, of other programs and of plain writing: what the reader meant, in the words of the language.

use super::closest;

/// A way of writing that is nearly right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Habit {
    /// `"arm"` for `arm`.
    QuotedName(String),
    /// `"1 kg"` for `1 [kg]`.
    QuotedValue,
    /// `1,5` for `1.5`.
    DecimalComma(String, String),
    /// `mass [kg] = 1, length …`
    CommaForSemicolon,
    /// `1 kg` for `1 [kg]`.
    BareUnit(String),
    /// The line before this word has no `;`.
    LineWithoutEnd,
    /// `c ? a : b`.
    Ternary,
    /// `if c { a } else { b }`.
    RustIf,
    /// `angle.sin()` for `sin(angle)`.
    Method(String),
    /// `std::f64::consts::PI`.
    RustPath,
    /// `mass: 1` for `mass = 1`.
    ColonForEquals,
    /// `mass (kg)` for `mass [kg]`.
    UnitInParentheses,
    /// `[kg] mass` for `mass [kg]`.
    UnitBeforeName,
    /// `rod a(…)` for `rod a { … }`.
    PropertiesInParentheses,
    /// `==` for `=`.
    EqualsTwice,
    /// `# …` for `// …`.
    HashComment,
    /// `9.81` for `(0, -9.81)`.
    VectorWithoutParentheses,
    /// `[1, 0]` for `(1, 0)`.
    VectorInBrackets,
    /// `};` behind a block.
    SemicolonBehindBlock,
    /// `point p = a.start`.
    NameForVector,
    /// `axis = z`, among these letters.
    AxisByLetter(String, &'static [&'static str]),
}

impl Habit {
    /// What to write instead.
    pub(crate) fn advice(&self) -> String {
        match self {
            Self::QuotedName(name) => format!("names are written without quotes: `{name}`"),
            Self::QuotedValue => {
                "values are written without quotes, their unit in brackets: `1 [kg]`".to_string()
            }
            Self::DecimalComma(whole, rest) => format!("decimals are written with a point: `{whole}.{rest}`"),
            Self::CommaForSemicolon => {
                "every line ends with `;`, and commas stand only within parentheses".to_string()
            }
            Self::BareUnit(unit) => format!("units stand in brackets: `[{unit}]`"),
            Self::LineWithoutEnd => "what stands before it has no `;` at its end".to_string(),
            Self::Ternary | Self::RustIf => "a choice is written `if(condition, value, other)`".to_string(),
            Self::Method(function) => format!("functions stand before their argument: `{function}(…)`"),
            Self::RustPath => "there are no paths of Rust here; π is `pi`".to_string(),
            Self::ColonForEquals => {
                "values stand behind `=`, units in brackets behind the name: `name [unit] = value`"
                    .to_string()
            }
            Self::UnitInParentheses => "units stand in brackets: `mass [kg] = 1`".to_string(),
            Self::UnitBeforeName => "the unit stands behind the name: `mass [kg] = 1;`".to_string(),
            Self::PropertiesInParentheses => {
                "properties stand in braces: `rod arm { mass [kg] = 1; length [m] = 1; }`".to_string()
            }
            Self::EqualsTwice => "one `=` is enough here, `==` only compares".to_string(),
            Self::HashComment => "comments begin with `//`".to_string(),
            Self::VectorWithoutParentheses => "a vector has all its components in parentheses".to_string(),
            Self::VectorInBrackets => {
                "vectors stand in parentheses, brackets are for units and indices".to_string()
            }
            Self::SemicolonBehindBlock => "a block ends with `}`, without `;`".to_string(),
            Self::NameForVector => "its components are written out, in parentheses".to_string(),
            Self::AxisByLetter(letter, letters) => {
                let components = letters.iter().map(|axis| if axis == letter { "1" } else { "0" });
                let vector = components.collect::<Vec<_>>().join(", ");
                format!("a direction is a vector: `({vector})` is along {letter}")
            }
        }
    }
}

/// Advice for a word that begins no statement.
pub(crate) fn foreign_statement(word: &str) -> Option<&'static str> {
    Some(match word {
        "let" | "static" | "var" | "constant" | "define" => {
            "write `const NAME [unit] = value;`, or `param name …` for a value that may change at run time"
        }
        "parameter" | "params" | "variable" => "write `param name [unit] = value;`",
        "for" | "while" | "loop" | "foreach" => "write `repeat i in 0..3 { … }`",
        "if" | "else" | "match" => "within expressions a choice is `if(condition, value, other)`",
        "fn" | "struct" | "enum" | "use" | "impl" | "mod" | "pub" | "type" => {
            "a mechanism has no items of Rust; write those beside `mechanism!`"
        }
        "assert" | "check" => "write `expect { … }`",
        "initial" | "init" | "initially" => "write `start { … }`",
        "link" | "part" | "solid" | "frame" | "mass" => {
            "write `body`, or a shape such as `rod`, `disk` or `box`"
        }
        "bar" => "write `rod`",
        "wheel" | "circle" => "write `disk`",
        "ball" => "write `sphere`, or `joint name: spherical(…)`",
        "cube" | "cuboid" | "block" => "write `box`",
        "point_mass" => "write `particle`",
        "motor" | "actuator" | "driver" => {
            "write `drive name: joint.angle = law;` for a given motion, `torque name: torque(joint) = law;` for a given torque"
        }
        "hinge" | "pin" | "slider" => "write `joint name: kind(place, place);`",
        "print" | "measure" | "sensor" => "write `output name [unit] = value;`",
        "import" | "include" => "a mechanism stands in one macro as a whole",
        "limit" | "limits" => {
            "write `limit name: joint.angle [deg] in -90..20 = law;`, with the law of a contact"
        }
        _ => return None,
    })
}

/// What other programs call an argument.
pub(crate) fn other_argument<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let ours = match name {
        "k" | "c" | "rate" | "spring_constant" => "stiffness",
        "d" | "b" | "damp" | "viscosity" => "damping",
        "l" | "l0" | "rest" | "rest_length" | "free_length" | "natural_length" => "length",
        "theta0" | "rest_angle" => "angle",
        "dir" | "along" | "normal" => "direction",
        "i" | "n" => "ratio",
        "r" => "radius",
        "lead" => "pitch",
        _ => return None,
    };
    let same = |known: &&&str| **known == ours || (ours == "direction" && **known == "axis");
    known.iter().find(same).copied()
}

/// What other languages call a function, and how it is written here.
pub(crate) fn other_function(name: &str) -> Option<&'static str> {
    Some(match name {
        "pow" | "powi" | "powf" => "a power is written `a^b`",
        "log" => "the natural logarithm is `ln`",
        "log2" => "write `ln(x)/ln(2)`",
        "arctan" => "write `atan`, or `atan2(y, x)`, which knows the quadrant",
        "arcsin" => "write `asin`",
        "arccos" => "write `acos`",
        "fabs" => "write `abs`",
        "length" | "magnitude" => "write `norm(a.end - b.start)`, or `hypot(x, y)`",
        "deg" | "degrees" | "radians" | "to_radians" => "write the unit: `30 [deg]`",
        "heaviside" => "write `step(x)`, 1 where x is positive",
        "mod" | "rem" | "fmod" | "modulo" => "write `wrap(x, period)`",
        "saturate" | "limit" | "constrain" | "clip" => "write `clamp(x, least, most)`",
        "dead_zone" | "deadzone" => "write `deadband(x, half)`",
        "floor" | "ceil" | "round" => "there is none whose value jumps by itself; write `if(…)`",
        _ => return None,
    })
}

/// What other programs call a value.
pub(crate) fn other_value(name: &str) -> Option<&'static str> {
    Some(match name {
        "t" | "TIME" | "now" => "the time is `time`",
        "PI" | "Pi" | "tau" | "TAU" => "π is `pi`",
        "g" => "declare it: `const g [m/s^2] = 9.81;`",
        "e" => "write `exp(1)`",
        _ => return None,
    })
}

/// What else an option or expectation could be called.
pub(crate) fn other_option(word: &str) -> Option<&'static str> {
    Some(match word {
        "dof" | "dofs" | "freedom" | "freedoms" | "mobility" => "degrees_of_freedom",
        "flops" | "ops" | "cost" => "operations",
        "redundancy" | "redundant_constraints" => "redundant",
        "derivatives" | "jacobians" | "generate" => "emit",
        _ => return None,
    })
}

/// What other programs call the ground.
pub(crate) fn is_ground(name: &str) -> bool {
    ["world", "base", "fixed", "inertial", "root", "global", "earth", "ground_link"].contains(&name)
}

/// What begins a mechanism, for a word that does not.
pub(crate) fn kind_of_mechanism(word: &str, statements: &[&str]) -> Option<String> {
    if let Some(kind) = closest(word, ["planar", "spatial"].into_iter()) {
        return Some(format!("did you mean `{kind}`?"));
    }
    if statements.contains(&word) {
        return Some(format!("statements stand in the braces of a mechanism: `planar Name {{ {word} … }}`"));
    }
    matches!(word, "struct" | "mechanism" | "mod" | "fn" | "model" | "space" | "plane")
        .then(|| "write `planar Name { … }` or `spatial Name { … }`".to_string())
}
