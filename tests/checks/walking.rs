//! Random consistent states of any model: a walk along its constraints from the start.
//!
//! Each step takes a random velocity, made consistent, moves along it and puts the position back on the constraints;
//! the branch of the start is kept, because the steps are small.

use crate::registry::{At, Model, Random, compiled, fields, gates, vector};
use linkwright::{AssembleExt, Vector, project_position, project_velocity, retract, smallest_pivot};
use linkwright_compiler::Compiled;

/// Steps between two states that are used.
const STRIDE: usize = 5;

/// A relative pivot of D Dᵀ below which a position is too near a singular one to be compared at.
const REGULAR: f64 = 1e-5;

/// `count` consistent states of a model with random parameters (also given), with random velocities and inputs.
pub fn walk<M: Model>(seed: u64, count: usize) -> (Compiled, Vec<f64>, M, Vec<At<M>>) {
    let compiled = compiled::<M>(None);
    let mut random = Random::new(seed);
    let parameters = random.parameters(&compiled);
    let model = M::prepared(&parameters).expect("parameters near their defaults");
    let near = model.start();
    let mut q = model.assemble(&near).unwrap_or_else(|error| panic!("{}: {error}", model.name())).q;
    let (mut time, mut states, mut tries) = (0.0, Vec::new(), 0);
    while states.len() < count {
        tries += 1;
        assert!(tries < 50 * count, "{}: the walk got stuck after {} states", model.name(), states.len());
        let Some(next) = stride(&model, &mut random, time, &q) else { continue };
        (time, q) = next;
        if smallest_pivot(&model, time, &q).0 < REGULAR {
            continue;
        }
        let Ok(v) = project_velocity(&model, time, &q, &velocity::<M>(&mut random)) else { continue };
        let u = fields(&random.vector(compiled.mechanism.inputs.len()));
        let z = vector(&random.internal(&compiled));
        let gates = vector(&gates(&compiled.mechanism, || random.unit()));
        states.push(At { time, q, v, z, gates, u });
    }
    (compiled, parameters, model, states)
}

fn stride<M: Model>(model: &M, random: &mut Random, time: f64, q: &M::Q) -> Option<(f64, M::Q)> {
    let (mut time, mut q) = (time, *q);
    let wish = velocity::<M>(random);
    for _ in 0..STRIDE {
        let v = project_velocity(model, time, &q, &wish).ok()?;
        let h = 0.05 / (1.0 + v.max_abs());
        let mut ahead = q;
        retract(model.layout(), &q, &v.scaled(h), &mut ahead);
        time += h;
        q = project_position(model, time, &ahead).ok()?;
    }
    Some((time, q))
}

fn velocity<M: Model>(random: &mut Random) -> M::V {
    let model = M::standard();
    vector(&random.vector(model.velocity_names().len()))
}
