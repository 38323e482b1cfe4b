//! By how much beams are turned and pressed at the start, against what they take: their first clamped frequency and Euler's load.

use super::{at, clamps, has_bending, slenderness, thrusts, ways};
use crate::check::assemble::{Ancestry, Assembly, Point};
use crate::check::rules::at_defaults;
use crate::equations::Equations;
use crate::model::{Beam, BodyId, Expr, Mechanism, Space};
use crate::solve::Solved;
use std::f64::consts::PI;

/// The first root of the clamped beam, squared.
const CLAMPED: f64 = 1.875_104_068_711_961_1 * 1.875_104_068_711_961_1;

/// Of a beam that bends.
#[derive(Clone, Debug)]
pub struct Strain {
    pub body: BodyId,
    /// Its length in radii of gyration √(I/A) of its section.
    pub slenderness: f64,
    /// Its rate across its axis at the start, and its first clamped frequency, rad/s.
    pub rate: f64,
    pub natural: f64,
    /// What its joints press it together with at the start, and Euler's load, N; nothing where no joint is on it.
    pub pressed: Option<[f64; 2]>,
    /// Whether inputs have a part in that.
    pub by_inputs: bool,
}

/// Of each beam that bends.
pub fn strains(
    mechanism: &Mechanism,
    equations: &Equations,
    solved: &Solved,
    assembly: &Assembly,
) -> Vec<Strain> {
    if !mechanism.bodies.iter().any(|body| body.beam().is_some_and(has_bending)) {
        return Vec::new();
    }
    let mut point = Point::at_start(mechanism, equations, assembly);
    let index1 = &solved.index1;
    let results = || index1.acceleration.iter().chain(&index1.lambda).copied();
    point.evaluate(&Ancestry::of(equations, results()));
    let values =
        |nodes: &[crate::symbolic::Node]| nodes.iter().map(|node| point.get(*node)).collect::<Vec<_>>();
    let (acceleration, lambda) = (values(&index1.acceleration), values(&index1.lambda));
    point.set(&equations.symbols.acceleration, &acceleration);
    point.set(&equations.symbols.lambda, &lambda);
    let motions = equations.motions.iter().flat_map(|motion| motion.flat());
    let reactions = equations.reactions.iter().flatten().copied();
    point.evaluate(&Ancestry::of(equations, motions.chain(reactions)));
    let by_inputs = results().any(|node| equations.takes_inputs(node));
    let bodies = mechanism.bodies.iter().enumerate();
    let beams =
        bodies.filter_map(|(index, body)| Some((index, body.beam().filter(|beam| has_bending(beam))?)));
    beams
        .filter_map(|(index, beam)| strain(mechanism, equations, &mut point, index, beam, by_inputs))
        .collect()
}

fn strain(
    mechanism: &Mechanism,
    equations: &Equations,
    point: &mut Point,
    index: usize,
    beam: &Beam,
    by_inputs: bool,
) -> Option<Strain> {
    let value = |expr: &Expr| at_defaults(mechanism, expr);
    let softest = ways(beam).filter_map(|way| value(beam.rigidity(way))).reduce(f64::min)?;
    let mass = value(&mechanism.bodies[index].mass)?;
    let length = beam.slender.length;
    let natural = CLAMPED * (softest / (mass * length.powi(3))).sqrt();
    // Across the axis: in the plane there is no other rate.
    let rates = equations.motions[index].rate.iter().map(|node| point.get(*node)).collect::<Vec<_>>();
    let rate = match rates.as_slice() {
        [_, y, z] => y.hypot(*z),
        rates => rates.iter().fold(0.0, |sum: f64, rate| sum.hypot(*rate)),
    };
    // The axis of its frame: (cos, sin), or the first column of the matrix.
    let orientation = &equations.motions[index].orientation;
    let along: Vec<f64> = match mechanism.space {
        Space::Planar => orientation.iter().map(|node| point.get(*node)).collect(),
        Space::Spatial => orientation.iter().step_by(3).map(|node| point.get(*node)).collect(),
    };
    let ends = thrusts(mechanism, index, beam, |joint| {
        let force = equations.reactions[joint].iter();
        along.iter().zip(force).map(|(along, force)| along * point.get(*force)).sum()
    });
    let thrust = match ends {
        [Some(start), Some(end)] => Some(0.5 * (start + end)),
        [start, end] => start.or(end),
    };
    // A column on a foot whose head sways, or one between two hinges.
    let one_end = ends.iter().flatten().count() == 1;
    let sways = || clamps::sways(mechanism, BodyId(index), beam, &at(mechanism, index, beam.slender.from));
    let factor = if one_end || sways() { 0.25 } else { 1.0 };
    let euler = factor * PI * PI * softest / (length * length);
    Some(Strain {
        body: BodyId(index),
        slenderness: slenderness(mechanism, beam)?,
        rate,
        natural,
        pressed: thrust.map(|thrust| [thrust, euler]),
        by_inputs,
    })
}
