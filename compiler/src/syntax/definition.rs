//! What was written: names, expressions and units as the user put them, `repeat` unrolled, nothing looked up
//! and nothing converted. Every part keeps its place in the source.

mod contacts;
mod modal;
mod parts;
mod tables;
mod terms;

use crate::beams::{Counts, Shapes, Theory};
use crate::diagnostics::{Allowed, Region};
use crate::forms::BodyForm;
pub use crate::forms::Space;
use crate::forms::{CouplingForm, JointForm, LoadForm, Proportion, ToothingForm};
pub use contacts::{Contact, ContactLawTerm, ContactTerm, Material, Surface};
pub use modal::{ModalTerm, NodeTerm, ReadModes};
pub use parts::{Given, OnDisk, PartFile, PartUse, PortKind};
use proc_macro2::TokenStream;
use std::collections::BTreeSet;
pub use tables::{ColumnTerm, FileTerm, ReadFile, TableData, TableTerm};
pub use terms::{
    Entry, Ground, Label, Operator, Path, PlaceTerm, Term, TermKind, Tuple, WrittenUnit, identifier,
};

/// One `planar Name { … }` or `spatial Name { … }`.
#[derive(Clone, Debug)]
pub struct Definition {
    pub space: Space,
    pub name: Label,
    /// `pub`, `pub(crate)` or nothing.
    pub visibility: TokenStream,
    /// Doc comments and other attributes before it.
    pub attributes: TokenStream,
    /// What `#[allow(…)]` says, and where.
    pub allowed: Allowed,
    /// Constants that indices, bounds and counts name.
    pub counted: BTreeSet<String>,
    /// Parts that are declared beside it, here or in files.
    pub parts: Vec<Label>,
    /// Uses of parts, in the order in which regions count them.
    pub uses: Vec<PartUse>,
    /// Texts that parts were read from.
    pub files: Vec<PartFile>,
    pub constants: Vec<Constant>,
    pub parameters: Vec<Parameter>,
    pub inputs: Vec<Input>,
    pub signals: Vec<Signal>,
    pub states: Vec<InternalState>,
    pub rates: Vec<StateRate>,
    pub memories: Vec<Memory>,
    pub events: Vec<Event>,
    pub tables: Vec<TableTerm>,
    pub gravity: Option<Tuple>,
    pub bodies: Vec<Body>,
    /// Lines of the ground.
    pub lines: Vec<Line>,
    /// Markers of the ground.
    pub markers: Vec<Marker>,
    pub joints: Vec<Joint>,
    pub constraints: Vec<Constraint>,
    pub drivers: Vec<Driver>,
    pub loads: Vec<Load>,
    pub surfaces: Vec<Surface>,
    pub materials: Vec<Material>,
    /// In the order written; as loads they come behind the others.
    pub contacts: Vec<Contact>,
    pub start: Vec<StartEntry>,
    /// The internal states that begin where they rest.
    pub steady: Vec<Path>,
    /// Bodies that start bent as they are loaded.
    pub deflected: Vec<Path>,
    /// Orientations that `start` states.
    pub orientations: Vec<OrientationEntry>,
    pub options: Vec<OptionEntry>,
    pub expect: Vec<ExpectEntry>,
    pub outputs: Vec<Output>,
}

impl Definition {
    /// The first of what is held between events, or sets it, but for the speeds of touches, which go with held gates.
    pub fn memory_or_event(&self) -> Option<&Label> {
        let of_touch = |memory: &&Memory| memory.touch_of.is_some();
        let memories = self.memories.iter().filter(|memory| !of_touch(memory)).map(|memory| &memory.name);
        let sets_touch = |event: &&Event| {
            let mut touches = self.memories.iter().filter(of_touch);
            touches.any(|memory| event.sets.iter().any(|(set, _)| set.text == memory.name.text))
        };
        let events = self.events.iter().filter(|event| !sets_touch(event)).map(|event| &event.name);
        memories.chain(events).next()
    }
}

/// `const NAME [unit] = value;`
#[derive(Clone, Debug)]
pub struct Constant {
    pub name: Label,
    pub entry: Entry,
}

/// `param name [unit] = value in minimum..maximum;`
#[derive(Clone, Debug)]
pub struct Parameter {
    pub name: Label,
    pub docs: TokenStream,
    pub entry: Entry,
    pub bounds: Option<(Term, Term)>,
}

/// `input name [unit];`
#[derive(Clone, Debug)]
pub struct Input {
    pub name: Label,
    pub docs: TokenStream,
    pub unit: Option<WrittenUnit>,
}

/// `rod coupler { mass [kg] = 0.1; … }`
#[derive(Clone, Debug)]
pub struct Body {
    pub name: Label,
    pub form: &'static BodyForm,
    /// `mass`, `density`, `inertia` in the plane, `length`, `radius`, `width`, `height`, `thickness`: those written.
    pub properties: Vec<(Label, Entry)>,
    /// In space: `inertia`, `products`, `size`: those written.
    pub vectors: Vec<(Label, Tuple)>,
    /// The marker in whose axes the inertia is given.
    pub inertia_axes: Option<Label>,
    pub center: Option<(Label, Tuple)>,
    pub points: Vec<(Label, Tuple)>,
    pub markers: Vec<Marker>,
    pub lines: Vec<Line>,
    pub toothings: Vec<Toothing>,
    /// Of a beam: what is not a value.
    pub beam: BeamTerm,
    /// Of a body with the modes of a file.
    pub modal: Option<ModalTerm>,
}

/// `toothing rim: external(teeth = 20, module [mm] = 2, at = shaft.seat);`
#[derive(Clone, Debug)]
pub struct Toothing {
    pub name: Label,
    pub form: &'static ToothingForm,
    pub named: Named,
    /// Its centre, if that is not the centre of the part.
    pub at: Option<Path>,
    /// Of a rack: along which line of the part its teeth stand.
    pub line: Option<LineTerm>,
}

/// What a beam is made of and how it bends; what is not written is not there.
#[derive(Clone, Debug, Default)]
pub struct BeamTerm {
    /// `circle(diameter [mm] = 7)`.
    pub section: Option<SectionTerm>,
    /// `(axial = 2, bending = 5)`; where the numbers are written.
    pub modes: Option<ModesTerm>,
    pub shapes: Option<(Label, Shapes)>,
    /// Whether bending draws its places in.
    pub stiffening: Option<(Label, bool)>,
    pub theory: Option<(Label, Theory)>,
}

impl BeamTerm {
    /// Three in bending each way where nothing is written, because axial ones are far too fast for most integrators.
    pub fn counts(&self, space: Space) -> Counts {
        let bending_z = if space == Space::Spatial { 3 } else { 0 };
        let unwritten = Counts { axial: 0, bending: 3, bending_z, torsion: 0, quadratic: false };
        self.modes.as_ref().map_or(unwritten, |modes| modes.counts)
    }

    pub fn shapes(&self) -> Shapes {
        self.shapes.as_ref().map_or(Shapes::Free, |(_, shapes)| *shapes)
    }

    pub fn theory(&self) -> Theory {
        self.theory.as_ref().map_or(Theory::EulerBernoulli, |(_, theory)| *theory)
    }

    pub fn stiffens(&self) -> bool {
        self.stiffening.as_ref().is_some_and(|(_, stiffens)| *stiffens)
    }
}

#[derive(Clone, Debug)]
pub struct SectionTerm {
    pub kind: Label,
    pub lengths: Vec<(Label, Entry)>,
}

#[derive(Clone, Debug)]
pub struct ModesTerm {
    pub counts: Counts,
    pub region: Region,
}

impl Body {
    /// A property that was written.
    pub fn property(&self, name: &str) -> Option<&(Label, Entry)> {
        self.properties.iter().find(|(label, _)| label.text == name)
    }

    /// A property with several values that was written.
    pub fn vector(&self, name: &str) -> Option<&(Label, Tuple)> {
        self.vectors.iter().find(|(label, _)| label.text == name)
    }
}

/// `marker hip [m] = (0, 0.1, 0), axis = (0, 1, 0), reference = (1, 0, 0);`: a place with axes of its own.
#[derive(Clone, Debug)]
pub struct Marker {
    pub name: Label,
    pub at: Tuple,
    /// `axis`, `reference`, `about_x`, `about_y`, `about_z`, in the order written.
    pub axes: Vec<(Label, MarkerAxes)>,
}

/// How the axes of a marker are given.
#[derive(Clone, Debug)]
pub enum MarkerAxes {
    Direction(Tuple),
    Angle(Entry),
}

/// `line slot = (guide.pivot, guide.tip);`
#[derive(Clone, Debug)]
pub struct Line {
    pub name: Label,
    pub from: PlaceTerm,
    pub to: PlaceTerm,
}

/// The line of a `point_on_line`.
#[derive(Clone, Debug)]
pub enum LineTerm {
    /// `guide.slot`, or the name of a line of the ground.
    Named(Path),
    /// `line(from, to)`.
    Inline { from: PlaceTerm, to: PlaceTerm, region: Region },
}

impl LineTerm {
    /// Where it is written.
    pub fn region(&self) -> Region {
        match self {
            Self::Named(path) => path.region,
            Self::Inline { region, .. } => *region,
        }
    }
}

/// `joint knee: revolute(guide.tip, coupler.end);`
#[derive(Clone, Debug)]
pub struct Joint {
    pub name: Label,
    pub form: &'static JointForm,
    pub first: FirstTerm,
    pub second: PlaceTerm,
    pub named: Named,
    /// What acts in place of its rows, `= penalty(…)`.
    pub penalty: Option<Load>,
    /// Whether it has play: a contact of its name acts in place of its rows.
    pub loose: bool,
}

/// The arguments of an element that were written with their names, in that order.
#[derive(Clone, Debug, Default)]
pub struct Named {
    pub entries: Vec<(Label, Entry)>,
    pub tuples: Vec<(Label, Tuple)>,
    /// What is made by a call with arguments of its own, `stiffness = involute(…)`.
    pub calls: Vec<(Label, Box<Named>)>,
}

impl Named {
    pub fn entry(&self, name: &str) -> Option<&Entry> {
        self.entries.iter().find(|(label, _)| label.text == name).map(|(_, entry)| entry)
    }

    pub fn tuple(&self, name: &str) -> Option<&Tuple> {
        self.tuples.iter().find(|(label, _)| label.text == name).map(|(_, tuple)| tuple)
    }

    pub fn call(&self, name: &str) -> Option<&Named> {
        self.calls.iter().find(|(label, _)| label.text == name).map(|(_, call)| &**call)
    }

    /// Their names.
    pub fn labels(&self) -> impl Iterator<Item = &Label> {
        let entries = self.entries.iter().map(|(label, _)| label);
        let calls = self.calls.iter().map(|(label, _)| label);
        entries.chain(self.tuples.iter().map(|(label, _)| label)).chain(calls)
    }
}

/// What a joint's first argument is.
#[derive(Clone, Debug)]
pub enum FirstTerm {
    Place(PlaceTerm),
    Line(LineTerm),
}

/// `constraint name: …;`
#[derive(Clone, Debug)]
pub struct Constraint {
    pub name: Label,
    pub kind: ConstraintTerm,
}

/// The kinds of constraints that are no joints.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "there are few of them, and each lives in one vector")]
pub enum ConstraintTerm {
    Coupling {
        form: &'static CouplingForm,
        kind: &'static Proportion,
        on: Vec<SubjectTerm>,
        factor: Entry,
        phase: Option<Entry>,
    },
    Equation {
        left: Term,
        right: Term,
    },
    /// Two toothings, by their paths.
    Teeth {
        form: &'static CouplingForm,
        on: Vec<SubjectTerm>,
    },
}

/// `drive name: crank_pin.angle = law;`
#[derive(Clone, Debug)]
pub struct Driver {
    pub name: Label,
    pub quantity: Path,
    pub law: Term,
}

/// `force name: torque(crank_pin) = law;`
#[derive(Clone, Debug)]
pub struct Load {
    pub name: Label,
    pub form: &'static LoadForm,
    /// What it acts on, as many as its form says.
    pub on: Vec<SubjectTerm>,
    pub named: Named,
    pub law: LawTerm,
}

/// What a load acts on or a coupling couples, as written.
#[derive(Clone, Debug)]
pub enum SubjectTerm {
    Place(PlaceTerm),
    /// The name of a joint or body.
    Name(Label),
    Expression(Term),
}

impl SubjectTerm {
    /// Where it is written.
    pub fn region(&self) -> Region {
        match self {
            Self::Place(place) => place.region(),
            Self::Name(label) => label.region,
            Self::Expression(term) => term.region,
        }
    }
}

/// What stands behind a load.
#[derive(Clone, Debug)]
pub enum LawTerm {
    None,
    Value(Term),
    Components(Tuple),
}

/// `crank_pin.angle [rad] = 0.3;` or `~` for a guess.
#[derive(Clone, Debug)]
pub struct StartEntry {
    pub quantity: Path,
    pub exact: bool,
    pub entry: Entry,
}

/// `top.orientation = (1, 0, 0, 0);` or `~` for a guess: a unit quaternion, scalar first.
#[derive(Clone, Debug)]
pub struct OrientationEntry {
    pub quantity: Path,
    pub exact: bool,
    pub value: Tuple,
}

/// One line of `options { … }`.
#[derive(Clone, Debug)]
pub enum OptionEntry {
    /// `absolute`, `tree` or `auto`.
    Coordinates(Label),
    /// `multipliers`, `independent` or `auto`.
    Solution(Label),
    /// `refuse`, `drop` or `keep`.
    Redundant(Label),
    /// `check` or `accept`.
    Inertia(Label),
    Cut(Vec<Label>),
    Independent(Vec<Path>),
    /// Words of [`EMITTED`].
    Emit(Vec<Label>),
    /// `on` or `off`.
    SelfCheck(Label),
    FrictionPasses(usize, Region),
    /// `live` or `held`.
    Contact(Label),
    /// `newton` or `poisson`.
    Impact(Label),
    ExportC(Label),
    Crate(TokenStream),
}

/// What can be emitted beyond the default.
pub const EMITTED: [&str; 4] = ["penalty", "projection", "null_space", "tangent"];

/// One line of `expect { … }`.
#[derive(Clone, Debug)]
pub enum ExpectEntry {
    DegreesOfFreedom(usize, Region),
    Budget(Budget),
    /// Joints and bodies that turn fully.
    Rotates(Vec<Label>),
    /// No singular position all along the motion.
    NoSingularity(Region),
    /// A coordinate that stays in a range.
    Within(Path, RangeTerm),
    /// A blow of a contact that takes at least so long.
    ContactTime(Path, Term),
    /// `friction_time(rub) >= 1e-4 [s]`
    FrictionTime(Path, Term),
    /// A mode of a beam whose frequency by itself is on one side of a bound.
    Frequency(Path, Side, Term),
    /// A place of a beam that is on one side of a bound off the axis of its frame.
    Deflection(Path, Side, Term),
    /// A force or torque that is on one side of a bound all along the motion.
    Effort(Path, Option<WrittenUnit>, Side, Term),
}

/// Of a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Above,
    Below,
}

/// `10..170 [deg]`
#[derive(Clone, Debug)]
pub struct RangeTerm {
    /// Of both ends: beside the name, or behind the upper end.
    pub unit: Option<WrittenUnit>,
    pub from: Term,
    pub to: Term,
}

/// `operations <= 400;`, `live_values(mass_matrix) <= 40;`
#[derive(Clone, Debug)]
pub struct Budget {
    pub of: Budgeted,
    /// `None` for the default acceleration function.
    pub function: Option<Label>,
    pub limit: usize,
    pub region: Region,
}

/// What of a function a budget limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Budgeted {
    Operations,
    /// The largest number of results that are alive at once.
    LiveValues,
}

impl Budgeted {
    pub const ALL: [Budgeted; 2] = [Budgeted::Operations, Budgeted::LiveValues];

    pub fn word(self) -> &'static str {
        match self {
            Budgeted::Operations => "operations",
            Budgeted::LiveValues => "live_values",
        }
    }
}

/// `output stroke [m] = slider.center.x;`
#[derive(Clone, Debug)]
pub struct Output {
    pub name: Label,
    pub docs: TokenStream,
    pub entry: Entry,
}

/// `signal name [unit] = value;`
#[derive(Clone, Debug)]
pub struct Signal {
    pub name: Label,
    pub entry: Entry,
}

/// `state name [unit] = start, scale = value;`
#[derive(Clone, Debug)]
pub struct InternalState {
    pub name: Label,
    pub docs: TokenStream,
    pub entry: Entry,
    pub scale: Option<Term>,
}

/// `rate name = value;`
#[derive(Clone, Debug)]
pub struct StateRate {
    pub name: Label,
    pub value: Term,
}

/// `memory name [unit] = value;`
#[derive(Clone, Debug)]
pub struct Memory {
    pub name: Label,
    pub docs: TokenStream,
    pub entry: Entry,
    /// The contact whose speed at each touch it is, so that it measures what goes with the gap.
    pub touch_of: Option<Label>,
}

/// `event name: occasion { memory = value; … jump(speed) = value; }`
#[derive(Clone, Debug)]
pub struct Event {
    pub name: Label,
    pub occasion: Occasion,
    /// At least one, or a jump.
    pub sets: Vec<(Label, Term)>,
    pub jump: Option<Jump>,
}

/// `jump(speed) = value;`
#[derive(Clone, Debug)]
pub struct Jump {
    pub speed: Path,
    pub to: Term,
}

/// When an event occurs.
#[derive(Clone, Debug)]
pub enum Occasion {
    /// A value passes a level.
    Passing { value: Term, way: Way, level: Term },
    /// At the multiples of a period.
    Every(Term),
}

/// Which way a value passes a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    Rises,
    Falls,
    Crosses,
}

impl Way {
    pub fn named(word: &str) -> Option<Self> {
        [Self::Rises, Self::Falls, Self::Crosses].into_iter().find(|way| way.word() == word)
    }

    pub fn word(self) -> &'static str {
        match self {
            Self::Rises => "rises",
            Self::Falls => "falls",
            Self::Crosses => "crosses",
        }
    }
}
