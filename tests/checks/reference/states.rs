//! Random states of a compiled mechanism: anywhere, and consistent ones reached by walking along the motion.

use super::random::Random;
use crate::registry::gates;
use linkwright_compiler::Compiled;
use linkwright_compiler::check::assemble::retract;
use linkwright_compiler::equations::Linear;
use linkwright_compiler::model::{InternalState, Rate};
use linkwright_compiler::schedule::{Function, Inputs, run};
use linkwright_compiler::solve::table::{Numeric, Table};
use std::f64::consts::PI;

/// A compiled mechanism with the means to find consistent states of it.
pub struct Walker<'a> {
    pub compiled: &'a Compiled,
    table: Table,
    /// (row, column) of D in the order of the function.
    pattern: Vec<(usize, usize)>,
    length: f64,
    speed: f64,
}

impl<'a> Walker<'a> {
    pub fn new(compiled: &'a Compiled) -> Self {
        let equations = &compiled.complete.equations;
        let n = equations.layout.velocities();
        let rows = equations.rows.iter().enumerate();
        let pattern: Vec<(usize, usize)> =
            rows.flat_map(|(row, r)| r.jet.columns.keys().map(move |column| (row, *column))).collect();
        let table =
            Table::new(n, equations.rows.len(), pattern.iter().map(|(row, column)| (n + row, *column)));
        let q = &compiled.assembly.q[..equations.layout.linear.len()];
        let length = q.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        Walker { compiled, table, pattern, length: if length > 0.0 { length } else { 1.0 }, speed: 3.0 }
    }

    /// Random parameters near the defaults and within their bounds, random time and inputs.
    fn setting(&self, random: &mut Random, spread: f64) -> Inputs {
        let compiled = self.compiled;
        let mut inputs = Inputs { phases: compiled.assembly.phases.clone(), ..Inputs::default() };
        for parameter in &compiled.mechanism.parameters {
            let value = parameter.default * (1.0 + random.between(-spread, spread));
            let (least, most) = parameter.bounds.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            inputs.parameters.push(value.clamp(least, most));
        }
        inputs.time = random.between(0.0, 1.0);
        inputs.inputs = random.vector(compiled.mechanism.inputs.len(), 10.0);
        let states = compiled.mechanism.states.iter();
        // Those of loads are of the size that their laws allow.
        let size = |state: &InternalState| match state.rate {
            Rate::OfLoad(..) => state.scale.unwrap_or(1.0),
            Rate::Written(..) => 1.0,
        };
        inputs.internal = states.map(|state| size(state) * random.between(-1.0, 1.0)).collect();
        inputs.gates = gates(&compiled.mechanism, || random.between(-1.0, 1.0));
        inputs
    }

    fn prepare(&self, inputs: &mut Inputs) {
        inputs.prepared = run(self.compiled.programs.get(Function::Prepare), inputs);
    }

    /// Any state: unit pairs and quaternions, everything else at random.
    pub fn anywhere(&self, random: &mut Random) -> Inputs {
        let layout = &self.compiled.complete.equations.layout;
        let mut inputs = self.setting(random, 0.1);
        inputs.phases.iter_mut().for_each(|phase| *phase += random.between(-1.0, 1.0));
        inputs.q = random.vector(layout.linear.len(), 2.0 * self.length);
        for _ in &layout.rotations {
            let angle = random.between(-PI, PI);
            inputs.q.extend([angle.cos(), angle.sin()]);
        }
        for _ in &layout.quaternions {
            inputs.q.extend(quaternion(random));
        }
        for _ in &layout.angles {
            // No turns would show no error in what they are multiplied by.
            let turns = random.between(-2.0, 2.0);
            inputs.q.extend([turns.signum() * turns.abs().ceil(), random.between(-PI, PI)]);
        }
        inputs.v = random.vector(layout.velocities(), self.speed);
        if !inputs.internal.is_empty() {
            // Their rates may name results.
            inputs.acceleration = random.vector(layout.velocities(), 10.0);
            inputs.lambda = random.vector(self.compiled.complete.equations.rows.len(), 10.0);
        }
        self.prepare(&mut inputs);
        inputs
    }

    /// A consistent state on the branch of the start: from there along random admissible velocities, in small steps.
    /// `None` if the way is barred (parameters or the time's drivers lead where the mechanism cannot follow).
    pub fn consistent(&self, random: &mut Random) -> Option<Inputs> {
        let mut inputs = self.setting(random, 0.02);
        let end = inputs.time;
        inputs.time = 0.0;
        inputs.q = self.compiled.assembly.q.clone();
        self.prepare(&mut inputs);
        self.close(&mut inputs)?;
        self.fix_phases(&mut inputs);
        // A driver turns by a radian at most in a step: what it carries goes along a straight line there.
        let nu = run(self.compiled.programs.get(Function::Nu), &inputs);
        let fastest = nu.iter().fold(0.0_f64, |most, rate| most.max(rate.abs()));
        let steps = 12.max((end * fastest).ceil() as usize);
        let layout = &self.compiled.complete.equations.layout;
        let bends = layout.linear.iter().any(|linear| matches!(linear, Linear::Mode(..)));
        // Beams that bend by as much as they are long turn their sections over.
        let speed = if bends { 0.1 * self.speed } else { self.speed };
        let wish = random.vector(layout.velocities(), speed);
        for step in 1..=steps {
            inputs.v = wish.clone();
            self.project_velocity(&mut inputs)?;
            let time = end * step as f64 / steps as f64;
            let drift = time - inputs.time;
            // Along the admissible velocities; what the drivers ask for comes with them.
            let stride = if self.compiled.mechanism.drivers.is_empty() { 0.04 } else { drift };
            let increment: Vec<f64> = inputs.v.iter().map(|v| v * stride).collect();
            inputs.q = retract(&self.compiled.complete.equations, &inputs.q, &increment);
            inputs.time = time;
            self.close(&mut inputs)?;
        }
        inputs.v = random.vector(inputs.v.len(), self.speed);
        self.project_velocity(&mut inputs)?;
        Some(inputs)
    }

    /// Phases that come from the assembled start make their rows vanish there.
    fn fix_phases(&self, inputs: &mut Inputs) {
        let open: Vec<usize> = self.open_rows();
        let phi = run(self.compiled.programs.get(Function::Constraints), inputs);
        for (phase, row) in open.into_iter().enumerate() {
            inputs.phases[phase] += phi[row];
        }
        self.prepare(inputs);
    }

    fn open_rows(&self) -> Vec<usize> {
        self.compiled.complete.equations.open_rows(&self.compiled.mechanism)
    }

    fn entries(&self, inputs: &Inputs) -> Vec<(usize, usize, f64)> {
        let n = self.compiled.complete.equations.layout.velocities();
        let d = run(self.compiled.programs.get(Function::ConstraintJacobian), inputs);
        let unit = (0..n).map(|k| (k, k, 1.0));
        unit.chain(self.pattern.iter().zip(d).map(|((row, column), value)| (n + row, *column, value)))
            .collect()
    }

    /// Newton steps of least length onto Φ = 0.
    fn close(&self, inputs: &mut Inputs) -> Option<()> {
        let n = self.compiled.complete.equations.layout.velocities();
        let scale = 1.0 + self.length;
        for _ in 0..40 {
            let phi = run(self.compiled.programs.get(Function::Constraints), inputs);
            let residual = phi.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            if !residual.is_finite() {
                return None;
            }
            let mut rhs = vec![0.0; n];
            rhs.extend(phi.iter().map(|x| -x));
            let step = Numeric::factor(&self.table, self.entries(inputs)).solve(&rhs);
            let length = step[..n].iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            inputs.q = retract(&self.compiled.complete.equations, &inputs.q, &step[..n]);
            if residual < 1e-13 * scale && length < 1e-12 * scale {
                return Some(());
            }
        }
        None
    }

    /// The nearest velocities with D v = ν.
    fn project_velocity(&self, inputs: &mut Inputs) -> Option<()> {
        let n = self.compiled.complete.equations.layout.velocities();
        let factor = Numeric::factor(&self.table, self.entries(inputs));
        let nu = run(self.compiled.programs.get(Function::Nu), inputs);
        for _ in 0..3 {
            let mut rhs = vec![0.0; n];
            let mut residual = nu.clone();
            let d = run(self.compiled.programs.get(Function::ConstraintJacobian), inputs);
            for ((row, column), value) in self.pattern.iter().zip(d) {
                residual[*row] -= value * inputs.v[*column];
            }
            rhs.extend(residual);
            let step = factor.solve(&rhs);
            inputs.v.iter_mut().zip(step).for_each(|(v, step)| *v += step);
        }
        inputs.v.iter().all(|v| v.is_finite()).then_some(())
    }
}

/// A unit quaternion, all directions alike: a point of the unit ball, brought to its surface.
fn quaternion(random: &mut Random) -> Vec<f64> {
    loop {
        let point = random.vector(4, 1.0);
        let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
        if (0.1..=1.0).contains(&length) {
            return point.iter().map(|x| x / length).collect();
        }
    }
}
