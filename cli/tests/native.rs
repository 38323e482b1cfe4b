//! `--native`: machine code gives what the interpreter gives, byte for byte. `cargo test -p linkwright-cli --features native`.

use std::path::Path;
use std::process::Command;

fn written(arguments: &[&str]) -> String {
    let documents = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let ran = Command::new(env!("CARGO_BIN_EXE_linkwright")).args(arguments).current_dir(documents).output();
    let ran = ran.expect("the program is built");
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    String::from_utf8(ran.stdout).expect("it writes text")
}

#[test]
fn machine_code_gives_the_same() {
    let file = "mechanisms/crank_rocker.mech";
    let run = ["run", file, "--for", "2s", "--input", "drive=2*sin(pi*t)", "--show", "all"];
    let sweep =
        ["sweep", file, "--for", "1s", "--over", "crank_length=90..110:5", "--measure", "range(swing)"];
    let implicit = ["run", file, "--for", "1s", "--integrator", "generalised_alpha:0.8"];
    for arguments in [&run[..], &sweep[..], &implicit[..]] {
        let interpreted = written(arguments);
        assert!(interpreted.lines().count() > 4, "{interpreted}");
        assert_eq!(written(&[arguments, &["--native"]].concat()), interpreted, "{arguments:?}");
    }
}
