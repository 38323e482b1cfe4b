//! Reads a definition from standard input, moves it for a second, and writes its outputs then, in SI units.
//! `cargo run -p linkwright-engine --example motion < docs/mechanisms/crank_rocker.mech`; it runs as WebAssembly too (`.ci/wasm`).

use linkwright_engine::Engine;
use linkwright_runtime::{AssembleExt, Baumgarte, Mechanism, Simulation};
use std::io::Read;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut definition = String::new();
    std::io::stdin().read_to_string(&mut definition)?;
    let engine = Engine::read(&definition)?;
    let inputs = engine.no_inputs();
    let mut simulation = Simulation::new(&engine, engine.start())
        .formulation(Baumgarte { alpha: 10.0, beta: 10.0 })
        .constant(inputs.clone())
        .step(1e-3);
    simulation.advance_until(1.0)?;
    let outputs = engine.outputs(simulation.time(), simulation.state(), &inputs);
    for (name, value) in engine.output_names().iter().zip(outputs.as_slice()) {
        println!("{name} {value:?}");
    }
    Ok(())
}
