//! Consistent states: at equal distances along the motion, or at random times with velocities times a random factor; where there are
//! no constraints, random increments and velocities.

use crate::timed::{Of, RATE};
use linkwright::lanes::InScalars;
use linkwright::{Assemble, AssembleExt, Baumgarte, Fields, Rk4, StateOf, Vector};

/// Marsaglia's xorshift with three shifts (2003).
struct Random(u64);

impl Random {
    /// In [−1, 1).
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

pub fn consistent<M>(of: &Of<M>, seed: u64, count: usize) -> Vec<StateOf<M>>
where
    M: InScalars + Assemble<f64, Z = (), Gates = ()> + Clone,
    M::Inputs: Fields<f64>,
{
    let start = of.model.assemble(&of.model.start()).expect("the default start");
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let mut stepper = of.model.stepper(start.clone(), (Rk4, Baumgarte { alpha: RATE, beta: RATE }));
    (0..count)
        .map(|_| {
            if seed != 0 && of.model.row_count() == 0 {
                return anywhere(of, &start, &mut random);
            }
            let pace = if seed == 0 { of.pace } else { of.pace * (1.0 + 0.9 * random.next()) };
            for _ in 0..400 {
                stepper.step(&of.inputs, pace / 400.0).expect("a regular motion");
            }
            let mut state = stepper.state().clone();
            if seed != 0 {
                let factor = 1.5 * random.next();
                state.v.as_mut_slice().iter_mut().for_each(|v| *v *= factor);
            }
            state
        })
        .collect()
}

fn anywhere<M>(of: &Of<M>, start: &StateOf<M>, random: &mut Random) -> StateOf<M>
where
    M: InScalars + Assemble<f64, Z = (), Gates = ()>,
{
    let (mut u, mut v) = (of.model.zero_v(), of.model.zero_v());
    u.as_mut_slice().iter_mut().for_each(|entry| *entry = 3.0 * random.next());
    v.as_mut_slice().iter_mut().for_each(|entry| *entry = 5.0 * random.next());
    start.moved(of.model.layout(), &u, v, ())
}
