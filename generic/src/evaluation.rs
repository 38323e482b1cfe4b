//! What is evaluated at a state: accelerations, rates of internal states, residuals, energies. What solves is in `system`.

use crate::coordinates::check_finite;
use crate::definition::Definition;
use crate::energy::{kinetic, potential};
use crate::error::Error;
use crate::law::Scratch;
use crate::load::Acts;
use crate::mechanism::{Formulation, Mechanism, State, check_length};
use crate::row::{Equation, Phase};
use crate::system::largest;

/// The most solutions for friction.
const MOST_PASSES: usize = 200;

impl Mechanism {
    /// v̇ and λ at a state: of M v̇ + Dᵀ λ = Q and D v̇ = γ, with Baumgarte's terms where the formulation has them.
    ///
    /// λ in the order of [`rows`](Mechanism::rows); −Dᵀ λ is what the constraints exert. Where rows repeat others, λ is that of least
    /// norm.
    ///
    /// # Errors
    /// Lists of other lengths, values that are not finite, a singular position, or Baumgarte's terms of a coupling whose phase is not
    /// known. What was in `a` and `lambda` is then without meaning.
    #[allow(clippy::too_many_arguments)]
    pub fn acceleration(
        &mut self,
        time: f64,
        q: &[f64],
        v: &[f64],
        inputs: &[f64],
        formulation: Formulation,
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<(), Error> {
        check_length("inputs", inputs.len(), self.definition.inputs.len())?;
        check_length("accelerations", a.len(), self.coordinates.velocities)?;
        check_length("multipliers", lambda.len(), self.definition.rows.len())?;
        check_finite("an input", inputs)?;
        self.evaluate_rows(time, q, v)?;
        self.at.multipliers.clear();
        let Mechanism { definition, coordinates, system, at, work, .. } = self;
        system.evaluate_forces(definition, coordinates, at, inputs);
        if !system.forces.iter().all(|force| force.is_finite()) {
            return Err(self.force_not_finite(inputs));
        }
        let lower = &mut work.lower;
        lower.iter_mut().zip(&system.bias).for_each(|(lower, bias)| *lower = -bias);
        if let Formulation::Baumgarte { alpha, beta } = formulation {
            check_finite("a coefficient of Baumgarte's", &[alpha, beta])?;
            for ((lower, rate), phi) in lower.iter_mut().zip(&system.phi_rate).zip(&system.phi) {
                *lower -= 2.0 * alpha * rate + beta * beta * phi;
            }
            self.check_phases()?;
        }
        self.factor()?;
        let Mechanism { system, work, .. } = self;
        work.upper.copy_from_slice(&system.forces);
        let solved = system.solve(&work.upper, &work.lower, a, lambda);
        solved.map_err(|_| self.singular())?;
        if !self.definition.loads.iter().any(|load| matches!(load.acts, Acts::Friction(_))) {
            return Ok(());
        }
        match self.friction_passes {
            Some(passes) => self.rub_in_passes(passes, inputs, a, lambda),
            None => self.rub(inputs, a, lambda),
        }
    }

    /// The same with the friction that the multipliers make, again and again.
    fn rub(&mut self, inputs: &[f64], a: &mut [f64], lambda: &mut [f64]) -> Result<(), Error> {
        let mut last = f64::INFINITY;
        for _ in 0..MOST_PASSES {
            self.at.multipliers.clear();
            self.at.multipliers.extend_from_slice(lambda);
            let before = a.to_vec();
            let Mechanism { definition, coordinates, system, at, work, .. } = self;
            system.evaluate_forces(definition, coordinates, at, inputs);
            work.upper.copy_from_slice(&system.forces);
            let solved = system.solve(&work.upper, &work.lower, a, lambda);
            solved.map_err(|_| self.singular())?;
            let change = a.iter().zip(&before).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // To rounding, below which it only moves to and fro.
            if change <= 1e-15 * largest(a) || change >= last && change <= 1e-12 * largest(a) {
                break;
            }
            last = change;
        }
        self.at.multipliers.clear();
        self.at.multipliers.extend_from_slice(lambda);
        Ok(())
    }

    /// ż of the internal states at a state with its multipliers, which [`acceleration`](Mechanism::acceleration) gives, in their SI units
    /// per second.
    ///
    /// # Errors
    /// Lists of other lengths, or values that are not finite.
    pub fn internal_rates(
        &mut self,
        time: f64,
        state: &State,
        inputs: &[f64],
        lambda: &[f64],
        rates: &mut [f64],
    ) -> Result<(), Error> {
        check_length("inputs", inputs.len(), self.definition.inputs.len())?;
        check_finite("an input", inputs)?;
        check_length("multipliers", lambda.len(), self.definition.rows.len())?;
        check_length("rates of internal states", rates.len(), self.definition.states.len())?;
        self.coordinates.kinematics(time, &state.q, &state.v, &mut self.at)?;
        self.write_internal_rates(inputs, lambda, rates)
    }

    /// At the state last evaluated.
    pub(crate) fn write_internal_rates(
        &mut self,
        inputs: &[f64],
        lambda: &[f64],
        rates: &mut [f64],
    ) -> Result<(), Error> {
        self.at.multipliers.clear();
        self.at.multipliers.extend_from_slice(lambda);
        for (rate, state) in rates.iter_mut().zip(&self.definition.states) {
            *rate = state.rate.value(&self.at, inputs, &mut self.work.scratch);
            if !rate.is_finite() {
                return Err(Error::NotFinite {
                    what: format!("the rate of `{}`", state.name),
                    time: self.at.time,
                });
            }
        }
        Ok(())
    }

    /// D, Φ, Φ̇ and γ at a state, all finite.
    pub(crate) fn evaluate_rows(&mut self, time: f64, q: &[f64], v: &[f64]) -> Result<(), Error> {
        let Mechanism { definition, coordinates, system, at, .. } = self;
        coordinates.kinematics(time, q, v, at)?;
        system.evaluate_rows(definition, coordinates, at);
        let rows = system.phi.iter().zip(&system.phi_rate).zip(&system.bias);
        let finite = |((phi, rate), bias): ((&f64, &f64), &f64)| (phi + rate + bias).is_finite();
        let what = match rows.map(finite).position(|finite| !finite) {
            Some(row) => row,
            None => match system.jacobian.iter().position(|entry| !entry.is_finite()) {
                Some(entry) => system.pattern[entry].0,
                None => return Ok(()),
            },
        };
        Err(Error::NotFinite { what: definition.rows[what].name(), time })
    }

    pub(crate) fn factor(&mut self) -> Result<(), Error> {
        let factored = self.system.factor();
        factored.map_err(|_| self.singular())
    }

    /// The load that did it, if it is one.
    fn force_not_finite(&self, inputs: &[f64]) -> Error {
        let mut scratch = Scratch::default();
        let bad = self.definition.loads.iter().find(|load| {
            let mut finite = true;
            load.evaluate(&self.at, inputs, &mut scratch, |pull| {
                finite &= pull.linear.iter().chain(&pull.angular).all(|x| x.is_finite());
            });
            !finite
        });
        let what = bad.map_or("a force".to_string(), |load| format!("the load `{}`", load.name));
        Error::NotFinite { what, time: self.at.time }
    }

    pub(crate) fn singular(&self) -> Error {
        let row = self.system.dependent_row().map(|row| self.definition.rows[row].name());
        Error::Singular { time: self.at.time, row }
    }

    /// The row that is met worst, and Φ.
    pub(crate) fn worst_row(&self) -> (String, f64) {
        let worst =
            self.system.phi.iter().zip(&self.definition.rows).max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        worst.map_or((self.definition.name.clone(), 0.0), |(phi, row)| (row.name(), phi.abs()))
    }

    pub(crate) fn check_phases(&self) -> Result<(), Error> {
        let open = self
            .definition
            .rows
            .iter()
            .find(|row| matches!(row.equation, Equation::Sum { phase: Phase::Open, .. }));
        match open {
            Some(row) => Err(Error::Phase { name: row.of.clone() }),
            None => Ok(()),
        }
    }

    /// The phases of gears and racks that are not written become what these positions give.
    ///
    /// # Errors
    /// Positions of another number, or not finite.
    pub fn keep_phases(&mut self, time: f64, q: &[f64]) -> Result<(), Error> {
        let rest = vec![0.0; self.coordinates.velocities];
        self.evaluate_rows(time, q, &rest)?;
        for (row, phi) in self.definition.rows.iter_mut().zip(&self.system.phi) {
            if let Equation::Sum { phase, .. } = &mut row.equation {
                *phase = match *phase {
                    Phase::Given(given) => Phase::Given(given),
                    Phase::Open => Phase::Kept(*phi),
                    Phase::Kept(kept) => Phase::Kept(kept + phi),
                };
            }
        }
        for load in &mut self.definition.loads {
            if let Acts::Mesh(mesh) = &mut load.acts {
                mesh.settle(&self.at);
            }
        }
        Ok(())
    }

    /// Largest |Φ| and |Φ̇| of the constraints at a state.
    ///
    /// # Errors
    /// As [`acceleration`](Mechanism::acceleration).
    pub fn residual(&mut self, time: f64, state: &State) -> Result<[f64; 2], Error> {
        self.check_phases()?;
        self.evaluate_rows(time, &state.q, &state.v)?;
        Ok([largest(&self.system.phi), largest(&self.system.phi_rate)])
    }

    /// T = ½ vᵀ M v and V of gravity and springs, J.
    ///
    /// # Errors
    /// Lists of other lengths, or values that are not finite.
    pub fn energy(&mut self, time: f64, state: &State) -> Result<[f64; 2], Error> {
        let Mechanism { definition, coordinates, at, .. } = self;
        coordinates.kinematics(time, &state.q, &state.v, at)?;
        let Definition { bodies, loads, gravity, .. } = definition;
        Ok([kinetic(bodies, at), potential(bodies, loads, *gravity, at)])
    }
}
