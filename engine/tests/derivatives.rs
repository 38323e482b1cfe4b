//! Derivatives of equations that are interpreted, and engines on other threads.

use linkwright_engine::{Derivatives, Engine, List, Made};
use linkwright_runtime::{AssembleExt, Mechanism, Simulation, StateOf, Tangent, Variables, Vector};

/// Derivatives of the equations, of a mechanism that has them.
#[test]
fn derivatives() {
    let definition = linkwright_models::four_bar::FourBar::SOURCE;
    let engine = Engine::<Derivatives>::read_with_derivatives(definition).expect("it is well");
    let start = engine.start();
    let u = engine.no_inputs();
    let (mut stiffness, mut damping) = (engine.zero_stiffness(), engine.zero_damping());
    let (a, lambda) = (engine.zero_v(), engine.zero_lambda());
    engine.tangent(0.0, &start, &u, &a, &lambda, &mut stiffness, &mut damping);
    // Against differences of the residual.
    let residual = |state: &StateOf<Engine<Derivatives>>| {
        let mut residual = engine.zero_v();
        engine.residual(0.0, state, &u, &a, &lambda, &mut residual);
        residual
    };
    let h = 1e-6;
    for column in 0..engine.velocity_count() {
        let moved = |by: f64| {
            let mut increment = engine.zero_v();
            increment.as_mut_slice()[column] = by;
            residual(&start.moved(engine.layout(), &increment, start.v.clone(), start.z.clone()))
        };
        let difference = moved(h).plus(-1.0, &moved(-h)).scaled(0.5 / h);
        for row in 0..engine.velocity_count() {
            let place = (row as u16, column as u16);
            let at = engine.stiffness_pattern().iter().position(|known| *known == place);
            let exact = at.map_or(0.0, |at| stiffness.as_slice()[at]);
            assert!((difference.as_slice()[row] - exact).abs() < 1e-6, "{place:?}: {exact}");
        }
    }
    // A definition that is compiled without them has none.
    let plain = linkwright_compiler::compile(definition.parse().expect("tokens"), None).expect("it is well");
    assert!(!Engine::<Derivatives>::admits(&plain) && Engine::<Derivatives>::of(&plain).is_err());
}

/// Engines move to other threads, and give the same there.
#[test]
fn clones_on_threads() {
    let engine = Engine::read(linkwright_models::four_bar::FourBar::SOURCE).expect("it is well");
    let moved = |engine: &Engine| {
        let mut simulation = Simulation::new(engine, engine.start()).constant(engine.no_inputs()).step(1e-3);
        simulation.advance_steps(100).expect("it moves");
        List::of(simulation.state().q.as_slice())
    };
    let here = moved(&engine);
    let threads: Vec<_> = (0..3)
        .map(|_| {
            let engine = engine.clone();
            std::thread::spawn(move || moved(&engine))
        })
        .collect();
    for thread in threads {
        assert_eq!(thread.join().expect("it ends"), here);
    }
}
