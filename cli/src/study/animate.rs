//! `linkwright animate`: one page with the motion, plots that share its cursor, and the values of parameters. Nothing is fetched, so that
//! it works from a disk and in years. What draws is `page/page.js`, and `against.js` beside it; here are the numbers that it draws.

use super::draw::pose;
use super::methods::Course;
use super::options::Study;
use super::record::Group;
use super::run::{Run, recorded};
use super::{Done, Failure, Loaded, moving_picture, short, write};
use crate::with_engine;
use linkwright_compiler::drawing_text::escaped;
use linkwright_compiler::page::magnified;
use linkwright_compiler::page::scene::{self, Scene, Spot};
use serde_json::{Value, json};
use std::path::PathBuf;

/// So many samples are shown if nothing is said.
const SAMPLES: f64 = 600.0;

/// What is kept of the run.
const GROUPS: [Group; 8] = [
    Group::Outputs,
    Group::Inputs,
    Group::Energy,
    Group::Reactions,
    Group::Efforts,
    Group::Residual,
    Group::Motions,
    Group::State,
];

/// A run with the places of all bodies.
pub struct Film {
    pub run: Run,
    pub scene: Scene,
    /// Of each sample, body after body: position and orientation; behind these the modes of beams.
    pub poses: Vec<Vec<f64>>,
    /// What is plotted: name, unit, group, and a value for each sample.
    pub curves: Vec<Curve>,
}

/// A quantity over time.
pub struct Curve {
    pub name: String,
    pub unit: String,
    pub group: Group,
    pub values: Vec<f64>,
}

/// The command.
pub fn animate(study: &Study, loaded: &Loaded) -> Result<Done, Failure> {
    let film = film(study, loaded)?;
    let (text, kind) = if study.svg {
        (moving_picture::picture(&loaded.name, &film, study.speed), "svg")
    } else {
        (page(study, loaded, &film), "html")
    };
    let stopped = film.run.stopped.as_ref().map(|error| error.to_string());
    let out = study.out.clone().unwrap_or_else(|| PathBuf::from(format!("{}.{kind}", loaded.name)));
    write(Some(&out), &text)?;
    if !study.json {
        println!("{}", out.display());
        if let Some(error) = &stopped {
            let end = film.run.trajectory.times.last().copied().unwrap_or_default();
            eprintln!("stopped at {} s of {} s: {error}", short(end), short(study.course.duration));
        }
    }
    let value = json!({ "file": out.display().to_string(), "samples": film.poses.len(), "stopped": stopped });
    Ok(Done { value, failed: film.run.stopped.is_some() })
}

/// Runs, and gathers what is shown.
pub fn film(study: &Study, loaded: &Loaded) -> Result<Film, Failure> {
    let mut study = study.clone();
    let Course { duration, step, every, .. } = &mut study.course;
    every.get_or_insert(((*duration / SAMPLES / *step).round().max(1.0)) * *step);
    let run = recorded(&study, loaded, &GROUPS)?;
    let [motion, reaction] = with_engine!(&loaded.engine, |engine| engine.lengths());
    let columns = &run.trajectory.columns;
    let of = |group: Group| columns.iter().position(|column| column.group == group).unwrap_or(columns.len());
    let (first, state) = (of(Group::Motions), of(Group::State));
    let dimensions = loaded.compiled.mechanism.space.dimensions();
    let scene = with_engine!(&loaded.engine, |engine| {
        let positions = run.trajectory.rows().map(|row| &row[state..]);
        let of_row = |row: &'_ [f64]| {
            let center = |body: &[f64]| [0, 1, 2].map(|k| if k < dimensions { body[k] } else { 0.0 });
            row[first..state].chunks(motion).map(center).collect::<Vec<_>>()
        };
        let centers = run.trajectory.rows().flat_map(of_row);
        scene::scene(&loaded.compiled, &pose(engine, &super::start(engine)?), positions, centers)
    });
    let kept = if scene.is_planar { 4 } else { 12 };
    let poses = run.trajectory.rows().map(|row| {
        let bodies = row[first..state].chunks(motion).flat_map(|body| &body[..kept]);
        let modes = scene.modes.iter().map(|index| &row[state + index]);
        bodies.chain(modes).map(|value| rounded(*value)).collect()
    });
    let poses = poses.collect();
    let mut curves = Vec::new();
    let mut index = 0;
    while index < first {
        let column = &columns[index];
        // Of a reaction the size of its force is shown.
        let width = if column.group == Group::Reactions { reaction } else { 1 };
        let axes = if column.group == Group::Reactions { if scene.is_planar { 2 } else { 3 } } else { 1 };
        let value = |row: &[f64]| match &row[index..index + axes] {
            [only] => *only,
            several => several.iter().map(|x| x * x).sum::<f64>().sqrt(),
        };
        let name = match column.group {
            Group::Reactions => format!("force in {}", column.name.trim_end_matches(".force.x")),
            _ => column.name.replace('_', " "),
        };
        let values = run.trajectory.rows().map(|row| rounded(value(row))).collect();
        curves.push(Curve { name, unit: column.unit.clone(), group: column.group, values });
        index += width;
    }
    Ok(Film { run, scene, poses, curves })
}

/// Seven digits are more than a picture shows.
fn rounded(value: f64) -> f64 {
    format!("{value:.6e}").parse().unwrap_or(value)
}

fn spot(spot: &Spot) -> Value {
    let [x, y, z] = spot.at.map(rounded);
    let body = spot.body.map_or(-1, |body| body as i64);
    match spot.station {
        Some(station) => json!([body, x, y, z, station]),
        None => json!([body, x, y, z]),
    }
}

/// What the page draws.
fn data(loaded: &Loaded, film: &Film) -> Value {
    let Scene { is_planar, up, bodies, joints, loads, wheels, surfaces, modes, times } = &film.scene;
    let point = |at: &[f64; 3]| json!(at.map(rounded));
    let bodies = bodies.iter().map(|body| {
        let spots: Vec<Value> = body.spots.iter().map(point).collect();
        let mut known =
            json!({ "name": body.name, "outline": body.outline, "lengths": body.lengths, "spots": spots });
        if let Some(lines) = &body.lines {
            let factors =
                |bending: &scene::Bending| bending.factors.iter().map(|it| rounded(*it)).collect::<Vec<_>>();
            let bending =
                |it: &scene::Bending| json!({ "modes": it.modes, "along": it.along, "factors": factors(it) });
            known["lines"] = json!({
                "stations": lines.stations.iter().map(point).collect::<Vec<_>>(),
                "counts": lines.counts,
                "bendings": lines.bendings.iter().map(bending).collect::<Vec<_>>(),
            });
        }
        known
    });
    let joints = joints.iter().map(|joint| {
        json!({
            "name": joint.name, "kind": joint.kind, "first": spot(&joint.first), "second": spot(&joint.second),
            "axis": point(&joint.axis), "slides": joint.slides,
        })
    });
    let loads = loads.iter().map(|load| {
        json!({ "name": load.name, "kind": load.kind, "ends": load.ends.iter().map(spot).collect::<Vec<_>>() })
    });
    let wheels = wheels.iter().map(
        |wheel| json!({ "center": spot(&wheel.center), "about": point(&wheel.about), "radius": wheel.radius }),
    );
    let surfaces = surfaces.iter().map(|surface| {
        let line = |line: &Vec<Spot>| line.iter().map(spot).collect::<Vec<_>>();
        json!({ "name": surface.name, "lines": surface.lines.iter().map(line).collect::<Vec<_>>() })
    });
    let columns = film
        .curves
        .iter()
        .map(|curve| json!({ "name": curve.name, "unit": curve.unit, "group": curve.group.text() }));
    json!({
        "name": loaded.name,
        "planar": is_planar,
        "modes": modes.len(),
        "magnified": if *times == 1.0 { Value::Null } else { Value::from(magnified(*times)) },
        "up": up,
        "bodies": bodies.collect::<Vec<_>>(),
        "joints": joints.collect::<Vec<_>>(),
        "loads": loads.collect::<Vec<_>>(),
        "wheels": wheels.collect::<Vec<_>>(),
        "surfaces": surfaces.collect::<Vec<_>>(),
        "times": film.run.trajectory.times.iter().map(|time| rounded(*time)).collect::<Vec<_>>(),
        "poses": film.poses,
        "columns": columns.collect::<Vec<_>>(),
        "values": film.curves.iter().map(|curve| &curve.values).collect::<Vec<_>>(),
    })
}

/// The page as a whole.
pub fn page(study: &Study, loaded: &Loaded, film: &Film) -> String {
    // A tag in a string of the data would end the element that holds it.
    let data = data(loaded, film).to_string().replace("</", "<\\/");
    let name = escaped(&loaded.name);
    let Course { step, formulation, integrator, .. } = &study.course;
    let end = film.run.trajectory.times.last().copied().unwrap_or_default();
    let bodies = match film.scene.bodies.len() {
        1 => "one body".to_string(),
        count => format!("{count} bodies"),
    };
    let freedoms = match loaded.compiled.assembly.mobility.generic {
        1 => "one degree of freedom".to_string(),
        count => format!("{count} degrees of freedom"),
    };
    let lead = format!(
        "{bodies}, {freedoms}; {} s in steps of {} s, {formulation}, {integrator}",
        short(end),
        short(*step)
    );
    let stopped = film.run.stopped.as_ref().map_or(String::new(), |error| {
        format!("<p class=\"stopped\">Stopped at {} s: {}</p>\n", short(end), escaped(&error.to_string()))
    });
    let tables = tables(loaded, film);
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <link rel=\"icon\" href=\"data:,\">\n<title>{name} in motion</title>\n<style>\n{CSS}</style>\n</head>\n<body>\n<main>\n\
         <h1>{name}</h1>\n<p class=\"lead\">{}</p>\n{stopped}{BODY}{tables}</div>\n</div>\n</main>\n\
         <script type=\"application/json\" id=\"data\">{data}</script>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n",
        escaped(&lead)
    )
}

const CSS: &str = include_str!("page/page.css");
const SCRIPT: &str = concat!(include_str!("page/against.js"), include_str!("page/page.js"));

/// Stage, controls, and the place of the plots.
const BODY: &str = "<div class=\"columns\">\n<div class=\"stage\">\n<canvas id=\"stage\" role=\"img\" aria-label=\"the mechanism in motion\"></canvas>\n\
    <div class=\"controls\"><button id=\"play\" type=\"button\">Play</button>\n\
    <input id=\"time\" type=\"range\" aria-label=\"time\"><output id=\"clock\"></output>\n\
    <select id=\"speed\" aria-label=\"speed\"><option value=\"0.1\">0.1 ×</option><option value=\"0.25\">0.25 ×</option>\
    <option value=\"0.5\">0.5 ×</option><option value=\"1\" selected>1 ×</option><option value=\"2\">2 ×</option>\
    <option value=\"5\">5 ×</option></select>\n\
    <label><input type=\"checkbox\" id=\"names\"> names</label><label><input type=\"checkbox\" id=\"traces\"> traces</label>\
    <label><input type=\"checkbox\" id=\"velocities\"> velocities</label></div>\n</div>\n<div>\n<div id=\"plots\"></div>\n";

/// Parameters, and what the run was like.
fn tables(loaded: &Loaded, film: &Film) -> String {
    let mut text = String::new();
    let known = &loaded.compiled.mechanism.parameters;
    let values = with_engine!(&loaded.engine, |engine| engine.parameters());
    if !known.is_empty() {
        text.push_str(
            "<h2>Parameters</h2>\n<div class=\"table\"><table><tr><th>name</th><th>value</th><th>unit</th><th>bounds</th></tr>\n",
        );
        for (parameter, value) in known.iter().zip(values) {
            let scale = parameter.unit.scale;
            let bounds = parameter.bounds.map_or("–".to_string(), |(least, most)| {
                format!("{} to {}", short(least / scale), short(most / scale))
            });
            text.push_str(&format!(
                "<tr><td>{}</td><td>{}</td><td>{}</td><td>{bounds}</td></tr>\n",
                escaped(&parameter.name.text),
                short(value / scale),
                escaped(&parameter.unit.text)
            ));
        }
        text.push_str("</table></div>\n");
    }
    let extremes = &film.run.trajectory.extremes;
    text.push_str(&format!(
        "<h2>The run</h2>\n<div class=\"table\"><table><tr><th>kinetic and potential energy, at the start</th><td>{} J</td></tr>\n\
         <tr><th>at the end</th><td>{} J</td></tr>\n<tr><th>largest residual of positions</th><td>{}</td></tr>\n\
         <tr><th>of velocities</th><td>{}</td></tr></table></div>\n",
        short(extremes.energy[0]),
        short(extremes.energy[1]),
        short(extremes.position[0]),
        short(extremes.velocity[0])
    ));
    text
}
