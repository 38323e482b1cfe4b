//! Drawings of all models: names cover neither one another nor anything that is drawn, and all of them have a place.
//!
//! What is measured is read from the SVG alone: boxes of texts with the widths of the letters of DejaVu Sans, a wide font, and
//! lines with their widths. `DRAWINGS=folder cargo test -p linkwright-compiler --test drawings` writes the drawings too.

mod measure;
mod surfaces;

use linkwright_compiler::model::Space;
use linkwright_compiler::page::{Figure, Pose, dimensioned_at, drawing_at, scene};
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
fn names_and_dimensions_cover_nothing() {
    let folder = std::env::var_os("DRAWINGS").map(PathBuf::from);
    let (mut wrong, mut counts) = (Vec::new(), [0, 0]);
    for compiled in models() {
        let name = &compiled.mechanism.name.text;
        let pose = Pose::start(&compiled);
        let (plain, dimensioned) = (drawing_at(&compiled, &pose), dimensioned_at(&compiled, &pose));
        if let Some(folder) = &folder {
            keep(folder, name, &plain.svg);
            keep(folder, &format!("{name}-dimensions"), &dimensioned.svg);
        }
        let allowed = CROWDED.iter().find(|(crowded, _)| crowded == name).map_or(0, |(_, count)| *count);
        if plain.left_out > allowed {
            wrong.push(format!("{name}: {} names found no place", plain.left_out));
        }
        wrong.extend(measure::overlaps(&plain.svg).into_iter().map(|what| format!("{name}: {what}")));
        if dimensioned.left_out > plain.left_out {
            let more = dimensioned.left_out - plain.left_out;
            wrong.push(format!("{name}: {more} more names found no place beside dimensions"));
        }
        let [all, left] = dimensions_cover_nothing(&compiled, &dimensioned, &mut wrong);
        counts = [counts[0] + all, counts[1] + left];
    }
    println!("{} dimensions, {} of them below their pictures", counts[0], counts[1]);
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
}

fn keep(folder: &Path, name: &str, svg: &str) {
    fs::create_dir_all(folder).expect("it can be made");
    fs::write(folder.join(format!("{name}.svg")), svg).expect("it can be written");
}

/// Dimensions cover neither names nor parts nor one another, and what finds no place is said in the picture; gives how many there are
/// and how many of them find none.
fn dimensions_cover_nothing(compiled: &Compiled, figure: &Figure, wrong: &mut Vec<String>) -> [usize; 2] {
    let name = &compiled.mechanism.name.text;
    let Figure { svg, dimensions, without_place, .. } = figure;
    let told: String = svg.split("without a place: ").skip(1).collect();
    for which in without_place.iter().filter(|which| !told.contains(which.as_str())) {
        wrong.push(format!("{name}: {which} is missing, and the picture does not say so"));
    }
    let seen = svg.matches("<title>dimension ").count();
    if seen + without_place.len() != *dimensions {
        wrong.push(format!("{name}: {seen} of {dimensions} dimensions, {} are left", without_place.len()));
    }
    let faults = measure::overlaps(svg).into_iter().chain(measure::crossings(svg, "dimension "));
    wrong.extend(faults.map(|what| format!("{name} with dimensions: {what}")));
    [*dimensions, without_place.len()]
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
    let group = |title: &str, y: f64| format!("<g><title>{title}</title>{}</g>", line(y));
    for (y, faults) in [(50.0, 1), (50.8, 1), (60.0, 0)] {
        let crossing = group("dimension 1 m of crank", 50.0) + &group("crank", y);
        assert_eq!(measure::crossings(&sheet(&crossing), "dimension ").len(), faults, "{y}");
    }
}

/// Names and values are those of what was written, in its units; of what is not written there is the value.
#[test]
fn dimensions_are_what_was_written() {
    let source = "planar Crane {
        param reach [mm] = 400 in 100..900; param stand [cm] = 50 in 10..90;
        rod crank { mass [kg] = 1; length [mm] = reach; }
        rod coupler { mass [kg] = 1; length [cm] = 60; }
        body rocker { mass [kg] = 1; inertia [kg*m^2] = 1; point knee [m] = (0.3, 0); point top [m] = (0.3, 0.4); }
        joint a: revolute(ground(0, 0) [m], crank.start);
        joint b: revolute(crank.end, coupler.start);
        joint c: revolute(coupler.end, rocker.knee);
        joint d: revolute(ground(stand, 0) [m], rocker.origin);
        spring coil: spring(ground(1, 1) [m], rocker.top, stiffness [N/m] = 1, length [m] = 1);
        start { a.angle [deg] = 80; d.angle [deg] ~ 70; }
    }";
    let compiled = compile(source.parse().expect("tokens"), None).unwrap_or_else(|errors| panic!("{errors}"));
    let mut pose = Pose::start(&compiled);
    let titles = |svg: &str| -> Vec<String> {
        let titles = svg.split("<title>dimension ").skip(1);
        titles.map(|rest| rest.split('<').next().unwrap_or_default().to_string()).collect()
    };
    let figure = dimensioned_at(&compiled, &pose);
    let expected =
        ["reach = 400 mm of crank", "60 cm of coupler", "0.3 m of rocker", "stand = 50 cm of ground"];
    assert_eq!((titles(&figure.svg), figure.without_place), (expected.map(String::from).to_vec(), vec![]));
    assert_eq!((figure.dimensions, measure::overlaps(&figure.svg)), (4, vec![]));
    pose.parameters[0] = 0.45;
    assert_eq!(titles(&dimensioned_at(&compiled, &pose).svg)[0], "reach = 450 mm of crank");
    assert!(titles(&drawing_at(&compiled, &pose).svg).is_empty(), "only where they are asked for");
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

const BENT: &str = "planar Bent {
    beam rod { length [mm] = 300; section = circle(diameter [mm] = 6); young [GPa] = 210; density [kg/m^3] = 7800;
               modes = (axial = 1, bending = 3); point third [mm] = (-50, 0); }
    joint left: revolute(ground(0, 0) [m], rod.start);
    joint right: point_on_line(line(ground(0, 0) [m], ground(1, 0.2) [m]), rod.end);
    spring stay: spring(ground(0.1, 0.2) [m], rod.third, stiffness [N/m] = 100, length [m] = 0.2);
    start { rod.angle [rad] ~ 0.2; rod.bending[0] [mm] = FIRST; }
}";

/// A beam is a curve with as much of a deflection as is seen, which is said; what hangs on it hangs on the curve, and joints stay.
#[test]
fn beams_are_bent() {
    let drawn = |first: &str| {
        let source = BENT.replace("FIRST", first);
        let compiled =
            compile(source.parse().expect("tokens"), None).unwrap_or_else(|errors| panic!("{errors}"));
        let Figure { svg, left_out, .. } = drawing_at(&compiled, &Pose::start(&compiled));
        assert_eq!((left_out, measure::overlaps(&svg)), (0, vec![]), "{first}");
        (svg, compiled)
    };
    let corners = |svg: &str| {
        let path = svg.split("<title>rod</title><path d=\"").nth(1).expect("the rod is drawn");
        path.split('"').next().unwrap_or_default().matches('L').count()
    };
    for (first, times, at_least) in [("0", None, 1), ("0.5", Some(10), 40), ("1", Some(5), 40)] {
        let (svg, compiled) = drawn(first);
        assert!(corners(&svg) >= at_least, "{first}");
        assert_eq!(svg.contains("<title>frame of rod</title>"), times.is_some());
        assert_eq!(svg.contains("deflections × "), times.is_some());
        let said = times.map(|times| svg.contains(&format!("deflections × {times}<")));
        assert_ne!(said, Some(false), "{first}: {svg}");
        // It begins in the hinge.
        let after = |mark: &str, end: &[char]| {
            let text = svg.split(mark).nth(1).unwrap_or_else(|| panic!("{mark} in {svg}"));
            text.split(end).next().unwrap_or_default().to_string()
        };
        let begin = after("<title>rod</title><path d=\"M", &['L']);
        let hinge = &svg[svg.rfind("<title>left</title>").expect("it is drawn")..];
        let [x, y] = begin.split_once(' ').map(|(x, y)| [x, y]).expect("two numbers");
        assert!(hinge.contains(&format!("cx=\"{x}\" cy=\"{y}\"")), "{first}: {begin}");
        // What moves is the same curve, from the modes alone.
        let pose = Pose::start(&compiled);
        let scene = scene::scene(&compiled, &pose, std::iter::once(pose.q.as_slice()), std::iter::empty());
        assert_eq!(scene.times, f64::from(times.unwrap_or(1)));
        let modes: Vec<f64> = scene.modes.iter().map(|index| pose.q[*index]).collect();
        let axis = scene.bodies[0].lines.as_ref().expect("it bends");
        let [x, y] = [axis.place(axis.counts[0] - 1, &modes), axis.place(0, &modes)].map(|at| at[1]);
        // The first shape is 2 at both ends, which joints hold.
        let held = 2e-3 * first.parse::<f64>().expect("a number");
        assert!((x - held).abs() < 1e-12 && (y - held).abs() < 1e-12, "{x} {y}");
        let middle = axis.place(axis.counts[0] / 2, &modes)[1];
        let away = 1e-3 * first.parse::<f64>().expect("a number") * (-1.215_655_6 - 2.0);
        assert!((middle - held - scene.times * away).abs() < 1e-6 * scene.times, "{middle}");
        assert!(scene.joints.iter().all(|joint| joint.second.station.is_some()));
    }
}

const BOOM: &str = "spatial Boom {
    flexible arm(file = \"FILE\") { point start = node(1); point third = node(5); point end = node(11); modes = 1..2; damping_ratio = 0.02; }
    body hand { mass [kg] = 0.5; inertia [kg*m^2] = (1e-3, 2e-3, 1.5e-3); }
    joint base: universal(ground(0, 0, 0) [m], arm.start, axis = (0, 0, 1), second_axis = (0, 1, 0));
    joint wrist: spherical(arm.end, hand.origin);
    spring tie: spring(arm.third, ground(1, 1, 0) [m], stiffness [N/m] = 100, length [m] = 0.5);
    start { arm.mode[2] [mm] = FIRST; }
}";

/// A body from a file is lines between its nodes, bent as these turn: the first bending of a cantilever, of which the file has three places. Its
/// modes are pictures on the page.
#[test]
fn bodies_from_files_are_bent() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/mechanisms/src/data/clamped.flex");
    // cosh βx − cos βx − σ (sinh βx − sin βx), 2 at the end.
    let cantilever = |x: f64| {
        let (beta, sigma) = (1.875_104_068_711_961_f64 * x, 0.734_095_513_753_9);
        beta.cosh() - beta.cos() - sigma * (beta.sinh() - beta.sin())
    };
    // Of a bend of 2 × 150 mm nothing is magnified; of 2 × 0.5 mm what is beside the straight line through both joints.
    for first in [150.0, 0.5] {
        let source = BOOM.replace("FILE", &file.display().to_string()).replace("FIRST", &first.to_string());
        let compiled =
            compile(source.parse().expect("tokens"), None).unwrap_or_else(|errors| panic!("{errors}"));
        let Figure { svg, left_out, .. } = drawing_at(&compiled, &Pose::start(&compiled));
        assert_eq!((left_out, measure::overlaps(&svg)), (0, vec![]), "{first}");
        assert!(svg.contains("<title>frame of arm</title>"));
        let pose = Pose::start(&compiled);
        let scene = scene::scene(&compiled, &pose, std::iter::once(pose.q.as_slice()), std::iter::empty());
        let modes: Vec<f64> = scene.modes.iter().map(|index| pose.q[*index]).collect();
        let lines = scene.bodies[0].lines.as_ref().expect("it bends");
        assert_eq!(lines.counts, [9, 9]);
        assert_eq!(scene.times == 1.0, first == 150.0, "{}", scene.times);
        for station in 0..18 {
            let [x, bent, aside] = lines.place(station, &modes);
            assert_eq!(aside, 0.0);
            let chord = 2.0 * x;
            let expected = chord + scene.times * (cantilever(x) - chord);
            let error = (bent - 1e-3 * first * expected).abs();
            // Cubics of 0.6 m are off by β⁴ φ L⁴/384 at most.
            assert!(error < 7e-3 * 1e-3 * first * scene.times, "{station}: {bent} {expected}");
        }
        // Joints and the spring are where the lines are.
        assert!(
            scene
                .joints
                .iter()
                .all(|joint| [joint.first, joint.second].iter().any(|it| it.station.is_some()))
        );
        assert!(scene.loads[0].ends.iter().any(|end| end.station.is_some()));
        let page = linkwright_compiler::page::page(&compiled);
        let pictures = page.matches("<title>arm.mode[").count();
        assert_eq!(pictures, 2);
    }
}
