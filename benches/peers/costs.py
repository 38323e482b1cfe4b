"""What Linkwright's own code costs: bytes of instructions of one evaluation, and seconds of the build that a user waits for.

A package of its own is written for each mechanism, with the definition as it was written and one function that evaluates. Its
dependencies are built before; what is timed is `cargo build --release` of the package: expansion, analysis and code generation.
"""

import json
import os
import subprocess
import time

import own
from surroundings import ROOT, Absent, bytes_of_code

MANIFEST = """[workspace]

[package]
name = "one"
version = "0.0.0"
edition = "2024"

[dependencies]
linkwright = {{ path = "{root}" }}

[profile.release]
codegen-units = 1
"""
LIBRARY = """linkwright::mechanism! {{
{source}
}}

use linkwright::{{Mechanism, StateOf, Variables}};

#[unsafe(no_mangle)]
pub fn evaluation(
    model: &{name},
    state: &StateOf<{name}>,
    u: &<{name} as Mechanism<f64>>::Inputs,
    a: &mut <{name} as Variables<f64>>::V,
    lambda: &mut <{name} as Variables<f64>>::Lambda,
) -> f64 {{
    if model.null_space_first() {{
        model.null_space_baumgarte(0.0, state, u, 20.0, 100.0, a, lambda)
    }} else {{
        model.acceleration_baumgarte(0.0, state, u, 20.0, 100.0, a, lambda)
    }}
}}
"""


def cost(surroundings, model):
    """Seconds and bytes."""
    folder = surroundings.folder("costs", model.name)
    name = json.loads(model.definition())["name"]
    (folder / "src").mkdir(exist_ok=True)
    (folder / "Cargo.toml").write_text(MANIFEST.format(root=ROOT))
    library = folder / "src" / "lib.rs"
    library.write_text("//! Nothing yet: dependencies are built first.\n")
    target = surroundings.folder("costs", "target")
    command = ["cargo", "build", "--release", "--quiet", "--manifest-path", folder / "Cargo.toml", "--target-dir", target]
    command = [str(part) for part in command]
    try:
        subprocess.run(command, env=own.environment(), check=True, capture_output=True, text=True)
        seconds = []
        for _ in range(3):
            library.write_text(LIBRARY.format(source=model.source(), name=name))
            os.utime(library)
            begin = time.perf_counter()
            subprocess.run(command, env=own.environment(), check=True, capture_output=True, text=True)
            seconds.append(time.perf_counter() - begin)
    except subprocess.CalledProcessError as error:
        raise Absent(f"the package of one definition is not built: {error.stderr.splitlines()[0]}") from None
    return min(seconds), bytes_of_code(target / "release" / "libone.rlib")
