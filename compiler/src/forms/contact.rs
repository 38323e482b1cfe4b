//! How surfaces and laws of contacts are written, and what anyone may know of them. Their geometry and equations stand in
//! `model::contacts`.

use super::{Argument, Form, Need, PLACES, Positional, Space, Value};
use crate::units::Dimension;

/// A kind of surface.
#[derive(Debug)]
pub struct SurfaceForm {
    pub call: Form,
    pub kind: SurfaceKind,
    /// Where it is known; nothing: in the plane and in space.
    pub only: Option<Space>,
    /// What it bounds, for documents.
    pub bounds: &'static str,
}

/// What a surface is, for those who find gaps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceKind {
    Point,
    /// A circle or a sphere.
    Round,
    /// A hole or the socket of a ball: inside of it is free.
    Hollow,
    /// A half-plane by a line.
    Line,
    /// A half-space by a place and an axis.
    Plane,
    /// From place to place: a segment or a capsule.
    Bar,
    Polygon,
    /// A closed curve in polar form.
    Profile,
    Cylinder,
    Bore,
    Rim,
}

/// A law of contacts.
#[derive(Debug)]
pub struct ContactLawForm {
    pub call: Form,
    pub kind: ContactLaw,
    /// Its force, for documents.
    pub force: &'static str,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactLaw {
    KelvinVoigt,
    HuntCrossley,
    Hertz,
    /// Hertz, along a line.
    HertzLine,
    Rigid,
}

const RADIUS: Argument = Argument::scalar("radius", Need::Always, Dimension::LENGTH);
const LENGTH: Argument = Argument::scalar("length", Need::Never, Dimension::LENGTH);
const AXIS: Argument = Argument::direction("axis", Need::UnlessMarked);
const PLACE: &[Positional] = &[Positional::Place];

const fn surface(
    word: &'static str,
    positional: &'static [Positional],
    named: &'static [Argument],
    kind: SurfaceKind,
    only: Option<Space>,
    bounds: &'static str,
) -> SurfaceForm {
    SurfaceForm { call: Form { word, elsewhere: &[], positional, named }, kind, only, bounds }
}

const PLANAR: Option<Space> = Some(Space::Planar);
const SPATIAL: Option<Space> = Some(Space::Spatial);

/// All surfaces.
pub static SURFACES: &[SurfaceForm] = &[
    surface("point", PLACE, &[], SurfaceKind::Point, None, "one place"),
    surface("circle", PLACE, &[RADIUS], SurfaceKind::Round, PLANAR, "a disk about the place"),
    surface("hole", PLACE, &[RADIUS], SurfaceKind::Hollow, PLANAR, "all but a disk about the place"),
    surface(
        "half_plane",
        &[Positional::Line],
        &[Argument::of("side", Need::Never, Value::Word)],
        SurfaceKind::Line,
        PLANAR,
        "what lies on the right of the line; its left is free, or with `side = right` its right",
    ),
    surface(
        "segment",
        PLACES,
        &[RADIUS_IF],
        SurfaceKind::Bar,
        PLANAR,
        "a bar from place to place, round at its ends",
    ),
    surface(
        "polygon",
        &[Positional::Place, Positional::Place, Positional::Place, Positional::Places],
        &[],
        SurfaceKind::Polygon,
        PLANAR,
        "a convex polygon, its corners counter-clockwise",
    ),
    surface(
        "profile",
        PLACE,
        &[
            Argument::of("radius", Need::Always, Value::Word),
            Argument::scalar("base", Need::Never, Dimension::LENGTH),
            Argument::scalar("refine", Need::Never, Dimension::ONE),
        ],
        SurfaceKind::Profile,
        PLANAR,
        "what lies within a closed curve, whose distance from the place is a table of the angle about it, and a base",
    ),
    surface("sphere", PLACE, &[RADIUS], SurfaceKind::Round, SPATIAL, "a ball about the place"),
    surface("ball_socket", PLACE, &[RADIUS], SurfaceKind::Hollow, SPATIAL, "all but a ball about the place"),
    surface("plane", PLACE, &[AXIS], SurfaceKind::Plane, SPATIAL, "what lies behind the axis"),
    surface(
        "capsule",
        PLACES,
        &[RADIUS],
        SurfaceKind::Bar,
        SPATIAL,
        "a bar from place to place, round at its ends",
    ),
    surface(
        "cylinder",
        PLACE,
        &[AXIS, RADIUS, LENGTH],
        SurfaceKind::Cylinder,
        SPATIAL,
        "a cylinder, the place in its middle",
    ),
    surface(
        "bore",
        PLACE,
        &[AXIS, RADIUS, LENGTH],
        SurfaceKind::Bore,
        SPATIAL,
        "all about a bore, the place in its middle",
    ),
    surface(
        "disk_rim",
        PLACE,
        &[AXIS, RADIUS],
        SurfaceKind::Rim,
        SPATIAL,
        "the edge of a thin disk about the place",
    ),
];

const RADIUS_IF: Argument = Argument::scalar("radius", Need::Never, Dimension::LENGTH);

const DISSIPATION: Argument = Argument::of("dissipation", Need::Never, Value::OfGap);
const RESTITUTION: Argument = Argument::scalar("restitution", Need::Never, Dimension::ONE);
const REST: Argument = Argument::of("rest", Need::Never, Value::OfGap);
const SPEED: Argument = Argument::of("speed", Need::Never, Value::OfGap);
/// What counts as the speed of a touch at least, of `speed = touch`.
const SLOWEST: Argument = Argument::of("slowest", Need::Never, Value::OfGap);
const DAMPING: Argument = Argument::of("damping", Need::Never, Value::Word);
/// `on`: what the law has below zero pulls.
const ADHESION: Argument = Argument::of("adhesion", Need::Never, Value::Word);

/// All laws. What their arguments measure follows from what the gap does.
pub static CONTACT_LAWS: &[ContactLawForm] = &[
    ContactLawForm {
        call: Form {
            word: "kelvin_voigt",
            elsewhere: &["spring_damper"],
            positional: &[],
            named: &[
                Argument::of("stiffness", Need::Always, Value::OfGap),
                Argument::of("damping", Need::Never, Value::OfGap),
                Argument::scalar("release", Need::Never, Dimension::ONE),
                ADHESION,
            ],
        },
        kind: ContactLaw::KelvinVoigt,
        force: "max(0, k d + c ḋ), c times `release` on the way out",
    },
    ContactLawForm {
        call: Form {
            word: "hunt_crossley",
            elsewhere: &[],
            positional: &[],
            named: &[
                Argument::of("force", Need::Always, Value::OfGap),
                Argument::of("depth", Need::Always, Value::OfGap),
                Argument::scalar("exponent", Need::Never, Dimension::ONE),
                DISSIPATION,
                RESTITUTION,
                SPEED,
                SLOWEST,
                DAMPING,
                ADHESION,
            ],
        },
        kind: ContactLaw::HuntCrossley,
        force: "F₀ (d/d₀)ⁿ max(0, 1 + b ḋ), n = 3/2 unless `exponent` says otherwise",
    },
    ContactLawForm {
        call: Form {
            word: "hertz",
            elsewhere: &[],
            positional: &[],
            named: &[
                Argument::of("first", Need::Always, Value::Word),
                Argument::of("second", Need::Always, Value::Word),
                DISSIPATION,
                RESTITUTION,
                SPEED,
                SLOWEST,
                DAMPING,
                ADHESION,
            ],
        },
        kind: ContactLaw::Hertz,
        force: "K d^1.5 max(0, 1 + b ḋ), K by moduli and radii",
    },
    ContactLawForm {
        call: Form {
            word: "hertz_line",
            elsewhere: &[],
            positional: &[],
            named: &[
                Argument::of("first", Need::Always, Value::Word),
                Argument::of("second", Need::Always, Value::Word),
                Argument::scalar("length", Need::Always, Dimension::LENGTH),
                DISSIPATION,
                RESTITUTION,
                SPEED,
                SLOWEST,
                DAMPING,
                ADHESION,
            ],
        },
        kind: ContactLaw::HertzLine,
        force: "F max(0, 1 + b ḋ), d = F/(π E l) (ln(4 π E l (R₁ ± R₂)/F) − 1), E by moduli, l the length",
    },
    ContactLawForm {
        call: Form { word: "rigid", elsewhere: &[], positional: &[], named: &[RESTITUTION, REST] },
        kind: ContactLaw::Rigid,
        force: "what keeps the gap from closing further: an impulse at a touch, a force at rest",
    },
];
