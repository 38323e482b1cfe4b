//! A small multiplicative hasher. Hash-consing is most of the work of building a graph, and compilers of user
//! crates run this code unoptimised, where the standard library's SipHash is the larger part of the cost.

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
