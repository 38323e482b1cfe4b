//! Motion: projection onto the constraints, steps of the classical Runge–Kutta method.

use crate::coordinates::check_finite;
use crate::error::Error;
use crate::mechanism::{Formulation, Mechanism, State, check_length};
use crate::system::{System, largest};

/// Newton's iterations that a projection may take.
const ITERATIONS: usize = 25;

/// Φ at which positions meet the constraints, in m, rad or m² beside lengths of one.
const CLOSED: f64 = 1e-13;

/// What a step writes: kept from step to step, so that none allocates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stages {
    stage: State,
    end: State,
    q_rate: Vec<f64>,
    a: Vec<f64>,
    lambda: Vec<f64>,
}

impl Stages {
    /// The end begins at the state; the first stage is there.
    fn begin(&mut self, state: &State, rows: usize) {
        for to in [&mut self.stage, &mut self.end] {
            to.q.clone_from(&state.q);
            to.v.clone_from(&state.v);
        }
        for (vector, length) in
            [(&mut self.q_rate, state.q.len()), (&mut self.a, state.v.len()), (&mut self.lambda, rows)]
        {
            vector.clear();
            vector.resize(length, 0.0);
        }
    }
}

impl Mechanism {
    /// Puts positions, then velocities, on the constraints, across them in the norm of M:
    ///
    /// ```text
    /// [ M  Dᵀ ] [ δ ]   [  0 ]                [ M  Dᵀ ] [ w ]   [  0 ]
    /// [ D  0  ] [ μ ] = [ −Φ ],  q ← q ⊕ δ,   [ D  0  ] [ μ ] = [ −Φ̇ ],  v ← v + w
    /// ```
    ///
    /// The first is Newton's iteration, with D anew at each. (García de Jalón & Bayo 1994, 5.3; Blajer 2002.)
    ///
    /// # Errors
    /// A state that leads to no position on the constraints, a singular one, or a phase that is not known; `state` has not changed
    /// then.
    pub fn project(&mut self, time: f64, state: &mut State) -> Result<(), Error> {
        let mut moved = std::mem::take(&mut self.work.projected);
        moved.q.clone_from(&state.q);
        moved.v.clone_from(&state.v);
        let projected = self.project_in_place(time, &mut moved);
        if projected.is_ok() {
            std::mem::swap(state, &mut moved);
        }
        self.work.projected = moved;
        projected
    }

    fn project_in_place(&mut self, time: f64, state: &mut State) -> Result<(), Error> {
        self.check_phases()?;
        self.close(time, &mut state.q, &state.v)?;
        self.evaluate_rows(time, &state.q, &state.v)?;
        self.factor()?;
        self.solve_for(|system| &system.phi_rate)?;
        state.v.iter_mut().zip(&self.work.delta).for_each(|(v, w)| *v += w);
        Ok(())
    }

    fn close(&mut self, time: f64, q: &mut [f64], v: &[f64]) -> Result<(), Error> {
        let mut last = f64::INFINITY;
        for _ in 0..ITERATIONS {
            self.evaluate_rows(time, q, v)?;
            let missed = largest(&self.system.phi);
            // At the end rounding is all that is left: what does not shrink any more and is small is met.
            if missed <= CLOSED
                || missed >= last
                    && missed <= CLOSED * (1.0 + largest(&q[..self.coordinates.counted])).powi(2)
            {
                self.count_angles(q);
                return Ok(());
            }
            last = missed;
            self.factor()?;
            self.solve_for(|system| &system.phi)?;
            self.coordinates.retract(q, &self.work.delta);
        }
        let (row, residual) = self.worst_row();
        Err(Error::NotConverged { time, row, residual })
    }

    /// δ of M δ + Dᵀ μ = 0, D δ = −residual.
    fn solve_for(&mut self, residual: impl Fn(&System) -> &[f64]) -> Result<(), Error> {
        let Mechanism { system, work, .. } = self;
        work.upper.fill(0.0);
        work.lower.iter_mut().zip(residual(system)).for_each(|(lower, residual)| *lower = -residual);
        let solved = system.solve(&work.upper, &work.lower, &mut work.delta, &mut work.mu);
        solved.map_err(|_| self.singular())
    }

    /// Counted angles go on to the whole turns nearest to those they had, at the positions last evaluated.
    fn count_angles(&mut self, q: &mut [f64]) {
        let counted = self.coordinates.counted;
        for (slot, angle) in q[counted..].iter_mut().zip(&self.definition.counted) {
            *slot = angle.jet(&self.at).along.value;
        }
    }

    /// One step of the classical Runge–Kutta method (RK4) with held inputs; in space on q̇ = N(q) v, with Euler parameters at length one
    /// at its end. With [`Formulation::Projected`] it ends on the constraints.
    ///
    /// # Errors
    /// Those of [`acceleration`](Mechanism::acceleration) and [`project`](Mechanism::project); `state` has not changed then.
    pub fn step(
        &mut self,
        time: f64,
        state: &mut State,
        inputs: &[f64],
        formulation: Formulation,
        step: f64,
    ) -> Result<(), Error> {
        check_finite("the step", &[step])?;
        check_length("positions", state.q.len(), self.coordinates.positions)?;
        check_length("velocities", state.v.len(), self.coordinates.velocities)?;
        let mut stages = std::mem::take(&mut self.work.stages);
        let stepped = self.stepped(time, state, inputs, formulation, step, &mut stages);
        if stepped.is_ok() {
            std::mem::swap(state, &mut stages.end);
        }
        self.work.stages = stages;
        stepped
    }

    fn stepped(
        &mut self,
        time: f64,
        state: &State,
        inputs: &[f64],
        formulation: Formulation,
        step: f64,
        stages: &mut Stages,
    ) -> Result<(), Error> {
        /// Share of the step at which each evaluates, and its weight.
        const TABLEAU: [(f64, f64); 4] =
            [(0.0, 1.0 / 6.0), (0.5, 1.0 / 3.0), (0.5, 1.0 / 3.0), (1.0, 1.0 / 6.0)];
        let internal = self.coordinates.internal;
        stages.begin(state, self.row_count());
        let Stages { stage, end, q_rate, a, lambda } = stages;
        for (share, weight) in TABLEAU {
            let ahead = share * step;
            moved(&mut stage.q, &state.q, ahead, q_rate);
            moved(&mut stage.v, &state.v, ahead, a);
            self.acceleration(time + ahead, &stage.q, &stage.v, inputs, formulation, a, lambda)?;
            self.coordinates.rates(&stage.q, &stage.v, q_rate);
            self.write_internal_rates(inputs, lambda, &mut q_rate[internal..])?;
            end.q.iter_mut().zip(&*q_rate).for_each(|(q, rate)| *q += step * weight * rate);
            end.v.iter_mut().zip(&*a).for_each(|(v, a)| *v += step * weight * a);
        }
        self.coordinates.normalise(&mut end.q);
        if formulation == Formulation::Projected {
            self.project(time + step, end)?;
        } else if !self.definition.counted.is_empty() {
            self.coordinates.kinematics(time + step, &end.q, &end.v, &mut self.at)?;
            self.count_angles(&mut end.q);
        }
        Ok(())
    }

    /// Steps from `time` on, until `steps` are taken; returns the time reached. `inputs` gives the inputs at the start of each step.
    ///
    /// # Errors
    /// Those of [`step`](Mechanism::step); `state` is where the last step that succeeded ended.
    pub fn simulate(
        &mut self,
        time: f64,
        state: &mut State,
        mut inputs: impl FnMut(f64, &State) -> Vec<f64>,
        formulation: Formulation,
        step: f64,
        steps: usize,
    ) -> Result<f64, Error> {
        for k in 0..steps {
            let now = time + step * k as f64;
            let given = inputs(now, state);
            self.step(now, state, &given, formulation, step)?;
        }
        Ok(time + step * steps as f64)
    }
}

fn moved(to: &mut [f64], from: &[f64], by: f64, rate: &[f64]) {
    for ((to, from), rate) in to.iter_mut().zip(from).zip(rate) {
        *to = from + by * rate;
    }
}
