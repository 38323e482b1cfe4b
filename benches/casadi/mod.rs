//! C code written by CasADi, loaded at run time: `generate.py` says what it computes.
//!
//! Without the environment variable `LINKWRIGHT_CASADI`, a folder of shared libraries, there is no peer. Where this bench is compiled
//! for a processor with fused multiply-adds, the peers are those that gcc has compiled for this processor.

use super::harness::largest;
use super::harness::library::Library;
use std::ffi::{c_int, c_void};
use std::path::PathBuf;

/// CasADi's calling convention.
type Function =
    unsafe extern "C" fn(*const *const f64, *mut *mut f64, *mut i64, *mut f64, *mut c_void) -> c_int;
type WorkSize = unsafe extern "C" fn(*mut i64, *mut i64, *mut i64, *mut i64) -> c_int;

/// A state in a peer's coordinates: angles, rates, and accelerations as this project computes them.
pub type Turns = [Vec<f64>; 3];

/// Angles, rates and angular accelerations of the bodies of a mechanism in the plane, in the order of its peers: as
/// defined, couplers last.
macro_rules! bodies {
    ($model:path) => {
        |model: &$model, state: &State<_, _>, a: &_| {
            let motions = model.motions(0.0, &state.q, &state.v, a);
            let mut order: Vec<usize> = (0..motions.len()).collect();
            order.sort_by_key(|at| <$model>::BODIES[*at].starts_with("coupler"));
            let angles =
                order.iter().map(|at| motions[*at].orientation[1].atan2(motions[*at].orientation[0]));
            let rates = order.iter().map(|at| motions[*at].rate);
            let accelerations = order.iter().map(|at| motions[*at].angular_acceleration);
            [angles.collect(), rates.collect(), accelerations.collect()]
        }
    };
}

/// A loaded function, its states and its memory.
#[allow(dead_code)]
pub struct Peer {
    pub name: String,
    /// How many `generate.py` says it has: additions, multiplications, divisions, square roots, sines and cosines.
    pub operations: String,
    function: Function,
    /// With cosines and sines for the angles where it takes them.
    states: Vec<Turns>,
    gains: [f64; 2],
    /// For arms, whose motors are off.
    torques: Vec<f64>,
    acceleration: Vec<f64>,
    lambda: Vec<f64>,
    integers: Vec<i64>,
    work: Vec<f64>,
}

impl Peer {
    /// The function `name` of `name.so`, if there is one, for α = β = `rate`. `convert` gives a state in its coordinates. A
    /// name that ends in `_turns` takes cosine and sine of each angle instead of the angle.
    pub fn open<S>(name: &str, rate: f64, states: &[S], convert: impl Fn(&S) -> Turns) -> Option<Self> {
        let folder = PathBuf::from(std::env::var_os("LINKWRIGHT_CASADI")?);
        let target = if cfg!(target_feature = "fma") { "native" } else { "." };
        let library = Library::open(&folder.join(target).join(format!("{name}.so")))?;
        let operations =
            std::fs::read_to_string(folder.join(format!("{name}.operations"))).unwrap_or_default();
        // SAFETY: both come from a library that `generate.py` has made, with CasADi's signatures.
        let (function, size) = unsafe {
            (library.function::<Function>(name)?, library.function::<WorkSize>(&format!("{name}_work"))?)
        };
        let mut sizes = [0i64; 4];
        let [a, r, i, w] = &mut sizes;
        // SAFETY: four places to write to, as the signature says.
        unsafe { size(a, r, i, w) };
        let mut states: Vec<Turns> = states.iter().map(convert).collect();
        let bodies = states[0][0].len();
        if name.ends_with("_turns") {
            for [angles, ..] in &mut states {
                *angles = angles.iter().flat_map(|angle| [angle.cos(), angle.sin()]).collect();
            }
        }
        Some(Peer {
            name: name.to_string(),
            operations: operations.trim().to_string(),
            function,
            states,
            gains: [2.0 * rate, rate * rate],
            torques: vec![0.0; bodies],
            acceleration: vec![0.0; bodies],
            lambda: vec![0.0; bodies],
            integers: vec![0; sizes[2].max(1) as usize],
            work: vec![0.0; sizes[3].max(1) as usize],
        })
    }

    /// One evaluation.
    pub fn call(&mut self, at: usize) {
        let [angles, rates, _] = &self.states[at];
        let arguments = [angles.as_ptr(), rates.as_ptr(), self.gains.as_ptr(), self.torques.as_ptr()];
        self.apply(arguments);
    }

    /// Accelerations at a state that is none of its own.
    #[allow(dead_code)]
    pub fn evaluate(&mut self, angles: &[f64], rates: &[f64]) -> &[f64] {
        let [own, others, _] = &self.states[0];
        assert!(angles.len() == own.len() && rates.len() == others.len(), "a state of {}", self.name);
        self.apply([angles.as_ptr(), rates.as_ptr(), self.gains.as_ptr(), self.torques.as_ptr()]);
        &self.acceleration
    }

    fn apply(&mut self, arguments: [*const f64; 4]) {
        let mut results = [self.acceleration.as_mut_ptr(), self.lambda.as_mut_ptr()];
        // SAFETY: arrays of the sizes that `generate.py` gives the function; λ has fewer entries
        // than there are bodies.
        unsafe {
            (self.function)(
                arguments.as_ptr(),
                results.as_mut_ptr(),
                self.integers.as_mut_ptr(),
                self.work.as_mut_ptr(),
                std::ptr::null_mut(),
            )
        };
        std::hint::black_box((&self.acceleration, &self.lambda));
    }

    /// Largest difference to this project's accelerations, relative to the largest of them at that state.
    pub fn error(&mut self) -> f64 {
        let mut worst = Vec::new();
        for at in 0..self.states.len() {
            self.call(at);
            let own = &self.states[at][2];
            let difference = own.iter().zip(&self.acceleration).map(|(a, b)| (a - b).abs());
            worst.push(largest(difference) / largest(own.iter().map(|a| a.abs())));
        }
        largest(worst.into_iter())
    }
}
