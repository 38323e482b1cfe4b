//! Memory with machine code in it, its call, and the tables that it looks up.
#![allow(unsafe_code)]

use crate::functions;
use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, default_libcall_names};
use linkwright_compiler::symbolic::{Orders, Table, Unary};
use linkwright_engine::{REGISTERS, Translated};
use std::sync::{Arc, Mutex};

/// A function of the one argument that code has: the registers.
type Entry = unsafe extern "C" fn(*mut f64);

/// The code of one program.
pub struct Code {
    entry: Entry,
    /// What holds the memory of `entry`.
    module: Mutex<Option<JITModule>>,
    /// The code knows their addresses.
    _tables: Vec<Arc<Table>>,
}

impl Code {
    /// What `translate` makes, with the addresses of the tables in their order. Nothing if it cannot be made.
    ///
    /// `translate` has to define a function of one pointer to [`REGISTERS`] numbers, which reads and writes nothing else, but by the look-ups
    /// of [`look_ups`] at these addresses.
    pub fn new(
        isa: OwnedTargetIsa,
        tables: &[Arc<Table>],
        translate: impl FnOnce(&mut JITModule, &[*const u8]) -> Option<FuncId>,
    ) -> Option<Self> {
        let mut builder = JITBuilder::with_isa(isa, default_libcall_names());
        builder.symbols(Unary::ALL.map(functions::unary));
        builder.symbol(ATAN2, functions::atan2 as *const u8);
        builder.symbols(look_ups());
        let mut module = JITModule::new(builder);
        let addresses: Vec<*const u8> = tables.iter().map(|table| Arc::as_ptr(table).cast()).collect();
        let made = translate(&mut module, &addresses).filter(|_| module.finalize_definitions().is_ok());
        let Some(function) = made else {
            // SAFETY: nothing of the module has been called, nor is it known anywhere else.
            unsafe { module.free_memory() };
            return None;
        };
        // SAFETY: the function has been defined with this signature, and its memory lives as long as the module.
        let entry =
            unsafe { std::mem::transmute::<*const u8, Entry>(module.get_finalized_function(function)) };
        Some(Code { entry, module: Mutex::new(Some(module)), _tables: tables.to_vec() })
    }
}

impl Translated for Code {
    #[inline]
    fn run(&self, registers: &mut [f64; REGISTERS]) {
        // SAFETY: the code reads and writes this array at numbers of 16 bits, which it has as many entries as there are of, and tables
        // that are kept beside it.
        unsafe { (self.entry)(registers.as_mut_ptr()) }
    }
}

impl Drop for Code {
    fn drop(&mut self) {
        let module = self.module.get_mut().unwrap_or_else(|poisoned| poisoned.into_inner()).take();
        if let Some(module) = module {
            // SAFETY: who could call the code borrows it from here.
            unsafe { module.free_memory() };
        }
    }
}

/// The names of functions of two and more arguments.
pub const ATAN2: &str = "angle_of";
pub const CELL: &str = "cell_of_table";
pub const PIECE: &str = "piece_of_table";
pub const PATCH: &str = "patch_of_table";

fn look_ups() -> [(&'static str, *const u8); 3] {
    [(CELL, cell as *const u8), (PIECE, piece as *const u8), (PATCH, patch as *const u8)]
}

/// # Safety
/// `table` is that of a table which lives: all that [`Code::new`] hands out.
unsafe extern "C" fn cell(table: *const Table, x: f64) -> f64 {
    // SAFETY: of the caller.
    unsafe { &*table }.cell(x)
}

/// # Safety
/// As [`cell`].
unsafe extern "C" fn piece(table: *const Table, order: i64, cell: f64, x: f64) -> f64 {
    // SAFETY: of the caller.
    unsafe { &*table }.piece(order as u8, cell, x)
}

/// # Safety
/// As [`cell`].
unsafe extern "C" fn patch(table: *const Table, first: i64, second: i64, cell: f64, x: f64, y: f64) -> f64 {
    // SAFETY: of the caller.
    unsafe { &*table }.patch(Orders::new(first as u8, second as u8), cell, x, y)
}
