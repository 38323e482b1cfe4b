#!/usr/bin/env python3
"""Writes docs/gallery.md and a picture in motion of every model beside this file.

    cargo build --release -p linkwright-cli
    python3 docs/gallery/make.py [NAME…]        all, or only these

What is driven has inputs here; all others move from their starts, for four seconds where nothing else is said.
"""

import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODELS = ROOT / "models" / "src"
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
PROGRAM = TARGET / "release" / "linkwright"

# Options of `linkwright animate`.
SETTINGS = {
    "change_point_four_bar": "--for 1s",
    "andrews": "--for 30ms --step 10us --speed 0.01",
    "andrews_iftomm": "--for 50ms --step 10us --speed 0.01",
    "light_cart_pole": "--for 0.44s --speed 0.25",
    "flyball_governor": "--for 4s --step 100us",
    "delta_robot": "--for 0.6s --speed 0.25",
    "dc_motor_arm": "--input voltage=12",
    "held_block": "--for 1s --step 100us --input pull=min(t/0.5,1)*8",
    "stick_slip": "--for 30s --step 100us --speed 3",
    "woodpecker": "--for 0.4s --step 100us --speed 0.1",
    "lugre_block": "--for 4s --step 100us --input push=4*t",
    "geared_shafts": "--for 0.4s --step 100us --input drive=2*cos(20*t) --speed 0.1",
    "cam_lift_off": "--for 100ms --step 20us --speed 0.04",
    "cam_follower": "--for 1.5s --speed 0.5",
    "vehicle_on_pans": "--for 2.5s --every 50ms",
    "gear_pair": "--for 60ms --step 2us --speed 0.02",
    "gear_pair_oscillator": "--for 20ms --step 2us --speed 0.01",
    "planetary_stage_held": "--for 20ms --step 1us --speed 0.01",
    "planetary_stage": "--for 20ms --step 1us --input torque=1000 --speed 0.01",
    "bevel_pair": "--input torque=1",
    "worm_drive": "--input torque=1",
    "yaw_drive": "--for 0.4s --step 5us --speed 0.1",
    "motor_gear_load": "--input drive=1",
    "elastic_motor_gear_load": "--input drive=1",
    "hydraulic_loader": "--input lift_valve=0.3 --input fold_valve=0.3",
    "dump_truck_steering": "--input valve=0.5",
    "dump_truck_tipping": "--input valve=0.5",
    "loose_wrist": "--for 0.2s --step 10us --speed 0.1",
    "flexible_arm": "--for 10s --step 1ms --input yaw_torque=300*sin(pi*t/4) --input shoulder_torque=-150*sin(pi*t/4) --input elbow_torque=60*sin(pi*t/4)",
    "princeton_beam": "--for 0.3s --step 10us --speed 0.1",
    "laval_rotor": "--for 1s --step 200us --speed 0.2",
    "flexible_quick_return": "--for 0.6s --step 10us --speed 0.1",
    "flexible_slider_crank": "--for 80ms --step 1us --speed 0.02",
    "quick_return": "--for 1.7s --speed 0.5",
    "four_bar": "--for 5s",
    "spin_up": "--for 15s",
    "spin_up_without_stiffening": "--for 8s",
}

# What is shown at its start: their vibrations are what they are for, and these would not be seen.
AT_REST = ["gear_pair_oscillator", "planetary_stage_held", "hinged_bar", "hinged_bar_of_one", "hinged_bar_of_five", "hinged_bar_of_sines"]

# Where a model's file stands on the page: the first section whose list has it.
SECTIONS = [
    ("Linkages in the plane", ["four_bar", "general_four_bar", "n_four_bar", "change_point_four_bar", "slider_crank", "quick_return",
        "andrews", "jansen_leg", "klann_leg"]),
    ("Linkages in space", ["four_spherical_joints", "spatial_four_bar", "spatial_slider_crank", "bricard", "sarrus_linkage",
        "flyball_governor"]),
    ("Robots and machines", ["iiwa14", "panda", "stewart_platform", "delta_robot", "cable_robot", "knuckle_boom_loader",
        "dump_truck_steering", "dump_truck_tipping", "light_cart_pole", "dc_motor_arm"]),
    ("Vehicles", ["double_wishbone", "tracked_vehicle", "vehicle_on_pans", "car_axis", "braked_wheel", "rear_wheel"]),
    ("Gears and drive trains", ["planetary_gear_train", "toothed_gears", "planetary_stage", "gear_pair", "yaw_drive", "motor_gear_load",
        "cam_follower"]),
    ("Contact and friction", ["bouncing_ball", "falling_cross", "hammer_at_wall", "loose_wrist",
        "cam_lift_off", "geared_shafts", "ball_between_walls", "hammer_at_rigid_wall", "slider_crank_on_stop", "rimless_wheel", "woodpecker",
        "rod_on_pin", "rubbing_four_bar", "rolling",
        "rubbing_block", "held_block", "stick_slip", "lugre_block", "penalty_chain"]),
    ("Flexible bodies", ["flexible_quick_return", "flexible_slider_crank", "flexible_pendulum", "spinning_beam", "flexible_arm", "laval_rotor", "princeton_beam"]),
    ("Pendulums and tops", []),
]


def models():
    """(name, file, mechanism) of every model that ships, in the order of `for_each_model!`."""
    text = (MODELS / "lib.rs").read_text()
    return re.findall(r"^ +(\w+): \$crate::(\w+)::(\w+),$", text, re.M)


def sentence(file, mechanism):
    """The first sentence of what the definition says of itself, else that of its file."""
    source = (MODELS / f"{file}.rs").read_text()
    before = re.search(rf"((?:^ *///.*\n)+) *(?:pub )?(?:planar|spatial) {mechanism} \{{", source, re.M)
    lines = re.findall(r"///? ?(.*)", before[1]) if before else re.findall(r"^//! ?(.*)", source, re.M)
    text = " ".join(lines).strip().split(". ")[0].rstrip(".:")
    return re.sub(r"\[`(\w+)`\]", r"`\1`", text)


def draw(model):
    name, file, mechanism = model
    out = ROOT / "docs" / "gallery" / f"{name}.svg"
    options = SETTINGS.get(name, "").split()
    if "--for" not in options:
        options = ["--for", "4s", *options]
    command = [PROGRAM, "animate", MODELS / f"{file}.rs", "--mechanism", mechanism, "--svg", *options, "--out", out]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        return f"{name}: {done.stderr.strip()}"
    if ("<animate" in out.read_text()) == (name in AT_REST):
        return f"{name}: {'moves' if name in AT_REST else 'stands still'}"
    return None


def manner(name):
    return "at rest" if name in AT_REST else "in motion"


def page():
    sections = {title: [] for title, _ in SECTIONS}
    for name, file, mechanism in models():
        title = next((title for title, files in SECTIONS if file in files), SECTIONS[-1][0])
        sections[title].append((name, file, mechanism))
    lines = [
        "# Gallery", "",
        "Every model that ships, in motion. `python3 docs/gallery/make.py` writes this page; one of its pictures is, say,",
        "`linkwright animate models/src/quick_return.rs --svg --for 2s`. Without `--svg` it is a page with a scrubber and plots.", "",
    ]
    for title, entries in sections.items():
        lines += [f"## {title}", "", "| | | |", "|---|---|---|"]
        for start in range(0, len(entries), 3):
            row = entries[start:start + 3]
            cells = [
                f'<img src="gallery/{name}.svg" width="280" alt="{mechanism} {manner(name)}"><br>[`{mechanism}`](../models/src/{file}.rs)<br>'
                f"{sentence(file, mechanism)}" for name, file, mechanism in row
            ]
            lines.append("| " + " | ".join(cells + [""] * (3 - len(row))) + " |")
        lines.append("")
    (ROOT / "docs" / "gallery.md").write_text("\n".join(lines).rstrip() + "\n")


def main():
    wanted = sys.argv[1:]
    chosen = [model for model in models() if not wanted or model[0] in wanted]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = [fault for fault in pool.map(draw, chosen) if fault]
    page()
    print(f"{len(chosen) - len(faults)} pictures")
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
