//! What a definition is built of: expressions, places and calls, in the words of the language.

use std::fmt::Write;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// An expression: a number, a number with its unit, a name, or what operators and functions make of these.
#[derive(Clone, Debug)]
pub struct Value(pub(super) Result<String, String>);

impl Value {
    /// A number with its unit, such as `(90.0, "deg")`.
    pub fn quantity(value: f64, unit: &str) -> Self {
        let unit = bracketed(unit);
        Value(number(value).and_then(|digits| Ok(format!("{digits} {}", unit?))))
    }

    /// A parameter, an input, or a quantity of the mechanism such as `crank_pin.angle`.
    pub fn name(path: &str) -> Self {
        Value(checked_path(path))
    }

    /// A function of the language, such as `sin`, `atan2`, `if`, or a table.
    pub fn call(function: &str, arguments: &[Value]) -> Self {
        let arguments: Result<Vec<String>, String> = arguments.iter().map(|it| it.0.clone()).collect();
        let name = checked_path(function);
        Value(arguments.and_then(|arguments| Ok(format!("{}({})", name?, arguments.join(", ")))))
    }

    fn joined(self, operator: &str, other: Value) -> Value {
        Value(self.0.and_then(|one| Ok(format!("({one} {operator} {})", other.0?))))
    }
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Value(number(value))
    }
}

impl From<&str> for Value {
    fn from(path: &str) -> Self {
        Value::name(path)
    }
}

macro_rules! operator {
    ($($trait:ident $method:ident $text:literal),*) => {$(
        impl<T: Into<Value>> $trait<T> for Value {
            type Output = Value;
            fn $method(self, other: T) -> Value {
                self.joined($text, other.into())
            }
        }
    )*};
}

operator!(Add add "+", Sub sub "-", Mul mul "*", Div div "/");

impl Neg for Value {
    type Output = Value;
    fn neg(self) -> Value {
        Value(self.0.map(|own| format!("(-{own})")))
    }
}

/// A place: of a body by its name, or of the ground.
#[derive(Clone, Debug)]
pub struct Place(pub(super) Result<String, String>);

/// A place of the ground, m.
pub fn ground(at: &[f64]) -> Place {
    Place(tuple(at).map(|at| format!("ground{at} [m]")))
}

impl From<&str> for Place {
    /// `crank.end`, also the name of a joint, a body or a line where one of these is meant.
    fn from(path: &str) -> Self {
        Place(checked_path(path))
    }
}

/// `word(places, name = value, …)`: a kind of joint, load or coupling with its arguments.
#[derive(Clone, Debug)]
pub struct Call {
    word: Result<String, String>,
    arguments: Vec<Result<String, String>>,
}

impl Call {
    pub fn new(word: &str) -> Self {
        Call { word: checked_name(word), arguments: Vec::new() }
    }

    /// What it acts on or holds, in the order of the language: places, or names of joints and bodies.
    pub fn on(mut self, place: impl Into<Place>) -> Self {
        self.arguments.push(place.into().0);
        self
    }

    /// The expression that it acts along.
    pub fn along(mut self, value: impl Into<Value>) -> Self {
        self.arguments.push(value.into().0);
        self
    }

    /// A named argument.
    pub fn with(mut self, name: &str, value: impl Into<Value>) -> Self {
        let (name, value) = (checked_name(name), value.into().0);
        self.arguments.push(value.and_then(|value| Ok(format!("{} = {value}", name?))));
        self
    }

    /// A named argument that is a direction.
    pub fn direction(mut self, name: &str, components: &[f64]) -> Self {
        let (name, components) = (checked_name(name), tuple(components));
        self.arguments.push(components.and_then(|components| Ok(format!("{} = {components}", name?))));
        self
    }

    pub(super) fn text(self) -> Result<String, String> {
        let arguments: Result<Vec<String>, String> = self.arguments.into_iter().collect();
        Ok(format!("{}({})", self.word?, arguments?.join(", ")))
    }
}

/// As digits that give back every bit.
pub(super) fn number(value: f64) -> Result<String, String> {
    if value.is_finite() { Ok(format!("{value:?}")) } else { Err(super::messages::not_finite(value)) }
}

/// `(x, y)`.
pub(super) fn tuple(values: &[f64]) -> Result<String, String> {
    let mut text = "(".to_string();
    for (index, value) in values.iter().enumerate() {
        let _ = write!(text, "{}{}", if index > 0 { ", " } else { "" }, number(*value)?);
    }
    text.push(')');
    Ok(text)
}

/// `[kg*m^2]`; nothing for no unit.
pub(super) fn bracketed(unit: &str) -> Result<String, String> {
    let fits = |c: char| c.is_alphanumeric() || "*/^()-. ".contains(c);
    match unit {
        "" => Ok(String::new()),
        unit if unit.chars().all(fits) => Ok(format!("[{unit}]")),
        _ => Err(super::messages::no_unit(unit)),
    }
}

/// A name that may be declared: letters, digits and `_`, with indices behind.
pub(super) fn checked_name(name: &str) -> Result<String, String> {
    let (stem, indices) = name.split_at(name.find('[').unwrap_or(name.len()));
    let mut characters = stem.chars();
    let is_first = |c: char| c == '_' || unicode_ident::is_xid_start(c);
    let is_stem = characters.next().is_some_and(is_first) && characters.all(unicode_ident::is_xid_continue);
    let are_indices = indices.is_empty()
        || indices.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).is_some_and(|inside| {
            inside.split("][").all(|index| !index.is_empty() && index.chars().all(|c| c.is_ascii_digit()))
        });
    if is_stem && are_indices { Ok(name.to_string()) } else { Err(super::messages::no_name(name)) }
}

/// Names joined by dots.
pub(super) fn checked_path(path: &str) -> Result<String, String> {
    path.split('.').map(checked_name).collect::<Result<Vec<_>, _>>().map(|parts| parts.join("."))
}
