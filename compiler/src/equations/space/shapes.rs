//! By how much modes move and turn the places of a body in space, and what means their shapes have over its mass: numbers, of a beam or of the
//! modes of a finite element model.

use crate::beams::{Rule, Shortening, Slender, Way};
use crate::equations::means::{Bent, Means};
use crate::modal::{Reduced, Rotary};
use crate::model::{Deforms, Expr, Vector};
use crate::symbolic::Sheet;
use std::sync::Arc;

/// What deforms.
#[derive(Clone, Debug)]
pub enum Shapes {
    Beam(Arc<Slender>),
    Modal(Arc<Reduced>),
}

/// A place where shapes are known: of a beam the bits of x, of a finite element model which node.
pub type Station = u64;

/// What modes do at a place.
pub struct Rows {
    /// By how much each mode moves it, 1, and turns it, 1/m, along the axes of the body.
    pub shifts: Vec<[f64; 3]>,
    pub turns: Vec<[f64; 3]>,
    /// Γ of each pair of modes of bending that draw it in, 1/m.
    pub gammas: Vec<f64>,
}

/// A function over the mass, of which fields are sums: a coordinate along an axis of the body, or what a mode moves along it.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    pub axis: usize,
    pub mode: Option<usize>,
}

/// A part of the mass with its place and the shapes there.
pub struct Slice {
    pub share: f64,
    pub at: [f64; 3],
    pub rows: Rows,
}

impl Shapes {
    pub fn of(deforms: &Deforms) -> Self {
        match deforms {
            Deforms::Beam(beam) => Self::Beam(beam.slender.clone()),
            Deforms::Modal(modal) => Self::Modal(modal.reduced.clone()),
        }
    }

    pub fn modes(&self) -> usize {
        match self {
            Self::Beam(slender) => slender.modes.len(),
            Self::Modal(reduced) => reduced.modes(),
        }
    }

    /// The station at a place whose coordinates are known as far as told.
    pub fn station(&self, at: [Option<f64>; 3]) -> Option<Station> {
        match self {
            Self::Beam(_) => at[0].map(f64::to_bits),
            Self::Modal(reduced) => {
                let [x, y, z] = at;
                reduced.node_at([x?, y?, z?]).map(|node| node as Station)
            }
        }
    }

    /// The same of a place as it is written.
    pub fn station_of(&self, at: &Vector) -> Option<Station> {
        self.station(at.each_ref().map(|component| match component {
            Expr::Number(value) => Some(*value),
            _ => None,
        }))
    }

    /// Where a station is while nothing deforms.
    pub fn place(&self, station: Station) -> [f64; 3] {
        match self {
            Self::Beam(_) => [f64::from_bits(station), 0.0, 0.0],
            Self::Modal(reduced) => reduced.nodes[station as usize].at,
        }
    }

    pub fn rows(&self, station: Station) -> Rows {
        match self {
            Self::Beam(slender) => rows_of_beam(slender, f64::from_bits(station)),
            Self::Modal(reduced) => {
                let node = &reduced.nodes[station as usize];
                Rows { shifts: node.shifts.clone(), turns: node.turns.clone(), gammas: Vec::new() }
            }
        }
    }

    pub fn shortenings(&self) -> &[Shortening] {
        match self {
            Self::Beam(slender) => &slender.shortenings,
            Self::Modal(_) => &[],
        }
    }

    /// In the order of the means, behind which those of what is drawn in stand.
    pub fn functions(&self) -> Vec<Function> {
        match self {
            Self::Beam(slender) => {
                let modes = slender.modes.iter().enumerate();
                let modes = modes.map(|(mode, it)| Function { axis: it.way.axis(), mode: Some(mode) });
                std::iter::once(Function { axis: 0, mode: None }).chain(modes).collect()
            }
            Self::Modal(reduced) => {
                let modes = std::iter::once(None).chain((0..reduced.modes()).map(Some));
                modes.flat_map(|mode| (0..3).map(move |axis| Function { axis, mode })).collect()
            }
        }
    }

    /// Whether a mode moves places at all: what twists a beam does not.
    pub fn moves(&self, mode: usize) -> bool {
        match self {
            Self::Beam(slender) => slender.modes[mode].way != Way::Torsion,
            Self::Modal(_) => true,
        }
    }

    /// Whether a mode draws places in by its square.
    pub fn draws_in(&self, mode: usize) -> bool {
        match self {
            Self::Beam(slender) => !slender.shortenings.is_empty() && slender.modes[mode].way.bends(),
            Self::Modal(_) => false,
        }
    }

    pub fn means<'g>(&self, g: Sheet<'g>, modes: &[Bent]) -> Means<'g> {
        match self {
            Self::Beam(slender) => Means::new(g, slender, modes),
            Self::Modal(reduced) => Means::of_constants(g, &reduced.first(), &reduced.second()),
        }
    }

    /// What turns beyond places that move: of a beam about its axis by its square of the radius of gyration times the mass, with shear about all
    /// axes by the mass, of a finite element model by itself.
    pub fn rotary(&self) -> Rotary {
        match self {
            Self::Beam(slender) => rotary_of_beam(slender),
            Self::Modal(reduced) => reduced.rotary(),
        }
    }

    /// The mass in parts.
    pub fn slices(&self, rule: &Rule) -> Vec<Slice> {
        match self {
            Self::Beam(slender) => {
                let slice = |(share, weight): (f64, f64)| {
                    let x = slender.from + share * slender.length;
                    Slice { share: weight, at: [x, 0.0, 0.0], rows: rows_of_beam(slender, x) }
                };
                rule.points().map(slice).collect()
            }
            Self::Modal(reduced) => {
                let points = reduced.points().into_iter();
                let rows = |shifts: Vec<[f64; 3]>| Rows {
                    turns: vec![[0.0; 3]; shifts.len()],
                    shifts,
                    gammas: Vec::new(),
                };
                points.map(|it| Slice { share: it.share, at: it.at, rows: rows(it.shifts) }).collect()
            }
        }
    }
}

/// About x by what twists; with shear about y and z by ψ of what bends along z and along y.
fn rotary_of_beam(slender: &Slender) -> Rotary {
    let turning = slender.turning.as_ref();
    let spin = turning.map_or(1.0, |turning| turning.about_y + turning.about_z);
    let own = |mode: usize| {
        let bent = turning.map_or(0.0, |turning| turning.first[mode]);
        match slender.modes[mode].way {
            Way::Axial => [0.0; 3],
            Way::Torsion => [spin * slender.first[1 + mode], 0.0, 0.0],
            Way::Bending => [0.0, 0.0, bent],
            Way::BendingZ => [0.0, -bent, 0.0],
        }
    };
    let twists = |mode: usize| slender.modes[mode].way == Way::Torsion;
    let both = |j: usize, k: usize| {
        if twists(j) && twists(k) {
            spin * slender.second[1 + j][1 + k]
        } else {
            turning.map_or(0.0, |turning| turning.second[j][k])
        }
    };
    let modes = 0..slender.modes.len();
    let [about_y, about_z] = turning.map_or([0.0; 2], |turning| [turning.about_y, turning.about_z]);
    Rotary {
        inertia: [[spin, 0.0, 0.0], [0.0, about_y, 0.0], [0.0, 0.0, about_z]],
        momentum: modes.clone().map(own).collect(),
        modal: modes.clone().map(|j| modes.clone().map(|k| both(j, k)).collect()).collect(),
    }
}

/// What rises along y turns about z, what rises along z back about y, what twists about x.
fn rows_of_beam(slender: &Slender, x: f64) -> Rows {
    let along = |axis: usize, part: f64| {
        let mut vector = [0.0; 3];
        vector[axis] = part;
        vector
    };
    let values = slender.modes.iter().zip(slender.values(x));
    let slopes = slender.modes.iter().zip(slender.slopes(x));
    Rows {
        shifts: values.map(|(mode, value)| along(mode.way.axis(), value)).collect(),
        turns: slopes
            .map(|(mode, slope)| match mode.way {
                Way::Axial => [0.0; 3],
                Way::Torsion => along(0, slope),
                Way::Bending => along(2, slope),
                Way::BendingZ => along(1, -slope),
            })
            .collect(),
        gammas: slender.shortenings_at(x),
    }
}
