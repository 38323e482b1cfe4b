//! The rows, conditions and guesses of a problem as residuals of a descent, divided by their sizes.

use super::descent::Residual;
use super::point::{Point, retract};
use super::position::{Problem, Sizes};
use super::world::World;
use crate::equations::Condition;
use crate::forms::row::Measures;
use crate::model::Mechanism;

impl Problem<'_> {
    /// Rows, conditions and guesses, each divided by its size, and the length of the mechanism. Sizes are the largest of
    /// those at `q` and with all bodies turned.
    pub fn residuals(&self, mechanism: &Mechanism, point: &mut Point, q: &[f64]) -> (Vec<Residual>, f64) {
        let mut sizes: Option<Sizes> = None;
        for number in 0..3 {
            let turn = |k: usize| number as f64 * (0.4 + 0.17 * (k % 7) as f64);
            let linear = self.equations.layout.linear.len();
            let away = (0..self.equations.symbols.v.len()).map(|k| if k < linear { 0.0 } else { turn(k) });
            let q = retract(self.equations, q, &away.collect::<Vec<_>>());
            point.set_q(&q);
            point.evaluate(&self.ancestry);
            let own = self.sizes(point, &q);
            sizes = Some(match sizes {
                None => own,
                Some(known) => Sizes {
                    length: known.length.max(own.length),
                    rows: known.rows.iter().zip(&own.rows).map(|(a, b)| a.max(*b)).collect(),
                },
            });
        }
        let Some(Sizes { length, rows: sizes }) = sizes else { return (Vec::new(), 1.0) };
        let world = World::at(mechanism, point, q);
        point.evaluate(&self.ancestry);
        let row = |(row, size): (&usize, &f64)| {
            let row = &self.equations.rows[*row];
            let plain =
                Residual { jet: row.jet.clone(), target: 0.0, angular: false, size: *size, length: None };
            let apart = row.joint().filter(|_| row.form.measures == Measures::Squares).and_then(|joint| {
                let joint = &mechanism.joints[joint.0];
                Some(super::world::length(super::world::sub(
                    world.place(&joint.first)?,
                    world.place(&joint.second)?,
                )))
            });
            match apart {
                None => plain,
                Some(apart) => {
                    let square = apart * apart - 2.0 * point.get(row.jet.value);
                    Residual { size: length, length: Some(square.max(0.0).sqrt()), ..plain }
                }
            }
        };
        let held = |(condition, target): &(Condition, f64)| Residual {
            jet: condition.jet.clone(),
            target: *target,
            angular: condition.angular,
            size: if condition.angular { 1.0 } else { length },
            length: None,
        };
        let guess = |guess: &(Condition, f64)| Residual { size: 1.0, ..held(guess) };
        let rows = self.rows.iter().zip(&sizes).map(row);
        let held = self.conditions.iter().map(held);
        (rows.chain(held).chain(self.guesses.iter().map(guess)).collect(), length)
    }

    pub fn has_guesses(&self) -> bool {
        !self.guesses.is_empty()
    }
}
