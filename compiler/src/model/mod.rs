//! What a definition means: names resolved, units converted to SI, ids for names.
//!
//! AFTER THIS POINT nothing is looked up by name: bodies, joints, parameters and inputs are indices, every number
//! is in SI units, every expression has been checked for dimension, every `repeat` has been unrolled.
//! Whether the mechanism makes physical sense is left to `check`.

mod beams;
mod bodies;
mod composites;
mod constants;
mod contacts;
mod deforms;
mod elements;
mod expression;
pub(crate) mod fold;
mod friction;
mod functions;
pub mod gears;
mod hysteresis;
mod joints;
mod kinks;
mod loads;
mod lower;
mod memories;
mod names;
mod parts;
mod penalty;
mod places;
mod quantities;
mod reactions;
mod settings;
mod shapes;
mod signals;
mod states;
pub mod tables;
mod unused;
mod values;
mod vectors;
mod written;

use crate::diagnostics::{Allowed, Region};
pub use crate::forms::{Alone, JointAxes, JointForm, LoadForm, Space};
use crate::forms::{Bearing, BodyForm};
use crate::scalar::Scalar;
pub use crate::syntax::Side;
pub use crate::syntax::Way;
pub use crate::syntax::{Budgeted, OnDisk, identifier};
pub use beams::Beam;
pub use contacts::{Shape, Surface};
pub use deforms::{Deforms, Modal};
pub use elements::{
    Constraint, ConstraintKind, Coupled, Coupling, Joint, Load, Rotor, Sliding, Spot, Subject,
};
pub use expression::{
    Comparison, Condition, Coordinate, Expr, Function1, Function2, OfTeeth, Quantity, ReactionPart,
};
pub use lower::lower;
pub use memories::{Event, Memory, Occasion};
pub use tables::{Curve, LookUp, Table};
pub use unused::{Declared, Unused};
pub use written::WrittenLengths;

/// Index of a body in [`Mechanism::bodies`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(pub usize);
/// Index of a joint in [`Mechanism::joints`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JointId(pub usize);
/// Index of a run-time parameter in [`Mechanism::parameters`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ParameterId(pub usize);
/// Index of an input in [`Mechanism::inputs`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct InputId(pub usize);
/// Index of a state in [`Mechanism::states`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StateId(pub usize);
/// Index of a memory in [`Mechanism::memories`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MemoryId(pub usize);
/// Index of a load in [`Mechanism::loads`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LoadId(pub usize);
/// Index of a coupling or an equation in [`Mechanism::constraints`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ConstraintId(pub usize);
/// Index of a driver in [`Mechanism::drivers`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DriverId(pub usize);

/// A name as written (indices included: `upright[3]`) with the place it was written at.
#[derive(Clone, Debug)]
pub struct Name {
    /// As the user wrote it, `upright[3]`.
    pub text: String,
    /// Where.
    pub span: Region,
}

impl Name {
    /// The name as a Rust identifier: `upright[3]` becomes `upright_3`, `left.foot` `left_foot`.
    pub fn identifier(&self) -> String {
        identifier(&self.text)
    }
}

/// The value of an expression of parameters, given theirs; `None` if it depends on anything else.
pub fn value_at(expr: &Expr, parameters: &[f64]) -> Option<f64> {
    fold::evaluate(expr, parameters)
}

/// The same of an expression of parameters and time.
pub fn value_in_time(expr: &Expr, parameters: &[f64], time: f64) -> Option<f64> {
    fold::evaluate_at(expr, parameters, Some(time))
}

/// Components along x, y, z; in the plane the last is the number 0.
pub type Vector = [Expr; 3];

/// The vector 0.
pub const ZERO: Vector = [Expr::Number(0.0), Expr::Number(0.0), Expr::Number(0.0)];

/// A mechanism, all quantities in SI units.
#[derive(Clone, Debug)]
pub struct Mechanism {
    pub space: Space,
    pub name: Name,
    /// Visibility as written (`pub`, `pub(crate)` or nothing).
    pub visibility: String,
    /// Doc comments and other outer attributes, as written.
    pub attributes: String,
    pub parameters: Vec<Parameter>,
    pub inputs: Vec<Input>,
    /// With rates of their own.
    pub states: Vec<InternalState>,
    pub memories: Vec<Memory>,
    /// What sets them, in the order written.
    pub events: Vec<Event>,
    pub signals: Vec<Signal>,
    /// World axes; `None` if no gravity was written.
    pub gravity: Option<Vector>,
    pub gravity_span: Option<Region>,
    pub bodies: Vec<Body>,
    pub joints: Vec<Joint>,
    /// Gears, racks and general equations, in the order written.
    pub constraints: Vec<Constraint>,
    pub drivers: Vec<Driver>,
    pub loads: Vec<Load>,
    /// Those with names that touch something.
    pub surfaces: Vec<Surface>,
    pub start: Vec<StartCondition>,
    /// The internal states that begin where they rest, and where that is said.
    pub steady: Vec<(usize, Region)>,
    /// The bodies that start bent as they are loaded, and where that is said.
    pub deflected: Vec<(BodyId, Region)>,
    pub orientations: Vec<StartOrientation>,
    pub options: Options,
    pub expect: Expect,
    pub outputs: Vec<Output>,
    pub tables: Vec<Table>,
    /// Pairs of toothings, of constraints and then of loads.
    pub pairs: Vec<gears::Pair>,
    /// Uses of parts.
    pub parts: Vec<UsedPart>,
    /// Where accelerations jump at the knots of a table.
    pub kinks: Vec<Kink>,
    /// What is declared and named by nothing.
    pub unused: Vec<Unused>,
    /// Warnings that are not wanted.
    pub allowed: Allowed,
    /// In which units lengths are written.
    pub lengths: WrittenLengths,
}

impl Mechanism {
    /// Defaults of the parameters.
    pub fn defaults(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.default).collect()
    }

    /// The internal states at the start, for the default parameters.
    pub fn internal_starts(&self) -> Vec<f64> {
        let defaults = self.defaults();
        let starts = self.states.iter().map(|state| value_at(&state.start, &defaults));
        starts.map(|start| start.unwrap_or(f64::NAN)).collect()
    }

    /// The first joint whose rows only the coordinates of a tree can have, if there is one.
    pub fn bound_to_a_tree(&self) -> Option<JointId> {
        self.joints.iter().position(Joint::must_carry).map(JointId)
    }

    /// Whether gates are forces, which the run finds: of rigid contacts, or of dry friction in joints.
    pub fn is_rigid(&self) -> bool {
        self.loads.iter().any(|load| !load.restitutions.is_empty()) || self.sticks()
    }

    /// Whether gates are those of dry friction in joints: all are, or none.
    pub fn sticks(&self) -> bool {
        self.loads.iter().any(Load::sticks)
    }

    /// The gates that are held over a step: contact and which of its gaps, in the order of their declaration.
    pub fn gates(&self) -> impl Iterator<Item = (LoadId, usize)> {
        let loads = self.loads.iter().enumerate();
        loads.flat_map(|(load, it)| (0..it.ungated.len()).map(move |which| (LoadId(load), which)))
    }

    /// Of each gate the one of the gap that presses, where it is of dry friction of a contact; nothing where none is.
    pub fn pressed_by(&self) -> Vec<Option<usize>> {
        if !self.loads.iter().any(|load| load.form.holds && load.contact().is_some()) {
            return Vec::new();
        }
        let gates: Vec<(LoadId, usize)> = self.gates().collect();
        let pressed = |(load, which): &(LoadId, usize)| {
            let load = &self.loads[load.0];
            let contact = load.contact().filter(|_| load.form.holds)?;
            gates.iter().position(|gate| *gate == (contact, which / self.axes_of(load)))
        };
        gates.iter().map(pressed).collect()
    }

    /// How many gates the dry friction of a contact has for each gap: one along each axis of the world, or one along what slides.
    fn axes_of(&self, load: &Load) -> usize {
        let gaps = load.contact().map_or(1, |contact| self.loads[contact.0].along().count());
        load.ungated.len() / gaps.max(1)
    }

    /// Of each gate the first of those that slide as one with it, along several directions; nothing where each slides by itself.
    pub fn slide_as_one(&self) -> Vec<usize> {
        let gates: Vec<(LoadId, usize)> = self.gates().collect();
        let as_one = |load: &Load| -> usize {
            if load.form.holds && load.contact().is_some() {
                return self.axes_of(load);
            }
            let joint = load.bearing().filter(|_| load.form.holds);
            let bearing = joint.and_then(|joint| self.joints[joint.0].form.bearing);
            if bearing.is_some_and(Bearing::slides_as_one) { load.ungated.len() } else { 1 }
        };
        let first =
            |(place, (load, which)): (usize, &(LoadId, usize))| place - which % as_one(&self.loads[load.0]);
        let found: Vec<usize> = gates.iter().enumerate().map(first).collect();
        if found.iter().enumerate().all(|(place, first)| place == *first) { Vec::new() } else { found }
    }

    /// The files that tables, parts and bodies were read from.
    pub fn files(&self) -> impl Iterator<Item = &OnDisk> {
        let tables = self.tables.iter().filter_map(|table| Some(&table.file.as_ref()?.on_disk));
        let bodies = self.bodies.iter().filter_map(|body| body.file.as_ref());
        tables.chain(self.parts.iter().filter_map(|part| part.file.as_ref())).chain(bodies)
    }

    /// Name of a body, or `ground`.
    pub fn frame_name(&self, frame: Frame) -> &str {
        match frame {
            Frame::Ground => "ground",
            Frame::Body(body) => &self.bodies[body.0].name.text,
        }
    }
}

/// The unit beside the name of a declared value.
#[derive(Clone, Debug)]
pub struct DeclaredUnit {
    /// As written; `1` if none was.
    pub text: String,
    /// One of it in SI.
    pub scale: f64,
    /// The unit of SI in its place.
    pub si: String,
}

impl DeclaredUnit {
    /// Whether values in it and in SI are the same numbers.
    pub fn is_si(&self) -> bool {
        self.scale == 1.0
    }
}

/// A part of which there is a copy: what it brought has its name in front.
#[derive(Clone, Debug)]
pub struct UsedPart {
    pub name: Name,
    /// The part.
    pub of: String,
    /// Where that is declared, if in a file of its own.
    pub file: Option<OnDisk>,
}

/// A table whose curvature jumps, named where accelerations follow it.
#[derive(Clone, Debug)]
pub struct Kink {
    pub table: String,
    /// Where it is named.
    pub region: Region,
}

/// A value that may change when parameters are set.
#[derive(Clone, Debug)]
pub struct Parameter {
    pub name: Name,
    pub unit: DeclaredUnit,
    /// Default, SI.
    pub default: f64,
    /// Inclusive bounds, SI.
    pub bounds: Option<(f64, f64)>,
    /// What the user wrote above it.
    pub docs: String,
}

/// A value that changes at every call.
#[derive(Clone, Debug)]
pub struct Input {
    pub name: Name,
    pub unit: DeclaredUnit,
    pub docs: String,
}

/// An expression with a name.
#[derive(Clone, Debug)]
pub struct Signal {
    pub name: Name,
    pub unit: DeclaredUnit,
}

/// A quantity with a rate of its own: ż = rate.
#[derive(Clone, Debug)]
pub struct InternalState {
    pub name: Name,
    pub unit: DeclaredUnit,
    pub docs: String,
    /// Of parameters.
    pub start: Expr,
    /// What its errors are measured by where it is small, SI.
    pub scale: Option<f64>,
    pub rate: Rate,
}

/// The rate of an internal state.
#[derive(Clone, Debug)]
pub enum Rate {
    /// As `rate` says.
    Written(Expr),
    /// One of those that a load has.
    OfLoad(LoadId, usize),
}

impl Rate {
    /// What is written.
    pub fn written(&self) -> Option<&Expr> {
        match self {
            Self::Written(expr) => Some(expr),
            Self::OfLoad(..) => None,
        }
    }
}

#[derive(Clone, Debug)]
pub struct Body {
    pub name: Name,
    pub form: &'static BodyForm,
    /// kg, of parameters only.
    pub mass: Expr,
    pub mass_span: Region,
    /// About the centre of mass; zero for a particle.
    pub inertia: Inertia,
    pub inertia_span: Region,
    /// Lengths of its shape, m, by name: positive, whatever parameters make of them.
    pub dimensions: Vec<(&'static str, Expr)>,
    /// Centre of mass in the body's frame, m.
    pub center: Vector,
    /// Named points in the body's frame, m (shape points such as a rod's `start` included).
    pub points: Vec<NamedPoint>,
    /// Where its markers are, likewise.
    pub markers: Vec<NamedPoint>,
    pub lines: Vec<NamedLine>,
    pub toothings: Vec<gears::Toothing>,
    /// What deforms of it.
    pub deforms: Option<Deforms>,
    /// The file that its modes were read from.
    pub file: Option<OnDisk>,
}

/// The inertia tensor about the centre of mass, kg m², of parameters only.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// Ixx, Iyy, Izz; in the plane the last one.
    pub moments: Vector,
    /// Ixy, Ixz, Iyz, entries of the tensor: Ixy = −∫ x y dm.
    pub products: Vector,
    /// The axes in which they are given, in body axes.
    pub axes: Axes,
}

/// Axes in the axes of a body or of the ground.
#[derive(Clone, Debug)]
pub enum Axes {
    Parallel,
    /// z along `axis`; x along `reference`, less its part along z, or as [`crate::equations::space`] chooses it.
    Directed {
        axis: Vector,
        reference: Option<Vector>,
    },
    /// Turned about own axes, one after the other: axis (0, 1, 2) and angle, rad.
    Turned(Vec<(usize, Expr)>),
}

#[derive(Clone, Debug)]
pub struct NamedPoint {
    pub name: Name,
    pub at: Vector,
}

/// A line through two points of one body.
#[derive(Clone, Debug)]
pub struct NamedLine {
    pub name: Name,
    pub from: Vector,
    pub to: Vector,
}

/// What a place belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Frame {
    Ground,
    Body(BodyId),
}

/// A point of a body or of the ground. Two places are the same if they are the same point, whatever they are called.
#[derive(Clone, Debug)]
pub struct Place {
    pub frame: Frame,
    /// In the body's frame, of parameters only; on the ground in world axes and possibly a function of time.
    pub at: Vector,
    /// Axes of the place in the axes of what it belongs to.
    pub axes: Axes,
    /// Whether it is the origin of a frame in the mean of a beam, and no point of its axis.
    pub of_mean: bool,
    /// As written: `crank.tip`, `ground(0, 0.2)`.
    pub text: String,
    pub span: Region,
}

impl PartialEq for Place {
    fn eq(&self, other: &Self) -> bool {
        self.frame == other.frame && self.at == other.at && self.of_mean == other.of_mean
    }
}

/// A rheonomic constraint: quantity = law(time).
#[derive(Clone, Debug)]
pub struct Driver {
    pub name: Name,
    /// Of which there is a value.
    pub coordinate: Coordinate,
    /// Of time and parameters.
    pub law: Expr,
}

/// `quantity = value` (exact) or `quantity ~ value` (guess), an angle, travel, position, or the rate of one.
#[derive(Clone, Debug)]
pub struct StartCondition {
    pub coordinate: Coordinate,
    /// Whether it is the coordinate's rate that is stated.
    pub rate: bool,
    /// As written, `crank_pin.angle`.
    pub text: String,
    pub value: Expr,
    pub exact: bool,
    pub span: Region,
}

/// The orientation of a body at the start, or a guess of it.
#[derive(Clone, Debug)]
pub struct StartOrientation {
    pub body: BodyId,
    /// Unit quaternion, scalar first, of parameters only.
    pub quaternion: [Expr; 4],
    pub exact: bool,
    pub span: Region,
}

/// What is done about constraint rows that repeat what others fix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Redundant {
    Refuse,
    /// They are no rows of the mechanism.
    Drop,
    /// They are rows, with the multiplier zero.
    Keep,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinates {
    Absolute,
    Tree,
    Auto,
}

/// The unknowns that the accelerations are solved for first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolvedBy {
    /// v̇ and λ together.
    Multipliers,
    /// Independent velocities, where these serve; v̇ and λ together elsewhere.
    Independent,
    /// What takes fewer operations.
    Auto,
}

#[derive(Clone, Debug)]
pub struct Options {
    pub coordinates: Coordinates,
    pub solution: SolvedBy,
    pub redundant: Redundant,
    /// Passes of Newton's method for the forces that press surfaces together.
    pub friction_passes: Option<usize>,
    /// Whether gates of contacts are held within a step.
    pub held: bool,
    /// Where that is said.
    pub held_at: Option<Region>,
    /// Whether restitutions of rigid contacts are of impulses, by Poisson's law, and not of speeds.
    pub by_impulses: bool,
    /// Whether principal moments may be those of no real body, as in some published data.
    pub accept_inertia: bool,
    /// Joints that the spanning tree must not use.
    pub cut: Vec<(JointId, Region)>,
    /// Position coordinates the user takes as independent (angles, travels); empty if the compiler chooses.
    pub independent: Vec<(Coordinate, Region)>,
    pub emit: Emit,
    /// Whether the compiler checks its own work: thoroughly, not at all, or, where nothing is written, in passing.
    pub self_check: Option<bool>,
    /// In which scalar functions with a C interface are emitted beside the items.
    pub export_c: Option<Scalar>,
    /// Path of the `linkwright` crate as seen by the user; `::linkwright` if `None`.
    pub crate_path: Option<String>,
}

/// What is emitted beyond the default, because it costs expansion and compilation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Emit {
    /// K(c) with the right-hand sides of the penalty family.
    pub penalty: bool,
    /// K(c) for projections.
    pub projection: bool,
    /// The equations in independent velocities.
    pub null_space: bool,
    /// Derivatives of the equations and outputs.
    pub tangent: bool,
}

impl Emit {
    /// Sets what one of the words says.
    pub fn set(&mut self, word: &str) {
        match word {
            "penalty" => self.penalty = true,
            "projection" => self.projection = true,
            "null_space" => self.null_space = true,
            "tangent" => self.tangent = true,
            _ => {}
        }
    }
}

#[derive(Clone, Debug, Default)]
pub struct Expect {
    pub degrees_of_freedom: Option<(usize, Region)>,
    pub budgets: Vec<Budget>,
    pub motion: MotionExpected,
    pub contact_times: Vec<LoadTime>,
    pub friction_times: Vec<LoadTime>,
    pub frequencies: Vec<Frequency>,
    pub deflections: Vec<Deflection>,
}

/// `deflection(arm.end) <= 3 [mm];`
#[derive(Clone, Debug)]
pub struct Deflection {
    /// A beam, and where on its axis.
    pub body: BodyId,
    pub x: f64,
    /// As written.
    pub text: String,
    pub side: Side,
    /// m.
    pub bound: f64,
    pub span: Region,
}

/// `frequency(coupler.bending[0]) >= 200 [Hz];`
#[derive(Clone, Debug)]
pub struct Frequency {
    pub body: BodyId,
    pub mode: usize,
    pub side: Side,
    /// Hz.
    pub bound: f64,
    pub span: Region,
}

/// `contact_time(touch) >= 1e-3 [s];` or `friction_time(rub) >= 1e-4 [s];`
#[derive(Clone, Debug)]
pub struct LoadTime {
    pub load: LoadId,
    /// s.
    pub least: f64,
    pub span: Region,
}

/// What is expected of the motion of a mechanism with one degree of freedom.
#[derive(Clone, Debug, Default)]
pub struct MotionExpected {
    /// Angles that take every value.
    pub rotates: Vec<Turning>,
    pub within: Vec<Within>,
    pub no_singularity: Option<Region>,
    /// Of the motion that drivers fix.
    pub efforts: Vec<EffortBound>,
}

impl MotionExpected {
    /// Where something is expected first.
    pub fn span(&self) -> Option<Region> {
        let turning = self.rotates.iter().map(|expected| expected.span);
        turning.chain(self.within.iter().map(|expected| expected.span)).chain(self.no_singularity).next()
    }
}

/// `rotates = crank_pin;`
#[derive(Clone, Debug)]
pub struct Turning {
    pub rotor: Rotor,
    pub name: String,
    pub span: Region,
}

/// `follow.force > 0;`
#[derive(Clone, Debug)]
pub struct EffortBound {
    pub value: Expr,
    /// As written, `follow.force`.
    pub text: String,
    pub side: Side,
    /// SI.
    pub bound: f64,
    /// N or N m.
    pub unit: &'static str,
    pub span: Region,
}

/// `knee.angle in 10..170 [deg];`
#[derive(Clone, Debug)]
pub struct Within {
    pub coordinate: Coordinate,
    /// As written, `knee.angle`.
    pub text: String,
    /// SI.
    pub from: f64,
    pub to: f64,
    /// The unit it is written in, and that unit in SI.
    pub unit: (String, f64),
    pub span: Region,
}

/// A limit on what a function takes.
#[derive(Clone, Debug)]
pub struct Budget {
    pub of: Budgeted,
    /// `None` for the default acceleration function.
    pub function: Option<String>,
    pub limit: usize,
    pub span: Region,
}

#[derive(Clone, Debug)]
pub struct Output {
    pub name: Name,
    pub unit: DeclaredUnit,
    pub docs: String,
    pub value: Expr,
}
