//! The functions of a mechanism at a state, by interpreting their programs; and states to ask for.

use super::quantity::Quantity;
use crate::check::assemble::retract;
use crate::compiled::Compiled;
use crate::functions::{Function, MOTION};
use crate::schedule::{Bounded, Errors, Inputs, run, run_bounded};

/// Programs, and the errors of what some prepare for others.
pub struct Machine<'a> {
    pub compiled: &'a Compiled,
    errors: Errors,
}

impl<'a> Machine<'a> {
    /// The machine, and `inputs` with what it prepared from their parameters.
    pub fn new(compiled: &'a Compiled, inputs: &mut Inputs) -> Self {
        let mut machine = Machine { compiled, errors: Errors::default() };
        let prepared = machine.bounded(Function::Prepare, inputs).into_iter();
        (inputs.prepared, machine.errors.prepared) =
            prepared.map(|bounded| (bounded.value, bounded.error)).unzip();
        machine
    }

    /// The same with what K(c) and D were factored into at this state; an empty list where they are not written out.
    pub fn factored(&self, inputs: &Inputs) -> (Machine<'a>, Inputs) {
        let (mut inputs, mut errors) = (inputs.clone(), self.errors.clone());
        let kept = |function: Function, inputs: &Inputs| {
            let all = self.bounded(function, inputs);
            let [kept, _pivot] = self.groups(function, &all);
            kept.iter().map(|bounded| (bounded.value, bounded.error)).unzip()
        };
        (inputs.kept, errors.kept) = kept(Function::Factor, &inputs);
        (inputs.lu, errors.lu) = kept(Function::FactorJacobian, &inputs);
        (Machine { compiled: self.compiled, errors }, inputs)
    }

    /// Results by the groups of the function's signature.
    pub fn groups<'v, T, const N: usize>(&self, function: Function, results: &'v [T]) -> [&'v [T]; N] {
        function.signature().split(&self.compiled.complete, results)
    }

    /// The motions of bodies by the fields of [`MOTION`].
    pub fn motions<'v, T, const N: usize>(&self, results: &'v [T]) -> impl Iterator<Item = [&'v [T]; N]> {
        let kind = MOTION.of(self.compiled.mechanism.space);
        results.chunks(kind.length()).map(|motion| kind.split(motion))
    }

    fn bounded(&self, function: Function, inputs: &Inputs) -> Vec<Bounded> {
        let compiled = self.compiled;
        run_bounded(
            compiled.programs.get(function),
            &compiled.complete.equations.graph.read(),
            inputs,
            &self.errors,
        )
    }

    pub fn run(&self, function: Function, inputs: &Inputs) -> Vec<Quantity> {
        self.bounded(function, inputs).into_iter().map(Quantity::from).collect()
    }

    pub fn plain(&self, function: Function, inputs: &Inputs) -> Vec<f64> {
        run(self.compiled.programs.get(function), inputs)
    }

    /// D as rows of (column, entry).
    pub fn jacobian(&self, inputs: &Inputs) -> Vec<Vec<(usize, Quantity)>> {
        let mut entries = self.run(Function::ConstraintJacobian, inputs).into_iter();
        let rows = self.compiled.complete.equations.rows.iter();
        rows.map(|row| row.jet.columns.keys().copied().zip(entries.by_ref()).collect()).collect()
    }

    /// M x.
    pub fn mass_times(&self, inputs: &Inputs, x: &[Quantity]) -> Vec<Quantity> {
        let entries = self.run(Function::MassMatrix, inputs);
        let mut product = vec![Quantity::default(); x.len()];
        for ((i, j), entry) in self.compiled.complete.equations.mass.keys().zip(entries) {
            product[*i] = product[*i] + entry * x[*j];
            if i != j {
                product[*j] = product[*j] + entry * x[*i];
            }
        }
        product
    }

    /// q ⊕ h δ.
    pub fn displaced(&self, inputs: &Inputs, h: f64, direction: &[f64]) -> Inputs {
        let increment: Vec<f64> = direction.iter().map(|x| h * x).collect();
        Inputs { q: retract(&self.compiled.complete.equations, &inputs.q, &increment), ..inputs.clone() }
    }

    /// (t + h, q ⊕ h v, v + h v̇).
    pub fn moved(&self, inputs: &Inputs, h: f64, acceleration: &[f64]) -> Inputs {
        let mut moved = self.displaced(inputs, h, &inputs.v);
        moved.time += h;
        moved.v.iter_mut().zip(acceleration).for_each(|(v, a)| *v += h * a);
        moved
    }
}

/// Uniform random numbers, the same in every run (SplitMix64: Steele, Lea, Flood, OOPSLA 2014).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Random(seed)
    }

    /// In [−1, 1).
    pub fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        (z >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self, length: usize) -> Vec<f64> {
        (0..length).map(|_| self.number()).collect()
    }
}

/// How far from the start states are taken, rad and in sizes of the mechanism; less far where something has no value there.
const REACHES: [f64; 4] = [0.7, 0.3, 0.1, 0.01];
/// Relative pivots below this are near a singular position.
const REGULAR: f64 = 1e-2;

/// A state near the start that fulfils no constraint, away from singular positions. `vary`: with other parameters, too.
pub fn state(compiled: &Compiled, random: &mut Random, vary: bool) -> Inputs {
    let mut found = Inputs::default();
    for reach in REACHES {
        found = any_state(compiled, random, reach, vary);
        let machine = Machine::new(compiled, &mut found);
        let solution = machine.plain(Function::Acceleration, &found);
        let [_, _, pivot] = machine.groups(Function::Acceleration, &solution);
        let pivot = pivot.first().copied().unwrap_or(1.0);
        let scalars =
            [Function::PotentialEnergy, Function::Powers].map(|function| machine.plain(function, &found));
        if pivot > REGULAR && solution.iter().chain(scalars.iter().flatten()).all(|x| x.is_finite()) {
            break;
        }
    }
    found
}

fn any_state(compiled: &Compiled, random: &mut Random, reach: f64, vary: bool) -> Inputs {
    let (equations, assembly) = (&compiled.complete.equations, &compiled.assembly);
    let n = equations.layout.velocities();
    let lengths = equations.layout.linear.len();
    let size = size(compiled);
    let sized = |random: &mut Random, factor: f64| -> Vec<f64> {
        let scale = |k: usize| factor * if k < lengths { size } else { 1.0 };
        (0..n).map(|k| scale(k) * random.number()).collect()
    };
    let increment = sized(random, reach);
    let parameters = compiled.mechanism.parameters.iter().map(|parameter| {
        let varied = parameter.default + 0.1 * random.number() * parameter.default.abs();
        let (least, most) = parameter.bounds.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        if vary { varied.clamp(least, most) } else { parameter.default }
    });
    let parameters = parameters.collect();
    let mut q = retract(equations, &assembly.q, &increment);
    for angle in 0..equations.layout.angles.len() {
        q[equations.layout.turns(angle)] += (3.0 * random.number()).round();
    }
    Inputs {
        parameters,
        phases: assembly.phases.clone(),
        time: 0.5 + 0.5 * random.number(),
        q,
        v: sized(random, 1.0),
        inputs: random.vector(equations.symbols.inputs.len()),
        internal: random.vector(equations.symbols.internal.len()),
        // Open and closed in turn, and not drawn: what is random for a mechanism without gates stays what it is.
        gates: (0..equations.symbols.gates.len()).map(|gate| f64::from(u8::from(gate % 2 == 0))).collect(),
        two_alpha: 10.0 + random.number(),
        beta_squared: 25.0 + random.number(),
        acceleration: sized(random, 3.0),
        lambda: random.vector(equations.rows.len()),
        targets: random.vector(compiled.complete.conditions.rows.len()),
        compliance: 0.01 * (2.0 + random.number()),
        given_forces: random.vector(n),
        given_rows: random.vector(equations.rows.len()),
        kept: random.vector(compiled.complete.further.kept().len()),
        lu: random.vector(compiled.complete.further.lu().len()),
        prepared: Vec::new(),
    }
}

/// The assembled start, at the default parameters.
pub fn start(compiled: &Compiled) -> Inputs {
    Inputs {
        parameters: compiled.mechanism.parameters.iter().map(|parameter| parameter.default).collect(),
        phases: compiled.assembly.phases.clone(),
        q: compiled.assembly.q.clone(),
        v: compiled.assembly.v.clone(),
        acceleration: vec![0.0; compiled.assembly.v.len()],
        inputs: vec![0.0; compiled.mechanism.inputs.len()],
        internal: compiled.mechanism.internal_starts(),
        gates: compiled.start_gates(),
        lambda: vec![0.0; compiled.complete.equations.rows.len()],
        ..Inputs::default()
    }
}

/// The largest coordinate of a centre of mass at the start, m.
pub fn size(compiled: &Compiled) -> f64 {
    let mut start = start(compiled);
    let machine = Machine::new(compiled, &mut start);
    let motions = machine.plain(Function::Motions, &start);
    let mut largest = 0.0_f64;
    for [position, ..] in machine.motions::<f64, 6>(&motions) {
        largest = position.iter().fold(largest, |largest, x| largest.max(x.abs()));
    }
    if largest.is_finite() && largest > 1e-9 { largest } else { 1.0 }
}
