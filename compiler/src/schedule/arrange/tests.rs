//! Orders of made-up programs.

use super::*;
use crate::functions::Argument;
use crate::schedule::program::{Instruction, Operand, Program, Source};

const LENGTH: usize = 400;

/// Sources and results so far, as if drawn from a hat.
fn drawn(state: &mut u64, results: usize) -> Operand {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    let drawn = (*state >> 33) as usize % (results + 4);
    match drawn.checked_sub(4) {
        // What came lately is taken more often.
        Some(value) => Operand::Value(value.max(results / 2) as u32),
        None => Operand::Source(Source { argument: Argument::Q, index: drawn as u32 }),
    }
}

fn random(seed: u64) -> Vec<Instruction> {
    let mut state = seed;
    (0..LENGTH)
        .map(|at| {
            let mut next = || drawn(&mut state, at);
            match at % 7 {
                0 => Instruction::Mul(next(), next()),
                1 => Instruction::Div(next(), next()),
                2 => Instruction::Neg(next()),
                3 => {
                    let one = next();
                    Instruction::Mul(one, one)
                }
                _ => Instruction::MulAdd(next(), next(), next(), false, true),
            }
        })
        .collect()
}

fn assert_in_order(stretch: &Stretch, order: &[usize]) {
    let mut sorted = order.to_vec();
    sorted.sort_unstable();
    assert_eq!(sorted, (stretch.start..stretch.end).collect::<Vec<_>>());
    let mut done = vec![false; stretch.end];
    done[..stretch.start].fill(true);
    for index in order {
        assert!(stretch.taken(*index).iter().all(|value| done[*value]), "{index} waits for an operand");
        done[*index] = true;
    }
}

/// Both orders compute everything once, operands first, in the whole and after a front.
#[test]
fn operands_come_first() {
    for seed in 0..50 {
        let instructions = random(seed);
        let kept: Vec<bool> = (0..LENGTH).map(|at| at % 5 == 0).collect();
        for start in [0, 150] {
            let stretch = Stretch::new(&instructions, start, kept.clone());
            for order in [interleave::order(&stretch), fewest_alive::order(&stretch)] {
                assert_in_order(&stretch, &order);
            }
        }
    }
}

/// x₀y₀ + x₁y₁ + …: by longest paths the products run ahead of the sums, which wait for one another; else one product is
/// alive beside the sum.
#[test]
fn a_sum_takes_its_products_one_by_one() {
    let source = |index: usize| Operand::Source(Source { argument: Argument::Q, index: index as u32 });
    let products = (0..LENGTH).map(|at| Instruction::Mul(source(at), source(at + 1)));
    let mut instructions: Vec<Instruction> = products.collect();
    for at in 0..LENGTH - 1 {
        let sum = if at == 0 { 0 } else { instructions.len() as u32 - 1 };
        instructions.push(Instruction::Add(Operand::Value(sum), Operand::Value(at as u32 + 1)));
    }
    let mut kept = vec![false; instructions.len()];
    kept[instructions.len() - 1] = true;
    let stretch = Stretch::new(&instructions, 0, kept);
    assert_eq!(stretch.most_alive(&fewest_alive::order(&stretch)), 2);
    assert!(stretch.most_alive(&interleave::order(&stretch)) > LENGTH / 2);
    assert_eq!(order(&stretch), fewest_alive::order(&stretch));
}

/// Values that are needed behind a front stay alive there, whichever program needs them.
#[test]
fn what_is_needed_later_is_kept() {
    let instructions = random(7);
    let outputs = vec![Operand::Value(3), Operand::Value(LENGTH as u32 - 1)];
    let program = Program { instructions, outputs, ..Program::default() };
    let needed = needed_after(&program, 200);
    assert!(needed[3]);
    for (value, needed) in needed.iter().enumerate() {
        let mut later = program.instructions[200..].iter().flat_map(Instruction::operands);
        assert_eq!(*needed, value == 3 || later.any(|taken| taken == Operand::Value(value as u32)));
    }
    // A front needs all that it keeps at its end.
    let kept = needed.iter().filter(|kept| **kept).count();
    let front = Stretch::new(&program.instructions, 0, needed);
    assert!(front.most_alive(&fewest_alive::order(&front)) >= kept);
}
