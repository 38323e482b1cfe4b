//! What statements are made of: names, expressions, units, vectors and places as written.

use crate::diagnostics::Region;
use crate::units::Unit;

/// A name, indices included (`upright[3]`).
#[derive(Clone, Debug)]
pub struct Label {
    pub text: String,
    pub region: Region,
}

impl Label {
    /// As a Rust identifier.
    pub fn identifier(&self) -> String {
        identifier(&self.text)
    }
}

/// `upright[3]` as a Rust identifier is `upright_3`, `left.foot` is `left_foot`.
pub fn identifier(name: &str) -> String {
    name.replace(['[', '.'], "_").replace(']', "")
}

/// Names joined by dots.
#[derive(Clone, Debug)]
pub struct Path {
    /// `upright[3].end.x`.
    pub text: String,
    pub parts: Vec<Label>,
    pub region: Region,
}

impl Path {
    /// At least one name.
    pub fn joined(parts: Vec<Label>) -> Path {
        let texts: Vec<&str> = parts.iter().map(|part| part.text.as_str()).collect();
        let region = parts[0].region.to(parts[parts.len() - 1].region);
        Path { text: texts.join("."), parts, region }
    }
}

/// A unit in brackets and where it stands.
#[derive(Clone, Debug)]
pub struct WrittenUnit {
    pub unit: Unit,
    pub region: Region,
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Term {
    pub kind: TermKind,
    pub region: Region,
    /// Height of the tree above its leaves, bounded by the parser.
    pub height: usize,
}

/// The kinds of expressions.
#[derive(Clone, Debug)]
pub enum TermKind {
    /// Digits as written.
    Number {
        text: String,
        unit: Option<WrittenUnit>,
    },
    Name(Path),
    Operation(Operator, Vec<Term>),
    Call(Label, Vec<Term>),
    /// A place of the ground, an argument of `distance`.
    Ground(Box<Ground>),
    /// A parenthesised expression followed by a unit.
    Measured(Box<Term>, WrittenUnit),
}

impl Term {
    /// A name joined by dots, as if written at `region`.
    pub fn name(region: Region, text: &str) -> Term {
        let parts = text.split('.').map(|part| Label { text: part.to_string(), region }).collect();
        let path = Path { text: text.to_string(), parts, region };
        Term { kind: TermKind::Name(path), region, height: 0 }
    }

    fn joined(self, operator: Operator, other: Term) -> Term {
        let (region, height) = (self.region, 1 + self.height.max(other.height));
        Term { kind: TermKind::Operation(operator, vec![self, other]), region, height }
    }

    pub fn negated(self) -> Term {
        let (region, height) = (self.region, 1 + self.height);
        Term { kind: TermKind::Operation(Operator::Negate, vec![self]), region, height }
    }

    pub fn plus(self, other: Term) -> Term {
        self.joined(Operator::Add, other)
    }

    pub fn times(self, other: Term) -> Term {
        self.joined(Operator::Multiply, other)
    }

    pub fn over(self, other: Term) -> Term {
        self.joined(Operator::Divide, other)
    }
}

impl Entry {
    /// A value without a unit beside its name.
    pub fn bare(value: Term) -> Entry {
        Entry { unit: None, value }
    }

    /// The value with its unit, to stand in an expression.
    pub fn term(self) -> Term {
        match self.unit {
            None => self.value,
            Some(unit) => {
                let (region, height) = (self.value.region, self.value.height + 1);
                Term { kind: TermKind::Measured(Box::new(self.value), unit), region, height }
            }
        }
    }
}

/// Operators, all with one spelling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Negate,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    Not,
}

impl Operator {
    /// As in the exported definition.
    pub fn text(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Power => "^",
            Self::Negate => "neg",
            Self::Less => "<",
            Self::LessEqual => "<=",
            Self::Greater => ">",
            Self::GreaterEqual => ">=",
            Self::Equal => "==",
            Self::NotEqual => "!=",
            Self::And => "and",
            Self::Or => "or",
            Self::Not => "not",
        }
    }
}

/// A value beside the unit of its name, if one stands there.
#[derive(Clone, Debug)]
pub struct Entry {
    pub unit: Option<WrittenUnit>,
    pub value: Term,
}

/// Values in parentheses beside the unit of all: a vector of the plane or of space, or a quaternion.
#[derive(Clone, Debug)]
pub struct Tuple {
    pub unit: Option<WrittenUnit>,
    pub values: Vec<Term>,
    pub region: Region,
}

/// `ground(x, y) [unit]`.
#[derive(Clone, Debug)]
pub struct Ground {
    /// `ground(0, 0.2)`, without its unit.
    pub text: String,
    pub at: Vec<Term>,
    pub unit: Option<WrittenUnit>,
    pub region: Region,
}

/// A place as written.
#[derive(Clone, Debug)]
pub enum PlaceTerm {
    Named(Path),
    Ground(Box<Ground>),
}

impl PlaceTerm {
    /// Where it is written.
    pub fn region(&self) -> Region {
        match self {
            Self::Named(path) => path.region,
            Self::Ground(ground) => ground.region,
        }
    }
}
