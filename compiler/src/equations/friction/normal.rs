//! N, the forces that press, as functions of v̇ and λ: what a function is given them for; and the parts of the loop that they close
//! where v̇ and λ are sought.

use super::bearing::pressing;
use super::magnitudes::{Coupled, magnitudes};
use crate::equations::Wrench;
use crate::equations::laws::Laws;
use crate::model::{Mechanism, value_at};
use crate::symbolic::{Class, Gradient, Node, Scalar, Sheet, all_bare};
use std::collections::BTreeMap;

/// |R| is √(R·R + ε²), so that it is smooth where nothing presses; ε is this part of the weight.
const SMALLEST: f64 = 1e-9;

/// Passes where the definition does not say.
const PASSES: usize = 2;

/// m/s², where no gravity is written.
const STANDARD_GRAVITY: f64 = 9.80665;

/// Frictions whose forces follow from reactions.
#[derive(Clone, Debug, Default)]
pub struct Friction {
    /// N of each, a symbol.
    pub normals: Vec<Node>,
    /// The components of the forces whose sizes together are N, in v̇, λ and N.
    pub pressing: Vec<Vec<Vec<Node>>>,
    /// ∂Q/∂N of each.
    pub columns: Vec<BTreeMap<usize, Node>>,
    /// The load of each.
    pub loads: Vec<usize>,
    /// N of each in v̇ and λ.
    pub given: Vec<Node>,
    /// Σ N ∂Q/∂N, in v̇ and λ.
    pub forces: Vec<Node>,
    /// ε², N².
    pub smallest: f64,
    /// How many passes the iteration for N takes.
    pub passes: usize,
}

impl Friction {
    /// Whether nothing rubs by a reaction in Q. The force of what is dry is no function of the state, but its N is.
    pub fn is_none(&self) -> bool {
        self.columns.iter().all(BTreeMap::is_empty)
    }

    /// Whether N of nothing follows from a reaction.
    pub fn presses_nowhere(&self) -> bool {
        self.normals.is_empty()
    }

    /// Each N by what it is in v̇ and λ.
    pub fn in_results(&self) -> BTreeMap<Node, Node> {
        self.normals.iter().copied().zip(self.given.iter().copied()).collect()
    }

    /// Each N by nothing.
    pub fn without(&self, g: Sheet) -> BTreeMap<Node, Node> {
        self.normals.iter().map(|normal| (*normal, g.zero().bare)).collect()
    }

    /// The forces that press, affine in N: with `replaced` in place of what they depend on, and by `seeds` for each N.
    pub fn coupled<'g>(
        &self,
        g: Sheet<'g>,
        mut replaced: BTreeMap<Node, Node>,
        mut seeds: BTreeMap<Node, Gradient>,
    ) -> Coupled<'g> {
        let one = g.one().bare;
        for (which, normal) in self.normals.iter().enumerate() {
            seeds.insert(*normal, Gradient::from([(which, one)]));
        }
        replaced.extend(self.without(g));
        let flat: Vec<Node> = self.pressing.iter().flatten().flatten().copied().collect();
        let values = g.graph().substitute(&flat, &replaced);
        let slopes = g.differentiate(&flat, &seeds);
        let (mut values, mut slopes) = (values.into_iter(), slopes.into_iter());
        let forces = self.pressing.iter().map(|forces| {
            let of = |force: &Vec<Node>| {
                let components = force.iter().map(|_| {
                    let value = values.next().map_or(g.zero(), |value| g.on(value));
                    (value, slopes.next().unwrap_or_default())
                });
                components.collect()
            };
            forces.iter().map(of).collect()
        });
        Coupled { forces: forces.collect(), smallest: self.smallest }
    }

    /// Q_f, Σ N ∂Q/∂N.
    fn forces(&self, g: Sheet, normals: &[Node], velocities: usize) -> Vec<Node> {
        let mut forces = vec![g.zero(); velocities];
        for (column, normal) in self.columns.iter().zip(normals) {
            for (velocity, entry) in column {
                forces[*velocity] += g.on(*entry) * *normal;
            }
        }
        all_bare(&forces)
    }
}

/// A symbol for N of each friction that has one.
pub fn symbols(g: Sheet, mechanism: &Mechanism) -> Vec<Node> {
    let rubbing = mechanism.loads.iter().filter(|load| load.normal.is_some());
    rubbing.map(|load| g.symbol(format!("normal_{}", load.name.identifier()), Class::Input).bare).collect()
}

/// What rubs by reactions. `forces`: Q; `reactions`: of the joints; both with N.
pub fn friction(laws: &Laws, forces: &[Node], reactions: &[Wrench]) -> Friction {
    let (g, mechanism) = (laws.g, laws.mechanism);
    let normals = laws.symbols.normals.clone();
    if normals.is_empty() {
        return Friction::default();
    }
    let rubbing = mechanism.loads.iter().enumerate().filter(|(_, load)| load.normal.is_some());
    let mut friction = Friction {
        normals,
        passes: mechanism.options.friction_passes.unwrap_or(PASSES),
        ..Friction::default()
    };
    for (index, load) in rubbing {
        let wrench = load.bearing().map(|joint| g.all(&reactions[joint.0])).unwrap_or_default();
        let forces = pressing(laws, load, &wrench);
        friction.loads.push(index);
        friction.pressing.push(forces.iter().map(|force| all_bare(force)).collect());
    }
    let one = g.one().bare;
    let own = friction.normals.iter().enumerate();
    let seeds = own.map(|(which, normal)| (*normal, Gradient::from([(which, one)]))).collect();
    let slopes = g.differentiate(forces, &seeds);
    friction.columns = (0..friction.normals.len())
        .map(|which| {
            let entries = slopes.iter().enumerate();
            entries.filter_map(|(velocity, slope)| Some((velocity, *slope.get(&which)?))).collect()
        })
        .collect();
    let defaults = mechanism.defaults();
    let mass: f64 = mechanism.bodies.iter().filter_map(|body| value_at(&body.mass, &defaults)).sum();
    let gravity = mechanism.gravity.as_ref().map_or(STANDARD_GRAVITY, |gravity| {
        let components = gravity.iter().filter_map(|component| value_at(component, &defaults));
        libm::sqrt(components.map(|component| component * component).sum())
    });
    let gravity = if gravity > 0.0 { gravity } else { STANDARD_GRAVITY };
    let smallest = SMALLEST * if mass > 0.0 { mass * gravity } else { 1.0 };
    friction.smallest = smallest * smallest;
    // v̇ and λ are given.
    let coupled = friction.coupled(g, BTreeMap::new(), BTreeMap::new());
    friction.given = all_bare(&magnitudes(g, &coupled, friction.passes));
    friction.forces = friction.forces(g, &friction.given, laws.layout.velocities());
    friction
}

/// v̇ and λ with friction.
pub struct Closed<'g> {
    pub results: Vec<Scalar<'g>>,
    /// Of each N: where the iteration begins, Σ |R| − N there, and where it ends.
    pub left: Vec<[Node; 3]>,
}

/// v̇ and λ of a linear solution by right-hand sides, without friction and for each N alone, closed by N.
pub fn closed<'g>(
    g: Sheet<'g>,
    friction: &Friction,
    results: &[Node],
    without: &[Scalar<'g>],
    columns: &[Vec<Scalar<'g>>],
) -> Closed<'g> {
    let replaced = results.iter().copied().zip(all_bare(without)).collect();
    let seeds = results.iter().enumerate().map(|(at, result)| {
        let own = columns.iter().enumerate().filter(|(_, column)| !column[at].is_zero());
        (*result, own.map(|(which, column)| (which, column[at].bare)).collect())
    });
    let coupled = friction.coupled(g, replaced, seeds.collect());
    let normals = magnitudes(g, &coupled, friction.passes);
    let start = coupled.sizes(g, &vec![g.zero(); normals.len()]);
    let [first, last] = [&start, &normals].map(|normals| coupled.sizes(g, normals));
    let ends = first.into_iter().zip(last).zip(normals.iter().zip(&start));
    let left = ends.map(|((first, last), (normal, start))| {
        [*start, first - *start, last - *normal].map(|scalar| scalar.bare)
    });
    let left = left.collect();
    let results = without.iter().enumerate().map(|(at, without)| {
        normals.iter().zip(columns).fold(*without, |sum, (normal, column)| sum + column[at] * *normal)
    });
    Closed { results: results.collect(), left }
}
