//! What a language has to say of itself so that [`Printer`](super::Printer) can write programs in it: constants, operations,
//! declarations, and how values go between the functions that a long program is cut into.
//!
//! Heads of functions and what becomes of the results are no part of it. They follow from
//! [`FUNCTIONS`](crate::functions::FUNCTIONS), by the conventions of the code that calls: `rust.rs` and `function.rs` have those of the
//! runtime.

use crate::functions::{Argument, Signature};
use crate::schedule::Instruction;
use crate::symbolic::Table;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::sync::Arc;

/// An operation is its operands with texts between: what stands before each of them, and behind the last.
///
/// ```text
/// a + b              ["", " + ", "", ""]
/// R::select(m, a, b) ["R::select(", ", ", ", ", ")"]
/// ```
pub type Spelling = [&'static str; 4];

/// How a language spells programs. What is appended to `text` is the language's; names are given.
pub trait Dialect {
    /// Words that are no names.
    fn keywords(&self) -> &[&'static str];
    /// Any number, also one that is not finite; it may stand as any operand.
    fn constant(&self, text: &mut String, value: f64);
    /// The texts around the operands, in the order of [`Instruction::operands`]; that behind the last stands directly behind it.
    fn operation(&self, instruction: &Instruction) -> Spelling;
    /// What stands before the first operand of a look-up in a table, which `operation` leaves out.
    fn look_up(&self, text: &mut String, tables: &[Arc<Table>], instruction: &Instruction);
    /// What stands before, in and behind `NAME VALUE` of a new value, which may be a truth value.
    fn declaration(&self, mask: bool) -> [&'static str; 3];
    /// A line of comment.
    fn comment(&self, text: &mut String, line: &str);
    /// An entry of an argument that is no number. `within`: the argument that brings it along, as the state brings q; `at`: its index, or
    /// what the user calls it where it is a field.
    fn entry(&self, text: &mut String, within: Option<Argument>, argument: Argument, at: &str);

    /// Declares a table of numbers.
    fn table(&self, text: &mut String, table: usize, numbers: &[f64]);
    /// One of them.
    fn number(&self, text: &mut String, table: usize, at: &str);
    /// Declares the lists of results that are no arguments, where results are written one by one.
    fn results(&self, _text: &mut String, _signature: &Signature) {}
    /// A result of a group. `at`: its entry; `place`: where it stands in that.
    fn result(&self, text: &mut String, signature: &Signature, group: usize, at: &str, place: &str) {
        let name = signature.results[group].name;
        let _ = write!(text, "{name}[{at}]{place}");
    }
    /// Declares an array of so many numbers, in which loops keep what leaves a round.
    fn array(&self, text: &mut String, name: &str, length: usize);
    /// What stands before the first value of a variable.
    fn variable(&self, text: &mut String, name: &str);
    /// Head of a loop that counts so many rounds by `i`, from zero.
    fn rounds(&self, text: &mut String, rounds: usize);
    /// Its end.
    fn end_of_rounds(&self, text: &mut String) {
        text.push_str("}\n");
    }

    /// Declares so many values that go from function to function.
    fn slots(&self, text: &mut String, size: usize);
    /// One of them.
    fn slot(&self, text: &mut String, slot: usize);
    /// What stands before and behind what is written to one. They are numbers, so that a truth value is made one.
    fn given(&self, mask: bool) -> [&'static str; 2];
    /// What stands before and behind one where it is read, as a number or as the truth value that it was.
    fn taken(&self, mask: bool) -> [&'static str; 2];
    /// Head of a function for a part of a program, up to the first statement. `reads`: what the part reads of the arguments, or of what
    /// they bring along.
    fn helper(
        &self,
        text: &mut String,
        name: &str,
        arguments: &[Argument],
        reads: &BTreeSet<Argument>,
        slots: usize,
    );
    /// Its end.
    fn end(&self, text: &mut String);
    /// A call of it.
    fn call(&self, text: &mut String, name: &str, arguments: &[Argument], reads: &BTreeSet<Argument>);
    /// A name as the language can have it.
    fn identifier(&self, name: String) -> String {
        name
    }
}
