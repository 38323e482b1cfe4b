//! Machine code for mechanisms whose definition is read while the program runs.
//!
//! ```
//! use linkwright_compiler::compile;
//! use linkwright_engine::Engine;
//! use linkwright_native::Native;
//! use linkwright_runtime::{AssembleExt, Simulation};
//! use std::sync::Arc;
//!
//! let pendulum = "
//!     planar Pendulum {
//!         gravity [m/s^2] = (0, -9.81);
//!         rod bob { mass [kg] = 1; length [m] = 0.5; }
//!         joint pivot: revolute(ground(0, 0) [m], bob.start);
//!         start { pivot.angle [deg] = -60; }
//!     }
//! ";
//! let compiled = compile(pendulum.parse().unwrap(), None).unwrap();
//! let engine: Engine = Engine::translated(&compiled, Arc::new(Native::new().unwrap())).unwrap();
//! let start = engine.assemble(&engine.start()).unwrap();
//! let mut simulation = Simulation::new(&engine, start).constant(engine.no_inputs()).step(1e-3);
//! let energy = simulation.energy();
//! simulation.advance_until(1.0).unwrap();
//! assert!((simulation.energy() - energy).abs() < 1e-8);
//! ```
//!
//! [`Native`] is a [`Translator`] of the engine on [Cranelift](https://cranelift.dev). A function is translated when it is first called, in
//! one pass over its instructions; what a run never asks for costs nothing. Numbers are those of the interpreter, to the bit: sines and
//! look-ups of tables are calls of the same functions, and products and sums are fused where the interpreter of this build fuses them, never
//! elsewhere.
//!
//! All `unsafe` of the package is in one file: what keeps the memory of the code, calls it, and hands it tables.
#![deny(unsafe_code)]
#![warn(missing_docs)]

mod functions;
mod machine;
mod translation;

use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_codegen::settings::{self, Configurable};
use linkwright_compiler::schedule::{Operand, Program};
use linkwright_engine::{Translated, Translator};
use std::fmt;

/// Makes machine code for the processor that it runs on.
pub struct Native {
    isa: OwnedTargetIsa,
}

/// There is no machine code for this processor or system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported(String);

impl fmt::Display for Unsupported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no machine code is made on this processor or system ({}); use the interpreter", self.0)
    }
}

impl std::error::Error for Unsupported {}

impl Native {
    /// Code for the processor that it runs on.
    ///
    /// # Errors
    /// [`Unsupported`].
    pub fn new() -> Result<Self, Unsupported> {
        let mut flags = settings::builder();
        // What is called lies anywhere, and code is at one place for good. Programs are optimised; what is done here once more makes of
        // loads that cost nothing values that are kept.
        for (flag, value) in [("use_colocated_libcalls", "false"), ("is_pic", "false"), ("opt_level", "none")]
        {
            flags.set(flag, value).map_err(|error| Unsupported(error.to_string()))?;
        }
        let host = cranelift_native::builder().map_err(|error| Unsupported(error.to_string()))?;
        let isa = host.finish(settings::Flags::new(flags)).map_err(|error| Unsupported(error.to_string()))?;
        Ok(Native { isa })
    }
}

impl Translator for Native {
    fn translate(
        &self,
        program: &Program,
        register: &dyn Fn(Operand) -> Option<u16>,
        results: u16,
    ) -> Option<Box<dyn Translated>> {
        let translate =
            |module: &mut _, tables: &[_]| translation::function(module, program, register, results, tables);
        Some(Box::new(machine::Code::new(self.isa.clone(), &program.tables, translate)?))
    }
}

impl fmt::Debug for Native {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Native").field("target", &self.isa.triple().to_string()).finish()
    }
}
