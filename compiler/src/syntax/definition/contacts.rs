//! Surfaces, materials, contacts and limits as written.

use super::{Entry, Label, LineTerm, Named, Path, PlaceTerm, RangeTerm, Term};
use crate::diagnostics::Region;
use crate::forms::{ContactLawForm, LoadForm, SurfaceForm};

/// `surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));`
#[derive(Clone, Debug)]
pub struct Surface {
    /// One that stands in the braces of a body has the body's name in front.
    pub name: Label,
    pub form: &'static SurfaceForm,
    pub places: Vec<PlaceTerm>,
    pub line: Option<LineTerm>,
    pub named: Named,
}

/// `material steel { modulus [Pa] = 207e9; poisson = 0.3; }`
#[derive(Clone, Debug)]
pub struct Material {
    pub name: Label,
    pub entries: Vec<(Label, Entry)>,
}

/// `contact touch: between(ball.surface, floor) = law;`, `limit bump: strut.travel [mm] in -80..60 = law;`
#[derive(Clone, Debug)]
pub struct Contact {
    pub name: Label,
    /// What it is as a load.
    pub form: &'static LoadForm,
    pub on: ContactTerm,
    pub law: ContactLawTerm,
    /// Whether it is that of a joint with play, whose name it has.
    pub of_joint: bool,
}

/// What touches.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "there are few of them, and each lives in one vector")]
pub enum ContactTerm {
    Between(Path, Path),
    /// An expression of positions that is negative in contact, and one of how far surfaces slide.
    Gap(Term, Option<Entry>),
    /// A quantity that is held within a range.
    Limit(Path, RangeTerm),
}

/// What a contact exerts.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "there are few of them, and each lives in one vector")]
pub enum ContactLawTerm {
    Named(&'static ContactLawForm, Named, Region),
    Expression(Term),
}
