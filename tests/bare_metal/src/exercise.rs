//! One model after the other: assembled, stepped, evaluated at random states.

use crate::Meter;
use crate::text::{decimal, hexadecimal};
use core::hint::black_box;
use linkwright::{
    Assemble, AssembleExt, Baumgarte, Corrected, Fields, LagrangeIndex1, NullSpace, Real, Rk4, State,
    StateOf, StepMethod, Stepper, Vector, WithMultipliers,
};

/// Steps of each method that go into the digest.
const STEPS: usize = 20;
/// Random states at which instructions are counted.
const STATES: usize = 12;

/// The bits of a number, for digests.
pub trait Bits: Real {
    fn bits(self) -> u64;
    /// A number made of the upper bits of a random one, in [−1, 1).
    fn random(seed: &mut u64) -> Self;
}

fn next(seed: &mut u64) -> u32 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 32) as u32
}

impl Bits for f32 {
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
    fn random(seed: &mut u64) -> Self {
        (next(seed) >> 8) as f32 / 8_388_608.0 - 1.0
    }
}

impl Bits for f64 {
    fn bits(self) -> u64 {
        self.to_bits()
    }
    fn random(seed: &mut u64) -> Self {
        f64::from(next(seed)) / 2_147_483_648.0 - 1.0
    }
}

/// FNV-1a over the bits of a state.
pub fn digest<R: Bits, Q: Vector<R>, V: Vector<R>, Z: Vector<R>, G>(
    mut hash: u64,
    state: &State<Q, V, Z, G>,
) -> u64 {
    for part in [state.q.as_slice(), state.v.as_slice(), state.z.as_slice()] {
        for value in part {
            for byte in value.bits().to_le_bytes() {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        }
    }
    hash
}

/// The least and the most of what was counted.
#[derive(Clone, Copy)]
struct Range {
    least: u32,
    most: u32,
}

impl Range {
    const NONE: Self = Range { least: u32::MAX, most: 0 };

    fn with(self, count: u32) -> Self {
        Range { least: self.least.min(count), most: self.most.max(count) }
    }
}

/// A line about this model.
pub fn exercise<R: Bits, M>(name: &str, scalar: &str, model: &M, meter: &mut impl Meter)
where
    M: Assemble<R, Inputs: Fields<R>, Outputs: Fields<R>> + Clone,
{
    let start = model.start();
    // Touches part the steps of these, which steppers refuse.
    if !model.gate_names().is_empty() {
        return;
    }
    // As by `assemble`, which a model with a massless part at rest may refuse: then the start of the compiler is taken.
    let assembled = model.assemble(&start).ok();
    let start = assembled.clone().unwrap_or(start);
    // Teeth of steel between grams vibrate at 55 kHz, a rod of steel along its axis at 15 kHz, short strips across theirs at tens of them.
    let is_stiff =
        name.starts_with("planetary_stage") || ["flexible_slider_crank", "princeton_beam"].contains(&name);
    let h = R::from_f64(if is_stiff { 1e-6 } else { 1e-4 });
    let begin = (&start, h);
    let mut hash = digest(0xcbf2_9ce4_8422_2325, &start);
    let mut of_steps = Range::NONE;
    let mut stack = 0;
    hash = steps(hash, model, begin, Rk4, &mut of_steps, &mut stack, meter);
    let (mut independent, mut corrected, mut ignored) = (Range::NONE, Range::NONE, 0);
    let mut by_multipliers = Range::NONE;
    let method = (Rk4, WithMultipliers(Baumgarte::time_constant(R::from_f64(1e-3))));
    hash = steps(hash, model, begin, method, &mut by_multipliers, &mut ignored, meter);
    hash = steps(hash, model, begin, (Rk4, NullSpace), &mut independent, &mut ignored, meter);
    let method = (Rk4, Corrected::after(LagrangeIndex1));
    hash = steps(hash, model, begin, method, &mut corrected, &mut ignored, meter);
    let [evaluation, multipliers] = evaluations(model, &start, meter);

    meter.tell(scalar);
    meter.tell(" ");
    meter.tell(name);
    meter.tell(" ");
    hexadecimal(hash, &mut |text| meter.tell(text));
    let numbers = [
        u32::from(assembled.is_some()),
        evaluation.least,
        evaluation.most,
        multipliers.least,
        multipliers.most,
        of_steps.least,
        of_steps.most,
        by_multipliers.least,
        by_multipliers.most,
        independent.most,
        corrected.most,
        stack,
    ];
    for number in numbers {
        meter.tell(" ");
        decimal(number, &mut |text| meter.tell(text));
    }
    meter.tell("\n");
}

fn no_inputs<R: Real, M: Assemble<R, Inputs: Fields<R>>>() -> M::Inputs {
    M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()))
}

/// Steps of one method, counted, into the digest.
#[inline(never)]
fn steps<R: Bits, M, S: StepMethod<R, M>>(
    mut hash: u64,
    model: &M,
    (start, h): (&StateOf<M, R>, R),
    method: S,
    count: &mut Range,
    stack: &mut u32,
    meter: &mut impl Meter,
) -> u64
where
    M: Assemble<R, Inputs: Fields<R>> + Clone,
{
    let mut plant = Stepper::new(model.clone(), start.clone(), method);
    let inputs = no_inputs::<R, M>();
    for tick in 0..STEPS {
        let mut code = 0;
        let instructions = meter.instructions(|| {
            code = plant.step(black_box(&inputs), black_box(h)).map_or_else(|error| error.code(), |_| 0);
        });
        // The first asks what the formulation remembers at the beginning.
        if tick > 0 {
            *count = count.with(instructions);
        }
        hash = digest(hash, plant.state()) ^ u64::from(code);
    }
    *stack = meter.stack(|| _ = black_box(plant.step(black_box(&inputs), black_box(h)).is_ok()));
    digest(hash, plant.state())
}

/// Accelerations at random states about the start: by the function that is asked first, and by multipliers.
#[inline(never)]
fn evaluations<R: Bits, M>(model: &M, start: &StateOf<M, R>, meter: &mut impl Meter) -> [Range; 2]
where
    M: Assemble<R, Inputs: Fields<R>> + Clone,
{
    let mut seed = 1;
    let mut ranges = [Range::NONE; 2];
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    let terms = [R::from_f64(20.0), R::from_f64(100.0)];
    for _ in 0..STATES {
        let mut delta = model.zero_v();
        delta.as_mut_slice().iter_mut().for_each(|entry| *entry = R::from_f64(0.2) * R::random(&mut seed));
        let mut v = start.v.clone();
        v.as_mut_slice().iter_mut().for_each(|entry| *entry = *entry + R::random(&mut seed));
        let mut inputs: <M::Inputs as Fields<R>>::Array = Vector::zeros(M::Inputs::NAMES.len());
        inputs.as_mut_slice().iter_mut().for_each(|entry| *entry = R::random(&mut seed));
        let inputs = M::Inputs::from_array(inputs);
        let state = start.moved(model.layout(), &delta, v, start.z.clone());
        let time = R::ONE + R::random(&mut seed);
        let [first, multipliers] = &mut ranges;
        let (t, s, u) = (black_box(time), black_box(&state), black_box(&inputs));
        let [two_alpha, beta_squared] = terms.map(black_box);
        *multipliers = multipliers.with(meter.instructions(|| {
            let pivot = model.acceleration_baumgarte(t, s, u, two_alpha, beta_squared, &mut a, &mut lambda);
            black_box((pivot, &a, &lambda));
        }));
        *first = if model.null_space_first() {
            first.with(meter.instructions(|| {
                let pivot = model.null_space_baumgarte(t, s, u, two_alpha, beta_squared, &mut a, &mut lambda);
                black_box((pivot, &a, &lambda));
            }))
        } else {
            *multipliers
        };
    }
    ranges
}
