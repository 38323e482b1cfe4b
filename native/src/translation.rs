//! From a program to a function of Cranelift: one value an instruction, no branch but the selection of values.

use crate::functions;
use crate::machine::{ATAN2, CELL, PATCH, PIECE};
use cranelift_codegen::Context;
use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::{AbiParam, FuncRef, InstBuilder, MemFlagsData, Type, Value, types};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::JITModule;
use cranelift_module::{FuncId, Linkage, Module};
use linkwright_compiler::schedule::{Instruction, Operand, Program};
use linkwright_compiler::symbolic::{Compare, Unary};
use linkwright_engine::REGISTERS;
use std::collections::HashMap;

/// As [`linkwright_runtime::Real::mul_add`] of this build does.
const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

/// Defines the function of a program. Nothing if Cranelift cannot.
pub fn function(
    module: &mut JITModule,
    program: &Program,
    register: &dyn Fn(Operand) -> Option<u16>,
    results: u16,
    tables: &[*const u8],
) -> Option<FuncId> {
    if usize::from(results) + program.outputs.len() > REGISTERS {
        return None;
    }
    let pointer = module.target_config().pointer_type();
    let mut context: Context = module.make_context();
    context.func.signature.params.push(AbiParam::new(pointer));
    let signature = context.func.signature.clone();
    let id = module.declare_function("evaluate", Linkage::Export, &signature).ok()?;
    let mut storage = FunctionBuilderContext::new();
    let mut builder = FunctionBuilder::new(&mut context.func, &mut storage);
    let block = builder.create_block();
    builder.append_block_params_for_function_params(block);
    builder.switch_to_block(block);
    builder.seal_block(block);
    let registers = builder.block_params(block)[0];
    let mut translation = Translation {
        module,
        builder,
        pointer,
        registers,
        register,
        tables,
        values: Vec::with_capacity(program.instructions.len()),
        called: HashMap::new(),
    };
    let mut given_out: HashMap<usize, Vec<usize>> = HashMap::new();
    for (at, output) in (usize::from(results)..).zip(&program.outputs) {
        match *output {
            Operand::Value(value) => given_out.entry(value as usize).or_default().push(at),
            known => translation.give_out(known, at),
        }
    }
    for (index, instruction) in program.instructions.iter().enumerate() {
        let value = translation.instruction(instruction)?;
        translation.values.push(value);
        // At once, so that no value is kept for it.
        for at in given_out.remove(&index).unwrap_or_default() {
            translation.give_out(Operand::Value(index as u32), at);
        }
    }
    translation.builder.ins().return_(&[]);
    let config = translation.module.target_config();
    translation.builder.finalize(config);
    module.define_function(id, &mut context).ok()?;
    Some(id)
}

fn offset(register: usize) -> i32 {
    // At most 2¹⁶ registers of eight bytes.
    8 * register as i32
}

struct Translation<'t> {
    module: &'t mut JITModule,
    builder: FunctionBuilder<'t>,
    pointer: Type,
    /// Where they begin.
    registers: Value,
    register: &'t dyn Fn(Operand) -> Option<u16>,
    tables: &'t [*const u8],
    values: Vec<Value>,
    called: HashMap<&'static str, FuncRef>,
}

impl Translation<'_> {
    fn give_out(&mut self, operand: Operand, at: usize) {
        let value = self.operand(operand);
        self.builder.ins().store(MemFlagsData::trusted(), value, self.registers, offset(at));
    }

    /// What stands in a register is loaded where it is used: an operand in memory costs nothing, a value that is kept does.
    fn operand(&mut self, operand: Operand) -> Value {
        match (operand, (self.register)(operand)) {
            (Operand::Value(value), _) => self.values[value as usize],
            (_, Some(register)) => {
                let at = offset(usize::from(register));
                self.builder.ins().load(types::F64, MemFlagsData::trusted(), self.registers, at)
            }
            (Operand::Constant(value), None) => self.constant(value),
            (Operand::Source(_), None) => unreachable!("every argument stands in registers"),
        }
    }

    fn constant(&mut self, value: f64) -> Value {
        self.builder.ins().f64const(value)
    }

    fn instruction(&mut self, instruction: &Instruction) -> Option<Value> {
        use Instruction::*;
        Some(match *instruction {
            Neg(a) => {
                let a = self.operand(a);
                self.builder.ins().fneg(a)
            }
            Add(a, b) => {
                let [a, b] = [a, b].map(|operand| self.operand(operand));
                self.builder.ins().fadd(a, b)
            }
            Sub(a, b) => {
                let [a, b] = [a, b].map(|operand| self.operand(operand));
                self.builder.ins().fsub(a, b)
            }
            Mul(a, b) => {
                let [a, b] = [a, b].map(|operand| self.operand(operand));
                self.builder.ins().fmul(a, b)
            }
            MulAdd(a, b, c, product, addend) => self.multiply_add([a, b, c], product, addend),
            Div(a, b) => {
                let [a, b] = [a, b].map(|operand| self.operand(operand));
                self.builder.ins().fdiv(a, b)
            }
            Unary(function, a) => self.unary(function, a)?,
            // The second where either is no number, as in the runtime.
            Min(a, b) => self.chosen(FloatCC::LessThan, a, b),
            Max(a, b) => self.chosen(FloatCC::GreaterThan, a, b),
            Atan2(y, x) => {
                let arguments = [y, x].map(|operand| self.operand(operand));
                self.call(ATAN2, &arguments)?
            }
            Compare(comparison, a, b) => {
                let [a, b] = [a, b].map(|operand| self.operand(operand));
                let holds = self.builder.ins().fcmp(condition(comparison), a, b);
                self.mask(holds)
            }
            And(a, b) => {
                let [a, b] = [a, b].map(|operand| self.holds(operand));
                let both = self.builder.ins().band(a, b);
                self.mask(both)
            }
            Or(a, b) => {
                let [a, b] = [a, b].map(|operand| self.holds(operand));
                let either = self.builder.ins().bor(a, b);
                self.mask(either)
            }
            Not(a) => {
                let (a, zero) = (self.operand(a), self.constant(0.0));
                let not = self.builder.ins().fcmp(FloatCC::Equal, a, zero);
                self.mask(not)
            }
            Select(mask, then, otherwise) => {
                let mask = self.holds(mask);
                let [then, otherwise] = [then, otherwise].map(|operand| self.operand(operand));
                self.builder.ins().select(mask, then, otherwise)
            }
            Cell(table, x) => {
                let arguments = [self.table(table), self.operand(x)];
                self.call(CELL, &arguments)?
            }
            Piece(table, orders, cell, x) => {
                let order = self.number(orders.first());
                let arguments = [self.table(table), order, self.operand(cell), self.operand(x)];
                self.call(PIECE, &arguments)?
            }
            Patch(table, orders, cell, x, y) => {
                let orders = [orders.first(), orders.second()].map(|order| self.number(order));
                let [first, second] = orders;
                let [cell, x, y] = [cell, x, y].map(|operand| self.operand(operand));
                let table = self.table(table);
                self.call(PATCH, &[table, first, second, cell, x, y])?
            }
        })
    }

    fn multiply_add(&mut self, operands: [Operand; 3], product: bool, addend: bool) -> Value {
        let [a, b, c] = operands.map(|operand| self.operand(operand));
        if FUSED {
            let a = if product { self.builder.ins().fneg(a) } else { a };
            let c = if addend { self.builder.ins().fneg(c) } else { c };
            return self.builder.ins().fma(a, b, c);
        }
        // A sign changes no rounding.
        let ab = self.builder.ins().fmul(a, b);
        match (product, addend) {
            (false, false) => self.builder.ins().fadd(ab, c),
            (false, true) => self.builder.ins().fsub(ab, c),
            (true, false) => self.builder.ins().fsub(c, ab),
            (true, true) => {
                let minus = self.builder.ins().fneg(ab);
                self.builder.ins().fsub(minus, c)
            }
        }
    }

    fn unary(&mut self, function: Unary, a: Operand) -> Option<Value> {
        let a = self.operand(a);
        Some(match function {
            Unary::Reciprocal => {
                let one = self.constant(1.0);
                self.builder.ins().fdiv(one, a)
            }
            Unary::Sqrt => self.builder.ins().sqrt(a),
            Unary::Abs => self.builder.ins().fabs(a),
            _ => self.call(functions::unary(function).0, &[a])?,
        })
    }

    /// a where it compares like this with b, else b.
    fn chosen(&mut self, condition: FloatCC, a: Operand, b: Operand) -> Value {
        let [a, b] = [a, b].map(|operand| self.operand(operand));
        let first = self.builder.ins().fcmp(condition, a, b);
        self.builder.ins().select(first, a, b)
    }

    /// Whether a mask holds.
    fn holds(&mut self, mask: Operand) -> Value {
        let (mask, zero) = (self.operand(mask), self.constant(0.0));
        self.builder.ins().fcmp(FloatCC::NotEqual, mask, zero)
    }

    /// 1 or 0.
    fn mask(&mut self, holds: Value) -> Value {
        let (one, zero) = (self.constant(1.0), self.constant(0.0));
        self.builder.ins().select(holds, one, zero)
    }

    fn table(&mut self, number: u16) -> Value {
        let address = self.tables[usize::from(number)].addr() as i64;
        self.builder.ins().iconst(self.pointer, address)
    }

    fn number(&mut self, number: u8) -> Value {
        self.builder.ins().iconst(types::I64, i64::from(number))
    }

    fn call(&mut self, name: &'static str, arguments: &[Value]) -> Option<Value> {
        let function = match self.called.get(name) {
            Some(function) => *function,
            None => {
                let mut signature = self.module.make_signature();
                let kinds = arguments.iter().map(|value| self.builder.func.dfg.value_type(*value));
                signature.params = kinds.map(AbiParam::new).collect();
                signature.returns.push(AbiParam::new(types::F64));
                let id = self.module.declare_function(name, Linkage::Import, &signature).ok()?;
                let function = self.module.declare_func_in_func(id, self.builder.func);
                self.called.insert(name, function);
                function
            }
        };
        let call = self.builder.ins().call(function, arguments);
        Some(self.builder.inst_results(call)[0])
    }
}

fn condition(comparison: Compare) -> FloatCC {
    match comparison {
        Compare::Less => FloatCC::LessThan,
        Compare::LessEqual => FloatCC::LessThanOrEqual,
        Compare::Equal => FloatCC::Equal,
    }
}
