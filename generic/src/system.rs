//! The augmented system of a definition, assembled at run time:
//!
//! ```text
//! [ M  Dᵀ ] [ v̇ ]   [ Q ]
//! [ D  −c ] [ λ ] = [ γ ]
//! ```
//!
//! M is constant and of blocks, because bodies are referred to their centres of mass and their own axes: m 1 and J. Q is gravity, loads
//! and −ω × J ω. c is zero, unless the definition says that rows may repeat others; see [`System::solve`].

use crate::coordinates::{Coordinates, Kind};
use crate::definition::{Body, Definition};
use crate::kinematics::Kinematics;
use crate::law::Scratch;
use crate::solver::{Algebra, NoFactors, Solver};
use crate::vector::*;

#[derive(Debug)]
pub(crate) struct System {
    /// Stored entries of M (row, column, value).
    mass: Vec<(usize, usize, f64)>,
    /// Beams, whose entries move, and where these begin.
    beams: Vec<(usize, usize)>,
    /// Stored entries of D, row by row.
    pub jacobian: Vec<f64>,
    /// (row, column) of each.
    pub pattern: Vec<(usize, usize)>,
    /// By row: bodies, and where their entries begin.
    blocks: Vec<Vec<(usize, usize)>>,
    /// c, 1/kg; `None` where rows are independent.
    compliance: Option<f64>,
    pub forces: Vec<f64>,
    pub phi: Vec<f64>,
    /// Φ̇.
    pub phi_rate: Vec<f64>,
    /// What Φ̈ is where no velocity changes: −γ.
    pub bias: Vec<f64>,
    right: Vec<f64>,
    previous: Vec<f64>,
    solver: Solver,
    scratch: Scratch,
}

/// Share of the largest inverse mass that softens rows which may repeat others. Its square root is far above rounding, its size far
/// below what constraints have.
const SOFT: f64 = 1e-7;

/// Solutions with one factorisation, each of which takes as much of what softened rows lack as c is smaller than D M⁻¹ Dᵀ.
const REPEATS: usize = 12;

/// A row of which no more is left across the others is a combination of them.
const DEPENDENT: f64 = 1e-8;

/// A solution so much larger than its right-hand side is rounding.
const LARGEST: f64 = 1e12;

impl System {
    pub fn new(
        definition: &Definition,
        coordinates: &Coordinates,
        algebra: Algebra,
    ) -> Result<Self, NoFactors> {
        let (mut mass, mut beams) = (Vec::new(), Vec::new());
        for (index, (body, slot)) in definition.bodies.iter().zip(&coordinates.slots).enumerate() {
            if body.beam.is_some() {
                beams.push((index, mass.len()));
                let width = slot.width();
                mass.extend((0..width * width).map(|k| (slot.v + k / width, slot.v + k % width, body.mass)));
                continue;
            }
            mass.extend(mass_entries(body, slot.kind).map(|(i, j, x)| (slot.v + i, slot.v + j, x)));
        }
        let (mut pattern, mut blocks) = (Vec::new(), Vec::new());
        for (row, equation) in definition.rows.iter().enumerate() {
            let mut block = Vec::new();
            for body in equation.bodies() {
                let slot = &coordinates.slots[body];
                block.push((body, pattern.len()));
                pattern.extend((0..slot.width()).map(|k| (row, slot.v + k)));
            }
            blocks.push(block);
        }
        let (n, m) = (coordinates.velocities, definition.rows.len());
        let heaviest = mass.iter().fold(0.0_f64, |most, (_, _, x)| most.max(x.abs()));
        let compliance = (definition.redundant && heaviest > 0.0).then(|| SOFT / heaviest);
        let mut all: Vec<(usize, usize)> = mass.iter().map(|(i, j, _)| (*i, *j)).collect();
        all.extend(pattern.iter().map(|(row, column)| (n + row, *column)));
        all.extend(pattern.iter().map(|(row, column)| (*column, n + row)));
        all.extend((n..n + m).filter(|_| compliance.is_some()).map(|at| (at, at)));
        let solver = Solver::new(n + m, &all, algebra)?;
        Ok(System {
            mass,
            beams,
            jacobian: vec![0.0; pattern.len()],
            pattern,
            blocks,
            compliance,
            forces: vec![0.0; n],
            phi: vec![0.0; m],
            phi_rate: vec![0.0; m],
            bias: vec![0.0; m],
            right: vec![0.0; n + m],
            previous: vec![0.0; m],
            solver,
            scratch: Scratch::default(),
        })
    }

    /// D, Φ, Φ̇ and the bias of Φ̈.
    pub fn evaluate_rows(&mut self, definition: &Definition, coordinates: &Coordinates, at: &Kinematics) {
        for (body, start) in &self.beams {
            let Some(beam) = at.beam(*body) else { continue };
            let width = coordinates.slots[*body].width();
            let block = &mut self.mass[*start..*start + width * width];
            block.iter_mut().for_each(|(_, _, x)| *x = 0.0);
            beam.mass(&at.frames[*body], at.modes(*body, beam), |i, j, x| block[i * width + j].2 += x);
        }
        self.jacobian.fill(0.0);
        for (row, equation) in definition.rows.iter().enumerate() {
            let (jacobian, blocks) = (&mut self.jacobian, &self.blocks[row]);
            let course = equation.evaluate(at, &mut self.scratch, |pull| {
                let Some(body) = pull.body else { return };
                if let Some((_, start)) = blocks.iter().find(|(of, _)| *of == body) {
                    let (frame, bent) = (&at.frames[body], at.bent(body));
                    coordinates.slots[body].add(frame, bent, &pull, &mut jacobian[*start..]);
                }
            });
            self.phi[row] = course.value;
            self.phi_rate[row] = course.rate;
            self.bias[row] = course.bias;
        }
    }

    /// Q.
    pub fn evaluate_forces(
        &mut self,
        definition: &Definition,
        coordinates: &Coordinates,
        at: &Kinematics,
        inputs: &[f64],
    ) {
        let forces = &mut self.forces;
        forces.fill(0.0);
        let bodies = definition.bodies.iter().zip(&coordinates.slots).zip(&at.frames).enumerate();
        for (index, ((body, slot), frame)) in bodies {
            if let Some(beam) = at.beam(index) {
                let own = &mut forces[slot.v..slot.v + slot.width()];
                beam.forces(frame, at.modes(index, beam), definition.gravity, own);
                continue;
            }
            for k in 0..if definition.spatial { 3 } else { 2 } {
                forces[slot.v + k] += body.mass * definition.gravity[k];
            }
            if slot.kind == Kind::Space {
                let omega = turned_back(&frame.axes, frame.spin);
                let gyroscopic = cross(turned(&body.inertia, omega), omega);
                for k in 0..3 {
                    forces[slot.v + 3 + k] += gyroscopic[k];
                }
            }
        }
        for load in &definition.loads {
            load.evaluate(at, inputs, &mut self.scratch, |pull| {
                let Some(body) = pull.body else { return };
                let slot = &coordinates.slots[body];
                slot.add(&at.frames[body], at.bent(body), &pull, &mut forces[slot.v..]);
            });
        }
    }

    /// Factorises the augmented matrix of the rows as last evaluated.
    pub fn factor(&mut self) -> Result<(), NoFactors> {
        let mass = self.mass.iter().map(|(_, _, x)| *x);
        let jacobian = self.jacobian.iter().copied();
        let soft = self.compliance.into_iter().flat_map(|c| std::iter::repeat_n(-c, self.phi.len()));
        self.solver.factor(mass.chain(jacobian.clone()).chain(jacobian).chain(soft))
    }

    /// x and μ of M x + Dᵀ μ = upper, D x = lower with the last factors.
    ///
    /// Where rows may repeat others, λ is not unique and the matrix with c = 0 is singular. It is then solved with c > 0 and
    /// lower − c λ in place of lower, again and again from λ = 0 on (the proximal form of the augmented Lagrangian). What it comes to has
    /// c = 0 again: x is exact and λ that of least norm, because each iterate is in the range of D. Where rows that repeat others contradict
    /// them, as drift does, something stays missed: D x = lower holds as nearly as it can, and λ has grown by the same from round to
    /// round, along what exerts nothing; that is taken back.
    pub fn solve(
        &mut self,
        upper: &[f64],
        lower: &[f64],
        x: &mut [f64],
        mu: &mut [f64],
    ) -> Result<(), NoFactors> {
        let (n, repeats) = (upper.len(), if self.compliance.is_some() { REPEATS } else { 1 });
        let c = self.compliance.unwrap_or(0.0);
        self.previous.fill(0.0);
        let mut last = f64::INFINITY;
        for round in 1..=repeats {
            self.right[..n].copy_from_slice(upper);
            for ((right, wanted), mu) in self.right[n..].iter_mut().zip(lower).zip(&self.previous) {
                *right = wanted - c * mu;
            }
            self.solver.solve(&mut self.right);
            if !self.right.iter().all(|x| x.is_finite()) {
                return Err(NoFactors);
            }
            x.copy_from_slice(&self.right[..n]);
            mu.copy_from_slice(&self.right[n..]);
            let missed = mu.iter().zip(&self.previous).map(|(a, b)| c * (a - b).abs()).fold(0.0, f64::max);
            if missed <= 1e-14 * (largest(lower) + largest(x)) {
                break;
            }
            if missed > 0.5 * last {
                for (mu, previous) in mu.iter_mut().zip(&self.previous) {
                    *mu -= round as f64 * (*mu - previous);
                }
                break;
            }
            last = missed;
            self.previous.copy_from_slice(mu);
        }
        self.check(upper, lower, x, mu)
    }

    /// A singular matrix gives finite numbers too, but such as have nothing to do with the right-hand side.
    fn check(&self, upper: &[f64], lower: &[f64], x: &[f64], mu: &[f64]) -> Result<(), NoFactors> {
        let mut size = 0.0_f64;
        for (i, j, entry) in &self.mass {
            size = size.max((entry * x[*j]).abs()).max((entry * x[*i]).abs());
        }
        for ((row, column), entry) in self.pattern.iter().zip(&self.jacobian) {
            size = size.max((entry * x[*column]).abs()).max((entry * mu[*row]).abs());
        }
        if size > LARGEST * largest(upper).max(largest(lower)) { Err(NoFactors) } else { Ok(()) }
    }

    /// The first row of D that depends on those before it, by Gram and Schmidt.
    pub fn dependent_row(&self) -> Option<usize> {
        let n = self.forces.len();
        let mut base: Vec<Vec<f64>> = Vec::new();
        for row in 0..self.phi.len() {
            let mut rest = vec![0.0; n];
            for ((_, column), entry) in self.pattern.iter().zip(&self.jacobian).filter(|(at, _)| at.0 == row)
            {
                rest[*column] = *entry;
            }
            let length = norm_of(&rest);
            // Twice, so that what is left is across the others to rounding.
            for unit in base.iter().chain(&base) {
                let along: f64 = unit.iter().zip(&rest).map(|(a, b)| a * b).sum();
                rest.iter_mut().zip(unit).for_each(|(rest, unit)| *rest -= along * unit);
            }
            let left = norm_of(&rest);
            if left <= DEPENDENT * length {
                return Some(row);
            }
            rest.iter_mut().for_each(|x| *x /= left);
            base.push(rest);
        }
        None
    }
}

fn norm_of(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum::<f64>().sqrt()
}

pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| x.abs().max(most))
}

/// m along the linear velocities, J about the angular ones.
fn mass_entries(body: &Body, kind: Kind) -> impl Iterator<Item = (usize, usize, f64)> {
    let linear = if matches!(kind, Kind::Space | Kind::SpaceParticle) { 3 } else { 2 };
    let mut entries: Vec<_> = (0..linear).map(|k| (k, k, body.mass)).collect();
    match kind {
        Kind::Plane => entries.push((2, 2, body.inertia[2][2])),
        Kind::Space => {
            for i in 0..3 {
                entries.extend((0..3).map(|j| (3 + i, 3 + j, body.inertia[i][j])));
            }
        }
        Kind::PlaneParticle | Kind::SpaceParticle => {}
    }
    entries.into_iter()
}
