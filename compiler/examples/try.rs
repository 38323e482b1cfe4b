use linkwright_compiler::model::Coordinates;
use linkwright_compiler::schedule::{Function, count};
fn main() {
    let path = std::env::args().nth(1).unwrap();
    let coords = match std::env::args().nth(2).as_deref() { Some("absolute") => Some(Coordinates::Absolute), Some("tree") => Some(Coordinates::Tree), _ => None };
    let text = std::fs::read_to_string(path).unwrap();
    let start = std::time::Instant::now();
    match linkwright_compiler::compile(text.parse().unwrap(), coords) {
        Err(e) => { println!("{e}"); std::process::exit(1) }
        Ok(c) => {
            println!("{} n={} rows={} dof={} in {:?}", c.choice.explanation(), c.equations.symbols.v.len(), c.equations.rows.len(), c.assembly.degrees_of_freedom, start.elapsed());
            for f in Function::ALL { let k = count(c.programs.get(f)); if k.total()>0 { println!("  {:24} {}", f.name(), k.total()); } }
            println!("q {:?}\nv {:?}", c.assembly.q, c.assembly.v);
            println!("dropped {:?} shared {:?}", c.assembly.dropped, c.assembly.shared);
        }
    }
}
