//! Redundant joints: left out, kept with idle rows, or made freer by hand, a mechanism moves alike.

use crate::registry::{Model, model};
use linkwright::{Assemble, AssembleExt, Baumgarte, Mechanism, Simulation, Vector, mechanism};
use linkwright_compiler::compile;
use linkwright_compiler::model::Coordinates;

/// A four-bar in space, of revolutes with parallel axes but for what the joints b, c and d are.
macro_rules! four_bar {
    ($name:ident, $redundant:ident, $b:ident($($b_axis:tt)*), $c:ident($($c_axis:tt)*), { $($guess:tt)* }) => {
        mechanism! {
            spatial $name {
                gravity [m/s^2] = (0, -9.81, 0);
                box left  { mass [kg] = 1; size [m] = (1, 0.1, 0.2); point near [m] = (-0.5, 0, 0); point far [m] = (0.5, 0, 0); }
                box above { mass [kg] = 2; size [m] = (2, 0.1, 0.1); point near [m] = (-1, 0, 0); point far [m] = (1, 0, 0); }
                box right { mass [kg] = 1; size [m] = (1.5, 0.1, 0.1); point near [m] = (-0.75, 0, 0); point far [m] = (0.75, 0, 0); }
                joint a: revolute(ground(0, 0, 0) [m], left.near, axis = (0, 0, 1));
                joint b: $b(left.far, above.near $($b_axis)*);
                joint c: $c(above.far, right.far $($c_axis)*);
                joint d: revolute(ground(2, 0, 0) [m], right.near, axis = (0, 0, 1));
                start { a.angle [deg] = 70; a.rate [rad/s] = 2; d.angle [deg] ~ 90; $($guess)* }
                options { redundant = $redundant; }
                expect { degrees_of_freedom = 1; }
                output swing [rad] = d.angle;
            }
        }
        model!($name);
    };
}
four_bar!(Dropped, drop, revolute(, axis = (0, 0, 1)), revolute(, axis = (0, 0, 1)), {});
four_bar!(Kept, keep, revolute(, axis = (0, 0, 1)), revolute(, axis = (0, 0, 1)), {});
// A universal joint and a spherical one leave what three rows too many held.
four_bar!(
    Freer,
    refuse,
    universal(, axis = (0, 0, 1), second_axis = (0, 1, 0)),
    spherical(),
    { b.angle_1 [rad] ~ -0.95; b.angle_2 [rad] ~ 0; }
);

mechanism! {
    /// A third crank that repeats what two hold: every bar of a parallelogram in the plane.
    planar ThirdCrank {
        gravity [m/s^2] = (0, -9.81);
        rod one { mass [kg] = 1; length [m] = 1; }
        rod two { mass [kg] = 1; length [m] = 1; }
        rod three { mass [kg] = 1; length [m] = 1; }
        rod table { mass [kg] = 2; length [m] = 2; }
        joint a: revolute(ground(0, 0) [m], one.start);
        joint b: revolute(ground(1, 0) [m], two.start);
        joint c: revolute(ground(2, 0) [m], three.start);
        joint d: revolute(one.end, table.start);
        joint e: revolute(two.end, table.center);
        joint f: revolute(three.end, table.end);
        start { a.angle [deg] = 60; b.angle [deg] ~ 60; c.angle [deg] ~ 60; table.angle [rad] ~ 0; }
        options { redundant = drop; }
        expect { degrees_of_freedom = 1; }
        output angle [rad] = a.angle;
    }
}
model!(ThirdCrank);

fn swing<M: Model + linkwright::Assemble<f64, Inputs = ()>>() -> (f64, f64) {
    let model = M::standard();
    let start = model.assemble(&model.start()).unwrap_or_else(|error| panic!("{}: {error}", model.name()));
    let mut simulation =
        Simulation::new(&model, start).formulation(Baumgarte { alpha: 10.0, beta: 10.0 }).step(1e-3);
    simulation.advance_until(1.0).unwrap_or_else(|error| panic!("{}: {error}", model.name()));
    let residual = simulation.constraint_residual();
    assert!(residual.position < 1e-9 && residual.velocity < 1e-8, "{}: {residual:?}", model.name());
    let swing = linkwright::Fields::to_array(&simulation.sample().outputs).as_slice()[0];
    (swing, simulation.energy())
}

#[test]
fn all_three_move_alike() {
    let (dropped, kept, freer) = (swing::<Dropped>(), swing::<Kept>(), swing::<Freer>());
    assert!((dropped.0 - kept.0).abs() < 1e-10, "{dropped:?} {kept:?}");
    assert!((dropped.0 - freer.0).abs() < 1e-9, "{dropped:?} {freer:?}");
    assert!((dropped.1 - freer.1).abs() < 1e-8, "{dropped:?} {freer:?}");
}

#[test]
fn rows_are_left_out_or_idle() {
    assert_eq!(Dropped::REDUNDANT_ROWS.len(), 3);
    assert_eq!(Kept::REDUNDANT_ROWS, Dropped::REDUNDANT_ROWS);
    assert_eq!(<Dropped>::default().rows().len() + 3, <Kept>::default().rows().len());
    assert_eq!(<Kept>::default().idle().len(), 3);
    // A force that the loop holds against itself runs through every joint.
    assert_eq!(Dropped::SHARED_REACTIONS, ["a", "b", "c", "d"]);
    assert!(Freer::REDUNDANT_ROWS.is_empty() && Freer::SHARED_REACTIONS.is_empty());

    let model = Kept::<f64>::default();
    let start = model.start();
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    model.acceleration(0.0, &start, &(), &mut a, &mut lambda);
    let idle = model.idle();
    for (row, lambda) in lambda.iter().enumerate() {
        assert_eq!(*lambda == 0.0, idle.contains(&(row as u16)), "row {row}: {lambda}");
    }
}

/// In absolute coordinates the same number of rows is superfluous, and the motion is the same.
#[test]
fn absolute_coordinates_drop_as_many() {
    for source in [Dropped::SOURCE, Kept::SOURCE, ThirdCrank::SOURCE] {
        let tokens = || source.parse().expect("the source was tokens");
        let tree = compile(tokens(), Some(Coordinates::Tree)).expect("it compiled before");
        let absolute = compile(tokens(), Some(Coordinates::Absolute)).expect("in other coordinates");
        assert_eq!(tree.assembly.dropped.len(), absolute.assembly.dropped.len());
        assert_eq!(tree.assembly.shared, absolute.assembly.shared);
        assert_eq!(absolute.assembly.mobility.generic, 1);
    }
}

#[test]
fn a_third_crank_changes_nothing() {
    assert_eq!(ThirdCrank::REDUNDANT_ROWS.len(), 1);
    let (angle, energy) = swing::<ThirdCrank>();
    // All of it is one pendulum: J θ̈ = −M g cos θ with J = 3 · ⅓ + 2 and M = 3 · ½ + 2.
    let (mut theta, mut rate) = (std::f64::consts::FRAC_PI_3, 0.0);
    let h = 1e-3;
    let slope = |theta: f64| -3.5 * 9.81 * f64::cos(theta) / 3.0;
    for _ in 0..1000 {
        let (k1, l1) = (rate, slope(theta));
        let (k2, l2) = (rate + 0.5 * h * l1, slope(theta + 0.5 * h * k1));
        let (k3, l3) = (rate + 0.5 * h * l2, slope(theta + 0.5 * h * k2));
        let (k4, l4) = (rate + h * l3, slope(theta + h * k3));
        theta += h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
        rate += h * (l1 + 2.0 * l2 + 2.0 * l3 + l4) / 6.0;
    }
    let off = (angle - theta).rem_euclid(std::f64::consts::TAU);
    assert!(off.min(std::f64::consts::TAU - off) < 1e-8, "{angle} {theta}");
    assert!((energy - 3.5 * 9.81 * std::f64::consts::FRAC_PI_3.sin()).abs() < 1e-7, "{energy}");
}
