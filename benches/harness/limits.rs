//! What a processor can do at best: bounds on an evaluation from the operations that it has, by a model of the ports.
//!
//! | bound | how it is computed |
//! |---|---|
//! | ports | operations of each kind over the pipes that take them, a division for as many cycles as it occupies one |
//! | latency | the longest path through the program, each operation for as long as its result takes |
//! | front end | 15 bytes of instructions for an operation, which is what was found in machine code, at 16 bytes a cycle where they are more than the 32 kB that are kept decoded or near; nothing below |
//!
//! Evaluations of different states overlap, so that ports and front end bound a bench of throughput, and latency one in which each
//! waits for the one before. Pipes and latencies: A. Fog, *Instruction tables* (2025), Zen 4 and Ice Lake; they are estimates to a tenth.

use linkwright_compiler::compile;
use linkwright_compiler::functions::Function;
use linkwright_compiler::schedule::{Instruction, Operand, Program};
use linkwright_compiler::symbolic::Unary;
use std::hint::black_box;
use std::time::Instant;

/// What a kind of processor does with floating-point numbers.
pub struct Processor {
    pub name: &'static str,
    /// Pipes for × and fused, and further ones for + − and choices; none where the same take all.
    pipes: [f64; 2],
    /// Cycles until the result is there: + ×, fused, ÷ and √.
    latency: [f64; 3],
    /// Cycles for which a ÷ or √ occupies its pipe.
    division: f64,
}

const ZEN: Processor = Processor { name: "Zen", pipes: [2.0, 2.0], latency: [3.0, 4.0, 13.0], division: 5.0 };
const CORE: Processor =
    Processor { name: "Intel Core", pipes: [2.0, 0.0], latency: [4.0, 4.0, 14.0], division: 4.0 };

/// Bytes of instructions for an operation, and what is kept near.
const BYTES: f64 = 15.0;
const NEAR: f64 = 32_768.0;
const STREAMED: f64 = 16.0;

impl Processor {
    /// That of this machine; where it is neither, the one with fewer pipes.
    pub fn here() -> Processor {
        let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        if text.contains("AuthenticAMD") { ZEN } else { CORE }
    }
}

/// Bounds on one evaluation, cycles.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    pub ports: f64,
    pub latency: f64,
    pub front_end: f64,
}

impl Limits {
    /// Of a function of a definition.
    pub fn of(
        source: &str,
        function: impl Fn(&linkwright_compiler::Compiled) -> Function,
        processor: &Processor,
    ) -> Limits {
        let compiled =
            compile(source.parse().expect("the source was tokens"), None).expect("it was compiled before");
        of_program(compiled.programs.get(function(&compiled)), processor)
    }

    /// The larger of the bounds on throughput.
    pub fn throughput(&self) -> f64 {
        self.ports.max(self.front_end)
    }
}

fn of_program(program: &Program, Processor { pipes, latency, division, .. }: &Processor) -> Limits {
    let (mut products, mut sums) = (0.0, 0.0);
    let mut ready = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let takes = match instruction {
            Instruction::Mul(..) => (1.0, 0.0, latency[0]),
            Instruction::MulAdd(..) => (1.0, 0.0, latency[1]),
            Instruction::Div(..) | Instruction::Unary(Unary::Sqrt, _) => (*division, 0.0, latency[2]),
            _ => (0.0, 1.0, latency[0]),
        };
        products += takes.0;
        sums += takes.1;
        let begin = instruction.operands().filter_map(|operand| match operand {
            Operand::Value(value) => Some(ready[value as usize]),
            _ => None,
        });
        ready.push(begin.fold(0.0, f64::max) + takes.2);
    }
    let ports = if pipes[1] > 0.0 {
        f64::max(products / pipes[0], sums / pipes[1])
    } else {
        (products + sums) / pipes[0]
    };
    let bytes = BYTES * program.instructions.len() as f64;
    let front_end = if bytes > NEAR { bytes / STREAMED } else { 0.0 };
    Limits { ports, latency: ready.into_iter().fold(0.0, f64::max), front_end }
}

/// Cycles of a nanosecond now, by a chain of multiplications of whole numbers, each of which waits three cycles for the one before.
pub fn clock() -> f64 {
    const CHAIN: usize = 4096;
    let mut least = f64::INFINITY;
    for _ in 0..200 {
        let begin = Instant::now();
        let mut x = black_box(3_u64);
        for _ in 0..CHAIN {
            // A square has no closed form over a chain, and each waits for the one before.
            x = x.wrapping_mul(x | 5);
        }
        black_box(x);
        least = least.min(begin.elapsed().as_nanos() as f64);
    }
    // The multiplication, and the one cycle of |.
    4.0 * CHAIN as f64 / least
}
