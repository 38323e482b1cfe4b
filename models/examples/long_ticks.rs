//! Ten million ticks in single precision: the clock against exact counts, the motion against double precision.
//!
//! ```text
//! cargo run --release -p linkwright-models --example long_ticks [-- TICKS [STEPS A TICK]]
//! ```
//! A crank-rocker is advanced tick by tick, as a control loop does it: from time zero, and from 86 400 s, where times in single
//! precision are 8 ms apart and a tick is 1 ms. After each tick the clock must show the exact time rounded once. The motor keeps the
//! crank turning against a brake, so that the turns that it made tell how much time was integrated; its torque swings with time,
//! which single precision sees rounded.

use linkwright::{AssembleExt, Baumgarte, Mechanism, Real, Simulation, mechanism};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::time::Instant;

mechanism! {
    /// A crank that swings a rocker, with a motor and a brake.
    pub planar CrankRocker {
        input drive [N*m];
        gravity [m/s^2] = (0, -9.81);

        rod  crank   { mass [kg] = 0.5; length [mm] = 200; }
        rod  coupler { mass [kg] = 1;   length [mm] = 600; }
        body rocker  { mass [kg] = 2; inertia [kg*m^2] = 0.05; center [m] = (0.3, 0); point tip [m] = (0.4, 0); }

        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint knee:       revolute(crank.end, coupler.start);
        joint wrist:      revolute(coupler.end, rocker.tip);
        joint rocker_pin: revolute(ground(0.5, 0) [m], rocker.origin);

        torque motor: torque(crank_pin) = drive - 0.4 [N*m*s/rad] * crank_pin.rate;

        start  { crank_pin.angle [deg] = 90; crank_pin.rate [rpm] = 60; rocker_pin.angle [deg] ~ 70; }
        expect { degrees_of_freedom = 1; rotates = crank_pin; no_singularity; }
        output angle [rad] = crank_pin.angle;
        output rate [rad/s] = crank_pin.rate;
    }
}

/// Ticks of single precision, which both precisions have.
#[derive(Clone, Copy)]
struct Ticks {
    begin: f32,
    tick: f32,
    count: u32,
    steps: u32,
}

/// What a run came to.
struct Outcome {
    /// By how much the crank turned, rad.
    turned: f64,
    rate: f64,
    time: f64,
    /// Ticks after which the clock did not show the exact time rounded once.
    wrong: u32,
    steps: u64,
    seconds: f64,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1).map(|argument| argument.parse());
    let count = arguments.next().transpose()?.unwrap_or(10_000_000);
    let steps = arguments.next().transpose()?.unwrap_or(1).max(1);
    for begin in [0.0, 86_400.0] {
        let ticks = Ticks { begin, tick: 1e-3, count, steps };
        let end = ticks.exact(count);
        println!(
            "{count} ticks of {} s, steps a tick: {steps}, from {begin} s to exactly {end} s",
            f64::from(ticks.tick)
        );
        let single = run::<f32>(ticks)?;
        let double = run::<f64>(ticks)?;
        for (name, outcome) in [("f32", &single), ("f64", &double)] {
            let Outcome { turned, rate, time, wrong, steps, seconds } = outcome;
            println!(
                "  {name}: the clock shows {time} s; not the exact time rounded once after {wrong} ticks"
            );
            println!(
                "       the crank turned by {turned:.3} rad, and turns by {rate:.4} rad/s; {steps} steps in {seconds:.1} s"
            );
        }
        let apart = (single.turned - double.turned) / double.turned;
        println!("  f32 and f64 are {apart:.1e} apart, as by {:.1} ticks\n", apart * f64::from(count));
        assert!(single.wrong == 0 && single.steps == double.steps, "the clock is not exact");
    }
    Ok(())
}

impl Ticks {
    /// The time after so many ticks: of a number of 24 bits, and a count of 24, exact in double precision.
    fn exact(self, count: u32) -> f64 {
        f64::from(self.begin) + f64::from(count) * f64::from(self.tick)
    }
}

fn run<R: Real>(ticks: Ticks) -> Result<Outcome, Box<dyn std::error::Error>> {
    let (k, started) = (R::from_f64, Instant::now());
    let model = CrankRocker::<R>::default();
    let drive = |time: R| CrankRockerInputs { drive: k(4.0) + (k(0.25) * time).sin() };
    let mut steps = 0;
    let mut simulation = Simulation::new(&model, model.start())
        .formulation(Baumgarte { alpha: k(20.0), beta: k(20.0) })
        .held(|time, _| {
            steps += 1;
            drive(time)
        })
        .start_time(k(ticks.begin.into()))
        .step(k(f64::from(ticks.tick) / f64::from(ticks.steps)));
    let (mut wrong, mut turned, mut rate) = (0, 0.0, 0.0);
    let mut last = FRAC_PI_2;
    for count in 1..=ticks.count {
        let state = simulation.advance_for(k(ticks.tick.into()))?;
        let time = simulation.time();
        wrong += u32::from(time != k(ticks.exact(count)));
        let outputs = model.outputs(time, &state, &drive(time));
        // The angle is within one turn; whole turns are counted here.
        let angle = outputs.angle.to_f64();
        turned += (angle - last + PI).rem_euclid(TAU) - PI;
        (last, rate) = (angle, outputs.rate.to_f64());
    }
    let time = simulation.time().to_f64();
    Ok(Outcome { turned, rate, time, wrong, steps, seconds: started.elapsed().as_secs_f64() })
}
