//! An explanation for people.

use crate::explain::{Beam, Explanation, Joint, MeshOf, Value};
use crate::start::Found;
use linkwright_compiler::check::Strain;
use linkwright_compiler::check::motion::Reflected;
use linkwright_compiler::counts;
use linkwright_compiler::numbers::coordinate;
use std::fmt::Write;

/// Longest table; what is behind it is only counted.
const MOST: usize = 60;

/// The whole page; `place` says where the definition stands.
pub fn explanation(e: &Explanation, place: &str) -> String {
    let mut text = format!("{} {}  ({place})\n", e.space, e.name);
    table(&mut text, "Parts", e.parts.iter().map(|one| one.to_vec()).collect());
    let parameters = e.parameters.iter().map(|parameter| {
        let value = &parameter.default;
        let bounds = parameter
            .bounds
            .map_or(String::new(), |[least, most]| format!("in {}..{}", number(least), number(most)));
        vec![value.name.clone(), format!("{} {}", number(value.value), value.unit), bounds]
    });
    table(&mut text, "Parameters", parameters.collect());
    table(&mut text, "Inputs", e.inputs.iter().map(|input| input.to_vec()).collect());
    table(&mut text, "Signals", e.signals.iter().map(|signal| signal.to_vec()).collect());
    table(&mut text, "States at the start", e.states.iter().map(value).collect());
    table(&mut text, "Memories at the start", e.memories.iter().map(value).collect());
    table(&mut text, "Events", e.events.iter().map(|event| event.to_vec()).collect());
    let bodies = e.bodies.iter().map(|body| {
        let moments: Vec<String> = body.moments.iter().map(|moment| number(*moment)).collect();
        let inertia =
            if moments.is_empty() { String::new() } else { format!("{} kg*m^2", moments.join(", ")) };
        vec![body.name.clone(), body.shape.to_string(), format!("{} kg", number(body.mass)), inertia]
    });
    table(&mut text, "Bodies", bodies.collect());
    let modes = e.modes.iter().map(|mode| {
        let step = format!("RK4 to {} us", number(1e6 * mode.step));
        vec![mode.name.clone(), format!("{} Hz", number(mode.hertz)), step]
    });
    table(&mut text, "Modes by themselves", modes.collect());
    table(&mut text, "Beams at the start, against what they take", e.beams.iter().map(beam).collect());
    table(&mut text, "Joints", e.joints.iter().map(|joint| self::joint(e, joint)).collect());
    table(&mut text, "Couplings and drivers", e.couplings.iter().map(|one| one.to_vec()).collect());
    table(&mut text, "Teeth", e.teeth.iter().map(|pair| pair.cells(str::to_string)).collect());
    table(&mut text, "Teeth that give", e.gives.iter().map(|mesh| mesh.cells(str::to_string)).collect());
    let meshes = e.meshes.iter().map(mesh).collect();
    table(&mut text, "Stiffness by the shape of teeth, N/m over a pitch", meshes);
    table(&mut text, "Loads", e.loads.iter().map(|one| one.to_vec()).collect());
    if let Some(vibration) = &e.vibration {
        let _ = writeln!(text, "\nJoints that yield\n  {vibration}");
    }
    table(&mut text, "Contacts", e.contacts.iter().map(|one| one.to_vec()).collect());
    table(&mut text, "Friction", e.frictions.iter().map(|one| one.to_vec()).collect());
    table(&mut text, "Tables", e.tables.iter().map(|one| one.to_vec()).collect());
    freedoms(&mut text, e);
    let title = "Reflected to each joint at the start: inertia, and gravity and loads at rest";
    table(&mut text, title, e.reflected.iter().map(reflected).collect());
    coordinates(&mut text, e);
    let start = |Found { value, given }: &Found| {
        vec![
            value.name.clone(),
            format!("= {} {}", number(value.value), value.unit),
            given.text().to_string(),
        ]
    };
    table(&mut text, "Start", e.start.iter().map(start).collect());
    table(&mut text, "Outputs at the start, inputs zero", e.outputs.iter().map(value).collect());
    text.push_str("\nOperations\n");
    text.push_str(&counts::as_tables(&e.functions));
    text
}

fn value(value: &Value) -> Vec<String> {
    let unit = if value.unit == "1" { "" } else { &value.unit };
    vec![value.name.clone(), format!("= {} {unit}", number(value.value))]
}

/// Length in radii of gyration, rate across the axis, thrust: what the warnings `slender` and `stiffening` judge.
fn beam(of: &Beam) -> Vec<String> {
    let Strain { slenderness, rate, natural, pressed, .. } = &of.strain;
    let pressed = pressed.map_or(String::new(), |[thrust, euler]| {
        format!("pressed with {} N, Euler's load {} N", number(thrust), number(euler))
    });
    vec![
        of.name.clone(),
        format!("{} radii of gyration long", number(*slenderness)),
        format!("turns at {} rad/s, clamped frequency {} rad/s", number(*rate), number(*natural)),
        pressed,
    ]
}

fn joint(e: &Explanation, joint: &Joint) -> Vec<String> {
    let part = match &joint.carries {
        Some(body) => format!("carries {body}"),
        None if joint.play => "has play".to_string(),
        None if joint.yields => "yields".to_string(),
        None if e.coordinates == "tree" => "closes a loop".to_string(),
        None => String::new(),
    };
    vec![joint.name.clone(), joint.kind.to_string(), joint.places.join(", "), part]
}

fn freedoms(text: &mut String, e: &Explanation) {
    let _ = writeln!(text, "\nFreedoms (drivers removed)\n  {}", e.mobility);
    if !e.independent.is_empty() {
        let _ = writeln!(text, "  independent: {}", e.independent.join(", "));
    }
    let _ = writeln!(text, "\nMotion\n  {}", e.motion.join("\n  "));
}

/// The exact stiffness at tenths of a pitch; all places are in the JSON.
fn mesh(of: &MeshOf) -> Vec<String> {
    let tenths = of.places.iter().step_by(of.places.len() / 10).map(|(exact, ..)| number(*exact));
    let series =
        format!("series: mean {}, leaves out {} % rms", number(of.mean), number(100.0 * of.left_out));
    [of.name.clone()].into_iter().chain(tenths).chain([series]).collect()
}

/// What a drive at a joint turns or moves, and against what.
fn reflected(of: &Reflected) -> Vec<String> {
    let [inertia, load] = if of.angular { ["kg*m^2", "N*m"] } else { ["kg", "N"] };
    vec![of.of.clone(), format!("{} {inertia}", number(of.inertia)), format!("{} {load}", number(of.load))]
}

fn coordinates(text: &mut String, e: &Explanation) {
    let _ = writeln!(text, "\nCoordinates\n  {}", e.choice);
    if let Some(solution) = &e.solution {
        let _ = writeln!(text, "  {solution}");
    }
    for repetition in &e.repetition {
        let _ = writeln!(text, "  {repetition}");
    }
    for (name, entries) in [("q", &e.positions), ("v", &e.velocities)] {
        let shown = entries.iter().take(MOST).cloned().collect::<Vec<_>>().join(", ");
        let more =
            if entries.len() > MOST { format!(", and {} more", entries.len() - MOST) } else { String::new() };
        let _ = writeln!(text, "  {name} ({}): {shown}{more}", entries.len());
    }
    let rows = e
        .rows
        .iter()
        .enumerate()
        .map(|(index, [of, what])| vec![index.to_string(), of.clone(), what.clone()]);
    table(text, "Constraint rows", rows.collect());
    if !e.redundant.is_empty() {
        let what = if e.keeps_redundant { "kept with the multiplier zero" } else { "left out" };
        table(text, &format!("Redundant rows, {what}"), e.redundant.iter().map(|row| row.to_vec()).collect());
        let _ = writeln!(text, "  reactions are not unique in {}", e.shared_reactions.join(", "));
    }
}

/// Rows under a heading, their columns aligned; nothing where there are none.
fn table(text: &mut String, heading: &str, rows: Vec<Vec<String>>) {
    if rows.is_empty() {
        return;
    }
    let _ = writeln!(text, "\n{heading} ({})", rows.len());
    let columns = rows[0].len();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    for row in rows.iter().take(MOST) {
        let cells: Vec<String> =
            row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}", width = *width)).collect();
        let _ = writeln!(text, "  {}", cells.join("  ").trim_end());
    }
    if rows.len() > MOST {
        let _ = writeln!(text, "  and {} more", rows.len() - MOST);
    }
}

/// Six digits.
pub fn number(value: f64) -> String {
    coordinate(value, 6)
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_have_six_digits() {
        let cases = [
            (0.0, "0"),
            (-3e-17, "0"),
            (90.0, "90"),
            (-0.061713890, "-0.0617139"),
            (123456.7, "123457"),
            (1234567.0, "1.23457e6"),
            (2.194e-6, "2.194e-6"),
            (1e-4, "0.0001"),
            (f64::NAN, "NaN"),
            (f64::INFINITY, "inf"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
