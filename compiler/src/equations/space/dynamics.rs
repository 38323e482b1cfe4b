//! M by composite rigid bodies, inertia and gravity forces by recursive Newton–Euler, both on the tree of links.
//!
//! Forwards, in the axes of each link and at its origin (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapters 5
//! and 6; Luh, Walker, Paul 1980):
//!   ω = Rᵀ ω_p + ω_r,  α = Rᵀ α_p + (Rᵀ ω_p) × ω_r + α_r,  a = Rᵀ (a_p + U_p d) + …,  U = α̃ + ω̃ ω̃,
//! with d from the parent's origin, and a = −g on the ground. Backwards, for a distribution (m, h, I) about the origin:
//!   F = m a + U h,  N = I α + ω × I ω + h × a.
//! Before that, what a turn or a slide cannot tell from mass of the parent is given to the parent (base inertial
//! parameters: Gautier & Khalil, IEEE Trans. Robotics and Automation 6, 1990): behind a turn about z, the mass, h_z and
//! a disk of moments I_yy; behind a slide, the tensor; behind a ball, the mass.

use super::axes;
use super::flexible::{self, Spread};
use super::kinematics::Kinematics;
use super::links::{GROUND, Link, LinkId, Motion};
use super::shapes::Shapes;
use super::tensor::{Distribution, Symmetric};
use super::vector::{self, Mat3, Vec3, vector};
use crate::equations::{Dynamics, Laws};
use crate::symbolic::{Computed, Node, On, Scalar, Sheet};
use std::collections::BTreeMap;

/// M, gyroscopic and gravity forces, energies.
pub fn dynamics<'g>(laws: &Laws<'g>) -> Dynamics<'g> {
    let g = laws.g;
    let Some(kinematics) = laws.space() else { return Dynamics::none(g) };
    let gravity = match &laws.mechanism.gravity {
        Some(gravity) => laws.vector(gravity),
        None => vector::zero(g),
    };
    let beams = Spread::all(laws, kinematics);
    let distributions = distributions(laws, kinematics.bare, &beams, Spread::distribution);
    let regrouped = regrouped(kinematics, &distributions);
    let composite = composite(kinematics, &regrouped);
    let mass = mass_matrix(kinematics, &composite, &beams);
    let upwards = -gravity;
    let mut computed = Computed::default();
    computed.add(&g.graph(), &mass.values().map(|entry| entry.bare).collect::<Vec<_>>());
    let needed = |accelerations: Option<&[Node]>, computed: Computed| {
        cheap(kinematics, computed, |known| {
            newton_euler(kinematics, &regrouped, &beams, accelerations, upwards, known)
        })
    };
    let mut forces: Vec<Scalar> = needed(None, computed).iter().map(|force| -*force).collect();
    let mut inverse = needed(Some(&laws.symbols.acceleration), Computed::default());
    for (velocity, force) in flexible::elastic_forces(laws, kinematics) {
        forces[velocity] += force;
        inverse[velocity] -= force;
    }
    let kinetic_energy = kinetic_energy(kinematics, &regrouped, &beams);
    let mut potential_energy = -gravity.dot(composite[GROUND].bare.first);
    if !beams.is_empty() {
        potential_energy += flexible::elastic_energy(laws, kinematics);
    }
    let distributions = regrouped.into_iter().map(|distribution| distribution.bare).collect();
    Dynamics { mass, forces, inverse, kinetic_energy, potential_energy, distributions }
}

/// The kinetic energy of rigid bodies and of slices of those that deform, by sums of ½ m |ṙ|² and of what sections have as they turn: what no algebra
/// of integrals has gone into.
pub fn kinetic_energy_of_slices<'g>(laws: &Laws<'g>, rule: &crate::beams::Rule) -> Scalar<'g> {
    let Some(kinematics) = laws.space() else { return laws.g.zero() };
    let beams = Spread::all(laws, kinematics);
    let none = |_: &Spread<'g>| laws.g.on(Distribution::none(laws.g));
    let rigid = distributions(laws, kinematics.bare, &beams, none);
    let mut sum = kinetic_energy(kinematics, &rigid, &[]);
    for (body, placement) in laws.mechanism.bodies.iter().zip(&kinematics.bare.bodies) {
        let Some(flexible) = &placement.flexible else { continue };
        let mass = laws.value(&body.mass);
        for slice in flexible.shapes.slices(rule) {
            let velocity = kinematics.slice_in_world(placement, &slice).rate();
            sum += 0.5 * slice.share * (mass * velocity.dot(velocity));
        }
    }
    let motions = motions(kinematics, None, vector::zero(laws.g));
    let flexible = kinematics.bare.bodies.iter().filter_map(|placement| placement.flexible.as_ref());
    for (beam, flexible) in beams.iter().zip(flexible) {
        let omega = motions[beam.link].omega;
        if let Shapes::Modal(_) = flexible.shapes {
            sum += 0.5 * beam.twice_turning(omega);
            continue;
        }
        for slice in flexible.shapes.slices(rule) {
            sum += 0.5 * slice.share * beam.twice_turning_of_section(omega, &slice.rows);
        }
    }
    sum
}

/// What the bodies on each link weigh, of beams as much as is asked for.
fn distributions<'g>(
    laws: &Laws<'g>,
    kinematics: &Kinematics,
    beams: &[Spread<'g>],
    of_beam: impl Fn(&Spread<'g>) -> On<'g, Distribution>,
) -> Vec<On<'g, Distribution>> {
    let g = laws.g;
    let none = Distribution::none(g);
    let mut found = vec![g.on(none); kinematics.links.len()];
    for beam in beams {
        let own = &mut found[beam.link];
        *own = *own + of_beam(beam);
    }
    for (body, placement) in laws.mechanism.bodies.iter().zip(&kinematics.bodies) {
        if placement.flexible.is_some() {
            continue;
        }
        let mass = laws.value(&body.mass).bare;
        let center = g.on(placement).point(laws.vector(&body.center));
        let inertia = if body.form.turns {
            inertia_in_body(laws, &body.inertia).turned(placement.axes).bare
        } else {
            none.inertia
        };
        let about_center = g.on(Distribution { mass, first: none.first, inertia });
        let own = &mut found[placement.link];
        *own = *own + about_center.shifted(center);
    }
    found
}

/// The tensor about the centre of mass in body axes.
pub fn inertia_in_body<'g>(laws: &Laws<'g>, inertia: &crate::model::Inertia) -> On<'g, Symmetric> {
    let ([xx, yy, zz], [xy, xz, yz]) =
        (laws.vector(&inertia.moments).bare, laws.vector(&inertia.products).bare);
    let axes = axes::matrix(laws, &inertia.axes);
    laws.g.on(Symmetric([xx, yy, zz, xy, xz, yz])).turned(axes.bare)
}

/// The same dynamics with fewer numbers, from the leaves inwards.
fn regrouped<'g>(
    kinematics: On<'g, &Kinematics>,
    distributions: &[On<'g, Distribution>],
) -> Vec<On<'g, Distribution>> {
    let g = kinematics.g;
    let none = Distribution::none(g);
    let zero = none.mass;
    let mut found = distributions.to_vec();
    for (at, link) in kinematics.bare.links.iter().enumerate().skip(1).rev() {
        let own = found[at].bare;
        // A foot that moves by itself makes mass at rest in the moving place do work.
        if own.is_none(g) || link.is_carried_by_time(g) {
            continue;
        }
        let Symmetric([xx, yy, zz, xy, xz, yz]) = own.inertia;
        let (given, kept) = match &link.motion {
            Motion::None => (own, none),
            Motion::Turn { .. } => (
                Distribution {
                    mass: own.mass,
                    first: [zero, zero, own.first[2]],
                    inertia: Symmetric([yy, yy, zero, zero, zero, zero]),
                },
                Distribution {
                    mass: zero,
                    first: [own.first[0], own.first[1], zero],
                    inertia: Symmetric([(g.on(xx) - yy).bare, zero, zz, xy, xz, yz]),
                },
            ),
            Motion::Slide { .. } | Motion::Shift { .. } => {
                (Distribution { inertia: own.inertia, ..none }, Distribution { inertia: none.inertia, ..own })
            }
            Motion::Ball { .. } | Motion::Lean { .. } => {
                (Distribution { mass: own.mass, ..none }, Distribution { mass: zero, ..own })
            }
        };
        found[at] = g.on(kept);
        let given = g.on(given).turned(link.axes).shifted(g.on(link.at));
        found[link.parent] = found[link.parent] + given;
    }
    found
}

/// What hangs on each link, itself included.
fn composite<'g>(
    kinematics: On<'g, &Kinematics>,
    distributions: &[On<'g, Distribution>],
) -> Vec<On<'g, Distribution>> {
    let mut composite = distributions.to_vec();
    for (at, link) in kinematics.bare.links.iter().enumerate().skip(1).rev() {
        let carried = composite[at].in_parent(link);
        composite[link.parent] = composite[link.parent] + carried;
    }
    composite
}

/// Moment about a link's origin, and force, in its axes.
#[derive(Clone, Copy)]
pub struct Wrench<'g> {
    pub moment: On<'g, Vec3>,
    pub force: On<'g, Vec3>,
}

impl<'g> Wrench<'g> {
    fn in_parent(self, link: On<'g, &Link>) -> Wrench<'g> {
        Wrench { moment: link.turn(self.moment), force: link.turn(self.force) }.of_parent(link)
    }

    /// From the axes before the motion of the link.
    fn of_parent(self, link: On<'g, &Link>) -> Wrench<'g> {
        let Wrench { moment, force } = self;
        let moment = moment + link.slide().cross(force);
        let (moment, force) = (link.bare.axes * moment, link.bare.axes * force);
        Wrench { moment: moment + force.g.on(link.bare.at).cross(force), force }
    }

    /// Power on each velocity of the link: its index, and Sᵀ of the wrench.
    fn projections(self, link: On<'g, &Link>) -> Vec<(usize, Scalar<'g>)> {
        let mut found = Vec::new();
        for (velocity, axis) in link.turning() {
            found.push((velocity, axis.dot(self.moment)));
        }
        for (velocity, axis) in link.sliding() {
            found.push((velocity, axis.dot(self.force)));
        }
        found
    }
}

/// M_kl = S_l · (I^c S_k), carried from the link of k inwards; of modes of beams, with what they need of their link.
fn mass_matrix<'g>(
    kinematics: On<'g, &Kinematics>,
    composite: &[On<'g, Distribution>],
    beams: &[Spread<'g>],
) -> BTreeMap<(usize, usize), Scalar<'g>> {
    let g = kinematics.g;
    let links = &kinematics.bare.links;
    let mut mass: BTreeMap<(usize, usize), Scalar> = BTreeMap::new();
    let mut accumulate = |k: usize, l: usize, entry: Scalar<'g>| {
        *mass.entry((k.max(l), k.min(l))).or_insert_with(|| g.zero()) += entry;
    };
    for (at, link) in links.iter().enumerate().skip(1) {
        let own = composite[at];
        let mut columns: Vec<(usize, Wrench)> = Vec::new();
        for (velocity, axis) in g.on(link).turning() {
            let moment = own.bare.inertia * axis;
            columns.push((velocity, Wrench { moment, force: axis.cross(own.first()) }));
        }
        for (velocity, axis) in g.on(link).sliding() {
            let moment = own.first().cross(axis);
            columns.push((velocity, Wrench { moment, force: own.mass() * axis }));
        }
        for (k, wrench) in columns {
            for (l, entry) in wrench.projections(g.on(link)).into_iter().filter(|(l, _)| *l <= k) {
                accumulate(k, l, entry);
            }
            carried(kinematics, wrench.in_parent(g.on(link)), link.parent, k, &mut accumulate);
        }
    }
    for beam in beams {
        for (mode, share) in beam.shares.iter().enumerate() {
            let [moment, force] = beam.column(share);
            carried(kinematics, Wrench { moment, force }, beam.link, share.velocity, &mut accumulate);
            for its in &beam.shares[..=mode] {
                accumulate(share.velocity, its.velocity, beam.mass_of(share, its));
            }
        }
    }
    mass.retain(|_, entry| !entry.is_zero());
    mass
}

/// The wrench that an acceleration of k needs at a link, with all velocities from there to the ground.
fn carried<'g>(
    kinematics: On<'g, &Kinematics>,
    mut wrench: Wrench<'g>,
    from: LinkId,
    k: usize,
    accumulate: &mut impl FnMut(usize, usize, Scalar<'g>),
) {
    let mut at = from;
    while at != GROUND {
        let link = kinematics.g.on(&kinematics.bare.links[at]);
        for (l, entry) in wrench.projections(link) {
            // One velocity that moves two links, as of a screw, meets itself both ways.
            accumulate(k, l, if l == k { 2.0 * entry } else { entry });
        }
        wrench = wrench.in_parent(link);
        at = link.bare.parent;
    }
}

/// Motion of a link, in its axes and at its origin.
#[derive(Clone, Copy)]
pub struct LinkMotion<'g> {
    pub omega: On<'g, Vec3>,
    pub alpha: On<'g, Vec3>,
    pub velocity: On<'g, Vec3>,
    pub acceleration: On<'g, Vec3>,
    /// α̃ + ω̃ ω̃.
    pub spin: On<'g, Mat3>,
    /// The same in the axes before the link's motion, of what turns about z.
    pub before: Option<On<'g, Mat3>>,
}

impl<'g> LinkMotion<'g> {
    pub fn new(
        omega: On<'g, Vec3>,
        alpha: On<'g, Vec3>,
        velocity: On<'g, Vec3>,
        acceleration: On<'g, Vec3>,
    ) -> Self {
        LinkMotion { omega, alpha, velocity, acceleration, spin: spin(omega, alpha), before: None }
    }
}

/// Motions of all links, with the accelerations given or zero, the ground's being `ground`.
pub fn motions<'g>(
    kinematics: On<'g, &Kinematics>,
    accelerations: Option<&[Node]>,
    ground: On<'g, Vec3>,
) -> Vec<LinkMotion<'g>> {
    let g = kinematics.g;
    let zero = vector::zero(g);
    let spin = g.on([zero.bare; 3]);
    let mut motions = vec![LinkMotion {
        omega: zero,
        alpha: zero,
        velocity: zero,
        acceleration: ground,
        spin,
        before: None,
    }];
    for link in kinematics.bare.links.iter().skip(1) {
        let motion = moved(g.on(link), &motions[link.parent], &kinematics.bare.velocities, accelerations);
        motions.push(motion);
    }
    motions
}

fn moved<'g>(
    link: On<'g, &Link>,
    parent: &LinkMotion<'g>,
    v: &[Node],
    accelerations: Option<&[Node]>,
) -> LinkMotion<'g> {
    let offset = link.offset();
    // At the link's origin, in the axes of the parent.
    let velocity = parent.velocity + (parent.omega.cross(offset) + link.bare.at_drift);
    let acceleration = parent.acceleration + (parent.spin * offset + link.bare.at_bias);

    let (mut velocity, mut acceleration) = (link.down(velocity), link.down(acceleration));
    let (base_omega, base_alpha) = (link.down(parent.omega), link.down(parent.alpha));
    let relative = link.omega(v);
    let gyration = base_omega.cross(relative) + link.turning_bias();
    let omega = base_omega + relative;
    let mut alpha = base_alpha + gyration;
    if let Some(a) = accelerations {
        alpha += link.omega(a);
    }
    if let Some(speed) = link.sliding_by(v) {
        velocity += speed;
        acceleration += 2.0 * omega.cross(speed) + link.sliding_bias();
        if let Some(forced) = accelerations.and_then(|a| link.sliding_by(a)) {
            acceleration += forced;
        }
    }
    let mut motion = LinkMotion::new(omega, alpha, velocity, acceleration);
    if let Motion::Turn { .. } = link.bare.motion {
        // What turns about an axis is seen alike from before and behind it.
        let carrying = link.before(parent.omega);
        let mut alpha = link.before(parent.alpha) + carrying.cross(relative);
        if let Some(a) = accelerations {
            alpha += link.omega(a);
        }
        motion.before = Some(spin(carrying + relative, alpha));
    }
    motion
}

/// R (a + U s), of s on the link and of a that it carries, in the axes before its motion; with what is `computed` anyway each component as this or as
/// R a + U′ R s, with U′ in those axes, whichever takes fewer operations beside that and R s: U′ has the zeros that ω of the parent has.
/// In m/s² with s in m, in N with h in kg m in its place.
pub fn turned<'g>(
    link: On<'g, &Link>,
    motion: &LinkMotion<'g>,
    carried: On<'g, Vec3>,
    held: On<'g, Vec3>,
    computed: Option<&mut Computed>,
) -> On<'g, Vec3> {
    let behind = link.turn(carried + motion.spin * held);
    let (Some(spin), Some(computed)) = (motion.before, computed) else { return behind };
    let turned = link.turn(held);
    let before = link.turn(carried) + spin * turned;
    let mut cheap = |parts: &[usize]| {
        let [first, second] = [behind, before].map(|sum| {
            let parts = parts.iter().map(|k| sum.bare[*k]).chain(turned.bare);
            computed.cost(&link.g.graph(), &parts.collect::<Vec<_>>())
        });
        if second < first { before } else { behind }
    };
    // What lies across the axis is turned together.
    let (across, along) = (cheap(&[0, 1]), cheap(&[2]));
    vector(|k| if k == 2 { along.at(k) } else { across.at(k) })
}

/// U = α̃ + ω̃ ω̃.
fn spin<'g>(omega: On<'g, Vec3>, alpha: On<'g, Vec3>) -> On<'g, Mat3> {
    let square = vector(|k| omega.at(k).square());
    let mut matrix = [square.bare; 3];
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        matrix[k][k] = (-(square.at(i) + square.at(j))).bare;
        let product = omega.at(i) * omega.at(j);
        matrix[i][j] = (product - alpha.at(k)).bare;
        matrix[j][i] = (product + alpha.at(k)).bare;
    }
    omega.g.on(matrix)
}

/// Forces in one of two ways, by what is computed or not, whichever takes fewer operations beside that.
fn cheap<'g>(
    kinematics: On<'g, &Kinematics>,
    mut computed: Computed,
    needed: impl Fn(Option<Computed>) -> Vec<Scalar<'g>>,
) -> Vec<Scalar<'g>> {
    let [behind, before] = [None, Some(computed.clone())].map(needed);
    let [first, second] = [&behind, &before].map(|forces| {
        let forces: Vec<Node> = forces.iter().map(|force| force.bare).collect();
        computed.cost(&kinematics.g.graph(), &forces)
    });
    if second < first { before } else { behind }
}

/// Forces that the motions need, per velocity, with the accelerations given or zero, the ground's being `ground`. `computed`: beside what
/// forces of links are turned cheaply, where that is said.
fn newton_euler<'g>(
    kinematics: On<'g, &Kinematics>,
    distributions: &[On<'g, Distribution>],
    beams: &[Spread<'g>],
    accelerations: Option<&[Node]>,
    ground: On<'g, Vec3>,
    mut computed: Option<Computed>,
) -> Vec<Scalar<'g>> {
    let g = kinematics.g;
    let motions = &motions(kinematics, accelerations, ground);
    if let Some(computed) = &mut computed {
        let parts = motions.iter().flat_map(|motion| [motion.omega, motion.acceleration]);
        computed.add(&g.graph(), &parts.flat_map(|part| part.bare).collect::<Vec<_>>());
    }
    let mut forces = vec![g.zero(); kinematics.bare.velocities.len()];
    let mut wrenches: Vec<Wrench> = distributions
        .iter()
        .zip(motions)
        .map(|(distribution, motion)| needed(*distribution, motion))
        .collect();
    // U h behind a turn is added as it is turned: no velocity of such a link needs its force.
    let mut held = vec![vector::zero(g); wrenches.len()];
    for (at, motion) in motions.iter().enumerate().filter(|(_, motion)| motion.before.is_some()) {
        held[at] = distributions[at].first();
        wrenches[at].force = distributions[at].mass() * motion.acceleration;
    }
    // Moments that the parent's axes see as they are.
    let mut unturned = vec![vector::zero(g); wrenches.len()];
    for (at, link) in kinematics.bare.links.iter().enumerate().skip(1) {
        let carrying = motions[link.parent].omega;
        if let Some((moment, gyration)) = needed_by_turning(distributions[at], link, &motions[at], carrying) {
            (wrenches[at].moment, unturned[at]) = (moment, gyration);
        }
    }
    for beam in beams {
        let motion = &motions[beam.link];
        let [moment, force] = beam.beyond(motion, accelerations);
        wrenches[beam.link].moment += moment;
        wrenches[beam.link].force += force;
        for (velocity, force) in beam.forces(motion, accelerations) {
            forces[velocity] += force;
        }
    }
    for (at, link) in kinematics.bare.links.iter().enumerate().skip(1).rev() {
        let wrench = wrenches[at];
        for (velocity, force) in wrench.projections(g.on(link)) {
            forces[velocity] += force;
        }
        let moment = g.on(link).turn(wrench.moment);
        let force = turned(g.on(link), &motions[at], wrench.force, held[at], computed.as_mut());
        if let Some(computed) = &mut computed {
            computed.add(&g.graph(), &force.bare);
        }
        let carried = Wrench { moment, force }.of_parent(g.on(link));
        let parent = &mut wrenches[link.parent];
        parent.moment += carried.moment + link.axes * unturned[at];
        parent.force += carried.force;
    }
    forces
}

/// F = m a + U h, N = I α + ω × I ω + h × a. With U at hand the second is, component by component,
///   N_x = Ixx α_x + (Izz − Iyy) ω_y ω_z − Ixy U_zx + Ixz U_yx + Iyz (U_yy − U_zz) + …
pub fn needed<'g>(distribution: On<'g, Distribution>, motion: &LinkMotion<'g>) -> Wrench<'g> {
    let LinkMotion { omega, alpha, acceleration, spin, .. } = *motion;
    let (first, inertia) = (distribution.first(), distribution.inertia());
    let force = distribution.mass() * acceleration + spin * first;
    // Products of inertia by the pair of axes they belong to: opposite x stands yz, and so on.
    let across = |a: usize, b: usize| inertia.at(2 + a + b);
    let lever = first.cross(acceleration);
    let moment = vector(|x| {
        let (y, z) = ((x + 1) % 3, (x + 2) % 3);
        let product = omega.at(y) * omega.at(z);
        let difference = inertia.at(z) - inertia.at(y);
        let diagonal = spin.row(y).at(y) - spin.row(z).at(z);
        let terms = [
            inertia.at(x) * alpha.at(x),
            difference * product,
            across(x, z) * spin.row(y).at(x),
            across(y, z) * diagonal,
        ];
        distribution.g.sum(terms) - across(x, y) * spin.row(z).at(x) + lever.at(x)
    });
    Wrench { moment, force }
}

/// The moment of what turns about z and has only Ixx, Izz and h_y, in two parts: of N = (Ixx α_x + Izz ω_y ω_z, (Ixx − Izz) ω_z ω_x, …) + h × a
/// the part (Izz − Ixx) ω_z (ω_y, −ω_x, 0) is seen by the parent as it is, with ω_x and ω_y of the parent, `carrying`, in the axes before the turn, and
/// what is left has no y. `None` of others: of most N_y has to be turned in any case, and without Ixx little is turned.
fn needed_by_turning<'g>(
    distribution: On<'g, Distribution>,
    link: &Link,
    motion: &LinkMotion<'g>,
    carrying: On<'g, Vec3>,
) -> Option<(On<'g, Vec3>, On<'g, Vec3>)> {
    let g = distribution.g;
    let [xx, yy, zz, products @ ..] = distribution.inertia().parts();
    let [h_x, h_y, h_z] = distribution.first().parts();
    let vanish = [yy, h_x, h_z].iter().chain(&products).all(|part| part.is_zero());
    if !matches!(link.motion, Motion::Turn { .. }) || !vanish || xx.is_zero() {
        return None;
    }
    let LinkMotion { omega, alpha, acceleration, spin, .. } = *motion;
    let own = [
        xx * spin.row(2).at(1) + h_y * acceleration.at(2),
        g.zero(),
        zz * alpha.at(2) - xx * (omega.at(0) * omega.at(1)) - h_y * acceleration.at(0),
    ];
    let (gyration, carrying) = ((zz - xx) * omega.at(2), g.on(link).before(carrying));
    let seen = [gyration * carrying.at(1), -(gyration * carrying.at(0)), g.zero()];
    Some((vector(|k| own[k]), vector(|k| seen[k])))
}

/// T = Σ ½ (m v² + 2 v·(ω × h) + ω·I ω), and what beams have beyond that.
fn kinetic_energy<'g>(
    kinematics: On<'g, &Kinematics>,
    distributions: &[On<'g, Distribution>],
    beams: &[Spread<'g>],
) -> Scalar<'g> {
    let g: Sheet<'g> = kinematics.g;
    let motions = motions(kinematics, None, vector::zero(g));
    let mut twice = g.zero();
    for (own, LinkMotion { velocity, omega, .. }) in distributions.iter().zip(&motions) {
        let (velocity, omega) = (*velocity, *omega);
        let translation = own.mass() * velocity.dot(velocity);
        let mixed = 2.0 * velocity.dot(omega.cross(own.first()));
        let rotation = omega.dot(own.bare.inertia * omega);
        twice += g.sum([translation, mixed, rotation]);
    }
    let beyond = beams.iter().map(|beam| beam.kinetic_energy(&motions[beam.link]));
    beyond.fold(0.5 * twice, |sum, own| sum + own)
}
