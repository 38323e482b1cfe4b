//! Events of a body that turns uniformly, so that their times are known, and of an input that jumps.

use crate::double_pendulum::{DoublePendulum, Torque};
use linkwright_runtime::{
    Direction, DormandPrince, Event, ExplicitTrapezoidal, InputSource, Integrator, LagrangeIndex1,
    MechanismDynamics, Rk4, SemiImplicitEuler, Simulation, SimulationError, State,
};

type Turning = State<[f64; 8], [f64; 2]>;

/// Upper body at 0 rad, 1 rad/s.
const START: Turning = State::new([1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [1.0, 1.0]);

/// No torque.
struct Free;

impl InputSource<f64, DoublePendulum> for Free {
    const HELD: bool = false;

    fn sample(&mut self, _time: f64, _state: &Turning) -> Torque {
        Torque { shoulder: 0.0 }
    }
}

type Dynamics<'m> = MechanismDynamics<'m, DoublePendulum, f64, LagrangeIndex1, Free>;
type Turn<'m, I> = Simulation<'m, DoublePendulum, f64, LagrangeIndex1, Free, I>;

fn turn<I: for<'m> Integrator<f64, Dynamics<'m>>>(
    model: &DoublePendulum,
    integrator: I,
    step: f64,
) -> Turn<'_, I> {
    Simulation::new(model, START).input_source(Free).integrator(integrator).step(step)
}

/// The times and indices of all events until `end`.
fn all<I: for<'m> Integrator<f64, Dynamics<'m>>>(
    simulation: &mut Turn<'_, I>,
    end: f64,
    events: &[Event],
) -> Vec<(f64, usize)> {
    let mut found = Vec::new();
    while let Some(event) = simulation.run_until_event(end, events, |_| ()).unwrap() {
        assert_eq!(simulation.time(), event.time);
        found.push((event.time, event.event));
    }
    assert_eq!(simulation.time(), end);
    found
}

fn close(found: &[(f64, usize)], expected: &[(f64, usize)], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        let late = found.0 - expected.0;
        assert!(found.1 == expected.1 && (-1e-14..=tolerance).contains(&late), "{found:?} {expected:?}");
    }
}

fn found_by<I: for<'m> Integrator<f64, Dynamics<'m>> + Copy>(integrator: I) {
    let model = DoublePendulum::balanced();
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
        let events = [Event::of("upper").level(1.234).tolerance(tolerance)];
        close(&all(&mut turn(&model, integrator, 0.1), 2.0, &events), &[(1.234, 0)], tolerance + 1e-14);
    }
}

#[test]
fn every_integrator_finds_the_crossing() {
    found_by(Rk4);
    found_by(SemiImplicitEuler);
    found_by(ExplicitTrapezoidal);
    found_by(DormandPrince::fixed());
    found_by(DormandPrince::tolerance(1e-9));
}

#[test]
fn only_crossings_in_the_direction_count() {
    let model = DoublePendulum::balanced();
    let level = Event::of("upper").level(0.55);
    assert_eq!((level.direction, level.rising().either().direction), (Direction::Either, Direction::Either));
    for (event, count) in [(level.rising(), 1), (level.falling(), 0), (level, 1)] {
        let found = all(&mut turn(&model, Rk4, 0.1), 2.0, &[event]);
        assert_eq!(found.len(), count, "{event:?}");
    }
    let mut simulation = turn(&model, Rk4, 0.1);
    let event = simulation.run_until_event(2.0, &[level], |_| ()).unwrap().unwrap();
    assert!(event.rising && event.output == "upper" && event.includes(0) && !event.includes(1));
}

/// At half a turn the arc tangent jumps by −2π; the angle goes on.
#[test]
fn a_whole_turn_crosses_nothing() {
    let model = DoublePendulum::balanced();
    let events = [Event::of("upper").level(3.0).falling(), Event::of("upper").level(8.0)];
    close(&all(&mut turn(&model, Rk4, 0.25), 30.0, &events), &[(8.0, 1)], 1e-9);
    close(&all(&mut turn(&model, DormandPrince::tolerance(1e-8), 0.5), 30.0, &events), &[(8.0, 1)], 1e-9);
}

#[test]
fn of_several_in_one_step_the_earliest_comes_first() {
    let model = DoublePendulum::balanced();
    let at = |level: f64| Event::of("upper").level(level);
    let events = [at(1.3), at(1.1), at(1.2), at(1.1 + 1e-6)];
    let expected = [(1.1, 1), (1.1 + 1e-6, 3), (1.2, 2), (1.3, 0)];
    close(&all(&mut turn(&model, Rk4, 0.7), 5.0, &events), &expected, 1e-9);
    close(&all(&mut turn(&model, DormandPrince::tolerance(1e-6), 0.7), 5.0, &events), &expected, 1e-9);
    // At one time both are told of, and neither again.
    let mut simulation = turn(&model, Rk4, 0.7);
    let both = [at(1.1), at(1.1), at(2.0)];
    let event = simulation.run_until_event(5.0, &both, |_| ()).unwrap().unwrap();
    assert!(event.event == 0 && event.includes(1) && !event.includes(2) && !event.includes(64));
    close(&all(&mut simulation, 5.0, &both), &[(2.0, 2)], 1e-9);
}

#[test]
fn what_begins_at_its_level_has_crossed_before() {
    let model = DoublePendulum::balanced();
    let zero = Event::of("upper");
    for event in [zero, zero.rising(), zero.falling()] {
        close(&all(&mut turn(&model, Rk4, 0.1), 2.0, &[event]), &[], 0.0);
    }
    // What ends at it crosses there, and not again: 0.5 is met to the bit.
    let mut simulation = turn(&model, Rk4, 0.125);
    let upper = |simulation: &mut Turn<'_, Rk4>| simulation.sample().outputs.upper;
    simulation.advance_until(0.5).unwrap();
    let level = upper(&mut simulation);
    let mut simulation = turn(&model, Rk4, 0.125);
    let event = zero.level(level);
    close(&all(&mut simulation, 0.5, &[event]), &[(0.5, 0)], 1e-9);
    close(&all(&mut simulation, 2.0, &[event]), &[], 0.0);
}

#[test]
fn samples_lead_to_the_event_and_on() {
    let model = DoublePendulum::balanced();
    let mut simulation = turn(&model, Rk4, 0.1);
    let mut times = Vec::new();
    let event = Event::of("upper").level(0.25);
    let found = simulation.run_until_event(1.0, &[event], |sample| times.push(sample.time)).unwrap().unwrap();
    assert_eq!(times, [0.0, 0.1, 0.2, found.time]);
    assert!(simulation.sample().outputs.upper >= 0.25, "it stands behind the crossing");
    times.clear();
    assert_eq!(simulation.run_until_event(0.5, &[event], |sample| times.push(sample.time)), Ok(None));
    assert_eq!((times.len(), times[0], simulation.time()), (4, found.time, 0.5));
    assert_eq!(simulation.run_until_event(0.6, &[], |_| ()), Ok(None));
    // The repeated step is a step: the same as one of that size.
    let mut direct = turn(&model, Rk4, 0.1);
    direct.advance_until(0.2).unwrap();
    let there = direct.advance_until(found.time).unwrap();
    let mut again = turn(&model, Rk4, 0.1);
    again.run_until_event(1.0, &[event], |_| ()).unwrap();
    assert_eq!(*again.state(), there);
}

/// Evaluations of the input tell how many steps were made.
#[test]
fn the_search_is_bounded() {
    let model = DoublePendulum::new();
    let swing = State::new([1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0; 2]);
    let count = |event: Event| {
        let mut count = 0;
        let source = |time: f64, _: &State<_, _>| {
            count += 1;
            Torque { shoulder: if time < 0.0123456 { 0.0 } else { 1.0 } }
        };
        let mut simulation = Simulation::new(&model, swing).sampled(source).step(0.02);
        let found = simulation.run_until_event(0.02, &[event], |_| ()).unwrap();
        assert!(found.is_some());
        count
    };
    // A step and its two samples, then trials of four or five evaluations each.
    let smooth = count(Event::of("upper").level(-0.001));
    let jump = count(Event::of("torque").level(0.3));
    println!("{smooth} evaluations for a smooth crossing, {jump} for a jump");
    // log₂(0.02/1e-9) = 24.3.
    assert!(smooth < 60 && jump < 6 + 5 * 26 + 6, "{smooth} {jump}");
}

#[test]
fn a_jump_of_an_input_is_found() {
    let model = DoublePendulum::balanced();
    let torque = |time: f64, _: &State<_, _>| Torque { shoulder: if time < 0.7371 { 0.0 } else { 1e-3 } };
    let event = Event::of("torque").level(5e-4).rising();
    let mut sampled = Simulation::new(&model, START).sampled(torque).step(0.05);
    let found = sampled.run_until_event(1.0, &[event], |_| ()).unwrap().unwrap();
    assert!((found.time - 0.7371).abs() < 1e-9, "{found:?}");
    // A jump that is felt: the steps are shortened before it, in the search too.
    for tolerance in [1e-4, 1e-7, 1e-10] {
        let heavy = DoublePendulum::new();
        let mut felt = Simulation::new(&heavy, START)
            .sampled(|time, _| Torque { shoulder: if time < 0.7371 { -20.0 } else { 40.0 * time } })
            .integrator(DormandPrince::tolerance(tolerance))
            .step(0.1);
        let event = Event::of("torque").tolerance(1e-11);
        let found = felt.run_until_event(1.0, &[event], |_| ()).unwrap().unwrap();
        assert!((found.time - 0.7371).abs() < 1.1e-11, "{found:?}");
        assert_eq!(felt.run_until_event(1.0, &[event], |_| ()), Ok(None));
    }
    // Held over the steps, it changes at the beginning of the first one after.
    let mut asked = 0;
    let mut held = Simulation::new(&model, START)
        .held(|time, state| {
            asked += 1;
            torque(time, state)
        })
        .step(0.05);
    let found = held.run_until_event(1.0, &[event], |_| ()).unwrap().unwrap();
    assert!((found.time - 0.75).abs() < 2e-9, "{found:?}");
    assert_eq!(asked, 17, "16 steps, and the event");
}

#[test]
fn mistakes_are_named() {
    let model = DoublePendulum::balanced();
    let mut simulation = turn(&model, Rk4, 0.1);
    let mut error = |events: &[Event]| simulation.run_until_event(1.0, events, |_| ()).unwrap_err();
    let found = error(&[Event::of("upper"), Event::of("uper")]);
    assert_eq!(
        found,
        SimulationError::NoSuchOutput { name: "uper", known: &["upper", "torque"], nearest: Some("upper") }
    );
    let text = found.to_string();
    assert!(text.contains("perhaps `upper` is meant; its outputs are `upper`, `torque`"), "{text}");
    for tolerance in [0.0, -1e-9, f64::NAN, f64::INFINITY] {
        let found = error(&[Event::of("upper").tolerance(tolerance)]);
        assert!(found.to_string().contains("the tolerance of an event is"), "{found}");
    }
    let found = error(&[Event::of("upper").level(f64::NAN)]);
    assert!(matches!(found, SimulationError::Setting(_)), "{found}");
    let found = error(&[Event::of("upper"); 65]);
    assert!(found.to_string().contains("at most 64"), "{found}");
    assert_eq!((simulation.time(), *simulation.state()), (0.0, START));
    let found = simulation.run_until_event(-1.0, &[Event::of("upper")], |_| ()).unwrap_err();
    assert!(matches!(found, SimulationError::End { .. }), "{found}");
}

#[test]
fn single_precision_finds_events_to_its_resolution() {
    let model = DoublePendulum::<f32>::balanced();
    let start = State::new([1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [1.0, 1.0]);
    let mut simulation =
        Simulation::new(&model, start).sampled(|_, _| Torque { shoulder: 0.0_f32 }).step(0.1);
    let event = Event::of("upper").level(2.5).rising();
    let found = simulation.run_until_event(5.0, &[event], |_| ()).unwrap().unwrap();
    assert!((found.time - 2.5).abs() < 1e-5, "{found:?}");
}
