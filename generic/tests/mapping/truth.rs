//! What the generic solver says of a state: accelerations of bodies and modes, rates of internal states, efforts of drivers.

use super::{beams, state};
use linkwright_generic::{BodyMotion, Formulation, Mechanism};

/// A state of an emitted model.
pub struct At<'a> {
    pub time: f64,
    pub inputs: &'a [f64],
    pub internal: &'a [f64],
    pub motions: &'a [BodyMotion],
    /// Modes of beams: coordinate, rate and acceleration.
    pub modes: &'a [(String, [f64; 3])],
}

pub struct Truth {
    /// Of each body, linear and angular.
    bodies: Vec<[[f64; 3]; 2]>,
    modes: Vec<f64>,
    /// ż.
    rates: Vec<f64>,
    /// What the drivers exert.
    efforts: Vec<f64>,
}

impl Truth {
    pub fn of(name: &str, mechanism: &mut Mechanism, at: &At) -> Self {
        let mut state = state(mechanism, at.motions, at.internal);
        beams::set_modes(mechanism, &mut state, at.modes);
        let [mut a, mut lambda] = [mechanism.velocity_count(), mechanism.row_count()].map(|n| vec![0.0; n]);
        mechanism
            .acceleration(at.time, &state.q, &state.v, at.inputs, Formulation::Lagrange, &mut a, &mut lambda)
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut rates = vec![0.0; at.internal.len()];
        mechanism.internal_rates(at.time, &state, at.inputs, &lambda, &mut rates).expect("rates");
        let names: Vec<String> = mechanism.bodies().map(str::to_string).collect();
        let mut bodies = Vec::new();
        for body in &names {
            let found = mechanism.body(body, &state, &a).expect("a body");
            bodies.push([found.acceleration, found.angular_acceleration]);
        }
        let mut modes = Vec::new();
        for (mode, _) in at.modes {
            modes.push(mechanism.mode_acceleration(mode, &a).expect("a mode"));
        }
        // The force of a driver along its quantity is −λ.
        let drivers = mechanism.rows().enumerate().filter(|(_, row)| row.ends_with(".driver"));
        let efforts = drivers.map(|(row, _)| -lambda[row]).collect();
        Truth { bodies, modes, rates, efforts }
    }

    /// The largest difference of accelerations, relative to the largest acceleration or 1; or of a rate of an internal state, relative to the
    /// rate; or of an effort of a driver, relative to the largest.
    pub fn difference(
        &self,
        motions: &[BodyMotion],
        modes: &[(String, [f64; 3])],
        rates: &[f64],
        efforts: &[f64],
    ) -> f64 {
        let of_bodies = self.bodies.iter().zip(motions).flat_map(|(truth, motion)| {
            let found = [motion.acceleration, motion.angular_acceleration];
            truth.concat().into_iter().zip(found.concat())
        });
        let of_modes = self.modes.iter().copied().zip(modes.iter().map(|(_, [_, _, a])| *a));
        let (mut difference, mut size) = (0.0_f64, 1.0_f64);
        for (truth, found) in of_bodies.chain(of_modes) {
            difference = worse(difference, (found - truth).abs());
            size = size.max(truth.abs());
        }
        let of_rates =
            self.rates.iter().zip(rates).map(|(truth, it)| (it - truth).abs() / truth.abs().max(1.0));
        assert_eq!(self.efforts.len(), efforts.len(), "drivers");
        let largest = self.efforts.iter().fold(1.0_f64, |most, effort| most.max(effort.abs()));
        let of_efforts = self.efforts.iter().zip(efforts).map(|(truth, it)| (it - truth).abs() / largest);
        of_rates.chain(of_efforts).fold(difference / size, worse)
    }
}

/// The larger one, and what is no number above all.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}
