//! A mechanism that a program builds: the text that stands for it, and what its accelerations take.
//!
//! ```text
//! cargo run -p linkwright-compiler --example build_four_bar
//! ```

use linkwright_compiler::builder::{Builder, Call, Value, ground};
use linkwright_compiler::functions::Function;
use linkwright_compiler::schedule::count;

fn main() {
    let mut four_bar = Builder::planar("FourBar");
    four_bar.gravity(&[0.0, -9.81]);
    for name in ["crank", "coupler", "rocker"] {
        four_bar.body("rod", name).value("mass", 1.0, "kg").value("length", 1.0, "m");
    }
    let joints = [
        ("crank_pin", ground(&[0.0, 0.0]), "crank.start"),
        ("rocker_pin", ground(&[1.0, 0.0]), "rocker.start"),
        ("left", "crank.end".into(), "coupler.start"),
        ("right", "coupler.end".into(), "rocker.end"),
    ];
    for (name, first, second) in joints {
        four_bar.joint(name, Call::new("revolute").on(first).on(second));
    }
    four_bar.start("crank_pin.angle", Value::quantity(90.0, "deg"));
    four_bar.start("crank_pin.rate", Value::quantity(-1.0, "rad/s"));
    four_bar.guess("rocker_pin.angle", Value::quantity(90.0, "deg"));
    four_bar.guess("coupler.angle", Value::quantity(0.0, "rad"));
    four_bar.expect_degrees_of_freedom(1);
    four_bar.output("angle", "rad", "rocker_pin.angle");

    print!("{}", four_bar.text());
    match four_bar.compile(None) {
        Ok(compiled) => {
            let operations = count(compiled.programs.get(Function::AccelerationBaumgarte)).total();
            println!("{}", compiled.choice.explanation());
            println!("operations of the accelerations: {operations}");
            four_bar.warnings(&compiled).iter().for_each(|warning| println!("warning: {warning}"));
        }
        Err(faults) => {
            faults.iter().for_each(|fault| eprintln!("error: {fault}"));
            std::process::exit(1);
        }
    }
}
