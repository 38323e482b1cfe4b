//! Machine code in place of the interpreter: what a package that makes it has to give. `linkwright-native` is one.

use linkwright_compiler::schedule::{Operand, Program};

/// So many numbers are in the registers that a function finds its arguments in and leaves its results in.
pub const REGISTERS: usize = 1 << 16;

/// Makes machine code of programs, of each when it is first called.
pub trait Translator: Send + Sync {
    /// The code of a program, or nothing if it cannot be made: the program is interpreted then.
    ///
    /// The registers hold the arguments where `register` says, and constants if it says so; results are left from register `results` on, one after another, and no other
    /// register is written. Each is less than [`REGISTERS`].
    fn translate(
        &self,
        program: &Program,
        register: &dyn Fn(Operand) -> Option<u16>,
        results: u16,
    ) -> Option<Box<dyn Translated>>;
}

/// The machine code of one program.
pub trait Translated: Send + Sync {
    /// Computes the results from the arguments.
    fn run(&self, registers: &mut [f64; REGISTERS]);
}
