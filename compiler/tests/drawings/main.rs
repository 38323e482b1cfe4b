//! Drawings of all models: names cover neither one another nor anything that is drawn, and all of them have a place.
//!
//! What is measured is read from the SVG alone: boxes of texts with the widths of the letters of DejaVu Sans, a wide font, and
//! lines with their widths. `DRAWINGS=folder cargo test -p linkwright-compiler --test drawings` writes the drawings too.

mod measure;

use linkwright_compiler::model::Space;
use linkwright_compiler::page::{Figure, Pose, drawing_at};
use linkwright_compiler::source::{Source, invocations};
use linkwright_compiler::{Compiled, compile};
use std::fs;
use std::path::{Path, PathBuf};

/// More names than a page has room for, and how many of them are left to the tables.
const CROWDED: [(&str, usize); 1] = [("NFourBar40", 140)];

/// Every definition in the folder of models.
fn models() -> Vec<Compiled> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/src");
    let entries = fs::read_dir(folder).expect("the folder of models");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("it is listed").path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    files.sort();
    let mut found = Vec::new();
    for file in files {
        let source = Source::new(file.display().to_string(), fs::read_to_string(&file).expect("text"));
        for invocation in invocations(&source).expect("it is read") {
            // One that names a file is none of its own.
            if let Ok(compiled) = compile(invocation.tokens.stream, None) {
                found.push(compiled);
            }
        }
    }
    assert!(found.len() > 60, "{} models", found.len());
    found
}

#[test]
fn names_cover_nothing() {
    let folder = std::env::var_os("DRAWINGS").map(PathBuf::from);
    let mut wrong = Vec::new();
    for compiled in models() {
        let name = &compiled.mechanism.name.text;
        let Figure { svg, left_out } = drawing_at(&compiled, &Pose::start(&compiled));
        if let Some(folder) = &folder {
            fs::create_dir_all(folder).expect("it can be made");
            fs::write(folder.join(format!("{name}.svg")), &svg).expect("it can be written");
        }
        let allowed = CROWDED.iter().find(|(crowded, _)| crowded == name).map_or(0, |(_, count)| *count);
        if left_out > allowed {
            wrong.push(format!("{name}: {left_out} names found no place"));
        }
        wrong.extend(measure::overlaps(&svg).into_iter().map(|what| format!("{name}: {what}")));
    }
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
}

/// What measures finds a name on a name, on a line, on a circle, and outside.
#[test]
fn overlaps_are_found() {
    let sheet = |inside: &str| {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200\" height=\"100\" font-size=\"12\">{inside}</svg>"
        )
    };
    let name = |x: f64, y: f64| format!("<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\">crank</text>");
    let stroke = "fill=\"none\" stroke=\"currentColor\" stroke-width=\"1\"";
    let line = |y: f64| format!("<path d=\"M0 {y}L200 {y}\" {stroke}/>");
    let circle = |r: f64| format!("<circle cx=\"100\" cy=\"50\" r=\"{r}\" {stroke}/>");
    for (inside, faults) in [
        (name(100.0, 50.0), 0),
        (name(100.0, 50.0) + &name(120.0, 52.0), 1),
        (name(100.0, 50.0) + &name(100.0, 70.0), 0),
        (name(100.0, 50.0) + &line(48.0), 1),
        (name(100.0, 50.0) + &line(60.0), 0),
        (name(100.0, 53.0) + &circle(6.0), 1),
        (name(100.0, 53.0) + &circle(40.0), 0),
        (name(5.0, 50.0), 1),
    ] {
        assert_eq!(measure::overlaps(&sheet(&inside)).len(), faults, "{inside}");
    }
}

/// Springs between the same places stand side by side, and a hinge in the spot of another is moved along its axis.
#[test]
fn what_coincides_is_drawn_apart() {
    let source = "spatial Strut {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); point end [m] = (1, 0, 0); }
        body hand { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); point end [m] = (0.5, 0, 0); }
        joint turn: revolute(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1));
        joint lift: revolute(arm.origin, hand.origin, axis = (0, 1, 0));
        spring coil: spring(ground(0, 0, 1) [m], hand.end, stiffness [N/m] = 100, length [m] = 1);
        force damper: damper(ground(0, 0, 1) [m], hand.end, damping [N*s/m] = 10);
    }";
    let compiled = compile(source.parse().expect("tokens"), None).unwrap_or_else(|errors| panic!("{errors}"));
    assert_eq!(compiled.mechanism.space, Space::Spatial);
    let svg = drawing_at(&compiled, &Pose::start(&compiled)).svg;
    let far = |one: &str, other: &str| measure::distance(&svg, one, other);
    assert!(far("turn", "lift") > 6.0, "{}", far("turn", "lift"));
    assert!(far("coil", "damper") > 6.0, "{}", far("coil", "damper"));
}
