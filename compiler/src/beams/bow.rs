//! The axis as pictures show it: what it bends away from the places where joints hold it, so many times as large that it is seen.
//!
//! The displacement u(x) of the axis is split in c(x) + r(x): c is the polynomial of least degree that has the values of u where joints hold the
//! beam, and across the axis its slopes where they hold its direction (Newton's divided differences, with repeated places). Shown is c + s r,
//! so that joints stay where they are whatever s is.

use super::{Slender, Way};
use std::sync::Arc;

/// Places along the axis where its largest deflection is looked for.
const PLACES: usize = 48;
/// What is seen of a deflection, of the length: from here on nothing is magnified, and up to here what is less.
const SEEN: f64 = 0.04;
const SHOWN: f64 = 0.1;
/// Of the length: what is less is rounding.
const NOTHING: f64 = 1e-9;

/// A place of the axis that a joint holds.
#[derive(Clone, Copy, Debug)]
pub struct Held {
    /// From the origin of the frame, m.
    pub x: f64,
    /// Whether its direction is held, too.
    pub turns_with: bool,
}

/// How a beam is shown.
#[derive(Clone, Debug)]
pub struct Bow {
    slender: Arc<Slender>,
    terms: Vec<Term>,
    /// Of each place over the length: what each mode moves it across the axis, less what joints share.
    across: Vec<Vec<f64>>,
}

/// What one mode, or the product of two, does to the axis.
#[derive(Clone, Debug)]
struct Term {
    /// One or two.
    modes: Vec<usize>,
    /// Along which axis of the frame.
    axis: usize,
    nodes: Vec<f64>,
    differences: Vec<f64>,
}

impl Bow {
    pub fn new(slender: Arc<Slender>, held: &[Held]) -> Self {
        let is_same = |a: f64, b: f64| (a - b).abs() < 1e-9 * slender.length;
        let mut places: Vec<Held> = Vec::new();
        for at in held {
            match places.iter_mut().find(|known| is_same(known.x, at.x)) {
                Some(known) => known.turns_with |= at.turns_with,
                None => places.push(*at),
            }
        }
        let single = slender.modes.iter().enumerate().map(|(mode, it)| (vec![mode], it.way));
        let double = slender.shortenings.iter().map(|it| (vec![it.modes.0, it.modes.1], Way::Axial));
        let mut terms = Vec::new();
        for (index, (modes, way)) in single.chain(double).enumerate() {
            let (mut nodes, mut values, mut slopes) = (Vec::new(), Vec::new(), Vec::new());
            for held in &places {
                for _ in 0..if held.turns_with && way.bends() { 2 } else { 1 } {
                    nodes.push(held.x);
                    values.push(values_at(&slender, held.x)[index]);
                    slopes.push(slender.slopes(held.x).get(index).copied().unwrap_or(0.0));
                }
            }
            let differences = divided(&nodes, values, &slopes);
            terms.push(Term { modes, axis: way.axis(), nodes, differences });
        }
        let mut bow = Bow { slender, terms, across: Vec::new() };
        bow.across = bow.places().map(|x| bow.away(x)).collect();
        bow
    }

    fn away(&self, x: f64) -> Vec<f64> {
        let values = self.slender.values(x).into_iter().zip(&self.terms);
        let away = |(value, term): (f64, &Term)| match term.axis {
            0 => 0.0,
            _ => value - term.held(x),
        };
        values.map(away).collect()
    }

    /// x of places over the whole length, both ends among them.
    pub fn places(&self) -> impl Iterator<Item = f64> {
        let Slender { from, length, .. } = *self.slender;
        (0..=PLACES).map(move |k| from + length * k as f64 / PLACES as f64)
    }

    /// x of start and end.
    pub fn ends(&self) -> [f64; 2] {
        [self.slender.from, self.slender.from + self.slender.length]
    }

    /// Which modes are multiplied, and along which axis of the frame that moves places.
    pub fn terms(&self) -> impl Iterator<Item = (&[usize], usize)> {
        self.terms.iter().map(|term| (term.modes.as_slice(), term.axis))
    }

    /// How far each term moves what is shown of the place at x, with what is beyond the joints so many times as large.
    pub fn factors(&self, x: f64, times: f64) -> Vec<f64> {
        let values = values_at(&self.slender, x);
        let factor = |(term, value): (&Term, f64)| {
            let held = term.held(x);
            held + times * (value - held)
        };
        self.terms.iter().zip(values).map(factor).collect()
    }

    /// What is shown of the place at x, in the axes of the frame, from its origin.
    pub fn shown(&self, x: f64, modes: &[f64], times: f64) -> [f64; 3] {
        let mut at = [x, 0.0, 0.0];
        for (term, factor) in self.terms.iter().zip(self.factors(x, times)) {
            at[term.axis] += factor * term.modes.iter().map(|mode| modes[*mode]).product::<f64>();
        }
        at
    }

    /// The largest deflection across the axis that is magnified, of the length.
    pub fn deflection(&self, modes: &[f64]) -> f64 {
        let away = |factors: &Vec<f64>| {
            let mut sums = [0.0; 3];
            for ((factor, mode), term) in factors.iter().zip(modes).zip(&self.terms) {
                sums[term.axis] += factor * mode;
            }
            sums[1].hypot(sums[2])
        };
        self.across.iter().map(away).fold(0.0, f64::max) / self.slender.length
    }
}

impl Term {
    /// c at x.
    fn held(&self, x: f64) -> f64 {
        let steps = self.nodes.iter().zip(&self.differences).rev();
        steps.fold(0.0, |sum, (node, difference)| sum * (x - node) + difference)
    }
}

/// Of each term at x.
fn values_at(slender: &Slender, x: f64) -> Vec<f64> {
    let mut values = slender.values(x);
    let shortenings = slender.shortenings.iter().zip(slender.shortenings_at(x));
    values
        .extend(shortenings.map(|(it, value)| if it.modes.0 == it.modes.1 { -0.5 * value } else { -value }));
    values
}

/// Newton's coefficients; equal nodes stand side by side.
fn divided(nodes: &[f64], mut values: Vec<f64>, slopes: &[f64]) -> Vec<f64> {
    let count = nodes.len();
    for order in 1..count {
        for k in (order..count).rev() {
            let apart = nodes[k] - nodes[k - order];
            values[k] = if apart == 0.0 { slopes[k] } else { (values[k] - values[k - 1]) / apart };
        }
    }
    values
}

/// How many times as large a picture shows deflections of so much of a length at most: 1, 2 or 5 times a power of ten, or 1.
pub fn magnification(deflection: f64) -> f64 {
    if !(NOTHING..SEEN).contains(&deflection) {
        return 1.0;
    }
    let wanted = SHOWN / deflection;
    let power = libm::pow(10.0, libm::floor(libm::log10(wanted)));
    [5.0, 2.0, 1.0].into_iter().map(|digit| digit * power).find(|it| *it <= wanted).unwrap_or(power)
}
