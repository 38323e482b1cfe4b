//! Bodies that can move while all others stand still: those that hang on one joint, and those that are held by several and
//! have an idle freedom nevertheless, as a rod that spins between two spherical joints.
//!
//! A group of bodies is moved as one (its twist: the velocity of a point and an angular velocity), the rest held: it is
//! loose if the rows of D in absolute coordinates admit that; held by several joints, also if they are still met when it has moved,
//! for at a dead centre there is a velocity that leads nowhere. Groups are single bodies with what is fixed to them, and
//! chains of such with two joints each, as the two halves of a leg.

use super::point::{Ancestry, Point, retract};
use super::world::{Vec3, World, add, cross, dot, length, sub};
use super::{carry_state, messages};
use crate::equations::{Ball, Equations, Linear, Omitted, Rotation, SpanningTree, derive};
use crate::model::{BodyId, Frame, Joint, JointId, Mechanism, Name, Space};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Bodies that move alone.
#[derive(Clone, Debug)]
pub struct Loose {
    pub members: Vec<BodyId>,
    /// Their names.
    pub bodies: Vec<Name>,
    /// In how many ways.
    pub freedoms: usize,
    /// The joints that hold them, none or one of a body that hangs.
    pub joints: Vec<Name>,
    pub way: Way,
}

/// How they move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// No joint holds them.
    Floating,
    /// As their only joint admits.
    Hanging(crate::forms::Alone),
    /// About the line through the places of two joints; whether both are spherical.
    Spinning {
        spherical: bool,
    },
    /// About the place of a joint.
    Turning,
    /// Without turning.
    Sliding,
    Otherwise,
}

/// `"coupler" can spin about its own axis between its two spherical joints "a" and "b"`
impl fmt::Display for Loose {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&messages::loose(self))
    }
}

/// Longest chain that is moved as one.
const CHAIN: usize = 4;
/// Pivots of rows of length one below this are rounding.
const NONE: f64 = 1e-9;
/// How far a body is moved, rad or m.
const FINITE: f64 = 0.1;
/// How much a row may then miss by, as a part of what it would at first.
const LEFT: f64 = 1e-4;
/// Distances from an axis, by the distance of places, below this are zero.
const ON_AXIS: f64 = 1e-6;

/// The bodies that move alone at `q`, drivers removed.
pub fn find(mechanism: &Mechanism, equations: &Equations, q: &[f64], phases: &[f64]) -> Vec<Loose> {
    if mechanism.bound_to_a_tree().is_some() {
        // Absolute coordinates lack its rows.
        return Vec::new();
    }
    let is_absolute = equations.tree.attachments.iter().all(|attachment| attachment.joint.is_none());
    if is_absolute {
        return Free::new(mechanism, equations, q, phases).loose();
    }
    let absolute = derive(mechanism, SpanningTree::absolute(mechanism), &Omitted::default());
    let ancestry = Ancestry::of(equations, equations.motions.iter().flat_map(|motion| motion.flat()));
    let rest = vec![0.0; equations.layout.velocities()];
    let mut point = Point::at_defaults(mechanism, equations, phases);
    let (q, _) = carry_state(equations, &absolute, &mut point, &ancestry, q, &rest);
    Free::new(mechanism, &absolute, &q, phases).loose()
}

/// All bodies free, with the rows that join them.
struct Free<'a> {
    mechanism: &'a Mechanism,
    equations: &'a Equations,
    world: World<'a>,
    q: &'a [f64],
    phases: &'a [f64],
    /// D, rows of length one, and their lengths.
    rows: Vec<BTreeMap<usize, f64>>,
    lengths: Vec<f64>,
    /// Bodies that are fixed to each other.
    groups: Vec<Vec<BodyId>>,
}

impl<'a> Free<'a> {
    fn new(mechanism: &'a Mechanism, equations: &'a Equations, q: &'a [f64], phases: &'a [f64]) -> Self {
        let mut point = Point::at_defaults(mechanism, equations, phases);
        let world = World::at(mechanism, &mut point, q);
        let rows = &equations.rows[..equations.rows.len() - mechanism.drivers.len()];
        point.evaluate(&Ancestry::of_jets(equations, rows.iter().map(|row| &row.jet)));
        let in_numbers = |row: &crate::equations::Row| {
            let columns = row.jet.columns.iter().map(|(column, node)| (*column, point.get(*node)));
            let mut columns: BTreeMap<usize, f64> = columns.collect();
            let length = columns.values().map(|x| x * x).sum::<f64>().sqrt();
            columns.values_mut().for_each(|x| *x /= length.max(f64::MIN_POSITIVE));
            (columns, length)
        };
        let (rows, lengths) = rows.iter().map(in_numbers).unzip();
        Free { mechanism, equations, world, q, phases, rows, lengths, groups: groups(mechanism) }
    }

    fn loose(&self) -> Vec<Loose> {
        let mut found = Vec::new();
        let mut moving: BTreeSet<usize> = BTreeSet::new();
        for group in 0..self.groups.len() {
            if let Some(loose) = self.alone(&[group]) {
                moving.insert(group);
                found.push(loose);
            }
        }
        for chain in self.chains() {
            if chain.iter().all(|group| !moving.contains(group))
                && let Some(loose) = self.alone(&chain)
            {
                moving.extend(chain);
                found.push(loose);
            }
        }
        found
    }

    /// Neighbouring groups with two joints each, shorter chains first.
    fn chains(&self) -> Vec<Vec<usize>> {
        let ends = |group: &usize| self.joints(&[*group]).len();
        let links: Vec<usize> = (0..self.groups.len()).filter(|group| ends(group) == 2).collect();
        let mut all: Vec<Vec<usize>> = Vec::new();
        let mut longer: Vec<Vec<usize>> = links.iter().map(|group| vec![*group]).collect();
        for _ in 1..CHAIN {
            let mut next: Vec<Vec<usize>> = Vec::new();
            for chain in &longer {
                for joint in self.joints(chain) {
                    let beyond = self.ends(joint).into_iter().flatten().find(|group| !chain.contains(group));
                    let Some(group) = beyond.filter(|group| links.contains(group)) else { continue };
                    let mut chain = chain.clone();
                    chain.push(group);
                    chain.sort_unstable();
                    if !next.contains(&chain) {
                        next.push(chain);
                    }
                }
            }
            all.extend(next.iter().cloned());
            longer = next;
        }
        all
    }

    /// The groups that a joint connects; `None` is the ground.
    fn ends(&self, joint: JointId) -> [Option<usize>; 2] {
        let Joint { first, second, .. } = &self.mechanism.joints[joint.0];
        [first.frame, second.frame].map(|frame| match frame {
            Frame::Ground => None,
            Frame::Body(body) => self.groups.iter().position(|group| group.contains(&body)),
        })
    }

    /// The joints that hold groups moved as one.
    fn joints(&self, moved: &[usize]) -> Vec<JointId> {
        let all = (0..self.mechanism.joints.len()).map(JointId);
        let inside = |end: Option<usize>| end.is_some_and(|group| moved.contains(&group));
        all.filter(|joint| self.ends(*joint).map(inside).iter().filter(|inside| **inside).count() == 1)
            .collect()
    }

    /// How the groups move as one while the rest stands still.
    fn alone(&self, moved: &[usize]) -> Option<Loose> {
        let bodies: Vec<BodyId> = moved.iter().flat_map(|group| self.groups[*group].clone()).collect();
        let pole = self.world.bodies[bodies[0].0].0;
        let planar = self.mechanism.space == Space::Planar;
        let basis: &[usize] = if planar { &[0, 1, 5] } else { &[0, 1, 2, 3, 4, 5] };
        let increments: Vec<BTreeMap<usize, f64>> =
            basis.iter().map(|component| self.increment(&bodies, pole, *component)).collect();
        let product = |row: &BTreeMap<usize, f64>, increment: &BTreeMap<usize, f64>| -> f64 {
            increment.iter().filter_map(|(column, x)| Some(row.get(column)? * x)).sum()
        };
        let touched = self.rows.iter().filter(|row| {
            increments.iter().any(|increment| increment.keys().any(|column| row.contains_key(column)))
        });
        let matrix: Vec<Vec<f64>> =
            touched.map(|row| increments.iter().map(|increment| product(row, increment)).collect()).collect();
        // A particle does not turn.
        let still = increments.iter().map(BTreeMap::is_empty).collect::<Vec<_>>();
        let admitted: Vec<Vec<f64>> = null_space(matrix, basis.len())
            .into_iter()
            .filter(|twist| twist.iter().zip(&still).any(|(x, still)| !still && *x != 0.0))
            .collect();
        let joints = self.joints(moved);
        let leads_away =
            |twist: &Vec<f64>| joints.len() < 2 || self.is_finite(&bodies, pole, full(basis, twist));
        let admitted: Vec<Vec<f64>> = admitted.into_iter().filter(leads_away).collect();
        let way = self.way(&joints, pole, basis, &admitted)?;
        let names = |body: &BodyId| self.mechanism.bodies[body.0].name.clone();
        let joint_names = match way {
            Way::Spinning { .. } | Way::Turning => self.on_axis(&joints, pole, &full(basis, &admitted[0])),
            _ => joints,
        };
        let joint_name = |joint: JointId| self.mechanism.joints[joint.0].name.clone();
        Some(Loose {
            bodies: bodies.iter().map(names).collect(),
            members: bodies,
            freedoms: admitted.len(),
            joints: joint_names.into_iter().map(joint_name).collect(),
            way,
        })
    }

    fn way(&self, joints: &[JointId], pole: Vec3, basis: &[usize], admitted: &[Vec<f64>]) -> Option<Way> {
        let twist = full(basis, admitted.first()?);
        Some(match joints {
            [] => Way::Floating,
            [only] => Way::Hanging(self.mechanism.joints[only.0].form.alone),
            _ if admitted.len() > 1 => Way::Otherwise,
            _ if length(twist[1]) == 0.0 => Way::Sliding,
            _ => {
                let on_axis = self.on_axis(joints, pole, &twist);
                let is_ball = |joint: &JointId| {
                    let form = self.mechanism.joints[joint.0].form;
                    form.keeps_place && form.freedoms == 3
                };
                match on_axis.as_slice() {
                    [] => Way::Otherwise,
                    [_] => Way::Turning,
                    several => Way::Spinning { spherical: several.iter().all(is_ball) },
                }
            }
        })
    }

    /// Whether the rows are still met when the bodies have moved along the twist by a finite angle or way: centres on their
    /// arcs, ω constant in body axes.
    fn is_finite(&self, bodies: &[BodyId], pole: Vec3, [velocity, omega]: [Vec3; 2]) -> bool {
        let rate = length(omega);
        let layout = &self.equations.layout;
        let mut increment = vec![0.0; layout.velocities()];
        for (component, x) in velocity.into_iter().chain(omega).enumerate() {
            for (column, own) in self.increment(bodies, pole, component) {
                increment[column] += FINITE * x * own;
            }
        }
        for (index, linear) in layout.linear.iter().enumerate() {
            let Linear::Center(body, axis) = linear else { continue };
            if rate > 0.0 && bodies.contains(body) {
                // ∫ exp(ω̂ t) u dt with u the velocity at first.
                let u = add(velocity, cross(omega, sub(self.world.bodies[body.0].0, pole)));
                let (once, twice) = (cross(omega, u), cross(omega, cross(omega, u)));
                let angle = rate * FINITE;
                let across = (1.0 - libm::cos(angle)) / (rate * rate);
                let back = (angle - libm::sin(angle)) / (rate * rate * rate);
                increment[index] = FINITE * u[*axis] + across * once[*axis] + back * twice[*axis];
            }
        }
        let moved = retract(self.equations, self.q, &increment);
        let mut point = Point::at_defaults(self.mechanism, self.equations, self.phases);
        point.set_q(&moved);
        let rows = &self.equations.rows[..self.rows.len()];
        point.evaluate(&Ancestry::of(self.equations, rows.iter().map(|row| row.jet.value)));
        let met = |(row, length): (&crate::equations::Row, &f64)| {
            point.get(row.jet.value).abs() <= LEFT * FINITE * length
        };
        rows.iter().zip(&self.lengths).all(met)
    }

    /// The joints whose place the twist leaves where it is.
    fn on_axis(&self, joints: &[JointId], pole: Vec3, [velocity, omega]: &[Vec3; 2]) -> Vec<JointId> {
        let place = |joint: &JointId| self.world.place(&self.mechanism.joints[joint.0].second);
        let size =
            joints.iter().filter_map(place).map(|at| length(sub(at, pole))).fold(f64::MIN_POSITIVE, f64::max);
        let still = |joint: &JointId| {
            let at = place(joint);
            at.is_some_and(|at| {
                length(add(*velocity, cross(*omega, sub(at, pole)))) < ON_AXIS * size * length(*omega)
            })
        };
        joints.iter().copied().filter(still).collect()
    }

    /// The velocities of the bodies for one component of the twist about the pole.
    fn increment(&self, bodies: &[BodyId], pole: Vec3, component: usize) -> BTreeMap<usize, f64> {
        let mut velocity = [0.0; 3];
        let mut omega = [0.0; 3];
        match component {
            0..3 => velocity[component] = 1.0,
            _ => omega[component - 3] = 1.0,
        }
        let layout = &self.equations.layout;
        let mut increment = BTreeMap::new();
        for (index, linear) in layout.linear.iter().enumerate() {
            if let Linear::Center(body, axis) = linear
                && bodies.contains(body)
            {
                let moved = add(velocity, cross(omega, sub(self.world.bodies[body.0].0, pole)));
                increment.insert(index, moved[*axis]);
            }
        }
        for (r, rotation) in layout.rotations.iter().enumerate() {
            if matches!(rotation, Rotation::Body(body) if bodies.contains(body)) {
                increment.insert(layout.linear.len() + r, omega[2]);
            }
        }
        for (b, ball) in layout.quaternions.iter().enumerate() {
            let Ball::Body(body) = ball else { continue };
            if bodies.contains(body) {
                let axes = self.world.bodies[body.0].1;
                let own = [0, 1, 2].map(|k| dot([axes[0][k], axes[1][k], axes[2][k]], omega));
                increment.extend((0..3).map(|k| (layout.omega(b) + k, own[k])));
            }
        }
        increment.retain(|_, x| *x != 0.0);
        increment
    }
}

/// A twist with all six components: velocity of the pole, and angular velocity.
fn full(basis: &[usize], twist: &[f64]) -> [Vec3; 2] {
    let mut parts = [[0.0; 3]; 2];
    for (component, x) in basis.iter().zip(twist) {
        parts[component / 3][component % 3] = *x;
    }
    parts
}

/// Bodies joined by `fixed`, in the order of their first.
fn groups(mechanism: &Mechanism) -> Vec<Vec<BodyId>> {
    let mut group_of: Vec<usize> = (0..mechanism.bodies.len()).collect();
    for joint in mechanism.joints.iter().filter(|joint| joint.holds()) {
        let (0, Frame::Body(a), Frame::Body(b)) =
            (joint.form.freedoms, joint.first.frame, joint.second.frame)
        else {
            continue;
        };
        let (keep, give) = (group_of[a.0].min(group_of[b.0]), group_of[a.0].max(group_of[b.0]));
        group_of.iter_mut().filter(|group| **group == give).for_each(|group| *group = keep);
    }
    let of = |first: usize| (0..group_of.len()).filter(|body| group_of[*body] == first).map(BodyId).collect();
    (0..group_of.len()).filter(|body| group_of[*body] == *body).map(of).collect()
}

/// A basis of the x with A x = 0, each with its largest entry 1, by elimination with complete pivoting.
fn null_space(mut matrix: Vec<Vec<f64>>, columns: usize) -> Vec<Vec<f64>> {
    let mut pivots: Vec<(usize, usize)> = Vec::new();
    loop {
        let used = |i: usize| pivots.iter().any(|(row, _)| *row == i);
        let mut best = (NONE, 0, 0);
        for (i, row) in matrix.iter().enumerate().filter(|(i, _)| !used(*i)) {
            for (j, x) in row.iter().enumerate() {
                if x.abs() > best.0 {
                    best = (x.abs(), i, j);
                }
            }
        }
        let (size, i, j) = best;
        if size <= NONE {
            break;
        }
        let pivot: Vec<f64> = matrix[i].iter().map(|x| x / matrix[i][j]).collect();
        for row in &mut matrix {
            let factor = row[j];
            row.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= factor * p);
        }
        matrix[i] = pivot;
        pivots.push((i, j));
    }
    let free = (0..columns).filter(|j| pivots.iter().all(|(_, column)| column != j));
    free.map(|j| {
        let mut vector = vec![0.0; columns];
        vector[j] = 1.0;
        pivots.iter().for_each(|(row, column)| vector[*column] = -matrix[*row][j]);
        let largest = vector.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        vector.iter().map(|x| if x.abs() < NONE * largest { 0.0 } else { x / largest }).collect()
    })
    .collect()
}
