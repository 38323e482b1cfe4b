use crate::*;
fn hash(definition: &str) -> String {
    let hash = definition.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    format!("{hash:016x}")
}
#[test]
fn scratch() {
    for file in [
        "general_four_bar",
        "slider_crank",
        "quick_return",
        "jansen_leg",
        "klann_leg",
        "change_point_four_bar",
    ] {
        let text = std::fs::read_to_string(format!("{}/../models/src/{file}.rs", env!("CARGO_MANIFEST_DIR")))
            .unwrap();
        for (i, _) in text.match_indices("mechanism! {") {
            let at = i + "mechanism! {".len();
            let mut depth = 1;
            let mut end = at;
            for (i, c) in text[at..].char_indices() {
                match c {
                    '{' => depth += 1,
                    '}' => {
                        depth -= 1;
                        if depth == 0 {
                            end = at + i;
                            break;
                        }
                    }
                    _ => {}
                }
            }
            let tokens = TokenStream::from_str(&text[at..end]).unwrap();
            match compile(tokens, None) {
                Err(e) => println!("DBG {file} {e}"),
                Ok(c) => {
                    let mut best = 1e9_f64;
                    let mut steps = 0;
                    let mut e = c.equations.clone();
                    e.graph = c.equations.graph.clone();
                    for _ in 0..5 {
                        let t = std::time::Instant::now();
                        let m = c.motion().unwrap();
                        steps = m.steps;
                        best = best.min(t.elapsed().as_secs_f64());
                    }
                    println!(
                        "DBG {file} {} {} all joints {:.2} ms, {steps} steps",
                        c.mechanism.name.text,
                        hash(&c.definition),
                        best * 1e3
                    )
                }
            }
        }
    }
}
