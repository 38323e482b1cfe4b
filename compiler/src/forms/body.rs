//! What anyone may know of a kind of body.

use super::{Need, Space};

/// A kind of body.
#[derive(Debug)]
pub struct BodyForm {
    pub word: &'static str,
    /// What it is, for documents.
    pub is: &'static str,
    /// How it is described in the plane and in space; `None` where there is none.
    pub planar: Option<&'static Solid>,
    pub spatial: Option<&'static Solid>,
    /// Whether it has an orientation. What has none has all its places at its centre of mass.
    pub turns: bool,
    /// Whether its centre of mass may be elsewhere than at its origin.
    pub states_center: bool,
    /// Whether it has points `start` and `end`, half its length from its centre along x.
    pub has_ends: bool,
    pub deforms: Deforms,
    pub outline: Outline,
}

/// The coordinates of its own by which a body deforms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deforms {
    Not,
    /// Modes of a slender beam, by its lengths and its material.
    Beam,
    /// Modes of a finite element model, as a file has them.
    Modal,
}

/// A body by its lengths.
#[derive(Debug)]
pub struct Solid {
    /// Its lengths, of the same or another name in the definition, in the order in which they are told.
    pub lengths: &'static [Length],
    /// Moments of inertia about its centre of mass, along its axes; in the plane the last one counts. `None`: they are stated.
    pub moments: Option<[Moment; 3]>,
    pub volume: Option<Volume>,
}

/// A length of a body.
#[derive(Clone, Copy, Debug)]
pub struct Length {
    pub name: &'static str,
    /// Where it may be left out it is zero.
    pub need: Need,
    /// Which component of the property `size` it is, where it has no property of its own.
    pub of_size: Option<usize>,
}

impl Length {
    pub const fn needed(name: &'static str) -> Self {
        Length { name, need: Need::Always, of_size: None }
    }

    pub const fn optional(name: &'static str) -> Self {
        Length { name, need: Need::Never, of_size: None }
    }

    pub const fn of_size(name: &'static str, component: usize) -> Self {
        Length { name, need: Need::Always, of_size: Some(component) }
    }
}

/// m Σ factor · length² / divisor.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    pub squares: &'static [(f64, &'static str)],
    pub divisor: f64,
}

impl Moment {
    pub const NONE: Self = Moment { squares: &[], divisor: 1.0 };

    pub const fn new(squares: &'static [(f64, &'static str)], divisor: f64) -> Self {
        Moment { squares, divisor }
    }
}

/// factor · Π length^power, m³.
#[derive(Clone, Copy, Debug)]
pub struct Volume {
    pub factor: f64,
    pub edges: &'static [(&'static str, u32)],
}

/// Second moments of area of a beam's section in the order of the axes across it that it bends along, y before z: the first is about z.
pub fn second_moments(space: Space) -> &'static [&'static str] {
    match space {
        Space::Planar => &["second_moment"],
        Space::Spatial => &["second_moment_z", "second_moment_y"],
    }
}

/// Cross-sections by their lengths, the one across the beam before the one along z.
pub const SECTIONS: [(&str, &[&str]); 3] =
    [("circle", &["diameter"]), ("tube", &["outer", "inner"]), ("rectangle", &["height", "width"])];

/// How a body is drawn, and how far it reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outline {
    /// Between its places.
    None,
    /// Along x by `length`, about it by `radius`.
    Bar,
    /// About z by `radius`, along it by `thickness`.
    Disk,
    /// About its centre by `radius`.
    Ball,
    /// By its lengths along x, y, z.
    Box,
}

impl BodyForm {
    /// Whether it has coordinates of its own by which it deforms.
    pub fn bends(&self) -> bool {
        self.deforms != Deforms::Not
    }

    pub fn is_beam(&self) -> bool {
        self.deforms == Deforms::Beam
    }

    /// Whether its modes are those of a file.
    pub fn is_modal(&self) -> bool {
        self.deforms == Deforms::Modal
    }

    /// How it is described in a space, if it is at home there.
    pub fn solid(&self, space: Space) -> Option<&'static Solid> {
        match space {
            Space::Planar => self.planar,
            Space::Spatial => self.spatial,
        }
    }

    /// Independent velocities of one that nothing holds.
    pub fn freedoms(&self, space: Space) -> usize {
        match (space, self.turns) {
            (Space::Planar, false) => 2,
            (Space::Planar, true) | (Space::Spatial, false) => 3,
            (Space::Spatial, true) => 6,
        }
    }

    /// Whether its moments of inertia do not follow from its lengths.
    pub fn states_inertia(&self, space: Space) -> bool {
        !self.is_modal() && self.solid(space).is_none_or(|solid| solid.moments.is_none())
    }

    /// Properties of one value that it may have.
    pub fn properties(&self, space: Space) -> Vec<&'static str> {
        let Some(solid) = self.solid(space) else { return Vec::new() };
        let mut names = vec!["mass"];
        names.extend(solid.volume.map(|_| "density"));
        names
            .extend(solid.lengths.iter().filter(|length| length.of_size.is_none()).map(|length| length.name));
        if self.turns && !self.bends() && space == Space::Planar {
            names.push("inertia");
        }
        if self.is_modal() {
            names.push("damping_ratio");
        }
        if self.is_beam() {
            names.extend(["density", "young", "area"].iter().chain(second_moments(space)));
            names.extend(["damping_ratio", "shear_modulus", "shear_factor"]);
            if space == Space::Spatial {
                names.push("torsion_constant");
            }
        }
        names
    }

    /// Properties of three values that it may have.
    pub fn vectors(&self, space: Space) -> Vec<&'static str> {
        let Some(solid) = self.solid(space) else { return Vec::new() };
        let mut names = Vec::new();
        if solid.has_size() {
            names.push("size");
        }
        if self.turns && !self.bends() && space == Space::Spatial {
            names.extend(["inertia", "products", "inertia_axes"]);
        }
        names
    }
}

impl Solid {
    /// Whether its lengths are the components of one property, `size`.
    pub fn has_size(&self) -> bool {
        self.lengths.iter().any(|length| length.of_size.is_some())
    }
}
