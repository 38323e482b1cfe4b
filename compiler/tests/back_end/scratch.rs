use crate::shipped::definitions;
use linkwright_compiler::compile;
use linkwright_compiler::self_check::{Extent, self_check};
use std::time::Instant;
#[test]
fn timing() {
    for (file, tokens) in definitions() {
        if !["four_bar", "stewart_platform", "panda"].contains(&file.as_str()) { continue }
        let compiled = compile(tokens.clone(), None).unwrap();
        let least = |f: &dyn Fn()| (0..20).map(|_| { let s = Instant::now(); f(); s.elapsed().as_secs_f64() * 1e3 }).fold(f64::MAX, f64::min);
        let c = least(&|| { let mut c = compiled.mechanism.clone(); c.options.self_check = Some(false); linkwright_compiler::compile_model(c, String::new(), None).unwrap(); });
        println!("{file}: compile {c:.2} passing {:.2} thorough {:.2} ms; graph {}", least(&|| { self_check(&compiled, Extent::Passing); }), least(&|| { self_check(&compiled, Extent::Thorough); }), compiled.equations.graph.len());
    }
}
