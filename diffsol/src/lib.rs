//! Linkwright's mechanisms as problems of [`diffsol`](https://docs.rs/diffsol): BDF, ESDIRK and explicit Runge–Kutta
//! methods by others integrate the same equations of motion, so that nobody needs this project's solvers to trust its
//! equations.
//!
//! ```
//! use linkwright::{AssembleExt, mechanism};
//! use linkwright_diffsol::{Method, Settings, exact_problem, problem, sensitivities, solve};
//!
//! mechanism! {
//!     /// A pendulum with a motor.
//!     pub planar Pendulum {
//!         param load [kg] = 1 in 0.1..10;
//!         input drive [N*m];
//!         gravity [m/s^2] = (0, -9.81);
//!         body arm { mass [kg] = load; inertia [kg*m^2] = 0; center [m] = (1, 0); }
//!         joint pivot: revolute(ground(0, 0) [m], arm.origin);
//!         force motor: torque(pivot) = drive;
//!         start   { pivot.angle [deg] = -90; pivot.rate [rad/s] = 0; }
//!         expect  { degrees_of_freedom = 1; }
//!         options { emit = (tangent); }
//!         output x [m] = arm.center.x;
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let model = Pendulum::default();
//! let start = model.assemble(&Pendulum::START)?;
//! let drive = |time: f64, _: &_| PendulumInputs { drive: time.sin() };
//! let settings = Settings::default();
//!
//! // Any mechanism; its Jacobian by differences.
//! let plain = problem(&model, 0.0, &start, drive, &settings)?;
//! let states = solve(&plain, Method::Tsit45, &[0.5, 1.0])?;
//!
//! // A mechanism that emits its tangent: its Jacobian exact, and derivatives of the motion by the parameters.
//! let exact = exact_problem(&model, 0.0, &start, drive, &settings)?;
//! let (same, derivatives) = sensitivities(&exact, Method::Bdf, &[0.5, 1.0])?;
//! assert!((states[1].v[0] - same[1].v[0]).abs() < 1e-5);
//! assert!(derivatives[1][0].v[0].is_finite()); // of the rate at 1 s, by the load
//! # Ok(())
//! # }
//! ```
//! A [`Problem`] is `diffsol`'s own `OdeSolverProblem`: its solvers, options, checkpoints and interpolation are all there,
//! and [`Equations::state`] reads the mechanism's state from any of its vectors. [`solve`] and [`sensitivities`] are the usual
//! case.
//!
//! # The unknowns
//! y = (positions, velocities, internal states). Positions are no vector space; a general solver needs one. So an orientation is integrated
//! as the numbers that hold it:
//!
//! | coordinate | in y | its rate |
//! |---|---|---|
//! | linear x | x | v |
//! | pair (c, s) | c, s | (−s ω, c ω) + κ/2 (1 − c² − s²) (c, s) |
//! | quaternion p | w, x, y, z | ½ p ⊗ (0, ω) + κ/2 (1 − p·p) p |
//! | multi-turn angle | the angle less the whole turns it had at the start | Σ weight v |
//!
//! then v, with v̇ of M v̇ + Dᵀ λ = Q, D v̇ = γ − 2α (D v − ν) − β² Φ, then z with its own ż; gates that a definition holds are live, those of each state. v̇ is evaluated with the orientations brought to length
//! one, so a length that has drifted by the solver's error changes nothing else; [`Settings::length_rate`] is κ. States that
//! are given back have length one. They satisfy the constraints to the solver's tolerance and as Baumgarte's terms keep
//! them, not to rounding: `model.project(time, &state)` brings them there.
//!
//! # Derivatives
//! With [`problem`] the derivatives of v̇ and ż are central differences along increments of the coordinates. With
//! [`exact_problem`] they are exact ([`linkwright::Tangent`]), Baumgarte's terms included; only what the inputs' function does with the
//! state is differenced. In both, a multi-turn angle moves with the orientations it counts, so the Jacobian is that along
//! motions, not by an angle alone.
//!
//! Forward sensitivities ([`sensitivities`], or `diffsol`'s own `…_sens` solvers) are by all parameters of the mechanism, with
//! the phases of couplings held. The start moves with the parameters as little as the constraints admit: in the norm of M, the
//! velocities likewise. The values of the parameters are in the model; `diffsol`'s vector p only counts them, holds zeros,
//! and setting it changes nothing. Adjoint sensitivities, outputs, events and mass matrices are not handed over.
//!
//! # Errors
//! A start without accelerations is refused. Later, a solver of `diffsol` knows no error of the equations: where the
//! constraints lose rank or a number is not finite, it is given numbers so large that it rejects the step, and gives up when
//! its steps are too short. [`solve`] then says what happened, by the names of the mechanism; [`Equations::failure`] does for
//! solvers called directly.
#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod coordinates;
mod derivatives;
mod equations;
mod error;
mod settings;
mod solve;

pub use derivatives::{Derivatives, Differences, Exact};
pub use diffsol;
pub use equations::Equations;
pub use error::Error;
pub use linkwright::StateOf;
pub use settings::{Problem, Settings, exact_problem, problem};
pub use solve::{Method, Sensitivity, sensitivities, solve};
