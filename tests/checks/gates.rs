//! What holds of every mechanism whose gates are held: at one state it has the forces of live gates, impulses take the energy that they say, and
//! bodies that touch each other alone keep their momentum.

use crate::registry::{Model, Random, for_each};
use crate::walking::walk;
use linkwright::{AssembleExt, Fields, Mechanism, Rk4, Simulation, Vector};
use linkwright_compiler::model::Coordinates;
use linkwright_compiler::schedule::{Function, Inputs, run};
use linkwright_compiler::{Compiled, compile};

for_each!(held_is_live_at_one_state);
for_each!(impulses_take_what_they_say);

const STATES: usize = 20;

fn in_coordinates(source: &str, coordinates: Coordinates) -> Compiled {
    compile(source.parse().expect("tokens"), Some(coordinates)).unwrap_or_else(|errors| panic!("{errors}"))
}

/// With the gates that live ones have at a state, forces, powers, accelerations and outputs are those of the same definition with live gates.
fn held_is_live_at_one_state<M: Model>() {
    let model = M::standard();
    // Memories are no other thing where gates are live.
    if model.takes_whole_steps() || model.is_rigid() || !model.memory_names().is_empty() {
        return;
    }
    held_is_live(model.name(), M::source());
}

fn held_is_live(name: &str, source: &str) {
    let word = "contact = held;";
    assert!(source.contains(word), "{name}");
    let (mut closed, mut open) = (0, 0);
    for coordinates in [Coordinates::Tree, Coordinates::Absolute] {
        let held = in_coordinates(source, coordinates);
        let live = in_coordinates(&source.replace(word, ""), coordinates);
        assert!(held.mechanism.gates().count() > 0 && live.mechanism.gates().count() == 0);
        let mut random = Random::new(50);
        for _ in 0..STATES {
            let mut point = random.point(&held);
            let mut other = Inputs { gates: Vec::new(), ..point.clone() };
            let program =
                |compiled: &Compiled, function, inputs: &Inputs| run(compiled.programs.get(function), inputs);
            point.prepared = program(&held, Function::Prepare, &point);
            other.prepared = program(&live, Function::Prepare, &other);
            let guards = program(&held, Function::Guards, &point);
            let (gaps, forces) = guards.split_at(point.gates.len());
            let pushes = gaps.iter().zip(forces).map(|(gap, force)| *gap < 0.0 && *force > 0.0);
            point.gates = pushes.map(|pushes| f64::from(u8::from(pushes))).collect();
            closed += point.gates.iter().filter(|gate| **gate > 0.5).count();
            open += point.gates.iter().filter(|gate| **gate < 0.5).count();
            for function in [Function::Forces, Function::Powers, Function::Acceleration, Function::Outputs] {
                let (found, expected) = (program(&held, function, &point), program(&live, function, &other));
                let size = expected.iter().fold(1.0_f64, |size, value| size.max(value.abs()));
                let alike = found.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= 1e-11 * size);
                assert!(alike, "{}, {}: {found:?}, live {expected:?}", name, function.name());
            }
        }
    }
    println!("{}: {closed} gates closed, {open} open", name);
    assert!(closed >= STATES / 2 && open >= STATES / 2, "{}: {closed} closed, {open} open", name);
}

/// The energy is less by what impulses say that they took: none of these mechanisms has anything else that takes energy but dry friction. Where surfaces move by
/// themselves, or by drivers, these do work.
fn impulses_take_what_they_say<M: Model>() {
    let model = M::standard();
    if !model.is_rigid() || model.sticks() {
        return;
    }
    let zero = M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let mut simulation = Simulation::new(&model, model.start()).integrator(Rk4).constant(zero).step(2e-4);
    let [mut drifts, mut none, mut shares] = [model.start().gates; 3];
    model.strikes(0.3, &model.start_q(), &model.zero_v(), &mut drifts, &mut none, &mut shares);
    // What memories say, and speeds that jump, do work too.
    let driven = !walk::<M>(30, 1).0.mechanism.drivers.is_empty() || !model.triggers().is_empty();
    let moves = driven || drifts.as_slice().iter().any(|drift| *drift != 0.0);
    let rubs = model.pressed_by().iter().any(Option::is_some);
    let begun = simulation.energy();
    let (mut impacts, mut lost) = (0, 0.0);
    while simulation.time() < 1.5 {
        let step = simulation.advance().unwrap_or_else(|error| panic!("{}: {error}", model.name()));
        assert!(step.lost >= 0.0 && step.gained >= 0.0, "{}: {step:?}", model.name());
        assert!(rubs || step.gained <= 1e-12, "{}: an impulse gave {:e} J", model.name(), step.gained);
        (impacts, lost) = (impacts + step.impacts, lost + step.lost - step.gained);
        if !moves {
            let off = simulation.energy() + lost - begun;
            // Friction takes more between touches, and gives nothing.
            let within = if rubs { off <= 1e-7 } else { off.abs() <= 1e-7 };
            assert!(within, "{} at {} s: {off:e} J", model.name(), step.time);
        }
    }
    println!("{}: {impacts} impacts took {lost} J", model.name());
    assert!(impacts > 0, "{}: nothing touches", model.name());
}

linkwright::mechanism! {
    /// Two disks and a plate far from everything.
    planar Adrift {
        disk one { mass [kg] = 1; radius [m] = 0.1; }
        disk other { mass [kg] = 2; radius [m] = 0.2; }
        body plate { mass [kg] = 3; inertia [kg*m^2] = 0.4; point a [m] = (-0.5, 0.1); point b [m] = (0.5, 0.1);
                     line top = (plate.a, plate.b); surface board: half_plane(plate.top); }
        contact meet: between(one.surface, other.surface) = rigid(restitution = 0.7);
        contact land: between(one.surface, plate.board) = rigid(restitution = 0.4);
        contact rest: between(other.surface, plate.board) = rigid(restitution = 0);
        start { one.center.x [m] = -0.6; one.center.y [m] = 0.3; one.angle [rad] = 0; one.rate [rad/s] = 3; one.center.velocity.x [m/s] = 2;
                one.center.velocity.y [m/s] = -1.5; other.center.x [m] = 0.3; other.center.y [m] = 0.45; other.angle [rad] = 0;
                other.center.velocity.y [m/s] = -1; plate.center.x [m] = 0; plate.center.y [m] = 0; plate.angle [rad] = 0; }
        output momentum_x [N*s] = 1 [kg]*one.center.velocity.x + 2 [kg]*other.center.velocity.x + 3 [kg]*plate.center.velocity.x;
        output momentum_y [N*s] = 1 [kg]*one.center.velocity.y + 2 [kg]*other.center.velocity.y + 3 [kg]*plate.center.velocity.y;
        output turning [N*m*s] = 1 [kg]*cross(one.center, one.center.velocity) + 2 [kg]*cross(other.center, other.center.velocity)
            + 3 [kg]*cross(plate.center, plate.center.velocity) + 0.005 [kg*m^2]*one.rate + 0.04 [kg*m^2]*other.rate + 0.4 [kg*m^2]*plate.rate;
    }
}

/// Impulses and forces at rest are equal and opposite along one line: momentum and its moment are kept through touches of all three.
#[test]
fn impulses_are_opposite() {
    let model = Adrift::default();
    let mut simulation = Simulation::new(&model, Adrift::START).integrator(Rk4).step(1e-3);
    let before = simulation.sample().outputs;
    let (mut impacts, mut touched, mut worst) = (0, [false; 3], 0.0_f64);
    while simulation.time() < 1.0 {
        impacts += simulation.advance().expect("they move").impacts;
        let sample = simulation.sample();
        let (gates, now) = (sample.state.gates, &sample.outputs);
        let [mut gaps, mut none] = [[0.0; 3]; 2];
        model.guards(sample.time, &sample.state, &mut gaps, &mut none);
        for (touched, (gate, gap)) in touched.iter_mut().zip(gates.iter().zip(gaps)) {
            *touched |= *gate > 0.0 || gap < 2e-3;
        }
        let [x, y] = [now.momentum_x - before.momentum_x, now.momentum_y - before.momentum_y];
        worst = worst.max(x.abs()).max(y.abs()).max((now.turning - before.turning).abs());
    }
    println!("{impacts} impacts, momentum off by {worst:.1e}, touched {touched:?}");
    assert!(impacts >= 3 && touched == [true; 3], "{impacts} impacts, {touched:?}");
    assert!(worst < 1e-11, "momentum off by {worst:e}");
}
