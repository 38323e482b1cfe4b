//! The shipped models against closed forms and published runs. Data files are in `tests/data`, each with its source in
//! its first line; single numbers are cited where they stand.

mod adams;
mod backlash;
mod beams;
mod beams_in_space;
mod benchmarks;
mod bristles;
mod cables;
mod cams;
mod closed_forms;
mod contacts;
mod curves;
mod four_bars;
mod friction;
mod gears;
mod hydraulics;
mod hysteresis;
mod impacts;
mod laws;
mod linkages;
mod meshes;
mod modal;
mod parts;
mod penalties;
mod planets;
mod quick_return;
mod robots;
mod rolling;
mod shafts;
mod space;
mod states;
mod teeth_on_bearings;
mod teeth_press;
mod vehicles;

use linkwright::{Assemble, Baumgarte, Sample, SimulationError, StateOf};

/// A file of comma-separated numbers: comments, one line of names, rows.
struct Table {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Table {
    fn new(text: &str) -> Self {
        let mut lines = text.lines().filter(|line| !line.starts_with('#') && !line.trim().is_empty());
        let names = lines.next().expect("a line of names").split(',').map(str::to_string).collect();
        let number = |field: &str| field.parse().unwrap_or_else(|_| panic!("`{field}` is no number"));
        let rows: Vec<Vec<f64>> = lines.map(|line| line.split(',').map(number).collect()).collect();
        assert!(rows.len() > 5, "a table with rows");
        Table { names, rows }
    }

    /// The value in a column of a row.
    fn get(&self, row: usize, name: &str) -> f64 {
        let column = self.names.iter().position(|known| known == name);
        self.rows[row][column.unwrap_or_else(|| panic!("no column `{name}`"))]
    }
}

/// Both of Baumgarte's coefficients.
fn baumgarte(coefficient: f64) -> Baumgarte<f64> {
    Baumgarte { alpha: coefficient, beta: coefficient }
}

/// Runs a mechanism without inputs from `start` at time zero and shows the sample at every `every`-th step.
fn run<M: Assemble<f64, Inputs = ()>>(
    model: &M,
    start: StateOf<M>,
    (coefficient, step): (f64, f64),
    end: f64,
    every: usize,
    mut show: impl FnMut(usize, &Sample<'_, f64, M>),
) -> Result<StateOf<M>, SimulationError> {
    let mut count = 0;
    let mut simulation =
        linkwright::Simulation::new(model, start).formulation(baumgarte(coefficient)).step(step);
    simulation.run_until(end, |sample| {
        if count % every == 0 {
            show(count / every, sample);
        }
        count += 1;
    })
}

/// Keeps the largest of many deviations, to print it and to hold it under a bound.
#[derive(Default)]
struct Worst(f64);

impl Worst {
    fn see(&mut self, found: f64, expected: f64) {
        let deviation = (found - expected).abs();
        // A NaN counts as infinitely wrong.
        self.0 = self.0.max(if deviation.is_nan() { f64::INFINITY } else { deviation });
    }

    #[track_caller]
    fn below(&self, bound: f64, what: &str) {
        println!("{what}: {:.2e} (bound {bound:.0e})", self.0);
        assert!(self.0 <= bound, "{what}: off by {:.3e}, more than {bound:.0e}", self.0);
    }
}

/// A(q) of a unit quaternion (w, x, y, z).
fn orientation([w, x, y, z]: [f64; 4]) -> [[f64; 3]; 3] {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// The entries of two matrices, one against the other.
fn see_matrix(worst: &mut Worst, found: [[f64; 3]; 3], expected: [[f64; 3]; 3]) {
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        worst.see(*found, *expected);
    }
}
