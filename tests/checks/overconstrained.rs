//! Mechanisms whose redundant rows change along the motion, and rows that vanish as a whole: whichever rows are taken, the rank along
//! the cycle is what eigenvalues say, and energy is kept to the order of the method.

use crate::rank::{compare, cycle};
use crate::registry::{Model, model};
use linkwright::{
    Assemble, AssembleExt, AugmentedLagrangian, Baumgarte, Formulation, LagrangeIndex1, Mechanism, NullSpace,
    Partitioned, Penalty, Projected, Simulation, mechanism,
};

/// Bennett's linkage: four revolutes, opposite links alike, sin α/a = sin β/b. It turns all round without a singular position, and no
/// two of the five rows that close it hold everywhere.
macro_rules! bennett {
    ($name:ident, $redundant:ident, $coordinates:ident) => {
        mechanism! {
            spatial $name {
                const ALPHA [deg] = 30;
                const BETA [deg] = 50;
                const A [m] = 0.5;
                const B [m] = A*sin(BETA)/sin(ALPHA);
                body base { mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.1, 0.1); center [m] = (A/2, 0, 0);
                    marker near [m] = (0, 0, 0), axis = (0, 0, 1), reference = (1, 0, 0);
                    marker far [m] = (A, 0, 0), axis = (0, -sin(ALPHA), cos(ALPHA)), reference = (1, 0, 0); }
                body second { mass [kg] = 1.3; inertia [kg*m^2] = (0.01, 0.15, 0.15); center [m] = (B/2, 0, 0);
                    marker near [m] = (0, 0, 0), axis = (0, 0, 1), reference = (1, 0, 0);
                    marker far [m] = (B, 0, 0), axis = (0, -sin(BETA), cos(BETA)), reference = (1, 0, 0); }
                body third { mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.1, 0.1); center [m] = (A/2, 0, 0);
                    marker near [m] = (0, 0, 0), axis = (0, 0, 1), reference = (1, 0, 0);
                    marker far [m] = (A, 0, 0), axis = (0, -sin(ALPHA), cos(ALPHA)), reference = (1, 0, 0); }
                body fourth { mass [kg] = 1.3; inertia [kg*m^2] = (0.01, 0.15, 0.15); center [m] = (B/2, 0, 0);
                    marker near [m] = (0, 0, 0), axis = (0, 0, 1), reference = (1, 0, 0);
                    marker far [m] = (B, 0, 0), axis = (0, -sin(BETA), cos(BETA)), reference = (1, 0, 0); }
                joint held: fixed(ground(0, 0, 0) [m], base.origin);
                joint j1: revolute(base.far, second.near);
                joint j2: revolute(second.far, third.near);
                joint j3: revolute(third.far, fourth.near);
                joint j4: revolute(fourth.far, base.near);
                start { j1.angle [deg] ~ 70; j1.rate [rad/s] = 3;
                        j2.angle [deg] ~ -158; j3.angle [deg] ~ -70; j4.angle [deg] ~ 158; }
                options { redundant = $redundant; coordinates = $coordinates; }
                expect { degrees_of_freedom = 1; }
            }
        }
        model!($name);
    };
}
bennett!(Bennett, drop, tree);
bennett!(BennettKept, keep, tree);
bennett!(BennettAbsolute, drop, absolute);

mechanism! {
    /// A table on three parallel cranks whose pins are not in line: the force that the loops hold against themselves turns with the cranks.
    planar ThirdByRods {
        gravity [m/s^2] = (0, -9.81);
        rod a { mass [kg] = 1; length [m] = 1; }
        rod b { mass [kg] = 1; length [m] = 1; }
        rod c { mass [kg] = 1; length [m] = 1; }
        body table { mass [kg] = 2; inertia [kg*m^2] = 0.5; center [m] = (1, 0);
                     point p [m] = (0, 0); point q [m] = (1, 0.3); point r [m] = (2, 0); }
        joint a1: revolute(ground(0, 0) [m], a.start);
        joint b1: revolute(ground(1, 0.3) [m], b.start);
        joint c1: revolute(ground(2, 0) [m], c.start);
        joint a2: revolute(a.end, table.p);
        joint b2: revolute(b.end, table.q);
        joint c2: revolute(c.end, table.r);
        start { a1.angle [deg] = 70; a1.rate [rad/s] = 6; b1.angle [deg] ~ 70; c1.angle [deg] ~ 70; }
        options { redundant = drop; }
        expect { degrees_of_freedom = 1; }
    }
}
model!(ThirdByRods);

mechanism! {
    /// The same with a distance for the crank in the middle.
    planar ThirdByDistance {
        gravity [m/s^2] = (0, -9.81);
        rod a { mass [kg] = 1; length [m] = 1; }
        rod c { mass [kg] = 1; length [m] = 1; }
        body table { mass [kg] = 2; inertia [kg*m^2] = 0.5; center [m] = (1, 0);
                     point p [m] = (0, 0); point q [m] = (1, 0.3); point r [m] = (2, 0); }
        joint a1: revolute(ground(0, 0) [m], a.start);
        joint c1: revolute(ground(2, 0) [m], c.start);
        joint a2: revolute(a.end, table.p);
        joint c2: revolute(c.end, table.r);
        joint b: distance(ground(1, 0.3) [m], table.q, length = 1 [m]);
        start { a1.angle [deg] = 70; a1.rate [rad/s] = 6; c1.angle [deg] ~ 70; }
        options { redundant = drop; }
        expect { degrees_of_freedom = 1; }
    }
}
model!(ThirdByDistance);

mechanism! {
    /// A parallelogram whose coupler is a distance: its only row vanishes where the cranks lie along it.
    planar ByDistance {
        gravity [m/s^2] = (0, -9.81);
        rod left  { mass [kg] = 1; length [m] = 1; }
        rod right { mass [kg] = 1; length [m] = 1; }
        joint a: revolute(ground(0, 0) [m], left.start);
        joint b: revolute(ground(1, 0) [m], right.start);
        joint bar: distance(left.end, right.end, length = 1 [m]);
        start { a.angle [deg] = 90; a.rate [rad/s] = -1; b.angle [deg] ~ 90; }
        expect { degrees_of_freedom = 1; }
    }
}
model!(ByDistance);

#[test]
fn rank_along_the_cycle() {
    fn check<M: Model>(regular: bool) {
        let model = M::standard();
        let off = compare(&model, &cycle(&model));
        println!("{}: {:.2} to {:.2}, down to {:.1e}", model.name(), off.least, off.most, off.smallest);
        assert!(off.least > 1.0 / 30.0 && off.most < 30.0, "{}: {} to {}", model.name(), off.least, off.most);
        assert!(!regular || off.smallest > 3e-4, "{}: {:e}", model.name(), off.smallest);
    }
    check::<Bennett>(true);
    check::<BennettKept>(true);
    check::<BennettAbsolute>(true);
    check::<ThirdByRods>(true);
    check::<ThirdByDistance>(false);
    check::<ByDistance>(false);
}

/// The largest change of energy over a run.
fn loss<M, F>(name: &str, model: &M, formulation: F, h: f64, end: f64) -> f64
where
    M: Assemble<f64, Inputs = ()>,
    F: Formulation<f64, M>,
{
    let start = model.start();
    let mut simulation = Simulation::new(model, start).formulation(formulation).step(h);
    let begin = simulation.energy();
    let mut most = 0.0_f64;
    while simulation.time() < end {
        let step = simulation.advance().unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(step.near_singular.is_none(), "{name}: {step:?}");
        most = most.max((simulation.energy() - begin).abs());
    }
    most
}

/// Where the mechanism is regular all round, halving the step divides the loss of energy by sixteen, whatever the formulation.
#[test]
fn energy_converges_with_the_step() {
    fn check<M, F>(name: &str, formulation: impl Fn(&M, f64) -> F, bound: f64)
    where
        M: Model + Assemble<f64, Inputs = ()>,
        F: Formulation<f64, M>,
    {
        let model = M::standard();
        let name = format!("{}, {name}", model.name());
        let loss = |h| loss(&name, &model, formulation(&model, h), h, 2.5);
        let (coarse, fine) = (loss(2e-3), loss(1e-3));
        println!("{name}: {coarse:.1e} J, {fine:.1e} J");
        assert!(fine < bound && fine < coarse / 7.0, "{name}: {coarse:e}, {fine:e}");
    }
    fn all<M: Model + Assemble<f64, Inputs = ()>>(bound: f64) {
        let penalty = |model: &M, h| Penalty::for_model(model, 0.0, &model.start_q(), h);
        check::<M, _>("Baumgarte", |_, _| Baumgarte { alpha: 10.0, beta: 10.0 }, bound);
        check::<M, _>("index 1, projected", |_, _| Projected::after(LagrangeIndex1), bound);
        check::<M, _>("penalty", penalty, bound);
        check::<M, _>("augmented Lagrangian", |model, h| AugmentedLagrangian::new(penalty(model, h)), bound);
        check::<M, _>("null space", |_, _| NullSpace, bound);
        check::<M, _>("partitioned", |_, _| Partitioned::default(), bound);
    }
    all::<Bennett>(1e-8);
    all::<BennettKept>(1e-8);
}

/// Without stabilisation errors of the rows that are taken pass on to those that follow them: less exact, and yet it converges.
#[test]
fn index_1_converges_too() {
    let model = Bennett::<f64>::default();
    let (coarse, fine) = (
        loss("Bennett", &model, LagrangeIndex1, 1e-3, 2.5),
        loss("Bennett", &model, LagrangeIndex1, 2.5e-4, 2.5),
    );
    assert!(fine < 1e-7 && fine < coarse / 16.0, "{coarse:e} {fine:e}");
}

/// With three cranks all of it turns like one pendulum, through the positions at which either row of a pin vanishes.
#[test]
fn a_third_crank_turns_all_round() {
    fn turns<M: Model + Assemble<f64, Inputs = ()>>() {
        let model = M::standard();
        let lost = loss(model.name(), &model, Baumgarte { alpha: 10.0, beta: 10.0 }, 1e-3, 2.0);
        assert!(lost < 1e-6, "{}: {lost:e} J", model.name());
    }
    turns::<ThirdByRods>();
}

/// The rows that are left out here are taken there, and named so; as many reactions are shared as joints close the loop.
#[test]
fn switched_rows_are_named() {
    let of = |rows: &[linkwright::Row]| rows.iter().map(|row| row.what).collect::<Vec<_>>();
    assert_eq!(of(<Bennett>::default().rows()), ["switched_1", "axis_1"]);
    let model = <BennettKept>::default();
    let kept = of(model.rows());
    assert!(kept.len() == 5 && kept.contains(&"idle_1"), "{kept:?}");
    assert_eq!(model.idle().len(), 3);
    assert_eq!(Bennett::REDUNDANT_ROWS.len(), 3);
}

/// What the loops hold against themselves is shared otherwise, and everything that it does not change is the same: the sum of what
/// the ground exerts.
#[test]
fn reactions_balance_whichever_rows_are_taken() {
    let (tree, absolute) = (Bennett::<f64>::default(), BennettAbsolute::<f64>::default());
    let mut simulation = Simulation::new(&tree, tree.start()).step(1e-3);
    let mut other = Simulation::new(&absolute, absolute.start()).step(1e-3);
    for _ in 0..40 {
        for _ in 0..25 {
            simulation.advance().expect("it turns");
            other.advance().expect("it turns");
        }
        let a = simulation.acceleration().expect("it is regular");
        let lambda = simulation.multipliers().expect("it is regular");
        let state = simulation.state();
        let held = tree.reactions(simulation.time(), state, &(), &a, &lambda);
        let a = other.acceleration().expect("it is regular");
        let lambda = other.multipliers().expect("it is regular");
        let state = other.state();
        let there = absolute.reactions(other.time(), state, &(), &a, &lambda);
        for axis in 0..3 {
            let (one, two) = (held[0].force[axis], there[0].force[axis]);
            assert!((one - two).abs() < 1e-4 * (1.0 + one.abs()), "{axis}: {one} {two}");
        }
    }
}

/// A row that vanishes as a whole is seen, in every formulation.
#[test]
fn a_row_that_vanishes_is_reported() {
    fn seen<F: Formulation<f64, ByDistance<f64>>>(name: &str, formulation: F) {
        let model = ByDistance::<f64>::default();
        let mut simulation = Simulation::new(&model, model.start()).formulation(formulation).step(1e-3);
        let mut found = None;
        while simulation.time() < 0.8 && found.is_none() {
            found = simulation.advance().unwrap_or_else(|error| panic!("{name}: {error}")).near_singular;
        }
        let near = found.unwrap_or_else(|| panic!("{name}: nothing was reported"));
        assert!((near.time - 0.6626).abs() < 2e-3 && near.row.of == "bar", "{name}: {near:?}");
    }
    let model = ByDistance::<f64>::default();
    let penalty = Penalty::for_model(&model, 0.0, &model.start().q, 1e-3);
    seen("index 1", LagrangeIndex1);
    seen("Baumgarte", Baumgarte { alpha: 10.0, beta: 10.0 });
    seen("index 1, projected", Projected::after(LagrangeIndex1));
    seen("penalty", penalty);
    seen("augmented Lagrangian", AugmentedLagrangian::new(penalty));
    seen("null space", NullSpace);
    seen("partitioned", Partitioned::default());
}
