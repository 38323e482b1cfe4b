//! Where the law switches: the time is found, no step goes across, and the derivative is carried over.
//!
//! ```text
//! δx⁺ = δx⁻ + (f⁺ − f⁻) n·δx⁻/ġ⁻        g = output − level, n = ∂g/∂x, ġ⁻ its rate before, f = ẋ on either side
//! ```
//! Where the law is continuous f⁺ = f⁻, and nothing jumps. Source: Müller, *Calculation of Lyapunov exponents for dynamic systems with discontinuities*,
//! Chaos, Solitons & Fractals 5 (1995); Leine, Nijmeijer, *Dynamics and Bifurcations of Non-smooth Mechanical Systems* (2004), 7.

use crate::error::PeriodicError;
use crate::flow::{At, Path, Switching, side};
use linkwright::{Tangent, Vector};
use nalgebra::{DMatrix, DVector};

/// How near both sides come to each other, of the period.
const WIDTH: f64 = 1e-11;
/// How much of the way to the switch a step leaves, so that none of its stages goes across.
const LEFT: f64 = 0.02;
/// Bisections of one approach.
const BISECTIONS: u32 = 12;
/// Doublings of the last step.
const DOUBLINGS: u32 = 20;
/// Switchings of a period beyond which it has none.
const MOST: usize = 1000;
/// The step by which ġ is found, of the period.
const ASIDE: f64 = 1e-6;
/// A jump of ẋ below this, of ẋ, is rounding.
const ROUNDING: f64 = 1e-9;

impl<M: Tangent<f64>> Path<'_, M> {
    /// The state just beyond the first switching within a step of size `h` from here, at whose end another side is reached.
    pub(crate) fn cross(&mut self, mut here: At<M>, h: f64) -> Result<At<M>, PeriodicError> {
        let before = self.gaps(&here);
        let mut remaining = h;
        while remaining > WIDTH * self.period {
            let [low, high] = self.bracket(&here, &before, remaining)?;
            let taken = low - LEFT * high;
            remaining = high;
            if taken > 0.0 {
                let step = self.step(&here, taken, self.derivative.is_some())?;
                here = self.accept(&here, step)?;
                remaining -= taken;
            }
        }
        // Rounding may have left the switch a little beyond.
        let mut last = self.step(&here, remaining, self.derivative.is_some())?;
        for _ in 0..DOUBLINGS {
            if self.passes(&before, &last.end) {
                break;
            }
            remaining *= 2.0;
            last = self.step(&here, remaining, self.derivative.is_some())?;
        }
        let beyond = self.accept(&here, last)?;
        self.pass(&here, &beyond)?;
        Ok(beyond)
    }

    fn passes(&self, before: &[f64], there: &At<M>) -> bool {
        self.gaps(there).iter().zip(before).any(|(&after, &before)| side(after) != side(before))
    }

    /// Two steps from here, of which the shorter does not pass a switch and the longer does.
    fn bracket(&self, here: &At<M>, before: &[f64], h: f64) -> Result<[f64; 2], PeriodicError> {
        let [mut low, mut high] = [0.0, h];
        let mut gaps = [self.gaps(here), self.gaps(&self.step(here, h, false)?.end)];
        for bisection in 0..BISECTIONS {
            if high - low <= 0.5 * LEFT * high {
                break;
            }
            // By the chord of the switch that passes first, a little to either side of it in turns, so that both ends close in.
            let share = (gaps[0].iter().zip(&gaps[1]))
                .filter(|(a, b)| side(**a) != side(**b))
                .map(|(a, b)| a / (a - b))
                .fold(1.0, f64::min);
            let aside = if bisection % 2 == 0 { -0.1 * LEFT } else { 0.1 * LEFT };
            let share = if bisection % 4 == 3 { 0.5 } else { (share + aside).clamp(0.01, 0.99) };
            let middle = low + share * (high - low);
            let there = self.step(here, middle, false)?.end;
            let found = self.gaps(&there);
            if found.iter().zip(before).any(|(&after, &before)| side(after) != side(before)) {
                (high, gaps[1]) = (middle, found);
            } else {
                (low, gaps[0]) = (middle, found);
            }
        }
        Ok([low, high])
    }

    /// Notes what switched between two states and carries the derivative over.
    fn pass(&mut self, before: &At<M>, after: &At<M>) -> Result<(), PeriodicError> {
        let gaps = [self.gaps(before), self.gaps(after)];
        let switched: Vec<usize> =
            (0..gaps[0].len()).filter(|&at| side(gaps[0][at]) != side(gaps[1][at])).collect();
        for &at in &switched {
            let switch = self.cycle.switches[at];
            let (output, level) = (switch.output, switch.level);
            if self.switchings.len() >= MOST {
                return Err(PeriodicError::Chatter { time: after.time, output });
            }
            self.switchings.push(Switching { time: after.time, output, level, rising: side(gaps[1][at]) });
        }
        if self.derivative.is_none() {
            return Ok(());
        }
        let (a, left) = self.rates(before, &self.model.zero_v())?;
        let (_, right) = self.rates(after, &a)?;
        // s̈ of the right side is told as its difference already.
        let f = self.model.states().len();
        let jump =
            DVector::from_fn(left.len(), |at, _| if at < 2 * f { right[at] } else { right[at] - left[at] });
        if jump.amax() <= ROUNDING * left.amax() {
            return Ok(());
        }
        // Of switches that pass together, the one that moves evenly there tells when.
        let width = after.time - before.time;
        for &at in &switched {
            let rate = self.gap_rate(before, at)?;
            let expected = gaps[0][at] + rate * width;
            if rate != 0.0 && (gaps[1][at] - expected).abs() <= (rate * width).abs() {
                let normal = self.normal(before, at)?;
                let over = DMatrix::identity(left.len(), left.len()) + &jump * normal.transpose() / rate;
                if let Some(derivative) = &mut self.derivative {
                    *derivative = over * &*derivative;
                }
                break;
            }
        }
        Ok(())
    }

    /// ġ of a switch, on this side of it: by going back a little.
    fn gap_rate(&self, here: &At<M>, switch: usize) -> Result<f64, PeriodicError> {
        let h = ASIDE * self.period;
        let back = |h: f64| Ok(self.gaps(&self.step(here, -h, false)?.end)[switch]);
        let [near, far] = [back(h)?, back(2.0 * h)?];
        Ok((3.0 * self.gaps(here)[switch] - 4.0 * near + far) / (2.0 * h))
    }

    /// ∂g/∂x of a switch.
    fn normal(&self, here: &At<M>, switch: usize) -> Result<DVector<f64>, PeriodicError> {
        let space = self.linearised(here)?.state_space().map_err(PeriodicError::Linearisation)?;
        let size = crate::coordinates::size(self.model);
        let row = &space.c.as_slice()[self.output(switch) * size..][..size];
        Ok(DVector::from_column_slice(row))
    }
}
