//! The generic solver that [Linkwright](https://docs.rs/linkwright) is compared with: the same definition as data, absolute
//! coordinates, equations assembled while the program runs, and linear systems solved by [`faer`](https://docs.rs/faer).
//!
//! A model of Linkwright carries its definition as JSON text, `Model::DEFINITION`: what was written, nothing converted. This package
//! rebuilds the mechanism from that text alone, without Linkwright's compiler and runtime, as a general multibody program does
//! it. It is the honest other side of every statement about what code that is written for one mechanism saves, and an
//! independent derivation of the same accelerations, with which all shipped models are tested.
//!
//! ```
//! use linkwright_generic::{BodyMotion, Formulation, Mechanism};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let definition = r#"{
//!   "linkwright": 1, "kind": "planar", "name": "Pendulum",
//!   "constants": [], "inputs": [],
//!   "parameters": [{"name": "length", "unit": "m", "value": {"number": "2"}, "min": {"number": "0.1"}, "max": null}],
//!   "gravity": {"unit": "m/s^2", "value": [{"number": "0"}, {"number": "-9.81"}]},
//!   "bodies": [{"name": "bob", "kind": "particle", "properties": {"mass": {"unit": "kg", "value": {"number": "3"}}}}],
//!   "joints": [{"name": "string", "kind": "distance",
//!               "first": {"ground": [{"number": "0"}, {"number": "0"}], "unit": "m"}, "second": {"place": "bob.center"},
//!               "length": {"unit": null, "value": {"name": "length"}}}],
//!   "constraints": [], "drivers": [], "loads": []
//! }"#;
//! let mut pendulum = Mechanism::from_definition(definition)?;
//! pendulum.set_parameter("length", 1.0)?;
//!
//! // Level, at rest: λ is zero and the bob begins to fall.
//! let mut state = pendulum.origin();
//! pendulum.set_body(&mut state, "bob", &BodyMotion { position: [1.0, 0.0, 0.0], ..BodyMotion::default() })?;
//! let (mut a, mut lambda) = ([0.0; 2], [0.0; 1]);
//! pendulum.acceleration(0.0, &state.q, &state.v, &[], Formulation::Lagrange, &mut a, &mut lambda)?;
//! assert!(a[0].abs() < 1e-12 && (a[1] + 9.81).abs() < 1e-12);
//!
//! // At the bottom ½ v² = g l, and the string has kept its length.
//! pendulum.simulate(0.0, &mut state, |_, _| Vec::new(), Formulation::Projected, 1e-3, 592)?;
//! assert!((state.v[0] + (2.0 * 9.81_f64).sqrt()).abs() < 1e-4);
//! assert!(pendulum.residual(0.592, &state)?[0] < 1e-12);
//! # Ok(())
//! # }
//! ```
//!
//! # Equations
//! Every body is free: the coordinates are its centre of mass and its angle, in space its Euler parameters with ω in body axes
//! ([`State`]). Joints, couplings and drivers are rows Φ(t, q) = 0 with Φ̇ = D v − ν, and
//!
//! ```text
//! [ M  Dᵀ ] [ v̇ ]   [ Q ]
//! [ D  0  ] [ λ ] = [ γ ],    γ = ν̇ − Ḋ v
//! ```
//!
//! is assembled and factorised as a whole at each evaluation ([`Algebra`]): dense for few unknowns, sparse for many, with a
//! symbolic analysis that is made once. M is constant and of blocks; Q has gravity, loads and −ω × J ω. D and γ of
//! joints are the analytic formulas of E. J. Haug, *Computer Aided Kinematics and Dynamics of Mechanical Systems* (1989), ch. 3 and 9, and
//! P. E. Nikravesh, *Computer-Aided Analysis of Mechanical Systems* (1988); those of expressions come from forward differentiation along the
//! motion, to second order. Formulations and steps are in [`Formulation`], [`Mechanism::project`] and [`Mechanism::step`]. All
//! values are in SI units.
//!
//! # Rows that repeat others
//! Where the definition says `redundant = drop` or `keep`, rows may repeat others, as in Bricard's mechanism. None is dropped here:
//! the system is solved with a small compliance of the rows, again and again with the same factors, until what it lacks
//! is gone (the proximal form of the augmented Lagrangian). Accelerations are then exact and λ is that of least norm; rows that
//! contradict one another, as drift makes them under Baumgarte's terms, are met as nearly as they can be together. In all other
//! definitions rows are taken to be independent; where they lose rank, as at a change point, the answer is [`Error::Singular`].
//!
//! # What is there
//! All bodies, joints, couplings, equations, drivers, loads, tables, internal states and functions of the language, in plane and space.
//! Refused by name ([`DefinitionError::NotThereYet`]) are rates of internal states that name reactions of joints, tensions or powers of
//! drivers, lines of the ground that move, cables whose length is of positions and inputs at once, bodies with the modes of a file, friction in joints that yield,
//! memories and events, joints on cams, and rigid contacts. Outputs, `start`
//! and `expect` of a definition are not read: a state is given body by body.
//!
//! `cargo bench -p linkwright-generic` measures what it takes beside the emitted code.
#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod beam;
mod body;
mod bristles;
mod coordinates;
mod definition;
mod energy;
mod error;
mod evaluation;
mod expression;
mod friction;
mod json;
mod kinematics;
mod law;
mod load;
mod mechanism;
mod mesh;
mod motion;
mod number;
mod passes;
mod penalty;
mod quantity;
mod reading;
mod row;
mod rubbing;
mod slopes;
mod solver;
mod system;
mod table;
mod units;
mod vector;

pub use body::BodyMotion;
pub use error::{DefinitionError, Error};
pub use mechanism::{Formulation, Mechanism, State};
pub use solver::Algebra;
