//! Operation counts and live values cannot creep up: every function of every shipped model, in both sets of coordinates, against the
//! table `tests/data/operation_ceilings.csv`.
//!
//! A change that lowers counts, or a new model, writes the table anew with WRITE_CEILINGS=1; a line that grows is a
//! decision for whoever reads the difference.

use crate::reference::{SETS, compiled, models};
use linkwright_compiler::schedule::{count, live_values};
use std::collections::BTreeMap;
use std::fmt::Write;

const HEADER: &str = "model,coordinates,function,operations,depth,live_values";

fn path() -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/operation_ceilings.csv")
}

#[test]
fn no_function_has_grown() {
    let mut counted = BTreeMap::new();
    for (name, source, _) in models() {
        for (coordinates, set) in SETS {
            for (function, program) in &compiled(source, coordinates).programs.functions {
                let counts = count(program);
                if counts.total() > 0 {
                    counted.insert(
                        (name, set, function.name()),
                        (counts.total(), counts.depth, live_values(program)),
                    );
                }
            }
        }
    }
    if std::env::var_os("WRITE_CEILINGS").is_some() {
        let mut text = format!("{HEADER}\n");
        for ((name, set, function), (operations, depth, live)) in &counted {
            let _ = writeln!(text, "{name},{set},{function},{operations},{depth},{live}");
        }
        std::fs::write(path(), text).unwrap();
    }

    let text = std::fs::read_to_string(path()).unwrap();
    let mut ceilings = BTreeMap::new();
    for line in text.lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |at: usize| fields[at].parse::<usize>().unwrap();
        ceilings.insert((fields[0], fields[1], fields[2]), (number(3), number(5)));
    }
    let mut grown = Vec::new();
    for (key, (operations, _, live)) in &counted {
        let Some((most_operations, most_live)) = ceilings.get(key) else {
            grown.push(format!("{key:?}: {operations} operations, and no ceiling"));
            continue;
        };
        if operations > most_operations {
            grown.push(format!("{key:?}: {operations} operations, at most {most_operations} before"));
        }
        if live > most_live {
            grown.push(format!("{key:?}: {live} live values, at most {most_live} before"));
        }
    }
    assert!(grown.is_empty(), "{}\n(WRITE_CEILINGS=1 writes the table anew)", grown.join("\n"));
    assert!(counted.len() > 100, "only {} functions were counted", counted.len());
}

/// What the project promises of two models, whatever the table says.
#[test]
fn promised_counts_hold() {
    let promised = [("four_bar", 80), ("n_four_bar_40", 3300)];
    for (model, most) in promised {
        let (_, source, _) = models().into_iter().find(|(name, ..)| *name == model).unwrap();
        let compiled = compiled(source, SETS[1].0);
        let counts = count(compiled.programs.get(compiled.default_solution()));
        assert!(counts.total() <= most, "{model}: {} operations", counts.total());
    }
}
