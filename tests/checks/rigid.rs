//! Rigid contacts: against closed forms, by every explicit method (implicit ones are `implicit_rigid.rs`), in closed loops; errors that name the contact. Shipped models with them are in
//! `published/impacts.rs`.

use linkwright::{
    Assemble, AssembleExt, AugmentedLagrangian, Baumgarte, DormandPrince, ExplicitTrapezoidal, Formulation,
    Integrator, LagrangeIndex1, MechanismDynamics, NoInputs, NullSpace, Partitioned, Penalty, Projected, Rk4,
    SemiImplicitEuler, Simulation, SimulationError, StateOf, Step,
};

linkwright::mechanism! {
    planar Bouncing {
        gravity [m/s^2] = (0, -9.81);
        particle ball { mass [kg] = 1; }
        surface below: point(ball.center);
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact stop: between(below, floor) = rigid(restitution = 0.8);
        start { ball.center.x [m] = 0; ball.center.y [m] = 1; }
        output height [m] = ball.center.y;
        output force [N] = stop.force;
        output gap [m] = stop.gap;
    }
}

linkwright::mechanism! {
    /// A slider-crank whose slider comes to a stop at the end of its rail, and whose crank to one of its own.
    planar Stopped {
        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 1; length [m] = 0.2; }
        rod coupler { mass [kg] = 2; length [m] = 0.5; }
        body slider { mass [kg] = 1.5; inertia [kg*m^2] = 0.01; }
        joint hinge: revolute(ground(0, 0) [m], crank.start);
        joint pin: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, slider.center);
        joint rail: prismatic(ground(0, 0) [m], slider.center, axis = (1, 0));
        limit end: rail.travel [mm] in 0..640 = rigid(restitution = 0.6);
        limit stop: hinge.angle [deg] in -200..150 = rigid(restitution = 0.3);
        start { hinge.angle [deg] = 120; coupler.angle [deg] ~ -20; }
        options { coordinates = absolute; emit = (null_space); }
        output angle [rad] = hinge.angle;
        output travel [m] = rail.travel;
    }
}

linkwright::mechanism! {
    /// A bar that falls flat on both of its ends.
    planar Flat {
        gravity [m/s^2] = (0, -9.81);
        rod bar { mass [kg] = 3; length [m] = 1; surface left: point(bar.start); surface right: point(bar.end); }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact on_left: between(bar.left, floor) = rigid(restitution = 0.5);
        contact on_right: between(bar.right, floor) = rigid(restitution = 0.5);
        start { bar.center.x [m] = 0; bar.center.y [m] = 0.2; bar.angle [rad] = 0; }
        output forces [N] = on_left.force - on_right.force;
        output force [N] = on_left.force;
    }
}

linkwright::mechanism! {
    /// A ball on a table that falls away faster and faster.
    spatial Left {
        gravity [m/s^2] = (0, 0, -9.81);
        particle ball { mass [kg] = 2; }
        surface below: point(ball.center);
        surface table: plane(ground(0 [m], 0 [m], -10 [m/s^4]*time^4), axis = (0, 0, 1));
        contact stop: between(below, table) = rigid(restitution = 0);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0; ball.center.z [m] = 0; }
        output force [N] = stop.force;
    }
}

linkwright::mechanism! {
    /// Six balls that fall apart from each other, and a bar on both of its ends.
    planar Apart {
        gravity [m/s^2] = (0, -9.81);
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        repeat i in 0..6 {
            particle ball[i] { mass [kg] = 1 + i; surface below: point(ball[i].center); }
            contact stop[i]: between(ball[i].below, floor) = rigid(restitution = 0);
            start { ball[i].center.x [m] = i; ball[i].center.y [m] = 0.1; }
        }
        rod bar { mass [kg] = 3; length [m] = 1; surface left: point(bar.start); surface right: point(bar.end); }
        contact on_left: between(bar.left, floor) = rigid(restitution = 0);
        contact on_right: between(bar.right, floor) = rigid(restitution = 0);
        friction rub: on(on_left) = dry(static = 0.3);
        start { bar.center.x [m] = -2; bar.center.y [m] = 0.1; bar.angle [rad] = 0; bar.center.velocity.x [m/s] = 0.2; }
        output first [N] = stop[0].force;
        output last [N] = stop[5].force;
        output bar [N] = on_left.force + on_right.force;
        output sliding [m/s] = on_left.sliding;
    }
}

linkwright::mechanism! {
    /// A ball on a slope, which slides down to a wall: only by the slope does it come near the wall.
    planar Cornered {
        gravity [m/s^2] = (0, -9.81);
        particle ball { mass [kg] = 2; }
        surface below: point(ball.center);
        surface slope: half_plane(line(ground(0, 0) [m], ground(1, 0.5) [m]));
        surface wall: half_plane(line(ground(0, 1) [m], ground(0, 0) [m]));
        contact lies: between(below, slope) = rigid(restitution = 0);
        contact strikes: between(below, wall) = rigid(restitution = 0.5);
        start { ball.center.x [m] = 0.4; ball.center.y [m] = 0.2; }
        output lies [N] = lies.force;
        output strikes [N] = strikes.force;
    }
}

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

/// It falls 1 m, touches at √(2h/g) and then after 2 eⁿ √(2h/g) each.
#[test]
fn a_ball_bounces_and_rests() {
    let model = Bouncing::default();
    let mut simulation = Simulation::new(&model, Bouncing::START).step(1e-3);
    for touch in [0.4515236409857309, 1.1739614665629004, 1.7519117270246359] {
        simulation.advance_until(touch - 1e-9).expect("it moves");
        let before = simulation.state().v[1];
        simulation.advance_until(touch + 1e-9).expect("it moves");
        close(simulation.state().v[1], -0.8 * before, 1e-7, "speed after a touch");
    }
    simulation.advance_until(2.0).expect("it moves");
    close(simulation.state().q[1], 0.2607417283270572, 1e-11, "height");
    simulation.advance_until(3.0).expect("it moves");
    close(simulation.state().q[1], 0.068_707_460_965_765_72, 1e-11, "height");
    let at_rest = 4.063_712_768_871_578;
    let (mut rested, mut lost, mut impacts) = (0, 0.0, 0);
    simulation.advance_until(at_rest - 2e-9).expect("it moves");
    assert_eq!(simulation.state().gates, [0.0]);
    while simulation.time() < 4.2 {
        let step = simulation.advance().expect("it moves");
        (rested, lost, impacts) = (rested + step.rested, lost + step.lost, impacts + step.impacts);
    }
    println!("{impacts} impacts, {lost:e} J in the last of them");
    assert_eq!(rested, 1);
    assert_eq!((simulation.state().q[1], simulation.state().v[1]), (0.0, 0.0));
    close(simulation.sample().outputs.force, 9.81, 1e-12, "force at rest");
    let mut simulation = Simulation::new(&model, Bouncing::START).step(1e-3);
    let (mut lost, mut rested) = (0.0, 0);
    while simulation.time() < at_rest + 1e-9 - 1e-3 {
        lost += simulation.advance().expect("it moves").lost;
    }
    for end in [at_rest - 1e-9, at_rest + 1e-9] {
        while simulation.time() < end {
            let left = end - simulation.time();
            let step = simulation.step(left.min(1e-3));
            simulation = step;
            let step = simulation.advance().expect("it moves");
            lost += step.lost;
            rested += step.rested;
        }
    }
    assert_eq!(rested, 1);
    close(lost, 9.81, 1e-9, "lost");
}

mod resting {
    linkwright::mechanism! {
        /// As `Bouncing`, but what would part with less than 1 m/s stays.
        pub(super) planar Resting {
            gravity [m/s^2] = (0, -9.81);
            particle ball { mass [kg] = 1; }
            surface below: point(ball.center);
            surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
            contact stop: between(below, floor) = rigid(restitution = 0.8, rest [m/s] = 1);
            start { ball.center.x [m] = 0; ball.center.y [m] = 1; }
            output force [N] = stop.force;
        }
    }
}

/// It parts with 0.8ⁿ √(2 g h) six times; the seventh would be 0.93 m/s.
#[test]
fn what_would_part_slowly_rests() {
    let model = resting::Resting::<f64>::default();
    let mut simulation = Simulation::new(&model, model.start()).step(1e-3);
    let fall = (2.0_f64 / 9.81).sqrt();
    let at_rest = fall + (1..=6).map(|n| 2.0 * 0.8_f64.powi(n) * fall).sum::<f64>();
    simulation.advance_until(at_rest - 1e-6).expect("it moves");
    assert_eq!(simulation.state().gates, [0.0]);
    let step = simulation.advance_until(at_rest + 1e-6).map(|_| *simulation.state()).expect("it moves");
    assert_eq!((step.q[1], step.v[1]), (0.0, 0.0));
    assert!((simulation.sample().outputs.force - 9.81).abs() < 1e-12);
    let (mut impacts, mut rested, mut lost) = (0, 0, 0.0);
    let mut simulation = Simulation::new(&model, model.start()).step(1e-3);
    while simulation.time() < at_rest + 0.1 {
        let step = simulation.advance().expect("it moves");
        (impacts, rested, lost) = (impacts + step.impacts, rested + step.rested, lost + step.lost);
    }
    assert_eq!((impacts, rested), (7, 1));
    close(lost, 9.81, 1e-9, "lost");
}

/// Samples at even times, before, between and after touches.
#[test]
fn dense_output_ends_at_a_touch() {
    let model = Bouncing::default();
    let mut simulation =
        Simulation::new(&model, Bouncing::START).integrator(DormandPrince::tolerance(1e-11)).step(0.1);
    let mut forces = 0;
    simulation
        .run_every(0.01, 4.5, |sample| {
            assert!(sample.outputs.height >= -1e-12, "{} m at {} s", sample.outputs.height, sample.time);
            assert_eq!(sample.outputs.gap, sample.outputs.height);
            if (sample.time - 3.0).abs() < 1e-9 {
                close(sample.outputs.height, 0.068_707_460_965_765_72, 1e-9, "height");
            }
            if sample.time > 4.07 {
                close(sample.outputs.force, 9.81, 1e-12, "force at rest");
                forces += 1;
            }
        })
        .expect("it moves");
    assert!(forces > 40);
}

/// The energy that is missing in the end, and where it is then.
fn balance<'m, M, F, I>(
    model: &'m M,
    start: StateOf<M>,
    formulation: F,
    integrator: I,
    h: f64,
) -> (u32, f64, StateOf<M>)
where
    M: Assemble<f64, Inputs = ()>,
    F: Formulation<f64, M>,
    I: Integrator<f64, MechanismDynamics<'m, M, f64, F, NoInputs>>,
{
    let mut simulation =
        Simulation::new(model, start).formulation(formulation).integrator(integrator).step(h);
    let (begun, mut lost, mut impacts) = (simulation.energy(), 0.0, 0);
    let steps = (END / h).round() as usize;
    for _ in 0..steps {
        let step: Step = simulation.advance().expect("it moves");
        (lost, impacts) = (lost + step.lost, impacts + step.impacts);
        if simulation.time() >= END - 1e-9 {
            break;
        }
    }
    (impacts, simulation.energy() + lost - begun, simulation.state().clone())
}

const END: f64 = 0.9;

/// Impulses through a closed loop: energies close, and every method comes to the same place.
#[test]
fn a_slider_crank_comes_to_its_stops() {
    let model = Stopped::default();
    let projected = Projected::after(NullSpace);
    let (impacts, off, end) = balance(&model, Stopped::START, projected, Rk4, 1e-4);
    println!("{impacts} impacts, energy {off:.1e} J off, at {:?}", end.q);
    assert!(impacts >= 3 && off.abs() < 1e-9);
    let augmented = AugmentedLagrangian::new(Penalty::for_model(&model, 0.0, &Stopped::START.q, 5e-4));
    macro_rules! by {
        ($($name:literal: $formulation:expr, $integrator:expr, $h:literal, $bound:literal;)*) => {$({
            let (count, off, found) = balance(&model, Stopped::START, $formulation, $integrator, $h);
            let away = end.q.iter().zip(found.q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            println!("{}: {count} impacts, {off:.1e} J, {away:.1e} away", $name);
            assert!(away <= $bound && count > 5 && off.abs() <= $bound, "{}", $name);
        })*};
    }
    by! {
        "index 1, RK4": LagrangeIndex1, Rk4, 5e-4, 1e-6;
        "null space, RK4": NullSpace, Rk4, 5e-4, 1e-6;
        "Baumgarte, RK4": Baumgarte { alpha: 10.0, beta: 10.0 }, Rk4, 5e-4, 1e-6;
        "partitioned, RK4": Partitioned::default(), Rk4, 5e-4, 1e-4;
        "penalty, RK4": Penalty::for_model(&model, 0.0, &Stopped::START.q, 1e-4), Rk4, 1e-4, 1e-2;
        "augmented Lagrangian, RK4": augmented, Rk4, 5e-4, 1e-6;
        "explicit trapezoidal": LagrangeIndex1, ExplicitTrapezoidal, 5e-4, 1e-2;
        "semi-implicit Euler": LagrangeIndex1, SemiImplicitEuler, 1e-4, 5e-2;
    }
}

/// A mechanism whose bar falls flat: both ends at once, by symmetry with equal impulses, and to rest.
#[test]
fn two_at_once() {
    let model = Flat::default();
    let mut simulation = Simulation::new(&model, Flat::START).step(1e-3);
    let (mut rested, mut lost) = (0, 0.0);
    let mut most = 0;
    while simulation.time() < 1.0 {
        let step = simulation.advance().expect("it moves");
        (rested, lost) = (rested + step.rested, lost + step.lost);
        most = most.max(step.impacts);
        assert!(simulation.state().v.as_slice().iter().skip(2).all(|rate| rate.abs() < 1e-9));
    }
    assert!(most >= 2);
    assert_eq!(rested, 2);
    close(lost, 3.0 * 9.81 * 0.2, 1e-9, "lost");
    close(simulation.sample().outputs.force, 1.5 * 9.81, 1e-9, "force at rest");
    close(simulation.sample().outputs.forces, 0.0, 1e-9, "difference of the forces");
}

/// It rests with m (g − 120 t²), parts where that is zero, and then flies.
#[test]
fn what_rests_parts_where_its_force_ends() {
    let model = Left::default();
    let mut simulation = Simulation::new(&model, Left::START).step(1e-3);
    let left = (9.81_f64 / 120.0).sqrt();
    simulation.advance_until(0.2).expect("it moves");
    close(simulation.state().q[2], -10.0 * 0.2_f64.powi(4), 1e-12, "height at rest");
    close(simulation.sample().outputs.force, 2.0 * (9.81 - 120.0 * 0.04), 1e-9, "force at rest");
    simulation.advance_until(left - 1e-8).expect("it moves");
    assert!(simulation.state().gates[0] > 0.0);
    simulation.advance_until(left + 1e-8).expect("it moves");
    assert_eq!(simulation.state().gates[0], 0.0);
    simulation.advance_until(0.5).expect("it moves");
    let flown = 0.5 - left;
    let height = -10.0 * left.powi(4) - 40.0 * left.powi(3) * flown - 0.5 * 9.81 * flown * flown;
    close(simulation.state().q[2], height, 1e-9, "height in flight");
}

/// Three balls in a row, of which the first comes to the second, and the second touches the third.
macro_rules! row {
    ($name:ident, $law:ident) => {
        linkwright::mechanism! {
            planar $name {
                param first [1] = 0;
                param second [1] = 1;
                disk a { mass [kg] = 1; radius [m] = 0.5; }
                disk b { mass [kg] = 1; radius [m] = 0.5; }
                disk c { mass [kg] = 1; radius [m] = 0.5; }
                contact ab: between(a.surface, b.surface) = rigid(restitution = first);
                contact bc: between(b.surface, c.surface) = rigid(restitution = second);
                start { a.center.x [m] = -2; a.center.y [m] = 0; a.angle [rad] = 0; a.center.velocity.x [m/s] = 1;
                        b.center.x [m] = 0; b.center.y [m] = 0; b.angle [rad] = 0; c.center.x [m] = 1; c.center.y [m] = 0; c.angle [rad] = 0; }
                options { impact = $law; }
                output a [m/s] = a.center.velocity.x;
                output b [m/s] = b.center.velocity.x;
                output c [m/s] = c.center.velocity.x;
            }
        }
    };
}
row!(RowByNewton, newton);
row!(RowByPoisson, poisson);

/// Speeds after a blow of the first of three equal balls on two that touch, with v = 1 m/s, m = 1 kg, G = [2 −1; −1 2]. Newton: ġ⁺ = (e₁, 0), so that
/// the second and the third go on together. Poisson: P_c = (2/3, 1/3), then e P_c of each, and 1/6 more for the first with e = (0, 1), whose gap
/// would close again.
#[test]
fn restitution_is_of_speeds_or_of_impulses() {
    macro_rules! speeds {
        ($model:ident, $parameters:ident, $first:expr, $second:expr) => {{
            let model = $model::prepare($parameters { first: $first, second: $second }).expect("shares");
            let mut simulation = Simulation::new(&model, $model::START).step(1e-2);
            let mut lost = 0.0;
            let mut impacts = 0;
            while impacts == 0 {
                let step = simulation.advance().expect("it moves");
                (impacts, lost) = (step.impacts, step.lost);
            }
            let o = simulation.sample().outputs;
            close(o.a + o.b + o.c, 1.0, 1e-12, "momentum");
            close(0.5 * (o.a * o.a + o.b * o.b + o.c * o.c) + lost, 0.5, 1e-12, "energy and loss");
            [o.a, o.b, o.c]
        }};
    }
    let third = 1.0 / 3.0;
    for (first, second, newton, poisson) in [
        (0.0, 0.0, [third; 3], [third; 3]),
        (0.0, 1.0, [third; 3], [third / 2.0, third / 2.0, 2.0 * third]),
        (1.0, 1.0, [-third, 2.0 * third, 2.0 * third], [-third, 2.0 * third, 2.0 * third]),
        (0.5, 0.5, [0.0, 0.5, 0.5], [0.0, 0.5, 0.5]),
        (0.5, 1.0, [0.0, 0.5, 0.5], [0.0, third, 2.0 * third]),
    ] {
        let found = [
            speeds!(RowByNewton, RowByNewtonParameters, first, second),
            speeds!(RowByPoisson, RowByPoissonParameters, first, second),
        ];
        for (found, expected) in found.iter().flatten().zip(newton.iter().chain(&poisson)) {
            close(*found, *expected, 1e-12, "speed");
        }
    }
}

/// What cannot be is named, and changes nothing.
#[test]
fn what_cannot_be_is_named() {
    let model = Bouncing::default();
    let inside = StateOf::<Bouncing> { q: [0.0, -0.01], ..Bouncing::START };
    let mut simulation = Simulation::new(&model, inside).step(1e-3);
    let error = simulation.advance().expect_err("it is inside");
    let SimulationError::Inside { contact: "stop", time: 0.0, depth } = error else { panic!("{error}") };
    close(depth, 0.01, 1e-12, "depth");
    assert!(error.to_string().contains("the rigid `stop` is 1.0e-2 m (or rad) inside"), "{error}");
    assert_eq!(error.joint(), Some("stop"));
}

linkwright::mechanism! {
    /// A comb that falls on five of its teeth at one time.
    planar Crowd {
        gravity [m/s^2] = (0, -9.81);
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        body comb {
            mass [kg] = 1; inertia [kg*m^2] = 0.1;
            point a [m] = (-0.2, 0); point b [m] = (-0.1, 0); point c [m] = (0, 0); point d [m] = (0.1, 0); point e [m] = (0.2, 0);
            surface tooth_a: point(comb.a); surface tooth_b: point(comb.b); surface tooth_c: point(comb.c); surface tooth_d: point(comb.d);
            surface tooth_e: point(comb.e);
        }
        contact first: between(comb.tooth_a, floor) = rigid(restitution = 0.5);
        contact second: between(comb.tooth_b, floor) = rigid(restitution = 0.5);
        contact third: between(comb.tooth_c, floor) = rigid(restitution = 0.5);
        contact fourth: between(comb.tooth_d, floor) = rigid(restitution = 0.5);
        contact fifth: between(comb.tooth_e, floor) = rigid(restitution = 0.5);
        start { comb.center.x [m] = 0; comb.center.y [m] = 1; comb.angle [rad] = 0; }
    }
}

linkwright::mechanism! {
    /// A slider that a drive pushes against its stop.
    planar Pushed {
        body slider { mass [kg] = 1.5; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], slider.center, axis = (1, 0));
        drive motor: rail.travel = 0.1 [m/s]*time;
        #[allow(no_effect)]
        limit stop: rail.travel [mm] in -10..50 = rigid(restitution = 0.6);
    }
}

/// The error of a run, which leaves the state of the last whole step, and its text.
#[track_caller]
fn refused<M: Assemble<f64, Inputs = ()>>(
    model: &M,
    start: StateOf<M>,
    end: f64,
) -> (SimulationError, String) {
    let mut simulation = Simulation::new(model, start).step(1e-3);
    let error = simulation.advance_until(end).expect_err("it cannot go on");
    let (time, before) = (simulation.time(), simulation.state().clone());
    assert_eq!(simulation.advance().expect_err("it still cannot"), error);
    assert!(simulation.time() == time && *simulation.state() == before, "a step that fails changes nothing");
    let text = error.to_string();
    (error, text)
}

#[test]
fn more_than_can_be_sought_for_is_named() {
    let (error, text) = refused(&Crowd::default(), Crowd::START, 1.0);
    let SimulationError::Crowded { contact: "fifth", time, most: 4 } = error else { panic!("{error}") };
    close(time, (2.0_f64 / 9.81).sqrt(), 1e-9, "time");
    assert!(text.contains("with `fifth` more than 4 rigid contacts touch"), "{text}");
    assert_eq!(error.joint(), Some("fifth"));
}

/// Parameters are free to say what no restitution is.
#[test]
fn restitutions_of_parameters_are_from_0_to_1() {
    for share in [1.5, -0.1, f64::NAN] {
        let Ok(model) = RowByNewton::prepare(RowByNewtonParameters { first: share, second: 0.5 }) else {
            assert!(share.is_nan(), "{share}");
            continue;
        };
        let (error, text) = refused(&model, RowByNewton::START, 2.0);
        assert!(matches!(error, SimulationError::Setting(_)), "{error}");
        assert!(text.contains("ab is ") && text.contains("it must be a restitution from 0 to 1"), "{text}");
    }
}

#[test]
fn what_a_drive_holds_against_a_stop_is_named() {
    let (error, text) = refused(&Pushed::default(), Pushed::START, 1.0);
    let SimulationError::NoImpact { contact: "stop", time } = error else { panic!("{error}") };
    close(time, 0.5, 1e-9, "time");
    assert!(text.contains("no impulse parts the rigid `stop` and what touches with it"), "{text}");
    assert_eq!(error.joint(), Some("stop"));
}

/// It bounces ever less, by what the slope makes of gravity alone, and rests in the corner.
#[test]
fn what_lies_on_a_slope_comes_to_rest_at_a_wall() {
    let model = Cornered::default();
    let mut simulation = Simulation::new(&model, Cornered::START).step(1e-3);
    // Along the slope 0.2 √5 m at g/√5; all bounces take 2 e/(1 − e) times the way down.
    let falls = (2.0_f64 * 0.2 * 5.0_f64.sqrt() / (9.81 / 5.0_f64.sqrt())).sqrt();
    let (mut impacts, mut rested) = (0, 0.0);
    while simulation.time() < 3.0 {
        let step = simulation.advance().expect("it slides");
        impacts += step.impacts;
        if step.rested > 0 {
            rested = step.time;
        }
    }
    println!("{impacts} impacts, at rest from {rested} s on");
    assert!(impacts < 40, "{impacts} impacts");
    close(rested, 3.0 * falls, 1e-3, "time at which it rests");
    let outputs = simulation.sample().outputs;
    close(outputs.lies, 2.0 * 9.81 * 5.0_f64.sqrt() / 2.0, 1e-11, "what the slope bears");
    close(outputs.strikes, 2.0 * 9.81 / 2.0, 1e-11, "what the wall bears");
}

/// As many as touch at one time, where they know nothing of each other; what lies on two places belongs together.
#[test]
fn what_lies_apart_does_not_count_together() {
    let model = Apart::default();
    let mut simulation = Simulation::new(&model, Apart::START).step(1e-3);
    let (mut impacts, mut rested) = (0, 0);
    while simulation.time() < 0.5 {
        let step = simulation.advance().expect("they fall");
        (impacts, rested) = (impacts + step.impacts, rested + step.rested);
    }
    assert_eq!((impacts, rested), (8, 8));
    let outputs = simulation.sample().outputs;
    close(outputs.first, 9.81, 1e-11, "the first");
    close(outputs.last, 6.0 * 9.81, 1e-11, "the last");
    close(outputs.bar, 3.0 * 9.81, 1e-11, "the bar");
    close(outputs.sliding, 0.0, 1e-14, "sliding");
}
