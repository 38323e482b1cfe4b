//! Numbers between 0 and 1 by a linear congruential generator (Knuth's MMIX), the same at every run.

pub struct Random(u64);

impl Random {
    /// Numbers of one case, which other cases do not change.
    pub fn of_case(case: usize) -> Self {
        let mut random = Random(0x9E37_79B9_7F4A_7C15_u64.wrapping_mul(case as u64 + 1));
        (0..4).for_each(|_| {
            random.next();
        });
        random
    }

    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }

    /// 0, …, `count` − 1.
    pub fn index(&mut self, count: usize) -> usize {
        ((self.next() * count as f64) as usize).min(count - 1)
    }
}
