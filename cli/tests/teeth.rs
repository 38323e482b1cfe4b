//! What `explain` tells of teeth that give: their stiffness over a pitch as a table, reduced mass, frequency and gaps.

use serde_json::Value;
use std::path::Path;
use std::process::Command;

fn explained(arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkwright"));
    command.arg("explain").args(arguments).arg("planets.mech");
    let output = command.current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data")).output();
    let output = output.expect("the program is built");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("it writes text")
}

#[track_caller]
fn near(found: &Value, expected: f64, within: f64) {
    let found = found.as_f64().expect("a number");
    assert!((found / expected - 1.0).abs() < within, "{found} in place of {expected}");
}

/// 12/30 teeth of 1 mm as cantilevers, from an evaluation apart: tenths of a pitch in 1e8 N/m; two pairs touch for u < 0.4053.
#[test]
fn the_stiffness_over_a_pitch() {
    let answer: Value = serde_json::from_str(&explained(&["--json"])).expect("the answer is JSON");
    let told = &answer["mechanisms"][0]["explanation"];
    let mesh = &told["meshes"][0];
    near(&mesh["mean_N_m"], 1.89079e8, 3e-4);
    let tenths = [1.65187, 1.24954, 1.10183, 1.22179, 1.57703, 2.07691, 2.58632, 2.83018, 2.64277, 2.09189];
    for (at, expected) in tenths.into_iter().enumerate() {
        near(&mesh["exact_N_m"][10 * at], expected * 1e8, 1e-5);
        assert_eq!(mesh["pairs"][10 * at], if at < 5 { 2 } else { 1 });
    }
    let give = &told["teeth_that_give"][0];
    let cosine = 20.0_f64.to_radians().cos();
    let mass = 1.0 / ((6e-3 * cosine).powi(2) / 8e-8 + (15e-3 * cosine).powi(2) / 3e-6);
    near(&give["reduced_mass_kg"], mass, 1e-9);
    near(&give["frequency_Hz"], (1.89079e8 / mass).sqrt() / std::f64::consts::TAU, 2e-4);
    near(&give["circumferential_backlash_m"], 20e-6 / cosine, 1e-9);
}

#[test]
fn in_words() {
    let text = explained(&[]);
    for line in [
        "Teeth that give",
        "backlash 20 um along the line of action, 21.2836 um along the pitch circle",
        "Stiffness by the shape of teeth",
    ] {
        assert!(text.contains(line), "{line}: {text}");
    }
}
