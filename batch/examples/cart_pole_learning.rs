//! A pole on a light cart learns to stand: a batch as the environments of reinforcement learning, with observations, rewards and resets.
//!
//! Every environment has a policy of its own, a force −k·(travel, angle, speed, rate). The cross-entropy method (Rubinstein, Kroese, 2004) takes
//! the tenth of them that stood longest and draws the next generation around it. An environment whose pole has fallen is reset at once,
//! beside others that go on.
//!
//! ```text
//! cargo run --release -p linkwright-batch --example cart_pole_learning [-- environments]
//! ```

use linkwright::{Rk4, mechanism};
use linkwright_batch::{Batch, BatchError, Columns, Constant, PerMember};
use std::error::Error;

mechanism! {
    /// A pole of 1 kg on a cart of 0.1 kg that is pushed.
    planar CartPole {
        input push [N];
        gravity [m/s^2] = (0, -9.81);
        particle cart { mass [kg] = 0.1; }
        body pole { mass [kg] = 1; inertia [kg*m^2] = 0.08; center [m] = (0, 0.5); }
        joint rail: point_on_line(line(ground(0, 0) [m], ground(1, 0) [m]), cart.center);
        joint pin:  revolute(cart.center, pole.origin);
        force motor: force(cart.center, direction = (1, 0)) = push;
        start  { rail.travel [m] = 0; rail.speed [m/s] = 0; pole.angle [rad] = 0; pole.rate [rad/s] = 0; }
        expect { degrees_of_freedom = 2; }
        output travel [m] = cart.center.x;
        output angle [rad] = pole.angle;
        output speed [m/s] = cart.center.velocity.x;
        output rate [rad/s] = pole.rate;
    }
}

/// A tick, s; ticks of a generation; the most that may be pushed, N.
const TICK: f64 = 0.01;
const TICKS: usize = 400;
const MOST: f64 = 40.0;
const GENERATIONS: usize = 8;

fn main() -> Result<(), Box<dyn Error>> {
    let count = std::env::args().nth(1).map_or(Ok(2048), |text| text.parse::<usize>())?;
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut environments = Environments::new(count)?;
    let (mut mean, mut spread) = ([0.0; 4], [50.0; 4]);
    let mut stood = 0.0;
    for generation in 0..GENERATIONS {
        let policies: Vec<[f64; 4]> =
            (0..count).map(|_| [0, 1, 2, 3].map(|k| mean[k] + spread[k] * random.normal())).collect();
        let mut rewards = vec![0.0; count];
        let mut falls = 0;
        (0..count).try_for_each(|environment| environments.reset(environment, &mut random))?;
        for _ in 0..TICKS {
            let seen = environments.observations();
            let actions: Vec<f64> = (0..count)
                .map(|environment| {
                    let pairs = policies[environment].iter().zip(&seen);
                    pairs.map(|(gain, of)| gain * of[environment]).sum()
                })
                .collect();
            for (environment, fell) in environments.step(&actions).into_iter().enumerate() {
                rewards[environment] += if fell { 0.0 } else { 1.0 };
                if fell {
                    falls += 1;
                    environments.reset(environment, &mut random)?;
                }
            }
        }
        // Every fall costs more than the tick that it takes.
        stood = rewards.iter().sum::<f64>() / (count * TICKS) as f64;
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&a, &b| rewards[b].total_cmp(&rewards[a]));
        let best: Vec<[f64; 4]> =
            order.iter().take((count / 10).max(2)).map(|&index| policies[index]).collect();
        for k in 0..4 {
            let of = |f: &dyn Fn(f64) -> f64| {
                best.iter().map(|gains| f(gains[k])).sum::<f64>() / best.len() as f64
            };
            mean[k] = of(&|gain| gain);
            spread[k] = of(&|gain| (gain - mean[k]).powi(2)).sqrt();
        }
        let seconds = TICKS as f64 * TICK;
        let falls = falls as f64 / count as f64;
        println!(
            "generation {generation}: {falls:>6.2} falls in {seconds:.0} s; the best push {mean:.1?} ± {spread:.1?}"
        );
        if generation + 1 == GENERATIONS {
            assert!(falls < 0.5, "it did not learn to stand");
        }
    }
    assert!(stood > 0.99, "it stood {stood} of the time");
    Ok(())
}

/// Environments side by side.
struct Environments {
    batch: Batch<CartPole, Rk4>,
    model: CartPole,
}

impl Environments {
    fn new(count: usize) -> Result<Self, BatchError> {
        let model = CartPole::default();
        Ok(Environments { batch: Batch::alike(count, &model, &CartPole::START, Rk4)?, model })
    }

    /// Begins anew near the upright position, at rest.
    fn reset(&mut self, environment: usize, random: &mut Random) -> Result<(), BatchError> {
        let angle: f64 = 0.05 * random.normal();
        let mut state = CartPole::START;
        let mut positions = CartPolePositions::from(state.q);
        positions.pole_angle = linkwright::Angle { cos: angle.cos(), sin: angle.sin() };
        state.q = positions.into();
        self.batch.set(environment, &self.model, 0.0, &state)
    }

    /// Travels, angles, speeds and rates, one of each environment.
    fn observations(&self) -> [Vec<f64>; 4] {
        let none = Constant(CartPoleInputs { push: 0.0 });
        let seen: Columns = self.batch.outputs(&none);
        ["travel", "angle", "speed", "rate"].map(|name| seen.column(name).unwrap_or_default().to_vec())
    }

    /// A tick with these pushes, N; whether the pole of each has fallen, or its cart has left the track.
    fn step(&mut self, actions: &[f64]) -> Vec<bool> {
        let inputs: Vec<_> =
            actions.iter().map(|push| CartPoleInputs { push: push.clamp(-MOST, MOST) }).collect();
        self.batch.step(&PerMember(&inputs), TICK);
        let [travel, angle, ..] = self.observations();
        let lost = travel.iter().zip(&angle).map(|(travel, angle)| travel.abs() > 3.0 || angle.abs() > 0.6);
        lost.enumerate()
            .map(|(environment, lost)| lost || self.batch.failure(environment).is_some())
            .collect()
    }
}

/// Marsaglia's xorshift: the same numbers in every run.
struct Random(u64);

impl Random {
    /// In (0, 1].
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 11) + 1) as f64 / (1_u64 << 53) as f64
    }

    /// Normally distributed (Box, Muller 1958).
    fn normal(&mut self) -> f64 {
        let (radius, angle) = ((-2.0 * self.unit().ln()).sqrt(), std::f64::consts::TAU * self.unit());
        radius * angle.cos()
    }
}
