//! A mechanism as its users have it: names, parameters, states body by body. What is evaluated at a state is in `evaluation`, steps
//! are in `motion`.

use crate::body::BodyMotion;
use crate::coordinates::{Coordinates, Kind, Slot};
use crate::definition::Definition;
use crate::error::{DefinitionError, Error};
use crate::kinematics::Kinematics;
use crate::law::Scratch;
use crate::load::Acts;
use crate::motion::Stages;
use crate::reading::read;
use crate::row::{Equation, Phase};
use crate::solver::Algebra;
use crate::system::System;
use crate::vector::*;
use serde_json::Value;
use std::collections::HashMap;

/// Positions q and velocities v of a [`Mechanism`], absolute coordinates body by body (SI units):
///
/// | body | q | v |
/// |---|---|---|
/// | planar | x, y of the centre of mass, θ over several turns | ẋ, ẏ, ω |
/// | planar particle | x, y | ẋ, ẏ |
/// | beam | x, y of the origin of its frame, θ, modes | ẋ, ẏ, ω, rates of modes |
/// | beam in space | as spatial, of the origin of its frame, then modes | as spatial, then rates of modes |
/// | spatial | x, y, z, Euler parameters (w, x, y, z) | ẋ, ẏ, ż, ω in body axes |
/// | spatial particle | x, y, z | ẋ, ẏ, ż |
///
/// Behind the bodies of space q has the angles of joints over several turns, which only choose whole turns, and behind these the
/// internal states.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// n_q positions.
    pub q: Vec<f64>,
    /// n_v velocities.
    pub v: Vec<f64>,
}

/// What is solved for the accelerations.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum Formulation {
    /// The index-1 equations as they are: M v̇ + Dᵀ λ = Q, D v̇ = γ. The constraints drift.
    #[default]
    Lagrange,
    /// D v̇ = γ − 2α (D v − ν) − β² Φ (Baumgarte 1972).
    Baumgarte {
        /// α, 1/s.
        alpha: f64,
        /// β, 1/s.
        beta: f64,
    },
    /// As `Lagrange`; after each step positions and velocities are put back on the constraints, across them in the norm of M
    /// ([`Mechanism::project`]).
    Projected,
}

/// A mechanism rebuilt from its definition, with the memory that its evaluations need.
///
/// See the [crate's page](crate) for the equations and an example.
#[derive(Debug)]
pub struct Mechanism {
    tree: Value,
    /// Values of parameters that are not their defaults.
    given: HashMap<String, f64>,
    algebra: Algebra,
    pub(crate) friction_passes: Option<usize>,
    pub(crate) definition: Definition,
    pub(crate) coordinates: Coordinates,
    pub(crate) system: System,
    pub(crate) at: Kinematics,
    pub(crate) work: Work,
}

/// Vectors that are written again and again.
#[derive(Clone, Debug, Default)]
pub(crate) struct Work {
    pub upper: Vec<f64>,
    pub lower: Vec<f64>,
    pub delta: Vec<f64>,
    pub mu: Vec<f64>,
    pub projected: State,
    pub stages: Stages,
    pub scratch: Scratch,
}

impl Mechanism {
    /// From the text of a model's `DEFINITION`, version 1, with parameters at their defaults.
    ///
    /// # Errors
    /// What cannot be read, and what is not there yet; the error names the part.
    pub fn from_definition(json: &str) -> Result<Self, DefinitionError> {
        Self::with_algebra(json, Algebra::Auto)
    }

    /// The same with the dense or the sparse factorisation.
    ///
    /// # Errors
    /// As [`from_definition`](Mechanism::from_definition).
    pub fn with_algebra(json: &str, algebra: Algebra) -> Result<Self, DefinitionError> {
        let tree: Value = serde_json::from_str(json)
            .map_err(|error| DefinitionError::Json { message: error.to_string() })?;
        Self::from_tree(tree, HashMap::new(), algebra)
    }

    fn from_tree(
        tree: Value,
        given: HashMap<String, f64>,
        algebra: Algebra,
    ) -> Result<Self, DefinitionError> {
        let mut definition = read(&tree, &given)?;
        let frictions = definition.loads.iter_mut().filter_map(|load| match &mut load.acts {
            Acts::Friction(friction) => Some(friction),
            _ => None,
        });
        frictions.enumerate().for_each(|(index, friction)| friction.index = index);
        let coordinates = Coordinates::new(&definition);
        let beams = definition.bodies.iter().map(|body| body.beam.clone()).collect();
        let system = System::new(&definition, &coordinates, algebra).map_err(|_| {
            DefinitionError::value(&definition.name, "the pattern of the augmented matrix has no factors")
        })?;
        let (n, m) = (coordinates.velocities, definition.rows.len());
        let work = Work {
            upper: vec![0.0; n],
            lower: vec![0.0; m],
            delta: vec![0.0; n],
            mu: vec![0.0; m],
            ..Work::default()
        };
        Ok(Mechanism {
            tree,
            given,
            algebra,
            friction_passes: None,
            definition,
            coordinates,
            system,
            at: Kinematics { beams, ..Kinematics::default() },
            work,
        })
    }

    /// The mechanism's name.
    pub fn name(&self) -> &str {
        &self.definition.name
    }

    /// Whether it moves in space.
    pub fn is_spatial(&self) -> bool {
        self.definition.spatial
    }

    /// Names of the bodies, in the order of q and v.
    pub fn bodies(&self) -> impl Iterator<Item = &str> {
        self.definition.bodies.iter().map(|body| body.name.as_str())
    }

    /// Names of the constraint rows, `joint.row`, in the order of λ.
    pub fn rows(&self) -> impl Iterator<Item = String> {
        self.definition.rows.iter().map(|row| row.name())
    }

    /// Names of the inputs, in the order in which they are given.
    pub fn inputs(&self) -> impl Iterator<Item = &str> {
        self.definition.inputs.iter().map(String::as_str)
    }

    /// Names and values (SI) of the parameters.
    pub fn parameters(&self) -> impl Iterator<Item = (&str, f64)> {
        self.definition.parameters.iter().map(|parameter| (parameter.name.as_str(), parameter.value))
    }

    /// Names of the internal states, in the order in which they end q.
    pub fn internal_states(&self) -> impl Iterator<Item = &str> {
        self.definition.states.iter().map(|state| state.name.as_str())
    }

    /// n_q, counted angles and internal states included.
    pub fn position_count(&self) -> usize {
        self.coordinates.positions
    }

    /// n_v.
    pub fn velocity_count(&self) -> usize {
        self.coordinates.velocities
    }

    /// m, the number of constraint rows.
    pub fn row_count(&self) -> usize {
        self.definition.rows.len()
    }

    /// Gives a parameter a value (SI); everything that follows from it is read again. Phases that were kept stay.
    ///
    /// # Errors
    /// An unknown name, a value out of its bounds, or one with which the definition makes no mechanism; nothing has changed then.
    pub fn set_parameter(&mut self, name: &str, value: f64) -> Result<(), DefinitionError> {
        if !self.definition.parameters.iter().any(|parameter| parameter.name == name) {
            return Err(DefinitionError::unknown(&self.definition.name, name));
        }
        let mut given = self.given.clone();
        given.insert(name.to_string(), value);
        let mut changed = Self::from_tree(self.tree.clone(), given, self.algebra)?;
        for (new, old) in changed.definition.rows.iter_mut().zip(&self.definition.rows) {
            if let (Equation::Sum { phase: new, .. }, Equation::Sum { phase: old @ Phase::Kept(_), .. }) =
                (&mut new.equation, &old.equation)
            {
                *new = *old;
            }
        }
        *self = Mechanism { friction_passes: self.friction_passes, ..changed };
        Ok(())
    }

    /// All bodies at rest at the origin, axes along the world's, internal states at their starts: what [`set_body`](Mechanism::set_body) begins with.
    pub fn origin(&self) -> State {
        State { q: self.coordinates.origin(&self.definition), v: vec![0.0; self.coordinates.velocities] }
    }

    fn body_index(&self, name: &str) -> Result<usize, Error> {
        let found = self.definition.bodies.iter().position(|body| body.name == name);
        found.ok_or_else(|| Error::UnknownName { name: name.to_string() })
    }

    /// Puts a body at a position and orientation and gives it its velocity and ω; accelerations are not read. In the plane the
    /// orientation is `angle`, in space the matrix `orientation`.
    ///
    /// # Errors
    /// An unknown name, lists of other lengths, or a matrix that is no rotation.
    pub fn set_body(&self, state: &mut State, name: &str, motion: &BodyMotion) -> Result<(), Error> {
        let slot = self.coordinates.slots[self.body_index(name)?];
        self.check_state(&state.q, &state.v)?;
        let (q, v) = (&mut state.q[slot.q..], &mut state.v[slot.v..]);
        let linear = if self.definition.spatial { 3 } else { 2 };
        q[..linear].copy_from_slice(&motion.position[..linear]);
        v[..linear].copy_from_slice(&motion.velocity[..linear]);
        match slot.kind {
            Kind::Plane => {
                q[2] = motion.angle;
                v[2] = motion.rate[2];
            }
            Kind::Space => {
                let p = rotation_parameters(&motion.orientation)?;
                q[3..7].copy_from_slice(&p);
                v[3..6].copy_from_slice(&motion.rate);
            }
            Kind::PlaneParticle | Kind::SpaceParticle => {}
        }
        Ok(())
    }

    /// Gives a mode of a beam, `coupler.bending[0]`, its coordinate, m, and its rate, m/s.
    ///
    /// # Errors
    /// An unknown name or lists of other lengths.
    pub fn set_mode(&self, state: &mut State, name: &str, value: f64, rate: f64) -> Result<(), Error> {
        let (slot, mode) = self.mode(name)?;
        self.check_state(&state.q, &state.v)?;
        let [q, v] = slot.modal();
        (state.q[q + mode], state.v[v + mode]) = (value, rate);
        Ok(())
    }

    /// The acceleration of a mode among those of all velocities, m/s².
    ///
    /// # Errors
    /// An unknown name or a list of another length.
    pub fn mode_acceleration(&self, name: &str, a: &[f64]) -> Result<f64, Error> {
        let (slot, mode) = self.mode(name)?;
        check_length("accelerations", a.len(), self.coordinates.velocities)?;
        Ok(a[slot.modal()[1] + mode])
    }

    fn mode(&self, name: &str) -> Result<(Slot, usize), Error> {
        let unknown = || Error::UnknownName { name: name.to_string() };
        let (body, mode) = name.rsplit_once('.').ok_or_else(unknown)?;
        let index = self.body_index(body)?;
        let beam = self.definition.bodies[index].beam.as_ref().ok_or_else(unknown)?;
        Ok((self.coordinates.slots[index], beam.mode(mode).ok_or_else(unknown)?))
    }

    /// The motion of a body, of given accelerations too.
    ///
    /// # Errors
    /// An unknown name or lists of other lengths.
    pub fn body(&mut self, name: &str, state: &State, a: &[f64]) -> Result<BodyMotion, Error> {
        let index = self.body_index(name)?;
        check_length("accelerations", a.len(), self.coordinates.velocities)?;
        self.coordinates.kinematics(0.0, &state.q, &state.v, &mut self.at)?;
        let (frame, slot) = (&self.at.frames[index], self.coordinates.slots[index]);
        let mut motion = BodyMotion {
            position: frame.position,
            orientation: frame.axes,
            angle: frame.angle,
            velocity: frame.velocity,
            rate: turned_back(&frame.axes, frame.spin),
            ..BodyMotion::default()
        };
        let a = &a[slot.v..];
        match slot.kind {
            Kind::Plane => motion.angular_acceleration[2] = a[2],
            Kind::Space => motion.angular_acceleration = [a[3], a[4], a[5]],
            Kind::PlaneParticle | Kind::SpaceParticle => {}
        }
        let linear = if self.definition.spatial { 3 } else { 2 };
        motion.acceleration[..linear].copy_from_slice(&a[..linear]);
        Ok(motion)
    }

    fn check_state(&self, q: &[f64], v: &[f64]) -> Result<(), Error> {
        check_length("positions", q.len(), self.coordinates.positions)?;
        check_length("velocities", v.len(), self.coordinates.velocities)
    }
}

/// The Euler parameters of a rotation matrix.
fn rotation_parameters(matrix: &M3) -> Result<[f64; 4], Error> {
    let p = quaternion_of(matrix).unwrap_or([0.0; 4]);
    let turned = rotation(p);
    let off = matrix.as_flattened().iter().zip(turned.as_flattened()).map(|(a, b)| (a - b).abs());
    // NaN is no rotation either.
    match off.fold(0.0, |most: f64, x| if x <= most { most } else { x }) {
        off if off < 1e-6 => Ok(p),
        value => Err(Error::Value { what: "the distance of a matrix from a rotation", value }),
    }
}

pub(crate) fn check_length(what: &'static str, given: usize, expected: usize) -> Result<(), Error> {
    if given == expected { Ok(()) } else { Err(Error::Length { what, expected, given }) }
}
