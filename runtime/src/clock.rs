//! The clock: the exact sum of the steps taken, read rounded once.
//!
//! Which steps a simulation takes towards the end of a run is `simulation/course.rs`. Nothing here knows a mechanism.

use crate::real::{Real, in_lanes};

/// A step must be at least this part of the distance of neighbouring times: laws of time see the clock rounded, and what stands
/// for a million steps stands for ever.
const LEAST_PART: f64 = 1.0 / 1_048_576.0;

/// A time as an unevaluated sum of three numbers, hi + mid + lo, without overlap: hi is the sum rounded to nearest, mid what that
/// leaves, rounded to nearest, and lo what that leaves.
///
/// Steps are added without error (Knuth's TwoSum: Møller, BIT 5 (1965) 37–50; Knuth, *The Art of Computer Programming* 2, 4.2.2,
/// theorem B), as long as the sum fits into 72 bits in single precision (159 in double), and rounded to that many otherwise: ticks
/// of 10⁻³ s as `f32` has them are exact for 17 000 years. hi + mid alone would be rounded after nine hours. It takes twelve
/// operations a step in the mechanism's own scalar, so that a target without a double-precision unit does not need one; a count of
/// steps would have to be turned into one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Clock<R> {
    terms: [R; 3],
    /// How much the steps so far fall short of the clock, s: where a run ends exactly where it was asked to, less than half a rounding of
    /// its last step. The last step of the next run takes it along.
    owed: R,
}

impl<R: Real> Clock<R> {
    pub const fn at(time: R) -> Self {
        Clock { terms: [time, R::ZERO, R::ZERO], owed: R::ZERO }
    }

    /// The three numbers; what a run is owed is not among them.
    pub fn terms(&self) -> [R; 3] {
        self.terms
    }

    /// The clock of three numbers, if it can be theirs: they are finite, and do not overlap.
    pub fn of_terms(terms: [R; 3]) -> Option<Self> {
        let [hi, mid, lo] = terms;
        let fits = terms.iter().all(|term| term.is_finite()) && hi + mid == hi && mid + lo == mid;
        fits.then_some(Clock { terms, owed: R::ZERO })
    }

    /// The first clock in the lanes of the mask, the second in the others.
    pub fn select(mask: R::Mask, first: Self, second: Self) -> Self {
        let [a, b] = [first.terms, second.terms];
        let terms = [R::select(mask, a[0], b[0]), R::select(mask, a[1], b[1]), R::select(mask, a[2], b[2])];
        Clock { terms, owed: R::select(mask, first.owed, second.owed) }
    }

    /// Writes the clock of one lane.
    pub fn set<S: Real>(&mut self, of: &Clock<S>, put: impl Fn(&mut R, S)) {
        self.terms.iter_mut().zip(of.terms).for_each(|(all, term)| put(all, term));
        put(&mut self.owed, of.owed);
    }

    /// The clock with this function of its terms.
    pub fn map<S: Real>(self, f: impl Fn(R) -> S) -> Clock<S> {
        Clock { terms: self.terms.map(&f), owed: f(self.owed) }
    }

    /// The time, rounded once, s.
    #[inline]
    pub fn time(&self) -> R {
        self.terms[0]
    }

    /// The clock after `seconds` more; or fewer.
    #[inline]
    pub fn after(self, seconds: R) -> Self {
        let [hi, mid, lo] = self.terms;
        let (sum, error) = two_sum(mid, seconds);
        let (hi, mid) = two_sum(hi, sum);
        let terms = if error == R::ZERO && lo == R::ZERO {
            [hi, mid, R::ZERO]
        } else {
            normalised(hi, mid, error, lo)
        };
        Clock { terms, ..self }
    }

    /// Whether this is earlier than the other, exactly.
    #[inline]
    pub fn is_before(&self, other: &Self) -> bool {
        self.terms < other.terms
    }

    /// The time from here to `goal`, rounded once, s.
    #[inline]
    pub fn until(&self, goal: &Self) -> R {
        distance(&self.terms, &goal.terms, R::ZERO).0
    }

    /// The step from here to `goal`, with what is owed taken along, and the clock after it, which stands at `goal`.
    #[inline]
    pub fn step_to(&self, goal: &Self) -> (R, Self) {
        let (size, owed) = distance(&self.terms, &goal.terms, self.owed);
        if size > R::ZERO {
            return (size, Clock { terms: goal.terms, owed });
        }
        // So near that what is owed is more.
        let (size, _) = distance(&self.terms, &goal.terms, R::ZERO);
        (size, Clock { terms: goal.terms, owed: self.owed })
    }
}

/// The least step that moves the clock at `time` for laws of time within a million steps, s: 2⁻²⁰ of the distance of neighbouring
/// times.
pub(crate) fn least_step<R: Real>(time: R) -> R {
    time.abs() * (R::EPSILON * R::from_f64(LEAST_PART))
}

/// a + b, rounded, and what the rounding left out, exactly.
#[inline]
fn two_sum<R: Real>(a: R, b: R) -> (R, R) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// goal − from + more, rounded, and what the rounding left out to a rounding of its own.
#[inline]
fn distance<R: Real>(from: &[R; 3], goal: &[R; 3], more: R) -> (R, R) {
    let (first, off) = two_sum(goal[0], -from[0]);
    let (second, off_second) = two_sum(goal[1], -from[1]);
    let (sum, off_sum) = two_sum(first, second);
    two_sum(sum, off + off_second + off_sum + (goal[2] - from[2]) + more)
}

/// hi + mid + error + lo without overlap.
#[cold]
fn normalised<R: Real>(hi: R, mid: R, error: R, lo: R) -> [R; 3] {
    let (mid, error) = two_sum(mid, error);
    let (mid, lo) = two_sum(mid, error + lo);
    let (hi, mid) = two_sum(hi, mid);
    let (mid, lo) = two_sum(mid, lo);
    // Half way between two numbers hi is the even one; lo then says on which side of the middle the sum is.
    let twice = mid + mid;
    let is_other = ((hi + twice) - hi).equal(twice) & (lo * mid.sign()).greater(R::ZERO);
    if R::any(is_other) {
        return [in_lanes(is_other, hi + twice, hi), in_lanes(is_other, -mid, mid), lo];
    }
    [hi, mid, lo]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A number as a multiple of 2⁻¹⁰⁰, exactly.
    fn units(x: f64) -> i128 {
        let unit = libm::pow(2.0, -100.0);
        let (mantissa, exponent) = libm::frexp(x / unit);
        let whole = (mantissa * libm::pow(2.0, 53.0)) as i128;
        let shift = exponent - 53;
        let units = if shift >= 0 { whole << shift } else { whole >> -shift.max(-127) };
        assert!(x == 0.0 || shift >= 0 || units << -shift == whole, "{x:e} is finer");
        units
    }

    fn exact(clock: &Clock<f32>) -> i128 {
        clock.terms.iter().map(|&term| units(term.into())).sum()
    }

    /// The nearest `f32`, ties to even, and whether `found` is it.
    fn is_nearest(found: f32, exact: i128) -> bool {
        let away = |x: f32| (units(x.into()) - exact).abs();
        let (below, above) = (found.next_down(), found.next_up());
        let even = found.to_bits() & 1 == 0;
        [below, above].iter().all(|&other| away(found) < away(other) || (away(found) == away(other) && even))
    }

    /// A small generator: Marsaglia's xorshift.
    fn random(state: &mut u64) -> u64 {
        *state ^= *state << 13;
        *state ^= *state >> 7;
        *state ^= *state << 17;
        *state
    }

    #[test]
    fn sums_are_exact_and_read_rounded_once() {
        let mut seed = 0x9E37_79B9_7F4A_7C15;
        for begin in [0.0_f32, 300.0, 86_400.0, -7.3, 604_800.0] {
            let mut clock = Clock::at(begin);
            let mut sum = exact(&clock);
            for _ in 0..20_000 {
                // From 10⁻⁷ to 1 s.
                let size = (10.0_f32).powi(-((random(&mut seed) % 8) as i32))
                    * (1.0 + (random(&mut seed) >> 40) as f32 * 2e-8);
                clock = clock.after(size);
                sum += units(size.into());
                assert_eq!(exact(&clock), sum);
                assert!(is_nearest(clock.time(), sum), "{clock:?}");
                let [hi, mid, lo] = clock.terms;
                assert!(hi + mid == hi || is_nearest(hi, sum));
                assert!(mid + lo == mid);
            }
        }
    }

    /// hi + ½ rounding, and a little more or less.
    #[test]
    fn ties_are_decided_by_what_is_left() {
        let half = f32::EPSILON / 2.0;
        for (hi, even) in [(1.0_f32, true), (1.0 + f32::EPSILON, false)] {
            for little in [f32::EPSILON * f32::EPSILON / 16.0, -f32::EPSILON * f32::EPSILON / 16.0, 0.0] {
                let clock = Clock::at(hi).after(little).after(half);
                let up = little > 0.0 || (little == 0.0 && !even);
                let expected = if up { hi.next_up() } else { hi };
                assert_eq!(clock.time(), expected, "{hi} {little:e}: {clock:?}");
                assert_eq!(exact(&clock), units(hi.into()) + units(half.into()) + units(little.into()));
            }
        }
    }

    /// A rest that the last step of a run cannot make is owed to the next, and never lost.
    #[test]
    fn runs_end_where_they_were_asked_to() {
        let mut seed = 42;
        let mut clock = Clock::at(0.0_f32);
        let (mut integrated, mut end) = (0, 0.0_f32);
        for run in 0..2000 {
            end += 1e-3 + (random(&mut seed) % 1000) as f32 * 1e-6;
            let goal = Clock::at(end);
            while clock.is_before(&goal) {
                let left = clock.until(&goal);
                let odd = (random(&mut seed) % 1000) as f32 * 1.234_567e-7 + 1e-6;
                let (size, after) = if left > odd { (odd, clock.after(odd)) } else { clock.step_to(&goal) };
                assert!(size > 0.0 && size <= odd.max(left * 1.000_001));
                integrated += units(size.into());
                clock = after;
            }
            assert_eq!(clock.time(), end);
            let off = units(end.into()) - integrated;
            assert!(off.abs() <= units(f64::from(f32::EPSILON) * 1.3e-4), "run {run}: {off}");
            assert!((off - units(clock.owed.into())).abs() < 1 << 36, "{off} {clock:?}");
        }
    }

    #[test]
    fn a_negative_time_comes_to_zero() {
        let (goal, mut clock) = (Clock::at(0.0_f64), Clock::at(-0.3));
        for _ in 0..2 {
            clock = clock.after(0.1);
        }
        let (size, clock) = clock.step_to(&goal);
        assert!((size - 0.1).abs() < 1e-16 && clock.time() == 0.0, "{size} {clock:?}");
    }
}
