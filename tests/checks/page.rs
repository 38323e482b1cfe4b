//! The page of every mechanism: its drawings are well-formed and finite, it names every body and joint, its tables are complete,
//! and nothing of it becomes a link or a test. Two pages, one of the plane and one of space, are golden files:
//! `UPDATE_GOLDEN=1 cargo test --test checks page` writes them anew.

use crate::golden::{compare_file, compare_text};
use crate::registry::{Model, compiled};
use linkwright_compiler::{Compiled, page};

crate::registry::for_each!(is_whole);

fn is_whole<M: Model>() {
    let compiled = compiled::<M>(None);
    let page = page(&compiled);
    assert_eq!(page, linkwright_compiler::page(&compiled), "the same page twice");
    let drawings = drawings(&page);
    drawings.iter().for_each(|svg| is_drawn(svg));
    everything_is_drawn(drawings[0], &compiled);
    let text = outside_of_drawings(&page);
    everything_is_named(&text, &compiled);
    tables_are_complete(&text);
    nothing_is_a_link_or_a_test(&text);
}

#[test]
fn of_the_plane() {
    compare_text("four_bar.md", &page(&compiled::<linkwright_models::four_bar::FourBar>(None)));
}

#[test]
fn of_space() {
    let compiled = compiled::<linkwright_models::spatial_slider_crank::SpatialSliderCrankArm>(None);
    compare_text("spatial_slider_crank_arm.md", &page(&compiled));
}

/// Uses of parts with what they bring.
#[test]
fn parts_are_groups() {
    let page = page(&compiled::<linkwright_models::tracked_vehicle::TrackedVehicle>(None));
    let row = "| `station[2]` | `Station` | `arm`, `wheel` | `swing`, `hub` | `bar`, `damper` |";
    assert!(page.contains("# Parts") && page.contains(row), "{page}");
    assert!(page.contains("# Signals") && page.contains("| `lift[5]` | `m` |"), "{page}");
}

/// The picture of README.md, on paper of its own, because it stands alone.
#[test]
fn of_the_front_page() {
    let page = page(&compiled::<linkwright_models::quick_return::QuickReturn>(None));
    let alone = linkwright_compiler::page::alone(drawings(&page)[0]);
    is_drawn(&alone);
    assert!(!alone.contains("var("), "what shows no style sheets shows it too");
    compare_file("docs/quick_return.svg", &(alone + "\n"));
}

/// Expressions read as in a textbook: angles under their cosines, of sums and differences too, and no 2π · turns.
#[test]
fn equations_can_be_read() {
    let page = page(&compiled::<linkwright_models::four_bar::FourBar>(None));
    for line in [
        "right.x: cos(crank) − cos(rocker) + cos(coupler) − 1 = 0",
        "coupler.rate, crank.rate =   0.5·cos(crank − coupler)",
        "coupler.rate = 0.5·sin(crank − coupler)·crank.rate² − 4.905·cos(coupler)",
    ] {
        assert!(page.contains(line), "{line}\n{page}");
    }
    let page = linkwright_compiler::page(&compiled::<crate::zoo_tangent::Gripper>(None));
    assert!(page.contains("stiffness·(a.angle − 0.698132)"), "{page}");
}

/// A part that nothing holds, and parts whose places are all one, have a picture too.
#[test]
fn little_is_enough_for_a_drawing() {
    for source in [
        "planar A { particle p { mass [kg] = 1; } }",
        "planar A { body p { mass [kg] = 1; inertia [kg*m^2] = 1; } joint a: revolute(ground(0, 0) [m], p.center); }",
        "spatial A { sphere p { mass [kg] = 1; radius [m] = 1; } }",
        "planar A { param r [m] = 1e-9; body p { mass [kg] = 1; inertia [kg*m^2] = 1; center [m] = (r, 0); }
                    joint a: revolute(ground(1e6, 0) [m], p.origin); }",
    ] {
        let compiled = linkwright_compiler::compile(source.parse().unwrap(), None).expect(source);
        let page = page(&compiled);
        drawings(&page).into_iter().for_each(is_drawn);
        everything_is_drawn(drawings(&page)[0], &compiled);
    }
}

fn drawings(page: &str) -> Vec<&str> {
    let after = page.split("<svg").skip(1);
    let found: Vec<&str> = after
        .map(|rest| {
            let end = rest.find("</svg>").expect("a drawing ends") + "</svg>".len();
            let start = rest.as_ptr() as usize - page.as_ptr() as usize - "<svg".len();
            &page[start..start + "<svg".len() + end]
        })
        .collect();
    assert!(!found.is_empty(), "there is a drawing");
    found
}

/// Well-formed, without blank lines, with finite coordinates within its frame.
fn is_drawn(svg: &str) {
    assert!(svg.lines().all(|line| !line.trim().is_empty()), "a blank line ends a block of HTML\n{svg}");
    let document = roxmltree::Document::parse(svg).unwrap_or_else(|error| panic!("{error}\n{svg}"));
    let root = document.root_element();
    let size = |name: &str| -> f64 { root.attribute(name).and_then(|it| it.parse().ok()).expect(name) };
    let (width, height) = (size("width"), size("height"));
    assert!((10.0..2000.0).contains(&width) && (10.0..2000.0).contains(&height), "{width} × {height}");
    assert!(root.children().any(|child| child.has_tag_name("title")), "it says what it is");
    assert!(
        document.descendants().filter(|node| node.has_tag_name("path")).count() > 0,
        "something is drawn"
    );
    for node in document.descendants() {
        for attribute in node.attributes() {
            let numbers = match attribute.name() {
                "d" => attribute.value().split(|c: char| c.is_alphabetic() || c == ' ').collect(),
                "cx" | "cy" | "r" | "x" | "y" => vec![attribute.value()],
                _ => continue,
            };
            for number in numbers.into_iter().filter(|number| !number.is_empty()) {
                let value: f64 = number.parse().unwrap_or_else(|_| panic!("{number} in {attribute:?}"));
                assert!(value.is_finite() && value.abs() < 4000.0, "{number} in {attribute:?}");
            }
        }
    }
}

/// Every body and every joint has its group, found by its title.
fn everything_is_drawn(svg: &str, compiled: &Compiled) {
    let document = roxmltree::Document::parse(svg).expect("it was parsed before");
    let titles: Vec<&str> = document
        .descendants()
        .filter(|node| node.has_tag_name("title"))
        .filter_map(|node| node.text())
        .collect();
    let mechanism = &compiled.mechanism;
    let bodies = mechanism.bodies.iter().map(|body| &body.name.text);
    for name in bodies.chain(mechanism.joints.iter().map(|joint| &joint.name.text)) {
        assert!(titles.contains(&name.as_str()), "{name} is drawn");
    }
}

fn outside_of_drawings(page: &str) -> String {
    drawings(page).into_iter().fold(page.to_string(), |text, svg| text.replace(svg, ""))
}

/// Each body, joint, parameter, input, output, velocity and constraint row has a row in the table of its kind.
fn everything_is_named(text: &str, compiled: &Compiled) {
    let (mechanism, equations) = (&compiled.mechanism, &compiled.complete.equations);
    let has = |heading: &str, count: usize, names: Vec<&str>| {
        let section = text.split(&format!("\n# {heading}\n")).nth(1);
        let Some(section) = section else {
            assert_eq!(count, 0, "a table of {heading}");
            return;
        };
        let section = section.split("\n# ").next().unwrap_or_default();
        let rows = section.lines().filter(|line| line.starts_with("| ")).count() - 2;
        assert_eq!(rows, count, "{heading}\n{section}");
        for name in names {
            assert!(section.contains(&format!("| `{name}` |")), "{name} among the {heading}");
        }
    };
    let of = |names: &mut dyn Iterator<Item = &'_ linkwright_compiler::model::Name>| -> Vec<String> {
        names.map(|name| name.text.clone()).collect()
    };
    let tables = [
        ("Bodies", of(&mut mechanism.bodies.iter().map(|it| &it.name))),
        ("Joints", of(&mut mechanism.joints.iter().map(|it| &it.name))),
        ("Loads", of(&mut mechanism.loads.iter().map(|it| &it.name))),
        ("Parameters", of(&mut mechanism.parameters.iter().map(|it| &it.name))),
        ("Inputs", of(&mut mechanism.inputs.iter().map(|it| &it.name))),
        ("Outputs", of(&mut mechanism.outputs.iter().map(|it| &it.name))),
    ];
    for (heading, names) in &tables {
        has(heading, names.len(), names.iter().map(String::as_str).collect());
    }
    let couplings = mechanism.constraints.len() + mechanism.drivers.len();
    has("Couplings and drivers", couplings, Vec::new());
    let velocities = equations.layout.velocity_names(mechanism);
    let counted = equations.layout.angles.len();
    has("Coordinates", velocities.len() + counted, velocities.iter().map(String::as_str).collect());
    has("Constraint rows", equations.rows.len(), Vec::new());
    has("Redundant rows", compiled.assembly.dropped.len(), Vec::new());
}

/// Every row of a table has as many cells as its heading.
fn tables_are_complete(text: &str) {
    let mut columns = None;
    for line in text.lines() {
        let cells = line.matches('|').count();
        match columns {
            _ if !line.starts_with('|') => columns = None,
            None => columns = Some(cells),
            Some(columns) => assert_eq!(cells, columns, "{line}"),
        }
    }
}

/// Brackets stand in code or in fenced text, fences say that they are text, and no line is indented as code.
fn nothing_is_a_link_or_a_test(text: &str) {
    let mut is_fenced = false;
    for line in text.lines() {
        if let Some(language) = line.strip_prefix("```") {
            assert_eq!(language, if is_fenced { "" } else { "text" }, "{line}");
            is_fenced = !is_fenced;
        } else if !is_fenced {
            assert!(!line.starts_with("    ") && !line.starts_with('\t'), "{line}");
            let outside: String = line.split('`').step_by(2).collect();
            assert_eq!(line.matches('`').count() % 2, 0, "{line}");
            assert!(!outside.contains(['[', ']', '*', '_']), "{line}");
        }
    }
    assert!(!is_fenced, "every fence is closed");
}

/// Each pair is drawn close up, with a line of action that touches both base circles, and its stiffness and pairs over a pitch as curves.
#[test]
fn teeth_are_drawn() {
    let page = page(&compiled::<linkwright_models::planetary_stage::PlanetaryStage>(None));
    for line in [
        "# Teeth that give",
        "# Stiffness of teeth",
        "Hz by itself",
        "of a pitch |",
        "Broken lines are the series",
    ] {
        assert!(page.contains(line), "{line}");
    }
    let drawings = drawings(&page);
    let titled = |title: &str| -> &str {
        let found: Vec<&&str> =
            drawings.iter().filter(|svg| svg.contains(&format!("<title>{title}"))).collect();
        assert_eq!(found.len(), 1, "{title}");
        found[0]
    };
    for mesh in ["inner", "outer"] {
        titled(&format!("{mesh}, stiffness"));
        titled(&format!("{mesh}, pairs that touch"));
        let close_up = titled(&format!("{mesh}: teeth of"));
        let value = |element: &str, name: &str| -> f64 {
            let text = element.split(&format!(" {name}=\"")).nth(1).and_then(|rest| rest.split('"').next());
            text.and_then(|text| text.parse().ok()).unwrap_or_else(|| panic!("{name} of {element}"))
        };
        let of = |mark: &str, start: &str| -> Vec<&str> {
            close_up.lines().filter(|line| line.starts_with(start) && line.contains(mark)).collect()
        };
        let bases = of("stroke-dasharray=\"1 3\"", "<circle");
        assert_eq!((bases.len(), of("stroke-dasharray=\"9 3 2 3\"", "<circle").len()), (2, 2), "{close_up}");
        let [line] = of("stroke-width=\"0.8\"", "<path")[..] else { panic!("{close_up}") };
        let places = line.split(" d=\"M").nth(1).and_then(|rest| rest.split('"').next()).expect("a path");
        let numbers: Vec<f64> =
            places.split([' ', 'L']).map(|part| part.parse().expect("a number")).collect();
        let [x1, y1, x2, y2] = numbers[..] else { panic!("{places}") };
        let (along, across) = (x2 - x1, y2 - y1);
        for base in bases {
            let (x, y) = (value(base, "cx") - x1, value(base, "cy") - y1);
            let distance = (along * y - across * x).abs() / along.hypot(across);
            assert!(
                (distance / value(base, "r") - 1.0).abs() < 2e-3,
                "{mesh}: {distance} in place of {base}"
            );
        }
    }
}
