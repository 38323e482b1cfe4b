//! A small multiplicative hasher, and a table of what was seen. Hash-consing is most of the work of building a graph, and compilers of user
//! crates run this code unoptimised, where the standard library's SipHash and the layers of its tables are the larger part of the cost.

use std::hash::{BuildHasherDefault, Hasher};

#[derive(Default)]
pub struct FastHasher(u64);

/// Golden-ratio multiplier, as in Fibonacci hashing (Knuth, The Art of Computer Programming 3, section 6.4).
const MULTIPLIER: u64 = 0x9E37_79B9_7F4A_7C15;

/// A hash and a further word.
pub fn mix(hash: u64, word: u64) -> u64 {
    (hash.rotate_left(5) ^ word).wrapping_mul(MULTIPLIER)
}

impl FastHasher {
    fn mix(&mut self, word: u64) {
        self.0 = mix(self.0, word);
    }
}

impl Hasher for FastHasher {
    fn finish(&self) -> u64 {
        self.0 ^ (self.0 >> 29)
    }
    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.mix(u64::from(*byte));
        }
    }
    fn write_u8(&mut self, word: u8) {
        self.mix(u64::from(word));
    }
    fn write_u32(&mut self, word: u32) {
        self.mix(u64::from(word));
    }
    fn write_u64(&mut self, word: u64) {
        self.mix(word);
    }
    fn write_isize(&mut self, word: isize) {
        self.mix(word as u64);
    }
    fn write_usize(&mut self, word: usize) {
        self.mix(word as u64);
    }
}

pub type FastHash = BuildHasherDefault<FastHasher>;

/// Finds things that are numbered from 0 by their hashes: open addresses (Knuth, *The Art of Computer Programming* 3, section 6.4,
/// algorithm L). The things themselves are with the caller.
#[derive(Clone, Debug, Default)]
pub struct Known {
    /// The upper half of a hash, and the number; at most half of them are taken.
    slots: Vec<(u32, u32)>,
    count: u32,
}

impl Known {
    const FREE: (u32, u32) = (0, u32::MAX);
    const FEWEST: usize = 64;

    /// The number of what has this hash and is the same; `None` if there is none.
    pub fn get(&self, hash: u64, is_same: impl Fn(u32) -> bool) -> Option<u32> {
        let upper = (hash >> 32) as u32;
        let mask = self.slots.len().checked_sub(1)?;
        let mut at = upper as usize & mask;
        loop {
            let (own, number) = self.slots[at];
            if number == Self::FREE.1 {
                return None;
            }
            if own == upper && is_same(number) {
                return Some(number);
            }
            at = (at + 1) & mask;
        }
    }

    /// Gives what has this hash the next number; nothing that is the same may be there.
    pub fn add(&mut self, hash: u64) -> u32 {
        if 2 * self.count as usize >= self.slots.len() {
            let room = (2 * self.slots.len()).max(Self::FEWEST);
            for slot in std::mem::replace(&mut self.slots, vec![Self::FREE; room]) {
                if slot.1 != Self::FREE.1 {
                    self.put(slot);
                }
            }
        }
        let number = self.count;
        self.put(((hash >> 32) as u32, number));
        self.count += 1;
        number
    }

    fn put(&mut self, slot: (u32, u32)) {
        let mask = self.slots.len() - 1;
        let mut at = slot.0 as usize & mask;
        while self.slots[at].1 != Self::FREE.1 {
            at = (at + 1) & mask;
        }
        self.slots[at] = slot;
    }
}

#[cfg(test)]
mod tests {
    use super::{Known, mix};

    #[test]
    fn what_was_seen_is_found_again_and_nothing_else() {
        // Of few hashes, so that many things share one.
        let hash = |thing: u64| mix(0, thing % 50);
        let (mut known, mut things) = (Known::default(), Vec::new());
        let number = |known: &Known, things: &[u64], thing| {
            known.get(hash(thing), |number| things[number as usize] == thing)
        };
        for thing in (0..1000).map(|k| 7 * k) {
            assert_eq!(number(&known, &things, thing), None);
            assert_eq!(known.add(hash(thing)) as usize, things.len());
            things.push(thing);
        }
        for (at, thing) in things.iter().enumerate() {
            assert_eq!(number(&known, &things, *thing), Some(at as u32));
            assert_eq!(number(&known, &things, *thing + 1), None);
        }
    }
}
