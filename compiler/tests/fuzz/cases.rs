//! The cases of a run: each is known by the seed of the run and its number.

use super::random::Random;
use super::seeds::Seed;
use super::{mutate, soup, tokens};

/// The text of a case.
pub fn case(seeds: &[Seed], seed: u64, number: u64) -> String {
    let mut random = Random::of_case(seed, number);
    if random.once_in(12) {
        return tokens::text(&tokens::balanced(soup::soup(&mut random)));
    }
    let mut definition = small(&mut random, seeds).to_vec();
    let other = small(&mut random, seeds);
    mutate::mutate(&mut random, &mut definition, other);
    tokens::text(&tokens::balanced(definition))
}

/// A seed; the smallest of four, since large ones take long and say nothing else, and seldom one with a mistake of its own.
fn small<'a>(random: &mut Random, seeds: &'a [Seed]) -> &'a [String] {
    let wrong = random.once_in(5);
    let mut pick = || loop {
        let seed = &seeds[random.below(seeds.len())];
        if wrong || !seed.is_mistake() {
            break &seed.tokens;
        }
    };
    let mut least = pick();
    for _ in 0..3 {
        let other = pick();
        if other.len() < least.len() {
            least = other;
        }
    }
    least
}
