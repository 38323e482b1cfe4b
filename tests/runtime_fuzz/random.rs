//! A small generator of random numbers, and numbers that nobody would give: the same seed gives the same cases on every machine.

/// SplitMix64 (Steele, Lea & Flood 2014).
pub struct Random(u64);

#[allow(dead_code, reason = "each program that includes this takes what it needs")]
impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The numbers of one case of a run.
    pub fn of_case(seed: u64, case: u64) -> Self {
        let mut random = Self(seed);
        Self(random.bits() ^ case.wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `limit`, which is not zero.
    pub fn below(&mut self, limit: usize) -> usize {
        (self.bits() % limit as u64) as usize
    }

    /// True once in `times`.
    pub fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    /// In [−1, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// A positive number of any magnitude from 10^low to 10^high.
    pub fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(low + (high - low) * 0.5 * (self.unit() + 1.0))
    }

    /// What no formula is written for.
    pub fn odd(&mut self) -> f64 {
        const ODD: [f64; 16] = [
            0.0,
            -0.0,
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::MAX,
            f64::MIN,
            f64::MIN_POSITIVE,
            5e-324,
            1e-310,
            -1e-310,
            1e300,
            -1e300,
            1e17,
            -1.0,
            f64::EPSILON,
        ];
        match self.below(20) {
            k if k < ODD.len() => ODD[k],
            _ => self.magnitude(-300.0, 300.0) * self.unit().signum(),
        }
    }

    /// Mostly near `usual`, now and then of another magnitude, seldom odd.
    pub fn near(&mut self, usual: f64) -> f64 {
        match self.below(24) {
            0 => self.odd(),
            1 => usual * self.magnitude(-12.0, 12.0),
            2 => self.unit(),
            3..6 => usual,
            _ => usual * (1.0 + 0.3 * self.unit()),
        }
    }
}
