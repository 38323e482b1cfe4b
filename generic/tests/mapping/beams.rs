//! Modes of beams of emitted models, by their names.

use linkwright_generic::{Mechanism, State};

/// The modes of beams by name, with coordinate, rate and acceleration, as `COORDINATES` says where they stand.
pub fn modes(coordinates: &str, q: &[f64], v: &[f64], a: &[f64]) -> Vec<(String, [f64; 3])> {
    let tree: serde_json::Value = serde_json::from_str(coordinates).expect("JSON");
    let linear = tree["linear"].as_array().expect("a list").iter().enumerate();
    let names = linear.filter_map(|(index, entry)| {
        let kind = entry["kind"].as_str()?;
        kind.ends_with(']').then(|| (index, format!("{}.{kind}", entry["of"].as_str().unwrap_or_default())))
    });
    names.map(|(index, name)| (name, [q[index], v[index], a[index]])).collect()
}

/// Gives the modes of beams to a state.
pub fn set_modes(mechanism: &Mechanism, state: &mut State, modes: &[(String, [f64; 3])]) {
    for (name, [value, rate, _]) in modes {
        mechanism.set_mode(state, name, *value, *rate).expect("a mode");
    }
}
